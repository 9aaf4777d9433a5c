// Times of impact of random shapes of every kind, moving and turning, against distances at many fractions.
#include <string.h>

#include "check.h"
#include "gjk/distance.h"
#include "gjk/impact.h"
#include "gjk/intersect.h"
#include "reference/random_shape.h"

#define SEED 4711
#define PAIRS 4000
#define SAMPLES 100

// Two shapes, how they move, and what is asked.
typedef struct trial {
  case_pair pair;
  gjk_motion a, b;
  gjk_impact_setup setup;
} trial;

static void show_motion(const char *name, const gjk_motion *m) {
  printf("%s to %d %d %d turn-to %d %d %d %d spin %d %d %d\n", name, (int)m->to.position.x, (int)m->to.position.y,
         (int)m->to.position.z, (int)m->to.rotation.x, (int)m->to.rotation.y, (int)m->to.rotation.z,
         (int)m->to.rotation.w, (int)m->spin.x, (int)m->spin.y, (int)m->spin.z);
}

static void show(const void *subject) {
  const trial *t = (const trial *)subject;
  case_show(&t->pair);
  show_motion("A", &t->a);
  show_motion("B", &t->b);
  printf("margin %d tolerance %d\n", (int)t->setup.margin, (int)t->setup.tolerance);
}

static gjk_vec3 sum(gjk_vec3 a, gjk_vec3 b) {
  return (gjk_vec3){a.x + b.x, a.y + b.y, a.z + b.z};
}

static gjk_vec3 difference(gjk_vec3 a, gjk_vec3 b) {
  return (gjk_vec3){a.x - b.x, a.y - b.y, a.z - b.z};
}

// Turns not at all, to another rotation, or by a spin of up to three turns; some by hundreds.
static void turn(random_state *random, gjk_motion *m) {
  const uint32_t way = random_below(random, 4);
  if (way == 1) {
    m->to.rotation = random_rotation(random);
  } else if (way > 1) {
    m->spin = random_vector(random, 65536 * 20 * random_unit(random) * (random_below(random, 40) == 0 ? 100 : 1));
  }
}

static double reach_of(const gjk_collider *c) {
  const double x = c->local_centre.x, y = c->local_centre.y, z = c->local_centre.z;
  return (x < 0 ? -x : x) + (y < 0 ? -y : y) + (z < 0 ? -z : z) + c->radius;
}

// Colliders of a trial, lazy and baked, which keep their memory from one to the next.
static struct { case_collider a, b, baked_a, baked_b; } colliders;

// B starts up to 1.8 radii away from A; it stays or moves to within 1.2 radii.
static bool make(random_state *random, trial *t) {
  const gjk_q16 reach = random_below(random, 2) == 0 ? GJK_Q16_ONE : random_reach(random) / 2 + 2;
  const gjk_collider *a = &colliders.a.collider, *b = &colliders.b.collider;
  const gjk_vec3 none = {0, 0, 0};
  random_shape(random, (case_kind)random_below(random, CASE_ELLIPSOID + 1), reach, &t->pair.a);
  random_shape(random, (case_kind)random_below(random, CASE_ELLIPSOID + 1), reach, &t->pair.b);
  if (!case_pair_build(&t->pair, true, &colliders.a, &colliders.b)) {
    return false;
  }
  const double radii = (double)a->radius + b->radius;
  const gjk_vec3 away = random_vector(random, radii * (0.6 + 1.2 * random_unit(random)));
  const gjk_vec3 there = random_vector(random, radii * 1.2 * random_unit(random));
  t->a.from = t->a.to = t->pair.a.pose;
  gjk_pose *at = &t->pair.b.pose;
  at->position = sum(difference(sum(at->position, a->centre), b->centre), away);
  t->b.from = t->b.to = *at;
  if (random_below(random, 4) != 0) {
    t->b.to.position = sum(difference(t->b.to.position, away), there);
  }
  t->a.spin = t->b.spin = none;
  turn(random, &t->a);
  turn(random, &t->b);
  t->setup.margin = random_below(random, 3) == 0 ? (gjk_q16)random_below(random, 1000) : 0;
  t->setup.tolerance = (gjk_q16)(16 + (reach_of(a) + reach_of(b)) / (1 << 23));
  t->setup.iterations = 0;
  return case_pair_build(&t->pair, false, &colliders.baked_a, &colliders.baked_b);
}

static gjk_distance_result gap_at(trial *t, gjk_collider *a, gjk_collider *b, gjk_q30 fraction) {
  gjk_pose pose;
  gjk_distance_result gap = {0};
  CHECK(gjk_motion_pose(&t->a, fraction, &pose) == GJK_OK && gjk_collider_pose(a, &pose) == GJK_OK);
  CHECK(gjk_motion_pose(&t->b, fraction, &pose) == GJK_OK && gjk_collider_pose(b, &pose) == GJK_OK);
  (void)gjk_distance(a, b, NULL, &gap);
  return gap;
}

// No pose before lower is within the margin: evenly spread ones, and those closely before it.
static void check_before(random_state *random, trial *t, gjk_collider *a, gjk_collider *b, gjk_q30 lower) {
  for (int i = 0; i < SAMPLES; i++) {
    const gjk_q30 fraction = i % 2 == 0 ? (gjk_q30)((int64_t)lower * i / SAMPLES)
                                        : lower - 1 - (gjk_q30)(random_u32(random) >> (3 + random_below(random, 29)));
    if (fraction >= 0 && fraction < lower) {
      const gjk_distance_result gap = gap_at(t, a, b, fraction);
      CHECK_MSG(gap.distance > t->setup.margin, "gap %d at %d before %d", (int)gap.distance, (int)fraction, (int)lower);
    }
  }
}

