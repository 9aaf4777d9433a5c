// Rounded polytopes and cones: integrals over a body and all points within a radius of it.
#ifndef GJK_SRC_MASS_ROUNDED_H
#define GJK_SRC_MASS_ROUNDED_H

#include "gjk_moments.h"

// The sums of Steiner's formula (gjk_mass_rounded.c).
typedef struct gjk_round_sums {
  gjk_moments solid;                  // of tetrahedra, whole numbers
  gjk_moments faces, edges, corners;  // Q80
  gjk_big normal[6], along[6];        // of faces N N' / |N|; of edges t e e' / L; Q80
} gjk_round_sums;

void gjk_round_start(gjk_round_sums *sums, const gjk_vec3 *origin);

// Writes the mass properties for a radius. of_pi: all sums are to be multiplied by pi. Pre: radius > 0. False: no body
// has these sums.
bool gjk_round_finish(gjk_round_sums *sums, int32_t radius, bool of_pi, gjk_mass *out);

// The hull of vertices with these faces. RANGE: the faces are not sound.
gjk_status gjk_mass_of_rounded_faces(const gjk_vec3 *v, const gjk_hull_faces *faces, int32_t radius, gjk_mass *out);

// A segment from a to b, which may be one point.
void gjk_mass_of_rounded_segment(const gjk_vec3 *a, const gjk_vec3 *b, int32_t radius, gjk_mass *out);

// A cone with its base at z = -half. Pre: base_radius or half is above 0.
void gjk_mass_of_rounded_cone(int32_t base_radius, int32_t half, int32_t radius, gjk_mass *out);

#endif
