// Concave bodies in a scene, against a second scene in which every triangle and part is a static body of its own: the
// same pairs, distances and depths in every update, the same first hits of rays and casts, the same nearest bodies. The
// answers do not depend on skips, on saves or on the order of adding.
#include <string.h>

#include "check.h"
#include "reference/random_shape.h"
#include "scene/concave_world.h"

#define SEED UINT64_C(0x436F6E63)
#define TRIALS 60
#define UPDATES 10
#define PAIRS UINT32_C(20000)
#define REPORTS 4000
#define BODIES (CONCAVE_PIECES + CONCAVE_MOVERS)

static struct { unsigned long pairs, near, begun, ended, hits, misses, rays, found, passed; } tally;

static concave_world w;
static const gjk_shape *whole_shapes[CONCAVE_BODIES + CONCAVE_MOVERS], *piece_shapes[BODIES];
static uint32_t whole_block[40000], checked_block[40000], piece_block[600000], saved_block[40000];
static gjk_epa_cell cells[GJK_EPA_CELLS(64)];
static const gjk_workspace workspace = {cells, sizeof cells / sizeof cells[0]};
static gjk_scene whole, checked, pieces;
static gjk_body_id mover[2][CONCAVE_MOVERS], ground[CONCAVE_BODIES];
static gjk_report reports[REPORTS];

// What is known of a mover and a concave body.
typedef struct relation {
  bool near;
  gjk_q16 distance;
} relation;

// Users: movers from 0, concave bodies and their pieces from 100.
#define GROUND 100

static void add_one(gjk_scene *scene, uint32_t slot, uint16_t shape, const gjk_pose *pose, uint8_t kind, uint32_t user,
                    gjk_q16 margin, gjk_body_id *id) {
  const gjk_part part = {shape, false, GJK_POSE_IDENTITY};
  const gjk_body_setup setup = {*pose, &part, 1, kind, 0, 1, 1, user, margin};
  CHECK(gjk_scene_add_at(scene, slot, &setup, id) == GJK_OK);
}

static gjk_pose any_pose(random_state *random, int32_t size) {
  gjk_pose pose;
  pose.position = random_vector(random, 12.0 * size * random_unit(random));
  pose.rotation = random_rotation(random);
  return pose;
}

static void start(gjk_scene *scene, void *block, size_t bytes, const gjk_shape *const *shapes, uint16_t shape_count,
                  uint32_t bodies, uint8_t detail, uint8_t retest) {
  const gjk_scene_config config = {bodies, bodies, 0, PAIRS / (bodies > 100 ? 1 : 50), 3000, detail,
                                   1,      retest, 0, sizeof cells / sizeof cells[0],  0};
  const gjk_scene_bindings bindings = {.details = &gjk_scene_contacts, .workspace = &workspace};
  CHECK(gjk_scene_bytes(&config) <= bytes);
  CHECK(gjk_scene_init(scene, &config, block, bytes, shapes, shape_count, &bindings) == GJK_OK);
}