static bool same_pose(const gjk_pose *a, const gjk_pose *b) {
  return memcmp(a, b, sizeof *a) == 0;
}

// A result against what its fields mean. Returns whether it is a hit.
static bool check_result(random_state *random, trial *t, gjk_collider *a, gjk_collider *b, const gjk_impact_result *r) {
  gjk_pose pose;
  CHECK(r->lower >= 0 && r->lower <= r->upper && r->upper <= GJK_Q30_ONE);
  CHECK(gjk_motion_pose(&t->a, r->lower, &pose) == GJK_OK && same_pose(&pose, &r->pose_a));
  CHECK(gjk_motion_pose(&t->b, r->lower, &pose) == GJK_OK && same_pose(&pose, &r->pose_b));
  check_before(random, t, a, b, r->lower);
  const gjk_distance_result at_lower = gap_at(t, a, b, r->lower);
  CHECK(r->overlap ? r->hit && r->lower == 0 && r->upper == 0 && at_lower.distance <= t->setup.margin
                   : at_lower.distance > t->setup.margin);
  if (!r->hit) {
    CHECK(r->upper == GJK_Q30_ONE && !r->overlap);
    return false;
  }
  const gjk_distance_result gap = gap_at(t, a, b, r->upper);
  const gjk_q16 wanted = t->setup.margin + t->setup.tolerance;
  gjk_decision near;
  CHECK(gap.distance == r->distance && gap.distance <= wanted);
  // Two questions about a curved shape may differ by its error.
  CHECK(gjk_within(a, b, wanted, NULL, &near) == GJK_OK &&
        (near.yes || t->pair.a.kind > CASE_HULL || t->pair.b.kind > CASE_HULL));
  CHECK(gap.intersecting || (memcmp(&gap.point_a, &r->point_a, sizeof gap.point_a) == 0 &&
                             memcmp(&gap.point_b, &r->point_b, sizeof gap.point_b) == 0 &&
                             memcmp(&gap.normal, &r->normal, sizeof gap.normal) == 0));
  return true;
}

static bool same_result(const gjk_impact_result *a, const gjk_impact_result *b) {
  return a->hit == b->hit && a->overlap == b->overlap && a->lower == b->lower && a->upper == b->upper &&
         a->iterations == b->iterations && same_pose(&a->pose_a, &b->pose_a) && same_pose(&a->pose_b, &b->pose_b) &&
         (!a->hit || a->distance == b->distance);
}

// A baked hull, colliders that are not posed, and a ceiling: the same bits, or a lower bound that the ceiling allows.
static void check_variants(trial *t, const gjk_impact_result *full) {
  const gjk_collider *a = &colliders.baked_a.collider, *b = &colliders.baked_b.collider, before = *a;
  gjk_impact_result r;
  const gjk_status status = gjk_time_of_impact(a, &t->a, b, &t->b, &t->setup, &r);
  CHECK(memcmp(&before, a, sizeof before) == 0);
  CHECK(same_result(full, &r));
  static const uint8_t ceilings[] = {1, 2, 3, 10};
  gjk_q30 lower = 0;
  for (unsigned i = 0; i < sizeof ceilings; i++) {
    gjk_impact_setup setup = t->setup;
    setup.iterations = ceilings[i];
    const gjk_status limited = gjk_time_of_impact(a, &t->a, b, &t->b, &setup, &r);
    if (full->iterations <= ceilings[i]) {
      CHECK(limited == status && same_result(full, &r));
    } else {
      CHECK(limited == GJK_ERROR_ITERATION_LIMIT && r.iterations == ceilings[i] && !r.hit && !r.overlap);
      CHECK(r.upper == GJK_Q30_ONE && r.lower >= lower && r.lower <= full->lower);
    }
    lower = r.lower;
  }
}

int main(void) {
  random_state random = random_seed(check_seed(SEED));
  const unsigned long pairs = check_trials(PAIRS);
  unsigned long made = 0, hits = 0, misses = 0, overlaps = 0, limits = 0, iterations = 0;
  gjk_collider *a = &colliders.a.collider, *b = &colliders.b.collider;
  static trial t;
  for (unsigned long i = 0; i < pairs; i++) {
    check_trial(i, show, &t);
    if (!make(&random, &t)) {
      continue;
    }
    gjk_impact_result r;
    const gjk_status status = gjk_time_of_impact(a, &t.a, b, &t.b, &t.setup, &r);
    CHECK(status == GJK_OK || status == GJK_ERROR_ITERATION_LIMIT);
    made++;
    iterations += r.iterations;
    const bool hit = check_result(&random, &t, a, b, &r);
    overlaps += r.overlap;
    hits += hit && !r.overlap;
    misses += !hit && status == GJK_OK;
    limits += status != GJK_OK;
    check_variants(&t, &r);
  }
  check_trial(pairs, NULL, NULL);
  printf("%lu of %lu: %lu hits, %lu misses, %lu overlaps, %lu at the limit, %.2f iterations\n", made, pairs, hits,
         misses, overlaps, limits, (double)iterations / (double)made);
  CHECK(pairs < 500 || (made > pairs * 9 / 10 && hits > made / 4 && misses > made / 5 && overlaps > made / 50));
  CHECK(limits * 200 <= made);
  case_pair_release(&t.pair, &colliders.baked_a, &colliders.baked_b);
  return check_done("impact");
}
