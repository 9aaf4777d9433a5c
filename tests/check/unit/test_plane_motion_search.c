// Times of impact in the plane, of long thin bodies that graze, turn several times or move fast, against a search of the
// whole way with proven bounds: between two fractions a gap can change by no more than the bodies' farthest points move.
//
//   test_plane_motion_search [SEED [TRIALS]]
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

// Of the farthest point, from the pose's position, LSB.
static double reach_of(const gjk2_collider *c) {
  return hypot(c->local_centre.x, c->local_centre.y) + c->radius + 2;
}

// The angle over the whole way, radians, rounded up.
static double angle_of(const gjk2_motion *m) {
  if (m->spin != 0) {
    return fabs((double)m->spin) / 65536 * (1 + 1e-9);
  }
  const gjk2_rotation *p = &m->from.rotation, *q = &m->to.rotation;
  const double sine = (double)p->c * q->s - (double)p->s * q->c, cosine = (double)p->c * q->c + (double)p->s * q->s;
  return fabs(atan2(sine, cosine)) + 1e-6;
}

// How far the gap can change on the whole way, LSB.
static double speed_of(const trial *t) {
  const gjk2_vec *p = &t->motion[0].from.position, *q = &t->motion[0].to.position, *u = &t->motion[1].from.position,
                 *v = &t->motion[1].to.position;
  return hypot(((double)v->x - u->x) - ((double)q->x - p->x), ((double)v->y - u->y) - ((double)q->y - p->y)) +
         angle_of(&t->motion[0]) * reach_of(&t->pair[0].collider) +
         angle_of(&t->motion[1]) * reach_of(&t->pair[1].collider);
}

// What posing may have added to a gap, LSB: gjk2/impact.h says 8 of shapes within 4096 units.
static double rounding_of(const trial *t) {
  return 8 + ldexp(reach_of(&t->pair[0].collider) + reach_of(&t->pair[1].collider), -25);
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

typedef enum outcome { CLEAR, OPEN, TOUCHED } outcome;

typedef struct interval {
  gjk_q30 from, to;
  int64_t gap_from, gap_to;
} interval;

// Is the gap above margin at all fractions from 0 to limit, but for what posing rounds? OPEN: too many distances.
static outcome search(const trial *t, gjk_q30 limit, gjk_q16 margin, unsigned long *measured) {
  interval stack[40];
  const double speed = speed_of(t) / ONE, rounding = rounding_of(t);
  unsigned used = 2;
  int depth = 1;
  const interval whole = {0, limit, gap_at(t, 0).distance, gap_at(t, limit).distance};
  if (limit == 0) {
    return CLEAR;
  }
  if ((double)whole.gap_from < margin - rounding || (margin == 0 && whole.gap_from == 0)) {
    return TOUCHED;
  }
  stack[0] = whole;
  while (depth > 0) {
    const interval now = stack[--depth];
    const double least = ((double)(now.gap_from + now.gap_to) - speed * ((double)now.to - now.from)) / 2;
    if (least > margin - 2 * rounding || now.to - now.from <= 1) {
      continue;
    }
    if (++used > MEASUREMENTS) {
      *measured += used;
      return OPEN;
    }
    const gjk_q30 middle = now.from + (now.to - now.from) / 2;
    const int64_t gap = gap_at(t, middle).distance;
    if ((double)gap < margin - rounding) {
      return TOUCHED;
    }
    const interval left = {now.from, middle, now.gap_from, gap}, right = {middle, now.to, gap, now.gap_to};
    stack[depth++] = right;  // at most 30 deep
    stack[depth++] = left;
  }
  *measured += used;
  return CLEAR;
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

static struct {
  unsigned long made[FAMILIES], hits[FAMILIES], misses[FAMILIES], limits[FAMILIES];
  unsigned long overlaps, proven, open, measured, cut, useful, casts;
} tally;

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

static void check(const trial *t) {
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
  const outcome found = search(t, r.lower, t->setup.margin, &tally.measured);
  CHECK_MSG(found != TOUCHED, "contact before %ld", (long)r.lower);
  tally.proven += found == CLEAR;
  tally.open += found == OPEN;
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
