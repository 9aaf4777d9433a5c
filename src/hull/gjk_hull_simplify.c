// Fewer vertices around the same points: neighbours are joined to a vertex beyond the planes around both.
//
//   1. Find the hull of what is left, and drop what is within it. If few enough vertices are left, stop.
//   2. For each edge from a to b find the way out from its middle along the mean normal of the triangles at a and b, until
//      it is beyond all their planes. A vertex keeps the edge that gives the least excess.
//   3. Join the edges that both of their ends keep: the cheapest one always is among them. On from 1.
//   4. If there is none, or the excess is larger than that of a box, take a box or a tetrahedron around all points.
//   5. Test that no point is beyond a plane of the result.
//
// Why the hull after step 3 holds the one before. Suppose that it does not, and let h be a direction along which the old
// one reaches farther. Its farthest vertex w along h was joined, since else it still reaches as far. Along h, w is
// farthest, so h is a sum of the normals of the triangles at w, with weights of at least 0. The vertex v that replaces w is
// beyond or on each of their planes, so it is at least as far along h. That holds for many joined edges at once.
//
// Excess: a vertex keeps how far it is at most from the first hull. The middle of an edge is no farther from it than the
// farther one of the ends, since the distance from a convex set is a convex function.
#include "gjk_hull_facets.h"

#include "../arith/gjk_root.h"
#include "../arith/gjk_unit.h"

// What a step outwards gains at least along each normal, Q30: 1/32. Less, and edges count as not to be joined.
#define LEAST_RISE (GJK_Q30_ONE / 32)

// Added to a vertex's way for the rounding of its coordinates, LSB: the middle's and its own, each at most sqrt(3) / 2.
#define ROUNDING 2u

#define NO_EXCESS UINT32_MAX

typedef struct simple_work {
  void *hull;  // workspace of the hull
  size_t bytes;
  gjk_vec3 *vertex, *other;  // what is left, and room for as many
  uint32_t *excess, *other_excess;
  uint32_t *cost;         // of the edge that a vertex keeps, or NO_EXCESS
  uint16_t *partner;      // its other end
  uint16_t count;         // of vertex
  gjk_vec3 lower, upper;  // where vertices may be
  gjk_hull_work triangles;
} simple_work;

static void set_point(gjk_vec3 *to, int64_t x, int64_t y, int64_t z) {
  to->x = (int32_t)x;
  to->y = (int32_t)y;
  to->z = (int32_t)z;
}

// Step 1. Sorts what is left, with its excess, by coordinates. Pre: there are at most as many as there were points.
static void rebuild(simple_work *s, gjk_hull *hull) {
  for (unsigned pass = 0; pass < 2; pass++) {  // with the points within dropped, all are extreme
    (void)gjk_hull_build(s->vertex, s->count, s->hull, s->bytes, hull);
    gjk_hull_work_of_hull(hull, &s->triangles);
    const gjk_hull_work *w = &s->triangles;
    uint16_t kept = 0;
    for (uint32_t point = 0; point < w->distinct; point++) {
      if (hull->dimension < 2 || w->next[point] != GJK_HULL_NO_POINT) {
        gjk_set(gjk_hull_point(w, point), &s->other[kept]);
        s->other_excess[kept++] = s->excess[w->order[point]];
      }
    }
    s->count = kept;
    for (uint32_t i = 0; i < kept; i++) {
      gjk_set(&s->other[i], &s->vertex[i]);
      s->excess[i] = s->other_excess[i];
    }
  }
}

// Goes to the next triangle around a vertex of *e, where the edge *e begins.
static void next_around(const gjk_hull_work *w, gjk_hull_edge *e) {
  const gjk_hull_triangle *t = &w->triangle[e->triangle];
  const uint16_t vertex = t->vertex[e->number];
  e->triangle = gjk_hull_side(t, e->number);
  e->number = gjk_next(gjk_hull_edge_to(&w->triangle[e->triangle], vertex));
}

// The plane of a triangle, and its normal as a unit.
static gjk_unit3 unit_of(const gjk_hull_work *w, uint32_t triangle, gjk_hull_plane *plane) {
  gjk_search_direction d;
  gjk_hull_set_plane(w, &w->triangle[triangle], plane);
  gjk_search_direction_of(&plane->n, &d);
  const gjk_vec3 up = gjk_scale_direction(&d.d);
  return gjk_unit(&up);
}

// The way out of an edge.
typedef struct way_out {
  gjk_vec3 middle;
  gjk_unit3 along;
  uint32_t length;
} way_out;

