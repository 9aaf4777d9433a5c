// src/motion/gjk_portal.h on any two colliders of vertices and any way: FIND the search; CHECK what the check of a cast
// asks, for a certificate of any content.
#include "portals.h"

// Values of CASE.
#define FIND 1
#define CHECK 2

static void read_weights(const gjk_portal *p) {
  gjk_u128 weight[3];
  uint32_t low;
  gjk_portal_weights(p, weight);
  (void)gjk_portal_dot(p, &p->corner[0].u, &p->start, &low);
  (void)gjk_portal_dot(p, NULL, &p->way, &low);
}

static void find(gjk_portal *p, const gjk_collider *a, const gjk_collider *b, const gjk_way *way) {
  const int passage = gjk_portal_find(p, a, b, way);
  //@ split passage;
  check_started(p);
  check_size(p->iterations, UINT8_MAX);
  if (passage == GJK_PASSAGE_BESIDE) {
    check_vec3(&p->g, INT32_C(1) << 30);
  } else if (passage == GJK_PASSAGE_SHORT || passage == GJK_PASSAGE_FACET) {
    check_plane(p);
    read_weights(p);
  }
}

static void check(gjk_portal *p, const gjk_collider *a, const gjk_collider *b, const gjk_way *way) {
  gjk_cast_certificate certificate;
  const int32_t count = any_between(0, 3);
  //@ split count;
  certificate.count = (uint8_t)count;
  certificate.direction = any_vec3(INT32_C(1) << 30);
  for (int i = 0; i < 3; i++) {
    certificate.a[i] = any_uint16();
    certificate.b[i] = any_uint16();
  }
  gjk_portal_start(p, a, b, way);
  check_started(p);
  const gjk_vec3 u = any_vec3(ANY_CORNER);
  gjk_portal_face(p, &certificate.direction);
  (void)gjk_portal_beside(p, &u);
  if (!gjk_portal_load(p, &certificate)) {
    return;
  }
  check_plane(p);
  (void)gjk_portal_side(p, &u, &p->start);
  (void)gjk_portal_side(p, &u, &p->goal);
  if (count > 0 && gjk_portal_is_entry(p)) {
    read_weights(p);
  }
}

int main(void) {
  gjk_shape shapes[2] = {0};
  gjk_collider a = {0}, b = {0};
  gjk_way way;
  gjk_portal p;
  any_collider(&a, &shapes[0], &polytope);
  any_collider(&b, &shapes[1], &polytope);
  any_way(&way);
#if CASE == FIND
  find(&p, &a, &b, &way);
#else
  check(&p, &a, &b, &way);
#endif
  return 0;
}
