// Which of many contact points to keep.
//
// Where shapes rest on each other, many choices are as good as each other but for rounding. So what is compared here is not
// which is best: of all that are as good as the best but for a margin that rounding does not cross, the first by id is taken.
#include "gjk_reduce.h"

// A point is as deep as the deepest if it is so to this many LSB. A body at rest leans by less than 1 / 2^LEAN; so as long as
// one that deep is kept, the choice begins with the first that is so to this part of how far the points reach.
#define DEEP 4
#define LEAN 9

// An area, or the square of a distance, is as large as the largest if it falls short of it by at most 1 / 2^ALIKE.
#define ALIKE 5

// Where a point lies seen along the axis that is nearest to the normal, from the first that is kept: below 2^30 in size.
typedef struct spot {
  int32_t x, y;
} spot;

typedef struct selection {
  spot at[GJK_CANDIDATES_MAX];
  uint8_t order[GJK_CANDIDATES_MAX];  // the candidates by their ids
  unsigned count;                     // of these
  uint8_t *keep;                      // places in order
  unsigned kept;
} selection;

static bool is_as_large(int64_t value, int64_t largest) {
  return value >= largest - gjk_sar64(largest, ALIKE);
}

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

// Finds the spots, from the first point. Returns the largest coordinate.
static uint32_t find_spots(const gjk_candidates *t, const gjk_unit3 *normal, selection *s) {
  const uint32_t x = gjk_magnitude32(normal->x), y = gjk_magnitude32(normal->y), z = gjk_magnitude32(normal->z);
  const unsigned axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
  const gjk_vec3 *origin = &t->candidate[s->order[0]].point_a;
  uint32_t reach = 0;
  for (unsigned i = 0; i < s->count; i++) {
    const gjk_vec3 v = gjk_sub(t->candidate[s->order[i]].point_a, *origin);
    const spot p = {axis == 0 ? v.y : v.x, axis == 2 ? v.y : v.z};
    s->at[i] = p;
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

// The first point whose distance is no more than limit. Pre: there is one.
static unsigned first_within(const gjk_candidates *t, const selection *s, int64_t limit) {
  unsigned i = 0;
  while (i + 1 < s->count && t->candidate[s->order[i]].distance > limit) {
    i++;
  }
  return i;
}

// Keeps point i, from which the spots are told from now on.
static void keep_first(selection *s, unsigned i) {
  const spot from = s->at[i];
  for (unsigned k = 0; k < s->count; k++) {
    s->at[k].x -= from.x;
    s->at[k].y -= from.y;
  }
  s->keep[0] = (uint8_t)i;
  s->kept = 1;
}

// Twice the area of the triangle of the first point kept, end and i; negative on the right. Below 2^61 in size.
static inline int64_t area_of(const selection *s, const spot *end, unsigned i) {
  return gjk_mul32(end->x, s->at[i].y) - gjk_mul32(end->y, s->at[i].x);
}

// Keeps the first point that is as far from the line to end as the farthest on that side.
static void keep_aside(selection *s, const spot *end, bool to_left, int64_t farthest) {
  // Seen the other way, right is left.
  const spot along = {to_left ? end->x : -end->x, to_left ? end->y : -end->y};
  unsigned i = 0;
  while (i + 1 < s->count && !is_as_large(area_of(s, &along, i), farthest)) {
    i++;
  }
  s->keep[s->kept++] = (uint8_t)i;
}

// A quadrilateral with a corner at the first point has a diagonal from there; so the largest has, to either side of its
// diagonal, the point that is farthest from it.
typedef struct diagonal {
  spot end;
  int64_t left, right;  // twice the areas of the largest triangles
} diagonal;

static int64_t measure_diagonal(const selection *s, unsigned k, bool quadrilateral, diagonal *out) {
  out->end = s->at[k];
  out->left = 0;
  out->right = 0;
  for (unsigned i = 0; i < s->count; i++) {
    const int64_t area = area_of(s, &out->end, i);
    out->left = area > out->left ? area : out->left;
    out->right = -area > out->right ? -area : out->right;
  }
  return quadrilateral ? out->left + out->right : out->left > out->right ? out->left : out->right;
}

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

// The square of how far point i is from the nearest one kept, below 2^61; -1 if it is one of them.
static int64_t clearance(const selection *s, unsigned i) {
  int64_t nearest = INT64_MAX;
  for (unsigned k = 0; k < s->kept; k++) {
    const int32_t x = s->at[i].x - s->at[s->keep[k]].x, y = s->at[i].y - s->at[s->keep[k]].y;
    const int64_t squared = s->keep[k] == i ? -1 : gjk_mul32(x, x) + gjk_mul32(y, y);
    nearest = squared < nearest ? squared : nearest;
  }
  return nearest;
}

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

static void keep_most(selection *s, unsigned first, unsigned most) {
  keep_first(s, first);
  if (most > 2) {
    keep_largest(s, most > 3);
  }
  while (s->kept < most) {  // there are more than that
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
  if (!keeps_within(candidates, &s, limit)) {
    keep_most(&s, first_within(candidates, &s, limit), most);
  }
  for (unsigned i = 0; i < most; i++) {
    keep[i] = s.order[keep[i]];
  }
}
