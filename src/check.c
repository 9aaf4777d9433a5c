// Checks certificates: from the named vertices, or the named direction, and one visit to every vertex.
#include "gjk/check.h"

#include "iteration.h"

// Fills the simplex with the named pairs. False when a vertex does not exist.
static bool load(gjk_iteration *it, const gjk_certificate *certificate) {
  gjk_simplex *s = &it->simplex;
  for (uint8_t i = 0; i < certificate->count; i++) {
    s->count = i;
    if (!gjk_iteration_place(it, certificate->a[i], certificate->b[i])) {
      return false;
    }
  }
  gjk_simplex_clear(s);
  return true;
}

// The vertex number, from 0, in *offset; vertices are numbered without gaps, and none has the last number.
typedef struct visit {
  const gjk_collider *collider;
  uint16_t number;
} visit;

static bool next(visit *v, gjk_vec3 *offset) {
  return v->collider->shape->type->vertex(v->collider, v->number++, offset);
}

// Does no vertex of the collider lie before vertex origin along the exact direction?
// Pre: the vertex exists.
static bool none_before(const gjk_collider *c, const gjk_direction *direction, uint16_t origin) {
  gjk_vec3 base, offset;
  visit v = {c, 0};
  const bool exists = c->shape->type->vertex(c, origin, &base);
  //@ assert exists;
  (void)exists;
  while (next(&v, &offset)) {  // at most GJK_HULL_VERTICES_MAX vertices
    const gjk_vec3 step = gjk_sub(offset, base);
    if (gjk_direction_sign(direction, &step) > 0) {
      return false;
    }
  }
  return true;
}

// The largest offset . d of the collider's vertices.
static int64_t farthest(const gjk_collider *c, const gjk_vec3 *d) {
  gjk_vec3 offset;
  visit v = {c, 0};
  int64_t largest = INT64_MIN;
  while (next(&v, &offset)) {  // at most GJK_HULL_VERTICES_MAX vertices
    const int64_t along = gjk_dot(&offset, d);
    largest = along > largest ? along : largest;
  }
  return largest;
}

// Does no vertex of A - B lie before the certificate's first along the direction?
static bool is_support(const gjk_iteration *it, const gjk_certificate *certificate, gjk_direction *direction) {
  direction->opposite = false;
  if (!none_before(it->a, direction, certificate->a[0])) {
    return false;
  }
  direction->opposite = true;
  return none_before(it->b, direction, certificate->b[0]);
}

// Is the named feature the nearest of A - B to the origin, and apart from it?
static bool is_nearest(gjk_iteration *it, const gjk_certificate *certificate) {
  gjk_direction direction;
  gjk_rounded rounded;
  gjk_simplex *s = &it->simplex;
  if (certificate->count < 1 || certificate->count > 3 || !load(it, certificate) ||
      !gjk_simplex_set(s, certificate->count) || !gjk_simplex_direction(s, &rounded)) {
    return false;
  }
  gjk_simplex_exact_direction(s, &direction);
  if (s->count == 3 && gjk_dot_sign(&s->normal, &s->slot[0].w) == 0) {
    return false;
  }
  return is_support(it, certificate, &direction);
}

static bool is_enclosing(gjk_iteration *it, const gjk_certificate *certificate) {
  return certificate->count >= 1 && certificate->count <= 4 && load(it, certificate) &&
         gjk_simplex_encloses(&it->simplex, certificate->count);
}

static bool is_near(gjk_iteration *it, const gjk_certificate *certificate) {
  return certificate->count >= 1 && certificate->count <= 3 && load(it, certificate) &&
         gjk_simplex_set(&it->simplex, certificate->count) && gjk_iteration_near(it);
}

