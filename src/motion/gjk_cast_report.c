// Reports of casts: what a plane makes of a way, rounded.
#include "gjk_cast_report.h"

#include "../arith/gjk_unit.h"
#include "gjk_quotient.h"

// The quotient n . w_0 / n . t.
static void set_quotient(const gjk_portal *p, gjk_quotient *q) {
  uint32_t low;
  gjk_u128 numerator, denominator;
  int64_t high = gjk_portal_dot(p, &p->corner[0].u, &p->start, &low);
  gjk_magnitude95(high, low, &numerator);
  high = gjk_portal_dot(p, NULL, &p->way, &low);
  gjk_magnitude95(high, low, &denominator);
  gjk_quotient_set(q, &numerator, &denominator);
}

// One axis of both resting places. way: A's whole way; t: of B against A; n: of the plane, to whose side B is rounded.
// Returns B's way against A to the nearest LSB.
static int64_t rest_along(const gjk_quotient *q, int64_t way, int64_t t, int64_t n, gjk_q16 a, gjk_q16 b,
                          gjk_q16 *rest_a, gjk_q16 *rest_b, bool *saturated) {
  bool whole;
  const int64_t of_a = way != 0 ? gjk_quotient_nearest(q, way) : 0;
  const int64_t halves = gjk_quotient_split(q, 2 * t, &whole), nearest = gjk_sar64(halves + 1, 1);
  const int64_t up = gjk_sar64(halves + (whole ? 1 : 2), 1);
  *rest_a = (gjk_q16)(a + of_a);
  *rest_b = gjk_saturate_noting(b + of_a + (n > 0 ? up : n < 0 ? gjk_sar64(halves, 1) : nearest), saturated);
  return nearest;
}

static gjk_long3 way_of_a(const gjk_portal *p, const gjk_way *way) {
  const gjk_vec3 *from = &p->a->centre, *to = &way->end_a;
  const gjk_long3 of_a = {(int64_t)to->x - from->x, (int64_t)to->y - from->y, (int64_t)to->z - from->z};
  return of_a;
}

// One coordinate of the point where A is touched: the corners' vertices of A in their proportions, moved along A's way.
//   offsets < 2^28, their differences < 2^29, weights <= 2^31 together:   partial sums below 2^61
//   a quarter of an LSB is what the way is rounded to, down:              1/8 LSB is added
static gjk_q16 touch(const gjk_quotient *q, const gjk_barycentric weight[2], gjk_q16 centre, int64_t way, int32_t v0,
                     int32_t v1, int32_t v2, bool *saturated) {
  const int32_t e1 = v1 - v0, e2 = v2 - v0;
  const int64_t fine = gjk_sar64(gjk_mac32(gjk_mul32(e1, weight[0].low), e2, weight[1].low), 16);
  int64_t sum = gjk_mac32(gjk_mac32(gjk_shl64(v0, 31), e1, weight[0].high), e2, weight[1].high) + fine;
  int64_t whole = 0;
  if (way != 0) {
    const int64_t quarters = gjk_quotient_floor(q, 4 * way);
    whole = gjk_sar64(quarters, 2);
    sum += gjk_shl64(quarters & 3, 29) + (INT64_C(1) << 28);
  }
  return gjk_saturate_noting(centre + whole + gjk_sar64(sum + (INT64_C(1) << 30), 31), saturated);
}

// A part of a way to the nearest LSB.
static gjk_long3 part_of_way(const gjk_quotient *q, const gjk_vec3 *from, const gjk_vec3 *to) {
  const gjk_long3 part = {gjk_quotient_nearest(q, (int64_t)to->x - from->x),
                          gjk_quotient_nearest(q, (int64_t)to->y - from->y),
                          gjk_quotient_nearest(q, (int64_t)to->z - from->z)};
  return part;
}

// Where a point is, moved along a part of its way. A centre stays within int32.
static void move_point(const gjk_vec3 *from, const gjk_long3 *part, gjk_vec3 *out) {
  out->x = (gjk_q16)(from->x + part->x);
  out->y = (gjk_q16)(from->y + part->y);
  out->z = (gjk_q16)(from->z + part->z);
}

// At larger core radii weights of 31 bits may move the point by a tenth of an LSB.
#define FINE_RADIUS (INT32_C(1) << 24)

