// Prisms.
#include "prism.h"

#include <math.h>

static int32_t scaled(int32_t size, double by) {
  return (int32_t)lround(size * by);
}

void generate_prism(unsigned sides, case_shape *shape, generate_faces *out) {
  const unsigned n = sides;
  const gjk_vec3 size = shape->size;
  shape->kind = CASE_HULL;
  case_shape_set_count(shape, 2 * (size_t)n);
  for (unsigned i = 0; i < n; i++) {
    const double angle = 6.283185307179586 * i / n;
    const gjk_vec3 low = {scaled(size.x, cos(angle)), scaled(size.y, sin(angle)), -size.z},
                   high = {low.x, low.y, size.z};
    shape->vertices[i] = low;
    shape->vertices[n + i] = high;
    out->corner[i] = (uint16_t)(n - 1 - i);
    out->corner[n + i] = (uint16_t)(n + i);
  }
  out->end[0] = (uint16_t)n;
  out->end[1] = (uint16_t)(2 * n);
  unsigned at = 2 * n;
  for (unsigned i = 0; i < n; i++) {
    const unsigned next = i + 1 < n ? i + 1 : 0;
    const unsigned side[4] = {i, next, n + next, n + i};
    for (unsigned k = 0; k < 4; k++) {
      out->corner[at++] = (uint16_t)side[k];
    }
    out->end[2 + i] = (uint16_t)at;
  }
  out->faces.corner = out->corner;
  out->faces.end = out->end;
  out->faces.count = (uint16_t)(n + 2);
}
