// Mass properties of rounded hulls, triangles, segments and cones: closed forms; bodies cut in two, whose moments add up;
// and what turning, moving and renumbering must not change.
#include <math.h>
#include <stdlib.h>

#include "gjk/mass.h"
#include "hull_points.h"

typedef long double real;

static hull_points p;
static hull_output out;

static real volume_of(const gjk_mass *m) {
  return ldexpl((real)m->volume.high, 64) + (real)m->volume.low;
}

static int64_t centre_of(const gjk_mass *m, int i) {
  return (i == 0 ? m->centre.x : i == 1 ? m->centre.y : m->centre.z) * INT64_C(65536) + m->fraction[i];
}

static void entries_of(const gjk_mass *m, int64_t entry[6]) {
  const int64_t all[6] = {m->inertia.xx, m->inertia.yy, m->inertia.zz, m->inertia.yz, m->inertia.zx, m->inertia.xy};
  memcpy(entry, all, sizeof all);
}

// Volumes, centres and inertias that differ by no more than two correct roundings do, and 2^-55 of the volume.
static void check_near(const gjk_mass *a, const gjk_mass *b) {
  int64_t x[6], y[6];
  entries_of(a, x);
  entries_of(b, y);
  CHECK_MSG(fabsl(volume_of(a) - volume_of(b)) <= 1 + 0x1p-55L * volume_of(a), "volume %Lg, %Lg", volume_of(a),
            volume_of(b));
  for (int i = 0; i < 6; i++) {
    CHECK_MSG(llabs(x[i] - y[i]) <= 1, "entry %d: %lld, %lld", i, (long long)x[i], (long long)y[i]);
  }
  for (int i = 0; i < 3; i++) {
    CHECK_MSG(llabs(centre_of(a, i) - centre_of(b, i)) <= 1, "centre %d", i);
  }
}

static gjk_shape shape_of_output(int32_t radius) {
  const gjk_shape shape =
      GJK_ROUNDED_HULL_WITH_FACES(out.vertex, out.hull.vertices, out.faces.count > 0 ? &out.faces : NULL, radius);
  return shape;
}

// The rounded hull of the points. False: it is too large.
static bool mass_of_points(int32_t radius, gjk_mass *m) {
  hull_output_make(&p, &out);
  const gjk_shape shape = shape_of_output(radius);
  const gjk_status status = gjk_mass_of_shape(&shape, m);
  CHECK_MSG(status == GJK_OK || status == GJK_ERROR_SIZE, "status %d", status);
  return status == GJK_OK;
}

// Boxes of 0 to 3 dimensions as hulls; capsules along all axes; the centre is exact.
static void test_boxes(void) {
  random_state random = {3};
  unsigned flat = 0, solid = 0;
  for (unsigned long trial = 0; trial < 400; trial++) {
    int32_t half[3];
    gjk_mass m, n;
    for (int i = 0; i < 3; i++) {
      half[i] = random_below(&random, 4) == 0
                    ? 0
                    : (int32_t)random_below(&random, UINT32_C(1) << (1 + random_below(&random, 26)));
    }
    const int32_t r = 1 + (int32_t)random_below(&random, UINT32_C(1) << (1 + random_below(&random, 26)));
    const int32_t at[3] = {random_range(&random, -1000, 1000), random_range(&random, -1000000000, 1000000000), 5};
    p.count = 0;
    check_trial(trial, hull_points_print, &p);
    for (unsigned i = 0; i < 8; i++) {
      hull_points_add(&p, at[0] + ((i & 1) != 0 ? half[0] : -half[0]), at[1] + ((i & 2) != 0 ? half[1] : -half[1]),
                      at[2] + ((i & 4) != 0 ? half[2] : -half[2]));
    }
    const gjk_shape box = GJK_ROUNDED_BOX(half[0], half[1], half[2], r);
    if (!mass_of_points(r, &m)) {
      continue;
    }
    CHECK(gjk_mass_of_shape(&box, &n) == GJK_OK && m.mass == 0);
    for (int i = 0; i < 3; i++) {
      CHECK(centre_of(&m, i) == at[i] * INT64_C(65536));
    }
    n.centre.x = at[0];
    n.centre.y = at[1];
    n.centre.z = at[2];
    check_near(&m, &n);
    flat += out.hull.dimension == 2;
    solid += out.hull.dimension == 3;
  }
  CHECK_MSG(flat > 50 && solid > 50, "%u %u", flat, solid);
}

