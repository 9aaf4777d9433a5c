// Triangles as parts of a body.
#include "gjk_triangle.h"

#include "../arith/gjk_root.h"
#include "../arith/gjk_rotation.h"
#include "gjk/mesh.h"

void gjk_triangle_start_box(gjk_vec3 *lower, gjk_vec3 *upper) {
  lower->x = lower->y = lower->z = INT32_MAX;
  upper->x = upper->y = upper->z = INT32_MIN;
}

void gjk_triangle_widen(gjk_vec3 *lower, gjk_vec3 *upper, const gjk_vec3 *v) {
  lower->x = v->x < lower->x ? v->x : lower->x;
  lower->y = v->y < lower->y ? v->y : lower->y;
  lower->z = v->z < lower->z ? v->z : lower->z;
  upper->x = v->x > upper->x ? v->x : upper->x;
  upper->y = v->y > upper->y ? v->y : upper->y;
  upper->z = v->z > upper->z ? v->z : upper->z;
}

static void box_of_triangle(const gjk_vec3 corner[3], gjk_aabb *box) {
  gjk_set(&corner[0], &box->lower);
  gjk_set(&corner[0], &box->upper);
  gjk_triangle_widen(&box->lower, &box->upper, &corner[1]);
  gjk_triangle_widen(&box->lower, &box->upper, &corner[2]);
}

bool gjk_triangle_meets_on_way(const gjk_region *region, const gjk_vec3 corner[3]) {
  gjk_aabb box;
  box_of_triangle(corner, &box);
  return gjk_region_meets_on_way(region, &box);
}

static bool is_mesh_coordinate(int32_t x) {
  return x <= GJK_MESH_COORDINATE_MAX && x >= -GJK_MESH_COORDINATE_MAX;
}

// *out = at + offset. False: that is beyond int32.
static bool move_axis(int32_t at, int32_t offset, int32_t *out) {
  *out = gjk_int32((uint32_t)at + (uint32_t)offset);
  return (*out >= at) == (offset >= 0);
}

// |v| <= sqrt(3) 2^30 < 2^31 - 4
static bool turn_corner(const gjk_parts_frame *frame, const gjk_vec3 *v, gjk_vec3 *out) {
  const gjk_vec3 *at = &frame->parts->pose.position;
  if (!is_mesh_coordinate(v->x) || !is_mesh_coordinate(v->y) || !is_mesh_coordinate(v->z)) {
    return false;
  }
  const gjk_vec3 turned = frame->is_level ? *v : gjk_rotate(frame->rows, v);
  return move_axis(at->x, turned.x, &out->x) && move_axis(at->y, turned.y, &out->y) &&
         move_axis(at->z, turned.z, &out->z);
}

bool gjk_triangle_turn(const gjk_parts_frame *frame, const gjk_vec3 corner[3], gjk_vec3 world[3]) {
  return turn_corner(frame, &corner[0], &world[0]) && turn_corner(frame, &corner[1], &world[1]) &&
         turn_corner(frame, &corner[2], &world[2]);
}

static void make_shape(gjk_parts_room *room) {
  const gjk_shape shape = GJK_TRIANGLE(0);
  room->shape.type = shape.type;
  room->shape.vertices = room->vertices;
  room->shape.support = NULL;
  room->shape.user = NULL;
  room->shape.size.x = 0;
  room->shape.size.y = 0;
  room->shape.size.z = 0;
  room->shape.convex_radius = 0;
  room->shape.count = 3;
  room->shape.faces = NULL;
}

static void set_corners(const gjk_vec3 from[3], gjk_parts_room *room) {
  for (unsigned i = 0; i < 3; i++) {
    gjk_set(&from[i], &room->vertices[i]);
  }
}

// Half of a range, rounded up, and its middle, rounded down: as gjk_collider_init has them.
GJK_ONE_COPY static uint32_t half_of(int32_t low, int32_t high, int32_t *middle) {
  *middle = (int32_t)gjk_sar64((int64_t)low + high, 1);
  return (uint32_t)((int64_t)high - *middle);
}

