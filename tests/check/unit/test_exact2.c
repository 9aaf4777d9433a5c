// The exact oracle of the plane, against answers known by hand and against the library's queries in space: flat hulls
// are as far apart there, and prisms higher than deep overlap as much.
#include "exact/exact2.h"

#include "case/case.h"
#include "check.h"
#include "generate/generate2.h"

#define PAIRS check_trials(2000)

static exact2_truth find(const exact2_point *a, unsigned n, int64_t radius_a, const exact2_point *b, unsigned m,
                         int64_t radius_b) {
  const exact2_shape of_a = {a, n, radius_a}, of_b = {b, m, radius_b};
  exact2_truth truth;
  exact2_find(&of_a, &of_b, &truth);
  return truth;
}

static void known(void) {
  static const exact2_point square[] = {{0, 0}, {10, 0}, {10, 10}, {0, 10}}, corner[] = {{10, 10}, {20, 20}, {10, 20}};
  static const exact2_point point[] = {{13, 14}}, inside[] = {{3, 4}}, line[] = {{-5, 4}, {15, 4}, {0, 4}};
  static const exact2_point beyond[] = {{20, 4}, {30, 4}}, diagonal[] = {{11, 0}, {0, 11}};
  exact2_truth t = find(square, 4, 0, corner, 3, 0);
  CHECK(t.intersecting && t.cores_meet && t.depth == 0);
  t = find(square, 4, 0, point, 1, 0);
  CHECK(!t.intersecting && t.distance == 5 && t.direction.x == 3 && t.direction.y == 4);
  t = find(square, 4, 4, point, 1, 1);
  CHECK(t.intersecting && !t.cores_meet && t.depth == 0);
  t = find(square, 4, 4, point, 1, 3);
  CHECK(t.intersecting && t.depth == 2);
  t = find(square, 4, 0, inside, 1, 2);
  CHECK(t.intersecting && t.cores_meet && t.depth == 5 && t.direction.x < 0 && t.direction.y == 0);
  t = find(line, 3, 0, beyond, 2, 0);
  CHECK(!t.intersecting && t.distance == 5);
  t = find(line, 3, 0, inside, 1, 0);
  CHECK(t.intersecting && t.depth == 0);
  t = find(inside, 1, 1, inside, 1, 1);
  CHECK(t.intersecting && t.depth == 2);
  t = find(square, 4, 0, diagonal, 2, 0);  // 9 / sqrt(2), rounded up
  CHECK(t.intersecting && t.depth == 7 && t.direction.x == t.direction.y && t.direction.x > 0);
  const exact2_point near[] = {{11, 11}};
  t = find(square, 4, 0, near, 1, 0);  // sqrt(2)
  CHECK(!t.intersecting && t.distance == 1);
  const exact2_shape a = {square, 4, 0}, b = {near, 1, 0};
  CHECK(!exact2_within(&a, &b, 1) && exact2_within(&a, &b, 2));
}

// A prism over the points of a shape, or with height 0 a flat hull.
static void lift(const exact2_point *point, unsigned n, gjk_q16 radius, gjk_q16 height, case_shape *out) {
  const unsigned layers = height > 0 ? 2 : 1;
  case_shape_reset(out);
  out->kind = CASE_HULL;
  out->convex_radius = radius;
  case_shape_set_count(out, (size_t)n * layers);
  const exact2_point origin = point[0];
  out->pose.position.x = (gjk_q16)origin.x;
  out->pose.position.y = (gjk_q16)origin.y;
  for (unsigned i = 0; i < n * layers; i++) {
    out->vertices[i] = (gjk_vec3){(gjk_q16)(point[i % n].x - origin.x), (gjk_q16)(point[i % n].y - origin.y),
                                  i < n ? -height : height};
  }
}

typedef struct lifted {
  case_pair pair;
  case_collider a, b;
} lifted;

static bool build(lifted *l, const exact2_shape *a, const exact2_shape *b, gjk_q16 height) {
  lift(a->point, a->count, (gjk_q16)a->radius, height, &l->pair.a);
  lift(b->point, b->count, (gjk_q16)b->radius, height, &l->pair.b);
  return case_pair_build(&l->pair, false, &l->a, &l->b);
}

typedef struct counts {
  unsigned long apart, together, deep;
} counts;

// Distances in space, of flat hulls. More than 8192 units apart they are right to 2^-28 alone.
static void check_flat(lifted *l, const exact2_shape *a, const exact2_shape *b, const exact2_truth *truth, counts *n) {
  gjk_distance_result r;
  if (!build(l, a, b, 0) || gjk_distance(&l->a.collider, &l->b.collider, NULL, &r) != GJK_OK) {
    return;
  }
  const int64_t error = truth->distance >> 28;
  CHECK(r.intersecting == truth->intersecting);
  CHECK(r.saturated || (r.distance >= truth->distance - error && r.distance <= truth->distance + error));
  CHECK(exact2_within(a, b, 0) == truth->intersecting);
  if (!truth->intersecting && truth->distance < INT32_MAX) {
    gjk_decision decision;
    const gjk_q16 distance = (gjk_q16)truth->distance;
    CHECK(error > 0 || (gjk_within(&l->a.collider, &l->b.collider, distance, NULL, &decision) == GJK_OK &&
                        decision.yes == exact2_within(a, b, distance)));
  }
  n->apart += truth->intersecting ? 0 : 1;
  n->together += truth->intersecting ? 1 : 0;
}

