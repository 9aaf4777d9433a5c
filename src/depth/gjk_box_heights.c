// The heights of the planes across two half axes each, from the high words of 64-bit products.
//
//   Step 1   Scale the half axes of each shape, so that the largest has 30 bits: a of A, b of B.
//   Step 2   Faces: the normals n = a_1 x a_2 / 2^32 and so on, and of B alike. The volumes |n . b| / 2^32 serve the
//            face and two edges each:   (a_1 x a_2) . b = a_1 . (a_2 x b) = a_2 . (b x a_1).
//   Step 3   Edges: the normals a x b themselves are not needed.
//              |(a x b) . delta| = |a . (b x delta)|
//              |a x b|^2         = |a|^2 |b|^2 - (a . b)^2
//
// Rounding: each vector / 2^32 loses less than 1 per component, sqrt(3) together; each number / 2^32 less than 1.
//   volumes             sqrt(3) |b| / 2^32 + 1 <= 7/4              with |b| <= sqrt(3) 2^30
//   n . delta           sqrt(3) 2^30 / 2^32 + 1 < 3/2
//   a . (b x delta)     as volumes
//   sum of a face       four volumes, n . delta                    17/2; shifts make volumes' errors smaller, and add
//   sum of an edge      four volumes, a . (b x delta)              35/4   less than they take
//   |n|^2 / 2^32        from -1 to 2 more than its whole part      2 sqrt(3) |n| + 3 < 2^32
//   |a x b|^2 / 2^32    from -2 to 2 more than the difference of whole parts: with p, q for |a|^2, |b|^2 / 2^32 and r
//                       for |a . b| / 2^32, each at most 3 2^28, |a x b|^2 / 2^64 is at least p q - (r + 1)^2 and at
//                       most (p + 1) (q + 1) - (r - 1)^2, where r >= 1; p + q + 2 r + 1 < 2^32
#include "gjk_box_heights.h"

#include "../arith/gjk_root.h"

// One of the shapes, scaled.
typedef struct box_side {
  gjk_vec3 axis[3];
  unsigned count, shift;  // of half axes; they are those of the frame times 2^shift
  int32_t volume[3][3];   // [m][k]: |n_m . half axis k of the other shape| / 2^32; 0 where count < 3
} box_side;

static inline int32_t high_dot(const gjk_vec3 *a, const gjk_vec3 *b) {
  return gjk_high32(gjk_dot(a, b));
}

static inline int32_t absolute(int32_t x) {
  const int32_t sign = gjk_sar32(x, 31);
  return (x ^ sign) - sign;
}

// a x b / 2^32. Pre: |a| <= sqrt(3) 2^30, |b| alike.
static inline gjk_vec3 high_cross(const gjk_vec3 *a, const gjk_vec3 *b) {
  gjk_long3 n;
  gjk_cross(a, b, &n);
  const gjk_vec3 high = {gjk_high32(n.x), gjk_high32(n.y), gjk_high32(n.z)};
  return high;
}

// Step 1.
static void scale_box(const gjk_vec3 *axis, unsigned count, box_side *side) {
  uint32_t bits = 1;
  for (unsigned k = 0; k < count; k++) {
    // -1 - x for a negative x has as many bits, or one less: a component may come to -2^30
    bits |= (uint32_t)((axis[k].x ^ gjk_sar32(axis[k].x, 31)) | (axis[k].y ^ gjk_sar32(axis[k].y, 31)) |
                       (axis[k].z ^ gjk_sar32(axis[k].z, 31)));
  }
  const unsigned zeros = gjk_clz32(bits);
  side->count = count;
  side->shift = zeros < 2 ? 0 : zeros - 2;
  for (unsigned k = 0; k < count; k++) {
    side->axis[k].x = gjk_shl32(axis[k].x, side->shift);
    side->axis[k].y = gjk_shl32(axis[k].y, side->shift);
    side->axis[k].z = gjk_shl32(axis[k].z, side->shift);
  }
}

// Step 2 for the faces of one shape, whose first has this number. Returns one that separates the shapes, or
// GJK_BOX_PLANES.
static unsigned set_faces(box_side *side, const box_side *other, const gjk_vec3 *delta, unsigned number,
                          gjk_box_heights *out) {
  unsigned separating = GJK_BOX_PLANES;
  if (side->count < 3) {
    for (unsigned m = 0; m < 3; m++) {
      side->volume[m][0] = side->volume[m][1] = side->volume[m][2] = 0;
    }
    return separating;
  }
  int32_t own = 0;
  for (unsigned m = 0; m < 3; m++) {
    const gjk_vec3 n = high_cross(&side->axis[gjk_next(m)], &side->axis[gjk_next(gjk_next(m))]);
    if (m == 0) {
      own = gjk_sar32(absolute(high_dot(&n, &side->axis[0])), side->shift);
    }
    int32_t volumes = 0;
    for (unsigned k = 0; k < other->count; k++) {
      side->volume[m][k] = absolute(high_dot(&n, &other->axis[k]));
      volumes += side->volume[m][k];
    }
    out->sum[number + m] = own + gjk_sar32(volumes, other->shift) - absolute(high_dot(&n, delta));
    out->squared[number + m] = (uint32_t)high_dot(&n, &n) + 2;
    separating = out->sum[number + m] < -GJK_BOX_SUM_ERROR ? number + m : separating;
  }
  return separating;
}

