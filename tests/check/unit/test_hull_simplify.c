// Simple hulls: all points inside exactly, few enough vertices, and the stated excess never less than the true one.
#include "gjk/collider.h"
#include "gjk/distance.h"
#include "hull_points.h"

static hull_points p, simple;
static hull_output out, full;
static uint32_t workspace[GJK_HULL_SIMPLIFY_WORKSPACE(HULL_POINTS) / 4];

// The largest distance of a vertex of the simple hull from the hull of all points, by GJK.
static int64_t true_excess(void) {
  const gjk_shape hull = GJK_HULL(full.vertex, full.hull.vertices), point = GJK_POINT;
  static gjk_vec3 buffer[HULL_POINTS];
  gjk_collider a = {0}, b = {0};
  gjk_pose pose = GJK_POSE_IDENTITY;
  int64_t most = 0;
  if (gjk_collider_init(&a, &hull, buffer, HULL_POINTS) != GJK_OK) {
    return 0;  // beyond the size of shapes
  }
  CHECK(gjk_collider_pose(&a, &pose) == GJK_OK && gjk_collider_init(&b, &point, NULL, 0) == GJK_OK);
  for (unsigned i = 0; i < simple.count; i++) {
    gjk_distance_result gap = {0};
    pose.position = simple.point[i];
    CHECK(gjk_collider_pose(&b, &pose) == GJK_OK && gjk_distance(&a, &b, NULL, &gap) == GJK_OK);
    most = gap.distance > most ? gap.distance : most;
  }
  return most;
}

// Is every point within or on all planes of the simple hull? By gjk_hull_check, which looks at all vertices.
static bool encloses(void) {
  static gjk_vec3 all[2 * HULL_POINTS];
  gjk_hull_report report;
  if (out.hull.dimension < 3) {
    return out.hull.vertices == full.hull.vertices &&
           memcmp(out.vertex, full.vertex, out.hull.vertices * sizeof out.vertex[0]) == 0;
  }
  memcpy(all, out.vertex, out.hull.vertices * sizeof all[0]);
  memcpy(all + out.hull.vertices, p.point, p.count * sizeof all[0]);
  CHECK(gjk_hull_check(all, (uint16_t)(out.hull.vertices + p.count), &out.faces, &report) == GJK_OK);
  return report.fault == GJK_HULL_SOUND;
}

// Simplifies and checks all that is promised. Returns the excess.
static uint32_t check_simple(uint16_t most) {
  gjk_hull_simple result;
  const size_t bytes = GJK_HULL_SIMPLIFY_WORKSPACE(p.count);
  memset(workspace, 0xA5, sizeof workspace);
  const gjk_status status = gjk_hull_simplify(p.point, p.count, most, workspace, bytes, simple.point, &result);
  CHECK_MSG(status == GJK_OK, "status %d of %u, at most %u", status, p.count, most);
  size_t end = sizeof workspace / 4;
  while (end > bytes / 4 && workspace[end - 1] == UINT32_C(0xA5A5A5A5)) {
    end--;
  }
  CHECK(end == bytes / 4);
  if (status != GJK_OK) {
    return 0;
  }
  simple.count = result.vertices;
  hull_output_make(&simple, &out);
  CHECK_MSG(result.vertices <= most && result.vertices == out.hull.vertices, "%u of %u", result.vertices, most);
  CHECK(encloses());
  CHECK((result.excess == 0) == (full.hull.vertices <= most));
  const int64_t excess = true_excess();
  CHECK_MSG(excess <= (int64_t)result.excess, "excess %lld, not %lu", (long long)excess, (unsigned long)result.excess);
  CHECK_MSG(full.hull.dimension < 3 || excess == 0 || excess + 2 >= (int64_t)result.excess, "excess %lld, stated %lu",
            (long long)excess, (unsigned long)result.excess);
  if (full.hull.vertices <= most) {
    CHECK(result.vertices == full.hull.vertices &&
          memcmp(simple.point, full.vertex, result.vertices * sizeof full.vertex[0]) == 0);
  }
  return result.excess;
}

static void make_sphere(random_state *random, uint16_t count, int32_t radius, int32_t flat) {
  p.count = 0;
  while (p.count < count) {
    const int32_t x = random_range(random, -1000, 1000), y = random_range(random, -1000, 1000),
                  z = random_range(random, -1000, 1000), squared = x * x + y * y + z * z;
    if (squared <= 1000000 && squared >= 900000) {
      hull_points_add(&p, x * (radius / 1000), y * (radius / 1000), z * (radius / 1000) / flat);
    }
  }
}

