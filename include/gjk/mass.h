// Mass properties: volume, centre of mass and inertia of a shape of uniform density, and of several parts together.
//
//     gjk_mass body = {0}, part;                                  // a zeroed gjk_mass has no parts yet
//     gjk_mass_of_shape(&crate, &part);
//     gjk_mass_set_density(&part, GJK_Q16(700.0));                // or part.mass = ...
//     gjk_mass_add(&body, &part, &pose);                          // and so on for each part
//     gjk_mass_principal(&body, &axes);
//
// Inertia is that of a mass of 1: multiply by the mass. So it depends on the shape alone, and a solver that works with
// ratios of masses takes it as it is. Its unit, a square LSB, is 2^-32 of a square unit of length.
#ifndef GJK_MASS_H
#define GJK_MASS_H

#include "gjk/hull.h"
#include "gjk/shape.h"
#include "gjk/status.h"

#ifdef __cplusplus
extern "C" {
#endif

// A volume, cubic LSB: 2^64 high + low. A cubic unit is 2^48.
typedef struct gjk_volume {
  uint64_t high, low;  // halves of the number
} gjk_volume;

// A symmetric tensor, square LSB: entries of the matrix. So yz is the negative of the mean of y z.
typedef struct gjk_inertia {
  int64_t xx, yy, zz, yz, zx, xy;  // row and column
} gjk_inertia;

// A body's mass properties in a frame: the shape's own, or the one that parts are placed in.
typedef struct gjk_mass {
  gjk_volume volume;    // of all parts together
  uint32_t mass;        // any unit, the caller's. gjk_mass_set_density: Q16.16 of the density's unit of mass
  gjk_vec3 centre;      // of mass, Q16.16, to the nearest
  int16_t fraction[3];  // what that rounding leaves, 2^-16 LSB: centre + fraction / 2^16 is the centre, rounded down
  gjk_inertia inertia;  // about the exact centre, for a mass of 1
} gjk_mass;

// The mass properties of a shape, in its own frame. out->mass is 0: set it.
//
// Kinds     point, segment, triangle, box, cylinder and cone, rounded or not; ellipsoid, rounded where it is a ball; hulls,
//           rounded or not, with faces that gjk_hull_check finds sound. Hulls of at most three vertices need no faces. Of a
//           hull without faces gjk_hull_build finds them, or take gjk_mass_of_hull.
// Exact     triangles and hulls without a radius: volume, centre and inertia are correctly rounded, a half up. Others: the
//           volume is within 0.51 cubic LSB and 2^-60 of itself, the inertia within 0.52 square LSB. The centre is exact, but
//           of rounded triangles, hulls and cones within 2^-36 LSB before it is rounded down.
// Flat      A shape without volume has its mass spread evenly over its area, its length or its one point. A flat box or
//           cylinder has what it tends to as it gets thin; a hull has that of its outline.
// Statuses  NULL; those of gjk_collider_init for the shape; UNSUPPORTED: a rounded ellipsoid, a custom shape, or a hull of
//           more than three vertices without faces. The area of an ellipsoid is an elliptic integral, without a closed form;
//           take a hull of points on it, rounded.
//           RANGE: faces that are not sound, as far as this notices; of others that are not, numbers without meaning.
// Cost      an exact sum over the triangles of the faces, and nine divisions of 256 bits: on Cortex-M3 some 100,000
//           instructions, and 3,000 a triangle. With a radius also three angles a triangle and one an edge, by 84 products
//           of 96 bits each. Each edge is looked for in all faces, so of n corners some n^2 steps are added.
// After     the moments of simplices: their vertices' sum s and products, for tetrahedra (s s' + sum v v') / 20.
//           Rounded: Steiner's formula for moments, in src/mass/gjk_mass_rounded.c.
gjk_status gjk_mass_of_shape(const gjk_shape *shape, gjk_mass *out);

// The same for a hull that gjk_hull_build has found, in the frame of its points; its faces need not be written.
gjk_status gjk_mass_of_hull(const gjk_hull *hull, gjk_mass *out);

// Sets the mass, Q16.16: the volume times a density, Q16.16 of a unit of mass per cubic unit; to the nearest.
// Statuses  NULL; RANGE: the mass would be 65536 or more.
gjk_status gjk_mass_set_density(gjk_mass *body, uint32_t density);

// Adds a part at a pose to a body. A zeroed body has no parts. Where parts overlap, each of them counts.
//
// part      with its mass above 0 (RANGE); not body itself (OVERLAP).
// pose      of the part's frame in the body's.
// body      the centre is within 2^-8 LSB of the exact one for each part added. Inertia is within 12 square LSB and
//           2^-26 of the larger of the inertias and the squared distance of the centres. Volumes add up.
// Statuses  NULL; ROTATION; RANGE: masses together of 2^32 or more, a centre outside int32, or a radius of gyration
//           beyond 2^30 LSB.
gjk_status gjk_mass_add(gjk_mass *body, const gjk_mass *part, const gjk_pose *pose);

// The principal axes of a body.
typedef struct gjk_principal {
  gjk_quat rotation;  // takes x, y, z to the axes
  int64_t moment[3];  // about them, for a mass of 1, square LSB
} gjk_principal;

// Finds the principal axes. Those are chosen that are near x, y, z; a tensor that is diagonal already gives the
// identity, so a cube's does.
//
// Accuracy  In the frame of the rounded rotation each product of inertia is at most 2^-26 of the tensor's largest entry,
//           or 8 square LSB. Each moment is within 2^-27 of that entry, or 2 square LSB. Two moments nearer than that
//           count as equal.
// Statuses  NULL; RANGE: a tensor with entries above 2^60; ITERATION_LIMIT: more than 40
//           rotations. Of 20,000 random tensors none took more than 10.
// After     Jacobi 1846, with each rotation taken from the given tensor anew, so that errors do not add up.
gjk_status gjk_mass_principal(const gjk_mass *body, gjk_principal *out);

#ifdef __cplusplus
}
#endif

#endif
