// Makes pairs from bytes.
#include "bytes.h"

#include <stdlib.h>
#include <string.h>

#define VERTICES_MAX 24

void fuzz_fail(const char *what) {
  fprintf(stderr, "fuzz: %s\n", what);
  abort();
}

// A coordinate, shifted so that the shape may be small enough. Coordinates that seeds.c writes are not changed by it.
static int32_t limited(int32_t x) {
  return x % (INT32_C(1) << 28);
}

static void fuzz_shape(fuzz_bytes *bytes, case_shape *shape) {
  case_shape_reset(shape);
  shape->kind = (case_kind)(fuzz_u8(bytes) % (CASE_ELLIPSOID + 1));
  const gjk_vec3 size = fuzz_vec3(bytes);
  shape->size.x = abs(limited(size.x));
  shape->size.y = abs(limited(size.y));
  shape->size.z = abs(limited(size.z));
  shape->convex_radius = abs(limited(fuzz_i32(bytes)));
  shape->pose.position = fuzz_vec3(bytes);
  gjk_quat q;
  q.x = fuzz_i32(bytes);
  q.y = fuzz_i32(bytes);
  q.z = fuzz_i32(bytes);
  q.w = fuzz_i32(bytes);
  (void)gjk_quat_normalize(&q, &shape->pose.rotation);  // of 0: stays the identity
  const size_t count = 1 + fuzz_u8(bytes) % VERTICES_MAX;
  if (shape->kind == CASE_TRIANGLE || shape->kind == CASE_HULL) {
    case_shape_set_count(shape, shape->kind == CASE_TRIANGLE ? 3 : count);
    for (size_t i = 0; i < shape->count; i++) {
      const gjk_vec3 v = fuzz_vec3(bytes);
      shape->vertices[i].x = limited(v.x);
      shape->vertices[i].y = limited(v.y);
      shape->vertices[i].z = limited(v.z);
    }
  }
}

void fuzz_pair(fuzz_bytes *bytes, case_pair *pair) {
  strcpy(pair->id, "fuzz");
  fuzz_shape(bytes, &pair->a);
  fuzz_shape(bytes, &pair->b);
}
