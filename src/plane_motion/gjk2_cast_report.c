// Writes the result of a cast in the plane.
//
// What is rounded:
//   normal   each component within 2 LSB of Q2.30
//   points   each coordinate once, to the nearest LSB: within 1 LSB of the shape at the fraction
//   rest     A's place each coordinate to the nearest LSB, B's place against A's along the normal: what lay across it
//            lies apart still
#include "gjk2_cast_report.h"

#include "../plane/gjk2_measure.h"

static void plane_cast_count(const gjk2_way *way, gjk2_cast_result *out) {
  out->iterations = (uint8_t)(way->scans < UINT8_MAX ? way->scans : UINT8_MAX);
  out->certificate.count = 0;
  out->certificate.direction.x = 0;
  out->certificate.direction.y = 0;
}

void gjk2_cast_miss(const gjk2_way *way, gjk2_cast_proof proof, gjk2_cast_result *out) {
  plane_cast_count(way, out);
  out->hit = false;
  out->certificate.proof = (uint8_t)proof;
}

void gjk2_cast_inside(const gjk2_way *way, const gjk2_distance_result *gap, gjk2_cast_result *out) {
  static const gjk2_vec origin = {0, 0};
  plane_cast_count(way, out);
  out->hit = true;
  out->inside = true;
  out->fraction = 0;
  gjk2_copy(&out->rest_a, &way->a->position);
  gjk2_copy(&out->rest_b, &way->b->position);
  out->point_a = gap != NULL ? gap->point_a : origin;
  out->point_b = gap != NULL ? gap->point_b : origin;
  out->normal.x = gap != NULL ? gap->normal.x : 0;
  out->normal.y = gap != NULL ? gap->normal.y : 0;
  out->saturated = gap != NULL && gap->saturated;
  out->certificate.proof = GJK2_CAST_PROOF_INSIDE;
}

// One coordinate of a point, from the centre at the start.
//   u, v              at most 2^28 in size:      2^30 u, (v - u) weight, normal radius below 2^59 each
//   way fraction      below 2^62
static inline gjk_q16 plane_cast_coordinate(int32_t u, int32_t v, gjk_q30 weight, gjk_q30 normal, gjk_q16 radius,
                                            int64_t moved, gjk_q16 centre, bool *saturated) {
  const int64_t half = INT64_C(1) << 29;
  const int64_t core = GJK_SHAPES <= GJK_SHAPES_POINTS ? 0 : gjk_mac32(gjk_shl64(u, 30), v - u, weight);
  const int64_t offset = gjk_mac32(core + half, normal, radius);
  return gjk_saturate_noting(centre + gjk_sar64(offset + moved, 30), saturated);
}

GJK_ONCE static void plane_cast_point(const gjk2_collider *c, const gjk2_support *p, const gjk2_support *q,
                                      gjk_q30 weight, const gjk2_unit *normal, gjk_q16 radius, const gjk2_long *way,
                                      gjk_q30 fraction, gjk2_vec *out, bool *saturated) {
  out->x = plane_cast_coordinate(p->offset.x, q->offset.x, weight, normal->x, radius, way->x * fraction, c->centre.x,
                                 saturated);
  out->y = plane_cast_coordinate(p->offset.y, q->offset.y, weight, normal->y, radius, way->y * fraction, c->centre.y,
                                 saturated);
}

// length times the portion, rounded towards the side that n points to.
static int64_t plane_round_along(const gjk2_portion *portion, int64_t length, int32_t n) {
  return n > 0   ? -gjk2_portion_floor(portion, -length)
         : n < 0 ? gjk2_portion_floor(portion, length)
                 : gjk2_portion_nearest(portion, length);
}

// One axis of both resting places. of_a: A's way; t: B's against A. A's lies between two positions of int32, so it fits.
GJK_ONCE static void plane_cast_rest(const gjk2_portion *portion, int64_t of_a, int64_t t, int32_t n, gjk_q16 a,
                                     gjk_q16 b, gjk_q16 *rest_a, gjk_q16 *rest_b, bool *saturated) {
  const int64_t moved = gjk2_portion_nearest(portion, of_a);
  *rest_a = (gjk_q16)(a + moved);
  *rest_b = gjk_saturate_noting(b + moved + plane_round_along(portion, t, n), saturated);
}

void gjk2_cast_hit(const gjk2_way *way, const gjk2_contact_place *place, const gjk2_portion *portion,
                   gjk2_cast_result *out) {
  const gjk2_collider *a = way->a, *b = way->b;
  const gjk2_vec n = place->n;
  gjk2_length length;
  plane_cast_count(way, out);
  gjk2_normal_set(&out->normal, &length, &n);
  out->hit = true;
  out->inside = false;
  out->saturated = false;
  out->fraction = portion->fraction;
  plane_cast_point(a, &place->p->a, &place->q->a, place->weight, &out->normal, a->shape->convex_radius, &way->of_a,
                   portion->fraction, &out->point_a, &out->saturated);
  plane_cast_point(b, &place->p->b, &place->q->b, place->weight, &out->normal, -b->shape->convex_radius, &way->of_b,
                   portion->fraction, &out->point_b, &out->saturated);
  plane_cast_rest(portion, way->of_a.x, way->t.x, n.x, a->position.x, b->position.x, &out->rest_a.x, &out->rest_b.x,
                  &out->saturated);
  plane_cast_rest(portion, way->of_a.y, way->t.y, n.y, a->position.y, b->position.y, &out->rest_a.y, &out->rest_b.y,
                  &out->saturated);
  if (!gjk2_is_curved(a->shape) && !gjk2_is_curved(b->shape)) {
    gjk2_cast_certificate *c = &out->certificate;
    c->proof = GJK2_CAST_PROOF_FACET;
    gjk2_copy(&c->direction, &n);
    c->count = place->p == place->q ? 1 : 2;
    c->a[0] = place->p->a.vertex;
    c->b[0] = place->p->b.vertex;
    c->a[1] = place->q->a.vertex;
    c->b[1] = place->q->b.vertex;
  } else {
    out->certificate.proof = GJK2_CAST_PROOF_NONE;
  }
}
