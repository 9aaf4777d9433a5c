// The nearest edge of A - B of two boxes, by their four half axes.
#ifndef GJK2_SRC_BOXES_H
#define GJK2_SRC_BOXES_H

#include "gjk2_edges.h"

// As gjk2_nearest_edge. OPEN: no edge is found, since two are equally near or nearly so. Pre: boxes in order, in a near
// frame.
gjk2_lie gjk2_boxes_edge(gjk2_search *s, gjk2_edge *edge);

#endif
