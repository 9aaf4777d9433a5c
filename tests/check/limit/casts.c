// Casts under ceilings on their iterations and rounds, in space and in the plane. test_ceilings.sh builds it with low ones
// and with the usual ones, and compares what it prints: a line for each cast.
//
//   NUMBER KIND STATUS PROVEN HIT INSIDE FRACTION SUM   PROVEN: by gjk_check_cast; SUM: of the other fields of a hit
//
// Here it is checked that an answer is not refused by the check, and that an open cast is no hit. Where its fraction is above 0
// its places of rest must be safe.
#include <stdio.h>
#include <string.h>

#include "generate/cast.h"
#include "gjk/cast.h"
#include "gjk/check.h"
#include "gjk/gjk.h"
#include "reference/random_shape.h"
#include "tests/check/unit/plane.h"

#define POLYTOPES 20000
#define ROUNDED 10000
#define CURVED 5000
#define PLANE_CASTS 20000

static unsigned long number, opened, safe, counted;

static uint32_t mix(uint32_t sum, const void *field, size_t size) {
  const unsigned char *byte = field;
  for (size_t i = 0; i < size; i++) {
    sum = (sum ^ byte[i]) * UINT32_C(16777619);
  }
  return sum;
}

static void print_line(const char *kind, gjk_status status, gjk_status checked, bool hit, bool inside, gjk_q30 fraction,
                       uint32_t sum) {
  printf("%lu %s %s %d %d %d %ld %08lx\n", number++, kind, gjk_status_name(status), checked == GJK_OK, hit, inside,
         (long)fraction, (unsigned long)sum);
}

static bool is_told(gjk_status status) {
  return status == GJK_OK || status == GJK_ERROR_ITERATION_LIMIT;
}

static bool is_safe(const gjk_collider *a, const gjk_collider *b, gjk_q16 margin, const gjk_cast_result *r) {
  static gjk_epa_cell cells[GJK_EPA_CELLS(128)];
  const gjk_workspace workspace = {cells, sizeof cells / sizeof cells[0]};
  gjk_collider at_a = *a, at_b = *b;
  gjk_distance_result gap;
  const bool curved = r->certificate.proof == GJK_CAST_PROOF_NONE;
  CHECK(gjk_collider_move(&at_a, &r->rest_a) == GJK_OK && gjk_collider_move(&at_b, &r->rest_b) == GJK_OK);
  CHECK(gjk_signed_distance(&at_a, &at_b, NULL, &workspace, &gap) == GJK_OK || GJK_ITERATIONS_MAX < 100);
  return curved ? gap.upper >= margin - 6 : gap.upper >= margin;
}

static void ask(const char *kind, const gjk_collider *a, const gjk_collider *b, const gjk_cast_path *path) {
  gjk_cast_result r;
  memset(&r, 0x5A, sizeof r);
  const gjk_status status = gjk_cast(a, b, path, &r);
  if (!is_told(status)) {
    print_line(kind, status, status, false, false, 0, 0);
    return;
  }
  const gjk_status checked = gjk_check_cast(a, b, path, &r);
  const bool open = status == GJK_ERROR_ITERATION_LIMIT, at_rest = r.hit || open;
  uint32_t sum = 0;
  if (r.hit) {
    sum = mix(mix(sum, &r.rest_a, sizeof r.rest_a), &r.rest_b, sizeof r.rest_b);
    sum = mix(sum, &r.normal, sizeof r.normal);
    sum = r.inside ? sum : mix(mix(sum, &r.point_a, sizeof r.point_a), &r.point_b, sizeof r.point_b);
  }
  CHECK(open || checked != GJK_ERROR_UNPROVEN);
  print_line(kind, status, checked, r.hit, r.hit && r.inside, at_rest ? r.fraction : 0, sum);
  counted++;
  if (open) {
    opened++;
    CHECK(!r.hit && r.fraction >= 0 && r.fraction <= GJK_Q30_ONE);
    CHECK_MSG(r.fraction == 0 || is_safe(a, b, path->margin, &r), "%s %lu: not safe at rest", kind, number - 1);
    safe += r.fraction > 0;
  }
}

