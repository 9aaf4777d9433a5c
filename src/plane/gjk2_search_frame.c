// The frame of a search of the plane (gjk2_search.h): where it starts, and how far pairs are scaled down.
#include "gjk2_search.h"

// floor(x / 2^n), n <= 3, by single steps: less code than a shift of 64 bits by a variable.
GJK_OUT_OF_LINE static int64_t shift_far(int64_t x, unsigned n) {
  for (; n > 0; n--) {
    x = gjk_sar64(x, 1);
  }
  return x;
}

// Is (x, y) / 2^far longer than 2^30? Pre: 0 <= x, y <= 2^32, and far >= 1 where one of them is above 2^31.
static bool is_long(int64_t x, int64_t y, unsigned far) {
  const uint32_t u = (uint32_t)shift_far(x, far), v = (uint32_t)shift_far(y, far);  // each square <= 2^62
  return gjk_umul32(u, u) + gjk_umul32(v, v) > UINT64_C(1) << 60;
}

// A radius of the frame's whole reach settles the question like a larger one.
#define FRAME_REACH (UINT32_C(3) << 29)

// The start for centres that may be more than 2^30 apart.
GJK_OUT_OF_LINE static bool start_far(gjk2_search *s, bool circles, uint32_t radius) {
  const int64_t x = (int64_t)s->a->centre.x - s->b->centre.x, y = (int64_t)s->a->centre.y - s->b->centre.y;
  const int64_t cores = (int64_t)s->a->core_radius + s->b->core_radius;
  const uint64_t ux = gjk_magnitude64(x), uy = gjk_magnitude64(y), limit = (uint64_t)(cores + radius);
  // From 2^31 on single components alone are compared, so circles that are apart may count as near.
  if (circles && (ux > limit || uy > limit ||
                  (limit >> 31 == 0 && gjk_umul32((uint32_t)ux, (uint32_t)ux) + gjk_umul32((uint32_t)uy, (uint32_t)uy) >
                                           gjk_umul32((uint32_t)limit, (uint32_t)limit)))) {
    return false;
  }
  s->far = (ux | uy) >> 31 != 0;
  while (is_long((int64_t)ux, (int64_t)uy, s->far)) {  // at most 3 times: then both are below 2^29 + 1
    s->far++;
  }
  const uint32_t framed = radius >> s->far;
  s->radius = framed < FRAME_REACH ? (int32_t)framed : (int32_t)FRAME_REACH;
  s->delta.x = (int32_t)shift_far(x, s->far);
  s->delta.y = (int32_t)shift_far(y, s->far);
  // Each is rounded down, so a negative one may be 1 below.
  //@ assert s->delta.x >= -(INT32_C(1) << 30) - 1 && s->delta.x <= INT32_C(1) << 30;
  //@ assert s->delta.y >= -(INT32_C(1) << 30) - 1 && s->delta.y <= INT32_C(1) << 30;
  return true;
}

// The start for near centres (gjk2_frame_is_near): as start_far's, for less.
static bool start_near(gjk2_search *s, bool circles, uint32_t radius) {
  const gjk2_vec delta = {s->a->centre.x - s->b->centre.x, s->a->centre.y - s->b->centre.y};
  //@ assert delta.x >= -(INT32_C(1) << 29) - 3 && delta.x <= (INT32_C(1) << 29) + 3;
  //@ assert delta.y >= -(INT32_C(1) << 29) - 3 && delta.y <= (INT32_C(1) << 29) + 3;
  // A radius of 2^30 or more exceeds |delta|. Core radii are below 2^28 + 4 each: limit < 2^31.
  if (circles && radius < UINT32_C(1) << 30) {
    const int32_t limit = s->a->core_radius + s->b->core_radius + (int32_t)radius;
    if (gjk2_dot(delta, delta) > gjk_mul32(limit, limit)) {
      return false;
    }
  }
  s->delta.x = delta.x;
  s->delta.y = delta.y;
  s->radius = radius < FRAME_REACH ? (int32_t)radius : (int32_t)FRAME_REACH;
  return true;
}

bool gjk2_search_start(gjk2_search *s, const gjk2_collider *a, const gjk2_collider *b, bool circles, uint32_t radius) {
  s->a = a;
  s->b = b;
  s->iterations = 0;
  s->far = 0;
  s->count = 0;
  s->curved = false;
  s->warm = false;
  if (!GJK_SMALL) {
    s->whole = false;
  }
  s->first = &s->slot[0];
  s->apex = &s->slot[1];
  s->last = &s->slot[2];
  s->spare = &s->slot[3];
  if (!gjk2_frame_is_near(a, b)) {
    if (!start_far(s, circles, radius)) {
      return false;
    }
  } else if (!start_near(s, circles, radius)) {
    return false;
  }
  s->d.x = -s->delta.x;
  s->d.y = -s->delta.y;
  gjk2_search_need_direction(s);
  s->walks = s->far == 0 && a->ordered && b->ordered;
  if (!s->walks) {  // curved shapes have no vertices in order
    s->curved = gjk2_is_curved(a->shape) || gjk2_is_curved(b->shape);
  }
  return true;
}

int32_t gjk2_frame_far(gjk_q16 a, gjk_q16 b, int32_t offset, unsigned far) {
  return (int32_t)shift_far((int64_t)a - b + offset + (INT32_C(1) << (far - 1)), far);
}
