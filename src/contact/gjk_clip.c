// Polygons that cover each other.
//
// Their shadows along the direction share a polygon. Its corners are corners of one within the other, and crossings of
// edges; which, is a matter of signs, and they are exact. Each point is then found from the given corners alone, and
// rounded once.
//
// Where borders nearly coincide, which of these a corner is flips with every LSB of motion. So an id tells only what a
// tolerance leaves alone:
//   1. A point near a corner of A's or B's is that corner's; of other edges it tells nothing.
//   2. Of points with the same id one stays, the deepest.
//   3. A crossing of edges at so small an angle that it bounds next to nothing is left out, unless it is deeper.
#include "gjk_clip.h"

// Of long edges, points no farther apart than this along each axis count as one: rounding moves a posed corner by up to 2
// LSB, so a motion of one moves two corners by up to 5 against each other.
#define NEAR_MIN 8

// The square of how far aside of each other two points may be that are across from each other, LSB^2, to the nearest LSB
// along each axis: less than 2 LSB.
#define ASIDE_SQUARED 1

// On which side of the lines of one polygon the corners of the other lie: bit i of [k] for corner i and line k, which starts
// at corner k. Neither: on it.
typedef struct sides {
  uint16_t inside[GJK_FACE_CORNERS_MAX], outside[GJK_FACE_CORNERS_MAX];
} sides;

typedef struct clip {
  const gjk_polygon *a, *b;
  const gjk_vec3 *centre;
  gjk_q16 margin;
  gjk_touches *out;
  sides of_a, of_b;  // the lines' owner
  uint32_t near;     // points closer than this along each axis count as one
  uint32_t flat;     // bit i: touch i is a crossing that bounds next to nothing
} clip;

static inline unsigned after(const gjk_polygon *p, unsigned i) {
  return i + 1 < p->count ? i + 1 : 0;
}

// An edge has one line, a polygon as many as corners.
static inline unsigned lines(const gjk_polygon *p) {
  return p->count > 2 ? p->count : 1;
}

static inline bool is_close(int32_t x, int32_t y, uint32_t near) {
  return (uint32_t)x - (uint32_t)y + near <= 2 * near;
}

static bool is_near_point(const gjk_vec3 *p, const gjk_vec3 *q, uint32_t near) {
  return is_close(p->x, q->x, near) && is_close(p->y, q->y, near) && is_close(p->z, q->z, near);
}

// The part that a point of p is: the first corner that it is near to, otherwise what is given.
static unsigned part_at(const clip *c, const gjk_polygon *p, const gjk_vec3 *point, unsigned otherwise) {
  for (unsigned i = 0; i < p->count; i++) {
    if (is_near_point(point, &p->corner[i], c->near)) {
      return i + (p->count > 2 ? GJK_PART_FACE_CORNER : GJK_PART_EDGE_END);
    }
  }
  return otherwise;
}

// Where the touch with this id belongs, or NULL: a deeper one is there, or no room.
static gjk_contact *place_for(gjk_touches *out, gjk_q16 distance, uint16_t id) {
  for (unsigned i = 0; i < out->count; i++) {
    if (out->touch[i].id == id) {
      return distance < out->touch[i].distance ? &out->touch[i] : NULL;
    }
  }
  return out->count < GJK_TOUCHES_MAX ? &out->touch[out->count++] : NULL;
}

// Adds a pair of points, relative to the centre.
static void add(clip *c, const gjk_vec3 *a, const gjk_vec3 *b, gjk_q16 distance, uint16_t id) {
  const gjk_vec3 *centre = c->centre;
  gjk_contact *touch = distance > c->margin ? NULL : place_for(c->out, distance, id);
  if (touch == NULL) {
    return;
  }
  touch->point_a.x = gjk_saturate((int64_t)centre->x + a->x);
  touch->point_a.y = gjk_saturate((int64_t)centre->y + a->y);
  touch->point_a.z = gjk_saturate((int64_t)centre->z + a->z);
  touch->point_b.x = gjk_saturate((int64_t)centre->x + b->x);
  touch->point_b.y = gjk_saturate((int64_t)centre->y + b->y);
  touch->point_b.z = gjk_saturate((int64_t)centre->z + b->z);
  touch->distance = distance;
  touch->id = id;
}

