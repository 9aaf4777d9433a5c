// Meshes and height fields: limits of fields, what is refused, and bodies that slide over flat ground, which meet its normal
// alone. test_surface_brute.c, test_parts_order.c and test_height_field.c ask every triangle.
#include <math.h>

#include "check.h"
#include "generate/surface.h"
#include "gjk/height_field.h"
#include "gjk/surface.h"
#include "placed.h"
#include "reference/random_shape.h"

#define SEED UINT64_C(0x4D517279)
#define FOUND 200

static struct { unsigned long slides, manifolds; } tally;

// The largest and smallest fields that there may be, and what is just beyond.
static void check_limits(void) {
  static int16_t heights[2 * (GJK_HEIGHT_FIELD_SIDE_MAX + 1)];
  static const struct {
    uint16_t columns, rows;
    gjk_q16 step_x, step_y, step_z;
    bool right;
  } limits[] = {
      {2, 2, 1, 1, 1, true},
      {1, 2, 1, 1, 1, false},
      {2, 1, 1, 1, 1, false},
      {2, 2, 0, 1, 1, false},
      {2, 2, 1, 0, 1, false},
      {2, 2, 1, 1, 0, false},
      {2, 2, GJK_RADIUS_MAX, GJK_RADIUS_MAX, GJK_HEIGHT_FIELD_STEP_MAX, true},
      {2, 2, GJK_RADIUS_MAX + 1, 1, 1, false},
      {2, 2, 1, GJK_RADIUS_MAX + 1, 1, false},
      {2, 2, 1, 1, GJK_HEIGHT_FIELD_STEP_MAX + 1, false},
      {GJK_HEIGHT_FIELD_SIDE_MAX, 2, INT32_C(1) << 15, 1, 1, true},
      {2, GJK_HEIGHT_FIELD_SIDE_MAX, 1, INT32_C(1) << 15, 1, true},
      {GJK_HEIGHT_FIELD_SIDE_MAX + 1, 2, 1, 1, 1, false},
      {2, GJK_HEIGHT_FIELD_SIDE_MAX + 1, 1, 1, 1, false},
      {5, 2, INT32_C(1) << 28, 1, 1, false},  // a step beyond GJK_RADIUS_MAX
      {9, 2, INT32_C(1) << 27, 1, 1, true},   // 16384 units long
      {2, 9, 1, (INT32_C(1) << 27) + 1, 1, false},
  };
  for (unsigned i = 0; i < sizeof limits / sizeof *limits; i++) {
    const gjk_height_field field = GJK_HEIGHT_FIELD(heights, limits[i].columns, limits[i].rows, limits[i].step_x,
                                                    limits[i].step_y, limits[i].step_z);
    const gjk_parts parts = GJK_PARTS_OF_HEIGHT_FIELD(&field);
    const uint32_t count = 2 * (limits[i].columns - UINT32_C(1)) * (limits[i].rows - UINT32_C(1));
    CHECK_MSG(gjk_height_field_check(&field) == (limits[i].right ? GJK_OK : GJK_ERROR_RANGE), "limit %u", i);
    CHECK(gjk_parts_count(&parts) == (limits[i].right ? count : 0));
    // Down through the middle, against both axes.
    const int32_t x = (limits[i].columns - 1) * limits[i].step_x / 2, y = (limits[i].rows - 1) * limits[i].step_y / 2;
    const gjk_vec3 from = {x + 1, y + 1, GJK_Q16_ONE}, to = {x - 1, y - 1, -GJK_Q16_ONE};
    gjk_cast_result ray;
    CHECK(!limits[i].right ||
          (gjk_parts_cast_ray(&parts, &from, &to, NULL, &ray) == GJK_OK && ray.hit && ray.fraction == GJK_Q30_ONE / 2));
  }
}

static void check_refusals(void) {
  static int16_t heights[9];
  const gjk_height_field good = GJK_HEIGHT_FIELD(heights, 3, 3, 10, 10, 1);
  gjk_height_field bad = good;
  CHECK(gjk_height_field_check(&good) == GJK_OK && gjk_height_field_check(NULL) == GJK_ERROR_NULL);
  bad.columns = 1;
  CHECK(gjk_height_field_check(&bad) == GJK_ERROR_RANGE);
  bad = good;
  bad.step_x = 0;
  CHECK(gjk_height_field_check(&bad) == GJK_ERROR_RANGE);
  bad = good;
  bad.step_y = INT32_C(1) << 29;
  CHECK(gjk_height_field_check(&bad) == GJK_ERROR_RANGE);
  bad = good;
  bad.step_z = GJK_HEIGHT_FIELD_STEP_MAX + 1;
  CHECK(gjk_height_field_check(&bad) == GJK_ERROR_RANGE);
  const gjk_parts parts = GJK_PARTS_OF_HEIGHT_FIELD(&bad);
  static const gjk_shape ball = GJK_SPHERE(100);
  const gjk_pose pose = GJK_POSE_IDENTITY;
  gjk_decision decision;
  gjk_surface_contact contact[2];
  uint16_t count = 7;
  const gjk_collider body = posed(&ball, &pose);
  CHECK(gjk_parts_intersect(&parts, &body, NULL, &decision) == GJK_ERROR_EMPTY);
  const gjk_parts sound = GJK_PARTS_OF_HEIGHT_FIELD(&good);
  CHECK(gjk_surface_contacts(&sound, &body, -1, 4, NULL, contact, 2, &count) == GJK_ERROR_NEGATIVE);
  CHECK(gjk_surface_contacts(&sound, &body, GJK_RADIUS_MAX + 1, 4, NULL, contact, 2, &count) == GJK_ERROR_RANGE);
  CHECK(gjk_surface_contacts(&sound, &body, 0, 9, NULL, contact, 2, &count) == GJK_ERROR_RANGE);
  CHECK(gjk_surface_contacts(&sound, &body, 0, 4, NULL, NULL, 2, &count) == GJK_ERROR_NULL && count == 7);
  CHECK(gjk_surface_contacts(&sound, &body, 0, 4, NULL, contact, 1, &count) == GJK_ERROR_CAPACITY && count == 1);
  CHECK(gjk_surface_contacts(&sound, &body, 0, 4, NULL, NULL, 0, &count) == GJK_ERROR_CAPACITY && count == 0);
}

