// Many bodies, asked the same question every tick: who touches whom, or is nearer than a margin?
//
// A scene is one block of the caller's memory with indices instead of pointers inside: a plain copy of the block is a
// save, at any address. Beside the block stands a gjk_scene, a small handle with the pointers. What a scene answers
// depends on its contents alone: not on addresses, caches, capacities, how bodies came to where they are, or the order in
// which they were added to stated slots; so it is the same on every platform. tests/check/unit/test_scene_*.c and
// test_history.c hold each statement of this header.
//
// Everything that is reported of a pair is a function of shapes, poses, margins and configuration, as the queries answer
// from a cold start: where no answer is found, too. Skips and caches never change it. Of a pair with a curved or custom
// shape, exact boxes that are farther apart than the margins along an axis are the answer, before any query. Lockstep peers
// need the same shapes, builds with the same GJK_ITERATIONS_MAX, and the same configuration but for box_margin, retest_all,
// and capacities that do not run out.
//
// Threads  calls for one scene may not overlap, but for gjk_scene_test_pairs and several queries at once.
// Cost     a call that changes one body: O(log bodies + its parts). An update: the pairs of the bodies that moved.
// Statuses of every call: NULL for a pointer that is missing; CORRUPT for a handle whose block is none.
#ifndef GJK_SCENE_H
#define GJK_SCENE_H

#include "gjk/contacts.h"