static void test_spheres(uint64_t seed) {
  static const uint16_t most[] = {4, 5, 8, 12, 16, 32, 64, 200};
  // Of points on a sphere. Of the sphere itself 32 vertices can do with 0.084 of its radius: those of an icosahedron and of a
  // dodecahedron, whose circles of 22.69 degrees cover it.
  static const uint32_t limit[] = {230000, 230000, 56000, 39000, 22000, 11000, 4700, 200};
  random_state random = random_seed(seed);
  for (unsigned long trial = 0; trial < 6; trial++) {
    make_sphere(&random, (uint16_t)(trial < 3 ? 100 : 300), trial == 1 ? 200000000 : 65536, trial == 2 ? 64 : 1);
    check_trial(trial, NULL, NULL);
    hull_output_make(&p, &full);
    for (unsigned i = 0; i < sizeof most / sizeof most[0]; i++) {
      if (trial == 1 && most[i] < 8) {
        continue;  // a tetrahedron around a box of this size has no room
      }
      const uint32_t excess = check_simple(most[i]);
      if (trial == 3 && most[i] != 5) {
        printf("sphere of %u vertices, radius 65536: at most %u vertices, excess %lu\n", full.hull.vertices, most[i],
               (unsigned long)excess);
        CHECK_MSG(excess <= limit[i], "%u vertices reach %lu LSB beyond a sphere of 65536", most[i],
                  (unsigned long)excess);
      }
    }
  }
}

// Half spheres drawn out along an axis, to either side: vertices beyond their tips leave the size of hulls, and where that
// ends differs from axis to axis. So there is a hull that is small enough, or none.
static void test_room(uint64_t seed) {
  random_state random = random_seed(seed + 2);
  for (unsigned k = 0; k < 12; k++) {
    const int32_t far = k < 6 ? 900000000 : -900000000, up = k % 2 == 0 ? 1 : -1;
    make_sphere(&random, 60, 262000000, 1);
    for (uint16_t i = 0; i < p.count; i++) {
      int32_t at[3] = {p.point[i].x, p.point[i].y, p.point[i].z};
      for (unsigned axis = 0; axis < 3; axis++) {
        const int32_t half = at[axis] < 0 ? -at[axis] : at[axis];
        at[axis] = axis == k / 2 % 3 ? up * (half + half / 4 * 3 - 200000000) - far : at[axis] / 64 + far;
      }
      p.point[i] = (gjk_vec3){at[0], at[1], at[2]};
    }
    check_trial(k, hull_points_print, &p);
    for (uint16_t most = 4; most < 8; most++) {
      gjk_hull_simple result = {0, 0};
      const gjk_status status =
          gjk_hull_simplify(p.point, p.count, most, workspace, sizeof workspace, simple.point, &result);
      simple.count = result.vertices;
      CHECK(status == GJK_OK || status == GJK_ERROR_RANGE);
      if (status == GJK_OK) {
        hull_output_make(&simple, &out);
      }
    }
  }
}

// Points from 0 to 10 along each axis, whose simple hull does not leave that. So it is the same where this is an end of int32.
static void test_ends(void) {
  static const int32_t some[3][3] = {{3, 8, 0}, {7, 5, 2}, {9, 9, 1}};
  static gjk_vec3 middle[8];
  for (unsigned k = 0; k < 7; k++) {
    int32_t at[3] = {0, 0, 0};
    if (k > 0) {
      at[(k - 1) / 2] = k % 2 == 0 ? INT32_MIN : INT32_MAX - 10;
    }
    p.count = 0;
    for (unsigned i = 0; i < 9; i++) {
      const int32_t x = some[i / 3][i % 3], y = some[i / 3][(i + 1) % 3], z = some[i / 3][(i + 2) % 3];
      hull_points_add(&p, at[0] + x, at[1] + y, at[2] + z);
      hull_points_add(&p, at[0] + 10 - x, at[1] + 10 - y, at[2] + 10 - z);
    }
    check_trial(k, hull_points_print, &p);
    hull_output_make(&p, &full);
    check_simple(8);
    for (unsigned i = 0; i < simple.count; i++) {
      simple.point[i].x -= at[0];
      simple.point[i].y -= at[1];
      simple.point[i].z -= at[2];
    }
    CHECK(simple.count == 6 && (k == 0 || memcmp(middle, simple.point, 6 * sizeof middle[0]) == 0));
    memcpy(middle, simple.point, 6 * sizeof middle[0]);
  }
}

