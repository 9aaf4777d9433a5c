// Step 3 of gjk_hull_simplify: each vertex goes outwards, until it is beyond or on all planes that were moved around it.
//
// The way begins at a point, and first goes along a mean of the normals or edges. The plane that it reaches last decides its
// length. A turn towards that plane's normal reaches it sooner, and others later. The turns get less, and the shortest way
// counts. Roundings let the vertex fall short of a plane by an LSB or so: then it goes on, until it is beyond by exact signs.
#include "gjk_hull_excess.h"
#include "gjk_hull_simple.h"

#include "../arith/gjk_unit.h"

// Least part of a step outwards that a plane's normal sees, Q30. With less a vertex is not looked for that way.
#define LEAST_RISE (GJK_Q30_ONE >> 20)

#define TURNS 16

#define NO_WAY UINT32_MAX

uint16_t gjk_hull_farthest_beyond(const gjk_hull_simple_work *s, const gjk_hull_plane *plane) {
  int64_t most = INT64_MIN;
  uint32_t most_low = 0;
  uint16_t farthest = s->extreme[0];
  for (uint32_t i = 0; i < s->extremes; i++) {
    uint32_t low;
    const int64_t high = gjk_hull_height(plane, &s->points[s->extreme[i]], &low);
    if (high > most || (high == most && low > most_low)) {
      most = high;
      most_low = low;
      farthest = s->extreme[i];
    }
  }
  return farthest;
}

