// Ground in scenes of the plane: what is reported is what its own queries answer, whatever the skips, slices and copies;
// bodies slide, roll and fly over a thousand joints without a bump, land on platforms from above alone, and pass through
// nothing however fast they are.
#include "gjk2/ground.h"

#include "gjk2/impact.h"
#include "gjk2/probe.h"
#include "gjk2/slide.h"
#include "placed2.h"
#include "plane.h"

#define SEED 2312
#define SCENES check_trials_least(120, 12)
#define UPDATES 8
#define MOVERS 8
#define GROUNDS 3
#define REPORTS 64
#define FOUND 64

static struct {
  unsigned long near, begun, ended, contacts, deep, casts, hits, rays, nearest, impacts, misses, slides, ticks, faces,
      turning;
} tally;

static const gjk2_tile forms[] = {GJK2_TILE(0, 0), GJK2_TILE(4, 4),         GJK2_TILE(2, 2), GJK2_TILE(0, 4),
                                  GJK2_TILE(4, 0), GJK2_TILE(0, 2),         GJK2_TILE(2, 4), GJK2_TILE(4, 2),
                                  GJK2_TILE(2, 0), GJK2_TILE_ONE_WAY(4, 4), GJK2_TILE(0, 1), GJK2_TILE(1, 2),
                                  GJK2_TILE(2, 3), GJK2_TILE(3, 4)};
enum { FORMS = sizeof forms / sizeof forms[0] };

// Three grounds at random and movers over them.
#define COLUMNS 24
#define ROWS 8
#define VERTICES 60

static uint8_t cells[COLUMNS * ROWS];
static gjk2_tiles grid = {cells, COLUMNS, ROWS, 0, FORMS, forms};
static gjk2_vec vertices[VERTICES];
static gjk2_index_box boxes[GJK2_INDEX_BOXES(VERTICES)];
static gjk2_index chain_index;
static gjk2_polyline polyline = {vertices, VERTICES, &chain_index};
static int16_t heights[VERTICES];
static gjk2_heights profile = {heights, VERTICES, 0, 2};
static gjk2_ground ground[GROUNDS];
static gjk2_shape ground_shape[GROUNDS];
static plane_body mover[MOVERS];
static const gjk2_shape *shapes[GROUNDS + MOVERS];

static void make_grounds(random_state *r, int32_t size) {
  polyline.index = NULL;
  for (int i = 0; i < VERTICES; i++) {
    vertices[i].x = (VERTICES / 2 - i) * size + random_range(r, -size / 3, size / 3);
    vertices[i].y = random_range(r, -size, size);
    heights[i] = (int16_t)random_range(r, -size / 8, size / 8);
  }
  CHECK(gjk2_index_build(&polyline, boxes, sizeof boxes / sizeof boxes[0], &chain_index) == GJK_OK);
  polyline.index = &chain_index;
  profile.width = size;
  grid.size = size / 4 * 4;
  for (unsigned i = 0; i < COLUMNS * ROWS; i++) {
    cells[i] = (uint8_t)(random_below(r, 2) == 0 ? 0 : random_below(r, FORMS));
  }
  CHECK(gjk2_ground_of_chain(&polyline, &ground[0], &ground_shape[0]) == GJK_OK);
  CHECK(gjk2_ground_of_heights(&profile, &ground[1], &ground_shape[1]) == GJK_OK);
  CHECK(gjk2_ground_of_tiles(&grid, &ground[2], &ground_shape[2]) == GJK_OK);
}

typedef struct stage {
  uint32_t block[12000];
  gjk2_scene scene;
  gjk2_manifold manifolds[REPORTS];
  gjk2_report reports[REPORTS];
  uint32_t count;
  gjk_body_id ground[GROUNDS], mover[MOVERS];
} stage;

static stage whole, retested, sliced, copied;

static gjk2_scene_bindings bindings_of(stage *s) {
  return (gjk2_scene_bindings){
      .details = &gjk2_scene_contacts, .manifolds = s->manifolds, .motion = &gjk2_scene_motion};
}

static gjk2_pose any_pose(random_state *r, int32_t spread) {
  gjk2_pose pose;
  pose.rotation = plane_random_rotation(r);
  pose.position = plane_random_vec(r, spread);
  return pose;
}

static gjk2_pose pose_of_ground[GROUNDS], pose_of_mover[MOVERS];
static bool grounds_last;  // in slots after those of the movers: then they are the second of their pairs

static bool is_ground(uint32_t slot) {
  return grounds_last ? slot >= MOVERS : slot < GROUNDS;
}

