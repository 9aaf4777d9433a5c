// Many bodies, asked the same question every tick: which of them touch, or are nearer than a margin?
//
// A scene is one block of the caller's memory. The block holds indices instead of pointers, so a plain copy of it is a
// save, and works at any address. A gjk_scene is the handle of a block: a small struct with the pointers.
//
// A scene's answers depend on its contents alone, so they are the same on every platform. They do not depend on
// addresses, caches or capacities, nor on how the bodies got there. Bodies may be added to stated slots in any order.
// tests/check/unit/test_scene_*.c and test_history.c check each statement of this header.
//
// The report of a pair is a function of shapes, poses, margins and configuration. It is what the queries answer from a
// cold start, even where they reach a ceiling. Skips and caches never change it. One case needs no query. A pair with a
// curved or custom shape is apart if its exact boxes are farther apart along an axis than the margins.
//
// Lockstep peers need the same shapes, builds with the same GJK_ITERATIONS_MAX, and the same configuration. Only
// box_margin, retest_all, and capacities that do not run out may differ.
//
// Threads  calls for one scene must not overlap, except for several queries, or several gjk_scene_test_pairs.
// Cost     a call that changes one body: O(log bodies + its parts). An update: O(pairs of the bodies that moved).
// Statuses of every call: NULL for a pointer that is missing; CORRUPT for a handle whose block is not a scene's.
#ifndef GJK_SCENE_H
#define GJK_SCENE_H

#include "gjk/body.h"
#include "gjk/contacts.h"

