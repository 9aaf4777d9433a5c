// A world of random bodies that is kept twice: in a scene, and as a plain list. What the scene reports is compared with
// what a test of all pairs of the list says.
//
// The list poses its own colliders with the public calls, and has no tree, pair records or caches.
#ifndef WORLD_H
#define WORLD_H

#include "gjk/cast.h"
#include "gjk/gjk.h"
#include "gjk/impact.h"
#include "gjk/scene.h"
#include "random.h"

#define WORLD_BODIES 40
#define WORLD_PARTS 3
#define WORLD_SHAPES 12
#define WORLD_REPORTS 8192
#define WORLD_CELLS 2000  // enough for any two of the shapes

typedef struct world_body {
  gjk_body_id id;  // its id; generation 0: there is no such body
  gjk_body_setup setup;
  gjk_part parts[WORLD_PARTS];
  gjk_collider colliders[WORLD_PARTS];
  bool asleep;
  uint8_t motion;  // a gjk_body_motion
  gjk_pose last;   // of a kept motion
  bool changed;    // moved or changed since the last update
} world_body;

// stamp  of a report that is expected: which writing its words are of, see world_write_words; 0: they are 0. A report that
//        is expected has no words itself.
// words  how many each pair has
typedef struct world_list {
  gjk_report report[WORLD_REPORTS];
  uint32_t stamp[WORLD_REPORTS];
  uint32_t count;
  uint8_t words;
} world_list;

typedef struct world_options {
  uint32_t bodies;  // at most WORLD_BODIES
  int32_t reach;    // half the side of the cube that they are in
  gjk_q16 box_margin;
  uint8_t
      detail;  // of the configuration; bodies ask for more, for depth and contacts only if detail is DEPTH or CONTACTS
  uint8_t persist, retest_all;
  bool predicate, margins;
  bool edges;     // positions are near the corners of int32_t, so that some parts leave it
  bool motions;   // bodies become fast
  uint8_t words;  // of the configuration
  bool sensors;   // some bodies are
} world_options;

typedef struct world {
  world_options options;
  gjk_scene scene;
  world_body bodies[WORLD_BODIES];
  world_list near;    // the pairs near at the last update, with GJK_EVENT_PERSIST; still: what was reported last holds
  gjk_body_id stale;  // the id of a removed body
  uint32_t adds, removes, moves, failures;
  uint32_t still;  // reports that were expected to be
  uint32_t stamp;  // of the last writing
  uint32_t impacts, turning_impacts,
      starts;  // expected; of parts that turn; that touch from the start, and are left out
} world;

// What was expected of fast bodies so far, in all worlds.
typedef struct world_tally {
  unsigned long impacts;
  unsigned long turning;  // of parts that turn
  unsigned long starts;   // parts that touch from the start, and are left out
} world_tally;

extern world_tally world_expected;

extern const gjk_shape *const world_shapes[WORLD_SHAPES];

// Where reports of all worlds point for their manifolds.
extern gjk_manifold world_manifolds[WORLD_REPORTS];

// How many cells of the workspace depths may use: WORLD_CELLS, or GJK_TEST_CELLS from the environment.
uint32_t world_cells(void);

// May queries stay unsettled, since a ceiling is lower than usual or the cells are few?
bool world_is_tight(void);

// The configuration of the scene for options.
gjk_scene_config world_config(const world_options *options);

// Starts an empty world in a block of gjk_scene_bytes(world_config(options)) bytes. False: the scene could not be made.
bool world_start(world *w, const world_options *options, void *block, size_t bytes);

// What is bound to the scene of a world with these options: depth and contacts, and perhaps world_predicate.
gjk_scene_bindings world_bindings(const world_options *options);

// Makes one random change in scene and list. False: the scene's status is not the expected one.
bool world_change(world *w, random_state *random);

// Sets the setup and parts of body at random.
void world_random_setup(const world *w, random_state *random, world_body *body);

// Adds a body as body->setup says to a slot of scene and list. Returns the scene's status.
gjk_status world_add_at(world *w, uint32_t slot, const world_body *body);

// Finds the reports that the next update must give, by a test of all pairs, and sets near to what the update leaves.
void world_expect(world *w, world_list *out);

// Sorts a list into the order in which a scene reports.
void world_sort(world_list *list);

// Does the scene report what is expected, field by field, and each pair's words?
bool world_same(const world_list *expected, const world_list *actual);

// Writes other words to some of the pairs that are near, through gjk_scene_next_near. False: a pair is not expected, or
// its words are not what was written last.
bool world_write_words(world *w, random_state *random);

// The predicate that the scene gets with options.predicate: should this pair be tested?
bool world_predicate(void *user, gjk_body_id a, uint32_t user_a, gjk_body_id b, uint32_t user_b);

#endif
