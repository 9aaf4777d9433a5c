// Times of impact of two bodies of many parts, compounds and surfaces, against every pair of their parts by the pair's query,
// bit for bit; with the tree and without; and against distances before and at the impact. Then ties and what is refused.
#include <string.h>

#include "check.h"
#include "generate/body.h"
#include "generate/surface.h"
#include "gjk/height_field.h"
#include "parts_answers.h"
#include "reference/random_shape.h"
#include "src/motion/gjk_impact.h"
#include "src/parts/gjk_parts_class.h"

#define TRIALS 240
#define SIDE 4

static generate_body body, other;
static surface ground;
static int16_t heights[(SIDE + 1) * (SIDE + 1)];
static gjk_height_field field;
static struct { unsigned long hits, overlaps, misses, ties, limited, least, holes, surfaces, still, near, far; } tally;

// What a question is about.
typedef struct question {
  gjk_parts a, b;
  gjk_motion motion[2];
  gjk_impact_setup setup;
} question;

static bool is_in_field(const gjk_parts *of, uint32_t number) {
  gjk_parts_room room;
  gjk_collider c;
  return gjk_parts_place(of, number, &room, &c) == GJK_OK;
}

static bool is_better(const gjk_impact_result *trial, const gjk_impact_result *best) {
  return trial->lower < best->lower || (trial->lower == best->lower && trial->overlap && !best->overlap);
}

// The first impact of all pairs, one after the other. limited: the least fraction of those that reached their ceiling.
static void ask_every_pair(const question *q, gjk_parts_pair *first, gjk_impact_result *best, gjk_q30 *limited) {
  gjk_impact_result trial;
  gjk_parts_room room[2];
  gjk_parts_local local[2];
  gjk_collider c[2];
  first->a = GJK_PARTS_NONE;
  first->b = GJK_PARTS_NONE;
  *limited = GJK_Q30_ONE;
  for (uint32_t j = 0; j < gjk_parts_count(&q->b); j++) {
    if (!is_in_field(&q->b, j)) {
      tally.holes++;
      continue;
    }
    q->b.type->local(q->b.data, j, &room[1], &local[1]);
    CHECK(gjk_collider_init(&c[1], local[1].shape, NULL, 0) == GJK_OK);
    for (uint32_t i = 0; i < gjk_parts_count(&q->a); i++) {
      if (!is_in_field(&q->a, i)) {
        continue;
      }
      q->a.type->local(q->a.data, i, &room[0], &local[0]);
      CHECK(gjk_collider_init(&c[0], local[0].shape, NULL, 0) == GJK_OK);
      const gjk_carried of[2] = {{&c[0], &q->motion[0], local[0].own, q->a.type->reach(q->a.data)},
                                 {&c[1], &q->motion[1], local[1].own, q->b.type->reach(q->b.data)}};
      const gjk_status status = gjk_impact_of_carried(of, &q->setup, gjk_pose_compose, &trial);
      CHECK(status == GJK_OK || status == GJK_ERROR_ITERATION_LIMIT);
      if (status == GJK_ERROR_ITERATION_LIMIT) {
        *limited = trial.lower < *limited ? trial.lower : *limited;
      } else if (trial.hit && (first->a == GJK_PARTS_NONE || is_better(&trial, best))) {
        first->a = i;
        first->b = j;
        *best = trial;
      } else if (trial.hit && trial.lower == best->lower && trial.overlap == best->overlap) {
        tally.ties++;
      }
    }
  }
}

static gjk_distance_result gap_at(const question *q, gjk_q30 fraction) {
  gjk_parts a = q->a, b = q->b;
  gjk_distance_result gap;
  CHECK(gjk_motion_pose(&q->motion[0], fraction, &a.pose) == GJK_OK);
  CHECK(gjk_motion_pose(&q->motion[1], fraction, &b.pose) == GJK_OK);
  CHECK(gjk_parts_both_distance(&a, &b, NULL, &gap) == GJK_OK);
  return gap;
}

static void check_apart_before(random_state *random, const question *q, gjk_q30 lower) {
  for (int k = 0; k < 4 && lower > 0; k++) {
    const gjk_q30 before = (gjk_q30)((double)(lower - 1) * (k == 0 ? 1 : random_unit(random)));
    const gjk_distance_result gap = gap_at(q, before);
    CHECK_MSG(!gap.intersecting && gap.distance >= q->setup.margin, "gap %ld at %ld", (long)gap.distance, (long)before);
  }
}