static void build(stage *s, uint8_t detail, gjk_q16 margin, bool retest) {
  const gjk2_scene_config config = {.bodies = GROUNDS + MOVERS,
                                    .parts = GROUNDS + MOVERS,
                                    .own_poses = GROUNDS,
                                    .pairs = 200,
                                    .box_margin = retest ? 0 : 2000,
                                    .detail = detail,
                                    .persist = 1,
                                    .retest_all = retest,
                                    .motions = MOVERS};
  const gjk2_scene_bindings bindings = bindings_of(s);
  CHECK(gjk2_scene_bytes(&config) <= sizeof s->block);
  CHECK(gjk2_scene_init(&s->scene, &config, s->block, sizeof s->block, shapes, GROUNDS + MOVERS, &bindings) == GJK_OK);
  for (uint16_t i = 0; i < GROUNDS + MOVERS; i++) {
    const bool stands = i < GROUNDS;
    const uint16_t slot = (uint16_t)((i + (grounds_last ? MOVERS : 0)) % (GROUNDS + MOVERS));
    const gjk2_part part = {i, false, GJK2_POSE_IDENTITY};
    const gjk2_body_setup setup = {stands ? pose_of_ground[i] : pose_of_mover[i - GROUNDS],
                                   &part,
                                   1,
                                   stands ? (i == 0 ? GJK_BODY_STATIC : GJK_BODY_KINEMATIC) : GJK_BODY_DYNAMIC,
                                   0,
                                   1,
                                   1,
                                   i,
                                   margin};
    CHECK(gjk2_scene_add_at(&s->scene, slot, &setup, stands ? &s->ground[i] : &s->mover[i - GROUNDS]) == GJK_OK);
  }
  for (unsigned i = 0; i < 3; i++) {
    CHECK(gjk2_scene_set_motion(&s->scene, s->mover[i], GJK_MOTION_FAST) == GJK_OK);
  }
}

static void update(stage *s, uint32_t tests) {
  gjk_progress progress;
  s->count = 0;
  do {
    const gjk_status status =
        tests == 0 ? gjk2_scene_update(&s->scene, s->reports, REPORTS, &progress)
                   : gjk2_scene_update_slice(&s->scene, tests, &s->reports[s->count], REPORTS - s->count, &progress);
    CHECK(status == GJK_OK);
    s->count += progress.reports;
    CHECK(s->count < REPORTS);
  } while (progress.pairs_left + progress.reports_left > 0);
}

static bool same_manifold(const gjk2_manifold *a, const gjk2_manifold *b) {
  bool same = a->count == b->count && a->normal.x == b->normal.x && a->normal.y == b->normal.y &&
              a->feature_a == b->feature_a && a->feature_b == b->feature_b;
  for (unsigned i = 0; i < a->count && same; i++) {
    const gjk2_contact *c = &a->contact[i], *d = &b->contact[i];
    same = c->distance == d->distance && c->id == d->id && c->point_a.x == d->point_a.x &&
           c->point_a.y == d->point_a.y && c->point_b.x == d->point_b.x && c->point_b.y == d->point_b.y;
  }
  return same;
}

// manifolds: of both all reports came from one call, so each has its own.
static void compare(const stage *a, const stage *b, bool manifolds) {
  CHECK_MSG(a->count == b->count, "%u and %u reports", a->count, b->count);
  for (unsigned i = 0; i < a->count && i < b->count; i++) {
    const gjk2_report *p = &a->reports[i], *q = &b->reports[i];
    CHECK(p->a.slot == q->a.slot && p->b.slot == q->b.slot && p->event == q->event && p->distance == q->distance &&
          p->fraction == q->fraction);
    CHECK((p->manifold == NULL) == (q->manifold == NULL));
    if (manifolds && p->manifold != NULL && q->manifold != NULL) {
      CHECK_MSG(same_manifold(p->manifold, q->manifold), "%u %u: count %d %d n %d %d feat %d %d - %d %d", p->a.slot,
                p->b.slot, p->manifold->count, q->manifold->count, p->manifold->normal.x, q->manifold->normal.x,
                p->manifold->feature_a, p->manifold->feature_b, q->manifold->feature_a, q->manifold->feature_b);
    }
  }
}

static const gjk2_report *report_of(const stage *s, uint32_t a, uint32_t b) {
  for (unsigned i = 0; i < s->count; i++) {
    const gjk2_report *p = &s->reports[i];
    if (p->a.slot == a && p->b.slot == b && (p->event == GJK_EVENT_BEGIN || p->event == GJK_EVENT_PERSIST)) {
      return p;
    }
  }
  return NULL;
}

