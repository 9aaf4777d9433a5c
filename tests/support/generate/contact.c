// Makes pairs whose shapes share planes, lines, points or lattices.
#include "contact.h"

#include <stdlib.h>
#include <string.h>

#include "place.h"
#include "polytope.h"
#include "prism.h"

// v + factor u.
static gjk_vec3 step(gjk_vec3 v, int32_t factor, gjk_vec3 u) {
  const gjk_vec3 sum = {v.x + factor * u.x, v.y + factor * u.y, v.z + factor * u.z};
  return sum;
}

// Moves by one LSB along the axis in which the vector is longest.
static gjk_vec3 nudge_along(gjk_vec3 v) {
  const gjk_vec3 x = {v.x < 0 ? -1 : 1, 0, 0}, y = {0, v.y < 0 ? -1 : 1, 0}, z = {0, 0, v.z < 0 ? -1 : 1};
  const int32_t ax = abs(v.x), ay = abs(v.y), az = abs(v.z);
  return ax >= ay && ax >= az ? x : ay >= az ? y : z;
}

void generate_stacked(random_state *random, case_pair *pair) {
  case_collider built;
  memset(&built, 0, sizeof built);
  generate_polytope(random, CASE_BOX, generate_reach(random), &pair->a);
  pair->a.pose.rotation = generate_rotation(random);
  case_shape_copy(&pair->b, &pair->a);
  if (case_collider_build(&built, &pair->a, false) == GJK_OK) {
    const gjk_vec3 *frame = built.collider.frame;
    const unsigned axis = random_below(random, 3);
    gjk_vec3 p = step(pair->a.pose.position, 2, frame[axis]);
    p = step(p, random_range(random, -2, 2), frame[(axis + 1) % 3]);
    p = step(p, random_range(random, -2, 2), frame[(axis + 2) % 3]);
    pair->b.pose.position = step(p, random_range(random, -1, 1), nudge_along(frame[axis]));
  }
  case_collider_free(&built);
}

void generate_stacked_hulls(random_state *random, case_pair *pair) {
  generate_stacked(random, pair);
  generate_bake(&pair->a);
  generate_bake(&pair->b);
}

// A plane of small integers: its normal, and two directions in it.
typedef struct tilted_plane {
  gjk_vec3 normal, u, v;
} tilted_plane;

static tilted_plane make_plane(random_state *random) {
  tilted_plane p;
  do {
    p.normal.x = random_range(random, -5, 5);
    p.normal.y = random_range(random, -5, 5);
    p.normal.z = random_range(random, -5, 5);
  } while (p.normal.x == 0 && p.normal.y == 0);
  const gjk_vec3 n = p.normal, u = {n.y, -n.x, 0};
  const gjk_vec3 v = {n.y * u.z - n.z * u.y, n.z * u.x - n.x * u.z, n.x * u.y - n.y * u.x};
  p.u = u;
  p.v = v;
  return p;
}

// A point of the plane, moved by height along the normal.
static gjk_vec3 on_plane(random_state *random, const tilted_plane *p, int32_t spread, int32_t height) {
  static const gjk_vec3 origin = {0, 0, 0};
  const gjk_vec3 v = step(origin, random_range(random, -spread, spread), p->u);
  return step(step(v, random_range(random, -spread, spread), p->v), height, p->normal);
}

void generate_shared_feature(random_state *random, case_pair *pair) {
  const tilted_plane plane = make_plane(random);
  const int32_t spread = (generate_reach(random) >> 10) + 1;
  const unsigned shared = 1 + random_below(random, 4);
  case_shape *shapes[2] = {&pair->a, &pair->b};
  for (int side = 0; side < 2; side++) {
    case_shape *shape = shapes[side];
    shape->kind = CASE_HULL;
    case_shape_set_count(shape, shared + 1 + random_below(random, 12));
    for (size_t i = 0; i < shape->count; i++) {
      const int32_t height = random_range(random, 1, 16 * spread);
      shape->vertices[i] = i >= shared ? on_plane(random, &plane, 4 * spread, side == 0 ? -height : height)
                           : side == 0 ? on_plane(random, &plane, 4 * spread, 0)
                                       : pair->a.vertices[i];
    }
  }
  pair->b.pose.position = step(pair->a.pose.position, random_range(random, -1, 1), nudge_along(plane.normal));
}

void generate_lattice(random_state *random, case_pair *pair) {
  const gjk_q16 unit = (generate_reach(random) >> 3) + 1;
  case_shape *shapes[2] = {&pair->a, &pair->b};
  for (int k = 0; k < 2; k++) {
    case_shape *shape = shapes[k];
    shape->kind = CASE_HULL;
    case_shape_set_count(shape, 2 + random_below(random, 20));
    for (size_t i = 0; i < shape->count; i++) {
      gjk_vec3 *v = &shape->vertices[i];
      v->x = random_range(random, -2, 2) * unit;
      v->y = random_range(random, -2, 2) * unit;
      v->z = random_range(random, -2, 2) * unit;
    }
  }
  gjk_vec3 *p = &pair->b.pose.position;
  p->x = random_range(random, -3, 3) * unit;
  p->y = random_range(random, -3, 3) * unit;
  p->z = random_range(random, 0, 4) * unit + random_range(random, -1, 1);
}

