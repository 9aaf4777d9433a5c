// A world of random bodies, in a scene and as a plain list.
#include "world.h"

#include <stdlib.h>
#include <string.h>

#include "ceilings.h"

// A file of the plane has included the plane's.
#ifndef WORLD_OF_PLANE
#include "world_space.h"
#endif

gjk_manifold world_manifolds[WORLD_REPORTS];
world_tally world_expected;

bool world_is_tight(void) {
  return GJK_ITERATIONS_MAX < 100 || CEILINGS_OPEN_CASTS || world_cells() < WORLD_CELLS;
}

gjk_scene_config world_config(const world_options *options) {
  gjk_scene_config config = {
      .bodies = options->bodies, .parts = WORLD_PARTS * options->bodies, .own_poses = options->bodies, .pairs = 4000};
  config.box_margin = options->box_margin;
  config.detail = options->detail;
  config.persist = options->persist;
  config.pair_words = options->words;
  config.retest_all = options->retest_all;
  config.motions = options->motions ? options->bodies / 2 : 0;
  world_set_cells(&config);
  return config;
}

bool world_predicate(void *user, gjk_body_id a, uint32_t user_a, gjk_body_id b, uint32_t user_b) {
  (void)user;
  (void)a;
  (void)b;
  return ((user_a ^ user_b) & 7u) != 0;
}

bool world_start(world *w, const world_options *options, void *block, size_t bytes) {
  memset(w, 0, sizeof *w);
  w->options = *options;
  const gjk_scene_config config = world_config(options);
  const gjk_scene_bindings bindings = world_bindings(options);
  return gjk_scene_init(&w->scene, &config, block, bytes, world_shapes, WORLD_SHAPES, &bindings) == GJK_OK;
}

// A place as far inside a corner of the range of int32_t as p is from the origin.
static int32_t at_edge(random_state *random, int32_t p) {
  return random_below(random, 2) == 0 ? INT32_MIN + abs(p) : INT32_MAX - abs(p);
}

static gjk_vec3 random_position(const world *w, random_state *random) {
  gjk_vec3 p = random_point(random, w->options.reach);
  if (w->options.edges) {
    p.x = at_edge(random, p.x);
    p.y = at_edge(random, p.y);
  }
  return p;
}

void world_random_setup(const world *w, random_state *random, world_body *body) {
  memset(body, 0, sizeof *body);
  gjk_body_setup *s = &body->setup;
  s->pose.position = random_position(w, random);
  s->pose.rotation = random_rotation(random, 2000);
  s->part_count = (uint16_t)(random_below(random, 5) == 0 ? 2 + random_below(random, 2) : 1);
  for (int i = 0; i < s->part_count; i++) {
    body->parts[i].shape = (uint16_t)random_below(random, WORLD_SHAPES);
    body->parts[i].own_pose = s->part_count > 1 ? i > 0 : random_below(random, 8) == 0;
    body->parts[i].pose.position = random_point(random, GJK_Q16(1.0));
    body->parts[i].pose.rotation = random_rotation(random, 2000);
  }
  s->kind = (uint8_t)(random_below(random, 4) == 0 ? random_below(random, 2) : GJK_BODY_DYNAMIC);
  const uint8_t most = w->options.detail >= GJK_DETAIL_DEPTH ? GJK_DETAIL_CONTACTS : GJK_DETAIL_DISTANCE;
  const uint32_t wish = random_below(random, 8);
  s->detail = (uint8_t)(wish < 2 ? most : wish == 2 && w->options.sensors ? GJK_DETAIL_SENSOR : GJK_DETAIL_TOUCH);
  s->category = 1u << random_below(random, 4);
  s->mask = random_below(random, 4) == 0 ? random_below(random, 16) : UINT32_MAX;
  s->user = random_u32(random);
  s->margin = w->options.margins ? random_range(random, 0, GJK_Q16(0.25)) : 0;
}

