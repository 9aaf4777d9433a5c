// Keys that order planes by their height over the origin.
#ifndef GJK_SRC_HEIGHT_KEY_H
#define GJK_SRC_HEIGHT_KEY_H

#include "gjk_wide.h"

// How high a plane lies over the origin is first told by a key: that of the height's square, 6 bits of exponent over 16
// bits of fraction. Equal heights have keys at most GJK_HEIGHT_KEY_ERROR apart, as long as they exceed 2^13; all others are
// told apart to within GJK_HEIGHT_ERROR units of the frame as well.
#define GJK_HEIGHT_KEY_MAX ((UINT32_C(64) << 16) - 1)
#define GJK_HEIGHT_KEY_ERROR 16

// (along / |d|)^2 as a key; 0 when along is not positive. along, squared = |d|^2: below 2^63.
uint32_t gjk_height_key(int64_t along, int64_t squared);

#endif