// Does the plane across direction keep all of A - B more than radius away? Directions beyond 3 2^29 per component are
// never made; radii from 2^31 exceed every vertex of A - B. Products: at most sqrt(3) 3 2^29 times 3 2^29.
static bool is_separating(const gjk_iteration *it, const gjk_vec3 *direction, int64_t radius) {
  const int64_t limit = INT64_C(3) << 29;
  const gjk_vec3 d = *direction;
  if (gjk_magnitude32(d.x) > limit || gjk_magnitude32(d.y) > limit || gjk_magnitude32(d.z) > limit ||
      radius > INT32_MAX) {
    return false;
  }
  const gjk_vec3 opposite = gjk_negate(d);
  const gjk_vec3 delta = gjk_sub(it->a->centre, it->b->centre);
  const int64_t along = gjk_dot(&delta, &d) + farthest(it->a, &d) + farthest(it->b, &opposite);
  return along < 0 && gjk_sum_sign(along, along, -(radius * radius), gjk_dot(&d, &d)) > 0;
}

static bool is_apart(gjk_iteration *it, const gjk_certificate *certificate, int64_t radius) {
  if (certificate->proof == GJK_PROOF_DIRECTION) {
    return is_separating(it, &certificate->direction, radius);
  }
  return certificate->proof == GJK_PROOF_NEAREST && is_nearest(it, certificate) && !gjk_iteration_near(it);
}

static bool is_together(gjk_iteration *it, const gjk_certificate *certificate) {
  if (certificate->proof == GJK_PROOF_NEAR) {
    return is_near(it, certificate);
  }
  return certificate->proof == GJK_PROOF_ENCLOSING && is_enclosing(it, certificate);
}

gjk_status gjk_check_decision(const gjk_collider *a, const gjk_collider *b, gjk_q16 distance,
                              const gjk_decision *decision) {
  gjk_iteration it;
  gjk_status status = gjk_check_pair(a, b, decision);
  if (status != GJK_OK || distance < 0) {
    return status != GJK_OK ? status : GJK_ERROR_NEGATIVE;
  }
  const gjk_certificate *certificate = &decision->certificate;
  const int64_t radius = (int64_t)a->shape->round + b->shape->round + distance;
  if (!gjk_iteration_start(&it, a, b, GJK_GOAL_WITHIN, radius)) {
    return decision->yes ? GJK_ERROR_UNPROVEN : GJK_OK;
  }
  if (it.curved != NULL || it.shift < 0) {
    return GJK_ERROR_UNSUPPORTED;
  }
  const bool proven = decision->yes ? is_together(&it, certificate) : is_apart(&it, certificate, radius);
  return proven ? GJK_OK : GJK_ERROR_UNPROVEN;
}

gjk_status gjk_check_distance(const gjk_collider *a, const gjk_collider *b, const gjk_distance_result *result) {
  gjk_iteration it;
  gjk_status status = gjk_check_pair(a, b, result);
  if (status != GJK_OK) {
    return status;
  }
  const gjk_certificate *certificate = &result->certificate;
  const int64_t radius = (int64_t)a->shape->round + b->shape->round;
  gjk_iteration_start(&it, a, b, GJK_GOAL_DISTANCE, radius);
  if (it.curved != NULL || it.shift < 0) {
    return GJK_ERROR_UNSUPPORTED;
  }
  if (result->intersecting) {
    return result->distance == 0 && is_together(&it, certificate) ? GJK_OK : GJK_ERROR_UNPROVEN;
  }
  if (result->distance < 0 || certificate->proof != GJK_PROOF_NEAREST || !is_apart(&it, certificate, radius)) {
    return GJK_ERROR_UNPROVEN;
  }
  // 2 d - 1 <= 2 (exact distance of the cores) < 2 d + 1, the left for d > 0. In the frame no distance exceeds 2^31.
  const uint64_t twice = 2 * (uint64_t)((int64_t)result->distance + radius);
  if (twice > UINT64_C(1) << (33 - it.shift)) {
    return GJK_ERROR_UNPROVEN;
  }
  gjk_limbs numerator, denominator;
  gjk_simplex_squared_distance(&it.simplex, &numerator, &denominator);
  const bool below = gjk_compare_distance(&numerator, &denominator, (twice + 1) << it.shift) < 0;
  const bool above = twice == 0 || gjk_compare_distance(&numerator, &denominator, (twice - 1) << it.shift) >= 0;
  return below && above ? GJK_OK : GJK_ERROR_UNPROVEN;
}