// The status that the scene must return for this body.
static gjk_status pose_parts(world_body *b) {
  gjk_status status = GJK_OK;
  for (int i = 0; i < b->setup.part_count && status == GJK_OK; i++) {
    gjk_pose pose = b->setup.pose;
    if (b->parts[i].own_pose) {
      status = gjk_pose_compose(&b->setup.pose, &b->parts[i].pose, &pose);
    }
    gjk_collider_init(&b->colliders[i], world_shapes[b->parts[i].shape], NULL, 0);
    if (status == GJK_OK) {
      status = gjk_collider_pose(&b->colliders[i], &pose);
    }
  }
  return status;
}

static void keep(world *w, const world_body *body, gjk_body_id id) {
  world_body *kept = &w->bodies[id.slot];
  *kept = *body;
  kept->id = id;
  kept->setup.parts = kept->parts;
  kept->asleep = false;
  pose_parts(kept);
  w->adds++;
}

gjk_status world_add_at(world *w, uint32_t slot, const world_body *body) {
  gjk_body_id id;
  gjk_body_setup setup = body->setup;
  setup.parts = body->parts;
  const gjk_status status = gjk_scene_add_at(&w->scene, slot, &setup, &id);
  if (status == GJK_OK) {
    keep(w, body, id);
  }
  return status;
}

static bool add(world *w, random_state *random) {
  world_body body;
  gjk_body_id id = {0, 0};
  uint32_t own_poses = 0, lowest = 0;
  world_random_setup(w, random, &body);
  body.setup.parts = body.parts;
  for (uint32_t i = 0; i < w->options.bodies; i++) {
    const world_body *b = &w->bodies[i];
    for (int k = 0; b->id.generation != 0 && k < b->setup.part_count; k++) {
      own_poses += b->parts[k].own_pose;
    }
  }
  for (int i = 0; i < body.setup.part_count; i++) {
    own_poses += body.parts[i].own_pose;
  }
  while (lowest < w->options.bodies && w->bodies[lowest].id.generation != 0) {
    lowest++;
  }
  const gjk_status status = gjk_scene_add(&w->scene, &body.setup, &id), posed = pose_parts(&body);
  if (lowest < w->options.bodies && posed != GJK_OK) {
    w->failures++;
    return status == posed;
  }
  if (lowest == w->options.bodies || own_poses > w->options.bodies) {
    w->failures++;
    return status == GJK_ERROR_CAPACITY;
  }
  if (status != GJK_OK || id.slot != lowest) {
    return false;
  }
  keep(w, &body, id);
  return true;
}

static bool remove_body(world *w, world_body *b) {
  w->stale = b->id;
  b->id.generation = 0;
  w->removes++;
  return gjk_scene_remove(&w->scene, w->stale) == GJK_OK;
}

static bool has_own_pose(const world_body *b) {
  bool own = false;
  for (int i = 0; i < b->setup.part_count; i++) {
    own = own || b->parts[i].own_pose;
  }
  return own;
}

// Bodies whose motion is kept go far and turn fast, some of them. Those of several parts do not turn, because the list
// knows no arcs.
static bool move(world *w, random_state *random, world_body *b) {
  gjk_pose pose = b->setup.pose;
  const bool jump = random_below(random, 16) == 0, fast = b->motion != GJK_MOTION_NOT_KEPT;
  const uint32_t how = fast && has_own_pose(b) ? 2 : random_below(random, 4);
  if (jump) {
    pose.position = random_position(w, random);
  } else if (how != 0) {
    const int32_t little = random_below(random, 2) == 0 ? 300 : GJK_Q16(0.125);
    const gjk_vec3 step = random_point(random, fast && random_below(random, 4) != 0 ? w->options.reach : little);
    pose.position = add_cut_all(pose.position, step);
  }
  if (how < 2) {
    const int32_t little = random_below(random, 2) == 0 ? 3 : 60;
    const gjk_quat turn = random_rotation(random, fast && random_below(random, 2) == 0 ? 2000 : little);
    gjk_quat_compose(&turn, &pose.rotation, &pose.rotation);
  }
  const gjk_status status =
      jump ? gjk_scene_teleport(&w->scene, b->id, &pose) : gjk_scene_move(&w->scene, b->id, &pose);
  world_body moved = *b;
  moved.setup.pose = pose;
  if (pose_parts(&moved) != GJK_OK) {
    w->failures++;
    return status == GJK_ERROR_RANGE;
  }
  moved.asleep = false;
  moved.changed = b->changed || memcmp(&pose, &b->setup.pose, sizeof pose) != 0;
  moved.setup.parts = b->parts;
  if (jump) {
    moved.last = pose;
  }
  *b = moved;
  w->moves++;
  return status == GJK_OK;
}

