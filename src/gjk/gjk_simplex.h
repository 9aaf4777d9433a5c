// The feature nearest to the origin - vertex, edge or triangle - and what a new vertex makes of it.
//
// All in the frame of the pair: vertices w of the Minkowski difference A - B are at most W = 3 2^29 long,
// differences of two at most E < 2^31, W E <= 2^61 (see pair.h). So, exactly:
//   w_i . w_j               at most W^2 < 2^62
//   w_i . (w_j - w_k)       at most W E <= 2^61
//   (w_j - w_i) x (w_k - w_i)   at most E^2 <= 2^62
#ifndef GJK_SRC_SIMPLEX_H
#define GJK_SRC_SIMPLEX_H

#include "../arith/gjk_vector.h"

// A vertex of A - B.
typedef struct gjk_vertex {
  gjk_vec3 w;
  gjk_support a;
  uint16_t b;  // vertex number; its offset follows from w
} gjk_vertex;

// Which feature is nearest, and a free slot. A feature of three is ordered so that its normal
// (v1 - v0) x (v2 - v0) points to the origin's side.
typedef struct gjk_simplex {
  gjk_vertex slot[4];
  // Of the slots in use: [i][i] = w_i . w_i; [i][j] = w_i . (w_i - w_j), positive when the origin's projection onto the
  // line through both lies on j's side of i.
  int64_t toward[4][4];
  gjk_long3 normal;  // of a feature of three
  uint8_t order[4];  // slots: first the feature's count, then the others
  uint8_t count;     // 0 to 3; 4, or less with the origin on it, when enclosing
} gjk_simplex;

typedef enum gjk_step {
  GJK_STEP_NONE,      // the new vertex is no nearer than the feature: not added
  GJK_STEP_NEARER,    // the feature is now one that contains the new vertex
  GJK_STEP_ENCLOSING  // the origin is on the first count vertices' point, segment, triangle or tetrahedron
} gjk_step;

static inline gjk_vertex *gjk_simplex_vertex(gjk_simplex *s, int i) {
  return &s->slot[s->order[i]];
}

// Where to put the next vertex.
static inline gjk_vertex *gjk_simplex_free(gjk_simplex *s) {
  return &s->slot[s->order[s->count]];
}

void gjk_simplex_clear(gjk_simplex *s);

// Takes the vertex in the free slot. Pre: count <= 3, and the last step was not ENCLOSING.
gjk_step gjk_simplex_add(gjk_simplex *s);

// Makes the first n slots the feature, 1 <= n <= 3. False when they are degenerate or the origin's projection does not
// lie strictly inside them.
bool gjk_simplex_set(gjk_simplex *s, unsigned n);

// Which edge of the triangle of the first three slots does the origin's projection onto their plane lie beyond? Edge i
// starts at slot i; 3: none, it lies in the triangle or on its border. Pre: gjk_simplex_set has taken them, whatever it
// said; they are not in a line.
unsigned gjk_simplex_beyond(const gjk_simplex *s);

// Does the hull of the first n slots contain the origin, 1 <= n <= 4? False also for degenerate ones.
bool gjk_simplex_encloses(gjk_simplex *s, unsigned n);

// The direction from the feature to the origin. False when it is zero: the origin lies on the feature. A feature of three
// with the origin on it is not one: see gjk_simplex_add. Pre: 1 <= count <= 3.
bool gjk_simplex_direction(const gjk_simplex *s, gjk_search_direction *out);

// The same, exact; valid while the simplex stays as it is.
void gjk_simplex_exact_direction(const gjk_simplex *s, gjk_direction *out);

// The feature's squared distance to the origin as numerator / denominator, exact. Pre: 1 <= count <= 3.
// numerator <= 2^186, denominator <= 2^124.
void gjk_simplex_squared_distance(const gjk_simplex *s, gjk_u192 *numerator, gjk_u192 *denominator);

// The sign of (2 distance)^2 - twice^2, where distance^2 = numerator / denominator.
int gjk_compare_distance(const gjk_u192 *numerator, const gjk_u192 *denominator, uint64_t twice);

typedef enum gjk_round_to {
  GJK_ROUND_UP,
  GJK_ROUND_NEAREST,  // a tie goes up
  GJK_ROUND_DOWN
} gjk_round_to;

// distance / 2^shift, rounded to an integer. Pre: low <= the result <= high; 2 (high + 1) 2^shift < 2^64; low >= 0.
int64_t gjk_round_distance(const gjk_u192 *numerator, const gjk_u192 *denominator, unsigned shift, int64_t low,
                           int64_t high, gjk_round_to to);

// Weights of the second and third vertex in the nearest point on the feature; the first has the rest. fine: see
// gjk_barycentrics. Pre: 2 <= count <= 3 and the feature is nearest.
void gjk_simplex_weights(const gjk_simplex *s, bool fine, gjk_barycentric weight[2]);

#endif
