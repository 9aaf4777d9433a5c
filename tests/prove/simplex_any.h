// Any simplex that src/gjk/gjk_simplex.c may leave behind, and the check that one is such a simplex.
//
// The queries know slots through order[] alone, so to them the slots' names mean nothing: tests/prove/query.c takes
// order 0, 1, 2, 3, tests/prove/simplex.c shows every other.
#ifndef PROVE_SIMPLEX_ANY_H
#define PROVE_SIMPLEX_ANY_H

#include "any.h"
#include "src/gjk/gjk_simplex.h"

// Of vertices w, squares and products of two, and w_i . (w_i - w_j): src/gjk/gjk_simplex.h.
#define ANY_W (INT32_C(3) << 29)
// A direction that a support is asked for: a vertex, an edge turned, or rounded.
#define ANY_DIRECTION INT32_MAX
#define ANY_SQUARE (INT64_C(9) << 58)
#define ANY_TOWARD (INT64_C(1) << 61)
#define ANY_NORMAL ((INT64_C(1) << 62) - 1)
// A component of a unit vector of src/arith/gjk_unit.h.
#define ANY_UNIT (GJK_Q30_ONE + 1)

static int64_t any_long(int64_t size) {
  return Frama_C_long_long_interval(-size, size);
}

static void any_vertex(gjk_vertex *v) {
  v->w = any_vec3(ANY_W);
  v->a.offset = any_vec3(ANY_OFFSET);
  v->a.vertex = any_uint16();
  v->b = any_uint16();
}

static void any_normal(gjk_long3 *n) {
  n->x = any_long(ANY_NORMAL);
  n->y = any_long(ANY_NORMAL);
  n->z = any_long(ANY_NORMAL);
}

// A direction of a support, by how many vertices have led to it: of a vertex as long as that, of others rounded.
static gjk_vec3 any_direction(unsigned count) {
  return any_vec3(count == 1 ? ANY_W : INT32_C(1) << 30);
}

static void check_size(int64_t x, int64_t size) {
  //@ assert x >= -size && x <= size;
}

static void check_vec3(const gjk_vec3 *v, int32_t size) {
  check_size(v->x, size);
  check_size(v->y, size);
  check_size(v->z, size);
}

static void check_vertex(const gjk_vertex *v) {
  check_vec3(&v->w, ANY_W);
  check_vec3(&v->a.offset, ANY_OFFSET);
  check_size(v->a.vertex, UINT16_MAX);
  check_size(v->b, UINT16_MAX);
}

#endif
