// Contact candidates of two polygons that meet along a direction.
//
// Seen along the direction, the polygons share a region. The corners of that region become the candidates:
//   1. Find on which side of every line of one polygon each corner of the other lies. All signs are exact.
//   2. A corner of one polygon inside the face of the other is a candidate, with the point across from it on that
//      face's plane.
//   3. Two edges that cross are a candidate, with a point on each edge.
//   4. Give each candidate an id, and of candidates with one id keep the deepest.
//   5. Drop slivers: crossings that bound next to nothing and are no deeper than the rest.
// Two edges have no inside. They share an interval of their common direction, whose two ends are the candidates:
//   6. Intersect the intervals. All products are exact.
//   7. Find the point of each edge at both ends. The points must lie across from each other.
//
// Borders that nearly coincide change their crossings with every LSB of motion. Ids therefore use tolerances (c->near):
// a point near a corner has the id of that corner and of no other edge; steps 4 and 5 remove what is then told twice.
//
// What is rounded, each candidate from the given corners alone and once:
//   corner         not at all
//   point across   per component to the nearest LSB, off by 2^-28 of the gap before that
//   point of edge  per component to the nearest LSB, off by 3/4 LSB along the edge before that
//   distance       to the nearest LSB
#include "gjk_clip.h"

// Points no farther apart than this along each axis count as one, unless edges are short. Rounding moves a posed corner
// by up to 2 LSB. So when a shape moves by 1 LSB, two corners move by up to 5 LSB against each other.
#define NEAR_MIN 8

// Two points are across from each other if the square of their offset aside is at most this, in LSB^2. The offset is
// rounded to the nearest LSB per axis, so it is below 2 LSB.
#define ASIDE_SQUARED 1

// On which side of the lines of one polygon the corners of the other lie. Bit i of [k] is corner i and line k; line k
// starts at corner k. A corner with neither bit lies on the line.
typedef struct sides {
  uint16_t inside[GJK_FACE_CORNERS_MAX], outside[GJK_FACE_CORNERS_MAX];
} sides;

typedef struct clip {
  const gjk_polygon *a, *b;
  const gjk_vec3 *centre;
  gjk_q16 margin;
  gjk_candidates *out;
  sides of_a, of_b;  // relative to the lines of a, of b
  uint32_t near;     // points no farther apart than this along each axis count as one
  uint32_t slivers;  // bit i: candidate i is a crossing that bounds next to nothing
} clip;

static inline unsigned next_corner(const gjk_polygon *p, unsigned i) {
  return i + 1 < p->count ? i + 1 : 0;
}

// An edge has one line, a face as many as corners.
static inline unsigned line_count(const gjk_polygon *p) {
  return p->count > 2 ? p->count : 1;
}

// |x - y| <= near. Unsigned: x - y + near wraps below 0 and exceeds 2 near.
static inline bool is_near_coordinate(int32_t x, int32_t y, uint32_t near) {
  return (uint32_t)x - (uint32_t)y + near <= 2 * near;
}

static bool is_near_point(const gjk_vec3 *p, const gjk_vec3 *q, uint32_t near) {
  return is_near_coordinate(p->x, q->x, near) && is_near_coordinate(p->y, q->y, near) &&
         is_near_coordinate(p->z, q->z, near);
}

// Step 4: the feature id of a point of p: of the first corner that it is near to, otherwise the given one.
static unsigned feature_at(const clip *c, const gjk_polygon *p, const gjk_vec3 *point, unsigned otherwise) {
  for (unsigned i = 0; i < p->count; i++) {
    if (is_near_point(point, &p->corner[i], c->near)) {
      return i + (p->count > 2 ? GJK_FEATURE_FACE_CORNER : GJK_FEATURE_EDGE_END);
    }
  }
  return otherwise;
}

// Step 4: where to write the candidate with this id. NULL: a deeper one has the id, or there is no room.
static gjk_contact *slot_for(gjk_candidates *out, gjk_q16 distance, uint16_t id) {
  for (unsigned i = 0; i < out->count; i++) {
    if (out->candidate[i].id == id) {
      return distance < out->candidate[i].distance ? &out->candidate[i] : NULL;
    }
  }
  return out->count < GJK_CANDIDATES_MAX ? &out->candidate[out->count++] : NULL;
}