static bool set_shape(world *w, random_state *random, world_body *b) {
  const uint16_t part = (uint16_t)random_below(random, b->setup.part_count);
  const uint16_t shape = (uint16_t)random_below(random, WORLD_SHAPES);
  const gjk_status status = gjk_scene_set_shape(&w->scene, b->id, part, shape);
  world_body changed = *b;
  changed.parts[part].shape = shape;
  if (pose_parts(&changed) != GJK_OK) {
    w->failures++;
    return status == GJK_ERROR_RANGE;
  }
  changed.setup.parts = b->parts;
  changed.changed = true;
  *b = changed;
  return status == GJK_OK;
}

static bool set_filter(world *w, random_state *random, world_body *b) {
  b->setup.category = 1u << random_below(random, 4);
  b->setup.mask = random_below(random, 2) == 0 ? random_below(random, 16) : UINT32_MAX;
  b->changed = true;
  return gjk_scene_set_filter(&w->scene, b->id, b->setup.category, b->setup.mask) == GJK_OK;
}

static bool set_user(world *w, random_state *random, world_body *b) {
  const uint32_t any = random_u32(random), user = any % 3 == 0 ? b->setup.user : any;
  b->changed = b->changed || user != b->setup.user;  // the present word changes nothing
  b->setup.user = user;
  return gjk_scene_set_user(&w->scene, b->id, user) == GJK_OK;
}

static bool doze(world *w, random_state *random, world_body *b) {
  if (random_below(random, 3) == 0) {
    b->asleep = false;
    return gjk_scene_wake(&w->scene, b->id) == GJK_OK;
  }
  const bool may = b->setup.kind == GJK_BODY_DYNAMIC;
  b->asleep = b->asleep || may;
  return gjk_scene_sleep(&w->scene, b->id) == (may ? GJK_OK : GJK_ERROR_RANGE);
}

static bool is_sensor(const world_body *b) {
  return b->setup.detail == GJK_DETAIL_SENSOR;
}

// The detail of a pair's report.
static uint8_t detail_of(const world *w, const world_body *a, const world_body *b) {
  const uint8_t own = a->setup.detail > b->setup.detail ? a->setup.detail : b->setup.detail;
  return is_sensor(a) || is_sensor(b) ? GJK_DETAIL_TOUCH : own > w->options.detail ? own : w->options.detail;
}

static bool set_motion(world *w, random_state *random, world_body *b) {
  const uint32_t any = random_below(random, 8);
  const uint8_t motion = (uint8_t)(any < 2 ? any : GJK_MOTION_FAST);
  const gjk_status status = gjk_scene_set_motion(&w->scene, b->id, motion);
  uint32_t kept = 0;
  for (uint32_t i = 0; i < w->options.bodies; i++) {
    kept += w->bodies[i].id.generation != 0 && w->bodies[i].motion != GJK_MOTION_NOT_KEPT;
  }
  if (b->setup.kind == GJK_BODY_STATIC || is_sensor(b)) {
    return status == GJK_ERROR_RANGE;
  }
  if (b->motion == GJK_MOTION_NOT_KEPT && motion != GJK_MOTION_NOT_KEPT && kept == w->options.bodies / 2) {
    return status == GJK_ERROR_CAPACITY;
  }
  if (b->motion == GJK_MOTION_NOT_KEPT) {
    b->last = b->setup.pose;
  }
  b->motion = motion;
  return status == GJK_OK;
}