// How long a step is along the direction. Pre: less than 2^31 long, as between points of edges: centres are at most
// sqrt(3) 2^29 apart, with two radii of 2^28.
static gjk_q16 gap_of(const clip *c, const gjk_vec3 *step) {
  return (gjk_q16)gjk_sar64(gjk_dot(step, &c->a->direction) + (INT64_C(1) << 29), 30);
}

// The normal of the line from corner k, to the inside; scaled, so that high words tell most of its signs: at most
// sqrt(3) 2^60. An edge of no length has no sides.
static void line_normal(const gjk_polygon *p, unsigned k, gjk_long3 *n) {
  const gjk_vec3 edge = gjk_sub(p->corner[after(p, k)], p->corner[k]);
  const gjk_vec3 scaled = (edge.x | edge.y | edge.z) != 0 ? gjk_scale_direction(&edge) : edge;
  gjk_cross(&p->direction, &scaled, n);
}

static void find_sides(const gjk_polygon *p, const gjk_polygon *other, sides *out) {
  for (unsigned k = 0; k < lines(p); k++) {
    gjk_long3 n;
    line_normal(p, k, &n);
    out->inside[k] = 0;
    out->outside[k] = 0;
    for (unsigned i = 0; i < other->count; i++) {
      const gjk_vec3 v = gjk_sub(other->corner[i], p->corner[k]);
      const int side = gjk_dot_sign(&n, &v);
      const uint16_t bit = (uint16_t)(1u << i);
      out->inside[k] = (uint16_t)(out->inside[k] | (side > 0 ? bit : 0u));
      out->outside[k] = (uint16_t)(out->outside[k] | (side < 0 ? bit : 0u));
    }
  }
}

// The corners of the other that lie in p's shadow or on its border.
static unsigned covered(const gjk_polygon *p, const sides *of_p) {
  unsigned beyond = 0;
  for (unsigned k = 0; k < p->count; k++) {
    beyond |= of_p->outside[k];
  }
  return ~beyond;
}

// |x| for x = n . v, and its sign.
static int measure_side(const gjk_long3 *n, const gjk_vec3 *v, gjk_u128 *size) {
  uint32_t low;
  const int64_t high = gjk_dot_exact(n, v, &low);
  gjk_magnitude95(high, low, size);
  return high < 0 ? -1 : 1;
}

// Adds corners of one polygon with the points across from them on the plane of the other. With the plane's normal n and
// a point o on it, corner p is g = n . (p - o) / (n . direction) before it: |p - o| < 2^31, and the angle between n and
// the direction is small, so |g| < 2^31.
static void add_corners(clip *c, const gjk_polygon *from, unsigned which, const gjk_polygon *onto) {
  gjk_u128 size;
  gjk_divisor divisor;
  measure_side(&onto->normal, &onto->direction, &size);
  gjk_divisor_set(&divisor, &size);
  for (unsigned i = 0; i < from->count; i++) {
    if ((which >> i & 1u) == 0) {
      continue;
    }
    const gjk_vec3 *p = &from->corner[i], *d = &onto->direction;
    const gjk_vec3 step = gjk_sub(*p, onto->corner[0]);
    const int sign = measure_side(&onto->normal, &step, &size);
    // g = m / 2^k in LSB, 2^30 in the direction's length; |m| < 2^31, 0 <= k <= 32.
    unsigned k;
    const int32_t m = sign * gjk_divide(&size, &divisor, 30, &k);
    const int64_t half = INT64_C(1) << (29 + k);
    const gjk_vec3 across = {p->x - (int32_t)gjk_sar64(gjk_mul32(m, d->x) + half, 30 + k),
                             p->y - (int32_t)gjk_sar64(gjk_mul32(m, d->y) + half, 30 + k),
                             p->z - (int32_t)gjk_sar64(gjk_mul32(m, d->z) + half, 30 + k)};
    const gjk_q16 gap = k == 0 ? m : (gjk_q16)gjk_sar64((int64_t)m + (INT64_C(1) << (k - 1)), k);
    const unsigned part = part_at(c, from, p, GJK_PART_FACE), part_onto = part_at(c, onto, &across, GJK_PART_FACE);
    if (from == c->a) {
      add(c, p, &across, gap, gjk_touch_id(part, part_onto));
    } else {
      add(c, &across, p, gap, gjk_touch_id(part_onto, part));
    }
  }
}

