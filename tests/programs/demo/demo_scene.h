// A scene as constant tables, with the answers of the host. `gjk-demo --c-source SCENE` writes it.
//
// For a device: compile the written file with firmware.c, and call demo_firmware from the program's start.
#ifndef DEMO_SCENE_H
#define DEMO_SCENE_H

#include "arm.h"
#include "gjk/collider.h"
#include "gjk/distance.h"

// Most vertices of a hull in the tables.
enum { DEMO_HULL_VERTICES_MAX = 64 };

typedef struct demo_pair {
  const char *id;
  gjk_shape a, b;
  gjk_pose pose_a, pose_b;
  gjk_q16 distance;
  gjk_vec3 point_a, point_b;  // zero when intersecting, as is normal
  gjk_unit3 normal;
  bool intersecting;
  uint8_t iterations;
} demo_pair;

extern const demo_pair demo_pairs[];
extern const unsigned demo_pair_count;

// The frames of the arm's joints.
extern const gjk_pose demo_arm[ARM_JOINTS];

// Answers every pair and compares the bits with the table. Prints a line per pair, with what instructions() counted
// during the distance query, a summary, and what the arm's frames take as a chain and composed one by one. Returns how many
// pairs and arms differ. Uses no C library.
int demo_firmware(void (*print)(const char *text), uint32_t (*instructions)(void));

#endif
