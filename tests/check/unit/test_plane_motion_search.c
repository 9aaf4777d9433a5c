// Times of impact in the plane, of long thin bodies that graze, turn several times or move fast, against a search of the
// whole way with proven bounds: between two fractions a gap can change by no more than the bodies' farthest points move.
//
//   test_plane_motion_search [SEED [TRIALS]]
#include "exact/clearance.h"
#include "plane.h"

#define SEED 6220
#define TRIALS 1500

// The most distances of one search.
#define MEASUREMENTS 20000

#define ONE GJK_Q30_ONE

enum { NEEDLES, GRAZING, TURNING, FAST, STRAIGHT, FAMILIES };

typedef struct trial {
  plane_body pair[2];
  gjk2_motion motion[2];
  gjk2_impact_setup setup;
  unsigned family;
} trial;

static void show(const void *subject) {
  const trial *t = (const trial *)subject;
  plane_print(t->pair);
  for (int i = 0; i < 2; i++) {
    const gjk2_motion *m = &t->motion[i];
    printf("  (%d, %d) %d %d to (%d, %d) %d %d spin %d\n", (int)m->from.position.x, (int)m->from.position.y,
           (int)m->from.rotation.c, (int)m->from.rotation.s, (int)m->to.position.x, (int)m->to.position.y,
           (int)m->to.rotation.c, (int)m->to.rotation.s, (int)m->spin);
  }
  printf("  family %u margin %d tolerance %d\n", t->family, (int)t->setup.margin, (int)t->setup.tolerance);
}

// What posing may have added to a gap, LSB: gjk2/impact.h says 8 of shapes within 4096 units.
static double rounding_of(const trial *t) {
  return 8 + ldexp(clearance2_reach(&t->pair[0].collider) + clearance2_reach(&t->pair[1].collider), -25);
}

static gjk2_distance_result gap_at(const trial *t, gjk_q30 fraction) {
  gjk2_collider c[2];
  gjk2_distance_result gap = {0};
  for (int i = 0; i < 2; i++) {
    gjk2_pose pose;
    c[i] = t->pair[i].collider;
    c[i].buffer = NULL;
    CHECK(gjk2_motion_pose(&t->motion[i], fraction, &pose) == GJK_OK && gjk2_collider_pose(&c[i], &pose) == GJK_OK);
  }
  CHECK(gjk2_distance(&c[0], &c[1], NULL, &gap) == GJK_OK);
  return gap;
}

static struct {
  unsigned long made[FAMILIES], hits[FAMILIES], misses[FAMILIES], limits[FAMILIES];
  unsigned long overlaps, proven, open, measured, cut, useful, casts;
} tally;

static bool measure(void *user, gjk_q30 fraction, int64_t *out) {
  *out = gap_at((const trial *)user, fraction).distance;
  return true;
}

// Is the gap above the margin at all fractions before limit, but for what posing rounds?
static clearance_outcome search(trial *t, gjk_q30 limit) {
  clearance c = {.gap = measure, .user = t, .most = MEASUREMENTS};
  c.speed = clearance2_speed(&t->motion[0], clearance2_reach(&t->pair[0].collider), &t->motion[1],
                             clearance2_reach(&t->pair[1].collider));
  c.least = t->setup.margin == 0 ? 1 : t->setup.margin - rounding_of(t);
  c.between = t->setup.margin - 2 * rounding_of(t);
  const clearance_outcome outcome = clearance_search(&c, limit);
  tally.measured += c.measured;
  return outcome;
}

