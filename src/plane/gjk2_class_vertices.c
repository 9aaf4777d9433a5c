// Triangle and polygon: lists of vertices.
//
// Whether a polygon's vertices are its corners in counterclockwise order, at whatever pose, is found once, from the
// shape (is_ordered). Posing rounds each vertex by at most 1/2 LSB per component beside a common rotation, so an edge
// is off by less than sqrt(2) LSB, and the cross product of two successive edges e and f by less than
//   sqrt(2) (|e| + |f|) + 2
// and 2^-28 of itself. A corner counts if its cross product is larger. If all do, and the edges turn once round, then
// they do so at every pose: while the vertices move continuously from exact to rounded places no corner becomes
// straight, so the sum of all turns, a multiple of a whole one, cannot change.
#include "gjk2_class.h"
#include "gjk2_rotation.h"

// Is a corner between two edges convex at every pose?
//   edges     components below 2^29:                 cross product below 2^60
//   (3/2) |x| + |y| is at least sqrt(2) times the length
static bool is_corner(gjk2_vec e, gjk2_vec f) {
  //@ assert e.x >= -2 * GJK2_RADIUS_MAX && e.x <= 2 * GJK2_RADIUS_MAX;
  //@ assert e.y >= -2 * GJK2_RADIUS_MAX && e.y <= 2 * GJK2_RADIUS_MAX;
  //@ assert f.x >= -2 * GJK2_RADIUS_MAX && f.x <= 2 * GJK2_RADIUS_MAX;
  //@ assert f.y >= -2 * GJK2_RADIUS_MAX && f.y <= 2 * GJK2_RADIUS_MAX;
  const int64_t turn = gjk2_cross(e, f);
  const int64_t slack = ((int64_t)gjk2_norm1(e) + gjk2_norm1(f)) * 3 / 2 + 3;
  return turn > slack + gjk_sar64(turn, 24);
}

// Does the edge point into the upper half of directions, from 0 to below pi?
static bool points_up(gjk2_vec e) {
  return e.y > 0 || (e.y == 0 && e.x > 0);
}

// Pre: coordinates are within GJK2_RADIUS_MAX of the centre of their bounding box.
static bool is_ordered(const gjk2_vec *v, uint32_t count) {
  if (count < 3) {
    return false;
  }
  unsigned changes = 0;
  gjk2_vec e = gjk2_sub(v[0], v[count - 1]);
  for (uint32_t i = 0; i < count; i++) {
    const gjk2_vec f = gjk2_sub(v[i + 1 < count ? i + 1 : 0], v[i]);
    if (!is_corner(e, f)) {
      return false;
    }
    changes += points_up(e) != points_up(f) ? 1u : 0u;
    e = f;
  }
  return changes == 2;
}

// |low - high| / 2 rounded down, and the middle, for any int32_t.
static int32_t middle(int32_t low, int32_t high) {
  return (int32_t)gjk_sar64((int64_t)low + high, 1);
}

static gjk_status measure_plane_vertices(const gjk2_shape *shape, gjk2_extent *out) {
  const gjk2_vec *v = shape->vertices;
  if (v == NULL) {
    return GJK_ERROR_NULL;
  }
  if (shape->count == 0) {
    return GJK_ERROR_EMPTY;
  }
  gjk2_vec low = v[0], high = v[0];
  for (uint32_t i = 1; i < shape->count; i++) {
    low.x = v[i].x < low.x ? v[i].x : low.x;
    low.y = v[i].y < low.y ? v[i].y : low.y;
    high.x = v[i].x > high.x ? v[i].x : high.x;
    high.y = v[i].y > high.y ? v[i].y : high.y;
  }
  const int64_t most = 2 * (int64_t)GJK2_RADIUS_MAX;
  if ((int64_t)high.x - low.x > most || (int64_t)high.y - low.y > most) {
    return GJK_ERROR_SIZE;
  }
  out->centre.x = middle(low.x, high.x);
  out->centre.y = middle(low.y, high.y);
  out->squared = 0;
  for (uint32_t i = 0; i < shape->count; i++) {
    const gjk2_vec from = gjk2_sub(v[i], out->centre);
    //@ assert from.x >= -GJK2_RADIUS_MAX && from.x <= GJK2_RADIUS_MAX;
    //@ assert from.y >= -GJK2_RADIUS_MAX && from.y <= GJK2_RADIUS_MAX;
    const uint64_t squared = (uint64_t)gjk2_dot(from, from);
    out->squared = squared > out->squared ? squared : out->squared;
  }
  out->ordered = is_ordered(v, shape->count);
  return GJK_OK;
}

