// What must not change an answer: the cache, earlier questions, how the bodies got there, skipped tests, saves. Nor may
// it where a ceiling on iterations or a small workspace leaves no answer; test_ceilings.sh repeats this test with low
// ceilings.
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "generate/polytope.h"
#include "gjk/cast.h"
#include "gjk/gjk.h"
#include "gjk/impact.h"
#include "gjk/scene.h"
#include "same.h"
#include "scene_bodies.h"

#define PAIRS check_trials(6000)
#define MOVES check_trials(2000)
#define SCENES check_trials(4000)
#define ROOMS check_trials(300)
#define CELLS 60u
#define CORNERS 16
#define KINDS 14
#define SEED 8200

static gjk_vec3 corners[2][CORNERS];
static gjk_epa_cell cells[CELLS + 10];

// A hull of so many points on a sphere, so that every one is a vertex.
static void make_corners(random_state *random, int i, double radius) {
  for (int k = 0; k < CORNERS; k++) {
    corners[i][k] = generate_vector(random, radius);
  }
}

// Half of the shapes are hulls of 16 points, whose depths need the most cells.
static gjk_shape make_shape(random_state *random, int i) {
  const gjk_q16 size = 1 << (10 + random_below(random, 8));
  const gjk_shape kinds[KINDS] = {GJK_CYLINDER(size / 2, size),  GJK_ELLIPSOID(size, size / 2, size / 3),
                                  GJK_CONE(size / 2, size),      GJK_BOX(size, size / 2, size / 3),
                                  GJK_BOX(size, size, 0),        GJK_ROUNDED_BOX(size, size / 2, size / 3, size / 8),
                                  GJK_CAPSULE(size / 4, size),   GJK_ROUNDED_HULL(corners[i], CORNERS, size / 8),
                                  GJK_HULL(corners[i], 8),       GJK_TRIANGLE(corners[i]),
                                  GJK_HULL(corners[i], CORNERS), GJK_HULL(corners[i], CORNERS),
                                  GJK_HULL(corners[i], CORNERS), GJK_HULL(corners[i], CORNERS)};
  make_corners(random, i, size);
  return kinds[random_below(random, 2) == 0 ? KINDS - 1 : random_below(random, KINDS)];
}

static gjk_pose make_pose(random_state *random, double reach) {
  gjk_pose pose = GJK_POSE_IDENTITY;
  pose.position = generate_vector(random, reach);
  pose.rotation = generate_rotation(random);
  return pose;
}

// A pose not far from another.
static gjk_pose make_neighbour(random_state *random, const gjk_pose *pose, double reach) {
  gjk_pose other = *pose;
  const gjk_vec3 step = generate_vector(random, reach * generate_unit(random));
  const gjk_quat turn = {random_range(random, -9, 9), random_range(random, -9, 9), random_range(random, -9, 9), 50};
  gjk_quat unit = {0, 0, 0, GJK_Q30_ONE};
  other.position.x += step.x;
  other.position.y += step.y;
  other.position.z += step.z;
  if (random_below(random, 2) == 0) {
    gjk_quat_normalize(&turn, &unit);
    gjk_quat_compose(&unit, &other.rotation, &other.rotation);
  }
  return other;
}

// The parts of an answer that no cache may change.
typedef struct answers {
  gjk_status touched, near, measured, stopped, pierced, parted;
  gjk_decision touch, within;
  gjk_distance_result gap, until, apart;
  gjk_penetration_result depth;
} answers;

typedef struct question {
  gjk_collider a, b;
  gjk_q16 margin;
  gjk_workspace workspace;
  gjk_effort effort;
} question;

static void ask(const question *q, gjk_cache *cache, answers *out) {
  memset(out, 0, sizeof *out);
  // The depth is asked first, so that it gets the cache that the other pose has left.
  out->pierced = gjk_penetration(&q->a, &q->b, cache, &q->workspace, &out->depth);
  out->parted = gjk_signed_distance(&q->a, &q->b, cache, &q->workspace, &out->apart);
  out->touched = gjk_intersect(&q->a, &q->b, cache, &out->touch);
  out->near = gjk_within(&q->a, &q->b, q->margin, cache, &out->within);
  out->measured = gjk_distance(&q->a, &q->b, cache, &out->gap);
  out->stopped = gjk_distance_until(&q->a, &q->b, &q->effort, cache, &out->until);
}

