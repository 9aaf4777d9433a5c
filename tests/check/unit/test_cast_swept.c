// Casts of rounded polytopes and with margins. What B sweeps is a rounded hull, so whether it comes near is a decision
// of gjk_within, which the exact oracle proves. Places on the way are looked at in whole LSB.
//
//   test_cast_swept [SEED [CASTS [FAMILY]]]    default: seed 1, 20,000 casts over all families
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "exact/cast_claim.h"
#include "generate/cast.h"
#include "generate/polytope.h"
#include "gjk/gjk.h"

#define CASTS check_trials(20000)
#define FAILURES_SHOWN 5

// A polytope has at most so many vertices; the hull of what it sweeps has twice as many.
#define VERTICES 256

// Ways are shorter per axis, so that what B sweeps is a shape.
#define WAY_MAX (INT32_C(1) << 27)

typedef struct swept {
  gjk_vec3 vertices[2 * VERTICES], buffer[2 * VERTICES];
  gjk_shape shape;
  gjk_collider collider;
} swept;

typedef struct campaign {
  case_pair pair;
  case_collider a, b;
  swept whole, part;
  exact_point way;
  gjk_q16 margin;
  random_state random;
  unsigned long casts, hits, inside, near, failures;
  char why[160];
} campaign;

#include "campaign.h"

// The hull of B here and B moved by a way. False: it is no shape.
static bool sweep(const gjk_collider *b, const exact_point *by, swept *out) {
  const unsigned count = exact_vertex_count(b);
  gjk_pose pose = GJK_POSE_IDENTITY;
  pose.position = b->centre;
  for (unsigned i = 0; i < count; i++) {
    const exact_point v = exact_vertex(b, i);
    gjk_vec3 *here = &out->vertices[i], *there = &out->vertices[count + i];
    here->x = (gjk_q16)(v.x[0] - b->centre.x);
    here->y = (gjk_q16)(v.x[1] - b->centre.y);
    here->z = (gjk_q16)(v.x[2] - b->centre.z);
    there->x = here->x + (gjk_q16)by->x[0];
    there->y = here->y + (gjk_q16)by->x[1];
    there->z = here->z + (gjk_q16)by->x[2];
  }
  out->shape = (gjk_shape)GJK_ROUNDED_HULL(out->vertices, (uint16_t)(2 * count), b->shape->convex_radius);
  memset(&out->collider, 0, sizeof out->collider);
  return gjk_collider_init(&out->collider, &out->shape, out->buffer, 2 * VERTICES) == GJK_OK &&
         gjk_collider_pose(&out->collider, &pose) == GJK_OK;
}

// Is what B sweeps within the distance? Proven by the oracle.
static bool is_within(campaign *t, const swept *s, gjk_q16 distance) {
  gjk_decision d = {0};
  const bool answered = gjk_within(&t->a.collider, &s->collider, distance, NULL, &d) == GJK_OK;
  expect(t, answered && exact_check_decision(&t->a.collider, &s->collider, distance, &d, t->why, sizeof t->why),
         "what B sweeps");
  return d.yes;
}

// The margin is no part of a case: the id tells it.
static void set_margin(campaign *t, int64_t margin) {
  const size_t length = strlen(t->pair.id);
  t->margin = (gjk_q16)margin;
  snprintf(t->pair.id + length, sizeof t->pair.id - length, "-margin-%ld", (long)t->margin);
}

// Gives both radii, and a margin, that add up to about the gap between A and what B sweeps; or any.
static bool choose_radii(campaign *t) {
  gjk_distance_result gap;
  if (!sweep(&t->b.collider, &t->way, &t->whole) ||
      gjk_distance(&t->a.collider, &t->whole.collider, NULL, &gap) != GJK_OK || gap.distance > WAY_MAX) {
    return false;
  }
  const int32_t reach = t->a.collider.radius / 4 + 4;
  const bool graze = !gap.intersecting && random_below(&t->random, 4) != 0;
  int32_t sum = graze ? gap.distance + random_range(&t->random, -2, 2) : random_range(&t->random, 1, reach);
  sum = sum < 0 ? 0 : sum;
  const int32_t first = random_range(&t->random, 0, sum), second = random_range(&t->random, 0, sum - first);
  t->pair.a.convex_radius = random_below(&t->random, 3) == 0 ? 0 : first;
  t->pair.b.convex_radius = random_below(&t->random, 3) == 0 ? 0 : second;
  set_margin(t, sum - t->pair.a.convex_radius - t->pair.b.convex_radius);
  return case_pair_build(&t->pair, false, &t->a, &t->b) && sweep(&t->b.collider, &t->way, &t->whole);
}

