// Linear scans over vertices, eight at a time: what gjk_scan.h promises, on a core with vectors (GJK_VECTORS).
//
// Coarse products of 16 bits are a filter. Per component of vertices v, w and the direction d
//
//   v = 2^shift vc + vr,  0 <= vr < 2^shift,  |vc| <= 2^14
//   d = 2^16 dc + q,      0 <= q < 2^16,      |dc| <= 2^15
//
//   v . d / 2^(shift + 16) = vc . dc + vc . q / 2^16 + vr . d / 2^(shift + 16)
//
//   v . d >= w . d  =>  vc . dc > wc . dc - |(vc - wc) . q| / 2^16 - |(vr - wr) . d| / 2^(shift + 16)
//                               > wc . dc - 3 2^15                 - 3 2^15
//                   =>  floor(vc . dc / 2^16) >= floor(wc . dc / 2^16) - 3
//
// gjk_scan_vectors:
//   1. Find the largest coarse product, floor(vc . dc / 2^16), 64 vertices at a time.
//   2. A vertex more than 3 behind it is not the farthest. Mark the others.
//   3. If a single one is marked, it is the farthest.
//   4. Else compare the exact products in the order of vertices, so that the first of equals is taken.
//
// gjk_reach_next_vectors:
//   5. Mark, 64 vertices at a time, those whose coarse products are at most 3 below the divided limit. It bounds the
//      others, as in the inference above with w . d replaced by the limit, wc by 0 and wr by 0.
//   6. For these the exact product decides.
#include "gjk_scan.h"

#if GJK_VECTORS

#define BLOCK 8   // vertices in a vector
#define CHUNK 64  // vertices marked in one uint64_t
#define MARGIN 3

// A direction's dc as it meets the components of two vertices, and the shift of vertices.
typedef struct coarse {
  gjk_4x32 even, odd;
  int32_t shift;
} coarse;

static inline coarse coarse_direction(const gjk_vec3 *d, unsigned bits) {
  const gjk_4x32 even = {d->x, d->y, d->z, 0}, odd = {0, d->x, d->y, d->z};
  const coarse c = {even >> 16, odd >> 16, bits > 14 ? (int32_t)bits - 14 : 0};
  return c;
}

// vc . dc of four vertices. Of each two it reads x y z x and z x y z.
//   |sum of two products| <= 2 2^14 2^15 = 2^30,  |vc . dc| <= 3 2^29
static inline gjk_4x32 four_products(const gjk_vec3 *v, const coarse *c) {
  const gjk_4x32 a = gjk_load_4x32(&v[0].x) >> c->shift, b = gjk_load_4x32(&v[0].z) >> c->shift;
  const gjk_4x32 e = gjk_load_4x32(&v[2].x) >> c->shift, f = gjk_load_4x32(&v[2].z) >> c->shift;
  return gjk_add_neighbours(gjk_add_products(a, b, c->even, c->odd), gjk_add_products(e, f, c->even, c->odd));
}

// The coarse products of eight vertices:  |...| <= 3 2^13
static inline gjk_8x16 block_products(const gjk_vec3 *v, const coarse *c) {
  return gjk_narrow(four_products(v, c) >> 16, four_products(v + 4, c) >> 16);
}

// Step 4, after best, the farthest so far; NULL: none.
GJK_OUT_OF_LINE static const gjk_vec3 *farthest_marked(const gjk_vec3 *first, uint64_t marked, const gjk_vec3 *d,
                                                       const gjk_vec3 *best) {
  int64_t most = best == NULL ? INT64_MIN : gjk_dot(best, d);
  for (; marked != 0; marked &= marked - 1) {
    const gjk_vec3 *v = first + gjk_lowest_bit(marked);
    const int64_t along = gjk_dot(v, d);
    if (along > most) {
      best = v;
      most = along;
    }
  }
  return best;
}

const gjk_vec3 *gjk_scan_vectors(const gjk_vec3 *first, size_t count, unsigned bits, const gjk_vec3 *d) {
  const coarse c = coarse_direction(d, bits);
  const gjk_vec3 *best = NULL;
  gjk_8x16 products[CHUNK / BLOCK], largest = gjk_all_8x16(INT16_MIN);
  for (;;) {  // a chunk
    const size_t last = (count > CHUNK ? CHUNK : count) - BLOCK;
    for (size_t i = 0; i < last; i += BLOCK) {  // Step 1
      products[i / BLOCK] = block_products(first + i, &c);
      largest = gjk_larger(largest, products[i / BLOCK]);
    }
    const gjk_8x16 last_products = block_products(first + last, &c);
    largest = gjk_largest(gjk_larger(largest, last_products));
    const gjk_8x16 limit = largest - (MARGIN + 1);
    uint64_t marked = (uint64_t)gjk_bits_of(last_products > limit) << last;  // Step 2
    for (size_t i = 0; i < last; i += BLOCK) {
      marked |= (uint64_t)gjk_bits_of(products[i / BLOCK] > limit) << i;
    }
    if (count <= CHUNK) {
      return best == NULL && (marked & (marked - 1)) == 0 ? first + gjk_lowest_bit(marked)  // Step 3
                                                          : farthest_marked(first, marked, d, best);
    }
    best = farthest_marked(first, marked, d, best);
    const size_t step = count - CHUNK < BLOCK ? count - BLOCK : CHUNK;
    first += step;
    count -= step;
  }
}

// Step 5: marks from the next up to 64 vertices. Where fewer than eight are left, those before them are looked at
// again and not marked.
static void mark_next(gjk_reach *reach) {
  const coarse c = coarse_direction(reach->d, reach->bits);
  const size_t left = (size_t)(reach->end - reach->next), fresh = left < CHUNK ? left : CHUNK;
  const size_t seen = fresh < BLOCK ? BLOCK - fresh : 0, last = fresh + seen - BLOCK;
  // |limit| <= 3 2^(bits + 31) + 2^33,  shift >= bits - 14:  |limit| / 2^(shift + 32) <= 3 2^13 + 2
  const gjk_8x16 limit = gjk_all_8x16((int16_t)(gjk_sar64(reach->limit, (unsigned)c.shift + 32) - (MARGIN + 1)));
  reach->first = reach->next - seen;
  reach->marked = (uint64_t)gjk_bits_of(block_products(reach->first + last, &c) > limit) << last;
  for (size_t i = 0; i < last; i += BLOCK) {
    reach->marked |= (uint64_t)gjk_bits_of(block_products(reach->first + i, &c) > limit) << i;
  }
  reach->marked = reach->marked >> seen << seen;
  reach->next += fresh;
}

const gjk_vec3 *gjk_reach_next_vectors(gjk_reach *reach) {
  while (reach->marked != 0 || reach->next != reach->end) {
    if (reach->marked == 0) {
      mark_next(reach);
    }
    for (uint64_t marked = reach->marked; marked != 0;) {  // Step 6
      const gjk_vec3 *v = reach->first + gjk_lowest_bit(marked);
      marked &= marked - 1;
      if (gjk_dot(v, reach->d) >= reach->limit) {
        reach->marked = marked;
        return v;
      }
    }
    reach->marked = 0;
  }
  return NULL;
}

#endif
