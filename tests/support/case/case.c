// Cases: storage, building of posed colliders, printing.
#include "case.h"

#include <stdlib.h>

static void *resize(void *memory, size_t count, size_t size) {
  void *grown = count > SIZE_MAX / size ? NULL : realloc(memory, count * size);
  if (grown == NULL) {
    fprintf(stderr, "out of memory for %lu vertices or corners\n", (unsigned long)count);
    exit(2);
  }
  return grown;
}

void case_shape_reset(case_shape *shape) {
  static const gjk_vec3 zero = {0, 0, 0};
  static const gjk_pose identity = GJK_POSE_IDENTITY;
  shape->kind = CASE_POINT;
  shape->size = zero;
  shape->count = 0;
  shape->faces = 0;
  shape->convex_radius = 0;
  shape->pose = shape->end = identity;
  shape->moves = false;
  shape->spin = zero;
}

void case_shape_free(case_shape *shape) {
  free(shape->vertices);
  free(shape->corners);
  free(shape->ends);
  shape->vertices = NULL;
  shape->corners = shape->ends = NULL;
  shape->count = shape->capacity = 0;
  shape->faces = shape->faces_capacity = 0;
}

void case_pair_free(case_pair *pair) {
  case_shape_free(&pair->a);
  case_shape_free(&pair->b);
}

void case_shape_set_count(case_shape *shape, size_t count) {
  if (count > shape->capacity) {
    shape->vertices = resize(shape->vertices, count, sizeof(gjk_vec3));
    shape->capacity = count;
  }
  shape->count = count;
}

void case_shape_set_faces(case_shape *shape, size_t faces) {
  if (faces > shape->faces_capacity) {
    shape->corners = resize(shape->corners, faces * GJK_FACE_CORNERS_MAX, sizeof(uint16_t));
    shape->ends = resize(shape->ends, faces, sizeof(uint16_t));
    shape->faces_capacity = faces;
  }
  shape->faces = faces;
}

void case_shape_move_to(case_shape *shape, const gjk_vec3 *to) {
  shape->end.rotation = shape->moves ? shape->end.rotation : shape->pose.rotation;
  shape->end.position = *to;
  shape->moves = true;
}

void case_shape_copy(case_shape *to, const case_shape *from) {
  to->kind = from->kind;
  to->size = from->size;
  to->convex_radius = from->convex_radius;
  to->pose = from->pose;
  to->end = from->end;
  to->moves = from->moves;
  to->spin = from->spin;
  case_shape_set_count(to, from->count);
  for (size_t i = 0; i < from->count; i++) {
    to->vertices[i] = from->vertices[i];
  }
  case_shape_set_faces(to, from->faces);
  for (size_t i = 0; i < from->faces; i++) {
    to->ends[i] = from->ends[i];
  }
  for (size_t i = 0; from->faces > 0 && i < from->ends[from->faces - 1]; i++) {
    to->corners[i] = from->corners[i];
  }
}

static gjk_shape library_shape(const case_shape *shape) {
  gjk_vec3 s = shape->size;
  gjk_q16 r = shape->convex_radius;
  switch (shape->kind) {
    case CASE_SEGMENT: {
      gjk_shape segment = GJK_ROUNDED_SEGMENT(s.z, r);
      return segment;
    }
    case CASE_TRIANGLE: {
      gjk_shape triangle = GJK_ROUNDED_TRIANGLE(shape->vertices, r);
      return triangle;
    }
    case CASE_BOX: {
      gjk_shape box = GJK_ROUNDED_BOX(s.x, s.y, s.z, r);
      return box;
    }
    case CASE_HULL: {
      gjk_shape hull = GJK_ROUNDED_HULL(shape->vertices, (uint16_t)shape->count, r);
      return hull;
    }
    case CASE_CYLINDER: {
      gjk_shape cylinder = GJK_ROUNDED_CYLINDER(s.x, s.z, r);
      return cylinder;
    }
    case CASE_CONE: {
      gjk_shape cone = GJK_ROUNDED_CONE(s.x, s.z, r);
      return cone;
    }
    case CASE_ELLIPSOID: {
      gjk_shape ellipsoid = GJK_ROUNDED_ELLIPSOID(s.x, s.y, s.z, r);
      return ellipsoid;
    }
    default: {
      gjk_shape point = GJK_ROUNDED_POINT(r);
      return point;
    }
  }
}

gjk_status case_collider_build(case_collider *collider, const case_shape *shape, bool lazy) {
  gjk_vec3 *buffer = NULL;
  if (shape->count > GJK_HULL_VERTICES_MAX) {
    return GJK_ERROR_RANGE;
  }
  if (shape->kind == CASE_HULL && !lazy) {
    if (shape->count > collider->capacity) {
      collider->buffer = resize(collider->buffer, shape->count, sizeof(gjk_vec3));
      collider->capacity = shape->count;
    }
    buffer = collider->buffer;
  }
  collider->shape = library_shape(shape);
  if (shape->faces > 0) {
    collider->faces.corner = shape->corners;
    collider->faces.end = shape->ends;
    collider->faces.count = (uint16_t)shape->faces;
    collider->shape.faces = &collider->faces;
  }
  gjk_status status = gjk_collider_init(&collider->collider, &collider->shape, buffer, (uint16_t)shape->count);
  return status == GJK_OK ? gjk_collider_pose(&collider->collider, &shape->pose) : status;
}

void case_collider_free(case_collider *collider) {
  free(collider->buffer);
  collider->buffer = NULL;
  collider->capacity = 0;
}

bool case_pair_build(const case_pair *pair, bool lazy, case_collider *a, case_collider *b) {
  return case_collider_build(a, &pair->a, lazy) == GJK_OK && case_collider_build(b, &pair->b, lazy) == GJK_OK;
}

