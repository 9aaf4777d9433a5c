// Ground of the plane: a chain of segments that bodies meet from one side, and cross from joint to joint without a bump.
//
// A chain runs from vertex to vertex; segment i leads from vertex i to vertex i + 1. Its outside lies to the right of the
// way. So ground runs from right to left; a counterclockwise loop is solid, a clockwise one is a room. A chain whose last
// vertex equals its first is closed. Vertices may repeat, and may lie in a line.
//
//     static const gjk2_vec hills[] = {{GJK_Q16(8), 0}, {GJK_Q16(4), GJK_Q16(1)}, {0, 0}};
//     gjk2_chain ground;
//     gjk2_chain_init(&ground, hills, 3, &origin);
//
// Which directions the surface has:
//   a segment       its own normal, to the outside
//   a convex joint  all directions between the normals of its two segments
//   an open end     all directions from the segment's normal to straight on, as if the surface turned back there
//   other joints    none of their own
//
// So a body that slides over joints meets no other normal, whichever its shape, and however deep it is.
#ifndef GJK2_CHAIN_H
#define GJK2_CHAIN_H

#include "gjk2/contacts.h"

#ifdef __cplusplus
extern "C" {
#endif

// Start from zeroed memory; gjk2_chain_init fills it. Its contents are the library's. It may be copied; copies share the
// vertices.
typedef struct gjk2_chain {
  const gjk2_vec *vertices;  // count of them
  gjk2_vec position;         // is added to each
  gjk2_vec lower, upper;     // the box of all vertices, chain frame
  uint16_t count;            // vertices
  uint16_t state;            // tells an initialised chain from other memory
  bool closed;               // the last vertex equals the first
} gjk2_chain;

// Binds a chain to its vertices, checks them, and places it. It does not turn: so no vertex is ever rounded.
//
// vertices  the caller's, must outlive the chain; fit for flash.
// position  is added to each vertex.
// Statuses  NULL; EMPTY: no two vertices differ; SIZE: a segment is longer than GJK2_RADIUS_MAX along an axis; RANGE: a
//           placed vertex leaves int32. The chain is written only when the result is GJK_OK.
// Cost      one pass over the vertices.
gjk_status gjk2_chain_init(gjk2_chain *chain, const gjk2_vec *vertices, uint16_t count, const gjk2_vec *position);

// Places the chain elsewhere. Statuses: NULL, UNINITIALISED, RANGE.
gjk_status gjk2_chain_move(gjk2_chain *chain, const gjk2_vec *position);

// Segments first to first + count - 1. A query that is given none takes the whole chain. What it says about a segment
// does not depend on the range.
typedef struct gjk2_chain_range {
  uint16_t first, count;  // of segments
} gjk2_chain_range;

// The contacts of a body with one segment, or with a joint. A of the manifold is the segment, with vertex 0 and 1; B is
// the body.
//   feature_a  256: the segment; 0: the joint where it begins; 1: the open end where it ends
// The segment's number and the contact's id name a contact from tick to tick.
typedef struct gjk2_chain_contact {
  uint32_t segment;        // its number
  gjk2_manifold manifold;  // normal from the chain to the body; count is 1 or 2
} gjk2_chain_contact;

// The contacts of a body with a chain, from the outside.
//
// body      a posed collider, read only.
// range     NULL: the whole chain.
// margin    Q16.16, from 0 (GJK_ERROR_NEGATIVE) to GJK2_RADIUS_MAX (RANGE); points farther apart are left out.
// out       room for capacity contacts, in the order of segments; of one segment its own before its joint's.
// count     how many there are.
//
// From outside  A body meets a segment while its collider's centre is in front of the segment's line or on it. It meets
//               a convex joint while the centre is so for one of the two lines. That is an exact sign. So ground lets
//               through what comes from behind, and lets go of a body whose centre is in it.
// A segment     The body's corner that is deepest along the segment's normal must lie across from the segment. Or its
//               edge must share a stretch with it, as in gjk2_contacts. Behind both segments of a concave joint, where
//               nothing lies across from either, a corner counts for both. Beyond an end where the body's box does not
//               meet the neighbour's, or the centre is behind a convex neighbour, it counts for the segment.
// Which normal  Each segment and joint compares how far the body reaches along its directions, exactly: the direction
//               of the shortest way out wins. A segment yields where the way out is shorter along a convex neighbour's
//               normal, or along one between the two. It does so if the body's box meets that neighbour's or holds the
//               joint, and the centre is in front of the neighbour. A joint yields unless a direction strictly between
//               is the shortest. A segment that faces an edge of the body yields only to normals more than 20 degrees
//               from its own.
// Exact         all of these signs, for points, segments, triangles, boxes, polygons and their forms with a convex
//               radius. Of an ellipse or custom shape points are within 2 LSB. There a segment yields to its
//               neighbours' normals alone, if they are more than 20 degrees off; a joint to normals that reach farther.
//                 normal    within 2^-28 of that of the segment, or of the direction
//                 distance  of the deepest point to the nearest LSB; others as of gjk2_contacts
//                 points    within 4 LSB of the surfaces. A joint's point on the body is straight across from it. It
//                           lies on the body's surface unless a nearer edge faces no direction of the joint
// Cost          on a Cortex-M3, as plane_bench.elf counts it: 10 instructions for each segment of the range, and 2,500 to
//               3,600 for each whose box meets the body's. A ridge under the body takes 11,700 in all, 17,200 at most.
//               Stack: 1,316 bytes there, 2,216 by the compiler's call graph, which includes curved shapes (`make sizes`).
//
// What is valid after each status; out beyond count may be overwritten:
//
// OK               count, and as many of out.
// CAPACITY         the same: there are more contacts than capacity, and the deepest are kept; ties go to the first.
// ITERATION_LIMIT  nothing, count as it was. Only ellipse and custom can cause it.
// NULL, UNINITIALISED, NEGATIVE, RANGE (of margin or range)  nothing, out and count as they were.
gjk_status gjk2_chain_contacts(const gjk2_chain *chain, const gjk2_collider *body, const gjk2_chain_range *range,
                               gjk_q16 margin, gjk2_chain_contact *out, uint16_t capacity, uint16_t *count);

// Does a shape touch a line of the chain, from either side? A body wholly inside solid ground touches none.
//
// yes       whether; segment: the first that it touches, set only with yes.
// Exact     as gjk2_intersect.
// Statuses  NULL, UNINITIALISED, RANGE, ITERATION_LIMIT (of ellipse and custom: open, nothing is set).
gjk_status gjk2_chain_intersect(const gjk2_chain *chain, const gjk2_collider *body, const gjk2_chain_range *range,
                                bool *yes, uint16_t *segment);

// How far is a shape from the lines of the chain, from either side?
//
// out       of the nearest segment as gjk2_distance gives it, A being the segment; ties go to the first. The
//           certificate's vertex 0 is where the segment begins, 1 and 2 where it ends.
// segment   its number.
// Statuses  NULL, UNINITIALISED, RANGE; EMPTY: the range holds no segment but of length 0; ITERATION_LIMIT: nothing is
//           set.
// Cost      a query for each segment whose box is nearer than the distance so far.
gjk_status gjk2_chain_distance(const gjk2_chain *chain, const gjk2_collider *body, const gjk2_chain_range *range,
                               gjk2_distance_result *out, uint16_t *segment);

#ifdef __cplusplus
}
#endif

#endif