// Adds a pair of points, relative to c->centre. World coordinates saturate.
static void add_candidate(clip *c, const gjk_vec3 *a, const gjk_vec3 *b, gjk_q16 distance, uint16_t id) {
  const gjk_vec3 *centre = c->centre;
  gjk_contact *candidate = distance > c->margin ? NULL : slot_for(c->out, distance, id);
  if (candidate == NULL) {
    return;
  }
  candidate->point_a.x = gjk_saturate((int64_t)centre->x + a->x);
  candidate->point_a.y = gjk_saturate((int64_t)centre->y + a->y);
  candidate->point_a.z = gjk_saturate((int64_t)centre->z + a->z);
  candidate->point_b.x = gjk_saturate((int64_t)centre->x + b->x);
  candidate->point_b.y = gjk_saturate((int64_t)centre->y + b->y);
  candidate->point_b.z = gjk_saturate((int64_t)centre->z + b->z);
  candidate->distance = distance;
  candidate->id = id;
}

// step . a->direction, to the nearest LSB. Pre: step leads between points of the shapes.
//   centres   at most sqrt(3) 2^29 apart
//   radii     at most 2^28 each:              |step| < 2^31
static gjk_q16 gap_along(const clip *c, const gjk_vec3 *step) {
  return (gjk_q16)gjk_sar64(gjk_dot(step, &c->a->direction) + (INT64_C(1) << 29), 30);
}

// The normal of the line from corner k, towards the inside. Scaling leaves its signs, and lets high words settle most
// of them.
//   |direction| about 2^30, |scaled| <= sqrt(3) 2^30:  |n| at most sqrt(3) 2^60
// An edge of length 0 has the normal 0, so every corner lies on its line.
static void line_normal(const gjk_polygon *p, unsigned k, gjk_long3 *n) {
  const gjk_vec3 edge = gjk_sub(p->corner[next_corner(p, k)], p->corner[k]);
  const gjk_vec3 scaled = (edge.x | edge.y | edge.z) != 0 ? gjk_scale_direction(&edge) : edge;
  gjk_cross(&p->direction, &scaled, n);
}

// Step 1.
static void find_sides(const gjk_polygon *p, const gjk_polygon *other, sides *out) {
  for (unsigned k = 0; k < line_count(p); k++) {
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

// The corners of the other polygon that are beyond none of p's lines: inside p or on its border, seen along the
// direction.
static unsigned corners_inside(const gjk_polygon *p, const sides *of_p) {
  unsigned beyond = 0;
  for (unsigned k = 0; k < p->count; k++) {
    beyond |= of_p->outside[k];
  }
  return ~beyond;
}

// *size = |n . v|. Returns -1 where n . v is negative, else 1.
static int measure_side(const gjk_long3 *n, const gjk_vec3 *v, gjk_u128 *size) {
  uint32_t low;
  const int64_t high = gjk_dot_exact(n, v, &low);
  gjk_magnitude95(high, low, size);
  return high < 0 ? -1 : 1;
}

// Step 2: adds corners of one polygon with the points across from them on the plane of the other. The plane has the
// normal n and contains o; corner p lies g before it along the direction:
//   g = n . (p - o) / (n . direction)      |p - o| < 2^31, n within 20.7 degrees of the direction
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
    // The scale 30 cancels the direction's length, 2^30.
    //   g = m / 2^k LSB     off by 2^-28 of itself and 2^-32;  |m| < 2^31, 0 <= k <= 32
    //   m d.x + half        |m d.x| <= 2^61, half <= 2^61:     below 2^62
    unsigned k;
    const int32_t m = sign * gjk_divide(&size, &divisor, 30, &k);
    const int64_t half = INT64_C(1) << (29 + k);
    const gjk_vec3 across = {p->x - (int32_t)gjk_sar64(gjk_mul32(m, d->x) + half, 30 + k),
                             p->y - (int32_t)gjk_sar64(gjk_mul32(m, d->y) + half, 30 + k),
                             p->z - (int32_t)gjk_sar64(gjk_mul32(m, d->z) + half, 30 + k)};
    const gjk_q16 gap = k == 0 ? m : (gjk_q16)gjk_sar64((int64_t)m + (INT64_C(1) << (k - 1)), k);
    const unsigned feature_from = feature_at(c, from, p, GJK_FEATURE_FACE),
                   feature_onto = feature_at(c, onto, &across, GJK_FEATURE_FACE);
    if (from == c->a) {
      add_candidate(c, p, &across, gap, gjk_contact_id(feature_from, feature_onto));
    } else {
      add_candidate(c, &across, p, gap, gjk_contact_id(feature_onto, feature_from));
    }
  }
}