// The report's manifold is that of the deepest contact, and leads from the report's a to its b.
static void check_side(const gjk2_manifold *m, const gjk2_chain_contact *deepest) {
  const gjk2_manifold *n = &deepest->manifold;
  const int32_t sign = grounds_last ? -1 : 1;
  CHECK(m->count == n->count && m->normal.x == sign * n->normal.x && m->normal.y == sign * n->normal.y);
  CHECK((grounds_last ? m->feature_b : m->feature_a) == (deepest->segment & UINT16_MAX));
  for (unsigned i = 0; i < m->count && i < n->count; i++) {
    const gjk2_contact *c = &m->contact[i], *d = &n->contact[i];
    const gjk2_vec *of_ground = grounds_last ? &c->point_b : &c->point_a,
                   *of_body = grounds_last ? &c->point_a : &c->point_b;
    CHECK(c->distance == d->distance && of_ground->x == d->point_a.x && of_ground->y == d->point_a.y &&
          of_body->x == d->point_b.x && of_body->y == d->point_b.y);
  }
}

// Each pair of ground and mover against the queries of ground.
static void check_reports(const stage *s, gjk_q16 margin, uint8_t detail) {
  for (uint16_t g = 0; g < GROUNDS; g++) {
    const gjk2_ground *found;
    gjk2_pose pose;
    CHECK(gjk2_scene_ground(&s->scene, s->ground[g], 0, &found, &pose) == GJK_OK && found == &ground[g]);
    for (uint16_t m = 0; m < MOVERS; m++) {
      gjk2_collider c;
      bool yes;
      CHECK(gjk2_scene_collider(&s->scene, s->mover[m], 0, &c) == GJK_OK);
      CHECK(gjk2_ground_within(found, &pose, &c, 2 * margin, &yes) == GJK_OK);
      const gjk2_report *report = grounds_last ? report_of(s, s->mover[m].slot, s->ground[g].slot)
                                               : report_of(s, s->ground[g].slot, s->mover[m].slot);
      CHECK((report != NULL) == yes);
      if (report == NULL) {
        continue;
      }
      gjk2_chain_contact contacts[FOUND];
      gjk2_distance_result distance;
      uint32_t segment;
      uint16_t count = 0;
      gjk_q16 least = INT32_MAX;
      bool any;
      CHECK(gjk2_ground_distance(found, &pose, &c, &distance, &segment, &any) == GJK_OK && any);
      CHECK(gjk2_scene_ground_contacts(&s->scene, report, contacts, FOUND, &count) == GJK_OK);
      unsigned deepest = 0;
      for (unsigned i = 0; i < count; i++) {
        for (unsigned k = 0; k < contacts[i].manifold.count; k++) {
          const gjk_q16 d = contacts[i].manifold.contact[k].distance;
          deepest = d < least ? i : deepest;
          least = d < least ? d : least;
        }
      }
      if (detail == GJK_DETAIL_DISTANCE) {
        CHECK(report->distance == distance.distance);
      } else if (detail == GJK_DETAIL_CONTACTS && count > 0) {
        CHECK(report->distance == least && report->manifold != NULL);
        check_side(report->manifold, &contacts[deepest]);
      } else if (detail == GJK_DETAIL_DEPTH && distance.distance > 0) {
        CHECK(report->distance == distance.distance || report->distance < 0);
      }
      tally.near++;
      tally.contacts += count;
      tally.deep += count > 0 && least < 0;
    }
  }
}

// Rays, casts and the nearest part see the ground as its queries do.
static void check_probes(random_state *r, const stage *s, int32_t spread) {
  const gjk2_pose at = any_pose(r, spread);
  const gjk2_vec to = plane_random_vec(r, spread);
  const gjk2_cast_path path = {NULL, &to, 0};
  gjk_scene_hit hit;
  gjk2_cast_result result, of_ground;
  bool found, expected = false;
  gjk_q30 first = 0;
  const gjk2_collider probe = posed2(&mover[0].shape, &at);
  for (int ray = 0; ray < 2; ray++) {
    expected = false;
    CHECK((ray ? gjk2_scene_cast_ray(&s->scene, &at.position, &to, NULL, &hit, &result, &found)
               : gjk2_scene_cast(&s->scene, &probe, &to, 0, NULL, &hit, &result, &found)) == GJK_OK);
    for (unsigned g = 0; g < GROUNDS; g++) {
      const gjk2_ground *of;
      gjk2_pose pose;
      uint32_t segment;
      CHECK(gjk2_scene_ground(&s->scene, s->ground[g], 0, &of, &pose) == GJK_OK);
      CHECK((ray ? gjk2_ground_cast_ray(of, &pose, &at.position, &to, &of_ground, &segment)
                 : gjk2_ground_cast(of, &pose, &probe, &path, &of_ground, &segment)) == GJK_OK);
      if (of_ground.hit && (!expected || of_ground.fraction < first)) {
        expected = true;
        first = of_ground.fraction;
      }
    }
    CHECK(!expected || (found && result.fraction <= first));
    if (found && is_ground(hit.body.slot)) {
      CHECK(expected && result.fraction == first);
      tally.hits++;
    }
    tally.casts++;
  }
}

