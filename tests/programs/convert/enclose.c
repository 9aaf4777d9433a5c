// The check that parts enclose a solid.
#include "enclose.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "areas.h"
#include "gjk/hull.h"

static bool is_same_way(const solid_plane *a, const solid_plane *b) {
  return a->n[0] == b->n[0] && a->n[1] == b->n[1] && a->n[2] == b->n[2];
}

// Does the part lie behind the facet's plane with a facet of its own in it? Then it covers nothing beyond.
static bool is_behind(const part *p, const solid_plane *facet) {
  for (unsigned f = 0; facet != NULL && f < p->faces; f++) {
    if (is_same_way(&p->plane[f], facet) && p->plane[f].d == facet->d) {
      return true;
    }
  }
  return false;
}

// The traces of a part's planes, positive inside. Those that the whole plane satisfies are left out.
// False: the plane misses the part.
static bool traces(const flat_base *base, const part *p, flat_line *line, unsigned *lines) {
  *lines = 0;
  for (unsigned f = 0; f < p->faces; f++) {
    const flat_line trace = flat_trace(base, &p->plane[f], -1);
    if (trace.ks != 0 || trace.kt != 0) {
      line[(*lines)++] = trace;
    } else if (trace.k < 0) {
      return false;
    }
  }
  return true;
}

static flat_polygon copy_of(const flat_polygon *polygon) {
  flat_polygon copy = {solid_allocate((size_t)polygon->lines + 1, sizeof copy.line[0]), polygon->lines};
  memcpy(copy.line, polygon->line, polygon->lines * sizeof copy.line[0]);
  return copy;
}

// What of the polygon is within all lines. To be freed; no lines: nothing with area.
static flat_polygon within(const flat_polygon *polygon, const flat_line *line, unsigned lines) {
  flat_polygon rest = copy_of(polygon);
  for (unsigned i = 0; i < lines && rest.lines > 0; i++) {
    if (flat_sides(&rest, &line[i]) & FLAT_BEHIND) {
      const flat_polygon less = flat_clip(&rest, &line[i], 1);
      flat_free(&rest);
      rest = less;
    }
  }
  return rest;
}

// Cuts away what is within all lines; what is not is put onto the pile. Takes the polygon.
static void subtract(flat_polygon polygon, const flat_line *line, unsigned lines, area_pile *out) {
  flat_polygon met = within(&polygon, line, lines);
  const bool meets = met.lines > 0;
  flat_free(&met);
  if (!meets) {
    area_put(out, polygon);
    return;
  }
  for (unsigned i = 0; i < lines; i++) {
    if (flat_sides(&polygon, &line[i]) & FLAT_BEHIND) {
      const flat_polygon kept = flat_clip(&polygon, &line[i], 1);
      area_put(out, flat_clip(&polygon, &line[i], -1));
      flat_free(&polygon);
      polygon = kept;
    }
  }
  flat_free(&polygon);
}

// What of a triangle the parts leave. facet: only what they reach beyond that plane counts. The part 'own' is left out.
static void leave(const flat_base *base, const part *p, size_t parts, const solid_plane *facet, size_t own,
                  area_pile *rest) {
  area_put(rest, flat_triangle());
  for (size_t j = 0; j < parts && rest->count > 0; j++) {
    unsigned lines;
    if (j == own || solid_is_apart(p[j].low, p[j].high, base->low, base->high) || is_behind(&p[j], facet)) {
      continue;
    }
    flat_line *line = solid_allocate(p[j].faces, sizeof line[0]);
    if (traces(base, &p[j], line, &lines)) {
      area_pile less = {NULL, 0, 0};
      for (size_t i = 0; i < rest->count; i++) {
        subtract(rest->polygon[i], line, lines, &less);
      }
      free(rest->polygon);
      *rest = less;
    }
    free(line);
  }
}

static void note(enclose_report *out, const flat_base *base, const flat_polygon *polygon, long owner, const char *what,
                 size_t number) {
  if (out->enclosed) {
    snprintf(out->problem, sizeof out->problem, what, number);
    out->enclosed = false;
  }
  if (out->gaps < ENCLOSE_GAPS_MAX && polygon != NULL) {
    enclose_gap *gap = &out->gap[out->gaps++];
    gap->corner = solid_allocate(polygon->lines, sizeof gap->corner[0]);
    gap->corners = polygon->lines;
    gap->part = owner;
    for (unsigned i = 0; i < polygon->lines; i++) {
      flat_corner(base, polygon, i, gap->corner[i]);
    }
  }
}

