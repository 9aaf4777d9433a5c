// A small lockstep game in the plane.
#include "plane_match.h"

static const gjk2_vec corners[6] = {{30000, 2000},   {9000, 29000},   {-25000, 20000},
                                    {-28000, -9000}, {-3000, -30000}, {19000, -18000}};
static const gjk2_vec sail[3] = {{-40000, -9000}, {41000, 0}, {3000, 52000}};
static const gjk2_shape crate = GJK2_BOX(GJK_Q16(0.5), GJK_Q16(0.5)), ball = GJK2_CIRCLE(GJK_Q16(0.5));
static const gjk2_shape capsule = GJK2_CAPSULE(GJK_Q16(0.25), GJK_Q16(0.4)), stone = GJK2_POLYGON(corners, 6);
static const gjk2_shape egg = GJK2_ELLIPSE(GJK_Q16(0.5), GJK_Q16(0.375)), flag = GJK2_TRIANGLE(sail);
static const gjk2_shape wall = GJK2_BOX(GJK_Q16(6.0), GJK_Q16(0.25));
static const gjk2_shape *const shapes[] = {&crate, &ball, &capsule, &stone, &egg, &flag, &wall};

#define SHAPES 7
#define WALL 6
#define REACH GJK_Q16(4)

static uint32_t scramble(uint32_t x) {
  x = (x ^ x >> 16) * UINT32_C(0x7FEB352D);
  x = (x ^ x >> 15) * UINT32_C(0x846CA68B);
  return x ^ x >> 16;
}

// A number from -limit to limit that depends on a, b and c.
static int32_t dice(uint32_t a, uint32_t b, uint32_t c, int32_t limit) {
  const uint32_t any = scramble(scramble(scramble(a) ^ b) ^ c);
  return (int32_t)(any % (2 * (uint32_t)limit + 1)) - limit;
}

// All matches use this memory in turn; nothing stays in it.
static gjk2_manifold manifold;

static const gjk2_scene_bindings bindings = {.details = &gjk2_scene_contacts, .manifolds = &manifold};

bool plane_match_scene(plane_match *m, gjk2_scene *out) {
  return gjk2_scene_attach(out, m->block, sizeof m->block, shapes, SHAPES, &bindings) == GJK_OK;
}

static const uint8_t details[6] = {GJK_DETAIL_DISTANCE, GJK_DETAIL_TOUCH, GJK_DETAIL_TOUCH,
                                   GJK_DETAIL_DISTANCE, GJK_DETAIL_DEPTH, GJK_DETAIL_CONTACTS};

static bool add(plane_match *m, gjk2_scene *scene, uint32_t slot) {
  gjk2_part parts[2] = {{0, false, GJK2_POSE_IDENTITY}, {1, true, GJK2_POSE_IDENTITY}};
  const bool fixed = slot == MATCH_BODIES - 1;
  plane_match_body *b = &m->bodies[slot];
  const gjk2_rotation turn = {30000, dice(slot, m->tick, 4, 500)};
  parts[0].shape = (uint16_t)(fixed ? WALL : slot % WALL);
  parts[1].pose.position.y = GJK_Q16(0.75);
  gjk2_body_setup setup = {GJK2_POSE_IDENTITY,
                           parts,
                           (uint16_t)(slot % 6 == 5 && !fixed ? 2 : 1),
                           (uint8_t)(fixed      ? GJK_BODY_STATIC
                                     : slot < 2 ? GJK_BODY_KINEMATIC
                                                : GJK_BODY_DYNAMIC),
                           details[slot % 6],
                           1,
                           UINT32_MAX,
                           slot,
                           slot % 4 == 0 ? GJK_Q16(0.125) : 0};
  setup.pose.position.x = fixed ? 0 : dice(slot, m->tick, 1, REACH);
  setup.pose.position.y = fixed ? -REACH : dice(slot, m->tick, 2, REACH);
  b->step.x = slot < 2 ? 0 : dice(slot, m->tick, 7, 3000);
  b->step.y = slot < 2 ? 0 : dice(slot, m->tick, 8, 3000);
  return gjk2_rotation_normalize(&turn, &b->turn) == GJK_OK && gjk2_scene_add_at(scene, slot, &setup, &b->id) == GJK_OK;
}

bool plane_match_start(plane_match *m) {
  const gjk2_scene_config config = {
      MATCH_BODIES, 2 * MATCH_BODIES, MATCH_BODIES, MATCH_PAIRS, GJK_Q16(0.1), GJK_DETAIL_TOUCH, 1, 0, 0, 0};
  gjk2_scene scene;
  m->tick = 0;
  bool fine = gjk2_scene_init(&scene, &config, m->block, sizeof m->block, shapes, SHAPES, &bindings) == GJK_OK;
  for (uint32_t i = 0; i < MATCH_BODIES && fine; i++) {
    fine = add(m, &scene, i);
  }
  return fine;
}

