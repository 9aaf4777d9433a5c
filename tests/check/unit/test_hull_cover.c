// gjk_hull_check on closed surfaces that nobody designed: triangle after triangle at random, until each edge has its opposite.
// They cover the hull once, or in layers, or twice as a torus that winds around each vertex; flat ones may leave places out.
// Which of these it is, the volume tells, and of a flat one many places.
#include <string.h>

#include "check.h"
#include "gjk/hull.h"
#include "random.h"

#define MOST 26
#define FACES 100
#define TRIALS 60000

// Points of a small lattice, and which triangles of them lie in their surface.
typedef struct lattice_points {
  const char *name;
  int point[MOST][3];
  unsigned count;
  bool flat;
  long six_volume;  // of a flat one: twice the area
  bool allowed[MOST][MOST][MOST];
} lattice_points;

// Triangles, and which edges they have on each side: a flat surface has two.
typedef struct closed_surface {
  unsigned face[FACES][3], faces;
  bool edge[2][MOST][MOST];
} closed_surface;

static lattice_points set;
static closed_surface surface;
static gjk_vec3 vertex[MOST];
static uint16_t corner[3 * FACES], end[FACES];

static void print_surface(const void *subject) {
  (void)subject;
  for (unsigned i = 0; i < set.count; i++) {
    printf("%u: %ld %ld %ld\n", i, (long)vertex[i].x, (long)vertex[i].y, (long)vertex[i].z);
  }
  for (unsigned f = 0; f < surface.faces; f++) {
    printf("face %u: %u %u %u\n", f, corner[3 * f], corner[3 * f + 1], corner[3 * f + 2]);
  }
}

static void add_point(int x, int y, int z) {
  int *p = set.point[set.count++];
  p[0] = x;
  p[1] = y;
  p[2] = z;
}

static long dot(const long n[3], const int p[3]) {
  return n[0] * p[0] + n[1] * p[1] + n[2] * p[2];
}

static void normal_of(unsigned a, unsigned b, unsigned c, long n[3]) {
  const int *p = set.point[a], *q = set.point[b], *r = set.point[c];
  for (int i = 0; i < 3; i++) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    n[i] = (long)(q[j] - p[j]) * (r[k] - p[k]) - (long)(q[k] - p[k]) * (r[j] - p[j]);
  }
}

// Corners of simplices, cubes and so on with the middles of their edges.
static void choose_points(unsigned kind) {
  static const char *const names[] = {"tetrahedron", "cube", "octahedron", "square", "triangle", "prism"};
  set.name = names[kind];
  set.count = 0;
  set.flat = kind == 3 || kind == 4;
  for (int x = -2; x <= 2; x++) {
    for (int y = -2; y <= 2; y++) {
      for (int z = -2; z <= 2; z++) {
        const int sum = x + y + z, size = abs(x) + abs(y) + abs(z);
        const bool low = x >= 0 && y >= 0 && z >= 0;
        const bool small = x <= 1 && y <= 1 && z <= 1 && x >= -1 && y >= -1 && z >= -1;
        if (kind == 0   ? low && sum <= 2
            : kind == 1 ? small && size > 0
            : kind == 2 ? size == 2
            : kind == 3 ? small && z == 0
            : kind == 4 ? low && z == 0 && sum <= 2
                        : x >= 0 && y >= 0 && x + y <= 2 && z >= 0 && z <= 1) {
          add_point(x, y, z);
        }
      }
    }
  }
}

// All about the points that does not depend on chance.
static void prepare(unsigned kind) {
  static const long six_volume[] = {8, 48, 64, 8, 4, 12};
  choose_points(kind);
  set.six_volume = six_volume[kind];
  for (unsigned a = 0; a < set.count; a++) {
    for (unsigned b = 0; b < set.count; b++) {
      for (unsigned c = 0; c < set.count; c++) {
        long n[3];
        normal_of(a, b, c, n);
        bool allowed = n[0] != 0 || n[1] != 0 || n[2] != 0;
        for (unsigned i = 0; i < set.count; i++) {
          allowed = allowed && dot(n, set.point[i]) <= dot(n, set.point[a]);
        }
        set.allowed[a][b][c] = allowed;
      }
    }
  }
}

