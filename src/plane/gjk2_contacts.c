// The contact manifold of the plane: the stretch along which two shapes lie across from each other.
//
//   1. Measure how the shapes meet (gjk2_meeting.h): the normal, the distance and the nearest points. Beyond margin there is no contact.
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
#include "gjk2_measure_inline.h"
#include "gjk2_meeting.h"
#include "gjk2_recall.h"

// Centres farther apart than this along an axis skip steps 2 and 3: the nearest points are the one contact. Otherwise
// coordinates relative to A's centre are below 2^29 + 2^28.
#define STRETCH_REACH (INT32_C(1) << 29)

// Step 4 admits the nearest points when every candidate is farther by more than this, LSB.
#define NEAREST_SLACK 2

// The byte that stands for an edge in an id; a corner's is its number modulo 128.
#define ID_EDGE 255u
#define ID_CORNERS 127u

// In line where registers hold 64 bits.
#if GJK2_IN_LINE
#define CONTACTS_INLINE GJK_ONCE static
#else
#define CONTACTS_INLINE static
#endif

// What a shape meets the normal with: an edge, from a corner that is farthest along the normal, or that corner.
typedef struct plane_side {
  gjk2_support corner, way;  // way: to the edge's other end
  int64_t run;               // way . the normal's left
  uint8_t count;             // 0: a curved shape; 1: a corner; 2: an edge
} plane_side;

// An edge, moved outwards by the convex radius. Of two ends the first has the lower place.
typedef struct plane_stretch {
  gjk2_vec end[2];   // relative to A's centre
  int64_t place[2];  // along the normal's left, Q30
  uint16_t number[2];
  uint32_t inverse;  // gjk_reciprocal of its length's leading bits; 0: not found yet
} plane_stretch;

GJK_ONE_COPY static bool plane_is_within_reach(int32_t a, int32_t b) {
  const int64_t x = (int64_t)a - b;
  return x <= STRETCH_REACH && x >= -STRETCH_REACH;
}