static gjk_status measure_plane_triangle(const gjk2_shape *shape, gjk2_extent *out) {
  return shape->count == 3 ? measure_plane_vertices(shape, out) : GJK_ERROR_RANGE;
}

static gjk2_vec plane_posed(const gjk2_collider *c, const gjk2_vec *rotation, uint32_t i) {
  const gjk2_vec from = gjk2_sub(c->shape->vertices[i], c->local_centre);
  //@ assert from.x >= -GJK2_RADIUS_MAX && from.x <= GJK2_RADIUS_MAX;
  //@ assert from.y >= -GJK2_RADIUS_MAX && from.y <= GJK2_RADIUS_MAX;
  return gjk2_rotate_onto(rotation, from, c->fraction);
}

static void pose_plane_triangle(gjk2_collider *c, const gjk2_vec *rotation) {
  for (uint32_t i = 0; i < 3; i++) {
    c->frame[i] = plane_posed(c, rotation, i);
  }
  const gjk2_vec e = gjk2_sub(c->frame[1], c->frame[0]), f = gjk2_sub(c->frame[2], c->frame[0]);
  c->ordered = gjk2_cross(e, f) > 0;
}

static void pose_polygon(gjk2_collider *c, const gjk2_vec *rotation) {
  c->frame[0] = *rotation;
  if (GJK_SMALL) {
    for (uint32_t i = 0; c->buffer != NULL && i < c->count; i++) {
      c->buffer[i] = plane_posed(c, rotation, i);
    }
    return;
  }
  // As plane_posed, of numbers that no store to the buffer can change.
  const gjk2_vec centre = {c->local_centre.x, c->local_centre.y};
  const gjk2_vec *const vertices = c->shape->vertices;
  gjk2_vec *const buffer = c->buffer;
  const uint32_t count = buffer != NULL ? c->count : 0;
#if GJK_64_BIT
  const int64_t cosine = rotation->x, sine = rotation->y, half = INT64_C(1) << 29, step = INT64_C(1) << 22;
  // Half an LSB and the fraction, less the rotated centre: below 2^61.6 in size, and partial sums with a vertex below 2^63.
  const int64_t x = half + c->fraction[0] * step - (cosine * centre.x - sine * centre.y);
  const int64_t y = half + c->fraction[1] * step - (sine * centre.x + cosine * centre.y);
  for (uint32_t i = 0; i < count; i++) {
    const int64_t u = vertices[i].x, v = vertices[i].y;
    buffer[i].x = (int32_t)gjk_sar64(x + cosine * u - sine * v, 30);
    buffer[i].y = (int32_t)gjk_sar64(y + sine * u + cosine * v, 30);
  }
#else
  const gjk2_vec unit = {rotation->x, rotation->y};
  const int8_t fraction[2] = {c->fraction[0], c->fraction[1]};
  for (uint32_t i = 0; i < count; i++) {
    buffer[i] = gjk2_rotate_onto(&unit, gjk2_sub(vertices[i], centre), fraction);
  }
#endif
}

