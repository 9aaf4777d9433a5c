// Articulated machines in motion: robot arms, cranes, doors. Is a whole motion free of contact, even between samples?
//
// A machine is a tree of links that joints move. Each link carries parts, which are convex shapes. A configuration is
// an array of joint values, one for each joint that moves, in the order of the links. The value of a revolute joint is
// an angle (gjk_angle), that of a prismatic joint a length (Q16.16). An edge moves all joints from one configuration to
// another at steady rates.
//
//     static const gjk_arm_model model = {links, parts, NULL, 7, 8};  // constants, may be in flash
//     static gjk_arm_link_room links_room[7];
//     ...
//     gjk_arm_init(&arm, &model, &base, &memory);
//     gjk_arm_obstacles(&arm, crates, 12);
//     gjk_arm_edge_start(&arm, from, to, &setup, NULL, NULL);
//     gjk_arm_edge_run(&arm, 1000, &result);  // FREE, TOUCH, or UNSETTLED so far: call again to go on
//
// Tested   Pairs of parts of different links, and each part with each obstacle, if some joint moves one relative to the
//          other. Parts of links that share a joint are not tested, nor are the pairs of model->never.
// Bodies   An obstacle may be a body of many parts: a compound, a mesh or a height field. Its parts are called pieces
//          here. A surface has no inside: what is wholly behind it is free.
// Real     An answer holds for the motion in real numbers, rounding included: see the proof in src/arm/gjk_arm_bound.c.
// Curved   Cylinders, cones, ellipsoids and custom shapes are as accurate as gjk/intersect.h states.
// Range    From the base to a part, all offsets, extensions and the part's reach may add up to GJK_ARM_REACH_MAX
//          (RANGE). On an edge, the turns of all joints may add up to GJK_ARM_TURN_MAX (RANGE).
#ifndef GJK_ARM_H
#define GJK_ARM_H

#include "gjk/collider.h"
#include "gjk/distance.h"
#include "gjk/joint.h"
#include "gjk/parts.h"

