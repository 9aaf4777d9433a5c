// Convex polygons in the plane of a triangle, cut exactly.
//
// A triangle's plane is a + s u + t v. The trace of another plane in it is a line k + ks s + kt t = 0, whose coefficients
// are integers. A polygon is the list of its edges' lines, counterclockwise, positive inside. So no corner is ever
// computed: which side of a line a corner is on is the sign of the determinant of three lines.
#ifndef FLAT_H
#define FLAT_H

#include "solid.h"

typedef struct flat_line {
  solid_wide k, ks, kt;  // below 2^93
} flat_line;

typedef struct flat_base {
  const int32_t *a;
  int32_t u[3], v[3];
  int32_t low[3], high[3];  // of the triangle
} flat_base;

typedef struct flat_polygon {
  flat_line *line;
  unsigned lines;
} flat_polygon;

flat_base flat_base_of(const int32_t a[3], const int32_t b[3], const int32_t c[3]);

// The triangle itself.
flat_polygon flat_triangle(void);

void flat_free(flat_polygon *polygon);

// The line that a plane leaves; positive where sign * height is.
flat_line flat_trace(const flat_base *base, const solid_plane *plane, int sign);

// Which sides of a line a polygon reaches into: bit 0 the positive one, bit 1 the negative one.
enum { FLAT_BEYOND = 1, FLAT_BEHIND = 2 };
unsigned flat_sides(const flat_polygon *polygon, const flat_line *line);

// What of a polygon is on the positive side of a line, sign = 1, or on the negative one, -1. No lines: nothing with area.
flat_polygon flat_clip(const flat_polygon *polygon, const flat_line *line, int sign);

// A point within, (s, t) = (i, j) / 2^60, strictly. attempt: others for other numbers. False: none was found.
bool flat_inner(const flat_polygon *polygon, unsigned attempt, int64_t *i, int64_t *j);

// The corner between a line and the next one, rounded.
void flat_corner(const flat_base *base, const flat_polygon *polygon, unsigned corner, long double out[3]);

#endif
