// Contact candidates: what two polygons, a polygon and an edge, or two edges share, seen along the direction in which
// they meet.
#ifndef GJK_SRC_CLIP_H
#define GJK_SRC_CLIP_H

#include "gjk/contacts.h"
#include "gjk_contact_polygon.h"

// Two convex polygons share a polygon with at most the corners of both.
#define GJK_CANDIDATES_MAX (2 * GJK_FACE_CORNERS_MAX)

// Contact candidates: pairs of points, one straight across the direction from the other.
typedef struct gjk_candidates {
  gjk_contact candidate[GJK_CANDIDATES_MAX];
  unsigned count;
} gjk_candidates;

// Feature ids: what of a shape's polygon a point lies on. One byte each; A's is the high byte of a contact id.
#define GJK_FEATURE_FACE 0x00u         // inside the face
#define GJK_FEATURE_FACE_CORNER 0x01u  // plus the corner's index
#define GJK_FEATURE_FACE_EDGE 0x11u    // plus the index of the corner where the edge starts
#define GJK_FEATURE_EDGE 0x40u         // inside the edge
#define GJK_FEATURE_EDGE_END 0x41u     // plus the end's index
#define GJK_FEATURE_CORNER 0x80u       // of a polygon that is a corner

// The feature id of a point inside p.
static inline unsigned gjk_feature_of(const gjk_polygon *p) {
  return p->count > 2 ? GJK_FEATURE_FACE : p->count == 2 ? GJK_FEATURE_EDGE : GJK_FEATURE_CORNER;
}

static inline uint16_t gjk_contact_id(unsigned feature_a, unsigned feature_b) {
  return (uint16_t)(feature_a << 8 | feature_b);
}

// Finds the contact candidates: the corners of the region that a and b share, seen along a->direction, at most margin
// apart. b->direction is the opposite of a->direction. centre is the origin of the polygons in the world, where the
// candidates are. Two edges share a region only where they lie across from each other, to less than 2 LSB or within
// their radii.
// Pre: both have two corners at least.
void gjk_clip(const gjk_polygon *a, const gjk_polygon *b, const gjk_vec3 *centre, gjk_q16 margin, gjk_candidates *out);

#endif
