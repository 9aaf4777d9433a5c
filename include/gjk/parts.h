// Bodies of many convex parts: compounds (gjk/compound.h), meshes, height fields, whatever has a class.
//
// Every query of a pair has a form here that takes such a body as A and a collider as B. It asks those parts whose boxes
// may be met. What it answers is what the pair's query answers about one part, and the number of that part. So an answer is
// proven as that of a pair: gjk_parts_place makes the collider of a part, which the checks of gjk/check.h take.
//
// Order    What is answered depends neither on the order of the parts in memory nor on the tree above them. Of parts that
//          are equally good, the one with the least number is reported.
// Numbers  Parts count from 0. Where a pointer for a number may be NULL, the number is not wanted.
// Caches   None are kept: each part is asked from a cold start.
// Statuses of every call, beside its own; outputs are then as they were:
//            NULL           a pointer is missing, or a body has no class or data
//            UNINITIALISED  a collider is not posed
//            EMPTY          a body without parts
//            ROTATION       of the body's pose
//            RANGE          the body is so near an end of int32 that some rotation would take a part beyond it
//          and any that a part's shape earns from gjk_collider_init, of bodies whose parts were not checked.
#ifndef GJK_PARTS_H
#define GJK_PARTS_H

#include "gjk/cast.h"
#include "gjk/contacts.h"
#include "gjk/impact.h"
#include "gjk/intersect.h"

#ifdef __cplusplus
extern "C" {
#endif

// The functions behind a kind of body, opaque: one constant per kind. A program links the kinds that it mentions.
typedef struct gjk_parts_class gjk_parts_class;

// A body of many parts at a pose. The initialiser of its kind sets the first two fields; the pose may change at any time.
typedef struct gjk_parts {
  const gjk_parts_class *type;
  const void *data;  // a gjk_compound, or what else the class takes; the caller's, read only
  gjk_pose pose;
} gjk_parts;

// No part.
#define GJK_PARTS_NONE UINT32_MAX

// Room for the shape of a part that is made when it is asked, such as a triangle of a mesh.
typedef struct gjk_parts_room {
  gjk_shape shape;
  gjk_vec3 vertices[4];
} gjk_parts_room;

// How many parts a body has; 0 for NULL.
uint32_t gjk_parts_count(const gjk_parts *parts);

// Makes the posed collider of one part: the very one that queries ask.
//
// room      the caller's; must stay as long as the collider is used.
// out       the caller's.
// Statuses  RANGE also for a number that no part has.
gjk_status gjk_parts_place(const gjk_parts *parts, uint32_t number, gjk_parts_room *room, gjk_collider *out);

// Does some part share a point with B? As gjk_intersect of each part.
//
// part  the least number of a part that does; GJK_PARTS_NONE if none does. May be NULL.
// out   of that part. If none does: no, with 0 iterations and a certificate that names no proof.
// Cost  of the pairs whose boxes meet; of those found to touch, and of lower numbers, no more than that.
//
// OK               as above.
// ITERATION_LIMIT  no part is found to touch, and a curved one reached its ceiling. part and out are as they were.
gjk_status gjk_parts_intersect(const gjk_parts *a, const gjk_collider *b, uint32_t *part, gjk_decision *out);

// Is some part at most distance away from B? As gjk_within of each part. NEGATIVE: distance is below 0.
gjk_status gjk_parts_within(const gjk_parts *a, const gjk_collider *b, gjk_q16 distance, uint32_t *part,
                            gjk_decision *out);

// The distance of the nearest part, as gjk_distance of it.
//
// part   the nearest part; of equally near ones the least number. Where parts intersect B, the least number of those.
// out    of that part; iterations are those of that part alone.
// Equal  Parts are as near as their reported distances say: to the nearest LSB, and farther apart than 8192 units to 2^-28.
//
// OK               everything, as of gjk_distance.
// ITERATION_LIMIT  a curved part reached its ceiling and may be nearer than what is reported: lower is the least bound of
//                  such parts. All else is as of gjk_distance with this status, of the part that is nearest so far.
gjk_status gjk_parts_distance(const gjk_parts *a, const gjk_collider *b, uint32_t *part, gjk_distance_result *out);

// Two bodies of many parts. The parts of B are asked one after the other, each against A, as above.
typedef struct gjk_parts_pair {
  uint32_t a, b;  // numbers of the parts; GJK_PARTS_NONE: none
} gjk_parts_pair;

// As above, for two bodies. Of equally good pairs the one with the least number of B's part is reported, of those the one
// with the least of A's. parts may be NULL.
gjk_status gjk_parts_both_within(const gjk_parts *a, const gjk_parts *b, gjk_q16 distance, gjk_parts_pair *parts,
                                 gjk_decision *out);
gjk_status gjk_parts_both_distance(const gjk_parts *a, const gjk_parts *b, gjk_parts_pair *parts,
                                   gjk_distance_result *out);

#ifdef __cplusplus
}
#endif

#endif