// Bodies and movers are added to the scene of wholes from the first slot on, to the checked one from the last on.
static void build(random_state *random, int32_t size, uint8_t detail) {
  const gjk_q16 margin = random_below(random, 2) ? 0 : random_range(random, 0, size / 4);
  const uint32_t bodies = CONCAVE_BODIES + CONCAVE_MOVERS;
  gjk_pose place[CONCAVE_MOVERS];
  gjk_body_id id;
  concave_world_make(&w, random, size);
  concave_world_cut(&w);
  for (unsigned i = 0; i < bodies; i++) {
    whole_shapes[i] = i < CONCAVE_BODIES ? &w.body[i].shape : &w.mover[i - CONCAVE_BODIES];
  }
  for (unsigned i = 0; i < w.pieces; i++) {
    piece_shapes[i] = &w.piece[i].shape;
  }
  for (unsigned i = 0; i < CONCAVE_MOVERS; i++) {
    piece_shapes[w.pieces + i] = &w.mover[i];
    place[i] = any_pose(random, size);
  }
  start(&whole, whole_block, sizeof whole_block, whole_shapes, (uint16_t)bodies, bodies, detail, 0);
  start(&checked, checked_block, sizeof checked_block, whole_shapes, (uint16_t)bodies, bodies, detail, 1);
  start(&pieces, piece_block, sizeof piece_block, piece_shapes, (uint16_t)(w.pieces + CONCAVE_MOVERS), BODIES, detail,
        0);
  for (uint32_t n = 0; n < bodies; n++) {
    for (unsigned turn = 0; turn < 2; turn++) {
      const uint32_t i = turn == 0 ? n : bodies - 1 - n;
      gjk_scene *scene = turn == 0 ? &whole : &checked;
      if (i < CONCAVE_BODIES) {
        add_one(scene, i, (uint16_t)i, &w.body[i].parts.pose, GJK_BODY_STATIC, GROUND + i, margin, &ground[i]);
      } else {
        add_one(scene, i, (uint16_t)i, &place[i - CONCAVE_BODIES], GJK_BODY_DYNAMIC, i - CONCAVE_BODIES, margin,
                &mover[0][i - CONCAVE_BODIES]);
      }
    }
  }
  for (uint32_t i = 0; i < w.pieces; i++) {
    add_one(&pieces, i, (uint16_t)i, &w.piece[i].pose, GJK_BODY_STATIC, GROUND + w.piece[i].of, margin, &id);
  }
  for (uint32_t i = 0; i < CONCAVE_MOVERS; i++) {
    add_one(&pieces, CONCAVE_PIECES + i, (uint16_t)(w.pieces + i), &place[i], GJK_BODY_DYNAMIC, i, margin,
            &mover[1][i]);
  }
}

static uint32_t user_of(const gjk_scene *scene, gjk_body_id id) {
  gjk_body_state state;
  CHECK(gjk_scene_get(scene, id, &state) == GJK_OK);
  return state.user;
}

// Updates a scene. What near movers and concave bodies there are, and of pieces the nearest. events: a begin of what was
// not near, and so on.
static void collect(gjk_scene *scene, bool events, relation now[CONCAVE_MOVERS][CONCAVE_BODIES], uint32_t *between) {
  gjk_progress progress;
  relation before[CONCAVE_MOVERS][CONCAVE_BODIES];
  memcpy(before, now, sizeof before);
  memset(now, 0, sizeof before);
  *between = 0;
  CHECK(gjk_scene_update(scene, reports, REPORTS, &progress) == GJK_OK);
  CHECK(progress.reports_left == 0);
  for (uint32_t i = 0; i < progress.reports; i++) {
    const gjk_report *r = &reports[i];
    uint32_t a = user_of(scene, r->a), b = user_of(scene, r->b);
    if (a < GROUND && b < GROUND) {
      *between += r->event * 31u + a * 7u + b;
      continue;
    }
    const uint32_t of_mover = a < GROUND ? a : b, of_ground = (a < GROUND ? b : a) - GROUND;
    relation *n = &now[of_mover][of_ground];
    if (events) {
      const bool was = before[of_mover][of_ground].near;
      CHECK(r->event == (was ? (r->event == GJK_EVENT_END ? GJK_EVENT_END : GJK_EVENT_PERSIST) : GJK_EVENT_BEGIN));
      tally.begun += r->event == GJK_EVENT_BEGIN;
      tally.ended += r->event == GJK_EVENT_END;
    }
    if (r->event != GJK_EVENT_END && (!n->near || r->distance < n->distance)) {
      n->near = true;
      n->distance = r->distance;
    }
  }
}