// The point that divides the way from one point to another as part to rest.
//   share.high       within 3 of 2^31 times the exact share
//   edge             at most 2^29 long:  the share moves the point by at most 3/4 LSB
//   result           per component to the nearest LSB
static gjk_vec3 interpolate(const gjk_vec3 *from, const gjk_vec3 *to, const gjk_u128 *part, const gjk_u128 *rest) {
  gjk_u128 whole = *rest;
  const gjk_vec3 edge = gjk_sub(*to, *from);
  const int64_t half = INT64_C(1) << 30;
  gjk_barycentric share;
  gjk_u128_add(&whole, part);
  gjk_weights(part, 1, &whole, false, &share);
  const gjk_vec3 at = {from->x + (int32_t)gjk_sar64(gjk_mul32(edge.x, share.high) + half, 31),
                       from->y + (int32_t)gjk_sar64(gjk_mul32(edge.y, share.high) + half, 31),
                       from->z + (int32_t)gjk_sar64(gjk_mul32(edge.z, share.high) + half, 31)};
  return at;
}

// Is v within near of the line with normal n, by size = |n . v|? The length of n is taken as |x| + |y| + |z|, at most
// sqrt(3) times too long: near is a tolerance.
static bool is_near_line(const gjk_long3 *n, const gjk_u128 *size, uint32_t near) {
  // Components are at most 2^61, so length < 2^31. size < 2^95 is compared without its low 32 bits.
  const uint32_t length = (uint32_t)(gjk_magnitude64(n->x) >> 32) + (uint32_t)(gjk_magnitude64(n->y) >> 32) +
                          (uint32_t)(gjk_magnitude64(n->z) >> 32);
  return (size->high << 32 | size->low >> 32) <= gjk_umul32(length, near);
}

// Where p's edge from corner i crosses line k of the other polygon. Sets *flat when the edge's inner end is near that
// line.
static gjk_vec3 crossing(const clip *c, const gjk_polygon *p, unsigned i, const gjk_polygon *other,
                         const sides *of_other, unsigned k, bool *flat) {
  const gjk_vec3 *from = &p->corner[i], *to = &p->corner[next_corner(p, i)];
  const gjk_vec3 step = gjk_sub(*from, other->corner[k]), step2 = gjk_sub(*to, other->corner[k]);
  gjk_long3 n;
  gjk_u128 part, rest;
  line_normal(other, k, &n);
  measure_side(&n, &step, &part);
  measure_side(&n, &step2, &rest);
  *flat = *flat || is_near_line(&n, (of_other->inside[k] >> i & 1u) != 0 ? &part : &rest, c->near);
  return interpolate(from, to, &part, &rest);
}

// Does p's edge from corner i cross line k of the other polygon? An end on the line of a face is no crossing: step 2
// has that corner. An edge has no inside, so an end on its line counts as inside.
static bool crosses(const gjk_polygon *p, unsigned i, const gjk_polygon *other, const sides *of_other, unsigned k) {
  const unsigned next = next_corner(p, i), out = of_other->outside[k],
                 in = other->count > 2 ? of_other->inside[k] : ~out;
  return ((out >> i & in >> next) | (in >> i & out >> next)) & 1u;
}

static unsigned edge_feature(const gjk_polygon *p, unsigned i) {
  return p->count > 2 ? GJK_FEATURE_FACE_EDGE + i : GJK_FEATURE_EDGE;
}

