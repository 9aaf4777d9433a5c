// The block of a scene: its layout, its pools, and how a handle finds its arrays.
#include "../arith/gjk_memory.h"
#include "gjk_scene_block.h"

#define ORDER UINT32_C(0x01020304)  // another byte order reads another number

// Every build must lay the header out alike: a block may come from another one.
typedef char gjk_scene_header_is_fixed[sizeof(gjk_scene_header) == GJK_SCENE_HEADER_BYTES ? 1 : -1];

static gjk_status check_config(const gjk_scene_config *c) {
  if (c->bodies < 1 || c->bodies > GJK_SCENE_BODIES_MAX || c->parts < 1 || c->parts > GJK_SCENE_BODIES_MAX ||
      c->own_poses > GJK_SCENE_BODIES_MAX || c->pairs < 1 || c->pairs > GJK_SCENE_PAIRS_MAX || c->box_margin < 0 ||
      c->box_margin > GJK_RADIUS_MAX || c->persist > 1 || c->retest_all > 1 ||
      c->pair_words > GJK_SCENE_PAIR_WORDS_MAX || c->detail > GJK_DETAIL_CONTACTS ||
      c->motions > GJK_SCENE_BODIES_MAX) {
    return GJK_ERROR_RANGE;
  }
  return GJK_OK;
}

static void set_pool(gjk_scene_pool *pool, uint32_t capacity, uint32_t size, uint32_t *at) {
  pool->at = *at;
  pool->capacity = capacity;
  pool->fresh = 0;
  pool->free = GJK_SCENE_NONE;
  pool->count = 0;
  *at += capacity * size;
}

// Lays out the arrays of a block for this configuration.
//
// at <= 2^20 (60 + 144 + 40 + 32 + 44 + 1) + 2^22 (44 + 4 + 4 * 32 + 24) + 400 < 2^31
static void lay_out(const gjk_scene_config *c, gjk_scene_header *h) {
  uint32_t at = sizeof *h;
  set_pool(&h->bodies, c->bodies, sizeof(gjk_scene_body), &at);
  set_pool(&h->parts, c->parts, sizeof(gjk_scene_part), &at);
  set_pool(&h->nodes, c->parts, sizeof(gjk_scene_node), &at);  // inner nodes are one less than leaves
  set_pool(&h->own_poses, c->own_poses, sizeof(gjk_scene_own_pose), &at);
  set_pool(&h->pairs, c->pairs, sizeof(gjk_scene_pair), &at);
  h->queue_at = at;
  at += c->pairs * (uint32_t)sizeof(uint32_t);
  h->slots_at = at;
  at += (c->bodies + 31) / 32 * (uint32_t)sizeof(uint32_t);
  h->kept_at = at;
  at += c->motions * (uint32_t)sizeof(gjk_scene_kept);
  h->words_at = at;
  at += c->pairs * c->pair_words * (uint32_t)sizeof(uint32_t);
  h->caches_at = at;
  if (c->detail == GJK_DETAIL_CONTACTS) {
    at += (c->pairs * (uint32_t)sizeof(gjk_cache) + 3) / 4 * 4;
  }
  h->bytes = at;
}

size_t gjk_scene_bytes(const gjk_scene_config *config) {
  gjk_scene_header h;
  if (config == NULL || check_config(config) != GJK_OK) {
    return 0;
  }
  lay_out(config, &h);
  // not reached: a size_t of 16 bits, which no host has
  return (uint32_t)(size_t)h.bytes == h.bytes ? (size_t)h.bytes : 0;
}

static void *at(void *block, uint32_t offset) {
  return (unsigned char *)block + (size_t)offset;
}

// Writes the whole handle.
static void set_handle(gjk_scene *scene, void *block, const gjk_shape *const *shapes, uint16_t shape_count,
                       const gjk_scene_bindings *bindings) {
  scene->block = block;
  scene->shapes = shapes;
  scene->shape_count = shape_count;
  gjk_scene_set_bindings(scene, bindings);
}

gjk_status gjk_scene_init(gjk_scene *scene, const gjk_scene_config *config, void *block, size_t bytes,
                          const gjk_shape *const *shapes, uint16_t shape_count, const gjk_scene_bindings *bindings) {
  if (scene == NULL || config == NULL || block == NULL || shapes == NULL) {
    return GJK_ERROR_NULL;
  }
  const gjk_status status = gjk_is_aligned(block) ? check_config(config) : GJK_ERROR_RANGE;
  const size_t needed = gjk_scene_bytes(config);
  if (status != GJK_OK) {
    return status;
  }
  // not reached: needed == 0: a size_t of 16 bits, which no host has
  if (needed == 0 || bytes < needed) {
    return GJK_ERROR_CAPACITY;
  }
  if (gjk_scene_lacks(bindings != NULL ? bindings->details : NULL, config->detail)) {
    return GJK_ERROR_UNSUPPORTED;
  }
  gjk_zero(block, needed);
  gjk_scene_header *h = (gjk_scene_header *)block;
  h->magic = GJK_SCENE_MAGIC;
  h->version = GJK_SCENE_VERSION;
  h->order = ORDER;
  h->iterations = GJK_ITERATIONS_MAX;
  h->casts = GJK_SCENE_CASTS;
  h->config = *config;
  h->most_detail = config->detail;
  lay_out(config, h);
  h->root = GJK_SCENE_NONE;
  h->moved = GJK_SCENE_NONE;
  h->gone = GJK_SCENE_NONE;
  uint32_t *slots = (uint32_t *)at(block, h->slots_at);
  for (uint32_t i = 0; i < config->bodies; i++) {
    slots[i / 32] |= UINT32_C(1) << i % 32;
  }
  set_handle(scene, block, shapes, shape_count, bindings);
  return GJK_OK;
}

