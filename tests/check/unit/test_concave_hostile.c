// Scenes with concave bodies under attack: ties, curved movers, degenerate and doubled triangles, bodies at the ends of
// int32, removed and replaced in one tick, workspaces of 0 cells and more.
//
// Four scenes play the same game: one in slices; one that tests every pair anew, in more memory, its pairs and fast bodies
// asked in any order; a copy of the block from before the tick; and one that is built anew before each tick. Reports,
// contacts and impacts are the same bit for bit, and those that gjk/parts.h gives without a scene. Ceilings are lower in
// test_ceilings.sh.
#include <string.h>

#include "check.h"
#include "reference/random_shape.h"
#include "same.h"
#include "scene/concave_solid.h"

#define SEED UINT64_C(0x486F7374)
#define TRIALS 8
#define TICKS 7
#define LADDERS 3
#define CROWDS 40

static struct { unsigned long pairs, near, curved, manifolds, lacking, limited, impacts, fits, full; } tally;

static game m;
static game_scene s[GAME_SCENES];

// Of a report without contacts only their number is set.
static bool same_contacts(const gjk_manifold *p, const gjk_manifold *q) {
  return p->count == 0 ? q->count == 0 : same_manifold(p, q);
}

// The reports of two scenes. anew: of one that was built anew, whose generations differ.
static void compare_reports(const game_scene *a, const game_scene *b, bool anew, const char *which) {
  CHECK_MSG(a->reports == b->reports, "%s: %u reports, expected %u", which, b->reports, a->reports);
  for (uint32_t i = 0; i < a->reports && i < b->reports; i++) {
    const gjk_report *p = &a->report[i], *q = &b->report[i];
    CHECK_MSG(p->a.slot == q->a.slot && p->b.slot == q->b.slot && p->part_a == q->part_a && p->part_b == q->part_b &&
                  p->event == q->event && p->detail == q->detail && p->distance == q->distance &&
                  p->fraction == q->fraction,
              "%s: report %u, bodies %u and %u: event %u %u, distance %d %d, fraction %d %d", which, i, p->a.slot,
              p->b.slot, p->event, q->event, (int)p->distance, (int)q->distance, (int)p->fraction, (int)q->fraction);
    CHECK(anew || (p->a.generation == q->a.generation && p->b.generation == q->b.generation));
    CHECK((p->manifold != NULL) == (q->manifold != NULL));
    CHECK_MSG(p->manifold == NULL || q->manifold == NULL || same_contacts(p->manifold, q->manifold),
              "%s: manifold of report %u", which, i);
    tally.impacts += !anew && p->event == GJK_EVENT_IMPACT;
  }
}

static uint64_t hash_of(const game_scene *scene) {
  uint64_t hash = 0;
  CHECK(gjk_scene_hash(&scene->scene, &hash) == GJK_OK);
  return hash;
}

static const gjk_report *report_of(uint32_t a, uint16_t i, uint32_t b, uint16_t k) {
  for (uint32_t n = 0; n < s[0].reports; n++) {
    const gjk_report *r = &s[0].report[n];
    if (r->event != GJK_EVENT_IMPACT && r->event != GJK_EVENT_END && r->a.slot == a && r->b.slot == b &&
        r->part_a == i && r->part_b == k) {
      return r;
    }
  }
  return NULL;
}

static bool is_awake(const game_body *b) {
  return b->setup.kind != GJK_BODY_STATIC && !b->asleep;
}

// A pair that is near may be left out: it rests, has a sensor, or its query decided by 2 LSB less than its boxes.
static void check_left_out(uint32_t a, uint32_t b, const concave_solid *p, const concave_solid *q) {
  const bool awake = is_awake(&m.body[a]) || is_awake(&m.body[b]);
  const bool sensor = m.body[a].setup.detail == GJK_DETAIL_SENSOR || m.body[b].setup.detail == GJK_DETAIL_SENSOR;
  gjk_distance_result gap;
  CHECK_MSG(!awake || sensor || solid_distance(p, q, &gap) != GJK_OK || gap.distance > p->margin + q->margin - 6,
            "bodies %u and %u, shapes %u and %u: not reported", a, b, p->shape, q->shape);
}

static gjk_q16 least_of(const gjk_manifold *manifold) {
  gjk_q16 least = INT32_MAX;
  for (unsigned i = 0; i < manifold->count; i++) {
    least = manifold->contact[i].distance < least ? manifold->contact[i].distance : least;
  }
  return least;
}

