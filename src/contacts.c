// The contact manifold: the face of one shape clipped by that of the other, and reduced to the points that matter.
#include "gjk/contacts.h"

#include "clip.h"
#include "contact_polygon.h"
#include "root.h"
#include "unit.h"
#include "witness.h"

// The id of the one point of gjk_signed_distance, and the bit for B's face as the reference.
#define WITNESS_ID UINT16_C(0xFFFF)
#define REFERENCE_B UINT16_C(0x8000)

#define CANDIDATES (GJK_CLIP_MAX + 1)

// Centres farther apart than this along an axis: the one point has to do.
#define REACH (INT32_C(1) << 29)

// Edges count as parallel when the sine of their angle is below about 1/32: a cosine of 1 - 2^-11.
#define PARALLEL (GJK_Q30_ONE - GJK_Q30_ONE / 2048)

typedef struct contacts {
  const gjk_collider *a, *b;
  gjk_unit3 u;  // the normal, from A to B
  gjk_q16 margin;
  gjk_contact candidate[CANDIDATES];
  unsigned count;
} contacts;

// A plane of the reference shape, relative to A's centre.
typedef struct reference {
  const gjk_polygon *polygon;
  gjk_unit3 out;     // the contact's normal, out of the reference shape
  gjk_unit3 normal;  // the plane's
  bool is_b;
} reference;

static gjk_vec3 vector_of(const gjk_unit3 *u) {
  const gjk_vec3 v = {u->x, u->y, u->z};
  return v;
}

static gjk_unit3 opposite(const gjk_unit3 *u) {
  const gjk_unit3 v = {-u->x, -u->y, -u->z};
  return v;
}

// To the nearest LSB. Pre: the result fits.
static gjk_q16 to_lsb(int64_t x) {
  return (gjk_q16)gjk_sar64(x + (INT64_C(1) << 29), 30);
}

// u length / 2^30 to the nearest.
static gjk_q16 part_along(gjk_q30 u, gjk_q16 length) {
  return to_lsb(gjk_mul32(u, length));
}

static gjk_vec3 step_along(const gjk_unit3 *u, gjk_q16 length) {
  const gjk_vec3 v = {part_along(u->x, length), part_along(u->y, length), part_along(u->z, length)};
  return v;
}

static gjk_q16 world(gjk_q16 centre, int32_t offset) {
  bool saturated;
  return gjk_saturate((int64_t)centre + offset, &saturated);
}

// Adds a pair of points of the cores, relative to A's centre; gap: between them.
static void add(contacts *c, const gjk_vec3 *on_a, const gjk_vec3 *on_b, gjk_q16 gap, uint16_t id) {
  const gjk_q16 round_a = c->a->shape->round, round_b = c->b->shape->round, distance = gap - round_a - round_b;
  if (distance > c->margin || c->count == CANDIDATES) {
    return;
  }
  const gjk_vec3 *centre = &c->a->centre;
  const gjk_vec3 a = gjk_add(*on_a, step_along(&c->u, round_a)), b = gjk_sub(*on_b, step_along(&c->u, round_b));
  gjk_contact *out = &c->candidate[c->count++];
  out->point_a.x = world(centre->x, a.x);
  out->point_a.y = world(centre->y, a.y);
  out->point_a.z = world(centre->z, a.z);
  out->point_b.x = world(centre->x, b.x);
  out->point_b.y = world(centre->y, b.y);
  out->point_b.z = world(centre->z, b.z);
  out->distance = distance;
  out->id = id;
}

// 2^60 / c for 2^29 <= c <= 2^30, within 2^-28 of itself: from 1 / sqrt(c), squared.
static uint32_t inverse(gjk_q30 c) {
  const uint32_t x = c >= GJK_Q30_ONE ? UINT32_MAX : (uint32_t)c * 4;
  const uint32_t root = gjk_reciprocal_root(x);  // 2^45 / sqrt(c), below 2^31
  return (uint32_t)(gjk_umul32(root, root) >> 30);
}