// Step 3.
static void set_edges(const box_side *a, const box_side *b, const gjk_vec3 *delta, gjk_box_heights *out) {
  uint32_t p[3];
  for (unsigned i = 0; i < a->count; i++) {
    p[i] = (uint32_t)high_dot(&a->axis[i], &a->axis[i]);
  }
  for (unsigned j = 0; j < b->count; j++) {
    const gjk_vec3 *axis = &b->axis[j], turned = high_cross(axis, delta);
    const uint32_t q = (uint32_t)high_dot(axis, axis);
    const int32_t across = a->volume[0][j] + a->volume[1][j] + a->volume[2][j];
    const unsigned next = gjk_next(j), last = gjk_next(next);
    for (unsigned i = 0; i < a->count; i++) {
      const unsigned k = 6 + 3 * i + j;
      const uint32_t r = (uint32_t)absolute(high_dot(&a->axis[i], axis));
      const int32_t volumes =
          gjk_sar32(across - a->volume[i][j], a->shift) + gjk_sar32(b->volume[next][i] + b->volume[last][i], b->shift);
      out->sum[k] = volumes - absolute(high_dot(&a->axis[i], &turned));
      // p q <= 9 2^56. Not negative: at least the exact square.
      out->squared[k] = gjk_umulh32(p[i], q) + 2 - gjk_umulh32(r, r);
    }
  }
}

unsigned gjk_box_heights_set(const gjk_vec3 axis[GJK_BOX_AXES], const gjk_vec3 *delta, unsigned of_a, unsigned of_b,
                             gjk_box_heights *out) {
  box_side a, b;
  if (of_a + of_b < GJK_BOX_AXES) {
    for (unsigned k = 0; k < GJK_BOX_PLANES; k++) {
      out->sum[k] = INT32_C(1) << 30;
      out->squared[k] = 0;
    }
  }
  scale_box(axis, of_a, &a);
  scale_box(axis + 3, of_b, &b);
  unsigned separating = set_faces(&a, &b, delta, 0, out);
  separating = separating < GJK_BOX_PLANES ? separating : set_faces(&b, &a, delta, 3, out);
  if (separating == GJK_BOX_PLANES) {
    set_edges(&a, &b, delta, out);
  }
  return separating;
}

// 2^46 / sqrt(x), up to 2^-21 of itself too small, at most 0.5 too large, and below 2^31: one step less than
// gjk_reciprocal_root. Pre: x >= 2^30.
static uint32_t rough_reciprocal_root(uint32_t x) {
  const uint32_t y = UINT32_C(2319282340) - gjk_umulh32(x, UINT32_C(1342177280));
  return gjk_root_step(x, gjk_root_step(x, gjk_root_step(x, y)));
}

// With squared = 2^(-2 z) x, 2^30 <= x < 2^32, and y = 2^46 / sqrt(x):
//   height      2^32 s / |N| = s y 2^(z - 30)
//   s           off by at most 9:                                 9 2^(z - 30) y < 18 2^z
//   y           at most 2^-21 of itself too small, and 1/2 off:   height / 2^21, and 1; 2^-20 covers what follows
//   squared     up to 4 too large, where it is at least 64:       4 / (squared - 4) <= 8 / squared <= 2^(2 z - 27)
//               so 1 / |N| is larger by at most                   2^(2 z - 28) of itself
//   with z >= 2, 20 2^z bounds the first and all roundings.
void gjk_box_height_bounds(const gjk_box_heights *h, unsigned k, int32_t *low, int32_t *high) {
  const uint32_t squared = h->squared[k];
  if (gjk_box_height_is_short(h, k)) {
    *low = INT32_MIN;
    *high = INT32_MAX;
    return;
  }
  const unsigned z = gjk_clz32(squared) / 2;  // squared < 2^28:  2 <= z <= 12
  const uint32_t y = rough_reciprocal_root(squared << (2 * z));
  const int32_t height = (int32_t)gjk_sar64(gjk_mul32(h->sum[k], (int32_t)y), 30 - z);
  const int32_t size = absolute(height), error = gjk_shl32(20, z) + gjk_sar32(size, 28 - 2 * z) + gjk_sar32(size, 20);
  *low = height - error;
  *high = height + error;
}
