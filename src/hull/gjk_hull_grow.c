// Quickhull. The steps are told in gjk_hull_grow.h.
#include "gjk_hull_grow.h"

gjk_hull_work gjk_hull_work_of(const gjk_vec3 *points, void *workspace, uint32_t count) {
  gjk_hull_work w;
  w.points = points;
  w.triangle = (gjk_hull_triangle *)workspace;
  w.of = (uint32_t *)(void *)(w.triangle + 2 * (size_t)count);
  w.order = (uint16_t *)(void *)(w.of + count);
  w.next = w.order + count;
  w.distinct = count;
  w.triangles = 0;
  w.free = GJK_HULL_NO_LINK;
  return w;
}

bool gjk_hull_fits(const gjk_vec3 *points, uint32_t count) {
  gjk_vec3 lower = points[0], upper = points[0];
  for (uint32_t i = 1; i < count; i++) {
    const gjk_vec3 *p = &points[i];
    lower.x = p->x < lower.x ? p->x : lower.x;
    lower.y = p->y < lower.y ? p->y : lower.y;
    lower.z = p->z < lower.z ? p->z : lower.z;
    upper.x = p->x > upper.x ? p->x : upper.x;
    upper.y = p->y > upper.y ? p->y : upper.y;
    upper.z = p->z > upper.z ? p->z : upper.z;
  }
  const int64_t most = 2 * (int64_t)GJK_RADIUS_MAX;
  return (int64_t)upper.x - lower.x <= most && (int64_t)upper.y - lower.y <= most && (int64_t)upper.z - lower.z <= most;
}

void gjk_hull_set_plane(const gjk_hull_work *w, const gjk_hull_triangle *t, gjk_hull_plane *out) {
  out->at = gjk_hull_point(w, t->vertex[0]);
  gjk_triangle_normal(out->at, gjk_hull_point(w, t->vertex[1]), gjk_hull_point(w, t->vertex[2]), &out->n);
}

static void set_triangle_side(gjk_hull_triangle *t, unsigned i, uint32_t side) {
  t->side[i] = (uint16_t)(side & 0xFFFFu);
  t->flags = (uint16_t)((t->flags & ~(1u << i)) | (side >> 16) << i);
}

static void place_triangle(gjk_hull_work *w, uint32_t at, uint16_t a, uint16_t b, uint16_t c) {
  gjk_hull_triangle *t = &w->triangle[at];
  t->vertex[0] = a;
  t->vertex[1] = b;
  t->vertex[2] = c;
  t->outside = GJK_HULL_NO_POINT;
  t->flags = 0;
}

// Step 4 for one triangle: moves the points of a list that lie beyond it to its own, the farthest one first.
static void take_points_beyond(gjk_hull_work *w, uint32_t at, uint16_t *list) {
  gjk_hull_triangle *t = &w->triangle[at];
  gjk_hull_plane plane;
  gjk_hull_set_plane(w, t, &plane);
  int64_t most = 0;
  for (uint16_t *link = list; *link != GJK_HULL_NO_POINT;) {  // each point of the list once
    const uint16_t point = *link;
    uint32_t low;
    const int64_t height = gjk_hull_height(&plane, gjk_hull_point(w, point), &low);
    if (height < 0 || (height == 0 && low == 0)) {
      link = &w->next[point];
      continue;
    }
    *link = w->next[point];
    w->of[point] = at;
    if (t->outside == GJK_HULL_NO_POINT || height > most) {
      most = height;
      w->next[point] = t->outside;
      t->outside = point;
    } else {
      w->next[point] = w->next[t->outside];
      w->next[t->outside] = point;
    }
  }
}

// The points of a list lie beyond no triangle.
static void drop_points_inside(gjk_hull_work *w, uint16_t list) {
  for (; list != GJK_HULL_NO_POINT; list = w->next[list]) {  // each point of the list once
    w->of[list] = GJK_HULL_NO_TRIANGLE;
  }
}

// The triangles that a point sees, linked by their field outside and a bit of flags.
typedef struct seen_list {
  uint32_t first, last;
  uint16_t points;  // what their lists held
  uint16_t start;   // a vertex of the horizon
} seen_list;

static uint32_t link_of(const gjk_hull_triangle *t) {
  return t->outside | ((t->flags & GJK_HULL_LINK_HIGH) != 0 ? UINT32_C(1) << 16 : 0);
}

static void set_link(gjk_hull_triangle *t, uint32_t link) {
  t->outside = (uint16_t)(link & 0xFFFFu);
  t->flags = (uint16_t)((t->flags & ~(unsigned)GJK_HULL_LINK_HIGH) | (link >> 16) * GJK_HULL_LINK_HIGH);
}

// Marks a triangle as seen, and adds its points to those that lost theirs.
static void see(gjk_hull_work *w, uint32_t at, seen_list *seen) {
  gjk_hull_triangle *t = &w->triangle[at], *last = &w->triangle[seen->last];
  if (t->outside != GJK_HULL_NO_POINT) {
    uint16_t end = t->outside;
    while (w->next[end] != GJK_HULL_NO_POINT) {  // each point of the list once
      end = w->next[end];
    }
    w->next[end] = seen->points;
    seen->points = t->outside;
  }
  t->flags |= GJK_HULL_SEEN;
  set_link(last, at);
  seen->last = at;
}