// B's displacement at a fraction, in whole LSB: rounded to the nearest, or towards the start.
static exact_point place_at(const campaign *t, gjk_q30 fraction, bool nearest) {
  exact_point by;
  for (int i = 0; i < 3; i++) {
    const int64_t product = t->way.x[i] * fraction, half = nearest ? (product < 0 ? -1 : 1) * (GJK_Q30_ONE / 2) : 0;
    by.x[i] = (product + half) / GJK_Q30_ONE;
  }
  return by;
}

static gjk_vec3 moved(const gjk_vec3 *from, const exact_point *by) {
  return (gjk_vec3){(gjk_q16)(from->x + by->x[0]), (gjk_q16)(from->y + by->x[1]), (gjk_q16)(from->z + by->x[2])};
}

// The gap is the margin at the fraction, and was more before. A place is off the way by up to 0.87 LSB, and 2^-30 of the
// way.
static void check_fraction(campaign *t, const gjk_cast_result *r) {
  gjk_collider b = t->b.collider;
  gjk_distance_result gap;
  const exact_point at = place_at(t, r->fraction, true), before = place_at(t, r->fraction, false);
  const gjk_vec3 to = moved(&b.position, &at);
  if (gjk_collider_move(&b, &to) == GJK_OK && gjk_distance(&t->a.collider, &b, NULL, &gap) == GJK_OK) {
    snprintf(t->why, sizeof t->why, "%ld", (long)gap.distance);
    expect(t, gap.distance <= (int64_t)t->margin + 4, "the gap at the fraction");
    t->why[0] = '\0';
  }
  if (t->margin >= 2 && sweep(&t->b.collider, &before, &t->part)) {
    expect(t, !is_within(t, &t->part, t->margin - 2), "contact before the fraction");
  }
}

static double length(double x, double y, double z) {
  return sqrt(x * x + y * y + z * z);
}

// The points are the margin apart, along the normal.
static void check_points(campaign *t, const gjk_cast_result *r) {
  const double x = (double)r->point_b.x - r->point_a.x, y = (double)r->point_b.y - r->point_a.y,
               z = (double)r->point_b.z - r->point_a.z;
  const double unit = GJK_Q30_ONE, m = t->margin;
  const double off = length(x - m * r->normal.x / unit, y - m * r->normal.y / unit, z - m * r->normal.z / unit);
  snprintf(t->why, sizeof t->why, "%.2f", off);
  expect(t, off <= 4.01 + m * 4e-9, "the points are not the margin apart");
  snprintf(t->why, sizeof t->why, "%ld %ld %ld", (long)r->normal.x, (long)r->normal.y, (long)r->normal.z);
  expect(t, fabs(length(r->normal.x, r->normal.y, r->normal.z) - unit) <= 4.01, "the normal's length");
  t->why[0] = '\0';
}

// At rest they are at least the margin apart, without one they share no inner point, and B is near its place on the way.
static void check_rest(campaign *t, const gjk_cast_result *r) {
  static gjk_epa_cell cells[GJK_EPA_CELLS(128)];
  static const gjk_workspace workspace = {cells, GJK_EPA_CELLS(128)};
  gjk_collider a = t->a.collider, b = t->b.collider;
  gjk_distance_result gap;
  gjk_penetration_result depth;
  const bool moves = gjk_collider_move(&a, &r->rest_a) == GJK_OK && gjk_collider_move(&b, &r->rest_b) == GJK_OK;
  expect(t, moves && gjk_distance(&a, &b, NULL, &gap) == GJK_OK, "they can be put at rest");
  if (!moves) {
    return;
  }
  snprintf(t->why, sizeof t->why, "%ld", (long)gap.distance);
  expect(t, gap.distance >= t->margin, "the gap at rest is too small");
  snprintf(t->why, sizeof t->why, "%ld", (long)gap.distance);
  expect(t, gap.distance <= (int64_t)t->margin + 6, "the gap at rest is too large");
  if (gjk_penetration(&a, &b, NULL, &workspace, &depth) == GJK_OK) {
    snprintf(t->why, sizeof t->why, "%ld", (long)depth.depth);
    expect(t, !depth.intersecting || depth.depth == 0, "they overlap at rest");
  }
  t->why[0] = '\0';
}