static void test_random(uint64_t seed) {
  random_state random = random_seed(seed + 1);
  unsigned same = 0, fewer = 0, flat = 0, boxed = 0;
  for (unsigned long trial = 0; trial < 1500; trial++) {
    const int32_t size = INT32_C(2) << random_below(&random, 26), thick = size >> random_below(&random, 28);
    const int32_t at = random_range(&random, -1000000000, 1000000000);
    p.count = 0;
    const uint32_t count = 1 + random_below(&random, 40);
    for (uint32_t i = 0; i < count; i++) {
      const int32_t x = random_range(&random, -size, size);
      hull_points_add(&p, at + x, random_range(&random, -size, size) - at,
                      at + random_range(&random, -thick, thick) + (trial % 3 == 0 ? x / 2 : 0));
    }
    check_trial(trial, hull_points_print, &p);
    hull_output_make(&p, &full);
    const uint16_t most = (uint16_t)(4 + random_below(&random, 16));
    if (most < 8 && size > (INT32_C(1) << 25)) {
      continue;
    }
    check_simple(most);
    flat += full.hull.dimension < 3;
    same += full.hull.vertices <= most;
    fewer += full.hull.vertices > most;
    boxed += full.hull.vertices > most && simple.count == 8;
    const hull_points kept = simple;
    hull_points_shuffle(&p, &random);
    check_simple(most);
    CHECK(kept.count == simple.count && memcmp(kept.point, simple.point, kept.count * sizeof kept.point[0]) == 0);
  }
  CHECK_MSG(same > 300 && fewer > 300 && flat > 30, "%u %u %u", same, fewer, flat);
  printf("random: %u as they were, %u simplified, %u of these to 8 vertices\n", same, fewer, boxed);
}

// A fan of n triangles around an apex, flat or sharp, round in a plane across z.
static void make_cone(int32_t n, int32_t radius, int32_t height, bool both) {
  p.count = 0;
  for (int32_t i = 0; i < n; i++) {  // rational points of a circle, in its four quarters
    const int32_t t = 1000 * (i / 4) / (n / 4), c = (1000000 - t * t) / 1000, d = 2 * t, r = (1000000 + t * t) / 1000;
    const int32_t x = (int32_t)((int64_t)radius * c / r), y = (int32_t)((int64_t)radius * d / r);
    hull_points_add(&p,
                    i % 4 == 0   ? x
                    : i % 4 == 1 ? -y
                    : i % 4 == 2 ? -x
                                 : y,
                    i % 4 == 0   ? y
                    : i % 4 == 1 ? x
                    : i % 4 == 2 ? -y
                                 : -x,
                    0);
  }
  hull_points_add(&p, 0, 0, height);
  if (both) {
    hull_points_add(&p, 0, 0, -height);
  }
}

// Apexes with nearly as many triangles as there are vertices, needles and discs. Where they are neither, 33 vertices reach at
// most a 50th of the radius beyond; a box reaches 0.41 of it.
static void test_cones(void) {
  static const int32_t height[] = {30, 3000, 300000, 30000000};
  for (unsigned i = 0; i < 16; i++) {
    const int32_t radius = i < 8 ? 300000 : 3000;
    const bool sharp = height[i % 4] >= 100 * radius || 1000 * height[i % 4] <= radius;
    make_cone(80, radius, height[i % 4], i / 4 % 2 != 0);
    check_trial(i, hull_points_print, &p);
    hull_output_make(&p, &full);
    for (uint16_t most = 6; most < 70; most += 9) {
      const uint32_t excess = check_simple(most);
      if (sharp) {
        continue;
      }
      CHECK_MSG(most < 33 || excess <= (uint32_t)radius / 50, "%u vertices reach %lu beyond a cone of %ld", most,
                (unsigned long)excess, (long)radius);
    }
  }
}