// Adds what is left of the incident shape, each point with the one of the reference plane across from it. The gap is
// (v - origin) . normal / (out . normal): with |v - origin| < 2^31 the product is below 2^62; divided, below 2^32.
static void add_points(contacts *c, const reference *r, const gjk_clip *clip) {
  const gjk_q30 cosine = gjk_cosine(&r->normal, &r->out);
  if (cosine < GJK_Q30_ONE / 2) {
    return;
  }
  const uint32_t scale = inverse(cosine);
  const uint32_t mask = (UINT32_C(1) << 30) - 1;
  for (unsigned i = 0; i < clip->count; i++) {
    const gjk_vec3 *v = &clip->corner[i].v;
    const gjk_vec3 step = gjk_sub(*v, r->polygon->corner[0]);
    const int64_t along = gjk_along(&r->normal, &step);
    const uint64_t low = gjk_umul32(gjk_low32(along) & mask, scale) >> 30;
    const int64_t gap = gjk_sar64(gjk_sar64(along, 30) * (int64_t)scale + (int64_t)low + (INT64_C(1) << 29), 30);
    if (gap >= 2 * (int64_t)REACH || gap <= -2 * (int64_t)REACH) {
      continue;
    }
    const gjk_vec3 across = gjk_sub(*v, step_along(&r->out, (gjk_q16)gap));
    const uint16_t id = (uint16_t)(clip->corner[i].id | (r->is_b ? REFERENCE_B : 0));
    add(c, r->is_b ? v : &across, r->is_b ? &across : v, (gjk_q16)gap, id);
  }
}

static void open_clip(const gjk_polygon *p, gjk_clip *clip) {
  clip->count = p->count;
  for (unsigned i = 0; i < p->count; i++) {
    clip->corner[i].v = p->corner[i];
    clip->corner[i].id = (uint16_t)i;
    clip->corner[i].label = (uint8_t)i;
  }
}

// The incident polygon or edge behind all sides of the reference polygon, which stand along the contact's normal: so the
// points across from what is left lie in the polygon.
static void clip_by_polygon(contacts *c, const reference *r, const gjk_polygon *incident) {
  gjk_clip clip;
  const gjk_polygon *p = r->polygon;
  const gjk_vec3 out = vector_of(&r->out);
  open_clip(incident, &clip);
  for (unsigned i = 0; i < p->count && clip.count > 0; i++) {
    gjk_long3 n;
    gjk_rounded d;
    const gjk_vec3 edge = gjk_sub(p->corner[i + 1 < p->count ? i + 1 : 0], p->corner[i]);
    gjk_cross(&edge, &out, &n);
    gjk_round_direction(&n, &d);
    gjk_clip_behind(&clip, &p->corner[i], &d.d, i);
  }
  add_points(c, r, &clip);
}

static gjk_unit3 edge_direction(const gjk_polygon *edge) {
  const gjk_vec3 e = gjk_sub(edge->corner[1], edge->corner[0]);
  const gjk_vec3 d = gjk_scale_direction(&e);
  return gjk_unit(&d);
}

static bool has_length(const gjk_polygon *edge) {
  const gjk_vec3 e = gjk_sub(edge->corner[1], edge->corner[0]);
  return (e.x | e.y | e.z) != 0;
}

// Two edges: parallel ones by the extent of A's, the reference; of others only the one point matters.
static void clip_by_edge(contacts *c, const reference *r, const gjk_polygon *incident) {
  if (!has_length(r->polygon) || !has_length(incident)) {
    return;
  }
  const gjk_unit3 e = edge_direction(r->polygon), f = edge_direction(incident);
  const gjk_q30 cosine = gjk_cosine(&e, &f);
  if (cosine < PARALLEL && cosine > -PARALLEL) {
    return;
  }
  gjk_clip clip;
  const gjk_vec3 forth = vector_of(&e), back = gjk_negate(forth);
  open_clip(incident, &clip);
  gjk_clip_behind(&clip, &r->polygon->corner[1], &forth, 0);
  if (clip.count == 0) {
    return;
  }
  gjk_clip_behind(&clip, &r->polygon->corner[0], &back, 1);
  for (unsigned i = 0; i < clip.count; i++) {
    const gjk_vec3 *v = &clip.corner[i].v, *start = &r->polygon->corner[0];
    const gjk_vec3 step = gjk_sub(*v, *start);
    const gjk_vec3 on_edge = gjk_add(*start, step_along(&e, to_lsb(gjk_along(&e, &step))));
    const gjk_vec3 across = gjk_sub(*v, on_edge);
    add(c, &on_edge, v, to_lsb(gjk_along(&r->out, &across)), clip.corner[i].id);
  }
}

