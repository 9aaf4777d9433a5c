// Bodies of many convex parts: compounds (gjk/compound.h), meshes, height fields, whatever has a class.
//
// Every query of a pair has a form here that takes such a body as A and a collider as B. It asks those parts whose boxes
// may be met. It returns the answer of the pair's query for one part, and that part's number. So an answer can be proven
// like that of a pair: gjk_parts_place makes the part's collider, which the checks of gjk/check.h take.
//
// Order    Answers depend neither on the order of the parts in memory nor on the tree above them. Ties go to the part with
//          the lowest number. gjk_parts_manifolds has a rule of its own.
// Numbers  Parts count from 0. Where a pointer for a number may be NULL, the number is not wanted.
// Caches   None are kept: each part is asked from a cold start.
// Statuses of every call, in addition to its own; they leave the outputs as they were:
//            NULL           a pointer is missing, or a body has no class or data
//            UNINITIALISED  a collider is not posed
//            EMPTY          a body without parts; of two bodies also a B with holes alone, asked for the distance
//            ROTATION       of the body's pose
//            RANGE          the body is so near an end of int32 that some rotation would take a part beyond it; or a part
//                           that is asked is not there: a field of holes alone, or data that were never checked
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
  const gjk_parts_class *type;  // its kind
  const void *data;             // a gjk_compound, or what else the class takes; the caller's, read only
  gjk_pose pose;                // of the body's frame
} gjk_parts;

// No part.
#define GJK_PARTS_NONE UINT32_MAX

