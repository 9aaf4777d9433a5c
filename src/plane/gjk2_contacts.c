// The contact manifold of the plane: the stretch along which two shapes lie across from each other.
//
//   1. Ask gjk2_signed_distance for the normal, the distance and the nearest points. Beyond margin there is no contact.
//   2. Find the edge with which each shape meets the normal, moved outwards by the convex radius; or a corner.
//   3. Of two edges: the ends of the stretch that they share, measured along the normal's left, are the candidates.
//   4. Admit the nearest points of step 1 unless a candidate is as near.
//   5. Keep at most `most` candidates.
//
// What is rounded:
//   step 1   the points, each within 1 LSB of its shape; a depth, up to the next LSB
//   step 2   the move of an edge by its convex radius: below 2 LSB for edges that are long enough
//   step 3   points of edges, points across from a corner, and gaps: to the nearest LSB
#include "gjk2/contacts.h"

#include "gjk2_facing.h"
#include "gjk2_hull.h"
#include "gjk2_measure.h"

// Centres farther apart than this along an axis skip steps 2 and 3: the nearest points are the one contact. Otherwise
// coordinates relative to A's centre are below 2^29 + 2^28.
#define STRETCH_REACH (INT32_C(1) << 29)

// Step 4 admits the nearest points when every candidate is farther by more than this, LSB.
#define NEAREST_SLACK 2

// The byte that stands for an edge in an id; a corner's is its number modulo 128.
#define ID_EDGE 255
#define ID_CORNERS 127

// What a shape meets the normal with. Of two ends the first has the lower place.
typedef struct plane_side {
  gjk2_vec end[2];   // relative to A's centre
  int64_t place[2];  // along the normal's left, Q30
  uint16_t number[2];
  uint8_t count;  // 0: a curved shape; 1: a corner; 2: an edge
} plane_side;

static bool plane_is_within_reach(const gjk2_collider *a, const gjk2_collider *b) {
  const int64_t x = (int64_t)a->centre.x - b->centre.x, y = (int64_t)a->centre.y - b->centre.y;
  return x <= STRETCH_REACH && x >= -STRETCH_REACH && y <= STRETCH_REACH && y >= -STRETCH_REACH;
}

// Moves the edge outwards, to the side where towards points, by the convex radius.
static void widen(plane_side *of, gjk2_vec edge, gjk2_vec towards, gjk_q16 convex_radius) {
  gjk2_length length;
  gjk2_vec n = gjk2_outward(edge);
  n = gjk2_dot(n, towards) < 0 ? gjk2_negate(n) : n;
  gjk2_unit u;
  gjk2_normal_set(&u, &length, &n);
  const int64_t half = INT64_C(1) << 29;
  const gjk2_vec outwards = {(int32_t)gjk_sar64(gjk_mac32(half, u.x, convex_radius), 30),
                             (int32_t)gjk_sar64(gjk_mac32(half, u.y, convex_radius), 30)};
  of->end[0] = gjk2_add(of->end[0], outwards);
  of->end[1] = gjk2_add(of->end[1], outwards);
}

// An edge, as the way from a corner that is farthest along the normal.
typedef struct plane_edge {
  gjk2_support way;
  int64_t along;  // way . normal, not positive;  |way| < 2^30 and units of Q30:  products below 2^60
  int64_t left;   // way . the normal's left
} plane_edge;

// Does the edge e lie nearer to straight across the normal than f? Both lead away from the same corner.
static bool is_flatter(const plane_edge *e, const plane_edge *f) {
  const int64_t p = e->along, q = gjk_int64(gjk_magnitude64(f->left));
  const int64_t r = -f->along, s = gjk_int64(gjk_magnitude64(e->left));
  // (p q + r s) / 2^64 is off by less than slack: the truncated parts are below 1 each.
  const int32_t ph = gjk_high32(p), qh = gjk_high32(q), rh = gjk_high32(r), sh = gjk_high32(s);
  const int64_t sum = gjk_mac32(gjk_mul32(ph, qh), rh, sh);
  const int64_t slack = (int64_t)gjk_magnitude32(ph) + qh + gjk_magnitude32(rh) + sh + 2;
  if (sum > slack || sum < -slack) {
    return sum > 0;
  }
  return gjk_sum_of_products_sign_exact(p, q, r, s) > 0;
}

// Is the edge within 20 degrees of straight across the normal, and long enough for its convex radius?
//   posing turns an edge by up to 2 / |e|, which moves the surface by convex_radius 2 / |e|^2 along the normal, and the
//   ends by twice convex_radius / |e| along the edge
static bool plane_is_level(const plane_edge *e, gjk_q16 convex_radius) {
  const uint64_t across = gjk_magnitude64(e->along), along = gjk_magnitude64(e->left);
  return across <= (along >> 10) * 373 &&  // tan 20 = 372.7 / 1024
         (convex_radius == 0 || gjk2_dot(e->way.offset, e->way.offset) >= 36 * (int64_t)convex_radius);
}

