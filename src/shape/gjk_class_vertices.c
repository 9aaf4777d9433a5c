// Triangle and hull: a list of vertices, posed beforehand (baked) or on demand (lazy).
//
// The support of a baked hull is the farthest of its posed vertices. A lazy hull finds the very same vertex:
//   1. Scale d up, so that rotating it loses little, and rotate it into the shape's frame: local.
//   2. Scan the shape's own vertices for the farthest along local.
//   3. Scan them again for all that come within slack of that one. slack bounds what the roundings of local and of
//      posed vertices can hide, so the vertex that the baked hull finds is among them.
//   4. Pose each of these, as a baked hull's are, and take the farthest along d, the first of equals.
//
// d itself is rounded. Refinement finds a vertex that is farthest along the exact direction:
//   5. Scan for all vertices within slack of the support along d. slack bounds what the rounding of d can hide, too.
//   6. Move to each vertex that is strictly farther along the exact direction; count those as far as the last.
#include "gjk_hull.h"

#include "gjk_scan.h"

// The posed vertices of a triangle or a baked hull.
static const gjk_vec3 *posed(const gjk_collider *c) {
  return c->buffer != NULL ? c->buffer : c->frame;
}

static void support_posed(const gjk_collider *c, const gjk_vec3 *d, gjk_support *out) {
  const gjk_vec3 *vertices = posed(c), *farthest = gjk_scan(vertices, vertices + c->count, c->bits, d);
  out->offset = *farthest;
  out->vertex = (uint16_t)(farthest - vertices);
}

// Components of the shape's own vertices are at most 2^own_bits in size: they lie within core_radius of local_centre.
// Only vectors gain by less than an int32_t has.
static unsigned own_bits(const gjk_collider *c) {
#if GJK_VECTORS
  const uint32_t x = gjk_magnitude32(c->local_centre.x), y = gjk_magnitude32(c->local_centre.y);
  const uint32_t z = gjk_magnitude32(c->local_centre.z);
  const unsigned bits = 32 - gjk_clz32((x | y | z | (uint32_t)c->core_radius) | 1);  // each below 2^bits
  return bits < 31 ? bits + 1 : 31;
#else
  (void)c;
  return 31;
#endif
}

// Starts a scan for all v of vertices with v . d >= one . d - slack. shape->vertices is not recentred; that shifts
// every product equally.
static void reach_within(gjk_reach *reach, const gjk_collider *c, const gjk_vec3 *vertices, const gjk_vec3 *d,
                         const gjk_vec3 *one, int64_t slack) {
  reach->next = vertices;
  reach->end = vertices + c->count;
  reach->d = d;
  reach->limit = gjk_dot(one, d) - slack;
  gjk_reach_start(reach, vertices == c->shape->vertices ? own_bits(c) : c->bits);
}

// Is the vertex known not to be farther along the exact direction than the one that the refinement began with?
static inline bool is_behind(const gjk_direction *direction, uint16_t vertex, uint16_t before, bool known) {
  return vertex == before || (known && gjk_direction_knows(direction, vertex));
}

#if GJK_CONDITIONAL_MOVES

// Up to so many vertices a branch for each costs more than a bit. At 64 it does not: few come within the slack there.
#define FEW_VERTICES 32

// Steps 5 and 6 for at most FEW_VERTICES vertices, without a branch for each. Bit 63 - i of open stands for vertex i: it comes
// within the slack of step 5, and is not known to be behind.
static bool refine_few(const gjk_collider *c, const gjk_vec3 *d, gjk_direction *direction, gjk_support *at) {
  const gjk_vec3 *vertices = posed(c);
  const uint16_t before = at->vertex;
  const int64_t limit = gjk_dot(&at->offset, d) - gjk_hull_rounding_slack(c);
  const uint64_t first = UINT64_C(1) << 63;
  uint64_t open = 0;
  for (unsigned i = 0; i < c->count; i++) {
    open = 2 * open + (gjk_dot(&vertices[i], d) >= limit ? 1u : 0u);
  }
  open = open << ((64u - c->count) & 63u) & ~(first >> before);
  direction->ties = 0;
  if (gjk_direction_knows(direction, before)) {
    const uint16_t *level = direction->level;
    open &= ~(first >> level[0] | first >> level[1] | first >> level[2]);
    direction->ties = gjk_direction_known(direction);
  }
  while (open != 0) {  // at most FEW_VERTICES times
    const unsigned i = gjk_clz64(open);
    open &= ~(first >> i);
    gjk_hull_refine_to(direction, &vertices[i], (uint16_t)i, at);
  }
  return at->vertex != before;
}