// How far vertices are along d: exactly; or on cores without a long multiplication by products of directions and vertices
// truncated to 15 bits, which cost a fifth of exact ones. They tell which vertices can be the farther ones:
//   v = 2^vs vc + r,  0 <= r < 2^vs,  |vc| <= 2^14        d = 2^ds dc + q,  0 <= q < 2^ds,  |dc| <= 2^15
//   v . d / 2^(vs + ds) - vc . dc = vc . q / 2^ds + r . d / 2^(vs + ds), at most 2 2^14 + 2 2^15 in size
//   |vc . dc| <= 2^30
#if GJK_NARROW_MULTIPLY
#define COARSE_ERROR (2 * INT32_C(16384) + 2 * INT32_C(32768))

typedef int32_t plane_height;

typedef struct plane_ruler {
  gjk2_vec d, coarse;
  unsigned shift;
} plane_ruler;

// Pre: |v| <= radius.
static inline plane_ruler ruler_along(const gjk2_vec *d, gjk_q16 radius) {
  const unsigned v_bits = 32 - gjk_clz32((uint32_t)radius);
  const unsigned d_bits = 32 - gjk_clz32(gjk_magnitude32(d->x) | gjk_magnitude32(d->y)),
                 ds = d_bits > 15 ? d_bits - 15 : 0;
  const plane_ruler ruler = {*d, {gjk_sar32(d->x, ds), gjk_sar32(d->y, ds)}, v_bits > 14 ? v_bits - 14 : 0};
  return ruler;
}

static inline plane_height ruler_height(const plane_ruler *r, const gjk2_vec *v) {
  return gjk_sar32(v->x, r->shift) * r->coarse.x + gjk_sar32(v->y, r->shift) * r->coarse.y;
}

// Is p farther than q?
static inline bool is_higher(const plane_ruler *r, plane_height of_p, plane_height of_q, const gjk2_vec *p,
                             const gjk2_vec *q) {
  const int32_t slack = 2 * COARSE_ERROR;
  return of_p > of_q + slack || (of_p >= of_q - slack && gjk2_dot(gjk2_sub(*p, *q), r->d) > 0);
}
#else
typedef int64_t plane_height;

typedef struct plane_ruler {
  gjk2_vec d;
} plane_ruler;

static inline plane_ruler ruler_along(const gjk2_vec *d, gjk_q16 radius) {
  const plane_ruler ruler = {*d};
  (void)radius;
  return ruler;
}

static inline plane_height ruler_height(const plane_ruler *r, const gjk2_vec *v) {
  return gjk2_dot(*v, r->d);  // |v| < 2^28, |d| <= 3 2^29:  below 2^59
}

static inline bool is_higher(const plane_ruler *r, plane_height of_p, plane_height of_q, const gjk2_vec *p,
                             const gjk2_vec *q) {
  (void)r;
  (void)p;
  (void)q;
  return of_p > of_q;
}
#endif

// The first of count vertices that is farthest along d. Pre: count >= 1, |v| <= radius.
static void scan_list(const gjk2_vec *v, uint32_t count, gjk_q16 radius, const gjk2_vec *d, gjk2_support *out) {
  const plane_ruler ruler = ruler_along(d, radius);
  const gjk2_vec *best = v, *const end = v + count;
  plane_height most = ruler_height(&ruler, v);
  for (const gjk2_vec *p = v + 1; p < end; p++) {
    const plane_height height = ruler_height(&ruler, p);
    if (is_higher(&ruler, height, most, p, best)) {
      most = height;
      best = p;
    }
  }
  gjk2_copy(&out->offset, best);
  out->vertex = (uint16_t)(best - v);
}

