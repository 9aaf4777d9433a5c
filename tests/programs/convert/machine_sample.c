// Which pairs of links touch in all configurations, or in none, as far as samples tell.
#include <stdlib.h>
#include <string.h>

#include "gjk/intersect.h"
#include "machine.h"
#include "random.h"

// A link's parts are first to end.
typedef struct sampler {
  const machine *m;
  gjk_arm arm;
  gjk_arm_model model;
  gjk_arm_memory memory;
  gjk_collider *collider;
  unsigned first[GJK_ARM_LINKS_MAX + 1];
  uint32_t above[GJK_ARM_LINKS_MAX];   // links from the base to it
  uint32_t asked[GJK_ARM_LINKS_MAX];   // pairs that are looked at, the higher link's bit in the lower one's word
  uint32_t always[GJK_ARM_LINKS_MAX];  // that have touched in each sample
  uint32_t ever[GJK_ARM_LINKS_MAX];    // that may have touched in some
} sampler;

static bool has_parts(const sampler *s, unsigned link) {
  return s->first[link + 1] > s->first[link];
}

// Does a joint move one of the two against the other?
static bool moves(const sampler *s, unsigned one, unsigned other) {
  const uint32_t between = s->above[one] ^ s->above[other];
  bool found = false;
  for (unsigned i = 0; i < s->m->links; i++) {
    found = found || ((between >> i & 1u) != 0 && s->m->link[i].kind != GJK_ARM_FIXED);
  }
  return found;
}

// The nearest link below with parts, GJK_ARM_BASE: none.
static unsigned neighbour(const sampler *s, unsigned link) {
  unsigned below = s->m->link[link].parent;
  while (below != GJK_ARM_BASE && !has_parts(s, below)) {
    below = s->m->link[below].parent;
  }
  return below;
}

static void prepare(sampler *s, machine *m) {
  const gjk_pose identity = GJK_POSE_IDENTITY;
  memset(s, 0, sizeof *s);
  s->m = m;
  s->model = machine_model(m);
  s->memory.links = solid_allocate(m->links, sizeof s->memory.links[0]);
  s->memory.parts = solid_allocate(m->parts, sizeof s->memory.parts[0]);
  s->memory.pair_capacity = GJK_ARM_PAIRS(m->parts, 0u);
  s->memory.pairs = solid_allocate(s->memory.pair_capacity, sizeof s->memory.pairs[0]);
  s->collider = solid_allocate(m->parts, sizeof s->collider[0]);
  memset(s->collider, 0, m->parts * sizeof s->collider[0]);
  for (unsigned i = 0; i < m->parts; i++) {
    s->first[m->part[i].link + 1] = i + 1;
    (void)gjk_collider_init(&s->collider[i], m->part[i].shape, NULL, 0);
  }
  for (unsigned i = 0; i < m->links; i++) {  // parts are in the order of links
    s->first[i + 1] = s->first[i + 1] > s->first[i] ? s->first[i + 1] : s->first[i];
    s->above[i] = UINT32_C(1) << i | (m->link[i].parent == GJK_ARM_BASE ? 0 : s->above[m->link[i].parent]);
  }
  for (unsigned i = 0; i < m->links; i++) {
    const unsigned below = neighbour(s, i);
    if (has_parts(s, i) && below != GJK_ARM_BASE && below != m->link[i].parent) {
      m->never[below] |= UINT32_C(1) << i;
    }
    for (unsigned k = 0; k < i; k++) {
      if (has_parts(s, i) && has_parts(s, k) && k != below && moves(s, i, k)) {
        s->asked[k] |= UINT32_C(1) << i;
      }
    }
  }
  memcpy(s->always, s->asked, sizeof s->always);
  (void)gjk_arm_init(&s->arm, &s->model, &identity, &s->memory);  // it was before
}

// May two links' parts touch? *surely: they do.
static bool touch(const sampler *s, unsigned one, unsigned other, bool *surely) {
  bool may = false;
  *surely = false;
  for (unsigned i = s->first[one]; i < s->first[one + 1] && !*surely; i++) {
    for (unsigned k = s->first[other]; k < s->first[other + 1] && !*surely; k++) {
      gjk_decision decision;
      const gjk_status status = gjk_intersect(&s->collider[i], &s->collider[k], NULL, &decision);
      may = may || status != GJK_OK || decision.yes;
      *surely = status == GJK_OK && decision.yes;
    }
  }
  return may;
}

static void sample(sampler *s, random_state *random) {
  const machine *m = s->m;
  const int32_t turn = 205887;  // pi
  int32_t values[GJK_ARM_LINKS_MAX];
  gjk_pose poses[GJK_ARM_LINKS_MAX];
  unsigned value = 0;
  for (unsigned i = 0; i < m->links; i++) {
    const gjk_arm_link *link = &m->link[i];
    const bool endless = link->lower == INT32_MIN || link->upper == INT32_MAX;
    if (link->kind != GJK_ARM_FIXED) {
      values[value++] = random_range(random, endless ? -turn : link->lower, endless ? turn : link->upper);
    }
  }
  if (gjk_arm_poses(&s->arm, values, poses) != GJK_OK) {  // it reaches too far there: nothing is known
    memset(s->always, 0, sizeof s->always);
    memcpy(s->ever, s->asked, sizeof s->ever);
    return;
  }
  for (unsigned i = 0; i < m->parts; i++) {
    gjk_pose pose;
    (void)gjk_pose_compose(&poses[m->part[i].link], &m->part[i].pose, &pose);
    (void)gjk_collider_pose(&s->collider[i], &pose);
  }
  for (unsigned i = 0; i < m->links; i++) {
    for (unsigned k = i + 1; k < m->links; k++) {
      const uint32_t bit = UINT32_C(1) << k;
      bool surely;
      if ((s->asked[i] & bit) != 0 && ((s->always[i] & bit) != 0 || (s->ever[i] & bit) == 0)) {
        s->ever[i] |= touch(s, k, i, &surely) ? bit : 0;
        s->always[i] &= surely ? UINT32_MAX : ~bit;
      }
    }
  }
}

void machine_sample(machine *m) {
  random_state random = random_seed(1);
  sampler *s = solid_allocate(1, sizeof *s);
  prepare(s, m);
  for (unsigned i = 0; i < MACHINE_SAMPLES; i++) {
    sample(s, &random);
  }
  for (unsigned i = 0; i < m->links; i++) {
    m->never[i] |= s->always[i];
    m->apart[i] = s->asked[i] & ~s->ever[i];
  }
  m->sampled = true;
  free(s->memory.links);
  free(s->memory.parts);
  free(s->memory.pairs);
  free(s->collider);
  free(s);
}