// Adds the normals of the triangles at a vertex: fewer than 2^17, so the sums are below 2^47.
static void add_normals(const gjk_hull_work *w, gjk_hull_edge e, gjk_long3 *sum) {
  const uint32_t first = e.triangle;
  do {  // once for each triangle at the vertex
    gjk_hull_plane plane;
    const gjk_unit3 u = unit_of(w, e.triangle, &plane);
    sum->x += u.x;
    sum->y += u.y;
    sum->z += u.z;
    next_around(w, &e);
  } while (e.triangle != first);
}

// The least t with rise t >= depth, or NO_EXCESS where it is 2^30 or more. Pre: rise > 0, both Q30.
static uint32_t least_way(int64_t depth, gjk_q30 rise) {
  uint32_t t = 0;
  for (uint32_t bit = UINT32_C(1) << 29; bit > 0; bit >>= 1) {
    if (gjk_mul32(rise, (int32_t)(t + bit)) < depth) {
      t += bit;
    }
  }
  return t == (UINT32_C(1) << 30) - 1 ? NO_EXCESS : t + 1;
}

// Makes the way long enough for the planes at a vertex, as far as roundings let it be known. False: it leads nowhere.
static bool lengthen(const gjk_hull_work *w, gjk_hull_edge e, way_out *way) {
  const uint32_t first = e.triangle;
  const gjk_vec3 along = {way->along.x, way->along.y, way->along.z};
  do {  // once for each triangle at the vertex
    gjk_hull_plane plane;
    const gjk_unit3 u = unit_of(w, e.triangle, &plane);
    const gjk_vec3 below = gjk_sub(*plane.at, way->middle);
    const int64_t rise = gjk_along(&u, &along);  // Q60
    // The plane's height over the middle, and 4 LSB for roundings: of u and of the vertex.
    const int64_t depth = gjk_along(&u, &below) + 4 * (int64_t)GJK_Q30_ONE;
    if (rise < (int64_t)LEAST_RISE * GJK_Q30_ONE) {
      return false;
    }
    const uint32_t length = least_way(depth, (gjk_q30)gjk_sar64(rise, 30));
    if (length == NO_EXCESS) {
      return false;
    }
    way->length = length > way->length ? length : way->length;
    next_around(w, &e);
  } while (e.triangle != first);
  return true;
}

// Is p beyond or on all planes at a vertex?
static bool is_beyond_all(const gjk_hull_work *w, gjk_hull_edge e, const gjk_vec3 *p) {
  const uint32_t first = e.triangle;
  do {  // once for each triangle at the vertex
    gjk_hull_plane plane;
    gjk_hull_set_plane(w, &w->triangle[e.triangle], &plane);
    if (gjk_hull_height_sign(&plane, p) < 0) {
      return false;
    }
    next_around(w, &e);
  } while (e.triangle != first);
  return true;
}

static bool is_within_room(const simple_work *s, int64_t x, int64_t y, int64_t z) {
  return x >= s->lower.x && x <= s->upper.x && y >= s->lower.y && y <= s->upper.y && z >= s->lower.z && z <= s->upper.z;
}

static int64_t step_along(int32_t from, gjk_q30 along, uint32_t length) {
  return from + gjk_sar64(gjk_mul32(along, (int32_t)length) + GJK_Q30_ONE / 2, 30);
}

// Step 2 for the edge e from a: the vertex that replaces both ends, and its excess. NO_EXCESS: there is none.
static uint32_t join_edge(const simple_work *s, gjk_hull_edge e, gjk_vec3 *vertex) {
  const gjk_hull_work *w = &s->triangles;
  const gjk_hull_triangle *t = &w->triangle[e.triangle];
  const gjk_hull_edge at_b = {e.triangle, gjk_next(e.number)};
  const uint16_t i = w->order[t->vertex[e.number]], j = w->order[t->vertex[at_b.number]];
  const gjk_vec3 *a = &s->vertex[i], *b = &s->vertex[j];
  gjk_long3 sum = {0, 0, 0};
  gjk_search_direction d;
  way_out way;
  add_normals(w, e, &sum);
  add_normals(w, at_b, &sum);
  gjk_search_direction_of(&sum, &d);
  if (gjk_norm1(d.d) == 0) {
    return NO_EXCESS;
  }
  const gjk_vec3 up = gjk_scale_direction(&d.d);
  way.along = gjk_unit(&up);
  way.length = 0;
  set_point(&way.middle, gjk_sar64((int64_t)a->x + b->x, 1), gjk_sar64((int64_t)a->y + b->y, 1),
            gjk_sar64((int64_t)a->z + b->z, 1));
  if (!lengthen(w, e, &way) || !lengthen(w, at_b, &way)) {
    return NO_EXCESS;
  }
  const int64_t x = step_along(way.middle.x, way.along.x, way.length),
                y = step_along(way.middle.y, way.along.y, way.length),
                z = step_along(way.middle.z, way.along.z, way.length);
  if (!is_within_room(s, x, y, z)) {
    return NO_EXCESS;
  }
  set_point(vertex, x, y, z);
  if (!is_beyond_all(w, e, vertex) || !is_beyond_all(w, at_b, vertex)) {
    return NO_EXCESS;
  }
  const uint32_t before = s->excess[i] > s->excess[j] ? s->excess[i] : s->excess[j];
  return before > (UINT32_C(1) << 30) ? NO_EXCESS : before + way.length + ROUNDING;
}