static void expect_same(unsigned pair, const char *cache, const answers *cold, const answers *warm) {
  CHECK_MSG(cold->touched == warm->touched, "%s, pair %u", cache, pair);
  CHECK_MSG(cold->touch.yes == warm->touch.yes, "%s, pair %u", cache, pair);
  CHECK_MSG(cold->near == warm->near, "%s, pair %u", cache, pair);
  CHECK_MSG(cold->within.yes == warm->within.yes, "%s, pair %u", cache, pair);
  CHECK_MSG(cold->measured == warm->measured, "%s, pair %u", cache, pair);
  CHECK_MSG(same_gap(&cold->gap, &warm->gap), "%s, pair %u", cache, pair);
  CHECK_MSG(cold->stopped == warm->stopped, "%s, pair %u", cache, pair);
  CHECK_MSG(same_gap(&cold->until, &warm->until), "%s, pair %u", cache, pair);
  CHECK_MSG(cold->pierced == warm->pierced, "%s, pair %u", cache, pair);
  CHECK_MSG(same_depth(&cold->depth, &warm->depth), "%s, pair %u", cache, pair);
  CHECK_MSG(cold->parted == warm->parted, "%s, pair %u", cache, pair);
  CHECK_MSG(same_gap(&cold->apart, &warm->apart), "%s, pair %u", cache, pair);
}

static gjk_cache make_rubbish(random_state *random) {
  gjk_cache c;
  for (int k = 0; k < 3; k++) {
    c.direction[k] = (int16_t)random_range(random, -32768, 32767);
  }
  c.count = (uint16_t)random_below(random, 6);
  for (int k = 0; k < 4; k++) {
    c.a[k] = (uint16_t)random_below(random, CORNERS + 1);
    c.b[k] = (uint16_t)random_below(random, CORNERS + 1);
  }
  return c;
}

// Answers with a cache against cold ones. The cache is from a neighbouring pose, from the same pose, or random bits.
static void check_caches(void) {
  unsigned touching = 0, full = 0, limited = 0;
  for (unsigned i = 0; i < PAIRS; i++) {
    random_state random = random_seed(check_seed(SEED) + i);
    const gjk_shape shapes[2] = {make_shape(&random, 0), make_shape(&random, 1)};
    question q;
    answers cold, warm;
    gjk_cache cache, rubbish = make_rubbish(&random);
    CHECK(gjk_collider_init(&q.a, &shapes[0], NULL, 0) == GJK_OK);
    CHECK(gjk_collider_init(&q.b, &shapes[1], NULL, 0) == GJK_OK);
    const double reach = (double)q.a.radius + q.b.radius;
    const gjk_pose origin = GJK_POSE_IDENTITY, pose = make_pose(&random, reach * generate_unit(&random));
    const gjk_pose before = make_neighbour(&random, &pose, reach / 4);
    q.margin = random_range(&random, 0, (int32_t)reach / 4);
    q.workspace.cells = cells;
    q.workspace.count = random_below(&random, CELLS + 1);
    q.effort.iterations = (uint8_t)random_below(&random, 6);
    q.effort.error = random_below(&random, 2) == 0 ? 0 : random_range(&random, 0, (int32_t)reach / 8);
    memset(&cache, 0, sizeof cache);
    CHECK(gjk_collider_pose(&q.a, &origin) == GJK_OK);
    CHECK(gjk_collider_pose(&q.b, &before) == GJK_OK);
    ask(&q, &cache, &warm);
    CHECK(gjk_collider_pose(&q.b, &pose) == GJK_OK);
    ask(&q, NULL, &cold);
    ask(&q, &cache, &warm);
    expect_same(i, "a neighbour's cache", &cold, &warm);
    ask(&q, &cache, &warm);
    expect_same(i, "its own cache", &cold, &warm);
    ask(&q, &rubbish, &warm);
    expect_same(i, "a cache of random bits", &cold, &warm);
    touching += cold.touch.yes;
    full += cold.pierced == GJK_ERROR_CAPACITY;
    limited += cold.touched == GJK_ERROR_ITERATION_LIMIT || cold.measured == GJK_ERROR_ITERATION_LIMIT;
  }
  printf("%u touching, %u beyond the workspace, %u beyond the ceiling\n", touching, full, limited);
  CHECK(touching > PAIRS / 8);
  CHECK(full > PAIRS / 20);
  CHECK(limited > 0 || GJK_ITERATIONS_MAX > 10);
}

