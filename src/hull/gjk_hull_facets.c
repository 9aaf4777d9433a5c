// The facets of a hull: a walk along the outline of each, by edges that no coplanar triangle is across.
#include "gjk_hull_facets.h"

void gjk_hull_work_of_hull(const gjk_hull *hull, gjk_hull_work *out) {
  const gjk_hull_work w = gjk_hull_work_of(hull->points, hull->workspace, hull->count);
  out->points = w.points;
  out->triangle = w.triangle;
  out->of = w.of;
  out->order = w.order;
  out->next = w.next;
  out->distinct = hull->distinct;
  out->triangles = hull->triangles;
  out->free = w.free;
}

static bool is_side_flat(const gjk_hull_triangle *t, unsigned i) {
  return (t->flags & (unsigned)GJK_HULL_FLAT << i) != 0;
}

// Marks the sides in the same plane: a neighbour is in it if its third corner is.
static void mark_flat_sides(gjk_hull_work *w, uint32_t at) {
  gjk_hull_triangle *t = &w->triangle[at];
  gjk_hull_plane plane;
  gjk_hull_set_plane(w, t, &plane);
  for (unsigned i = 0; i < 3; i++) {
    const gjk_hull_triangle *side = &w->triangle[gjk_hull_side(t, i)];
    const unsigned third = gjk_next(gjk_next(gjk_hull_edge_to(side, t->vertex[i])));
    if (gjk_hull_height_sign(&plane, gjk_hull_point(w, side->vertex[third])) == 0) {
      t->flags = (uint16_t)(t->flags | (unsigned)GJK_HULL_FLAT << i);
    }
  }
}

// Numbers the extreme points. At a point within a facet no edge of a facet begins, within an edge 2, at others more.
static void number_extreme(gjk_hull_work *w, gjk_hull *out) {
  out->vertices = 0;
  out->corners = 0;
  for (uint32_t point = 0; point < w->distinct; point++) {
    w->next[point] = GJK_HULL_NO_POINT;
    if (w->of[point] >= 3) {
      w->next[point] = out->vertices++;
      out->corners += w->of[point];  // each edge between facets begins at both of its ends
    }
  }
  out->edges = out->corners / 2;
  out->faces = out->edges + 2 - out->vertices;  // Euler
}

// The edge between facets that follows e around its facet: around the vertex where e ends, across flat edges.
static gjk_hull_edge next_outline_edge(const gjk_hull_work *w, gjk_hull_edge e) {
  const gjk_hull_triangle *t = &w->triangle[e.triangle];
  const unsigned i = gjk_next(e.number);
  gjk_hull_edge next = {e.triangle, i};
  while (is_side_flat(t, next.number)) {  // ends: at most once for each triangle at the vertex
    const uint16_t vertex = t->vertex[next.number];
    next.triangle = gjk_hull_side(t, next.number);
    t = &w->triangle[next.triangle];
    next.number = gjk_next(gjk_hull_edge_to(t, vertex));
  }
  return next;
}

bool gjk_hull_next_facet(gjk_hull_work *w, gjk_hull_facet *facet) {
  for (; facet->triangle < w->triangles; facet->triangle++) {
    for (unsigned i = 0; i < 3; i++) {
      const gjk_hull_triangle *t = &w->triangle[facet->triangle];
      const unsigned written = (unsigned)GJK_HULL_WRITTEN << i;
      if ((t->flags & (GJK_HULL_SEEN | written)) == 0 && !is_side_flat(t, i) &&
          w->next[t->vertex[i]] != GJK_HULL_NO_POINT) {
        facet->first.triangle = facet->triangle;
        facet->first.number = i;
        facet->edge = facet->first;
        facet->done = false;
        return true;
      }
    }
  }
  return false;
}

bool gjk_hull_next_corner(gjk_hull_work *w, gjk_hull_facet *facet, uint16_t *vertex) {
  while (!facet->done) {  // ends: each edge of the facet once
    gjk_hull_triangle *t = &w->triangle[facet->edge.triangle];
    const uint16_t number = w->next[t->vertex[facet->edge.number]];
    t->flags = (uint16_t)(t->flags | (unsigned)GJK_HULL_WRITTEN << facet->edge.number);
    facet->edge = next_outline_edge(w, facet->edge);
    facet->done = facet->edge.triangle == facet->first.triangle && facet->edge.number == facet->first.number;
    if (number != GJK_HULL_NO_POINT) {
      *vertex = number;
      return true;
    }
  }
  return false;
}

void gjk_hull_clear_facets(gjk_hull_work *w) {
  for (uint32_t at = 0; at < w->triangles; at++) {
    w->triangle[at].flags &= (uint16_t)(GJK_HULL_WRITTEN - 1u);
  }
}

// The most corners of a facet.
static uint16_t most_facet_corners(gjk_hull_work *w) {
  gjk_hull_facet facet = {0, {0, 0}, {0, 0}, true};
  uint16_t most = 0, vertex;
  gjk_hull_clear_facets(w);
  while (gjk_hull_next_facet(w, &facet)) {  // each facet once
    uint16_t corners = 0;
    while (gjk_hull_next_corner(w, &facet, &vertex)) {  // each corner once
      corners++;
    }
    most = corners > most ? corners : most;
  }
  return most;
}

void gjk_hull_join(gjk_hull_work *w, gjk_hull *out) {
  for (uint32_t point = 0; point < w->distinct; point++) {
    w->of[point] = 0;  // how many edges between facets begin at it
  }
  for (uint32_t at = 0; at < w->triangles; at++) {
    if ((w->triangle[at].flags & GJK_HULL_SEEN) != 0) {
      continue;
    }
    mark_flat_sides(w, at);
    const gjk_hull_triangle *t = &w->triangle[at];
    for (unsigned i = 0; i < 3; i++) {
      w->of[t->vertex[i]] += is_side_flat(t, i) ? 0u : 1u;
    }
  }
  number_extreme(w, out);
  out->most_corners = most_facet_corners(w);
}
