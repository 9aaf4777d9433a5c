// The linear scan for the vertex farthest along a direction: where a query on hulls spends most of its time.
#ifndef GJK_SRC_SCAN_H
#define GJK_SRC_SCAN_H

#include "vector.h"

// What a scan looks for: the first of n >= 1 vertices with the largest vertex . d.
typedef struct gjk_scan {
  const gjk_vec3 *vertices;
  uint32_t n;
  uint32_t reach;  // bounds the components of the vertices; below 2^31
  gjk_vec3 d;      // vertex . d is below 2^63 in size
  int64_t slack;   // how near another vertex must come to count as a tie, at most 2^33; 0: never, and needed when no
                   // component of d reaches 2^29
} gjk_scan;

// Returns the vertex's index. *tie: another may come within slack; false only when none does.
uint16_t gjk_scan_farthest(const gjk_scan *scan, bool *tie);

#endif
