// Linear scans over vertices: the farthest along a direction, and all that reach a limit.
//
// On a core with a long multiplication each vertex costs one exact product. Without one (GJK_NARROW_MULTIPLY) the
// products of gjk_coarse.h are a filter:
//
// gjk_scan:
//   1. Find the largest coarse product. A vertex that stays margin behind it is not the farthest: the errors of two
//      coarse products are together less than margin. open tells whether any other vertex came closer.
//   2. If open is false, the vertex with the largest coarse product is the farthest.
//   3. Else compare the exact products of all vertices within margin in their order, so that the first of equals is
//      taken.
//
// gjk_reach_next:
//   4. A vertex whose coarse product is below coarse_limit does not reach the limit.
//   5. For the others the exact product decides.
#include "gjk_scan.h"

#if GJK_NARROW_MULTIPLY

const gjk_vec3 *gjk_scan(const gjk_vec3 *first, const gjk_vec3 *end, unsigned bits, const gjk_vec3 *d) {
  const gjk_coarse c = gjk_coarse_direction(d, bits);
  const int32_t margin = 2 * GJK_COARSE_ERROR + 1;
  const gjk_vec3 *best = first;
  int32_t limit = gjk_coarse_dot(&c, best) - margin;
  bool open = false;
  for (const gjk_vec3 *v = best + 1; v != end; v++) {  // Step 1; the largest coarse product is limit + margin
    const int32_t along = gjk_coarse_dot(&c, v);
    if (along > limit) {
      open = along - limit <= 2 * margin;
      if (along - limit > margin) {
        best = v;
        limit = along - margin;
      }
    }
  }
  if (!open) {  // Step 2
    return best;
  }
  // Step 3
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
  // |coarse product| <= 3 2^28, a slack of gjk_scan.h is at most 4 in its units:  |coarse_limit| <= 2^30
  const int64_t coarse_limit =
      gjk_sar64(reach->limit, reach->coarse.vertex_shift + reach->coarse.shift) - GJK_COARSE_ERROR;
  //@ assert coarse_limit >= -(INT32_C(1) << 30) && coarse_limit <= INT32_C(1) << 30;
  reach->coarse_limit = (int32_t)coarse_limit;
}

const gjk_vec3 *gjk_reach_next(gjk_reach *reach) {
  while (reach->next != reach->end) {
    const gjk_vec3 *v = reach->next++;
    // Steps 4 and 5
    if (gjk_coarse_dot(&reach->coarse, v) >= reach->coarse_limit && gjk_dot(v, reach->d) >= reach->limit) {
      return v;
    }
  }
  return NULL;
}

#else

#if GJK_CONDITIONAL_MOVES

// So many vertices are compared without branches. Of later ones few are farther than all before: one in 48 and less.
#define WITHOUT_BRANCHES 48

#endif

const gjk_vec3 *gjk_scan(const gjk_vec3 *first, const gjk_vec3 *end, unsigned bits, const gjk_vec3 *d) {
#if GJK_VECTORS
  if (end - first >= GJK_SCAN_VECTORS_FROM) {
    return gjk_scan_vectors(first, (size_t)(end - first), bits, d);
  }
#else
  (void)bits;
#endif
  const int32_t x = d->x, y = d->y, z = d->z;
  const gjk_vec3 *v = first + 1, *after = v;  // one past the farthest so far
  int64_t most = gjk_dot(first, d);
#if GJK_CONDITIONAL_MOVES
  const gjk_vec3 *const turn = !GJK_VECTORS && end - v > WITHOUT_BRANCHES ? v + WITHOUT_BRANCHES : end;
  while (v != turn) {
    const int32_t vx = v->x, vy = v->y, vz = v->z;
    v++;
    const int64_t along = gjk_mac32(gjk_mac32(gjk_mul32(vx, x), vy, y), vz, z);
    GJK_KEEP_LARGER(most, after, along, v);
  }
#endif
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
#if GJK_VECTORS
  if (reach->bits != 0) {
    return gjk_reach_next_vectors(reach);
  }
#endif
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