// Every call refuses the id of a removed body.
static bool use_stale(world *w) {
  const gjk_body_id h = w->stale;
  const gjk_pose pose = GJK_POSE_IDENTITY;
  gjk_body_state state;
  return gjk_scene_remove(&w->scene, h) == GJK_ERROR_BODY_ID &&
         gjk_scene_move(&w->scene, h, &pose) == GJK_ERROR_BODY_ID &&
         gjk_scene_sleep(&w->scene, h) == GJK_ERROR_BODY_ID && gjk_scene_wake(&w->scene, h) == GJK_ERROR_BODY_ID &&
         gjk_scene_set_shape(&w->scene, h, 0, 0) == GJK_ERROR_BODY_ID &&
         gjk_scene_set_filter(&w->scene, h, 1, 1) == GJK_ERROR_BODY_ID &&
         gjk_scene_set_user(&w->scene, h, 1) == GJK_ERROR_BODY_ID &&
         gjk_scene_get(&w->scene, h, &state) == GJK_ERROR_BODY_ID;
}

bool world_change(world *w, random_state *random) {
  world_body *b = &w->bodies[random_below(random, w->options.bodies)];
  const uint32_t what = random_below(random, 100);
  if (what >= 99) {
    return use_stale(w);
  }
  if (b->id.generation == 0) {
    return add(w, random);
  }
  if (what < 80) {
    return w->options.motions && random_below(random, 5) == 0 ? set_motion(w, random, b) : move(w, random, b);
  }
  return what < 83   ? set_shape(w, random, b)
         : what < 86 ? set_filter(w, random, b)
         : what < 88 ? set_user(w, random, b)
         : what < 94 ? doze(w, random, b)
         : what < 97 ? remove_body(w, b)
                     : add(w, random);
}

// Is the pair near, as the scene must report it? A pair that the ceiling on iterations leaves open counts as near. Of a
// pair with a curved shape, boxes farther apart than the margins are the answer.
static bool is_near(const gjk_collider *a, const gjk_collider *b, gjk_q16 margin) {
  gjk_decision decision = {0};
  if (spheres_apart(a, b, margin) || ((is_curved(a) || is_curved(b)) && boxes_apart(a, b, margin))) {
    return false;
  }
  return gjk_within(a, b, margin, NULL, &decision) == GJK_ERROR_ITERATION_LIMIT || decision.yes;
}

static bool tested(const world *w, const world_body *a, const world_body *b) {
  return (a->setup.kind != GJK_BODY_STATIC || b->setup.kind != GJK_BODY_STATIC) &&
         (a->setup.category & b->setup.mask) != 0 && (b->setup.category & a->setup.mask) != 0 &&
         (!w->options.predicate || world_predicate(NULL, a->id, a->setup.user, b->id, b->setup.user));
}

// The distance that a report gives.
static gjk_q16 report_distance(const gjk_collider *a, const gjk_collider *b, gjk_q16 margin, unsigned detail) {
  gjk_distance_result gap = {0};
  gjk_manifold manifold = {0};
  gjk_status status = GJK_OK;
  switch (detail) {
    case GJK_DETAIL_DISTANCE: status = gjk_distance(a, b, NULL, &gap); break;
    case GJK_DETAIL_DEPTH: status = signed_distance(a, b, &gap); break;
    case GJK_DETAIL_CONTACTS: contacts(a, b, margin, &manifold); break;
    default: break;
  }
  if (detail == GJK_DETAIL_DISTANCE || detail == GJK_DETAIL_DEPTH) {
    return status == GJK_ERROR_ITERATION_LIMIT ? gap.lower : gap.distance;
  }
  gjk_q16 least = manifold.count > 0 ? INT32_MAX : 0;
  for (int i = 0; i < manifold.count; i++) {
    least = manifold.contact[i].distance < least ? manifold.contact[i].distance : least;
  }
  return least;
}

static void add_near(const world *w, const world_body *a, const world_body *b, int i, int k, world_list *list) {
  const gjk_collider *x = &a->colliders[i], *y = &b->colliders[k];
  const gjk_q16 margin = a->setup.margin + b->setup.margin;
  if (!is_near(x, y, margin)) {
    return;
  }
  gjk_report *r = &list->report[list->count++];
  memset(r, 0, sizeof *r);
  r->a = a->id;
  r->b = b->id;
  r->part_a = (uint16_t)i;
  r->part_b = (uint16_t)k;
  r->event = GJK_EVENT_PERSIST;
  r->detail = detail_of(w, a, b);
  r->distance = report_distance(x, y, margin, r->detail);
}

