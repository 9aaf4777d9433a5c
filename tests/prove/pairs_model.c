// Stands in for the queries of pairs under bodies of many parts: any answer that query.c, contacts.c, cast.c, impact.c and
// motion.c of tests/prove show, with what each status sets and no more.
#include "candidates.h"
#include "colliders.h"
#include "gjk/contacts.h"
#include "gjk/draw.h"
#include "gjk/intersect.h"
#include "src/motion/gjk_impact.h"
#include "src/motion/gjk_motion.h"
#include "src/query/gjk_distance.h"

// A search of parts keeps two results, of which the better one is its answer. Which of both are set: 1 the one that was set
// first, 2 the other. Of contacts: how many manifolds there are. Eva keeps its values apart, so that it sees that what is
// read has been set.
int32_t pairs_results_set = 0;

static void note_result(const void *out) {
  static const void *first = NULL;
  first = first == NULL ? out : first;
  pairs_results_set |= out == first ? 1 : 2;
}

static void check_posed(const gjk_collider *a, const gjk_collider *b) {
  //@ assert a->state == GJK_STATE_POSED && b->state == GJK_STATE_POSED;
  //@ assert a->shape->convex_radius >= 0 && b->shape->convex_radius >= 0;
}

static gjk_unit3 any_unit(void) {
  const gjk_unit3 u = {any_between(-ANY_UNIT, ANY_UNIT), any_between(-ANY_UNIT, ANY_UNIT),
                       any_between(-ANY_UNIT, ANY_UNIT)};
  return u;
}

static void any_proof(gjk_certificate *certificate) {
  for (int i = 0; i < 4; i++) {
    certificate->a[i] = any_uint16();
    certificate->b[i] = any_uint16();
  }
  certificate->direction = any_position();
  certificate->count = (uint8_t)any_between(0, 4);
  certificate->proof = (uint8_t)any_between(0, UINT8_MAX);
}

gjk_status gjk_within(const gjk_collider *a, const gjk_collider *b, gjk_q16 distance, gjk_cache *cache,
                      gjk_decision *out) {
  check_posed(a, b);
  const int32_t answer = any_between(0, 2);
  //@ split answer;
  if (distance < 0) {
    return GJK_ERROR_NEGATIVE;
  }
  if (cache != NULL) {
    check_size(cache->count, UINT16_MAX);
    any_cache(cache);
  }
  out->iterations = (uint8_t)any_between(0, UINT8_MAX);
  if (answer == 2) {
    return GJK_ERROR_ITERATION_LIMIT;
  }
  out->yes = answer != 0;
  any_proof(&out->certificate);
  return GJK_OK;
}

gjk_status gjk_intersect(const gjk_collider *a, const gjk_collider *b, gjk_cache *cache, gjk_decision *out) {
  return gjk_within(a, b, 0, cache, out);
}

gjk_status gjk_distance_with(const gjk_collider *a, const gjk_collider *b, gjk_distance_detail detail, gjk_cache *cache,
                             gjk_distance_result *out) {
  const bool points = detail != GJK_DISTANCE_ALONE;
  check_posed(a, b);
  (void)cache;
  const int32_t answer = any_between(0, 2);
  //@ split answer;
  out->intersecting = answer == 0;
  out->saturated = any_bool();
  out->iterations = (uint8_t)any_between(0, UINT8_MAX);
  out->distance = 0;
  out->lower = 0;
  out->upper = 0;
  if (points) {
    any_proof(&out->certificate);
  }
  if (answer != 0) {
    out->distance = any_between(0, INT32_MAX);
    out->lower = any_between(0, INT32_MAX);
    out->upper = any_between(0, INT32_MAX);
    if (points) {
      out->normal = any_unit();
      out->point_a = any_position();
      out->point_b = any_position();
    }
  }
  return answer == 2 ? GJK_ERROR_ITERATION_LIMIT : GJK_OK;
}

gjk_status gjk_distance(const gjk_collider *a, const gjk_collider *b, gjk_cache *cache, gjk_distance_result *out) {
  return gjk_distance_with(a, b, GJK_DISTANCE_POINTS, cache, out);
}

