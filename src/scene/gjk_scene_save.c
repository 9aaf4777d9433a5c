// The hash of a scene, its seal, and the opening of a block that may come from anywhere.
#include "gjk_scene_block.h"

GJK_ONE_COPY static uint64_t mix(uint64_t hash, uint32_t word) {
  return gjk_hash_step(hash, word);
}

static uint64_t mix_pose(uint64_t hash, const gjk_vec3 *position, const gjk_quat *rotation) {
  return gjk_scene_mix_rotation(gjk_scene_mix_vec3(hash, position), rotation);
}

static uint64_t mix_body(uint64_t hash, const gjk_scene_view *v, uint32_t slot) {
  const gjk_scene_body *body = &v->bodies[slot];
  hash = mix(mix(hash, slot), body->generation);
  if (body->generation % 2 == 0) {
    return hash;
  }
  hash = mix_pose(hash, &body->position, &body->rotation);
  hash = mix(mix(mix(mix(hash, body->category), body->mask), body->user), (uint32_t)body->margin);
  hash = mix(hash, (uint32_t)body->kind_detail << 16 | gjk_scene_part_count(body, v->parts));
  hash = mix(hash, body->flags & GJK_SCENE_ASLEEP);
  for (uint32_t i = body->first; i != GJK_SCENE_NONE; i = v->parts[i].next) {
    const gjk_scene_part *p = &v->parts[i];
    hash = mix(hash, p->shape);
    const uint32_t own_pose = p->own_pose;
    if (own_pose != GJK_SCENE_NONE) {
      const gjk_pose *pose = &v->own_poses[own_pose].pose;
      hash = mix_pose(mix(hash, 1), &pose->position, &pose->rotation);
    }
  }
  return hash;
}

static uint64_t hash_of_near(const gjk_report *r, uint32_t words) {
  uint64_t hash = mix(mix(mix(mix(1, r->a.slot), r->a.generation), r->b.slot), r->b.generation);
  hash = mix(hash, (uint32_t)r->part_a << 16 | r->part_b);
  hash = mix(mix(hash, r->event), (uint32_t)r->distance);
  for (uint32_t i = 0; i < words; i++) {
    hash = mix(hash, r->words[i]);
  }
  return hash;
}

gjk_status gjk_scene_hash(const gjk_scene *scene, uint64_t *out) {
  gjk_scene_view v;
  const gjk_status status = out == NULL ? GJK_ERROR_NULL : gjk_scene_view_of(scene, &v);
  if (status != GJK_OK) {
    return status;
  }
  const gjk_scene_header *h = v.header;
  if (h->phase != GJK_SCENE_IDLE) {
    return GJK_ERROR_BUSY;
  }
  const gjk_scene_config *c = &h->config;
  uint64_t hash = mix(mix(0, (uint32_t)c->detail << 16 | (uint32_t)c->pair_words << 8 | c->persist), h->updates);
  hash = mix(mix(hash, gjk_scene_cells(c)), h->iterations);
  for (uint32_t slot = 0; slot < h->bodies.fresh; slot++) {
    if (v.bodies[slot].generation != 0) {
      hash = mix_body(hash, &v, slot);
    }
  }
  for (uint32_t i = 0; i < h->kept; i++) {
    const gjk_scene_kept *k = &v.kept[i];
    const bool fast = (v.bodies[k->slot].flags & GJK_SCENE_FAST) != 0;
    hash = mix_pose(mix(mix(hash, k->slot), fast), &k->last.position, &k->last.rotation);
  }
  // The sum does not depend on the order of pairs, which depends on history.
  uint64_t pairs = 0;
  uint32_t cursor = 0;
  bool found;
  do {  // ends: the cursor reaches the end of the pairs
    gjk_report near;
    (void)gjk_scene_next_near(scene, &cursor, &near, &found);
    pairs += found ? hash_of_near(&near, c->pair_words) : 0;
  } while (found);
  *out = mix(mix(hash, (uint32_t)(pairs >> 32)), (uint32_t)(pairs & UINT32_MAX));
  return GJK_OK;
}

// A hash over every word of the block but sealed and checksum.
static uint64_t checksum_of(const gjk_scene_header *h) {
  const uint32_t *word = (const uint32_t *)(const void *)h, *seal = &h->sealed, *end = word + h->bytes / sizeof *word;
  uint64_t hash = 0;
  for (; word < end; word++) {
    if (word < seal || word > &h->checksum[1]) {
      hash = mix(hash, *word);
    }
  }
  return hash;
}

gjk_status gjk_scene_seal(gjk_scene *scene) {
  gjk_scene_view v;
  const gjk_status status = gjk_scene_view_of(scene, &v);
  if (status == GJK_OK) {
    const uint64_t sum = checksum_of(v.header);
    v.header->checksum[0] = (uint32_t)(sum & UINT32_MAX);
    v.header->checksum[1] = (uint32_t)(sum >> 32);
    v.header->sealed = 1;
  }
  return status;
}

gjk_status gjk_scene_open(gjk_scene *scene, void *block, size_t bytes, const gjk_shape *const *shapes,
                          uint16_t shape_count, const gjk_scene_bindings *bindings) {
  gjk_scene opened;
  gjk_status status =
      scene == NULL ? GJK_ERROR_NULL : gjk_scene_attach(&opened, block, bytes, shapes, shape_count, bindings);
  if (status != GJK_OK) {
    return status;
  }
  const gjk_scene_header *h = (const gjk_scene_header *)block;
  const uint64_t sum = checksum_of(h);
  if (h->sealed != 1 || h->checksum[0] != (uint32_t)(sum & UINT32_MAX) || h->checksum[1] != (uint32_t)(sum >> 32)) {
    return GJK_ERROR_CORRUPT;
  }
  status = gjk_scene_check(&opened);
  if (status == GJK_OK) {
    *scene = opened;
  }
  return status;
}
