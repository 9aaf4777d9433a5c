// Fast bodies, rays, casts and distances among concave bodies, by a look at every part: the first of all is answered, and
// nothing passes through anything.
#include <string.h>

#include "check.h"
#include "reference/random_shape.h"
#include "scene/concave_solid.h"

#define SEED UINT64_C(0x57617973)
#define TRIALS 20
#define TICKS 6
#define SAMPLES 12
#define QUESTIONS 12

static struct { unsigned long impacts, none, arcs, samples, hits, misses, places; } tally;

static game m;
static game_scene s;

// Where bodies were at the last update, and which parts were near then.
static gjk_pose last[GAME_BODIES];
static gjk_report before[GAME_REPORTS];
static uint32_t befores;

static void note_before(void) {
  uint32_t cursor = 0;
  bool found;
  befores = 0;
  do {  // ends: the cursor reaches the end of the pairs
    CHECK(gjk_scene_next_near(&s.scene, &cursor, &before[befores], &found) == GJK_OK);
    befores += found && before[befores].event == GJK_EVENT_PERSIST;
  } while (found && befores < GAME_REPORTS - 1);
  for (unsigned n = 0; n < m.moves; n++) {
    const game_move *move = &m.move[n];
    if (move->starts) {
      last[move->slot] = move->from;
    }
  }
}

static bool were_near(uint32_t a, uint16_t i, uint32_t b, uint16_t k) {
  for (uint32_t n = 0; n < befores; n++) {
    const gjk_report *r = &before[n];
    if ((r->a.slot == a && r->part_a == i && r->b.slot == b && r->part_b == k) ||
        (r->a.slot == b && r->part_a == k && r->b.slot == a && r->part_b == i)) {
      return true;
    }
  }
  return false;
}

static const gjk_pose *start_of(uint32_t slot) {
  return m.body[slot].motion != GJK_MOTION_NOT_KEPT ? &last[slot] : &m.body[slot].setup.pose;
}

static const gjk_report *impact_of(uint32_t fast) {
  for (uint32_t n = 0; n < s.reports; n++) {
    if (s.report[n].event == GJK_EVENT_IMPACT && s.report[n].a.slot == fast) {
      return &s.report[n];
    }
  }
  return NULL;
}

// A part of a fast body and one of another.
typedef struct pair_on_way {
  uint32_t slot[2];
  uint16_t part[2];
  concave_traveller on[2];
} pair_on_way;

// Before the impact that is reported, or on all of the way, parts that were apart at the start share no point.
static void check_apart(const pair_on_way *p, const gjk_report *reported) {
  const gjk_motion a = {*start_of(p->slot[0]), m.body[p->slot[0]].setup.pose, {0, 0, 0}};
  const gjk_motion b = {*start_of(p->slot[1]), m.body[p->slot[1]].setup.pose, {0, 0, 0}};
  const gjk_q30 end = reported != NULL ? reported->fraction : GJK_Q30_ONE;
  bool together =
      traveller_together(&m, &p->on[0], &a, p->slot[0], p->part[0], &p->on[1], &b, p->slot[1], p->part[1], 0);
  for (int n = 1; n <= SAMPLES && !together; n++) {
    const gjk_q30 x = (gjk_q30)((int64_t)end * n / SAMPLES);
    const bool at_end = n == SAMPLES && reported != NULL;
    CHECK_MSG(at_end || !traveller_together(&m, &p->on[0], &a, p->slot[0], p->part[0], &p->on[1], &b, p->slot[1],
                                            p->part[1], x),
              "bodies %u and %u together at %d, before %d", p->slot[0], p->slot[1], (int)x, (int)end);
    tally.samples++;
  }
}

