// Methods that keep many boxes, of which some change each tick, and find those that meet.
#ifndef BENCH_SCENE_METHOD_H
#define BENCH_SCENE_METHOD_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

// A body's box in units, for other libraries. Beyond 256 units a float is not exact; then it is rounded outwards.
typedef struct scene_box {
  uint32_t body;
  bool anew;   // another body takes the place
  bool fixed;  // static: its pairs with others of the kind do not count
  float lower[3], upper[3];
} scene_box;

struct traffic_body;

// The bodies that change in a tick, as boxes for other libraries and as bodies for gjk: body i is that of box i.
typedef struct scene_tick {
  const scene_box *boxes;
  const struct traffic_body *bodies;
  uint32_t count;
} scene_tick;

// Do the exact boxes of two bodies meet, and are not both static?
typedef bool scene_meet(const void *user, uint32_t a, uint32_t b);

typedef struct scene_method {
  const char *name;
  void *(*start)(const scene_tick *all);              // every body once; NULL: it failed
  bool (*tick)(void *world, const scene_tick *tick);  // what is timed
  // Counts the pairs that the method holds after a tick, and how many of them meet exactly. Ends the measurement. NULL:
  // it holds none.
  void (*count)(void *world, scene_meet *meet, const void *user, uint32_t *held, uint32_t *meeting);
  void (*stop)(void *world);
} scene_method;

// The library: its whole ticks, its broad phase, and posing alone. Other libraries are linked if their package is
// installed.
extern const scene_method scene_gjk_whole, scene_gjk_broad, scene_gjk_posing;
extern const scene_method scene_bullet, scene_fcl;

#ifdef __cplusplus
}
#endif

#endif
