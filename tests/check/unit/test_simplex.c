// The nearest feature after each new vertex, against a trial of all features in exact integers. On small lattices,
// where everything coincides and touches, and on larger ones.
#include <string.h>

#include "check.h"
#include "random_vec.h"
#include "src/gjk/gjk_simplex.h"

#define RUNS ((int)check_trials(150000))
#define VERTICES 12

__extension__ typedef __int128 wide;

typedef struct point {
  wide x, y, z;
} point;

static point point_of(const gjk_vec3 *v) {
  return (point){v->x, v->y, v->z};
}

static wide dot(point a, point b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

static point minus(point a, point b) {
  return (point){a.x - b.x, a.y - b.y, a.z - b.z};
}

static point cross(point a, point b) {
  return (point){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static point times(point a, wide f) {
  return (point){a.x * f, a.y * f, a.z * f};
}

// The point nearest to the origin of the point, line or plane through a feature's vertices, times *scale > 0. False: it
// is not inside the feature.
static bool nearest(const point *v, unsigned count, point *p, wide *scale) {
  if (count == 1) {
    *p = v[0];
    *scale = 1;
    return true;
  }
  if (count == 2) {
    const point edge = minus(v[1], v[0]);
    const wide a = dot(v[1], edge), b = -dot(v[0], edge);
    *scale = a + b;
    const point q = {a * v[0].x + b * v[1].x, a * v[0].y + b * v[1].y, a * v[0].z + b * v[1].z};
    *p = q;
    return a > 0 && b > 0;
  }
  const point n = cross(minus(v[1], v[0]), minus(v[2], v[0]));
  *scale = dot(n, n);
  *p = times(n, dot(n, v[0]));
  return *scale > 0 && dot(n, cross(v[1], v[2])) > 0 && dot(n, cross(v[2], v[0])) > 0 && dot(n, cross(v[0], v[1])) > 0;
}

// Does v lie nearer to the origin than the plane through p / scale, across p?
static bool is_before(point v, point p, wide scale) {
  return dot(v, p) * scale < dot(p, p);
}

// The feature of v nearest to the origin, as a set of vertices, a bit each. 15: the tetrahedron holds the origin.
static unsigned nearest_set(const point *v, unsigned count) {
  for (unsigned set = 1; set < 1u << count; set++) {
    point part[4], p;
    wide scale;
    unsigned n = 0;
    for (unsigned i = 0; i < count; i++) {
      if ((set >> i & 1u) != 0) {
        part[n++] = v[i];
      }
    }
    bool is_nearest = n < 4 && nearest(part, n, &p, &scale);
    for (unsigned i = 0; is_nearest && i < count; i++) {
      is_nearest = !is_before(v[i], p, scale);
    }
    // If the origin lies on a face of a tetrahedron, the answer is the tetrahedron, not the face.
    if (is_nearest && !(count == 4 && n == 3 && dot(p, p) == 0)) {
      return count == 4 && dot(p, p) == 0 ? 15 : set;
    }
  }
  return 15;
}

static bool is_permutation(const gjk_simplex *s) {
  return (1u << s->order[0] | 1u << s->order[1] | 1u << s->order[2] | 1u << s->order[3]) == 15;
}

// Is the normal that of the corners in their order, pointing to the origin?
static bool has_normal(const gjk_simplex *s) {
  const point a = point_of(&s->slot[s->order[0]].w), b = point_of(&s->slot[s->order[1]].w),
              c = point_of(&s->slot[s->order[2]].w), n = cross(minus(b, a), minus(c, a));
  return n.x == s->normal.x && n.y == s->normal.y && n.z == s->normal.z && dot(n, a) <= 0;
}

// Adds a vertex to the simplex and checks the feature that is left. Returns whether another vertex may be added.
static bool add(gjk_simplex *s, gjk_vec3 w, unsigned long *counts) {
  const gjk_simplex before = *s;
  const unsigned count = s->count, slot = s->order[count];
  point v[4], p;
  wide scale = 1;
  for (unsigned i = 0; i < count; i++) {
    v[i] = point_of(&s->slot[s->order[i]].w);
  }
  v[count] = point_of(&w);
  gjk_simplex_free(s)->w = w;
  const bool nearer = count == 0 || (nearest(v, count, &p, &scale) && is_before(v[count], p, scale));
  const gjk_step step = gjk_simplex_add(s);
  if (!nearer) {
    CHECK(step == GJK_STEP_NONE);
    CHECK(s->count == count);
    CHECK(memcmp(s->order, before.order, sizeof s->order) == 0);
    return true;
  }
  const unsigned set = nearest_set(v, count + 1);
  unsigned found = 0, n = 0;
  for (unsigned i = 0; i < s->count; i++) {
    for (unsigned k = 0; k <= count; k++) {
      const unsigned at = k < count ? before.order[k] : slot;
      found |= s->order[i] == at ? 1u << k : 0;
    }
  }
  for (unsigned i = set; i != 0; i &= i - 1) {
    n++;
  }
  CHECK_MSG(found == set, "%u vertices: %u instead of %u", count, found, set);
  CHECK_MSG(s->count == n, "%u vertices: %u instead of %u", count, found, set);
  CHECK_MSG(is_permutation(s), "%u vertices: %u instead of %u", count, found, set);
  const bool triangle = s->count == 3;
  CHECK(!triangle || has_normal(s));
  const bool on_triangle = triangle && gjk_dot_sign(&s->normal, &w) == 0;
  CHECK(step == (s->count == 4 || on_triangle ? GJK_STEP_ENCLOSING : GJK_STEP_NEARER));
  counts[count * 5 + s->count]++;
  gjk_search_direction direction;
  return step == GJK_STEP_NEARER && gjk_simplex_direction(s, &direction);
}

int main(void) {
  random_state random = random_seed(check_seed(8));
  unsigned long counts[20];
  memset(counts, 0, sizeof counts);
  for (int run = 0; run < RUNS; run++) {
    check_trial((unsigned long)run, NULL, NULL);
    const int32_t size = run % 8 < 7 ? 1 + run % 8 : 3000;
    const gjk_vec3 middle = random_in_cube(&random, size);
    gjk_simplex s;
    memset(&s, 0x55, sizeof s);
    gjk_simplex_clear(&s);
    CHECK(s.count == 0);
    CHECK(is_permutation(&s));
    for (int i = 0; i < VERTICES; i++) {
      const gjk_vec3 w = {middle.x + random_range(&random, -size, size), middle.y + random_range(&random, -size, size),
                          middle.z + random_range(&random, -size, size)};
      if (!add(&s, w, counts)) {
        break;
      }
    }
  }
  for (unsigned from = 0; from < 4; from++) {
    printf("from %u vertices to 1: %lu, 2: %lu, 3: %lu, 4: %lu\n", from, counts[from * 5 + 1], counts[from * 5 + 2],
           counts[from * 5 + 3], counts[from * 5 + 4]);
    for (unsigned to = 1; to <= from + 1; to++) {
      CHECK(counts[from * 5 + to] * 300 >= (unsigned long)RUNS);
    }
  }
  return check_done("simplex");
}
