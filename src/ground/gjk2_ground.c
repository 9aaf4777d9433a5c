// Ground and its shape, from the box of all its vertices.
#include "gjk2_ground_box.h"

gjk_status gjk2_ground_set(const gjk2_ground_class *type, const void *data, const gjk2_aabb *box, gjk2_ground *out,
                           gjk2_shape *shape) {
  // Corners are at most 2^28 in size, so sums and differences fit. The middle is rounded down, so upper is farther.
  const gjk2_vec centre = {(int32_t)gjk_sar64((int64_t)box->lower.x + box->upper.x, 1),
                           (int32_t)gjk_sar64((int64_t)box->lower.y + box->upper.y, 1)};
  const gjk2_vec half = gjk2_sub(box->upper, centre);
  const int64_t room = GJK2_RADIUS_MAX;
  if (gjk2_dot(half, half) > room * room) {
    return GJK_ERROR_SIZE;
  }
  out->type = type;
  out->data = data;
  gjk2_copy(&out->centre, &centre);
  shape->type = &gjk2_class_ground;
  shape->vertices = NULL;
  shape->support = NULL;
  shape->user = out;
  gjk2_copy(&shape->size, &half);
  shape->convex_radius = 0;
  shape->count = 0;
  return GJK_OK;
}
