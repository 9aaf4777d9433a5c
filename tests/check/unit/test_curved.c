// Cylinder, cone, ellipsoid and custom shapes against the accurate oracle: within 2 LSB, at every scale.
#include <math.h>

#include "check.h"
#include "reference/accurate.h"
#include "reference/random_shape.h"

#define SEED 20240611
#define PAIRS_PER_CELL ((unsigned)check_trials(300))
#define POINTS_PER_KIND ((unsigned)check_trials(20000))
#define TOLERANCE 2.0L
// The largest gap between the oracle's bounds, LSB.
#define SHARPNESS 0.001L

typedef enum placement { APART, NEAR, OVERLAPPING, STACKED, PLACEMENTS } placement;

static const char *const placement_name[] = {"apart", "near touching", "overlapping", "stacked"};
static const char *const kind_name[] = {"point", "segment", "triangle", "box", "hull", "cylinder", "cone", "ellipsoid"};

// What a family of pairs has shown.
typedef struct family {
  unsigned pairs, intersecting, decided_otherwise, cache_differs;
  long double distance_error, point_error, gap_error, normal_error;
  int iterations, oracle_iterations;
} family;

static void raise(long double *largest, long double value) {
  *largest = value > *largest ? value : *largest;
}

static void add(gjk_vec3 *v, gjk_vec3 by) {
  v->x += by.x;
  v->y += by.y;
  v->z += by.z;
}

// Moves B until its gap is -3 to 3 LSB, as nearly as integer coordinates allow.
static void bring_near(random_state *random, case_pair *pair, case_collider *a, case_collider *b) {
  accurate_result gap;
  accurate_distance(pair, a, b, &gap);
  const long double by = -gap.upper + random_range(random, -3, 3);
  gjk_vec3 step = {(gjk_q16)lroundl(gap.normal[0] * by), (gjk_q16)lroundl(gap.normal[1] * by),
                   (gjk_q16)lroundl(gap.normal[2] * by)};
  add(&pair->b.pose.position, step);
}

// Stacks B on A within 3 LSB, both with the same rotation, so that faces, rims and axes are parallel.
static void stack(random_state *random, case_pair *pair) {
  static const gjk_pose upright = GJK_POSE_IDENTITY;
  const int32_t side = pair->a.size.x + pair->b.size.x;
  pair->a.pose = upright;
  pair->b.pose = upright;
  if (random_below(random, 2) == 0) {
    pair->b.pose.position.x = random_range(random, -side, side);
    pair->b.pose.position.y = random_range(random, -side, side);
  }
  pair->b.pose.position.z =
      pair->a.size.z + pair->a.convex_radius + pair->b.size.z + pair->b.convex_radius + random_range(random, -3, 3);
}

static bool make_pair(random_state *random, case_kind a_kind, case_kind b_kind, placement place, case_pair *pair,
                      case_collider *a, case_collider *b) {
  const gjk_q16 reach = random_reach(random);
  // Sizes of two shapes: of the same order of magnitude, or any.
  const gjk_q16 other = random_below(random, 2) == 0 ? reach : random_reach(random);
  random_shape(random, a_kind, reach, &pair->a);
  random_shape(random, b_kind, other, &pair->b);
  if (place == STACKED) {
    stack(random, pair);
    return case_pair_build(pair, false, a, b);
  }
  pair->a.pose.position = random_vector(random, random_below(random, 2) == 0 ? 1e9 : 1e3);
  pair->b.pose.position = pair->a.pose.position;
  if (!case_pair_build(pair, false, a, b)) {
    return false;
  }
  // The way from a hull's own origin to its centre.
  gjk_vec3 to_a = {a->collider.centre.x - b->collider.centre.x, a->collider.centre.y - b->collider.centre.y,
                   a->collider.centre.z - b->collider.centre.z};
  const double radii = (double)a->collider.radius + b->collider.radius;
  const double share = place == APART ? 1 + random_unit(random) : place == NEAR ? 1.1 : 0.5 * random_unit(random);
  add(&pair->b.pose.position, to_a);
  add(&pair->b.pose.position, random_vector(random, share * radii + (place == OVERLAPPING ? 0 : 8)));
  if (!case_pair_build(pair, false, a, b)) {
    return false;
  }
  if (place == NEAR) {
    bring_near(random, pair, a, b);
  }
  return case_pair_build(pair, false, a, b);
}