// Do the two edges of faces bound the shared region one after the other? Otherwise they enclose a tip of it. The faces
// are turned to each other, so seen along the direction one of them is clockwise.
static bool edges_continue(const clip *c, unsigned i, unsigned k) {
  const gjk_vec3 e = gjk_sub(c->a->corner[next_corner(c->a, i)], c->a->corner[i]),
                 f = gjk_sub(c->b->corner[next_corner(c->b, k)], c->b->corner[k]);
  return c->a->count > 2 && c->b->count > 2 && gjk_dot(&e, &f) < 0;
}

// Step 3.
static void add_crossing(clip *c, unsigned i, unsigned k) {
  const gjk_polygon *a = c->a, *b = c->b;
  bool flat = false;
  const gjk_vec3 on_a = crossing(c, a, i, b, &c->of_b, k, &flat), on_b = crossing(c, b, k, a, &c->of_a, i, &flat);
  unsigned feature_a = feature_at(c, a, &on_a, gjk_feature_of(a)),
           feature_b = feature_at(c, b, &on_b, gjk_feature_of(b));
  const bool inside_both = feature_a == gjk_feature_of(a) && feature_b == gjk_feature_of(b);
  const unsigned count = c->out->count;
  if (inside_both) {
    feature_a = edge_feature(a, i);
    feature_b = edge_feature(b, k);
  }
  const gjk_vec3 step = gjk_sub(on_b, on_a);
  add_candidate(c, &on_a, &on_b, gap_along(c, &step), gjk_contact_id(feature_a, feature_b));
  if (inside_both && flat && c->out->count > count && edges_continue(c, i, k)) {
    c->slivers |= UINT32_C(1) << count;
  }
}

static void add_crossings(clip *c) {
  const gjk_polygon *a = c->a, *b = c->b;
  for (unsigned i = 0; i < line_count(a); i++) {
    for (unsigned k = 0; k < line_count(b); k++) {
      if (crosses(b, k, a, &c->of_a, i) && crosses(a, i, b, &c->of_b, k)) {
        add_crossing(c, i, k);
      }
    }
  }
}

// Step 5: drops slivers that are not deeper than all other candidates by 2 LSB, if there are others.
static void drop_slivers(clip *c) {
  gjk_candidates *t = c->out;
  gjk_q16 least = INT32_MAX;
  unsigned count = 0;
  for (unsigned i = 0; i < t->count; i++) {
    if ((c->slivers >> i & 1u) == 0 && t->candidate[i].distance < least) {
      least = t->candidate[i].distance;
    }
  }
  for (unsigned i = 0; i < t->count; i++) {
    if ((c->slivers >> i & 1u) == 0 || (int64_t)t->candidate[i].distance + 1 < least || least == INT32_MAX) {
      t->candidate[count++] = t->candidate[i];
    }
  }
  t->count = count;
}

static void clip_faces(clip *c) {
  find_sides(c->a, c->b, &c->of_a);
  find_sides(c->b, c->a, &c->of_b);
  if (c->a->count > 2) {
    add_corners(c, c->b, corners_inside(c->a, &c->of_a), c->a);
  }
  if (c->b->count > 2) {
    add_corners(c, c->a, corners_inside(c->b, &c->of_b), c->b);
  }
  add_crossings(c);
  if (c->slivers != 0) {
    drop_slivers(c);
  }
}

// The interval of an edge along the common direction of two edges.
typedef struct edge_span {
  const gjk_polygon *edge;
  unsigned first;  // the corner where it begins
  int64_t begin, end;
} edge_span;

// The point of the edge at x, begin <= x <= end; an end exactly.
static gjk_vec3 point_at(const edge_span *e, int64_t x) {
  const gjk_u128 before = {0, (uint64_t)(x - e->begin)}, behind = {0, (uint64_t)(e->end - x)};
  const gjk_vec3 *corner = e->edge->corner;
  if (x == e->begin || x == e->end) {
    return corner[x == e->begin ? e->first : 1 - e->first];
  }
  return interpolate(&corner[e->first], &corner[1 - e->first], &before, &behind);
}