// The same of a segment, whose only edge leads to its other end. False: both ends are as far.
static bool find_end(const gjk2_collider *c, const gjk2_vec *normal, gjk2_support *corner, plane_edge *edge) {
  gjk2_support end[2];
  for (uint16_t k = 0; k < 2; k++) {
    end[k].vertex = k;
    (void)c->shape->type->vertex(c, k, &end[k].offset);
  }
  const int64_t along = gjk2_dot(gjk2_sub(end[1].offset, end[0].offset), *normal);
  const unsigned far = along > 0 ? 1 : 0;
  gjk2_copy_support(corner, &end[far]);
  edge->way.offset = gjk2_sub(end[1 - far].offset, end[far].offset);
  edge->way.vertex = end[1 - far].vertex;
  edge->along = along > 0 ? -along : along;
  return along != 0;
}

// The corner farthest along the normal, of several the last one counterclockwise, with the edges to the next one and to
// the one before. False: it has no neighbours. guess: the number of a corner near it, or a negative one.
static bool find_corner(const gjk2_collider *c, int32_t guess, const gjk2_vec *normal, gjk2_support *corner,
                        plane_edge *after, plane_edge *before) {
  if (c->count == 2 && find_end(c, normal, corner, after)) {
    gjk2_copy_support(&before->way, &after->way);
    before->along = after->along;
    return true;
  }
  if (guess < 0 || !c->ordered || GJK_SMALL) {
    gjk2_hull_corner(c, *normal, corner);
    if (!gjk2_hull_neighbour(c, corner, true, &after->way) || !gjk2_hull_neighbour(c, corner, false, &before->way)) {
      return false;
    }
    after->along = gjk2_dot(after->way.offset, *normal);
    before->along = gjk2_dot(before->way.offset, *normal);
    return true;
  }
  const gjk2_shape_class *type = c->shape->type;
  corner->vertex = (uint16_t)guess;
  (void)type->vertex(c, corner->vertex, &corner->offset);
  // Corners in order rise along the normal to the farthest one and fall again: at most as many steps as there are.
  for (uint32_t i = 0; i <= c->count; i++) {
    type->adjacent(c, corner, true, &after->way);
    after->along = gjk2_dot(after->way.offset, *normal);
    if (after->along < 0) {
      break;
    }
    gjk2_follow(corner, &after->way);
  }
  for (uint32_t i = 0; i <= c->count; i++) {
    type->adjacent(c, corner, false, &before->way);
    before->along = gjk2_dot(before->way.offset, *normal);
    if (before->along <= 0) {
      break;
    }
    after->way.offset = gjk2_negate(before->way.offset);
    after->way.vertex = corner->vertex;
    after->along = -before->along;
    gjk2_follow(corner, &before->way);
  }
  return true;
}

// Step 2. towards: the normal, from this shape to the other; left: the normal's left, the same for both.
static void find_side(const gjk2_collider *c, int32_t guess, gjk2_vec origin, const gjk2_vec *towards,
                      const gjk2_vec *left, plane_side *out) {
  gjk2_support corner;
  plane_edge after, before;
  out->count = 0;
  if (gjk2_is_curved(c->shape)) {
    out->number[0] = 0;
    return;
  }
  if (c->count == 1) {  // a circle
    out->count = 1;
    out->number[0] = 0;
    return;
  }
  const bool has_edges = find_corner(c, guess, towards, &corner, &after, &before);
  out->count = 1;
  out->number[0] = corner.vertex;
  out->end[0] = gjk2_add(origin, corner.offset);
  if (!has_edges) {
    return;
  }
  after.left = gjk2_dot(after.way.offset, *left);
  before.left = gjk2_dot(before.way.offset, *left);
  const plane_edge *edge = is_flatter(&before, &after) ? &before : &after;
  if (!plane_is_level(edge, c->shape->convex_radius)) {
    return;
  }
  const gjk2_vec at = out->end[0];
  const unsigned other = edge->left > 0 ? 1 : 0, same = 1 - other;
  out->count = 2;
  out->end[same] = at;
  out->number[same] = corner.vertex;
  out->end[other] = gjk2_add(at, edge->way.offset);
  out->number[other] = edge->way.vertex;
  if (c->shape->convex_radius != 0) {
    widen(out, edge->way.offset, *towards, c->shape->convex_radius);
  }
  out->place[same] = gjk2_dot(out->end[same], *left);  // |end| < 2^30.2:  below 2^61
  out->place[other] = out->place[same] + edge->left;
}