static void check_updates(random_state *random, int32_t size) {
  relation now[3][CONCAVE_MOVERS][CONCAVE_BODIES];
  uint32_t between[3];
  uint64_t hash[2];
  memset(now, 0, sizeof now);
  for (unsigned u = 0; u < UPDATES; u++) {
    collect(&whole, true, now[0], &between[0]);
    collect(&checked, true, now[1], &between[1]);
    collect(&pieces, false, now[2], &between[2]);
    CHECK(between[0] == between[1] && between[0] == between[2]);
    for (unsigned i = 0; i < CONCAVE_MOVERS; i++) {
      for (unsigned k = 0; k < CONCAVE_BODIES; k++) {
        const relation *r = &now[0][i][k], *c = &now[1][i][k], *p = &now[2][i][k];
        CHECK_MSG(r->near == p->near && r->distance == p->distance, "mover %u, body %u: %d %d, expected %d %d", i, k,
                  r->near, (int)r->distance, p->near, (int)p->distance);
        CHECK(r->near == c->near && r->distance == c->distance);
        tally.pairs++;
        tally.near += r->near;
      }
    }
    CHECK(gjk_scene_check(&whole) == GJK_OK && gjk_scene_check(&checked) == GJK_OK);
    CHECK(gjk_scene_hash(&whole, &hash[0]) == GJK_OK && gjk_scene_hash(&checked, &hash[1]) == GJK_OK);
    CHECK(hash[0] == hash[1]);
    for (unsigned i = 0; i < CONCAVE_MOVERS; i++) {
      gjk_body_state state;
      CHECK(gjk_scene_get(&whole, mover[0][i], &state) == GJK_OK);
      const uint32_t how = random_below(random, 4);
      const gjk_vec3 off = random_vector(random, size * (how == 0 ? 3.0 : 0.05));
      state.pose.position =
          (gjk_vec3){state.pose.position.x + off.x, state.pose.position.y + off.y, state.pose.position.z + off.z};
      state.pose.rotation = how == 1 ? random_rotation(random) : state.pose.rotation;
      if (how != 2) {
        CHECK(gjk_scene_move(&whole, mover[0][i], &state.pose) == GJK_OK);
        CHECK(gjk_scene_move(&checked, mover[0][i], &state.pose) == GJK_OK);
        CHECK(gjk_scene_move(&pieces, mover[1][i], &state.pose) == GJK_OK);
      }
    }
  }
}

// Which body a hit in the scene of pieces stands for.
static uint32_t user_at(const gjk_scene *scene, const gjk_scene_hit *hit) {
  return user_of(scene, hit->body);
}

static void check_ways(random_state *random, int32_t size) {
  const gjk_shape shape = GJK_ROUNDED_BOX(size / 3, size / 5, size / 4, size / 7);
  for (unsigned n = 0; n < 30; n++) {
    gjk_collider c = {0};
    const gjk_pose pose = any_pose(random, size), end = any_pose(random, size);
    gjk_scene_hit hit[2], all[2][200];
    gjk_cast_result result[2];
    bool found[2];
    uint32_t count[2];
    gjk_q16 distance[2];
    const gjk_scene *scene[2] = {&whole, &pieces};
    CHECK(gjk_collider_init(&c, &shape, NULL, 0) == GJK_OK && gjk_collider_pose(&c, &pose) == GJK_OK);
    for (unsigned k = 0; k < 2; k++) {
      CHECK(gjk_scene_cast_ray(scene[k], &pose.position, &end.position, NULL, &hit[k], &result[k], &found[k]) ==
            GJK_OK);
    }
    CHECK(found[0] == found[1]);
    if (found[0] && found[1]) {
      CHECK_MSG(hit[0].fraction == hit[1].fraction && user_at(&whole, &hit[0]) == user_at(&pieces, &hit[1]),
                "ray %u: %u, expected %u", n, hit[0].fraction, hit[1].fraction);
      CHECK(memcmp(&result[0].point_b, &result[1].point_b, sizeof result[0].point_b) == 0 || result[0].inside);
      tally.rays++;
    }
    const gjk_q16 margin = n % 2 == 0 ? 0 : size / 10;
    for (unsigned k = 0; k < 2; k++) {
      CHECK(gjk_scene_cast(scene[k], &c, &end.position, margin, NULL, &hit[k], &result[k], &found[k]) == GJK_OK);
    }
    CHECK(found[0] == found[1]);
    if (found[0] && found[1]) {
      CHECK_MSG(hit[0].fraction == hit[1].fraction && result[0].inside == result[1].inside, "cast %u: %u, expected %u",
                n, hit[0].fraction, hit[1].fraction);
      tally.hits++;
    } else {
      tally.misses++;
    }
    for (unsigned k = 0; k < 2; k++) {
      CHECK(gjk_scene_cast_all(scene[k], &c, &end.position, margin, NULL, NULL, all[k], 200, &count[k]) == GJK_OK);
    }
    // Of the pieces of a body the first in order stands for it.
    uint32_t at = 0;
    bool seen[GROUND + CONCAVE_BODIES] = {false};
    for (uint32_t i = 0; i < count[1] && i < 200; i++) {
      const uint32_t user = user_at(&pieces, &all[1][i]);
      if (!seen[user]) {
        bool there = false;
        seen[user] = true;
        at++;
        for (uint32_t k = 0; k < count[0] && k < 200; k++) {
          there = there || (user_at(&whole, &all[0][k]) == user && all[0][k].fraction == all[1][i].fraction);
        }
        CHECK(there);
      }
    }
    CHECK(count[1] > 200 || at == count[0]);
    for (unsigned k = 0; k < 2; k++) {
      CHECK(gjk_scene_query_nearest(scene[k], &c, 4 * size, NULL, &hit[k], &distance[k], &found[k]) == GJK_OK);
    }
    CHECK(found[0] == found[1] && (!found[0] || distance[0] == distance[1]));
    tally.found += found[0];
    for (unsigned k = 0; k < 2; k++) {
      CHECK(gjk_scene_query_within(scene[k], &c, margin, NULL, NULL, all[k], 200, &count[k]) == GJK_OK);
    }
    memset(seen, 0, sizeof seen);
    at = 0;
    for (uint32_t i = 0; i < count[1] && i < 200; i++) {
      const uint32_t user = user_at(&pieces, &all[1][i]);
      at += !seen[user];
      seen[user] = true;
    }
    CHECK(count[1] > 200 || at == count[0]);
    for (uint32_t i = 0; i < count[0] && count[1] <= 200; i++) {
      CHECK(seen[user_at(&whole, &all[0][i])]);
    }
    tally.passed += count[0];
  }
}

