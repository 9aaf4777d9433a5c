// Mass properties of rounded polygons: against the rectangles and sectors that they are made of, one by one; closed
// forms; and what turning, moving and renumbering must not change.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "gjk2/hull.h"
#include "gjk2/mass.h"
#include "random.h"

typedef long double real;

#define MOST 40

typedef struct outline {
  gjk2_vec v[MOST];
  unsigned count;
  int32_t radius;
} outline;

static outline o;

static void print_outline(const void *subject) {
  const outline *own = subject;
  printf("radius %ld\n", (long)own->radius);
  for (unsigned i = 0; i < own->count; i++) {
    printf("%ld %ld\n", (long)own->v[i].x, (long)own->v[i].y);
  }
}

// Area, first moments and polar second moment, from v[0].
typedef struct sums {
  real area, x, y, polar;
} sums;

// A piece by its area, its centre, and its polar moment about that.
static void add_piece(sums *s, real area, real x, real y, real polar) {
  s->area += area;
  s->x += area * x;
  s->y += area * y;
  s->polar += polar + area * (x * x + y * y);
}

static void add_triangle(sums *s, const real a[2], const real b[2], const real c[2]) {
  const real area = ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
  const real x = (a[0] + b[0] + c[0]) / 3, y = (a[1] + b[1] + c[1]) / 3;
  real squares = 0;
  const real *const corner[3] = {a, b, c};
  for (int i = 0; i < 3; i++) {
    squares += (corner[i][0] - x) * (corner[i][0] - x) + (corner[i][1] - y) * (corner[i][1] - y);
  }
  add_piece(s, area, x, y, area * squares / 12);
}

static void place(const outline *own, unsigned i, real at[2]) {
  const unsigned n = i % own->count;
  at[0] = (real)own->v[n].x - own->v[0].x;
  at[1] = (real)own->v[n].y - own->v[0].y;
}

// Pieces: triangles, rectangles by their middles, sectors by their centroids 4 r sin(t/2) / (3 t) from the corner.
static sums sums_of_pieces(const outline *own) {
  const real pi = acosl(-1.0L), r = own->radius;
  sums s = {0, 0, 0, 0};
  real origin[2] = {0, 0};
  if (own->count == 1) {
    add_piece(&s, pi * r * r, 0, 0, pi * r * r * r * r / 2);
    return s;
  }
  for (unsigned i = 0; i < own->count; i++) {
    real a[2], b[2], c[2];
    place(own, i, a);
    place(own, i + 1, b);
    place(own, i + 2, c);
    add_triangle(&s, origin, a, b);
    const real e[2] = {b[0] - a[0], b[1] - a[1]}, f[2] = {c[0] - b[0], c[1] - b[1]},
               length = sqrtl(e[0] * e[0] + e[1] * e[1]), other = sqrtl(f[0] * f[0] + f[1] * f[1]),
               n[2] = {e[1] / length, -e[0] / length};
    add_piece(&s, length * r, (a[0] + b[0] + n[0] * r) / 2, (a[1] + b[1] + n[1] * r) / 2,
              length * r * (length * length + r * r) / 12);
    const real turn = own->count == 2 ? pi : atan2l(e[0] * f[1] - e[1] * f[0], e[0] * f[0] + e[1] * f[1]);
    // The middle of the sector lies along the sum of both normals, and along the difference of both edges.
    const bool sharp = e[0] * f[0] + e[1] * f[1] < 0;
    const real m[2] = {sharp ? e[0] / length - f[0] / other : n[0] + f[1] / other,
                       sharp ? e[1] / length - f[1] / other : n[1] - f[0] / other};
    const real size = sqrtl(m[0] * m[0] + m[1] * m[1]), lever = 4 * r * sinl(turn / 2) / (3 * turn),
               area = turn * r * r / 2;
    add_piece(&s, area, b[0] + lever * m[0] / size, b[1] + lever * m[1] / size, area * (r * r / 2 - lever * lever));
  }
  return s;
}

static real inertia_of(const sums *s) {
  return (s->polar - (s->x * s->x + s->y * s->y) / s->area) / s->area;
}

static gjk_status mass_of(const outline *own, gjk2_mass *m) {
  const gjk2_shape shape = GJK2_ROUNDED_POLYGON(own->v, (uint16_t)own->count, own->radius);
  return gjk2_mass_of_shape(&shape, m);
}

