// Putting points in order: the convex hull of a set of points, exactly.
#ifndef GJK2_POLYGON_H
#define GJK2_POLYGON_H

#include "gjk/status.h"
#include "gjk2/format.h"

#ifdef __cplusplus
extern "C" {
#endif

// Writes the corners of the convex hull of points, counterclockwise from the lowest (the leftmost of several). Points
// inside, repeated points and points within an edge are left out. So points in a line give two corners, and a single
// point gives itself.
//
// points     count points, in any order, Q16.16, any int32_t.
// out        room for count points; may be points itself, but must not overlap it otherwise.
// out_count  how many corners there are, at least 1.
// Exact      no tolerance: three points in a line are so by their integers.
// Statuses   NULL; EMPTY; SIZE: the points are more than 2 GJK2_RADIUS_MAX apart along an axis; OVERLAP. Outputs are
//            written only when the result is GJK_OK.
// Cost       of the order of count log count; no stack that grows with count.
// After      Graham, An efficient algorithm for determining the convex hull of a finite planar set, 1972.
gjk_status gjk2_polygon_order(const gjk2_vec *points, uint16_t count, gjk2_vec *out, uint16_t *out_count);

#ifdef __cplusplus
}
#endif

#endif
