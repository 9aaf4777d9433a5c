// Where does a body touch a surface of triangles? Contacts with meshes and height fields, along the surface's normals.
#ifndef GJK_SURFACE_H
#define GJK_SURFACE_H

#include "gjk/parts.h"

#ifdef __cplusplus
extern "C" {
#endif

// The contacts of one triangle.
typedef struct gjk_surface_contact {
  uint32_t triangle;      // number of the triangle
  gjk_manifold manifold;  // its normal leads out of the surface, from A to B
} gjk_surface_contact;

// The contacts of a body with a mesh or height field. Each triangle that overlaps the body or is at most margin apart
// has a manifold. Normals that a lone triangle would have, but the surface does not, are left out.
//
// a          a body of triangles: GJK_PARTS_OF_MESH or GJK_PARTS_OF_HEIGHT_FIELD (others: GJK_ERROR_UNSUPPORTED).
// b          a posed collider.
// margin     Q16.16, 0 to GJK_RADIUS_MAX (NEGATIVE, RANGE); points farther apart are left out.
// most       the most contacts of one manifold, 1 to 8 (RANGE).
// workspace  as in gjk_penetration; may be NULL.
// out        room for capacity manifolds, the caller's; may be written in any case. The order depends only on the data
//            of a.
// count      the number of manifolds in out.
//
// Normals  A manifold has the triangle's own normal if a deepest point of the body along it lies over the triangle.
//          Otherwise it may have the normal of an edge or corner. All triangles there must lie behind the plane
//          perpendicular to it, to within 2^-27, or 1/1024 for curved bodies. At a convex edge it lies between both
//          triangles' normals. The triangle's own normal replaces any other that the distance would give. If a
//          neighbour across that normal keeps the body farther out, the neighbour has the contact instead. So flat and
//          concave edges have no normals. An edge that two triangles share only in part counts as open.
// Sides    A body is behind a triangle if more than half of its height along the triangle's normal is behind the plane.
//          A one-sided triangle then has no contact. It has none either if the body is apart and nearest to the
//          triangle's back, as at a border that the body hooks under. A two-sided triangle counts from the side that
//          the body is not behind.
// Missing  Triangles whose corners lie in a line have no contacts. Otherwise a body in front of a triangle that it
//          overlaps has a contact. A body that is apart has one at the least distance. Rarely (1 in 50,000) that is at
//          another triangle farther out (tests/check/unit/test_mesh_contacts.c).
// Twice    A body at an edge or corner has a contact with each triangle there that has the normal.
// Cost     about that of gjk_contacts for each triangle; less if the body lies on a face.
//
// OK               all contacts.
// CAPACITY         there are more manifolds than room. Or the workspace was too small for a pair; its contacts are safe
//                  to move by, but not the least.
// ITERATION_LIMIT  a pair with a curved body reached its ceiling; its contacts are left out.
// Others           those of gjk/parts.h.
gjk_status gjk_surface_contacts(const gjk_parts *a, const gjk_collider *b, gjk_q16 margin, unsigned most,
                                const gjk_workspace *workspace, gjk_surface_contact *out, uint16_t capacity,
                                uint16_t *count);

#ifdef __cplusplus
}
#endif

#endif
