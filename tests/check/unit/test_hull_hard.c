// Point sets that break hull builders with tolerances, with answers from geometry: clusters, sums, lattices under maps of
// determinant 1, polygons that are flat but for an LSB, as many points as fit. Then workspaces too small.
#include "hull_proof.h"

static hull_points p;
static hull_output out, again;
static random_state shuffle = {77};

// Builds, and again in other orders. Numbers of 0 are not known.
static void build(unsigned vertices, unsigned faces, unsigned edges) {
  hull_output_make(&p, &out);
  CHECK_MSG(out.hull.dimension == 3 && (vertices == 0 || out.hull.vertices == vertices) &&
                (faces == 0 || out.hull.faces == faces) && (edges == 0 || out.hull.edges == edges),
            "%d-D, %u vertices, %lu faces, %lu edges", out.hull.dimension, out.hull.vertices,
            (unsigned long)out.hull.faces, (unsigned long)out.hull.edges);
  for (unsigned i = 0; i < 3; i++) {
    hull_points_shuffle(&p, &shuffle);
    hull_output_make(&p, &again);
    CHECK(hull_output_equal(&out, &again));
  }
}

// Small grids at the corners of a large cube: all but eight points are coplanar with many.
static void test_clusters(void) {
  for (int32_t apart = 10; apart < 500000; apart *= 7) {
    check_trial((unsigned long)apart, hull_points_print, &p);
    p.count = 0;
    for (unsigned i = 0; i < 8 * 27; i++) {
      const unsigned at = i / 27, x = i % 3, y = i / 3 % 3, z = i / 9 % 3;
      hull_points_add(&p, (int32_t)x + ((at & 1) != 0 ? apart : 0), (int32_t)y + ((at & 2) != 0 ? apart : 0),
                      (int32_t)z + ((at & 4) != 0 ? apart : 0));
    }
    build(8, 6, 12);
    CHECK(out.hull.most_corners == 4);
    (void)hull_certify(&p, &out);
    const uint64_t side = (uint64_t)apart + 2;
    CHECK(out.volume.high == 0 && out.volume.low == 6 * side * side * side);
  }
}

// Sums of a prism over a polygon of a circle's rational points and of an octahedron: of n corners, which come in fours, that
// is a cylinder with a chamfer, whose facets have up to n corners.
static void test_sums(void) {
  static const int32_t circle[3][2] = {{25, 0}, {24, 7}, {15, 20}};
  for (int32_t ball = 1; ball <= 100; ball *= 10) {
    check_trial((unsigned long)ball, hull_points_print, &p);
    p.count = 0;
    for (unsigned i = 0; i < 3 * 8 * 2; i++) {
      const int32_t x = 100 * circle[i % 3][0], y = 100 * circle[i % 3][1];
      const int32_t cx = (i & 8) != 0 ? -x : x, cy = (i & 16) != 0 ? -y : y, cz = i >= 24 ? 3000 : -3000;
      for (unsigned j = 0; j < 6; j++) {
        const int32_t step = j % 2 == 0 ? ball : -ball;
        hull_points_add(&p, cx + (j / 2 == 0 ? step : 0), cy + (j / 2 == 1 ? step : 0), cz + (j / 2 == 2 ? step : 0));
      }
    }
    build(0, 0, 0);
    (void)hull_certify(&p, &out);
    CHECK(out.hull.most_corners >= 8);
  }
}

// Products of shears: integers of up to 27 bits, determinant 1.
static void random_map(random_state *random, int32_t m[3][3]) {
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      m[i][j] = i == j ? 1 : 0;
    }
  }
  for (unsigned round = 0; round < 60; round++) {
    const unsigned to = random_below(random, 3), from = (to + 1 + random_below(random, 2)) % 3;
    const int32_t factor = random_range(random, -3, 3);
    int64_t row[3], most = 0;
    for (int j = 0; j < 3; j++) {
      row[j] = m[to][j] + (int64_t)factor * m[from][j];
      most = row[j] > most ? row[j] : -row[j] > most ? -row[j] : most;
    }
    for (int j = 0; j < 3 && most < (1 << 26) / 8; j++) {
      m[to][j] = (int32_t)row[j];
    }
  }
}

