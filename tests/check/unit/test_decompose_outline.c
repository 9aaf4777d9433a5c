// Decomposition of prisms over outlines of random sizes, upright and turned: the fewest parts, which an oracle in the plane
// counts, and exact ones where no rounding bends the faces.
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "random.h"
#include "tests/programs/convert/decompose.h"

enum { CORNERS = 24, CHORDS = CORNERS * CORNERS / 2 };

// Counterclockwise.
typedef struct outline {
  const char *name;
  unsigned corners;
  int64_t at[CORNERS][2];
} outline;

// Corners of each as numbers of lines across x and y. slanted: cuts may have to go to corners.
static const struct {
  const char *name, *corners;
  bool slanted;
} families[] = {
    {"L", "00 20 21 11 12 02", false},
    {"U", "00 30 33 23 21 11 12 02", false},
    {"T", "00 30 31 21 22 12 11 01", false},
    {"S", "00 20 21 31 32 12 11 01", false},
    {"Z", "00 20 23 33 34 14 11 01", false},
    {"cross", "10 20 21 31 32 22 23 13 12 02 01 11", false},
    {"cross with arms aside", "11 21 20 40 41 61 63 73 75 65 66 56 57 37 36 16 14 04 02 12", false},
    {"stairs", "00 50 51 41 42 32 33 23 24 14 15 05", false},
    {"comb", "00 70 73 63 61 51 52 42 41 31 34 24 21 11 12 02", false},
    {"H", "00 10 12 22 21 31 35 25 23 13 14 04", false},
    {"C", "00 30 32 22 21 11 15 25 24 34 36 06", false},
    {"E", "00 20 21 11 12 32 33 13 14 24 25 05", false},
    {"chevron", "02 10 22 23 11 03", true},
    {"zigzag", "00 12 20 32 40 41 33 21 13 01", true},
    {"arrow", "01 11 10 22 14 13 03", true},
    {"dovetail", "00 50 54 34 42 12 24 04", true},
    {"notch", "00 40 43 22 03", true},
};

enum { FAMILIES = sizeof families / sizeof families[0] };

static void print_outline(const void *subject) {
  const outline *o = (const outline *)subject;
  printf("%s:", o->name);
  for (unsigned i = 0; i < o->corners; i++) {
    printf(" %ld,%ld", (long)o->at[i][0], (long)o->at[i][1]);
  }
  printf("\n");
}

static outline outline_random(random_state *random, unsigned family) {
  outline o = {families[family].name, 0, {{0, 0}}};
  int64_t line[2][8] = {{0}};
  for (int i = 0; i < 2; i++) {
    for (int j = 1; j < 8; j++) {
      line[i][j] = line[i][j - 1] + random_range(random, 60, random_below(random, 3) == 0 ? 400 : 4000);
    }
  }
  for (const char *text = families[family].corners; *text != '\0'; text += text[2] == ' ' ? 3 : 2) {
    o.at[o.corners][0] = line[0][text[0] - '0'];
    o.at[o.corners++][1] = line[1][text[1] - '0'];
  }
  return o;
}

// The oracle. Each corner that is not convex needs a cut, and one cut does for two if it runs between them, inside, and
// leaves no angle at either above half a turn. So the fewest parts are 1 more than those corners, less the most such chords that
// do not cross.

static int64_t turn(const int64_t a[2], const int64_t b[2], const int64_t c[2]) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

static int sign(int64_t x) {
  return (x > 0) - (x < 0);
}

static const int64_t *corner(const outline *o, unsigned i, unsigned step) {
  return o->at[(i + step) % o->corners];
}

static bool is_notch(const outline *o, unsigned i) {
  return turn(corner(o, i, o->corners - 1), o->at[i], corner(o, i, 1)) < 0;
}

// Does a chord from i leave two angles there of at most half a turn?
static bool resolves(const outline *o, unsigned i, unsigned to) {
  return turn(corner(o, i, o->corners - 1), o->at[i], o->at[to]) >= 0 &&
         turn(o->at[i], corner(o, i, 1), o->at[to]) >= 0;
}