// Where a pair first meets. False: it runs along an arc, or has no answer.
static bool meet(const pair_on_way *p, concave_meeting *found) {
  const concave_traveller *a = &p->on[p->slot[0] < p->slot[1] ? 0 : 1], *b = &p->on[p->slot[0] < p->slot[1] ? 1 : 0];
  gjk_status status = GJK_OK;
  found->hit = false;
  if (a->arcs || b->arcs) {
    tally.arcs++;
    return false;
  }
  status = traveller_meet(a, b, false, found);
  if (status == GJK_OK && found->hit && found->at_start && were_near(p->slot[0], p->part[0], p->slot[1], p->part[1])) {
    found->hit = false;
    if (a->at.many || b->at.many) {
      status = traveller_meet(a, b, true, found);
    }
  }
  return status == GJK_OK;
}

static bool set_pair(uint32_t fast, uint32_t slot, uint16_t i, uint16_t k, pair_on_way *p) {
  if (i >= m.body[fast].setup.part_count || k >= m.body[slot].setup.part_count) {
    return false;
  }
  p->slot[0] = fast;
  p->slot[1] = slot;
  p->part[0] = i;
  p->part[1] = k;
  traveller_set(&m, &s, fast, i, start_of(fast), &p->on[0]);
  traveller_set(&m, &s, slot, k, start_of(slot), &p->on[1]);
  return p->on[0].moves || (p->on[1].moves && !m.body[fast].asleep);
}

// The impact of a fast body. Equal fractions: the lowest slot, part of it, part of its own.
static void check_impact(uint32_t fast) {
  const gjk_report *reported = impact_of(fast);
  bool any = false, known = true;
  gjk_report first = {0};
  for (uint32_t slot = 0; slot < GAME_BODIES; slot++) {
    const game_body *other = &m.body[slot];
    if (slot == fast || !other->there || !game_may_meet(&m, fast, slot) || other->setup.detail == GJK_DETAIL_SENSOR) {
      continue;
    }
    for (uint16_t n = 0; n < 4; n++) {
      pair_on_way p;
      concave_meeting found;
      if (!set_pair(fast, slot, n % 2, n / 2, &p)) {
        continue;
      }
      check_apart(&p, reported);
      known = meet(&p, &found) && known;
      if (found.hit && (!any || found.fraction < first.fraction)) {
        any = true;
        first.fraction = found.fraction;
        first.b.slot = slot;
        first.part_a = n % 2;
        first.part_b = n / 2;
      }
    }
  }
  if (known) {
    CHECK_MSG(any == (reported != NULL), "body %u: %s, expected %d with %u", fast, any ? "no impact" : "an impact",
              (int)first.fraction, first.b.slot);
    CHECK_MSG(!any || reported == NULL ||
                  (reported->fraction == first.fraction && reported->b.slot == first.b.slot &&
                   reported->part_a == first.part_a && reported->part_b == first.part_b),
              "body %u: at %d with %u, expected %d with %u", fast, reported != NULL ? (int)reported->fraction : -1,
              reported != NULL ? reported->b.slot : 0, (int)first.fraction, first.b.slot);
    tally.impacts += any;
    tally.none += !any;
  }
}

// A question to the parts of a scene: a ray where there is no collider.
typedef struct question {
  gjk_collider c;
  gjk_vec3 from, to;
  gjk_q16 margin;
  bool ray;
} question;

// A place near the middle, at a corner of the grid of ties, or at an end of int32.
static gjk_vec3 draw_place(random_state *random) {
  const gjk_vec3 *at = &m.middle;
  const uint32_t how = random_below(random, 8);
  const gjk_vec3 off = random_vector(random, 6.0 * m.size * random_unit(random));
  const int32_t half = m.size / 2;
  if (how == 0 && at->x == 0) {
    return (gjk_vec3){INT32_MIN, random_range(random, -half, half), random_below(random, 2) != 0 ? INT32_MAX : 0};
  }
  if (how < 4) {
    return (gjk_vec3){at->x + random_range(random, -5, 5) * half, at->y + random_range(random, -5, 5) * half,
                      at->z + random_range(random, -5, 5) * half};
  }
  return (gjk_vec3){at->x + off.x, at->y + off.y, at->z + off.z};
}

