// Articulated machines in motion: robot arms, cranes, doors, lifts, turrets. Is a whole motion free of contact, between
// the samples too?
//
// A machine is a tree of links, which joints move. Each link carries parts: convex shapes. A configuration is an array of
// joint values, one for each joint that moves, in the order of the links: angles (gjk_angle) of revolute joints, lengths
// (Q16.16) of prismatic ones. An edge moves all joints from one configuration to another at steady rates.
//
//     static const gjk_arm_model model = {links, parts, NULL, 7, 8};  // constants, may be in flash
//     static gjk_arm_link_room links_room[7];
//     ...
//     gjk_arm_init(&arm, &model, &base, &memory);
//     gjk_arm_obstacles(&arm, crates, 12);
//     gjk_arm_edge_start(&arm, from, to, &setup);
//     gjk_arm_edge_run(&arm, 1000, &result);  // FREE, TOUCH, or UNSETTLED so far: call it again to go on
//
// Tested   Pairs of parts of different links, and each part with each obstacle, where some joint moves one against the
//          other. Not tested: parts of links that a joint connects, and pairs in the model's list.
// Bodies   An obstacle may be a body of many parts: a compound, a mesh, a height field. Its parts are called pieces here.
//          A surface has no inside: what is wholly behind it is free.
// Real     An answer holds for the motion in real numbers: every rounding is paid for. src/arm/gjk_arm_bound.c has the
//          bounds and their proof.
// Curved   Cylinders, cones, ellipsoids and custom shapes count as accurately as gjk/intersect.h states.
// Range    From the base to a part, the lengths of all offsets and extensions and the part's reach must be together at
//          most GJK_ARM_REACH_MAX, and the angles that the joints turn by on an edge GJK_ARM_TURN_MAX (RANGE).
#ifndef GJK_ARM_H
#define GJK_ARM_H

#include "gjk/collider.h"
#include "gjk/distance.h"
#include "gjk/joint.h"
#include "gjk/parts.h"