#define HEIGHT (INT32_C(1) << 26)
#define CELLS GJK_EPA_CELLS(2048)

// Depths in space, of prisms that are deeper overlapping along z.
static void check_prisms(lifted *l, const exact2_shape *a, const exact2_shape *b, const exact2_truth *truth,
                         counts *n) {
  static gjk_epa_cell cells[CELLS];
  const gjk_workspace workspace = {cells, CELLS};
  gjk_penetration_result r;
  if (!truth->intersecting || truth->depth >= 2 * HEIGHT || a->count > 32 || b->count > 32 || !build(l, a, b, HEIGHT) ||
      gjk_penetration(&l->a.collider, &l->b.collider, NULL, &workspace, &r) != GJK_OK) {
    return;
  }
  CHECK(r.intersecting);
  CHECK_MSG(r.depth == truth->depth, "%ld in space, %ld", (long)r.depth, (long)truth->depth);
  n->deep++;
}

// The answer does not change when the shapes change places, or the plane is turned by a quarter.
static void check_symmetry(const exact2_shape *a, const exact2_shape *b, const exact2_truth *truth) {
  static exact2_point turned[2][GENERATE2_VERTICES_MAX];
  const exact2_shape *shape[2] = {b, a};
  exact2_shape other[2];
  exact2_truth again;
  for (int side = 0; side < 2; side++) {
    for (unsigned i = 0; i < shape[side]->count; i++) {
      turned[side][i].x = -shape[side]->point[i].y;
      turned[side][i].y = shape[side]->point[i].x;
    }
    other[side] = *shape[side];
    other[side].point = turned[side];
  }
  exact2_find(&other[0], &other[1], &again);
  CHECK(again.intersecting == truth->intersecting && again.cores_meet == truth->cores_meet);
  CHECK(again.distance == truth->distance && again.depth == truth->depth);
}

// Every point lies on the left of every edge or on it, and every corner is a point.
static void check_hull(const exact2_shape *shape) {
  static exact2_hull hull;
  bool convex = true;
  unsigned corners = 0;
  exact2_hull_find(shape->point, shape->count, &hull);
  for (unsigned i = 0; i < hull.count; i++) {
    const exact2_point p = hull.vertex[i], q = hull.vertex[(i + 1) % hull.count];
    bool found = false;
    for (unsigned k = 0; k < shape->count; k++) {
      const exact2_point r = shape->point[k];
      convex = convex && (q.x - p.x) * (r.y - p.y) >= (q.y - p.y) * (r.x - p.x);  // edges below 2^30
      found = found || (r.x == p.x && r.y == p.y);
    }
    corners += found ? 1 : 0;
  }
  CHECK(convex);
  CHECK(hull.count > 0 && corners == hull.count);
}

static void random_pairs(uint64_t seed) {
  static case2_pair pair;
  static exact2_point a[GENERATE2_VERTICES_MAX], b[GENERATE2_VERTICES_MAX];
  static lifted l;
  counts all = {0, 0, 0};
  for (unsigned f = 0; f < generate2_family_count; f++) {
    const generate2_family *family = &generate2_families[f];
    unsigned long together = 0, near = 0;
    for (unsigned long i = 0; i < PAIRS; i++) {
      generate2_pair(family, seed * 1000003 + i, &pair);
      check_trial(i, case2_show, &pair);
      const exact2_shape of_a = {a, generate2_points(&pair.a, a), pair.a.convex_radius};
      const exact2_shape of_b = {b, generate2_points(&pair.b, b), pair.b.convex_radius};
      exact2_truth truth;
      exact2_find(&of_a, &of_b, &truth);
      check_hull(&of_a);
      check_symmetry(&of_a, &of_b, &truth);
      check_flat(&l, &of_a, &of_b, &truth, &all);
      check_prisms(&l, &of_a, &of_b, &truth, &all);
      together += truth.intersecting ? 1 : 0;
      near += !truth.intersecting && truth.distance <= family->near ? 1 : 0;
    }
    check_trial(0, NULL, NULL);
    if (PAIRS >= 1000) {  // The mix must still test both sides.
      CHECK_MSG(100 * together >= family->least * PAIRS && 100 * together <= family->most * PAIRS, "%s: %lu of %lu",
                family->name, together, PAIRS);
      CHECK_MSG(family->near == 0 || 10 * near >= 9 * (PAIRS - together), "%s: %lu near", family->name, near);
    }
  }
  CHECK(all.apart > PAIRS && all.together > PAIRS && all.deep > PAIRS);
  case_pair_release(&l.pair, &l.a, &l.b);
  case2_pair_free(&pair);
}

int main(void) {
  const uint64_t seed = check_seed(20261122);
  known();
  random_pairs(seed);
  return check_done("exact2");
}
