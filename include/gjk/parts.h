// Bodies of many convex parts: compounds (gjk/compound.h), meshes, height fields, and any other kind with a class.
//
// Each query of a pair has a form here that takes such a body as A and a collider as B. It queries the parts whose
// boxes may meet B. It returns the answer of the pair's query for one part, and the number of that part. Such an
// answer can be proven like that of a pair: gjk_parts_place makes the part's collider for the checks of gjk/check.h.
//
// Order    Answers depend neither on the order of the parts in memory nor on the tree above them. Ties go to the part
//          with the lowest number.
// Numbers  start at 0. Where a pointer for a number may be NULL, NULL means that the number is not wanted.
// Caches   There are none: every part is queried from a cold start.
// Statuses of every call, in addition to its own; they leave the outputs as they were:
//            NULL           a pointer is missing, or a body has no class or data
//            UNINITIALISED  a collider is not posed
//            EMPTY          a body has no parts; for the distance of two bodies also: B has nothing but holes
//            ROTATION       the rotation of a body's pose is not a unit
//            RANGE          some rotation of a body would take a part beyond int32. Or a queried part is missing, as in
//                           a field of nothing but holes, or in data that were never checked
//          A body whose parts were not checked may also return any status of gjk_collider_init for a part's shape.
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

// A body of many parts at a pose. The initialiser of its kind sets type and data; pose may change at any time.
typedef struct gjk_parts {
  const gjk_parts_class *type;  // the kind of body
  const void *data;             // a gjk_compound, or whatever else the class takes; the caller's, read only
  gjk_pose pose;                // of the body's frame
} gjk_parts;

// No part.
#define GJK_PARTS_NONE UINT32_MAX

// Room for the shape of a part that is made on demand, such as a triangle of a mesh.
typedef struct gjk_parts_room {
  gjk_shape shape;       // the library's
  gjk_vec3 vertices[4];  // of the shape
} gjk_parts_room;

// The number of parts of a body; 0 for NULL.
uint32_t gjk_parts_count(const gjk_parts *parts);

// Makes the posed collider of one part: the same one that queries use.
//
// room      the caller's; must stay as long as the collider is used.
// out       the caller's.
// Statuses  RANGE also for a number that no part has.
gjk_status gjk_parts_place(const gjk_parts *parts, uint32_t number, gjk_parts_room *room, gjk_collider *out);

// Does some part share a point with B? As gjk_intersect of each part.
//
// part  the lowest number of a part that does; GJK_PARTS_NONE if none does. May be NULL.
// out   the decision for that part. If no part touches: no, with 0 iterations and GJK_PROOF_NONE.
// Cost  that of the pairs whose boxes meet. Once a part touches, only lower numbers are queried.
//
// OK               as above.
// ITERATION_LIMIT  no part is found to touch, and a curved part reached its ceiling. part and out are as they were.
gjk_status gjk_parts_intersect(const gjk_parts *a, const gjk_collider *b, uint32_t *part, gjk_decision *out);

// Is some part at most distance away from B? As gjk_within of each part. NEGATIVE: distance is below 0.
gjk_status gjk_parts_within(const gjk_parts *a, const gjk_collider *b, gjk_q16 distance, uint32_t *part,
                            gjk_decision *out);

// The distance of the nearest part, as gjk_distance of that part.
//
// part   the nearest part; ties go to the lowest number. If parts intersect B, the lowest number among those.
// out    the result for that part alone, iterations included.
// Equal  Parts are compared by their reported distances, to the nearest LSB. Beyond 8192 units these are good to 2^-28.
//
// OK               everything, as in gjk_distance.
// ITERATION_LIMIT  a curved part reached its ceiling and may be nearer than reported. lower is the least lower bound of
//                  such parts. All else is that of the nearest part found, as in gjk_distance with this status.
gjk_status gjk_parts_distance(const gjk_parts *a, const gjk_collider *b, uint32_t *part, gjk_distance_result *out);

// The depth of the deepest part, as gjk_penetration of that part.
//
// Depth, normal and points are those of one part. B moved by depth * normal is clear of that part, but may still
// overlap others. Between two walls no single move clears both. Ask again after the move, or take all contacts.
//
// workspace  as in gjk_penetration, used for one part after the other; may be NULL.
// part       the deepest part; ties go to the lowest number. GJK_PARTS_NONE: no part overlaps.
// out        the result for that part, except that lower is the largest lower bound of all parts. If no part overlaps:
//            not intersecting, with 0 iterations and GJK_PROOF_NONE.
//
// OK               everything, as in gjk_penetration.
// CAPACITY         the same; the depth of the reported part is an upper bound, as in gjk_penetration.
// ITERATION_LIMIT  a curved part reached its ceiling: part and out are as they were.
gjk_status gjk_parts_penetration(const gjk_parts *a, const gjk_collider *b, const gjk_workspace *workspace,
                                 uint32_t *part, gjk_penetration_result *out);