static void draw_question(random_state *random, question *q) {
  const unsigned shape = GAME_SHAPES - 1 - random_below(random, GAME_SOLIDS);
  const gjk_pose identity = GJK_POSE_IDENTITY;
  gjk_pose pose = {draw_place(random), random_below(random, 2) != 0 ? identity.rotation : random_rotation(random)};
  q->from = pose.position;
  q->to = draw_place(random);
  q->margin = random_below(random, 2) == 0 ? 0 : random_range(random, 0, m.size / 4);
  q->ray = random_below(random, 2) != 0;
  memset(&q->c, 0, sizeof q->c);
  CHECK(gjk_collider_init(&q->c, m.shapes[shape], NULL, 0) == GJK_OK);
  if (gjk_collider_pose(&q->c, &pose) != GJK_OK) {  // at an end
    pose.position = m.middle;
    q->from = pose.position;
    CHECK(gjk_collider_pose(&q->c, &pose) == GJK_OK);
  }
}

static gjk_status ask_part(const question *q, const concave_solid *of, gjk_cast_result *out) {
  const gjk_cast_path path = {NULL, &q->to, q->margin};
  out->hit = false;
  if (q->ray) {
    return of->many ? gjk_parts_cast_ray(&of->parts, &q->from, &q->to, NULL, out)
                    : gjk_cast_ray(&of->collider, &q->from, &q->to, out);
  }
  return of->many ? gjk_parts_cast(&of->parts, &q->c, &path, NULL, out) : gjk_cast(&of->collider, &q->c, &path, out);
}

// What of a hit does not depend on what is undefined inside.
static bool same_hit(const gjk_cast_result *a, const gjk_cast_result *b) {
  return a->inside == b->inside && a->fraction == b->fraction &&
         (a->inside || (memcmp(&a->point_a, &b->point_a, sizeof a->point_a) == 0 &&
                        memcmp(&a->point_b, &b->point_b, sizeof a->point_b) == 0 &&
                        memcmp(&a->normal, &b->normal, sizeof a->normal) == 0 &&
                        memcmp(&a->rest_b, &b->rest_b, sizeof a->rest_b) == 0));
}

// The nearest part, and those within the margin, by gjk/parts.h.
static void check_places(const question *q) {
  gjk_scene_hit hit, hits[2 * GAME_BODIES];
  gjk_q16 distance, least = 0;
  bool found, any = false;
  uint32_t count, within = 0;
  CHECK(gjk_scene_query_within(&s.scene, &q->c, q->margin, NULL, NULL, hits, 2 * GAME_BODIES, &count) == GJK_OK);
  CHECK(gjk_scene_query_nearest(&s.scene, &q->c, 4 * m.size, NULL, &hit, &distance, &found) == GJK_OK);
  for (uint32_t slot = 0; slot < GAME_BODIES; slot++) {
    for (uint16_t i = 0; m.body[slot].there && i < m.body[slot].setup.part_count; i++) {
      concave_solid of;
      gjk_decision near;
      gjk_distance_result gap;
      solid_set(&m, &s, slot, i, &of);
      CHECK((of.many ? gjk_parts_distance(&of.parts, &q->c, NULL, &gap)
                     : gjk_distance(&q->c, &of.collider, NULL, &gap)) == GJK_OK);
      CHECK((of.many ? gjk_parts_within(&of.parts, &q->c, q->margin, NULL, &near)
                     : gjk_within(&q->c, &of.collider, q->margin, NULL, &near)) == GJK_OK);
      CHECK_MSG(!found || gap.distance >= distance, "shape %u nearer: %d, %d", of.shape, (int)gap.distance,
                (int)distance);
      any = any || gap.distance <= 4 * m.size;
      least = found && slot == hit.body.slot && i == hit.part ? gap.distance : least;
      within += near.yes;
      bool listed = false;
      for (uint32_t n = 0; n < count; n++) {
        listed = listed || (hits[n].body.slot == slot && hits[n].part == i);
      }
      // By 2 LSB a curved one may be within, and its box not.
      CHECK(listed == near.yes || (near.yes && gap.distance > q->margin - 6));
    }
  }
  CHECK(any == found && (!found || least == distance) && count <= within);
  tally.places += count;
}

