// Cases of the plane: storage, printing.
#include "case2.h"

#include <stdlib.h>

void case2_shape_reset(case2_shape *shape) {
  static const gjk2_vec zero = {0, 0};
  static const gjk2_pose identity = GJK2_POSE_IDENTITY;
  shape->kind = CASE2_POINT;
  shape->size = zero;
  shape->count = 0;
  shape->convex_radius = 0;
  shape->pose = shape->end = identity;
  shape->moves = false;
  shape->spin = 0;
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
    void *grown = count > SIZE_MAX / sizeof(gjk2_vec) ? NULL : realloc(shape->vertices, count * sizeof(gjk2_vec));
    if (grown == NULL) {
      fprintf(stderr, "out of memory for %lu vertices\n", (unsigned long)count);
      exit(2);
    }
    shape->vertices = grown;
    shape->capacity = count;
  }
  shape->count = count;
}

void case2_shape_move_to(case2_shape *shape, const gjk2_vec *to) {
  shape->end.rotation = shape->moves ? shape->end.rotation : shape->pose.rotation;
  shape->end.position = *to;
  shape->moves = true;
}

gjk2_cast_path case2_path(const case2_pair *pair, gjk_q16 margin) {
  const gjk2_cast_path path = {.to_a = pair->a.moves ? &pair->a.end.position : NULL,
                               .to_b = pair->b.moves ? &pair->b.end.position : NULL,
                               .margin = margin};
  return path;
}

gjk2_motion case2_motion(const case2_shape *shape) {
  const gjk2_motion motion = {.from = shape->pose, .to = shape->moves ? shape->end : shape->pose, .spin = shape->spin};
  return motion;
}

static void print_vec(FILE *file, gjk2_vec v) {
  fprintf(file, "%ld %ld\n", (long)v.x, (long)v.y);
}

static void print_way(FILE *file, char name, const case2_shape *shape) {
  const gjk2_rotation *p = &shape->pose.rotation, *q = &shape->end.rotation;
  if (shape->moves) {
    fprintf(file, "%c to ", name);
    print_vec(file, shape->end.position);
  }
  if (shape->moves && (p->c != q->c || p->s != q->s)) {
    fprintf(file, "%c turn-to %ld %ld\n", name, (long)q->c, (long)q->s);
  }
  if (shape->spin != 0) {
    fprintf(file, "%c spin %ld\n", name, (long)shape->spin);
  }
}

static void print_shape(FILE *file, char name, const case2_shape *shape) {
  fprintf(file, "%c ", name);
  switch (shape->kind) {
    case CASE2_POINT: fprintf(file, "point\n"); break;
    case CASE2_SEGMENT: fprintf(file, "segment %ld\n", (long)shape->size.x); break;
    case CASE2_TRIANGLE: fprintf(file, "triangle\n"); break;
    case CASE2_BOX: fprintf(file, "box "); break;
    case CASE2_POLYGON: fprintf(file, "polygon %lu\n", (unsigned long)shape->count); break;
    case CASE2_ELLIPSE: fprintf(file, "ellipse "); break;
  }
  if (shape->kind == CASE2_BOX || shape->kind == CASE2_ELLIPSE) {
    print_vec(file, shape->size);
  }
  for (size_t i = 0; i < shape->count; i++) {
    print_vec(file, shape->vertices[i]);
  }
  if (shape->convex_radius != 0) {
    fprintf(file, "%c round %ld\n", name, (long)shape->convex_radius);
  }
  fprintf(file, "%c at ", name);
  print_vec(file, shape->pose.position);
  fprintf(file, "%c turn %ld %ld\n", name, (long)shape->pose.rotation.c, (long)shape->pose.rotation.s);
  print_way(file, name, shape);
}

void case2_print(FILE *file, const case2_pair *pair) {
  fprintf(file, "case2 %s\n", pair->id[0] != '\0' ? pair->id : "unnamed");
  print_shape(file, 'A', &pair->a);
  print_shape(file, 'B', &pair->b);
}

void case2_show(const void *pair) {
  case2_print(stdout, pair);
}
