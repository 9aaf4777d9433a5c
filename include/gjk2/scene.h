// Many bodies of the plane, asked the same question every tick: which of them touch, or are nearer than a margin?
//
// A scene is one block of the caller's memory. The block holds indices instead of pointers, so a plain copy of it is a
// save, and works at any address. A gjk2_scene is the handle of a block: a small struct with the pointers.
//
// Everything is as in gjk/scene.h, for shapes of gjk2/shape.h, without a workspace. One source serves both, so a
// statement of that header holds here too. gjk/body.h has ids, kinds, details, events, statistics and hits of both.
//
// A scene's answers depend on its contents alone, so they are the same on every platform. They do not depend on
// addresses, caches or capacities, nor on how the bodies got there. Bodies may be added to stated slots in any order.
// tests/check/unit/test_plane_scene_*.c check each statement of this header.
//
// The report of a pair is a function of shapes, poses, margins and configuration. It is what the queries answer from a
// cold start, even where they reach a ceiling. Skips and caches never change it. One case needs no query. A pair with
// an ellipse or custom shape is apart if its exact boxes are farther apart along an axis than the margins.
//
// Lockstep peers need the same shapes, builds with the same GJK_ITERATIONS_MAX, and the same configuration. Only
// box_margin, retest_all, and capacities that do not run out may differ.
//
// Threads  calls for one scene must not overlap, except for several queries, or several gjk2_scene_test_pairs.
// Cost     a call that changes one body: O(log bodies + its parts). An update: O(pairs of the bodies that moved).
// RAM      a block takes 292 bytes, and these for each unit of capacity (in brackets: in space):
//            body       44.125 (60.125)
//            part      116     (184), its node in the tree included
//            own pose   20     (32)
//            motion     32     (44)
//            pair       32     (48)    and 4 for each of config.pair_words, and 14 (24) where config.detail is CONTACTS
//          A body of one part with its share of the tree takes 160 bytes (244).
// Statuses of every call: NULL for a pointer that is missing; CORRUPT for a handle whose block is not a scene's.
#ifndef GJK2_SCENE_H
#define GJK2_SCENE_H

#include "gjk/body.h"
#include "gjk2/contacts.h"