static void random_points(random_state *random, int32_t size) {
  const uint32_t kind = random_below(random, 6), count = 1 + random_below(random, 14);
  const int32_t thick = size >> random_below(random, 20), slope = random_range(random, -1, 1);
  p.count = 0;
  for (uint32_t i = 0; i < count; i++) {
    const int32_t x = random_range(random, -size, size), y = kind == 0 ? x : random_range(random, -size, size);
    hull_points_add(&p, x, y, slope * (x / 2) + (kind <= 2 ? 0 : random_range(random, -thick, thick)));
  }
}

// x to y, y to z, z to x; or moved; or in another order.
static void test_symmetries(uint64_t seed) {
  random_state random = random_seed(seed);
  unsigned dimensions[4] = {0, 0, 0, 0}, tiny = 0, huge = 0;
  for (unsigned long trial = 0; trial < 200; trial++) {
    const int32_t size = INT32_C(1) << random_below(&random, 26);
    const int32_t r = 1 + (int32_t)random_below(&random, UINT32_C(1) << random_below(&random, 27));
    gjk_mass m, n, turned;
    random_points(&random, size);
    check_trial(trial, hull_points_print, &p);
    if (!mass_of_points(r, &m)) {
      continue;
    }
    dimensions[out.hull.dimension]++;
    tiny += r < size / 256;
    huge += r / 256 > size;
    for (unsigned i = 0; i < p.count; i++) {
      const gjk_vec3 v = p.point[i];
      p.point[i].x = v.z + 7;
      p.point[i].y = v.x - 9;
      p.point[i].z = v.y;
    }
    CHECK(mass_of_points(r, &turned));
    n = m;
    n.centre.x = m.centre.z + 7;
    n.centre.y = m.centre.x - 9;
    n.centre.z = m.centre.y;
    n.fraction[0] = m.fraction[2];
    n.fraction[1] = m.fraction[0];
    n.fraction[2] = m.fraction[1];
    n.inertia.xx = m.inertia.zz;
    n.inertia.yy = m.inertia.xx;
    n.inertia.zz = m.inertia.yy;
    n.inertia.yz = m.inertia.xy;
    n.inertia.zx = m.inertia.yz;
    n.inertia.xy = m.inertia.zx;
    check_near(&turned, &n);
  }
  CHECK_MSG(
      dimensions[0] > 5 && dimensions[1] > 10 && dimensions[2] > 20 && dimensions[3] > 60 && tiny > 20 && huge > 20,
      "%u %u %u %u, %u %u", dimensions[0], dimensions[1], dimensions[2], dimensions[3], tiny, huge);
}

// The integrals over a body about the frame's origin: volume, first, second.
static void add_integrals(const gjk_mass *m, real sign, real sum[10]) {
  const real v = volume_of(m);
  int64_t entry[6];
  entries_of(m, entry);
  real c[3], half = 0;
  sum[0] += sign * v;
  for (int i = 0; i < 3; i++) {
    c[i] = centre_of(m, i) / 65536.0L + 0x1p-17L;
    sum[1 + i] += sign * v * c[i];
    half += entry[i] / 2.0L;
  }
  for (int i = 0; i < 3; i++) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    sum[4 + i] += sign * v * (half - entry[i] + c[i] * c[i]);
    sum[7 + i] += sign * v * (-entry[i + 3] + c[j] * c[k]);
  }
}