// Overlap queries and the nearest part see the ground, too.
static void check_overlaps(random_state *r, const stage *s, int32_t spread) {
  gjk_scene_hit hits[GROUNDS + MOVERS], nearest;
  uint32_t count = 0;
  gjk_q16 distance = 0, least = INT32_MAX;
  bool found;
  const gjk2_pose at = any_pose(r, spread);
  const gjk_q16 reach = random_range(r, 0, spread / 8);
  const gjk2_collider probe = posed2(&mover[1].shape, &at);
  CHECK(gjk2_scene_query_within(&s->scene, &probe, reach, NULL, NULL, hits, GROUNDS + MOVERS, &count) == GJK_OK);
  CHECK(gjk2_scene_query_nearest(&s->scene, &probe, INT32_MAX, NULL, &nearest, &distance, &found) == GJK_OK && found);
  for (unsigned g = 0; g < GROUNDS; g++) {
    const gjk2_ground *of;
    gjk2_distance_result of_ground;
    gjk2_pose pose;
    uint32_t segment;
    bool yes, listed = false, any;
    CHECK(gjk2_scene_ground(&s->scene, s->ground[g], 0, &of, &pose) == GJK_OK);
    CHECK(gjk2_ground_within(of, &pose, &probe, reach, &yes) == GJK_OK);
    CHECK(gjk2_ground_distance(of, &pose, &probe, &of_ground, &segment, &any) == GJK_OK);
    for (unsigned i = 0; i < count; i++) {
      listed = listed || hits[i].body.slot == s->ground[g].slot;
    }
    CHECK(listed == yes);
    least = any && of_ground.distance < least ? of_ground.distance : least;
    tally.nearest += yes;
  }
  CHECK(distance <= least && (!is_ground(nearest.body.slot) || distance == least));
}

static void check_scenes(random_state *random) {
  for (unsigned long i = 0; i < SCENES; i++) {
    check_trial(i, NULL, NULL);
    const int32_t size = random_range(random, 4000, 20000), spread = 10 * size;
    const uint8_t detail = (uint8_t)(GJK_DETAIL_TOUCH + i % 4);
    const gjk_q16 margin = random_below(random, 2) == 0 ? 0 : random_range(random, 0, size / 4);
    grounds_last = random_below(random, 2) == 0;
    make_grounds(random, size);
    for (unsigned g = 0; g < GROUNDS; g++) {
      pose_of_ground[g] = any_pose(random, 3 * size);
      shapes[g] = &ground_shape[g];
    }
    for (unsigned m = 0; m < MOVERS; m++) {
      plane_random_shape(random, size, &mover[m]);
      pose_of_mover[m] = any_pose(random, spread);
      shapes[GROUNDS + m] = &mover[m].shape;
    }
    build(&whole, detail, margin, false);
    build(&retested, detail, margin, true);
    build(&sliced, detail, margin, false);
    for (int tick = 0; tick < UPDATES; tick++) {
      update(&whole, 0);
      update(&retested, 0);
      update(&sliced, 1 + random_below(random, 3));
      compare(&whole, &retested, true);
      compare(&whole, &sliced, false);
      if (tick > UPDATES / 2) {
        update(&copied, 0);
        compare(&whole, &copied, true);
      }
      check_reports(&whole, margin, detail);
      check_probes(random, &whole, spread);
      check_overlaps(random, &whole, spread);
      for (unsigned k = 0; k < whole.count; k++) {
        tally.begun += whole.reports[k].event == GJK_EVENT_BEGIN;
        tally.ended += whole.reports[k].event == GJK_EVENT_END;
        tally.impacts += whole.reports[k].event == GJK_EVENT_IMPACT;
      }
      CHECK(gjk2_scene_check(&whole.scene) == GJK_OK);
      if (tick == UPDATES / 2) {  // a copy goes on beside
        const gjk2_scene_bindings bindings = bindings_of(&copied);
        CHECK(gjk2_scene_seal(&whole.scene) == GJK_OK);
        memcpy(copied.block, whole.block, sizeof copied.block);
        CHECK(gjk2_scene_open(&copied.scene, copied.block, sizeof copied.block, shapes, GROUNDS + MOVERS, &bindings) ==
              GJK_OK);
      }
      stage *const all[] = {&whole, &retested, &sliced, &copied};
      const unsigned stages = tick >= UPDATES / 2 ? 4 : 3;
      for (unsigned m = 0; m < MOVERS + 1; m++) {
        const bool is_ground = m == MOVERS;  // one of them moves and turns as well
        gjk2_pose *pose = is_ground ? &pose_of_ground[1] : &pose_of_mover[m];
        gjk2_rotation turn;
        if (random_below(random, 4) == 0) {
          continue;
        }
        CHECK(gjk2_rotation_from_angle(random_below(random, 2) == 0 ? 0 : random_range(random, -20000, 20000), &turn) ==
              GJK_OK);
        (void)gjk2_rotation_compose(&pose->rotation, &turn, &pose->rotation);
        const int32_t way = random_below(random, 4) == 0 ? spread : size;
        pose->position.x += random_range(random, -way, way) / 2;
        pose->position.y += random_range(random, -way, way) / 2;
        for (unsigned k = 0; k < stages; k++) {
          CHECK(gjk2_scene_move(&all[k]->scene, is_ground ? whole.ground[1] : whole.mover[m], pose) == GJK_OK);
        }
      }
      if (random_below(random, 3) == 0) {  // a cell changes
        cells[random_below(random, COLUMNS * ROWS)] = (uint8_t)random_below(random, FORMS);
        for (unsigned k = 0; k < stages; k++) {
          CHECK(gjk2_scene_refilter(&all[k]->scene, whole.ground[2]) == GJK_OK);
        }
      }
    }
  }
}