static void find_near(const world *w, world_list *list) {
  list->count = 0;
  for (uint32_t m = 0; m < w->options.bodies; m++) {
    for (uint32_t n = m + 1; n < w->options.bodies; n++) {
      const world_body *a = &w->bodies[m], *b = &w->bodies[n];
      if (a->id.generation == 0 || b->id.generation == 0 || !tested(w, a, b)) {
        continue;
      }
      for (int i = 0; i < a->setup.part_count; i++) {
        for (int k = 0; k < b->setup.part_count; k++) {
          add_near(w, a, b, i, k, list);
        }
      }
    }
  }
}

static int order(const void *x, const void *y) {
  const gjk_report *a = x, *b = y;
  const uint32_t key_a[] = {a->a.slot, a->a.generation, a->part_a, a->b.slot, a->b.generation, a->part_b};
  const uint32_t key_b[] = {b->a.slot, b->a.generation, b->part_a, b->b.slot, b->b.generation, b->part_b};
  for (int i = 0; i < 6; i++) {
    if (key_a[i] != key_b[i]) {
      return key_a[i] < key_b[i] ? -1 : 1;
    }
  }
  return 0;
}

void world_sort(world_list *list) {
  qsort(list->report, list->count, sizeof list->report[0], order);
}

static bool of_sensor(const world *w, const gjk_report *r) {
  return is_sensor(&w->bodies[r->a.slot]) || is_sensor(&w->bodies[r->b.slot]);
}

static bool awake(const world *w, gjk_body_id id) {
  const world_body *b = &w->bodies[id.slot];
  return b->setup.kind != GJK_BODY_STATIC && !b->asleep;
}

// Where the pose of a body that stands is, and where that of another one was.
static gjk_pose start_of(const world_body *b) {
  return b->motion != GJK_MOTION_NOT_KEPT ? b->last : b->setup.pose;
}

static bool turns(const world_body *b, int part) {
  const gjk_pose start = start_of(b);
  const gjk_shape *shape = world_shapes[b->parts[part].shape];
  return memcmp(&start.rotation, &b->setup.pose.rotation, sizeof start.rotation) != 0 &&
         (b->parts[part].own_pose || (shape != &ball && shape != &speck));
}

static void collider_at_start(const world_body *b, int part, gjk_collider *c, gjk_vec3 *to) {
  const gjk_pose start = start_of(b), *own = b->parts[part].own_pose ? &b->parts[part].pose : NULL;
  gjk_pose pose = start, end = b->setup.pose;
  gjk_collider_init(c, world_shapes[b->parts[part].shape], NULL, 0);
  if (own != NULL) {
    gjk_pose_compose(&start, own, &pose);
    gjk_pose_compose(&b->setup.pose, own, &end);
  }
  gjk_collider_pose(c, &pose);
  *to = end.position;
}

static bool were_near(const world *w, const gjk_report *pair) {
  for (uint32_t i = 0; i < w->near.count; i++) {
    if (order(&w->near.report[i], pair) == 0) {
      return true;
    }
  }
  return false;
}

