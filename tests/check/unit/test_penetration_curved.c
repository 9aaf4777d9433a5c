// Depths of cylinder, cone and ellipsoid in each other and in polytopes, against the accurate oracle: within 3 LSB, or
// bounds that hold.
#include <math.h>

#include "check.h"
#include "gjk/penetration.h"
#include "reference/accurate.h"
#include "reference/random_shape.h"

#define SEED 20260611
#define PAIRS_PER_CELL ((unsigned)check_trials(300))
#define TOLERANCE 3.0L
// If the bounds of the oracle are closer than this, LSB, they tell the depth.
#define SHARP 1.0L
#define VERTICES 512
#define CELLS (GJK_EPA_CELLS(VERTICES) + VERTICES)

static const char *const kind_name[] = {"point", "segment", "triangle", "box", "hull", "cylinder", "cone", "ellipsoid"};
static gjk_epa_cell cells[CELLS];

typedef struct tally {
  unsigned pairs, sharp, full;
  unsigned iterations;
  long double depth, point, parting;  // largest errors
} tally;

typedef struct subject {
  case_pair pair;
  case_collider a, b;
} subject;

static void raise(long double *largest, long double value) {
  *largest = value > *largest ? value : *largest;
}

// Puts B's centre within half of both radii of A's.
static bool make_pair(random_state *random, case_kind a, case_kind b, subject *s) {
  const gjk_q16 reach = random_reach(random);
  random_shape(random, a, reach, &s->pair.a);
  random_shape(random, b, random_below(random, 2) == 0 ? reach : random_reach(random), &s->pair.b);
  if (!case_pair_build(&s->pair, false, &s->a, &s->b)) {
    return false;
  }
  const gjk_collider *p = &s->a.collider, *q = &s->b.collider;
  const gjk_vec3 by = random_vector(random, 0.5 * random_unit(random) * ((double)p->radius + q->radius));
  gjk_vec3 *position = &s->pair.b.pose.position;
  position->x += p->centre.x - q->centre.x + by.x;
  position->y += p->centre.y - q->centre.y + by.y;
  position->z += p->centre.z - q->centre.z + by.z;
  return case_pair_build(&s->pair, false, &s->a, &s->b);
}

// How far a point is outside of a shape.
static long double outside(const case_shape *shape, const case_collider *collider, gjk_vec3 point) {
  if (shape->kind == CASE_CYLINDER || shape->kind == CASE_CONE) {
    return accurate_point_distance(shape, point);
  }
  return accurate_point_outside(shape, collider, point);
}

// The points must be of the shapes, and coincide after the move unless EPA had no room.
static bool check_points(const subject *s, const gjk_penetration_result *r, bool full, tally *t) {
  const long double off_a = outside(&s->pair.a, &s->a, r->point_a), off_b = outside(&s->pair.b, &s->b, r->point_b);
  const long double scale = (long double)r->depth / GJK_Q30_ONE;
  const long double x = (long double)r->point_a.x - r->point_b.x - scale * r->normal.x;
  const long double y = (long double)r->point_a.y - r->point_b.y - scale * r->normal.y;
  const long double z = (long double)r->point_a.z - r->point_b.z - scale * r->normal.z;
  const long double off = sqrtl(x * x + y * y + z * z);
  raise(&t->point, off_a);
  raise(&t->point, off_b);
  CHECK_MSG(off_a <= TOLERANCE, "points %.2Lf and %.2Lf LSB outside", off_a, off_b);
  CHECK_MSG(off_b <= TOLERANCE, "points %.2Lf and %.2Lf LSB outside", off_a, off_b);
  CHECK_MSG(full || off <= 2 * TOLERANCE, "points %.2Lf LSB off depth times normal", off);
  return off_a <= TOLERANCE && off_b <= TOLERANCE && (full || off <= 2 * TOLERANCE);
}