static uint16_t feature_of(const plane_side *of) {
  if (of->count < 2) {
    return of->number[0];
  }
  const uint16_t low = of->number[0] < of->number[1] ? of->number[0] : of->number[1];
  const uint16_t high = of->number[0] < of->number[1] ? of->number[1] : of->number[0];
  return (uint16_t)((low + 256 * (uint32_t)high) & UINT16_MAX);
}

// The byte of an id. slack: how near to a corner a place counts as the corner, Q30.
static unsigned id_byte(const plane_side *of, int64_t place, int64_t slack) {
  if (of->count == 2) {  // not reached: 1, since candidates are of edges
    const bool at_first = place - of->place[0] <= slack;
    if (!at_first && of->place[1] - place > slack) {
      return ID_EDGE;
    }
    return of->number[at_first ? 0 : 1] & ID_CORNERS;
  }
  return of->number[0] & ID_CORNERS;
}

// part / whole in Q31, at most INT32_MAX; within 2^-28 of itself. Pre: 0 < part < whole < 2^62.
//   part = 2^(32 - n) top and whole = 2^(32 - m) bottom, before truncation, so quotient = 2^30 top / bottom is from 2^29 to
//   2^31, and part / whole is quotient / 2^(30 + n - m)
static int32_t share(uint64_t part, uint64_t whole) {
  const unsigned n = gjk_clz64(part), m = gjk_clz64(whole);
  const uint32_t quotient = gjk_umulh32(gjk_upper32(part, n), gjk_reciprocal(gjk_upper32(whole, m))) >> 1;
  if (n == m) {
    return quotient >> 30 == 0 ? (int32_t)(quotient << 1) : INT32_MAX;
  }
  return n - m <= 32 ? (int32_t)(quotient >> (n - m - 1)) : 0;
}

// Step 3: the edge's point at a place, to the nearest LSB.
static gjk2_vec plane_point_at(const plane_side *of, int64_t place) {
  if (place <= of->place[0]) {
    return of->end[0];
  }
  if (place >= of->place[1]) {
    return of->end[1];
  }
  const int32_t w = share((uint64_t)(place - of->place[0]), (uint64_t)(of->place[1] - of->place[0]));
  const gjk2_vec edge = gjk2_sub(of->end[1], of->end[0]);
  const int64_t half = INT64_C(1) << 30;
  const gjk2_vec point = {of->end[0].x + (int32_t)gjk_sar64(gjk_mac32(half, edge.x, w), 31),
                          of->end[0].y + (int32_t)gjk_sar64(gjk_mac32(half, edge.y, w), 31)};
  return point;
}

static gjk2_vec in_world(gjk2_vec origin, gjk2_vec p) {
  const gjk2_vec world = {gjk_saturate((int64_t)origin.x + p.x), gjk_saturate((int64_t)origin.y + p.y)};
  return world;
}

// The candidate at a place of the shared stretch. False: it is farther than margin.
static bool candidate_at(const plane_side *of_a, const plane_side *of_b, int64_t place, int64_t slack, gjk2_vec origin,
                         gjk_q16 margin, const gjk2_unit *normal, gjk2_contact *out) {
  const gjk2_vec a = plane_point_at(of_a, place), b = plane_point_at(of_b, place), n = {normal->x, normal->y};
  const int64_t gap = gjk_sar64(gjk2_dot(gjk2_sub(b, a), n) + (INT64_C(1) << 29), 30);
  if (gap > margin) {
    return false;
  }
  out->point_a = in_world(origin, a);
  out->point_b = in_world(origin, b);
  out->distance = (gjk_q16)gap;  // |b - a| < 2^31
  out->id = (uint16_t)(id_byte(of_a, place, slack) << 8 | id_byte(of_b, place, slack));
  return true;
}

// Is p to be kept before q?
static bool is_better(const gjk2_contact *p, const gjk2_contact *q) {
  return p->distance != q->distance ? p->distance < q->distance : p->id < q->id;
}

// Makes the first of two contacts the one to be kept.
static void keep_better(gjk2_contact c[2]) {
  if (is_better(&c[1], &c[0])) {
    gjk2_copy(&c[0].point_a, &c[1].point_a);
    gjk2_copy(&c[0].point_b, &c[1].point_b);
    c[0].distance = c[1].distance;
    c[0].id = c[1].id;
  }
}