#endif

// Steps 5 and 6. Pre: offsets are at most core_radius long.
static bool refine_posed(const gjk_collider *c, const gjk_vec3 *d, gjk_direction *direction, gjk_support *at) {
#if GJK_CONDITIONAL_MOVES
  if (c->count <= FEW_VERTICES) {
    return refine_few(c, d, direction, at);
  }
#endif
  const gjk_vec3 *vertices = posed(c), *v;
  const uint16_t before = at->vertex;
  const bool known = gjk_direction_knows(direction, before);
  gjk_reach reach;
  direction->ties = known ? gjk_direction_known(direction) : 0;
  reach_within(&reach, c, vertices, d, &at->offset, gjk_hull_rounding_slack(c));
  while ((v = gjk_reach_next(&reach)) != NULL) {  // at most GJK_HULL_VERTICES_MAX
    if (!is_behind(direction, (uint16_t)(v - vertices), before, known)) {
      gjk_hull_refine_to(direction, v, (uint16_t)(v - vertices), at);
    }
  }
  return at->vertex != before;
}

// The vertex's offset from the rounded centre. It is rounded once, with the fraction of an LSB that the centre's
// rounding has left. Errors per component:
//   rounding the result       <= 1/2
//   rounding the matrix       <= 2^-31 (|x| + |y| + |z|) < 0.22
//   truncating the fraction   <  2^-8
//   the centre's own error    <  2^-9
//   together                  <  3/4 LSB
static gjk_vec3 pose_vertex(const gjk_collider *c, const gjk_vec3 rows[3], const gjk_vec3 *v) {
  const gjk_vec3 local = gjk_sub(*v, c->local_centre);  // gjk_collider_init:  |local| <= GJK_RADIUS_MAX
  return gjk_rotate_onto(rows, &local, c->fraction);
}

// Step 1: *local = d in the shape's frame. Returns how far behind along *local a vertex may be that is farther along d
// when posed. With u for the difference of two vertices:
//   rounding *local, 1/2 per component               |u.x| / 2 + |u.y| / 2 + |u.z| / 2 <= sqrt(3) core_radius
//   rounding both posed vertices, 1/2 per component  |d.x| + |d.y| + |d.z| < 2^32
static int64_t local_direction(const gjk_collider *c, const gjk_vec3 *d, gjk_vec3 *local) {
  *local = gjk_rotate_back(c->frame, d);
  return 2 * (int64_t)c->core_radius + gjk_norm1(*d) + 8;
}

// Out of line, as refine_lazy: in line it costs queries on baked hulls 1 % more instructions on Cortex-M3, and
// refine_lazy 40 bytes of stack.
GJK_OUT_OF_LINE static void support_lazy(const gjk_collider *c, const gjk_vec3 *direction, gjk_support *out) {
  const gjk_vec3 *vertices = c->shape->vertices, *best = NULL;
  const gjk_vec3 d = gjk_scale_direction(direction);
  gjk_vec3 local;
  gjk_reach reach;
  const int64_t slack = local_direction(c, &d, &local);
  // Steps 2 and 3
  reach_within(&reach, c, vertices, &local, gjk_scan(vertices, vertices + c->count, own_bits(c), &local), slack);
  const gjk_vec3 *v = gjk_reach_next(&reach);
  int64_t farthest = 0;
  //@ assert v != 0;
  do {  // Step 4: for at least the vertex of step 2, at most GJK_HULL_VERTICES_MAX
    const gjk_vec3 offset = pose_vertex(c, c->frame, v);
    const int64_t along = gjk_dot(&offset, &d);
    if (best == NULL || along > farthest) {
      best = v;
      farthest = along;
      out->offset = offset;
    }
    v = gjk_reach_next(&reach);
  } while (v != NULL);
  out->vertex = (uint16_t)(best - vertices);
}