// What casts and impacts answer.
typedef struct moves {
  gjk_status cast, ray, impact;
  gjk_cast_result hit, ray_hit;
  gjk_impact_result meeting;
} moves;

typedef struct journey {
  gjk_motion a, b;
  gjk_q16 margin;
} journey;

static void ask_moves(const gjk_collider *a, const gjk_collider *b, const journey *j, moves *out) {
  const gjk_cast_path path = {.to_a = &j->a.to.position, .to_b = &j->b.to.position, .margin = j->margin};
  const gjk_impact_setup setup = {.margin = j->margin, .tolerance = GJK_IMPACT_TOLERANCE_MIN + j->margin / 64};
  memset(out, 0, sizeof *out);
  out->cast = gjk_cast(a, b, &path, &out->hit);
  out->ray = gjk_cast_ray(a, &j->b.from.position, &j->b.to.position, &out->ray_hit);
  out->impact = gjk_time_of_impact(a, &j->a, b, &j->b, &setup, &out->meeting);
}

static bool same_cast(gjk_status status, const gjk_cast_result *a, const gjk_cast_result *b) {
  return status != GJK_OK ||
         (a->hit == b->hit && a->iterations == b->iterations && a->certificate.proof == b->certificate.proof &&
          (!a->hit || (a->inside == b->inside && a->fraction == b->fraction && same_vec3(&a->rest_a, &b->rest_a) &&
                       same_vec3(&a->rest_b, &b->rest_b) && (a->inside || same_vec3(&a->point_a, &b->point_a)))));
}

static void expect_same_moves(unsigned pair, const char *what, const moves *a, const moves *b) {
  CHECK_MSG(a->cast == b->cast && a->ray == b->ray && a->impact == b->impact, "%s, pair %u", what, pair);
  CHECK_MSG(same_cast(a->cast, &a->hit, &b->hit), "%s, pair %u", what, pair);
  CHECK_MSG(same_cast(a->ray, &a->ray_hit, &b->ray_hit), "%s, pair %u", what, pair);
  const gjk_impact_result *p = &a->meeting, *q = &b->meeting;
  CHECK_MSG(p->hit == q->hit && p->overlap == q->overlap && p->lower == q->lower && p->upper == q->upper &&
                p->iterations == q->iterations && same_vec3(&p->pose_b.position, &q->pose_b.position),
            "%s, pair %u", what, pair);
}

// Casts and impacts asked again after other questions, of colliders elsewhere in memory, and of hulls with a buffer;
// impacts of colliders that were posed elsewhere.
static void check_moves(void) {
  static gjk_vec3 buffers[2][CORNERS];
  unsigned hits = 0, meetings = 0, limited = 0;
  for (unsigned i = 0; i < MOVES; i++) {
    random_state random = random_seed(check_seed(SEED) + 3000000 + i);
    const gjk_shape shapes[2] = {make_shape(&random, 0), make_shape(&random, 1)};
    gjk_collider lazy[2], baked[2], copied[2];
    moves first, other, again;
    journey j = {.a = {.from = GJK_POSE_IDENTITY}};
    for (int k = 0; k < 2; k++) {
      CHECK(gjk_collider_init(&lazy[k], &shapes[k], NULL, 0) == GJK_OK);
      CHECK(gjk_collider_init(&baked[k], &shapes[k], buffers[k], CORNERS) == GJK_OK);
    }
    const double reach = (double)lazy[0].radius + lazy[1].radius;
    j.a.to = make_neighbour(&random, &j.a.from, reach / 4);
    j.b.from = make_pose(&random, reach * (1 + generate_unit(&random)));
    j.b.to = make_pose(&random, reach * generate_unit(&random));
    j.margin = random_below(&random, 2) == 0 ? 0 : random_range(&random, 0, (int32_t)reach / 8);
    for (int k = 0; k < 2; k++) {
      const gjk_pose *pose = k == 0 ? &j.a.from : &j.b.from;
      CHECK(gjk_collider_pose(&lazy[k], pose) == GJK_OK && gjk_collider_pose(&baked[k], pose) == GJK_OK);
      copied[k] = lazy[k];
    }
    ask_moves(&lazy[0], &lazy[1], &j, &first);
    ask_moves(&lazy[1], &lazy[0], &j, &other);
    ask_moves(&copied[0], &copied[1], &j, &again);
    expect_same_moves(i, "elsewhere, and after another question", &first, &again);
    ask_moves(&baked[0], &baked[1], &j, &again);
    expect_same_moves(i, "baked", &first, &again);
    CHECK(gjk_collider_pose(&copied[0], &j.b.to) == GJK_OK && gjk_collider_pose(&copied[1], &j.a.to) == GJK_OK);
    ask_moves(&copied[0], &copied[1], &j, &again);
    again.cast = first.cast;
    again.hit = first.hit;
    again.ray = first.ray;
    again.ray_hit = first.ray_hit;
    expect_same_moves(i, "posed elsewhere", &first, &again);
    hits += first.cast == GJK_OK && first.hit.hit;
    meetings += first.impact == GJK_OK && first.meeting.hit;
    limited += first.impact == GJK_ERROR_ITERATION_LIMIT;
  }
  printf("%u casts hit, %u impacts, %u beyond the ceiling\n", hits, meetings, limited);
  CHECK(hits > MOVES / 8);
  CHECK(meetings > MOVES / 8 || GJK_ITERATIONS_MAX <= 10);
  CHECK(limited > 0 || GJK_ITERATIONS_MAX > 10);
}