static bool same_pool(const gjk_scene_pool *a, const gjk_scene_pool *b) {
  return a->at == b->at && a->capacity == b->capacity && b->count <= b->fresh && b->fresh <= b->capacity;
}

gjk_status gjk_scene_check_header(const void *block, size_t bytes) {
  const gjk_scene_header *h = (const gjk_scene_header *)block;
  gjk_scene_header expected;
  if (bytes < sizeof *h) {
    return GJK_ERROR_CAPACITY;
  }
  if (h->magic != GJK_SCENE_MAGIC || h->version != GJK_SCENE_VERSION || h->order != ORDER ||
      h->iterations != GJK_ITERATIONS_MAX || h->casts != GJK_SCENE_CASTS || check_config(&h->config) != GJK_OK) {
    return GJK_ERROR_CORRUPT;
  }
  lay_out(&h->config, &expected);
  if (h->bytes != expected.bytes || h->queue_at != expected.queue_at || h->slots_at != expected.slots_at ||
      h->kept_at != expected.kept_at || h->words_at != expected.words_at || h->caches_at != expected.caches_at ||
      h->kept > h->config.motions || !same_pool(&expected.bodies, &h->bodies) ||
      !same_pool(&expected.parts, &h->parts) || !same_pool(&expected.nodes, &h->nodes) ||
      !same_pool(&expected.own_poses, &h->own_poses) || !same_pool(&expected.pairs, &h->pairs)) {
    return GJK_ERROR_CORRUPT;
  }
  return bytes < h->bytes ? GJK_ERROR_CAPACITY : GJK_OK;
}

gjk_status gjk_scene_attach(gjk_scene *scene, void *block, size_t bytes, const gjk_shape *const *shapes,
                            uint16_t shape_count, const gjk_scene_bindings *bindings) {
  if (scene == NULL || block == NULL || shapes == NULL) {
    return GJK_ERROR_NULL;
  }
  const gjk_status status = gjk_is_aligned(block) ? gjk_scene_check_header(block, bytes) : GJK_ERROR_RANGE;
  if (status != GJK_OK) {
    return status;
  }
  set_handle(scene, block, shapes, shape_count, bindings);
  return GJK_OK;
}

gjk_status gjk_scene_view_of(const gjk_scene *scene, gjk_scene_view *out) {
  if (scene == NULL || scene->block == NULL || scene->shapes == NULL) {
    return GJK_ERROR_NULL;
  }
  gjk_scene_header *h = (gjk_scene_header *)scene->block;
  if (h->magic != GJK_SCENE_MAGIC || h->version != GJK_SCENE_VERSION || h->order != ORDER) {
    return GJK_ERROR_CORRUPT;
  }
  out->scene = scene;
  out->header = h;
  out->bodies = (gjk_scene_body *)at(h, h->bodies.at);
  out->parts = (gjk_scene_part *)at(h, h->parts.at);
  out->nodes = (gjk_scene_node *)at(h, h->nodes.at);
  out->own_poses = (gjk_scene_own_pose *)at(h, h->own_poses.at);
  out->pairs = (gjk_scene_pair *)at(h, h->pairs.at);
  out->queue = (uint32_t *)at(h, h->queue_at);
  out->slots = (uint32_t *)at(h, h->slots_at);
  out->kept = (gjk_scene_kept *)at(h, h->kept_at);
  out->words = (uint32_t *)at(h, h->words_at);
  const bool kept = h->config.detail == GJK_DETAIL_CONTACTS && h->config.retest_all == 0;
  out->caches = kept ? (gjk_cache *)at(h, h->caches_at) : NULL;
  return GJK_OK;
}

gjk_status gjk_scene_edit(gjk_scene *scene, gjk_scene_view *out) {
  const gjk_status status = gjk_scene_view_of(scene, out);
  if (status != GJK_OK) {
    return status;
  }
  if (out->header->phase != GJK_SCENE_IDLE) {
    return GJK_ERROR_BUSY;
  }
  out->header->sealed = 0;
  return GJK_OK;
}

uint32_t gjk_scene_pool_take(gjk_scene_view *v, gjk_scene_pool *pool, uint32_t size) {
  pool->count++;
  const uint32_t index = pool->free;
  if (index == GJK_SCENE_NONE) {
    //@ assert pool->fresh < pool->capacity;
    return pool->fresh++;
  }
  //@ assert index < pool->fresh;
  const uint32_t *record = (const uint32_t *)at(v->header, pool->at + index * size);
  pool->free = *record;
  return index;
}

void gjk_scene_pool_give(gjk_scene_view *v, gjk_scene_pool *pool, uint32_t size, uint32_t index) {
  uint32_t *record = (uint32_t *)at(v->header, pool->at + index * size);
  *record = pool->free;
  pool->free = index;
  pool->count--;
}

gjk_status gjk_scene_body_of(const gjk_scene_view *v, gjk_body_id id, gjk_scene_body **out) {
  if (id.slot >= v->header->config.bodies || id.generation % 2 == 0 || v->bodies[id.slot].generation != id.generation) {
    return GJK_ERROR_BODY_ID;
  }
  *out = &v->bodies[id.slot];
  return GJK_OK;
}
