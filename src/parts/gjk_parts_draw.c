// The outlines of parts, for debug drawing.
#include "gjk/draw.h"
#include "gjk_parts_class.h"

static bool boxes_meet(const gjk_aabb *a, const gjk_aabb *b) {
  return a->lower.x <= b->upper.x && b->lower.x <= a->upper.x && a->lower.y <= b->upper.y && b->lower.y <= a->upper.y &&
         a->lower.z <= b->upper.z && b->lower.z <= a->upper.z;
}

// Makes the collider of a part. False: the part is not there, as at a hole of a height field, or not near.
static bool is_drawn(const gjk_parts_frame *frame, uint32_t number, const gjk_aabb *near, gjk_parts_room *room,
                     gjk_collider *out) {
  gjk_aabb box;
  return gjk_parts_place_in(frame, number, room, out) == GJK_OK && gjk_collider_aabb(out, &box) == GJK_OK &&
         boxes_meet(&box, near);
}

gjk_status gjk_draw_parts(const gjk_draw *draw, const gjk_parts *parts, const gjk_aabb *near, uint32_t most,
                          gjk_draw_role role, uint32_t *drawn) {
  static const gjk_aabb everywhere = {{INT32_MIN, INT32_MIN, INT32_MIN}, {INT32_MAX, INT32_MAX, INT32_MAX}};
  const gjk_aabb *within = near != NULL ? near : &everywhere;
  gjk_parts_frame frame;
  gjk_region region;
  gjk_parts_walk walk;
  uint32_t number, count = 0;
  if (draw == NULL) {
    return GJK_ERROR_NULL;
  }
  gjk_status status = gjk_parts_frame_set(&frame, parts);
  if (status == GJK_OK &&
      (within->lower.x > within->upper.x || within->lower.y > within->upper.y || within->lower.z > within->upper.z)) {
    status = GJK_ERROR_RANGE;
  }
  if (status != GJK_OK) {
    return status;
  }
  gjk_region_start(&region, frame.rows, &parts->pose.position, within, NULL);
  gjk_parts_walk_start(&walk);
  while (status == GJK_OK && gjk_parts_next(&frame, &region, &walk, &number)) {  // ends: each part comes once
    gjk_parts_room room;
    gjk_collider c;
    if (!is_drawn(&frame, number, within, &room, &c)) {
      continue;
    }
    if (count == most) {
      status = GJK_ERROR_CAPACITY;
    } else {
      (void)gjk_draw_collider(draw, &c, role);  // it is posed
      count++;
    }
  }
  if (drawn != NULL) {
    *drawn = count;
  }
  return status;
}