static void keep_cheaper(const simple_work *s, uint16_t vertex, uint16_t partner, uint32_t cost) {
  if (cost < s->cost[vertex] || (cost == s->cost[vertex] && cost != NO_EXCESS && partner < s->partner[vertex])) {
    s->cost[vertex] = cost;
    s->partner[vertex] = partner;
  }
}

// Calls for each edge, from its end of the lower number, once.
static bool is_first_side(const gjk_hull_work *w, const gjk_hull_edge *e) {
  const gjk_hull_triangle *t = &w->triangle[e->triangle];
  return (t->flags & GJK_HULL_SEEN) == 0 && t->vertex[e->number] < t->vertex[gjk_next(e->number)];
}

// Step 2. Numbers of points of the hull are places in s->vertex, which is sorted as they are.
static void find_costs(simple_work *s) {
  const gjk_hull_work *w = &s->triangles;
  gjk_hull_edge e;
  gjk_vec3 vertex;
  for (uint32_t i = 0; i < s->count; i++) {
    s->cost[i] = NO_EXCESS;
    s->partner[i] = GJK_HULL_NO_POINT;
  }
  for (e.triangle = 0; e.triangle < w->triangles; e.triangle++) {
    for (e.number = 0; e.number < 3; e.number++) {
      if (is_first_side(w, &e)) {
        const gjk_hull_triangle *t = &w->triangle[e.triangle];
        const uint16_t a = t->vertex[e.number], b = t->vertex[gjk_next(e.number)];
        const uint32_t cost = join_edge(s, e, &vertex);
        keep_cheaper(s, a, b, cost);
        keep_cheaper(s, b, a, cost);
      }
    }
  }
}

static uint32_t cheapest_of(const simple_work *s) {
  uint32_t cheapest = NO_EXCESS;
  for (uint32_t i = 0; i < s->count; i++) {
    cheapest = s->cost[i] < cheapest ? s->cost[i] : cheapest;
  }
  return cheapest;
}

// Step 3: joins edges that cost at most limit, at most so many. Returns how many.
static uint32_t join_edges(simple_work *s, uint32_t limit, uint32_t most) {
  const gjk_hull_work *w = &s->triangles;
  uint32_t joined = 0;
  gjk_hull_edge e;
  for (uint32_t i = 0; i < s->count; i++) {
    gjk_set(&s->vertex[i], &s->other[i]);
    s->other_excess[i] = s->excess[i];
  }
  for (e.triangle = 0; e.triangle < w->triangles && joined < most; e.triangle++) {
    for (e.number = 0; e.number < 3 && joined < most; e.number++) {
      const gjk_hull_triangle *t = &w->triangle[e.triangle];
      const uint16_t a = t->vertex[e.number], b = t->vertex[gjk_next(e.number)];
      if (is_first_side(w, &e) && s->cost[a] <= limit && s->partner[a] == b && s->partner[b] == a) {
        s->other_excess[a] = s->other_excess[b] = join_edge(s, e, &s->other[a]);
        gjk_set(&s->other[a], &s->other[b]);  // twice the same: one of them is dropped
        joined++;
      }
    }
  }
  for (uint32_t i = 0; i < s->count; i++) {
    gjk_set(&s->other[i], &s->vertex[i]);
    s->excess[i] = s->other_excess[i];
  }
  return joined;
}