#ifdef __cplusplus
extern "C" {
#endif

// The most links and the most parts of a machine. There may be up to 65535 obstacles, and as many bodies.
#define GJK_ARM_LINKS_MAX 32
#define GJK_ARM_PARTS_MAX 1024

// The limits of Range above: 2048 units, 128 radians.
#define GJK_ARM_REACH_MAX INT32_C(134217728)
#define GJK_ARM_TURN_MAX INT32_C(8388608)

// The parent of a link that stands on the base.
#define GJK_ARM_BASE 255

// How a joint moves its link relative to the parent.
typedef enum gjk_arm_kind {
  GJK_ARM_FIXED = 0,  // the link does not move; the joint has no value
  GJK_ARM_REVOLUTE,   // the link turns about the axis, by the right-hand rule
  GJK_ARM_PRISMATIC   // the link shifts along the axis
} gjk_arm_kind;

// A link, and the joint that it hangs on.
typedef struct gjk_arm_link {
  uint8_t parent;        // a link with a lower number; GJK_ARM_BASE: the base
  uint8_t kind;          // a gjk_arm_kind
  gjk_pose fixed;        // pose of the link's frame in its parent's frame, at value 0
  gjk_vec3 axis;         // in the link's frame, through its origin; of any length but 0. A fixed joint may have 0
  int32_t lower, upper;  // limits of the value. Values beyond them are allowed; results then have outside set
} gjk_arm_link;

// A shape on a link.
typedef struct gjk_arm_part {
  const gjk_shape *shape;  // must stay as long as the arm
  gjk_pose pose;           // of the shape in the link's frame; an exact identity is fastest and costs no accuracy
  uint8_t link;            // number of the link
} gjk_arm_part;

// A machine, constant.
typedef struct gjk_arm_model {
  const gjk_arm_link *links;  // parents before their children
  const gjk_arm_part *parts;  // in any order
  const uint32_t *never;      // one word a link: bit k of word i means that links i and k are never tested. NULL: none
  uint8_t link_count;         // 1 to GJK_ARM_LINKS_MAX
  uint16_t part_count;        // 0 to GJK_ARM_PARTS_MAX
} gjk_arm_model;

// A link's frame in the world; the library's.
typedef struct gjk_arm_frame {
  int64_t origin[3];  // Q30 of an LSB
  gjk_quat rotation;  // Q2.30
  gjk_vec3 rows[3];   // its matrix
  gjk_vec3 at;        // origin to the nearest LSB
} gjk_arm_frame;

// Room for a link in RAM; the library's.
typedef struct gjk_arm_link_room {
  gjk_joint joint;         // a prismatic joint has its axis in quarter
  uint32_t above;          // links from the base to this one, itself included, as a bit mask
  uint32_t change;         // how far the joint moves on the edge, LSB of its value
  uint32_t extent;         // largest value of a prismatic joint on the edge, LSB
  gjk_arm_frame frame[2];  // at both ends of a span
} gjk_arm_link_room;

// Room for a part in RAM; the library's.
typedef struct gjk_arm_part_room {
  gjk_collider collider;  // in the link's frame
  gjk_vec3 at[2];         // its centre in the world, at both ends of a span
  gjk_vec3 middle;        // middle of the chord between them
  int32_t half;           // no less than half of the chord, LSB
  int32_t reach;          // distance of the part's farthest point from the link's origin, LSB
  uint8_t slack;          // error of the part's support points, LSB
  bool scanned;           // the part's support points are the shape's own vertices
} gjk_arm_part_room;

// Room for a pair in RAM; the library's.
typedef struct gjk_arm_pair {
  uint64_t bend;         // bound of the second derivative on the edge, LSB
  int32_t slack;         // bound of all roundings, LSB
  gjk_unit3 direction;   // direction that last separated the pair
  uint32_t done;         // where the pair was last tested for a touch; in a check, up to where it is proven apart
  uint32_t piece;        // the piece of a body that was last found open
  uint16_t part, other;  // numbers of both
  uint8_t frame;         // the link of the other part; GJK_ARM_BASE: an obstacle; GJK_ARM_BASE - 1: a body
  uint8_t level;         // depth of the span on which the pair is proven apart
} gjk_arm_pair;

// The caller's memory, all of which must stay as long as the arm.
typedef struct gjk_arm_memory {
  gjk_arm_link_room *links;  // one for each link
  gjk_arm_part_room *parts;  // one for each part
  gjk_arm_pair *pairs;       // GJK_ARM_PAIRS(parts, obstacles and bodies) are enough for any machine; fewer may do
  uint32_t pair_capacity;    // length of pairs
} gjk_arm_memory;

// The most pairs that these numbers of parts and obstacles can have.
#define GJK_ARM_PAIRS(parts, obstacles) ((parts) * (obstacles) + (parts) * ((parts)-1) / 2)

// How exactly to decide an edge. Lengths Q16.16.
typedef struct gjk_arm_setup {
  gjk_q16 margin;      // the gap that must be kept: 0 to GJK_ARM_MARGIN_MAX
  gjk_q16 tolerance;   // a gap of up to margin + tolerance may count as a touch; at least GJK_ARM_TOLERANCE_MIN
  gjk_q30 resolution;  // wanted distance between lower and upper of a touch; GJK_Q30_ONE: any touch will do
} gjk_arm_setup;

// The largest margin is 1024 units, the least tolerance 48 LSB. That tolerance is enough for parts that move by up to
// 128 units on an edge and reach as far from the base. Beyond that, an edge that grazes may stay UNSETTLED.
#define GJK_ARM_MARGIN_MAX ((gjk_q16)67108864)
#define GJK_ARM_TOLERANCE_MIN ((gjk_q16)48)

// The largest gap that is reported: 2048 units.
#define GJK_ARM_GAP_MAX ((gjk_q16)134217728)

// Names of the two things in a pair. The first is a part of the machine.
typedef struct gjk_arm_names {
  uint16_t part;   // number of the part in the model
  uint16_t other;  // the number of another part, of an obstacle, or of a body
  bool obstacle;   // other is an obstacle or a body
  uint32_t piece;  // number of a body's part; else GJK_PARTS_NONE
} gjk_arm_names;

// What is known of an edge.
typedef enum gjk_arm_answer {
  GJK_ARM_UNSETTLED = 0,  // no pair comes within the margin before lower; the rest is open
  GJK_ARM_FREE,           // no pair does so on the whole edge
  GJK_ARM_TOUCH           // no pair does so before lower, and at upper a pair is within margin + tolerance
} gjk_arm_answer;

// Lengths Q16.16, fractions of the edge Q2.30.
typedef struct gjk_arm_edge_result {
  gjk_arm_answer answer;  // as above
  gjk_q30 lower;          // before this all pairs are proven farther apart than margin; FREE: GJK_Q30_ONE, included
  gjk_q30 upper;          // TOUCH: where the pair is within margin + tolerance; else GJK_Q30_ONE
  gjk_q16 gap;            // FREE: proven lower bound of all gaps, margin to GJK_ARM_GAP_MAX; may not be tight
  gjk_arm_names pair;     // TOUCH: the pair that is near at upper
  uint32_t tests;         // tests of a pair on a span so far
  bool outside;           // a value of from or to is outside its limits
} gjk_arm_edge_result;

// One step of a certificate: a pair is apart on the span between two fractions. The proof is one direction along which
// the pair is apart at both ends.
//
// The direction leads from the other thing to the part. It is in the frame of the other part's link, or for an obstacle
// in the world. For a body there is a step for each piece near the part, and a last step without a direction. All other
// pieces are outside a box around the part. Steps of a span without that last step prove nothing yet.
typedef struct gjk_arm_proof {
  gjk_q30 from, to;     // a dyadic span: its length is a power of 2, and from is a multiple of that length
  gjk_unit3 direction;  // as above
  uint32_t pair;        // number of the pair
  uint32_t piece;       // number of a body's part; GJK_PARTS_NONE in the last step, and where there is no body
} gjk_arm_proof;

// The functions for bodies, opaque.
typedef struct gjk_arm_body_class gjk_arm_body_class;

// Takes a proof. The proofs of one pair come in order of time, without gaps.
typedef void gjk_arm_proof_function(void *user, const gjk_arm_proof *proof);

// An arm in RAM. gjk_arm_init fills it; its contents are the library's.
typedef struct gjk_arm {
  const gjk_arm_model *model;       // the caller's
  const gjk_collider *obstacles;    // the caller's
  const gjk_parts *bodies;          // the caller's
  const gjk_arm_body_class *type;   // class that queries bodies; NULL: there are none
  const int32_t *from;              // the caller's
  const int32_t *to;                // the caller's
  gjk_arm_proof_function *proof;    // the caller's, or NULL
  void *user;                       // argument of proof
  gjk_arm_memory memory;            // the caller's
  gjk_pose base;                    // where the machine stands
  gjk_arm_setup setup;              // setup of the edge
  int64_t gap;                      // the least gap proven so far
  uint32_t pair_count, self_count;  // pairs, and pairs of two parts, which come first
  uint32_t next;                    // the pair to be tested next
  uint32_t place;                   // the span's number at its depth
  uint32_t upper, touched;          // the known touch in steps of the edge, and its pair
  uint32_t tests;                   // tests so far
  uint32_t touched_piece;           // the piece of a body that is touched
  uint32_t node, item;              // progress within the pieces of a body
  gjk_q16 spare;                    // gap of the pieces beyond those
  gjk_status fault;                 // status of a piece that cannot be placed
  uint16_t obstacle_count;          // length of obstacles
  uint16_t body_count;              // length of bodies
  uint16_t state;                   // tells an arm that was set up from other memory, and the state of its edge
  uint8_t value_count;              // joints that move
  uint8_t depth;                    // depth of the span
  uint8_t first;                    // which of a link's frames is the span's start
  bool open;                        // a pair of the span is open
  bool within;                      // the pieces of a body are being tested
  bool outside;                     // a value is outside its limits
} gjk_arm;

// Sets up an arm without obstacles.
//
// base      the pose of the base in the world.
// Statuses  NULL. EMPTY: no link. ROTATION: base, fixed or a part's pose, or an axis of length 0. CAPACITY: more pairs
//           than room. RANGE: too many links or parts, an unknown kind, or a part on no link. Also RANGE: a parent that
//           is not a link with a lower number. Also any status of gjk_collider_init or gjk_collider_pose for a part.
//           arm is written only after OK; the memory may be written in any case.
gjk_status gjk_arm_init(gjk_arm *arm, const gjk_arm_model *model, const gjk_pose *base, const gjk_arm_memory *memory);

// Sets the obstacles that the arm must not hit. A running edge or check is abandoned.
//
// obstacles  posed colliders; must stay as they are while the arm is queried. NULL where count is 0.
// Statuses   NULL, UNINITIALISED (the arm or an obstacle), CAPACITY (pairs). The arm's obstacles are then as they were.
gjk_status gjk_arm_obstacles(gjk_arm *arm, const gjk_collider *obstacles, uint16_t count);

// Sets the bodies of many parts that the arm must not hit, besides its obstacles. A running edge or check is abandoned.
//
// bodies    posed; they and their data must stay as they are while the arm is queried. NULL where count is 0.
// Cost      for each part of the arm, testing a span or configuration visits the pieces whose boxes meet a box around
//           it. Each costs as much as an obstacle. Programs without this call link none of it.
// Statuses  NULL, UNINITIALISED (the arm), CAPACITY (pairs), and EMPTY, ROTATION, RANGE as in gjk/parts.h. The arm's
//           bodies are then as they were. If data were never checked, later calls may return these statuses; their
//           outputs are then meaningless.
gjk_status gjk_arm_bodies(gjk_arm *arm, const gjk_parts *bodies, uint16_t count);

// The number of values in a configuration of the model; 0 for NULL.
unsigned gjk_arm_values(const gjk_arm_model *model);

// The poses of all links in the world. out has one pose for each link. Errors are as in gjk_joints_from_angles.
// Statuses  NULL, UNINITIALISED, RANGE (see above, or a link that might leave int32). A running edge is abandoned.
gjk_status gjk_arm_poses(gjk_arm *arm, const int32_t *values, gjk_pose *out);

// Begins an edge.
//
// from, to     configurations, the caller's; must stay as they are until the edge is settled.
// setup        is copied.
// proof, user  proof is called with user and each step of the certificate; NULL: no calls.
// Statuses     NULL, UNINITIALISED, NEGATIVE (margin), RANGE (margin, tolerance, resolution, and see Range above).
gjk_status gjk_arm_edge_start(gjk_arm *arm, const int32_t *from, const int32_t *to, const gjk_arm_setup *setup,
                              gjk_arm_proof_function *proof, void *user);

// Continues the edge that gjk_arm_edge_start began.
//
// tests  the most tests in this call. A test of a pair on a span costs about one gjk_within, and some also make one or
//        two such calls. Each piece of a body counts as a test; some also cost a gjk_parts_within. Where an edge is
//        interrupted affects neither its answer nor its proofs.
// out    what is proven so far. UNSETTLED: call again to continue.
//
// OK               everything, as above.
// ITERATION_LIMIT  the same, and UNSETTLED is final: on a span of 2^-GJK_ARM_DEPTH_MAX of the edge, some pair is
//                  neither proven apart nor within margin + tolerance.
// NULL, UNINITIALISED (no edge was begun)  nothing.
gjk_status gjk_arm_edge_run(gjk_arm *arm, uint32_t tests, gjk_arm_edge_result *out);

// The most times that a span is halved.
#define GJK_ARM_DEPTH_MAX 20

// How many edges at the beginning of a path are free?
//
// path      count configurations, one after the other.
// edges     the number of free edges before the first that is not free, or not settled within tests.
// out       the result of that edge, or of the last edge if all are free.
// tests     the most tests of an edge.
// Statuses  as in gjk_arm_edge_start and gjk_arm_edge_run; EMPTY: count is below 2. ITERATION_LIMIT sets edges and out.
gjk_status gjk_arm_path(gjk_arm *arm, const int32_t *path, unsigned count, const gjk_arm_setup *setup, uint32_t tests,
                        unsigned *edges, gjk_arm_edge_result *out);

// Do the proofs show that result is true of the edge?
//
// The check needs no search. Checking a proof takes the motion's bound on its span, the poses at both ends, and there a
// support point of each shape. Checking a touch takes one gjk_within at upper.
//
// Weaker   A claim weaker than what is proven passes. That is a smaller gap or lower, or in a TOUCH any upper where the
//          pair is near. tests and outside are not checked.
// proofs   count proofs, as the callback got them.
//
// OK                                proven.
// UNPROVEN                          not proven.
// NULL, UNINITIALISED, RANGE, NEGATIVE  as in gjk_arm_edge_start. A running edge is abandoned.
gjk_status gjk_check_edge(gjk_arm *arm, const int32_t *from, const int32_t *to, const gjk_arm_setup *setup,
                          const gjk_arm_edge_result *result, const gjk_arm_proof *proofs, uint32_t count);

// The nearest pair at a configuration.
typedef struct gjk_arm_distance_result {
  gjk_arm_names pair;            // the nearest pair; ties go to the first, with parts before obstacles before bodies
  gjk_distance_result distance;  // A is the other thing, B the part
  bool outside;                  // a value is outside its limits
} gjk_arm_distance_result;

// The least distance of all tested pairs at a configuration, and the pair that has it.
//
// most      pairs farther apart than this are skipped, Q16.16, at least 0; GJK_DISTANCE_MAX: none is.
// out       written after OK and ITERATION_LIMIT. EMPTY: there is no pair, or none within most.
// Exact     as in gjk_distance, for colliders posed by gjk_pose_compose of the link's pose and the part's pose.
// Statuses  NULL, UNINITIALISED, NEGATIVE, RANGE (see Range above), EMPTY. ITERATION_LIMIT: a curved pair reached it,
//           and counts by its lower. A running edge is abandoned.
gjk_status gjk_arm_distance(gjk_arm *arm, const int32_t *values, gjk_q16 most, gjk_arm_distance_result *out);

// Is any tested pair at most distance apart? *yes says so, and pair is the first such pair; pair may be NULL. In a body
// it names the piece with the lowest number.
//
// Statuses  as in gjk_arm_distance without EMPTY. ITERATION_LIMIT: no pair is found near, and a curved pair is open.
//           Then *yes is true and pair names the open pair.
gjk_status gjk_arm_near(gjk_arm *arm, const int32_t *values, gjk_q16 distance, bool *yes, gjk_arm_names *pair);

// The derivative of a gjk_arm_distance result with respect to each joint value, in LSB per LSB of that value, Q16.16.
//
// values    the configuration. nearest is the result of gjk_arm_distance there, with the shapes apart.
// out       one number for each value.
// Errors    against the derivative in real numbers along the reported normal at the reported points: 2 LSB for a
//           prismatic joint. For a revolute one, 3 LSB and 2^-26 of the points' distance from the joint's origin, in
//           LSB. Where the nearest points are not unique, the derivative is that of the reported points' distance.
// Statuses  NULL, UNINITIALISED, RANGE (see Range above; an unknown pair; shapes that intersect).
gjk_status gjk_arm_gradient(gjk_arm *arm, const int32_t *values, const gjk_arm_distance_result *nearest, gjk_q16 *out);

#ifdef __cplusplus
}
#endif

#endif