// Do two parts touch on their ways, and where? Pre: a has the lower slot.
static bool touch(const world_body *a, int i, const world_body *b, int k, uint32_t *fraction, bool *at_start) {
  gjk_collider x, y;
  gjk_vec3 to_x, to_y;
  collider_at_start(a, i, &x, &to_x);
  collider_at_start(b, k, &y, &to_y);
  if (!turns(a, i) && !turns(b, k)) {
    const gjk_cast_path path = {&to_x, &to_y, 0};
    gjk_cast_result result;
    const bool hit = gjk_cast(&x, &y, &path, &result) == GJK_OK && result.hit;
    *fraction = hit ? (uint32_t)result.fraction : 0;
    *at_start = hit && result.inside;
    return hit;
  }
  gjk_motion of_x, of_y;
  memset(&of_x, 0, sizeof of_x);
  of_y = of_x;
  of_x.from = start_of(a);
  of_x.to = a->setup.pose;
  of_y.from = start_of(b);
  of_y.to = b->setup.pose;
  if (b->parts[k].own_pose) {
    gjk_pose_compose(&of_y.from, &b->parts[k].pose, &of_y.from);
    gjk_pose_compose(&of_y.to, &b->parts[k].pose, &of_y.to);
  }
  if (a->parts[i].own_pose) {
    gjk_pose_compose(&of_x.from, &a->parts[i].pose, &of_x.from);
    gjk_pose_compose(&of_x.to, &a->parts[i].pose, &of_x.to);
  }
  const gjk_impact_setup setup = {0, WORLD_TOLERANCE, 0};
  gjk_impact_result result;
  const gjk_status status = gjk_time_of_impact(&x, &of_x, &y, &of_y, &setup, &result);
  *fraction = (uint32_t)result.lower;
  *at_start = status == GJK_OK && *fraction == 0;
  return status == GJK_ERROR_ITERATION_LIMIT || (status == GJK_OK && result.hit);
}

static bool stands(const world_body *b) {
  const gjk_pose start = start_of(b);
  return memcmp(&start, &b->setup.pose, sizeof start) == 0;
}

// The first impact of a fast body, by a search of all parts.
static bool find_impact(world *w, const world_body *f, gjk_report *out) {
  bool found = false;
  for (uint32_t slot = 0; slot < w->options.bodies; slot++) {
    const world_body *o = &w->bodies[slot];
    const bool first = f->id.slot < slot;
    const world_body *a = first ? f : o, *b = first ? o : f;
    if (o == f || o->id.generation == 0 || is_sensor(o) || (stands(f) && stands(o)) || !tested(w, a, b)) {
      continue;
    }
    for (int k = 0; k < o->setup.part_count; k++) {
      for (int i = 0; i < f->setup.part_count; i++) {
        gjk_report pair;
        uint32_t fraction;
        bool at_start;
        memset(&pair, 0, sizeof pair);
        pair.a = a->id;
        pair.b = b->id;
        pair.part_a = (uint16_t)(first ? i : k);
        pair.part_b = (uint16_t)(first ? k : i);
        if (!touch(a, pair.part_a, b, pair.part_b, &fraction, &at_start)) {
          continue;
        }
        if (at_start && were_near(w, &pair)) {
          world_expected.starts++;
        } else if (!found || (int32_t)fraction < out->fraction) {
          found = true;
          memset(out, 0, sizeof *out);
          out->a = f->id;
          out->b = o->id;
          out->part_a = (uint16_t)i;
          out->part_b = (uint16_t)k;
          out->event = GJK_EVENT_IMPACT;
          out->detail = detail_of(w, f, o);
          out->fraction = (gjk_q30)fraction;
          world_expected.turning += turns(f, i) || turns(o, k);
        }
      }
    }
  }
  return found;
}

// Adds the impacts of an update. With a low ceiling the first one may be open: then the list has none.
static void add_impacts(world *w, world_list *out) {
  for (uint32_t i = 0; i < w->options.bodies; i++) {
    const world_body *b = &w->bodies[i];
    if (b->id.generation == 0 || b->motion != GJK_MOTION_FAST || (stands(b) && b->asleep) || world_is_tight()) {
      continue;
    }
    gjk_report impact;
    if (find_impact(w, b, &impact)) {
      out->report[out->count++] = impact;
      world_expected.impacts++;
    }
  }
  for (uint32_t i = 0; i < w->options.bodies; i++) {
    w->bodies[i].last = w->bodies[i].setup.pose;
  }
}

// The user word of a body; 0 of one that was removed.
static uint32_t user_of(const world *w, gjk_body_id id) {
  const world_body *b = &w->bodies[id.slot];
  return b->id.generation == id.generation ? b->setup.user : 0;
}

