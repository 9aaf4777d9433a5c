// Which feature of A - B is reported, where several hold the nearest point: the whole edge of A - B, or the end of it.
//
// Where both shapes have an edge across the direction, parts of both edges and of their sum are features too. A search ends at
// any of them, by where it begins. Each names vertices whose edges, seen from here, show which other ones there may be.
//
// A walk of two polygons with area mostly knows that none of this is needed:
//   a vertex   both ways from it lead strictly away, so no edge across the direction begins or ends there
//   an edge    it is of both shapes, and then whole; or where it begins no edge of the other shape ends in the same direction.
//              There the walk begins, or an edge of both would have joined them at the vertex before
#include "gjk2_canonical.h"

#include "gjk2_hull.h"

// Has the shape a vertex beside this one that is exactly as far along d? Pre: its vertices are in order, or two.
static bool has_level_neighbour(const gjk2_collider *c, const gjk2_support *at, gjk2_vec d) {
  gjk2_support way;
  if (c->count < 2) {
    return false;
  }
  if (!c->ordered) {
    return gjk2_hull_neighbour(c, at, true, &way) && gjk2_dot(way.offset, d) == 0;
  }
  c->shape->type->adjacent(c, at, true, &way);
  if (gjk2_dot(way.offset, d) == 0) {
    return true;
  }
  c->shape->type->adjacent(c, at, false, &way);
  return gjk2_dot(way.offset, d) == 0;
}

// Are the vertices corners in order, or the two ends of a segment? Others may lie within an edge.
static inline bool has_corners_alone(const gjk2_collider *c) {
  return c->ordered || c->count <= 2;
}

// Is the feature the whole edge, or a vertex that no edge across the direction goes on from?
static bool is_whole(const gjk2_search *s) {
  const gjk2_vec d = {s->d.x, s->d.y}, opposite = gjk2_negate(d);
  if (!has_corners_alone(s->a) || !has_corners_alone(s->b)) {
    return false;
  }
  if (s->count == 1) {  // of one shape's edge, a vertex is its end
    return !has_level_neighbour(s->a, &s->apex->a, d);
  }
  const gjk2_vertex *p = s->first, *q = s->last;
  if (p->a.vertex == q->a.vertex) {
    return !has_level_neighbour(s->a, &p->a, d);
  }
  if (p->b.vertex == q->b.vertex) {
    return !has_level_neighbour(s->b, &p->b, opposite);
  }
  const gjk2_vec of_a = gjk2_sub(q->a.offset, p->a.offset), of_b = gjk2_sub(p->b.offset, q->b.offset);
  return gjk2_dot(of_a, of_b) > 0;  // both edges run the same way
}

// The ends of a shape's edge across d, or twice its corner: the last one counterclockwise in high.
static void level_edge(const gjk2_collider *c, gjk2_vec d, gjk2_support *low, gjk2_support *high) {
  gjk2_support way;
  gjk2_hull_corner(c, d, high);
  gjk2_copy_support(low, high);
  if (c->count > 1 && gjk2_hull_neighbour(c, high, false, &way) && gjk2_dot(way.offset, d) == 0) {
    gjk2_follow(low, &way);
  }
}

void gjk2_search_canonical(gjk2_search *s) {
  if (is_whole(s)) {
    return;
  }
  const gjk2_vec d = {s->d.x, s->d.y};
  gjk2_vertex *p = s->first, *q = s->last;
  level_edge(s->a, d, &p->a, &q->a);
  level_edge(s->b, gjk2_negate(d), &p->b, &q->b);
  p->w = gjk2_add(s->delta, gjk2_sub(p->a.offset, p->b.offset));
  q->w = gjk2_add(s->delta, gjk2_sub(q->a.offset, q->b.offset));
  const gjk2_vec edge = gjk2_sub(q->w, p->w);
  if (gjk2_dot(p->w, edge) < 0 && gjk2_dot(q->w, edge) > 0) {
    s->count = 2;
    s->base = gjk2_cross(p->w, q->w);
  } else {
    gjk2_copy_vertex(s->apex, gjk2_dot(p->w, edge) < 0 ? q : p);
    s->count = 1;
    s->alone = true;
    s->base = -gjk2_dot(s->apex->w, s->apex->w);
  }
  gjk2_search_direct(s);
}