// A long thin body, up to 100,000 times as long as thick, with its middle or an end at the pose's position.
static void make_thin(random_state *random, gjk_q16 half, plane_body *out) {
  const gjk_q16 thick = random_range(random, 1, 1 + (half >> (2 + random_below(random, 15))));
  const gjk2_shape rod = GJK2_ROUNDED_SEGMENT(half, random_below(random, 2) == 0 ? 0 : thick),
                   bar = GJK2_BOX(half, thick);
  const gjk2_shape blade = GJK2_POLYGON(out->vertices, 5);
  const gjk2_vec corners[5] = {{0, -thick}, {2 * half, -thick / 2}, {2 * half, 0}, {half, thick}, {0, thick / 3}};
  for (int i = 0; i < 5; i++) {
    out->vertices[i] = corners[i];
  }
  switch (random_below(random, 3)) {
    case 0: out->shape = rod; break;
    case 1: out->shape = bar; break;
    default: out->shape = blade;
  }
  out->pose.rotation = plane_random_rotation(random);
  out->pose.position.x = out->pose.position.y = 0;
}

static gjk2_vec spread(random_state *random, int32_t most) {
  const gjk2_vec v = {random_range(random, -most, most), random_range(random, -most, most)};
  return v;
}

static void make_motions(random_state *random, trial *t, gjk_q16 half) {
  const gjk2_vec away = spread(random, half + half / 2), aim = spread(random, half);
  const int32_t times = t->family == FAST ? 1 + (int32_t)random_below(random, 20) : 1;
  t->pair[1].pose.position = away;
  for (int i = 0; i < 2; i++) {
    gjk2_motion *m = &t->motion[i];
    const uint32_t how = random_below(random, 4);
    m->from = m->to = t->pair[i].pose;
    m->spin = 0;
    if (t->family == STRAIGHT) {
      continue;
    }
    if (how == 0) {
      m->to.rotation = plane_random_rotation(random);
    } else if (how < 3 || t->family == TURNING) {
      m->spin = random_range(random, -65536, 65536) * (how == 1 ? 3 : 40);
    }
  }
  if (t->family != TURNING) {
    t->motion[1].to.position.x = aim.x - times * away.x;
    t->motion[1].to.position.y = aim.y - times * away.y;
  }
}

// Of a grazing pair the margin is about the least gap on the way.
static void choose_margin(random_state *random, trial *t) {
  t->setup.iterations = 0;
  t->setup.tolerance = (gjk_q16)(GJK2_IMPACT_TOLERANCE_MIN + ldexp(rounding_of(t), -1));
  t->setup.margin = random_below(random, 2) == 0 ? 0 : random_range(random, 0, 2000);
  if (t->family == GRAZING) {
    int64_t least = INT32_MAX;
    for (int i = 0; i <= 400; i++) {
      const int64_t gap = gap_at(t, (gjk_q30)((int64_t)ONE * i / 400)).distance;
      least = gap < least ? gap : least;
    }
    least += random_range(random, -40, 10);
    t->setup.margin = least < 0 ? 0 : (gjk_q16)least;
  }
}

static void make(random_state *random, trial *t) {
  const gjk_q16 half = 1 << (9 + random_below(random, 15));
  t->family = random_below(random, FAMILIES);
  make_thin(random, half, &t->pair[0]);
  make_thin(random, random_below(random, 3) == 0 ? half / 64 + 1 : half, &t->pair[1]);
  make_motions(random, t, half);
  plane_place(&t->pair[0], false);
  plane_place(&t->pair[1], false);
  choose_margin(random, t);
}

static gjk_status ask(const trial *t, uint8_t iterations, gjk2_impact_result *out) {
  gjk2_impact_setup setup = t->setup;
  setup.iterations = iterations;
  return gjk2_time_of_impact(&t->pair[0].collider, &t->motion[0], &t->pair[1].collider, &t->motion[1], &setup, out);
}

// Without turns a cast knows whether they touch.
static void check_cast(const trial *t, const gjk2_impact_result *r, gjk_status status) {
  const gjk2_cast_path path = {&t->motion[0].to.position, &t->motion[1].to.position, t->setup.margin};
  gjk2_cast_result cast;
  CHECK(gjk2_cast(&t->pair[0].collider, &t->pair[1].collider, &path, &cast) == GJK_OK);
  CHECK(!cast.hit || status != GJK_OK || r->hit);
  tally.casts += cast.hit;
}

