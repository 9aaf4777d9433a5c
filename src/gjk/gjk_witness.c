// The witness points.
//
//   Step 1   Find the exact weights of the feature's vertices in its nearest point: numerators of one denominator.
//   Step 2   For each shape, add the weights of those that share its vertex, and order its vertices by their numbers. So the
//            points do not depend on the triangle that found them, where several hold the nearest point: crossing edges.
//            A box's three corners of a face become one corner and two half axes, for the same reason.
//   Step 3   Round the weights and take the point of each core; move it along the normal by the convex radius.
#include "gjk_witness.h"

// At a smaller shift edges may be so long that weights of 31 bits move the point by half an LSB: low parts count too.
#define FINE_SHIFT 4

// A point of a core: a vertex, and up to two steps from there, each by a part of the whole.
typedef struct core_point {
  unsigned steps;
  gjk_vec3 at;
  gjk_vec3 step[2];
  gjk_u128 part[2];
} core_point;

// The vertices of one shape in a feature: numbers, offsets from its centre, weights.
typedef struct core_feature {
  unsigned count;
  uint16_t number[3];
  gjk_vec3 corner[3];
  gjk_u128 part[3];
} core_feature;

// Step 2: takes a vertex with its weight. Curved shapes have no numbers, and theirs keep their order.
static void take_vertex(core_feature *f, bool numbered, uint16_t number, const gjk_vec3 *corner, const gjk_u128 *part) {
  unsigned i = f->count;
  while (numbered && i > 0 && f->number[i - 1] >= number) {  // at most twice
    if (f->number[i - 1] == number) {
      gjk_u128_add(&f->part[i - 1], part);
      return;
    }
    i--;
  }
  for (unsigned k = f->count; k > i; k--) {
    f->number[k] = f->number[k - 1];
    f->corner[k] = f->corner[k - 1];
    f->part[k] = f->part[k - 1];
  }
  f->number[i] = number;
  f->corner[i] = *corner;
  f->part[i] = *part;
  f->count++;
}

// Step 2 for three corners of a box's face, whose numbers differ in two bits: the corner without these bits, and both
// whole axes. A point's part of an axis is the weight of the corners with its bit.
//   offsets   at most 2^28 in size, axes 2^29
static void span_face(const core_feature *f, unsigned bits, core_point *out) {
  unsigned beside = 0;  // the corner that differs from both others in one bit
  const unsigned low = bits & (~bits + 1u);
  for (unsigned i = 0; i < 3; i++) {
    const unsigned j = gjk_next(i), across = f->number[j] ^ f->number[gjk_next(j)];
    beside = across == bits ? i : beside;
  }
  out->steps = 2;
  out->at = f->corner[beside];
  for (unsigned k = 0; k < 2; k++) {
    const unsigned bit = k == 0 ? low : bits ^ low;
    const bool set = (f->number[beside] & bit) != 0;
    out->part[k].low = out->part[k].high = 0;
    for (unsigned i = 0; i < 3; i++) {
      if ((f->number[i] & bit) != 0) {
        gjk_u128_add(&out->part[k], &f->part[i]);
      }
      if ((f->number[i] ^ f->number[beside]) == bit) {
        out->step[k] = set ? gjk_sub(f->corner[beside], f->corner[i]) : gjk_sub(f->corner[i], f->corner[beside]);
      }
    }
    if (set) {
      out->at = gjk_sub(out->at, out->step[k]);
    }
  }
}

// Step 2, at its end.
static void span(const core_feature *f, bool axes, core_point *out) {
  const unsigned bits = (f->number[0] | f->number[1] | f->number[2]) & ~(f->number[0] & f->number[1] & f->number[2]);
  if (axes && f->count == 3 && (bits == 3 || bits == 5 || bits == 6)) {
    span_face(f, bits, out);
    return;
  }
  out->steps = f->count - 1;
  out->at = f->corner[0];
  for (unsigned k = 0; k < out->steps; k++) {
    out->step[k] = gjk_sub(f->corner[k + 1], f->corner[0]);
    out->part[k] = f->part[k + 1];
  }
}

// The bits of a box's vertex that say where it is: those of half axes with a length. Other kinds: all.
static unsigned meaning_of(const gjk_collider *c) {
  unsigned bits = UINT16_MAX;
  if (c->shape->type->kind == GJK_KIND_AXES) {
    for (unsigned i = 0; i < c->count; i++) {
      bits = gjk_norm1(c->frame[i]) == 0 ? bits & ~(1u << i) : bits;
    }
  }
  return bits;
}

