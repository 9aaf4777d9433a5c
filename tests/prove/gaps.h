// Sizes of what src/motion/gjk_gap.h finds.
#ifndef PROVE_GAPS_H
#define PROVE_GAPS_H

#include "ways.h"

// The plane's gap, Q16 LSB: a distance below 2^33 LSB, less a radius below 2^33.
#define ANY_ABOVE (INT64_C(1) << 51)

// A point from the centre of A: an offset and a convex radius.
#define ANY_POINT (INT32_C(1) << 30)

#endif