gjk_status gjk_signed_distance(const gjk_collider *a, const gjk_collider *b, gjk_cache *cache,
                               const gjk_workspace *workspace, gjk_distance_result *out) {
  check_posed(a, b);
  (void)cache, (void)workspace;
  const int32_t answer = any_between(0, 2);
  //@ split answer;
  out->lower = any_int32();
  out->upper = any_int32();
  out->iterations = (uint8_t)any_between(0, UINT8_MAX);
  if (answer == 2) {
    return GJK_ERROR_ITERATION_LIMIT;
  }
  out->distance = any_int32();
  out->normal = any_unit();
  out->point_a = any_position();
  out->point_b = any_position();
  out->intersecting = any_bool();
  out->saturated = any_bool();
  any_proof(&out->certificate);
  return answer == 1 ? GJK_ERROR_CAPACITY : GJK_OK;
}

gjk_status gjk_penetration(const gjk_collider *a, const gjk_collider *b, gjk_cache *cache,
                           const gjk_workspace *workspace, gjk_penetration_result *out) {
  check_posed(a, b);
  (void)cache, (void)workspace;
  const int32_t answer = any_between(0, 3);
  //@ split answer;
  if (answer == 3) {
    return GJK_ERROR_ITERATION_LIMIT;
  }
  out->intersecting = answer != 0;
  out->iterations = (uint8_t)any_between(0, UINT8_MAX);
  any_proof(&out->certificate);
  if (answer != 0) {
    note_result(out);
    out->depth = any_between(0, INT32_MAX);
    out->lower = any_between(0, INT32_MAX);
    out->upper = any_between(0, INT32_MAX);
    out->normal = any_unit();
    out->point_a = any_position();
    out->point_b = any_position();
  }
  return answer == 2 ? GJK_ERROR_CAPACITY : GJK_OK;
}

static void any_contacts(gjk_manifold *out, int32_t count) {
  out->count = (uint8_t)count;
  for (int i = 0; i < count; i++) {
    out->contact[i].point_a = any_position();
    out->contact[i].point_b = any_position();
    out->contact[i].distance = any_int32();
    out->contact[i].id = any_uint16();
  }
}

// No contact, one, or as many as there may be.
gjk_status gjk_contacts(const gjk_collider *a, const gjk_collider *b, gjk_q16 margin, unsigned most, gjk_cache *cache,
                        const gjk_workspace *workspace, gjk_manifold *out) {
  check_posed(a, b);
  (void)cache, (void)workspace;
  //@ assert margin >= 0 && most >= 1 && most <= GJK_CONTACTS_MAX;
  const int32_t answer = any_between(0, 3);
  //@ split answer;
  if (answer == 3) {
    return GJK_ERROR_ITERATION_LIMIT;
  }
  pairs_results_set += answer != 0 ? 1 : 0;
  out->normal = any_unit();
  out->feature_a = any_uint16();
  out->feature_b = any_uint16();
  any_contacts(out, answer == 2 ? (int32_t)most : answer);
  return any_bool() ? GJK_OK : GJK_ERROR_CAPACITY;
}

static void any_cast_answer(int32_t answer, gjk_cast_result *out) {
  out->iterations = (uint8_t)any_between(0, UINT8_MAX);
  out->hit = answer == 1 || answer == 2;
  out->certificate.direction = any_position();
  for (int i = 0; i < 3; i++) {
    out->certificate.a[i] = any_uint16();
    out->certificate.b[i] = any_uint16();
  }
  out->certificate.count = (uint8_t)any_between(0, 3);
  out->certificate.proof = (uint8_t)any_between(0, GJK_CAST_PROOF_SWEPT);
  if (answer == 0) {
    return;
  }
  note_result(out);
  out->inside = answer == 2;
  out->fraction = answer == 2 ? 0 : any_between(0, GJK_Q30_ONE);
  out->normal = any_unit();
  out->rest_a = any_position();
  out->rest_b = any_position();
  out->saturated = any_bool();
  if (answer != 2) {
    out->point_a = any_position();
    out->point_b = any_position();
  }
}

