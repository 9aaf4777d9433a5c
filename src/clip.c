// Clipping.
//
// After   Sutherland, Hodgman, Reentrant Polygon Clipping, 1974.
#include "clip.h"

// From a to b by share.
static int32_t between(int32_t a, int32_t b, gjk_share share) {
  const int64_t half = INT64_C(1) << 30;
  return a + (int32_t)gjk_sar64(gjk_mul32(b - a, share.high) + half, 31);
}

// Where the edge from a to b crosses the plane; along: how far they lie before it, of opposite signs.
static gjk_vec3 crossing(const gjk_vec3 *a, int64_t along_a, const gjk_vec3 *b, int64_t along_b) {
  const gjk_u128 part = {0, gjk_magnitude64(along_a)}, rest = {0, gjk_magnitude64(along_b)}, none = {0, 0};
  gjk_share share[2];
  gjk_shares(&rest, &part, &none, false, share);
  const gjk_vec3 v = {between(a->x, b->x, share[0]), between(a->y, b->y, share[0]), between(a->z, b->z, share[0])};
  return v;
}

// In place: of a convex polygon no more corners have been written at any time than read and two, and the one to be read
// next is kept. Products: at most sqrt(3) 3 2^29 times sqrt(3) 2^30, below 2^63.
void gjk_clip_behind(gjk_clip *clip, const gjk_vec3 *point, const gjk_vec3 *d, unsigned plane) {
  const unsigned n = clip->count, edges = n > 2 ? n : n - 1;
  const gjk_clip_corner first = clip->corner[0];
  gjk_clip_corner c = first;
  unsigned kept = 0;
  for (unsigned i = 0; i < n; i++) {
    const gjk_clip_corner next = i + 1 < n ? clip->corner[i + 1] : first;
    const gjk_vec3 to_c = gjk_sub(c.v, *point), to_next = gjk_sub(next.v, *point);
    const int64_t along = gjk_dot(&to_c, d), along_next = gjk_dot(&to_next, d);
    if (along <= 0 && kept <= i + 1 && kept < GJK_CLIP_MAX) {
      clip->corner[kept++] = c;
    }
    if (i < edges && (along <= 0) != (along_next <= 0) && along != 0 && along_next != 0 && kept <= i + 1 &&
        kept < GJK_CLIP_MAX) {
      gjk_clip_corner *cut = &clip->corner[kept++];
      cut->v = crossing(&c.v, along, &next.v, along_next);
      cut->id = (uint16_t)((plane + 1) << 8 | c.label);
      cut->label = along <= 0 ? (uint8_t)(0x80u | plane) : c.label;
    }
    c = next;
  }
  clip->count = kept;
}