#ifdef __cplusplus
extern "C" {
#endif

// Most links of a machine, and most parts of it. Obstacles may be up to 65535, and bodies as many.
#define GJK_ARM_LINKS_MAX 32
#define GJK_ARM_PARTS_MAX 1024

// See Range above: 2048 units, 128 radians.
#define GJK_ARM_REACH_MAX INT32_C(134217728)
#define GJK_ARM_TURN_MAX INT32_C(8388608)

// The parent of a link that stands on the base.
#define GJK_ARM_BASE 255

// How a joint moves its link against the parent.
typedef enum gjk_arm_kind {
  GJK_ARM_FIXED = 0,  // not; it has no value
  GJK_ARM_REVOLUTE,   // turns it about the axis, by the right-hand rule
  GJK_ARM_PRISMATIC   // shifts it along the axis
} gjk_arm_kind;

// A link, and the joint that it hangs on.
typedef struct gjk_arm_link {
  uint8_t parent;        // a link with a lower number; GJK_ARM_BASE: the base
  uint8_t kind;          // a gjk_arm_kind
  gjk_pose fixed;        // of the link's frame in its parent's, at value 0
  gjk_vec3 axis;         // in the link's frame, through its origin; of any length but 0, which a fixed joint may have
  int32_t lower, upper;  // limits of the value. Values beyond are allowed, and are said
} gjk_arm_link;

// A shape on a link.
typedef struct gjk_arm_part {
  const gjk_shape *shape;  // must stay as long as the arm
  gjk_pose pose;           // of the shape in the link's frame; an exact identity is fastest and costs no accuracy
  uint8_t link;            // its number
} gjk_arm_part;

// A machine, constant.
typedef struct gjk_arm_model {
  const gjk_arm_link *links;  // parents before their children
  const gjk_arm_part *parts;  // in any order
  const uint32_t *never;      // one word a link: bit k of word i set: links i and k are never tested. NULL: none
  uint8_t link_count;         // 1 to GJK_ARM_LINKS_MAX
  uint16_t part_count;        // 0 to GJK_ARM_PARTS_MAX
} gjk_arm_model;

// A link's frame in the world: the library's.
typedef struct gjk_arm_frame {
  int64_t origin[3];  // Q30 of an LSB
  gjk_quat rotation;  // Q2.30
  gjk_vec3 rows[3];   // its matrix
  gjk_vec3 at;        // origin to the nearest LSB
} gjk_arm_frame;

// Room for a link in RAM: the library's.
typedef struct gjk_arm_link_room {
  gjk_joint joint;         // the axis of a prismatic one is in quarter
  uint32_t above;          // links from the base to this one, itself included, as bits
  uint32_t change;         // how far the joint moves on the edge, LSB of its value
  uint32_t extent;         // of a prismatic joint: its largest value on the edge, LSB
  gjk_arm_frame frame[2];  // at both ends of a span
} gjk_arm_link_room;

// Room for a part in RAM: the library's.
typedef struct gjk_arm_part_room {
  gjk_collider collider;  // in the link's frame
  gjk_vec3 at[2];         // its centre in the world, at both ends of a span
  gjk_vec3 middle;        // of the chord between them
  int32_t half;           // no less than half of the chord, LSB
  int32_t reach;          // of the part from the link's origin, LSB
  uint8_t slack;          // of its support points, LSB
  bool scanned;           // its support points are vertices of the shape as they are
} gjk_arm_part_room;

// Room for a pair in RAM: the library's.
typedef struct gjk_arm_pair {
  uint64_t bend;         // bound of the second derivative on the edge, LSB
  int32_t slack;         // all roundings, LSB
  gjk_unit3 direction;   // that last parted the pair
  uint32_t done;         // where it was last tested for a touch; of a check, up to where it is proven apart
  uint32_t piece;        // of a body: the one that was last found open
  uint16_t part, other;  // their numbers
  uint8_t frame;         // the link whose parts other is one of; GJK_ARM_BASE: an obstacle; one less: a body
  uint8_t level;         // the depth of the span on which it is proven apart
} gjk_arm_pair;

// The caller's memory, all of which must stay as long as the arm.
typedef struct gjk_arm_memory {
  gjk_arm_link_room *links;  // one for each link
  gjk_arm_part_room *parts;  // one for each part
  gjk_arm_pair *pairs;       // GJK_ARM_PAIRS(parts, obstacles and bodies) are enough for any machine; fewer may be
  uint32_t pair_capacity;    // how many there are
} gjk_arm_memory;

// As many pairs as a number of parts and obstacles can have.
#define GJK_ARM_PAIRS(parts, obstacles) ((parts) * (obstacles) + (parts) * ((parts)-1) / 2)

// How exactly an edge is wanted. Lengths Q16.16.
typedef struct gjk_arm_setup {
  gjk_q16 margin;      // the gap that must be kept: 0 to GJK_ARM_MARGIN_MAX
  gjk_q16 tolerance;   // a gap above margin by no more than this may be a touch: from GJK_ARM_TOLERANCE_MIN
  gjk_q30 resolution;  // how near lower and upper of a touch shall be; GJK_Q30_ONE: any touch will do
} gjk_arm_setup;

// The largest margin, 1024 units, and the least tolerance, 48 LSB. It is enough for parts that move by up to 128 units on
// an edge, and reach as far from the base; beyond that an edge that grazes may stay UNSETTLED.
#define GJK_ARM_MARGIN_MAX ((gjk_q16)67108864)
#define GJK_ARM_TOLERANCE_MIN ((gjk_q16)48)

// The largest gap that is reported: 2048 units.
#define GJK_ARM_GAP_MAX ((gjk_q16)134217728)

// Two things of which one or both belong to the machine.
typedef struct gjk_arm_names {
  uint16_t part;   // its number in the model
  uint16_t other;  // the number of another part, of an obstacle, or of a body
  bool obstacle;   // other is an obstacle or a body
  uint32_t piece;  // of a body: the number of its part; else GJK_PARTS_NONE
} gjk_arm_names;

// What is known of an edge.
typedef enum gjk_arm_answer {
  GJK_ARM_UNSETTLED = 0,  // before lower nothing comes within the margin; the rest is open
  GJK_ARM_FREE,           // on the whole edge nothing does
  GJK_ARM_TOUCH           // before lower nothing does; at upper a pair is within margin and tolerance
} gjk_arm_answer;

// Lengths Q16.16, fractions of the edge Q2.30.
typedef struct gjk_arm_edge_result {
  gjk_arm_answer answer;  // as above
  gjk_q30 lower;          // before it all pairs are proven farther apart than the margin; FREE: GJK_Q30_ONE, included
  gjk_q30 upper;          // TOUCH: where the pair comes within margin and tolerance; else GJK_Q30_ONE
  gjk_q16 gap;         // FREE: no pair undercuts it, proven; from margin to GJK_ARM_GAP_MAX. Not the largest such bound
  gjk_arm_names pair;  // TOUCH: which pair comes near at upper
  uint32_t tests;      // of a pair on a span, so far
  bool outside;        // a value of from or to is outside its limits
} gjk_arm_edge_result;

// One step of a certificate: on the span from one fraction to another a pair is apart, as both ends show along a direction.
// It leads from the other thing to the part, in the frame of the other part's link, or of an obstacle in the world. A body has
// a step for each piece that is near the part, and a last one without a direction. All other pieces are outside a box
// around the part. Steps of a span that have no last one show nothing yet.
typedef struct gjk_arm_proof {
  gjk_q30 from, to;     // a dyadic span: its length is a power of 2, and from a multiple of it
  gjk_unit3 direction;  // as above
  uint32_t pair;        // its number
  uint32_t piece;       // of a body: the number of its part; else, and of the last step, GJK_PARTS_NONE
} gjk_arm_proof;

// The functions for bodies, opaque.
typedef struct gjk_arm_body_class gjk_arm_body_class;

// Takes a proof: of one pair in the order of time, without gaps.
typedef void gjk_arm_proof_function(void *user, const gjk_arm_proof *proof);

// An arm in RAM. gjk_arm_init fills it; its contents are the library's.
typedef struct gjk_arm {
  const gjk_arm_model *model;       // the caller's
  const gjk_collider *obstacles;    // the caller's
  const gjk_parts *bodies;          // the caller's
  const gjk_arm_body_class *type;   // what asks them; NULL: there are none
  const int32_t *from;              // the caller's
  const int32_t *to;                // the caller's
  gjk_arm_proof_function *proof;    // the caller's, or NULL
  void *user;                       // what it is given
  gjk_arm_memory memory;            // the caller's
  gjk_pose base;                    // where the machine stands
  gjk_arm_setup setup;              // of the edge
  int64_t gap;                      // the least proven so far
  uint32_t pair_count, self_count;  // pairs, and those of two parts, which come first
  uint32_t next;                    // the pair to be tested next
  uint32_t place;                   // the span's number at its depth
  uint32_t upper, touched;          // where a touch is known, in steps of the edge; whose
  uint32_t tests;                   // so far
  uint32_t touched_piece;           // of a body that is touched
  uint32_t node, item;              // how far a body's pieces are looked at
  gjk_q16 spare;                    // the gap that pieces beyond those have
  gjk_status fault;                 // of a body's piece that cannot be placed
  uint16_t obstacle_count;          // how many there are
  uint16_t body_count;              // how many there are
  uint16_t state;                   // tells an arm that was set up from other memory, and how far an edge is
  uint8_t value_count;              // joints that move
  uint8_t depth;                    // of the span
  uint8_t first;                    // which of a link's frames is the span's start
  bool open;                        // a pair of the span is open
  bool within;                      // a body's pieces are looked at
  bool outside;                     // a value is outside its limits
} gjk_arm;

// Sets up an arm without obstacles.
//
// base      the pose of the base in the world.
// Statuses  NULL; EMPTY (no link); RANGE: too many links or parts; a parent that is not a link with a lower number, so that
//           joints run in a circle; a kind that does not exist; a part on no link; ROTATION: of base, fixed or a pose, or
//           an axis of length 0; CAPACITY: more pairs than there is room for; and any of gjk_collider_init or
//           gjk_collider_pose, of a part. arm is written only after OK; the memory in any case.
gjk_status gjk_arm_init(gjk_arm *arm, const gjk_arm_model *model, const gjk_pose *base, const gjk_arm_memory *memory);

// Sets what the arm must not hit. An edge or check that runs is given up.
//
// obstacles  posed colliders; must stay as they are as long as the arm is asked. NULL where count is 0.
// Statuses   NULL, UNINITIALISED (an arm or an obstacle), CAPACITY (pairs). The arm's obstacles are then as they were.
gjk_status gjk_arm_obstacles(gjk_arm *arm, const gjk_collider *obstacles, uint16_t count);

// Sets the bodies of many parts that the arm must not hit, beside its obstacles. An edge or check that runs is given up.
//
// bodies    posed; they and their data must stay as they are as long as the arm is asked. NULL where count is 0.
// Cost      of a span or a configuration, for each part of the arm: a walk through the pieces whose boxes meet a box around
//           it. Each of them costs what an obstacle does. Programs without this call link none of it.
// Statuses  NULL, UNINITIALISED (the arm), CAPACITY (pairs), and EMPTY, ROTATION, RANGE as of gjk/parts.h. The arm's
//           bodies are then as they were. Calls that ask a body later have those statuses too, of data that were
//           never checked; what they write is then of no use.
gjk_status gjk_arm_bodies(gjk_arm *arm, const gjk_parts *bodies, uint16_t count);

// How many values a configuration of the model has; 0 for NULL.
unsigned gjk_arm_values(const gjk_arm_model *model);

// The poses of all links in the world. out: one for each link. Errors as of gjk_joints_from_angles.
// Statuses  NULL, UNINITIALISED, RANGE (see above, or a link that might leave int32). An edge that runs is given up.
gjk_status gjk_arm_poses(gjk_arm *arm, const int32_t *values, gjk_pose *out);

// Begins an edge.
//
// from, to  configurations, the caller's, which must stay as they are until the edge is settled.
// setup     copied.
// proof     called with each step of the certificate; NULL: none. user: what it is given.
// Statuses  NULL, UNINITIALISED, NEGATIVE (margin), RANGE (margin, tolerance, resolution, and see Range above).
gjk_status gjk_arm_edge_start(gjk_arm *arm, const int32_t *from, const int32_t *to, const gjk_arm_setup *setup,
                              gjk_arm_proof_function *proof, void *user);

// Goes on with the edge that was begun.
//
// tests  the most tests of this call, each of a pair on a span: of about the cost of gjk_within, which some ask once or
//        twice beside. Each piece of a body counts as a test; some ask what gjk_parts_within costs beside. Where an edge
//        is interrupted makes no difference to its answer or its proofs.
// out    what is proven by now. UNSETTLED: call it again to go on.
//
// OK               everything, as above.
// ITERATION_LIMIT  the same: UNSETTLED for good. On a span of 2^-GJK_ARM_DEPTH_MAX of the edge a pair is neither proven
//                  apart nor within margin and tolerance.
// NULL, UNINITIALISED (no edge was begun)  nothing.
gjk_status gjk_arm_edge_run(gjk_arm *arm, uint32_t tests, gjk_arm_edge_result *out);

// Spans are halved so often at most.
#define GJK_ARM_DEPTH_MAX 20

// Are the first edges of a path free?
//
// path    count configurations, one after the other.
// edges   how many are free before the first that is not, or that is not settled by so many tests.
// out     of that edge; of the last one if all are free.
// tests   the most tests of an edge.
// Statuses  as of gjk_arm_edge_start and gjk_arm_edge_run; EMPTY: less than two configurations. ITERATION_LIMIT comes
//           with edges and out.
gjk_status gjk_arm_path(gjk_arm *arm, const int32_t *path, unsigned count, const gjk_arm_setup *setup, uint32_t tests,
                        unsigned *edges, gjk_arm_edge_result *out);

// Is result an answer about the edge, which the proofs show?
//
// It needs no search: of each proof it takes the poses at both ends of the span, one support of each shape along the
// direction there, and the bound of the motion between. A touch is decided by one gjk_within at upper.
// Weaker   A claim that is weaker than what is proven is true, and passes: a smaller gap or lower, of a TOUCH any upper
//          where the pair is near. tests and outside are not looked at.
// proofs   count of them, as the callback got them.
//
// OK                                proven.
// UNPROVEN                          not proven.
// NULL, UNINITIALISED, RANGE, NEGATIVE  as of gjk_arm_edge_start. An edge that runs is given up.
gjk_status gjk_check_edge(gjk_arm *arm, const int32_t *from, const int32_t *to, const gjk_arm_setup *setup,
                          const gjk_arm_edge_result *result, const gjk_arm_proof *proofs, uint32_t count);

// What is nearest at a configuration.
typedef struct gjk_arm_distance_result {
  gjk_arm_names pair;            // the nearest; ties go to the first: parts, then obstacles, then bodies
  gjk_distance_result distance;  // from the other thing, A, to the part, B
  bool outside;                  // a value is outside its limits
} gjk_arm_distance_result;

// The least distance of all tested pairs, whose parts are posed at the links' poses, and of which pair.
//
// most      pairs farther apart need not be looked at, Q16.16, at least 0; GJK_DISTANCE_MAX: any.
// out       written after OK and ITERATION_LIMIT; not where there is no pair, or none within most (EMPTY).
// Exact     as gjk_distance, of colliders posed by gjk_pose_compose of the link's pose and the part's.
// Statuses  NULL, UNINITIALISED, NEGATIVE, RANGE (see Range above), EMPTY; ITERATION_LIMIT: of a curved pair, whose lower
//           counts. An edge that runs is given up.
gjk_status gjk_arm_distance(gjk_arm *arm, const int32_t *values, gjk_q16 most, gjk_arm_distance_result *out);

// Is any tested pair at most distance apart? *yes: whether one is; pair: the first such, may be NULL. Of a body it is the
// piece with the least number. Statuses as of
// gjk_arm_distance without EMPTY; ITERATION_LIMIT: no pair is found near, and a curved one is open: *yes is then true, and
// pair names it.
gjk_status gjk_arm_near(gjk_arm *arm, const int32_t *values, gjk_q16 distance, bool *yes, gjk_arm_names *pair);

// How the distance of a result of gjk_arm_distance changes with each joint: in LSB per LSB of the joint's value, Q16.16.
//
// values    the configuration, and nearest the result of gjk_arm_distance there, apart.
// out       one number for each value.
// Errors    against the derivative in real numbers along the reported normal at the reported points: of a prismatic
//           joint 2 LSB, of a revolute one 3 LSB and 2^-26 of the distance of the points from the joint's origin, in LSB.
//           Where the nearest points are not unique, it is a derivative of the distance of these points.
// Statuses  NULL, UNINITIALISED, RANGE (see Range above; a pair that is not there; shapes that intersect).
gjk_status gjk_arm_gradient(gjk_arm *arm, const int32_t *values, const gjk_arm_distance_result *nearest, gjk_q16 *out);

#ifdef __cplusplus
}
#endif

#endif