// The distance of a point from a shape: in closed form from a curved shape, by the accurate oracle from a polytope.
static long double point_error(const case_shape *shape, const case_collider *collider, gjk_vec3 point) {
  if (shape->kind > CASE_HULL) {
    return fabsl(accurate_point_distance(shape, point));
  }
  const long double off = accurate_point_outside(shape, collider, point);
  return off > 0 ? off : 0;
}

static bool check_points(const case_pair *pair, const case_collider *a, const case_collider *b,
                         const gjk_distance_result *found, family *f) {
  const long double off_a = point_error(&pair->a, a, found->point_a), off_b = point_error(&pair->b, b, found->point_b);
  const long double gap =
      hypotl(hypotl((long double)found->point_b.x - found->point_a.x, (long double)found->point_b.y - found->point_a.y),
             (long double)found->point_b.z - found->point_a.z);
  const long double along = accurate_separation(pair, a, b, &found->normal);
  raise(&f->point_error, off_a > off_b ? off_a : off_b);
  raise(&f->gap_error, fabsl(gap - found->distance));
  raise(&f->normal_error, found->distance - along);
  CHECK_MSG(off_a <= TOLERANCE, "points %Lg and %Lg LSB off", off_a, off_b);
  CHECK_MSG(off_b <= TOLERANCE, "points %Lg and %Lg LSB off", off_a, off_b);
  CHECK_MSG(found->distance - along <= TOLERANCE, "%ld found, %Lg along the normal", (long)found->distance, along);
  return off_a <= TOLERANCE && off_b <= TOLERANCE && found->distance - along <= TOLERANCE;
}

// Checks the yes-or-no queries around a true distance that lies between the bounds.
static bool check_decisions(const case_collider *a, const case_collider *b, const accurate_result *truth, family *f) {
  gjk_decision touch, less, more;
  const long double nearer = truth->upper - TOLERANCE - 1, farther = truth->upper + TOLERANCE + 1;
  bool right = gjk_intersect(&a->collider, &b->collider, NULL, &touch) == GJK_OK &&
               (truth->lower > TOLERANCE ? !touch.yes : true) && (truth->upper < -TOLERANCE ? touch.yes : true);
  f->iterations = touch.iterations > f->iterations ? touch.iterations : f->iterations;
  if (nearer >= 0 && farther < INT32_MAX) {
    right = right && gjk_within(&a->collider, &b->collider, (gjk_q16)nearer, NULL, &less) == GJK_OK && !less.yes &&
            gjk_within(&a->collider, &b->collider, (gjk_q16)farther, NULL, &more) == GJK_OK && more.yes;
  }
  CHECK(right);
  return right;
}

// The same question with a cache must have the same answer. With the shapes swapped it must be as near to the truth.
static bool check_again(const case_collider *a, const case_collider *b, long double truth, family *f) {
  gjk_distance_result cold, warm, swapped;
  gjk_cache cache = {{0}, 0, {0}, {0}};
  bool right = gjk_distance(&a->collider, &b->collider, &cache, &cold) == GJK_OK &&
               gjk_distance(&a->collider, &b->collider, &cache, &warm) == GJK_OK &&
               gjk_distance(&b->collider, &a->collider, NULL, &swapped) == GJK_OK;
  CHECK(right);
  if (right) {
    raise(&f->distance_error, fabsl(swapped.distance - truth));
    const bool same = warm.distance == cold.distance && warm.intersecting == cold.intersecting;
    CHECK_MSG(same, "cold %ld, cached %ld", (long)cold.distance, (long)warm.distance);
    right = fabsl(swapped.distance - truth) <= TOLERANCE + SHARPNESS;
    CHECK_MSG(right, "swapped %ld, true %Lg", (long)swapped.distance, truth);
    f->cache_differs += !same;
    right = right && same;
    f->iterations = swapped.iterations > f->iterations ? swapped.iterations : f->iterations;
    f->iterations = warm.iterations > f->iterations ? warm.iterations : f->iterations;
  }
  return right;
}