// A polygon that leans away from u, which leads out of it, meets it with the edge that reaches farthest.
static void reduce_to_edge(gjk_polygon *p, const gjk_unit3 *u) {
  if (p->count < 3 || gjk_cosine(&p->normal, u) >= GJK_ALIGNED) {
    return;
  }
  unsigned best = 0;
  int64_t reach = INT64_MIN;
  for (unsigned i = 0; i < p->count; i++) {
    const int64_t along = gjk_along(u, &p->corner[i]);
    if (along > reach) {
      reach = along;
      best = i;
    }
  }
  const unsigned after = best + 1u < p->count ? best + 1 : 0, before = best > 0 ? best - 1 : p->count - 1u;
  const bool forth = gjk_along(u, &p->corner[after]) >= gjk_along(u, &p->corner[before]);
  const gjk_vec3 from = p->corner[best], to = p->corner[forth ? after : before];
  p->corner[0] = from;
  p->corner[1] = to;
  p->count = 2;
}

// Finds the points where the two faces meet.
static void meet(contacts *c, gjk_manifold *out) {
  const gjk_vec3 origin = {0, 0, 0}, delta = gjk_sub(c->b->centre, c->a->centre);
  const gjk_unit3 back = opposite(&c->u);
  gjk_polygon a, b;
  gjk_contact_polygon(c->a, &origin, &c->u, &a);
  gjk_contact_polygon(c->b, &delta, &back, &b);
  out->feature_a = a.feature;
  out->feature_b = b.feature;
  reduce_to_edge(&a, &c->u);
  reduce_to_edge(&b, &back);
  if (a.count < 2 || b.count < 2) {
    return;
  }
  const bool a_first = b.count < 3 || (a.count > 2 && gjk_cosine(&a.normal, &c->u) >= gjk_cosine(&b.normal, &back));
  reference r;
  r.polygon = a_first ? &a : &b;
  r.out = a_first ? c->u : back;
  r.is_b = !a_first;
  r.normal = r.polygon->normal;
  if (r.polygon->count > 2) {
    clip_by_polygon(c, &r, a_first ? &b : &a);
  } else {
    clip_by_edge(c, &r, &b);
  }
}

// The points of gjk_signed_distance, unless one of the others is as deep.
static void add_witness(contacts *c, const gjk_distance_result *d) {
  for (unsigned i = 0; i < c->count; i++) {
    if (c->candidate[i].distance <= d->distance + 2) {
      return;
    }
  }
  if (c->count < CANDIDATES) {
    gjk_contact *out = &c->candidate[c->count++];
    out->point_a = d->point_a;
    out->point_b = d->point_b;
    out->distance = d->distance;
    out->id = WITNESS_ID;
  }
}

// |p - q|^2 of points that are less than 2^30 apart along each axis.
static int64_t squared_between(const gjk_vec3 *p, const gjk_vec3 *q) {
  const gjk_vec3 v = gjk_sub(*p, *q);
  return gjk_dot(&v, &v);
}

// Twice the area of p, q, r as seen along u, positive counterclockwise; in units of 2^32.
static int64_t area(const gjk_unit3 *u, const gjk_vec3 *p, const gjk_vec3 *q, const gjk_vec3 *r) {
  const gjk_vec3 e = gjk_sub(*q, *p), f = gjk_sub(*r, *p);
  gjk_long3 n;
  gjk_cross(&e, &f, &n);
  const gjk_vec3 high = {gjk_high32(n.x), gjk_high32(n.y), gjk_high32(n.z)};
  const gjk_vec3 low = {(int32_t)(gjk_low32(n.x) >> 2), (int32_t)(gjk_low32(n.y) >> 2), (int32_t)(gjk_low32(n.z) >> 2)};
  return gjk_along(u, &high) + gjk_sar64(gjk_along(u, &low), 30);
}