static void check_triangles(const solid *s, const part *p, size_t parts, enclose_report *out) {
  for (size_t t = 0; t < s->triangles && out->gaps < ENCLOSE_GAPS_MAX; t++) {
    const int32_t *a = s->point[s->triangle[t][0]], *b = s->point[s->triangle[t][1]], *c = s->point[s->triangle[t][2]];
    const solid_plane *plane = &s->plane[t];
    bool covered = plane->n[0] == 0 && plane->n[1] == 0 && plane->n[2] == 0;
    for (size_t j = 0; j < parts && !covered; j++) {
      covered = part_has(&p[j], a) && part_has(&p[j], b) && part_has(&p[j], c);
    }
    if (covered) {
      continue;
    }
    const flat_base base = flat_base_of(a, b, c);
    area_pile rest = {NULL, 0, 0};
    leave(&base, p, parts, NULL, parts, &rest);
    for (size_t i = 0; i < rest.count; i++) {
      note(out, &base, &rest.polygon[i], -1, "triangle %zu of the solid is not covered", t);
    }
    area_clear(&rest);
  }
}

// Is the solid beyond a polygon of a facet? One that no triangle divides. What is not decided is not proven.
static bool is_solid_beyond(const solid *s, const flat_base *base, const flat_polygon *polygon,
                            const solid_plane *facet) {
  long winding;
  return !area_winding(s, base, polygon, facet, 1, &winding) || winding != 0;
}

static void check_facet(const solid *s, const part *p, size_t parts, size_t own, unsigned face, enclose_report *out) {
  const part *q = &p[own];
  const unsigned begin = face == 0 ? 0 : q->end[face - 1];
  for (unsigned i = begin + 1; i + 1 < q->end[face] && out->gaps < ENCLOSE_GAPS_MAX; i++) {
    const flat_base base = flat_base_of(q->point[q->corner[begin]], q->point[q->corner[i]], q->point[q->corner[i + 1]]);
    const solid_plane flat =
        solid_plane_of(q->point[q->corner[begin]], q->point[q->corner[i]], q->point[q->corner[i + 1]]);
    area_pile rest = {NULL, 0, 0};
    bool split = true;
    if (flat.n[0] != 0 || flat.n[1] != 0 || flat.n[2] != 0) {
      leave(&base, p, parts, &q->plane[face], own, &rest);
      split = area_split(s, &base, &rest);
    }
    for (size_t n = 0; n < rest.count; n++) {
      if (!split || is_solid_beyond(s, &base, &rest.polygon[n], &q->plane[face])) {
        note(out, &base, &rest.polygon[n], (long)own, "the solid goes on beyond part %zu, where no other part is", own);
      }
    }
    area_clear(&rest);
  }
}

static bool is_part_sound(const part *p) {
  if (p->points < 4 || p->points > UINT16_MAX || p->faces < 4 || p->faces > UINT16_MAX) {
    return false;
  }
  for (unsigned f = 0, begin = 0; f < p->faces; begin = p->end[f++]) {
    const solid_plane *plane = &p->plane[f];
    if (plane->n[0] == 0 && plane->n[1] == 0 && plane->n[2] == 0) {
      return false;
    }
    for (unsigned i = 0; i < p->points; i++) {
      if (solid_height(plane, p->point[i]) > 0) {
        return false;
      }
    }
    for (unsigned i = begin; i < p->end[f]; i++) {
      if (p->corner[i] >= p->points || solid_height(plane, p->point[p->corner[i]]) != 0) {
        return false;
      }
    }
  }
  for (unsigned i = 0; i < p->points; i++) {
    for (int j = 0; j < 3; j++) {
      if (p->point[i][j] < p->low[j] || p->point[i][j] > p->high[j]) {
        return false;
      }
    }
  }
  gjk_vec3 *vertex = solid_allocate(p->points, sizeof vertex[0]);
  for (unsigned i = 0; i < p->points; i++) {
    vertex[i].x = p->point[i][0];
    vertex[i].y = p->point[i][1];
    vertex[i].z = p->point[i][2];
  }
  const gjk_hull_faces faces = {p->corner, p->end, (uint16_t)p->faces};
  gjk_hull_report report;
  const bool sound =
      gjk_hull_check(vertex, (uint16_t)p->points, &faces, &report) == GJK_OK && report.fault == GJK_HULL_SOUND;
  free(vertex);
  return sound;
}

