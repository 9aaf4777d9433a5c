// Any block of a scene: small capacities, and everything else as it may be.
#ifndef PROVE_SCENE_ANY_H
#define PROVE_SCENE_ANY_H

#include "colliders.h"
#include "src/scene/gjk_scene_block.h"

#define BODIES 3
#define PARTS 3
#define OWN_POSES 2
#define PAIRS 4
#define SHAPES 2
#define UNIT 0x40002000L  // of a rotation's component
#define GAP 40            // words, more than any record has
#define NAMED 3           // vertices that queries name

// A driver of kept motions defines how many before it includes this file.
#ifdef MOTIONS
#define KEPT_MOTIONS gjk_scene_kept kept[MOTIONS];
#else
#define MOTIONS 0
#define KEPT_MOTIONS
#endif

// As src/scene/gjk_scene_memory.c lays it out.
typedef struct any_block {
  gjk_scene_header header;
  gjk_scene_body bodies[BODIES];
  gjk_scene_part parts[PARTS];
  gjk_scene_node nodes[PARTS];
  gjk_scene_own_pose own_poses[OWN_POSES];
  gjk_scene_pair pairs[PAIRS];
  uint32_t queue[PAIRS];
  uint32_t slots[1];
  KEPT_MOTIONS
  uint32_t words[PAIRS];
} any_block;

// The same with room between the sections that is never set, so that an index beyond one of them shows.
typedef struct apart_block {
  gjk_scene_header header;
  uint32_t gap_a[GAP];
  gjk_scene_body bodies[BODIES];
  uint32_t gap_b[GAP];
  gjk_scene_part parts[PARTS];
  uint32_t gap_c[GAP];
  gjk_scene_node nodes[PARTS];
  uint32_t gap_d[GAP];
  gjk_scene_own_pose own_poses[OWN_POSES];
  uint32_t gap_e[GAP];
  gjk_scene_pair pairs[PAIRS];
  uint32_t gap_f[GAP];
  uint32_t queue[PAIRS];
  uint32_t gap_g[GAP];
  uint32_t slots[1];
  uint32_t gap_h[GAP];
  gjk_cache caches[PAIRS];
  uint32_t gap_i[GAP];
  uint32_t words[PAIRS];
  uint32_t gap_j[GAP];
  KEPT_MOTIONS
} apart_block;

static any_block block;
static gjk_shape shape;
static const gjk_shape *shapes[SHAPES];

static uint32_t any_uint32(void) {
  return Frama_C_unsigned_long_interval(0, UINT32_MAX);
}

static bool named_vertex(const gjk_collider *c, uint16_t number, gjk_vec3 *offset) {
  //@ assert number < NAMED;
  *offset = any_vec3(ANY_OFFSET);
  return true;
}

static const gjk_shape_class with_vertices = {.measure = any_measure,
                                              .pose = keep_pose,
                                              .support = any_support,
                                              .refine = any_refine,
                                              .vertex = named_vertex,
                                              .kind = GJK_KIND_SMOOTH};

static void any_shapes(void) {
  const int32_t vertices = any_between(0, 1);
  //@ split vertices;
  shape.type = vertices != 0 ? &with_vertices : &curved;
  shape.convex_radius = any_between(0, GJK_RADIUS_MAX);
  shape.count = any_uint16();
  shapes[0] = &shape;
  shapes[1] = any_bool() ? &shape : NULL;
}

// An index below count.
static uint32_t any_below(uint32_t count) {
  return Frama_C_unsigned_long_interval(0, count - 1);
}

// An index below count, or none: without a branch, whose outcomes Eva would keep apart.
static uint32_t any_index(uint32_t count) {
  return any_below(count + 1) - 1;
}

static uint32_t any_node(void) {
  return any_below(2) * GJK_SCENE_LEAF | any_below(PARTS);
}

static gjk_aabb any_box(void) {
  const gjk_aabb box = {any_position(), any_position()};
  return box;
}

static gjk_body_id any_body_handle(void) {
  const gjk_body_id body = {any_uint32(), any_uint32()};
  return body;
}