// Steps 5 and 6, with the slack of step 3 added, since vertices are compared along local.
GJK_OUT_OF_LINE static bool refine_lazy(const gjk_collider *c, const gjk_vec3 *d, gjk_direction *direction,
                                        gjk_support *at) {
  const gjk_vec3 *vertices = c->shape->vertices, *v;
  const uint16_t before = at->vertex;
  const bool known = gjk_direction_knows(direction, before);
  gjk_vec3 local;
  gjk_reach reach;
  const int64_t slack = local_direction(c, d, &local) + gjk_hull_rounding_slack(c);
  direction->ties = known ? gjk_direction_known(direction) : 0;
  reach_within(&reach, c, vertices, &local, &vertices[before], slack);
  while ((v = gjk_reach_next(&reach)) != NULL) {  // at most GJK_HULL_VERTICES_MAX
    if (!is_behind(direction, (uint16_t)(v - vertices), before, known)) {
      const gjk_vec3 offset = pose_vertex(c, c->frame, v);
      gjk_hull_refine_to(direction, &offset, (uint16_t)(v - vertices), at);
    }
  }
  return at->vertex != before;
}

static void support_hull(const gjk_collider *c, const gjk_vec3 *d, gjk_support *out) {
  if (c->buffer != NULL) {
    support_posed(c, d, out);
  } else {
    support_lazy(c, d, out);
  }
}

static bool refine_hull(const gjk_collider *c, const gjk_vec3 *d, gjk_direction *direction, gjk_support *at) {
  return c->buffer != NULL ? refine_posed(c, d, direction, at) : refine_lazy(c, d, direction, at);
}

static bool vertex_posed(const gjk_collider *c, uint16_t number, gjk_vec3 *offset) {
  if (number >= c->count) {
    return false;
  }
  *offset = posed(c)[number];
  return true;
}

static bool vertex_hull(const gjk_collider *c, uint16_t number, gjk_vec3 *offset) {
  if (c->buffer != NULL || number >= c->count) {
    return vertex_posed(c, number, offset);
  }
  *offset = pose_vertex(c, c->frame, &c->shape->vertices[number]);
  return true;
}

// *out = the vertices, posed as by pose_vertex.
#if GJK_SMALL || GJK_NARROW_MULTIPLY

static void pose_vertices(const gjk_collider *c, const gjk_vec3 rows[3], gjk_vec3 *out) {
  const gjk_vec3 *v = c->shape->vertices, *const end = v + c->count;
  for (; v != end; v++, out++) {
    const gjk_vec3 local = gjk_sub(*v, c->local_centre);
    *out = gjk_rotate_onto(rows, &local, c->fraction);
  }
}

#else

// A row of the matrix and what is added to its product, in registers while vertices pass.
typedef struct pose_row {
  int32_t x, y, z, start;
} pose_row;

static inline pose_row pose_row_of(const gjk_vec3 *row, int8_t fraction) {
  const pose_row of = {row->x, row->y, row->z, gjk_rotation_start(fraction)};
  return of;
}

// A component of gjk_rotate_onto.
static inline int32_t pose_component(pose_row row, gjk_vec3 v) {
  // |row| <= 2^30 + 1, |v| <= GJK_RADIUS_MAX < 2^28:  |sum| < 2^59
  const int64_t sum = gjk_mac32(gjk_mac32(gjk_mac32(row.start, row.x, v.x), row.y, v.y), row.z, v.z);
  const int64_t rotated = gjk_sar64(sum, 30);
  //@ assert rotated >= -GJK_RADIUS_MAX - 1 && rotated <= GJK_RADIUS_MAX + 1;
  return (int32_t)rotated;
}

#if defined(GJK_VECTORS_MULTIPLY)

// Two vertices at a time, where products of vectors are unsigned. With r for an entry, v for a coordinate, R = r + 2^30 and
// V = v + 2^28, neither negative:
//   sum of r v       = sum of R V - 2^30 (sum of V) - 2^28 (sum of r)
//   pose_component   = (start + sum of r v) / 2^30, floored
//                    = (start - 2^28 (sum of r) + sum of R V) / 2^30, floored, - (sum of V)
// modulo 2^32, since a shift modulo 2^64 keeps the low 34 bits.
typedef struct pose_rows {
  gjk_4xu32 x, y, z;  // R of a row
  gjk_2xu64 start;
} pose_rows;

#define POSE_BIAS (INT32_C(1) << 28)

static inline gjk_4xu32 all_of(uint32_t x) {
  const gjk_4xu32 all = {x, x, x, x};
  return all;
}

static inline pose_rows pose_rows_of(const gjk_vec3 *row, int8_t fraction) {
  const uint32_t bias = UINT32_C(1) << 30;
  const int64_t sum = (int64_t)row->x + row->y + row->z;  // at most 2^32 in size
  const uint64_t start = (uint64_t)(gjk_rotation_start(fraction) - sum * POSE_BIAS);
  const pose_rows of = {all_of((uint32_t)row->x + bias),
                        all_of((uint32_t)row->y + bias),
                        all_of((uint32_t)row->z + bias),
                        {start, start}};
  return of;
}