static bool cross(const int64_t a[2], const int64_t b[2], const int64_t c[2], const int64_t d[2]) {
  return sign(turn(a, b, c)) * sign(turn(a, b, d)) < 0 && sign(turn(c, d, a)) * sign(turn(c, d, b)) < 0;
}

// Chords that resolve their ends begin inside, so those that meet no side and no corner in between stay there.
static bool is_free(const outline *o, unsigned from, unsigned to) {
  const int64_t *a = o->at[from], *b = o->at[to];
  for (unsigned i = 0; i < o->corners; i++) {
    const int64_t *c = o->at[i];
    const int64_t along = (c[0] - a[0]) * (b[0] - a[0]) + (c[1] - a[1]) * (b[1] - a[1]);
    const int64_t length = (b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1]);
    if ((turn(a, b, c) == 0 && along > 0 && along < length) || cross(a, b, c, corner(o, i, 1))) {
      return false;
    }
  }
  return (from + 1) % o->corners != to && (to + 1) % o->corners != from;
}

typedef struct chords {
  unsigned end[CHORDS][2], count;
} chords;

// The most chords from the first on that share no end and do not cross.
static unsigned most_chords(const outline *o, const chords *all, unsigned first, bool taken[CHORDS]) {
  unsigned best = 0;
  for (unsigned i = first; i < all->count; i++) {
    const unsigned *e = all->end[i];
    bool fits = true;
    for (unsigned j = 0; j < i && fits; j++) {
      const unsigned *f = all->end[j];
      fits = !taken[j] || (e[0] != f[0] && e[0] != f[1] && e[1] != f[0] && e[1] != f[1] &&
                           !cross(o->at[e[0]], o->at[e[1]], o->at[f[0]], o->at[f[1]]));
    }
    if (fits) {
      taken[i] = true;
      const unsigned found = 1 + most_chords(o, all, i + 1, taken);
      taken[i] = false;
      best = found > best ? found : best;
    }
  }
  return best;
}

static unsigned fewest_parts(const outline *o) {
  static bool taken[CHORDS];
  chords all = {{{0, 0}}, 0};
  unsigned notches = 0;
  for (unsigned i = 0; i < o->corners; i++) {
    notches += is_notch(o, i) ? 1 : 0;
    for (unsigned j = i + 1; j < o->corners; j++) {
      if (is_notch(o, i) && is_notch(o, j) && resolves(o, i, j) && resolves(o, j, i) && is_free(o, i, j)) {
        all.end[all.count][0] = i;
        all.end[all.count++][1] = j;
      }
    }
  }
  return 1 + notches - most_chords(o, &all, 0, taken);
}

// Rows of a rotation.
static void rotation_random(random_state *random, double rows[3][3]) {
  double q[4], length = 0;
  for (int i = 0; i < 4; i++) {
    q[i] = random_range(random, -1000, 1000) + 0.5;
    length += q[i] * q[i];
  }
  for (int i = 0; i < 3; i++) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    rows[i][i] = (q[3] * q[3] + q[i] * q[i] - q[j] * q[j] - q[k] * q[k]) / length;
    rows[i][j] = 2 * (q[i] * q[j] - q[3] * q[k]) / length;
    rows[i][k] = 2 * (q[i] * q[k] + q[3] * q[j]) / length;
  }
}

// The prism between z = 0 and 'high', turned and rounded to LSB. Its faces of many corners are cut as those of a file are.
static solid prism(const outline *o, int32_t high, double rows[3][3]) {
  const unsigned n = o->corners;
  mesh m = {0};
  mesh_file file = {"prism", NULL, 0, 1, 0, "", NULL};
  char problem[200] = "";
  int64_t face[2][CORNERS];
  solid s;
  for (unsigned i = 0; i < 2 * n; i++) {
    const double x[3] = {(double)o->at[i % n][0], (double)o->at[i % n][1], i < n ? 0 : high};
    double turned[3];
    for (int j = 0; j < 3; j++) {
      turned[j] = rows[j][0] * x[0] + rows[j][1] * x[1] + rows[j][2] * x[2];
    }
    CHECK(mesh_add_point(&m, &file, turned));
    face[0][i % n] = n - 1 - i % n;
    face[1][i % n] = n + i % n;
  }
  CHECK(mesh_add_polygon(&m, &file, face[0], n) && mesh_add_polygon(&m, &file, face[1], n));
  for (unsigned i = 0; i < n; i++) {
    const int64_t j = (i + 1) % n, side[4] = {i, j, n + j, n + i};
    CHECK(mesh_add_polygon(&m, &file, side, 4));
  }
  mesh_weld(&m);
  CHECK_MSG(solid_from_mesh(&s, &m, problem, sizeof problem), "%s\n", problem);
  mesh_free(&m);
  return s;
}

