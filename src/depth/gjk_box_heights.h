// Cheap bounds of the heights of the planes that may bound A - B, for boxes, segments and points.
#ifndef GJK_SRC_BOX_HEIGHTS_H
#define GJK_SRC_BOX_HEIGHTS_H

#include "../arith/gjk_vector.h"

// Half axes by slots: 0 to 2 of A, 3 to 5 of B; one that a shape lacks is 0.
#define GJK_BOX_AXES 6

// The planes by number: faces of A across its half axes 0, 1, 2; faces of B; edge i of A with edge j of B: 6 + 3 i + j.
#define GJK_BOX_PLANES 15

// How far sum is off its true value.
#define GJK_BOX_SUM_ERROR 9

// A plane that the shapes lack has sum 2^30 and squared 0. So it counts as the highest, and its normal as too short to
// tell. With N for a plane's normal / 2^32, as made of scaled half axes, the plane's height in the frame is
// 2^32 s / |N|.
typedef struct gjk_box_heights {
  int32_t sum[GJK_BOX_PLANES];       // s, within GJK_BOX_SUM_ERROR; at most 2^30 in size
  uint32_t squared[GJK_BOX_PLANES];  // |N|^2 / 2^32 at most, and too large by at most 4; below 2^28
} gjk_box_heights;

// Sets the heights. Returns a face that separates the shapes, or GJK_BOX_PLANES. After a face, the heights of edges may
// be missing. of_a, of_b: how many half axes the shapes have, 0, 1 or 3.
// Pre: |delta| <= 2^30; components of half axes at most 2^30 in size; the lengths of all together below 2^31.
unsigned gjk_box_heights_set(const gjk_vec3 axis[GJK_BOX_AXES], const gjk_vec3 *delta, unsigned of_a, unsigned of_b,
                             gjk_box_heights *out);

// Is the normal of plane k too short to tell?
static inline bool gjk_box_height_is_short(const gjk_box_heights *h, unsigned k) {
  return h->squared[k] < 64;
}

// What gjk_box_height_exceeds asks of a height: its square / 2^32, rounded up to at most 2^30. Pre: 0 <= height.
static inline uint32_t gjk_box_height_square(int32_t height) {
  return (uint32_t)gjk_high32(gjk_mul32(height, height)) + 1;
}

// Is the height of plane k surely above the one that has this square?
//   height >= 2^32 (sum - error) / |N|, the square of which is (sum - error)^2 / (|N|^2 / 2^32) 2^32
static inline bool gjk_box_height_exceeds(const gjk_box_heights *h, unsigned k, uint32_t square) {
  const int32_t sum = h->sum[k] - GJK_BOX_SUM_ERROR;
  return (sum > 0) & ((uint64_t)gjk_mul32(sum, sum) > gjk_umul32(square, h->squared[k]));
}

// Bounds of the height of plane k. high is INT32_MAX where the normal is too short to tell.
void gjk_box_height_bounds(const gjk_box_heights *h, unsigned k, int32_t *low, int32_t *high);

#endif
