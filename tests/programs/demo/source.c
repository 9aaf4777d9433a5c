// Writes an answered scene as C tables.
#include "source.h"

#include "demo_scene.h"

// INT32_MIN has no literal of its own type.
static void put_number(FILE *file, int32_t value) {
  if (value == INT32_MIN) {
    fprintf(file, "INT32_MIN");
  } else {
    fprintf(file, "%ld", (long)value);
  }
}

static void put_numbers(FILE *file, const char *before, const int32_t *value, size_t count, const char *after) {
  fputs(before, file);
  for (size_t i = 0; i < count; i++) {
    fputs(i == 0 ? "" : ", ", file);
    put_number(file, value[i]);
  }
  fputs(after, file);
}

static void put_vec3(FILE *file, gjk_vec3 v, const char *after) {
  const int32_t value[3] = {v.x, v.y, v.z};
  put_numbers(file, "{", value, 3, "}");
  fputs(after, file);
}

static void put_shape(FILE *file, const scene_body *body, size_t index) {
  const case_shape *shape = &body->shape;
  const int32_t number[4] = {shape->size.x, shape->size.y, shape->size.z, shape->convex_radius};
  const int32_t tall[3] = {shape->size.x, shape->size.z, shape->convex_radius};
  switch (shape->kind) {
    case CASE_POINT: put_numbers(file, "GJK_ROUNDED_POINT(", &shape->convex_radius, 1, ")"); break;
    case CASE_SEGMENT: put_numbers(file, "GJK_ROUNDED_SEGMENT(", tall + 1, 2, ")"); break;
    case CASE_BOX: put_numbers(file, "GJK_ROUNDED_BOX(", number, 4, ")"); break;
    case CASE_CYLINDER: put_numbers(file, "GJK_ROUNDED_CYLINDER(", tall, 3, ")"); break;
    case CASE_CONE: put_numbers(file, "GJK_ROUNDED_CONE(", tall, 3, ")"); break;
    case CASE_ELLIPSOID: put_numbers(file, "GJK_ROUNDED_ELLIPSOID(", number, 4, ")"); break;
    case CASE_TRIANGLE:
      fprintf(file, "GJK_ROUNDED_TRIANGLE(vertices_%lu, ", (unsigned long)index);
      put_numbers(file, "", &shape->convex_radius, 1, ")");
      break;
    case CASE_HULL:
      fprintf(file, "GJK_ROUNDED_HULL(vertices_%lu, %lu, ", (unsigned long)index, (unsigned long)shape->count);
      put_numbers(file, "", &shape->convex_radius, 1, ")");
      break;
  }
}

static bool put_vertices(FILE *file, const scene_body *body, size_t index) {
  const case_shape *shape = &body->shape;
  if (shape->count > DEMO_HULL_VERTICES_MAX) {
    fprintf(stderr, "%s: a hull of the tables has at most %d vertices\n", body->name, DEMO_HULL_VERTICES_MAX);
    return false;
  }
  if (shape->count > 0) {
    fprintf(file, "// %s\nstatic const gjk_vec3 vertices_%lu[] = {\n", body->name, (unsigned long)index);
    for (size_t i = 0; i < shape->count; i++) {
      fputs("  ", file);
      put_vec3(file, shape->vertices[i], ",\n");
    }
    fprintf(file, "};\n\n");
  }
  return true;
}

static void put_pose(FILE *file, const gjk_pose *pose) {
  const gjk_quat *q = &pose->rotation;
  const int32_t turn[4] = {q->x, q->y, q->z, q->w};
  fputs("{", file);
  put_vec3(file, pose->position, ", ");
  put_numbers(file, "{", turn, 4, "}},\n");
}

// The name as the inside of a C string.
static void put_string(FILE *file, const char *text) {
  for (; *text != '\0'; text++) {
    if (*text == '"' || *text == '\\') {
      fputc('\\', file);
    }
    fputc(*text == '?' ? '_' : *text, file);  // no trigraphs
  }
}

static void put_pair(FILE *file, const scene *s, const scene_pair *pair) {
  const gjk_distance_result *r = &pair->answer;
  static const gjk_vec3 zero = {0, 0, 0};
  const gjk_vec3 normal = {r->normal.x, r->normal.y, r->normal.z};
  fprintf(file, "  {\"");
  put_string(file, s->body[pair->a].name);
  fputc(':', file);
  put_string(file, s->body[pair->b].name);
  fprintf(file, "\",\n   ");
  put_shape(file, &s->body[pair->a], pair->a);
  fprintf(file, ",\n   ");
  put_shape(file, &s->body[pair->b], pair->b);
  fprintf(file, ",\n   ");
  put_pose(file, &s->body[pair->a].shape.pose);
  fprintf(file, "   ");
  put_pose(file, &s->body[pair->b].shape.pose);
  fprintf(file, "   ");
  put_number(file, r->distance);
  fprintf(file, ", ");
  put_vec3(file, r->intersecting ? zero : r->point_a, ", ");
  put_vec3(file, r->intersecting ? zero : r->point_b, ",\n   ");
  put_vec3(file, r->intersecting ? zero : normal, ", ");
  fprintf(file, "%s, %u},\n", r->intersecting ? "true" : "false", r->iterations);
}

static bool put_arm(FILE *file) {
  gjk_joint joints[ARM_JOINTS];
  gjk_pose frames[ARM_JOINTS];
  if (!arm_make(joints) || !arm_frames(joints, frames)) {
    return false;
  }
  fprintf(file, "\nconst gjk_pose demo_arm[ARM_JOINTS] = {\n");
  for (unsigned i = 0; i < ARM_JOINTS; i++) {
    put_pose(file, &frames[i]);
  }
  fprintf(file, "};\n");
  return true;
}

bool source_write(FILE *file, const scene *s) {
  fprintf(file, "// Written by gjk-demo --c-source.\n#include \"demo_scene.h\"\n\n#include \"gjk/shape.h\"\n\n");
  for (size_t i = 0; i < s->bodies; i++) {
    if (!put_vertices(file, &s->body[i], i)) {
      return false;
    }
  }
  fprintf(file, "const demo_pair demo_pairs[] = {\n");
  for (size_t i = 0; i < s->pairs; i++) {
    put_pair(file, s, &s->pair[i]);
  }
  fprintf(file, "};\n\nconst unsigned demo_pair_count = sizeof demo_pairs / sizeof demo_pairs[0];\n");
  return put_arm(file);
}