// Moves the edge outwards, to the side where towards points, by the convex radius.
static void widen(plane_stretch *of, gjk2_vec edge, gjk2_vec towards, gjk_q16 convex_radius) {
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
#if !GJK_SMALL
  // Mostly one is flatter than half of a right angle, and one is steeper.
  const uint64_t across_e = gjk_magnitude64(e->along), run_e = gjk_magnitude64(e->left);
  const uint64_t across_f = gjk_magnitude64(f->along), run_f = gjk_magnitude64(f->left);
  if ((across_e < run_e) != (across_f < run_f)) {
    return across_e < run_e;
  }
#endif
  const int64_t p = e->along, q = gjk_int64(gjk_magnitude64(f->left));
  const int64_t r = -f->along, s = gjk_int64(gjk_magnitude64(e->left));
  // (p q + r s) / 2^64 is off by less than slack: the truncated parts are below 1 each.
  const int32_t ph = gjk_high32(p), qh = gjk_high32(q), rh = gjk_high32(r), sh = gjk_high32(s);
  const int64_t sum = gjk_mac32(gjk_mul32(ph, qh), rh, sh);
  const int64_t slack = (int64_t)gjk_magnitude32(ph) + qh + gjk_magnitude32(rh) + sh + 2;
  if (!GJK_SMALL && (sum > slack || sum < -slack)) {
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

#if !GJK_SMALL
// Has the collider two ends alone? That of a chain's segment is a triangle whose last vertex is its second.
static inline bool has_two_ends(const gjk2_collider *c) {
  return c->count == 2 ||
         (c->count == 3 && !c->ordered && !c->shape->type->buffered && gjk2_equal(c->frame[1], c->frame[2]));
}

// The end of a segment that is farther along the normal, and the way to the other. False: both are as far.
static bool find_end(const gjk2_collider *c, const gjk2_vec *normal, gjk2_support *corner, plane_edge *edge) {
  gjk2_vec high = {c->frame[0].x, c->frame[0].y};
  gjk2_vec low = gjk2_negate(high);
  if (c->count == 3) {
    gjk2_copy(&low, &c->frame[0]);
    gjk2_copy(&high, &c->frame[1]);
  } else if (c->shape->type->buffered) {  // a polygon of two vertices
    (void)c->shape->type->vertex(c, 0, &low);
    (void)c->shape->type->vertex(c, 1, &high);
  }
  const gjk2_vec way = gjk2_sub(high, low);
  const int64_t along = gjk2_dot(way, *normal);
  const bool far = along > 0;
  gjk2_copy(&corner->offset, far ? &high : &low);
  corner->vertex = far ? 1 : 0;
  edge->way.offset = far ? gjk2_negate(way) : way;
  edge->way.vertex = far ? 0 : 1;
  edge->along = far ? -along : along;
  return along != 0;
}
#endif

// The corner farthest along the normal, of several the last one counterclockwise, with the edges to the next one and to
// the one before. False: it has no neighbours. guess: the number of a corner near it, or a negative one.
static bool find_corner(const gjk2_collider *c, int32_t guess, const gjk2_vec *normal, gjk2_support *corner,
                        plane_edge *after, plane_edge *before) {
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

CONTACTS_INLINE void take_if_level(const gjk2_collider *c, const plane_edge *edge, plane_side *out) {
  if (plane_is_level(edge, c->shape->convex_radius)) {
    out->count = 2;
    gjk2_copy_support(&out->way, &edge->way);
    out->run = edge->left;
  }
}

#if !GJK_SMALL
// find_side of a box. Along the normal its half axes tell the corner, along the left the flatter one of its edges there.
CONTACTS_INLINE void find_box_side(const gjk2_collider *c, const gjk2_vec *towards, const gjk2_vec *left,
                                   plane_side *out) {
  const gjk2_vec x = c->frame[0], y = c->frame[1];
  const int64_t px = gjk2_dot(x, *towards), py = gjk2_dot(y, *towards);  // not both 0
  // Of two corners as far the last one counterclockwise, in the order 3, 2, 0, 1.
  const bool plus_x = px != 0 ? px > 0 : py < 0, plus_y = py != 0 ? py > 0 : px > 0;
  // The ways from the corner lead against both half axes.
  plane_edge of_x, of_y;
  of_x.along = -2 * gjk_int64(gjk_magnitude64(px));
  of_y.along = -2 * gjk_int64(gjk_magnitude64(py));
  of_x.left = (plus_x ? -2 : 2) * gjk2_dot(x, *left);
  of_y.left = (plus_y ? -2 : 2) * gjk2_dot(y, *left);
  const bool takes_x = plus_x == plus_y ? !is_flatter(&of_y, &of_x) : is_flatter(&of_x, &of_y);
  const unsigned number = (plus_x ? 1u : 0u) | (plus_y ? 2u : 0u);
  out->corner.offset.x = (plus_x ? x.x : -x.x) + (plus_y ? y.x : -y.x);
  out->corner.offset.y = (plus_x ? x.y : -x.y) + (plus_y ? y.y : -y.y);
  out->corner.vertex = (uint16_t)number;
  plane_edge *edge = takes_x ? &of_x : &of_y;
  const gjk2_vec axis = takes_x ? x : y;
  const int32_t twice = (takes_x ? plus_x : plus_y) ? -2 : 2;
  edge->way.offset.x = twice * axis.x;  // half axes are below 2^28 long
  edge->way.offset.y = twice * axis.y;
  edge->way.vertex = (uint16_t)(number ^ (takes_x ? 1u : 2u));
  take_if_level(c, edge, out);
}

// (q - p) . d
static inline int64_t rise(const gjk2_vec *p, const gjk2_vec *q, const gjk2_vec *d) {
  return gjk_mac32(gjk_mul32(q->x - p->x, d->x), q->y - p->y, d->y);
}

// find_side where there is a list v of corners in order. last: the number of its last one.
static void find_listed_side(const gjk2_collider *c, const gjk2_vec *v, unsigned guess, const gjk2_vec *towards,
                             const gjk2_vec *left, plane_side *out) {
  const unsigned last = c->count - 1u;
  unsigned at = guess, next = at < last ? at + 1 : 0, previous = at > 0 ? at - 1 : last;
  plane_edge after, before;
  after.along = rise(&v[at], &v[next], towards);
  // Corners rise along the normal to the farthest one and fall again: at most as many steps as there are, each way.
  for (unsigned i = 0; i <= last && after.along >= 0; i++) {
    previous = at;
    at = next;
    next = at < last ? at + 1 : 0;
    after.along = rise(&v[at], &v[next], towards);
  }
  before.along = rise(&v[at], &v[previous], towards);
  for (unsigned i = 0; i <= last && before.along > 0; i++) {
    after.along = -before.along;
    next = at;
    at = previous;
    previous = at > 0 ? at - 1 : last;
    before.along = rise(&v[at], &v[previous], towards);
  }
  after.left = rise(&v[at], &v[next], left);
  before.left = rise(&v[at], &v[previous], left);
  const bool takes_before = is_flatter(&before, &after);
  plane_edge *edge = takes_before ? &before : &after;
  const unsigned other = takes_before ? previous : next;
  gjk2_copy(&out->corner.offset, &v[at]);
  out->corner.vertex = (uint16_t)at;
  edge->way.offset.x = v[other].x - v[at].x;
  edge->way.offset.y = v[other].y - v[at].y;
  edge->way.vertex = (uint16_t)other;
  take_if_level(c, edge, out);
}

// find_side of a polygon in order that is posed already. False: it is not.
static bool find_posed_side(const gjk2_collider *c, int32_t guess, const gjk2_vec *towards, const gjk2_vec *left,
                            plane_side *out) {
  if (!c->ordered) {
    return false;
  }
  if (c->count == 4 && !c->shape->type->buffered) {
    find_box_side(c, towards, left, out);
    return true;
  }
  const gjk2_vec *v = c->shape->type->buffered ? c->buffer : c->frame;
  if (v == NULL || guess < 0) {
    return false;
  }
  find_listed_side(c, v, (unsigned)guess, towards, left, out);
  return true;
}
#endif

// Step 2. towards: the normal, from this shape to the other; left: the normal's left, the same for both.
static void find_side(const gjk2_collider *c, int32_t guess, const gjk2_vec *towards, const gjk2_vec *left,
                      plane_side *out) {
  plane_edge after, before;
  out->corner.vertex = 0;
  out->count = 0;
  if (gjk2_is_curved(c->shape)) {
    return;
  }
  out->count = 1;
#if !GJK_SMALL
  if (find_posed_side(c, guess, towards, left, out)) {
    return;
  }
  if (has_two_ends(c) && find_end(c, towards, &out->corner, &after)) {
    after.left = gjk2_dot(after.way.offset, *left);
    take_if_level(c, &after, out);
    return;
  }
#endif
  if (c->count == 1 || !find_corner(c, guess, towards, &out->corner, &after, &before)) {  // 1: a circle
    return;
  }
  after.left = gjk2_dot(after.way.offset, *left);
  before.left = gjk2_dot(before.way.offset, *left);
  take_if_level(c, is_flatter(&before, &after) ? &before : &after, out);
}

// Step 2: an edge's ends.
CONTACTS_INLINE void set_stretch(const gjk2_collider *c, const plane_side *of, gjk2_vec origin, const gjk2_vec *towards,
                                 const gjk2_vec *left, plane_stretch *out) {
  const unsigned other = of->run > 0 ? 1 : 0, same = 1 - other;
  out->end[same] = gjk2_add(origin, of->corner.offset);
  out->number[same] = of->corner.vertex;
  out->end[other] = gjk2_add(out->end[same], of->way.offset);
  out->number[other] = of->way.vertex;
  if (c->shape->convex_radius != 0) {
    widen(out, of->way.offset, *towards, c->shape->convex_radius);
  }
  out->place[same] = gjk2_dot(out->end[same], *left);  // |end| < 2^30.2:  below 2^61
  out->place[other] = out->place[same] + of->run;
  out->inverse = 0;
}

GJK_ONE_COPY static uint16_t feature_of(const plane_side *of) {
  const uint16_t p = of->corner.vertex;
  if (of->count < 2) {
    return p;
  }
  const uint16_t q = of->way.vertex, low = p < q ? p : q, high = p < q ? q : p;
  return (uint16_t)((low + 256 * (uint32_t)high) & UINT16_MAX);
}

// The byte of an id. slack: how near to a corner a place counts as the corner, Q30.
GJK_ONE_COPY static unsigned id_byte(const plane_stretch *of, int64_t place, int64_t slack) {
  const bool at_first = place - of->place[0] <= slack;
  if (!at_first && of->place[1] - place > slack) {
    return ID_EDGE;
  }
  return of->number[at_first ? 0 : 1] & ID_CORNERS;
}

// part / the stretch's length in Q31, at most INT32_MAX; within 2^-28 of itself. Pre: 0 < part < the length.
//   part = 2^(32 - n) top and length = 2^(32 - m) bottom, before truncation, so quotient = 2^30 top / bottom is from 2^29 to
//   2^31, and part / length is quotient / 2^(30 + n - m)
static int32_t share(plane_stretch *of, uint64_t part) {
  const uint64_t length = (uint64_t)(of->place[1] - of->place[0]);
  const unsigned n = gjk_clz64(part), m = gjk_clz64(length);
  if (of->inverse == 0) {
    of->inverse = gjk_reciprocal(gjk_upper32(length, m));
  }
  const uint32_t quotient = gjk_umulh32(gjk_upper32(part, n), of->inverse) >> 1;
  if (n == m) {
    return quotient >> 30 == 0 ? (int32_t)(quotient << 1) : INT32_MAX;
  }
  return n - m <= 32 ? (int32_t)(quotient >> (n - m - 1)) : 0;
}

// Step 3: the edge's point at a place, to the nearest LSB.
CONTACTS_INLINE gjk2_vec plane_point_at(plane_stretch *of, int64_t place) {
  if (place <= of->place[0]) {
    return of->end[0];
  }
  if (place >= of->place[1]) {
    return of->end[1];
  }
  const int32_t w = share(of, (uint64_t)(place - of->place[0]));
  const gjk2_vec edge = gjk2_sub(of->end[1], of->end[0]);
  const int64_t half = INT64_C(1) << 30;
  const gjk2_vec point = {of->end[0].x + (int32_t)gjk_sar64(gjk_mac32(half, edge.x, w), 31),
                          of->end[0].y + (int32_t)gjk_sar64(gjk_mac32(half, edge.y, w), 31)};
  return point;
}

GJK_ONE_COPY static gjk2_vec in_world(gjk2_vec origin, gjk2_vec p) {
  const gjk2_vec world = {gjk_saturate((int64_t)origin.x + p.x), gjk_saturate((int64_t)origin.y + p.y)};
  return world;
}

// The candidate at a place of the shared stretch. False: it is farther than margin.
CONTACTS_INLINE bool candidate_at(plane_stretch *of_a, plane_stretch *of_b, int64_t place, int64_t slack,
                                  gjk2_vec origin, gjk_q16 margin, const gjk2_unit *normal, gjk2_contact *out) {
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
CONTACTS_INLINE void plane_clip(plane_stretch *of_a, plane_stretch *of_b, gjk2_vec origin, gjk_q16 margin,
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

bool gjk2_facing_lacks(const gjk2_manifold *m, gjk_q16 distance) {
  for (unsigned i = 0; i < m->count; i++) {
    if (m->contact[i].distance <= distance + NEAREST_SLACK) {
      return false;
    }
  }
  return true;
}

// The place of a contact that is admitted: that of the farther one, where there are two.
static gjk2_contact *place_nearest(gjk2_manifold *m, gjk_q16 distance, uint16_t id) {
  gjk2_contact *c = m->contact;
  const unsigned i = m->count == 2 && is_better(&c[0], &c[1]) ? 1 : 0;
  m->count = m->count == 0 ? 1 : m->count;
  c[i].distance = distance;
  c[i].id = id;
  return &c[i];
}

void gjk2_facing_limit(gjk2_manifold *m, unsigned most) {
  if (m->count > most) {
    keep_better(m->contact);
    m->count = 1;
  }
}

void gjk2_facing_admit(gjk2_manifold *m, gjk_q16 distance, const gjk2_vec *point_a, const gjk2_vec *point_b,
                       uint16_t id) {
  gjk2_contact *c = place_nearest(m, distance, id);
  gjk2_copy(&c->point_a, point_a);
  gjk2_copy(&c->point_b, point_b);
}

GJK_OUT_OF_LINE bool gjk2_facing_contacts(const gjk2_collider *a, const gjk2_collider *b, gjk_q16 margin,
                                          int32_t guess_a, int32_t guess_b, gjk2_manifold *out, uint16_t *id) {
  *id = 0;
  if (!plane_is_within_reach(a->centre.x, b->centre.x) || !plane_is_within_reach(a->centre.y, b->centre.y)) {
    return false;
  }
  const gjk2_vec towards_b = {out->normal.x, out->normal.y}, towards_a = gjk2_negate(towards_b);
  const gjk2_vec left = {-towards_b.y, towards_b.x}, origin = {0, 0};
  plane_side of_a, of_b;
  find_side(a, guess_a, &towards_b, &left, &of_a);
  find_side(b, guess_b, &towards_a, &left, &of_b);
  out->feature_a = feature_of(&of_a);
  out->feature_b = feature_of(&of_b);
  if (of_a.count < 2 || of_b.count < 2) {
    *id = (uint16_t)((of_a.count == 2 ? ID_EDGE : of_a.corner.vertex & ID_CORNERS) << 8 |
                     (of_b.count == 2 ? ID_EDGE : of_b.corner.vertex & ID_CORNERS));
    return false;
  }
  plane_stretch stretch_a, stretch_b;
  *id = ID_EDGE << 8 | ID_EDGE;
  set_stretch(a, &of_a, origin, &towards_b, &left, &stretch_a);
  set_stretch(b, &of_b, gjk2_sub(b->centre, a->centre), &towards_a, &left, &stretch_b);
  plane_clip(&stretch_a, &stretch_b, a->centre, margin, out);
  return true;
}

// The contacts of a pair that has been measured without a search.
static void plane_touch(const gjk2_collider *a, const gjk2_collider *b, gjk_q16 margin, unsigned most,
                        const gjk2_distance_result *touch, gjk2_manifold *out) {
  uint16_t id = 0;  // circles have one vertex, number 0
  out->normal.x = touch->normal.x;
  out->normal.y = touch->normal.y;
  out->feature_a = 0;
  out->feature_b = 0;
  out->count = 0;
  if (touch->distance > margin) {
    return;
  }
  if (a->count + b->count > 2) {
    (void)gjk2_facing_contacts(a, b, margin, touch->certificate.a[0], touch->certificate.b[0], out, &id);
    if (!gjk2_facing_lacks(out, touch->distance)) {
      gjk2_facing_limit(out, most);
      return;
    }
  }
  gjk2_facing_admit(out, touch->distance, &touch->point_a, &touch->point_b, id);
  gjk2_facing_limit(out, most);
}

gjk_status gjk2_contacts(const gjk2_collider *a, const gjk2_collider *b, gjk_q16 margin, unsigned most,
                         gjk2_cache *cache, gjk2_manifold *out) {
  gjk_status status = gjk2_check_pair(a, b, out);
  if (status != GJK_OK || margin < 0 || most < 1 || most > GJK2_CONTACTS_MAX) {
    return status != GJK_OK ? status : margin < 0 ? GJK_ERROR_NEGATIVE : GJK_ERROR_RANGE;
  }
  gjk2_distance_result touch;
  if (gjk2_recalls(a, b, cache, GJK2_TOUCH_ALL, &touch)) {
    plane_touch(a, b, margin, most, &touch, out);
    return GJK_OK;
  }
  if (gjk2_touch_without_search(a, b, GJK2_TOUCH_ALL, &touch)) {
    gjk2_touch_keep(&touch, cache);
    plane_touch(a, b, margin, most, &touch, out);
    return GJK_OK;
  }
  gjk2_meeting m;
  status = gjk2_meet(&m, a, b, cache);
  if (status == GJK_ERROR_ITERATION_LIMIT) {
    return status;
  }
  out->normal.x = m.normal.x;
  out->normal.y = m.normal.y;
  out->feature_a = 0;
  out->feature_b = 0;
  out->count = 0;
  if (m.distance <= margin) {
    uint16_t id = 0;  // circles have one vertex, number 0
    if (GJK_SHAPES >= GJK_SHAPES_ROUND && (a->count != 1 || b->count != 1)) {
      (void)gjk2_facing_contacts(a, b, margin, m.p->a.vertex, m.p->b.vertex, out, &id);
    }
    if (gjk2_facing_lacks(out, m.distance)) {
      gjk2_contact *c = place_nearest(out, m.distance, id);
      (void)gjk2_meeting_points(&m, &c->point_a, &c->point_b);
    }
    gjk2_facing_limit(out, most);
  }
  return status;
}