// The sign of the exact distance of the simplex's feature less d LSB.
static int compare_to(const gjk_iteration *it, int64_t d) {
  gjk_limbs numerator, denominator;
  // In the frame no distance exceeds 2^31.
  if (d < 0 || d > (int64_t)(UINT32_MAX >> it->shift)) {
    return d < 0 ? 1 : -1;
  }
  gjk_simplex_squared_distance(&it->simplex, &numerator, &denominator);
  return gjk_compare_distance(&numerator, &denominator, (uint64_t)((uint32_t)d << it->shift) * 2);
}

// Do three pairs span a plane that no vertex of A - B lies beyond, depth (rounded up) over the origin?
static bool is_facet(gjk_iteration *it, const gjk_certificate *certificate, int64_t depth) {
  const gjk_simplex *s = &it->simplex;
  gjk_long3 n;
  if (certificate->count != 3 || !load(it, certificate)) {
    return false;
  }
  const gjk_vec3 edge = gjk_edge(s->slot[1].w, s->slot[0].w), edge2 = gjk_edge(s->slot[2].w, s->slot[0].w);
  gjk_cross(&edge, &edge2, &n);
  gjk_direction outwards = {NULL, NULL, &n, 0, 0, 3, false};
  gjk_simplex_set(&it->simplex, 3);
  return (n.x | n.y | n.z) != 0 && gjk_dot_sign(&n, &s->slot[0].w) >= 0 && is_support(it, certificate, &outwards) &&
         compare_to(it, depth) <= 0 && compare_to(it, depth - 1) > 0;
}

// Does the plane across direction through the origin bound A - B, touching it? Products: at most sqrt(3) 2^31 times 2^30.
static bool is_level(const gjk_iteration *it, const gjk_certificate *certificate) {
  const gjk_vec3 d = certificate->direction;
  if ((d.x | d.y | d.z) == 0 || d.x < -INT32_MAX || d.y < -INT32_MAX || d.z < -INT32_MAX) {
    return false;
  }
  const gjk_vec3 opposite = gjk_negate(d), delta = gjk_sub(it->a->centre, it->b->centre);
  return gjk_dot(&delta, &d) + farthest(it->a, &d) + farthest(it->b, &opposite) == 0;
}

gjk_status gjk_check_penetration(const gjk_collider *a, const gjk_collider *b, const gjk_penetration_result *result) {
  gjk_iteration it;
  const gjk_status status = gjk_check_pair(a, b, result);
  if (status != GJK_OK) {
    return status;
  }
  const gjk_certificate *certificate = &result->certificate;
  const int64_t radius = (int64_t)a->shape->round + b->shape->round, depth = (int64_t)result->depth - radius;
  if (!gjk_iteration_start(&it, a, b, GJK_GOAL_DEPTH, radius)) {
    return result->intersecting ? GJK_ERROR_UNPROVEN : GJK_OK;
  }
  if (it.curved != NULL) {  // near enough for the unscaled frame they are: the bounding spheres meet
    return GJK_ERROR_UNSUPPORTED;
  }
  //@ assert it.shift >= 0;
  bool proven = false;
  if (!result->intersecting) {
    proven = is_apart(&it, certificate, radius);
  } else if (certificate->proof == GJK_PROOF_FACET) {
    proven = is_facet(&it, certificate, depth);
  } else if (certificate->proof == GJK_PROOF_PLANE) {
    proven = depth == 0 && is_level(&it, certificate);
  } else if (certificate->proof == GJK_PROOF_NEAREST) {
    proven = result->depth >= 0 && is_nearest(&it, certificate) && compare_to(&it, -depth) >= 0 &&
             compare_to(&it, 1 - depth) < 0;
  }
  return proven ? GJK_OK : GJK_ERROR_UNPROVEN;
}