// Grids, prisms, both ends of int32, points in a plane.
static void test_cases(void) {
  for (int corner = 0; corner < 2; corner++) {
    const int32_t side = 2 * GJK_RADIUS_MAX, low = corner == 0 ? INT32_MIN : INT32_MAX - side;
    p.count = 0;
    for (unsigned i = 0; i < 8; i++) {
      hull_points_add(&p, low + ((i & 1) != 0 ? side : 0), low + ((i & 2) != 0 ? side : 0),
                      low + ((i & 4) != 0 ? side : 0));
    }
    for (int32_t i = 0; i < 6; i++) {  // one corner cut off
      hull_points_add(&p, low + 9 - i, low + i * i, low);
    }
    p.point[0].x += 10;
    hull_output_make(&p, &full);
    check_trial((unsigned long)corner, hull_points_print, &p);
    check_simple(8);
    gjk_hull_simple result = {77, 88};
    CHECK(gjk_hull_simplify(p.point, p.count, 4, workspace, sizeof workspace, simple.point, &result) ==
              GJK_ERROR_RANGE &&
          result.vertices == 77 && result.excess == 88);
  }
  p.count = 0;
  for (int32_t i = 0; i < 30; i++) {  // a polygon in a plane
    hull_points_add(&p, i * 100, i * i * 10, i * 300 - 7);
  }
  check_trial(2, hull_points_print, &p);
  hull_output_make(&p, &full);
  CHECK(full.hull.dimension == 2);
  check_simple(4);
  check_simple(8);
  check_simple(30);
  for (int32_t i = 0; i < 30; i++) {  // its prism
    hull_points_add(&p, i * 100 + 5000, i * i * 10, i * 300 - 7);
  }
  check_trial(3, hull_points_print, &p);
  hull_output_make(&p, &full);
  for (uint16_t most = 4; most <= 61; most++) {
    check_simple(most);
  }
}

// Slivers: points that are beyond planes by less than what the rounded normals see of points in them. So a gain must be that
// of a point strictly beyond, or choosing points never ends.
static void test_slivers(void) {
  static const gjk_vec3 points[] = {
      {0, 1280, 368}, {-59662718, 197120, 34738704}, {34738706, 1048570, 0},  {-1, -32769, -1}, {-1673, -1, -1},
      {-1, -1, -1},   {-2097153, -1, 34738711},      {-32370158, 34738706, 0}};
  p.count = (uint16_t)(sizeof points / sizeof points[0]);
  memcpy(p.point, points, sizeof points);
  hull_output_make(&p, &full);
  for (uint16_t most = 4; most <= 7; most++) {
    check_simple(most);
  }
}

static void test_statuses(void) {
  gjk_hull_simple result = {77, 88};
  gjk_vec3 far[2] = {{0, 0, 0}, {INT32_MAX, 0, 0}};
  const size_t bytes = sizeof workspace;
  CHECK(gjk_hull_simplify(NULL, 1, 8, workspace, bytes, simple.point, &result) == GJK_ERROR_NULL);
  CHECK(gjk_hull_simplify(far, 1, 8, NULL, bytes, simple.point, &result) == GJK_ERROR_NULL);
  CHECK(gjk_hull_simplify(far, 1, 8, workspace, bytes, NULL, &result) == GJK_ERROR_NULL);
  CHECK(gjk_hull_simplify(far, 1, 8, workspace, bytes, simple.point, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_hull_simplify(far, 0, 8, workspace, bytes, simple.point, &result) == GJK_ERROR_EMPTY);
  CHECK(gjk_hull_simplify(far, 2, 8, workspace, bytes, simple.point, &result) == GJK_ERROR_SIZE);
  CHECK(gjk_hull_simplify(far, 1, 3, workspace, bytes, simple.point, &result) == GJK_ERROR_RANGE);
  CHECK(gjk_hull_simplify(far, 1, 8, (unsigned char *)workspace + 2, bytes - 2, simple.point, &result) ==
        GJK_ERROR_RANGE);
  CHECK(gjk_hull_simplify(far, 1, 8, workspace, GJK_HULL_SIMPLIFY_WORKSPACE(1) - 1, simple.point, &result) ==
        GJK_ERROR_CAPACITY);
  CHECK(result.vertices == 77 && result.excess == 88);
  CHECK(gjk_hull_simplify(far, 1, 4, workspace, GJK_HULL_SIMPLIFY_WORKSPACE(1), simple.point, &result) == GJK_OK);
  CHECK(result.vertices == 1 && result.excess == 0 && simple.point[0].x == 0);
}

int main(void) {
  const uint64_t seed = check_seed(271828);
  test_statuses();
  test_cases();
  test_spheres(seed);
  test_room(seed);
  test_ends();
  test_slivers();
  test_cones();
  test_random(seed);
  return check_done("hull simplify");
}
