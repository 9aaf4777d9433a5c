// Scenes with concave bodies for tests.
#include "scene/concave_world.h"

#include "check.h"
#include "reference/random_shape.h"

static gjk_q16 length_of(random_state *random, int32_t size) {
  return random_range(random, size / 8, size);
}

// A rounded box, a capsule, a ball or a box.
static gjk_shape any_convex(random_state *random, int32_t size) {
  const gjk_q16 x = length_of(random, size), y = length_of(random, size), z = length_of(random, size);
  switch (random_below(random, 4)) {
    case 0: return (gjk_shape)GJK_ROUNDED_BOX(x / 2, y / 2, z / 2, x / 4);
    case 1: return (gjk_shape)GJK_CAPSULE(x / 2, y);
    case 2: return (gjk_shape)GJK_SPHERE(x);
    default: return (gjk_shape)GJK_BOX(x, y, z);
  }
}

static void add_body(concave_world *w, unsigned i, gjk_parts parts, random_state *random, int32_t size) {
  concave_body *b = &w->body[i];
  b->parts = parts;
  CHECK(gjk_concave_init(&parts, &b->concave, &b->shape) == GJK_OK);
  b->parts.pose.position = random_vector(random, 3.0 * size * random_unit(random));
  b->parts.pose.rotation = random_rotation(random);
}

void concave_world_make(concave_world *w, random_state *random, int32_t size) {
  static const surface_kind kinds[] = {SURFACE_FLAT, SURFACE_BENT, SURFACE_ROUGH,
                                       SURFACE_CUBE, SURFACE_BALL, SURFACE_SOUP};
  surface_make(random, kinds[random_below(random, 6)], 1 + random_below(random, 300), size,
               random_below(random, 2) != 0, &w->mesh);
  add_body(w, 0, (gjk_parts)GJK_PARTS_OF_MESH(&w->mesh.mesh), random, size);
  const uint16_t columns = (uint16_t)random_range(random, 2, CONCAVE_SIDE),
                 rows = (uint16_t)random_range(random, 2, CONCAVE_SIDE);
  for (unsigned k = 0; k < (unsigned)columns * rows; k++) {
    const bool hole = k > 4 && random_below(random, 12) == 0;
    w->heights[k] = hole ? GJK_HEIGHT_HOLE : (int16_t)random_range(random, -1000, 1000);
  }
  const gjk_height_field field = GJK_HEIGHT_FIELD(w->heights, columns, rows, size, size, 1 + size / 2000);
  w->field = field;
  if (gjk_height_field_check(&field) != GJK_OK) {
    for (unsigned k = 0; k < 4; k++) {
      w->heights[k % 2 + k / 2 * columns] = 0;
    }
  }
  add_body(w, 1, (gjk_parts)GJK_PARTS_OF_HEIGHT_FIELD(&w->field), random, size);
  const unsigned parts = 1 + random_below(random, 16);
  for (unsigned i = 0; i < parts; i++) {
    w->compound_shapes[i] = any_convex(random, size);
    w->compound_parts[i].shape = &w->compound_shapes[i];
    w->compound_parts[i].pose.position = random_vector(random, 3.0 * size);
    w->compound_parts[i].pose.rotation = random_rotation(random);
  }
  CHECK(gjk_compound_build(w->compound_parts, (uint16_t)parts, w->compound_nodes, GJK_COMPOUND_NODES(16),
                           &w->compound) == GJK_OK);
  add_body(w, 2, (gjk_parts)GJK_PARTS_OF_COMPOUND(&w->compound), random, size);
  for (unsigned i = 0; i < CONCAVE_MOVERS; i++) {
    w->mover[i] = any_convex(random, size);
  }
}

void concave_world_free(concave_world *w) {
  surface_free(&w->mesh);
}
