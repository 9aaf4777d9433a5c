// The facet of A - B nearest to the origin inside it: the best of the candidates so far, and its exact depth.
//
//   height       the distance of a plane from the origin, in the frame
//   height key   orders planes by height, rounded (arith/gjk_height_key.h)
//   depth        height in LSB, exact and rounded up
#ifndef GJK_SRC_FACET_H
#define GJK_SRC_FACET_H

#include "../arith/gjk_height_key.h"
#include "../gjk/gjk_iteration.h"
#include "gjk/certificate.h"

// The largest error of a height that is computed with a unit vector, in units of the frame:
//   the unit vector is within 7/2 2^-30 of the normal, |w| <= 2^30    7/2
//   the fraction is dropped                                           1
#define GJK_HEIGHT_ERROR 5
#define GJK_HEIGHT_MAX ((UINT32_C(1) << 30) - 1)

// The best candidate so far. Valid where found is set.
typedef struct gjk_facet {
  gjk_vertex corner[3];  // span its plane; (w1 - w0) x (w2 - w0) is outwards. a.offset is set for curved shapes alone
  gjk_search_direction direction;  // outward normal
  gjk_unit3 normal;                // the same
  gjk_q16 depth;                   // or an upper bound of it
  bool found;
  bool covers;  // the origin's projection lies in the triangle of the corners, or counts as if it did
  bool set;     // the simplex still holds the corners
} gjk_facet;

// The height of the plane through w with the outward normal d, within GJK_HEIGHT_ERROR. 0 where the origin is beyond.
// Pre: |w| <= 2^30.
uint32_t gjk_height(const gjk_vec3 *d, const gjk_vec3 *w);

// The depth of the plane through w across it->direction. 0 where the origin is beyond it.
gjk_q16 gjk_depth_across(const gjk_iteration *it, const gjk_vec3 *w);

// ceil(height / 2^shift): a height in LSB.
static inline gjk_q16 gjk_height_to_lsb(uint32_t height, int shift) {
  return (gjk_q16)((height + (UINT32_C(1) << shift) - 1) >> shift);
}

// May a plane of this height key be better than the best candidate? It is, if it is nearer by an LSB, or as near and
// its facet holds the nearest point, which the best candidate's does not.
bool gjk_facet_may_improve(const gjk_facet *best, int shift, uint32_t key);

// May a plane of this height key be as low as the best candidate's, or lower by any amount? Pre: polytopes.
bool gjk_facet_may_tie(const gjk_facet *best, uint32_t key);

// The sign of the height of the plane through the simplex's first three slots less that of the best candidate's. Exact.
// Overwrites the feature. Pre: polytopes; a candidate is found; it->direction is the plane's normal.
int gjk_facet_compare(gjk_facet *best, gjk_iteration *it);

// Offers the plane of the simplex's first three slots as a candidate. Pre: gjk_simplex_set has made them the feature;
// it->direction is the outward normal.
// covers: the origin's projection lies in their triangle.
// bound: the depth of a parallel plane that counts instead of the slots' own; -1: their own counts.
void gjk_facet_consider(gjk_facet *best, gjk_iteration *it, bool covers, gjk_q16 bound);

// Makes the corners the feature. If they do not cover the origin's projection, the nearest of their features becomes
// the feature.
void gjk_facet_load(const gjk_facet *facet, gjk_iteration *it);

#endif
