// The directions of a circle in which outlines are drawn.
#ifndef GJK_SRC_CIRCLE_H
#define GJK_SRC_CIRCLE_H

#include "gjk/body.h"

// Direction i of GJK_DRAW_DIRECTIONS: a unit vector, Q2.30, to the nearest LSB. Pre: i < GJK_DRAW_DIRECTIONS.
static inline void gjk_circle(unsigned i, gjk_q30 *x, gjk_q30 *y) {
  static const gjk_q30 cosine[7] = {1073741824, 1037154959, 929887697, 759250125,
                                    536870912,  277904834,  0};  // of 0, 15 ... 90 degrees
  const gjk_q30 c = cosine[i % 6], s = cosine[6 - i % 6];
  switch (i / 6) {
    case 0: *x = c, *y = s; break;
    case 1: *x = -s, *y = c; break;
    case 2: *x = -c, *y = -s; break;
    default: *x = s, *y = -c; break;
  }
}

#endif
