// Times of impact of long thin bodies that graze, turn several times or move fast, against a search of the whole way with
// proven bounds: between two fractions a gap can change by no more than the bodies' farthest points move.
//
//   test_impact_search [SEED [TRIALS]]
#include <math.h>

#include "check.h"
#include "exact/clearance.h"
#include "gjk/cast.h"
#include "gjk/distance.h"
#include "gjk/impact.h"
#include "reference/random_shape.h"

#define SEED 6120

typedef struct trial {
  case_pair pair;
  gjk_motion motion[2];
  gjk_impact_setup setup;
  unsigned family;
} trial;

#include "impact_searches.h"

static case_collider of_a, of_b;

static void show(const void *subject) {
  const trial *t = (const trial *)subject;
  case_show(&t->pair);
  for (int i = 0; i < 2; i++) {
    const gjk_motion *m = &t->motion[i];
    printf("%c to %d %d %d turn-to %d %d %d %d spin %d %d %d\n", 'A' + i, (int)m->to.position.x, (int)m->to.position.y,
           (int)m->to.position.z, (int)m->to.rotation.x, (int)m->to.rotation.y, (int)m->to.rotation.z,
           (int)m->to.rotation.w, (int)m->spin.x, (int)m->spin.y, (int)m->spin.z);
  }
  printf("family %u margin %d tolerance %d\n", t->family, (int)t->setup.margin, (int)t->setup.tolerance);
}

// What posing may have added to a gap, LSB.
static double rounding_of(void) {
  return 5 + ldexp(clearance_reach(&of_a.collider) + clearance_reach(&of_b.collider), -24);
}

static gjk_distance_result gap_at(const trial *t, gjk_q30 fraction) {
  gjk_collider *c[2] = {&of_a.collider, &of_b.collider};
  gjk_distance_result gap = {0};
  for (int i = 0; i < 2; i++) {
    gjk_pose pose;
    CHECK(gjk_motion_pose(&t->motion[i], fraction, &pose) == GJK_OK && gjk_collider_pose(c[i], &pose) == GJK_OK);
  }
  CHECK(gjk_distance(c[0], c[1], NULL, &gap) == GJK_OK);
  return gap;
}

static gjk_status ask(const trial *t, uint8_t iterations, gjk_impact_result *out) {
  gjk_impact_setup setup = t->setup;
  setup.iterations = iterations;
  return gjk_time_of_impact(&of_a.collider, &t->motion[0], &of_b.collider, &t->motion[1], &setup, out);
}

// Measured gaps are exact, others but for what posing rounds.
static void set_clearance(const trial *t, clearance *c) {
  c->speed =
      clearance_speed(&t->motion[0], clearance_reach(&of_a.collider), &t->motion[1], clearance_reach(&of_b.collider));
  c->least = (double)t->setup.margin + 1;
  c->between = t->setup.margin - rounding_of();
}

static gjk_vec3 scaled(gjk_vec3 v, int32_t times) {
  return (gjk_vec3){v.x * times, v.y * times, v.z * times};
}

static gjk_vec3 sum(gjk_vec3 a, gjk_vec3 b) {
  return (gjk_vec3){a.x + b.x, a.y + b.y, a.z + b.z};
}

// A long thin body: a segment, a box or a hull, up to 100,000 times as long as thick, with its middle or an end at the
// pose's position.
static void make_thin(random_state *random, gjk_q16 half, case_shape *out) {
  const gjk_q16 thick = random_range(random, 1, 1 + (half >> (2 + random_below(random, 15))));
  case_shape_reset(out);
  switch (random_below(random, 3)) {
    case 0:
      out->kind = CASE_SEGMENT;
      out->size.z = half;
      out->convex_radius = random_below(random, 2) == 0 ? 0 : thick;
      break;
    case 1:
      out->kind = CASE_BOX;
      out->size.x = half;
      out->size.y = thick;
      out->size.z = random_below(random, 2) == 0 ? thick : half / 2;
      break;
    default:
      out->kind = CASE_HULL;
      case_shape_set_count(out, 6);
      for (int i = 0; i < 6; i++) {
        out->vertices[i] =
            (gjk_vec3){i < 3 ? 0 : 2 * half, random_range(random, -thick, thick), random_range(random, -thick, thick)};
      }
  }
  out->pose.rotation = random_rotation(random);
}

static void make_motions(random_state *random, trial *t, gjk_q16 half) {
  const gjk_vec3 none = {0, 0, 0};
  const bool fast = t->family == FAST;
  for (int i = 0; i < 2; i++) {
    gjk_motion *m = &t->motion[i];
    const case_shape *s = i == 0 ? &t->pair.a : &t->pair.b;
    m->from = m->to = s->pose;
    m->spin = none;
    if (t->family == STRAIGHT) {
      continue;
    }
    const uint32_t how = random_below(random, 4);
    if (how == 0) {
      m->to.rotation = random_rotation(random);
    } else if (how < 3 || t->family == TURNING) {
      m->spin = random_vector(random, 65536 * (how == 1 ? 3.0 : 40.0) * random_unit(random));
    }
  }
  gjk_pose *from = &t->motion[1].from, *to = &t->motion[1].to;
  const gjk_vec3 away = random_vector(random, half * (0.3 + 2.5 * random_unit(random)));
  from->position = to->position = away;
  if (t->family != TURNING) {
    const gjk_vec3 aim = random_vector(random, half * random_unit(random));
    const gjk_vec3 there = sum(aim, scaled(away, -1));
    to->position = fast ? sum(aim, scaled(away, -(1 + (int32_t)random_below(random, 20)))) : there;
  }
  t->pair.b.pose.position = from->position;
}

static bool make(random_state *random, trial *t) {
  const gjk_q16 half = 1 << (9 + random_below(random, 15));
  const gjk_q16 other = random_below(random, 3) == 0 ? half / 64 + 1 : half;
  t->family = random_below(random, FAMILIES);
  make_thin(random, half, &t->pair.a);
  make_thin(random, other, &t->pair.b);
  make_motions(random, t, half);
  if (!case_pair_build(&t->pair, true, &of_a, &of_b)) {
    return false;
  }
  t->setup.iterations = 0;
  t->setup.tolerance = (gjk_q16)(GJK_IMPACT_TOLERANCE_MIN +
                                 ldexp(clearance_reach(&of_a.collider) + clearance_reach(&of_b.collider), -23));
  choose_margin(random, t, GJK_IMPACT_MARGIN_MAX);
  return true;
}

static void check_cast(const trial *t, const gjk_impact_result *r, gjk_status status) {
  const gjk_cast_path path = {&t->motion[0].to.position, &t->motion[1].to.position, t->setup.margin};
  gjk_cast_result cast;
  (void)gap_at(t, 0);
  CHECK(gjk_cast(&of_a.collider, &of_b.collider, &path, &cast) == GJK_OK);
  CHECK(!cast.hit || status != GJK_OK || r->hit);
  tally.casts += cast.hit;
}

int main(int argc, char **argv) {
  static trial t;
  check_trials_of(&t, argc, argv, SEED);
  case_pair_release(&t.pair, &of_a, &of_b);
  return check_done("impact_search");
}