// Moved by the depth along the normal, the shapes overlap by at most the tolerance.
static bool check_parting(const subject *s, const gjk_penetration_result *r, tally *t) {
  const long double left = -accurate_separation(&s->pair, &s->a, &s->b, &r->normal) - r->depth;
  raise(&t->parting, left);
  CHECK_MSG(left <= TOLERANCE, "moving by %ld leaves %.2Lf", (long)r->depth, left);
  return left <= TOLERANCE;
}

static bool check_depth(const subject *s, const gjk_penetration_result *r, gjk_status status, tally *t) {
  accurate_result truth;
  accurate_signed(&s->pair, &s->a, &s->b, &truth);
  const long double least = -truth.upper, most = -truth.lower;
  const bool together = most > -TOLERANCE, sharp = most - least <= SHARP;
  CHECK_MSG(r->intersecting ? most >= -TOLERANCE : least <= TOLERANCE, "depth %.2Lf to %.2Lf", least, most);
  if (!r->intersecting || !together) {
    return true;
  }
  t->pairs++;
  t->sharp += sharp;
  t->full += status == GJK_ERROR_CAPACITY;
  // Whether shapes intersect is told to within 2 LSB.
  const bool bounded =
      (r->lower <= most || r->lower == 0) && r->upper >= least && r->lower <= r->depth && r->depth <= r->upper;
  CHECK_MSG(bounded, "%ld to %ld, truth %.2Lf to %.2Lf", (long)r->lower, (long)r->upper, least, most);
  bool right = bounded;
  if (status == GJK_OK) {
    const long double high = r->depth - (most > 0 ? most : 0), low = least - r->depth;
    right = right && high <= TOLERANCE && low <= TOLERANCE;
    raise(&t->depth, high);
    raise(&t->depth, low);
    CHECK_MSG(high <= TOLERANCE, "depth %ld, truth %.2Lf to %.2Lf", (long)r->depth, least, most);
    CHECK_MSG(low <= TOLERANCE, "depth %ld, truth %.2Lf to %.2Lf", (long)r->depth, least, most);
  }
  right = check_parting(s, r, t) && right;
  return check_points(s, r, status != GJK_OK, t) && right;
}

static void test_cell(random_state *random, case_kind a, case_kind b, subject *s) {
  static const gjk_workspace workspace = {cells, CELLS};
  tally t = {0, 0, 0, 0, 0, 0, 0};
  for (unsigned i = 0; i < PAIRS_PER_CELL; i++) {
    gjk_penetration_result r;
    const bool made = make_pair(random, a, b, s);
    CHECK(made);
    const gjk_status status =
        made ? gjk_penetration(&s->a.collider, &s->b.collider, NULL, &workspace, &r) : GJK_ERROR_RANGE;
    CHECK_MSG(status == GJK_OK || status == GJK_ERROR_CAPACITY, "%s", gjk_status_name(status));
    if (status != GJK_OK && status != GJK_ERROR_CAPACITY) {
      case_print(stdout, &s->pair);
      continue;
    }
    t.iterations = r.iterations > t.iterations ? r.iterations : t.iterations;
    if (!check_depth(s, &r, status, &t)) {
      case_print(stdout, &s->pair);
    }
  }
  printf(
      "%-9s in %-9s %3u overlap, %3u with sharp truth, %3u in bounds only, %4u scans; off by %5.2Lf, points %5.2Lf, "
      "parting %5.2Lf\n",
      kind_name[a], kind_name[b], t.pairs, t.sharp, t.full, t.iterations, t.depth, t.point, t.parting);
  fflush(stdout);
  // Of few pairs, perhaps only a few overlap.
  CHECK_MSG(t.pairs > PAIRS_PER_CELL / 6 || PAIRS_PER_CELL < 100, "%u overlap", t.pairs);
}

int main(void) {
  static subject s;
  random_state random = random_seed(check_seed(SEED));
  for (int a = CASE_CYLINDER; a <= CASE_ELLIPSOID; a++) {
    for (int b = CASE_POINT; b <= CASE_ELLIPSOID; b++) {
      test_cell(&random, (case_kind)a, (case_kind)b, &s);
    }
  }
  case_pair_release(&s.pair, &s.a, &s.b);
  return check_done("penetration-curved");
}