// From one point part / (part + rest) of the way to another; edges are at most 2^29 long.
static gjk_vec3 between(const gjk_vec3 *from, const gjk_vec3 *to, const gjk_u128 *part, const gjk_u128 *rest) {
  const gjk_u128 none = {0, 0};
  const gjk_vec3 edge = gjk_sub(*to, *from);
  const int64_t half = INT64_C(1) << 30;
  gjk_barycentric share[2];
  gjk_barycentrics(rest, part, &none, false, share);
  const gjk_vec3 at = {from->x + (int32_t)gjk_sar64(gjk_mul32(edge.x, share[0].high) + half, 31),
                       from->y + (int32_t)gjk_sar64(gjk_mul32(edge.y, share[0].high) + half, 31),
                       from->z + (int32_t)gjk_sar64(gjk_mul32(edge.z, share[0].high) + half, 31)};
  return at;
}

// Is size, a multiple |n . v| of how far v lies from the line with normal n, no more than near?
static bool is_flat(const gjk_long3 *n, const gjk_u128 *size, uint32_t near) {
  // Of components up to 2^61: below 2^31; of the size, below 2^95, what is above 2^32.
  const uint32_t length = (uint32_t)(gjk_magnitude64(n->x) >> 32) + (uint32_t)(gjk_magnitude64(n->y) >> 32) +
                          (uint32_t)(gjk_magnitude64(n->z) >> 32);
  return (size->high << 32 | size->low >> 32) <= gjk_umul32(length, near);
}

// Where p's edge from corner i crosses line k of the other. *flat is set where the end within is next to that line.
static gjk_vec3 crossing(const clip *c, const gjk_polygon *p, unsigned i, const gjk_polygon *other,
                         const sides *of_other, unsigned k, bool *flat) {
  const gjk_vec3 *from = &p->corner[i], *to = &p->corner[after(p, i)];
  const gjk_vec3 step = gjk_sub(*from, other->corner[k]), step2 = gjk_sub(*to, other->corner[k]);
  gjk_long3 n;
  gjk_u128 part, rest;
  line_normal(other, k, &n);
  measure_side(&n, &step, &part);
  measure_side(&n, &step2, &rest);
  *flat = *flat || is_flat(&n, (of_other->inside[k] >> i & 1u) != 0 ? &part : &rest, c->near);
  return between(from, to, &part, &rest);
}

// Does p's edge from corner i cross line k of the other? One end on the line is no crossing of a polygon's border: that
// corner is covered. The line of an edge has no border, and such an end counts as inside.
static bool crosses(const gjk_polygon *p, unsigned i, const gjk_polygon *other, const sides *of_other, unsigned k) {
  const unsigned next = after(p, i), out = of_other->outside[k], in = other->count > 2 ? of_other->inside[k] : ~out;
  return ((out >> i & in >> next) | (in >> i & out >> next)) & 1u;
}

static unsigned edge_part(const gjk_polygon *p, unsigned i) {
  return p->count > 2 ? GJK_PART_FACE_EDGE + i : GJK_PART_EDGE;
}

// Do the edges of two faces bound what is shared one after the other, rather than enclose its tip?
static bool go_on(const clip *c, unsigned i, unsigned k) {
  const gjk_vec3 e = gjk_sub(c->a->corner[after(c->a, i)], c->a->corner[i]),
                 f = gjk_sub(c->b->corner[after(c->b, k)], c->b->corner[k]);
  return c->a->count > 2 && c->b->count > 2 && gjk_dot(&e, &f) < 0;  // faces turn to each other: one is clockwise
}

