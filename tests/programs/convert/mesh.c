// Meshes in memory.
#include "mesh.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "polygon.h"

void mesh_free(mesh *m) {
  free(m->point);
  free(m->triangle);
  free(m->face);
}

bool mesh_fail(mesh_file *file, const char *format, ...) {
  if (file->problem[0] == '\0') {
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(file->problem, sizeof file->problem, format, arguments);
    va_end(arguments);
  }
  return false;
}

bool mesh_fail_at(mesh_file *file, const char *what, long number) {
  const size_t length = strlen(file->problem);
  snprintf(file->problem + length, sizeof file->problem - length, ", in %s %ld", what, number);
  return false;
}

bool mesh_add_point(mesh *m, mesh_file *file, const double xyz[3]) {
  gjk_q16 lsb[3];
  for (int i = 0; i < 3; i++) {
    const double *row = file->place != NULL ? file->place[i] : NULL;
    const double placed = row != NULL ? row[0] * xyz[0] + row[1] * xyz[1] + row[2] * xyz[2] + row[3] : xyz[i];
    const double exact = placed * file->scale, rounded = rint(exact);
    if (!(rounded >= INT32_MIN && rounded <= INT32_MAX)) {
      return mesh_fail(file, "a coordinate is beyond Q16.16");
    }
    lsb[i] = (gjk_q16)rounded;
    m->most_rounding = fmax(m->most_rounding, fabs(exact - rounded));
  }
  if (m->points == m->point_room) {
    m->point = solid_grow(m->point, &m->point_room, sizeof m->point[0]);
  }
  const gjk_vec3 point = {lsb[0], lsb[1], lsb[2]};
  m->point[m->points++] = point;
  return true;
}

bool mesh_add_polygon(mesh *m, mesh_file *file, const int64_t *corner, size_t corners) {
  if (corners < 3) {
    return mesh_fail(file, "a face of less than 3 corners");
  }
  for (size_t i = 0; i < corners; i++) {
    if (corner[i] < 0 || (uint64_t)corner[i] >= m->points) {
      return mesh_fail(file, "a face with a corner that is no vertex");
    }
  }
  uint32_t *at = solid_allocate(corners, sizeof at[0]);
  while (m->triangle_room - m->triangles < corners - 2) {
    size_t room = m->triangle_room;
    m->face = solid_grow(m->face, &room, sizeof m->face[0]);
    m->triangle = solid_grow(m->triangle, &m->triangle_room, sizeof m->triangle[0]);
  }
  for (size_t i = 0; i < corners; i++) {
    at[i] = (uint32_t)corner[i];
  }
  polygon_cut(m->point, at, corners, m->triangle + m->triangles);
  free(at);
  m->faces++;
  for (size_t i = 0; i + 2 < corners; i++) {
    m->face[m->triangles++] = (uint32_t)m->faces;
  }
  return true;
}

typedef struct numbered_point {
  gjk_vec3 at;
  uint32_t number;
} numbered_point;

static int compare(int32_t a, int32_t b) {
  return a < b ? -1 : a > b;
}

static int by_place(const void *a, const void *b) {
  const numbered_point *p = a, *q = b;
  const int x = compare(p->at.x, q->at.x), y = compare(p->at.y, q->at.y), z = compare(p->at.z, q->at.z);
  return x != 0 ? x : y != 0 ? y : z != 0 ? z : (p->number > q->number) - (p->number < q->number);
}

static bool is_same(gjk_vec3 a, gjk_vec3 b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

void mesh_weld(mesh *m) {
  numbered_point *sorted = solid_allocate(m->points, sizeof sorted[0]);
  uint32_t *number = solid_allocate(m->points, sizeof number[0]);
  for (size_t i = 0; i < m->points; i++) {
    sorted[i].at = m->point[i];
    sorted[i].number = (uint32_t)i;
  }
  qsort(sorted, m->points, sizeof sorted[0], by_place);
  for (size_t i = 0; i < m->points; i++) {  // each point is known by the first one of its place
    const bool again = i > 0 && is_same(sorted[i].at, sorted[i - 1].at);
    number[sorted[i].number] = again ? number[sorted[i - 1].number] : sorted[i].number;
  }
  size_t kept = 0;
  for (size_t i = 0; i < m->points; i++) {
    if (number[i] == i) {
      m->point[kept] = m->point[i];
      number[i] = (uint32_t)kept++;
    } else {
      number[i] = number[number[i]];  // that one comes before, and has its new number
    }
  }
  m->points = kept;
  kept = 0;
  for (size_t t = 0; t < m->triangles; t++) {
    const uint32_t a = number[m->triangle[t][0]], b = number[m->triangle[t][1]], c = number[m->triangle[t][2]];
    if (a != b && b != c && c != a) {
      if (m->face != NULL) {
        m->face[kept] = m->face[t];
      }
      m->triangle[kept][0] = a;
      m->triangle[kept][1] = b;
      m->triangle[kept++][2] = c;
    }
  }
  m->triangles = kept;
  free(sorted);
  free(number);
}

static int by_value(const void *a, const void *b) {
  const uint64_t x = *(const uint64_t *)a, y = *(const uint64_t *)b;
  return (x > y) - (x < y);
}

bool mesh_is_watertight(const mesh *m) {
  const size_t edges = 3 * m->triangles;
  uint64_t *forth = solid_allocate(edges, sizeof forth[0]), *back = solid_allocate(edges, sizeof back[0]);
  for (size_t i = 0; i < edges; i++) {
    const uint64_t from = m->triangle[i / 3][i % 3], to = m->triangle[i / 3][(i + 1) % 3];
    forth[i] = from << 32 | to;
    back[i] = to << 32 | from;
  }
  qsort(forth, edges, sizeof forth[0], by_value);
  qsort(back, edges, sizeof back[0], by_value);
  bool tight = edges > 0;
  for (size_t i = 0; i < edges; i++) {
    tight = tight && forth[i] == back[i] && (i == 0 || forth[i] != forth[i - 1]);
  }
  free(forth);
  free(back);
  return tight;
}