static void check_question(random_state *random) {
  question q;
  gjk_scene_hit hit, first = {0};
  gjk_cast_result result, best = {0}, trial;
  bool found, any = false;
  draw_question(random, &q);
  const gjk_status status = q.ray ? gjk_scene_cast_ray(&s.scene, &q.from, &q.to, NULL, &hit, &result, &found)
                                  : gjk_scene_cast(&s.scene, &q.c, &q.to, q.margin, NULL, &hit, &result, &found);
  if (status == GJK_ERROR_RANGE) {  // the centre would leave int32
    return;
  }
  CHECK(status == GJK_OK);
  for (uint32_t slot = 0; slot < GAME_BODIES; slot++) {
    for (uint16_t i = 0; m.body[slot].there && i < m.body[slot].setup.part_count; i++) {
      concave_solid of;
      solid_set(&m, &s, slot, i, &of);
      const gjk_status of_part = ask_part(&q, &of, &trial);
      CHECK_MSG(of_part == GJK_OK, "shape %u: %d", of.shape, (int)of_part);
      if (trial.hit && (!any || trial.fraction < best.fraction)) {
        any = true;
        best = trial;
        first.body.slot = slot;
        first.part = i;
      }
    }
  }
  CHECK_MSG(any == found, "%s: %s", q.ray ? "ray" : "cast", any ? "not found" : "found");
  if (any && found) {
    CHECK_MSG(hit.body.slot == first.body.slot && hit.part == first.part && same_hit(&best, &result),
              "%s: body %u at %d, expected %u at %d", q.ray ? "ray" : "cast", hit.body.slot, (int)result.fraction,
              first.body.slot, (int)best.fraction);
  }
  tally.hits += any;
  tally.misses += !any;
  check_places(&q);
}

static void check_game(random_state *random) {
  const gjk_scene_config config = game_config(&m, 400, 0, 0, m.size / 8);
  CHECK(game_start(&m, &config, &s) == GJK_OK);
  for (unsigned t = 0; t < TICKS; t++) {
    game_draw(&m, random, t == 0);
    game_play(&m, &s);
    note_before();
    CHECK(game_update(&s, UINT32_MAX, GAME_REPORTS) == GJK_OK);
    for (uint32_t i = 0; i < GAME_BODIES; i++) {
      if (m.body[i].there && m.body[i].motion == GJK_MOTION_FAST) {
        check_impact(i);
      }
    }
    for (uint32_t i = 0; i < GAME_BODIES; i++) {
      last[i] = m.body[i].setup.pose;
    }
    for (unsigned n = 0; n < QUESTIONS; n++) {
      check_question(random);
    }
  }
  game_end(&s);
}

int main(void) {
  const uint64_t seed = check_seed(SEED);
  for (unsigned long i = 0; i < check_trials(TRIALS); i++) {
    random_state random = random_seed(seed + i);
    check_trial(i, NULL, NULL);
    game_make(&m, &random);
    check_game(&random);
    game_free(&m);
  }
  printf(
      "%lu impacts, %lu ways without, %lu arcs, %lu places on ways; %lu rays and casts hit, %lu miss, %lu parts "
      "within\n",
      tally.impacts, tally.none, tally.arcs, tally.samples, tally.hits, tally.misses, tally.places);
  CHECK(!check_is_full() || (tally.hits > 300 && tally.misses > 100 && tally.places > 300));
  CHECK(!check_is_full() || (tally.impacts > 40 && tally.none > 40 && tally.arcs > 20));
  return check_done("concave_ways");
}