static case_pair pair;
static case_collider a, b;

static bool build(void) {
  return case_pair_build(&pair, false, &a, &b);
}

static void ask_polytopes(random_state *random) {
  for (unsigned long i = 0; i < check_trials(POLYTOPES); i++) {
    const generate_cast_family *family = &generate_cast_families[random_below(random, generate_cast_family_count)];
    generate_cast(family, random_u32(random), &pair);
    check_trial(i, case_show, &pair);
    if (build()) {
      const gjk_cast_path path = case_path(&pair, 0);
      ask(family->name, &a.collider, &b.collider, &path);
    }
  }
}

// Shapes with a radius or margin, that touch, graze by up to 2 LSB, or miss.
static void ask_rounded(random_state *random, unsigned long casts, bool curved) {
  for (unsigned long i = 0; i < casts; i++) {
    const gjk_q16 reach = (gjk_q16)(4 << random_below(random, 22)), other = (gjk_q16)(4 << random_below(random, 22));
    check_trial(i, case_show, &pair);
    random_shape(random, (case_kind)random_below(random, 5), reach, &pair.a);
    random_shape(random, (case_kind)(curved ? 5 + random_below(random, 3) : random_below(random, 5)), other, &pair.b);
    const double both = (double)reach + other, away = both * (1 + 8 * random_unit(random));
    const gjk_vec3 none = {0, 0, 0}, from = random_vector(random, away < 1e9 ? away : 1e9),
                   aim = random_vector(random, both * random_unit(random));
    const gjk_vec3 to = {aim.x - from.x, aim.y - from.y, aim.z - from.z};
    pair.a.pose.position = none;
    pair.b.pose.position = from;
    case_shape_move_to(&pair.b, &to);
    gjk_cast_path path = {NULL, &to, random_below(random, 2) == 0 ? 0 : random_range(random, 0, reach / 4 + 1)};
    if (!curved) {  // by so much as the line passes, or less
      pair.a.convex_radius = random_range(random, 1, reach);
      pair.b.convex_radius = random_below(random, 2) == 0 ? 0 : random_range(random, 0, other);
    }
    if (build()) {
      ask(curved ? "curved" : "rounded", &a.collider, &b.collider, &path);
    }
  }
}

// About the least gap on the way, by distances alone, so that ceilings of casts don't matter: it is convex.
static gjk_q16 least_gap(const gjk_collider *still, const gjk_collider *moves, const gjk_vec3 *to) {
  const gjk_vec3 from = moves->position;
  gjk_q30 low = 0, high = GJK_Q30_ONE;
  gjk_distance_result gap[2];
  while (high - low > 2) {
    for (int i = 0; i < 2; i++) {
      const int64_t at = low + (high - low) / 3 * (i + 1);
      const gjk_vec3 place = {(gjk_q16)(from.x + ((int64_t)to->x - from.x) * at / GJK_Q30_ONE),
                              (gjk_q16)(from.y + ((int64_t)to->y - from.y) * at / GJK_Q30_ONE),
                              (gjk_q16)(from.z + ((int64_t)to->z - from.z) * at / GJK_Q30_ONE)};
      gjk_collider there = *moves;
      CHECK(gjk_collider_move(&there, &place) == GJK_OK && gjk_distance(still, &there, NULL, &gap[i]) == GJK_OK);
    }
    const gjk_q30 third = (high - low) / 3 > 0 ? (high - low) / 3 : 1;
    low = gap[0].distance > gap[1].distance ? low + third : low;
    high = gap[0].distance > gap[1].distance ? high : high - third;
  }
  return gap[0].distance;
}