static void decompose_prism(const outline *o, random_state *random, double rows[3][3], decomposition *out) {
  static const decompose_options usual = {-1, 0};
  solid s = prism(o, random_range(random, 60, 4000), rows);
  decompose(&s, &usual, out);
  solid_wide sum = 0;
  for (size_t i = 0; i < out->parts; i++) {
    sum += out->part[i].volume6;
  }
  CHECK_MSG(out->enclosed, "%s\n", out->problem);
  CHECK(out->excess.at_most > 0 || sum >= s.volume6);
  solid_free(&s);
}

// As the outline lies: no rounding. Outlines along the axes come out exactly; most slanted ones do.
static void test_upright(uint64_t seed) {
  double rows[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  random_state random = random_seed(seed);
  unsigned long slanted = 0, exact = 0, few = 0, many = 0;
  const unsigned long count = check_trials(8 * FAMILIES);
  for (unsigned long i = 0; i < count; i++) {
    const outline o = outline_random(&random, (unsigned)(i % FAMILIES));
    const unsigned fewest = fewest_parts(&o);
    decomposition d;
    check_trial(i, print_outline, &o);
    decompose_prism(&o, &random, rows, &d);
    CHECK_MSG(d.parts == fewest, "%s: %zu parts, expected %u\n", o.name, d.parts, fewest);
    CHECK_MSG(d.excess.at_most <= (families[i % FAMILIES].slanted ? 2 : 0), "%s: %Lg\n", o.name, d.excess.at_most);
    slanted += families[i % FAMILIES].slanted;
    exact += families[i % FAMILIES].slanted && d.excess.at_most == 0;
    few += fewest <= 2;
    many += fewest >= 4;
    decompose_free(&d);
  }
  CHECK_MSG(!check_is_full() || (10 * exact >= 9 * slanted && few > count / 5 && many > count / 5),
            "%lu of %lu slanted exact; %lu of 2 parts, %lu of 4 or more\n", exact, slanted, few, many);
}

// Turned: each corner is rounded, which bends faces by up to an LSB. As many parts, which reach few LSB beyond. Outlines
// are left out whose notches are in line with each other: rounding puts them out of line.
static void test_turned(uint64_t seed) {
  static const unsigned chosen[] = {0, 1, 7, 12, 16};
  random_state random = random_seed(seed);
  const unsigned long count = check_trials(3 * sizeof chosen / sizeof chosen[0]);
  for (unsigned long i = 0; i < count; i++) {
    const outline o = outline_random(&random, chosen[i % (sizeof chosen / sizeof chosen[0])]);
    const unsigned fewest = fewest_parts(&o);
    double rows[3][3];
    decomposition d;
    check_trial(i, print_outline, &o);
    rotation_random(&random, rows);
    decompose_prism(&o, &random, rows, &d);
    CHECK_MSG(d.parts == fewest, "%s: %zu parts, expected %u\n", o.name, d.parts, fewest);
    CHECK_MSG(d.excess.at_most <= 4 && d.excess.at_most <= d.excess.at_least + 1, "%s: %Lg to %Lg\n", o.name,
              d.excess.at_least, d.excess.at_most);
    decompose_free(&d);
  }
}

int main(void) {
  const uint64_t seed = check_seed(3031);
  test_upright(seed);
  test_turned(seed + 1);
  return check_done("decompose_outline");
}