bool enclose_check(const solid *s, const part *p, size_t parts, enclose_report *out) {
  memset(out, 0, sizeof *out);
  out->enclosed = true;
  for (size_t i = 0; i < parts && out->enclosed; i++) {
    if (!is_part_sound(&p[i])) {
      snprintf(out->problem, sizeof out->problem, "part %zu is not convex and closed", i);
      out->enclosed = false;
    }
  }
  if (parts == 0) {
    snprintf(out->problem, sizeof out->problem, "there are no parts");
    out->enclosed = false;
  }
  if (!out->enclosed) {
    return false;
  }
  check_triangles(s, p, parts, out);
  for (size_t i = 0; i < parts; i++) {
    for (unsigned f = 0; f < p[i].faces && out->gaps < ENCLOSE_GAPS_MAX; f++) {
      check_facet(s, p, parts, i, f, out);
    }
  }
  return out->enclosed;
}

void enclose_free(enclose_report *report) {
  for (unsigned i = 0; i < report->gaps; i++) {
    free(report->gap[i].corner);
  }
  report->gaps = 0;
}

// A point strictly inside, times 2^4: the mean of a facet's three corners and a point off its plane.
static bool inner_point(const part *p, solid_wide out[3]) {
  for (unsigned i = 0; i < p->points; i++) {
    if (solid_height(&p->plane[0], p->point[i]) < 0) {
      for (int j = 0; j < 3; j++) {
        out[j] = 2 * (solid_wide)p->point[p->corner[0]][j] + 3 * (solid_wide)p->point[p->corner[1]][j] +
                 4 * (solid_wide)p->point[p->corner[2]][j] + 7 * (solid_wide)p->point[i][j];
      }
      for (unsigned f = 0; f < p->faces; f++) {
        const solid_plane *plane = &p->plane[f];
        if (plane->n[0] * out[0] + plane->n[1] * out[1] + plane->n[2] * out[2] >= 16 * plane->d) {
          return false;
        }
      }
      return true;
    }
  }
  return false;
}

// Is the solid on both sides of what of a triangle is within all lines?
static bool is_solid_around(const solid *s, size_t t, const flat_base *base, const flat_line *line, unsigned lines) {
  flat_polygon triangle = flat_triangle();
  area_pile pile = {NULL, 0, 0};
  area_put(&pile, within(&triangle, line, lines));
  bool around = area_split(s, base, &pile);
  for (size_t i = 0; i < pile.count && around; i++) {
    long before, behind;
    around = area_winding(s, base, &pile.polygon[i], &s->plane[t], 1, &before) && before != 0 &&
             area_winding(s, base, &pile.polygon[i], &s->plane[t], -1, &behind) && behind != 0;
  }
  area_clear(&pile);
  flat_free(&triangle);
  return around;
}

bool enclose_is_inside(const solid *s, const part *p) {
  flat_line *line = solid_allocate(p->faces, sizeof line[0]);
  bool inside = true;
  for (size_t t = 0; t < s->triangles && inside; t++) {
    const flat_base base =
        flat_base_of(s->point[s->triangle[t][0]], s->point[s->triangle[t][1]], s->point[s->triangle[t][2]]);
    const solid_plane *plane = &s->plane[t];
    unsigned lines = 0;
    bool through = !solid_is_apart(base.low, base.high, p->low, p->high) &&
                   (plane->n[0] != 0 || plane->n[1] != 0 || plane->n[2] != 0);
    for (unsigned f = 0; f < p->faces && through; f++) {
      line[lines] = flat_trace(&base, &p->plane[f], -1);
      if (line[lines].ks != 0 || line[lines].kt != 0) {
        lines++;
      } else if (line[lines].k <= 0) {
        through = false;  // in the facet's plane, or beyond it
      }
    }
    if (through) {
      inside = is_solid_around(s, t, &base, line, lines);
    }
  }
  free(line);
  solid_wide x[3];
  long winding = 0;
  // A point on the surface will do as well: there the solid is on both sides, as every triangle above.
  return inside && inner_point(p, x) && (!solid_winding(s, x, 4, 0, 1, NULL, &winding) || winding != 0);
}
