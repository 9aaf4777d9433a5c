// Solids bounded by closed surfaces of triangles, in integers.
#ifndef SOLID_H
#define SOLID_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "memory.h"
#include "mesh.h"

__extension__ typedef __int128 solid_wide;

// The most triangles.
#define SOLID_TRIANGLES_MAX 4096

// The greatest coordinate, counted from the solid's lowest corner.
#define SOLID_EXTENT (1 << 29)

// n . x = d. Beyond it n . x > d.
typedef struct solid_plane {
  int64_t n[3];  // below 2^60, without a common divisor
  solid_wide d;  // below 2^91
} solid_plane;

// Points are counted from origin: 0 to SOLID_EXTENT. The solid is what the surface winds around, once or more
// often, and the surface itself. So shells may cross or touch: the solid is their union. Triangles without area are kept: their plane has n = 0.
typedef struct solid {
  gjk_vec3 origin;
  int32_t (*point)[3];
  uint32_t (*triangle)[3];
  solid_plane *plane;
  size_t points, triangles;
  int32_t high[3];     // the highest corner
  solid_wide volume6;  // six times the volume, each point counted as often as the surface winds around it
} solid;

// The plane through three points, counterclockwise when seen from beyond; n = 0: they are on a line.
solid_plane solid_plane_of(const int32_t a[3], const int32_t b[3], const int32_t c[3]);

// n . x - d, below 2^92.
solid_wide solid_height(const solid_plane *plane, const int32_t x[3]);

// Have two boxes no point in common?
bool solid_is_apart(const int32_t low[3], const int32_t high[3], const int32_t lowest[3], const int32_t highest[3]);

// Takes a welded mesh. False, with a message in problem that names the face at fault: not closed, without volume, too wide,
// too many triangles, or a surface that winds around some points less than 0 times. Triangles that are turned inwards all
// together are turned.
bool solid_from_mesh(solid *s, const mesh *m, char *problem, size_t room);

void solid_free(solid *s);

// A ray from x / 2^shift, shift at most 60, towards sign * axis.
typedef struct solid_ray {
  solid_wide x[3];
  const solid_plane *within;  // may be NULL
  int shift, axis, sign;
} solid_ray;

// Counts a triangle that the ray crosses. False: x is on it, and it does not lie in 'within'.
bool solid_cross(const solid *s, size_t t, const solid_ray *ray, long *winding);

// How often the surface winds around a point: what solid_cross counts of all triangles. False: it said so of one.
bool solid_winding(const solid *s, const solid_wide x[3], int shift, int axis, int sign, const solid_plane *within,
                   long *out);

#endif