// A map of determinant 1 keeps volumes, facets and edges, and takes vertices to vertices. The smallest heights of its points
// over planes of theirs are 1, in products of 80 bits.
static void test_maps(void) {
  static hull_points before;
  static hull_output simple;
  random_state random = random_seed(check_seed(31337));
  unsigned large = 0;
  for (unsigned long trial = 0; trial < check_trials(2000); trial++) {
    int32_t m[3][3];
    check_trial(trial, hull_points_print, &p);
    random_map(&random, m);
    before.count = p.count = 0;
    for (uint32_t n = 5 + random_below(&random, 30); before.count < n;) {
      const int32_t x = random_range(&random, -2, 2), y = random_range(&random, -2, 2),
                    z = random_range(&random, -2, 2);
      hull_points_add(&before, x, y, z);
      hull_points_add(&p, m[0][0] * x + m[0][1] * y + m[0][2] * z, m[1][0] * x + m[1][1] * y + m[1][2] * z,
                      m[2][0] * x + m[2][1] * y + m[2][2] * z);
    }
    for (int i = 0; i < 3; i++) {
      large += m[i][0] > (1 << 20) || m[i][0] < -(1 << 20);
    }
    hull_output_make(&before, &simple);
    hull_output_make(&p, &out);
    CHECK(out.hull.dimension == simple.hull.dimension && out.hull.vertices == simple.hull.vertices &&
          out.hull.faces == simple.hull.faces && out.hull.edges == simple.hull.edges &&
          out.hull.most_corners == simple.hull.most_corners);
    CHECK(out.volume.high == 0 && out.volume.low == simple.volume.low);
    for (unsigned i = 0; i < simple.hull.vertices; i++) {
      const gjk_vec3 v = simple.vertex[i];
      const int32_t x = m[0][0] * v.x + m[0][1] * v.y + m[0][2] * v.z,
                    y = m[1][0] * v.x + m[1][1] * v.y + m[1][2] * v.z,
                    z = m[2][0] * v.x + m[2][1] * v.y + m[2][2] * v.z;
      bool found = false;
      for (unsigned j = 0; j < out.hull.vertices; j++) {
        found = found || (out.vertex[j].x == x && out.vertex[j].y == y && out.vertex[j].z == z);
      }
      CHECK(found);
    }
  }
  CHECK(large > check_trials(2000) / 2);
}

// Corners of a polygon in a leaning plane, and one point an LSB above or below it: a pyramid, as flat as can be.
static void test_flat(void) {
  for (int32_t n = 3; n <= 100; n++) {
    for (int32_t off = -1; off <= 1; off += 2) {
      check_trial((unsigned long)n, hull_points_print, &p);
      p.count = 0;
      for (int32_t i = 0; i < n; i++) {  // on a parabola, so all are extreme; z = 2 x + 3 y
        hull_points_add(&p, 100 * i, i * i, 2 * 100 * i + 3 * i * i);
      }
      hull_points_add(&p, 100, 2, 200 + 6 + off);  // above the inside of the polygon
      if (n > 3) {
        build((unsigned)n + 1, (unsigned)n + 1, 2u * (unsigned)n);
        CHECK(out.hull.most_corners == n);
        (void)hull_certify(&p, &out);
      }
    }
  }
}

