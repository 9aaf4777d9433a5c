// The class of shapes of ground: that of a box in its own frame until its queries are asked.
#include "gjk2_ground_box.h"
#include "gjk2_ground_queries.h"

static const gjk2_ground *ground_of_shape(const gjk2_shape *shape) {
  return (const gjk2_ground *)shape->user;
}

// Colliders are bound by a scene alone, for the box: see gjk2_ground_bind.
static gjk_status refuse_ground(const gjk2_shape *shape, gjk2_extent *out) {
  (void)shape;
  (void)out;
  return GJK_ERROR_UNSUPPORTED;
}

static gjk_status measure_ground(const gjk2_shape *shape, gjk2_extent *out) {
  const gjk2_vec *half = &shape->size;
  if (half->x < 0 || half->y < 0) {
    return GJK_ERROR_NEGATIVE;
  }
  gjk2_copy(&out->centre, &ground_of_shape(shape)->centre);
  out->squared = (uint64_t)gjk2_dot(*half, *half);
  out->ordered = false;
  return GJK_OK;
}

// Keeps the rotation, as curved shapes do.
static void pose_ground(gjk2_collider *c, const gjk2_vec *rotation) {
  const gjk2_vec none = {0, 0};
  gjk2_copy(&c->frame[0], rotation);
  gjk2_copy(&c->frame[1], &none);
  gjk2_copy(&c->frame[2], &none);
}

// How far the box reaches along an axis of the world. Its half extents are whole, and posed vertices within 1 LSB.
//   |rotation| <= 2^30, |size| <= 2^28:  products <= 2^58
static int32_t box_reach(int32_t along, int32_t across, const gjk2_vec *size) {
  const int64_t reach =
      gjk_mac32(gjk_mul32((int32_t)gjk_magnitude32(along), size->x), (int32_t)gjk_magnitude32(across), size->y);
  return (int32_t)gjk_sar64(reach + (INT64_C(1) << 30) - 1, 30) + 1;
}

// A corner of the box in the world's axes, for bounds alone.
static void support_ground(const gjk2_collider *c, const gjk2_vec *d, gjk2_support *out) {
  const gjk2_vec *turn = &c->frame[0], *size = &c->shape->size;
  const int32_t x = box_reach(turn->x, turn->y, size), y = box_reach(turn->y, turn->x, size);
  out->offset.x = d->x < 0 ? -x : x;
  out->offset.y = d->y < 0 ? -y : y;
  out->vertex = 0;
}

// What gjk2_collider_init measures for gjk2_ground_bind, where the public class refuses.
static const gjk2_shape_class class_of_ground_box = {
    .measure = measure_ground,
    .pose = pose_ground,
    .support = support_ground,
    .vertex = NULL,
    .adjacent = NULL,
    .depth = NULL,
    .touch = NULL,
    .ground = NULL,
    .buffered = false,
    .count = 0,
};

static gjk_status bind_ground(const gjk2_shape *shape, gjk2_collider *out) {
  gjk2_shape box;
  const gjk2_ground *ground = ground_of_shape(shape);
  if (ground == NULL || ground->type == NULL || ground->data == NULL) {
    return GJK_ERROR_NULL;
  }
  box.type = &class_of_ground_box;
  box.vertices = NULL;
  box.support = NULL;
  box.user = ground;
  gjk2_copy(&box.size, &shape->size);
  box.convex_radius = 0;
  box.count = 0;
  const gjk_status status = gjk2_collider_init(out, &box, NULL, 0);
  out->shape = shape;
  return status;
}

static const struct gjk2_ground_queries ground_queries = {
    .bind = bind_ground,
    .within = gjk2_ground_within,
    .distance = gjk2_ground_distance,
    .contacts = gjk2_ground_contacts,
    .cast = gjk2_ground_cast_ahead,
    .ray = gjk2_ground_cast_ray,
};

const gjk2_shape_class gjk2_class_ground = {
    .measure = refuse_ground,
    .pose = pose_ground,
    .support = support_ground,
    .vertex = NULL,
    .adjacent = NULL,
    .depth = NULL,
    .touch = NULL,
    .ground = &ground_queries,
    .buffered = false,
    .count = 0,
};

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