#if !GJK_SMALL
// The same where the vertices are corners in order. Along d they rise to the farthest one and fall again, and at most two
// successive ones are equally far. So this climbs from the first vertex, the one way or the other.
static void climb_list(const gjk2_vec *v, uint32_t count, gjk_q16 radius, const gjk2_vec *d, gjk2_support *out) {
  const plane_ruler ruler = ruler_along(d, radius);
  const gjk2_vec *best = v, *const end = v + count;
  plane_height most = ruler_height(&ruler, v), height = ruler_height(&ruler, v + 1);
  if (is_higher(&ruler, height, most, v + 1, v)) {
    do {  // at most once for each vertex
      most = height;
      best++;
      if (best + 1 == end) {
        break;
      }
      height = ruler_height(&ruler, best + 1);
    } while (is_higher(&ruler, height, most, best + 1, best));
  } else {
    height = ruler_height(&ruler, end - 1);
    if (is_higher(&ruler, height, most, end - 1, v)) {
      best = end;
      do {  // at most once for each vertex: the first is less far
        most = height;
        best--;
        height = ruler_height(&ruler, best - 1);
      } while (!is_higher(&ruler, most, height, best, best - 1));
    }
  }
  gjk2_copy(&out->offset, best);
  out->vertex = (uint16_t)(best - v);
}
#endif

static void support_triangle(const gjk2_collider *c, const gjk2_vec *d, gjk2_support *out) {
  scan_list(c->frame, 3, c->core_radius, d, out);
}

static gjk2_vec posed_vertex(const gjk2_collider *c, uint32_t i) {
  return c->buffer != NULL ? c->buffer[i] : plane_posed(c, &c->frame[0], i);
}

#if GJK_SMALL
static void support_polygon(const gjk2_collider *c, const gjk2_vec *d, gjk2_support *out) {
  int64_t most = INT64_MIN;
  for (uint32_t i = 0; i < c->count; i++) {
    const gjk2_vec v = posed_vertex(c, i);
    const int64_t along = gjk2_dot(v, *d);  // |v| < 2^28, |d| <= 3 2^29:  below 2^59
    if (along > most) {
      most = along;
      gjk2_copy(&out->offset, &v);
      out->vertex = (uint16_t)i;
    }
  }
}
#else
// The vertex that the scan_list of posed vertices would find, by one of the shape's own vertices along d rotated back.
//   rotated back, d is off by less than 1 in each component:             |v| 2 < 2^30, off by less than 2 core_radius
//   a posed vertex is off by less than 3/4 and 1/2 per component:        5/4 (|d.x| + |d.y|)
// Two vertices are ordered wrongly only within twice that; there posed ones are compared.
GJK_OUT_OF_LINE static void scan_plane_lazy(const gjk2_collider *c, const gjk2_vec *d, gjk2_support *out) {
  const gjk2_vec local = gjk2_rotate_back(&c->frame[0], *d);
  const int64_t slack = 4 * (int64_t)c->core_radius + 3 * (int64_t)gjk2_norm1(*d);
  uint32_t best = 0;
  int64_t most = INT64_MIN / 2, exact = 0;
  bool known = false;  // is exact that of the best posed vertex along d?
  for (uint32_t i = 0; i < c->count; i++) {
    const int64_t along = gjk2_dot(gjk2_sub(c->shape->vertices[i], c->local_centre), local);
    if (along < most - slack) {
      continue;
    }
    if (along <= most + slack) {
      exact = known ? exact : gjk2_dot(plane_posed(c, &c->frame[0], best), *d);
      known = true;
      const int64_t other = gjk2_dot(plane_posed(c, &c->frame[0], i), *d);
      if (other <= exact) {
        continue;
      }
      exact = other;
    } else {
      known = false;
    }
    most = along;
    best = i;
  }
  out->offset = plane_posed(c, &c->frame[0], best);
  out->vertex = (uint16_t)best;
}

// Is the posed vertex q farther along d than p? local: d rotated back. Within slack the shape's own vertices do not tell.
static inline bool is_farther_lazy(const gjk2_collider *c, const gjk2_vec *p, const gjk2_vec *q, const gjk2_vec *local,
                                   int64_t slack, const gjk2_vec *d) {
  const int64_t gain = gjk2_dot(gjk2_sub(*q, *p), *local);
  if (gain > slack || gain < -slack) {
    return gain > 0;
  }
  const gjk2_vec *v = c->shape->vertices;
  const gjk2_vec at_p = plane_posed(c, &c->frame[0], (uint32_t)(p - v)),
                 at_q = plane_posed(c, &c->frame[0], (uint32_t)(q - v));
  return gjk2_dot(gjk2_sub(at_q, at_p), *d) > 0;
}