static bool mass_of(const gjk_vec3 *v, const unsigned number[4], unsigned count, int32_t r, gjk_mass *m) {
  p.count = 0;
  for (unsigned i = 0; i < count; i++) {
    hull_points_add(&p, v[number[i]].x, v[number[i]].y, v[number[i]].z);
  }
  return mass_of_points(r, m);
}

// Two tetrahedra on both sides of a triangle, whose union is convex: the integrals over the rounded union, and over the
// rounded triangle in which they meet, add up to those over both.
static void test_cut(uint64_t seed) {
  random_state random = random_seed(seed + 1);
  static const unsigned both[5] = {0, 1, 2, 3, 4}, above[4] = {0, 1, 2, 3}, below[4] = {0, 1, 2, 4};
  unsigned convex = 0;
  for (unsigned long trial = 0; trial < 300; trial++) {
    const int32_t size = INT32_C(1) << (3 + random_below(&random, 22)),
                  r = 1 + (int32_t)random_below(&random, (uint32_t)size);
    gjk_vec3 v[5];
    gjk_mass m[4];
    for (int i = 0; i < 3; i++) {
      v[i].x = random_range(&random, -size, size);
      v[i].y = random_range(&random, -size, size);
      v[i].z = 0;
    }
    for (int i = 3; i < 5; i++) {
      v[i].x = (v[0].x + v[1].x + v[2].x) / 3 + random_range(&random, -size / 8, size / 8);
      v[i].y = (v[0].y + v[1].y + v[2].y) / 3 + random_range(&random, -size / 8, size / 8);
      v[i].z = (i == 3 ? 1 : -1) * random_range(&random, 1, size);
    }
    check_trial(trial, hull_points_print, &p);
    if (!mass_of(v, both, 5, r, &m[0]) || out.hull.dimension < 3) {
      continue;
    }
    // Does the line from 3 to 4 pass within the triangle? Then all of its sides are on the same side of the place.
    int sides = 0;
    const real t = (real)v[3].z / ((real)v[3].z - v[4].z), x = v[3].x + t * ((real)v[4].x - v[3].x),
               y = v[3].y + t * ((real)v[4].y - v[3].y);
    for (int i = 0; i < 3; i++) {
      const gjk_vec3 a = v[i], b = v[(i + 1) % 3];
      sides += ((real)b.x - a.x) * (y - a.y) - ((real)b.y - a.y) * (x - a.x) > 0 ? 1 : -1;
    }
    if (abs(sides) != 3) {
      continue;
    }
    convex++;
    CHECK(mass_of(v, above, 4, r, &m[1]) && mass_of(v, below, 4, r, &m[2]) && mass_of(v, both, 3, r, &m[3]));
    real sum[10] = {0};
    for (int i = 0; i < 4; i++) {
      add_integrals(&m[i], i == 1 || i == 2 ? 1 : -1, sum);
    }
    const real v0 = volume_of(&m[0]), reach = 4.0L * size + r;
    CHECK_MSG(fabsl(sum[0]) <= 2.1L + 0x1p-55L * v0, "volume %Lg of %Lg", sum[0], v0);
    for (int i = 1; i < 10; i++) {
      // Each centre is known to 2^-17, each inertia to 0.51, each volume to half a unit.
      const real most = i < 4 ? v0 * (0x1p-15L + 0x1p-55L * reach) + 3 * reach
                              : v0 * (4 + 0x1p-14L * reach + 0x1p-54L * reach * reach) + 3 * reach * reach;
      CHECK_MSG(fabsl(sum[i]) <= most, "integral %d: %Lg, %Lg", i, sum[i], most);
    }
  }
  CHECK_MSG(convex > 60, "%u", convex);
}