// All manifolds: the first is the report's, and fewer are the first of them.
static gjk_q16 check_manifolds(const gjk_report *r, const concave_solid *p, const concave_solid *q) {
  gjk_manifold all[GJK_PARTS_MANIFOLDS_MAX], some[GJK_PARTS_MANIFOLDS_MAX];
  unsigned count = 0, found = 77;
  const gjk_status status = solid_manifolds(p, q, &m.workspace, all, &count);
  const unsigned capacity = 1 + (r->a.slot + r->b.slot) % GJK_PARTS_MANIFOLDS_MAX;
  memset(some, 0x55, sizeof some);
  CHECK(gjk_scene_manifolds(&s[0].scene, r, 4, some, capacity, &found) == status);
  if (status != GJK_OK && status != GJK_ERROR_CAPACITY) {
    CHECK(r->manifold->count == 0 && found == 77 && some[0].count == 0x55);
    return 0;
  }
  CHECK(found == (count < capacity ? count : capacity));
  for (unsigned i = 0; i < found; i++) {
    CHECK_MSG(same_manifold(&all[i], &some[i]), "manifold %u of %u in room for %u", i, count, capacity);
  }
  tally.manifolds += count;
  tally.lacking += count > 4;
  if (count == 0) {
    CHECK(r->manifold->count == 0);
    return 0;
  }
  CHECK_MSG(same_manifold(&all[0], r->manifold), "shapes %u and %u: the first of %u", p->shape, q->shape, count);
  return least_of(&all[0]);
}

static gjk_q16 distance_of(const concave_solid *p, const concave_solid *q) {
  gjk_distance_result result;
  return solid_distance(p, q, &result) == GJK_OK ? result.distance : result.lower;
}

// Without an answer: a bound that holds for any depth. What of it is no distance is below 0.
static void check_depth(const gjk_report *r, const concave_solid *p, const concave_solid *q) {
  gjk_penetration_result depth;
  depth.intersecting = false;
  const gjk_status status = solid_depth(p, q, &m.workspace, &depth);
  const gjk_q16 distance = distance_of(p, q);
  if (status == GJK_ERROR_ITERATION_LIMIT) {
    CHECK_MSG(distance > 0 ? r->distance == distance : r->distance < 0, "depth without an answer: %d",
              (int)r->distance);
    tally.limited++;
  } else {
    CHECK(r->distance == (depth.intersecting ? -depth.depth : distance));
  }
}

// The report of a pair, by gjk/parts.h alone.
static void check_pair(uint32_t a, uint16_t i, uint32_t b, uint16_t k) {
  concave_solid p, q;
  gjk_decision decision;
  const gjk_report *r = report_of(a, i, b, k);
  solid_set(&m, &s[0], a, i, &p);
  solid_set(&m, &s[0], b, k, &q);
  if (!p.many && !q.many) {
    return;
  }
  const gjk_status status = solid_within(&p, &q, &decision);
  const bool near = (status != GJK_OK || decision.yes) && game_may_meet(&m, a, b);
  CHECK(status == GJK_OK || status == GJK_ERROR_ITERATION_LIMIT);
  tally.pairs++;
  tally.near += near;
  tally.curved += near && (game_is_curved(p.shape) || game_is_curved(q.shape));
  if (r == NULL) {
    if (near) {
      check_left_out(a, b, &p, &q);
    }
    return;
  }
  CHECK_MSG(near, "bodies %u and %u, shapes %u and %u: reported", a, b, p.shape, q.shape);
  if (r->detail == GJK_DETAIL_DEPTH) {
    check_depth(r, &p, &q);
    return;
  }
  const gjk_q16 expected = r->detail == GJK_DETAIL_CONTACTS   ? check_manifolds(r, &p, &q)
                           : r->detail == GJK_DETAIL_DISTANCE ? distance_of(&p, &q)
                                                              : 0;
  CHECK_MSG(r->distance == expected, "bodies %u and %u, shapes %u and %u, detail %u: distance %d, expected %d", a, b,
            p.shape, q.shape, r->detail, (int)r->distance, (int)expected);
}

