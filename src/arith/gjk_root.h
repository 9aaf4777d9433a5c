// Square roots of integers, and their reciprocals.
#ifndef GJK_SRC_ROOT_H
#define GJK_SRC_ROOT_H

#include "gjk_wide.h"

// 2^46 / sqrt(x), at most 1.5 too small, at most 0.5 too large, and below 2^31. Pre: x >= 2^30.
uint32_t gjk_reciprocal_root(uint32_t x);

// floor(sqrt(x)).
uint32_t gjk_isqrt64(uint64_t x);

#endif
