// A scene of the pile as it is at one tick, and its debug drawing.
#include "seen.h"

#include "gjk2/draw.h"
#include "pile.h"
#include "tests/programs/demo_plane/flat_solver.h"

#define RECORDS 8192
#define FIELDS 5
#define TILES (PAGE_PILE_WIDTH + 2 * PAGE_PILE_HEIGHT)  // of the trough, each a unit long, so that pairs are short
#define SLOTS (FLAT_BODIES + TILES)
#define PAIRS (SLOTS * (SLOTS - 1) / 2)  // all of them, so that an update never lacks room
#define MARGIN (GJK_Q16_ONE / 100)       // of each body: pairs are near where the solver asks them for contacts
#define NORMAL (GJK_Q16_ONE / 5)         // the length that a normal is drawn with
#define BLOCK_WORDS (72 + SLOTS * 48 + PAIRS * 12)  // at most 192 bytes a body and 48 a pair with its cache

static int32_t records[RECORDS * FIELDS];
static uint32_t count;
static uint32_t block[BLOCK_WORDS];

static void add_line(void *user, const gjk2_vec *from, const gjk2_vec *to, gjk_draw_role role) {
  (void)user;
  if (count < RECORDS) {
    int32_t *out = &records[FIELDS * count++];
    out[0] = (int32_t)role;
    out[1] = from->x;
    out[2] = from->y;
    out[3] = to->x;
    out[4] = to->y;
  }
}

static void add_point(void *user, const gjk2_vec *at, gjk_draw_role role) {
  add_line(user, at, at, role);
}

static const gjk2_draw draw = {.line = add_line, .point = add_point};

static void draw_report(void *user, const gjk2_report *report) {
  (void)user;
  (void)gjk2_draw_manifold(&draw, report->manifold, NORMAL);
}

static void add(gjk2_scene *scene, uint16_t shape, const gjk2_pose *pose, gjk_body_kind kind) {
  const gjk2_part part = {.shape = shape};
  const gjk2_body_setup setup = {.pose = *pose,
                                 .parts = &part,
                                 .part_count = 1,
                                 .kind = (uint8_t)kind,
                                 .category = 1,
                                 .mask = 1,
                                 .margin = MARGIN};
  gjk_body_id id;
  (void)gjk2_scene_add(scene, &setup, &id);
}

static void add_trough(gjk2_scene *scene, uint16_t tile) {
  const int32_t half = GJK_Q16_ONE / 2;
  for (int32_t i = 0; i < PAGE_PILE_WIDTH; i++) {
    const gjk2_pose pose = {{i * GJK_Q16_ONE + half, 0}, {GJK_Q30_ONE, 0}};
    add(scene, tile, &pose, GJK_BODY_STATIC);
  }
  for (int32_t i = 0; i < 2 * PAGE_PILE_HEIGHT; i++) {
    const gjk2_pose pose = {{i % 2 * PAGE_PILE_WIDTH * GJK_Q16_ONE, i / 2 * GJK_Q16_ONE + half}, {0, GJK_Q30_ONE}};
    add(scene, tile, &pose, GJK_BODY_STATIC);
  }
}

uint32_t page_seen_look(int side) {
  const gjk2_shape tile = GJK2_SEGMENT(GJK_Q16_ONE / 2);
  const flat_world *w = page_pile_state(side);
  const gjk2_scene_config config = {.bodies = SLOTS, .parts = SLOTS, .pairs = PAIRS, .detail = GJK_DETAIL_CONTACTS};
  const gjk2_shape *shapes[1 + FLAT_BODIES] = {&tile};
  gjk2_manifold manifold;
  const gjk2_scene_bindings bindings = {.details = &gjk2_scene_contacts, .manifolds = &manifold};
  gjk2_scene scene;
  count = 0;
  if (gjk2_scene_init(&scene, &config, block, sizeof block, shapes, 1 + FLAT_BODIES, &bindings) == GJK_OK) {
    add_trough(&scene, 0);
    for (uint16_t i = 0; i < w->bodies; i++) {
      shapes[1 + i] = &w->body[i].shape;
      add(&scene, (uint16_t)(1 + i), &w->body[i].pose, GJK_BODY_DYNAMIC);
    }
    (void)gjk2_scene_update_each(&scene, draw_report, NULL);
    (void)gjk2_draw_scene(&draw, &scene, GJK_DRAW_BOXES | GJK_DRAW_PAIRS);
  }
  return count;
}

const int32_t *page_seen_records(void) {
  return records;
}
