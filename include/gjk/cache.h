// What a caller may keep per pair from one query to the next.
#ifndef GJK_CACHE_H
#define GJK_CACHE_H

#include "gjk/format.h"

// Zeroed is a cold start; so is NULL. Any content is safe, also that of another pair or of another query. It serves pairs of
// polytopes and their rounded forms; others take nothing from it.
// Status, decision, distance, depth and bounds never depend on it. Between polytopes and their rounded forms the witness
// points, normal, certificate, and contacts that follow from them may, among equally near ones; iterations do. A lockstep
// game that uses those saves caches with its state, or passes none; a scene's reports never depend on its own.
// tests/check/unit/test_history.c holds it, with low ceilings and small workspaces as well.
typedef struct gjk_cache {
  int16_t direction[3];  // last direction from A to B; all zero: none
  uint16_t count;        // pairs below
  uint16_t a[4], b[4];   // vertices of the last feature or simplex
} gjk_cache;

#endif
