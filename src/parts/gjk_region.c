// Where a query looks for parts.
#include "gjk_region.h"

// The ends of a box in the world. A box cut off at an end of int32 may go on beyond it, by less than twice GJK_RADIUS_MAX.
static int64_t lower_end(gjk_q16 x) {
  return x == INT32_MIN ? (int64_t)x - (INT64_C(1) << 29) : x;
}

static int64_t upper_end(gjk_q16 x) {
  return x == INT32_MAX ? (int64_t)x + (INT64_C(1) << 29) : x;
}

// One axis of the body's frame: its column of the rotation times the box.
//   a corner   less than 2^32 + 2^29 from the position, per axis; the column at most 2^30 + 1 long:
//              sums, partial ones too, below sqrt(3) 9/8 2^62 < 2^63
static void turn_axis(const int32_t column[3], const int64_t lower[3], const int64_t upper[3], int64_t *low,
                      int64_t *high) {
  int64_t least = 0, most = 0;
  for (int i = 0; i < 3; i++) {
    const bool up = column[i] >= 0;
    least += column[i] * (up ? lower[i] : upper[i]);
    most += column[i] * (up ? upper[i] : lower[i]);
  }
  *low = gjk_sar64(least, 30);
  *high = gjk_sar64(most, 30) + 1;
}

static int32_t clamp_to_int32(int64_t x) {
  return gjk_saturate(x);
}

// A part of the way, within 2, and no longer than that of a larger fraction. Pre: |way| < 2^34.
static int64_t part_until(int64_t way, gjk_q30 fraction) {
  const int64_t size = (int64_t)gjk_magnitude64(way), coarse = size >> 15, fine = size & 32767;
  const int64_t part = (coarse * fraction >> 15) + (fine * fraction >> 30);
  return way < 0 ? -part : part;
}

// Sets the box, also as its corners.
static void settle_box(gjk_region *r, int32_t low[3], int32_t high[3]) {
  for (int i = 0; i < 3; i++) {
    const int64_t along = r->moves ? part_until(r->way[i], r->latest) : 0;
    low[i] = clamp_to_int32(r->lower[i] - r->grow + (along < 0 ? along : 0));
    high[i] = clamp_to_int32(r->upper[i] + r->grow + (along > 0 ? along : 0));
  }
  r->box.lower.x = low[0];
  r->box.lower.y = low[1];
  r->box.lower.z = low[2];
  r->box.upper.x = high[0];
  r->box.upper.y = high[1];
  r->box.upper.z = high[2];
}

// Sets the box and on a way, which has not been cut, the coarse frame. All that this holds is measured from the box's lower
// corner: the start, the end, and the box's extent.
//   lower, upper < 2^34 in size, way < 2^34, grow < 2^40:   below 2^42
static void settle_region(gjk_region *r) {
  const int32_t *low = r->base;
  int32_t high[3];
  int64_t most = 0;
  settle_box(r, r->base, high);
  if (!r->moves) {
    return;
  }
  for (int i = 0; i < 3; i++) {
    const int64_t start = r->lower[i] - low[i], extent = r->upper[i] - r->lower[i] + 2 * r->grow;
    const int64_t sizes[4] = {start, start + r->way[i], extent, (int64_t)high[i] - low[i]};
    for (int j = 0; j < 4; j++) {
      const int64_t size = (int64_t)gjk_magnitude64(sizes[j]);
      most = size > most ? size : most;
    }
  }
  r->shift = 0;
  while (most >> r->shift >= INT64_C(1) << 27) {  // ends: below 2^43, so at most 16 times
    r->shift++;
  }
  for (int i = 0; i < 3; i++) {
    const int64_t middle =
        r->lower[i] + r->upper[i] - 2 * (int64_t)low[i] + r->way[i];  // doubled:  below 2^29 when shifted
    r->along[i] = (int32_t)gjk_sar64(r->way[i], r->shift);
    r->middle[i] = (int32_t)gjk_sar64(middle, r->shift);
    // A box's corners, the way's ends and the middle are each off by less than 2 coarse units, doubled less than 4.
    r->extent[i] = (int32_t)gjk_sar64(r->upper[i] - r->lower[i] + 2 * r->grow, r->shift) + 16;
  }
}

