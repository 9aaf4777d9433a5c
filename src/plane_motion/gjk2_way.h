// The way of a cast in the plane: how B moves against A, and on which side of that way the vertices of A - B lie.
//
// The colliders stand at the start. At fraction s of the way a vertex w of A - B is at w - s t, so the shapes share a
// point there if s t lies in A - B as it is at the start. Vertices stand as w = delta + o:
//   delta   centre_a - centre_b, components below 2^32
//   o       a vertex of A from its centre less one of B from its own, below 2^29
// The side of w is t x w: positive to the left of the way, 0 on its line.
#ifndef GJK2_SRC_WAY_H
#define GJK2_SRC_WAY_H

#include "../plane/gjk2_class.h"
#include "gjk2/cast.h"

typedef struct gjk2_long {
  int64_t x, y;
} gjk2_long;

typedef struct gjk2_way {
  const gjk2_collider *a, *b;
  gjk2_long of_a, of_b;  // how far A and B move; below 2^32
  gjk2_long t;           // of_b - of_a, below 2^32
  gjk2_long delta;
  gjk2_vec d;      // t, or where a component is 2^30 or more t / 8: a direction for support scans
  int64_t base;    // t x delta, or where that is larger 2^62 with its sign: no o changes the sign then
  bool wide;       // a component of t or delta is 2^30 or more
  uint32_t scans;  // support scans of both shapes so far
} gjk2_way;

// A vertex of A - B.
typedef struct gjk2_span {
  gjk2_support a, b;
  gjk2_vec o;
} gjk2_span;

// The one vertex of A - B of two points.
static const gjk2_span gjk2_origin_span = {{{0, 0}, 0}, {{0, 0}, 0}, {0, 0}};

static inline void gjk2_copy_span(gjk2_span *to, const gjk2_span *from) {
  gjk2_copy_support(&to->a, &from->a);
  gjk2_copy_support(&to->b, &from->b);
  gjk2_copy(&to->o, &from->o);
}

// Sets the way. Statuses: NULL, UNINITIALISED, NEGATIVE, RANGE as of gjk2_cast.
gjk_status gjk2_way_set(gjk2_way *way, const gjk2_collider *a, const gjk2_collider *b, const gjk2_cast_path *path,
                        const void *out);

// Turns the way round: from the same start on the same line, the other way.
void gjk2_way_reverse(gjk2_way *way);

// May shapes within radius of each other's cores meet on the way? False: their bounding circles do not.
// early, late: may they at the start, at the end? Pre: 0 <= radius < 2^32.
bool gjk2_way_may_meet(const gjk2_way *way, int64_t radius, bool *early, bool *late);

// Support scan along a direction, at most 3 2^29 long.
void gjk2_way_scan(gjk2_way *way, gjk2_vec d, gjk2_span *out);

// The vertex farthest to the left of the way, or to the right of it: exact of polygons.
void gjk2_way_outermost(gjk2_way *way, bool left, gjk2_span *out);

// The vertex of a polygon that is farthest to the left of a way t, or to the right, found by looking at each.
void gjk2_way_outermost_of(const gjk2_collider *c, const gjk2_long *t, bool left, gjk2_support *out);

// t x w, exact or, where the way is wide and w far from its line, of the right sign. |result| < 2^63.
int64_t gjk2_way_side(const gjk2_way *way, gjk2_vec o);

// Is w farther from the line of the way than radius? Exact. Pre: 0 <= radius < 2^32.
bool gjk2_way_is_beside(const gjk2_way *way, gjk2_vec o, int64_t radius);

// n . w, and n . t. Pre: |n| <= 2^30, or n is d and the way is short.
int64_t gjk2_way_along(const gjk2_way *way, gjk2_vec n, gjk2_vec o);
int64_t gjk2_way_ahead(const gjk2_way *way, gjk2_vec n);

// The sign of t . (w - s t), for s = 0 (start) or 1: does w lie ahead of that place?
int gjk2_way_is_ahead(const gjk2_way *way, gjk2_vec o, bool at_end);

// floor(2^30 num / den). *exact: nothing is cut off. Pre: 0 <= num <= den < 2^63, 0 < den.
gjk_q30 gjk2_ratio(uint64_t num, uint64_t den, bool *exact);

// The same with gjk2_ratio_set of den, for several numbers.
void gjk2_ratio_set(gjk_divisor *divisor, uint64_t den);
gjk_q30 gjk2_ratio_by(const gjk_divisor *divisor, uint64_t num, uint64_t den, bool *exact);

// A fraction of a way as num / den, and as gjk2_ratio has it.
typedef struct gjk2_portion {
  uint64_t num, den;
  gjk_q30 fraction;
  bool exact;
} gjk2_portion;

// The length of a way along an axis times the portion, rounded down, exactly. Pre: |length| < 2^33.
int64_t gjk2_portion_floor_of(const gjk2_portion *portion, int64_t length);

static inline int64_t gjk2_portion_floor(const gjk2_portion *portion, int64_t length) {
  return GJK_64_BIT && !GJK_SMALL && portion->exact ? gjk_sar64(length * portion->fraction, 30)
                                                    : gjk2_portion_floor_of(portion, length);
}

// The same to the nearest integer, a tie up. Pre: |length| < 2^32.
static inline int64_t gjk2_portion_nearest(const gjk2_portion *portion, int64_t length) {
  return gjk_sar64(gjk2_portion_floor(portion, 2 * length) + 1, 1);
}

#endif