// Step 3
static void plane_clip(const plane_side *of_a, const plane_side *of_b, gjk2_vec origin, gjk_q16 margin,
                       gjk2_manifold *out) {
  const int64_t low = of_a->place[0] > of_b->place[0] ? of_a->place[0] : of_b->place[0];
  const int64_t high = of_a->place[1] < of_b->place[1] ? of_a->place[1] : of_b->place[1];
  const int64_t length_a = of_a->place[1] - of_a->place[0], length_b = of_b->place[1] - of_b->place[0];
  const int64_t shorter = length_a < length_b ? length_a : length_b, least = gjk_shl64(8, 30);
  int64_t slack = shorter >> 6 > least ? shorter >> 6 : least;
  slack = slack < shorter >> 2 ? slack : shorter >> 2;
  if (low > high) {
    return;
  }
  gjk2_contact *c = out->contact;
  // avr-gcc 5.4 at -Os spoils the pointer to the normal where the call itself holds &c[out->count].
  out->count = candidate_at(of_a, of_b, low, slack, origin, margin, &out->normal, c);
  gjk2_contact *const free_place = out->count == 0 ? c : c + 1;
  out->count = (uint8_t)(out->count + candidate_at(of_a, of_b, high, slack, origin, margin, &out->normal, free_place));
  if (out->count == 2 && c[0].id == c[1].id) {
    keep_better(c);
    out->count = 1;
  }
}

// Step 4. They replace the candidate that is farther.
static void plane_admit_nearest(const gjk2_distance_result *nearest, uint16_t id, gjk2_manifold *out) {
  gjk2_contact *c = out->contact;
  for (unsigned i = 0; i < out->count; i++) {
    if (c[i].distance <= nearest->distance + NEAREST_SLACK) {
      return;
    }
  }
  const unsigned i = out->count == 2 && is_better(&c[0], &c[1]) ? 1 : 0;
  out->count = out->count == 0 ? 1 : out->count;
  gjk2_copy(&c[i].point_a, &nearest->point_a);
  gjk2_copy(&c[i].point_b, &nearest->point_b);
  c[i].distance = nearest->distance;
  c[i].id = id;
}

GJK_OUT_OF_LINE bool gjk2_facing_contacts(const gjk2_collider *a, const gjk2_collider *b, gjk_q16 margin, unsigned most,
                                          const gjk2_distance_result *nearest, const gjk2_certificate *named,
                                          gjk2_manifold *out) {
  uint16_t id = 0;
  bool level = false;
  if (plane_is_within_reach(a, b)) {
    const gjk2_vec towards_b = {out->normal.x, out->normal.y}, towards_a = gjk2_negate(towards_b);
    const gjk2_vec left = {-towards_b.y, towards_b.x}, origin = {0, 0};
    plane_side of_a, of_b;
    const bool guesses = named != NULL && named->count > 0;
    find_side(a, guesses ? (int32_t)named->a[0] : -1, origin, &towards_b, &left, &of_a);
    find_side(b, guesses ? (int32_t)named->b[0] : -1, gjk2_sub(b->centre, a->centre), &towards_a, &left, &of_b);
    out->feature_a = feature_of(&of_a);
    out->feature_b = feature_of(&of_b);
    id = (uint16_t)((of_a.count == 2 ? ID_EDGE : of_a.number[0] & ID_CORNERS) << 8 |
                    (of_b.count == 2 ? ID_EDGE : of_b.number[0] & ID_CORNERS));
    level = of_a.count == 2 && of_b.count == 2;
    if (level) {
      plane_clip(&of_a, &of_b, a->centre, margin, out);
    }
  }
  if (nearest != NULL) {
    plane_admit_nearest(nearest, id, out);
  }
  if (out->count > most) {
    keep_better(out->contact);
    out->count = 1;
  }
  return level;
}

gjk_status gjk2_contacts(const gjk2_collider *a, const gjk2_collider *b, gjk_q16 margin, unsigned most,
                         gjk2_cache *cache, gjk2_manifold *out) {
  gjk_status status = gjk2_check_pair(a, b, out);
  if (status != GJK_OK || margin < 0 || most < 1 || most > GJK2_CONTACTS_MAX) {
    return status != GJK_OK ? status : margin < 0 ? GJK_ERROR_NEGATIVE : GJK_ERROR_RANGE;
  }
  gjk2_distance_result nearest;
  status = gjk2_signed_distance(a, b, cache, &nearest);
  if (status != GJK_OK && status != GJK_ERROR_CAPACITY) {
    return status;
  }
  out->normal = nearest.normal;
  out->feature_a = 0;
  out->feature_b = 0;
  out->count = 0;
  if (nearest.distance <= margin && a->count == 1 && b->count == 1) {
    plane_admit_nearest(&nearest, 0, out);  // circles have one vertex, number 0
  } else if (nearest.distance <= margin) {
    (void)gjk2_facing_contacts(a, b, margin, most, &nearest, &nearest.certificate, out);
  }
  return status;
}
