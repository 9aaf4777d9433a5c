// Where do two shapes touch? The points that a solver pushes at.
#ifndef GJK_CONTACTS_H
#define GJK_CONTACTS_H

#include "gjk/penetration.h"

#ifdef __cplusplus
extern "C" {
#endif

#define GJK_CONTACTS_MAX 8

// World frame, Q16.16; coordinates beyond int32 are cut off there.
typedef struct gjk_contact {
  gjk_vec3 point_a, point_b;  // on the surfaces, one straight across the normal from the other
  gjk_q16 distance;           // between them along the normal; negative: how deep
  uint16_t id;  // of no other one; lasts while the contact does, as long as the manifold's features do: which part of
                // A in the high byte and of B in the low one, a corner or edge of the face or what lies within
} gjk_contact;

typedef struct gjk_manifold {
  gjk_unit3 normal;    // from A to B, Q2.30
  uint8_t count;       // of contacts; 0: farther apart than the margin
  uint16_t feature_a;  // what each meets the other with. A face: of a box 2 axis + (1 on the side of minus), of a hull
  uint16_t feature_b;  // its number, of a triangle 0, or 1 on the other side; the top of a cylinder 0, its base and a
                       // cone's 1, their side 2. An edge: 256 times its higher vertex number plus the lower one, of 16
                       // bits. A corner: its vertex number. The ids tell which of them it is
  gjk_contact contact[GJK_CONTACTS_MAX];  // in no order that matters
} gjk_manifold;

// The contact manifold of two shapes that overlap or are at most margin apart.
//
// margin     Q16.16, not negative (GJK_ERROR_NEGATIVE): points farther apart are left out.
// most       contacts, 1 to 8 (GJK_ERROR_RANGE); 4 are enough for a solver. Of more are kept: those that span 9/10 at least
//            of the largest area with one of them, which is about as deep as the deepest; one at least is so to 4 LSB; then
//            the ones farthest from all others. Where choices are as good as each other, the lowest ids stay.
// cache, workspace  as of gjk_signed_distance, which is asked first.
// Faces      boxes, triangles, hulls with faces and the flat ends of cylinders and cones (octagons) meet in the polygon that
//            they share, seen along the normal; but no face of a rounded hull that is narrower than some 6 times the root
//            of its rounding, both in LSB, since posing turns it. A shape that has no face within 20 degrees of the
//            normal meets with its edge, or the line of its side, if that is level within 20 degrees. Edges share two
//            points where they are across from each other all along, to 2 LSB; the lines of round sides, where a point
//            between them is on both to half an LSB. At any larger angle edges meet where they cross. Everything else, a hull without faces too,
//            meets in the one point of gjk_signed_distance, and so do shapes whose centres are more than 8192 units apart
//            along an axis. That point always is one of them where it is nearer than all others, but for those left out.
// Ids        functions of the shapes and poses alone. Shapes that rest keep them: of bodies that tremble by an LSB and 1e-7
//            rad, congruent, flush, spun or moved aside, at most 1 in 100 is new from one tick to the next. For that, a
//            point is a corner's when it is near it, whatever edges bound it there; points with one id are one, the deepest;
//            and a crossing of faces' edges that is near a line between other points is left out, unless it is deeper. Near
//            is a 64th of the shortest edge, |x| + |y| + |z|, or 8 LSB, but no more than a quarter of it, along each axis.
// Exact      the shared polygon, but for what ids leave out. Points within 2 LSB of the surfaces and of straight across, and
//            distances within 2 LSB of their gap along the normal; the least distance within 2 LSB of that of
//            gjk_signed_distance, or 6 where points had to be left out for most. Its point: within 3 LSB of that gap, since a
//            depth is rounded up, and 2^-28 of it, as the normal is; where a shape is curved as exact as its depth.
// Cost       of gjk_signed_distance, and 8,000 to 20,000 instructions for faces; stack: `make sizes`.
//
// What is valid in out after each status; after an error all else is as it was:
//
// OK        normal, count, features, the first count contacts.
// CAPACITY  the same. The normal is that of the upper bound; a single point need not lie on the surfaces.
// ITERATION_LIMIT, NULL, UNINITIALISED, NEGATIVE, RANGE  nothing.
gjk_status gjk_contacts(const gjk_collider *a, const gjk_collider *b, gjk_q16 margin, unsigned most, gjk_cache *cache,
                        const gjk_workspace *workspace, gjk_manifold *out);

#ifdef __cplusplus
}
#endif

#endif