static void check_pairs(void) {
  for (uint32_t a = 0; a < GAME_BODIES; a++) {
    for (uint32_t b = a + 1; b < GAME_BODIES; b++) {
      for (uint16_t n = 0; m.body[a].there && m.body[b].there && n < 4; n++) {
        if (n / 2 < m.body[a].setup.part_count && n % 2 < m.body[b].setup.part_count) {
          check_pair(a, n / 2, b, n % 2);
        }
      }
    }
  }
}

// An update whose pairs and sweeps are asked in ranges from the last to the first, as threads may.
static gjk_status update_apart(game_scene *scene) {
  uint32_t pairs, sweeps;
  const gjk_status status = gjk_scene_update_begin(&scene->scene, &pairs);
  if (status == GJK_OK) {
    for (uint32_t i = pairs; i > 0; i--) {
      CHECK(gjk_scene_test_pairs(&scene->scene, i - 1, i) == GJK_OK);
    }
    CHECK(gjk_scene_sweep_count(&scene->scene, &sweeps) == GJK_OK);
    for (uint32_t i = sweeps; i > 0; i--) {
      CHECK(gjk_scene_sweep(&scene->scene, i - 1, i) == GJK_OK);
    }
  }
  return status == GJK_OK ? game_update(scene, UINT32_MAX, GAME_REPORTS) : status;
}

// A tick from a copy of the block, at another address: the block is the same to the last bit.
static void check_copy(uint32_t *copy, uint32_t tests, uint32_t room) {
  CHECK(gjk_scene_attach(&s[2].scene, copy, s[0].bytes, m.shapes, GAME_SHAPES, &s[0].scene.bindings) == GJK_OK);
  s[2].scene.bindings.manifolds = s[2].manifold;
  game_play(&m, &s[2]);
  CHECK(game_update(&s[2], tests, room) == GJK_OK);
  compare_reports(&s[0], &s[2], false, "again from a copy");
  CHECK(memcmp(copy, s[0].block, s[0].bytes) == 0);
}

static void check_tick(random_state *random, uint32_t *copy, bool first) {
  const uint32_t tests = 1 + random_below(random, 20), room = 1 + random_below(random, 9);
  if (!first) {
    const gjk_scene_config config = game_config(&m, 400, 0, 0, m.size / 8);
    CHECK(game_start(&m, &config, &s[3]) == GJK_OK);
    game_rebuild(&m, &s[3]);
    CHECK(game_update(&s[3], UINT32_MAX, GAME_REPORTS) == GJK_OK);
  }
  memcpy(copy, s[0].block, s[0].bytes);
  s[2] = s[0];
  game_draw(&m, random, first);
  game_play(&m, &s[0]);
  game_play(&m, &s[1]);
  CHECK(game_update(&s[0], tests, room) == GJK_OK && update_apart(&s[1]) == GJK_OK);
  CHECK(gjk_scene_check(&s[0].scene) == GJK_OK && gjk_scene_check(&s[1].scene) == GJK_OK);
  compare_reports(&s[0], &s[1], false, "every pair anew");
  CHECK(hash_of(&s[0]) == hash_of(&s[1]));
  check_copy(copy, tests, room);
  if (!first) {
    game_play(&m, &s[3]);
    CHECK(game_update(&s[3], UINT32_MAX, GAME_REPORTS) == GJK_OK);
    compare_reports(&s[0], &s[3], true, "built anew");
    game_end(&s[3]);
  }
  check_pairs();
}

static void play(random_state *random) {
  const gjk_scene_config usual = game_config(&m, 400, 0, 0, random_range(random, 0, m.size / 4));
  const gjk_scene_config anew = game_config(&m, 900, 7, 1, 0);
  CHECK(game_start(&m, &usual, &s[0]) == GJK_OK && game_start(&m, &anew, &s[1]) == GJK_OK);
  uint32_t *copy = malloc(s[0].bytes);
  for (unsigned t = 0; t < TICKS; t++) {
    check_tick(random, copy, t == 0);
  }
  free(copy);
  game_end(&s[0]);
  game_end(&s[1]);
}

