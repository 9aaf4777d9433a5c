// The facet of A - B that is nearest to the origin inside: which of the candidates it is, and how far away exactly.
#ifndef GJK_SRC_FACET_H
#define GJK_SRC_FACET_H

#include "../arith/gjk_height_key.h"
#include "../gjk/gjk_iteration.h"
#include "gjk/certificate.h"

// Heights by unit vectors are below 2^30 and within so many units of the exact ones: the unit vector is within
// 7/2 2^-30 of the normal, and a vertex is at most 2^30 away; the fraction is cut off.
#define GJK_HEIGHT_ERROR 5
#define GJK_HEIGHT_MAX ((UINT32_C(1) << 30) - 1)

// The best candidate so far.
typedef struct gjk_facet {
  gjk_vertex corner[3];  // span the plane, outwards by (w1 - w0) x (w2 - w0); A's offset only for curved shapes
  gjk_search_direction direction;  // outward normal
  gjk_unit3 normal;                // the same
  gjk_q16 depth;                   // exact height in LSB, rounded up, or an upper bound of it
  bool found;
  bool covers;  // the origin's projection lies in the corners' triangle, or as near as matters
  bool set;     // the simplex is still as it was when this was taken
} gjk_facet;

// The height of a plane with an outward normal, rounded to *d, through w. Pre: not below the origin; |w| <= 2^30.
uint32_t gjk_height(const gjk_vec3 *d, const gjk_vec3 *w);

// The exact height over the origin, in LSB and rounded up, of the plane across it->direction through w.
gjk_q16 gjk_depth_across(const gjk_iteration *it, const gjk_vec3 *w);

// ceil(height / 2^shift): from the frame to LSB.
static inline gjk_q16 gjk_height_to_lsb(uint32_t height, int shift) {
  return (gjk_q16)((height + (UINT32_C(1) << shift) - 1) >> shift);
}

// Is a plane of this height key able to be nearer than the best, by a whole LSB, or to hold the nearest point that the
// best one misses?
bool gjk_facet_may_improve(const gjk_facet *best, int shift, uint32_t key);

// Takes the plane of the simplex's first three slots for the best if it is better. They are the feature, by
// gjk_simplex_set; covers: the projection lies in their triangle. it->direction: the outward normal.
// bound: the depth, when it isn't the exact height of the slots that counts but that of a parallel plane; otherwise -1.
void gjk_facet_consider(gjk_facet *best, gjk_iteration *it, bool covers, gjk_q16 bound);

// Makes the corners the feature, or what of them is nearest to the origin.
void gjk_facet_load(const gjk_facet *facet, gjk_iteration *it);

#endif