static gjk_status ask(const question *q, gjk_parts_pair *pair, gjk_impact_result *out) {
  return gjk_parts_both_time_of_impact(&q->a, &q->motion[0], &q->b, &q->motion[1], &q->setup, pair, out);
}

static void check_question(random_state *random, const question *q) {
  gjk_parts_pair first, pair;
  gjk_impact_result best = {0}, answer;
  gjk_q30 limited;
  gjk_pose end;
  memset(&answer, 0x5A, sizeof answer);
  ask_every_pair(q, &first, &best, &limited);
  const gjk_status status = ask(q, &pair, &answer);
  if (status == GJK_ERROR_ITERATION_LIMIT) {
    tally.limited++;
    // Pairs that are not near enough on what is left of the way are not asked, so they do not lower it.
    CHECK(!answer.hit && answer.lower >= limited && answer.upper == GJK_Q30_ONE);
    tally.least += answer.lower == limited;
    CHECK(first.a == GJK_PARTS_NONE || limited < best.lower);
    check_apart_before(random, q, answer.lower);
    return;
  }
  CHECK_MSG(status == GJK_OK, "%s", gjk_status_name(status));
  CHECK_MSG(pair.a == first.a && pair.b == first.b, "pair %ld %ld not %ld %ld", (long)pair.a, (long)pair.b,
            (long)first.a, (long)first.b);
  if (first.a == GJK_PARTS_NONE) {
    best.lower = best.upper = GJK_Q30_ONE;
  }
  CHECK(same_impact(&answer, &best));
  CHECK(gjk_motion_pose(&q->motion[1], answer.lower, &end) == GJK_OK &&
        same_vec3(&end.position, &answer.pose_b.position));
  CHECK(gjk_motion_pose(&q->motion[0], answer.lower, &end) == GJK_OK &&
        same_vec3(&end.position, &answer.pose_a.position));
  tally.hits += answer.hit && !answer.overlap;
  tally.overlaps += answer.overlap;
  tally.misses += !answer.hit;
  if (answer.hit) {
    const gjk_distance_result gap = gap_at(q, answer.upper);
    CHECK_MSG(gap.distance <= q->setup.margin + q->setup.tolerance + 24, "gap %ld", (long)gap.distance);
  }
  check_apart_before(random, q, answer.lower);
}

static void set_motions(random_state *random, gjk_q16 spread, question *q) {
  const gjk_vec3 off = random_vector(random, random_below(random, 3) == 0 ? 0.3 * spread : 3.0 * spread),
                 way_a = random_vector(random, spread), past = random_vector(random, 3.0 * spread);
  memset(q->motion, 0, sizeof q->motion);
  q->motion[0].from.position = random_vector(random, spread);
  const gjk_vec3 *at = &q->motion[0].from.position;
  q->motion[0].from.rotation = random_rotation(random);
  q->motion[0].to = q->motion[0].from;
  q->motion[0].to.position = (gjk_vec3){at->x + way_a.x, at->y + way_a.y, at->z + way_a.z};
  q->motion[1].from.rotation = random_rotation(random);
  q->motion[1].from.position = (gjk_vec3){at->x + off.x, at->y + off.y, at->z + off.z};
  q->motion[1].to = q->motion[1].from;
  q->motion[1].to.position = (gjk_vec3){at->x + past.x - off.x, at->y + past.y - off.y, at->z + past.z - off.z};
  if (random_below(random, 2) == 0) {
    q->motion[0].to.rotation = random_rotation(random);
  }
  if (random_below(random, 2) == 0) {
    q->motion[1].spin = random_vector(random, 400000);
  }
  q->setup = (gjk_impact_setup){random_below(random, 2) == 0 ? 0 : random_range(random, 0, 1000), 2048,
                                random_below(random, 3) == 0 ? (uint8_t)(1 + random_below(random, 3)) : 0};
}

static void make_field(random_state *random, gjk_q16 spread) {
  for (unsigned k = 0; k < sizeof heights / sizeof heights[0]; k++) {
    heights[k] = (int16_t)(random_below(random, 8) == 0 ? GJK_HEIGHT_HOLE : random_range(random, -200, 200));
  }
  heights[0] = heights[1] = heights[SIDE + 1] = heights[SIDE + 2] = 0;
  field = (gjk_height_field){heights, SIDE + 1, SIDE + 1, spread / SIDE + 1, spread / SIDE + 1, spread / 400 + 1};
}