static void any_body(gjk_scene_body *body) {
  body->generation = any_uint32();
  body->position = any_position();
  body->rotation.x = any_between(-UNIT, UNIT);
  body->rotation.y = any_between(-UNIT, UNIT);
  body->rotation.z = any_between(-UNIT, UNIT);
  body->rotation.w = any_between(-UNIT, UNIT);
  body->category = any_uint32();
  body->mask = any_uint32();
  body->user = any_uint32();
  body->margin = any_between(0, GJK_RADIUS_MAX);
  body->first = any_index(PARTS);
  body->next_moved = any_index(BODIES);
  body->parts = any_uint16();
  body->kind_detail = (uint8_t)(any_between(0, GJK_BODY_DYNAMIC) | any_between(0, GJK_DETAIL_SENSOR) << 4);
  body->flags = (uint8_t)any_between(0, UINT8_MAX);
}

static void any_part(gjk_scene_part *part) {
  part->next = any_index(PARTS);
  part->body = any_below(BODIES);
  part->parent = any_index(PARTS);
  part->pairs = any_index(2 * PAIRS);
  part->own_pose = any_index(OWN_POSES);
  part->motion = any_uint32();
  part->centre = any_position();
  part->local_centre = any_position();
  for (int i = 0; i < 3; i++) {
    part->frame[i] = any_position();
    part->fraction[i] = (int8_t)any_between(INT8_MIN, INT8_MAX);
  }
  part->core_radius = any_between(4, GJK_RADIUS_MAX + 4);
  part->exact = any_box();
  part->enlarged = any_box();
  part->shape = 0;
  part->number = any_uint16();
  part->state = any_uint32();
}

static void any_inner(gjk_scene_node *node) {
  node->child[0] = any_node();
  node->child[1] = any_node();
  node->parent = any_index(PARTS);
  node->height = any_below(GJK_SCENE_DEPTH);
  node->box = any_box();
}

static void any_own_pose(gjk_scene_own_pose *own_pose) {
  own_pose->next = any_index(PARTS > OWN_POSES ? PARTS : OWN_POSES);
  own_pose->pose = any_pose();
}

static void any_pair(gjk_scene_pair *pair) {
  for (int i = 0; i < 2; i++) {
    pair->ends.linked.part[i] = any_below(PARTS);
    pair->ends.linked.next[i] = any_index(2 * PAIRS);
    pair->ends.linked.previous[i] = any_index(2 * PAIRS);
  }
  pair->gap = any_int32();
  for (int i = 0; i < 3; i++) {
    pair->hint.direction[i] = (int16_t)any_between(INT16_MIN, INT16_MAX);
  }
  for (int i = 0; i < 4; i++) {
    pair->a[i] = (uint8_t)any_between(0, UINT8_MAX);
    pair->b[i] = (uint8_t)any_between(0, UINT8_MAX);
  }
  pair->state = (uint8_t)any_between(0, UINT8_MAX);
  pair->outcome = (uint8_t)(any_between(0, GJK_SCENE_OUTCOMES - 1) + any_between(0, 1) * GJK_SCENE_UNSETTLED +
                            any_between(0, 1) * GJK_SCENE_MEASURED + any_between(0, 1) * GJK_SCENE_TOLD);
}

static void any_pool(gjk_scene_pool *pool, uint32_t free) {
  pool->fresh = any_below(pool->capacity + 1);
  pool->free = any_index(free);
  pool->count = any_below(pool->capacity + 1);
}

static void any_header(gjk_scene_header *h) {
  h->sealed = any_uint32();
  h->config.box_margin = any_between(0, GJK_RADIUS_MAX);
  h->config.detail = (uint8_t)any_between(0, GJK_DETAIL_CONTACTS);
  h->config.persist = any_bool();
  h->config.retest_all = any_bool();
  any_pool(&h->bodies, BODIES);
  any_pool(&h->parts, PARTS);
  any_pool(&h->nodes, PARTS);
  any_pool(&h->own_poses, OWN_POSES);
  any_pool(&h->pairs, PAIRS);
  h->lowest = any_below(2);
  h->moved = any_index(BODIES);
  h->gone = any_index(PAIRS);
  h->phase = any_below(GJK_SCENE_REPORTING + 1);
  h->queued = any_below(PAIRS + 1);
  h->next_test = any_below(PAIRS + 1);
  h->next_report = any_below(PAIRS + 1);
  h->updates = any_uint32();
  h->most_detail = any_below(GJK_DETAIL_CONTACTS + 1);
  h->refused = any_uint32();
  h->kept = 0;  // none more than the configuration has
  Frama_C_make_unknown((char *)&h->stats, sizeof h->stats);
}

