// Keeps some of many contact candidates, the same ones from tick to tick.
//
//   1. Sort the candidates by id, and look at them along the axis that is nearest to the normal.
//   2. Keep the first that is about as deep as the deepest: within 4 LSB and 1/512 of how far the candidates reach.
//   3. To keep three or more: add those that span the largest triangle or quadrilateral with it, seen along that axis.
//   4. Until `most` are kept: add the one farthest from all that are kept.
//   5. If none that is kept is within 4 LSB of the deepest: repeat steps 2 to 4 without the 1/512.
//
// Where shapes rest on each other, many choices are equally good up to rounding, and the best flips with every LSB of
// motion. So each step takes, of all candidates as good as the best up to a margin wider than rounding, the first by
// id. Step 3 therefore keeps at least 9/10 of the largest area. Nothing is rounded but the margins, down.
#include "gjk_reduce.h"

// A candidate within this many LSB of the deepest counts as deepest. A body at rest leans by less than 1 / 2^LEAN, so
// step 2 widens the margin by that share of the reach.
#define DEEP 4
#define LEAN 9

// An area or squared distance that falls short of the largest by at most 1 / 2^ALIKE of it counts as largest.
#define ALIKE 5

// Where a candidate lies seen along the axis nearest to the normal, relative to the first that is kept.
//   x, y   below 2^30 in size
typedef struct spot {
  int32_t x, y;
} spot;

typedef struct selection {
  spot spots[GJK_CANDIDATES_MAX];     // in the order below
  uint8_t order[GJK_CANDIDATES_MAX];  // indices of the candidates, by id
  unsigned count;                     // of candidates
  uint8_t *keep;                      // indices in order
  unsigned kept;
} selection;

GJK_ONE_COPY static bool is_as_large(int64_t value, int64_t largest) {
  return value >= largest - gjk_sar64(largest, ALIKE);
}

// Step 1: insertion sort by id.
static void sort(const gjk_candidates *t, selection *s) {
  s->count = t->count;
  s->order[0] = 0;
  for (unsigned i = 1; i < t->count; i++) {
    unsigned at = i;
    while (at > 0 && t->candidate[s->order[at - 1]].id > t->candidate[i].id) {
      s->order[at] = s->order[at - 1];
      at--;
    }
    s->order[at] = (uint8_t)i;
  }
}

// Step 1: finds the spots, relative to the first candidate. Returns the largest |coordinate|.
static uint32_t find_spots(const gjk_candidates *t, const gjk_unit3 *normal, selection *s) {
  const uint32_t x = gjk_magnitude32(normal->x), y = gjk_magnitude32(normal->y), z = gjk_magnitude32(normal->z);
  const unsigned axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
  const gjk_vec3 *origin = &t->candidate[s->order[0]].point_a;
  uint32_t reach = 0;
  for (unsigned i = 0; i < s->count; i++) {
    const gjk_vec3 v = gjk_sub(t->candidate[s->order[i]].point_a, *origin);
    const spot p = {axis == 0 ? v.y : v.x, axis == 2 ? v.y : v.z};
    s->spots[i] = p;
    reach = gjk_magnitude32(p.x) > reach ? gjk_magnitude32(p.x) : reach;
    reach = gjk_magnitude32(p.y) > reach ? gjk_magnitude32(p.y) : reach;
  }
  return reach;
}

static gjk_q16 least_distance(const gjk_candidates *t) {
  gjk_q16 least = t->candidate[0].distance;
  for (unsigned i = 1; i < t->count; i++) {
    least = t->candidate[i].distance < least ? t->candidate[i].distance : least;
  }
  return least;
}

// Step 2: the first candidate whose distance is at most limit. Pre: there is one.
GJK_ONE_COPY static unsigned first_within(const gjk_candidates *t, const selection *s, int64_t limit) {
  unsigned i = 0;
  while (i + 1 < s->count && t->candidate[s->order[i]].distance > limit) {
    i++;
  }
  return i;
}

// Keeps candidate i, and makes the spots relative to it.
static void keep_first(selection *s, unsigned i) {
  const spot from = s->spots[i];
  for (unsigned k = 0; k < s->count; k++) {
    s->spots[k].x -= from.x;
    s->spots[k].y -= from.y;
  }
  s->keep[0] = (uint8_t)i;
  s->kept = 1;
}

// Twice the area of the triangle of the first one kept, end and i; negative when i lies on the right.
//   products below 2^60 in size, their difference below 2^61
GJK_ONE_COPY static int64_t area_of(const selection *s, const spot *end, unsigned i) {
  return gjk_mul32(end->x, s->spots[i].y) - gjk_mul32(end->y, s->spots[i].x);
}