// The manifold of one part.
typedef struct gjk_parts_manifold {
  uint32_t part;          // number of the part of A
  uint32_t part_of_b;     // number of the part of B where B is a body of many parts; else 0
  gjk_manifold manifold;  // with the part as A
} gjk_parts_manifold;

// The contact manifolds of all parts that overlap B or are at most margin away from it, as gjk_contacts of each.
//
// margin, most, workspace  as in gjk_contacts.
// manifolds                the caller's, room for capacity manifolds; may be NULL where capacity is 0. They are in the
//                          order of their parts' numbers.
// count                    the number of manifolds found, including those that do not fit.
//
// OK               manifolds and count.
// CAPACITY         the same. If *count is above capacity, the manifolds of the highest numbers are left out. If the
//                  workspace is too small for a part, its manifold is as gjk_contacts gives it with this status.
// ITERATION_LIMIT  the same, without curved parts that reached their ceiling.
// NEGATIVE, RANGE  margin or most is out of range: nothing.
gjk_status gjk_parts_contacts(const gjk_parts *a, const gjk_collider *b, gjk_q16 margin, unsigned most,
                              const gjk_workspace *workspace, gjk_parts_manifold *manifolds, uint32_t capacity,
                              uint32_t *count);

// The most manifolds of gjk_parts_manifolds and gjk_parts_both_manifolds.
#define GJK_PARTS_MANIFOLDS_MAX 8

// The contacts of all parts, merged by their normals into a few manifolds for a solver, however many parts there are.
//
// margin     0 to GJK_RADIUS_MAX. most, workspace: as in gjk_contacts.
// out        room for capacity manifolds, 1 to GJK_PARTS_MANIFOLDS_MAX (RANGE). The deepest manifold comes first.
//            Without contacts there are none. out may be written whatever the status.
// Merging    The contacts of a part join the manifold with the nearest normal, if it is at most 3 degrees from theirs.
//            Otherwise they begin another one. A manifold takes the normal of its deepest contact, so in a row of
//            normals some may be farther from it. Contacts within 8 LSB of each other per axis count once. If there are
//            more than most, they are chosen as in gjk_contacts.
// Room       If there are more normals than capacity, the least deep are left out. A normal that is left out for a
//            while loses its contacts, so the manifolds that are kept may then depend on capacity.
// Order      Parts are taken in the order of their numbers, so the manifolds do not depend on the tree.
// Surfaces   Contacts of a mesh or height field are those of gjk_surface_contacts.
// Ids        as in gjk_contacts, mixed with the number of the part. Each is unique within its manifold.
// Features   those of the deepest part.
//
// OK               out and count.
// CAPACITY         the same; the workspace was too small for a pair, as in gjk_contacts.
// ITERATION_LIMIT  the same, without curved parts that reached their ceiling.
// NEGATIVE, RANGE  margin, most or capacity is out of range: count is as it was.
gjk_status gjk_parts_manifolds(const gjk_parts *a, const gjk_collider *b, gjk_q16 margin, unsigned most,
                               const gjk_workspace *workspace, gjk_manifold *out, unsigned capacity, unsigned *count);

// The first part that is met when A and B move in straight lines, as gjk_cast of that part.
//
// path  as in gjk_cast: path->to_a is the position of A's pose at the end.
// part  the part with the least fraction. Ties go to a part with inside set, then to the lowest number. GJK_PARTS_NONE:
//       no part is met. May be NULL.
// out   the result for that part, except that rest_a is the position of A's own pose. After a miss only hit is set,
//       with 0 iterations and GJK_CAST_PROOF_NONE.
// Cost  parts are queried from near to far, as far as their boxes tell, and none beyond the first hit so far.
//
// OK               as above.
// ITERATION_LIMIT  everything, as in gjk_cast with this status: a curved part may be met before all others. fraction is
//                  the least fraction up to which such parts are known to be clear.
// NEGATIVE, RANGE  as in gjk_cast; nothing.
gjk_status gjk_parts_cast(const gjk_parts *a, const gjk_collider *b, const gjk_cast_path *path, uint32_t *part,
                          gjk_cast_result *out);

// The first part that the segment from one point to another enters, as gjk_cast_ray of that part.
gjk_status gjk_parts_cast_ray(const gjk_parts *a, const gjk_vec3 *from, const gjk_vec3 *to, uint32_t *part,
                              gjk_cast_result *out);

// The least tolerance of gjk_parts_time_of_impact, 24 LSB. It covers the rounding of composed poses too.
//
// 24 LSB are enough while the farthest points of A and B are together at most 256 units from the positions of their
// poses. Beyond that, add 2^-23 of the excess, 11 LSB if A reaches farther than 4096 units, and 2^-26 of the margin.
#define GJK_PARTS_TOLERANCE_MIN ((gjk_q16)24)