// pose_component of two vertices, at 0 and 2, by V and their sum.
static inline gjk_4x32 pose_two(const pose_rows *row, gjk_4xu32 x, gjk_4xu32 y, gjk_4xu32 z, gjk_4xu32 sum) {
  const gjk_2xu64 products = gjk_mul_even(row->x, x) + gjk_mul_even(row->y, y) + gjk_mul_even(row->z, z);
  return (gjk_4x32)((gjk_4xu32)((products + row->start) >> 30) - sum);
}

// Poses all vertices, or all but the last one. Returns how many.
static unsigned pose_pairs(const gjk_collider *c, const gjk_vec3 rows[3], gjk_vec3 *out) {
  const pose_rows of_x = pose_rows_of(&rows[0], c->fraction[0]);
  const pose_rows of_y = pose_rows_of(&rows[1], c->fraction[1]);
  const pose_rows of_z = pose_rows_of(&rows[2], c->fraction[2]);
  const gjk_vec3 *centre = &c->local_centre, *v = c->shape->vertices;
  const uint32_t bias = (uint32_t)POSE_BIAS;
  const gjk_4xu32 to_x = all_of(bias - (uint32_t)centre->x), to_y = all_of(bias - (uint32_t)centre->y),
                  to_z = all_of(bias - (uint32_t)centre->z);
  unsigned i = 0;
  for (; i + 1 < c->count; i += 2) {
    const gjk_4x32 first = gjk_load_4x32(&v[i].x), last = gjk_load_4x32(&v[i].z);  // x y z x and z x y z
    const gjk_4xu32 x = (gjk_4xu32)GJK_PICK(gjk_4x32, first, first, 0, 0, 3, 3) + to_x;
    const gjk_4xu32 y = (gjk_4xu32)GJK_PICK(gjk_4x32, first, last, 1, 1, 6, 6) + to_y;
    const gjk_4xu32 z = (gjk_4xu32)GJK_PICK(gjk_4x32, last, last, 0, 0, 3, 3) + to_z;
    const gjk_4xu32 sum = x + y + z;
    const gjk_4x32 px = pose_two(&of_x, x, y, z, sum), py = pose_two(&of_y, x, y, z, sum),
                   pz = pose_two(&of_z, x, y, z, sum);
    const gjk_4x32 xy = GJK_PICK(gjk_4x32, px, py, 0, 4, 2, 6), zx = GJK_PICK(gjk_4x32, pz, px, 0, 0, 6, 6);
    gjk_store_4x32(GJK_PICK(gjk_4x32, xy, zx, 0, 1, 4, 6), &out[i].x);  // and the second x
    out[i + 1].y = py[2];
    out[i + 1].z = pz[2];
  }
  return i;
}

#endif

static void pose_vertices(const gjk_collider *c, const gjk_vec3 rows[3], gjk_vec3 *out) {
  const pose_row x = pose_row_of(&rows[0], c->fraction[0]);
  const pose_row y = pose_row_of(&rows[1], c->fraction[1]);
  const pose_row z = pose_row_of(&rows[2], c->fraction[2]);
  const gjk_vec3 centre = c->local_centre;
  const gjk_vec3 *v = c->shape->vertices, *const end = v + c->count;
#if defined(GJK_VECTORS_MULTIPLY)
  const unsigned posed_in_pairs = pose_pairs(c, rows, out);
  v += posed_in_pairs;
  out += posed_in_pairs;
#endif
  for (; v != end; v++, out++) {
    const gjk_vec3 local = gjk_sub(*v, centre);  // gjk_collider_init:  |local| <= GJK_RADIUS_MAX
    out->x = pose_component(x, local);
    out->y = pose_component(y, local);
    out->z = pose_component(z, local);
  }
}

#endif

static void pose_hull(gjk_collider *c, const gjk_vec3 rows[3]) {
  if (c->buffer == NULL) {
    for (int i = 0; i < 3; i++) {
      c->frame[i] = rows[i];
    }
    return;
  }
  pose_vertices(c, rows, c->buffer);
}

static void pose_triangle(gjk_collider *c, const gjk_vec3 rows[3]) {
  pose_vertices(c, rows, c->frame);
}