static unsigned side_of(unsigned a, unsigned b, unsigned c) {
  long n[3];
  normal_of(a, b, c, n);
  return set.flat && n[2] < 0 ? 1 : 0;
}

// Adds a triangle unless an edge of it is there already on its side.
static bool add_triangle(unsigned a, unsigned b, unsigned c) {
  if (!set.allowed[a][b][c] || surface.faces == FACES) {
    return false;
  }
  bool(*edge)[MOST] = surface.edge[side_of(a, b, c)];
  if (edge[a][b] || edge[b][c] || edge[c][a]) {
    return false;
  }
  edge[a][b] = edge[b][c] = edge[c][a] = true;
  unsigned *face = surface.face[surface.faces++];
  face[0] = a;
  face[1] = b;
  face[2] = c;
  return true;
}

// Is there an edge from b to a on that side, or, if crossed, on any?
static bool has_opposite(unsigned side, unsigned a, unsigned b, bool crossed) {
  return surface.edge[side][b][a] || (crossed && set.flat && surface.edge[1 - side][b][a]);
}

// Closes what is open with random triangles. crossed: sides of flat surfaces may meet within the outline, which is wrong.
// False: that went into a corner.
static bool close_surface(random_state *random, bool crossed) {
  for (unsigned f = 0; f < surface.faces; f++) {
    for (unsigned i = 0; i < 3; i++) {
      const unsigned a = surface.face[f][i], b = surface.face[f][(i + 1) % 3];
      const unsigned side = side_of(surface.face[f][0], surface.face[f][1], surface.face[f][2]);
      // A line on the outline has triangles of one side only on its left.
      bool outline = set.flat;
      for (unsigned c = 0; c < set.count && outline; c++) {
        outline = !set.allowed[b][a][c] || side_of(b, a, c) != side;
      }
      if (has_opposite(side, a, b, crossed || outline)) {
        continue;
      }
      bool added = false;
      for (unsigned tries = 0; tries < 3 * set.count && !added; tries++) {
        const unsigned c = random_below(random, set.count);
        if (set.allowed[b][a][c] && (crossed || outline || side_of(b, a, c) == side)) {
          added = add_triangle(b, a, c);
        }
      }
      if (!added) {
        return false;
      }
    }
  }
  return true;
}

// How often the surface covers the hull's: 6 times its volume over that of the hull.
static long covers_volume(void) {
  long sum = 0;
  for (unsigned f = 0; f < surface.faces; f++) {
    long n[3];
    normal_of(surface.face[f][0], surface.face[f][1], surface.face[f][2], n);
    sum += dot(n, set.point[surface.face[f][0]]);
  }
  CHECK(sum % set.six_volume == 0);
  return sum / set.six_volume;
}

// Is each of many places of a flat surface covered once on each side, and none outside? No place is on a line of the lattice.
static bool covers_places_once(void) {
  for (int i = 0; i < 300; i++) {
    const int x = 2 * (i * 7 % 17) * 379 + 11 - 4096, y = 2 * (i * 5 % 19) * 337 + 37 - 4096;  // 2^-12
    unsigned of_side[2] = {0, 0};
    for (unsigned f = 0; f < surface.faces; f++) {
      const unsigned *t = surface.face[f];
      const unsigned side = side_of(t[0], t[1], t[2]);
      bool in = true;
      for (unsigned k = 0; k < 3; k++) {
        const int *a = set.point[t[k]], *b = set.point[t[(k + 1) % 3]];
        const long turn = (long)(b[0] - a[0]) * (y - 4096 * a[1]) - (long)(b[1] - a[1]) * (x - 4096 * a[0]);
        CHECK(turn != 0);
        in = in && (side == 0 ? turn > 0 : turn < 0);
      }
      of_side[side] += in;
    }
    const bool inside =
        set.count == 9 ? x > -4096 && x < 4096 && y > -4096 && y < 4096 : x > 0 && y > 0 && x + y < 8192;
    if (of_side[0] != (inside ? 1u : 0u) || of_side[1] != (inside ? 1u : 0u)) {
      return false;
    }
  }
  return true;
}