static void check_pieces(const outline *own, const gjk2_mass *m) {
  const sums s = sums_of_pieces(own);
  const real inertia = inertia_of(&s), spread = (s.polar + (s.x * s.x + s.y * s.y) / s.area) / s.area;
  CHECK_MSG(fabsl((real)m->area - s.area) <= 0.51L + 0x1p-60L * s.area, "area %llu, %Lf", (unsigned long long)m->area,
            s.area);
  CHECK_MSG(fabsl((real)m->inertia - inertia) <= 0.51L + 0x1p-59L * spread, "inertia %lld, %Lf", (long long)m->inertia,
            inertia);
  const real x = (real)m->centre.x - own->v[0].x + m->fraction[0] / 65536.0L,
             y = (real)m->centre.y - own->v[0].y + m->fraction[1] / 65536.0L;
  CHECK_MSG(x - s.x / s.area <= 0x1p-30L && s.x / s.area - x <= 0x1p-16L + 0x1p-30L, "x %Lf, %Lf", x, s.x / s.area);
  CHECK_MSG(y - s.y / s.area <= 0x1p-30L && s.y / s.area - y <= 0x1p-16L + 0x1p-30L, "y %Lf, %Lf", y, s.y / s.area);
}

static bool are_near(const gjk2_mass *a, const gjk2_mass *b) {
  return (a->area > b->area ? a->area - b->area : b->area - a->area) <= 1 && a->inertia - b->inertia <= 1 &&
         b->inertia - a->inertia <= 1;
}

static int64_t centre_of(int32_t whole, int16_t fraction) {
  return whole * INT64_C(65536) + fraction;
}

// Renumbered, moved, turned by a quarter: the same, but for what rounding may do.
static void check_symmetries(const outline *own, const gjk2_mass *m, random_state *random) {
  outline other = *own;
  gjk2_mass n;
  const unsigned first = random_below(random, own->count);
  const int32_t dx = random_range(random, -1000, 1000), dy = random_range(random, -1000, 1000);
  for (unsigned i = 0; i < own->count; i++) {
    other.v[i] = own->v[(i + first) % own->count];
  }
  CHECK(mass_of(&other, &n) == GJK_OK && are_near(m, &n));
  CHECK(llabs(centre_of(m->centre.x, m->fraction[0]) - centre_of(n.centre.x, n.fraction[0])) <= 1);
  other = *own;
  for (unsigned i = 0; i < own->count; i++) {
    other.v[i].x += dx;
    other.v[i].y += dy;
  }
  CHECK(mass_of(&other, &n) == GJK_OK && n.area == m->area && n.inertia == m->inertia);
  CHECK(n.centre.x == m->centre.x + dx && n.centre.y == m->centre.y + dy && n.fraction[0] == m->fraction[0] &&
        n.fraction[1] == m->fraction[1]);
  for (unsigned i = 0; i < own->count; i++) {
    other.v[i].x = -own->v[i].y;
    other.v[i].y = own->v[i].x;
  }
  CHECK(mass_of(&other, &n) == GJK_OK && n.area == m->area && n.inertia == m->inertia);
  CHECK(n.centre.y == m->centre.x && n.fraction[1] == m->fraction[0]);
  CHECK(llabs(centre_of(n.centre.x, n.fraction[0]) + centre_of(m->centre.y, m->fraction[1])) <= 1);
}

static void test_random(uint64_t seed) {
  random_state random = random_seed(seed);
  unsigned dimensions[3] = {0, 0, 0}, tiny = 0, huge = 0;
  for (unsigned long trial = 0; trial < 3000; trial++) {
    const int32_t size = INT32_C(1) << random_below(&random, 26), thick = size >> random_below(&random, 26);
    const int32_t shift = random_range(&random, -1000000000, 1000000000);
    gjk2_vec point[12];
    gjk2_hull hull;
    gjk2_mass m;
    const unsigned points = 1 + random_below(&random, 12);
    const int32_t slope = random_range(&random, -1, 1);
    for (unsigned i = 0; i < points; i++) {
      const int32_t x = random_range(&random, -size, size);
      point[i].x = x + shift;
      point[i].y = slope * x + random_range(&random, -thick, thick) * (trial % 5 != 0) - shift;
    }
    o.count = 0;
    o.radius = 1 + (int32_t)random_below(&random, UINT32_C(1) << random_below(&random, 28));
    check_trial(trial, print_outline, &o);
    CHECK(gjk2_hull_build(point, (uint16_t)points, o.v, &hull) == GJK_OK);
    o.count = hull.vertices;
    CHECK(mass_of(&o, &m) == GJK_OK && m.mass == 0);
    check_pieces(&o, &m);
    check_symmetries(&o, &m, &random);
    dimensions[hull.dimension]++;
    tiny += o.radius < size / 1024;
    huge += o.radius / 64 > size;
  }
  CHECK_MSG(dimensions[0] > 100 && dimensions[1] > 200 && dimensions[2] > 1000 && tiny > 200 && huge > 200,
            "%u %u %u, %u %u", dimensions[0], dimensions[1], dimensions[2], tiny, huge);
}

