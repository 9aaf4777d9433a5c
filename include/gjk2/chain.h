// Ground of the plane: a chain of segments that bodies meet from one side, and whose joints they cross without a bump.
//
// Segment i leads from vertex i to vertex i + 1, and its outside lies to its right. So ground runs from right to left.
// A counterclockwise loop is solid, a clockwise one is a room. A chain whose last vertex equals its first is closed.
// Vertices may repeat, and may lie in a line.
//
//     static const gjk2_vec hills[] = {{GJK_Q16(8), 0}, {GJK_Q16(4), GJK_Q16(1)}, {0, 0}};
//     gjk2_chain ground;
//     gjk2_chain_init(&ground, hills, 3, &origin);
//
// The surface has these directions:
//   a segment       its own normal, towards the outside
//   a convex joint  all directions between the normals of its two segments
//   an open end     all directions from the segment's normal to straight on, as if the surface turned back there
//   other joints    none of their own
//
// So a body that slides over joints meets no other normal, whatever its shape and however deep it is.
#ifndef GJK2_CHAIN_H
#define GJK2_CHAIN_H

#include "gjk2/contacts.h"

#ifdef __cplusplus
extern "C" {
#endif

// Start from zeroed memory; gjk2_chain_init fills it. Its contents are the library's. Copies share the vertices.
typedef struct gjk2_chain {
  const gjk2_vec *vertices;  // count vertices
  gjk2_vec position;         // added to each vertex
  gjk2_vec lower, upper;     // the box of all vertices, chain frame
  uint16_t count;            // number of vertices
  uint16_t state;            // tells an initialised chain from other memory
  bool closed;               // the last vertex equals the first
} gjk2_chain;

// Binds a chain to its vertices, checks them, and places it. A chain does not turn, so no vertex is ever rounded.
//
// vertices  the caller's, must outlive the chain; fit for flash.
// position  added to each vertex.
// Statuses  NULL; EMPTY: no two vertices differ; SIZE: a segment is longer than GJK2_RADIUS_MAX along an axis; RANGE: a
//           placed vertex leaves int32. The chain is written only when the result is GJK_OK.
// Cost      one pass over the vertices.
gjk_status gjk2_chain_init(gjk2_chain *chain, const gjk2_vec *vertices, uint16_t count, const gjk2_vec *position);

// Places the chain elsewhere. Statuses: NULL, UNINITIALISED, RANGE.
gjk_status gjk2_chain_move(gjk2_chain *chain, const gjk2_vec *position);

// Segments first to first + count - 1. NULL stands for the whole chain. Answers about a segment do not depend on the
// range.
typedef struct gjk2_chain_range {
  uint16_t first, count;  // the first segment, and the number of segments
} gjk2_chain_range;

// The contacts of a body, B, with one segment or joint. A of the manifold is the segment, with vertices 0 and 1.
//   feature_a  256: the segment; 0: the joint where it begins; 1: the open end where it ends
// The segment's number and the contact's id name a contact from tick to tick.
typedef struct gjk2_chain_contact {
  uint32_t segment;        // number of the segment
  gjk2_manifold manifold;  // normal from the chain to the body; count is 1 or 2
} gjk2_chain_contact;

// The contacts of a body with a chain, from the outside.
//
// body      a posed collider, read only.
// range     NULL: the whole chain.
// margin    Q16.16, from 0 (GJK_ERROR_NEGATIVE) to GJK2_RADIUS_MAX (RANGE); points farther apart are left out.
// out       room for capacity contacts, in the order of segments, with a segment's own before its joint's.
// count     the number of contacts.
//
// From outside  A body meets a segment while its collider's centre is in front of the segment's line or on it. It meets
//               a convex joint while the centre is in front of or on one of the two lines. These tests are exact signs.
//               So ground lets bodies through from behind, and lets go of a body whose centre is in it.
// A segment     The body's deepest corner along the segment's normal must lie opposite the segment. Or an edge of the
//               body must share a stretch with the segment, as in gjk2_contacts. A corner behind both segments of a
//               concave joint, opposite neither, counts for both. A corner beyond an end counts for the segment if the
//               body cannot meet the neighbour there. That is so if their boxes do not meet, or if the centre is behind
//               a convex neighbour.
// Which normal  The direction of the shortest way out wins. It is found exactly, among the directions of segments and
//               joints. A segment yields to a convex neighbour if the way out is shorter along the neighbour's normal.
//               For this the boxes must meet, and the centre must be in front of the neighbour. A segment also yields
//               to a shorter way along a direction of a convex joint or open end in the body's box. If it faces an edge
//               of the body, it yields only to directions more than 20 degrees from its normal. A joint yields unless
//               the shortest way out is strictly inside its range of directions.
// Exact         all of these signs, for points, segments, triangles, boxes, polygons and their forms with a convex
//               radius. Points of an ellipse or custom shape are within 2 LSB. With these, a segment yields only to
//               neighbours' normals more than 20 degrees off, and a joint to normals that reach farther.
//                 normal    within 2^-28 of that of the segment, or of the direction
//                 distance  of the deepest point to the nearest LSB; others as in gjk2_contacts
//                 points    within 4 LSB of the surfaces. A joint's point on the body is directly opposite it. It lies
//                           on the body's surface unless a nearer edge faces no direction of the joint
// Cost          on a Cortex-M3 10 instructions for each segment of the range, and 2,500 to 3,600 for each whose box
//               meets the body's. A ridge under the body takes 11,700 in all, at most 17,200 (plane_bench.elf). Stack:
//               1,316 bytes there, or 2,216 by the call graph, which includes curved shapes (`make sizes`).
//
// What is valid after each status; out beyond count may be overwritten:
//
// OK               count, and the first count of out.
// CAPACITY         the same: there are more contacts than capacity, and the deepest are kept. Ties go to the first.
// ITERATION_LIMIT  nothing, count as it was. Only ellipse and custom can cause it.
// NULL, UNINITIALISED, NEGATIVE, RANGE (of margin or range)  nothing, out and count as they were.
gjk_status gjk2_chain_contacts(const gjk2_chain *chain, const gjk2_collider *body, const gjk2_chain_range *range,
                               gjk_q16 margin, gjk2_chain_contact *out, uint16_t capacity, uint16_t *count);

// Does a shape touch a line of the chain, from either side? A body wholly inside solid ground touches none.
//
// yes       the answer. segment: the first segment touched, set only if yes.
// Exact     as in gjk2_intersect.
// Statuses  NULL, UNINITIALISED, RANGE. ITERATION_LIMIT: open, only with ellipse and custom; nothing is set.
gjk_status gjk2_chain_intersect(const gjk2_chain *chain, const gjk2_collider *body, const gjk2_chain_range *range,
                                bool *yes, uint16_t *segment);

// How far is a shape from the lines of the chain, from either side?
//
// out       of the nearest segment, as gjk2_distance gives it with the segment as A; ties go to the first. In the
//           certificate, vertex 0 is where the segment begins, and 1 and 2 are where it ends.
// segment   number of the segment.
// Statuses  NULL, UNINITIALISED, RANGE. EMPTY: all segments of the range have length 0. ITERATION_LIMIT: nothing set.
// Cost      a query for each segment whose box is nearer than the distance so far.
gjk_status gjk2_chain_distance(const gjk2_chain *chain, const gjk2_collider *body, const gjk2_chain_range *range,
                               gjk2_distance_result *out, uint16_t *segment);

#ifdef __cplusplus
}
#endif

#endif
