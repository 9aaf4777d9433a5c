// Prisms.
#include "prism.h"

#include <math.h>

static int32_t scaled(int32_t size, double by) {
  return (int32_t)lround(size * by);
}

static void set_faces(unsigned n, case_shape *shape) {
  case_shape_set_faces(shape, n + 2);
  for (unsigned i = 0; i < n; i++) {
    shape->corners[i] = (uint16_t)(n - 1 - i);
    shape->corners[n + i] = (uint16_t)(n + i);
  }
  shape->ends[0] = (uint16_t)n;
  shape->ends[1] = (uint16_t)(2 * n);
  unsigned at = 2 * n;
  for (unsigned i = 0; i < n; i++) {
    const unsigned next = i + 1 < n ? i + 1 : 0;
    const unsigned side[4] = {i, next, n + next, n + i};
    for (unsigned k = 0; k < 4; k++) {
      shape->corners[at++] = (uint16_t)side[k];
    }
    shape->ends[2 + i] = (uint16_t)at;
  }
}

void generate_prism(unsigned sides, case_shape *shape) {
  const gjk_vec3 size = shape->size;
  shape->kind = CASE_HULL;
  case_shape_set_count(shape, 2 * (size_t)sides);
  for (unsigned i = 0; i < sides; i++) {
    const double angle = 6.283185307179586 * i / sides;
    const gjk_vec3 low = {scaled(size.x, cos(angle)), scaled(size.y, sin(angle)), -size.z},
                   high = {low.x, low.y, size.z};
    shape->vertices[i] = low;
    shape->vertices[sides + i] = high;
  }
  set_faces(sides, shape);
}
