// Hulls as a line, as C, as a case.
#include "write.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "gjk/collider.h"
#include "gjk/table.h"
#include "memory.h"

void write_name(char *out, size_t room, const char *name, bool file) {
  const char *slash = strrchr(name, '/');
  size_t length = 0;
  name = file && slash != NULL ? slash + 1 : name;
  for (; *name != '\0' && !(file && *name == '.') && length + 2 < room; name++) {
    const char c = *name;
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_', digit = c >= '0' && c <= '9';
    if (length == 0 && digit) {
      out[length++] = '_';
    }
    out[length++] = (char)(letter || digit ? c : '_');
  }
  out[length] = '\0';
  if (length == 0) {
    memcpy(out, "hull", 5);
  }
}

// 2^64 high + low in decimal.
static void print_volume(gjk_hull_volume v) {
  char digits[40];
  size_t at = sizeof digits - 1;
  digits[at] = '\0';
  do {  // at most 39 digits: divide 2^64 high + low by 10, 32 bits at a time
    const uint32_t part[4] = {(uint32_t)(v.high >> 32), (uint32_t)v.high, (uint32_t)(v.low >> 32), (uint32_t)v.low};
    uint32_t quotient[4];
    uint64_t rest = 0;
    for (int i = 0; i < 4; i++) {
      rest = rest << 32 | part[i];
      quotient[i] = (uint32_t)(rest / 10);
      rest %= 10;
    }
    digits[--at] = (char)('0' + rest);
    v.high = (uint64_t)quotient[0] << 32 | quotient[1];
    v.low = (uint64_t)quotient[2] << 32 | quotient[3];
  } while (v.high != 0 || v.low != 0);
  fputs(digits + at, stdout);
}

void write_info(const gjk_hull *hull, size_t points, bool watertight) {
  gjk_hull_volume volume = {0, 0};
  gjk_hull_get_volume(hull, &volume);
  printf("points=%zu vertices=%u faces=%lu volume6=", points, hull->vertices, (unsigned long)hull->faces);
  print_volume(volume);
  printf(" watertight=%s\n", watertight ? "yes" : "no");
}

static gjk_vec3 *vertices_of(const gjk_hull *hull) {
  gjk_vec3 *vertex = solid_allocate(hull->vertices, sizeof vertex[0]);
  gjk_hull_vertices(hull, vertex, hull->vertices);
  return vertex;
}

bool write_fits(const gjk_vec3 *vertex, unsigned count) {
  const gjk_shape shape = GJK_HULL(vertex, (uint16_t)count);
  gjk_collider collider;
  memset(&collider, 0, sizeof collider);
  const bool fits = gjk_collider_init(&collider, &shape, NULL, 0) == GJK_OK;
  if (!fits) {
    fprintf(stderr, "gjk-convert: no shape: a vertex is more than 4095 units from the middle of its hull's box\n");
  }
  return fits;
}

static bool hull_fits(const gjk_hull *hull) {
  gjk_vec3 *vertex = vertices_of(hull);
  const bool fits = write_fits(vertex, hull->vertices);
  free(vertex);
  return fits;
}

static void print_vertices(const gjk_hull *hull, const char *name) {
  gjk_vec3 *vertex = vertices_of(hull);
  printf("static const gjk_vec3 %s_vertices[%u] = {\n", name, hull->vertices);
  for (unsigned i = 0; i < hull->vertices; i++) {
    printf("    {%ld, %ld, %ld},\n", (long)vertex[i].x, (long)vertex[i].y, (long)vertex[i].z);
  }
  printf("};\n");
  free(vertex);
}

static void print_numbers(const char *name, const char *what, const uint16_t *number, size_t count) {
  printf("static const uint16_t %s_%s[%zu] = {", name, what, count);
  for (size_t i = 0; i < count; i++) {
    printf("%s%u", i % 16 == 0 ? "\n    " : " ", number[i]);
    fputs(i + 1 < count ? "," : "\n", stdout);
  }
  printf("};\n");
}

// Makes the table, and writes it if that is asked for.
static bool write_table(const gjk_hull *hull, const char *name, int level) {
  const size_t cells = GJK_TABLE_CELLS(level);
  gjk_vec3 *vertex = vertices_of(hull);
  uint16_t *listed = solid_allocate(65535, sizeof listed[0]), *end = solid_allocate(cells, sizeof end[0]);
  const bool fits = gjk_hull_table_make(vertex, hull->vertices, (uint8_t)level, listed, 65535, end) == GJK_OK;
  if (fits) {
    print_numbers(name, "listed", listed, end[cells - 1]);
    print_numbers(name, "cells", end, cells);
    printf("static const gjk_hull_table %s_table = {%s_listed, %s_cells, %d};\n", name, name, name, level);
  } else {
    fprintf(stderr, "gjk-convert: the hull's table has more than 65535 numbers\n");
  }
  free(end);
  free(listed);
  free(vertex);
  return fits;
}

bool write_source(const gjk_hull *hull, const char *name, int level) {
  if (!hull_fits(hull)) {
    return false;
  }
  const size_t corners = 3 * (size_t)hull->corners < 65535 ? 3 * (size_t)hull->corners : 65535;
  uint16_t *corner = solid_allocate(corners, sizeof corner[0]), *end = solid_allocate(corners, sizeof end[0]);
  gjk_hull_faces faces = {NULL, NULL, 0};
  bool done = false;
  const gjk_status status = gjk_hull_write_faces(hull, corner, (uint16_t)corners, end, (uint16_t)corners, &faces);
  if (status == GJK_OK) {
    printf("// Made by gjk-convert: the convex hull of points, Q16.16.\n#include \"gjk/shape.h\"\n\n");
    print_vertices(hull, name);
    if (faces.count > 0) {
      print_numbers(name, "corners", corner, end[faces.count - 1]);
      print_numbers(name, "ends", end, faces.count);
      printf("static const gjk_hull_faces %s_faces = {%s_corners, %s_ends, %u};\n", name, name, name, faces.count);
    }
    done = level < 0 || write_table(hull, name, level);
    printf("const gjk_shape %s = %s(", name, level < 0 ? "GJK_HULL_WITH_FACES" : "GJK_ROUNDED_HULL_WITH_TABLE");
    printf("%s_vertices, %u, %s%s%s", name, hull->vertices, faces.count > 0 ? "&" : "0", faces.count > 0 ? name : "",
           faces.count > 0 ? "_faces" : "");
    if (level >= 0) {
      printf(", &%s_table, 0", name);
    }
    printf(");\n");
  } else {
    fprintf(stderr, "gjk-convert: the hull's faces have more than 65535 corners\n");
  }
  free(corner);
  free(end);
  return done;
}

static void print_shape(const gjk_hull *hull, char body) {
  gjk_vec3 *vertex = vertices_of(hull);
  printf("%c hull %u\n", body, hull->vertices);
  for (unsigned i = 0; i < hull->vertices; i++) {
    printf("%ld %ld %ld\n", (long)vertex[i].x, (long)vertex[i].y, (long)vertex[i].z);
  }
  free(vertex);
}

bool write_case(const gjk_hull *hull, const char *name) {
  if (!hull_fits(hull)) {
    return false;
  }
  gjk_vec3 *vertex = vertices_of(hull);
  const int64_t length = (int64_t)vertex[hull->vertices - 1].x - vertex[0].x;  // they are in order by x
  printf("case %s\n", name);
  print_shape(hull, 'A');
  print_shape(hull, 'B');
  printf("B at %ld 0 0\n", (long)length);
  free(vertex);
  return true;
}
