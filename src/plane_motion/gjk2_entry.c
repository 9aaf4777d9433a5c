// Portal refinement in the plane: from an edge between vertices on both sides of a line to the edge that it enters by.
//
//   1. Support scan against the way: x is the vertex of A - B that comes first. If it lies on the line, the line enters
//      there.
//   2. Support scan across the way, to the other side of the line: if no vertex lies there, the line passes A - B.
//   3. The portal is the edge between both: p on the right of the way, q on its left, n across it against the way.
//   4. Support scan along n. If x is not strictly beyond the portal, no vertex is: the line enters here.
//   5. Otherwise x takes the place of the one on its side. A vertex on the line takes that of another on the line. On
//      from 3.
//
// Every number is exact: n is an edge turned by a quarter, and its product with t is the difference of the sides.
// Step 4 finds a vertex strictly beyond the portal, on the arc of the boundary between its ends, and the next portal
// leaves the rest of that arc on one side out. So no vertex returns, and as in gjk2_search.c there are at most n + m.
// After  Snethen 2008 (XenoCollide), whose portal in space is a triangle.
#include "gjk2_entry.h"

// Step 3: p and q are on both sides of the line, or on it, but not both on it.
//   n . t = -(side of q - side of p)
static void plane_entry_aim(const gjk2_way *way, gjk2_entry *e) {
  const gjk2_vec edge = gjk2_sub(e->q.o, e->p.o);  // |edge| <= 2^30
  e->n.x = -edge.y;
  e->n.y = edge.x;
  e->along = gjk2_way_along(way, e->n, e->p.o);
  e->closing = (uint64_t)(e->side_q - e->side_p);
  e->count = 2;
}

// The line enters at the vertex p, which lies on it. Against a way of more than 2^30 that is so only where all of A - B
// lies on the line; then its truncated direction serves as well.
static void plane_entry_at(const gjk2_way *way, gjk2_entry *e) {
  e->n = gjk2_negate(way->d);
  e->along = gjk2_way_along(way, e->n, e->p.o);
  e->closing = (uint64_t)-gjk2_way_ahead(way, e->n);
  e->count = 1;
}

// Step 2, where x on the line comes first of those that a truncated direction tells apart. Returns whether the portal
// has two ends.
static bool plane_entry_both_sides(gjk2_way *way, gjk2_entry *e) {
  gjk2_way_outermost(way, true, &e->q);
  e->side_q = gjk2_way_side(way, e->q.o);
  if (e->side_q > 0) {
    return true;
  }
  gjk2_span right;
  gjk2_way_outermost(way, false, &right);
  const int64_t side = gjk2_way_side(way, right.o);
  if (side == 0) {
    return false;
  }
  gjk2_copy_span(&e->q, &e->p);
  e->side_q = 0;
  gjk2_copy_span(&e->p, &right);
  e->side_p = side;
  return true;
}

// Steps 1 and 2. Returns the number of ends of the portal; 0: the line passes A - B.
static unsigned plane_entry_start(gjk2_way *way, gjk2_entry *e) {
  gjk2_way_scan(way, gjk2_negate(way->d), &e->p);
  e->side_p = gjk2_way_side(way, e->p.o);
  if (GJK_SHAPES <= GJK_SHAPES_POINTS) {
    return e->side_p == 0 ? 1 : 0;
  }
  if (e->side_p == 0) {
    return way->wide && plane_entry_both_sides(way, e) ? 2 : 1;
  }
  if (e->side_p < 0) {
    gjk2_way_outermost(way, true, &e->q);
    e->side_q = gjk2_way_side(way, e->q.o);
    if (e->side_q < 0) {
      gjk2_copy_span(&e->p, &e->q);
      return 0;
    }
    return 2;
  }
  gjk2_copy_span(&e->q, &e->p);
  e->side_q = e->side_p;
  gjk2_way_outermost(way, false, &e->p);
  e->side_p = gjk2_way_side(way, e->p.o);
  return e->side_p > 0 ? 0 : 2;
}

bool gjk2_entry_find(gjk2_way *way, gjk2_entry *e) {
  const unsigned ends = plane_entry_start(way, e);
  if (GJK_SHAPES <= GJK_SHAPES_POINTS || ends < 2) {
    if (ends == 1) {
      plane_entry_at(way, e);
    }
    return ends == 1;
  }
  const uint32_t most = GJK2_ITERATIONS_OF((uint32_t)way->a->count, (uint32_t)way->b->count);
  for (uint32_t i = 0; i < most; i++) {  // at most once for each corner of A - B
    gjk2_span x;
    plane_entry_aim(way, e);
    gjk2_way_scan(way, e->n, &x);  // Step 4
    if (gjk2_dot(e->n, gjk2_sub(x.o, e->p.o)) <= 0) {
      break;
    }
    const int64_t side = gjk2_way_side(way, x.o);  // Step 5
    if (side > 0 || (side == 0 && e->side_p < 0)) {
      gjk2_copy_span(&e->q, &x);
      e->side_q = side;
    } else {
      gjk2_copy_span(&e->p, &x);
      e->side_p = side;
    }
  }
  return true;
}