static void check_ceilings(const trial *t, const gjk2_impact_result *full, gjk_status status) {
  static const uint8_t ceilings[] = {1, 2, 3, 10};
  gjk_q30 lower = 0;
  for (unsigned i = 0; i < sizeof ceilings; i++) {
    gjk2_impact_result r;
    const gjk_status limited = ask(t, ceilings[i], &r);
    if (full->iterations <= ceilings[i]) {
      CHECK(limited == status && r.hit == full->hit && r.lower == full->lower && r.upper == full->upper);
    } else {
      CHECK(limited == GJK_ERROR_ITERATION_LIMIT && !r.hit && !r.overlap && r.upper == ONE);
      CHECK(r.lower >= lower && r.lower <= full->lower);
      tally.cut++;
      tally.useful += r.lower > 0;
    }
    lower = r.lower;
  }
}

static void check(trial *t) {
  gjk2_impact_result r;
  const gjk_status status = ask(t, 0, &r);
  CHECK(status == GJK_OK || status == GJK_ERROR_ITERATION_LIMIT);
  tally.made[t->family]++;
  if (r.overlap) {
    const gjk2_distance_result gap = gap_at(t, 0);
    tally.overlaps++;
    CHECK(r.hit && r.lower == 0 && r.upper == 0 && (gap.intersecting || gap.distance <= t->setup.margin));
    return;
  }
  tally.hits[t->family] += r.hit;
  tally.misses[t->family] += status == GJK_OK && !r.hit;
  tally.limits[t->family] += status != GJK_OK;
  CHECK(r.hit || r.upper == ONE);
  CHECK(status != GJK_OK || r.hit || r.lower == ONE);
  if (r.hit) {
    const gjk2_distance_result gap = gap_at(t, r.upper);
    CHECK_MSG(gap.intersecting || gap.distance <= (int64_t)t->setup.margin + t->setup.tolerance, "gap %ld at upper",
              (long)gap.distance);
  }
  const clearance_outcome found = search(t, r.lower);
  CHECK_MSG(found != CLEARANCE_TOUCHED, "contact before %ld", (long)r.lower);
  tally.proven += found == CLEARANCE_PROVEN;
  tally.open += found == CLEARANCE_OPEN;
  check_ceilings(t, &r, status);
  if (t->family == STRAIGHT) {
    check_cast(t, &r, status);
  }
}

int main(int argc, char **argv) {
  random_state random = random_seed(argc > 1 ? check_seeded(strtoull(argv[1], NULL, 10)) : check_seed(SEED));
  const unsigned long trials = argc > 2 ? strtoul(argv[2], NULL, 10) : check_trials(TRIALS);
  static const char *const names[FAMILIES] = {"needles", "grazing", "turning", "fast", "straight"};
  static trial t;
  for (unsigned long i = 0; i < trials; i++) {
    check_trial(i, show, &t);
    make(&random, &t);
    check(&t);
  }
  check_trial(trials, NULL, NULL);
  for (unsigned i = 0; i < FAMILIES; i++) {
    printf("%-9s %lu: %lu hits, %lu misses, %lu at the ceiling\n", names[i], tally.made[i], tally.hits[i],
           tally.misses[i], tally.limits[i]);
    CHECK(trials < 500 || (tally.made[i] > trials / 10 && tally.hits[i] > 10 && tally.misses[i] > 10));
  }
  printf("%lu overlaps, %lu proven clear, %lu not, %lu distances; %lu cut short, %lu of them above 0\n", tally.overlaps,
         tally.proven, tally.open, tally.measured, tally.cut, tally.useful);
  CHECK(tally.proven > tally.open * 10);
  CHECK(tally.useful > tally.cut / 2 && (trials < 500 || tally.casts > trials / 100));
  return check_done("plane_motion_search");
}