static void add_crossing(clip *c, unsigned i, unsigned k) {
  const gjk_polygon *a = c->a, *b = c->b;
  bool flat = false;
  const gjk_vec3 on_a = crossing(c, a, i, b, &c->of_b, k, &flat), on_b = crossing(c, b, k, a, &c->of_a, i, &flat);
  unsigned part_a = part_at(c, a, &on_a, gjk_part_of(a)), part_b = part_at(c, b, &on_b, gjk_part_of(b));
  const bool bare = part_a == gjk_part_of(a) && part_b == gjk_part_of(b);
  const unsigned count = c->out->count;
  if (bare) {
    part_a = edge_part(a, i);
    part_b = edge_part(b, k);
  }
  const gjk_vec3 step = gjk_sub(on_b, on_a);
  add(c, &on_a, &on_b, gap_of(c, &step), gjk_touch_id(part_a, part_b));
  if (bare && flat && c->out->count > count && go_on(c, i, k)) {
    c->flat |= UINT32_C(1) << count;
  }
}

static void add_crossings(clip *c) {
  const gjk_polygon *a = c->a, *b = c->b;
  for (unsigned i = 0; i < lines(a); i++) {
    for (unsigned k = 0; k < lines(b); k++) {
      if (crosses(b, k, a, &c->of_a, i) && crosses(a, i, b, &c->of_b, k)) {
        add_crossing(c, i, k);
      }
    }
  }
}

// Leaves out what bounds next to nothing and is no deeper than the others, if there are others.
static void drop_flat(clip *c) {
  gjk_touches *t = c->out;
  gjk_q16 least = INT32_MAX;
  unsigned count = 0;
  for (unsigned i = 0; i < t->count; i++) {
    if ((c->flat >> i & 1u) == 0 && t->touch[i].distance < least) {
      least = t->touch[i].distance;
    }
  }
  for (unsigned i = 0; i < t->count; i++) {
    if ((c->flat >> i & 1u) == 0 || (int64_t)t->touch[i].distance + 1 < least || least == INT32_MAX) {
      t->touch[count++] = t->touch[i];
    }
  }
  t->count = count;
}

static void clip_faces(clip *c) {
  find_sides(c->a, c->b, &c->of_a);
  find_sides(c->b, c->a, &c->of_b);
  if (c->a->count > 2) {
    add_corners(c, c->b, covered(c->a, &c->of_a), c->a);
  }
  if (c->b->count > 2) {
    add_corners(c, c->a, covered(c->b, &c->of_b), c->b);
  }
  add_crossings(c);
  if (c->flat != 0) {
    drop_flat(c);
  }
}

// An edge along a common direction: where it begins and ends there.
typedef struct edge_span {
  const gjk_polygon *edge;
  unsigned first;  // the corner where it begins
  int64_t begin, end;
} edge_span;

// The point of the edge at x.
static gjk_vec3 point_at(const edge_span *e, int64_t x) {
  const gjk_u128 before = {0, (uint64_t)(x - e->begin)}, behind = {0, (uint64_t)(e->end - x)};
  const gjk_vec3 *corner = e->edge->corner;
  if (x == e->begin || x == e->end) {
    return corner[x == e->begin ? e->first : 1 - e->first];
  }
  return between(&corner[e->first], &corner[1 - e->first], &before, &behind);
}

// A point on each edge, across from each other.
typedef struct level_pair {
  gjk_vec3 a, b;
  gjk_q16 gap;
  uint16_t id;
} level_pair;