// A history: one of several ways to the same scene.
typedef struct history {
  gjk_scene scene;
  gjk_body_id bodies[2];
  uint32_t block[400];
  gjk_report report;
  gjk_progress progress;
  gjk_manifold manifold;
} history;

typedef struct story {
  const gjk_shape *table[2];
  gjk_pose way[4];  // of the second body: where it begins, passes, rests, and ends
  gjk_q16 margin, box_margin;
  uint8_t detail;
  uint32_t cells;
} story;

static gjk_scene_bindings bindings_of(history *h) {
  static const gjk_workspace workspace = {cells, CELLS + 10};
  return (gjk_scene_bindings){.details = &gjk_scene_contacts, .workspace = &workspace, .manifolds = &h->manifold};
}

// Fills the room for reports with bytes that differ every time.
static bool update(history *h) {
  static uint8_t rubbish;
  memset(&h->report, 0, sizeof h->report);
  memset(&h->manifold, ++rubbish, sizeof h->manifold);
  return gjk_scene_update(&h->scene, &h->report, 1, &h->progress) == GJK_OK && h->progress.reports_left == 0;
}

static bool start(history *h, const story *s, const gjk_pose *at, uint8_t retest_all) {
  const gjk_scene_config config = {2, 2, 0, 1, s->box_margin, s->detail, 1, retest_all, 0, s->cells, 0};
  const gjk_scene_bindings bindings = bindings_of(h);
  bool fine = gjk_scene_init(&h->scene, &config, h->block, sizeof h->block, s->table, 2, &bindings) == GJK_OK;
  for (uint16_t i = 0; i < 2; i++) {
    const gjk_part part = {i, false, GJK_POSE_IDENTITY};
    gjk_body_setup setup = {GJK_POSE_IDENTITY,     &part, 1, GJK_BODY_DYNAMIC, GJK_DETAIL_TOUCH, 1, 1, 0,
                            i == 0 ? 0 : s->margin};
    setup.pose = i == 0 ? setup.pose : *at;
    fine = fine && gjk_scene_add(&h->scene, &setup, &h->bodies[i]) == GJK_OK;
  }
  return fine;
}

static bool move(history *h, const gjk_pose *pose) {
  return gjk_scene_move(&h->scene, h->bodies[1], pose) == GJK_OK && update(h);
}

// Makes three updates, after which the body rests at the same place. It takes the whole way there, or is there from the
// start.
static bool play(history *h, const story *s, bool whole, uint8_t retest_all) {
  bool fine = start(h, s, &s->way[whole ? 0 : 2], retest_all) && update(h);
  for (int i = 1; i < 3 && fine; i++) {
    fine = whole ? move(h, &s->way[i]) : update(h);
  }
  return fine;
}

