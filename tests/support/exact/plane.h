// Planes that no vertex of A - B lies beyond, and how far they are from the origin.
#ifndef EXACT_PLANE_H
#define EXACT_PLANE_H

#include "feature.h"

// The points p with normal . p = height; height is negative when A - B lies behind the origin.
typedef struct exact_plane {
  exact_vector normal;  // outwards, not 0, any length
  exact_int height;
  exact_int squared;  // normal . normal
} exact_plane;

void exact_plane_make(const exact_vector *normal, const exact_int *height, exact_plane *out);

// The plane through the nearest point of a feature, across the way to the origin, which lies beyond it.
// Pre: the feature does not hold the origin.
void exact_plane_behind(const exact_feature *feature, exact_plane *out);

// The sign of (height / |normal|) - distance.
int exact_plane_compare(const exact_plane *plane, int64_t distance);

// height / |normal| rounded up. Pre: below 2^40 in size.
int64_t exact_plane_ceiling(const exact_plane *plane);

// height / |normal|, within 2^-47 of itself.
double exact_plane_height(const exact_plane *plane);

// The sign of (a.height / |a.normal|) - (b.height / |b.normal|). Pre: neither height is negative.
int exact_plane_order(const exact_plane *a, const exact_plane *b);

#endif