// 0: a miss, 1: a hit, 2: inside, 3: limited, 4: a centre leaves int32
static gjk_status any_cast(gjk_cast_result *out) {
  const int32_t answer = any_between(0, 4);
  //@ split answer;
  if (answer == 4) {
    return GJK_ERROR_RANGE;
  }
  any_cast_answer(answer, out);
  return answer == 3 ? GJK_ERROR_ITERATION_LIMIT : GJK_OK;
}

gjk_status gjk_cast(const gjk_collider *a, const gjk_collider *b, const gjk_cast_path *path, gjk_cast_result *out) {
  check_posed(a, b);
  //@ assert path->margin >= 0;
  if (path->to_a != NULL) {
    check_position(path->to_a);
  }
  if (path->to_b != NULL) {
    check_position(path->to_b);
  }
  return any_cast(out);
}

gjk_status gjk_cast_ray(const gjk_collider *a, const gjk_vec3 *from, const gjk_vec3 *to, gjk_cast_result *out) {
  check_posed(a, a);
  check_position(from);
  check_position(to);
  return any_cast(out);
}

gjk_status gjk_turning_start(const gjk_motion *motion, gjk_turning *out) {
  //@ assert \initialized(&motion->from) && \initialized(&motion->to);
  const int32_t good = any_between(0, 1);
  //@ split good;
  if (good == 0) {
    return GJK_ERROR_ROTATION;
  }
  out->half_turns = (uint64_t)Frama_C_long_long_interval(0, INT64_C(3) << 59);
  out->deviation = Frama_C_long_long_interval(-(INT64_C(1) << 44), INT64_C(1) << 44);
  out->axis = any_unit();
  return GJK_OK;
}

gjk_status gjk_motion_pose(const gjk_motion *motion, gjk_q30 fraction, gjk_pose *out) {
  //@ assert \initialized(&motion->from) && \initialized(&motion->to);
  //@ assert fraction >= 0 && fraction <= GJK_Q30_ONE;
  *out = any_pose();
  return GJK_OK;
}

gjk_status gjk_impact_of_carried(const gjk_carried of[2], const gjk_impact_setup *setup, gjk_composer *compose,
                                 gjk_impact_result *out) {
  (void)compose;
  for (int i = 0; i < 2; i++) {
    //@ assert \valid_read(of[i].collider) && \valid_read(of[i].motion);
    check_size(of[i].collider->local_centre.x, INT64_C(1) << 31);
    check_size(of[i].arm, UINT32_MAX);
    if (of[i].own != NULL) {
      check_position(&of[i].own->position);
    }
  }
  //@ assert setup->margin >= 0 && setup->margin <= GJK_IMPACT_MARGIN_MAX;
  const int32_t answer = any_between(0, 4);
  //@ split answer;
  if (answer == 4) {
    return any_bool() ? GJK_ERROR_RANGE : GJK_ERROR_UNINITIALISED;
  }
  note_result(out);
  out->iterations = (uint8_t)any_between(0, UINT8_MAX);
  out->pose_a = any_pose();
  out->pose_b = any_pose();
  out->hit = answer == 1 || answer == 2;
  out->overlap = answer == 2;
  out->lower = answer == 0 ? GJK_Q30_ONE : any_between(0, GJK_Q30_ONE);
  out->upper = out->hit ? out->lower : GJK_Q30_ONE;
  if (out->hit) {
    out->distance = any_between(0, INT32_MAX);
    out->point_a = any_position();
    out->point_b = any_position();
    out->normal = any_unit();
  }
  return answer == 3 ? GJK_ERROR_ITERATION_LIMIT : GJK_OK;
}

gjk_status gjk_draw_collider(const gjk_draw *draw, const gjk_collider *collider, gjk_draw_role role) {
  check_posed(collider, collider);
  (void)draw, (void)role;
  return GJK_OK;
}