// Goes on in a copy of the block elsewhere: a plain copy, or a sealed one that is opened.
static bool carry(history *to, history *from, const story *s, bool seal) {
  *to = *from;
  bool fine = !seal || gjk_scene_seal(&from->scene) == GJK_OK;
  memcpy(to->block, from->block, sizeof to->block);
  const gjk_scene_bindings bindings = bindings_of(to);
  return fine && (seal ? gjk_scene_open : gjk_scene_attach)(&to->scene, to->block, sizeof to->block, s->table, 2,
                                                            &bindings) == GJK_OK;
}

// Everything that was reported.
static bool same_reports(const history *a, const history *b) {
  const gjk_manifold *m = a->report.manifold, *n = b->report.manifold;
  return a->progress.reports == b->progress.reports && a->report.event == b->report.event &&
         a->report.distance == b->report.distance && (m == NULL) == (n == NULL) && (m == NULL || same_manifold(m, n));
}

static story make_story(random_state *random, gjk_shape shapes[2]) {
  story s;
  gjk_collider a, b;
  for (int i = 0; i < 2; i++) {
    shapes[i] = make_shape(random, i);
    s.table[i] = &shapes[i];
  }
  CHECK(gjk_collider_init(&a, &shapes[0], NULL, 0) == GJK_OK);
  CHECK(gjk_collider_init(&b, &shapes[1], NULL, 0) == GJK_OK);
  const double reach = (double)a.radius + b.radius;
  s.way[3] = make_pose(random, reach * generate_unit(random));
  for (int i = 2; i >= 0; i--) {
    s.way[i] = make_neighbour(random, &s.way[i + 1], reach / (2 << random_below(random, 6)));
  }
  s.margin = random_range(random, 0, (int32_t)reach / 8);
  s.box_margin = random_range(random, 0, (int32_t)reach / 4);
  s.detail = (uint8_t)random_below(random, 4);
  s.cells = random_below(random, CELLS + 1);
  return s;
}

// Scenes with equal hashes give the same reports of the same move, whatever their history: tests skipped or all
// repeated, saved or not.
static void check_scenes(void) {
  enum { WHOLE, SHORT, RETESTED, SHORT_RETESTED, COPIED, OPENED, HISTORIES };
  static history h[HISTORIES];
  unsigned near = 0, unsettled = 0, skipped = 0;
  for (unsigned i = 0; i < SCENES; i++) {
    random_state random = random_seed(check_seed(SEED) + 1000000 + i);
    gjk_shape shapes[2];
    const story s = make_story(&random, shapes);
    CHECK(play(&h[WHOLE], &s, true, 0));
    CHECK(play(&h[SHORT], &s, false, 0));
    CHECK(play(&h[RETESTED], &s, true, 1));
    CHECK(play(&h[SHORT_RETESTED], &s, false, 1));
    CHECK(carry(&h[COPIED], &h[WHOLE], &s, false));
    CHECK(carry(&h[OPENED], &h[SHORT], &s, true));
    for (int k = 1; k < HISTORIES; k++) {
      CHECK_MSG(scene_hash(&h[k].scene) == scene_hash(&h[0].scene), "scene %u before, history %d", i, k);
    }
    for (int k = 0; k < HISTORIES; k++) {
      gjk_scene_stats stats = {0};
      CHECK(move(&h[k], &s.way[3]));
      CHECK(gjk_scene_get_stats(&h[k].scene, &stats) == GJK_OK);
      CHECK_MSG(same_reports(&h[k], &h[0]), "scene %u, history %d, detail %d, %u cells: %ld, not %ld", i, k, s.detail,
                (unsigned)s.cells, (long)h[k].report.distance, (long)h[0].report.distance);
      CHECK_MSG(scene_hash(&h[k].scene) == scene_hash(&h[0].scene), "scene %u, history %d, detail %d", i, k, s.detail);
      unsettled += stats.unsettled;
      skipped += stats.motion + stats.direction;
    }
    near += h[0].progress.reports;
  }
  printf("%u scenes near, %u unsettled, %u skipped\n", near, unsettled, skipped);
  CHECK(near > SCENES / 4);
  CHECK(unsettled > SCENES / 4);
  CHECK(skipped > SCENES / 8);
}

#define CROWD 6

typedef struct crowd {
  gjk_scene scene;
  gjk_body_id bodies[CROWD];
  uint32_t block[1200];
} crowd;

