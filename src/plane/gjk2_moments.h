// Moments in the plane: what src/mass/gjk_moments.h is in space, with one number for the second one.
#ifndef GJK2_SRC_MOMENTS_H
#define GJK2_SRC_MOMENTS_H

#include "../arith/gjk_big.h"
#include "gjk2/mass.h"
#include "gjk2_vector.h"

// Sums of weights w, of w s for vectors s, and of w q for numbers q.
typedef struct gjk2_moments {
  gjk_big weight, first[2], second;
} gjk2_moments;

void gjk2_moments_start(gjk2_moments *m);
void gjk2_moments_add(gjk2_moments *m, const gjk_big *weight, gjk2_vec s, int64_t q);

// The q of two vertices a, b: |a + b|^2 + |a|^2 + |b|^2. Pre: |a|, |b| <= 2^29, lengths; then it is at most 2^60 + 2^59.
int64_t gjk2_moments_squares(gjk2_vec a, gjk2_vec b);

// Writes the centre: at / 2^16, rounded to the nearest, a half up. Pre: it fits.
void gjk2_set_centre(const int64_t at[2], gjk2_mass *out);

// The mass properties, but for the centre: 0.
void gjk2_set_body(uint64_t area, int64_t inertia, gjk2_mass *out);

// The mass properties of a convex polygon with a radius: of 1 or 2 vertices, or a sound outline.
// Pre: 0 < radius; the vertices with the radius are within GJK2_RADIUS_MAX of some point.
void gjk2_mass_of_rounded(const gjk2_vec *v, uint32_t count, int32_t radius, gjk2_mass *out);

#endif