static int32_t bounce(int32_t at, int32_t step) {
  return (at > REACH && step > 0) || (at < -REACH && step < 0) ? -step : step;
}

static bool move(plane_match *m, gjk2_scene *scene, uint32_t slot, plane_match_input input) {
  plane_match_body *b = &m->bodies[slot];
  gjk2_body_state state;
  if (gjk2_scene_get(scene, b->id, &state) != GJK_OK) {
    return false;
  }
  if (state.kind == GJK_BODY_STATIC || state.asleep) {
    return true;
  }
  const int32_t push = (input & 8) != 0 ? -2000 : 2000;
  b->step.x = bounce(state.pose.position.x, (input & 1) != 0 ? push : b->step.x);
  b->step.y = bounce(state.pose.position.y, (input & 2) != 0 ? push : b->step.y);
  state.pose.position.x += b->step.x;
  state.pose.position.y += b->step.y;
  if (slot >= 2 || (input & 16) != 0) {
    gjk2_rotation_compose(&b->turn, &state.pose.rotation, &state.pose.rotation);
  }
  return gjk2_scene_move(scene, b->id, &state.pose) == GJK_OK;
}

// Does what a player does besides moving, to the body of the tick.
static bool act(plane_match *m, gjk2_scene *scene, plane_match_input input) {
  const uint32_t slot = 2 + m->tick % (MATCH_BODIES - 3);
  plane_match_body *b = &m->bodies[slot];
  bool fine = true;
  if ((input & 32) != 0 && m->tick % 5 == 0) {
    fine = gjk2_scene_set_shape(scene, b->id, 0, (uint16_t)(m->tick % WALL)) == GJK_OK;
  }
  if ((input & 64) != 0 && m->tick % 7 == 0) {
    fine = fine && gjk2_scene_remove(scene, b->id) == GJK_OK && add(m, scene, slot);
  }
  if ((input & 128) != 0 && m->tick % 3 == 0) {
    gjk2_body_state state;
    fine = fine && gjk2_scene_get(scene, b->id, &state) == GJK_OK &&
           (state.asleep ? gjk2_scene_wake(scene, b->id) : gjk2_scene_sleep(scene, b->id)) == GJK_OK;
  }
  return fine;
}

static bool holds(const plane_match *m, gjk_body_id body) {
  return m->bodies[body.slot].id.generation == body.generation;
}

// A number that depends on almost every field of a manifold.
static int32_t sum_of(const gjk2_manifold *m) {
  int32_t sum = m->normal.x % 5 + m->normal.y % 7 + m->feature_a + m->feature_b;
  for (int i = 0; i < m->count; i++) {
    const gjk2_contact *c = &m->contact[i];
    sum += c->point_a.x % 5 + c->point_a.y % 7 + c->point_b.x % 11 + c->distance % 13 + c->id;
  }
  return sum;
}

// Bodies that begin to touch swap their steps. The distance of bodies that stay near, or their manifold, bends the path
// of one.
static void react(void *user, const gjk2_report *report) {
  plane_match *m = user;
  if (!holds(m, report->a) || !holds(m, report->b)) {
    return;
  }
  plane_match_body *a = &m->bodies[report->a.slot], *b = &m->bodies[report->b.slot];
  if (report->event == GJK_EVENT_BEGIN) {
    const gjk2_vec step = a->step;
    a->step = b->step;
    b->step = step;
  } else if (report->event == GJK_EVENT_PERSIST) {
    b->step.x += (report->manifold != NULL ? sum_of(report->manifold) : report->distance) % 7 - 3;
  } else {
    b->step.y += report->part_b + 1;
  }
  b->step.x = b->step.x > 4000 ? 3000 : b->step.x < -4000 ? -3000 : b->step.x;
  b->step.y = b->step.y > 4000 ? -3000 : b->step.y;
}

bool plane_match_tick(plane_match *m, plane_match_input first, plane_match_input second) {
  gjk2_scene scene;
  bool fine = plane_match_scene(m, &scene);
  for (uint32_t i = 0; i < MATCH_BODIES && fine; i++) {
    fine = move(m, &scene, i, i == 0 ? first : i == 1 ? second : 0);
  }
  fine = fine && act(m, &scene, first) && act(m, &scene, second) && gjk2_scene_update_each(&scene, react, m) == GJK_OK;
  m->tick++;
  return fine;
}

uint64_t plane_match_hash(plane_match *m) {
  gjk2_scene scene;
  uint64_t hash = 0;
  if (!plane_match_scene(m, &scene) || gjk2_scene_hash(&scene, &hash) != GJK_OK) {
    return 0;
  }
  for (uint32_t i = 0; i < MATCH_BODIES; i++) {
    const plane_match_body *b = &m->bodies[i];
    const uint32_t words[] = {(uint32_t)b->step.x, (uint32_t)b->step.y, b->id.generation};
    for (int k = 0; k < 3; k++) {
      hash = (hash ^ words[k]) * UINT64_C(0x100000001B3);
    }
  }
  return hash;
}