static void start_crowd(crowd *c, gjk_q16 box_margin, gjk_q16 margin, uint32_t pairs) {
  static const gjk_shape crate = GJK_BOX(GJK_Q16_ONE, GJK_Q16_ONE, GJK_Q16_ONE);
  static const gjk_shape *const table[1] = {&crate};
  const gjk_scene_config config = {CROWD, CROWD, 0, pairs, box_margin, GJK_DETAIL_TOUCH, 0, 0, 0, 0, 0};
  CHECK(gjk_scene_init(&c->scene, &config, c->block, sizeof c->block, table, 1, NULL) == GJK_OK);
  for (int i = 0; i < CROWD; i++) {
    const gjk_part part = {0, false, GJK_POSE_IDENTITY};
    gjk_body_setup setup = {GJK_POSE_IDENTITY, &part, 1, GJK_BODY_DYNAMIC, GJK_DETAIL_TOUCH, 1, 1, 0, margin};
    setup.pose.position.x = i * 10 * GJK_Q16_ONE;
    CHECK(gjk_scene_add(&c->scene, &setup, &c->bodies[i]) == GJK_OK);
  }
}

// How many pairs need room: those that were near, and those whose boxes meet, each enlarged by twice the margin.
static uint32_t count_needed(const crowd *c, gjk_q16 margin) {
  bool needed[CROWD][CROWD] = {{false}};
  uint32_t cursor = 0, count = 0;
  gjk_report near;
  bool found = true;
  while (gjk_scene_next_near(&c->scene, &cursor, &near, &found) == GJK_OK && found) {
    needed[near.a.slot][near.b.slot] = true;
  }
  for (int i = 0; i < CROWD; i++) {
    for (int k = i + 1; k < CROWD; k++) {
      gjk_collider a, b;
      gjk_aabb x, y;
      gjk_scene_collider(&c->scene, c->bodies[i], 0, &a);
      gjk_scene_collider(&c->scene, c->bodies[k], 0, &b);
      gjk_collider_aabb(&a, &x);
      gjk_collider_aabb(&b, &y);
      const gjk_q16 reach = 2 * margin;
      count += needed[i][k] ||
               (x.lower.x - reach <= y.upper.x && y.lower.x - reach <= x.upper.x && x.lower.y - reach <= y.upper.y &&
                y.lower.y - reach <= x.upper.y && x.lower.z - reach <= y.upper.z && y.lower.z - reach <= x.upper.z);
    }
  }
  return count;
}

// Whether all pairs find room depends on poses, and on which pairs were near. It must not depend on how far boxes in
// the tree have grown.
static void check_room(void) {
  static crowd wide, tight;
  unsigned refused = 0, narrow = 0;
  for (unsigned i = 0; i < ROOMS; i++) {
    random_state random = random_seed(check_seed(SEED) + 2000000 + i);
    const gjk_q16 margin = random_below(&random, 2) == 0 ? 0 : GJK_Q16(0.25);
    const uint32_t pairs = 2 + random_below(&random, 10);
    start_crowd(&wide, GJK_Q16(2), margin, pairs);
    start_crowd(&tight, 0, margin, pairs);
    for (int tick = 0; tick < 12; tick++) {
      gjk_report report[20];
      gjk_progress progress;
      gjk_scene_stats stats = {0};
      for (int k = 0; k < 3; k++) {
        const uint32_t body = random_below(&random, CROWD);
        const gjk_pose pose = make_pose(&random, GJK_Q16(5) * generate_unit(&random));
        CHECK(gjk_scene_move(&wide.scene, wide.bodies[body], &pose) == GJK_OK);
        CHECK(gjk_scene_teleport(&tight.scene, tight.bodies[body], &pose) == GJK_OK);
      }
      const bool fits = count_needed(&tight, margin) <= pairs;
      const gjk_status expected = fits ? GJK_OK : GJK_ERROR_CAPACITY;
      CHECK_MSG(gjk_scene_update(&tight.scene, report, 20, &progress) == expected, "room %u, tick %d", i, tick);
      CHECK_MSG(gjk_scene_update(&wide.scene, report, 20, &progress) == expected, "room %u, tick %d", i, tick);
      CHECK(gjk_scene_check(&wide.scene) == GJK_OK);
      CHECK(gjk_scene_check(&tight.scene) == GJK_OK);
      CHECK_MSG(scene_hash(&wide.scene) == scene_hash(&tight.scene), "room %u, tick %d", i, tick);
      CHECK(gjk_scene_get_stats(&wide.scene, &stats) == GJK_OK);
      refused += !fits;
      narrow += fits && stats.pairs == pairs;
    }
  }
  printf("%u updates refused, %u just fit\n", refused, narrow);
  CHECK(refused > ROOMS);
  CHECK(narrow > ROOMS);
}