// Keeps the first candidate that is as far from the line to end as the farthest on that side.
GJK_ONE_COPY static void keep_aside(selection *s, const spot *end, bool to_left, int64_t farthest) {
  // Seen from end backwards, right is left.
  const spot along = {to_left ? end->x : -end->x, to_left ? end->y : -end->y};
  unsigned i = 0;
  while (i + 1 < s->count && !is_as_large(area_of(s, &along, i), farthest)) {
    i++;
  }
  s->keep[s->kept++] = (uint8_t)i;
}

// A quadrilateral with a corner at the first one kept has a diagonal from there. The largest one on a given diagonal
// has, on either side, the candidate that is farthest from the diagonal.
typedef struct diagonal {
  spot end;
  int64_t left, right;  // twice the areas of the largest triangles
} diagonal;

static int64_t measure_diagonal(const selection *s, unsigned k, bool quadrilateral, diagonal *out) {
  out->end = s->spots[k];
  out->left = 0;
  out->right = 0;
  for (unsigned i = 0; i < s->count; i++) {
    const int64_t area = area_of(s, &out->end, i);
    out->left = area > out->left ? area : out->left;
    out->right = -area > out->right ? -area : out->right;
  }
  return quadrilateral ? out->left + out->right : out->left > out->right ? out->left : out->right;
}

// Step 3.
static void keep_largest(selection *s, bool quadrilateral) {
  int64_t area[GJK_CANDIDATES_MAX], most = 0;
  unsigned k = 0;
  diagonal d;
  for (unsigned i = 0; i < s->count; i++) {
    area[i] = measure_diagonal(s, i, quadrilateral, &d);
    most = area[i] > most ? area[i] : most;
  }
  if (most == 0) {
    return;
  }
  while (k + 1 < s->count && !is_as_large(area[k], most)) {
    k++;
  }
  measure_diagonal(s, k, quadrilateral, &d);
  const bool to_left = is_as_large(d.left, d.right);
  s->keep[s->kept++] = (uint8_t)k;
  if (d.left > 0 && (quadrilateral || to_left)) {
    keep_aside(s, &d.end, true, d.left);
  }
  if (d.right > 0 && (quadrilateral || !to_left)) {
    keep_aside(s, &d.end, false, d.right);
  }
}

// The squared distance of candidate i from the nearest one kept; -1 if it is kept.
//   |x|, |y| < 2^30:  the sum of squares is below 2^61
static int64_t clearance(const selection *s, unsigned i) {
  int64_t nearest = INT64_MAX;
  for (unsigned k = 0; k < s->kept; k++) {
    const int32_t x = s->spots[i].x - s->spots[s->keep[k]].x, y = s->spots[i].y - s->spots[s->keep[k]].y;
    const int64_t squared = s->keep[k] == i ? -1 : gjk_mul32(x, x) + gjk_mul32(y, y);
    nearest = squared < nearest ? squared : nearest;
  }
  return nearest;
}

// Step 4.
static void keep_farthest(selection *s) {
  int64_t most = 0;
  unsigned i = 0;
  for (unsigned k = 0; k < s->count; k++) {
    const int64_t far = clearance(s, k);
    most = far > most ? far : most;
  }
  while (i + 1 < s->count && !is_as_large(clearance(s, i), most)) {
    i++;
  }
  s->keep[s->kept++] = (uint8_t)i;
}

// Steps 2 to 4.
static void keep_most(selection *s, unsigned first, unsigned most) {
  keep_first(s, first);
  if (GJK_SHAPES <= GJK_SHAPES_ROUND) {
    return;  // two edges have two candidates: most is 1
  }
  if (most > 2) {
    keep_largest(s, most > 3);
  }
  while (s->kept < most) {  // ends: there are more candidates than most
    keep_farthest(s);
  }
}

static bool keeps_within(const gjk_candidates *t, const selection *s, int64_t limit) {
  for (unsigned k = 0; k < s->kept; k++) {
    if (t->candidate[s->order[s->keep[k]]].distance <= limit) {
      return true;
    }
  }
  return false;
}

void gjk_reduce(const gjk_candidates *candidates, const gjk_unit3 *normal, unsigned most, uint8_t *keep) {
  selection s;
  s.keep = keep;
  sort(candidates, &s);
  const uint32_t reach = find_spots(candidates, normal, &s);
  const int64_t limit = (int64_t)least_distance(candidates) + DEEP;
  keep_most(&s, first_within(candidates, &s, limit + (reach >> LEAN)), most);
  // Step 5.
  if (!keeps_within(candidates, &s, limit)) {
    keep_most(&s, first_within(candidates, &s, limit), most);
  }
  for (unsigned i = 0; i < most; i++) {
    keep[i] = s.order[keep[i]];
  }
}
