// Any portal that a search or a load may leave, as src/motion/gjk_portal.h has it, and the check that one is such a portal.
#ifndef PROVE_PORTALS_H
#define PROVE_PORTALS_H

#include "src/motion/gjk_portal.h"
#include "ways.h"

// A component of a scaled corner, and of a plane's normal.
#define ANY_CORNER ((INT32_C(1) << 29) - 1)
#define ANY_PLANE ((INT64_C(1) << 62) - 1)

// A component of start, and of goal.
#define ANY_START ((INT64_C(1) << 32) + (INT64_C(1) << 31))

static void any_long3(gjk_long3 *v, int64_t size) {
  v->x = any_long(size);
  v->y = any_long(size);
  v->z = any_long(size);
}

static void check_long3(const gjk_long3 *v, int64_t size) {
  check_size(v->x, size);
  check_size(v->y, size);
  check_size(v->z, size);
}

static void any_corner(gjk_corner *c) {
  c->u = any_vec3(ANY_CORNER);
  c->a = any_uint16();
  c->b = any_uint16();
}

// What a portal is once started.
static void any_started(gjk_portal *p, const gjk_collider *a, const gjk_collider *b) {
  p->a = a;
  p->b = b;
  p->shift = (uint8_t)any_between(0, 18);
  p->iterations = 0;
  p->leaving = false;
  p->arrives = false;
  p->wide = any_bool();
  p->near = any_bool();
  any_long3(&p->way, ANY_WAY);
  any_long3(&p->start, ANY_WAY);
  any_long3(&p->goal, ANY_START);
  any_long3(&p->m, INT64_C(7) << 60);
  p->t = any_vec3(INT32_C(1) << 30);
}

static void any_plane(gjk_portal *p, int32_t least) {
  any_long3(&p->n, ANY_PLANE);
  p->direction.d = any_vec3(INT32_C(1) << 30);
  p->direction.exact = any_bool();
  const int32_t count = any_between(least, 3);
  //@ split count;
  p->count = (uint8_t)count;
  for (int i = 0; i < 4; i++) {
    any_corner(&p->corner[i]);
  }
  p->axis = (uint8_t)any_between(0, 2);
}

static void check_started(const gjk_portal *p) {
  check_size(p->shift, 18);
  check_long3(&p->way, ANY_WAY);
  check_long3(&p->start, ANY_WAY);
  check_long3(&p->goal, ANY_START);
  check_long3(&p->m, INT64_C(7) << 60);
}

static void check_plane(const gjk_portal *p) {
  check_long3(&p->n, ANY_PLANE);
  check_vec3(&p->direction.d, INT32_C(1) << 30);
  //@ assert p->count <= 3;
  for (unsigned i = 0; i < p->count; i++) {
    check_vec3(&p->corner[i].u, ANY_CORNER);
  }
}

#endif