// How much candidate i would add to the chosen first ones.
static int64_t worth(const contacts *c, unsigned chosen, unsigned i) {
  const gjk_contact *k = c->candidate;
  if (chosen == 0) {
    return -(int64_t)k[i].distance;
  }
  if (chosen == 2 || chosen == 3) {
    const int64_t side = area(&c->u, &k[0].point_a, &k[1].point_a, &k[i].point_a);
    // The fourth lies across the first two from the third, or beside them wherever it adds most.
    if (chosen == 2) {
      return side < 0 ? -side : side;
    }
    return area(&c->u, &k[0].point_a, &k[1].point_a, &k[2].point_a) > 0 ? -side : side;
  }
  int64_t nearest = INT64_MAX;
  for (unsigned n = 0; n < chosen; n++) {
    const int64_t squared = squared_between(&k[n].point_a, &k[i].point_a);
    nearest = squared < nearest ? squared : nearest;
  }
  return nearest;
}

// Moves the candidates to keep to the front; among equals the first.
static void choose(contacts *c, unsigned most) {
  for (unsigned chosen = 0; chosen < most; chosen++) {
    unsigned best = chosen;
    int64_t most_worth = worth(c, chosen, chosen);
    for (unsigned i = chosen + 1; i < c->count; i++) {
      const int64_t w = worth(c, chosen, i);
      if (w > most_worth) {
        most_worth = w;
        best = i;
      }
    }
    const gjk_contact moved = c->candidate[best];
    for (unsigned i = best; i > chosen; i--) {
      c->candidate[i] = c->candidate[i - 1];
    }
    c->candidate[chosen] = moved;
  }
  c->count = most;
}

static bool is_within_reach(const gjk_vec3 *a, const gjk_vec3 *b) {
  const int64_t x = (int64_t)a->x - b->x, y = (int64_t)a->y - b->y, z = (int64_t)a->z - b->z;
  return x <= REACH && x >= -REACH && y <= REACH && y >= -REACH && z <= REACH && z >= -REACH;
}

// Fills in the manifold of shapes that are at most margin apart. Out of line, so that its room on the stack is not taken
// while the distance is measured.
GJK_OUT_OF_LINE static void make_manifold(const gjk_collider *a, const gjk_collider *b, gjk_q16 margin, unsigned most,
                                          const gjk_distance_result *d, gjk_manifold *out) {
  contacts c;
  c.a = a;
  c.b = b;
  c.u = d->normal;
  c.margin = margin;
  c.count = 0;
  out->normal = d->normal;
  out->feature_a = 0;
  out->feature_b = 0;
  if (is_within_reach(&a->centre, &b->centre)) {
    meet(&c, out);
  }
  add_witness(&c, d);
  if (c.count > most) {
    choose(&c, most);
  }
  out->count = (uint8_t)c.count;
  for (unsigned i = 0; i < c.count; i++) {
    out->contact[i] = c.candidate[i];
  }
}

gjk_status gjk_contacts(const gjk_collider *a, const gjk_collider *b, gjk_q16 margin, unsigned most, gjk_cache *cache,
                        const gjk_workspace *workspace, gjk_manifold *out) {
  gjk_status status = gjk_check_pair(a, b, out);
  if (status != GJK_OK || margin < 0 || most < 1 || most > GJK_CONTACTS_MAX) {
    return status != GJK_OK ? status : margin < 0 ? GJK_ERROR_NEGATIVE : GJK_ERROR_RANGE;
  }
  gjk_distance_result d;
  status = gjk_signed_distance(a, b, cache, workspace, &d);
  if (status == GJK_OK || status == GJK_ERROR_CAPACITY) {
    out->count = 0;
    if (d.distance <= margin) {
      make_manifold(a, b, margin, most, &d, out);
    }
  }
  return status;
}