#ifdef __cplusplus
extern "C" {
#endif

// Ceilings on capacities.
#define GJK_SCENE_BODIES_MAX UINT32_C(1048576)
#define GJK_SCENE_PAIRS_MAX UINT32_C(4194304)

// A body by its slot and how often the slot was taken. Zeroed: no body. A handle of a removed body is never that of
// another: a slot that was taken 2^31 times is not taken again.
typedef struct gjk_body_id {
  uint32_t slot, generation;
} gjk_body_id;

typedef enum gjk_body_kind {
  GJK_BODY_STATIC = 0,  // scenery: never tested against other statics
  GJK_BODY_KINEMATIC,   // moved by its own plan
  GJK_BODY_DYNAMIC      // may fall asleep
} gjk_body_kind;

// What is wanted of a pair. Depth and contacts are there for a handle whose field details says so.
typedef enum gjk_detail {
  GJK_DETAIL_TOUCH = 0,  // near or not
  GJK_DETAIL_DISTANCE,   // and the distance
  GJK_DETAIL_DEPTH,      // and the depth
  GJK_DETAIL_CONTACTS    // and the manifold
} gjk_detail;

// One shape of a body.
typedef struct gjk_part {
  uint16_t shape;  // index into the table of shapes
  bool placed;     // false: at the body's own pose, which takes less memory
  gjk_pose pose;   // in the body's frame, if placed
} gjk_part;

// A body to be added.
typedef struct gjk_body_setup {
  gjk_pose pose;
  const gjk_part *parts;    // read during the call alone
  uint16_t part_count;      // at least 1
  uint8_t kind;             // a gjk_body_kind
  uint8_t detail;           // a gjk_detail; a pair takes the most that the scene or one of its bodies asks
  uint32_t category, mask;  // a pair is tested when each one's category has a bit of the other's mask
  uint32_t user;            // the caller's own word
  gjk_q16 margin;           // two parts are near when at most the sum of their margins apart; 0: touching
} gjk_body_setup;

typedef struct gjk_scene_config {
  uint32_t bodies;  // capacity, from 1 to GJK_SCENE_BODIES_MAX
  uint32_t parts;   // capacity, shapes of all bodies together; same ceiling
  uint32_t placed;  // capacity, parts with a pose of their own; same ceiling, may be 0
  uint32_t pairs;  // capacity, pairs of parts whose boxes meet, margins included, or that were near at the last update;
                   // from 1 to GJK_SCENE_PAIRS_MAX. Room for those that meet within box_margin saves work
  gjk_q16 box_margin;  // boxes in the tree are larger by this, so that small moves leave it alone; 0 to GJK_RADIUS_MAX
  uint8_t detail;      // a gjk_detail: the least for every pair
  uint8_t persist;     // 1: pairs that stay near are reported in every update
  uint8_t
      retest_all;    // 1: every pair is tested anew in every update, from a cold start; for tests. Answers are the same
  uint8_t reserved;  // 0
  uint32_t
      workspace_cells;  // of the handle's workspace, as many as depth and contacts use; 0: none is needed. Where they
                        // are too few, what is reported depends on their number: see gjk/penetration.h
} gjk_scene_config;

// Should this pair be tested? Called at most once per test, perhaps from several threads: it may depend on its arguments
// and on what does not change during an update. A pair whose last answer outlasts its motion is not asked about again
// unless a user word changes, or gjk_scene_refilter says so, which every other change of mind needs.
typedef bool gjk_scene_predicate(void *user, gjk_body_id a, uint32_t user_a, gjk_body_id b, uint32_t user_b);

// What depth and contacts need, one constant each, so that a program links them only if it mentions them.
typedef struct gjk_scene_details gjk_scene_details;
extern const gjk_scene_details gjk_scene_depth, gjk_scene_contacts;

// The handle. gjk_scene_init, gjk_scene_open and gjk_scene_attach set the first three fields, and the others to zero; these
// are the caller's.
typedef struct gjk_scene {
  void *block;
  const gjk_shape *const *shapes;  // the same shapes, in the same order, wherever a block goes
  uint16_t shape_count;
  gjk_scene_predicate *predicate;    // NULL: all pairs
  void *user;                        // of the predicate
  const gjk_scene_details *details;  // &gjk_scene_depth; &gjk_scene_contacts: both; NULL: neither
  const gjk_workspace *workspace;    // at least config.workspace_cells; no more are used; NULL: none
  gjk_manifold *manifolds;           // room for as many manifolds as reports, see gjk_report; NULL: none are wanted
} gjk_scene;

// Bytes of a block; 0 for a configuration outside its ranges, or more than size_t can say.
size_t gjk_scene_bytes(const gjk_scene_config *config);

// Makes an empty scene.
//
// scene   written whole but for predicate and user, which become NULL.
// block   the caller's, aligned for uint32_t, at least gjk_scene_bytes; may come from gjk_port_allocate.
// shapes  the caller's, must stay as it is; may hold NULLs that no body names.
// Statuses  RANGE (config, or a block that is not aligned), UNSUPPORTED (detail), CAPACITY (bytes).
gjk_status gjk_scene_init(gjk_scene *scene, const gjk_scene_config *config, void *block, size_t bytes,
                          const gjk_shape *const *shapes, uint16_t shape_count);

// Bodies. A call that fails changes nothing. Statuses: HANDLE for a handle that is stale or was never given; BUSY from
// the first slice of an update to its last report, when bodies must stay as they are.

// Adds a body to the lowest free slot. Statuses: CAPACITY (bodies, parts or placed parts are used up), RANGE (a field,
// or a part that leaves int32), EMPTY (no parts), ROTATION, UNSUPPORTED (detail), and those of gjk_collider_init.
gjk_status gjk_scene_add(gjk_scene *scene, const gjk_body_setup *setup, gjk_body_id *out);

// The same with the slot named, so that bodies may be added in any order: the scene is the same. HANDLE: taken.
gjk_status gjk_scene_add_at(gjk_scene *scene, uint32_t slot, const gjk_body_setup *setup, gjk_body_id *out);

// Pairs that were near are reported as ended by the next update.
gjk_status gjk_scene_remove(gjk_scene *scene, gjk_body_id handle);

// Takes a body to its next pose, and wakes it. Statuses as gjk_collider_pose.
gjk_status gjk_scene_move(gjk_scene *scene, gjk_body_id handle, const gjk_pose *pose);

// The same without an expectation that the motion goes on. Answers do not differ; boxes in the tree do.
gjk_status gjk_scene_teleport(gjk_scene *scene, gjk_body_id handle, const gjk_pose *pose);

// A sleeping body stands still. Pairs without an awake body are not reported as persisting. Sleep: RANGE unless dynamic.
gjk_status gjk_scene_sleep(gjk_scene *scene, gjk_body_id handle);
gjk_status gjk_scene_wake(gjk_scene *scene, gjk_body_id handle);

// Gives part number part another shape. RANGE: no such part or shape; and the statuses of gjk_collider_init.
gjk_status gjk_scene_set_shape(gjk_scene *scene, gjk_body_id handle, uint16_t part, uint16_t shape);
gjk_status gjk_scene_set_filter(gjk_scene *scene, gjk_body_id handle, uint32_t category, uint32_t mask);

// Gives the body another word; one that differs refilters, as the predicate is given it.
gjk_status gjk_scene_set_user(gjk_scene *scene, gjk_body_id handle, uint32_t user);

// Has the next update ask the predicate about the body's pairs again.
gjk_status gjk_scene_refilter(gjk_scene *scene, gjk_body_id handle);

// What a scene holds about a body.
typedef struct gjk_body_state {
  gjk_pose pose;
  uint32_t category, mask, user;
  gjk_q16 margin;
  uint16_t part_count;
  uint8_t kind, detail;
  bool asleep;
} gjk_body_state;

gjk_status gjk_scene_get(const gjk_scene *scene, gjk_body_id handle, gjk_body_state *out);

// The body in a slot, generation 0 when it is free. RANGE: no such slot.
gjk_status gjk_scene_body_at(const gjk_scene *scene, uint32_t slot, gjk_body_id *out);

// A part as a posed collider, for any query of the library. RANGE: no such part.
gjk_status gjk_scene_collider(const gjk_scene *scene, gjk_body_id handle, uint16_t part, gjk_collider *out);

// Updates.

typedef enum gjk_event {
  GJK_EVENT_BEGIN = 1,  // near now, not at the last update
  GJK_EVENT_PERSIST,    // near both times; with config.persist
  GJK_EVENT_END         // no longer near; removed bodies included, whose handles are stale
} gjk_event;

// One pair of parts. a has the lower slot.
typedef struct gjk_report {
  gjk_body_id a, b;
  uint16_t part_a, part_b;
  uint8_t event;   // a gjk_event
  uint8_t detail;  // what was asked of the pair
  gjk_q16
      distance;  // begin and persist; DISTANCE: as gjk_distance says; DEPTH: as gjk_signed_distance says, negative for a
                 // depth; CONTACTS: the least of the manifold's; otherwise 0
  const gjk_manifold
      *manifold;  // begin and persist, CONTACTS: the scene's manifolds hold it, that of the i-th report of
                  // a call at i, with up to 4 contacts, without a cache; otherwise NULL
} gjk_report;

// How far an update has come. Both zero: done.
typedef struct gjk_progress {
  uint32_t reports;       // written by this call
  uint32_t pairs_left;    // not yet tested
  uint32_t reports_left;  // not yet written
} gjk_progress;

// Finds which pairs are near now. Reports are in the order of (slot, generation, part) of a, then of b.
//
// reports   room for capacity reports; NULL when that is 0. A buffer that fills up loses nothing: call again.
// Statuses  CAPACITY: more pairs of parts than config.pairs have exact boxes that meet, each with its body's margin all round,
//           or were near at the last update. The update has not begun, and does once bodies are moved or removed so that
//           they fit. UNSUPPORTED: some body or the configuration asks for a detail that the
//           handle's details lack, or for depths and the handle's workspace has fewer cells than config.workspace_cells;
//           nothing is done.
// Unsettled  A query that reaches the ceiling on its iterations, which is of curved or custom shapes, counts the pair as near, at
//           the proven lower bound, and in unsettled; its manifold is zero. So does a depth whose workspace is too small,
//           with the depth that is enough.
gjk_status gjk_scene_update(gjk_scene *scene, gjk_report *reports, uint32_t capacity, gjk_progress *progress);

// The same with at most tests tests of pairs in this call, for firmware with a deadline. Boxes are matched by the first.
gjk_status gjk_scene_update_slice(gjk_scene *scene, uint32_t tests, gjk_report *reports, uint32_t capacity,
                                  gjk_progress *progress);

typedef void gjk_report_function(void *user, const gjk_report *report);

// The same with each report handed to a function, which may not change the scene; manifolds need room for one.
gjk_status gjk_scene_update_each(gjk_scene *scene, gjk_report_function *function, void *user);

// Spreads an update over threads: begin says how many pairs are to be tested; disjoint ranges of them are tested at the
// same time, without locks, each call writing to the records of its own pairs alone; a gjk_scene_update then tests what
// is left and reports. Threads that ask for depth each need a handle of their own, a copy with another workspace.
// RANGE: first > end, or end beyond the pairs; or no update has begun.
gjk_status gjk_scene_update_begin(gjk_scene *scene, uint32_t *pairs);
gjk_status gjk_scene_test_pairs(gjk_scene *scene, uint32_t first, uint32_t end);

// Goes through the pairs that were near at the last update, in no stated order: start with *cursor 0; found is false
// at the end. event is PERSIST, or END when a body was removed since.
gjk_status gjk_scene_next_near(const gjk_scene *scene, uint32_t *cursor, gjk_report *out, bool *found);

// The manifold of a reported pair at its bodies' poses of now, at most their margins apart, without a cache; for those who
// ask of some pairs alone, or share the work among threads. most and out as of gjk_contacts; statuses, too, and HANDLE,
// RANGE for a part that is not there, UNSUPPORTED for a workspace of fewer cells than config.workspace_cells.
gjk_status gjk_scene_manifold(const gjk_scene *scene, const gjk_report *report, unsigned most, gjk_manifold *out);

// What the last update whose tests are done did. Each of its pairs is counted in resting or in one of filtered to cold. These
// tell of work, not of answers: they depend on skips, on caches, and on how bodies came to where they are.
typedef struct gjk_scene_stats {
  uint32_t bodies, parts;  // there now
  uint32_t pairs;          // whose boxes met
  uint32_t refused;        // boxes came together, but both are static or the filter refuses: not made a pair
  uint32_t resting;        // neither side moved - asleep, static or still: the last answer stands
  uint32_t filtered;       // the predicate, or a changed filter
  uint32_t motion;         // what the last test left, apart or near, exceeds the motion since
  uint32_t boxes;          // exact boxes or, without curves, bounding spheres apart
  uint32_t direction;      // the last separating direction still separates: one support scan
  uint32_t warm, cold;     // queries, started from the cache or not
  uint32_t begun, persisting, ended;
  uint32_t unsettled;  // queries that reached their ceiling
  uint32_t updates;    // completed so far, modulo 2^32
} gjk_scene_stats;

gjk_status gjk_scene_get_stats(const gjk_scene *scene, gjk_scene_stats *out);

// Queries. They see the poses of now, also between updates.

// A part that a query found.
typedef struct gjk_scene_hit {
  gjk_body_id body;
  uint16_t part;
  uint32_t fraction;  // ray: where it enters the part's box, in 2^-30 of the way, rounded down; otherwise 0
} gjk_scene_hit;

// Parts whose exact boxes share a point with box, in the order of (slot, part).
//
// after   NULL, or the last hit of the call before: only what follows it is found. So any buffer will do.
// hits    room for capacity; *count is how many were found in all, of which the first are written.
// Statuses  RANGE: lower > upper somewhere.
gjk_status gjk_scene_query_box(const gjk_scene *scene, const gjk_aabb *box, const gjk_scene_hit *after,
                               gjk_scene_hit *hits, uint32_t capacity, uint32_t *count);

// Parts whose exact boxes the way from from to to meets, in the order of (fraction, slot, part); decided exactly. The
// rest as above.
gjk_status gjk_scene_query_ray(const gjk_scene *scene, const gjk_vec3 *from, const gjk_vec3 *to,
                               const gjk_scene_hit *after, gjk_scene_hit *hits, uint32_t capacity, uint32_t *count);

// The part nearest to a posed collider, at most reach away by gjk_distance; among equals the lowest (slot, part). A part
// whose query reaches the ceiling on iterations counts at the larger of the lower bounds that it and the boxes prove.
//
// ignore  NULL, or a body to leave out, for example the one that asks.
// found   whether there is one; hit and distance are set only then.
// Statuses  NEGATIVE (reach), UNINITIALISED.
gjk_status gjk_scene_query_nearest(const gjk_scene *scene, const gjk_collider *collider, gjk_q16 reach,
                                   const gjk_body_id *ignore, gjk_scene_hit *hit, gjk_q16 *distance, bool *found);

// Lockstep and saving.

// 64 bits over what decides all further answers: configuration but for capacities, box_margin and retest_all; the build's
// GJK_ITERATIONS_MAX; bodies, pairs near at the last update, updates. Not over tree and caches. BUSY during an update.
gjk_status gjk_scene_hash(const gjk_scene *scene, uint64_t *out);

// Enters a checksum into the block, which holds until a call that changes the scene. For saves that leave the program.
gjk_status gjk_scene_seal(gjk_scene *scene);

// Opens a sealed block that may come from anywhere: checks its header, byte order, checksum, and all that
// gjk_scene_check does, so that no call reads or writes outside of it afterwards. scene is written as by gjk_scene_init.
// Statuses: CORRUPT, also for a block of another version of the library or of a build with another GJK_ITERATIONS_MAX;
// CAPACITY (bytes); RANGE (not aligned, or a shape index beyond shape_count). That the shapes are the same is the caller's
// promise; CORRUPT where a part's box or pose tells that they are not.
gjk_status gjk_scene_open(gjk_scene *scene, void *block, size_t bytes, const gjk_shape *const *shapes,
                          uint16_t shape_count);

// Opens a copy of a block that this program made itself, sealed or not: only the header is looked at.
gjk_status gjk_scene_attach(gjk_scene *scene, void *block, size_t bytes, const gjk_shape *const *shapes,
                            uint16_t shape_count);

// Checks every index and invariant in the block, and poses every part anew: OK or CORRUPT; RANGE as above. Visits all of
// it, and may not overlap with queries.
gjk_status gjk_scene_check(const gjk_scene *scene);

#ifdef __cplusplus
}
#endif

#endif