static bool check_pair(const case_pair *pair, const case_collider *a, const case_collider *b, family *f) {
  accurate_result truth;
  gjk_distance_result found;
  accurate_distance(pair, a, b, &truth);
  gjk_status status = gjk_distance(&a->collider, &b->collider, NULL, &found);
  CHECK_MSG(status == GJK_OK, "%s", gjk_status_name(status));
  if (status != GJK_OK) {
    return false;
  }
  // Cores that share a point have no distance to bound; cores nearer than the convex radii have one below 0.
  const bool sharp = truth.enclosing || truth.upper < -TOLERANCE || truth.upper - truth.lower <= SHARPNESS;
  CHECK_MSG(sharp, "oracle from %Lg to %Lg in %d", truth.lower, truth.upper, truth.iterations);
  f->pairs++;
  f->intersecting += found.intersecting;
  f->decided_otherwise += found.intersecting != (truth.upper <= 0);
  f->iterations = found.iterations > f->iterations ? found.iterations : f->iterations;
  f->oracle_iterations = truth.iterations > f->oracle_iterations ? truth.iterations : f->oracle_iterations;
  const long double upper = truth.upper > 0 ? truth.upper : 0;
  const long double error = fabsl(found.distance - upper);
  raise(&f->distance_error, error);
  bool right = error <= TOLERANCE + SHARPNESS && found.lower == found.distance && found.upper == found.distance &&
               found.certificate.proof == GJK_PROOF_NONE;
  CHECK_MSG(right, "%ld found, true %Lg", (long)found.distance, truth.upper);
  right = check_decisions(a, b, &truth, f) && right;
  right = check_again(a, b, upper, f) && right;
  return (found.intersecting || check_points(pair, a, b, &found, f)) && right && sharp;
}

static void print_family(const char *a, const char *b, const char *place, const family *f) {
  printf(
      "%-9s %-9s %-13s %5u pairs, %3u %% together, %3u decided otherwise, %3u by cache; error %5.3Lf, points %5.3Lf, "
      "gap %5.3Lf, "
      "normal %5.3Lf LSB; %3d iterations (oracle %d)\n",
      a, b, place, f->pairs, 100 * f->intersecting / (f->pairs > 0 ? f->pairs : 1), f->decided_otherwise,
      f->cache_differs, f->distance_error, f->point_error, f->gap_error, f->normal_error, f->iterations,
      f->oracle_iterations);
}

static void test_random_pairs(case_pair *pair, case_collider *a, case_collider *b) {
  random_state random = random_seed(check_seed(SEED));
  unsigned shown = 0;
  for (int a_kind = CASE_CYLINDER; a_kind <= CASE_ELLIPSOID; a_kind++) {
    for (int b_kind = CASE_POINT; b_kind <= CASE_ELLIPSOID; b_kind++) {
      for (int place = 0; place < PLACEMENTS; place++) {
        family f = {0};
        for (unsigned i = 0; i < PAIRS_PER_CELL; i++) {
          bool swapped = random_below(&random, 2) == 0;
          bool made = make_pair(&random, (case_kind)(swapped ? b_kind : a_kind), (case_kind)(swapped ? a_kind : b_kind),
                                (placement)place, pair, a, b);
          if (made && !check_pair(pair, a, b, &f) && shown++ < 10) {
            case_print(stdout, pair);
          }
        }
        print_family(kind_name[a_kind], kind_name[b_kind], placement_name[place], &f);
        CHECK(f.pairs > PAIRS_PER_CELL * 9 / 10);
      }
    }
  }
}