// Finds the points at x. False: they are too far aside of each other.
static bool find_level(const clip *c, const edge_span *a, const edge_span *b, int64_t x, level_pair *out) {
  const gjk_vec3 *d = &c->a->direction, on_a = point_at(a, x), on_b = point_at(b, x), step = gjk_sub(on_b, on_a);
  const int64_t half = INT64_C(1) << 29;
  const gjk_q16 gap = gap_of(c, &step);
  const gjk_vec3 aside = {step.x - (int32_t)gjk_sar64(gjk_mul32(gap, d->x) + half, 30),
                          step.y - (int32_t)gjk_sar64(gjk_mul32(gap, d->y) + half, 30),
                          step.z - (int32_t)gjk_sar64(gjk_mul32(gap, d->z) + half, 30)};
  const gjk_q16 radius = c->a->radius < c->b->radius ? c->a->radius : c->b->radius;
  const int64_t squared = gjk_dot(&aside, &aside);
  out->a = on_a;
  out->b = on_b;
  out->gap = gap;
  out->id = gjk_touch_id(part_at(c, c->a, &on_a, GJK_PART_EDGE), part_at(c, c->b, &on_b, GJK_PART_EDGE));
  if (squared <= ASIDE_SQUARED) {
    return true;
  }
  // The sides are round there. Both points move to the middle, which leaves sides by s^2 / (2 radius): half an LSB.
  const gjk_vec3 middle = {gjk_sar32(aside.x, 1), gjk_sar32(aside.y, 1), gjk_sar32(aside.z, 1)};
  out->a = gjk_add(on_a, middle);
  out->b = gjk_add(gjk_sub(on_b, aside), middle);
  return squared <= 4 * (int64_t)radius;
}

// Parallel edges: the two ends of what they share along the middle of their directions. With edges of 2^29 and offsets
// below 2^31, products are below 2^61.
static void clip_edges(clip *c) {
  const gjk_vec3 *a = c->a->corner, *b = c->b->corner;
  const gjk_vec3 e = gjk_sub(a[1], a[0]);
  gjk_vec3 f = gjk_sub(b[1], b[0]);
  const bool turned = gjk_dot(&e, &f) < 0;
  f = turned ? gjk_negate(f) : f;
  const gjk_vec3 along = gjk_add(e, f), to_b = gjk_sub(b[turned ? 1 : 0], a[0]);
  const int64_t start = gjk_dot(&to_b, &along);
  const edge_span of_a = {c->a, 0, 0, gjk_dot(&e, &along)};
  const edge_span of_b = {c->b, turned ? 1u : 0u, start, start + gjk_dot(&f, &along)};
  const int64_t begin = of_a.begin > of_b.begin ? of_a.begin : of_b.begin;
  const int64_t end = of_a.end < of_b.end ? of_a.end : of_b.end;
  level_pair first, last;
  if (begin <= end && find_level(c, &of_a, &of_b, begin, &first) && find_level(c, &of_a, &of_b, end, &last)) {
    add(c, &first.a, &first.b, first.gap, first.id);
    add(c, &last.a, &last.b, last.gap, last.id);
  }
}

// The least of length and p's edges: |x| + |y| + |z|, below sqrt(3) 2^29.
static uint32_t shortest_edge(const gjk_polygon *p, uint32_t length) {
  for (unsigned i = 0; i < lines(p); i++) {
    const uint32_t edge = gjk_norm1(gjk_sub(p->corner[after(p, i)], p->corner[i]));
    length = edge < length ? edge : length;
  }
  return length;
}

// How near points are that count as one: a 64th of the shortest edge, or what rounding takes, but no more than a quarter.
static uint32_t nearness(const gjk_polygon *a, const gjk_polygon *b) {
  const uint32_t shortest = shortest_edge(a, shortest_edge(b, UINT32_MAX));
  return shortest >= 64 * NEAR_MIN ? shortest / 64 : shortest >= 4 * NEAR_MIN ? NEAR_MIN : shortest / 4;
}

void gjk_clip(const gjk_polygon *a, const gjk_polygon *b, const gjk_vec3 *centre, gjk_q16 margin, gjk_touches *out) {
  clip c;
  c.a = a;
  c.b = b;
  c.centre = centre;
  c.margin = margin;
  c.out = out;
  c.near = nearness(a, b);
  c.flat = 0;
  out->count = 0;
  if (a->count > 2 || b->count > 2) {
    clip_faces(&c);
  } else {
    clip_edges(&c);
  }
}
