// Fewer vertices around the same points: some of the points, moved outwards.
//
//   1. Find the hull of the points. If it has few enough vertices, stop.
//   2. Choose points: four that span space, then again and again those that are farthest beyond the hull of the chosen ones.
//   3. Move each triangle of that hull outwards, until no point is beyond its plane. Each vertex goes where it is beyond or
//      on all planes that were moved around it, by a short way.
//   4. Repeat step 3 with the hull of these vertices, whose planes move inwards. A vertex moves if its way gets shorter.
//   5. Where a box or a tetrahedron around all points is nearer, or no vertex could be found, take that.
//   6. Test that no point is beyond a plane of the result.
//
// Why the hull after step 3 holds all points. Let h be any direction, and w the vertex of the hull before that is farthest
// along h. Then h is a sum of the normals of the triangles at w, with weights of at least 0. Along each
// of these normals no point is farther than the moved plane. The vertex v that w becomes is at least as far as that. So v is
// at least as far along h as any point. That holds for all vertices at once.
#include "gjk_hull_excess.h"
#include "gjk_hull_simple.h"

#include "../arith/gjk_memory.h"
#include "../arith/gjk_root.h"
#include "../arith/gjk_unit.h"

// How often steps 3 and 4 are done.
#define ROUNDS_MAX 3

static void set_point(gjk_vec3 *to, int64_t x, int64_t y, int64_t z) {
  to->x = (int32_t)x;
  to->y = (int32_t)y;
  to->z = (int32_t)z;
}

// Builds the hull of vertex, and drops those that are not extreme.
static void rebuild(gjk_hull_simple_work *s, gjk_hull *hull) {
  for (unsigned pass = 0; pass < 2; pass++) {
    (void)gjk_hull_build(s->vertex, s->count, s->hull, s->bytes, hull);  // they fit: each is within the room
    gjk_hull_work_of_hull(hull, &s->triangles);
    const gjk_hull_work *w = &s->triangles;
    uint16_t kept = 0;
    if (hull->vertices == s->count || hull->dimension < 3) {
      return;
    }
    for (uint32_t i = 0; i < s->count; i++) {
      s->moved[i].x = 0;
    }
    for (uint32_t point = 0; point < w->distinct; point++) {
      s->moved[w->order[point]].x = w->next[point] != GJK_HULL_NO_POINT ? 1 : 0;
    }
    for (uint32_t i = 0; i < s->count; i++) {
      if (s->moved[i].x != 0) {
        gjk_set(&s->vertex[i], &s->vertex[kept]);
        s->core[kept++] = s->core[i];
      }
    }
    s->count = kept;
  }
}

// How far the plane of a triangle moves outwards, Q30. 0 where no point is beyond it, by exact signs: the unit normal is
// rounded, so of points in the plane it sees a little.
static int64_t gain_of(const gjk_hull_simple_work *s, uint32_t at) {
  const gjk_hull_triangle *t = &s->triangles.triangle[at];
  const gjk_vec3 *touch = &s->points[s->touch[at]];
  gjk_hull_plane plane;
  if (!gjk_hull_is_in_use(t)) {
    return 0;
  }
  gjk_hull_set_plane(&s->triangles, t, &plane);
  const gjk_vec3 beyond = gjk_sub(*touch, *plane.at);
  return gjk_hull_height_sign(&plane, touch) > 0 ? gjk_along(&s->unit[at], &beyond) : 0;
}

static void choose_point(gjk_hull_simple_work *s, uint16_t point) {
  gjk_set(&s->points[point], &s->vertex[s->count]);
  s->core[s->count++] = point;
}

// Chooses the points of triangles that gain at least so much and have no vertex in common.
static void choose_farthest(gjk_hull_simple_work *s, int64_t least, uint16_t most) {
  const gjk_hull_work *w = &s->triangles;
  const uint16_t before = s->count;
  for (uint32_t i = 0; i < w->distinct; i++) {
    w->of[i] = 0;  // 1: a vertex of a triangle whose point was chosen
  }
  for (uint32_t at = 0; at < w->triangles && s->count < most; at++) {
    const gjk_hull_triangle *t = &w->triangle[at];
    bool apart = gain_of(s, at) >= least && (w->of[t->vertex[0]] | w->of[t->vertex[1]] | w->of[t->vertex[2]]) == 0;
    for (uint32_t i = before; i < s->count; i++) {
      apart = apart && s->core[i] != s->touch[at];
    }
    if (apart) {
      w->of[t->vertex[0]] = w->of[t->vertex[1]] = w->of[t->vertex[2]] = 1;
      choose_point(s, s->touch[at]);
    }
  }
}

