// Mass properties in the plane: area, centre of mass and inertia of a shape of uniform density, and of several parts
// together.
//
// Inertia is that of a mass of 1, about an axis across the plane through the centre: multiply by the mass. Its unit, a
// square LSB, is 2^-32 of a square unit of length.
#ifndef GJK2_MASS_H
#define GJK2_MASS_H

#include "gjk/status.h"
#include "gjk2/shape.h"

#ifdef __cplusplus
extern "C" {
#endif

// A body's mass properties in a frame: the shape's own, or the one that parts are placed in.
typedef struct gjk2_mass {
  uint64_t area;        // square LSB
  uint32_t mass;        // any unit, the caller's. gjk2_mass_set_density: Q16.16 of the density's unit of mass
  gjk2_vec centre;      // of mass, Q16.16, to the nearest
  int16_t fraction[2];  // what that rounding leaves, 2^-16 LSB: centre + fraction / 2^16 is the centre, rounded down
  int64_t inertia;      // about the exact centre, for a mass of 1, square LSB
} gjk2_mass;

// The mass properties of a shape, in its own frame. out->mass is 0: set it.
//
// Kinds     point, segment, box and triangle, rounded or not; ellipse, rounded where it is a circle; polygons, rounded or
//           not, of at most two vertices, or convex and in counterclockwise order as gjk2_polygon_order writes them.
// Exact     triangles and polygons without a radius: area, centre and inertia are correctly rounded, a half up. Others:
//           the area is within 0.51 square LSB, the inertia within 0.51 square LSB. The centre is exact, but of a rounded
//           triangle or polygon off by at most 2^-36 LSB before it is rounded down. Symmetry keeps it exact there.
// Flat      A shape without area has its mass spread evenly over its length or its one point.
// Statuses  NULL; those of gjk2_collider_init for the shape; UNSUPPORTED: a custom shape, a polygon that is not in that
//           order, or a rounded ellipse: the length of an ellipse has no closed form. Take a polygon, rounded, for it.
// Cost      with a radius a root of 256 bits and an angle, by 84 products of 96 bits, for each corner.
gjk_status gjk2_mass_of_shape(const gjk2_shape *shape, gjk2_mass *out);

// Sets the mass, Q16.16: the area times a density, Q16.16 of a unit of mass per square unit; to the nearest.
// Statuses  NULL; RANGE: the mass would be 65536 or more.
gjk_status gjk2_mass_set_density(gjk2_mass *body, uint32_t density);

// Adds a part at a pose to a body. A zeroed body has no parts. Parts that overlap count where they do as often as they
// do; a part's mass is what it says.
//
// part      with its mass above 0 (RANGE); not body itself (OVERLAP).
// pose      of the part's frame in the body's.
// body      for each part added the centre is within 2^-8 LSB of the exact one. The inertia is within 1 square LSB and
//           2^-7 of the distance of the centres in LSB. Areas add up.
// Statuses  NULL; ROTATION; RANGE: masses together of 2^32 or more, a centre outside int32, centres more than 2^30 LSB
//           apart along an axis, or a radius of gyration beyond 2^30 LSB.
gjk_status gjk2_mass_add(gjk2_mass *body, const gjk2_mass *part, const gjk2_pose *pose);

#ifdef __cplusplus
}
#endif

#endif