// Bodies that stand still: they overlap at the start, or miss.
static void try_still(random_state *random, const question *moved) {
  question q = *moved;
  gjk_parts_pair pair;
  gjk_impact_result answer;
  for (unsigned k = 0; k < 2; k++) {
    memset(&q.motion[k].spin, 0, sizeof q.motion[k].spin);
    q.motion[k].to = q.motion[k].from;
  }
  q.setup.iterations = 0;
  check_question(random, &q);
  CHECK(ask(&q, &pair, &answer) == GJK_OK && (!answer.hit || answer.lower == 0));
  tally.still += answer.hit;
}

// The least tolerance that is taken is enough for each pair of parts, however far its parts are from their poses.
static void try_least_tolerance(random_state *random, uint64_t seed) {
  static const gjk_vec3 origin = {0, 0, 0};
  static const gjk_q16 spreads[] = {GJK_Q16(2.0), GJK_Q16(90.0), GJK_Q16(900.0), GJK_Q16(9000.0)};
  question q;
  gjk_parts_pair pair;
  gjk_impact_result answer;
  gjk_q30 limited;
  const unsigned of_a = random_below(random, 4), of_b = random_below(random, 4);
  generate_body_make((generate_layout)random_below(random, GENERATE_LAYOUTS), seed, 5, spreads[of_a], &origin, &body);
  generate_body_make(GENERATE_CURVED, seed + 1, 5, spreads[of_b], &origin, &other);
  set_motions(random, GJK_Q16(2.0), &q);
  q.a = body.tree;
  q.b = other.tree;
  q.setup.iterations = 1;
  q.setup.margin = random_below(random, 2) == 0 ? 0 : GJK_IMPACT_MARGIN_MAX;
  gjk_q16 low = 0, high = GJK_Q16(1.0);
  while (high - low > 1) {
    q.setup.tolerance = low + (high - low) / 2;
    const gjk_status status = ask(&q, &pair, &answer);
    CHECK(status == GJK_OK || status == GJK_ERROR_ITERATION_LIMIT || status == GJK_ERROR_RANGE);
    *(status == GJK_ERROR_RANGE ? &low : &high) = q.setup.tolerance;
  }
  const double of_body = body.tree.type->reach(body.tree.data), of_other = other.tree.type->reach(other.tree.data),
               excess = of_body + of_other > 16777216 ? of_body + of_other - 16777216 : 0,
               far = (of_body > 268435456 ? 11 : 0) + (of_other > 268435456 ? 11 : 0),
               least = GJK_PARTS_BOTH_TOLERANCE_MIN + excess / 2097152 + far + q.setup.margin / 67108864.0;
  CHECK_MSG(high >= least - 1 / 256.0 && high <= least + 1 && high < GJK_Q16(1.0), "%ld", (long)high);
  *(excess > 0 ? &tally.far : &tally.near) += 1;
  q.setup.tolerance = high;
  ask_every_pair(&q, &pair, &answer, &limited);
}

static void try_bodies(random_state *random, uint64_t seed) {
  static const gjk_vec3 origin = {0, 0, 0};
  const gjk_q16 spread = (random_reach(random) % (40 * 65536) + 800) / 2;
  const gjk_parts of_mesh = GJK_PARTS_OF_MESH(&ground.mesh), of_field = GJK_PARTS_OF_HEIGHT_FIELD(&field);
  question q, flat;
  generate_body_make((generate_layout)random_below(random, GENERATE_LAYOUTS), seed,
                     (uint16_t)(1 + random_below(random, 14)), spread, &origin, &body);
  generate_body_make((generate_layout)random_below(random, GENERATE_LAYOUTS), seed + 1,
                     (uint16_t)(1 + random_below(random, 12)), spread / 2 + 1, &origin, &other);
  surface_make(random, (surface_kind)random_below(random, SURFACE_KINDS), 20, spread / 4 + 8,
               random_below(random, 2) == 0, &ground);
  make_field(random, spread);
  const gjk_parts as_a[] = {body.tree, of_mesh, of_field, body.tree},
                  as_b[] = {other.tree, other.tree, other.tree, of_field};
  for (unsigned k = 0; k < 4; k++) {
    q.a = as_a[k];
    q.b = as_b[k];
    set_motions(random, spread, &q);
    check_question(random, &q);
    tally.surfaces += k > 0;
  }
  q.a = body.tree;
  q.b = other.tree;
  flat = q;
  flat.a = body.flat;
  flat.b = other.flat;
  gjk_impact_result answer, of_flat;
  gjk_parts_pair pair, of_list;
  CHECK(ask(&q, &pair, &answer) == ask(&flat, &of_list, &of_flat));
  CHECK(pair.a == of_list.a && pair.b == of_list.b && same_impact(&answer, &of_flat));
  try_still(random, &q);
  surface_free(&ground);
}