void world_expect(world *w, world_list *out) {
  static world_list now;
  find_near(w, &now);
  world_sort(&now);
  now.words = out->words = w->options.words;
  out->count = 0;
  uint32_t i = 0, k = 0;
  while (i < w->near.count || k < now.count) {  // merge: both are sorted
    const int side = i == w->near.count ? 1 : k == now.count ? -1 : order(&w->near.report[i], &now.report[k]);
    gjk_report r = side < 0 ? w->near.report[i] : now.report[k];
    r.event = side < 0 ? GJK_EVENT_END : side > 0 ? GJK_EVENT_BEGIN : GJK_EVENT_PERSIST;
    if (side < 0) {
      r.distance = 0;
      const bool there =
          w->bodies[r.a.slot].id.generation == r.a.generation && w->bodies[r.b.slot].id.generation == r.b.generation;
      r.detail = there ? r.detail : w->options.detail;
    }
    bool told = side == 0 && w->near.report[i].still && !w->bodies[r.a.slot].changed && !w->bodies[r.b.slot].changed;
    r.still = told;
    if (side != 0 || (w->options.persist && (awake(w, r.a) || awake(w, r.b)) && !of_sensor(w, &r))) {
      told = true;
      w->still += r.still;
      out->stamp[out->count] = side > 0 ? 0 : w->near.stamp[i];
      out->report[out->count++] = r;
    }
    if (side >= 0) {
      now.stamp[k] = side > 0 ? 0 : w->near.stamp[i];
      now.report[k].still = told;
    }
    i += side <= 0;
    k += side >= 0;
  }
  if (w->options.motions) {
    add_impacts(w, out);
  }
  for (uint32_t n = 0; n < out->count; n++) {
    out->report[n].user_a = user_of(w, out->report[n].a);
    out->report[n].user_b = user_of(w, out->report[n].b);
  }
  w->near = now;
  for (uint32_t n = 0; n < w->options.bodies; n++) {
    w->bodies[n].changed = false;
  }
}

static bool same(const gjk_report *a, const gjk_report *b) {
  return order(a, b) == 0 && a->event == b->event && a->detail == b->detail && a->distance == b->distance &&
         a->still == b->still && a->fraction == b->fraction && a->user_a == b->user_a && a->user_b == b->user_b;
}

// The words of a pair after a writing.
static uint32_t word_of(const gjk_report *r, uint32_t stamp, uint32_t number) {
  const uint32_t pair = (r->a.slot * 64 + r->b.slot) * 64 + r->part_a * 8u + r->part_b;
  return stamp == 0 ? 0 : (stamp * 64 + number) * UINT32_C(2654435761) ^ pair;
}

// Does a report that the scene made have the words that are expected?
static bool same_words(const gjk_report *r, uint32_t stamp, uint8_t words) {
  if (words == 0 || r->event == GJK_EVENT_IMPACT) {
    return r->words == NULL;
  }
  bool fine = r->words != NULL;
  for (uint32_t i = 0; i < words && fine; i++) {
    fine = r->words[i] == word_of(r, stamp, i);
  }
  return fine;
}

bool world_same(const world_list *expected, const world_list *actual) {
  for (uint32_t i = 0; i < expected->count && i < actual->count; i++) {
    if (!same(&expected->report[i], &actual->report[i]) ||
        !same_words(&actual->report[i], expected->stamp[i], expected->words)) {
      return false;
    }
  }
  return expected->count == actual->count;
}

bool world_write_words(world *w, random_state *random) {
  gjk_report r;
  uint32_t cursor = 0, count = 0;
  bool found = false;
  w->stamp++;
  while (gjk_scene_next_near(&w->scene, &cursor, &r, &found) == GJK_OK && found) {
    uint32_t at = 0;
    while (at < w->near.count && order(&w->near.report[at], &r) != 0) {
      at++;
    }
    if (at == w->near.count || r.still != w->near.report[at].still ||
        !same_words(&r, w->near.stamp[at], w->options.words)) {
      return false;
    }
    if (w->options.words > 0 && random_below(random, 2) == 0) {
      w->near.stamp[at] = w->stamp;
      for (uint32_t i = 0; i < w->options.words; i++) {
        r.words[i] = word_of(&r, w->stamp, i);
      }
    }
    count++;
  }
  return count == w->near.count;
}
