// What all queries of bodies of many parts begin with.
#include "../arith/gjk_memory.h"
#include "../arith/gjk_rotation.h"
#include "gjk_parts_class.h"

// Is a position so far from both ends of int32 that nothing within reach of it is beyond them?
static bool is_inside(gjk_q16 position, uint32_t reach) {
  return (int64_t)position - reach >= INT32_MIN && (int64_t)position + reach <= INT32_MAX;
}

bool gjk_parts_has_room(const gjk_parts *parts, const gjk_vec3 *position) {
  const uint32_t reach = parts->type->reach(parts->data);
  return is_inside(position->x, reach) && is_inside(position->y, reach) && is_inside(position->z, reach);
}

gjk_status gjk_parts_frame_set(gjk_parts_frame *frame, const gjk_parts *a) {
  if (a == NULL || a->type == NULL || a->data == NULL) {
    return GJK_ERROR_NULL;
  }
  if (a->type->count(a->data) == 0) {
    return GJK_ERROR_EMPTY;
  }
  frame->parts = a;
  if (!gjk_rotation_from_quat(&a->pose.rotation, frame->rows)) {
    return GJK_ERROR_ROTATION;
  }
  const gjk_vec3 *r = frame->rows;
  frame->is_level = r[0].x == GJK_Q30_ONE && r[1].y == GJK_Q30_ONE && r[2].z == GJK_Q30_ONE &&
                    (r[0].y | r[0].z | r[1].x | r[1].z | r[2].x | r[2].y) == 0;
  return gjk_parts_has_room(a, &a->pose.position) ? GJK_OK : GJK_ERROR_RANGE;
}

gjk_status gjk_parts_open(gjk_parts_frame *frame, gjk_region *region, const gjk_parts *a, const gjk_collider *b) {
  gjk_aabb box;
  gjk_status status = gjk_collider_aabb(b, &box);
  status = status == GJK_OK ? gjk_parts_frame_set(frame, a) : status;
  if (status == GJK_OK) {
    gjk_region_start(region, frame->rows, &a->pose.position, &box, NULL);
  }
  return status;
}

uint32_t gjk_parts_count(const gjk_parts *parts) {
  return parts == NULL || parts->type == NULL || parts->data == NULL ? 0 : parts->type->count(parts->data);
}

gjk_status gjk_parts_place(const gjk_parts *parts, uint32_t number, gjk_parts_room *room, gjk_collider *out) {
  gjk_parts_frame frame;
  gjk_collider placed;
  if (room == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  gjk_status status = gjk_parts_frame_set(&frame, parts);
  if (status == GJK_OK) {
    status =
        number < parts->type->count(parts->data) ? gjk_parts_place_in(&frame, number, room, &placed) : GJK_ERROR_RANGE;
  }
  if (status == GJK_OK) {  // a part that cannot be posed may be half written
    gjk_copy(out, &placed, sizeof *out);
  }
  return status;
}
