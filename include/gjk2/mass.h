// Mass properties in the plane: area, centre of mass and inertia of a shape of uniform density, or of several parts.
//
// Inertia is for a mass of 1, about an axis across the plane through the centre; multiply it by the mass. Its unit, a
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
  uint32_t mass;        // the caller's unit. gjk2_mass_set_density: Q16.16 of the density's unit of mass
  gjk2_vec centre;      // centre of mass, Q16.16, to the nearest
  int16_t fraction[2];  // rest of that rounding, 2^-16 LSB: centre + fraction / 2^16 is the centre, rounded down
  int64_t inertia;      // about the exact centre, for a mass of 1, square LSB
} gjk2_mass;

// The mass properties of a shape in its own frame. out->mass is 0; the caller sets it.
//
// Kinds     point, segment, box and triangle, rounded or not; ellipse; rounded ellipse if it is a circle. Polygons,
//           rounded or not, must be as gjk2_polygon_order writes them, convex and counterclockwise, or have at most two
//           vertices.
// Exact     triangles and polygons without a radius: area, centre and inertia are correctly rounded, halves up. Others:
//           area and inertia are within 0.51 square LSB. The centre is exact, except for rounded triangles and polygons
//           without symmetry. Theirs is within 2^-36 LSB before it is rounded down.
// Flat      A shape without area has its mass spread evenly over its length or its one point.
// Statuses  NULL; those of gjk2_collider_init for the shape. UNSUPPORTED: a custom shape, a polygon that is not as
//           above, or a rounded ellipse. The length of an ellipse has no closed form; use a rounded polygon instead.
// Cost      with a radius, each corner takes a root of 256 bits and an angle, which is 84 products of 96 bits.
gjk_status gjk2_mass_of_shape(const gjk2_shape *shape, gjk2_mass *out);

// Sets the mass, Q16.16, to the area times density, to the nearest. density: Q16.16 mass per square unit.
// Statuses  NULL; RANGE: the mass would be 65536 or more.
gjk_status gjk2_mass_set_density(gjk2_mass *body, uint32_t density);

// Adds a part at a pose to a body. A zeroed body has no parts. Where parts overlap, each of them counts.
//
// part      must have a mass above 0 (RANGE) and must not be body (OVERLAP).
// pose      pose of the part's frame in the body's.
// body      Each part adds an error of at most 2^-8 LSB to the centre. Inertia is within 1 square LSB and 2^-7 of the
//           distance of the centres in LSB. Areas add up.
// Statuses  NULL; ROTATION; RANGE: a total mass of 2^32 or more, a centre outside int32, or a radius of gyration above
//           2^30 LSB. Also RANGE: centres more than 2^30 LSB apart along an axis.
gjk_status gjk2_mass_add(gjk2_mass *body, const gjk2_mass *part, const gjk2_pose *pose);

#ifdef __cplusplus
}
#endif

#endif
