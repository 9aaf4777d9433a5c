// Convex parts as a line, as C, as cases.
#include "write_parts.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "write.h"

void write_parts_info(const decomposition *d) {
  printf("parts=%zu excess=%.0Lf enclosed=%s\n", d->parts, ceill(d->excess.at_most), d->enclosed ? "yes" : "no");
}

bool write_parts_fit(const decomposition *d) {
  bool fit = true;
  for (size_t i = 0; i < d->parts && fit; i++) {
    const part *p = &d->part[i];
    gjk_vec3 *vertex = solid_allocate(p->points, sizeof vertex[0]);
    for (unsigned n = 0; n < p->points; n++) {
      vertex[n].x = p->point[n][0];
      vertex[n].y = p->point[n][1];
      vertex[n].z = p->point[n][2];
    }
    fit = write_fits(vertex, p->points);
    free(vertex);
  }
  return fit;
}

static void print_numbers(const char *name, size_t number, const char *what, const uint16_t *value, size_t count) {
  printf("static const uint16_t %s_%zu_%s[%zu] = {", name, number, what, count);
  for (size_t i = 0; i < count; i++) {
    printf("%s%u", i % 16 == 0 ? "\n    " : " ", value[i]);
    fputs(i + 1 < count ? "," : "\n", stdout);
  }
  printf("};\n");
}

static long coordinate(const solid *s, const part *p, unsigned point, int axis) {
  const gjk_q16 origin = axis == 0 ? s->origin.x : axis == 1 ? s->origin.y : s->origin.z;
  return (long)p->point[point][axis] + origin;
}

void write_parts_source(const solid *s, const decomposition *d, const char *name) {
  printf(
      "// Made by gjk-convert: convex parts, Q16.16, in one frame. They %s the solid, and reach beyond it by at most "
      "%.0Lf LSB.\n",
      d->enclosed ? "enclose" : "do not enclose", ceill(d->excess.at_most));
  printf("// gjk_compound_build(%s, %zu, nodes, GJK_COMPOUND_NODES(%zu), &compound) makes them one body.\n", name,
         d->parts, d->parts);
  printf("#include \"gjk/compound.h\"\n\n");
  for (size_t i = 0; i < d->parts; i++) {
    const part *p = &d->part[i];
    printf("static const gjk_vec3 %s_%zu_vertices[%u] = {\n", name, i, p->points);
    for (unsigned n = 0; n < p->points; n++) {
      printf("    {%ld, %ld, %ld},\n", coordinate(s, p, n, 0), coordinate(s, p, n, 1), coordinate(s, p, n, 2));
    }
    printf("};\n");
    print_numbers(name, i, "corners", p->corner, p->end[p->faces - 1]);
    print_numbers(name, i, "ends", p->end, p->faces);
    printf("static const gjk_hull_faces %s_%zu_faces = {%s_%zu_corners, %s_%zu_ends, %u};\n", name, i, name, i, name, i,
           p->faces);
    printf("static const gjk_shape %s_%zu = GJK_HULL_WITH_FACES(%s_%zu_vertices, %u, &%s_%zu_faces);\n", name, i, name,
           i, p->points, name, i);
  }
  printf("const gjk_compound_part %s[%zu] = {\n", name, d->parts);
  for (size_t i = 0; i < d->parts; i++) {
    printf("    {&%s_%zu, GJK_POSE_IDENTITY},\n", name, i);
  }
  printf("};\n");
}

static void print_shape(const solid *s, const part *p, char body) {
  printf("%c hull %u\n", body, p->points);
  for (unsigned n = 0; n < p->points; n++) {
    printf("%ld %ld %ld\n", coordinate(s, p, n, 0), coordinate(s, p, n, 1), coordinate(s, p, n, 2));
  }
}

void write_parts_case(const solid *s, const decomposition *d, const char *name) {
  for (size_t i = 0; i < d->parts; i++) {
    printf("case %s_%zu\n", name, i);
    print_shape(s, &d->part[0], 'A');
    print_shape(s, &d->part[i], 'B');
  }
}
