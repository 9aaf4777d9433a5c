// The linear scan for the vertex farthest along a direction: where a query on hulls spends most of its time.
#ifndef GJK_SRC_SCAN_H
#define GJK_SRC_SCAN_H

#include "vector.h"

typedef struct gjk_farthest {
  uint16_t index;  // the first of the vertices with the largest vertex . d
  bool tie;        // another one may come within the slack; false only when none does
} gjk_farthest;

// Scans n >= 1 vertices with components of at most 2^bits in size, 1 <= bits <= 31; vertex . d is below 2^63.
// slack: in units of 4, at most 2^30; 0, which makes no ties, when no component of d reaches 2^29.
gjk_farthest gjk_scan(const gjk_vec3 *vertices, uint32_t n, unsigned bits, const gjk_vec3 *d, uint32_t slack);

#endif