void generate_flat(random_state *random, case_pair *pair) {
  static const gjk_vec3 origin = {0, 0, 0};
  const double reach = generate_reach(random) / 9.0 + 1;
  const gjk_vec3 u = generate_vector(random, reach), v = generate_vector(random, reach);
  const bool line_a = random_below(random, 3) == 0, line_b = random_below(random, 3) == 0;
  case_shape *shapes[2] = {&pair->a, &pair->b};
  for (int k = 0; k < 2; k++) {
    case_shape *shape = shapes[k];
    const bool line = k == 0 ? line_a : line_b;
    shape->kind = CASE_HULL;
    case_shape_set_count(shape, 1 + random_below(random, 12));
    for (size_t i = 0; i < shape->count; i++) {
      const gjk_vec3 at = step(origin, random_range(random, -3, 3), u);
      shape->vertices[i] = step(at, line ? 0 : random_range(random, -3, 3), v);
    }
  }
  const gjk_vec3 p = step(step(origin, random_range(random, -4, 4), u), random_range(random, -2, 2), v);
  pair->b.pose.position = p;
  pair->b.pose.position.z += random_below(random, 4) == 0 ? random_range(random, -1, 1) : 0;
}

// The shapes stand corner to corner, at an offset whose length is an integer.
void generate_level_radius(random_state *random, case_pair *pair) {
  static const int32_t offsets[][4] = {{0, 0, 1, 1}, {0, 3, 4, 5},  {1, 2, 2, 3},  {2, 3, 6, 7},   {1, 4, 8, 9},
                                       {4, 4, 7, 9}, {2, 6, 9, 11}, {6, 6, 7, 11}, {8, 9, 12, 17}, {0, 20, 21, 29}};
  const int32_t *o = offsets[random_below(random, sizeof offsets / sizeof offsets[0])];
  const int32_t scale = (generate_reach(random) >> 7) + 2;
  const int32_t w[3] = {o[0] * scale, o[1] * scale, o[2] * scale}, sum = o[3] * scale;
  const unsigned turn = random_below(random, 3);
  generate_polytope(random, random_below(random, 2) == 0 ? CASE_BOX : CASE_POINT, generate_reach(random) >> 1,
                    &pair->a);
  generate_polytope(random, random_below(random, 2) == 0 ? CASE_BOX : CASE_POINT, generate_reach(random) >> 1,
                    &pair->b);
  const gjk_vec3 a = pair->a.size, b = pair->b.size;
  gjk_vec3 *p = &pair->b.pose.position;
  p->x = a.x + b.x + w[turn];
  p->y = a.y + b.y + w[(turn + 1) % 3];
  p->z = a.z + b.z + w[(turn + 2) % 3];
  *(random_below(random, 2) == 0 ? &p->x : &p->y) += random_range(random, -1, 1);
  pair->a.convex_radius = random_range(random, 0, sum);
  pair->b.convex_radius = sum - pair->a.convex_radius;
}

// Turned about an axis, and tilted by at most 2^-tilt.
static gjk_quat tilted_rotation(random_state *random, unsigned tilt) {
  const gjk_q30 one = GJK_Q30_ONE / 2, most = GJK_Q30_ONE >> tilt, a = random_range(random, -most, most),
                b = random_range(random, -most, most);
  const gjk_quat about[4] = {{one, one, a, b}, {a, one, one, b}, {one, a, b, one}, {a, b, one, 0}};
  gjk_quat out = about[random_below(random, 4)];
  gjk_quat_normalize(&out, &out);
  return out;
}

static void make_prism(random_state *random, gjk_q16 wide, gjk_q16 thin, case_shape *shape) {
  const gjk_vec3 size = {wide, wide, thin};
  shape->size = size;
  generate_prism(3 + random_below(random, 4), shape);
  shape->convex_radius = random_below(random, 2) == 0 ? 0 : random_range(random, 1, wide);
}

void generate_tilted(random_state *random, case_pair *pair) {
  const gjk_q16 wide = generate_reach(random) / 4 + 16, least = wide >> random_below(random, 26),
                thin = random_below(random, 2) == 0 ? 0 : least, near = thin + (gjk_q16)random_below(random, 2);
  gjk_vec3 *p = &pair->b.pose.position;
  make_prism(random, wide, thin, &pair->a);
  pair->a.pose.rotation = tilted_rotation(random, random_below(random, 30));
  if (random_below(random, 2) == 0) {
    make_prism(random, wide, thin, &pair->b);
    pair->b.pose.rotation = tilted_rotation(random, random_below(random, 30));
  } else {
    generate_polytope(random, generate_kind(random), wide, &pair->b);
  }
  p->x = random_range(random, -near, near);
  p->y = random_range(random, -near, near);
  p->z = random_range(random, -near, near);
}
