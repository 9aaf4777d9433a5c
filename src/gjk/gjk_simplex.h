// The feature nearest to the origin - vertex, edge or triangle - and what a new vertex makes of it.
//
// All vertices w of A - B are in the frame of the pair (gjk_frame.h). So these are exact in int64_t:
//   |w_i| <= 3 2^29,  |w_j - w_k| < 2^31,  |w_i| |w_j - w_k| <= 2^61     lengths
//   |w_i . w_j|                          < 2^62
//   |w_i . (w_j - w_k)|                 <= 2^61
//   |(w_j - w_i) x (w_k - w_i)|         <= 2^62
#ifndef GJK_SRC_SIMPLEX_H
#define GJK_SRC_SIMPLEX_H

#include "../arith/gjk_vector.h"

// A vertex of A - B.
typedef struct gjk_vertex {
  gjk_vec3 w;
  gjk_support a;
  uint16_t b;  // the number of B's vertex; its offset follows from w and a
} gjk_vertex;

// The nearest feature and a free slot. A triangle v0, v1, v2 is ordered so that its normal (v1 - v0) x (v2 - v0) points
// to the side of the origin.
typedef struct gjk_simplex {
  gjk_vertex slot[4];
  // For slots i, j of the feature:
  //   [i][i] = w_i . w_i
  //   [i][j] = w_i . (w_i - w_j), positive when the origin's projection onto their line lies on j's side of i
  int64_t toward[4][4];
  gjk_long3 normal;  // of a triangle
  uint8_t order[4];  // slots: first those of the feature, then the others
  uint8_t count;     // of vertices: 0 to 3. After ENCLOSING up to 4: the origin lies in what they span
} gjk_simplex;

typedef enum gjk_step {
  GJK_STEP_NONE,      // the new vertex is no nearer than the feature: not added
  GJK_STEP_NEARER,    // the feature is one with the new vertex, strictly nearer than before
  GJK_STEP_ENCLOSING  // the origin lies in the point, segment, triangle or tetrahedron of the first count vertices
} gjk_step;

static inline gjk_vertex *gjk_simplex_vertex(gjk_simplex *s, int i) {
  return &s->slot[s->order[i]];
}

// Where to put the next vertex.
static inline gjk_vertex *gjk_simplex_free(gjk_simplex *s) {
  return &s->slot[s->order[s->count]];
}

void gjk_simplex_clear(gjk_simplex *s);

// Adds the vertex in the free slot. Pre: count <= 3, and the last step was not ENCLOSING.
gjk_step gjk_simplex_add(gjk_simplex *s);

// Makes the first n slots the feature, 1 <= n <= 3. False: they are degenerate, or the origin's projection does not lie
// strictly inside what they span.
bool gjk_simplex_set(gjk_simplex *s, unsigned n);

// Makes the edge and the free slot a triangle, though its nearest point stays on the edge. False: the three are in a line,
// and the feature is still the edge. Pre: count == 2.
bool gjk_simplex_widen(gjk_simplex *s);

// Beyond which edge of the triangle of the first three slots does the origin's projection onto its plane lie? Edge i
// starts at slot i. 3: beyond none, it lies in the triangle or on its border.
// Pre: gjk_simplex_set(s, 3) has been called, with any result; the slots are not in a line.
unsigned gjk_simplex_beyond(const gjk_simplex *s);

// Does the convex hull of the first n slots contain the origin, 1 <= n <= 4? False also if the slots are degenerate.
bool gjk_simplex_encloses(gjk_simplex *s, unsigned n);

// The direction from the feature to the origin, rounded. False: it is zero, because the origin lies on the vertex or
// edge. (The origin on a triangle is ENCLOSING in gjk_simplex_add.) Pre: 1 <= count <= 3.
bool gjk_simplex_direction(const gjk_simplex *s, gjk_search_direction *out);

// The same direction, exact. It is valid while the simplex stays as it is.
void gjk_simplex_exact_direction(const gjk_simplex *s, gjk_direction *out);

// The feature's squared distance to the origin as numerator / denominator, exact. Pre: 1 <= count <= 3.
// numerator <= 2^186, denominator <= 2^124.
void gjk_simplex_squared_distance(const gjk_simplex *s, gjk_u192 *numerator, gjk_u192 *denominator);

// The feature's distance to the origin, exact, where the direction of a triangle or vertex is an axis of the frame. -1:
// another feature, or another direction.
int32_t gjk_simplex_along_axis(const gjk_simplex *s);

// The sign of (2 distance)^2 - twice^2, where distance^2 = numerator / denominator.
int gjk_compare_distance(const gjk_u192 *numerator, const gjk_u192 *denominator, uint64_t twice);

typedef enum gjk_round_to {
  GJK_ROUND_UP,
  GJK_ROUND_NEAREST,  // a tie goes up
  GJK_ROUND_DOWN
} gjk_round_to;

// distance / 2^shift, rounded to an integer. Pre: low <= the result <= high; 2 (high + 1) 2^shift < 2^64; low >= 0.
int64_t gjk_round_distance(const gjk_u192 *numerator, const gjk_u192 *denominator, int64_t low, int64_t high,
                           unsigned shift, gjk_round_to to);

// The barycentric coordinates of the feature's nearest point, up to a common factor: exact, not negative, with a sum
// below 2^126, in the order of its vertices. For an edge the third is 0. Pre: 2 <= count <= 3 and the feature is
// nearest.
void gjk_simplex_parts(const gjk_simplex *s, gjk_u128 part[3]);

// Barycentric coordinates of the feature's nearest point: those of the second and the third vertex; the first has the
// rest of 1. fine: see gjk_barycentrics. Pre: 2 <= count <= 3 and the feature is nearest.
void gjk_simplex_weights(const gjk_simplex *s, bool fine, gjk_barycentric weight[2]);

#endif
