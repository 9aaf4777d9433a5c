// Areas: polygons in a plane, split where a surface crosses them, and how often the surface winds around what is beside them.
#ifndef AREAS_H
#define AREAS_H

#include "flat.h"

// The most pieces that an area is split into; a surface that crosses itself in more than so many in all is refused.
enum { AREAS_MAX = 1 << 15 };

typedef struct area_pile {
  flat_polygon *polygon;
  size_t count, room;
} area_pile;

// Takes the polygon; one without area is freed.
void area_put(area_pile *p, flat_polygon polygon);

void area_clear(area_pile *p);

// Splits polygons until no triangle lies across one, nor an edge of a triangle in their plane. False: there would be more
// than AREAS_MAX; the pile is to be cleared all the same.
bool area_split(const solid *s, const flat_base *base, area_pile *polygons);

// How often the surface winds around what is just beyond a polygon that no triangle divides; way = -1: just behind it.
// plane: the polygon's own. False: not decided.
bool area_winding(const solid *s, const flat_base *base, const flat_polygon *polygon, const solid_plane *plane, int way,
                  long *out);

// Is the surface turned one way, so that it winds around no point a number of times below 0? False, and the triangle: a
// piece of it has such points beside it, or (*decided = false) it crosses the others in too many pieces, or too small ones.
// Every region that the surface bounds has a piece of a triangle at its rim, so all are looked at.
bool area_is_turned_one_way(const solid *s, size_t *triangle, bool *decided);

#endif