// What gjk_collider_init and gjk_collider_pose at the identity make of these corners, at less cost.
gjk_status gjk_triangle_collider(const gjk_vec3 world[3], gjk_parts_room *room, gjk_collider *out) {
  gjk_aabb box;
  uint64_t most = 0;
  if (GJK_SHAPES < GJK_SHAPES_POLYTOPES) {
    return GJK_ERROR_UNSUPPORTED;
  }
  make_shape(room);
  set_corners(world, room);
  box_of_triangle(world, &box);
  if ((half_of(box.lower.x, box.upper.x, &out->centre.x) | half_of(box.lower.y, box.upper.y, &out->centre.y) |
       half_of(box.lower.z, box.upper.z, &out->centre.z)) >>
          28 !=
      0) {
    return GJK_ERROR_SIZE;
  }
  for (unsigned i = 0; i < 3; i++) {
    const gjk_vec3 offset = gjk_sub(world[i], out->centre);  // below 2^28 along each axis
    const uint64_t squared = (uint64_t)gjk_dot(&offset, &offset);
    gjk_set(&offset, &out->frame[i]);
    most = squared > most ? squared : most;
    out->fraction[i] = 0;
  }
  const uint32_t reach = gjk_isqrt64(most);
  if (most > (uint64_t)GJK_RADIUS_MAX * (uint64_t)GJK_RADIUS_MAX) {
    return GJK_ERROR_SIZE;
  }
  out->shape = &room->shape;
  out->buffer = NULL;
  out->position.x = 0;
  out->position.y = 0;
  out->position.z = 0;
  gjk_set(&out->centre, &out->local_centre);
  out->core_radius = (gjk_q16)reach + 4;
  out->radius = out->core_radius;
  out->bits = (uint8_t)(32 - gjk_clz32((uint32_t)out->core_radius));
  out->count = 3;
  out->state = GJK_STATE_POSED;
  return GJK_OK;
}

gjk_status gjk_triangle_place(const gjk_parts_frame *frame, const gjk_vec3 corner[3], gjk_parts_room *room,
                              gjk_collider *out) {
  gjk_vec3 world[3];
  return gjk_triangle_turn(frame, corner, world) ? gjk_triangle_collider(world, room, out) : GJK_ERROR_RANGE;
}

void gjk_triangle_local(const gjk_vec3 corner[3], gjk_parts_room *room, gjk_parts_local *out) {
  make_shape(room);
  set_corners(corner, room);
  out->shape = &room->shape;
  out->own = NULL;
}

// The larger end of a range, as a size.
static uint32_t farther_end(int32_t low, int32_t high) {
  const uint32_t a = gjk_magnitude32(low), b = gjk_magnitude32(high);
  return a > b ? a : b;
}

uint32_t gjk_triangle_reach(const gjk_vec3 *lower, const gjk_vec3 *upper) {
  const uint32_t x = farther_end(lower->x, upper->x), y = farther_end(lower->y, upper->y),
                 z = farther_end(lower->z, upper->z);
  return gjk_isqrt64(gjk_umul32(x, x) + gjk_umul32(y, y) + gjk_umul32(z, z)) + 4;  // squares at most 2^62 each
}

static int64_t gap_on_axis(int32_t low, int32_t high, int32_t own_low, int32_t own_high) {
  return low > own_high ? (int64_t)low - own_high : own_low > high ? (int64_t)own_low - high : 0;
}

int64_t gjk_box_gap(const gjk_vec3 *lower, const gjk_vec3 *upper, const gjk_region *region) {
  const gjk_aabb *own = &region->box;
  return gap_on_axis(lower->x, upper->x, own->lower.x, own->upper.x) +
         gap_on_axis(lower->y, upper->y, own->lower.y, own->upper.y) +
         gap_on_axis(lower->z, upper->z, own->lower.z, own->upper.z);
}

GJK_ONE_COPY static int64_t middles_apart(int32_t low, int32_t high, int32_t own_low, int32_t own_high) {
  const int64_t doubled = (int64_t)low + high - own_low - own_high;
  return doubled < 0 ? -doubled : doubled;
}

int64_t gjk_triangle_distance(const gjk_vec3 corner[3], const gjk_region *region) {
  const gjk_aabb *own = &region->box;
  gjk_aabb box;
  box_of_triangle(corner, &box);
  return 16 * gjk_box_gap(&box.lower, &box.upper, region) +
         middles_apart(box.lower.x, box.upper.x, own->lower.x, own->upper.x) +
         middles_apart(box.lower.y, box.upper.y, own->lower.y, own->upper.y) +
         middles_apart(box.lower.z, box.upper.z, own->lower.z, own->upper.z);
}

GJK_ONE_COPY static int sign_of_first(const gjk_long3 *n) {
  return gjk_sign64(n->x != 0 ? n->x : n->y != 0 ? n->y : n->z);
}

// Corners of a triangle are at most 2^28 apart along each axis, so edges are below 2^29 long: |n| < 2^58.
gjk_mesh_edge gjk_triangle_edge_of(const gjk_vec3 *a, const gjk_vec3 *b, const gjk_vec3 *c, const gjk_vec3 *w) {
  gjk_long3 n, beyond;
  gjk_triangle_normal(a, b, c, &n);
  const gjk_vec3 step = gjk_sub(*w, *a);
  const int side = gjk_dot_sign(&n, &step);
  if (side != 0) {
    return side > 0 ? GJK_MESH_CONCAVE : GJK_MESH_CONVEX;
  }
  // In one plane the normals of a, b, c and a, b, w are parallel. They point alike where w is on the side of c.
  gjk_triangle_normal(a, b, w, &beyond);
  const int of_n = sign_of_first(&n);
  return of_n != 0 && of_n == sign_of_first(&beyond) ? GJK_MESH_CONVEX : GJK_MESH_FLAT;
}
