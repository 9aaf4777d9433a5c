// Cases of the plane: storage, printing.
#include "case2.h"

#include <stdlib.h>

#define ONE (INT32_C(1) << 30)

void case2_shape_reset(case2_shape *shape) {
  static const case2_vec zero = {0, 0}, unturned = {ONE, 0};
  shape->kind = CASE2_POINT;
  shape->size = zero;
  shape->count = 0;
  shape->convex_radius = 0;
  shape->at = zero;
  shape->turn = unturned;
}

static void free_shape(case2_shape *shape) {
  free(shape->vertices);
  shape->vertices = NULL;
  shape->count = shape->capacity = 0;
}

void case2_pair_free(case2_pair *pair) {
  free_shape(&pair->a);
  free_shape(&pair->b);
}

void case2_shape_set_count(case2_shape *shape, size_t count) {
  if (count > shape->capacity) {
    void *grown = count > SIZE_MAX / sizeof(case2_vec) ? NULL : realloc(shape->vertices, count * sizeof(case2_vec));
    if (grown == NULL) {
      fprintf(stderr, "out of memory for %lu vertices\n", (unsigned long)count);
      exit(2);
    }
    shape->vertices = grown;
    shape->capacity = count;
  }
  shape->count = count;
}

static void print_vec(FILE *file, case2_vec v) {
  fprintf(file, "%ld %ld\n", (long)v.x, (long)v.y);
}

static void print_shape(FILE *file, char name, const case2_shape *shape) {
  fprintf(file, "%c ", name);
  switch (shape->kind) {
    case CASE2_POINT: fprintf(file, "point\n"); break;
    case CASE2_SEGMENT: fprintf(file, "segment %ld\n", (long)shape->size.x); break;
    case CASE2_BOX: fprintf(file, "box "); break;
    case CASE2_POLYGON: fprintf(file, "polygon %lu\n", (unsigned long)shape->count); break;
    case CASE2_ELLIPSE: fprintf(file, "ellipse "); break;
  }
  if (shape->kind == CASE2_BOX || shape->kind == CASE2_ELLIPSE) {
    print_vec(file, shape->size);
  }
  for (size_t i = 0; shape->kind == CASE2_POLYGON && i < shape->count; i++) {
    print_vec(file, shape->vertices[i]);
  }
  if (shape->convex_radius != 0) {
    fprintf(file, "%c round %ld\n", name, (long)shape->convex_radius);
  }
  fprintf(file, "%c at ", name);
  print_vec(file, shape->at);
  fprintf(file, "%c turn ", name);
  print_vec(file, shape->turn);
}

void case2_print(FILE *file, const case2_pair *pair) {
  fprintf(file, "case2 %s\n", pair->id[0] != '\0' ? pair->id : "unnamed");
  print_shape(file, 'A', &pair->a);
  print_shape(file, 'B', &pair->b);
}

void case2_show(const void *pair) {
  case2_print(stdout, pair);
}
