// Where a query looks for parts: a box in the frame of a body, which may move along a straight way.
//
// 1. Turn the world's box of B into the body's frame. Add a slack for what is rounded there and in the parts' poses.
// 2. Grow it by the distance asked about. The caller may lower the distance while it walks.
// 3. On a way, the region is what the box covers up to a fraction. The caller may lower the fraction while it walks.
//
// A box is outside if an axis of the frame separates it from the region. On a way, axes across the way and one of the
// frame's count too: the separating axes of a segment and a box. What is outside stays outside as the region is cut, and so does
// all that its box holds. So every walk meets the boxes of its final region, whatever its order, and perhaps others.
#ifndef GJK_SRC_REGION_H
#define GJK_SRC_REGION_H

#include "../arith/gjk_vector.h"
#include "gjk/collider.h"

// In LSB, per axis: by how much a part posed in the world may be off, seen from the body, from the part in the body's
// own frame. The rounding of the region itself is included.
//
//   posing, in the world and in the frame      3 each: POSE_SLACK of gjk_collider.c
//   composed position                          4                          gjk_pose_apply
//   composed rotation, of a centre 2^31 away   2^-29 sqrt(3) 2^31: 7
//   the same of vertices 2^28 away             1
//   curved shapes                              2 of the box, 2 of the surface
//   the region's corners and way               3/2 2^-30 of 2^32 + 2^29 each, and 1: 8 each
//   together                                   38
#define GJK_REGION_SLACK 64

typedef struct gjk_region {
  gjk_aabb box;                // holds the region, cut off at the ends of int32
  int64_t lower[3], upper[3];  // of the box at the start, slack included
  int64_t way[3];              // whole, in the body's frame
  int64_t grow;
  gjk_q30 latest;
  bool moves;
  // Of the whole way, coarse: shifted right by `shift`, relative to base.
  unsigned shift;
  int32_t base[3];    // the lower corner of box before it is cut
  int32_t along[3];   // the way
  int32_t middle[3];  // of the box at half of that way, doubled
  int32_t extent[3];  // of the box, doubled, and errors of the coarse frame
} gjk_region;

// Steps 1 and 3. rows: the body's rotation. world: B's box at the start. way: of B against the body, components below 2^32
// in size; NULL: none. Starts grown by 0, with the whole way.
void gjk_region_start(gjk_region *region, const gjk_vec3 rows[3], const gjk_vec3 *position, const gjk_aabb *world,
                      const gjk_long3 *way);

// Sets by how much the box is grown. Pre: 0 <= grow < 2^40; it has not been cut.
void gjk_region_grow(gjk_region *region, int64_t grow);

// Sets the fraction up to which the way counts.
void gjk_region_cut(gjk_region *region, gjk_q30 latest);

bool gjk_region_meets_on_way(const gjk_region *region, const gjk_aabb *box);

// Does the way lead back along the axis in which one of two boxes lies farthest from the other? Then that box is met first.
// rise: from the middle of the other box to that of this one. Pre: the region moves.
static inline bool gjk_region_comes_back(const gjk_region *region, const int32_t rise[3]) {
  uint32_t most = 0;
  bool back = false;
  for (int i = 0; i < 3; i++) {
    const uint32_t size = gjk_magnitude32(rise[i]);
    if (size > most) {
      most = size;
      back = (rise[i] < 0) != (region->way[i] < 0);
    }
  }
  return back;
}

// Does the region's box meet this one?
static inline bool gjk_region_touches(const gjk_region *region, const gjk_aabb *box) {
  const gjk_aabb *own = &region->box;
  return box->lower.x <= own->upper.x && own->lower.x <= box->upper.x && box->lower.y <= own->upper.y &&
         own->lower.y <= box->upper.y && box->lower.z <= own->upper.z && own->lower.z <= box->upper.z;
}

// May a part in this box of the body's frame be met? False: it is not.
static inline bool gjk_region_meets(const gjk_region *region, const gjk_aabb *box) {
  return gjk_region_touches(region, box) && (!region->moves || gjk_region_meets_on_way(region, box));
}

#endif