void case_pair_release(case_pair *pair, case_collider *a, case_collider *b) {
  case_pair_free(pair);
  case_collider_free(a);
  case_collider_free(b);
}

gjk_cast_path case_path(const case_pair *pair, gjk_q16 margin) {
  const gjk_cast_path path = {.to_a = pair->a.moves ? &pair->a.end.position : NULL,
                              .to_b = pair->b.moves ? &pair->b.end.position : NULL,
                              .margin = margin};
  return path;
}

gjk_motion case_motion(const case_shape *shape) {
  const gjk_motion motion = {.from = shape->pose, .to = shape->moves ? shape->end : shape->pose, .spin = shape->spin};
  return motion;
}

static void print_vec3(FILE *file, gjk_vec3 v) {
  fprintf(file, "%ld %ld %ld\n", (long)v.x, (long)v.y, (long)v.z);
}

// Prints the KIND part of a shape's line, and the lines of its vertices.
static void print_kind(FILE *file, const case_shape *shape) {
  gjk_vec3 s = shape->size;
  switch (shape->kind) {
    case CASE_POINT: fprintf(file, "point\n"); break;
    case CASE_SEGMENT: fprintf(file, "segment %ld\n", (long)s.z); break;
    case CASE_TRIANGLE: fprintf(file, "triangle\n"); break;
    case CASE_BOX:
      fprintf(file, "box ");
      print_vec3(file, s);
      break;
    case CASE_HULL: fprintf(file, "hull %lu\n", (unsigned long)shape->count); break;
    case CASE_CYLINDER: fprintf(file, "cylinder %ld %ld\n", (long)s.x, (long)s.z); break;
    case CASE_CONE: fprintf(file, "cone %ld %ld\n", (long)s.x, (long)s.z); break;
    case CASE_ELLIPSOID:
      fprintf(file, "ellipsoid ");
      print_vec3(file, s);
      break;
  }
  if (shape->kind == CASE_TRIANGLE || shape->kind == CASE_HULL) {
    for (size_t i = 0; i < shape->count; i++) {
      print_vec3(file, shape->vertices[i]);
    }
  }
}

static void print_faces(FILE *file, char name, const case_shape *shape) {
  fprintf(file, "%c faces %lu\n", name, (unsigned long)shape->faces);
  for (size_t i = 0, k = 0; i < shape->faces; i++) {
    for (const char *before = ""; k < shape->ends[i]; k++, before = " ") {
      fprintf(file, "%s%u", before, shape->corners[k]);
    }
    fprintf(file, "\n");
  }
}

static void print_rotation(FILE *file, char name, const char *word, const gjk_quat *q) {
  fprintf(file, "%c %s %ld %ld %ld %ld\n", name, word, (long)q->x, (long)q->y, (long)q->z, (long)q->w);
}

static void print_way(FILE *file, char name, const case_shape *shape) {
  const gjk_quat *p = &shape->pose.rotation, *q = &shape->end.rotation;
  if (shape->moves) {
    fprintf(file, "%c to ", name);
    print_vec3(file, shape->end.position);
  }
  if (shape->moves && (p->x != q->x || p->y != q->y || p->z != q->z || p->w != q->w)) {
    print_rotation(file, name, "turn-to", q);
  }
  if ((shape->spin.x | shape->spin.y | shape->spin.z) != 0) {
    fprintf(file, "%c spin ", name);
    print_vec3(file, shape->spin);
  }
}

static void print_shape(FILE *file, char name, const case_shape *shape) {
  fprintf(file, "%c ", name);
  print_kind(file, shape);
  if (shape->faces > 0) {
    print_faces(file, name, shape);
  }
  if (shape->convex_radius != 0) {
    fprintf(file, "%c round %ld\n", name, (long)shape->convex_radius);
  }
  fprintf(file, "%c at ", name);
  print_vec3(file, shape->pose.position);
  print_rotation(file, name, "turn", &shape->pose.rotation);
  print_way(file, name, shape);
}

void case_print(FILE *file, const case_pair *pair) {
  fprintf(file, "case %s\n", pair->id[0] != '\0' ? pair->id : "unnamed");
  print_shape(file, 'A', &pair->a);
  print_shape(file, 'B', &pair->b);
}

void case_show(const void *pair) {
  case_print(stdout, pair);
}

// A case of a shape; it borrows the vertices, to be printed.
static case_shape borrow(const gjk_shape *shape, const gjk_pose *pose) {
  static const gjk_shape_class *const kinds[] = {
      [CASE_POINT] = &gjk_class_point, [CASE_SEGMENT] = &gjk_class_segment,    [CASE_TRIANGLE] = &gjk_class_triangle,
      [CASE_BOX] = &gjk_class_box,     [CASE_HULL] = &gjk_class_hull,          [CASE_CYLINDER] = &gjk_class_cylinder,
      [CASE_CONE] = &gjk_class_cone,   [CASE_ELLIPSOID] = &gjk_class_ellipsoid};
  case_shape s = {.kind = CASE_POINT,
                  .size = shape->size,
                  .count = shape->count,
                  .convex_radius = shape->convex_radius,
                  .pose = *pose,
                  .end = *pose};
  while (s.kind < CASE_ELLIPSOID && kinds[s.kind] != shape->type) {
    s.kind = (case_kind)(s.kind + 1);
  }
  s.vertices = (gjk_vec3 *)(uintptr_t)shape->vertices;
  s.count = s.kind == CASE_TRIANGLE ? 3 : shape->count;
  return s;
}

void case_show_posed(const void *posed) {
  const case_posed *p = posed;
  const case_pair pair = {"posed", borrow(&p->a, &p->at_a), borrow(&p->b, &p->at_b)};
  case_print(stdout, &pair);
}
