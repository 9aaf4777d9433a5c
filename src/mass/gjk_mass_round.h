// Closed forms: boxes, capsules and cylinders, rounded or not, cones and ellipsoids.
#ifndef GJK_SRC_MASS_ROUND_H
#define GJK_SRC_MASS_ROUND_H

#include "gjk_moments.h"

// The mass properties of a shape without vertices, but for its centre, by its kind.
// Pre: lengths are from 0 to GJK_RADIUS_MAX. Cones and ellipsoids are not rounded.

// half: the half extents of the core, 0 for a point.
void gjk_mass_of_axes(const int32_t half[3], int32_t radius, gjk_mass *out);
void gjk_mass_of_cylinder(int32_t base_radius, int32_t half, int32_t radius, gjk_mass *out);
void gjk_mass_of_cone(int32_t base_radius, int32_t half, gjk_mass *out);
void gjk_mass_of_ellipsoid(const int32_t radius[3], gjk_mass *out);

#endif
