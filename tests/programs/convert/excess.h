// How far parts reach beyond a solid.
#ifndef EXCESS_H
#define EXCESS_H

#include "nearest.h"
#include "part.h"

// The greatest distance of a part's points from the solid lies between the two, LSB.
typedef struct excess_bounds {
  long double at_least, at_most;
} excess_bounds;

// Stops when at_most is within 'tolerance' of at_least, or of it / 64; when at_least is above 'limit', or at_most no more than
// that; or after 'cells'.
//
// The part is cut into cells. What of a cell is outside the solid is as near to it as the cell's farthest corner to any one
// triangle; as the middle is, and the radius more; or, if the middle is inside, the radius less. A cell that no
// triangle crosses, with its middle inside, has nothing outside. Cells are cut by a triangle's plane that crosses them, else across.
// Triangles count as crossing from a graze on, tolerance / 64 or 2^-10 LSB; what they cut off is counted with the graze
// times the cell's slenderness. Of long double with 64 bits, the cells' rounding is below 2^-20 LSB; at_most has a graze added.
excess_bounds excess_of(const nearest_tree *tree, const part *p, long double tolerance, long double limit,
                        unsigned cells);

// An upper bound for parts that reach only a few LSB beyond, INFINITY for others: their points are moved inwards until
// the hull of what they become is inside the solid, which is checked exactly. A point of the part, a mixture of its own, is no farther
// from the same mixture of the moved ones than the farthest move.
long double excess_by_shrinking(const solid *s, const part *p);

#endif