// A level of one row of tiles, and a body over it.
#define LENGTH 1200

static uint8_t level_cells[4 * LENGTH];
static gjk2_tiles level = {level_cells, LENGTH, 4, GJK_Q16(1), FORMS, forms};
static gjk2_ground level_ground;
static gjk2_shape level_shape;
static const gjk2_shape *level_shapes[2];

static void set_level(stage *s, const gjk2_shape *rider, gjk2_pose *at, bool fast) {
  const gjk2_scene_config config = {.bodies = 2,
                                    .parts = 2,
                                    .own_poses = 0,
                                    .pairs = 4,
                                    .box_margin = 4000,
                                    .detail = GJK_DETAIL_CONTACTS,
                                    .persist = 1,
                                    .motions = 1};
  const gjk2_scene_bindings bindings = bindings_of(s);
  const gjk2_part parts[2] = {{0, false, GJK2_POSE_IDENTITY}, {1, false, GJK2_POSE_IDENTITY}};
  const gjk2_body_setup floor = {GJK2_POSE_IDENTITY, &parts[0], 1, GJK_BODY_STATIC, 0, 1, 1, 0, 0};
  const gjk2_body_setup body = {*at, &parts[1], 1, GJK_BODY_DYNAMIC, 0, 1, 1, 0, 0};
  CHECK(gjk2_ground_of_tiles(&level, &level_ground, &level_shape) == GJK_OK);
  level_shapes[0] = &level_shape;
  level_shapes[1] = rider;
  CHECK(gjk2_scene_init(&s->scene, &config, s->block, sizeof s->block, level_shapes, 2, &bindings) == GJK_OK);
  CHECK(gjk2_scene_add(&s->scene, &floor, &s->ground[0]) == GJK_OK);
  CHECK(gjk2_scene_add(&s->scene, &body, &s->mover[0]) == GJK_OK);
  if (fast) {
    CHECK(gjk2_scene_set_motion(&s->scene, s->mover[0], GJK_MOTION_FAST) == GJK_OK);
  }
}

static const gjk2_shape riders[] = {GJK2_BOX(GJK_Q16(0.4), GJK_Q16(0.3)), GJK2_CIRCLE(GJK_Q16(0.3)),
                                    GJK2_ROUNDED_BOX(GJK_Q16(0.3), GJK_Q16(0.2), GJK_Q16(0.1)),
                                    GJK2_BOX(GJK_Q16(1.7), GJK_Q16(0.3))};
enum { RIDERS = sizeof riders / sizeof riders[0] };

