// Places the shapes of a pair.
#include "place.h"

#include <math.h>
#include <string.h>

#include "exact/exact.h"
#include "polytope.h"

typedef struct built_pair {
  case_collider a, b;
} built_pair;

static bool build(const case_pair *pair, built_pair *out) {
  return case_pair_build(pair, false, &out->a, &out->b);
}

static void release(built_pair *built) {
  case_collider_free(&built->a);
  case_collider_free(&built->b);
}

static gjk_q16 clamp(int64_t x) {
  return x > INT32_MAX ? INT32_MAX : x < INT32_MIN ? INT32_MIN : (gjk_q16)x;
}

static void move(case_shape *shape, const gjk_vec3 *by) {
  gjk_vec3 *p = &shape->pose.position;
  p->x = clamp((int64_t)p->x + by->x);
  p->y = clamp((int64_t)p->y + by->y);
  p->z = clamp((int64_t)p->z + by->z);
}

// Puts B's centre at factor times both radii from A's.
static void set_apart(random_state *random, double factor, case_pair *pair, built_pair *built) {
  const gjk_collider *a = &built->a.collider, *b = &built->b.collider;
  if (build(pair, built)) {
    gjk_vec3 by = generate_vector(random, factor * ((double)a->radius + b->radius));
    by.x = clamp((int64_t)by.x + a->centre.x - b->centre.x);
    by.y = clamp((int64_t)by.y + a->centre.y - b->centre.y);
    by.z = clamp((int64_t)by.z + a->centre.z - b->centre.z);
    move(&pair->b, &by);
  }
}

void generate_apart(random_state *random, double factor, case_pair *pair) {
  built_pair built;
  memset(&built, 0, sizeof built);
  pair->a.pose.rotation = generate_rotation(random);
  pair->b.pose.rotation = generate_rotation(random);
  pair->a.pose.position = generate_vector(random, (double)generate_reach(random));
  set_apart(random, factor, pair, &built);
  release(&built);
}

// Moves B to the given gap, if the shapes are apart.
static bool approach(const built_pair *built, gjk_q16 gap, case_pair *pair) {
  gjk_distance_result r;
  if (gjk_distance(&built->a.collider, &built->b.collider, NULL, &r) != GJK_OK || r.intersecting) {
    return false;
  }
  const double scale = (double)gap / GJK_Q30_ONE;
  const gjk_vec3 by = {clamp((int64_t)r.point_a.x - r.point_b.x + llrint(r.normal.x * scale)),
                       clamp((int64_t)r.point_a.y - r.point_b.y + llrint(r.normal.y * scale)),
                       clamp((int64_t)r.point_a.z - r.point_b.z + llrint(r.normal.z * scale))};
  move(&pair->b, &by);
  return true;
}

void generate_near(random_state *random, gjk_q16 gap, case_pair *pair) {
  built_pair built;
  memset(&built, 0, sizeof built);
  set_apart(random, 1.1, pair, &built);
  // The first step stops before the shapes touch. From there the second step is as exact as integer coordinates allow.
  if (build(pair, &built) && approach(&built, 8, pair) && build(pair, &built)) {
    approach(&built, gap, pair);
  }
  release(&built);
}

// How far one coordinate of both may move up, or down.
static int64_t room(bool up, int32_t position_a, int32_t position_b, int32_t centre_a, int32_t centre_b) {
  const int64_t all[4] = {position_a, position_b, centre_a, centre_b};
  int64_t outermost = all[0];
  for (int i = 1; i < 4; i++) {
    outermost = (up ? all[i] > outermost : all[i] < outermost) ? all[i] : outermost;
  }
  return (up ? INT32_MAX : INT32_MIN) - outermost;
}

void generate_outermost(random_state *random, case_pair *pair) {
  built_pair built;
  memset(&built, 0, sizeof built);
  if (build(pair, &built)) {
    const unsigned corner = random_below(random, 8);
    const gjk_vec3 *p = &pair->a.pose.position, *q = &pair->b.pose.position;
    const gjk_vec3 *a = &built.a.collider.centre, *b = &built.b.collider.centre;
    const int64_t slack = (int64_t)random_below(random, 100);
    const int64_t x = room((corner & 1) != 0, p->x, q->x, a->x, b->x),
                  y = room((corner & 2) != 0, p->y, q->y, a->y, b->y);
    const int64_t z = room((corner & 4) != 0, p->z, q->z, a->z, b->z);
    const gjk_vec3 by = {clamp(x > 0 ? x - slack : x + slack), clamp(y > 0 ? y - slack : y + slack),
                         clamp(z > 0 ? z - slack : z + slack)};
    move(&pair->a, &by);
    move(&pair->b, &by);
  }
  release(&built);
}

void generate_bake(case_shape *shape) {
  static const gjk_quat identity = {0, 0, 0, GJK_Q30_ONE};
  case_collider built;
  memset(&built, 0, sizeof built);
  if (case_collider_build(&built, shape, false) == GJK_OK) {
    const gjk_vec3 centre = built.collider.centre;
    const unsigned count = exact_vertex_count(&built.collider);
    shape->kind = CASE_HULL;
    case_shape_set_count(shape, count);
    for (unsigned i = 0; i < count; i++) {
      const exact_point v = exact_vertex(&built.collider, i);
      const gjk_vec3 offset = {(gjk_q16)(v.x[0] - centre.x), (gjk_q16)(v.x[1] - centre.y),
                               (gjk_q16)(v.x[2] - centre.z)};
      shape->vertices[i] = offset;
    }
    shape->pose.position = centre;
    shape->pose.rotation = identity;
  }
  case_collider_free(&built);
}
