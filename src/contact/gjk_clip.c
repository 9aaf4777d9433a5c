// Contact candidates of two polygons that meet along a direction.
//
// Seen along the direction, the polygons share a region. The corners of that region become the candidates:
//   1. Find on which side of every line of one polygon each corner of the other lies: on a grid (gjk_flat.h), and where its
//      rounding leaves a doubt exactly. So all signs are exact.
//   2. A corner of one polygon inside the face of the other is a candidate, with the point across from it on that
//      face's plane.
//   3. Two edges that cross are a candidate, with a point on each edge.
//   4. Give each candidate an id, and of candidates with one id keep the deepest.
//   5. Drop slivers: crossings that bound next to nothing and are no deeper than the rest.
// Two edges have no inside. They share an interval of their common way, whose two ends are the candidates:
//   6. Intersect the intervals. All products are exact.
//   7. Find the point of each edge at both ends. The points must lie across from each other.
//
// Borders that nearly coincide change their crossings with every LSB of motion. Ids therefore use tolerances (c->near):
// a point near a corner has the id of that corner and of no other edge; steps 4 and 5 remove what is then told twice.
//
// What is rounded, each candidate from the given corners alone and once:
//   corner         not at all
//   point across   per component to the nearest LSB, off by 2^-28 of the gap and 1/8 LSB before that
//   point of edge  per component to the nearest LSB, off by 3/4 LSB along the edge before that, on the grid by 1/2 more
//   distance       to the nearest LSB
// Polygons that spread over more than 256 units take neither the grid nor 30 bits of a plane's normal for points, but exact
// products.
#include "gjk_clip.h"

#include "gjk_flat.h"

// Points no farther apart than this along each axis count as one, unless edges are short. Rounding moves a posed corner
// by up to 2 LSB. So when a shape moves by 1 LSB, two corners move by up to 5 LSB against each other.
#define NEAR_MIN 8

// Two points are across from each other if the square of their offset aside is at most this, in LSB^2. The offset is
// rounded to the nearest LSB per axis, so it is below 2 LSB.
#define ASIDE_SQUARED 1

// Up to so many bits of spread, 256 units, 30 bits of a plane's normal serve:   3 2^bits 2^30 for n . v by 2^59 for
// n . direction, below 1/8 LSB.
#define GRID_BITS 24

// On which side of the lines of one polygon the corners of the other lie. Bit i of [k] is corner i and line k; line k
// starts at corner k. A corner with neither bit lies on the line.
typedef struct sides {
  uint16_t inside[GJK_POLYGON_CORNERS], outside[GJK_POLYGON_CORNERS];
  uint16_t crossed[GJK_POLYGON_CORNERS];  // bit i: by the edge from corner i
} sides;

typedef struct clip {
  const gjk_polygon *a, *b;
  const gjk_vec3 *centre;
  gjk_q16 margin;
  gjk_candidates *out;
  gjk_flat flat;
  sides of_a, of_b;   // relative to the lines of a, of b
  uint32_t near;      // points no farther apart than this along each axis count as one
  bool may_saturate;  // points, which are below 2^30 from the centre, may be beyond int32
  uint32_t slivers;   // bit i: candidate i is a crossing that bounds next to nothing
} clip;

static inline unsigned next_corner(const gjk_polygon *p, unsigned i) {
  return i + 1 < p->count ? i + 1 : 0;
}

// An edge has one line, a face as many as corners.
GJK_ONE_COPY static unsigned line_count(const gjk_polygon *p) {
  return p->count > 2 ? p->count : 1;
}

