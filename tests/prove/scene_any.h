// Any block of a scene: small capacities, and everything else as it may be.
#ifndef PROVE_SCENE_ANY_H
#define PROVE_SCENE_ANY_H

#include "colliders.h"
#include "scene.h"

#define BODIES 3
#define PARTS 3
#define PLACED 2
#define PAIRS 4
#define SHAPES 2

// As src/scene_memory.c lays it out.
typedef struct any_block {
  gjk_scene_header header;
  gjk_scene_body bodies[BODIES];
  gjk_scene_part parts[PARTS];
  gjk_scene_node nodes[PARTS];
  gjk_scene_placed placed[PLACED];
  gjk_scene_pair pairs[PAIRS];
  uint32_t queue[PAIRS];
  uint32_t slots[1];
} any_block;

static any_block block;
static gjk_shape shape;
static const gjk_shape *shapes[SHAPES];

static uint32_t any_uint32(void) {
  return Frama_C_unsigned_int_interval(0, UINT32_MAX);
}

static void any_shapes(void) {
  shape.type = any_bool() ? &polytope : &curved;
  shape.round = any_between(0, GJK_RADIUS_MAX);
  shape.count = any_uint16();
  for (int i = 0; i < SHAPES; i++) {
    shapes[i] = any_bool() ? &shape : NULL;
  }
}


#endif
