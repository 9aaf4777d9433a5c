// Ground of any data that is as long as it says, and any walk over it: CASE names the kind. A chain has up to 4 vertices and an
// index of any content, a profile up to 4 heights, a grid up to 2 by 2 cells of 2 forms.
#include "plane_any.h"
#include "src/ground/gjk2_ground_walk.h"

#define CHAIN 1
#define HEIGHTS 2
#define TILES 3

#define VERTICES 4
#define BOXES 8  // one of each level
#define COLUMNS 4
#define CELLS 2

// Grids are placed as they are: what turns a walk has nothing of them.
#if CASE == TILES
#define TURN \
  { GJK_Q30_ONE, 0 }
#else
#define TURN any_rotation()
#endif

static gjk2_vec vertices[VERTICES];
static gjk2_index_box boxes[BOXES];
static int16_t heights[COLUMNS];
static uint8_t cells[CELLS * CELLS];
static gjk2_tile forms[2];

#if CASE == CHAIN
static gjk_status any_chain(gjk2_polyline *chain, gjk2_index *index, gjk2_ground *out, gjk2_shape *shape) {
  for (int i = 0; i < VERTICES; i++) {
    vertices[i] = any_position2();
  }
  for (int i = 0; i < BOXES; i++) {
    const gjk2_index_box box = {any_uint16(), any_uint16(), any_uint16(), any_uint16()};
    boxes[i] = box;
  }
  chain->vertices = any_bool() ? vertices : NULL;
  chain->count = (uint16_t)any_between(0, VERTICES);
  index->boxes = any_bool() ? boxes : NULL;
  index->count = any_uint16();
  index->segments = any_uint16();
  index->shift = (uint8_t)any_between(0, UINT8_MAX);
  index->corner = any_position2();
  chain->index = any_bool() ? index : NULL;
  (void)gjk2_index_build(chain, any_bool() ? boxes : NULL, (uint16_t)any_between(0, BOXES), any_bool() ? index : NULL);
  return gjk2_ground_of_chain(any_bool() ? chain : NULL, any_bool() ? out : NULL, any_bool() ? shape : NULL);
}
#elif CASE == HEIGHTS
static gjk_status any_heights(gjk2_heights *profile, gjk2_ground *out, gjk2_shape *shape) {
  for (int i = 0; i < COLUMNS; i++) {
    heights[i] = (int16_t)any_between(INT16_MIN, INT16_MAX);
  }
  profile->heights = any_bool() ? heights : NULL;
  profile->count = (uint16_t)any_between(0, COLUMNS);
  profile->width = any_int32();
  profile->shift = (uint8_t)any_between(0, UINT8_MAX);
  return gjk2_ground_of_heights(any_bool() ? profile : NULL, any_bool() ? out : NULL, any_bool() ? shape : NULL);
}
#else
static gjk_status any_tiles(gjk2_tiles *grid, gjk2_ground *out, gjk2_shape *shape) {
  for (int i = 0; i < CELLS * CELLS; i++) {
    cells[i] = (uint8_t)any_between(0, UINT8_MAX);
  }
  for (int i = 0; i < 2; i++) {
    const gjk2_tile form = {(uint8_t)any_between(0, UINT8_MAX), (uint8_t)any_between(0, UINT8_MAX),
                            (uint8_t)any_between(0, UINT8_MAX), any_bool()};
    forms[i] = form;
  }
  grid->cells = any_bool() ? cells : NULL;
  grid->columns = (uint16_t)any_between(0, CELLS);
  grid->rows = (uint16_t)any_between(0, CELLS);
  grid->size = any_int32();
  grid->form_count = (uint8_t)any_between(0, 2);
  grid->forms = any_bool() ? forms : NULL;
  return gjk2_ground_of_tiles(any_bool() ? grid : NULL, any_bool() ? out : NULL, any_bool() ? shape : NULL);
}
#endif

// Any walk, whatever the calls above have said of the data.
static void walk_over(const gjk2_ground_class *type, const void *data) {
  const gjk2_ground ground = {type, data, any_position2()};
  const gjk2_pose pose = {any_position2(), TURN};
  const gjk2_aabb box = {any_position2(), any_position2()};
  gjk2_ground_walk walk;
  gjk2_line line;
  gjk2_ground_edge edge;
  if (gjk2_ground_place(&ground, &pose, &walk) != GJK_OK) {
    return;
  }
  gjk2_ground_begin(&walk, &box);
  while (gjk2_ground_next(&walk, &line, &edge)) {
    gjk2_ground_set_neighbours(&walk, &line, &edge);
  }
}

int main(void) {
  gjk2_ground ground;
  gjk2_shape shape;
#if CASE == CHAIN
  gjk2_polyline chain;
  gjk2_index index;
  (void)any_chain(&chain, &index, &ground, &shape);
  walk_over(&gjk2_ground_chain, &chain);
#elif CASE == HEIGHTS
  gjk2_heights profile;
  (void)any_heights(&profile, &ground, &shape);
  walk_over(&gjk2_ground_heights, &profile);
#else
  gjk2_tiles grid;
  (void)any_tiles(&grid, &ground, &shape);
  walk_over(&gjk2_ground_tiles, &grid);
#endif
  return 0;
}
