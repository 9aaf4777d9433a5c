// Fewer corners around the same points of the plane: edges are removed, those first whose neighbours meet nearest.
//
//   1. Find the hull of the points, and keep it. If it has few enough corners, stop.
//   2. For each edge find a corner in place of both of its ends: beyond or on the line of the edge and of both neighbours,
//      near where these meet. Its cost is its distance from the hull of the points.
//   3. Remove the cheapest edge, and others that cost little more and are no neighbours of a removed one. Find the hull of
//      what is left. On from 2 while there are too many corners.
//   4. Take the bounding box where it is nearer, or no edge can be removed.
//   5. Test that no corner of the hull of the points is beyond an edge.
//
// Why the hull after step 3 holds the one before: a direction along which an old corner is farthest lies between the normals
// of its edges. The corner in its place is at least as far along both of these.
//
// Of five edges or more two neighbours turn by less than half a turn together, so that one can be removed.
//
// Bounds: points are at most 2 GJK2_RADIUS_MAX < 2^29 apart along each axis, and so are new corners. Ways are below 2^30, so
// cross products below 2^61.
#include "gjk2/hull.h"

#include "../arith/gjk_root.h"
#include "../arith/gjk_unit.h"
#include "gjk2_vector.h"

#define NO_COST UINT32_MAX

// The foot on an edge is off by at most so many LSB: by its direction, off by 2^-30, and by the rounding of its place.
#define FOOT_ROUNDING 2u

typedef struct outline_work {
  gjk2_vec *corner;      // of what is left, counterclockwise
  const gjk2_vec *hull;  // of the points
  uint16_t count, hull_count;
  gjk2_vec lower, upper;  // where corners may be
} outline_work;

static gjk_unit3 direction_of(gjk2_vec edge) {
  const gjk_vec3 d = {edge.x, edge.y, 0};
  return gjk_unit(&d);
}

// The whole steps of a way of so many LSB.
static gjk2_vec steps_along(const gjk_unit3 *u, int32_t length) {
  const gjk2_vec way = {(int32_t)gjk_sar64(gjk_mul32(u->x, length) + GJK_Q30_ONE / 2, 30),
                        (int32_t)gjk_sar64(gjk_mul32(u->y, length) + GJK_Q30_ONE / 2, 30)};
  return way;
}

static uint32_t rounded_length(gjk2_vec d) {
  const uint64_t squared = (uint64_t)gjk2_dot(d, d);
  const uint32_t root = gjk_isqrt64(squared);
  return gjk_umul32(root, root) == squared ? root : root + 1;
}

// A bound of p's distance from an edge, never too small.
static uint32_t distance_of_edge(gjk2_vec from, gjk2_vec to, gjk2_vec p) {
  const gjk2_vec edge = gjk2_sub(to, from), way = gjk2_sub(p, from), back = gjk2_sub(p, to);
  if (gjk2_dot(edge, way) <= 0) {
    return rounded_length(way);
  }
  if (gjk2_dot(edge, back) >= 0) {
    return rounded_length(back);
  }
  const gjk_unit3 u = direction_of(edge);
  const int64_t along = gjk_mac32(gjk_mul32(u.x, way.x), u.y, way.y);
  const gjk2_vec foot = steps_along(&u, (int32_t)gjk_sar64(along, 30));
  return rounded_length(gjk2_sub(way, foot)) + FOOT_ROUNDING;
}

// A bound of p's distance from the hull of the points. The nearest edge has p on its right.
static uint32_t distance_of_hull(const outline_work *w, gjk2_vec p) {
  uint32_t least = NO_COST;
  for (uint32_t i = 0; i < w->hull_count; i++) {
    const gjk2_vec from = w->hull[i], to = w->hull[i + 1u < w->hull_count ? i + 1u : 0];
    if (gjk2_cross(gjk2_sub(to, from), gjk2_sub(p, from)) < 0) {
      const uint32_t own = distance_of_edge(from, to, p);
      least = own < least ? own : least;
    }
  }
  return least == NO_COST ? 0 : least;
}

// Three edges in a row: the vectors along them, of which the middle one is to be removed.
typedef struct edge_row {
  gjk2_vec before, own, after;
} edge_row;