// The distance of p from the nearest point, rounded up. Pre: components of differences are below 2^31.
static uint32_t distance_from(const gjk_vec3 *points, uint16_t count, const gjk_vec3 *p) {
  uint64_t least = UINT64_MAX;
  for (uint32_t i = 0; i < count; i++) {
    const int64_t x = (int64_t)points[i].x - p->x, y = (int64_t)points[i].y - p->y, z = (int64_t)points[i].z - p->z;
    const uint32_t dx = gjk_magnitude32((int32_t)x), dy = gjk_magnitude32((int32_t)y), dz = gjk_magnitude32((int32_t)z);
    const uint64_t squared = gjk_umul32(dx, dx) + gjk_umul32(dy, dy) + gjk_umul32(dz, dz);  // < 3 2^62
    least = squared < least ? squared : least;
  }
  const uint32_t root = gjk_isqrt64(least);
  return (uint64_t)gjk_umul32(root, root) == least ? root : root + 1;
}

static void bounds_of(const gjk_vec3 *points, uint16_t count, gjk_vec3 *lower, gjk_vec3 *upper) {
  gjk_set(&points[0], lower);
  gjk_set(&points[0], upper);
  for (uint32_t i = 1; i < count; i++) {
    const gjk_vec3 *p = &points[i];
    set_point(lower, p->x < lower->x ? p->x : lower->x, p->y < lower->y ? p->y : lower->y,
              p->z < lower->z ? p->z : lower->z);
    set_point(upper, p->x > upper->x ? p->x : upper->x, p->y > upper->y ? p->y : upper->y,
              p->z > upper->z ? p->z : upper->z);
  }
}

// Step 4: corners of a box around all points, or of a tetrahedron around that, each at least 1 LSB wide. Returns how many;
// 0: they leave int32 or the size of hulls.
static uint16_t enclose(const gjk_vec3 *lower, const gjk_vec3 *upper, bool box, gjk_vec3 corner[8]) {
  const int64_t times = box ? 1 : 3, most = 2 * (int64_t)GJK_RADIUS_MAX;
  const int64_t low[3] = {lower->x, lower->y, lower->z}, high[3] = {upper->x, upper->y, upper->z};
  int64_t at[3], far[3];
  for (int i = 0; i < 3; i++) {
    const int64_t side = times * (high[i] > low[i] ? high[i] - low[i] : 1);
    const bool up = low[i] + side <= INT32_MAX;  // else the corner is the upper one
    at[i] = up ? low[i] : high[i];
    far[i] = up ? low[i] + side : high[i] - side;
    if (far[i] < INT32_MIN || side > most) {
      return 0;
    }
  }
  for (unsigned i = 0; i < (box ? 8u : 4u); i++) {
    const unsigned bits = box ? i : i == 3 ? 4 : i;
    set_point(&corner[i], (bits & 1u) != 0 ? far[0] : at[0], (bits & 2u) != 0 ? far[1] : at[1],
              (bits & 4u) != 0 ? far[2] : at[2]);
  }
  return box ? 8 : 4;
}

// Where vertices may be: so that all are at most 2 GJK_RADIUS_MAX apart, and within int32.
static void set_room(simple_work *s, const gjk_vec3 *lower, const gjk_vec3 *upper) {
  const int64_t most = 2 * (int64_t)GJK_RADIUS_MAX;
  const int64_t low[3] = {lower->x, lower->y, lower->z}, high[3] = {upper->x, upper->y, upper->z};
  int64_t from[3], to[3];
  for (int i = 0; i < 3; i++) {
    const int64_t margin = gjk_sar64(most - (high[i] - low[i]), 1);
    from[i] = low[i] - margin < INT32_MIN ? INT32_MIN : low[i] - margin;
    to[i] = high[i] + margin > INT32_MAX ? INT32_MAX : high[i] + margin;
  }
  set_point(&s->lower, from[0], from[1], from[2]);
  set_point(&s->upper, to[0], to[1], to[2]);
}

// Steps 1 to 3. False: no edge can be joined, and too many vertices are left.
static bool join_until(simple_work *s, uint16_t most) {
  gjk_hull hull;
  for (rebuild(s, &hull); s->count > most; rebuild(s, &hull)) {  // each time at least one vertex less
    if (hull.dimension < 3) {
      return false;
    }
    find_costs(s);
    const uint32_t cheapest = cheapest_of(s), extra = (uint32_t)(s->count - most);
    const bool at_once = cheapest < NO_EXCESS / 4 && extra > s->count / 8u;
    if (cheapest == NO_EXCESS || join_edges(s, at_once ? cheapest + cheapest / 4 : cheapest, extra) == 0) {
      return false;
    }
  }
  return true;
}

