// The cells of a hull's table: how directions are divided among them.
//
// A cell is a part of the square of directions around one local axis. From the coarse to the fine:
//   1. The axis along which the direction is longest: its major axis, the first of equals.
//   2. The octant: the signs of x, y and z, a bit each, set where negative.
//   3. For each level the quarter of the square: a bit each for the other two axes in their cyclic order, set where
//      the component, compared with the major one, lies in the upper half of what is left.
// So the directions of a cell are, up to a positive factor and the signs, from (2^level, u, v) to
// (2^level, u + 1, v + 1), for 0 <= u, v < 2^level.
#ifndef GJK_SRC_HULL_TABLE_H
#define GJK_SRC_HULL_TABLE_H

#include "../arith/gjk_vector.h"
#include "gjk/shape.h"

// A cell lists all vertices that reach, along some direction of the cell, at least as far as the farthest one less
// GJK_TABLE_SLACK LSB times the direction's major component. gjk_class_table.c shows that this slack is enough.
#define GJK_TABLE_SLACK 16

// Takes a bit of *rest / major: 0 <= *rest <= major, before and after.
static inline unsigned gjk_table_bit(uint32_t *rest, uint32_t major) {
  const uint32_t left = major - *rest;
  if (*rest >= left) {
    *rest -= left;
    return 1;
  }
  *rest += *rest;  // below major
  return 0;
}

// The cell that a direction is in. Pre: level <= GJK_TABLE_LEVEL_MAX.
static inline unsigned gjk_table_cell(const gjk_vec3 *d, unsigned level) {
  const uint32_t x = gjk_magnitude32(d->x), y = gjk_magnitude32(d->y), z = gjk_magnitude32(d->z);
  unsigned cell = (d->x < 0 ? 1u : 0u) | (d->y < 0 ? 2u : 0u) | (d->z < 0 ? 4u : 0u);
  uint32_t major = x, u = y, v = z;
  if (y > x && y >= z) {
    cell |= 8;
    major = y;
    u = z;
    v = x;
  } else if (z > x) {
    cell |= 16;
    major = z;
    u = x;
    v = y;
  }
  for (unsigned i = 0; i < level; i++) {
    cell = 2 * cell | gjk_table_bit(&u, major);
    cell = 2 * cell | gjk_table_bit(&v, major);
  }
  return cell;
}

// Is the table one for count vertices? Every cell has vertices, whose numbers rise and are below count.
gjk_status gjk_table_measure(const gjk_hull_table *table, uint16_t count);

#endif
