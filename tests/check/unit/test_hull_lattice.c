// Hulls of few points on small lattices, where most sets have coplanar, collinear or repeated points, against brute
// force over all planes through three of them.
#include "hull_points.h"

#define MOST 12
#define TRIALS 500000

// What brute force finds. A facet is the set of points on a plane that no point is beyond, as a mask.
typedef struct brute {
  uint32_t facet[MOST * MOST * MOST / 6];
  unsigned facets, vertices, edges, most_corners;
  uint32_t extreme;  // mask of the first of each extreme place
  long volume;       // six times
} brute;

static gjk_vec3 minus(gjk_vec3 a, gjk_vec3 b) {
  const gjk_vec3 d = {a.x - b.x, a.y - b.y, a.z - b.z};
  return d;
}

static gjk_vec3 cross(gjk_vec3 a, gjk_vec3 b) {
  const gjk_vec3 n = {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  return n;
}

static long dot(gjk_vec3 a, gjk_vec3 b) {
  return (long)a.x * b.x + (long)a.y * b.y + (long)a.z * b.z;
}

static unsigned ones(uint32_t mask) {
  unsigned n = 0;
  for (; mask != 0; mask &= mask - 1) {
    n++;
  }
  return n;
}

// The facet whose outward normal is (b - a) x (c - a). 0: there is none.
static uint32_t facet_of(const hull_points *p, const unsigned t[3], gjk_vec3 *n) {
  const gjk_vec3 at = p->point[t[0]];
  uint32_t mask = 0;
  *n = cross(minus(p->point[t[1]], at), minus(p->point[t[2]], at));
  if (dot(*n, *n) == 0) {
    return 0;
  }
  for (unsigned i = 0; i < p->count; i++) {
    const long height = dot(*n, minus(p->point[i], at));
    if (height > 0) {
      return 0;
    }
    mask |= height == 0 ? UINT32_C(1) << i : 0;
  }
  return mask;
}

// The corners of a facet's outline, and 6 times the volume between it and the first point.
static unsigned walk_facet(const hull_points *p, uint32_t facet, gjk_vec3 n, long *volume) {
  unsigned first = 0, at, corners = 0;
  for (unsigned i = 0; i < p->count; i++) {  // the extreme point of lowest coordinates
    const gjk_vec3 a = p->point[i], b = p->point[first];
    if ((facet >> i & 1) != 0 &&
        ((facet >> first & 1) == 0 || a.x < b.x || (a.x == b.x && (a.y < b.y || (a.y == b.y && a.z < b.z))))) {
      first = i;
    }
  }
  at = first;
  gjk_vec3 from = p->point[first];
  do {  // gift wrapping: the point that all others are to the left of, the farthest of those in line
    unsigned next = at;
    for (unsigned i = 0; i < p->count; i++) {
      const gjk_vec3 step = minus(p->point[i], p->point[at]), best = minus(p->point[next], p->point[at]);
      const long side = dot(n, cross(best, step));
      if ((facet >> i & 1) != 0 && dot(step, step) > 0 &&
          (dot(best, best) == 0 || side < 0 || (side == 0 && dot(step, step) > dot(best, best)))) {
        next = i;
      }
    }
    *volume +=
        dot(minus(from, p->point[0]), cross(minus(p->point[at], p->point[0]), minus(p->point[next], p->point[0])));
    at = next;
    corners++;
  } while (dot(minus(p->point[at], p->point[first]), minus(p->point[at], p->point[first])) != 0 && corners < MOST);
  return corners;
}

static void brute_force(const hull_points *p, brute *b) {
  memset(b, 0, sizeof *b);
  uint32_t repeated = 0;
  for (unsigned i = 0; i < p->count; i++) {
    for (unsigned j = 0; j < i; j++) {
      const gjk_vec3 d = minus(p->point[i], p->point[j]);
      repeated |= dot(d, d) == 0 ? UINT32_C(1) << i : 0;
    }
  }
  unsigned t[3];
  for (t[0] = 0; t[0] < p->count; t[0]++) {
    for (t[1] = 0; t[1] < p->count; t[1]++) {
      for (t[2] = t[0] + 1; t[2] < p->count; t[2]++) {
        gjk_vec3 n = {0, 0, 0};
        const uint32_t facet = t[1] > t[0] && t[1] != t[2] ? facet_of(p, t, &n) : 0;
        bool known = facet == 0;
        for (unsigned i = 0; i < b->facets; i++) {
          known = known || b->facet[i] == facet;
        }
        if (!known) {
          b->facet[b->facets++] = facet;
          const unsigned corners = walk_facet(p, facet, n, &b->volume);
          b->most_corners = corners > b->most_corners ? corners : b->most_corners;
        }
      }
    }
  }
  for (unsigned i = 0; i < p->count; i++) {
    unsigned of = 0;
    for (unsigned f = 0; f < b->facets; f++) {
      of += b->facet[f] >> i & 1;
    }
    if (of >= 3 && (repeated >> i & 1) == 0) {
      b->extreme |= UINT32_C(1) << i;
      b->vertices++;
    }
  }
  for (unsigned f = 0; f < b->facets; f++) {
    for (unsigned g = 0; g < f; g++) {
      b->edges += ones(b->facet[f] & b->facet[g] & b->extreme) >= 2;
    }
  }
}

static bool has_vertex(const hull_output *out, gjk_vec3 v) {
  for (unsigned i = 0; i < out->hull.vertices; i++) {
    const gjk_vec3 d = minus(out->vertex[i], v);
    if (dot(d, d) == 0) {
      return true;
    }
  }
  return false;
}

int main(void) {
  random_state random = random_seed(check_seed(2611));
  static hull_points p;
  static hull_output out, again;
  const unsigned long trials = check_trials(TRIALS);
  unsigned long of_dimension[4] = {0}, merged = 0, repeated = 0, inner = 0;
  for (unsigned long trial = 0; trial < trials; trial++) {
    const int32_t size = random_range(&random, 1, 4);
    brute b;
    check_trial(trial, hull_points_print, &p);
    p.count = 0;
    for (unsigned count = 1 + random_below(&random, MOST); p.count < count;) {
      hull_points_add(&p, random_range(&random, 0, size), random_range(&random, 0, size),
                      random_range(&random, 0, random_below(&random, 4) == 0 ? 0 : size));
    }
    hull_output_make(&p, &out);
    of_dimension[out.hull.dimension]++;
    if (trial % 8 == 0) {
      hull_points_shuffle(&p, &random);
      hull_output_make(&p, &again);
      CHECK(hull_output_equal(&out, &again));
    }
    if (out.hull.dimension < 3) {
      CHECK(out.volume.high == 0 && out.volume.low == 0);
    }
    brute_force(&p, &b);
    CHECK((b.facets > 2) == (out.hull.dimension == 3));
    if (b.facets <= 2) {
      continue;
    }
    CHECK(out.hull.vertices == b.vertices && out.hull.faces == b.facets && out.hull.edges == b.edges &&
          out.hull.corners == 2 * b.edges && out.hull.most_corners == b.most_corners);
    CHECK(out.volume.high == 0 && out.volume.low == (uint64_t)b.volume);
    for (unsigned i = 0; i < p.count; i++) {
      CHECK((b.extreme >> i & 1) == 0 || has_vertex(&out, p.point[i]));
    }
    merged += b.most_corners > 3;
    repeated += out.hull.distinct < p.count;
    inner += out.hull.vertices < out.hull.distinct;
  }
  CHECK(of_dimension[0] > trials / 1000 && of_dimension[1] > trials / 1000 && of_dimension[2] > trials / 100);
  CHECK(merged > trials / 4 && repeated > trials / 10 && inner > trials / 10);
  printf("%lu points, %lu lines, %lu planes, %lu solids\n", of_dimension[0], of_dimension[1], of_dimension[2],
         of_dimension[3]);
  return check_done("hull_lattice");
}
