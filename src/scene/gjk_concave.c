// The shape of a body of many parts: the box that holds them.
#include "gjk/concave.h"

#include "../arith/gjk_memory.h"
#include "gjk_scene_part.h"

// By how much posing may take a part, seen from its body, out of the box that holds it unturned: as GJK_REGION_SLACK of
// src/parts/gjk_region.h, which counts the same roundings.
#define CONCAVE_SLACK 64

// Is no point of a part farther than GJK_CONCAVE_REACH from the origin, at any rotation? A body so far from an end of
// int32 is not refused then. Any other status is that of the body.
static gjk_status check_reach(const gjk_parts *parts) {
  static const gjk_shape point = GJK_POINT;
  gjk_parts at_end;
  gjk_collider c;
  gjk_decision decision;
  const gjk_pose origin = GJK_POSE_IDENTITY;
  gjk_status status = gjk_collider_init(&c, &point, NULL, 0);
  (void)gjk_collider_pose(&c, &origin);
  at_end.type = parts->type;
  at_end.data = parts->data;
  at_end.pose = origin;
  at_end.pose.position.x = INT32_MAX - GJK_CONCAVE_REACH;
  if (status == GJK_OK) {
    status = gjk_parts_within(&at_end, &c, 0, NULL, &decision);
  }
  return status == GJK_ERROR_RANGE ? GJK_ERROR_SIZE : status == GJK_ERROR_ITERATION_LIMIT ? GJK_OK : status;
}

// The box of all parts. A number that no part has, such as one at a hole of a height field, is left out.
static gjk_status box_of_parts(const gjk_parts *unturned, gjk_aabb *box) {
  const uint32_t count = gjk_parts_count(unturned);
  bool any = false;
  for (uint32_t i = 0; i < count; i++) {
    gjk_parts_room room;
    gjk_collider c;
    gjk_aabb of_part;
    const gjk_status status = gjk_parts_place(unturned, i, &room, &c);
    if (status == GJK_OK) {
      (void)gjk_collider_aabb(&c, &of_part);  // posed, so it cannot fail
      *box = any ? gjk_aabb_hull(box, &of_part) : of_part;
      any = true;
    } else if (status != GJK_ERROR_RANGE) {
      return status;
    }
  }
  return any ? GJK_OK : GJK_ERROR_EMPTY;
}

// The middle of a side of the box, and half of its length, which together hold it. |ends| <= 2^29
static void halve_side(gjk_q16 lower, gjk_q16 upper, gjk_q16 *centre, gjk_q16 *half) {
  *centre = lower + (upper - lower) / 2;
  *half = upper - *centre + CONCAVE_SLACK;
}

gjk_status gjk_concave_init(const gjk_parts *parts, gjk_concave *out, gjk_shape *shape) {
  gjk_aabb box;
  gjk_vec3 centre, half;
  if (parts == NULL || out == NULL || shape == NULL) {
    return GJK_ERROR_NULL;
  }
  const gjk_parts unturned = {parts->type, parts->data, GJK_POSE_IDENTITY};
  gjk_status status = check_reach(&unturned);
  status = status == GJK_OK ? box_of_parts(&unturned, &box) : status;
  if (status != GJK_OK) {
    return status;
  }
  halve_side(box.lower.x, box.upper.x, &centre.x, &half.x);
  halve_side(box.lower.y, box.upper.y, &centre.y, &half.y);
  halve_side(box.lower.z, box.upper.z, &centre.z, &half.z);
  const int64_t room = GJK_RADIUS_MAX;
  if (gjk_dot(&half, &half) > room * room) {  // |half| < 2^30:  the product < 3 2^60
    return GJK_ERROR_SIZE;
  }
  gjk_copy(&out->parts, &unturned, sizeof out->parts);
  out->centre = centre;
  const gjk_shape made = GJK_CONCAVE(out, half.x, half.y, half.z);
  gjk_copy(shape, &made, sizeof *shape);
  return GJK_OK;
}

gjk_status gjk_scene_parts(const gjk_scene *scene, gjk_body_id id, uint16_t part, gjk_parts *out) {
  gjk_scene_view v;
  gjk_scene_body *body;
  gjk_status status = out == NULL ? GJK_ERROR_NULL : gjk_scene_view_of(scene, &v);
  status = status == GJK_OK ? gjk_scene_body_of(&v, id, &body) : status;
  if (status != GJK_OK) {
    return status;
  }
  const uint32_t index = gjk_scene_part_of(&v, body, part);
  if (index == GJK_SCENE_NONE) {
    return GJK_ERROR_RANGE;
  }
  const gjk_shape *shape = scene->shapes[v.parts[index].shape];
  if (!gjk_scene_is_concave(shape)) {
    return GJK_ERROR_UNSUPPORTED;
  }
  gjk_copy(out, &((const gjk_concave *)shape->user)->parts, sizeof *out);
  gjk_scene_part_pose(&v, &v.parts[index], &out->pose);
  return GJK_OK;
}