// Triangles by themselves, in either order, and in a line; sides in a file of faces; unsound faces.
static void test_few(void) {
  static const gjk_vec3 right[3] = {{0, 0, 0}, {400, 0, 0}, {0, 300, 0}},
                        left[3] = {{0, 0, 0}, {0, 300, 0}, {400, 0, 0}}, line[3] = {{5, 5, 0}, {1, 1, 0}, {9, 9, 0}},
                        same[3] = {{7, 8, 9}, {7, 8, 9}, {7, 8, 9}};
  const gjk_shape shape[6] = {GJK_ROUNDED_TRIANGLE(right, 50),   GJK_ROUNDED_TRIANGLE(left, 50),
                              GJK_ROUNDED_HULL(right, 3, 50),    GJK_ROUNDED_TRIANGLE(line, 50),
                              GJK_ROUNDED_HULL(line + 1, 2, 50), GJK_ROUNDED_TRIANGLE(same, 50)};
  gjk_mass m[6];
  for (int i = 0; i < 6; i++) {
    CHECK(gjk_mass_of_shape(&shape[i], &m[i]) == GJK_OK);
  }
  check_near(&m[0], &m[1]);
  check_near(&m[0], &m[2]);
  check_near(&m[3], &m[4]);
  CHECK(m[3].centre.x == 5 && m[3].fraction[0] == 0);
  // area 60000: 2 r A + perimeter pi r^2 / 2 + 4 pi / 3 r^3
  CHECK(m[0].volume.low == 6000000 + 4712389 + 523599 && m[0].volume.high == 0);
  CHECK(m[5].volume.low == 523599 && m[5].inertia.xx == 1000 && m[5].inertia.xy == 0 && m[5].centre.z == 9);
  const gjk_shape ball = GJK_SPHERE(70), round = GJK_ROUNDED_ELLIPSOID(30, 30, 30, 40);
  CHECK(gjk_mass_of_shape(&ball, &m[1]) == GJK_OK && gjk_mass_of_shape(&round, &m[2]) == GJK_OK);
  check_near(&m[1], &m[2]);
  static const gjk_vec3 v[4] = {{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {0, 0, 9}};
  static const uint16_t inward[12] = {0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0}, open[9] = {0, 2, 1, 0, 1, 3, 1, 2, 3},
                        end[4] = {3, 6, 9, 12};
  // A face whose other side is outside, after one with the first corner; a triangle's two faces four times each.
  static const gjk_vec3 w[4] = {{0, 9, 0}, {9, 0, 0}, {0, 0, 0}, {0, 0, -9}};
  static const uint16_t across[9] = {2, 1, 0, 0, 1, 3, 2, 0, 3}, again[9] = {2, 1, 0, 1, 0, 3, 2, 0, 3},
                        often[24] = {0, 1, 2, 0, 2, 1, 0, 1, 2, 0, 2, 1, 0, 1, 2, 0, 2, 1, 0, 1, 2, 0, 2, 1},
                        ends[8] = {3, 6, 9, 12, 15, 18, 21, 24};
  const gjk_hull_faces turned = {inward, end, 4}, missing = {open, end, 3}, behind = {across, end, 3},
                       before = {again, end, 3}, repeated = {often, ends, 8};
  const gjk_shape unsound[5] = {
      GJK_ROUNDED_HULL_WITH_FACES(v, 4, &turned, 1), GJK_ROUNDED_HULL_WITH_FACES(v, 4, &missing, 1),
      GJK_ROUNDED_HULL_WITH_FACES(w, 4, &behind, 1), GJK_ROUNDED_HULL_WITH_FACES(w, 4, &before, 1),
      GJK_ROUNDED_HULL_WITH_FACES(v, 3, &repeated, 1 << 20)};
  for (int i = 0; i < 5; i++) {
    memcpy(&m[1], &m[0], sizeof m[0]);
    CHECK(gjk_mass_of_shape(&unsound[i], &m[1]) == GJK_ERROR_RANGE && memcmp(&m[0], &m[1], sizeof m[0]) == 0);
  }
}

#define STEPS 200000

// A cone by rings: at z its radius is that of the cone, of the ball around the apex, or of the ring around the base, whichever
// is largest of those that the place has.
static real radius_at(real a, real h, real r, real z) {
  const real s = sqrtl(a * a + h * h), nz = a / s, nw = h / s;  // the side's normal: up, outwards
  real w = 0;
  if (z - h <= r && z - h >= r * nz) {
    w = fmaxl(w, sqrtl(fmaxl(0, r * r - (z - h) * (z - h))));
  }
  if (z <= h + r * nz && z >= r * nz) {  // on the side, moved by r
    w = fmaxl(w, r * nw + a - (z - r * nz) * a / h);
  }
  if (z <= r * nz) {
    w = fmaxl(w, a + sqrtl(fmaxl(0, r * r - z * z)));
  }
  return w;
}

static void test_cones(void) {
  static const int32_t size[][3] = {{30000, 50000, 7000},
                                    {50000, 100, 9000},
                                    {3, 40000, 20000},
                                    {60000000, 50000000, 90000000},
                                    {80000000, 90000000, 1},
                                    {1, 1, 70000},
                                    {0, 5000, 600},
                                    {5000, 0, 600},
                                    {0, 0, 900}};
  for (unsigned i = 0; i < sizeof size / sizeof size[0]; i++) {
    const real a = size[i][0], h = 2.0L * size[i][1], r = size[i][2];
    const gjk_shape shape = GJK_ROUNDED_CONE(size[i][0], size[i][1], size[i][2]);
    gjk_mass m, n;
    check_trial(i, NULL, NULL);
    CHECK(gjk_mass_of_shape(&shape, &m) == GJK_OK);
    CHECK(m.centre.x == 0 && m.centre.y == 0 && m.fraction[0] == 0 && m.fraction[1] == 0 &&
          m.inertia.xx == m.inertia.yy);
    CHECK(m.inertia.yz == 0 && m.inertia.zx == 0 && m.inertia.xy == 0 && m.mass == 0);
    if (i >= 6) {  // a capsule, a disc, a ball
      const gjk_shape same = i == 6 ? (gjk_shape)GJK_CAPSULE(600, 5000) : (gjk_shape)GJK_ROUNDED_CYLINDER(5000, 0, 600),
                      ball = GJK_SPHERE(900);
      CHECK(gjk_mass_of_shape(i == 8 ? &ball : &same, &n) == GJK_OK);
      check_near(&m, &n);
      continue;
    }
    const real pi = acosl(-1.0L);
    real volume = 0, first = 0, up = 0, across = 0;
    for (int j = 0; j < STEPS; j++) {  // z by a cosine, so that the ends are smooth
      const real t = (j + 0.5L) * pi / STEPS, z = h / 2 - (h / 2 + r) * cosl(t), w = radius_at(a, h, r, z),
                 area = pi * w * w * (h / 2 + r) * sinl(t) * pi / STEPS;
      volume += area;
      first += area * z;
      up += area * z * z;
      across += area * w * w / 4;
    }
    const real c = first / volume;
    CHECK_MSG(fabsl(volume_of(&m) / volume - 1) <= 1e-7L, "volume %Lg, %Lg", volume_of(&m), volume);
    CHECK_MSG(fabsl(centre_of(&m, 2) / 65536.0L - (c - h / 2)) <= 1e-7L * (h + r), "centre %Lg, %Lg",
              centre_of(&m, 2) / 65536.0L, c - h / 2);
    CHECK_MSG(fabsl((real)m.inertia.zz - 2 * across / volume) <= 0.6L + 1e-6L * across / volume, "zz %lld, %Lg",
              (long long)m.inertia.zz, 2 * across / volume);
    const real xx = (across + up) / volume - c * c;
    CHECK_MSG(fabsl((real)m.inertia.xx - xx) <= 0.6L + 1e-6L * xx, "xx %lld, %Lg", (long long)m.inertia.xx, xx);
  }
}

int main(void) {
  const uint64_t seed = check_seed(61);
  test_cones();
  test_boxes();
  test_symmetries(seed);
  test_cut(seed);
  test_few();
  return check_done("mass round");
}