// Is a place beyond or on the lines of all three? r: from where the last one begins.
static bool is_beyond_row(const edge_row *e, gjk2_vec r) {
  return gjk2_cross(e->before, gjk2_add(r, e->own)) <= 0 && gjk2_cross(e->own, r) <= 0 && gjk2_cross(e->after, r) <= 0;
}

// Step 2: where the neighbours of an edge meet, rounded outwards. *r: from where the last one begins. False: nowhere near.
static bool find_meeting(const edge_row *e, gjk2_vec *r) {
  const gjk_unit3 u = direction_of(e->before);
  int32_t length = 0;
  for (int32_t bit = INT32_C(1) << 28; bit > 0; bit >>= 1) {  // the most that does not reach the last line
    const gjk2_vec way = gjk2_sub(steps_along(&u, length + bit), e->own);
    length += gjk2_cross(e->after, way) > 0 ? bit : 0;
  }
  for (int32_t more = 1; more < INT32_C(1) << 28; more *= 2) {
    const gjk2_vec at = gjk2_sub(steps_along(&u, length + more), e->own);
    for (int32_t i = -1; i <= 1; i++) {  // there and around
      for (int32_t j = -1; j <= 1; j++) {
        r->x = at.x + i;
        r->y = at.y + j;
        if (is_beyond_row(e, *r)) {
          return true;
        }
      }
    }
  }
  return false;
}

static bool is_in_room(const outline_work *w, int64_t x, int64_t y) {
  return x >= w->lower.x && x <= w->upper.x && y >= w->lower.y && y <= w->upper.y;
}

// The corner in place of edge i, and its cost. NO_COST: there is none.
static uint32_t replace_edge(const outline_work *w, uint32_t i, gjk2_vec *corner) {
  const uint32_t n = w->count, next = i + 1 < n ? i + 1 : 0;
  const gjk2_vec a = w->corner[i > 0 ? i - 1 : n - 1], b = w->corner[i], c = w->corner[next];
  const edge_row e = {gjk2_sub(b, a), gjk2_sub(c, b), gjk2_sub(w->corner[next + 1 < n ? next + 1 : 0], c)};
  gjk2_vec r;
  if (gjk2_cross(e.before, e.after) <= 0 || !find_meeting(&e, &r)) {
    return NO_COST;
  }
  const int64_t x = (int64_t)c.x + r.x, y = (int64_t)c.y + r.y;
  if (!is_in_room(w, x, y)) {
    return NO_COST;
  }
  corner->x = (int32_t)x;
  corner->y = (int32_t)y;
  return distance_of_hull(w, *corner);
}

static uint32_t cheapest_edge(const outline_work *w) {
  uint32_t cheapest = NO_COST;
  gjk2_vec corner = {0, 0};
  for (uint32_t i = 0; i < w->count; i++) {
    const uint32_t cost = replace_edge(w, i, &corner);
    cheapest = cost < cheapest ? cost : cheapest;
  }
  return cheapest;
}

// Step 3: removes edges that cost at most limit, at most so many. The corner that an edge ends at stays for the neighbours'
// sake: the hull of what is left drops it.
static void remove_edges(outline_work *w, uint32_t limit, uint32_t most) {
  uint32_t removed = 0;
  gjk2_vec corner = {0, 0};
  for (uint32_t i = 0; i < w->count && removed < most; i++) {
    if (removed > 0 && i + 2 >= w->count) {
      return;  // a neighbour of the first one, perhaps
    }
    if (replace_edge(w, i, &corner) <= limit) {
      gjk2_copy(&w->corner[i], &corner);
      removed++;
      i++;
    }
  }
}

// Steps 2 and 3. False: no edge can be removed, and too many are left.
static bool remove_until(outline_work *w, uint16_t most) {
  gjk2_hull hull;
  while (w->count > most) {  // each time at least one corner less
    const uint32_t cheapest = cheapest_edge(w), extra = (uint32_t)w->count - most;
    if (cheapest == NO_COST) {
      return false;
    }
    remove_edges(w, extra > 8 ? cheapest + cheapest / 4 : cheapest, extra > 8 ? extra / 2 : 1);
    (void)gjk2_hull_build(w->corner, w->count, w->corner, &hull);  // it fits: all are within the room
    w->count = hull.vertices;
  }
  return true;
}