static void check_cast(campaign *t) {
  const gjk_vec3 to = moved(&t->b.collider.position, &t->way);
  const exact_point back_way = {{-t->way.x[0], -t->way.x[1], -t->way.x[2]}};
  const gjk_vec3 back_to = moved(&t->a.collider.position, &back_way);
  const gjk_cast_path path = {.to_b = &to, .margin = t->margin}, back = {.to_b = &back_to, .margin = t->margin};
  gjk_cast_result r, reversed;
  exact_cast range;
  if (!exact_cast_is_in_range(&t->a.collider, &t->b.collider, &path, &range) ||
      !exact_cast_is_in_range(&t->b.collider, &t->a.collider, &back, &range)) {
    return;
  }
  const bool near = is_within(t, &t->whole, t->margin);
  const gjk_status status = gjk_cast(&t->a.collider, &t->b.collider, &path, &r);
  expect(t, status == GJK_OK, gjk_status_name(status));
  if (status != GJK_OK) {
    return;
  }
  t->casts++;
  t->hits += r.hit;
  expect(t, r.hit == near, "hit or miss");
  const gjk_status proven = gjk_check_cast(&t->a.collider, &t->b.collider, &path, &r);
  expect(t, proven == GJK_OK, gjk_status_name(proven));
  gjk_cast_result wrong = r;
  wrong.hit = !r.hit;
  wrong.inside = false;
  wrong.fraction = r.hit ? r.fraction : GJK_Q30_ONE / 2;
  expect(t, gjk_check_cast(&t->a.collider, &t->b.collider, &path, &wrong) == GJK_ERROR_UNPROVEN, "forged");
  expect(t, gjk_cast(&t->b.collider, &t->a.collider, &back, &reversed) == GJK_OK && reversed.hit == r.hit, "reversed");
  if (!r.hit) {
    return;
  }
  gjk_decision start;
  const bool began = gjk_within(&t->a.collider, &t->b.collider, t->margin, NULL, &start) == GJK_OK && start.yes;
  expect(t, r.inside == began, "inside");
  expect(t, r.fraction >= 0 && r.fraction <= GJK_Q30_ONE && (!r.inside || r.fraction == 0), "the fraction's range");
  t->inside += r.inside;
  if (!r.inside) {
    check_fraction(t, &r);
    check_rest(t, &r);
    check_points(t, &r);
  }
}

// Few vertices on ways of up to 2^31 LSB, which brute force judges: within 3 LSB of grazing.
static void make_long(random_state *random, case_pair *pair) {
  const gjk_q16 reach = (gjk_q16)(4 << random_below(random, 23));
  const gjk_vec3 way = generate_vector(random, 65536.0 * (double)(UINT32_C(1) << random_below(random, 16)));
  const gjk_vec3 beside = generate_vector(random, reach * (1 + 2 * generate_unit(random)));
  const double part = generate_unit(random);
  const gjk_vec3 from = {(gjk_q16)(beside.x - way.x * part), (gjk_q16)(beside.y - way.y * part),
                         (gjk_q16)(beside.z - way.z * part)};
  const gjk_vec3 to = {(gjk_q16)(beside.x + way.x * (1 - part)), (gjk_q16)(beside.y + way.y * (1 - part)),
                       (gjk_q16)(beside.z + way.z * (1 - part))};
  case_shape_reset(&pair->a);
  case_shape_reset(&pair->b);
  pair->a.kind = CASE_HULL;
  case_shape_set_count(&pair->a, 1 + random_below(random, 4));
  for (size_t i = 0; i < pair->a.count; i++) {
    gjk_vec3 *v = &pair->a.vertices[i];
    v->x = random_range(random, -reach, reach);
    v->y = random_range(random, -reach, reach);
    v->z = random_range(random, -reach, reach);
  }
  pair->b.kind = random_below(random, 2) == 0 ? CASE_POINT : CASE_SEGMENT;
  pair->b.size.z = pair->b.kind == CASE_SEGMENT ? reach : 0;
  pair->b.pose.rotation = generate_rotation(random);
  pair->b.pose.position = from;
  case_shape_move_to(&pair->b, &to);
  snprintf(pair->id, sizeof pair->id, "long");
}

// Ways of up to so many LSB are decided exactly; beyond, a hit may be one by less than an LSB.
#define EXACT_WAY (16380.0 * 65536)