// 65,535 points: a lattice under a paraboloid, all of them extreme, whose squares are facets; and 27 places again and again.
static void test_many(void) {
  static gjk_vec3 point[GJK_HULL_POINTS_MAX], vertex[GJK_HULL_POINTS_MAX];
  static uint32_t workspace[GJK_HULL_WORKSPACE(GJK_HULL_POINTS_MAX) / 4];
  static uint16_t corner[GJK_HULL_POINTS_MAX], end[GJK_HULL_POINTS_MAX];
  gjk_hull hull;
  gjk_hull_faces faces;
  gjk_hull_volume volume;
  for (int32_t i = 0; i < GJK_HULL_POINTS_MAX; i++) {
    const int32_t k = (int32_t)((int64_t)i * 40507 % GJK_HULL_POINTS_MAX), x = k % 255, y = k / 255;
    point[i].x = x;
    point[i].y = y;
    point[i].z = x * x + y * y;
  }
  CHECK(gjk_hull_build(point, GJK_HULL_POINTS_MAX, workspace, sizeof workspace, &hull) == GJK_OK);
  CHECK(hull.dimension == 3 && hull.vertices == GJK_HULL_POINTS_MAX);
  CHECK(hull.faces - hull.edges + hull.vertices == 2);
  // Below, the four corners of each square of the lattice are in one plane. Each side of the lattice is a facet, a polygon
  // within a parabola, and so are its four corners, above.
  CHECK_MSG(hull.faces == 254 * 256 + 5, "%lu faces", (unsigned long)hull.faces);
  CHECK(gjk_hull_vertices(&hull, vertex, GJK_HULL_POINTS_MAX) == GJK_OK);
  for (uint32_t i = 0; i < GJK_HULL_POINTS_MAX; i++) {
    CHECK(vertex[i].x == (int32_t)(i / 257) && vertex[i].y == (int32_t)(i % 257));
  }
  CHECK(gjk_hull_write_faces(&hull, corner, GJK_HULL_POINTS_MAX, end, GJK_HULL_POINTS_MAX, &faces) ==
        GJK_ERROR_CAPACITY);
  for (uint32_t i = 0; i < GJK_HULL_POINTS_MAX; i++) {
    point[i].x = (int32_t)(i % 3) * 1000;
    point[i].y = (int32_t)(i / 3 % 3) * 1000;
    point[i].z = (int32_t)(i / 9 % 3) * 1000;
  }
  CHECK(gjk_hull_build(point, GJK_HULL_POINTS_MAX, workspace, sizeof workspace, &hull) == GJK_OK);
  CHECK(hull.vertices == 8 && hull.faces == 6 && hull.edges == 12 && gjk_hull_get_volume(&hull, &volume) == GJK_OK &&
        volume.low == UINT64_C(48000000000) && volume.high == 0);
}

// A workspace of 40 bytes a point and 40 is enough, and nothing beyond it is touched; any smaller one is refused, and then
// nothing is.
static void test_workspaces(void) {
  static uint32_t workspace[GJK_HULL_WORKSPACE(64) / 4 + 8];
  random_state random = random_seed(check_seed(4));
  CHECK(GJK_HULL_WORKSPACE(64) == 2600 && GJK_HULL_WORKSPACE(0) == 40);
  for (uint16_t count = 1; count <= 64; count++) {
    const size_t need = GJK_HULL_WORKSPACE(count);
    gjk_hull hull;
    p.count = 0;
    while (p.count < count) {  // near a sphere
      const int32_t x = random_range(&random, -100, 100), y = random_range(&random, -100, 100);
      const int32_t z = random_range(&random, -100, 100), squared = x * x + y * y + z * z;
      if (squared > 9000 && squared < 10000) {
        hull_points_add(&p, x, y, z);
      }
    }
    memset(workspace, 0xA5, sizeof workspace);
    hull.vertices = 4711;
    hull.faces = 4712;
    for (size_t bytes = 0; bytes < need; bytes++) {
      CHECK(gjk_hull_build(p.point, count, workspace, bytes, &hull) == GJK_ERROR_CAPACITY);
    }
    CHECK(hull.vertices == 4711 && hull.faces == 4712 && workspace[0] == UINT32_C(0xA5A5A5A5));
    CHECK(gjk_hull_build(p.point, count, workspace, need, &hull) == GJK_OK);
    CHECK(workspace[need / 4] == UINT32_C(0xA5A5A5A5));
  }
}

int main(void) {
  test_clusters();
  test_sums();
  test_maps();
  test_flat();
  test_many();
  test_workspaces();
  return check_done("hull hard");
}
