// A world of random bodies that is kept twice: in a scene, and as a plain list that is searched pair by pair.
//
// The list poses its own colliders from the public calls and knows no boxes, trees, pairs or caches.
#ifndef WORLD_H
#define WORLD_H

#include "gjk/gjk.h"
#include "gjk/scene.h"
#include "random.h"

#define WORLD_BODIES 40
#define WORLD_PARTS 3
#define WORLD_SHAPES 12
#define WORLD_REPORTS 8192
#define WORLD_CELLS 2000  // enough for any two of the shapes

typedef struct world_body {
  gjk_body_id handle;  // generation 0: not there
  gjk_body_setup setup;
  gjk_part parts[WORLD_PARTS];
  gjk_collider colliders[WORLD_PARTS];
  bool asleep;
} world_body;

typedef struct world_list {
  gjk_report report[WORLD_REPORTS];
  uint32_t count;
} world_list;

typedef struct world_options {
  uint32_t bodies;  // at most WORLD_BODIES
  int32_t reach;    // half the side of the cube that they are in
  gjk_q16 box_margin;
  uint8_t detail;  // of the configuration; bodies ask for more, from DEPTH on for depth and contacts, too
  uint8_t persist, retest_all;
  bool predicate, margins;
  bool edges;  // positions are around the corners of int32, so that some parts leave it
} world_options;

typedef struct world {
  world_options options;
  gjk_scene scene;
  world_body bodies[WORLD_BODIES];
  world_list near;    // pairs near at the last update, with GJK_EVENT_PERSIST
  gjk_body_id stale;  // a handle of a body that was removed
  uint32_t adds, removes, moves, failures;
} world;

extern const gjk_shape *const world_shapes[WORLD_SHAPES];

// Where the manifolds of all worlds' reports are.
extern gjk_manifold world_manifolds[WORLD_REPORTS];

// Cells of the workspace that a world's configuration lets depths use: WORLD_CELLS, or as many as GJK_TEST_CELLS says.
uint32_t world_cells(void);

// May a query of a world be left unsettled, by a ceiling on iterations lower than usual or by the cells?
bool world_is_tight(void);

// The configuration for these options.
gjk_scene_config world_config(const world_options *options);

// An empty world in a block of gjk_scene_bytes(world_config(options)). Returns whether the scene could be made.
bool world_start(world *w, const world_options *options, void *block, size_t bytes);

// What is bound to the scene of a world with these options: depth and contacts, and perhaps world_predicate.
gjk_scene_bindings world_bindings(const world_options *options);

// One random change to both. Returns false when the scene's status is not the expected one.
bool world_change(world *w, random_state *random);

// A random body's setup; parts are stored in body.
void world_random_setup(const world *w, random_state *random, world_body *body);

// Adds what body->setup says to both, to a slot. Returns the scene's status.
gjk_status world_add_at(world *w, uint32_t slot, const world_body *body);

// The reports that an update must give now, by testing all pairs; afterwards near is what it is after the update.
void world_expect(world *w, world_list *out);

// Sorts into the order of reports.
void world_sort(world_list *list);

bool world_same(const world_list *a, const world_list *b);

// Tests pairs for the scene: the predicate of options.predicate.
bool world_predicate(void *user, gjk_body_id a, uint32_t user_a, gjk_body_id b, uint32_t user_b);

#endif
