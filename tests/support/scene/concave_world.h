// Scenes with concave bodies for tests: a mesh, a height field and a compound.
#ifndef CONCAVE_WORLD_H
#define CONCAVE_WORLD_H

#include "generate/surface.h"
#include "gjk/gjk.h"
#include "gjk/probe.h"
#include "random.h"

#define CONCAVE_BODIES 3
#define CONCAVE_MOVERS 12
#define CONCAVE_SIDE 13

typedef struct concave_body {
  gjk_parts parts;  // at the body's pose
  gjk_concave concave;
  gjk_shape shape;
} concave_body;

typedef struct concave_world {
  surface mesh;
  gjk_height_field field;
  int16_t heights[CONCAVE_SIDE * CONCAVE_SIDE];
  gjk_compound compound;
  gjk_shape compound_shapes[16];
  gjk_compound_part compound_parts[16];
  gjk_compound_node compound_nodes[GJK_COMPOUND_NODES(16)];
  concave_body body[CONCAVE_BODIES];
  gjk_shape mover[CONCAVE_MOVERS];
} concave_world;

// Makes the bodies and movers, of size LSB each, about the origin. Every part without curves.
void concave_world_make(concave_world *w, random_state *random, int32_t size);
void concave_world_free(concave_world *w);

#endif
