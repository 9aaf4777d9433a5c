// An arm of seven joints with hulls of 30 to 60 points, among crates, balls and hulls: the project's own.
#ifndef SEVEN_H
#define SEVEN_H

#include "gjk/arm.h"

#include "random.h"

#define SEVEN_JOINTS 7
#define SEVEN_LINKS 8
#define SEVEN_PARTS 10
#define SEVEN_OBSTACLES 20
#define SEVEN_POINTS 48  // of a part
#define SEVEN_PAIRS GJK_ARM_PAIRS(SEVEN_PARTS, SEVEN_OBSTACLES)

typedef struct seven {
  gjk_arm_model model;
  gjk_arm_link links[SEVEN_LINKS];
  gjk_arm_part parts[SEVEN_PARTS];
  uint32_t never[SEVEN_LINKS];
  gjk_shape shapes[SEVEN_PARTS];
  gjk_vec3 points[SEVEN_PARTS][SEVEN_POINTS];
  gjk_shape obstacle_shapes[SEVEN_OBSTACLES];
  gjk_vec3 obstacle_points[SEVEN_OBSTACLES][16];
  gjk_vec3 obstacle_posed[SEVEN_OBSTACLES][16];
  gjk_collider obstacles[SEVEN_OBSTACLES];
  gjk_arm_link_room link_room[SEVEN_LINKS];
  gjk_arm_part_room part_room[SEVEN_PARTS];
  gjk_arm_pair pairs[SEVEN_PAIRS];
  gjk_arm_memory memory;
  gjk_arm arm;
} seven;

// Makes the arm at base, the same each time. False: a call failed.
bool seven_make(seven *s, const gjk_pose *base);

// Puts obstacles around the base: any from 1 to SEVEN_OBSTACLES. False: a call failed.
bool seven_surround(seven *s, random_state *random, unsigned count);

// Any configuration within the limits; and one that is so far from it, in LSB of the angles' Euclidean length.
void seven_any(random_state *random, int32_t values[SEVEN_JOINTS]);
void seven_beside(random_state *random, const int32_t from[SEVEN_JOINTS], int32_t far, int32_t to[SEVEN_JOINTS]);

// A hash of the answers to some edges, their certificates, distances and gradients: the same on every machine.
#define SEVEN_HASH UINT64_C(0x798F37E6D4E8047F)
bool seven_hash(seven *s, uint64_t *hash);

#endif
