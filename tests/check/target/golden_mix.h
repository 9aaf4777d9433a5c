// The hash of a fixed set in space, and what is mixed into it.
#ifndef GOLDEN_MIX_H
#define GOLDEN_MIX_H

#include "fnv.h"
#include "gjk/contacts.h"
#include "random_vec.h"

static uint64_t hash;

static inline void mix(uint32_t value) {
  hash = fnv_word(hash, value);
}

static inline void mix_three(int32_t x, int32_t y, int32_t z) {
  mix((uint32_t)x);
  mix((uint32_t)y);
  mix((uint32_t)z);
}

static inline void mix_vector(const gjk_vec3 *v) {
  mix_three(v->x, v->y, v->z);
}

static inline void mix_unit(const gjk_unit3 *n) {
  mix_three(n->x, n->y, n->z);
}

static inline void mix_contacts_of(const gjk_manifold *m) {
  for (unsigned i = 0; i < m->count; i++) {
    mix_vector(&m->contact[i].point_a);
    mix_vector(&m->contact[i].point_b);
    mix((uint32_t)m->contact[i].distance);
    mix(m->contact[i].id);
  }
}

#endif