// One coordinate of the vertex of B, from B's centre, by that of the vertex of A and of w. At most 2^28 + 2^3 in size.
static int32_t offset_b(const gjk_iteration *it, gjk_q16 centre_a, gjk_q16 centre_b, int32_t a, int32_t w) {
  const int shift = it->shift;
  if (shift >= 0) {
    return centre_a - centre_b + a - gjk_sar32(w, (unsigned)shift);
  }
  return (int32_t)((int64_t)centre_a - centre_b + a - gjk_shl64(w, (unsigned)-shift));
}

// What all coordinates of one point share.
typedef struct core_weights {
  gjk_barycentric step[2];
  int32_t radius;  // twice the convex radius, against the normal negative
} core_weights;

// What the low parts of the weights add, Q31. In line it costs 0.9 % of a distance query.
GJK_OUT_OF_LINE static int64_t fine_part(const core_weights *of, int32_t v, int32_t w) {
  // |v|, |w| <= 2^30, weights < 2^16:  at most 2^31
  return gjk_sar64(gjk_mac32(gjk_mul32(v, of->step[0].low), w, of->step[1].low), 16);
}

// One coordinate of a point, in the world: at + weights steps + radius normal, to the nearest LSB.
//   |at| <= 2^29:                              start at most 2^60 + 2^30
//   |step| <= 2^30, each weight <= 2^31:       partial sums at most 5 2^60
//   |radius| <= 2^29, |normal| <= 2^30:        2^59 more
static int64_t coordinate(const core_weights *of, gjk_q16 centre, int32_t at, int32_t v, int32_t w, gjk_q30 normal) {
  //@ assert at >= -(INT32_C(1) << 29) && at <= INT32_C(1) << 29;
  const int64_t start = gjk_shl64(2 * at + 1, 30);
  int64_t sum = gjk_mac32(gjk_mac32(start, v, of->step[0].high), w, of->step[1].high);
  if ((of->step[0].low | of->step[1].low) != 0) {
    sum += fine_part(of, v, w);
  }
  return centre + gjk_sar64(gjk_mac32(sum, normal, of->radius), 31);
}

// Step 3 for one shape.
static void report_point(const core_point *p, const gjk_u128 *whole, bool fine, const gjk_vec3 *centre, gjk_q16 radius,
                         const gjk_unit3 *normal, gjk_vec3 *out, bool *saturated) {
  core_weights of = {{{0, 0}, {0, 0}}, 2 * radius};
  gjk_vec3 v = {0, 0, 0}, w = {0, 0, 0};
  if (p->steps > 0) {
    gjk_weights(p->part, p->steps, whole, fine, of.step);
    v = p->step[0];
    w = p->steps > 1 ? p->step[1] : w;
  }
  out->x = gjk_saturate_noting(coordinate(&of, centre->x, p->at.x, v.x, w.x, normal->x), saturated);
  out->y = gjk_saturate_noting(coordinate(&of, centre->y, p->at.y, v.y, w.y, normal->y), saturated);
  out->z = gjk_saturate_noting(coordinate(&of, centre->z, p->at.z, v.z, w.z, normal->z), saturated);
}

void gjk_witness_points(const gjk_iteration *it, const gjk_unit3 *normal, gjk_vec3 *point_a, gjk_vec3 *point_b,
                        bool *saturated) {
  const gjk_simplex *s = &it->simplex;
  const gjk_vec3 *a = &it->a->centre, *b = &it->b->centre;
  const bool numbered = !gjk_pair_is_curved(it), fine = it->shift < FINE_SHIFT;
  const unsigned bits_a = meaning_of(it->a), bits_b = meaning_of(it->b);
  core_feature of_a, of_b;
  core_point p;
  gjk_u128 part[3], whole = {0, 0};
  //@ assert s->count >= 1 && s->count <= 3;
  gjk_simplex_parts(s, part);  // Step 1
  of_a.count = of_b.count = 0;
  for (unsigned i = 0; i < s->count; i++) {
    const gjk_vertex *v = &s->slot[s->order[i]];
    const gjk_vec3 offset = {offset_b(it, a->x, b->x, v->a.offset.x, v->w.x),
                             offset_b(it, a->y, b->y, v->a.offset.y, v->w.y),
                             offset_b(it, a->z, b->z, v->a.offset.z, v->w.z)};
    gjk_u128_add(&whole, &part[i]);
    take_vertex(&of_a, numbered, (uint16_t)(v->a.vertex & bits_a), &v->a.offset, &part[i]);
    take_vertex(&of_b, numbered, (uint16_t)(v->b & bits_b), &offset, &part[i]);
  }
  span(&of_a, numbered && it->a->shape->type->kind == GJK_KIND_AXES, &p);
  report_point(&p, &whole, fine, a, it->a->shape->convex_radius, normal, point_a, saturated);
  span(&of_b, numbered && it->b->shape->type->kind == GJK_KIND_AXES, &p);
  report_point(&p, &whole, fine, b, -it->b->shape->convex_radius, normal, point_b, saturated);
}
