// Mass properties: volume, centre of mass and inertia of a shape of uniform density, and of several parts together.
//
//     gjk_mass body = {0}, part;                                  // a zeroed gjk_mass has no parts yet
//     gjk_mass_of_shape(&crate, &part);
//     gjk_mass_set_density(&part, GJK_Q16(700.0));                // or part.mass = ...
//     gjk_mass_add(&body, &part, &pose);                          // and so on for each part
//     gjk_mass_principal(&body, &axes);
//
// Inertia is for a mass of 1; multiply it by the mass. So it depends on the shape alone, and solvers that work with
// ratios of masses use it as it is. Its unit, a square LSB, is 2^-32 of a square unit of length.
#ifndef GJK_MASS_H
#define GJK_MASS_H

#include "gjk/hull.h"
#include "gjk/shape.h"
#include "gjk/status.h"

#ifdef __cplusplus
extern "C" {
#endif

// A volume in cubic LSB: 2^64 high + low. A cubic unit is 2^48 cubic LSB.
typedef struct gjk_volume {
  uint64_t high, low;  // halves of the number
} gjk_volume;

// A symmetric inertia tensor in square LSB, as entries of the matrix. So yz is minus the mean of y z.
typedef struct gjk_inertia {
  int64_t xx, yy, zz, yz, zx, xy;  // entry of that row and column
} gjk_inertia;

// A body's mass properties in a frame: the shape's own, or the one that parts are placed in.
typedef struct gjk_mass {
  gjk_volume volume;    // sum of all parts
  uint32_t mass;        // the caller's unit. gjk_mass_set_density: Q16.16 of the density's unit of mass
  gjk_vec3 centre;      // centre of mass, Q16.16, to the nearest
  int16_t fraction[3];  // rest of that rounding, 2^-16 LSB: centre + fraction / 2^16 is the centre, rounded down
  gjk_inertia inertia;  // about the exact centre, for a mass of 1
} gjk_mass;

// The mass properties of a shape in its own frame. out->mass is 0; the caller sets it.
//
// Kinds     point, segment, triangle, box, cylinder and cone, rounded or not; ellipsoid; rounded ellipsoid if it is a
//           ball. Hulls, rounded or not, need faces that gjk_hull_check finds sound, except with up to three vertices.
//           gjk_hull_build finds faces for a hull without them, or use gjk_mass_of_hull.
// Exact     triangles and hulls without a radius: volume, centre and inertia are correctly rounded, halves up. Others:
//           the volume is within 0.51 cubic LSB and 2^-60 of itself, the inertia within 0.52 square LSB. The centre is
//           exact, except for rounded triangles, hulls and cones. Theirs is within 2^-36 LSB before it is rounded down.
// Flat      A shape without volume has its mass spread evenly over its area, its length or its one point. A flat box or
//           cylinder has the limit of thin ones, a flat hull that of its outline.
// Statuses  NULL; those of gjk_collider_init for the shape. UNSUPPORTED: a custom shape, a hull of more than three
//           vertices without faces, or a rounded ellipsoid. The area of an ellipsoid has no closed form; use a rounded
//           hull instead. RANGE: faces that the call finds unsound. Other unsound faces give meaningless numbers.
// Cost      an exact sum over the triangles of the faces, and nine divisions of 256 bits. On Cortex-M3 that is some
//           100,000 instructions, and 3,000 a triangle. A radius adds three angles a triangle and one an edge, each 84
//           products of 96 bits. For n corners, finding the edges in all faces adds some n^2 steps.
// After     the moments of simplices, from the sum s and the products of their vertices: for tetrahedra
//           (s s' + sum v v') / 20. Rounded: Steiner's formula for moments, in src/mass/gjk_mass_rounded.c.
gjk_status gjk_mass_of_shape(const gjk_shape *shape, gjk_mass *out);

// The same for a hull made by gjk_hull_build, in the frame of its points. Its faces need not be written.
gjk_status gjk_mass_of_hull(const gjk_hull *hull, gjk_mass *out);

// Sets the mass, Q16.16, to the volume times density, to the nearest. density: Q16.16 mass per cubic unit.
// Statuses  NULL; RANGE: the mass would be 65536 or more.
gjk_status gjk_mass_set_density(gjk_mass *body, uint32_t density);

// Adds a part at a pose to a body. A zeroed body has no parts. Where parts overlap, each of them counts.
//
// part      must have a mass above 0 (RANGE) and must not be body (OVERLAP).
// pose      pose of the part's frame in the body's.
// body      Each part adds an error of at most 2^-8 LSB to the centre. Inertia is within 12 square LSB and 2^-26 of the
//           larger of the inertias and the squared distance of the centres. Volumes add up.
// Statuses  NULL; ROTATION; RANGE: a total mass of 2^32 or more, a centre outside int32, a gyration radius above 2^30
//           LSB.
gjk_status gjk_mass_add(gjk_mass *body, const gjk_mass *part, const gjk_pose *pose);

// The principal axes of a body.
typedef struct gjk_principal {
  gjk_quat rotation;  // takes x, y and z to the axes
  int64_t moment[3];  // moments about the axes for a mass of 1, square LSB
} gjk_principal;

// Finds the principal axes that are nearest to x, y and z. A diagonal tensor, such as a cube's, gives the identity.
//
// Accuracy  In the frame of the rounded rotation, a product of inertia is at most 2^-26 of the tensor's largest entry,
//           or 8 square LSB. A moment is within 2^-27 of that entry, or 2 square LSB. Of the two bounds of each, the
//           larger holds. Moments nearer than that count as equal.
// Statuses  NULL; RANGE: an entry of the tensor above 2^60; ITERATION_LIMIT: more than 40 rotations. Of 20,000 random
//           tensors none took more than 10.
// After     Jacobi 1846; each rotation is found from the given tensor anew, so errors do not add up.
gjk_status gjk_mass_principal(const gjk_mass *body, gjk_principal *out);

#ifdef __cplusplus
}
#endif

#endif
