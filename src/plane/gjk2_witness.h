// The witness points of the plane: where a feature of A - B is nearest to the origin, as a point on each shape.
#ifndef GJK2_SRC_WITNESS_H
#define GJK2_SRC_WITNESS_H

#include "gjk2_search.h"

// The point nearest to the origin of the edge from p to q, or p itself where q is NULL, as a point of each core, moved
// by the convex radius along the normal (A) and against it (B) and then rounded once. World frame. Returns
// whether a coordinate does not fit Q16.16 and is saturated. length: of the edge, or of a vector across it.
bool gjk2_witness_points(const gjk2_search *s, const gjk2_vertex *p, const gjk2_vertex *q, const gjk2_length *length,
                         const gjk2_unit *normal, gjk2_vec *point_a, gjk2_vec *point_b);

#endif
