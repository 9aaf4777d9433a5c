// The most iterations that a query may take, as gjk/format.h promises.
#ifndef ITERATIONS_H
#define ITERATIONS_H

#include "src/gjk/gjk_search.h"

// How many vertices a collider's core has; 0: it is curved.
static inline unsigned iterations_vertices(const gjk_collider *c) {
  const gjk_shape_class *type = c->shape->type;
  if (type->vertex == NULL) {
    return 0;
  }
  return type->kind == GJK_KIND_AXES ? 1u << c->count : c->count;
}

// The most iterations for this pair. GJK_ITERATIONS_OF assumes 16 plain iterations; a build with fewer has a lower
// bound.
static inline unsigned iterations_bound(const gjk_collider *a, const gjk_collider *b) {
  const unsigned n = iterations_vertices(a), m = iterations_vertices(b);
  return n == 0 || m == 0 ? GJK_ITERATIONS_MAX : GJK_ITERATIONS_OF(n, m) - 16 + GJK_PLAIN_ITERATIONS;
}

#endif
