// What other libraries say of an arm's edges. All lengths in units, world frame.
#ifndef SWEEP_H
#define SWEEP_H

#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

// A convex shape: the hull of points, or a ball around one.
typedef struct sweep_solid {
  const double (*points)[3];
  size_t count;
  double radius;
} sweep_solid;

typedef struct sweep_pose {
  double q[4], p[3];  // x, y, z, w
} sweep_pose;

// Parts that move, obstacles that stand, and which pairs of parts count.
typedef struct sweep_scene {
  const sweep_solid *parts, *obstacles;
  size_t part_count, obstacle_count, pair_count;
  const size_t (*pairs)[2];
} sweep_scene;

// A library: a scene as it keeps it; is a pair in touch where the parts are; does one touch while the parts go straight from
// one pose to another, as the library moves them?
typedef struct sweep_method {
  const char *name;
  void *(*prepare)(const sweep_scene *scene);
  bool (*touches)(void *prepared, const sweep_pose *at);
  bool (*sweeps)(void *prepared, const sweep_pose *from, const sweep_pose *to);
  void (*release)(void *prepared);
} sweep_method;

extern const sweep_method sweep_fcl, sweep_bullet;

#ifdef __cplusplus
}
#endif

#endif
