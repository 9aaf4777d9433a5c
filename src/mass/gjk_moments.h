// Sums over simplices, and what they say of a body: its centre and its inertia.
//
// A simplex has k vertices (segment, triangle, tetrahedron), a mass of w, and s is the sum of its vertices:
//   first moment    w s / k
//   second moment   w (s s' + sum v v') / (k (k + 1))
// Let S, F and M be the sums of w, w s and w (s s' + sum v v') over all simplices. The body's second moment about its
// centre, for a mass of 1, is
//   C = M / (k (k + 1) S) - F F' / (k S)^2
//     = (k^2 S M - k (k + 1) F F') / (k^3 (k + 1) S^2)
// The inertia about x is C.yy + C.zz, the product of inertia of y and z -C.yz.
//
// Vertices are relative to one of them, so their components are at most 2^29 in size. Bounds, in bits of size:
//   w            90, of tetrahedra six times the volume. All are within the box of the vertices, so S <= 6 2^87 < 2^90
//   F            S |s| < 2^90 2^31 = 2^121
//   M            S (3 2^29)^2 + ... <= 12 2^58 S < 2^152
//   S M, F F'    of a body: M = 20 S E[v v'], F = 4 S E[v]; so 16 S M, 20 F F' <= 320 S^2 2^58 < 2^247
#ifndef GJK_SRC_MOMENTS_H
#define GJK_SRC_MOMENTS_H

#include "../arith/gjk_big.h"
#include "../arith/gjk_vector.h"
#include "gjk/mass.h"

typedef struct gjk_moments {
  gjk_vec3 origin;              // vertices are relative to it
  gjk_big weight;               // S
  gjk_big first[3], second[6];  // F; M as xx, yy, zz, yz, zx, xy
} gjk_moments;

void gjk_moments_start(gjk_moments *m, const gjk_vec3 *origin);

// Adds a simplex: of the corners, or of origin and three corners. Pre: corners are at most 2^29 from origin along each
// axis.
void gjk_moments_add(gjk_moments *m, const gjk_big *weight, const gjk_vec3 *const corner[], int corners);

// Adds the tetrahedron from the origin to a triangle. False: the origin is above the triangle, so that it would count
// negatively.
bool gjk_moments_add_tetrahedron(gjk_moments *m, const gjk_vec3 *const corner[3]);

// Writes the mass properties. Pre: the simplices have k = 2 to 4 vertices; weight > 0.
void gjk_moments_finish(gjk_moments *m, unsigned k, gjk_mass *out);

// The axis along which the normal of a triangle is longest, or 3 if the triangle is degenerate.
unsigned gjk_longest_axis(const gjk_vec3 *a, const gjk_vec3 *b, const gjk_vec3 *c);

// Adds the triangle with its area's projection along an axis as its weight.
void gjk_moments_add_flat(gjk_moments *m, unsigned axis, const gjk_vec3 *const corner[3]);

// Mass properties of the segment from a to b, which may be one point.
void gjk_moments_of_segment(const gjk_vec3 *a, const gjk_vec3 *b, gjk_mass *out);

// The axes of the entries of a symmetric matrix: xx, yy, zz, yz, zx, xy.
extern const uint8_t gjk_entry_axis[6][2];

// From second moments to inertia: the trace less the moment, and the opposite of products. Pre: |m| < 2^252.
void gjk_inertia_of_second(gjk_big m[6]);

// Writes entry / whole, each to the nearest, a half up. The entries are spent. Pre: as gjk_big_nearest.
void gjk_set_inertia(gjk_big entry[6], const gjk_big *whole, gjk_inertia *out);

// Writes the centre: at / 2^16, each component rounded to the nearest, a half up. Pre: it fits.
void gjk_set_centre(const int64_t at[3], gjk_mass *out);

// *out = the number nearest to x / y. Pre: x >= 0, y > 0, x / y < 2^127.
void gjk_set_volume(gjk_big *x, const gjk_big *y, gjk_volume *out);

#endif