// At points around a surface the closed form, the oracle and the library agree.
static void test_points_about(case_kind kind, case_pair *pair, case_collider *a, case_collider *b) {
  random_state random = random_seed(check_seed(SEED) + kind);
  unsigned inside = 0, made = 0;
  long double oracle_error = 0, error = 0;
  while (made < POINTS_PER_KIND) {
    random_shape(&random, kind, random_reach(&random), &pair->a);
    case_shape_reset(&pair->b);
    const double reach = (double)pair->a.size.x + pair->a.size.y + pair->a.size.z + pair->a.convex_radius;
    pair->b.pose.position = random_vector(&random, 0.7 * reach * random_unit(&random) + 1);
    gjk_distance_result found;
    accurate_result solved;
    bool fine = case_pair_build(pair, false, a, b) && gjk_distance(&a->collider, &b->collider, NULL, &found) == GJK_OK;
    CHECK(fine);
    accurate_distance(pair, a, b, &solved);
    long double truth = accurate_point_distance(&pair->a, pair->b.pose.position);
    fine = fine && (truth > 0 ? fabsl(solved.upper - truth) <= SHARPNESS && fabsl(found.distance - truth) <= TOLERANCE
                              : solved.upper <= SHARPNESS && (truth >= -TOLERANCE || found.intersecting));
    CHECK_MSG(fine, "closed form %Lg, oracle %Lg, library %ld", truth, solved.upper, (long)found.distance);
    if (!fine) {
      case_print(stdout, pair);
      return;
    }
    raise(&oracle_error, truth > 0 ? fabsl(solved.upper - truth) : 0);
    raise(&error, truth > 0 ? fabsl(found.distance - truth) : 0);
    inside += truth <= 0;
    made++;
  }
  printf("%-9s and points: %u, %u inside; oracle %.6Lf, library %.3Lf LSB off the closed form\n", kind_name[kind], made,
         inside, oracle_error, error);
  CHECK(inside > made / 20);
  CHECK(inside < made * 9 / 10);
}

// Ellipsoids of three equal radii are spheres: their distance is that of the centres less the radii.
static void test_spheres(case_pair *pair, case_collider *a, case_collider *b) {
  random_state random = random_seed(check_seed(SEED));
  for (int i = 0; i < 20000; i++) {
    const gjk_q16 reach = random_reach(&random);
    random_shape(&random, CASE_ELLIPSOID, reach, &pair->a);
    random_shape(&random, CASE_POINT, random_reach(&random), &pair->b);
    pair->a.size.y = pair->a.size.z = pair->a.size.x;
    const double radii = (double)pair->a.size.x + pair->a.convex_radius + pair->b.convex_radius;
    const gjk_vec3 p = pair->b.pose.position = random_vector(&random, radii * (0.9 + 0.2 * random_unit(&random)) + 3);
    gjk_distance_result found;
    bool fine = case_pair_build(pair, false, a, b) && gjk_distance(&a->collider, &b->collider, NULL, &found) == GJK_OK;
    CHECK(fine);
    const long double gap = sqrtl((long double)p.x * p.x + (long double)p.y * p.y + (long double)p.z * p.z) - radii;
    fine = fine && fabsl(found.distance - (gap > 0 ? gap : 0)) <= TOLERANCE &&
           (found.intersecting ? gap <= TOLERANCE : gap >= -TOLERANCE);
    CHECK_MSG(fine, "true %Lg, found %ld", gap, (long)found.distance);
    if (!fine) {
      case_print(stdout, pair);
      return;
    }
  }
}

int main(void) {
  case_pair pair = {0};
  case_collider a = {0}, b = {0};
  for (int kind = CASE_CYLINDER; kind <= CASE_ELLIPSOID; kind++) {
    test_points_about((case_kind)kind, &pair, &a, &b);
  }
  test_spheres(&pair, &a, &b);
  test_random_pairs(&pair, &a, &b);
  case_collider_free(&a);
  case_collider_free(&b);
  case_pair_free(&pair);
  return check_done("curved");
}