// The surface under a map of determinant 1, its faces in another order and each from another corner on.
static void write_surface(random_state *random) {
  long m[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (unsigned i = random_below(random, 30); i > 0; i--) {
    const unsigned to = random_below(random, 3), from = (to + 1 + random_below(random, 2)) % 3;
    for (int j = 0; j < 3; j++) {
      m[to][j] += (i % 2 == 0 ? 1 : -1) * m[from][j];
    }
  }
  const int32_t at = random_range(random, -1000000000, 1000000000);
  for (unsigned i = 0; i < set.count; i++) {
    const int *p = set.point[i];
    vertex[i].x = at + (int32_t)(m[0][0] * p[0] + m[0][1] * p[1] + m[0][2] * p[2]);
    vertex[i].y = -at + (int32_t)(m[1][0] * p[0] + m[1][1] * p[1] + m[1][2] * p[2]);
    vertex[i].z = at + (int32_t)(m[2][0] * p[0] + m[2][1] * p[1] + m[2][2] * p[2]);
  }
  for (unsigned f = 0; f < surface.faces; f++) {
    const unsigned j = random_below(random, f + 1), first = random_below(random, 3);
    for (unsigned k = 0; k < 3; k++) {
      corner[3 * f + k] = corner[3 * j + k];
      corner[3 * j + k] = (uint16_t)surface.face[f][(first + k) % 3];
    }
    end[f] = (uint16_t)(3 * (f + 1));
  }
}

// Writes the surface and asks. Returns whether it is sound; if not, *report says where.
static bool check_surface(random_state *random, gjk_hull_report *report) {
  write_surface(random);
  const bool sound = set.flat ? covers_places_once() : covers_volume() == 1;
  const gjk_hull_faces faces = {corner, end, (uint16_t)surface.faces};
  CHECK(gjk_hull_check(vertex, (uint16_t)set.count, &faces, report) == GJK_OK);
  CHECK_MSG((report->fault == GJK_HULL_SOUND) == sound, "%s: fault %d of face %d, corner %d", set.name, report->fault,
            report->face, report->corner);
  CHECK(sound || report->fault == GJK_HULL_LAYERS || (set.flat && report->fault >= GJK_HULL_OPEN));
  return sound;
}

// A square of which all faces of both sides meet in the middle, so the first one does.
static void test_middle(random_state *random) {
  static const unsigned around[] = {0, 3, 6, 7, 8, 5, 2, 1};
  gjk_hull_report report;
  prepare(3);
  memset(&surface, 0, sizeof surface);
  for (unsigned i = 0; i < 8; i++) {
    CHECK(add_triangle(4, around[i], around[(i + 1) % 8]) && add_triangle(4, around[(i + 1) % 8], around[i]));
  }
  CHECK(check_surface(random, &report));
}

int main(void) {
  random_state random = random_seed(check_seed(42));
  unsigned long once = 0, more = 0, flat_once = 0, flat_wrong = 0, torus = 0;
  const unsigned long trials = check_trials_least(TRIALS, 3000);
  test_middle(&random);
  for (unsigned long trial = 0; trial < trials; trial++) {
    const unsigned kind = (unsigned)(trial * 6 / trials);
    if (trial == 0 || kind != (unsigned)((trial - 1) * 6 / trials)) {
      prepare(kind);
    }
    memset(&surface, 0, sizeof surface);
    check_trial(trial, print_surface, &surface);
    while (surface.faces == 0) {
      add_triangle(random_below(&random, set.count), random_below(&random, set.count),
                   random_below(&random, set.count));
    }
    if (!close_surface(&random, trial % 2 == 0)) {
      continue;
    }
    gjk_hull_report report;
    const bool sound = check_surface(&random, &report);
    once += !set.flat && sound;
    more += !set.flat && !sound;
    flat_once += set.flat && sound;
    flat_wrong += set.flat && !sound;
    torus += !set.flat && !sound && report.face == 0 && report.corner == 0;
  }
  if (check_is_full()) {
    CHECK(once > trials / 100 && more > trials / 100 && torus > trials / 400);
    CHECK(flat_once > trials / 100 && flat_wrong > trials / 20);
  }
  printf("once %lu, more %lu, torus %lu, flat: once %lu, wrong %lu\n", once, more, torus, flat_once, flat_wrong);
  return check_done("hull cover");
}