// Slides over flat ground, an LSB or more into it, at any angle: every normal is the ground's.
static void check_slides(uint64_t seed) {
  static const gjk_vec3 hull[6] = {{30000, 0, -9000}, {-15000, 26000, -9000}, {-15000, -26000, -9000},
                                   {30000, 0, 9000},  {-15000, 26000, 9000},  {-15000, -26000, 9000}};
  static const gjk_shape shapes[] = {GJK_BOX(30000, 20000, 10000), GJK_SPHERE(25000), GJK_CAPSULE(9000, 30000),
                                     GJK_HULL(hull, 6), GJK_CYLINDER(20000, 9000)};
  static const gjk_q16 lowest[] = {10000, 25000, 39000, 9000, 9000};
  static gjk_epa_cell cells[2000];
  const gjk_workspace workspace = {cells, 2000};
  for (unsigned long i = 0; i < 60; i++) {
    random_state random = random_seed(seed + i);
    const unsigned kind = (unsigned)(i % 5);
    surface s;
    surface_make(&random, SURFACE_FLAT, 3200, random_range(&random, 6000, 50000), false, &s);
    // Level ground, which the same turn as the body's tilts.
    for (uint32_t k = 0; k < s.vertex_count; k++) {
      s.vertices[k].z = 0;
    }
    CHECK(gjk_mesh_build(s.vertices, s.vertex_count, s.triangles, s.triangle_count, false, s.nodes, s.node_count,
                         &s.mesh) == GJK_OK);
    const gjk_parts ground = GJK_PARTS_OF_MESH(&s.mesh);
    gjk_collider body;
    gjk_pose pose = GJK_POSE_IDENTITY;
    const int32_t sink = random_range(&random, 0, 60);
    const gjk_vec3 axis = {0, 0, 1}, way = random_vector(&random, random_range(&random, 100, 20000));
    CHECK(gjk_quat_from_axis_angle(&axis, random_range(&random, -200000, 200000), &pose.rotation) == GJK_OK);
    CHECK(gjk_collider_init(&body, &shapes[kind], NULL, 0) == GJK_OK);
    check_trial(i, NULL, NULL);
    for (int tick = 0; tick < 40; tick++) {
      static gjk_surface_contact found[FOUND];
      uint16_t count = 0;
      pose.position.x = tick * way.x % (s.mesh.upper.x - 40000 > 0 ? s.mesh.upper.x - 40000 : 1);
      pose.position.y = tick * way.y % (s.mesh.upper.y - 40000 > 0 ? s.mesh.upper.y - 40000 : 1);
      pose.position.z = lowest[kind] - sink;
      CHECK(gjk_collider_pose(&body, &pose) == GJK_OK);
      CHECK(gjk_surface_contacts(&ground, &body, 200, 4, &workspace, found, FOUND, &count) == GJK_OK);
      CHECK_MSG(count > 0, "kind %u at (%d, %d)", kind, (int)pose.position.x, (int)pose.position.y);
      gjk_q16 least = 1000;
      for (unsigned k = 0; k < count; k++) {
        const gjk_unit3 *n = &found[k].manifold.normal;
        CHECK_MSG(abs(n->x) <= 2 && abs(n->y) <= 2 && n->z > GJK_Q30_ONE - 4, "kind %u: normal (%d, %d, %d)", kind,
                  (int)n->x, (int)n->y, (int)n->z);
        for (unsigned c = 0; c < found[k].manifold.count; c++) {
          least = found[k].manifold.contact[c].distance < least ? found[k].manifold.contact[c].distance : least;
        }
      }
      CHECK_MSG(abs(least + sink) <= 4, "kind %u, %d deep, %d expected", kind, (int)-least, (int)sink);
      tally.slides++;
      tally.manifolds += count;
    }
    surface_free(&s);
  }
}

int main(void) {
  check_limits();
  check_refusals();
  check_slides(check_seed(SEED) + 2000);
  printf("%lu ticks of slides, %lu manifolds\n", tally.slides, tally.manifolds);
  return check_done("mesh_query");
}