// A save that is opened goes on as the scene it was made of.
static void check_save(random_state *random, int32_t size) {
  gjk_scene opened;
  gjk_progress progress;
  uint64_t hash[2];
  memcpy(saved_block, whole_block, sizeof saved_block);
  CHECK(gjk_scene_attach(&opened, saved_block, sizeof saved_block, whole.shapes, whole.shape_count, &whole.bindings) ==
        GJK_OK);
  CHECK(gjk_scene_seal(&opened) == GJK_OK);
  CHECK(gjk_scene_open(&opened, saved_block, sizeof saved_block, whole.shapes, whole.shape_count, &whole.bindings) ==
        GJK_OK);
  for (unsigned u = 0; u < 2; u++) {
    for (unsigned i = 0; i < CONCAVE_MOVERS; i++) {
      const gjk_pose pose = any_pose(random, size);
      CHECK(gjk_scene_move(&whole, mover[0][i], &pose) == GJK_OK);
      CHECK(gjk_scene_move(&opened, mover[0][i], &pose) == GJK_OK);
    }
    CHECK(gjk_scene_update(&whole, reports, REPORTS, &progress) == GJK_OK);
    CHECK(gjk_scene_update(&opened, reports, REPORTS, &progress) == GJK_OK);
    CHECK(gjk_scene_hash(&whole, &hash[0]) == GJK_OK && gjk_scene_hash(&opened, &hash[1]) == GJK_OK);
    CHECK(hash[0] == hash[1]);
  }
}

int main(void) {
  const uint64_t seed = check_seed(SEED);
  for (unsigned long i = 0; i < TRIALS; i++) {
    static const uint8_t details[] = {GJK_DETAIL_TOUCH, GJK_DETAIL_DISTANCE, GJK_DETAIL_DEPTH};
    random_state random = random_seed(seed + i);
    const int32_t size = 1 << random_range(&random, 8, 17);
    check_trial(i, NULL, NULL);
    build(&random, size, details[i % 3]);
    check_updates(&random, size);
    check_ways(&random, size);
    check_save(&random, size);
    concave_world_free(&w);
  }
  printf("%lu pairs, %lu near, %lu begun, %lu ended; %lu casts hit, %lu miss, %lu rays hit, %lu nearest, %lu within\n",
         tally.pairs, tally.near, tally.begun, tally.ended, tally.hits, tally.misses, tally.rays, tally.found,
         tally.passed);
  CHECK(tally.near > tally.pairs / 20 && tally.near < tally.pairs * 8 / 10);
  CHECK(tally.begun > 100 && tally.ended > 100 && tally.hits > 200 && tally.misses > 100 && tally.rays > 100);
  return check_done("concave");
}
