// Stands in for src/motion/gjk_portal.c under the casts: any answer that tests/prove/portal.c shows possible.
#include "portals.h"

void gjk_portal_start(gjk_portal *p, const gjk_collider *a, const gjk_collider *b, const gjk_way *way) {
  check_way(way);
  any_started(p, a, b);
}

gjk_passage gjk_portal_find(gjk_portal *p, const gjk_collider *a, const gjk_collider *b, const gjk_way *way) {
  const int32_t passage = any_between(GJK_PASSAGE_BESIDE, GJK_PASSAGE_LIMIT);
  //@ split passage;
  gjk_portal_start(p, a, b, way);
  p->iterations = (uint8_t)any_between(0, UINT8_MAX);
  p->leaving = any_bool();
  p->arrives = any_bool();
  if (passage == GJK_PASSAGE_BESIDE) {
    p->g = any_vec3(INT32_C(1) << 30);
  } else if (passage == GJK_PASSAGE_SHORT || passage == GJK_PASSAGE_FACET) {
    any_plane(p, 1);
  }
  return (gjk_passage)passage;
}

bool gjk_portal_load(gjk_portal *p, const gjk_cast_certificate *certificate) {
  //@ assert certificate->count <= 3;
  for (unsigned i = 0; i < certificate->count; i++) {
    check_size(certificate->a[i], UINT16_MAX);
    check_size(certificate->b[i], UINT16_MAX);
  }
  any_plane(p, 0);
  p->count = certificate->count;
  return any_bool();
}

bool gjk_portal_is_entry(gjk_portal *p) {
  check_plane(p);
  p->axis = (uint8_t)any_between(0, 2);
  return any_bool();
}

void gjk_portal_face(gjk_portal *p, const gjk_vec3 *g) {
  check_vec3(g, INT32_C(1) << 30);
  p->g = *g;
  any_long3(&p->n, INT64_MAX);
}

int gjk_portal_beside(const gjk_portal *p, const gjk_vec3 *u) {
  check_vec3(&p->g, INT32_C(1) << 30);
  check_vec3(u, ANY_CORNER);
  return any_between(-1, 1);
}

int gjk_portal_side(const gjk_portal *p, const gjk_vec3 *u, const gjk_long3 *at) {
  check_long3(&p->n, ANY_PLANE);
  check_vec3(u, ANY_CORNER);
  check_long3(at, ANY_START);
  return any_between(-1, 1);
}

int64_t gjk_portal_dot(const gjk_portal *p, const gjk_vec3 *u, const gjk_long3 *at, uint32_t *low) {
  check_long3(&p->n, ANY_PLANE);
  if (u != NULL) {
    check_vec3(u, ANY_CORNER);
  }
  check_long3(at, ANY_START);
  *low = (uint32_t)any_between(0, INT32_MAX);
  return any_long(INT64_MAX);
}

void gjk_portal_weights(const gjk_portal *p, gjk_u128 weight[3]) {
  check_plane(p);
  for (int i = 0; i < 3; i++) {
    weight[i].high = (uint64_t)any_long(INT64_MAX);
    weight[i].low = (uint64_t)any_long(INT64_MAX);
  }
}