// A flat floor of a thousand tiles of any forms that are full above, in both directions, at speeds from an LSB to 20 tiles
// a tick: contacts have the floor's normal alone, the slide is never stopped, and a fast body meets nothing.
static void ride_flat(random_state *r, bool one_way) {
  const gjk2_slide_setup setup = {{0, GJK_Q30_ONE}, GJK_Q30_ONE / 2, 64, 0, GJK_Q16(0.1), false, NULL};
  memset(level_cells, 0, sizeof level_cells);
  for (int x = 0; x < LENGTH; x++) {
    level_cells[x] = 1;
    level_cells[LENGTH + x] = one_way ? 9 : 1;
  }
  for (unsigned rider = 0; rider < RIDERS; rider++) {
    for (int direction = -1; direction <= 1; direction += 2) {
      static const int32_t speeds[] = {1, 77, 5000, GJK_Q16(1), GJK_Q16(1.37), GJK_Q16(20)};
      for (unsigned k = 0; k < sizeof speeds / sizeof speeds[0]; k++) {
        const int32_t start = direction > 0 ? GJK_Q16(3) : GJK_Q16(LENGTH - 3);
        const int32_t sunk = (int32_t)random_below(r, 3) * 40;
        gjk2_pose at = GJK2_POSE_IDENTITY;
        at.position.x = start + random_range(r, 0, 60000);
        at.position.y = GJK_Q16(2.3) - sunk;
        set_level(&whole, &riders[rider], &at, true);
        for (int tick = 0; tick < 400; tick++) {
          update(&whole, 0);
          CHECK(whole.count == 1 || tick == 0);
          for (unsigned i = 0; i < whole.count; i++) {
            const gjk2_report *report = &whole.reports[i];
            gjk2_chain_contact found[FOUND];
            uint16_t count = 0;
            CHECK_MSG(report->event != GJK_EVENT_IMPACT && report->event != GJK_EVENT_END,
                      "event %d rider %u speed %d sunk %d tick %d", report->event, rider, speeds[k] * direction, sunk,
                      tick);
            CHECK(gjk2_scene_ground_contacts(&whole.scene, report, found, FOUND, &count) == GJK_OK && count > 0);
            for (unsigned n = 0; n < count; n++) {
              CHECK_MSG(found[n].manifold.normal.x == 0 && found[n].manifold.normal.y == GJK_Q30_ONE,
                        "rider %u at %d sunk %d, %d of %d: n %d", rider, at.position.x, sunk, n, count,
                        found[n].manifold.normal.x);
              CHECK(found[n].manifold.contact[0].distance == -sunk);
            }
            tally.faces += count;
          }
          at.position.x += direction * speeds[k];
          if (at.position.x < GJK_Q16(2) || at.position.x > GJK_Q16(LENGTH - 2)) {
            break;
          }
          CHECK(gjk2_scene_move(&whole.scene, whole.mover[0], &at) == GJK_OK);
          tally.ticks++;
        }
        // A slide, over the floor alone.
        CHECK(gjk2_scene_remove(&whole.scene, whole.mover[0]) == GJK_OK);
        at.position.x = start;
        at.position.y = GJK_Q16(2.3) + 64 + 10;
        gjk2_collider c = posed2(&riders[rider], &at);
        for (int tick = 0; tick < 200; tick++) {
          gjk2_slide_result slid;
          const gjk2_vec to = {c.position.x + direction * speeds[k], c.position.y - (tick % 2)};
          if (to.x < GJK_Q16(2) || to.x > GJK_Q16(LENGTH - 2)) {
            break;
          }
          CHECK(gjk2_slide(&whole.scene, &c, &to, &setup, &slid) == GJK_OK);
          CHECK_MSG(!slid.stuck && abs(slid.position.x - to.x) <= 4 &&
                        slid.on_ground,  // where a rounded cast rests, x is rounded
                    "rider %u: %d of %d", rider, slid.position.x - c.position.x, to.x - c.position.x);
          CHECK(slid.position.y >= GJK_Q16(2.3) + 60 && slid.position.y <= GJK_Q16(2.3) + 80);
          CHECK(gjk2_collider_move(&c, &slid.position) == GJK_OK);
          tally.slides++;
        }
      }
    }
  }
}

