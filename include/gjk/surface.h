// Where does a body touch a surface of triangles? Contacts with meshes and height fields, by normals that the surface has.
#ifndef GJK_SURFACE_H
#define GJK_SURFACE_H

#include "gjk/parts.h"

#ifdef __cplusplus
extern "C" {
#endif

// The contacts of one triangle: its number, and the manifold. Its normal leads out of the surface, from A to B.
typedef struct gjk_surface_contact {
  uint32_t triangle;      // its number
  gjk_manifold manifold;  // normal from A to B
} gjk_surface_contact;

// The contacts of a body with a mesh or height field: one manifold for each triangle that it overlaps, or is at most
// margin apart from. Normals that the triangle alone would have, and the surface has not, are left out.
//
// a          a body of triangles: GJK_PARTS_OF_MESH, GJK_PARTS_OF_HEIGHT_FIELD (others: GJK_ERROR_UNSUPPORTED).
// b          a posed collider.
// margin     Q16.16, 0 to GJK_RADIUS_MAX (NEGATIVE, RANGE); points farther apart are left out.
// most       contacts of one manifold at most, 1 to 8 (RANGE).
// workspace  as of gjk_penetration; may be NULL.
// out        room for capacity manifolds, the caller's; it may be written in any case. In an order that is fixed by the
//            data of a.
// count      how many there are in out.
//
// Normals  The normal of a manifold is one of these:
//          the triangle's own, where a deepest point of the body along it lies over the triangle;
//          of an edge or corner, if all triangles there lie behind the plane across it: at a convex edge between both
//          normals. To within 2^-27, for curved bodies 1/1024;
//          the triangle's own, in place of any other that the distance would have. If a neighbour across it keeps the body
//          farther out, it has the contact instead.
//          So flat and concave edges have none. Edges that two triangles share in part alone count as open.
// Sides    A body is behind a triangle if more than half of its height along the triangle's normal is behind the plane. There
//          is no contact with a triangle of one side then, nor where the nearest point of a body apart is on its back, such as
//          at a border that the body hooks under. Of two sides the one counts where the body is not behind.
// Missing  Triangles whose corners lie in a line have none. Every other body in front of a triangle that it overlaps has a
//          contact, and so has one apart: at the least distance, or rarely (1 of 50,000) at another triangle, farther
//          out (tests/check/unit/test_mesh_contacts.c).
// Twice    A body at an edge or corner has its contact with each triangle there that has the normal.
// Cost     about that of gjk_contacts for each triangle; less where the body lies on a face.
//
// OK               all contacts.
// CAPACITY         there are more manifolds than room; or the workspace was too small for a pair, and its contacts are safe to
//                  move by but not the least.
// ITERATION_LIMIT  a pair with a curved body reached its ceiling; its contacts are left out.
// Others           those of gjk/parts.h.
gjk_status gjk_surface_contacts(const gjk_parts *a, const gjk_collider *b, gjk_q16 margin, unsigned most,
                                const gjk_workspace *workspace, gjk_surface_contact *out, uint16_t capacity,
                                uint16_t *count);

#ifdef __cplusplus
}
#endif

#endif
