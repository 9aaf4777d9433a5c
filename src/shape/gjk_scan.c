// Linear scans over vertices.
#include "gjk_scan.h"

#if GJK_NARROW_MULTIPLY

// Coarse products come first, and those in full only where these leave it open.

const gjk_vec3 *gjk_scan(const gjk_vec3 *first, const gjk_vec3 *end, unsigned bits, const gjk_vec3 *d) {
  const gjk_coarse c = gjk_coarse_direction(d, bits);
  const int32_t margin = 2 * GJK_COARSE_ERROR + 1;  // what lies further behind is no candidate
  const gjk_vec3 *best = first;
  int32_t limit = gjk_coarse_dot(&c, best) - margin;
  bool open = false;
  for (const gjk_vec3 *v = best + 1; v != end; v++) {
    const int32_t along = gjk_coarse_dot(&c, v);
    if (along > limit) {
      open = along - limit <= 2 * margin;
      if (along - limit > margin) {
        best = v;
        limit = along - margin;
      }
    }
  }
  if (!open) {
    return best;
  }
  const gjk_vec3 *v = first;
  while (v != best && gjk_coarse_dot(&c, v) < limit) {  // best itself reaches the limit
    v++;
  }
  best = v;
  int64_t most = gjk_dot(best, d);
  for (v++; v != end; v++) {
    if (gjk_coarse_dot(&c, v) >= limit) {
      const int64_t along = gjk_dot(v, d);
      if (along > most) {
        best = v;
        most = along;
      }
    }
  }
  return best;
}

void gjk_reach_start(gjk_reach *reach, unsigned bits) {
  reach->coarse = gjk_coarse_direction(reach->d, bits);
  // Whatever is below the coarse limit lies below the limit. A coarse product is at most 3 2^28 in size, a slack at most 4.
  const int64_t coarse_limit = gjk_sar64(reach->limit, reach->coarse.vertex_shift + reach->coarse.shift) - GJK_COARSE_ERROR;
  //@ assert coarse_limit >= -(INT32_C(1) << 30) && coarse_limit <= INT32_C(1) << 30;
  reach->coarse_limit = (int32_t)coarse_limit;
}

const gjk_vec3 *gjk_reach_next(gjk_reach *reach) {
  while (reach->next != reach->end) {
    const gjk_vec3 *v = reach->next++;
    if (gjk_coarse_dot(&reach->coarse, v) >= reach->coarse_limit && gjk_dot(v, reach->d) >= reach->limit) {
      return v;
    }
  }
  return NULL;
}

#else

const gjk_vec3 *gjk_scan(const gjk_vec3 *first, const gjk_vec3 *end, unsigned bits, const gjk_vec3 *d) {
  (void)bits;
  const int32_t x = d->x, y = d->y, z = d->z;
  const gjk_vec3 *v = first + 1, *after = v;  // after the farthest so far
  int64_t most = gjk_dot(first, d);
  while (v != end) {
    const int32_t vx = v->x, vy = v->y, vz = v->z;
    v++;
    const int64_t along = gjk_mac32(gjk_mac32(gjk_mul32(vx, x), vy, y), vz, z);
    if (along > most) {
      after = v;
      most = along;
    }
  }
  return after - 1;
}

const gjk_vec3 *gjk_reach_next(gjk_reach *reach) {
  const int32_t x = reach->d->x, y = reach->d->y, z = reach->d->z;
  const int64_t limit = reach->limit;
  const gjk_vec3 *const end = reach->end, *v = reach->next;
  while (v != end) {
    const int32_t vx = v->x, vy = v->y, vz = v->z;
    v++;
    if (gjk_mac32(gjk_mac32(gjk_mul32(vx, x), vy, y), vz, z) >= limit) {
      reach->next = v;
      return v - 1;
    }
  }
  return NULL;
}

#endif
