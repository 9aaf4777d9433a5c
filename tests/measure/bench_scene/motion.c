// Records traffic.
#include "motion.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static float round_to(int32_t lsb, float way) {
  const double exact = lsb / 65536.0;
  const float near = (float)exact;
  return (way < 0 ? near > exact : near < exact) ? nextafterf(near, way) : near;
}

// Enters a body at the end of the record.
static bool record(motion *m, uint32_t index, uint32_t at, bool anew) {
  gjk_collider c;
  scene_box *out = &m->boxes[at];
  gjk_aabb *box = &m->exact[index];
  if (gjk_scene_collider(&m->scene, m->bodies[index].handle, 0, &c) != GJK_OK || gjk_collider_aabb(&c, box) != GJK_OK) {
    return false;
  }
  m->states[at] = m->bodies[index];
  m->fixed[index] = traffic_is_static(&m->bodies[index]);
  out->body = index;
  out->anew = anew;
  out->fixed = m->fixed[index];
  out->lower[0] = round_to(box->lower.x, -INFINITY);
  out->lower[1] = round_to(box->lower.y, -INFINITY);
  out->lower[2] = round_to(box->lower.z, -INFINITY);
  out->upper[0] = round_to(box->upper.x, INFINITY);
  out->upper[1] = round_to(box->upper.y, INFINITY);
  out->upper[2] = round_to(box->upper.z, INFINITY);
  return true;
}

bool motion_start(motion *m, traffic_kind kind, uint32_t count, uint32_t percent) {
  const gjk_scene_config config = traffic_config(kind, count);
  const size_t bytes = gjk_scene_bytes(&config);
  void *block = malloc(bytes);
  memset(m, 0, sizeof *m);
  m->count = count;
  m->bodies = malloc(count * sizeof *m->bodies);
  m->exact = malloc(count * sizeof *m->exact);
  m->fixed = malloc(count * sizeof *m->fixed);
  m->boxes = malloc((size_t)count * MOTION_TICKS * sizeof *m->boxes);
  m->states = malloc((size_t)count * MOTION_TICKS * sizeof *m->states);
  return block != NULL && m->bodies != NULL && m->exact != NULL && m->fixed != NULL && m->boxes != NULL &&
         m->states != NULL &&
         gjk_scene_init(&m->scene, &config, block, bytes, traffic_shapes, TRAFFIC_SHAPES, NULL) == GJK_OK &&
         traffic_start(&m->traffic, &m->scene, kind, count, percent, m->bodies) == GJK_OK;
}

void motion_free(motion *m) {
  free(m->scene.block);
  free(m->bodies);
  free(m->exact);
  free(m->fixed);
  free(m->boxes);
  free(m->states);
}

scene_tick motion_all(motion *m) {
  scene_tick all = {m->boxes, m->states, m->count};
  for (uint32_t i = 0; i < m->count; i++) {
    if (!record(m, i, i, true)) {
      all.count = 0;
    }
  }
  return all;
}

bool motion_record(motion *m) {
  uint32_t at = 0;
  m->first[0] = 0;
  for (unsigned tick = 0; tick < MOTION_TICKS; tick++) {
    const uint32_t oldest = m->traffic.oldest;
    traffic_plan(&m->traffic);
    if (traffic_apply(&m->traffic, &m->scene) != GJK_OK) {
      return false;
    }
    // The bodies of a streaming scene that were replaced, from the oldest on, round the end.
    const uint32_t replaced = (m->traffic.oldest + m->count - oldest) % m->count;
    for (uint32_t i = 0; i < m->count; i++) {
      const bool anew = (i + m->count - oldest) % m->count < replaced;
      if (anew || m->bodies[i].moves) {
        if (!record(m, i, at++, anew)) {
          return false;
        }
      }
    }
    m->first[tick + 1] = at;
  }
  return true;
}

scene_tick motion_tick(const motion *m, unsigned tick) {
  const uint32_t first = m->first[tick];
  const scene_tick changes = {m->boxes + first, m->states + first, m->first[tick + 1] - first};
  return changes;
}

static inline bool meet(const gjk_aabb *a, const gjk_aabb *b) {
  return a->lower.x <= b->upper.x && b->lower.x <= a->upper.x && a->lower.y <= b->upper.y && b->lower.y <= a->upper.y &&
         a->lower.z <= b->upper.z && b->lower.z <= a->upper.z;
}

bool motion_meet(const void *user, uint32_t a, uint32_t b) {
  const motion *m = user;
  return meet(&m->exact[a], &m->exact[b]) && !(m->fixed[a] && m->fixed[b]);
}

uint32_t motion_test_all(const motion *m) {
  uint32_t found = 0;
  for (uint32_t i = 0; i < m->count; i++) {
    for (uint32_t k = i + 1; k < m->count; k++) {
      if (meet(&m->exact[i], &m->exact[k])) {
        found += !(m->fixed[i] && m->fixed[k]);
      }
    }
  }
  return found;
}