// *middle = the middle of a coordinate from low to high. Returns half of the width, rounded up.
static uint32_t measure_axis(int32_t low, int32_t high, int32_t *middle) {
  *middle = (int32_t)gjk_sar64((int64_t)low + high, 1);
  return (uint32_t)((int64_t)high - *middle);
}

// Are the faces polygons whose corners are vertices of the hull?
static gjk_status check_faces(const gjk_hull_faces *faces, uint16_t vertices) {
  uint16_t first = 0;
  if (faces->corner == NULL || faces->end == NULL) {
    return GJK_ERROR_NULL;
  }
  for (uint32_t i = 0; i < faces->count; i++) {
    const uint16_t end = faces->end[i];
    if (end < first || end - first < 3 || end - first > GJK_FACE_CORNERS_MAX) {
      return GJK_ERROR_RANGE;
    }
    for (; first < end; first++) {
      if (faces->corner[first] >= vertices) {
        return GJK_ERROR_RANGE;
      }
    }
  }
  return GJK_OK;
}

static gjk_status measure_vertices(const gjk_shape *shape, gjk_extent *out) {
  const gjk_vec3 *v = shape->vertices;
  if (v == NULL) {
    return GJK_ERROR_NULL;
  }
  if (shape->count == 0) {
    return GJK_ERROR_EMPTY;
  }
  const gjk_status faces = shape->faces == NULL ? GJK_OK : check_faces(shape->faces, shape->count);
  if (faces != GJK_OK) {
    return faces;
  }
  gjk_vec3 low = v[0], high = v[0];
  for (uint32_t i = 1; i < shape->count; i++) {
    low.x = v[i].x < low.x ? v[i].x : low.x;
    low.y = v[i].y < low.y ? v[i].y : low.y;
    low.z = v[i].z < low.z ? v[i].z : low.z;
    high.x = v[i].x > high.x ? v[i].x : high.x;
    high.y = v[i].y > high.y ? v[i].y : high.y;
    high.z = v[i].z > high.z ? v[i].z : high.z;
  }
  uint32_t x = measure_axis(low.x, high.x, &out->centre.x);
  uint32_t y = measure_axis(low.y, high.y, &out->centre.y);
  uint32_t z = measure_axis(low.z, high.z, &out->centre.z);
  if ((x | y | z) >> 28 != 0) {  // beyond GJK_RADIUS_MAX; the squares below would not fit
    return GJK_ERROR_SIZE;
  }
  out->squared = 0;
  for (uint32_t i = 0; i < shape->count; i++) {
    gjk_vec3 offset = gjk_sub(v[i], out->centre);  // |each component| < 2^28
    uint64_t squared = (uint64_t)gjk_dot(&offset, &offset);
    out->squared = squared > out->squared ? squared : out->squared;
  }
  return GJK_OK;
}

gjk_status gjk_hull_measure(const gjk_shape *shape, gjk_extent *out) {
  return measure_vertices(shape, out);
}

void gjk_hull_pose(gjk_collider *c, const gjk_vec3 rows[3]) {
  pose_hull(c, rows);
}

int64_t gjk_hull_local_direction(const gjk_collider *c, const gjk_vec3 *d, gjk_vec3 *local) {
  return local_direction(c, d, local);
}

gjk_vec3 gjk_hull_pose_vertex(const gjk_collider *c, const gjk_vec3 rows[3], const gjk_vec3 *v) {
  return pose_vertex(c, rows, v);
}

bool gjk_hull_vertex(const gjk_collider *c, uint16_t number, gjk_vec3 *offset) {
  return vertex_hull(c, number, offset);
}

static gjk_status measure_triangle(const gjk_shape *shape, gjk_extent *out) {
  return shape->vertices == NULL || shape->count == 3 ? measure_vertices(shape, out) : GJK_ERROR_RANGE;
}

const gjk_shape_class gjk_class_triangle = {
    .measure = measure_triangle,
    .pose = pose_triangle,
    .support = support_posed,
    .refine = refine_posed,
    .vertex = vertex_posed,
    .stalls = NULL,
    .close = NULL,
    .concave = NULL,
    .buffered = false,
    .count = 3,
    .kind = GJK_KIND_VERTICES,
};

const gjk_shape_class gjk_class_hull = {
    .measure = measure_vertices,
    .pose = pose_hull,
    .support = support_hull,
    .refine = refine_hull,
    .vertex = vertex_hull,
    .stalls = NULL,
    .close = NULL,
    .concave = NULL,
    .buffered = true,
    .count = 0,
    .kind = GJK_KIND_VERTICES,
};
