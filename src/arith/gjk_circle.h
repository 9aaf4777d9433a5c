// The directions of a circle in which outlines are drawn.
#ifndef GJK_SRC_CIRCLE_H
#define GJK_SRC_CIRCLE_H

#include "gjk/body.h"

// Direction i of GJK_DRAW_DIRECTIONS: a unit vector, Q2.30, to the nearest LSB. Pre: i < GJK_DRAW_DIRECTIONS.
static inline void gjk_circle(unsigned i, gjk_q30 *x, gjk_q30 *y) {
  // The sines of 0, 15 ... 435 degrees: a quarter turn more than a full one, for the cosines.
  static const gjk_q30 sine[GJK_DRAW_DIRECTIONS * 5 / 4] = {
      0,          277904834,   536870912,   759250125,   929887697,  1037154959, 1073741824, 1037154959,
      929887697,  759250125,   536870912,   277904834,   0,          -277904834, -536870912, -759250125,
      -929887697, -1037154959, -1073741824, -1037154959, -929887697, -759250125, -536870912, -277904834,
      0,          277904834,   536870912,   759250125,   929887697,  1037154959};
  *x = sine[i + GJK_DRAW_DIRECTIONS / 4];
  *y = sine[i];
}

#endif
