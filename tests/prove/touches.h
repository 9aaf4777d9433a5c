// Any contact points that src/contact/gjk_clip.c may give.
#ifndef PROVE_TOUCHES_H
#define PROVE_TOUCHES_H

#include "simplex_any.h"
#include "src/contact/gjk_clip.h"

static void any_touches(gjk_touches *touches, int32_t count) {
  for (int i = 0; i < count; i++) {
    gjk_contact *touch = &touches->touch[i];
    touch->point_a = any_position();
    touch->point_b = any_position();
    touch->distance = any_int32();
    touch->id = any_uint16();
  }
  touches->count = (unsigned)count;
}

// It is set.
static void check_position(const gjk_vec3 *v) {
  check_size(v->x, INT64_C(1) << 31);
  check_size(v->y, INT64_C(1) << 31);
  check_size(v->z, INT64_C(1) << 31);
}

static void check_touch(const gjk_contact *touch) {
  check_position(&touch->point_a);
  check_position(&touch->point_b);
  check_size(touch->distance, INT64_C(1) << 31);
  check_size(touch->id, UINT16_MAX);
}

static void check_touches(const gjk_touches *touches) {
  //@ assert touches->count <= GJK_TOUCHES_MAX;
  for (unsigned i = 0; i < touches->count; i++) {
    check_touch(&touches->touch[i]);
  }
}

#endif
