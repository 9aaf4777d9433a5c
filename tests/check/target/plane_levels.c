// The sets of pairs and queries of levels.h in the plane, without libc and with little RAM.
#include "fnv.h"
#include "levels.h"
#include "random.h"
#include "scene/plane_names.h"

#define levels_hash plane_levels_hash
#define levels_refused plane_levels_refused
#define levels_beyond plane_levels_beyond
#define gjk_check_cast gjk2_check_cast
#define gjk_check_decision gjk2_check_decision
#define gjk_check_distance gjk2_check_distance
#define gjk_check_penetration gjk2_check_penetration
#define gjk_distance_until gjk2_distance_until
#define gjk_effort gjk2_effort
#define gjk_penetration_result gjk2_penetration_result
#define gjk_within_result gjk2_within_result
#define gjk_within_until gjk2_within_until
#undef GJK_IMPACT_TOLERANCE_MIN
#define GJK_IMPACT_TOLERANCE_MIN GJK2_IMPACT_TOLERANCE_MIN
#define ask_depth gjk2_penetration
#define ask_signed_distance gjk2_signed_distance
#define ask_contacts(a, b, margin, most, out) gjk2_contacts(a, b, margin, most, NULL, out)

#define AXES 2
#define TRIANGLE (&gjk2_class_triangle)
#define CASTS_FROM 1
#define CONTACTS_MOST 2
#define SPIN(x) x

static void gjk2_levels_support(const void *user, const gjk2_vec *direction, gjk2_vec *out) {
  (void)user;
  out->x = direction->x < 0 ? -4 : 4;
}

static const gjk2_shape kinds[] = {
    GJK2_POINT,
    GJK2_SEGMENT(0),
    GJK2_BOX(0, 0),
    GJK2_TRIANGLE(0),
    GJK2_POLYGON(0, 0),
    GJK2_ELLIPSE(0, 0),
    GJK2_CUSTOM(gjk2_levels_support, 0, 9),
};
static const gjk2_vec corners[] = {{1, 0}, {0, 1}, {0, 0}};

static int32_t *component(gjk2_vec *v, unsigned axis) {
  return axis == 0 ? &v->x : &v->y;
}

static gjk2_vec vector_of(const gjk2_unit *normal) {
  const gjk2_vec v = {normal->x, normal->y};
  return v;
}

static void set_size(gjk2_shape *shape, gjk2_vec v) {
  const bool has_length = shape->type != &gjk2_class_point,
             has_width = has_length && shape->type != &gjk2_class_segment;
  shape->size.x = has_length ? (v.x < 0 ? -v.x : v.x) : 0;
  shape->size.y = has_width ? (v.y < 0 ? -v.y : v.y) : 0;
}

static void make_pose(random_state *random, gjk2_pose *pose, int32_t reach);

#include "levels_common.h"

// Every other pose is not turned, or by a quarter, and on a grid.
static void make_pose(random_state *random, gjk2_pose *pose, int32_t reach) {
  static const gjk2_pose identity = GJK2_POSE_IDENTITY;
  static const gjk2_rotation quarter = {0, GJK_Q30_ONE};
  const gjk2_rotation raw = {random_range(random, -1000, 1000), random_range(random, -1000, 1001)};
  const uint32_t way = random_below(random, 4);
  *pose = identity;
  pose->position = random_vector(random, reach);
  if (way < 2) {
    pose->position = on_grid(pose->position, reach / 4 + 1);
    pose->rotation = way == 1 ? quarter : identity.rotation;
    return;
  }
  (void)gjk2_rotation_normalize(&raw, &pose->rotation);
}