static void check_long(campaign *t, unsigned long counts[3]) {
  exact_cast range;
  exact_truth truth;
  gjk_cast_result r;
  gjk_cast_path path = case_path(&t->pair, 0);
  if (!case_pair_build(&t->pair, false, &t->a, &t->b) ||
      !exact_cast_is_in_range(&t->a.collider, &t->b.collider, &path, &range)) {
    return;
  }
  exact_brute_way(&t->a.collider, &t->b.collider, &range.way, &truth);
  const int64_t gap = truth.enclosing ? 0 : exact_truth_distance(&truth, &t->a.collider, &t->b.collider);
  const int64_t sum = gap + random_range(&t->random, -3, 3);
  if (gap == 0 || sum < 1 || sum > INT32_C(1) << 27) {
    return;
  }
  t->pair.a.convex_radius = (gjk_q16)(sum / 2);
  t->pair.b.convex_radius = random_below(&t->random, 2) == 0 ? 0 : (gjk_q16)(sum - sum / 2);
  set_margin(t, sum - t->pair.a.convex_radius - t->pair.b.convex_radius);
  path.margin = t->margin;
  if (!case_pair_build(&t->pair, false, &t->a, &t->b)) {
    return;
  }
  const gjk_collider *a = &t->a.collider, *b = &t->b.collider;
  const double far = length((double)range.way.x[0], (double)range.way.x[1], (double)range.way.x[2]);
  const bool exact = far + 2.0 * ((double)a->core_radius + b->core_radius) < EXACT_WAY;
  const bool near = exact_truth_within(&truth, a, b, t->margin);
  const gjk_status status = gjk_cast(a, b, &path, &r);
  expect(t, status == GJK_OK, gjk_status_name(status));
  if (status == GJK_OK) {
    expect(t, !near || r.hit, "a hit is missed");
    expect(t, near || !r.hit || !exact, "a miss is hit");
    expect(t, !r.hit || exact_truth_within(&truth, a, b, t->margin + 1), "a miss by more than an LSB is hit");
    counts[0] += exact;
    counts[1] += !exact;
    counts[2] += near;
  }
}

static void test_long(campaign *t, uint64_t seed, unsigned long casts) {
  unsigned long counts[3] = {0, 0, 0};
  t->random = random_seed(seed);
  t->failures = 0;
  for (unsigned long i = 0; i < casts && t->failures < FAILURES_SHOWN; i++) {
    make_long(&t->random, &t->pair);
    check_long(t, counts);
  }
  printf("long             %6lu exact, %lu beyond, %lu near\n", counts[0], counts[1], counts[2]);
  if (casts >= 500) {
    CHECK(counts[0] > casts / 4 && counts[1] > casts / 50);
    CHECK(counts[2] > casts / 4 && counts[2] < casts * 3 / 4);
  }
}

static void run_family(campaign *t, const generate_cast_family *family, uint64_t seed, unsigned long casts) {
  t->random = random_seed(seed);
  t->casts = t->hits = t->inside = t->failures = 0;
  for (unsigned long i = 0; i < casts && t->failures < FAILURES_SHOWN; i++) {
    generate_cast(family, (seed << 32) + i, &t->pair);
    const gjk_vec3 *p = &t->pair.b.pose.position, *q = &t->pair.b.end.position;
    const exact_point way = {{(int64_t)q->x - p->x, (int64_t)q->y - p->y, (int64_t)q->z - p->z}};
    t->way = way;
    t->pair.a.moves = false;
    if (llabs(way.x[0]) > WAY_MAX || llabs(way.x[1]) > WAY_MAX || llabs(way.x[2]) > WAY_MAX ||
        !case_pair_build(&t->pair, false, &t->a, &t->b) || exact_vertex_count(&t->b.collider) > VERTICES ||
        !choose_radii(t)) {
      continue;
    }
    check_cast(t);
  }
  printf("%-16s %6lu casts, %5.1f %% hit, %5.1f %% at the start\n", family->name, t->casts,
         100 * (double)t->hits / (double)(t->casts > 0 ? t->casts : 1),
         100 * (double)t->inside / (double)(t->casts > 0 ? t->casts : 1));
  fflush(stdout);
}

int main(int argc, char **argv) {
  static campaign t;
  const campaign_request asked = campaign_requested(argc, argv, CASTS, generate_cast_family_count);
  unsigned long total = 0, hits = 0;
  for (unsigned i = 0; i < generate_cast_family_count; i++) {
    const generate_cast_family *family = &generate_cast_families[i];
    if (campaign_includes(&asked, family->name)) {
      run_family(&t, family, asked.seed, asked.each);
      total += t.casts;
      hits += t.hits;
    }
  }
  printf("%lu casts, %lu hits\n", total, hits);
  if (asked.name == NULL && asked.count >= 1000) {
    CHECK(total > asked.count / 2);
    CHECK(hits > total / 4 && hits < total * 9 / 10);
  }
  if (asked.name == NULL) {
    test_long(&t, asked.seed, asked.count / 10);
  }
  case_pair_release(&t.pair, &t.a, &t.b);
  return check_done("cast_swept");
}