static void expect_refused(const question *q, gjk_status expected) {
  unsigned char before[sizeof(gjk_impact_result)];
  gjk_impact_result out;
  gjk_parts_pair pair = {77, 78};
  memset(&out, 0x5A, sizeof out);
  memset(before, 0x5A, sizeof before);
  const gjk_status status = ask(q, &pair, &out);
  CHECK_MSG(status == expected, "%s", gjk_status_name(status));
  const unsigned char *after = (const unsigned char *)&out;
  CHECK(memcmp(after, before, sizeof out) == 0 && pair.a == 77 && pair.b == 78);
}

static void check_refusals(void) {
  static const gjk_vec3 origin = {0, 0, 0};
  static const gjk_motion rest = {.from = GJK_POSE_IDENTITY, .to = GJK_POSE_IDENTITY};
  static const gjk_compound nothing;
  gjk_impact_result out;
  generate_body_make(GENERATE_ROW, 5, 4, 65536, &origin, &body);
  const question good = {body.tree, body.tree, {rest, rest}, {0, GJK_PARTS_BOTH_TOLERANCE_MIN, 0}};
  question bad;
  gjk_parts_pair pair;
  const gjk_motion *m = good.motion;
  // Bodies that are equal and at one place: every pair of them that shares a point overlaps, so the least numbers count.
  CHECK(gjk_parts_both_time_of_impact(&good.a, &m[0], &good.b, &m[1], &good.setup, &pair, &out) == GJK_OK);
  CHECK(out.hit && out.overlap && out.lower == 0 && pair.a == 0 && pair.b == 0);
  CHECK(gjk_parts_both_time_of_impact(&good.a, &m[0], &good.b, &m[1], &good.setup, NULL, &out) == GJK_OK);
  for (unsigned k = 0; k < 2; k++) {
    bad = good;
    (k == 0 ? &bad.a : &bad.b)->type = NULL;
    expect_refused(&bad, GJK_ERROR_NULL);
    bad = good;
    (k == 0 ? &bad.a : &bad.b)->data = &nothing;
    expect_refused(&bad, GJK_ERROR_EMPTY);
    bad = good;
    bad.motion[k].from.rotation.w = 0;
    expect_refused(&bad, GJK_ERROR_ROTATION);
    bad = good;
    bad.motion[k].to.rotation.w = 0;
    expect_refused(&bad, GJK_ERROR_ROTATION);
    bad = good;
    bad.motion[k].from.position.x = INT32_MAX;
    expect_refused(&bad, GJK_ERROR_RANGE);
    bad = good;
    bad.motion[k].to.position.y = INT32_MIN;
    expect_refused(&bad, GJK_ERROR_RANGE);
  }
  bad = good;
  bad.setup.tolerance--;
  expect_refused(&bad, GJK_ERROR_RANGE);
  bad = good;
  bad.setup.margin = -1;
  expect_refused(&bad, GJK_ERROR_NEGATIVE);
  bad = good;
  bad.setup.margin = GJK_IMPACT_MARGIN_MAX + 1;
  expect_refused(&bad, GJK_ERROR_RANGE);
}

int main(void) {
  const uint64_t seed = check_seed(20261123);
  const unsigned long trials = check_trials_least(TRIALS, 60);
  for (unsigned long i = 0; i < trials; i++) {
    random_state random = random_seed(seed + 3 * i);
    check_trial(i, generate_body_show, &body);
    try_bodies(&random, seed + 3 * i);
    try_least_tolerance(&random, seed + 3 * i);
  }
  check_trial(trials, NULL, NULL);
  printf("hits %lu, overlaps %lu, misses %lu, ties %lu, limited %lu %lu, holes %lu, still %lu, near %lu, far %lu\n",
         tally.hits, tally.overlaps, tally.misses, tally.ties, tally.limited, tally.least, tally.holes, tally.still,
         tally.near, tally.far);
  CHECK(tally.hits > trials / 4 && tally.overlaps > trials / 8 && tally.misses > trials / 4);
  CHECK(tally.ties > 0 && tally.limited > 20 && tally.least > tally.limited / 2 && tally.holes > 0 &&
        tally.surfaces > 0 && tally.still > trials / 16 && tally.near > trials / 16 && tally.far > trials / 4);
  check_refusals();
  generate_body_free(&body);
  generate_body_free(&other);
  return check_done("test_parts_impact");
}