// Room for `pairs` pairs: two scenes of other box margins and histories come as far, and what fails changes nothing. Whether
// there was room.
static bool has_room(uint32_t pairs) {
  gjk_status status[2];
  for (unsigned k = 0; k < 2; k++) {
    const gjk_scene_config config = game_config(&m, pairs, 0, 0, k == 0 ? 0 : m.size);
    CHECK(game_start(&m, &config, &s[k]) == GJK_OK);
    game_rebuild(&m, &s[k]);
    for (uint32_t i = 0; i < GAME_BODIES && k == 1; i++) {  // away and back
      gjk_pose away = m.body[i].setup.pose;
      away.position.y -= m.size / 3;
      if (m.body[i].there && !m.body[i].asleep && m.body[i].motion == GJK_MOTION_NOT_KEPT) {
        CHECK(gjk_scene_move(&s[k].scene, s[k].id[i], &away) == GJK_OK);
        CHECK(gjk_scene_move(&s[k].scene, s[k].id[i], &m.body[i].setup.pose) == GJK_OK);
      }
    }
    const uint64_t before = hash_of(&s[k]);
    status[k] = game_update(&s[k], UINT32_MAX, GAME_REPORTS);
    CHECK(status[k] == GJK_OK || (status[k] == GJK_ERROR_CAPACITY && hash_of(&s[k]) == before));
    CHECK(gjk_scene_check(&s[k].scene) == GJK_OK);
  }
  CHECK_MSG(status[0] == status[1], "%u pairs: %d and %d", pairs, (int)status[0], (int)status[1]);
  if (status[0] == GJK_OK) {
    compare_reports(&s[0], &s[1], false, "in little room");
    CHECK(hash_of(&s[0]) == hash_of(&s[1]));
  }
  game_end(&s[0]);
  game_end(&s[1]);
  return status[0] == GJK_OK;
}

// From room for one pair to enough: once there is enough, more is too.
static void check_ladder(random_state *random) {
  bool enough = false;
  game_draw(&m, random, true);
  for (uint32_t pairs = 1; pairs < 90; pairs += 1 + random_below(random, 5)) {
    const bool fits = has_room(pairs);
    CHECK(fits || !enough);
    enough = fits;
    tally.fits += fits;
    tally.full += !fits;
    pairs += fits ? 40 : 0;
  }
}

// All bodies in one place: pairs with more normals than are kept.
static void check_crowd(random_state *random) {
  game_draw(&m, random, true);
  for (unsigned i = 0; i < m.moves; i++) {
    gjk_body_setup *setup = &m.move[i].setup;
    const gjk_vec3 off = random_vector(random, 1.0 * m.size);
    setup->pose.position = (gjk_vec3){m.middle.x + off.x, m.middle.y + off.y, m.middle.z + off.z};
    setup->pose.rotation = random_rotation(random);
    setup->kind = GJK_BODY_KINEMATIC;
    setup->detail = GJK_DETAIL_CONTACTS;
    m.body[i].setup = *setup;
  }
  const gjk_scene_config config = game_config(&m, 400, 0, 0, 0);
  CHECK(game_start(&m, &config, &s[0]) == GJK_OK);
  game_play(&m, &s[0]);
  CHECK(game_update(&s[0], UINT32_MAX, GAME_REPORTS) == GJK_OK);
  check_pairs();
  game_end(&s[0]);
}

// Plays games of the numbers from first on.
static void each_game(uint64_t seed, unsigned long first, unsigned long count, void (*check)(random_state *random)) {
  for (unsigned long i = first; i < first + count; i++) {
    random_state random = random_seed(seed + i);
    check_trial(i, NULL, NULL);
    game_make(&m, &random);
    check(&random);
    game_free(&m);
  }
}

int main(void) {
  const uint64_t seed = check_seed(SEED);
  each_game(seed, 0, check_trials_least(TRIALS, 2), play);
  each_game(seed, 1000, check_trials(LADDERS), check_ladder);
  each_game(seed, 2000, check_trials(CROWDS), check_crowd);
  printf(
      "%lu pairs, %lu near, %lu of them curved, %lu manifolds, %lu pairs with more than 4, %lu depths without an "
      "answer, "
      "%lu impacts; room for pairs: %lu enough, %lu not\n",
      tally.pairs, tally.near, tally.curved, tally.manifolds, tally.lacking, tally.limited, tally.impacts / 3,
      tally.fits, tally.full);
  CHECK(tally.near > tally.pairs / 40 && tally.near < tally.pairs / 2 && tally.curved > tally.near / 16);
  CHECK(GJK_ITERATIONS_MAX > 3 || tally.limited > 0);
  CHECK(!check_is_full() || (tally.lacking > 2 && tally.impacts > 50 && tally.fits > 2 && tally.full > 10));
  return check_done("concave_hostile");
}