#ifdef __cplusplus
extern "C" {
#endif

// The version of a block's format. gjk_scene_open and gjk_scene_attach refuse a block of another version.
#define GJK_SCENE_BLOCK_VERSION UINT32_C(6)

// One shape of a body.
typedef struct gjk_part {
  uint16_t shape;  // index into the table of shapes
  bool own_pose;   // false: the part is at the body's pose, which takes less memory
  gjk_pose pose;   // in the body's frame; read only if own_pose
} gjk_part;

// A body to be added.
typedef struct gjk_body_setup {
  gjk_pose pose;            // where it stands
  const gjk_part *parts;    // read only during the call
  uint16_t part_count;      // at least 1
  uint8_t kind;             // a gjk_body_kind; 0: static, never tested against another static body, even when moved
  uint8_t detail;           // a gjk_detail; a pair gets the largest of the configuration's and its two bodies'
  uint32_t category, mask;  // tested if each body's category shares a bit with the other's mask; both 0: RANGE
  uint32_t user;            // the caller's own word
  gjk_q16 margin;           // two parts are near when at most the sum of their margins apart; 0: touching
} gjk_body_setup;

// What a scene holds and does.
//
// pairs            must hold the pairs of parts that were near at the last update, and those whose boxes meet. These
//                  are the exact boxes, each enlarged by its body's margin. Room for all pairs that meet within
//                  box_margin saves work.
// workspace_cells  if a depth needs more, its report depends on their number: see gjk/penetration.h.
typedef struct gjk_scene_config {
  uint32_t bodies;     // capacity, from 1 to GJK_SCENE_BODIES_MAX
  uint32_t parts;      // capacity: parts of all bodies together, from 1 to GJK_SCENE_BODIES_MAX
  uint32_t own_poses;  // capacity: parts with a pose of their own, from 0 to GJK_SCENE_BODIES_MAX
  uint32_t pairs;      // capacity, from 1 to GJK_SCENE_PAIRS_MAX, see above
  gjk_q16 box_margin;  // enlarges the boxes in the tree, so that small moves do not change it; 0 to GJK_RADIUS_MAX
  uint8_t detail;      // a gjk_detail but SENSOR, the least for every pair; DEPTH, CONTACTS: set bindings.details too
  uint8_t persist;     // 1: pairs that stay near are reported in every update
  uint8_t retest_all;  // 1: every update tests every pair anew from a cold start. For tests: the answers are the same
  uint8_t pair_words;  // the caller's words for each pair, see gjk_report; 0 to GJK_SCENE_PAIR_WORDS_MAX
  uint32_t workspace_cells;  // cells of bindings.workspace for depths and contacts, see above; 0: none
  uint32_t motions;  // capacity: bodies whose motion is kept, see gjk_scene_set_motion; 0 to GJK_SCENE_BODIES_MAX
} gjk_scene_config;

// The code behind depths and contacts, one constant each: a program links only what it mentions.
typedef struct gjk_scene_details gjk_scene_details;
extern const gjk_scene_details gjk_scene_depth, gjk_scene_contacts;

// The code behind fast bodies.
typedef struct gjk_scene_motions gjk_scene_motions;
extern const gjk_scene_motions gjk_scene_motion;

// What a program binds to a scene besides its block and shapes. Each field is optional: zeroed, it binds nothing.
typedef struct gjk_scene_bindings {
  gjk_scene_predicate *predicate;    // NULL: every pair that category and mask let through is tested
  void *user;                        // the predicate's first argument
  const gjk_scene_details *details;  // &gjk_scene_depth; &gjk_scene_contacts: both; NULL: neither
  const gjk_workspace *workspace;    // at least config.workspace_cells cells, no more are used; NULL: none
  gjk_manifold *manifolds;           // room for a manifold per report of a call, see gjk_report; NULL: none are wanted
  const gjk_scene_motions *motion;   // &gjk_scene_motion; NULL: no motion is kept
  bool keeps_manifolds;  // true: the program keeps each pair's last manifold, so reports with still set have none
} gjk_scene_bindings;

// The handle of a scene. gjk_scene_init, gjk_scene_open and gjk_scene_attach write all of it when they return GJK_OK,
// and nothing of it otherwise. It may be copied: all copies are handles of the same scene. A copy may have other
// bindings: a thread that tests pairs uses a copy with a workspace of its own.
typedef struct gjk_scene {
  void *block;                     // the caller's memory
  const gjk_shape *const *shapes;  // the same shapes, in the same order, wherever a block goes
  uint16_t shape_count;            // of shapes
  gjk_scene_bindings bindings;     // what else the program binds to it
} gjk_scene;

// Bytes of a block for these numbers of bodies, parts and pairs, as a constant.
//
//     static uint32_t block[GJK_SCENE_BYTES(8, 8, 16) / 4];
//
// Exact if config.detail is CONTACTS; any other detail needs 24 bytes less for each pair.
#define GJK_SCENE_BYTES(bodies, parts, pairs)                                                 \
  (UINT32_C(296) + UINT32_C(60) * (bodies) + UINT32_C(4) * (((bodies) + UINT32_C(31)) / 32) + \
   UINT32_C(184) * (parts) + UINT32_C(72) * (pairs))

// Bytes to add for own poses, motions and words. There are config.pairs * config.pair_words words.
#define GJK_SCENE_MORE_BYTES(own_poses, motions, words) \
  (UINT32_C(32) * (own_poses) + UINT32_C(44) * (motions) + UINT32_C(4) * (words))

// Bytes of a block, at run time. 0: the configuration is outside its ranges, or size_t cannot hold the number.
size_t gjk_scene_bytes(const gjk_scene_config *config);

// Makes an empty scene.
//
// scene     written whole.
// block     the caller's, aligned for uint32_t, of gjk_scene_bytes or more. GJK_SCENE_BYTES sizes a static array.
// shapes    the caller's, must stay as it is while the scene is used; may hold NULLs that no body names.
// bindings  copied into the handle; may point to the handle's own; NULL: none.
// Statuses  RANGE (config, or a block that is not aligned), CAPACITY (bytes). UNSUPPORTED: config.detail asks for what
//           bindings.details lacks.
gjk_status gjk_scene_init(gjk_scene *scene, const gjk_scene_config *config, void *block, size_t bytes,
                          const gjk_shape *const *shapes, uint16_t shape_count, const gjk_scene_bindings *bindings);

// Bodies. A call that fails changes nothing. Statuses: BODY_ID for an id that is stale or was never given. BUSY: an
// update has begun, and its last report is not yet written.

// Adds a body to the lowest free slot.
//
// Statuses  CAPACITY: bodies, parts or own poses are used up. RANGE: a field is outside its range, or a part leaves
//           int32. Also RANGE: category and mask are both 0, as in a setup that was only zeroed. UNSUPPORTED: detail
//           asks for what bindings.details lacks. EMPTY: no parts. ROTATION. Also those of gjk_collider_init.
gjk_status gjk_scene_add(gjk_scene *scene, const gjk_body_setup *setup, gjk_body_id *out);

// Adds a body to a stated slot. The scene does not depend on the order of such calls. BODY_ID: the slot is taken or
// used up. CAPACITY: there is no such slot.
gjk_status gjk_scene_add_at(gjk_scene *scene, uint32_t slot, const gjk_body_setup *setup, gjk_body_id *out);

// Removes a body. The next update reports the end of its pairs that were near.
gjk_status gjk_scene_remove(gjk_scene *scene, gjk_body_id id);

// Moves a body to its next pose, and wakes it. A static body moves too, but is never tested against other static ones.
// Statuses as gjk_collider_pose.
gjk_status gjk_scene_move(gjk_scene *scene, gjk_body_id id, const gjk_pose *pose);

// As gjk_scene_move, for a body that will not go on moving the same way. Only boxes in the tree differ, never answers.
gjk_status gjk_scene_teleport(gjk_scene *scene, gjk_body_id id, const gjk_pose *pose);

// A sleeping body stands still. A pair persists in reports only while one of its bodies is awake and not static.
// gjk_scene_sleep: RANGE unless the body is dynamic.
gjk_status gjk_scene_sleep(gjk_scene *scene, gjk_body_id id);
gjk_status gjk_scene_wake(gjk_scene *scene, gjk_body_id id);

// Keeps a body's pose of the last update, so that fast bodies are swept against its motion. GJK_MOTION_FAST also sweeps
// the body itself.
//
// motion    a gjk_body_motion. The motion begins at the pose that the body has now. A teleport begins it anew.
// Way       from the pose at the last update to that at the next one. The position moves in a straight line, and the
//           rotation along the shortest arc. A body without kept motion stands where it is at the next update.
// Impact    For each fast body that moved, or is awake, the next update reports the part that it touches first. Ties go
//           to the lowest (slot, part) of b, then of a. Kinds, category, mask and the predicate count; margins do not.
// Start     Parts that touch at the start are no impact if they were near at the last update, or if neither body moves.
// fraction  If neither part turns, that of gjk_cast from where both were. Otherwise the lower fraction of
//           gjk_time_of_impact with GJK_IMPACT_TOLERANCE_MIN. A sphere or point at its body's origin does not turn.
// Open      A cast or time of impact may reach its ceiling. Or the way of one against the other may be 2^32 LSB or
//           longer. Then the impact is reported at a proven lower fraction.
// Statuses  RANGE (motion, a static body, or a sensor), CAPACITY (config.motions), UNSUPPORTED: bindings.motion is
//           NULL. gjk_scene_remove and gjk_scene_teleport of a body with kept motion need that binding, too.
gjk_status gjk_scene_set_motion(gjk_scene *scene, gjk_body_id id, uint8_t motion);

// The pose of a body with kept motion at the last update, or where a teleport has put it since. Its motion leads from
// there to its present pose; a platform carries what stands on it by that motion. Ask before the next update.
// UNSUPPORTED: no kept motion.
gjk_status gjk_scene_last_pose(const gjk_scene *scene, gjk_body_id id, gjk_pose *out);

// Gives a part of a body another shape. RANGE: no such part or shape; and the statuses of gjk_collider_init.
gjk_status gjk_scene_set_shape(gjk_scene *scene, gjk_body_id id, uint16_t part, uint16_t shape);

// Sets a body's category and mask. With both 0, which gjk_scene_add refuses, the body has no pairs.
gjk_status gjk_scene_set_filter(gjk_scene *scene, gjk_body_id id, uint32_t category, uint32_t mask);

// Sets a body's user word. A different word implies gjk_scene_refilter, because the predicate is given that word.
gjk_status gjk_scene_set_user(gjk_scene *scene, gjk_body_id id, uint32_t user);

// Makes the next update ask the predicate about all pairs of the body again.
gjk_status gjk_scene_refilter(gjk_scene *scene, gjk_body_id id);

// What a scene holds about a body.
typedef struct gjk_body_state {
  gjk_pose pose;                  // where it stands now
  uint32_t category, mask, user;  // as in gjk_body_setup
  gjk_q16 margin;                 // as in gjk_body_setup
  uint16_t part_count;            // number of its parts
  uint8_t kind, detail;           // a gjk_body_kind and a gjk_detail
  bool asleep;                    // see gjk_scene_sleep
  uint8_t motion;                 // a gjk_body_motion
} gjk_body_state;

// What a body is, and where it is.
gjk_status gjk_scene_get(const gjk_scene *scene, gjk_body_id id, gjk_body_state *out);

// The id of the body in a slot. Its generation is 0 when the slot is free. RANGE: no such slot.
gjk_status gjk_scene_body_at(const gjk_scene *scene, uint32_t slot, gjk_body_id *out);

// A part as a posed collider, for any query of the library. RANGE: no such part.
gjk_status gjk_scene_collider(const gjk_scene *scene, gjk_body_id id, uint16_t part, gjk_collider *out);

// Updates.

// One pair of parts. a has the lower slot; in an IMPACT it is the fast body.
//
// distance  set in BEGIN and PERSIST, by detail. DISTANCE: as gjk_distance; DEPTH: as gjk_signed_distance, negative for
//           a depth; CONTACTS with a manifold: the least of its contacts' distances. Otherwise 0.
// manifold  set in BEGIN and PERSIST with CONTACTS: up to 4 contacts. The i-th report of a call has
//           &bindings.manifolds[i]. Otherwise NULL.
// still     set in PERSIST: since the pair's last report no call has moved or changed one of its bodies. So distance
//           and manifold are, bit for bit, what they were then. A move to the present pose changes nothing; a move away
//           and back counts as a move. still is not hashed, because it changes no answer.
// Keeping   With bindings.keeps_manifolds, a report with still set has no manifold, and with CONTACTS its distance is
//           0. Set it once the program has a manifold of each near pair, and save these with the block.
// words     config.pair_words words in the block, for the caller to write, such as impulses to warm start a solver.
//           They are 0 at BEGIN, and stay as written until the pair's END has been reported. Saves and copies include
//           them, and gjk_scene_hash counts them. So peers must write the same words, and no addresses. A write breaks
//           a seal. The pointer is valid while the pair is near, and at END until the next update begins. NULL: none
//           configured, or an IMPACT.
typedef struct gjk_report {
  gjk_body_id a, b;         // the bodies
  uint32_t user_a, user_b;  // their user words; 0 of one that was removed
  uint16_t part_a, part_b;  // numbers of their parts
  uint8_t event;            // a gjk_event
  uint8_t detail;           // a gjk_detail: the pair's; the configuration's if a body was removed
  bool still;               // in PERSIST: nothing has changed since the last report, see above
  gjk_q16 distance;
  const gjk_manifold *manifold;
  uint32_t *words;
  gjk_q30 fraction;  // of IMPACT, see gjk_scene_set_motion; otherwise 0
} gjk_report;

// Finds which pairs are near, and what fast bodies touch first. Reports are in the order of (slot, generation, part) of
// a, then of b. Those of impacts follow all others, in the order of a.
//
// reports   room for capacity reports; NULL when that is 0. A buffer that fills up loses nothing: call again.
// Statuses  CAPACITY: config.pairs is too small, see there. The update has not begun; it begins once bodies are moved
//           or removed so that their pairs fit.
//           UNSUPPORTED: the configuration or a body asks for a detail that bindings.details lacks, or for depths while
//           bindings.workspace has fewer cells than config.workspace_cells. Or motions are kept and bindings.motion is
//           NULL. Nothing is done.
// Unsettled  A query of curved or custom shapes may reach its ceiling on iterations. Then the pair counts as
//           near, at the proven lower bound, and its manifold is zero. A workspace may be too small for a depth: then
//           the distance is minus a depth that is enough. gjk_scene_stats.unsettled counts both.
gjk_status gjk_scene_update(gjk_scene *scene, gjk_report *reports, uint32_t capacity, gjk_progress *progress);

// As gjk_scene_update, but this call tests at most tests pairs and fast bodies, for firmware with a deadline. The first
// slice matches all boxes.
gjk_status gjk_scene_update_slice(gjk_scene *scene, uint32_t tests, gjk_report *reports, uint32_t capacity,
                                  gjk_progress *progress);

// Takes a report, which is valid only during the call.
typedef void gjk_report_function(void *user, const gjk_report *report);

// As gjk_scene_update, with each report handed to a function, which must not change the scene. bindings.manifolds needs
// room for one.
gjk_status gjk_scene_update_each(gjk_scene *scene, gjk_report_function *function, void *user);

// Spreads an update over threads. gjk_scene_update_begin says how many pairs are to be tested. Then threads test
// disjoint ranges of them at the same time, without locks: each call writes only to its own pairs' records. Last, a
// gjk_scene_update tests what is left and reports. Where depths are asked for, each thread needs a copy of the handle
// with a workspace of its own. Statuses as gjk_scene_update. Beginning also: BUSY while reports are left. Testing also:
// RANGE if first > end, if end is beyond the pairs, or if no update has begun.
gjk_status gjk_scene_update_begin(gjk_scene *scene, uint32_t *pairs);
gjk_status gjk_scene_test_pairs(gjk_scene *scene, uint32_t first, uint32_t end);

// Spreads fast bodies over threads as well, once every pair is tested. count is the number of bodies whose motion is
// kept. Threads then sweep disjoint ranges of them at the same time. Statuses as gjk_scene_test_pairs.
gjk_status gjk_scene_sweep_count(const gjk_scene *scene, uint32_t *count);
gjk_status gjk_scene_sweep(gjk_scene *scene, uint32_t first, uint32_t end);

// Iterates over the pairs near at the last update, in unspecified order. Start with *cursor 0; *found is false at the
// end. The event is PERSIST, or END if a body has been removed since.
gjk_status gjk_scene_next_near(const gjk_scene *scene, uint32_t *cursor, gjk_report *out, bool *found);

// The manifold of a reported pair at its bodies' current poses, with the sum of their margins as its margin, from a
// cold start. It serves programs that need only some pairs, or share the work among threads. most, out and statuses as
// in gjk_contacts. Also BODY_ID; RANGE for a part that is not there; UNSUPPORTED for a workspace of fewer cells than
// config.workspace_cells.
gjk_status gjk_scene_manifold(const gjk_scene *scene, const gjk_report *report, unsigned most, gjk_manifold *out);

// What the last update did, and what the scene holds.
gjk_status gjk_scene_get_stats(const gjk_scene *scene, gjk_scene_stats *out);

// Queries. They see the current poses, even between updates.

// Finds the parts whose exact boxes share a point with box, in the order of (slot, part).
//
// after   NULL, or the last hit of the call before, to find only what follows it. So a buffer of any size will do.
// hits    room for capacity hits, NULL when that is 0.
// count   how many were found. hits holds the first of them, as many as fit.
// Statuses  RANGE: lower > upper along an axis.
gjk_status gjk_scene_query_box(const gjk_scene *scene, const gjk_aabb *box, const gjk_scene_hit *after,
                               gjk_scene_hit *hits, uint32_t capacity, uint32_t *count);

// Finds the parts whose exact boxes the segment between two points meets, in the order of (fraction, slot, part).
// Meeting is decided exactly. after, hits and count as in gjk_scene_query_box.
gjk_status gjk_scene_query_ray(const gjk_scene *scene, const gjk_vec3 *from, const gjk_vec3 *to,
                               const gjk_scene_hit *after, gjk_scene_hit *hits, uint32_t capacity, uint32_t *count);

// Finds the part nearest to a posed collider, at most reach away by gjk_distance; ties go to the lowest (slot, part).
// If a query reaches its ceiling on iterations, the larger of two lower bounds counts as the distance: the query's and
// the boxes'.
//
// ignore  NULL, or a body to leave out, for example the one that asks.
// found   whether there is one. hit and distance are written only then.
// Statuses  NEGATIVE (reach), UNINITIALISED.
gjk_status gjk_scene_query_nearest(const gjk_scene *scene, const gjk_collider *collider, gjk_q16 reach,
                                   const gjk_body_id *ignore, gjk_scene_hit *hit, gjk_q16 *distance, bool *found);

// Lockstep and saving.

// A 64-bit hash of everything that affects later answers.
//
// Counted   the configuration except capacities, box_margin and retest_all; the build's GJK_ITERATIONS_MAX; bodies and
//           their kept motions; pairs near at the last update and their words; the number of updates.
// Left out  tree and caches: a copy whose caches are zeroed goes on with the same answers.
// Statuses  BUSY during an update.
gjk_status gjk_scene_hash(const gjk_scene *scene, uint64_t *out);

// Writes a checksum into the block, for blocks stored in a file or sent over a network. The next change breaks it.
gjk_status gjk_scene_seal(gjk_scene *scene);

// Opens a sealed block from any source. Checks its header, byte order and checksum, and everything that gjk_scene_check
// does. So no later call reads or writes outside the block.
//
// scene, bindings  as in gjk_scene_init.
// shapes           the same shapes as before; the caller promises that.
// Statuses         CORRUPT: damaged, or of another GJK_SCENE_BLOCK_VERSION, or of a build with other ceilings on
//                  iterations. Also CORRUPT: a part's box or pose shows that the shapes differ. CAPACITY (bytes).
//                  RANGE: not aligned, or a shape index that the table lacks.
gjk_status gjk_scene_open(gjk_scene *scene, void *block, size_t bytes, const gjk_shape *const *shapes,
                          uint16_t shape_count, const gjk_scene_bindings *bindings);

// Opens a copy of a block that this program made itself, sealed or not. Checks only the header. scene and bindings as
// in gjk_scene_init; statuses as gjk_scene_open.
gjk_status gjk_scene_attach(gjk_scene *scene, void *block, size_t bytes, const gjk_shape *const *shapes,
                            uint16_t shape_count, const gjk_scene_bindings *bindings);

// Checks every index and invariant in the block, and poses every part anew: OK or CORRUPT; RANGE for a shape index that
// the table lacks. Visits the whole block. Must not run beside queries, because it marks and restores records.
gjk_status gjk_scene_check(const gjk_scene *scene);

#ifdef __cplusplus
}
#endif

#endif
