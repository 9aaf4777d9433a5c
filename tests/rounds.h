// How many rounds a query may take: what gjk/format.h promises.
#ifndef ROUNDS_H
#define ROUNDS_H

#include "pair_search.h"

// The vertices of a collider's polytope; 0: it is curved.
static inline unsigned rounds_vertices(const gjk_collider *c) {
  const gjk_shape_class *type = c->shape->type;
  if (type->vertex == NULL) {
    return 0;
  }
  return type->kind == GJK_KIND_AXES ? 1u << c->count : c->count;
}

// A build with fewer plain rounds has a lower bound.
static inline unsigned rounds_bound(const gjk_collider *a, const gjk_collider *b) {
  const unsigned n = rounds_vertices(a), m = rounds_vertices(b);
  return n == 0 || m == 0 ? GJK_ITERATIONS_MAX : GJK_ITERATIONS_OF(n, m) - 16 + GJK_PLAIN_ROUNDS;
}

#endif