// The nearest of parts that are far away, almost equally far, so that distances are rounded by more than boxes are. It
// must be the one that a search of all parts finds, whatever the shape of the tree.
static void check_nearest(void) {
  static const gjk_shape kinds[] = {GJK_BOX(40000, 40000, 40000), GJK_ELLIPSOID(30000, 40000, 50000),
                                    GJK_CYLINDER(40000, 30000), GJK_SPHERE(40000)};
  static const gjk_shape *const table[] = {&kinds[0], &kinds[1], &kinds[2], &kinds[3]};
  static const gjk_scene_config config = {CROWD, CROWD, 0, 1, 0, GJK_DETAIL_TOUCH, 0, 0, 0, 0, 0};
  static crowd c;
  for (unsigned i = 0; i < ROOMS; i++) {
    random_state random = random_seed(check_seed(SEED) + 3000000 + i);
    gjk_collider from, to[CROWD];
    gjk_pose pose = GJK_POSE_IDENTITY;
    gjk_q16 best = INT32_MAX, distance = 0;
    gjk_scene_hit hit = {{0, 0}, 0, 0, 0};
    uint32_t nearest = 0;
    bool found = false;
    CHECK(gjk_collider_init(&from, table[random_below(&random, 4)], NULL, 0) == GJK_OK);
    pose.position.x = -GJK_Q16(16000);
    CHECK(gjk_collider_pose(&from, &pose) == GJK_OK);
    CHECK(gjk_scene_init(&c.scene, &config, c.block, sizeof c.block, table, 4, NULL) == GJK_OK);
    for (uint32_t k = 0; k < CROWD; k++) {
      const gjk_part part = {(uint16_t)random_below(&random, 4), false, GJK_POSE_IDENTITY};
      gjk_body_setup setup = {GJK_POSE_IDENTITY, &part, 1, GJK_BODY_DYNAMIC, GJK_DETAIL_TOUCH, 1, 1, 0, 0};
      gjk_distance_result gap = {0};
      setup.pose.position.x = GJK_Q16(16000) + kinds[part.shape].size.x + random_range(&random, 0, 25);
      setup.pose.position.y = random_range(&random, -2000, 2000);
      CHECK(gjk_scene_add(&c.scene, &setup, &c.bodies[k]) == GJK_OK);
      CHECK(gjk_scene_collider(&c.scene, c.bodies[k], 0, &to[k]) == GJK_OK);
      const bool settled = gjk_distance(&from, &to[k], NULL, &gap) == GJK_OK;
      CHECK(settled || GJK_ITERATIONS_MAX <= 10);
      if (settled && gap.distance < best) {
        best = gap.distance;
        nearest = k;
      }
      found = found || !settled;
    }
    if (found) {
      continue;  // the ceiling leaves one of them open
    }
    CHECK(gjk_scene_query_nearest(&c.scene, &from, GJK_DISTANCE_MAX, NULL, &hit, &distance, &found) == GJK_OK);
    CHECK(found);
    CHECK_MSG(hit.body.slot == nearest, "scene %u: body %u, not %u", i, (unsigned)hit.body.slot, (unsigned)nearest);
    CHECK_MSG(distance == best, "scene %u: %ld, not %ld", i, (long)distance, (long)best);
  }
}

// The hash holds what lockstep peers must have in common: the cells of the workspace.
static void check_configuration(void) {
  static history few, many;
  random_state random = random_seed(check_seed(SEED));
  gjk_shape shapes[2];
  story s = make_story(&random, shapes);
  s.cells = 40;
  CHECK(start(&few, &s, &s.way[0], 0));
  s.cells = 41;
  CHECK(start(&many, &s, &s.way[0], 0));
  CHECK(scene_hash(&few.scene) != scene_hash(&many.scene));
}

int main(void) {
  printf("ceiling %d\n", GJK_ITERATIONS_MAX);
  check_caches();
  check_moves();
  check_scenes();
  check_room();
  check_nearest();
  check_configuration();
  return check_done("history");
}
