// Hashes over the answers of queries on pairs of the kinds that a level of GJK_SHAPES knows, by query.
#ifndef LEVELS_H
#define LEVELS_H

#include <stdint.h>

#define LEVELS_PAIRS 6000
#define LEVELS_FEW_PAIRS 300

// The rows of the table that the two programs print.
typedef enum levels_query {
  LEVELS_TOUCH,
  LEVELS_GAP,
  LEVELS_DEPTH,
  LEVELS_CONTACTS,
  LEVELS_MOTION,
  LEVELS_UNTIL,
  LEVELS_PROOFS,
  LEVELS_REFUSED,
  LEVELS_QUERIES
} levels_query;

// Each hash over the first pairs of the set. level: the first kinds alone, from 1 for points to 5 for all; every build of
// that level or a higher one answers with the same hashes. Refused is another one in each build: the statuses of
// gjk_collider_init for all kinds.
// Returns how many pairs overlapped, so that a caller sees that both sides are covered.
uint32_t levels_hash(unsigned level, uint32_t pairs, uint64_t hash[LEVELS_QUERIES]);
uint32_t plane_levels_hash(unsigned level, uint32_t pairs, uint64_t hash[LEVELS_QUERIES]);

#endif
