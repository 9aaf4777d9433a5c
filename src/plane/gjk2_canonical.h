// Which feature is reported where several hold the nearest point.
#ifndef GJK2_SRC_CANONICAL_H
#define GJK2_SRC_CANONICAL_H

#include "gjk2_search.h"

// Makes the feature one that depends on the pair alone: the whole edge of A - B that holds the nearest point within, or its end.
// Pre: a search has ended NEAREST; polygons, in a near frame.
void gjk2_search_canonical(gjk2_search *s);

#endif
