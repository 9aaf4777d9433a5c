// A triangle of a surface as a body sees it: its corners, its plane, and how the body lies to it.
//
// All but the corners in the world is relative to the body's centre. The body's radius, the margin and the triangle are
// each at most 2^28 along an axis. So near corners are at most 3 2^28 + 1, and sqrt(3) 3 2^28 < 2^30.4 long; edges are
// below 2^29 long.
#ifndef GJK_SRC_SURFACE_FACE_H
#define GJK_SRC_SURFACE_FACE_H

#include "gjk_triangle.h"

// A plane whose unit normal is rounded is off by up to this at the body, LSB.
#define GJK_FACE_LEVEL 2

typedef struct gjk_surface_face {
  uint32_t number;              // the triangle's
  gjk_vec3 local[3], world[3];  // its corners
  gjk_vec3 corner[3];           // counterclockwise seen from the body; relative to the body's centre
  gjk_vec3 direction;           // of its normal, of 30 bits
  gjk_unit3 unit;               // its normal
  gjk_vec3 deepest;             // of the body's core along the normal, relative to its centre
  gjk_q16 height;               // of the body above the plane, negative where it is deeper
  unsigned edges;               // as of gjk_parts_class.edges, from the body's side
} gjk_surface_face;

// Sets number and local. Pre: a walk has found the triangle, so it is there.
void gjk_face_find(const gjk_parts_frame *frame, uint32_t number, gjk_surface_face *f);

// Sets world and corner. False: the triangle is not as it should be, or far from the body.
bool gjk_face_turn(const gjk_parts_frame *frame, const gjk_collider *body, gjk_surface_face *f);

// Sets the rest, and flips the face if the body is on its other side. False: the triangle has no plane, or the body is
// behind it. Pre: corners are set.
bool gjk_face_set(const gjk_parts_frame *frame, const gjk_collider *body, gjk_surface_face *f);

// Is the body, a sum of half axes, more than the margin apart from the triangle along one of them? False proves
// nothing.
// Pre: corners are set.
bool gjk_face_is_aside(const gjk_collider *body, gjk_q16 margin, const gjk_surface_face *f);

// Does a point, relative to the body's centre, lie over the triangle? Along the plane's direction of 30 bits, exact.
bool gjk_face_is_over(const gjk_surface_face *f, const gjk_vec3 *point);

// Does the deepest point lie over the triangle, up to the rounding of its corners? Each corner is off by less than an
// LSB, which tilts a triangle of 128 LSB by 1/64. Above an edge no sharper than that, a point may lie over neither
// side. Pre: the height is at most 2^28 + GJK_FACE_LEVEL.
bool gjk_face_is_nearly_over(const gjk_collider *body, const gjk_surface_face *f);

// Does an edge of a body's core, a sum of half axes, that ends at its deepest point pass through the triangle? False proves
// nothing. Pre: the deepest point lies over the triangle.
bool gjk_face_is_pierced(const gjk_collider *body, const gjk_surface_face *f);

// Is the body, a sum of half axes, so tilted against the plane that it has only one deepest point?
bool gjk_face_is_pointed(const gjk_collider *body, const gjk_surface_face *f);

// The deepest point of the core moved by a length along the normal, in the world.
void gjk_face_move_deepest(const gjk_collider *body, const gjk_surface_face *f, gjk_q16 by, gjk_vec3 *out);

#endif