// A point on each edge, across from each other.
typedef struct opposite_pair {
  gjk_vec3 a, b;
  gjk_q16 gap;
  uint16_t id;
} opposite_pair;

// Step 7: finds the points at x. False: they are too far aside of each other.
static bool find_opposite(const clip *c, const edge_span *a, const edge_span *b, int64_t x, opposite_pair *out) {
  const gjk_vec3 *d = &c->a->direction, on_a = point_at(a, x), on_b = point_at(b, x), step = gjk_sub(on_b, on_a);
  const int64_t half = INT64_C(1) << 29;
  const gjk_q16 gap = gap_along(c, &step);
  const gjk_vec3 aside = {step.x - (int32_t)gjk_sar64(gjk_mul32(gap, d->x) + half, 30),
                          step.y - (int32_t)gjk_sar64(gjk_mul32(gap, d->y) + half, 30),
                          step.z - (int32_t)gjk_sar64(gjk_mul32(gap, d->z) + half, 30)};
  const gjk_q16 radius = c->a->radius < c->b->radius ? c->a->radius : c->b->radius;
  const int64_t squared = gjk_dot(&aside, &aside);
  out->a = on_a;
  out->b = on_b;
  out->gap = gap;
  out->id = gjk_contact_id(feature_at(c, c->a, &on_a, GJK_FEATURE_EDGE), feature_at(c, c->b, &on_b, GJK_FEATURE_EDGE));
  if (squared <= ASIDE_SQUARED) {
    return true;
  }
  // The sides may be curved. Both points move to the middle, by s = |aside| / 2 along their tangents. They leave their
  // sides by s^2 / (2 radius), which is at most 1/2 LSB where aside^2 <= 4 radius. A sharp edge has the radius 0.
  const gjk_vec3 middle = {gjk_sar32(aside.x, 1), gjk_sar32(aside.y, 1), gjk_sar32(aside.z, 1)};
  out->a = gjk_add(on_a, middle);
  out->b = gjk_add(gjk_sub(on_b, aside), middle);
  return squared <= 4 * (int64_t)radius;
}

// Steps 6 and 7: the intervals lie along e + f, the sum of the edges' directions turned alike.
//   |e|, |f|     at most 2^29:                |along| <= 2^30
//   |to_b|       below 2^31:                  products below 2^61
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
  opposite_pair first, last;
  if (begin <= end && find_opposite(c, &of_a, &of_b, begin, &first) && find_opposite(c, &of_a, &of_b, end, &last)) {
    add_candidate(c, &first.a, &first.b, first.gap, first.id);
    add_candidate(c, &last.a, &last.b, last.gap, last.id);
  }
}

// The least of length and p's edges, measured as |x| + |y| + |z|: at most sqrt(3) 2^29.
static uint32_t shortest_edge(const gjk_polygon *p, uint32_t length) {
  for (unsigned i = 0; i < line_count(p); i++) {
    const uint32_t edge = gjk_norm1(gjk_sub(p->corner[next_corner(p, i)], p->corner[i]));
    length = edge < length ? edge : length;
  }
  return length;
}

// The distance along each axis within which points count as one: 1/64 of the shortest edge, at least NEAR_MIN, but at
// most 1/4 of that edge, so that its two ends stay two.
static uint32_t nearness(const gjk_polygon *a, const gjk_polygon *b) {
  const uint32_t shortest = shortest_edge(a, shortest_edge(b, UINT32_MAX));
  return shortest >= 64 * NEAR_MIN ? shortest / 64 : shortest >= 4 * NEAR_MIN ? NEAR_MIN : shortest / 4;
}

void gjk_clip(const gjk_polygon *a, const gjk_polygon *b, const gjk_vec3 *centre, gjk_q16 margin, gjk_candidates *out) {
  clip c;
  c.a = a;
  c.b = b;
  c.centre = centre;
  c.margin = margin;
  c.out = out;
  c.near = nearness(a, b);
  c.slivers = 0;
  out->count = 0;
  if (a->count > 2 || b->count > 2) {
    clip_faces(&c);
  } else {
    clip_edges(&c);
  }
}