// climb_list for a lazy collider, with the bound of scan_plane_lazy.
GJK_OUT_OF_LINE static void climb_plane_lazy(const gjk2_collider *c, const gjk2_vec *d, gjk2_support *out) {
  const gjk2_vec local = gjk2_rotate_back(&c->frame[0], *d);
  const int64_t slack = 4 * (int64_t)c->core_radius + 3 * (int64_t)gjk2_norm1(*d);
  const gjk2_vec *const v = c->shape->vertices, *const end = v + c->count, *best = v;
  if (is_farther_lazy(c, v, v + 1, &local, slack, d)) {
    do {  // at most once for each vertex
      best++;
    } while (best + 1 != end && is_farther_lazy(c, best, best + 1, &local, slack, d));
  } else if (is_farther_lazy(c, v, end - 1, &local, slack, d)) {
    best = end;
    do {  // at most once for each vertex: the first is less far
      best--;
    } while (!is_farther_lazy(c, best - 1, best, &local, slack, d));
  }
  const uint32_t index = (uint32_t)(best - v);
  out->offset = plane_posed(c, &c->frame[0], index);
  out->vertex = (uint16_t)index;
}

static void support_polygon(const gjk2_collider *c, const gjk2_vec *d, gjk2_support *out) {
  if (c->buffer == NULL) {
    if (c->ordered) {
      climb_plane_lazy(c, d, out);
    } else {
      scan_plane_lazy(c, d, out);
    }
  } else if (c->ordered) {
    climb_list(c->buffer, c->count, c->core_radius, d, out);
  } else {
    scan_list(c->buffer, c->count, c->core_radius, d, out);
  }
}
#endif

static bool vertex_triangle(const gjk2_collider *c, uint16_t number, gjk2_vec *offset) {
  if (number >= 3) {
    return false;
  }
  *offset = c->frame[number];
  return true;
}

static bool vertex_polygon(const gjk2_collider *c, uint16_t number, gjk2_vec *offset) {
  if (number >= c->count) {
    return false;
  }
  *offset = posed_vertex(c, number);
  return true;
}

static void adjacent_vertices(const gjk2_collider *c, const gjk2_support *from, bool following, gjk2_support *way) {
  unsigned number = from->vertex;
  if (following) {
    number = number + 1 < c->count ? number + 1 : 0;
  } else {
    number = (number > 0 ? number : c->count) - 1u;
  }
  way->vertex = (uint16_t)number;
  const gjk2_vec *v = c->buffer != NULL ? c->buffer : c->frame;
  if (c->buffer == NULL && c->shape->type->buffered) {
    way->offset = gjk2_sub(plane_posed(c, v, number), from->offset);
  } else {
    way->offset = gjk2_sub(v[number], from->offset);
  }
}

const gjk2_shape_class gjk2_class_triangle = {
    .measure = measure_plane_triangle,
    .pose = pose_plane_triangle,
    .support = support_triangle,
    .vertex = vertex_triangle,
    .adjacent = adjacent_vertices,
    .depth = NULL,
    .touch = NULL,
    .ground = NULL,
    .buffered = false,
    .count = 3,
};

const gjk2_shape_class gjk2_class_polygon = {
    .measure = measure_plane_vertices,
    .pose = pose_polygon,
    .support = support_polygon,
    .vertex = vertex_polygon,
    .adjacent = adjacent_vertices,
    .depth = NULL,
    .touch = NULL,
    .ground = NULL,
    .buffered = true,
    .count = 0,
};