static uint32_t largest_distance(const outline_work *w, const gjk2_vec *corner, uint32_t count) {
  uint32_t most = 0;
  for (uint32_t i = 0; i < count; i++) {
    const uint32_t own = distance_of_hull(w, corner[i]);
    most = own > most ? own : most;
  }
  return most;
}

// The box around the hull, and where corners may be: so that all are at most 2 GJK2_RADIUS_MAX apart, and within int32.
static void set_outline_room(outline_work *w, gjk2_vec box[4]) {
  gjk2_vec low = w->hull[0], high = w->hull[0];
  for (uint32_t i = 1; i < w->hull_count; i++) {
    low.x = w->hull[i].x < low.x ? w->hull[i].x : low.x;
    low.y = w->hull[i].y < low.y ? w->hull[i].y : low.y;
    high.x = w->hull[i].x > high.x ? w->hull[i].x : high.x;
    high.y = w->hull[i].y > high.y ? w->hull[i].y : high.y;
  }
  const int64_t most = 2 * (int64_t)GJK2_RADIUS_MAX, lowest = INT32_MIN, highest = INT32_MAX;
  const int64_t x = gjk_sar64(most - ((int64_t)high.x - low.x), 1), y = gjk_sar64(most - ((int64_t)high.y - low.y), 1);
  w->lower.x = (int32_t)(low.x - x < lowest ? lowest : low.x - x);
  w->lower.y = (int32_t)(low.y - y < lowest ? lowest : low.y - y);
  w->upper.x = (int32_t)(high.x + x > highest ? highest : high.x + x);
  w->upper.y = (int32_t)(high.y + y > highest ? highest : high.y + y);
  gjk2_copy(&box[0], &low);
  box[1].x = high.x;
  box[1].y = low.y;
  gjk2_copy(&box[2], &high);
  box[3].x = low.x;
  box[3].y = high.y;
}

// Step 5.
static bool holds_hull(const outline_work *w) {
  for (uint32_t i = 0; i < w->count; i++) {
    const gjk2_vec from = w->corner[i], edge = gjk2_sub(w->corner[i + 1u < w->count ? i + 1u : 0], from);
    for (uint32_t j = 0; j < w->hull_count; j++) {
      if (gjk2_cross(edge, gjk2_sub(w->hull[j], from)) < 0) {
        return false;  // not reached: the steps above hold all
      }
    }
  }
  return w->count >= 3;
}

gjk_status gjk2_hull_simplify(const gjk2_vec *points, uint16_t count, uint16_t most, gjk2_vec *vertices,
                              gjk2_hull_simple *out) {
  if (points == NULL || vertices == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  if (most < GJK2_HULL_SIMPLE_MIN) {
    return GJK_ERROR_RANGE;
  }
  gjk2_hull hull;
  const gjk_status status = gjk2_hull_build(points, count, vertices, &hull);
  if (status != GJK_OK) {
    return status;
  }
  out->vertices = hull.vertices;
  out->excess = 0;
  if (hull.vertices <= most) {
    return GJK_OK;
  }
  outline_work w = {vertices, vertices + count, hull.vertices, hull.vertices, {0, 0}, {0, 0}};
  gjk2_vec box[4];
  for (uint32_t i = 0; i < hull.vertices; i++) {
    gjk2_copy(&vertices[count + i], &vertices[i]);
  }
  set_outline_room(&w, box);
  const bool fewer = remove_until(&w, most);
  const uint32_t own = fewer ? largest_distance(&w, w.corner, w.count) : NO_COST, of_box = largest_distance(&w, box, 4);
  if (of_box < own) {
    for (uint32_t i = 0; i < 4; i++) {
      gjk2_copy(&w.corner[i], &box[i]);
    }
    w.count = 4;
  }
  if (!holds_hull(&w)) {
    return GJK_ERROR_UNPROVEN;  // not reached: the steps above hold all
  }
  out->vertices = w.count;
  out->excess = of_box < own ? of_box : own;
  return GJK_OK;
}