static void touch_point(const gjk_portal *p, const gjk_quotient *q, const gjk_way *way, gjk_vec3 *out,
                        bool *saturated) {
  const gjk_long3 of_a = way_of_a(p, way);
  const gjk_collider *a = p->a;
  gjk_u128 part[3];
  gjk_barycentric weight[2];
  gjk_vec3 v[3];
  gjk_portal_weights(p, part);
  gjk_barycentrics(&part[0], &part[1], &part[2], a->core_radius >= FINE_RADIUS, weight);
  for (unsigned i = 0; i < 3; i++) {
    a->shape->type->vertex(a, p->corner[i < p->count ? i : 0].a, &v[i]);  // of fewer corners the others weigh nothing
  }
  out->x = touch(q, weight, a->centre.x, of_a.x, v[0].x, v[1].x, v[2].x, saturated);
  out->y = touch(q, weight, a->centre.y, of_a.y, v[0].y, v[1].y, v[2].y, saturated);
  out->z = touch(q, weight, a->centre.z, of_a.z, v[0].z, v[1].z, v[2].z, saturated);
}

// Names the corners of a plane, so that (w_1 - w_0) x (w_2 - w_0) points along n. Less than three: direction is n.
void gjk_cast_name_plane(const gjk_portal *p, gjk_cast_certificate *out) {
  out->count = p->count;
  for (unsigned i = 0; i < p->count; i++) {
    const gjk_corner *c = &p->corner[p->count == 3 && i > 0 && !p->leaving ? 3 - i : i];
    out->a[i] = c->a;
    out->b[i] = c->b;
  }
  if (p->count < 3) {
    out->direction.x = (gjk_q16)p->n.x;
    out->direction.y = (gjk_q16)p->n.y;
    out->direction.z = (gjk_q16)p->n.z;
  }
}

void gjk_cast_report_start(const gjk_collider *a, const gjk_collider *b, gjk_cast_result *out) {
  const gjk_unit3 none = {0, 0, 0};
  out->hit = true;
  out->inside = true;
  out->fraction = 0;
  out->normal = none;
  out->rest_a = a->position;
  out->rest_b = b->position;
  out->saturated = false;
  out->certificate.proof = GJK_CAST_PROOF_INSIDE;
  out->certificate.count = 0;
}

void gjk_cast_report_entry(const gjk_portal *p, const gjk_way *way, gjk_cast_result *out) {
  gjk_quotient q;
  const gjk_long3 of_a = way_of_a(p, way);
  const gjk_vec3 *a = &p->a->position, *b = &p->b->position;
  set_quotient(p, &q);
  out->hit = true;
  out->inside = false;
  out->fraction = q.one ? GJK_Q30_ONE : (gjk_q30)(q.high >> 2);
  out->saturated = false;
  const gjk_long3 of_b = {
      rest_along(&q, of_a.x, p->way.x, p->n.x, a->x, b->x, &out->rest_a.x, &out->rest_b.x, &out->saturated),
      rest_along(&q, of_a.y, p->way.y, p->n.y, a->y, b->y, &out->rest_a.y, &out->rest_b.y, &out->saturated),
      rest_along(&q, of_a.z, p->way.z, p->n.z, a->z, b->z, &out->rest_a.z, &out->rest_b.z, &out->saturated)};
  if (gjk_portal_is_point(p->b) && (of_a.x | of_a.y | of_a.z) == 0) {
    move_point(&p->b->centre, &of_b, &out->point_a);
  } else if (gjk_portal_is_point(p->b)) {
    const gjk_long3 part = part_of_way(&q, &p->b->centre, &way->end_b);
    move_point(&p->b->centre, &part, &out->point_a);
  } else if (gjk_portal_is_point(p->a)) {
    const gjk_long3 part = part_of_way(&q, &p->a->centre, &way->end_a);
    move_point(&p->a->centre, &part, &out->point_a);
  } else {
    touch_point(p, &q, way, &out->point_a, &out->saturated);
  }
  out->point_b = out->point_a;
  out->normal = gjk_unit(&p->direction.d);
  out->certificate.proof = GJK_CAST_PROOF_FACET;
  gjk_cast_name_plane(p, &out->certificate);
}