// Boxes, capsules and circles have closed forms. Their centres are exact.
static void test_closed_forms(void) {
  random_state random = {17};
  for (unsigned long trial = 0; trial < 500; trial++) {
    const int32_t a = (int32_t)random_below(&random, UINT32_C(1) << (1 + trial % 26)),
                  b = trial % 7 == 0 ? 0 : (int32_t)random_below(&random, UINT32_C(1) << (1 + trial / 2 % 26)),
                  r = 1 + (int32_t)random_below(&random, UINT32_C(1) << (1 + trial % 27)),
                  x = random_range(&random, -1000000, 1000000);
    gjk2_mass m, n;
    const gjk2_shape box = GJK2_ROUNDED_BOX(a, b, r), disc = GJK2_ROUNDED_ELLIPSE(a, a, r), circle = GJK2_CIRCLE(a + r);
    const gjk2_vec corner[4] = {{x - a, -b}, {x + a, -b}, {x + a, b}, {x - a, b}};
    check_trial(trial, print_outline, &o);
    o.radius = r;
    o.count = a == 0 || b == 0 ? 2 : 4;
    memcpy(o.v, corner, sizeof corner);
    o.v[1] = a == 0 ? corner[2] : corner[1];
    CHECK(gjk2_mass_of_shape(&box, &m) == GJK_OK && mass_of(&o, &n) == GJK_OK && are_near(&m, &n));
    CHECK(n.centre.x == x && n.centre.y == 0 && n.fraction[0] == 0 && n.fraction[1] == 0);
    CHECK(gjk2_mass_of_shape(&disc, &m) == GJK_OK && gjk2_mass_of_shape(&circle, &n) == GJK_OK);
    CHECK(memcmp(&m, &n, sizeof m) == 0);
  }
}

// Triangles in either order, with equal vertices, in a line; and the largest and the smallest of all.
static void test_triangles(void) {
  static const gjk2_vec right[3] = {{0, 0}, {400, 0}, {0, 300}}, left[3] = {{0, 0}, {0, 300}, {400, 0}},
                        line[3] = {{5, 5}, {1, 1}, {9, 9}}, ends[2] = {{1, 1}, {9, 9}},
                        same[3] = {{7, 8}, {7, 8}, {7, 8}};
  const gjk2_shape shape[5] = {GJK2_ROUNDED_TRIANGLE(right, 50), GJK2_ROUNDED_TRIANGLE(left, 50),
                               GJK2_ROUNDED_TRIANGLE(line, 50), GJK2_ROUNDED_POLYGON(ends, 2, 50),
                               GJK2_ROUNDED_TRIANGLE(same, 50)};
  gjk2_mass m[5];
  for (int i = 0; i < 5; i++) {
    CHECK(gjk2_mass_of_shape(&shape[i], &m[i]) == GJK_OK);
  }
  CHECK(memcmp(&m[0], &m[1], sizeof m[0]) == 0 && memcmp(&m[2], &m[3], sizeof m[2]) == 0);
  CHECK(m[0].area == 60000 + 50 * 1200 + 7854);  // pi 2500 = 7853.98
  CHECK(m[2].centre.x == 5 && m[2].fraction[0] == 0 && m[2].centre.y == 5);
  CHECK(m[4].area == 7854 && m[4].inertia == 1250 && m[4].centre.x == 7 && m[4].centre.y == 8);
  const int32_t low = INT32_MIN + 65536, side = GJK2_RADIUS_MAX / 2;
  const gjk2_vec far[4] = {{low, low}, {low + side, low}, {low + side, low + side}, {low, low + side}};
  const gjk2_shape large = GJK2_ROUNDED_POLYGON(far, 4, GJK2_RADIUS_MAX / 2),
                   box = GJK2_ROUNDED_BOX(side / 2, side / 2, GJK2_RADIUS_MAX / 2),
                   over = GJK2_ROUNDED_POLYGON(far, 4, GJK2_RADIUS_MAX);
  gjk2_mass one, two;
  CHECK(side % 2 == 0);
  CHECK(gjk2_mass_of_shape(&large, &one) == GJK_OK && gjk2_mass_of_shape(&box, &two) == GJK_OK && are_near(&one, &two));
  CHECK(one.centre.x == low + side / 2 && one.fraction[0] == 0 && one.fraction[1] == 0);
  CHECK(gjk2_mass_of_shape(&over, &one) == GJK_ERROR_SIZE && one.centre.x == low + side / 2);
}

int main(void) {
  const uint64_t seed = check_seed(57);
  test_random(seed);
  test_closed_forms();
  test_triangles();
  return check_done("plane mass round");
}
