// Hashes over the answers of queries on pairs of the kinds that a level of GJK_SHAPES knows, by query.
#ifndef LEVELS_H
#define LEVELS_H

#include <stdint.h>

// Pairs in the full set, and in the start of it that small emulated cores have time for.
#define LEVELS_PAIRS 3000
#define LEVELS_FEW_PAIRS 200

typedef enum levels_query {
  LEVELS_TOUCH,
  LEVELS_GAP,
  LEVELS_DEPTH,
  LEVELS_CONTACTS,
  LEVELS_MOTION,
  LEVELS_UNTIL,   // what queries prove in a few iterations
  LEVELS_PROOFS,  // what the checks say of the certificates
  LEVELS_QUERIES
} levels_query;

// Sets the hashes over the first pairs of the level's set: of kinds that it knows, from 1 for points to 5 for all. The builds
// for that level and for all kinds have the same. Returns how many pairs overlap. Not reentrant.
uint32_t levels_hash(unsigned level, uint32_t pairs, uint64_t hash[LEVELS_QUERIES]);
uint32_t plane_levels_hash(unsigned level, uint32_t pairs, uint64_t hash[LEVELS_QUERIES]);

// The kinds that gjk_collider_init refuses as unsupported, a bit each; bit 31: it says something else of one.
uint32_t levels_refused(void);
uint32_t plane_levels_refused(void);

// The kinds that are beyond the level.
uint32_t levels_beyond(unsigned level);
uint32_t plane_levels_beyond(unsigned level);

#endif
