// Host program: prints the golden hashes of this build, and what to write into the headers for those that are others.
#include "golden.h"

#include <inttypes.h>
#include <stdbool.h>
#include <stdio.h>

#include "concave_golden.h"
#include "hull_golden.h"
#include "motion_golden.h"
#include "parts_golden.h"
#include "plane_golden.h"
#include "scene_golden.h"

#ifndef GOLDEN_MANY
static uint64_t scene_hash(uint32_t ticks) {
  return scene_golden_hash(ticks, 1);
}
#endif

// A hash, of how much, and what it is in its header under this name.
typedef struct golden {
  const char *name;
  uint64_t expected;
  uint64_t (*hash)(uint32_t size);
  uint32_t size;
} golden;

#define GOLDEN(name, hash, size) \
  { #name, name, hash, size }

// The sets of a kind: the larger one, or a few of a set and all of it.
#ifdef GOLDEN_MANY
#define HASHES(name, hash, sizes, of) GOLDEN(name##_GOLDEN_MANY_HASH, hash, sizes##_GOLDEN_MANY_##of)
#else
#define HASHES(name, hash, sizes, of) \
  GOLDEN(name##_GOLDEN_FEW_HASH, hash, sizes##_GOLDEN_FEW_##of), GOLDEN(name##_GOLDEN_HASH, hash, sizes##_GOLDEN_##of)
#endif

static const golden goldens[] = {
#ifdef GOLDEN_MANY
    GOLDEN(GOLDEN_MANY_HASH, golden_hash, GOLDEN_MANY_PAIRS),
    GOLDEN(CONCAVE_GOLDEN_MANY_HASH, concave_golden_hash, CONCAVE_GOLDEN_MANY_TICKS),
#else
    GOLDEN(GOLDEN_FEW_HASH, golden_hash, GOLDEN_FEW_PAIRS),
    GOLDEN(GOLDEN_HASH, golden_hash, GOLDEN_PAIRS),
    GOLDEN(SCENE_GOLDEN_FEW_HASH, scene_hash, SCENE_GOLDEN_FEW_TICKS),
    GOLDEN(CONCAVE_GOLDEN_HASH, concave_golden_hash, CONCAVE_GOLDEN_TICKS),
#endif
    HASHES(PLANE, plane_golden_hash, PLANE, PAIRS),
    HASHES(MOTION, motion_golden_hash, MOTION, PAIRS),
    HASHES(PLANE_MOTION, plane_motion_golden_hash, MOTION, PAIRS),
    HASHES(PARTS, parts_golden_hash, PARTS, BODIES),
    HASHES(PARTS_CONTACTS, parts_contacts_golden_hash, PARTS, BODIES),
    HASHES(PARTS_MOTION, parts_motion_golden_hash, PARTS, BODIES),
    HASHES(HULL, hull_golden_hash, HULL, SETS),
};

int main(void) {
  bool same = true;
  for (size_t i = 0; i < sizeof goldens / sizeof goldens[0]; i++) {
    const golden *g = &goldens[i];
    const uint64_t hash = g->hash(g->size);
    printf("%016" PRIx64 " ", hash);
    if (hash != g->expected) {
      fprintf(stderr, "#define %s UINT64_C(0x%016" PRIx64 ")\n", g->name, hash);
      same = false;
    }
  }
  printf("\n");
  return same ? 0 : 1;
}
