// Cases of the plane: posed colliders.
#include <stdlib.h>

#include "case2.h"

static gjk2_shape library_shape(const case2_shape *shape) {
  const gjk2_vec s = shape->size;
  const gjk_q16 r = shape->convex_radius;
  switch (shape->kind) {
    case CASE2_SEGMENT: {
      const gjk2_shape segment = GJK2_ROUNDED_SEGMENT(s.x, r);
      return segment;
    }
    case CASE2_TRIANGLE: {
      const gjk2_shape triangle = GJK2_ROUNDED_TRIANGLE(shape->vertices, r);
      return triangle;
    }
    case CASE2_BOX: {
      const gjk2_shape box = GJK2_ROUNDED_BOX(s.x, s.y, r);
      return box;
    }
    case CASE2_POLYGON: {
      const gjk2_shape polygon = GJK2_ROUNDED_POLYGON(shape->vertices, (uint16_t)shape->count, r);
      return polygon;
    }
    case CASE2_ELLIPSE: {
      const gjk2_shape ellipse = GJK2_ROUNDED_ELLIPSE(s.x, s.y, r);
      return ellipse;
    }
    default: {
      const gjk2_shape point = GJK2_ROUNDED_POINT(r);
      return point;
    }
  }
}

gjk_status case2_collider_build(case2_collider *collider, const case2_shape *shape, bool lazy) {
  gjk2_vec *buffer = NULL;
  if (shape->kind == CASE2_POLYGON && !lazy) {
    if (shape->count > collider->capacity) {
      gjk2_vec *grown = realloc(collider->buffer, shape->count * sizeof *grown);
      if (grown == NULL) {
        fprintf(stderr, "out of memory for %lu vertices\n", (unsigned long)shape->count);
        exit(2);
      }
      collider->buffer = grown;
      collider->capacity = shape->count;
    }
    buffer = collider->buffer;
  }
  collider->shape = library_shape(shape);
  const gjk_status status = gjk2_collider_init(&collider->collider, &collider->shape, buffer, (uint16_t)shape->count);
  return status == GJK_OK ? gjk2_collider_pose(&collider->collider, &shape->pose) : status;
}

void case2_collider_free(case2_collider *collider) {
  free(collider->buffer);
  collider->buffer = NULL;
  collider->capacity = 0;
}