// Step 2. Pre: s->triangles is the work of the hull of all points.
static void choose_points(gjk_hull_simple_work *s, uint16_t most) {
  const gjk_hull_work *w = &s->triangles;
  uint16_t corner[4];
  gjk_hull hull;
  (void)gjk_hull_span(w, corner);
  s->count = 0;
  for (unsigned i = 0; i < 4; i++) {
    choose_point(s, w->order[corner[i]]);
  }
  for (;;) {  // each time at least one point more: it is a vertex of the hull of all, so it stays one
    rebuild(s, &hull);
    gjk_hull_look_along(s);
    int64_t gain = 0;
    for (uint32_t at = 0; at < w->triangles; at++) {
      const int64_t own = gain_of(s, at);
      gain = own > gain ? own : gain;
    }
    if (gain == 0 || s->count >= most) {
      return;
    }
    choose_farthest(s, gain - gjk_sar64(gain, 3), most);
  }
}

// The largest distance of vertices from the hull of all points, rounded up. Of a flat one: from its nearest corners.
static uint32_t excess_of(const gjk_hull_simple_work *s, const gjk_hull *hull, const gjk_vec3 *vertex, uint16_t count) {
  if (hull->dimension == 3) {
    return gjk_hull_excess(&s->triangles, vertex, count, (uint32_t *)(void *)s->moved);
  }
  uint64_t most = 0;
  for (uint32_t i = 0; i < count; i++) {
    uint64_t least = UINT64_MAX;
    for (uint32_t j = 0; j < s->extremes; j++) {
      const uint64_t squared = gjk_hull_squared_between(&vertex[i], &s->points[s->extreme[j]]);
      least = squared < least ? squared : least;
    }
    most = least > most ? least : most;
  }
  const uint32_t root = gjk_isqrt64(most);
  return gjk_umul32(root, root) == most ? root : root + 1;
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

// Step 5: corners of a box around all points, or of a tetrahedron around that, each at least 1 LSB wide. Returns how many;
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
static void set_room(gjk_hull_simple_work *s, const gjk_vec3 *lower, const gjk_vec3 *upper) {
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

// Steps 2 to 4. False: no vertices were found.
static bool move_out(gjk_hull_simple_work *s, uint16_t most) {
  gjk_hull hull;
  choose_points(s, most);
  for (unsigned i = 0; i < ROUNDS_MAX; i++) {
    if (!gjk_hull_move_vertices(s, i > 0)) {
      return false;
    }
    rebuild(s, &hull);
  }
  return true;
}

// Step 6, the test.
static bool encloses_all(gjk_hull_simple_work *s) {
  gjk_hull hull;
  rebuild(s, &hull);
  const gjk_hull_work *w = &s->triangles;
  for (uint32_t at = 0; at < w->triangles; at++) {
    if (gjk_hull_is_in_use(&w->triangle[at])) {
      gjk_hull_plane plane;
      gjk_hull_set_plane(w, &w->triangle[at], &plane);
      if (gjk_hull_height_sign(&plane, &s->points[gjk_hull_farthest_beyond(s, &plane)]) > 0) {
        return false;  // not reached: the steps above enclose all
      }
    }
  }
  return hull.dimension == 3;
}

// The parts of a workspace for n points: of the hull, then what is left, in the order of gjk_hull_simple_work.
static void divide_workspace(gjk_hull_simple_work *s, void *workspace, uint16_t count) {
  const size_t room = count < 8 ? 8 : count;
  s->hull = workspace;
  s->bytes = (size_t)GJK_HULL_WORKSPACE(room);  // it fits: the caller's bytes are at least as many
  s->vertex = (gjk_vec3 *)(void *)((unsigned char *)workspace + s->bytes);
  s->moved = s->vertex + room;
  s->unit = (gjk_unit3 *)(void *)(s->moved + room);
  s->touch = (uint16_t *)(void *)(s->unit + 2 * room);
  s->core = s->touch + 2 * room;
  s->extreme = s->core + room;
}

// Step 5: takes corners around all points where they are wanted, or nearer. moved: there are vertices. *excess: how far
// those that were taken reach. False: there are neither.
static bool take_enclosure(gjk_hull_simple_work *s, uint16_t count, uint16_t most, bool moved, uint32_t *excess) {
  gjk_hull hull;
  gjk_vec3 lower, upper, corner[8];
  bounds_of(s->points, count, &lower, &upper);
  const uint16_t corners = enclose(&lower, &upper, most >= 8, corner);
  (void)gjk_hull_build(s->points, count, s->hull, s->bytes, &hull);
  gjk_hull_work_of_hull(&hull, &s->triangles);
  const uint32_t own = moved ? excess_of(s, &hull, s->vertex, s->count) : UINT32_MAX;
  *excess = corners > 0 ? excess_of(s, &hull, corner, corners) : UINT32_MAX;
  if (moved && own <= *excess) {
    *excess = own;
    return true;
  }
  s->count = corners;
  for (uint32_t i = 0; i < corners; i++) {
    gjk_set(&corner[i], &s->vertex[i]);
    s->core[i] = 0;
  }
  return corners > 0;
}

// Writes the hull of the points where it has few enough vertices. Else sets extreme.
static bool write_whole(gjk_hull_simple_work *s, const gjk_hull *hull, uint16_t most, gjk_vec3 *vertices) {
  if (hull->vertices <= most) {
    (void)gjk_hull_vertices(hull, vertices, most);
    return true;
  }
  gjk_hull_work_of_hull(hull, &s->triangles);
  const gjk_hull_work *w = &s->triangles;
  s->extremes = 0;
  for (uint32_t point = 0; point < w->distinct; point++) {
    if (w->next[point] != GJK_HULL_NO_POINT) {
      s->extreme[s->extremes++] = w->order[point];
    }
  }
  return false;
}

static gjk_status check_arguments(const gjk_vec3 *points, uint16_t count, uint16_t most, const void *workspace,
                                  size_t bytes) {
  if (count == 0) {
    return GJK_ERROR_EMPTY;
  }
  if (!gjk_is_aligned(workspace) || most < GJK_HULL_SIMPLE_MIN) {
    return GJK_ERROR_RANGE;
  }
  if (bytes < GJK_HULL_SIMPLIFY_WORKSPACE(count)) {
    return GJK_ERROR_CAPACITY;
  }
  return gjk_hull_fits(points, count) ? GJK_OK : GJK_ERROR_SIZE;
}

gjk_status gjk_hull_simplify(const gjk_vec3 *points, uint16_t count, uint16_t most, void *workspace, size_t bytes,
                             gjk_vec3 *vertices, gjk_hull_simple *out) {
  if (points == NULL || workspace == NULL || vertices == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  const gjk_status status = check_arguments(points, count, most, workspace, bytes);
  if (status != GJK_OK) {
    return status;
  }
  gjk_hull_simple_work s;
  gjk_vec3 lower, upper;
  gjk_hull hull;
  s.points = points;
  divide_workspace(&s, workspace, count);
  bounds_of(points, count, &lower, &upper);
  set_room(&s, &lower, &upper);
  (void)gjk_hull_build(points, count, s.hull, s.bytes, &hull);  // the arguments are fine
  if (write_whole(&s, &hull, most, vertices)) {
    out->vertices = hull.vertices;
    out->excess = 0;
    return GJK_OK;
  }
  uint32_t excess;
  if (!take_enclosure(&s, count, most, hull.dimension == 3 && move_out(&s, most), &excess)) {
    return GJK_ERROR_RANGE;
  }
  if (!encloses_all(&s)) {
    return GJK_ERROR_UNPROVEN;  // not reached: the steps above enclose all
  }
  out->vertices = s.count;
  out->excess = excess;
  for (uint32_t i = 0; i < s.count; i++) {
    gjk_set(&s.vertex[i], &vertices[i]);
  }
  return GJK_OK;
}
