// The linear scan for the vertex farthest along a direction: where a query on hulls spends most of its time.
#ifndef GJK_SRC_SCAN_H
#define GJK_SRC_SCAN_H

#include "vector.h"

// What a scan found.
typedef struct gjk_scan_result {
  uint16_t best;  // the first of the vertices with the largest vertex . d
  bool tie;       // another vertex may come within slack of it; never set when slack is 0
} gjk_scan_result;

// Pre: 1 <= n; |d| <= 2^31, |vertices| <= 2^31 each, lengths, and their product below 2^63; 0 <= slack <= 2^60.
gjk_scan_result gjk_scan(const gjk_vec3 *vertices, uint32_t n, const gjk_vec3 *d, int64_t slack);

#endif
