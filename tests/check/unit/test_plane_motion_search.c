// Times of impact in the plane, of long thin bodies that graze, turn several times or move fast, against a search of the
// whole way with proven bounds: between two fractions a gap can change by no more than the bodies' farthest points move.
//
//   test_plane_motion_search [SEED [TRIALS]]
#include "exact/clearance.h"
#include "plane.h"

#define SEED 6220

// After the headers.
#define gjk_distance_result gjk2_distance_result
#define gjk_impact_result gjk2_impact_result

typedef struct trial {
  plane_body pair[2];
  gjk2_motion motion[2];
  gjk2_impact_setup setup;
  unsigned family;
} trial;

#include "impact_searches.h"

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

static gjk_status ask(const trial *t, uint8_t iterations, gjk2_impact_result *out) {
  gjk2_impact_setup setup = t->setup;
  setup.iterations = iterations;
  return gjk2_time_of_impact(&t->pair[0].collider, &t->motion[0], &t->pair[1].collider, &t->motion[1], &setup, out);
}

static void set_clearance(const trial *t, clearance *c) {
  c->speed = clearance2_speed(&t->motion[0], clearance2_reach(&t->pair[0].collider), &t->motion[1],
                              clearance2_reach(&t->pair[1].collider));
  c->least = t->setup.margin == 0 ? 1 : t->setup.margin - rounding_of(t);
  c->between = t->setup.margin - 2 * rounding_of(t);
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

static void make_motions(random_state *random, trial *t, gjk_q16 half) {
  const gjk2_vec away = plane_random_vec(random, half + half / 2), aim = plane_random_vec(random, half);
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

static bool make(random_state *random, trial *t) {
  const gjk_q16 half = 1 << (9 + random_below(random, 15));
  t->family = random_below(random, FAMILIES);
  make_thin(random, half, &t->pair[0]);
  make_thin(random, random_below(random, 3) == 0 ? half / 64 + 1 : half, &t->pair[1]);
  make_motions(random, t, half);
  plane_place(&t->pair[0], false);
  plane_place(&t->pair[1], false);
  t->setup.iterations = 0;
  t->setup.tolerance = (gjk_q16)(GJK2_IMPACT_TOLERANCE_MIN + ldexp(rounding_of(t), -1));
  choose_margin(random, t, INT32_MAX);
  return true;
}

static void check_cast(const trial *t, const gjk2_impact_result *r, gjk_status status) {
  const gjk2_cast_path path = {&t->motion[0].to.position, &t->motion[1].to.position, t->setup.margin};
  gjk2_cast_result cast;
  CHECK(gjk2_cast(&t->pair[0].collider, &t->pair[1].collider, &path, &cast) == GJK_OK);
  CHECK(!cast.hit || status != GJK_OK || r->hit);
  tally.casts += cast.hit;
}

int main(int argc, char **argv) {
  static trial t;
  check_trials_of(&t, argc, argv, SEED);
  return check_done("plane_motion_search");
}
