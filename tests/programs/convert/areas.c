// Areas of planes, split by a surface.
#include "areas.h"

#include <stdlib.h>
#include <string.h>

void area_put(area_pile *p, flat_polygon polygon) {
  if (polygon.lines == 0) {
    flat_free(&polygon);
    return;
  }
  if (p->count == p->room) {
    p->polygon = solid_grow(p->polygon, &p->room, sizeof p->polygon[0]);
  }
  p->polygon[p->count++] = polygon;
}

void area_clear(area_pile *p) {
  for (size_t i = 0; i < p->count; i++) {
    flat_free(&p->polygon[i]);
  }
  free(p->polygon);
  memset(p, 0, sizeof *p);
}

// The plane through an edge of a triangle, along an axis.
static solid_plane wall(const int32_t a[3], const int32_t b[3], int axis) {
  int32_t c[3] = {a[0], a[1], a[2]};
  c[axis] += a[axis] < SOLID_EXTENT / 2 ? 1 : -1;
  return solid_plane_of(a, b, c);
}

static int greatest(const int64_t n[3]) {
  int axis = 0;
  for (int i = 1; i < 3; i++) {
    const int64_t a = n[i] < 0 ? -n[i] : n[i], b = n[axis] < 0 ? -n[axis] : n[axis];
    axis = a > b ? i : axis;
  }
  return axis;
}

bool area_split(const solid *s, const flat_base *base, area_pile *polygons) {
  for (size_t t = 0; t < s->triangles && polygons->count > 0 && polygons->count <= AREAS_MAX; t++) {
    const int32_t *corner[3] = {s->point[s->triangle[t][0]], s->point[s->triangle[t][1]], s->point[s->triangle[t][2]]};
    const flat_base other = flat_base_of(corner[0], corner[1], corner[2]);
    const solid_plane *plane = &s->plane[t];
    if (solid_is_apart(other.low, other.high, base->low, base->high) ||
        (plane->n[0] == 0 && plane->n[1] == 0 && plane->n[2] == 0)) {
      continue;
    }
    const flat_line line = flat_trace(base, plane, 1);
    const bool level = line.ks == 0 && line.kt == 0;
    if (level && line.k != 0) {
      continue;
    }
    flat_line wall_line[4];
    const solid_wide turned = level ? 0 : 1;
    for (int i = 0; i < 3; i++) {
      const int axis = greatest(plane->n);
      const solid_plane side = wall(corner[i], corner[(i + 1) % 3], axis);
      const solid_wide inside = solid_height(&side, corner[(i + 2) % 3]);
      wall_line[i] = flat_trace(base, &side, inside > 0 ? 1 : -1);
    }
    wall_line[3] = line;
    area_pile done = {NULL, 0, 0};
    for (size_t i = 0; i < polygons->count; i++) {
      flat_polygon polygon = polygons->polygon[i];
      bool near = true;
      for (int e = 0; e < 3 && near; e++) {
        near = (flat_sides(&polygon, &wall_line[e]) & FLAT_BEYOND) != 0 ||
               (wall_line[e].ks == 0 && wall_line[e].kt == 0 && wall_line[e].k >= 0);
      }
      for (int e = turned ? 3 : 0; near && e < (turned ? 4 : 3); e++) {
        if (flat_sides(&polygon, &wall_line[e]) == (FLAT_BEYOND | FLAT_BEHIND)) {
          const flat_polygon kept = flat_clip(&polygon, &wall_line[e], 1);
          area_put(&done, flat_clip(&polygon, &wall_line[e], -1));
          flat_free(&polygon);
          polygon = kept;
        }
      }
      area_put(&done, polygon);
    }
    free(polygons->polygon);
    *polygons = done;
  }
  return polygons->count <= AREAS_MAX;
}

bool area_winding(const solid *s, const flat_base *base, const flat_polygon *polygon, const solid_plane *plane, int way,
                  long *out) {
  const int axis = greatest(plane->n);
  for (unsigned attempt = 0; attempt < 16; attempt++) {
    int64_t i, j;
    solid_wide x[3];
    if (!flat_inner(polygon, attempt, &i, &j)) {
      continue;
    }
    for (int n = 0; n < 3; n++) {  // below 2^91
      x[n] = (solid_wide)base->a[n] * ((solid_wide)1 << 60) + (solid_wide)i * base->u[n] + (solid_wide)j * base->v[n];
    }
    if (solid_winding(s, x, 60, axis, plane->n[axis] > 0 ? way : -way, plane, out)) {
      return true;
    }
  }
  return false;
}

// The same for all pieces of one triangle. pieces: how many there were so far.
static bool is_triangle_turned_one_way(const solid *s, size_t triangle, size_t *pieces, bool *decided) {
  const uint32_t *corner = s->triangle[triangle];
  const solid_plane *plane = &s->plane[triangle];
  if (plane->n[0] == 0 && plane->n[1] == 0 && plane->n[2] == 0) {
    return true;
  }
  const flat_base base = flat_base_of(s->point[corner[0]], s->point[corner[1]], s->point[corner[2]]);
  area_pile pile = {NULL, 0, 0};
  area_put(&pile, flat_triangle());
  *decided = area_split(s, &base, &pile);
  *pieces += pile.count;
  *decided = *decided && *pieces <= s->triangles + AREAS_MAX;
  bool one_way = true;
  for (size_t i = 0; i < pile.count && one_way && *decided; i++) {
    for (int way = -1; way <= 1; way += 2) {
      long winding = 0;
      *decided = *decided && area_winding(s, &base, &pile.polygon[i], plane, way, &winding);
      one_way = one_way && winding >= 0;
    }
  }
  area_clear(&pile);
  return one_way && *decided;
}

bool area_is_turned_one_way(const solid *s, size_t *triangle, bool *decided) {
  size_t pieces = 0;
  *decided = true;
  for (size_t t = 0; t < s->triangles; t++) {
    *triangle = t;
    if (!is_triangle_turned_one_way(s, t, &pieces, decided)) {
      return false;
    }
  }
  return true;
}