// Step 5.
static bool encloses_all(simple_work *s, const gjk_vec3 *points, uint16_t count) {
  gjk_hull hull;
  rebuild(s, &hull);
  const gjk_hull_work *w = &s->triangles;
  for (uint32_t at = 0; at < w->triangles; at++) {
    if ((w->triangle[at].flags & GJK_HULL_SEEN) == 0) {
      gjk_hull_plane plane;
      gjk_hull_set_plane(w, &w->triangle[at], &plane);
      for (uint32_t i = 0; i < count; i++) {
        if (gjk_hull_height_sign(&plane, &points[i]) > 0) {
          return false;  // not reached: the steps above enclose all
        }
      }
    }
  }
  return hull.dimension == 3;
}

static uint32_t largest_excess(const simple_work *s) {
  uint32_t most = 0;
  for (uint32_t i = 0; i < s->count; i++) {
    most = s->excess[i] > most ? s->excess[i] : most;
  }
  return most;
}

// The parts of a workspace for n points: of the hull, then what is left, in the order of simple_work.
static void divide_workspace(simple_work *s, void *workspace, uint16_t count) {
  const size_t room = count < 8 ? 8 : count;
  s->hull = workspace;
  s->bytes = (size_t)GJK_HULL_WORKSPACE(room);  // it fits: the caller's bytes are at least as many
  s->vertex = (gjk_vec3 *)(void *)((unsigned char *)workspace + s->bytes);
  s->other = s->vertex + room;
  s->excess = (uint32_t *)(void *)(s->other + room);
  s->other_excess = s->excess + room;
  s->cost = s->other_excess + room;
  s->partner = (uint16_t *)(void *)(s->cost + room);
}

// Steps 4 and 5 where the joined edges do not do, or do worse.
static bool take_enclosure(simple_work *s, const gjk_vec3 *points, uint16_t count, uint16_t most, bool joined) {
  gjk_vec3 lower, upper, corner[8];
  bounds_of(points, count, &lower, &upper);
  const uint16_t corners = enclose(&lower, &upper, most >= 8, corner);
  uint32_t excess = 0;
  for (uint32_t i = 0; i < corners; i++) {
    const uint32_t own = distance_from(points, count, &corner[i]);
    excess = own > excess ? own : excess;
  }
  if (joined && (corners == 0 || largest_excess(s) <= excess)) {
    return true;
  }
  s->count = corners;
  for (uint32_t i = 0; i < corners; i++) {
    gjk_set(&corner[i], &s->vertex[i]);
    s->excess[i] = excess;
  }
  return corners > 0;
}

gjk_status gjk_hull_simplify(const gjk_vec3 *points, uint16_t count, uint16_t most, void *workspace, size_t bytes,
                             gjk_vec3 *vertices, gjk_hull_simple *out) {
  if (points == NULL || workspace == NULL || vertices == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  if (count == 0) {
    return GJK_ERROR_EMPTY;
  }
  if ((uintptr_t)workspace % sizeof(uint32_t) != 0 || most < GJK_HULL_SIMPLE_MIN) {
    return GJK_ERROR_RANGE;
  }
  if (bytes < GJK_HULL_SIMPLIFY_WORKSPACE(count)) {
    return GJK_ERROR_CAPACITY;
  }
  if (!gjk_hull_fits(points, count)) {
    return GJK_ERROR_SIZE;
  }
  simple_work s;
  gjk_vec3 lower, upper;
  divide_workspace(&s, workspace, count);
  bounds_of(points, count, &lower, &upper);
  set_room(&s, &lower, &upper);
  s.count = count;
  for (uint32_t i = 0; i < count; i++) {
    gjk_set(&points[i], &s.vertex[i]);
    s.excess[i] = 0;
  }
  const bool joined = join_until(&s, most);
  if (!joined || largest_excess(&s) > 0) {
    if (!take_enclosure(&s, points, count, most, joined)) {
      return GJK_ERROR_RANGE;
    }
    if (!encloses_all(&s, points, count)) {
      return GJK_ERROR_UNPROVEN;  // not reached: the steps above enclose all
    }
  }
  for (uint32_t i = 0; i < s.count; i++) {
    gjk_set(&s.vertex[i], &vertices[i]);
  }
  out->vertices = s.count;
  out->excess = largest_excess(&s);
  return GJK_OK;
}
