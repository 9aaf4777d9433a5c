// The rules of a small lockstep game (match.h), for space and, under the plane's names, for the plane.
//
// Before it comes what a dimension has of its own: SHAPES in the table shapes, the number of the WALL among them, REACH,
// bindings, config, AXES, and the component of a vector along an axis.
#ifndef MATCH_RULES_H
#define MATCH_RULES_H

// How far a body turns in a tick, as a rotation to be normalised.
static gjk_quat turn_of(uint32_t slot, uint32_t tick);

// A number that depends on almost every field of a manifold.
static int32_t sum_of(const gjk_manifold *m);

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

bool match_scene(match *m, gjk_scene *out) {
  return gjk_scene_attach(out, m->block, sizeof m->block, shapes, SHAPES, &bindings) == GJK_OK;
}

static const uint8_t details[6] = {GJK_DETAIL_DISTANCE, GJK_DETAIL_TOUCH, GJK_DETAIL_TOUCH,
                                   GJK_DETAIL_DISTANCE, GJK_DETAIL_DEPTH, GJK_DETAIL_CONTACTS};

static bool add(match *m, gjk_scene *scene, uint32_t slot) {
  gjk_part parts[2] = {{0, false, GJK_POSE_IDENTITY}, {1, true, GJK_POSE_IDENTITY}};
  const bool fixed = slot == MATCH_BODIES - 1;
  match_body *b = &m->bodies[slot];
  const gjk_quat turn = turn_of(slot, m->tick);
  parts[0].shape = (uint16_t)(fixed ? WALL : slot % WALL);
  *along(&parts[1].pose.position, AXES - 1) = GJK_Q16(0.75);
  gjk_body_setup setup = {GJK_POSE_IDENTITY,
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
  for (uint32_t axis = 0; axis < AXES; axis++) {
    *along(&setup.pose.position, axis) = !fixed ? dice(slot, m->tick, 1 + axis, REACH) : axis == AXES - 1 ? -REACH : 0;
    *along(&b->step, axis) = slot < 2 ? 0 : dice(slot, m->tick, 7 + axis, 3000);
  }
  return gjk_quat_normalize(&turn, &b->turn) == GJK_OK && gjk_scene_add_at(scene, slot, &setup, &b->id) == GJK_OK;
}

bool match_start(match *m) {
  gjk_scene scene;
  m->tick = 0;
  bool fine = gjk_scene_init(&scene, &config, m->block, sizeof m->block, shapes, SHAPES, &bindings) == GJK_OK;
  for (uint32_t i = 0; i < MATCH_BODIES && fine; i++) {
    fine = add(m, &scene, i);
  }
  return fine;
}

static int32_t bounce(int32_t at, int32_t step) {
  return (at > REACH && step > 0) || (at < -REACH && step < 0) ? -step : step;
}

static bool move(match *m, gjk_scene *scene, uint32_t slot, match_input input) {
  match_body *b = &m->bodies[slot];
  gjk_body_state state;
  if (gjk_scene_get(scene, b->id, &state) != GJK_OK) {
    return false;
  }
  if (state.kind == GJK_BODY_STATIC || state.asleep) {
    return true;
  }
  const int32_t push = (input & 8) != 0 ? -2000 : 2000;
  for (uint32_t axis = 0; axis < AXES; axis++) {
    gjk_q16 *at = along(&state.pose.position, axis), *step = along(&b->step, axis);
    *step = bounce(*at, (input & 1u << axis) != 0 ? push : *step);
    *at += *step;
  }
  if (slot >= 2 || (input & 16) != 0) {
    gjk_quat_compose(&b->turn, &state.pose.rotation, &state.pose.rotation);
  }
  return gjk_scene_move(scene, b->id, &state.pose) == GJK_OK;
}

// Does what a player does besides moving, to the body of the tick.
static bool act(match *m, gjk_scene *scene, match_input input) {
  const uint32_t slot = 2 + m->tick % (MATCH_BODIES - 3);
  match_body *b = &m->bodies[slot];
  bool fine = true;
  if ((input & 32) != 0 && m->tick % 5 == 0) {
    fine = gjk_scene_set_shape(scene, b->id, 0, (uint16_t)(m->tick % WALL)) == GJK_OK;
  }
  if ((input & 64) != 0 && m->tick % 7 == 0) {
    fine = fine && gjk_scene_remove(scene, b->id) == GJK_OK && add(m, scene, slot);
  }
  if ((input & 128) != 0 && m->tick % 3 == 0) {
    gjk_body_state state;
    fine = fine && gjk_scene_get(scene, b->id, &state) == GJK_OK &&
           (state.asleep ? gjk_scene_wake(scene, b->id) : gjk_scene_sleep(scene, b->id)) == GJK_OK;
  }
  return fine;
}

static bool holds(const match *m, gjk_body_id body) {
  return m->bodies[body.slot].id.generation == body.generation;
}

// Bodies that begin to touch swap their steps. The distance of bodies that stay near, or their manifold, bends the path
// of one.
static void react(void *user, const gjk_report *report) {
  match *m = user;
  if (!holds(m, report->a) || !holds(m, report->b)) {
    return;
  }
  match_body *a = &m->bodies[report->a.slot], *b = &m->bodies[report->b.slot];
  if (report->event == GJK_EVENT_BEGIN) {
    const gjk_vec3 step = a->step;
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

bool match_tick(match *m, match_input first, match_input second) {
  gjk_scene scene;
  bool fine = match_scene(m, &scene);
  for (uint32_t i = 0; i < MATCH_BODIES && fine; i++) {
    fine = move(m, &scene, i, i == 0 ? first : i == 1 ? second : 0);
  }
  fine = fine && act(m, &scene, first) && act(m, &scene, second) && gjk_scene_update_each(&scene, react, m) == GJK_OK;
  m->tick++;
  return fine;
}

static uint64_t mix(uint64_t hash, uint32_t word) {
  return (hash ^ word) * UINT64_C(0x100000001B3);
}

uint64_t match_hash(match *m) {
  gjk_scene scene;
  uint64_t hash = 0;
  if (!match_scene(m, &scene) || gjk_scene_hash(&scene, &hash) != GJK_OK) {
    return 0;
  }
  for (uint32_t i = 0; i < MATCH_BODIES; i++) {
    for (uint32_t axis = 0; axis < AXES; axis++) {
      hash = mix(hash, (uint32_t)*along(&m->bodies[i].step, axis));
    }
    hash = mix(hash, m->bodies[i].id.generation);
  }
  return hash;
}

#endif