// Long thin bodies that pass each other hardly farther away than their radii.
static void ask_thin(random_state *random) {
  for (unsigned long i = 0; i < check_trials(ROUNDED); i++) {
    const gjk_q16 half = 1 << (10 + random_below(random, 15)), radius = random_range(random, 1, 9);
    const gjk_shape rod = GJK_CAPSULE(half, radius), bar = GJK_ROUNDED_BOX(random_range(random, 0, 3), half, 1, radius);
    gjk_collider c[2];
    gjk_pose pose = GJK_POSE_IDENTITY;
    gjk_vec3 to = {-2 * half, random_range(random, -half, half), 0};
    check_trial(i, NULL, NULL);
    memset(c, 0, sizeof c);
    pose.rotation = random_rotation(random);
    CHECK(gjk_collider_init(&c[0], &rod, NULL, 0) == GJK_OK && gjk_collider_pose(&c[0], &pose) == GJK_OK);
    pose.rotation = random_rotation(random);
    pose.position.x = 2 * half;
    pose.position.y = random_range(random, -half, half);
    CHECK(gjk_collider_init(&c[1], random_below(random, 2) == 0 ? &rod : &bar, NULL, 0) == GJK_OK);
    CHECK(gjk_collider_pose(&c[1], &pose) == GJK_OK);
    const gjk_cast_path path = {NULL, &to, least_gap(&c[0], &c[1], &to) + random_range(random, -2, 2)};
    if (path.margin >= 0) {
      ask("thin", &c[0], &c[1], &path);
    }
  }
}

static void ask_plane(random_state *random) {
  static plane_body bodies[2];
  for (unsigned long i = 0; i < check_trials(PLANE_CASTS); i++) {
    const int32_t size = 4 << random_below(random, 22);
    const bool curved = random_below(random, 3) == 0;
    check_trial(i, plane_print, bodies);
    plane_random_pair(random, size, 2 * size, bodies);
    const gjk2_shape ellipse = GJK2_ELLIPSE(size, random_range(random, 1, size));
    if (curved) {
      bodies[0].shape = ellipse;
      plane_place(&bodies[0], false);
    }
    const gjk2_vec at = bodies[0].collider.centre, from = bodies[1].pose.position;
    const gjk2_vec to = {from.x + 2 * (at.x - from.x) + random_range(random, -size, size),
                         from.y + 2 * (at.y - from.y) + random_range(random, -size, size)};
    const gjk2_cast_path path = {NULL, &to, random_below(random, 2) == 0 ? 0 : random_range(random, 0, size / 4)};
    gjk2_cast_result r, before;
    memset(&r, 0x5A, sizeof r);
    before = r;
    const gjk_status status = gjk2_cast(&bodies[0].collider, &bodies[1].collider, &path, &r);
    const char *kind = curved ? "ellipse" : "polygon";
    if (status != GJK_OK) {
      CHECK(memcmp(&before, &r, sizeof r) == 0);
      print_line(kind, status, status, false, false, 0, 0);
      opened += status == GJK_ERROR_ITERATION_LIMIT;
      continue;
    }
    const gjk_status checked = gjk2_check_cast(&bodies[0].collider, &bodies[1].collider, &path, &r);
    uint32_t sum = 0;
    if (r.hit) {
      sum = mix(mix(sum, &r.rest_a, sizeof r.rest_a), &r.rest_b, sizeof r.rest_b);
      sum = mix(mix(mix(sum, &r.normal, sizeof r.normal), &r.point_a, sizeof r.point_a), &r.point_b, sizeof r.point_b);
    }
    print_line(kind, status, checked, r.hit, r.hit && r.inside, r.hit ? r.fraction : 0, sum);
    counted++;
  }
}

int main(void) {
  random_state random = random_seed(check_seed(4400));
  ask_polytopes(&random);
  ask_rounded(&random, check_trials(ROUNDED), false);
  ask_rounded(&random, check_trials(CURVED), true);
  ask_plane(&random);
  ask_thin(&random);
  case_pair_release(&pair, &a, &b);
  printf("# %lu answered, %lu open, %lu of them bounded away from the start\n", counted - opened, opened, safe);
  return check_done("casts");
}
