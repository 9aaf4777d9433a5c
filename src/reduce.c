// Which of many contact points to keep.
#include "reduce.h"

// Where a point lies seen along the axis that is nearest to the normal, from the deepest point.
typedef struct spot {
  int32_t x, y;
} spot;

typedef struct selection {
  const gjk_touches *touches;
  unsigned axis;  // 0 to 2: x, y, z
  uint8_t *keep;  // the first is the deepest
  unsigned count;
} selection;

static spot spot_of(const selection *s, unsigned i) {
  const gjk_vec3 v = gjk_sub(s->touches->touch[i].point_a, s->touches->touch[s->keep[0]].point_a);
  const spot p = {s->axis == 0 ? v.y : v.x, s->axis == 2 ? v.y : v.z};
  return p;
}

static unsigned deepest(const gjk_touches *t, gjk_q16 limit) {
  gjk_q16 least = t->touch[0].distance;
  unsigned i = 0;
  for (unsigned k = 1; k < t->count; k++) {
    least = t->touch[k].distance < least ? t->touch[k].distance : least;
  }
  while (t->touch[i].distance > least + 1 || t->touch[i].distance > limit) {  // one of them is the least
    i++;
    //@ assert i < t->count;
  }
  return i;
}

// A quadrilateral with a corner at the deepest point has a diagonal from there; so the largest has, to either side of its
// diagonal, the point that is farthest from it.
static void keep_largest(selection *s, bool quadrilateral) {
  unsigned best[3] = {0, 0, 0}, corners = 0;
  int64_t most = 0;
  for (unsigned k = 0; k < s->touches->count; k++) {
    const spot end = spot_of(s, k);
    int64_t left = 0, right = 0;  // twice the areas; below 2^61
    unsigned left_at = k, right_at = k;
    for (unsigned i = 0; i < s->touches->count; i++) {
      const spot p = spot_of(s, i);
      const int64_t area = gjk_mul32(end.x, p.y) - gjk_mul32(end.y, p.x);
      if (area > left) {
        left = area;
        left_at = i;
      }
      if (-area > right) {
        right = -area;
        right_at = i;
      }
    }
    const int64_t area = quadrilateral ? left + right : left > right ? left : right;
    if (area > most) {
      most = area;
      corners = 0;
      best[corners++] = k;
      if (left > 0 && (quadrilateral || left > right)) {
        best[corners++] = left_at;
      }
      if (right > 0 && (quadrilateral || left <= right)) {
        best[corners++] = right_at;
      }
    }
  }
  for (unsigned i = 0; i < corners; i++) {
    s->keep[s->count++] = (uint8_t)best[i];
  }
}

// The square of how far point i is from the nearest one kept, below 2^62.
static int64_t clearance(const selection *s, unsigned i) {
  int64_t nearest = INT64_MAX;
  for (unsigned k = 0; k < s->count; k++) {
    const gjk_vec3 v = gjk_sub(s->touches->touch[i].point_a, s->touches->touch[s->keep[k]].point_a);
    const int64_t squared = gjk_dot(&v, &v);
    nearest = squared < nearest ? squared : nearest;
  }
  return nearest;
}

static bool is_kept(const selection *s, unsigned i) {
  for (unsigned k = 0; k < s->count; k++) {
    if (s->keep[k] == i) {
      return true;
    }
  }
  return false;
}

static void keep_farthest(selection *s) {
  unsigned best = 0;
  int64_t most = -1;
  for (unsigned i = 0; i < s->touches->count; i++) {
    const int64_t far = is_kept(s, i) ? -1 : clearance(s, i);
    if (far > most) {
      most = far;
      best = i;
    }
  }
  s->keep[s->count++] = (uint8_t)best;
}

void gjk_reduce(const gjk_touches *touches, const gjk_unit3 *normal, unsigned most, gjk_q16 limit, uint8_t *keep) {
  const uint32_t x = gjk_magnitude32(normal->x), y = gjk_magnitude32(normal->y), z = gjk_magnitude32(normal->z);
  selection s = {touches, x >= y && x >= z ? 0 : y >= z ? 1 : 2, keep, 1};
  keep[0] = (uint8_t)deepest(touches, limit);
  if (most > 2) {
    keep_largest(&s, most > 3);
  }
  while (s.count < most) {  // there are more than that
    keep_farthest(&s);
  }
}