// Step 2. For each edge of the horizon, w->of of the vertex where it begins becomes the triangle beyond it. That is free:
// a vertex is in no list.
static void find_seen(gjk_hull_work *w, uint16_t point, seen_list *seen) {
  const gjk_vec3 *p = gjk_hull_point(w, point);
  for (uint32_t at = seen->first;; at = link_of(&w->triangle[at])) {  // each seen triangle once
    const gjk_hull_triangle *t = &w->triangle[at];
    for (unsigned i = 0; i < 3; i++) {
      const uint32_t side = gjk_hull_side(t, i);
      if ((w->triangle[side].flags & GJK_HULL_SEEN) != 0) {
        continue;
      }
      gjk_hull_plane plane;
      gjk_hull_set_plane(w, &w->triangle[side], &plane);
      if (gjk_hull_height_sign(&plane, p) > 0) {
        see(w, side, seen);
      } else {
        w->of[t->vertex[i]] = side;
        seen->start = t->vertex[i];
      }
    }
    if (at == seen->last) {
      return;
    }
  }
}

// A triangle for use: a free one, or a new one.
static uint32_t take_place(gjk_hull_work *w) {
  const uint32_t at = w->free;
  if (at == GJK_HULL_NO_LINK) {
    return w->triangles++;
  }
  w->free = link_of(&w->triangle[at]);
  return at;
}

// Step 3: triangles around the point, along the horizon from seen->start. Those that were seen become free: their place
// is taken first. Returns the first new one.
static uint32_t close_horizon(gjk_hull_work *w, uint16_t point, const seen_list *seen) {
  uint32_t first = GJK_HULL_NO_TRIANGLE, before = GJK_HULL_NO_TRIANGLE;
  uint16_t a = seen->start;
  set_link(&w->triangle[seen->last], w->free);
  w->free = seen->first;
  do {  // once for each edge of the horizon
    const uint32_t beyond = w->of[a];
    const unsigned edge = gjk_hull_edge_to(&w->triangle[beyond], a);
    const uint16_t b = w->triangle[beyond].vertex[edge];
    const uint32_t at = take_place(w);
    w->of[a] = GJK_HULL_NO_TRIANGLE;
    place_triangle(w, at, a, b, point);
    set_triangle_side(&w->triangle[at], 0, beyond);
    set_triangle_side(&w->triangle[beyond], edge, at);
    if (before == GJK_HULL_NO_TRIANGLE) {
      first = at;
    } else {
      set_triangle_side(&w->triangle[at], 2, before);
      set_triangle_side(&w->triangle[before], 1, at);
    }
    before = at;
    a = b;
  } while (a != seen->start);
  set_triangle_side(&w->triangle[first], 2, before);
  set_triangle_side(&w->triangle[before], 1, first);
  return first;
}

// Steps 1 to 4 for the list of one triangle.
static void add_farthest(gjk_hull_work *w, uint32_t at) {
  const uint16_t point = w->triangle[at].outside;
  seen_list seen = {at, at, GJK_HULL_NO_POINT, 0};
  w->triangle[at].outside = w->next[point];  // Step 1
  w->of[point] = GJK_HULL_NO_TRIANGLE;
  see(w, at, &seen);
  find_seen(w, point, &seen);
  const uint32_t first = close_horizon(w, point, &seen);
  uint32_t around = first;
  do {  // once for each new triangle
    take_points_beyond(w, around, &seen.points);
    around = gjk_hull_side(&w->triangle[around], 1);
  } while (around != first && seen.points != GJK_HULL_NO_POINT);
  drop_points_inside(w, seen.points);
}

void gjk_hull_grow(gjk_hull_work *w, const uint16_t corner[4]) {
  // Triangles of a tetrahedron by their corners, and what is across their edges.
  static const uint8_t corners[4][3] = {{0, 1, 2}, {1, 0, 3}, {2, 1, 3}, {0, 2, 3}};
  static const uint8_t across[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  uint16_t rest = GJK_HULL_NO_POINT;
  for (uint32_t i = w->distinct; i > 0; i--) {
    const uint16_t point = (uint16_t)(i - 1);
    w->of[point] = GJK_HULL_NO_TRIANGLE;
    if (point != corner[0] && point != corner[1] && point != corner[2] && point != corner[3]) {
      w->next[point] = rest;
      rest = point;
    }
  }
  for (uint32_t t = 0; t < 4; t++) {
    place_triangle(w, t, corner[corners[t][0]], corner[corners[t][1]], corner[corners[t][2]]);
    for (unsigned i = 0; i < 3; i++) {
      set_triangle_side(&w->triangle[t], i, across[t][i]);
    }
  }
  w->triangles = 4;
  w->free = GJK_HULL_NO_LINK;
  for (uint32_t t = 0; t < 4; t++) {
    take_points_beyond(w, t, &rest);
  }
  drop_points_inside(w, rest);
  for (uint32_t point = 0; point < w->distinct; point++) {
    while (w->of[point] != GJK_HULL_NO_TRIANGLE) {  // each time a point of its list becomes a vertex
      add_farthest(w, w->of[point]);
    }
  }
}
