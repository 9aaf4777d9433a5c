// Any contact points that src/contact/gjk_clip.c may give.
#ifndef PROVE_CANDIDATES_H
#define PROVE_CANDIDATES_H

#include "simplex_any.h"
#include "src/contact/gjk_clip.h"

static void any_candidates(gjk_candidates *candidates, int32_t count) {
  for (int i = 0; i < count; i++) {
    gjk_contact *candidate = &candidates->candidate[i];
    candidate->point_a = any_position();
    candidate->point_b = any_position();
    candidate->distance = any_int32();
    candidate->id = any_uint16();
  }
  candidates->count = (unsigned)count;
}

// It is set.
static void check_position(const gjk_vec3 *v) {
  check_size(v->x, INT64_C(1) << 31);
  check_size(v->y, INT64_C(1) << 31);
  check_size(v->z, INT64_C(1) << 31);
}

static void check_candidate(const gjk_contact *candidate) {
  check_position(&candidate->point_a);
  check_position(&candidate->point_b);
  check_size(candidate->distance, INT64_C(1) << 31);
  check_size(candidate->id, UINT16_MAX);
}

static void check_candidates(const gjk_candidates *candidates) {
  //@ assert candidates->count <= GJK_CANDIDATES_MAX;
  for (unsigned i = 0; i < candidates->count; i++) {
    check_candidate(&candidates->candidate[i]);
  }
}

#endif
