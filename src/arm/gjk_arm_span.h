// A pair on a span of an edge: a direction along which it is apart at both ends.
#ifndef GJK_SRC_ARM_SPAN_H
#define GJK_SRC_ARM_SPAN_H

#include "../arith/gjk_vector.h"
#include "gjk_arm_frames.h"

// P and S of a pair at both ends of a span, in the frame where S stands still; see gjk_arm_bound.c.
typedef struct gjk_arm_view {
  const gjk_arm *arm;
  const gjk_arm_pair *pair;
  unsigned frame[2];  // the numbers of the frames at the start and at the end; equal: there is no motion
  const gjk_arm_part_room *part;
  const gjk_collider *other;  // S
  gjk_vec3 axis;              // not 0: S is so far away that only directions along this axis are tried
  gjk_vec3 centre[2];         // of P from that of S
  // The rest is set only where it is needed.
  const gjk_vec3 *rows[2];  // the rotation of P's link
  gjk_vec3 turned[2][3];    // room for it if S is a part
  gjk_vec3 origin[2];       // of P's link, from the centre of S
} gjk_arm_view;

// Looks at a pair in the arm's frames with these numbers. obstacle: its own, or a piece of its body; NULL: it has none.
void gjk_arm_look(const gjk_arm *arm, const gjk_arm_pair *pair, const gjk_collider *obstacle, unsigned start,
                  unsigned end, gjk_arm_view *out);

// The gap of the pair along a unit direction from S to P, at the end where it is smaller, Q30 of an LSB. It exceeds the
// gap in real numbers by at most the slack. False: the view does not allow this direction.
bool gjk_arm_gap(gjk_arm_view *view, const gjk_unit3 *direction, int64_t *gap);

typedef enum gjk_arm_found {
  GJK_ARM_APART,  // along *direction the gap is above the one wanted
  GJK_ARM_OPEN,   // no such direction was found
  GJK_ARM_CLOSE,  // the same, and the pair is within near at both ends and between
  GJK_ARM_MORE    // of a body: some pieces are not tested yet
} gjk_arm_found;

// *way = a - b. False: a component is not surely below 2^29 in size.
static inline bool gjk_arm_near_way(const gjk_vec3 *a, const gjk_vec3 *b, gjk_vec3 *way) {
  const int32_t x = gjk_sar32(a->x, 2) - gjk_sar32(b->x, 2), y = gjk_sar32(a->y, 2) - gjk_sar32(b->y, 2);
  const int32_t z = gjk_sar32(a->z, 2) - gjk_sar32(b->z, 2);
  const uint32_t bits =
      (uint32_t)(x ^ gjk_sar32(x, 31)) | (uint32_t)(y ^ gjk_sar32(y, 31)) | (uint32_t)(z ^ gjk_sar32(z, 31));
  if (bits >> 26 != 0) {
    return false;
  }
  *way = gjk_sub(*a, *b);  // below 2^28 + 4
  return true;
}

// Are two centres surely more than reach >= 0 apart? A "no" may be wrong.
static inline bool gjk_arm_balls_apart(const gjk_vec3 *a, const gjk_vec3 *b, int64_t reach) {
  gjk_vec3 way;
  return reach <= INT32_MAX && gjk_arm_near_way(a, b, &way) &&
         gjk_dot(&way, &way) > gjk_mul32((int32_t)reach, (int32_t)reach);  // below 2^58 and 2^62
}

// Do the bounding spheres of a part and an obstacle stay more than gap apart on the span? gap: LSB, from 0 to 2^30. Then
// gjk_arm_separate would find a direction along which the gap is above that. A "no" may be wrong.
bool gjk_arm_spheres_apart(const gjk_arm *arm, const gjk_arm_pair *pair, const gjk_collider *other, int64_t gap);

// Is a pair surely more than this much apart at the frames with number which? obstacle: as above. A "no" may be wrong,
// so the pair must then be measured. This test costs less than posing.
bool gjk_arm_surely_apart(const gjk_arm *arm, const gjk_arm_pair *pair, const gjk_collider *obstacle, unsigned which,
                          int64_t most);

// No slack of a pair is larger, see gjk_arm_bound.c: N is at most 64, D at most 2^29.
#define GJK_ARM_SLACK_MAX 600

// A box of the world around a part at both ends of a span, whose sides err no more than the gap of gjk_arm_gap.
void gjk_arm_box(const gjk_arm *arm, unsigned number, unsigned start, unsigned end, gjk_aabb *out);

// What is searched. Lengths in LSB, from 0 to 2^30.
typedef struct gjk_arm_search {
  int64_t wanted;  // a gap above this
  int64_t near;    // see GJK_ARM_CLOSE
} gjk_arm_search;

// Searches a direction along which the gap is above the one wanted.
//
// kept       where to start, or 0; set if a search beyond spheres finds a direction.
// direction  if APART: what was found.
// gap        if APART: the gap along it, Q30.
gjk_arm_found gjk_arm_separate(gjk_arm_view *view, const gjk_arm_search *search, gjk_unit3 *kept, gjk_unit3 *direction,
                               int64_t *gap);

#endif
