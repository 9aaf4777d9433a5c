// Scenes that move by rule, for measuring and for lockstep: the same on every target, no libc.
#ifndef TRAFFIC_H
#define TRAFFIC_H

#include "gjk/gjk.h"
#include "gjk/scene.h"
#include "random.h"

#define TRAFFIC_SHAPES 5

typedef enum traffic_kind {
  TRAFFIC_SPARSE,    // bodies 4 units apart on the average
  TRAFFIC_CROWDED,   // 1.5 units: each touches or nearly touches some others
  TRAFFIC_PILES,     // crates in columns of 8 on static plates
  TRAFFIC_STREAMING  // static scenery, which leaves behind and comes in ahead of a moving window
} traffic_kind;

typedef struct traffic_body {
  gjk_body_id handle;
  gjk_pose pose;
  gjk_vec3 step;  // per tick
  gjk_quat turn;
  uint8_t shape;
  bool moves;
} traffic_body;

typedef struct traffic {
  traffic_kind kind;
  uint32_t count, percent;  // bodies, and how many of a hundred move
  gjk_vec3 reach;           // half the room
  uint32_t oldest;          // streaming: the next to leave
  int32_t ahead;            // where the window is
  random_state random;
  traffic_body *bodies;  // the caller's, count of them
} traffic;

extern const gjk_shape *const traffic_shapes[TRAFFIC_SHAPES];

gjk_scene_config traffic_config(traffic_kind kind, uint32_t count);

// Fills an empty scene. Returns the first status that is not GJK_OK.
gjk_status traffic_start(traffic *t, gjk_scene *scene, traffic_kind kind, uint32_t count, uint32_t percent,
                         traffic_body *bodies);

// Adds a body of some traffic to a slot of a scene, and sets its handle.
gjk_status traffic_add(gjk_scene *scene, uint32_t slot, traffic_body *b);
bool traffic_is_static(const traffic_body *b);

// Where the bodies are next; touches no scene.
void traffic_plan(traffic *t);

// Takes the scene there. Returns the first status that is not GJK_OK.
gjk_status traffic_apply(traffic *t, gjk_scene *scene);

#endif
