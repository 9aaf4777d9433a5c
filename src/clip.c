// Polygons that cover each other.
//
// Their shadows along the direction share a polygon. Its corners are corners of one within the other, and crossings of
// edges; which, is a matter of signs, and they are exact. Each point is then found from the given corners alone, and
// rounded once.
#include "clip.h"

#include "unit.h"
#include "witness.h"

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
} clip;

static inline unsigned after(const gjk_polygon *p, unsigned i) {
  return i + 1 < p->count ? i + 1 : 0;
}

// An edge has one line, a polygon as many as corners.
static inline unsigned lines(const gjk_polygon *p) {
  return p->count > 2 ? p->count : 1;
}

// Adds a pair of points, relative to the centre.
static void add(clip *c, const gjk_vec3 *a, const gjk_vec3 *b, gjk_q16 distance, uint16_t id) {
  const gjk_vec3 *centre = c->centre;
  bool cut;
  if (distance > c->margin || c->out->count == GJK_TOUCHES_MAX) {
    return;
  }
  gjk_contact *touch = &c->out->touch[c->out->count++];
  touch->point_a.x = gjk_saturate((int64_t)centre->x + a->x, &cut);
  touch->point_a.y = gjk_saturate((int64_t)centre->y + a->y, &cut);
  touch->point_a.z = gjk_saturate((int64_t)centre->z + a->z, &cut);
  touch->point_b.x = gjk_saturate((int64_t)centre->x + b->x, &cut);
  touch->point_b.y = gjk_saturate((int64_t)centre->y + b->y, &cut);
  touch->point_b.z = gjk_saturate((int64_t)centre->z + b->z, &cut);
  touch->distance = distance;
  touch->id = id;
}