// When does a body that moves and turns first touch B? As gjk_time_of_impact of each part, on its exact arc.
//
// a                   its pose is not read: motion_a gives the pose.
// b                   as in gjk_time_of_impact, posed or not.
// motion_a, motion_b  the motions of the body's pose and of B's pose.
// part, out           the part with the least lower among those that hit. Ties go to a part that overlaps at the start,
//                     then to the lowest number. pose_a is the body's. A miss: lower is GJK_Q30_ONE, iterations 0.
// Cost                if A turns, every part that B can reach at any rotation of A is queried.
//
// OK               as above.
// ITERATION_LIMIT  as in gjk_time_of_impact; lower is the least of the parts that reached a ceiling before any hit.
// ROTATION, NEGATIVE, RANGE  as in gjk_time_of_impact, with the tolerance above; nothing.
gjk_status gjk_parts_time_of_impact(const gjk_parts *a, const gjk_motion *motion_a, const gjk_collider *b,
                                    const gjk_motion *motion_b, const gjk_impact_setup *setup, uint32_t *part,
                                    gjk_impact_result *out);

// As gjk_parts_cast and gjk_parts_time_of_impact, but only for the parts that B is in front of at the start. A body on
// the ground may still run into those.
//
// Triangles  B is in front if all of it is more than the margin beyond the plane. A two-sided triangle counts from the
//            side where most of B lies. In an impact, B meets such a triangle only if it is more than margin +
//            tolerance beyond, or if most of B crosses the plane.
// Others     B is in front of any other part if B is farther than the margin from it. The same holds for a triangle
//            whose corners lie in a line; in an impact, with margin + tolerance instead.
// Rounding   B's height above a plane may be within 12 LSB of the margin. Then B does not meet a triangle within the
//            margin. Otherwise B meets it if B is in front, or if most of B crosses the plane.
// Statuses   as in gjk_parts_cast and gjk_parts_time_of_impact. For an impact, b need only be bound to its shape.
gjk_status gjk_parts_cast_ahead(const gjk_parts *a, const gjk_collider *b, const gjk_cast_path *path, uint32_t *part,
                                gjk_cast_result *out);
gjk_status gjk_parts_impact_ahead(const gjk_parts *a, const gjk_motion *motion_a, const gjk_collider *b,
                                  const gjk_motion *motion_b, const gjk_impact_setup *setup, uint32_t *part,
                                  gjk_impact_result *out);

// Two bodies of many parts. The parts of B are queried one by one against A, so the body with fewer parts should be B.
typedef struct gjk_parts_pair {
  uint32_t a, b;  // numbers of the parts; GJK_PARTS_NONE: none
} gjk_parts_pair;

// The queries above for two bodies. Ties go to the lowest number of B's part, then to the lowest of A's. parts may be
// NULL. In casts rest_b is the position of B's own pose. Manifolds are in the order of B's parts, then of A's.
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

// The least tolerance of gjk_parts_both_time_of_impact, 32 LSB.
//
// 32 LSB are enough while the farthest points of A and B are together at most 256 units from the positions of their
// poses. Beyond that, add 2^-21 of the excess, 11 LSB for each reach above 4096 units, and 2^-26 of the margin.
#define GJK_PARTS_BOTH_TOLERANCE_MIN ((gjk_q16)32)

// When do two bodies that move and turn first touch? As gjk_parts_time_of_impact, each part on its exact arc.
//
// a, b   their poses are not read: motion_a and motion_b give the poses.
// parts  the pair with the least lower among those that hit. Ties go to a pair that overlaps at the start, then to the
//        lowest number of B's part, then of A's. GJK_PARTS_NONE twice: a miss. May be NULL.
// out    the result for that pair. pose_a and pose_b are the bodies'. A miss: lower is GJK_Q30_ONE, iterations 0.
// Cost   every pair whose boxes may meet is queried. If A turns, these are all parts of A within reach at any rotation.
//        If B turns, its parts may be anywhere around its position.
//
// OK               as above.
// ITERATION_LIMIT  as in gjk_time_of_impact; lower is the least of the pairs that reached a ceiling before any hit.
// ROTATION, NEGATIVE, RANGE  for either body as in gjk_parts_time_of_impact, with the tolerance above; nothing.
gjk_status gjk_parts_both_time_of_impact(const gjk_parts *a, const gjk_motion *motion_a, const gjk_parts *b,
                                         const gjk_motion *motion_b, const gjk_impact_setup *setup,
                                         gjk_parts_pair *parts, gjk_impact_result *out);

#ifdef __cplusplus
}
#endif

#endif
