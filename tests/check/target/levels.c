// The sets of pairs and queries of levels.h in space, without libc and with little RAM.
#include "levels.h"

#include "fnv.h"
#include "gjk/gjk.h"
#include "gjk/impact.h"
#include "random.h"

#define AXES 3
#define TRIANGLE (&gjk_class_triangle)
#define CASTS_FROM 2  // a build for points alone has no casts
#define CONTACTS_MOST 4
#define SPIN(x) \
  { x, 30000, 0 }

static void gjk_levels_support(const void *user, const gjk_vec3 *direction, gjk_vec3 *out) {
  (void)user;
  out->x = direction->x < 0 ? -4 : 4;
}

static const gjk_shape kinds[] = {
    GJK_POINT,       GJK_SEGMENT(0),         GJK_BOX(0, 0, 0),
    GJK_TRIANGLE(0), GJK_HULL(0, 0),         GJK_CYLINDER(0, 0),
    GJK_CONE(0, 0),  GJK_ELLIPSOID(0, 0, 0), GJK_CUSTOM(gjk_levels_support, 0, 9),
};
static const gjk_vec3 corners[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}};

static gjk_epa_cell cells[GJK_EPA_CELLS(20)];
static const gjk_workspace workspace = {cells, GJK_EPA_CELLS(20)};

#define ask_depth(a, b, cache, out) gjk_penetration(a, b, cache, &workspace, out)
#define ask_signed_distance(a, b, cache, out) gjk_signed_distance(a, b, cache, &workspace, out)
#define ask_contacts(a, b, margin, most, out) gjk_contacts(a, b, margin, most, NULL, &workspace, out)

static int32_t *component(gjk_vec3 *v, unsigned axis) {
  return axis == 0 ? &v->x : axis == 1 ? &v->y : &v->z;
}

static gjk_vec3 vector_of(const gjk_unit3 *normal) {
  const gjk_vec3 v = {normal->x, normal->y, normal->z};
  return v;
}

static void set_size(gjk_shape *shape, gjk_vec3 v) {
  const bool has_length = shape->type != &gjk_class_point, has_width = has_length && shape->type != &gjk_class_segment;
  shape->size.x = has_width ? (v.x < 0 ? -v.x : v.x) : 0;
  shape->size.y = has_width ? (v.y < 0 ? -v.y : v.y) : 0;
  shape->size.z = has_length ? (v.z < 0 ? -v.z : v.z) : 0;
}

static void make_pose(random_state *random, gjk_pose *pose, int32_t reach);

#include "levels_common.h"

// Every other pose is not turned, or by a quarter, and on a grid: parallel edges, crossing ones, and shapes that touch.
static void make_pose(random_state *random, gjk_pose *pose, int32_t reach) {
  static const gjk_pose identity = GJK_POSE_IDENTITY;
  static const gjk_quat quarter = {0, 1000, 0, 1000}, other = {1000, 0, 0, 1000};
  const uint32_t way = random_below(random, 8);
  *pose = identity;
  pose->position = random_vector(random, reach);
  if (way < 4) {
    pose->position = on_grid(pose->position, way < 2 ? reach / 4 + 1 : 1);
    if (way > 0) {
      (void)gjk_quat_normalize(way < 3 ? &quarter : &other, &pose->rotation);
    }
    return;
  }
  const gjk_quat q = {random_range(random, -1000, 1000), random_range(random, -1000, 1000),
                      random_range(random, -1000, 1000), random_range(random, -1000, 1001)};
  (void)gjk_quat_normalize(&q, &pose->rotation);
}
