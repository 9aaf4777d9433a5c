// Where do two shapes touch? The points that a solver pushes at.
#ifndef GJK_CONTACTS_H
#define GJK_CONTACTS_H

#include "gjk/penetration.h"

#ifdef __cplusplus
extern "C" {
#endif

#define GJK_CONTACTS_MAX 8

// World frame, Q16.16.
typedef struct gjk_contact {
  gjk_vec3 point_a, point_b;  // on the surfaces, one straight across the normal from the other
  gjk_q16 distance;           // between them along the normal; negative: how deep
  uint16_t id;                // the same while the contact persists, as long as the manifold's features are
} gjk_contact;

typedef struct gjk_manifold {
  gjk_unit3 normal;  // from A to B, Q2.30
  uint8_t count;     // of contacts; 0: farther apart than the margin, nothing else is set
  uint16_t feature_a,
      feature_b;  // the face that each meets the other with: of a box 2 axis + (1 on the side of minus),
                  // of a hull its number, of a cylinder 0 top, 1 base, 2 side, of a cone 1 base, 2 side
  gjk_contact contact[GJK_CONTACTS_MAX];  // in no order that matters
} gjk_manifold;

// The contact manifold of two shapes that overlap or are at most margin apart.
//
// margin     Q16.16, not negative (GJK_ERROR_NEGATIVE): points farther apart are left out.
// most       contacts, 1 to 8 (GJK_ERROR_RANGE); 4 are enough for a solver. More are reduced to the deepest, the one
//            farthest from it, those that span the largest area to either side, then those farthest from all others.
// cache, workspace  as of gjk_signed_distance, which is asked first.
// out        written when the result is GJK_OK or CAPACITY.
// Faces      boxes, triangles, hulls with faces and the flat ends of cylinders and cones meet in a polygon: the corners of
//            the one clipped by the other; parallel edges, and lines of capsules, cylinders and cones, in two points;
//            everything else, a hull without faces too, in the one point of gjk_signed_distance. A face counts when it
//            is within 20 degrees of the normal; an end of a cylinder or cone counts as an octagon.
// Accuracy   points within 3 LSB of the shapes, distances within 3 LSB of their gap along the normal; not exact, but the
//            same bits everywhere. Parallel edges are across from each other to within their angle.
// Cost       of gjk_signed_distance, and a few thousand instructions; stack: `make sizes`.
// Statuses   NULL, UNINITIALISED, NEGATIVE, RANGE, ITERATION_LIMIT; CAPACITY: the normal is that of the upper bound.
gjk_status gjk_contacts(const gjk_collider *a, const gjk_collider *b, gjk_q16 margin, unsigned most, gjk_cache *cache,
                        const gjk_workspace *workspace, gjk_manifold *out);

#ifdef __cplusplus
}
#endif

#endif