static bool any_answer(void *user, gjk_body_id a, uint32_t user_a, gjk_body_id b, uint32_t user_b) {
  return any_bool();
}

static gjk_epa_cell cells[1];
static const gjk_workspace workspace = {cells, 1};
static gjk_manifold manifolds[1];

static void any_tree(gjk_scene_header *h) {
  const int32_t empty = any_between(0, 1);
#if MOTIONS == 0
  //@ split empty;
#endif
  h->root = empty != 0 ? GJK_SCENE_NONE : any_node();
}

static void any_bindings(gjk_scene_bindings *bindings) {
  const int32_t able = any_between(0, 2);
  bindings->predicate = any_bool() ? any_answer : NULL;
  bindings->user = NULL;
  bindings->details = able == 0 ? NULL : able == 1 ? &gjk_scene_depth : &gjk_scene_contacts;
  bindings->workspace = any_bool() ? &workspace : NULL;
  bindings->manifolds = any_bool() ? manifolds : NULL;
  bindings->keeps_manifolds = any_bool();
}

#if MOTIONS > 0
static void any_motions(gjk_scene *scene, apart_block *b) {
  scene->bindings.motion = &gjk_scene_motion;
  b->header.kept_at = offsetof(apart_block, kept);
  b->header.kept = any_below(MOTIONS + 1);
  b->header.next_test = any_below(PAIRS + MOTIONS + 1);
  b->header.next_report = any_below(PAIRS + MOTIONS + 1);
  for (int i = 0; i < MOTIONS; i++) {
    gjk_scene_kept *k = &b->kept[i];
    k->slot = any_below(BODIES);
    k->last = any_pose();
    k->last.rotation.x = any_between(-UNIT, UNIT);
    k->last.rotation.y = any_between(-UNIT, UNIT);
    k->last.rotation.z = any_between(-UNIT, UNIT);
    k->last.rotation.w = any_between(-UNIT, UNIT);
    k->other = any_index(PARTS);
    k->fraction = any_uint32();
    k->number = any_uint16();
    k->state = any_uint16();
  }
}
#endif

// Every field of a block holds what gjk_scene_check lets it hold by itself.
static bool any_scene(gjk_scene *scene, apart_block *b) {
  const gjk_scene_config config = {BODIES, PARTS, OWN_POSES, PAIRS, 0, 0, 0, 0, 1, 1, MOTIONS};
  const gjk_scene_bindings none = {0};
  if (gjk_scene_init(scene, &config, &block, sizeof block, shapes, SHAPES, any_bool() ? &none : NULL) != GJK_OK) {
    return false;
  }
  b->header = block.header;
  b->header.bodies.at = offsetof(apart_block, bodies);
  b->header.parts.at = offsetof(apart_block, parts);
  b->header.nodes.at = offsetof(apart_block, nodes);
  b->header.own_poses.at = offsetof(apart_block, own_poses);
  b->header.pairs.at = offsetof(apart_block, pairs);
  b->header.queue_at = offsetof(apart_block, queue);
  b->header.slots_at = offsetof(apart_block, slots);
  b->header.caches_at = offsetof(apart_block, caches);
  b->header.words_at = offsetof(apart_block, words);
  Frama_C_make_unknown((char *)b->caches, sizeof b->caches);
  Frama_C_make_unknown((char *)b->words, sizeof b->words);
  scene->block = b;
  any_header(&b->header);
  for (int i = 0; i < PARTS; i++) {
    any_body(&b->bodies[i]);
    any_part(&b->parts[i]);
    any_inner(&b->nodes[i]);
  }
  for (int i = 0; i < OWN_POSES; i++) {
    any_own_pose(&b->own_poses[i]);
  }
  for (int i = 0; i < PAIRS; i++) {
    any_pair(&b->pairs[i]);
    b->queue[i] = any_below(PAIRS);
  }
  b->slots[0] = any_below(1u << BODIES);
  // What Eva keeps apart comes last.
  any_shapes();
  any_tree(&b->header);
  any_bindings(&scene->bindings);
#if MOTIONS > 0
  any_motions(scene, b);
#endif
  return true;
}

#endif