// Hills of all slopes: each normal is that of a surface, or lies between those of a convex joint; the slide climbs at its
// speed and stays at the surface.
static void ride_hills(random_state *r) {
  static const uint8_t up[][4] = {{3, 0, 0, 0}, {5, 6, 0, 0}, {10, 11, 12, 13}}, down[][2] = {{4, 0}, {7, 8}};
  static const unsigned ups[] = {1, 2, 4}, downs[] = {1, 2};
  const gjk2_slide_setup setup = {{0, GJK_Q30_ONE}, GJK_Q30_ONE / 2, 64, 0, GJK_Q16(0.2), true, NULL};
  int column = 0;
  memset(level_cells, 0, sizeof level_cells);
  while (column < LENGTH - 20) {
    const unsigned kind = random_below(r, 3), way = random_below(r, 2), flat = random_below(r, 3);
    for (unsigned i = 0; i < flat; i++) {
      level_cells[column++] = 1;
    }
    for (unsigned i = 0; i < ups[kind]; i++, column++) {
      level_cells[column] = 1;
      level_cells[LENGTH + column] = up[kind][i];
    }
    for (unsigned i = 0; i < flat; i++, column++) {
      level_cells[column] = level_cells[LENGTH + column] = 1;
    }
    for (unsigned i = 0; i < downs[way]; i++, column++) {
      level_cells[column] = 1;
      level_cells[LENGTH + column] = down[way][i];
    }
  }
  for (unsigned rider = 0; rider < 2; rider++) {
    gjk2_pose at = GJK2_POSE_IDENTITY;
    unsigned moved = 0;
    at.position.x = GJK_Q16(1);
    at.position.y = GJK_Q16(2.6);
    set_level(&whole, &riders[rider], &at, false);
    CHECK(gjk2_scene_remove(&whole.scene, whole.mover[0]) == GJK_OK);
    gjk2_collider c = posed2(&riders[1], &at);
    const int32_t speed = random_range(r, 3000, 30000);
    while (c.position.x < GJK_Q16(LENGTH - 30) && moved < 30000) {
      gjk2_slide_result slid;
      bool inside;
      const gjk2_vec to = {c.position.x + speed, c.position.y};
      CHECK(gjk2_slide(&whole.scene, &c, &to, &setup, &slid) == GJK_OK && !slid.stuck);
      CHECK_MSG(slid.position.x > c.position.x, "at %d", c.position.x);
      for (unsigned i = 0; i < slid.count; i++) {
        CHECK(slid.plane[i].normal.y > GJK_Q30_ONE / 2);
      }
      CHECK(gjk2_collider_move(&c, &slid.position) == GJK_OK);
      const gjk2_pose identity = GJK2_POSE_IDENTITY;
      CHECK(gjk2_ground_within(&level_ground, &identity, &c, 0, &inside) == GJK_OK && !inside);
      moved++;
      tally.slides++;
    }
    CHECK(moved < 30000);
  }
}

// Platforms let through from below, and carry from above.
static void jump_through(void) {
  gjk2_pose at = GJK2_POSE_IDENTITY;
  gjk2_cast_result hit;
  gjk_scene_hit part;
  bool found;
  memset(level_cells, 0, sizeof level_cells);
  for (int x = 10; x < 20; x++) {
    level_cells[LENGTH + x] = 9;  // its surface is at 2
  }
  at.position.x = GJK_Q16(15);
  at.position.y = GJK_Q16(0.5);
  set_level(&whole, &riders[0], &at, true);
  gjk2_collider c = posed2(&riders[0], &at);
  CHECK(gjk2_scene_remove(&whole.scene, whole.mover[0]) == GJK_OK);
  const gjk2_vec top = {GJK_Q16(15), GJK_Q16(4)};
  CHECK(gjk2_scene_cast(&whole.scene, &c, &top, 0, NULL, &part, &hit, &found) == GJK_OK && !found);
  CHECK(gjk2_scene_cast_ray(&whole.scene, &c.position, &top, NULL, &part, &hit, &found) == GJK_OK && !found);
  const gjk2_vec bottom = c.position;
  CHECK(gjk2_collider_move(&c, &top) == GJK_OK);
  CHECK(gjk2_scene_cast(&whole.scene, &c, &bottom, 0, NULL, &part, &hit, &found) == GJK_OK && found);
  CHECK(hit.rest_b.y == GJK_Q16(2.3) && hit.normal.y == GJK_Q30_ONE);
  CHECK(gjk2_scene_cast_ray(&whole.scene, &top, &bottom, NULL, &part, &hit, &found) == GJK_OK && found);
  CHECK(hit.point_a.y == GJK_Q16(2));
  // What falls past its open end, an LSB away, meets nothing.
  const gjk2_vec beside = {GJK_Q16(20.4) + 1, GJK_Q16(4)}, under = {GJK_Q16(20.4) + 1, GJK_Q16(0.5)};
  CHECK(gjk2_collider_move(&c, &beside) == GJK_OK);
  CHECK(gjk2_scene_cast(&whole.scene, &c, &under, 0, NULL, &part, &hit, &found) == GJK_OK && !found);
}