void gjk_region_start(gjk_region *r, const gjk_vec3 rows[3], const gjk_vec3 *position, const gjk_aabb *world,
                      const gjk_long3 *way) {
  const int64_t lower[3] = {lower_end(world->lower.x) - position->x, lower_end(world->lower.y) - position->y,
                            lower_end(world->lower.z) - position->z};
  const int64_t upper[3] = {upper_end(world->upper.x) - position->x, upper_end(world->upper.y) - position->y,
                            upper_end(world->upper.z) - position->z};
  const int32_t column[3][3] = {
      {rows[0].x, rows[1].x, rows[2].x}, {rows[0].y, rows[1].y, rows[2].y}, {rows[0].z, rows[1].z, rows[2].z}};
  r->moves = way != NULL && (way->x | way->y | way->z) != 0;
  r->grow = 0;
  r->latest = GJK_Q30_ONE;
  for (int i = 0; i < 3; i++) {
    turn_axis(column[i], lower, upper, &r->lower[i], &r->upper[i]);
    r->lower[i] -= GJK_REGION_SLACK;
    r->upper[i] += GJK_REGION_SLACK;
    r->way[i] = 0;
    if (r->moves) {
      const int64_t of_b[3] = {way->x, way->y, way->z};
      int64_t more;
      turn_axis(column[i], of_b, of_b, &r->way[i], &more);
    }
  }
  settle_region(r);
}

void gjk_region_grow(gjk_region *r, int64_t grow) {
  r->grow = grow;
  settle_region(r);
}

void gjk_region_cut(gjk_region *r, gjk_q30 latest) {
  int32_t low[3], high[3];
  r->latest = latest;
  settle_box(r, low, high);
}

// One axis of a box that is cut off at the region's own, in the coarse frame and doubled: its middle less the region's, and
// how far apart both middles may be. A box that holds another one, or is cut off farther out, may lie by no more apart than
// it reaches farther.
static void coarse_axis(const gjk_region *r, int i, int64_t low, int64_t high, gjk_q16 own_low, gjk_q16 own_high,
                        int32_t *apart, int32_t *reach) {
  const int64_t from = (low > own_low ? low : own_low) - r->base[i],
                to = (high < own_high ? high : own_high) - r->base[i];
  const int32_t a = (int32_t)gjk_sar64(from, r->shift), b = (int32_t)gjk_sar64(to, r->shift);  // 0 to 2^27
  *apart = a + b - r->middle[i];
  *reach = b - a + r->extent[i];
}

static int64_t size_of_product(int32_t a, int32_t b) {
  return (int64_t)gjk_magnitude64(gjk_mul32(a, b));
}

// Coarse values are below 2^30: products below 2^60.
bool gjk_region_meets_on_way(const gjk_region *r, const gjk_aabb *box) {
  const gjk_aabb *own = &r->box;
  int32_t apart[3], reach[3];
  coarse_axis(r, 0, box->lower.x, box->upper.x, own->lower.x, own->upper.x, &apart[0], &reach[0]);
  coarse_axis(r, 1, box->lower.y, box->upper.y, own->lower.y, own->upper.y, &apart[1], &reach[1]);
  coarse_axis(r, 2, box->lower.z, box->upper.z, own->lower.z, own->upper.z, &apart[2], &reach[2]);
  for (unsigned i = 0; i < 3; i++) {
    const unsigned j = gjk_next(i), k = gjk_next(j);
    const int64_t across = gjk_mul32(r->along[j], apart[k]) - gjk_mul32(r->along[k], apart[j]);
    const int64_t most = size_of_product(r->along[j], reach[k]) + size_of_product(r->along[k], reach[j]);
    if ((int64_t)gjk_magnitude64(across) > most) {
      return false;
    }
  }
  return true;
}