// The gap of two points of edges, along the direction.
static void add_between(clip *c, const gjk_vec3 *a, const gjk_vec3 *b, uint16_t id) {
  const gjk_vec3 step = gjk_sub(*b, *a);  // less than 2^31 long: centres at most sqrt(3) 2^29 apart, two radii of 2^28
  add(c, a, b, (gjk_q16)gjk_sar64(gjk_dot(&step, &c->a->direction) + (INT64_C(1) << 29), 30), id);
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

// The corners of the other that coincide with a corner of p: they are on two lines of it.
static unsigned coincident(const gjk_polygon *p, const sides *of_p) {
  unsigned both = 0, on_last = ~((unsigned)of_p->inside[p->count - 1] | of_p->outside[p->count - 1]);
  for (unsigned k = 0; k < p->count; k++) {
    const unsigned on = ~((unsigned)of_p->inside[k] | of_p->outside[k]);
    both |= on & on_last;
    on_last = on;
  }
  return both;
}

// |x| for x = n . v, and its sign.
static int measure(const gjk_long3 *n, const gjk_vec3 *v, gjk_u128 *size) {
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
  measure(&onto->normal, &onto->direction, &size);
  gjk_divisor_set(&divisor, &size);
  for (unsigned i = 0; i < from->count; i++) {
    if ((which >> i & 1u) == 0) {
      continue;
    }
    const gjk_vec3 *p = &from->corner[i], *d = &onto->direction;
    const gjk_vec3 step = gjk_sub(*p, onto->corner[0]);
    const int sign = measure(&onto->normal, &step, &size);
    // g = m / 2^k in LSB, 2^30 in the direction's length; |m| < 2^31, 0 <= k <= 32.
    unsigned k;
    const int32_t m = sign * gjk_divide(&size, &divisor, 30, &k);
    const int64_t half = INT64_C(1) << (29 + k);
    const gjk_vec3 across = {p->x - (int32_t)gjk_sar64(gjk_mul32(m, d->x) + half, 30 + k),
                             p->y - (int32_t)gjk_sar64(gjk_mul32(m, d->y) + half, 30 + k),
                             p->z - (int32_t)gjk_sar64(gjk_mul32(m, d->z) + half, 30 + k)};
    const gjk_q16 gap = k == 0 ? m : (gjk_q16)gjk_sar64((int64_t)m + (INT64_C(1) << (k - 1)), k);
    const unsigned part = i + (from->count > 2 ? GJK_PART_FACE_CORNER : GJK_PART_EDGE_END);
    if (from == c->a) {
      add(c, p, &across, gap, gjk_touch_id(part, GJK_PART_FACE));
    } else {
      add(c, &across, p, gap, gjk_touch_id(GJK_PART_FACE, part));
    }
  }
}

// From one point part / (part + rest) of the way to another; edges are at most 2^29 long.
static gjk_vec3 between(const gjk_vec3 *from, const gjk_vec3 *to, const gjk_u128 *part, const gjk_u128 *rest) {
  const gjk_u128 none = {0, 0};
  const gjk_vec3 edge = gjk_sub(*to, *from);
  const int64_t half = INT64_C(1) << 30;
  gjk_share share[2];
  gjk_shares(rest, part, &none, false, share);
  const gjk_vec3 at = {from->x + (int32_t)gjk_sar64(gjk_mul32(edge.x, share[0].high) + half, 31),
                       from->y + (int32_t)gjk_sar64(gjk_mul32(edge.y, share[0].high) + half, 31),
                       from->z + (int32_t)gjk_sar64(gjk_mul32(edge.z, share[0].high) + half, 31)};
  return at;
}

// Where p's edge from corner i crosses line k of the other.
static gjk_vec3 crossing(const gjk_polygon *p, unsigned i, const gjk_polygon *other, unsigned k) {
  const gjk_vec3 *from = &p->corner[i], *to = &p->corner[after(p, i)];
  const gjk_vec3 step = gjk_sub(*from, other->corner[k]), step2 = gjk_sub(*to, other->corner[k]);
  gjk_long3 n;
  gjk_u128 part, rest;
  line_normal(other, k, &n);
  measure(&n, &step, &part);
  measure(&n, &step2, &rest);
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

static void add_crossings(clip *c) {
  const gjk_polygon *a = c->a, *b = c->b;
  for (unsigned i = 0; i < lines(a); i++) {
    for (unsigned k = 0; k < lines(b); k++) {
      if (crosses(b, k, a, &c->of_a, i) && crosses(a, i, b, &c->of_b, k)) {
        const gjk_vec3 on_a = crossing(a, i, b, k), on_b = crossing(b, k, a, i);
        add_between(c, &on_a, &on_b, gjk_touch_id(edge_part(a, i), edge_part(b, k)));
      }
    }
  }
}

static void clip_faces(clip *c) {
  find_sides(c->a, c->b, &c->of_a);
  find_sides(c->b, c->a, &c->of_b);
  const unsigned coinciding = c->a->count > 2 && c->b->count > 2 ? coincident(c->b, &c->of_b) : 0;
  if (c->a->count > 2) {
    add_corners(c, c->b, covered(c->a, &c->of_a), c->a);
  }
  if (c->b->count > 2) {
    add_corners(c, c->a, covered(c->b, &c->of_b) & ~coinciding, c->b);
  }
  add_crossings(c);
}

// |e x f| <= |e| |f| / 32? Both are not 0.
static bool are_parallel(const gjk_vec3 *e, const gjk_vec3 *f) {
  const gjk_unit3 u = gjk_unit(e), v = gjk_unit(f);
  const gjk_vec3 s = {u.x, u.y, u.z}, t = {v.x, v.y, v.z};
  gjk_long3 n;
  gjk_cross(&s, &t, &n);
  const gjk_vec3 sine = {(int32_t)gjk_sar64(n.x, 30), (int32_t)gjk_sar64(n.y, 30), (int32_t)gjk_sar64(n.z, 30)};
  return gjk_dot(&sine, &sine) <= INT64_C(1) << 50;
}

// An edge along a common direction: where it begins and ends there.
typedef struct extent {
  const gjk_polygon *edge;
  unsigned first;  // the corner where it begins
  int64_t begin, end;
} extent;

// The point of the edge at x; its part.
static gjk_vec3 point_at(const extent *e, int64_t x, unsigned *part) {
  const gjk_u128 before = {0, (uint64_t)(x - e->begin)}, behind = {0, (uint64_t)(e->end - x)};
  const gjk_vec3 *corner = e->edge->corner;
  if (x == e->begin || x == e->end) {
    const unsigned i = x == e->begin ? e->first : 1 - e->first;
    *part = GJK_PART_EDGE_END + i;
    return corner[i];
  }
  *part = GJK_PART_EDGE;
  return between(&corner[e->first], &corner[1 - e->first], &before, &behind);
}

static void add_level(clip *c, const extent *a, const extent *b, int64_t x) {
  unsigned part_a, part_b;
  const gjk_vec3 on_a = point_at(a, x, &part_a), on_b = point_at(b, x, &part_b);
  add_between(c, &on_a, &on_b, gjk_touch_id(part_a, part_b));
}

// Parallel edges: the two ends of what they share along the middle of their directions. With edges of 2^29 and offsets
// below 2^31, products are below 2^61.
static void clip_edges(clip *c) {
  const gjk_vec3 *a = c->a->corner, *b = c->b->corner;
  const gjk_vec3 e = gjk_sub(a[1], a[0]);
  gjk_vec3 f = gjk_sub(b[1], b[0]);
  const bool turned = gjk_dot(&e, &f) < 0;
  if (!are_parallel(&e, &f)) {
    return;
  }
  f = turned ? gjk_negate(f) : f;
  const gjk_vec3 along = gjk_add(e, f), to_b = gjk_sub(b[turned ? 1 : 0], a[0]);
  const int64_t start = gjk_dot(&to_b, &along);
  const extent of_a = {c->a, 0, 0, gjk_dot(&e, &along)};
  const extent of_b = {c->b, turned ? 1 : 0, start, start + gjk_dot(&f, &along)};
  const int64_t begin = of_a.begin > of_b.begin ? of_a.begin : of_b.begin;
  const int64_t end = of_a.end < of_b.end ? of_a.end : of_b.end;
  if (begin <= end) {
    add_level(c, &of_a, &of_b, begin);
  }
  if (begin < end) {
    add_level(c, &of_a, &of_b, end);
  }
}

void gjk_clip(const gjk_polygon *a, const gjk_polygon *b, const gjk_vec3 *centre, gjk_q16 margin, gjk_touches *out) {
  clip c;
  c.a = a;
  c.b = b;
  c.centre = centre;
  c.margin = margin;
  c.out = out;
  out->count = 0;
  if (a->count > 2 || b->count > 2) {
    clip_faces(&c);
  } else {
    clip_edges(&c);
  }
}