// Bullets pass through no floor, however fast, turning or not, and where the floor is met agrees with the cast.
static void shoot(random_state *r) {
  for (unsigned long i = 0; i < check_trials_least(400, 40); i++) {
    const unsigned rider = random_below(r, RIDERS);
    const bool turns = random_below(r, 2) == 0;
    gjk2_pose at = GJK2_POSE_IDENTITY, to;
    bool impact = false;
    memset(level_cells, 0, sizeof level_cells);
    for (int x = 0; x < LENGTH; x++) {
      level_cells[x] = (uint8_t)(random_below(r, 8) == 0 ? 2 : 1);
    }
    at.rotation = plane_random_rotation(r);
    at.position.x = GJK_Q16(400) + random_range(r, 0, GJK_Q16(400));
    at.position.y = random_range(r, GJK_Q16(3.2), GJK_Q16(20));
    to = at;
    to.position.x += random_range(r, -GJK_Q16(300), GJK_Q16(300));
    to.position.y -= random_range(r, 0, GJK_Q16(25));
    if (turns) {
      gjk2_rotation turn;
      CHECK(gjk2_rotation_from_angle(random_range(r, -200000, 200000), &turn) == GJK_OK);
      CHECK(gjk2_rotation_compose(&at.rotation, &turn, &to.rotation) == GJK_OK);
    }
    set_level(&whole, &riders[rider], &at, true);
    update(&whole, 0);
    CHECK(gjk2_scene_move(&whole.scene, whole.mover[0], &to) == GJK_OK);
    update(&whole, 0);
    gjk_q30 fraction = GJK_Q30_ONE;
    for (unsigned k = 0; k < whole.count; k++) {
      if (whole.reports[k].event == GJK_EVENT_IMPACT) {
        impact = true;
        fraction = whole.reports[k].fraction;
      }
    }
    // Before the impact nothing is touched; without one, nothing at all.
    const gjk2_motion motion = {at, to, 0};
    const gjk2_pose identity = GJK2_POSE_IDENTITY;
    gjk2_collider c;
    CHECK(gjk2_collider_init(&c, &riders[rider], NULL, 0) == GJK_OK);
    for (int sample = 0; sample <= 200; sample++) {
      const gjk_q30 f = (gjk_q30)((int64_t)fraction * sample / 201);
      gjk2_pose pose;
      gjk2_distance_result distance;
      uint32_t segment;
      bool found;
      CHECK(gjk2_motion_pose(&motion, f, &pose) == GJK_OK && gjk2_collider_pose(&c, &pose) == GJK_OK);
      CHECK(gjk2_ground_distance(&level_ground, &identity, &c, &distance, &segment, &found) == GJK_OK);
      CHECK_MSG(!found || !distance.intersecting, "touches at %d of %d", f, fraction);
      CHECK(c.centre.y > GJK_Q16(0.5));
    }
    if (impact) {
      gjk2_pose pose;
      bool near;
      CHECK(gjk2_motion_pose(&motion, fraction, &pose) == GJK_OK && gjk2_collider_pose(&c, &pose) == GJK_OK);
      CHECK(gjk2_ground_within(&level_ground, &identity, &c, 700, &near) == GJK_OK && near);
    }
    tally.impacts += impact;
    tally.misses += !impact;
    tally.turning += turns && impact;
  }
  CHECK(tally.misses > 3 && tally.turning > 10);
}

int main(void) {
  random_state random = random_seed(check_seed(SEED));
  jump_through();
  ride_flat(&random, false);
  ride_flat(&random, true);
  ride_hills(&random);
  shoot(&random);
  check_scenes(&random);
  printf("%lu ticks and %lu slides over joints with %lu contacts\n", tally.ticks, tally.slides, tally.faces);
  printf("%lu pairs near, %lu begun, %lu ended, %lu contacts, %lu deep, %lu hits of %lu, %lu impacts\n", tally.near,
         tally.begun, tally.ended, tally.contacts, tally.deep, tally.hits, tally.casts, tally.impacts);
  CHECK(tally.near > 50 && tally.begun > 20 && tally.ended > 20 && tally.contacts > 50 && tally.deep > 20 &&
        tally.hits > 20 && tally.impacts > 20 && tally.ticks > 1000 && tally.nearest > 20 && tally.slides > 1000);
  return check_done("plane ground scene");
}