// The edge from corner i to the next one.
GJK_ONE_COPY static gjk_vec3 way_from_corner(const gjk_polygon *p, unsigned i) {
  return gjk_sub(p->corner[next_corner(p, i)], p->corner[i]);
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

GJK_ONE_COPY static gjk_vec3 world_point(const gjk_vec3 *centre, const gjk_vec3 *p, bool may_saturate) {
  if (!GJK_SMALL && !may_saturate) {
    return gjk_add(*centre, *p);
  }
  const gjk_vec3 moved = {gjk_saturate((int64_t)centre->x + p->x), gjk_saturate((int64_t)centre->y + p->y),
                          gjk_saturate((int64_t)centre->z + p->z)};
  return moved;
}

// Adds a pair of points, relative to c->centre. World coordinates saturate.
static void add_candidate(clip *c, const gjk_vec3 *a, const gjk_vec3 *b, gjk_q16 distance, uint16_t id) {
  const gjk_vec3 *centre = c->centre;
  gjk_contact *candidate = distance > c->margin ? NULL : slot_for(c->out, distance, id);
  if (candidate == NULL) {
    return;
  }
  candidate->point_a = world_point(centre, a, c->may_saturate);
  candidate->point_b = world_point(centre, b, c->may_saturate);
  candidate->distance = distance;
  candidate->id = id;
}

// v . a->direction, to the nearest LSB. Pre: |v| < 2^31, as it is for steps between points of the shapes:
//   centres   at most sqrt(3) 2^29 apart
//   radii     at most 2^28 each
static gjk_q16 gap_along(const clip *c, const gjk_vec3 *v) {
  return (gjk_q16)gjk_sar64(gjk_dot(v, &c->a->direction) + (INT64_C(1) << 29), 30);
}

// The normal of the line from corner k, towards the inside. Scaling leaves its signs, and lets high words settle most
// of them.
//   |direction| about 2^30, |scaled| <= sqrt(3) 2^30:  |n| at most sqrt(3) 2^60
// An edge of length 0 has the normal 0, so every corner lies on its line.
static void line_normal(const gjk_polygon *p, unsigned k, gjk_long3 *n) {
  const gjk_vec3 edge = way_from_corner(p, k);
  const gjk_vec3 scaled = (edge.x | edge.y | edge.z) != 0 ? gjk_scale_direction(&edge) : edge;
  gjk_cross(&p->direction, &scaled, n);
}

// Step 1 where the grid leaves a doubt: adds on which side of line k the corners in open lie.
GJK_OUT_OF_LINE static void add_exact_sides(const gjk_polygon *p, unsigned k, const gjk_polygon *other, unsigned open,
                                            unsigned *inside, unsigned *outside) {
  gjk_long3 n;
  line_normal(p, k, &n);
  for (unsigned i = 0; i < other->count; i++) {
    if ((open >> i & 1u) != 0) {
      const gjk_vec3 v = gjk_sub(other->corner[i], p->corner[k]);
      const int side = gjk_dot_sign(&n, &v);
      *inside |= (side > 0 ? 1u : 0u) << i;
      *outside |= (side < 0 ? 1u : 0u) << i;
    }
  }
}

// Which edges of a polygon of n corners cross a line, from where the corners are? Bit i: the one from corner i. An end on the
// line of a face is no crossing: step 2 has that corner. An edge has no inside, so an end on its line counts as inside.
static unsigned crossing_edges(unsigned n, bool of_face, unsigned inside, unsigned outside) {
  const unsigned last = n > 0 ? n - 1 : 0, all = (2u << last) - 1, in = of_face ? inside : ~outside & all;
  const unsigned out_next = outside >> 1 | (outside & 1u) << last, in_next = in >> 1 | (in & 1u) << last;
  return (outside & in_next) | (in & out_next);
}

// Step 1. The lines of B run the other way around on the grid.
static void find_sides(const gjk_polygon *p, const gjk_flat_point *of_p, const gjk_polygon *other,
                       const gjk_flat_point *of_other, bool turned, sides *out) {
  const unsigned all = (1u << other->count) - 1;
  for (unsigned k = 0; k < line_count(p); k++) {
    unsigned left = 0, right = 0;
    if (!GJK_SMALL) {
      const gjk_flat_point edge = gjk_flat_way(&of_p[k], &of_p[next_corner(p, k)]);
      // edge x (corner - start) as a difference of two products: below 2^60 each
      const int64_t start = gjk_flat_cross(edge, of_p[k]), error = gjk_flat_error(edge);
      const int64_t above = start + error, below = start - error;
      for (unsigned i = 0; i < other->count; i++) {
        const int64_t side = gjk_flat_cross(edge, of_other[i]);
        left |= (side >= above ? 1u : 0u) << i;
        right |= (side <= below ? 1u : 0u) << i;
      }
    }
    unsigned inside = turned ? right : left, outside = turned ? left : right;
    const unsigned open = all & ~(left | right);
    if (open != 0) {
      add_exact_sides(p, k, other, open, &inside, &outside);
    }
    out->inside[k] = (uint16_t)inside;
    out->outside[k] = (uint16_t)outside;
    out->crossed[k] = (uint16_t)crossing_edges(other->count, p->count > 2, inside, outside);
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

// The plane of a face, ready to tell how far a point lies before it along the direction:
//   g = n . (p - o) / (n . direction)      |p - o| < 2^31, n within 20.7 degrees of the direction
typedef struct face_plane {
  const gjk_polygon *face;
  bool exact;
  gjk_divisor divisor;  // n . direction; exact
  gjk_vec3 n;           // the normal, in 30 bits
  uint32_t inverse;     // of the leading 32 bits of n . direction
  unsigned zeros;       // before these
} face_plane;

static void set_face_plane(face_plane *of, const gjk_polygon *face, bool exact) {
  of->face = face;
  of->exact = exact;
  if (exact) {
    gjk_u128 size;
    measure_side(&face->normal, &face->direction, &size);
    gjk_divisor_set(&of->divisor, &size);
    return;
  }
  const gjk_long3 *n = &face->normal;
  const unsigned bits =
      64 - gjk_clz64(gjk_magnitude64(n->x) | gjk_magnitude64(n->y) | gjk_magnitude64(n->z) | 1u);  // at most 62
  const unsigned shift = bits > 30 ? bits - 30 : 0;
  of->n.x = (int32_t)gjk_sar64(n->x, shift);
  of->n.y = (int32_t)gjk_sar64(n->y, shift);
  of->n.z = (int32_t)gjk_sar64(n->z, shift);
  // Positive, and below 2^62: the normal is near to the direction.
  const uint64_t along = gjk_magnitude64(gjk_dot(&of->n, &face->direction)) | 1u;
  of->zeros = gjk_clz64(along);
  of->inverse = gjk_reciprocal((uint32_t)(along << of->zeros >> 32));
}

// The distance of p before the plane as m / 2^k LSB, 0 <= k <= 32; the scale 30 cancels the direction's length, 2^30.
//   off by 2^-28 of itself and 2^-32; in 30 bits by 1/8 LSB more:  |m| < 2^31
static int32_t gap_before(const face_plane *of, const gjk_vec3 *p, unsigned *k) {
  const gjk_vec3 step = gjk_sub(*p, of->face->corner[0]);
  if (of->exact) {
    gjk_u128 size;
    const int sign = measure_side(&of->face->normal, &step, &size);
    return sign * gjk_divide(&size, &of->divisor, 30, k);
  }
  const int64_t along = gjk_dot(&of->n, &step);  // |n| < 2^30, |step| < 2^(GRID_BITS + 1) per component: below 2^57
  const uint64_t size = gjk_magnitude64(along);
  const unsigned zeros = gjk_clz64(size | 1u);
  // size / (n . direction) = top / bottom 2^(of->zeros - zeros), and the share is 2^30 top / bottom, from 2^29 to 2^31.
  const uint32_t share = gjk_umulh32((uint32_t)(size << zeros >> 32), of->inverse) >> 1;
  // The gap is below 2^(GRID_BITS + 2) LSB, so zeros exceeds of->zeros.
  const unsigned scale = zeros > of->zeros ? zeros - of->zeros : 0, cut = scale > 32 ? scale - 32 : 0;
  *k = scale - cut;
  const int32_t m = cut > 31 ? 0 : (int32_t)(share >> cut);
  return along < 0 ? -m : m;
}

// Step 2: adds corners of one polygon with the points across from them on the plane of the other.
static void add_corners(clip *c, const gjk_polygon *from, unsigned which, const gjk_polygon *onto) {
  const gjk_vec3 *d = &onto->direction;
  face_plane plane;
  set_face_plane(&plane, onto, c->flat.bits > GRID_BITS);
  for (unsigned i = 0; i < from->count; i++) {
    if ((which >> i & 1u) == 0) {
      continue;
    }
    const gjk_vec3 *p = &from->corner[i];
    unsigned k;
    const int32_t m = gap_before(&plane, p, &k);
    gjk_vec3 way;
    gjk_scaled(d, m, 30 + k, &way);  // |m d| <= 2^61
    const gjk_vec3 across = gjk_sub(*p, way);
    const gjk_q16 gap = k == 0 ? m : (gjk_q16)gjk_sar64((int64_t)m + gjk_shl64(1, k - 1), k);
    const unsigned feature_from = feature_at(c, from, p, GJK_FEATURE_FACE),
                   feature_onto = feature_at(c, onto, &across, GJK_FEATURE_FACE);
    if (from == c->a) {
      add_candidate(c, p, &across, gap, gjk_contact_id(feature_from, feature_onto));
    } else {
      add_candidate(c, &across, p, gap, gjk_contact_id(feature_onto, feature_from));
    }
  }
}

// A part of the way from one point to another.
//   share    Q31, within 3 of the exact one
//   edge     at most 2^29 long:  the share moves the point by at most 3/4 LSB
//   result   per component to the nearest LSB
static gjk_vec3 point_between(const gjk_vec3 *from, const gjk_vec3 *to, int32_t share) {
  const gjk_vec3 edge = gjk_sub(*to, *from);
  gjk_vec3 way;
  gjk_scaled(&edge, share, 31, &way);
  return gjk_add(*from, way);
}

// The point that divides the way from one point to another as part to rest.
static gjk_vec3 interpolate(const gjk_vec3 *from, const gjk_vec3 *to, const gjk_u128 *part, const gjk_u128 *rest) {
  const gjk_u128 none = {0, 0};
  gjk_barycentric share[2];
  gjk_barycentrics(rest, part, &none, false, share);
  return point_between(from, to, share[0].high);
}

// A number to divide by, below 2^62.
typedef struct whole_length {
  uint64_t whole;
  unsigned zeros;
  uint32_t inverse;  // of the leading 32 bits
} whole_length;

static void set_whole(whole_length *of, uint64_t whole) {
  of->whole = whole;
  of->zeros = gjk_clz64(whole);
  of->inverse = gjk_reciprocal((uint32_t)(whole << of->zeros >> 32));
}

// part / whole, Q31. Pre: part <= whole.
static int32_t share_of(const whole_length *of, uint64_t part) {
  const uint32_t share = gjk_umulh32((uint32_t)(part << of->zeros >> 32), of->inverse);
  return share < INT32_MAX ? (int32_t)share : INT32_MAX;
}

// Is v within near of the line with normal n, by size = |n . v|? The length of n is taken as |x| + |y| + |z|, at most
// sqrt(3) times too long: near is a tolerance.
static bool is_near_line(const gjk_long3 *n, const gjk_u128 *size, uint32_t near) {
  // Components are at most 2^61, so length < 2^31. size < 2^95 is compared without its low 32 bits.
  const uint32_t length = (uint32_t)(gjk_magnitude64(n->x) >> 32) + (uint32_t)(gjk_magnitude64(n->y) >> 32) +
                          (uint32_t)(gjk_magnitude64(n->z) >> 32);
  return (size->high << 32 | size->low >> 32) <= gjk_umul32(length, near);
}

// The point where edge i of p crosses line k of other, by exact products. lines: of other.
GJK_OUT_OF_LINE static gjk_vec3 exact_crossing(const clip *c, const gjk_polygon *p, unsigned i,
                                               const gjk_polygon *other, unsigned k, const sides *lines, bool *flat) {
  const gjk_vec3 *from = &p->corner[i], *to = &p->corner[next_corner(p, i)];
  const gjk_vec3 *start = &other->corner[k], step = gjk_sub(*from, *start), step2 = gjk_sub(*to, *start);
  gjk_long3 n;
  gjk_u128 part, rest;
  line_normal(other, k, &n);
  measure_side(&n, &step, &part);
  measure_side(&n, &step2, &rest);
  *flat = *flat || is_near_line(&n, (lines->inside[k] >> i & 1u) != 0 ? &part : &rest, c->near);
  return interpolate(from, to, &part, &rest);
}

// The point of edge i of p on the grid. out: how far its start is beyond the line that it crosses; negative: inside it. of: from
// its start to its end. leaves: its end is beyond. An end that the exact sign and the rounded one have on different sides is on
// the line.
static gjk_vec3 grid_crossing(const clip *c, const gjk_polygon *p, unsigned i, int64_t out, const whole_length *of,
                              bool leaves, uint32_t line_length, bool *flat) {
  const int64_t whole = gjk_int64(of->whole), part = leaves ? -out : out, rest = whole - part;
  const int64_t inside = leaves ? part : rest;
  const uint64_t near = gjk_umul32(gjk_flat_near(&c->flat, c->near), line_length);
  *flat = *flat || inside <= 0 || (uint64_t)inside <= near;
  const int32_t share = part <= 0 ? 0 : rest <= 0 ? INT32_MAX : share_of(of, (uint64_t)part);
  return point_between(&p->corner[i], &p->corner[next_corner(p, i)], share);
}

// Where edge i of A and edge k of B cross: a point on each. On the grid both divide each other by the same two lines, so the
// points lie across from each other. flat: one of them is near to the other's line at its inner end.
//
// The grid moves a line by less than 2 of its units, 2^(bits - 28) LSB each, and so their crossing by 4 units / sin of the angle
// between them. That is at most 1/2 LSB where the sine is 2^(bits - 25); smaller ones are left to exact products.
static bool find_crossing(const clip *c, unsigned i, unsigned k, gjk_vec3 *on_a, gjk_vec3 *on_b) {
  const gjk_polygon *a = c->a, *b = c->b;
  const gjk_flat_point *of_a = c->flat.a, *of_b = c->flat.b;
  const unsigned next = next_corner(a, i), next_k = next_corner(b, k), bits = c->flat.bits;
  const gjk_flat_point e = gjk_flat_way(&of_a[i], &of_a[next]), f = gjk_flat_way(&of_b[k], &of_b[next_k]);
  const gjk_flat_point way = gjk_flat_way(&of_b[k], &of_a[i]);
  const int64_t across = gjk_flat_cross(f, e);
  const uint64_t size = gjk_magnitude64(across);
  const uint32_t length_e = gjk_flat_length(e), length_f = gjk_flat_length(f);
  bool flat = false;
  if (bits > GRID_BITS || size == 0 || size < gjk_umul32(length_e, length_f) >> (GRID_BITS + 1 - bits)) {
    *on_a = exact_crossing(c, a, i, b, k, &c->of_b, &flat);
    *on_b = exact_crossing(c, b, k, a, i, &c->of_a, &flat);
    return flat;
  }
  // The lines of B run the other way around: left of f is outside B, left of e inside A.
  whole_length of;
  set_whole(&of, size);
  *on_a = grid_crossing(c, a, i, gjk_flat_cross(f, way), &of, (c->of_b.outside[k] >> next & 1u) != 0, length_f, &flat);
  *on_b =
      grid_crossing(c, b, k, gjk_flat_cross(e, way), &of, (c->of_a.outside[i] >> next_k & 1u) != 0, length_e, &flat);
  return flat;
}

static unsigned edge_feature(const gjk_polygon *p, unsigned i) {
  return p->count > 2 ? GJK_FEATURE_FACE_EDGE + i : GJK_FEATURE_EDGE;
}

// Do the two edges of faces bound the shared region one after the other? Otherwise they enclose a tip of it. The faces
// are turned to each other, so seen along the direction one of them is clockwise.
static bool edges_continue(const clip *c, unsigned i, unsigned k) {
  const gjk_vec3 e = way_from_corner(c->a, i), f = way_from_corner(c->b, k);
  return c->a->count > 2 && c->b->count > 2 && gjk_dot(&e, &f) < 0;
}

// Step 3.
static void add_crossing(clip *c, unsigned i, unsigned k) {
  const gjk_polygon *a = c->a, *b = c->b;
  gjk_vec3 on_a, on_b;
  const bool flat = find_crossing(c, i, k, &on_a, &on_b);
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
  for (unsigned i = 0; i < line_count(c->a); i++) {
    for (unsigned k = 0; k < line_count(c->b); k++) {
      if (((unsigned)c->of_a.crossed[i] >> k & (unsigned)c->of_b.crossed[k] >> i & 1u) != 0) {
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
  gjk_flat_set(&c->flat, c->a, c->b);
  find_sides(c->a, c->flat.a, c->b, c->flat.b, false, &c->of_a);
  find_sides(c->b, c->flat.b, c->a, c->flat.a, true, &c->of_b);
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

// v as seen along the direction: without gap_along of it, which *gap tells.
static gjk_vec3 seen_along(const clip *c, const gjk_vec3 *v, gjk_q16 *gap) {
  gjk_vec3 way;
  *gap = gap_along(c, v);
  gjk_scaled(&c->a->direction, *gap, 30, &way);
  return gjk_sub(*v, way);
}

// A point on each edge, across from each other.
typedef struct opposite_pair {
  gjk_vec3 a, b;
  gjk_q16 gap;
  uint16_t id;
} opposite_pair;

// Does a move by half of aside slip along the edge by at most 1 LSB? So it leaves an end of the side by no more.
static bool stays_on(const gjk_polygon *edge, const gjk_vec3 *aside) {
  const gjk_vec3 e = gjk_sub(edge->corner[1], edge->corner[0]);
  const uint64_t along = gjk_magnitude64(gjk_dot(&e, aside));  // to be at most 2 |e| <= 2^30
  return along >> 31 == 0 && gjk_umul32((uint32_t)along, (uint32_t)along) <= 4 * (uint64_t)gjk_dot(&e, &e);
}

// Step 7: finds the points at x. False: they are too far aside of each other.
static bool find_opposite(const clip *c, const edge_span *a, const edge_span *b, int64_t x, opposite_pair *out) {
  const gjk_vec3 on_a = point_at(a, x), on_b = point_at(b, x), step = gjk_sub(on_b, on_a);
  const gjk_vec3 aside = seen_along(c, &step, &out->gap);
  const gjk_q16 radius = c->a->radius < c->b->radius ? c->a->radius : c->b->radius;
  const int64_t squared = gjk_dot(&aside, &aside);
  out->a = on_a;
  out->b = on_b;
  out->id = gjk_contact_id(feature_at(c, c->a, &on_a, GJK_FEATURE_EDGE), feature_at(c, c->b, &on_b, GJK_FEATURE_EDGE));
  if (squared <= ASIDE_SQUARED) {
    return true;
  }
  // The sides may be curved. Both points move to the middle, by s = |aside| / 2 along their tangents. They leave their
  // sides by s^2 / (2 radius), which is at most 1/2 LSB where aside^2 <= 4 radius. A sharp edge has the radius 0.
  const gjk_vec3 middle = {gjk_sar32(aside.x, 1), gjk_sar32(aside.y, 1), gjk_sar32(aside.z, 1)};
  out->a = gjk_add(on_a, middle);
  out->b = gjk_add(gjk_sub(on_b, aside), middle);
  return squared <= 4 * (int64_t)radius && stays_on(c->a, &aside) && stays_on(c->b, &aside);
}

// Where two edges lead that are turned alike: their sum as seen along the direction, so that points equally far along it lie
// across from each other, at any gap and however the edges lean. As long as 30 bits allow: what rounding leaves of the
// direction moves points by at most 2^-29 of the gap.
static gjk_vec3 common_way(const clip *c, const gjk_vec3 *e, const gjk_vec3 *f) {
  // The sum is not 0: neither edge is. |way| <= sqrt(3) 2^30.
  const gjk_vec3 sum = gjk_add(*e, *f), way = gjk_scale_direction(&sum);
  gjk_q16 lean;
  return seen_along(c, &way, &lean);
}

// Steps 6 and 7: the intervals lie along the edges' common way.
//   |e|, |f|     at most 2^29:                |along| <= sqrt(3) 2^30
//   |to_b|       below 2^31:                  products below 2^62
static void clip_edges(clip *c) {
  const gjk_vec3 *a = c->a->corner, *b = c->b->corner;
  const gjk_vec3 e = gjk_sub(a[1], a[0]);
  gjk_vec3 f = gjk_sub(b[1], b[0]);
  const bool turned = gjk_dot(&e, &f) < 0;
  f = turned ? gjk_negate(f) : f;
  const gjk_vec3 along = common_way(c, &e, &f), to_b = gjk_sub(b[turned ? 1 : 0], a[0]);
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
    const uint32_t edge = gjk_norm1(way_from_corner(p, i));
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
  c.may_saturate = ((gjk_magnitude32(centre->x) | gjk_magnitude32(centre->y) | gjk_magnitude32(centre->z)) >> 30) != 0;
  c.margin = margin;
  c.out = out;
  c.near = nearness(a, b);
  c.slivers = 0;
  out->count = 0;
  if (GJK_SHAPES >= GJK_SHAPES_BOXES && (a->count > 2 || b->count > 2)) {
    clip_faces(&c);
  } else {
    clip_edges(&c);
  }
}
