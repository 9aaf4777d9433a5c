// The height key: a 22-bit number that orders planes by their height over the origin.
#ifndef GJK_SRC_HEIGHT_KEY_H
#define GJK_SRC_HEIGHT_KEY_H

#include "gjk_wide.h"

// The key encodes the square of a height: 6 bits of exponent over 16 bits of fraction. Equal heights above 2^13 have
// keys at most GJK_HEIGHT_KEY_ERROR apart. Comparisons of lower heights also allow for GJK_HEIGHT_ERROR of gjk_facet.h.
#define GJK_HEIGHT_KEY_MAX ((UINT32_C(64) << 16) - 1)
#define GJK_HEIGHT_KEY_ERROR 16

// The key of the height along / |d|; 0 when along is not positive. along and squared = |d|^2 are below 2^63.
uint32_t gjk_height_key(int64_t along, int64_t squared);

#endif