// Room for the shape of a part that is made when it is asked, such as a triangle of a mesh.
typedef struct gjk_parts_room {
  gjk_shape shape;       // the library's
  gjk_vec3 vertices[4];  // of the shape
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
// Cost  of the pairs whose boxes meet. Once a part touches, only lower numbers are asked.
//
// OK               as above.
// ITERATION_LIMIT  no part is found to touch, and a curved one reached its ceiling. part and out are as they were.
gjk_status gjk_parts_intersect(const gjk_parts *a, const gjk_collider *b, uint32_t *part, gjk_decision *out);

// Is some part at most distance away from B? As gjk_within of each part. NEGATIVE: distance is below 0.
gjk_status gjk_parts_within(const gjk_parts *a, const gjk_collider *b, gjk_q16 distance, uint32_t *part,
                            gjk_decision *out);

// The distance of the nearest part, as gjk_distance of it.
//
// part   the nearest part; ties go to the lowest number. If parts intersect B, the lowest number among those.
// out    of that part; iterations are those of that part alone.
// Equal  Parts are as near as their reported distances say: to the nearest LSB, and farther apart than 8192 units to 2^-28.
//
// OK               everything, as of gjk_distance.
// ITERATION_LIMIT  a curved part reached its ceiling and may be nearer than what is reported: lower is the least bound of
//                  such parts. All else is as of gjk_distance with this status, of the part that is nearest so far.
gjk_status gjk_parts_distance(const gjk_parts *a, const gjk_collider *b, uint32_t *part, gjk_distance_result *out);

// The depth of the deepest part, as gjk_penetration of it.
//
// That is the depth, the direction and the points of one part. B moved by depth normal is clear of that part. It may still
// overlap others, which one move need not part it from: between two walls there is none. Ask again after the move, or take
// the contacts of all parts.
//
// workspace  as of gjk_penetration, used for one part after the other; may be NULL.
// part       the deepest part; ties go to the lowest number. GJK_PARTS_NONE: none overlaps.
// out        of that part. lower is the largest lower bound of all parts. Where no part overlaps: not intersecting, with 0
//            iterations and a certificate that names no proof.
//
// OK               everything, as of gjk_penetration.
// CAPACITY         the same, where the depth of the reported part is an upper bound, as gjk_penetration has it.
// ITERATION_LIMIT  of a curved part: part and out are as they were.
gjk_status gjk_parts_penetration(const gjk_parts *a, const gjk_collider *b, const gjk_workspace *workspace,
                                 uint32_t *part, gjk_penetration_result *out);

// The manifold of one part.
typedef struct gjk_parts_manifold {
  uint32_t part;          // of A
  uint32_t part_of_b;     // where B is a body of many parts; else 0
  gjk_manifold manifold;  // A is the part
} gjk_parts_manifold;

// The contact manifolds of all parts that overlap B or are at most margin away from it, as gjk_contacts of each.
//
// margin, most, workspace  as of gjk_contacts.
// manifolds                the caller's, room for capacity of them; may be NULL where capacity is 0. In the order of their
//                          numbers: those with the least, as many as fit.
// count                    how many there are, also those that do not fit.
//
// OK               manifolds and count.
// CAPACITY         the same. Where *count is above capacity, the manifolds of the highest numbers are left out. Where the
//                  workspace is too small for a part, its manifold is as gjk_contacts gives it with this status.
// ITERATION_LIMIT  the same, without curved parts that reached their ceiling.
// NEGATIVE, RANGE  of margin and most: nothing.
gjk_status gjk_parts_contacts(const gjk_parts *a, const gjk_collider *b, gjk_q16 margin, unsigned most,
                              const gjk_workspace *workspace, gjk_parts_manifold *manifolds, uint32_t capacity,
                              uint32_t *count);

// Most manifolds of the next two calls.
#define GJK_PARTS_MANIFOLDS_MAX 8

// The contacts of all parts, put together by their normals: what a solver takes, a few manifolds for any number of parts.
//
// margin     0 to GJK_RADIUS_MAX. most, workspace: as of gjk_contacts.
// out        room for capacity manifolds, 1 to GJK_PARTS_MANIFOLDS_MAX (RANGE); it may be written in any case. The deepest
//            comes first; there are none without contacts.
// Together   A part's contacts join the manifold whose normal is nearest to theirs, at most 3 degrees away, or begin another
//            one. The deepest contact gives the normal; so in a row of normals some may be farther from it. Contacts in one
//            place, within 8 LSB per axis, count once. Beyond most, the same ones are kept as by gjk_contacts.
// Room       Normals beyond capacity are left out, the least deep ones. One that is left out for a while loses its contacts,
//            so with more normals than room what is left may depend on capacity.
// Order      It may depend on the order of the parts in memory, and on the tree. Both are data: peers have the same.
// Surfaces   Contacts of a mesh or height field are those of gjk_surface_contacts.
// Ids        as of gjk_contacts, with the numbers of the parts mixed in. Within a manifold each is there once.
// Features   of the deepest part.
//
// OK               out and count.
// CAPACITY         the same; the workspace was too small for a pair, as gjk_contacts has it.
// ITERATION_LIMIT  the same, without curved parts that reached their ceiling.
// NEGATIVE, RANGE  of margin, most and capacity: count is as it was.
gjk_status gjk_parts_manifolds(const gjk_parts *a, const gjk_collider *b, gjk_q16 margin, unsigned most,
                               const gjk_workspace *workspace, gjk_manifold *out, unsigned capacity, unsigned *count);

// The part that is met first where both move straight, as gjk_cast of it.
//
// path  as of gjk_cast: path->to_a is where the position of A's pose goes.
// part  the one with the least fraction; ties go to one that is inside, then to the lowest number. GJK_PARTS_NONE: no part
//       is met. May be NULL.
// out   of that part, but for rest_a, which is the position of A's own pose. A miss: hit alone, with 0 iterations and a
//       certificate that names no proof.
//
// OK               as above.
// ITERATION_LIMIT  everything, as of gjk_cast with this status: of a curved part that may be met before all others, at the
//                  least fraction up to which such parts are known to be free.
// NEGATIVE, RANGE  as of gjk_cast; nothing.
gjk_status gjk_parts_cast(const gjk_parts *a, const gjk_collider *b, const gjk_cast_path *path, uint32_t *part,
                          gjk_cast_result *out);

// The part that a segment from one point to another enters first, as gjk_cast_ray of it.
gjk_status gjk_parts_cast_ray(const gjk_parts *a, const gjk_vec3 *from, const gjk_vec3 *to, uint32_t *part,
                              gjk_cast_result *out);

// The least tolerance of gjk_parts_time_of_impact, 24 LSB. It pays for the rounding of composed poses too. It is enough where
// the farthest points of A and B are together at most 256 units from the positions of their poses. Beyond that 2^-23 of the
// excess comes on top, 11 LSB for an A that reaches farther than 4096 units, and 2^-26 of the margin.
#define GJK_PARTS_TOLERANCE_MIN ((gjk_q16)24)

// When does a body that moves and turns first touch B? As gjk_time_of_impact of each part, which runs along an arc with its
// body, exactly.
//
// a                   its pose is not read: motion_a has it.
// b                   as of gjk_time_of_impact, posed or not.
// motion_a, motion_b  of the pose of the body, and of B's.
// part, out           of the part with the least lower among those that hit; ties go to one that overlaps at the start, then
//                     to the lowest number. pose_a is the pose of the body. A miss: lower is the end of the way, iterations are 0.
// Cost                where A turns, every part within reach of B's way, at any rotation of A, is asked.
//
// OK               as above.
// ITERATION_LIMIT  as of gjk_time_of_impact: lower is the least one of parts whose ceiling was reached, before all hits.
// ROTATION, NEGATIVE, RANGE  as of gjk_time_of_impact, with the tolerance above; nothing.
gjk_status gjk_parts_time_of_impact(const gjk_parts *a, const gjk_motion *motion_a, const gjk_collider *b,
                                    const gjk_motion *motion_b, const gjk_impact_setup *setup, uint32_t *part,
                                    gjk_impact_result *out);

// As gjk_parts_cast and gjk_parts_time_of_impact, of those parts alone that B is in front of at the start. That is what
// a body on the ground may still run into.
//
// In front  of a triangle: all of B is more than the margin beyond its plane. Of a triangle with two sides that side
//           counts where most of B is. An impact meets a triangle that is no nearer than the tolerance, or one whose
//           plane most of B goes through. Of other parts: B is farther than the margin from it. Of a triangle whose
//           corners lie in a line: farther than the margin, for an impact than margin and tolerance.
// Rounding  Where B's height is within 12 LSB of that margin, a triangle that B is as near to is not met. Another one
//           is, if B is in front of it or most of B goes through its plane.
// Statuses  as of gjk_parts_cast and gjk_parts_time_of_impact; b has to be bound to its shape, no more, for an impact.
gjk_status gjk_parts_cast_ahead(const gjk_parts *a, const gjk_collider *b, const gjk_cast_path *path, uint32_t *part,
                                gjk_cast_result *out);
gjk_status gjk_parts_impact_ahead(const gjk_parts *a, const gjk_motion *motion_a, const gjk_collider *b,
                                  const gjk_motion *motion_b, const gjk_impact_setup *setup, uint32_t *part,
                                  gjk_impact_result *out);

// Two bodies of many parts. The parts of B are asked one after the other, each against A, as above; so the one with fewer
// parts is better B.
typedef struct gjk_parts_pair {
  uint32_t a, b;  // numbers of the parts; GJK_PARTS_NONE: none
} gjk_parts_pair;

// As above, for two bodies. Ties go to the lowest number of B's part, then to the lowest of A's. parts may be NULL. In casts
// rest_b is the position of B's own pose. Manifolds are in the order of B's parts, then of A's.
gjk_status gjk_parts_both_within(const gjk_parts *a, const gjk_parts *b, gjk_q16 distance, gjk_parts_pair *parts,
                                 gjk_decision *out);
gjk_status gjk_parts_both_distance(const gjk_parts *a, const gjk_parts *b, gjk_parts_pair *parts,
                                   gjk_distance_result *out);
gjk_status gjk_parts_both_penetration(const gjk_parts *a, const gjk_parts *b, const gjk_workspace *workspace,
                                      gjk_parts_pair *parts, gjk_penetration_result *out);
gjk_status gjk_parts_both_contacts(const gjk_parts *a, const gjk_parts *b, gjk_q16 margin, unsigned most,
                                   const gjk_workspace *workspace, gjk_parts_manifold *manifolds, uint32_t capacity,
                                   uint32_t *count);
gjk_status gjk_parts_both_manifolds(const gjk_parts *a, const gjk_parts *b, gjk_q16 margin, unsigned most,
                                    const gjk_workspace *workspace, gjk_manifold *out, unsigned capacity,
                                    unsigned *count);
gjk_status gjk_parts_both_cast(const gjk_parts *a, const gjk_parts *b, const gjk_cast_path *path, gjk_parts_pair *parts,
                               gjk_cast_result *out);

// The least tolerance of gjk_parts_both_time_of_impact, 32 LSB. It is enough where the farthest points of A and B are
// together at most 256 units from the positions of their poses. Beyond that 2^-21 of the excess comes on top, 11 LSB
// for each body that reaches farther than 4096 units, and 2^-26 of the margin.
#define GJK_PARTS_BOTH_TOLERANCE_MIN ((gjk_q16)32)

// When do two bodies that move and turn first touch? As gjk_parts_time_of_impact: every part runs along an arc with its body.
//
// a, b   their poses are not read: motion_a and motion_b have them.
// parts  the pair with the least lower among those that hit; ties go to one that overlaps at the start,
//        then to the lowest number of B's part, then of A's. GJK_PARTS_NONE twice: a miss. May be NULL.
// out    of that pair. pose_a and pose_b are the poses of the bodies. A miss: lower is the end of the way, iterations are 0.
// Cost   every pair whose boxes may meet is asked. Where A turns, that is every part of A within reach at any rotation; where
//        B turns, its parts may be anywhere around its position.
//
// OK               as above.
// ITERATION_LIMIT  as of gjk_time_of_impact: lower is the least one of pairs whose ceiling was reached, before all hits.
// ROTATION, NEGATIVE, RANGE  of either body, as of gjk_parts_time_of_impact, with the tolerance above; nothing.
gjk_status gjk_parts_both_time_of_impact(const gjk_parts *a, const gjk_motion *motion_a, const gjk_parts *b,
                                         const gjk_motion *motion_b, const gjk_impact_setup *setup,
                                         gjk_parts_pair *parts, gjk_impact_result *out);

#ifdef __cplusplus
}
#endif

#endif
