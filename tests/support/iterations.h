// How many iterations a query may take: what gjk/format.h promises.
#ifndef ITERATIONS_H
#define ITERATIONS_H

#include "src/gjk/gjk_search.h"

// The vertices of a collider's polytope; 0: it is curved.
static inline unsigned iterations_vertices(const gjk_collider *c) {
  const gjk_shape_class *type = c->shape->type;
  if (type->vertex == NULL) {
    return 0;
  }
  return type->kind == GJK_KIND_AXES ? 1u << c->count : c->count;
}

// A build with fewer plain iterations has a lower bound.
static inline unsigned iterations_bound(const gjk_collider *a, const gjk_collider *b) {
  const unsigned n = iterations_vertices(a), m = iterations_vertices(b);
  return n == 0 || m == 0 ? GJK_ITERATIONS_MAX : GJK_ITERATIONS_OF(n, m) - 16 + GJK_PLAIN_ITERATIONS;
}

#endif