#ifdef __cplusplus
extern "C" {
#endif

// The version of a block's format. gjk2_scene_open and gjk2_scene_attach refuse a block of another version.
#define GJK2_SCENE_BLOCK_VERSION UINT32_C(4)

// One shape of a body.
typedef struct gjk2_part {
  uint16_t shape;  // index into the table of shapes
  bool own_pose;   // false: the part is at the body's pose, which takes less memory
  gjk2_pose pose;  // in the body's frame; read only if own_pose
} gjk2_part;

// A body to be added.
typedef struct gjk2_body_setup {
  gjk2_pose pose;           // where it stands
  const gjk2_part *parts;   // read only during the call
  uint16_t part_count;      // at least 1
  uint8_t kind;             // a gjk_body_kind; 0: static, never tested against another static body, even when moved
  uint8_t detail;           // a gjk_detail; a pair gets the largest of the configuration's and its two bodies'
  uint32_t category, mask;  // tested if each body's category shares a bit with the other's mask; both 0: RANGE
  uint32_t user;            // the caller's own word
  gjk_q16 margin;           // two parts are near when at most the sum of their margins apart; 0: touching
} gjk2_body_setup;

// What a scene holds and does.
//
// pairs  must hold the pairs of parts that were near at the last update, and those whose boxes meet. These are the
//        exact boxes, each enlarged by its body's margin. Room for all pairs that meet within box_margin saves work.
typedef struct gjk2_scene_config {
  uint32_t bodies;     // capacity, from 1 to GJK_SCENE_BODIES_MAX
  uint32_t parts;      // capacity: parts of all bodies together, from 1 to GJK_SCENE_BODIES_MAX
  uint32_t own_poses;  // capacity: parts with a pose of their own, from 0 to GJK_SCENE_BODIES_MAX
  uint32_t pairs;      // capacity, from 1 to GJK_SCENE_PAIRS_MAX, see above
  gjk_q16 box_margin;  // enlarges the boxes in the tree, so that small moves do not change it; 0 to GJK2_RADIUS_MAX
  uint8_t detail;      // a gjk_detail but SENSOR, the least for every pair; DEPTH, CONTACTS: set bindings.details too
  uint8_t persist;     // 1: pairs that stay near are reported in every update
  uint8_t retest_all;  // 1: every update tests every pair anew from a cold start. For tests: the answers are the same
  uint8_t pair_words;  // the caller's words for each pair, see gjk2_report; 0 to GJK_SCENE_PAIR_WORDS_MAX
  uint32_t motions;    // capacity: bodies whose motion is kept, see gjk2_scene_set_motion; 0 to GJK_SCENE_BODIES_MAX
} gjk2_scene_config;

// The code behind depths and contacts, one constant each: a program links only what it mentions.
typedef struct gjk2_scene_details gjk2_scene_details;
extern const gjk2_scene_details gjk2_scene_depth, gjk2_scene_contacts;

// The code behind fast bodies.
typedef struct gjk2_scene_motions gjk2_scene_motions;
extern const gjk2_scene_motions gjk2_scene_motion;

// What a program binds to a scene besides its block and shapes. Each field is optional: zeroed, it binds nothing.
typedef struct gjk2_scene_bindings {
  gjk_scene_predicate *predicate;     // NULL: every pair that category and mask let through is tested
  void *user;                         // the predicate's first argument
  const gjk2_scene_details *details;  // &gjk2_scene_depth; &gjk2_scene_contacts: both; NULL: neither
  gjk2_manifold *manifolds;          // room for a manifold per report of a call, see gjk2_report; NULL: none are wanted
  const gjk2_scene_motions *motion;  // &gjk2_scene_motion; NULL: no motion is kept
  bool keeps_manifolds;  // true: the program keeps each pair's last manifold, so reports with still set have none
} gjk2_scene_bindings;

// The handle of a scene. gjk2_scene_init, gjk2_scene_open and gjk2_scene_attach write all of it when they return
// GJK_OK, and nothing of it otherwise. It may be copied: all copies are handles of the same scene. A copy may have
// other bindings.
typedef struct gjk2_scene {
  void *block;                      // the caller's memory
  const gjk2_shape *const *shapes;  // the same shapes, in the same order, wherever a block goes
  uint16_t shape_count;             // of shapes
  gjk2_scene_bindings bindings;     // what else the program binds to it
} gjk2_scene;

// Bytes of a block for these numbers of bodies, parts and pairs, as a constant.
//
//     static uint32_t block[GJK2_SCENE_BYTES(8, 8, 16) / 4];
//
// Exact if config.detail is CONTACTS; any other detail needs 14 bytes less for each pair.
#define GJK2_SCENE_BYTES(bodies, parts, pairs)                                                \
  (UINT32_C(292) + UINT32_C(44) * (bodies) + UINT32_C(4) * (((bodies) + UINT32_C(31)) / 32) + \
   UINT32_C(116) * (parts) + UINT32_C(32) * (pairs) + (UINT32_C(14) * (pairs) + UINT32_C(3)) / 4 * 4)

// Bytes to add for own poses, motions and words. There are config.pairs * config.pair_words words.
#define GJK2_SCENE_MORE_BYTES(own_poses, motions, words) \
  (UINT32_C(20) * (own_poses) + UINT32_C(32) * (motions) + UINT32_C(4) * (words))

// Bytes of a block, at run time. 0: the configuration is outside its ranges, or size_t cannot hold the number.
size_t gjk2_scene_bytes(const gjk2_scene_config *config);

// Makes an empty scene.
//
// scene     written whole.
// block     the caller's, aligned for uint32_t, of gjk2_scene_bytes or more. GJK2_SCENE_BYTES sizes a static array.
// shapes    the caller's, must stay as it is while the scene is used; may hold NULLs that no body names.
// bindings  copied into the handle; may point to the handle's own; NULL: none.
// Statuses  RANGE (config, or a block that is not aligned), CAPACITY (bytes). UNSUPPORTED: config.detail asks for what
//           bindings.details lacks.
gjk_status gjk2_scene_init(gjk2_scene *scene, const gjk2_scene_config *config, void *block, size_t bytes,
                           const gjk2_shape *const *shapes, uint16_t shape_count, const gjk2_scene_bindings *bindings);

// Bodies. A call that fails changes nothing. Statuses: BODY_ID for an id that is stale or was never given. BUSY: an
// update has begun, and its last report is not yet written.

// Adds a body to the lowest free slot.
//
// Statuses  CAPACITY: bodies, parts or own poses are used up. RANGE: a field is outside its range, or a part leaves
//           int32. Also RANGE: category and mask are both 0, as in a setup that was only zeroed. UNSUPPORTED: detail
//           asks for what bindings.details lacks. EMPTY: no parts. ROTATION. Also those of gjk2_collider_init.
gjk_status gjk2_scene_add(gjk2_scene *scene, const gjk2_body_setup *setup, gjk_body_id *out);

// Adds a body to a stated slot. The scene does not depend on the order of such calls. BODY_ID: the slot is taken or
// used up. CAPACITY: there is no such slot.
gjk_status gjk2_scene_add_at(gjk2_scene *scene, uint32_t slot, const gjk2_body_setup *setup, gjk_body_id *out);

// Removes a body. The next update reports the end of its pairs that were near.
gjk_status gjk2_scene_remove(gjk2_scene *scene, gjk_body_id id);

// Moves a body to its next pose, and wakes it. A static body moves too, but is never tested against other static ones.
// Statuses as gjk2_collider_pose.
gjk_status gjk2_scene_move(gjk2_scene *scene, gjk_body_id id, const gjk2_pose *pose);

// As gjk2_scene_move, for a body that will not go on moving the same way. Only boxes in the tree differ, never answers.
gjk_status gjk2_scene_teleport(gjk2_scene *scene, gjk_body_id id, const gjk2_pose *pose);

// A sleeping body stands still. A pair persists in reports only while one of its bodies is awake and not static.
// gjk2_scene_sleep: RANGE unless the body is dynamic.
gjk_status gjk2_scene_sleep(gjk2_scene *scene, gjk_body_id id);
gjk_status gjk2_scene_wake(gjk2_scene *scene, gjk_body_id id);

// Keeps a body's pose of the last update, so that fast bodies are swept against its motion. GJK_MOTION_FAST also sweeps
// the body itself.
//
// motion    a gjk_body_motion. The motion begins at the pose that the body has now. A teleport begins it anew.
// Way       from the pose at the last update to that at the next one. The position moves in a straight line, and the
//           rotation along the shortest arc. A body without kept motion stands where it is at the next update.
// Impact    For each fast body that moved, or is awake, the next update reports the part that it touches first. Ties go
//           to the lowest (slot, part) of b, then of a. Kinds, category, mask and the predicate count; margins do not.
// Start     Parts that touch at the start are no impact if they were near at the last update, or if neither body moves.
// fraction  If neither part turns, that of gjk2_cast from where both were. Otherwise the lower fraction of
//           gjk2_time_of_impact with GJK2_IMPACT_TOLERANCE_MIN. A circle or point at its body's origin does not turn.
// Open      A cast or time of impact may reach its ceiling. Or the way of one against the other may be 2^32 LSB or
//           longer. Then the impact is reported at a proven lower fraction.
// Statuses  RANGE (motion, a static body, or a sensor), CAPACITY (config.motions), UNSUPPORTED: bindings.motion is
//           NULL. gjk2_scene_remove and gjk2_scene_teleport of a body with kept motion need that binding, too.
gjk_status gjk2_scene_set_motion(gjk2_scene *scene, gjk_body_id id, uint8_t motion);

// The pose of a body with kept motion at the last update, or where a teleport has put it since. Its motion leads from
// there to its present pose; a platform carries what stands on it by that motion. Ask before the next update.
// UNSUPPORTED: no kept motion.
gjk_status gjk2_scene_last_pose(const gjk2_scene *scene, gjk_body_id id, gjk2_pose *out);

// Gives a part of a body another shape. RANGE: no such part or shape; and the statuses of gjk2_collider_init.
gjk_status gjk2_scene_set_shape(gjk2_scene *scene, gjk_body_id id, uint16_t part, uint16_t shape);

// Sets a body's category and mask. With both 0, which gjk2_scene_add refuses, the body has no pairs.
gjk_status gjk2_scene_set_filter(gjk2_scene *scene, gjk_body_id id, uint32_t category, uint32_t mask);

// Sets a body's user word. A different word implies gjk2_scene_refilter, because the predicate is given that word.
gjk_status gjk2_scene_set_user(gjk2_scene *scene, gjk_body_id id, uint32_t user);

// Makes the next update ask the predicate about all pairs of the body again.
gjk_status gjk2_scene_refilter(gjk2_scene *scene, gjk_body_id id);

// What a scene holds about a body.
typedef struct gjk2_body_state {
  gjk2_pose pose;                 // where it stands now
  uint32_t category, mask, user;  // as in gjk2_body_setup
  gjk_q16 margin;                 // as in gjk2_body_setup
  uint16_t part_count;            // number of its parts
  uint8_t kind, detail;           // a gjk_body_kind and a gjk_detail
  bool asleep;                    // see gjk2_scene_sleep
  uint8_t motion;                 // a gjk_body_motion
} gjk2_body_state;

// What a body is, and where it is.
gjk_status gjk2_scene_get(const gjk2_scene *scene, gjk_body_id id, gjk2_body_state *out);

// The id of the body in a slot. Its generation is 0 when the slot is free. RANGE: no such slot.
gjk_status gjk2_scene_body_at(const gjk2_scene *scene, uint32_t slot, gjk_body_id *out);

// A part as a posed collider, for any query of the library. RANGE: no such part.
gjk_status gjk2_scene_collider(const gjk2_scene *scene, gjk_body_id id, uint16_t part, gjk2_collider *out);

// Updates.

// One pair of parts. a has the lower slot; in an IMPACT it is the fast body.
//
// distance  set in BEGIN and PERSIST, by detail. DISTANCE: as gjk2_distance; DEPTH: as gjk2_signed_distance, negative
//           for a depth; CONTACTS with a manifold: the least of its contacts' distances. Otherwise 0.
// manifold  set in BEGIN and PERSIST with CONTACTS: up to 2 contacts. The i-th report of a call has
//           &bindings.manifolds[i]. Otherwise NULL.
// still     set in PERSIST: since the pair's last report no call has moved or changed one of its bodies. So distance
//           and manifold are, bit for bit, what they were then. A move to the present pose changes nothing; a move away
//           and back counts as a move. still is not hashed, because it changes no answer.
// Keeping   With bindings.keeps_manifolds, a report with still set has no manifold, and with CONTACTS its distance is
//           0. Set it once the program has a manifold of each near pair, and save these with the block.
// words     config.pair_words words in the block, for the caller to write, such as impulses to warm start a solver.
//           They are 0 at BEGIN, and stay as written until the pair's END has been reported. Saves and copies include
//           them, and gjk2_scene_hash counts them. So peers must write the same words, and no addresses. A write breaks
//           a seal. The pointer is valid while the pair is near, and at END until the next update begins. NULL: none
//           configured, or an IMPACT.
typedef struct gjk2_report {
  gjk_body_id a, b;         // the bodies
  uint32_t user_a, user_b;  // their user words; 0 of one that was removed
  uint16_t part_a, part_b;  // numbers of their parts
  uint8_t event;            // a gjk_event
  uint8_t detail;           // a gjk_detail: the pair's; the configuration's if a body was removed
  bool still;               // in PERSIST: nothing has changed since the last report, see above
  gjk_q16 distance;
  const gjk2_manifold *manifold;
  uint32_t *words;
  gjk_q30 fraction;  // of IMPACT, see gjk2_scene_set_motion; otherwise 0
} gjk2_report;

// Finds which pairs are near, and what fast bodies touch first. Reports are in the order of (slot, generation, part) of
// a, then of b. Those of impacts follow all others, in the order of a.
//
// reports   room for capacity reports; NULL when that is 0. A buffer that fills up loses nothing: call again.
// Statuses  CAPACITY: config.pairs is too small, see there. The update has not begun; it begins once bodies are moved
//           or removed so that their pairs fit.
//           UNSUPPORTED: the configuration or a body asks for a detail that bindings.details lacks. Or
//           motions are kept and bindings.motion is NULL. Nothing is done.
// Unsettled  A query of ellipses or custom shapes may reach its ceiling on iterations. Then the pair counts
//           as near, at the proven lower bound, and its manifold is zero. So may the depth of such a pair: then the
//           distance is minus a depth that is enough. gjk_scene_stats.unsettled counts both.
gjk_status gjk2_scene_update(gjk2_scene *scene, gjk2_report *reports, uint32_t capacity, gjk_progress *progress);

// As gjk2_scene_update, but this call tests at most tests pairs and fast bodies, for firmware with a deadline. The
// first slice matches all boxes.
gjk_status gjk2_scene_update_slice(gjk2_scene *scene, uint32_t tests, gjk2_report *reports, uint32_t capacity,
                                   gjk_progress *progress);

// Takes a report, which is valid only during the call.
typedef void gjk2_report_function(void *user, const gjk2_report *report);

// As gjk2_scene_update, with each report handed to a function, which must not change the scene. bindings.manifolds
// needs room for one.
gjk_status gjk2_scene_update_each(gjk2_scene *scene, gjk2_report_function *function, void *user);

// Spreads an update over threads. gjk2_scene_update_begin says how many pairs are to be tested. Then threads test
// disjoint ranges of them at the same time, without locks: each call writes only to its own pairs' records. Last, a
// gjk2_scene_update tests what is left and reports. Statuses as gjk2_scene_update. Beginning also: BUSY while reports
// are left. Testing also: RANGE if first > end, if end is beyond the pairs, or if no update has begun.
gjk_status gjk2_scene_update_begin(gjk2_scene *scene, uint32_t *pairs);
gjk_status gjk2_scene_test_pairs(gjk2_scene *scene, uint32_t first, uint32_t end);

// Spreads fast bodies over threads as well, once every pair is tested. count is the number of bodies whose motion is
// kept. Threads then sweep disjoint ranges of them at the same time. Statuses as gjk2_scene_test_pairs.
gjk_status gjk2_scene_sweep_count(const gjk2_scene *scene, uint32_t *count);
gjk_status gjk2_scene_sweep(gjk2_scene *scene, uint32_t first, uint32_t end);

// Iterates over the pairs near at the last update, in unspecified order. Start with *cursor 0; *found is false at the
// end. The event is PERSIST, or END if a body has been removed since.
gjk_status gjk2_scene_next_near(const gjk2_scene *scene, uint32_t *cursor, gjk2_report *out, bool *found);

// The manifold of a reported pair at its bodies' current poses, with the sum of their margins as its margin, from a
// cold start. It serves programs that need only some pairs, or share the work among threads. most, out and statuses as
// in gjk2_contacts. Also BODY_ID, and RANGE for a part that is not there.
gjk_status gjk2_scene_manifold(const gjk2_scene *scene, const gjk2_report *report, unsigned most, gjk2_manifold *out);

// What the last update did, and what the scene holds.
gjk_status gjk2_scene_get_stats(const gjk2_scene *scene, gjk_scene_stats *out);

// Queries. They see the current poses, even between updates.

// Finds the parts whose exact boxes share a point with box, in the order of (slot, part).
//
// after   NULL, or the last hit of the call before, to find only what follows it. So a buffer of any size will do.
// hits    room for capacity hits, NULL when that is 0.
// count   how many were found. hits holds the first of them, as many as fit.
// Statuses  RANGE: lower > upper along an axis.
gjk_status gjk2_scene_query_box(const gjk2_scene *scene, const gjk2_aabb *box, const gjk_scene_hit *after,
                                gjk_scene_hit *hits, uint32_t capacity, uint32_t *count);

// Finds the parts whose exact boxes the segment between two points meets, in the order of (fraction, slot, part).
// Meeting is decided exactly. after, hits and count as in gjk2_scene_query_box.
gjk_status gjk2_scene_query_ray(const gjk2_scene *scene, const gjk2_vec *from, const gjk2_vec *to,
                                const gjk_scene_hit *after, gjk_scene_hit *hits, uint32_t capacity, uint32_t *count);

// Finds the part nearest to a posed collider, at most reach away by gjk2_distance; ties go to the lowest (slot, part).
// If a query reaches its ceiling on iterations, the larger of two lower bounds counts as the distance: the query's and
// the boxes'.
//
// ignore  NULL, or a body to leave out, for example the one that asks.
// found   whether there is one. hit and distance are written only then.
// Statuses  NEGATIVE (reach), UNINITIALISED.
gjk_status gjk2_scene_query_nearest(const gjk2_scene *scene, const gjk2_collider *collider, gjk_q16 reach,
                                    const gjk_body_id *ignore, gjk_scene_hit *hit, gjk_q16 *distance, bool *found);

// Lockstep and saving.

// A 64-bit hash of everything that affects later answers.
//
// Counted   the configuration except capacities, box_margin and retest_all; the build's GJK_ITERATIONS_MAX; bodies and
//           their kept motions; pairs near at the last update and their words; the number of updates.
// Left out  tree and caches: a copy whose caches are zeroed goes on with the same answers.
// Statuses  BUSY during an update.
gjk_status gjk2_scene_hash(const gjk2_scene *scene, uint64_t *out);

// Writes a checksum into the block, for blocks stored in a file or sent over a network. The next change breaks it.
gjk_status gjk2_scene_seal(gjk2_scene *scene);

// Opens a sealed block from any source. Checks its header, byte order and checksum, and everything that
// gjk2_scene_check does. So no later call reads or writes outside the block.
//
// scene, bindings  as in gjk2_scene_init.
// shapes           the same shapes as before; the caller promises that.
// Statuses         CORRUPT: damaged, or of another GJK2_SCENE_BLOCK_VERSION, or of a build with other ceilings on
//                  iterations. Also CORRUPT: a part's box or pose shows that the shapes differ. CAPACITY (bytes).
//                  RANGE: not aligned, or a shape index that the table lacks.
gjk_status gjk2_scene_open(gjk2_scene *scene, void *block, size_t bytes, const gjk2_shape *const *shapes,
                           uint16_t shape_count, const gjk2_scene_bindings *bindings);

// Opens a copy of a block that this program made itself, sealed or not. Checks only the header. scene and bindings as
// in gjk2_scene_init; statuses as gjk2_scene_open.
gjk_status gjk2_scene_attach(gjk2_scene *scene, void *block, size_t bytes, const gjk2_shape *const *shapes,
                             uint16_t shape_count, const gjk2_scene_bindings *bindings);

// Checks every index and invariant in the block, and poses every part anew: OK or CORRUPT; RANGE for a shape index that
// the table lacks. Visits the whole block. Must not run beside queries, because it marks and restores records.
gjk_status gjk2_scene_check(const gjk2_scene *scene);

#ifdef __cplusplus
}
#endif

#endif