void gjk_hull_look_along(gjk_hull_simple_work *s) {
  const gjk_hull_work *w = &s->triangles;
  for (uint32_t at = 0; at < w->triangles; at++) {
    if (gjk_hull_is_in_use(&w->triangle[at])) {
      gjk_hull_plane plane;
      gjk_hull_set_plane(w, &w->triangle[at], &plane);
      s->unit[at] = gjk_hull_unit(&plane);
      s->touch[at] = gjk_hull_farthest_beyond(s, &plane);
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

// A way from a point to where it is beyond all planes at a vertex.
typedef struct way_out {
  const gjk_vec3 *from;
  gjk_unit3 along;
  uint32_t length;  // or NO_WAY
  uint32_t last;    // the triangle whose plane it reaches last
} way_out;

// The least t with rise t >= depth, or NO_WAY where it is 2^30 or more. Pre: rise > 0, both Q30.
static uint32_t least_way(int64_t depth, gjk_q30 rise) {
  uint32_t t = 0;
  for (uint32_t bit = UINT32_C(1) << 29; bit > 0; bit >>= 1) {
    if (gjk_mul32(rise, (int32_t)(t + bit)) < depth) {
      t += bit;
    }
  }
  return t == (UINT32_C(1) << 30) - 1 ? NO_WAY : t + 1;
}

// Finds how long the way has to be for the planes that were moved, and which is the last.
static void measure_way(const gjk_hull_simple_work *s, gjk_hull_edge e, way_out *way) {
  const uint32_t first = e.triangle;
  const gjk_vec3 along = {way->along.x, way->along.y, way->along.z};
  gjk_q30 least = LEAST_RISE;
  way->length = 0;
  way->last = first;
  do {  // once for each triangle at the vertex
    const gjk_unit3 *u = &s->unit[e.triangle];
    const gjk_vec3 below = gjk_sub(s->points[s->touch[e.triangle]], *way->from);
    const gjk_q30 rise = (gjk_q30)gjk_sar64(gjk_along(u, &along), 30);
    const int64_t depth = gjk_along(u, &below);
    if (rise < least) {
      least = rise;
      way->length = NO_WAY;
      way->last = e.triangle;
    } else if (way->length != NO_WAY && gjk_umul32((uint32_t)rise, way->length) < (uint64_t)(depth > 0 ? depth : 0)) {
      way->length = least_way(depth, rise);
      way->last = e.triangle;
    }
    next_around(&s->triangles, &e);
  } while (e.triangle != first);
}

// Adds a part of a unit vector to a direction.
static gjk_unit3 turn_towards(const gjk_unit3 *along, const gjk_unit3 *to, gjk_q30 part) {
  const gjk_vec3 sum = {(int32_t)gjk_sar64(gjk_shl64(along->x, 30) + gjk_mul32(to->x, part), 31),
                        (int32_t)gjk_sar64(gjk_shl64(along->y, 30) + gjk_mul32(to->y, part), 31),
                        (int32_t)gjk_sar64(gjk_shl64(along->z, 30) + gjk_mul32(to->z, part), 31)};
  return gjk_unit(&sum);
}

static void add_unit(gjk_long3 *sum, const gjk_unit3 *u) {
  sum->x += u->x;
  sum->y += u->y;
  sum->z += u->z;
}

// The unit vector along a sum, or another one where that is 0.
static gjk_unit3 unit_of_sum(const gjk_long3 *sum, const gjk_unit3 *other) {
  gjk_search_direction d;
  gjk_search_direction_of(sum, &d);
  if (gjk_norm1(d.d) == 0) {
    return *other;
  }
  const gjk_vec3 up = gjk_scale_direction(&d.d);
  return gjk_unit(&up);
}

// Two directions outwards: the mean of the normals, one of each facet, and the opposite of the mean of the edges' directions.
// Along the second one each normal rises, however sharp the vertex is, but it is rounded most where the vertex is blunt.
static void start_ways(const gjk_hull_simple_work *s, gjk_hull_edge e, gjk_unit3 start[2]) {
  const gjk_hull_work *w = &s->triangles;
  const uint32_t first = e.triangle;
  gjk_long3 normals = {0, 0, 0}, edges = {0, 0, 0};
  do {  // once for each triangle at the vertex: fewer than 2^17, so the sums are below 2^47
    const gjk_hull_triangle *t = &w->triangle[e.triangle];
    const gjk_unit3 *u = &s->unit[e.triangle];
    const gjk_vec3 edge =
        gjk_sub(*gjk_hull_point(w, t->vertex[e.number]), *gjk_hull_point(w, t->vertex[gjk_next(e.number)]));
    const gjk_vec3 scaled = gjk_scale_direction(&edge);
    const gjk_unit3 out = gjk_unit(&scaled);
    if ((t->flags & (unsigned)GJK_HULL_FLAT << e.number) == 0) {
      add_unit(&normals, u);
    }
    add_unit(&edges, &out);
    next_around(w, &e);
  } while (e.triangle != first);
  start[0] = unit_of_sum(&normals, &s->unit[first]);
  start[1] = unit_of_sum(&edges, &start[0]);
}

static void set_unit(const gjk_unit3 *from, gjk_unit3 *to) {
  to->x = from->x;
  to->y = from->y;
  to->z = from->z;
}

// Measures a way, and keeps its direction if it is shorter than best.
static void try_way(const gjk_hull_simple_work *s, gjk_hull_edge e, way_out *way, way_out *best) {
  measure_way(s, e, way);
  if (way->length < best->length) {
    set_unit(&way->along, &best->along);
    best->length = way->length;
    best->last = way->last;
  }
}

// A short way from best->from: each turn is towards the plane that is last, by less and less.
static void shorten_way(const gjk_hull_simple_work *s, gjk_hull_edge e, const gjk_unit3 start[2], way_out *best) {
  way_out way = {best->from, {0, 0, 0}, 0, 0};
  gjk_q30 part = GJK_Q30_ONE / 2;
  best->length = NO_WAY;
  for (unsigned i = 0; i < 2; i++) {
    set_unit(&start[i], &way.along);
    try_way(s, e, &way, best);
  }
  set_unit(&best->along, &way.along);
  way.last = best->last;
  for (unsigned i = 0; i < TURNS && best->length != NO_WAY; i++) {
    const gjk_unit3 turned = turn_towards(&way.along, &s->unit[way.last], part);
    set_unit(&turned, &way.along);
    try_way(s, e, &way, best);
    part -= part / 4;
  }
}

// Is p beyond or on all planes that were moved around a vertex?
static bool is_beyond_all(const gjk_hull_simple_work *s, gjk_hull_edge e, const gjk_vec3 *p) {
  const uint32_t first = e.triangle;
  do {  // once for each triangle at the vertex
    gjk_hull_plane plane;
    gjk_hull_set_plane(&s->triangles, &s->triangles.triangle[e.triangle], &plane);
    plane.at = &s->points[s->touch[e.triangle]];
    if (gjk_hull_height_sign(&plane, p) < 0) {
      return false;
    }
    next_around(&s->triangles, &e);
  } while (e.triangle != first);
  return true;
}

static bool is_within_room(const gjk_hull_simple_work *s, int64_t x, int64_t y, int64_t z) {
  return x >= s->lower.x && x <= s->upper.x && y >= s->lower.y && y <= s->upper.y && z >= s->lower.z && z <= s->upper.z;
}

static int64_t step_along(int32_t from, gjk_q30 along, uint32_t length) {
  return from + gjk_sar64(gjk_mul32(along, (int32_t)length) + GJK_Q30_ONE / 2, 30);
}

// Goes a way, and on as far as roundings ask for. False: that leads nowhere.
static bool go_out(const gjk_hull_simple_work *s, gjk_hull_edge e, const way_out *way, gjk_vec3 *to) {
  for (unsigned i = 0; i < 29; i++) {
    const uint32_t length = way->length + (UINT32_C(1) << i) - 1;  // below 2^31
    const int64_t x = step_along(way->from->x, way->along.x, length),
                  y = step_along(way->from->y, way->along.y, length),
                  z = step_along(way->from->z, way->along.z, length);
    if (!is_within_room(s, x, y, z)) {
      return false;
    }
    to->x = (int32_t)x;
    to->y = (int32_t)y;
    to->z = (int32_t)z;
    if (is_beyond_all(s, e, to)) {
      return true;
    }
  }
  return false;
}

// The point that is farthest along a unit vector, of equals the first.
static uint16_t farthest_point_along(const gjk_hull_simple_work *s, const gjk_unit3 *u) {
  int64_t most = INT64_MIN;
  uint16_t farthest = s->extreme[0];
  for (uint32_t i = 0; i < s->extremes; i++) {
    const gjk_vec3 from_first = gjk_sub(s->points[s->extreme[i]], s->points[s->extreme[0]]);
    const int64_t height = gjk_along(u, &from_first);
    if (height > most) {
      most = height;
      farthest = s->extreme[i];
    }
  }
  return farthest;
}

// Step 3 for the vertex that the edge e begins at. False: there is none, and no earlier one.
static bool move_vertex(gjk_hull_simple_work *s, gjk_hull_edge e, bool again) {
  const gjk_hull_work *w = &s->triangles;
  const uint16_t i = w->order[w->triangle[e.triangle].vertex[e.number]];
  uint64_t least = again ? gjk_hull_squared_between(&s->vertex[i], &s->points[s->core[i]]) : UINT64_MAX;
  gjk_unit3 start[2];
  way_out way = {&s->points[s->core[i]], {0, 0, 0}, 0, 0};
  start_ways(s, e, start);
  gjk_set(&s->vertex[i], &s->moved[i]);
  for (unsigned pass = 0; pass < 2; pass++) {
    gjk_vec3 to;
    shorten_way(s, e, start, &way);
    if (way.length == NO_WAY) {
      break;
    }
    if (go_out(s, e, &way, &to) && gjk_hull_squared_between(&to, way.from) < least) {
      least = gjk_hull_squared_between(&to, way.from);
      s->core[i] = (uint16_t)(way.from - s->points);
      gjk_set(&to, &s->moved[i]);
    }
    way.from = &s->points[farthest_point_along(s, &way.along)];
  }
  return least != UINT64_MAX;
}

bool gjk_hull_move_vertices(gjk_hull_simple_work *s, bool again) {
  const gjk_hull_work *w = &s->triangles;
  gjk_hull_edge e;
  gjk_hull_look_along(s);
  for (uint32_t i = 0; i < w->distinct; i++) {
    w->of[i] = 0;  // 1: the vertex was moved
  }
  for (e.triangle = 0; e.triangle < w->triangles; e.triangle++) {
    for (e.number = 0; e.number < 3 && gjk_hull_is_in_use(&w->triangle[e.triangle]); e.number++) {
      const uint16_t number = w->triangle[e.triangle].vertex[e.number];
      if (w->of[number] == 0 && !move_vertex(s, e, again)) {
        return false;
      }
      w->of[number] = 1;
    }
  }
  for (uint32_t i = 0; i < s->count; i++) {
    gjk_set(&s->moved[i], &s->vertex[i]);
  }
  return true;
}
