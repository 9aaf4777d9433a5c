// Contact manifolds: what each shape meets with, shapes without thickness, how far faces are looked at, which points are
// kept of many, faces that are none.
#include <math.h>

#include "case/case.h"
#include "contacts_scene.h"
#include "random.h"

// Which face, side or vertex it is: of a box 2 axis + 1 on the lower side, of a hull as in its list, of a triangle 1 seen
// from behind, of a cylinder or cone top, bottom, side; of a hull without a face there the vertex.
static void test_features(void) {
  static const gjk_vec3 corners[3] = {{-ONE, -ONE, 0}, {ONE, -ONE, 0}, {0, ONE, 0}};
  static const gjk_shape sheet = GJK_TRIANGLE(corners), cylinder = GJK_CYLINDER(HALF, ONE), cone = GJK_CONE(HALF, ONE);
  static const uint16_t hull_face[6] = {5, 4, 3, 2, 1, 0};  // across +x, -x, +y, -y, +z, -z
  for (int side = 0; side < 6; side++) {
    const gjk_q16 by = side % 2 == 0 ? 2 * ONE - 100 : 100 - 2 * ONE;
    const gjk_pose pose = at(side < 2 ? by : 0, side / 2 == 1 ? by : 0, side > 3 ? by : 0);
    gjk_manifold m = meet(&box, origin, &box, pose, 4);
    CHECK(m.count == 4);
    CHECK(m.feature_a == side);
    CHECK(m.feature_b == (side ^ 1));
    m = meet(&cube, origin, &box, pose, 4);
    CHECK(m.count == 4);
    CHECK(m.feature_a == hull_face[side]);
    CHECK(m.feature_b == (side ^ 1));
  }
  for (int sign = -1; sign <= 1; sign += 2) {
    const gjk_pose pose = at(0, 0, sign * (ONE - 100)), beyond = at(0, 0, sign * (2 * ONE - 100)),
                   beside = at(sign * (ONE + HALF - 100), 0, 0);
    gjk_manifold m = meet(&sheet, origin, &box, pose, 8);
    HAS(m, 3, {-ONE, -ONE, -100}, {ONE, -ONE, -100}, {0, ONE, -100});
    CHECK(m.feature_a == (sign < 0));
    CHECK(m.feature_b == (sign < 0 ? 4 : 5));
    m = meet(&cylinder, origin, &box, beyond, 8);
    const gjk_q16 diagonal = 23170;  // half of cos 45 degrees
    HAS(m, 8, {HALF, 0, -100}, {0, -HALF, -100}, {diagonal, -diagonal, -100}, {-diagonal, diagonal, -100});
    CHECK(m.feature_a == (sign < 0));
    m = meet(&cylinder, origin, &box, beside, 8);
    CHECK(m.count == 2);
    CHECK(m.feature_a == 2);
    CHECK(is_near(m.contact[0].point_a.x, sign * HALF, 3));
    m = meet(&cone, origin, &box, beyond, 8);
    if (sign < 0) {
      HAS(m, 8, {-HALF, 0, -100}, {diagonal, diagonal, -100});
    } else {
      HAS(m, 1, {0, 0, -100});
    }
    CHECK(m.feature_a == (sign < 0 ? 1 : 2));
  }
  // Only the lower face is given.
  static const uint16_t end[1] = {4};
  static const gjk_hull_faces lower = {cube_corners, end, 1};
  static const gjk_shape half_open = GJK_HULL_WITH_FACES(cube_vertices, 8, &lower);
  gjk_manifold m = meet(&half_open, origin, &box, at(0, 0, 100 - 2 * ONE), 4);
  CHECK(m.count == 4);
  CHECK(m.feature_a == 0);
  for (int i = 0; i < 4; i++) {  // a corner of the upper face is highest when it leans there
    gjk_pose pose = at(0, 0, 0);
    const gjk_vec3 lean = {i < 2 ? -ONE : ONE, i % 2 == 0 ? ONE : -ONE, 0};
    CHECK(gjk_quat_from_axis_angle(&lean, EIGHTH_TURN / 4, &pose.rotation) == GJK_OK);
    gjk_collider c;
    gjk_vec3 high = {0, 0, 0};
    c = posed(&half_open, &pose);
    gjk_aabb bounds;
    CHECK(gjk_collider_aabb(&c, &bounds) == GJK_OK);
    m = meet(&half_open, pose, &box, at(0, 0, bounds.upper.z + ONE - 100), 4);
    CHECK(m.count == 1);
    CHECK(m.feature_a >= 4);
    CHECK(m.feature_a < 8);
    CHECK(gjk_pose_apply(&pose, &cube_vertices[m.feature_a], &high) == GJK_OK);
    CHECK(is_near(high.z, bounds.upper.z, 3));
  }
}

// The line of an edge through a corner of a face leaves it there, and through the middle of the edge opposite.
static void test_edge_over_corner(void) {
  static const gjk_vec3 corners[3] = {{-ONE, -ONE, 0}, {ONE, -ONE, 0}, {0, ONE, 0}};
  static const gjk_shape needle = GJK_BOX(0, 2 * ONE, 0);
  for (int first = 0; first < 3; first++) {
    for (int sign = -1; sign <= 1; sign += 2) {
      const gjk_vec3 around[3] = {corners[first], corners[(first + 1) % 3], corners[(first + 2) % 3]};
      const gjk_shape sheet = GJK_TRIANGLE(around);
      gjk_manifold m = meet(&sheet, origin, &needle, at(0, 0, sign * 40), 8);
      HAS(m, 2, {0, ONE, 40}, {0, -ONE, 40});
      m = meet(&needle, at(0, 0, sign * 40), &sheet, origin, 8);
      HAS(m, 2, {0, ONE, 40}, {0, -ONE, 40});
    }
  }
}

// A roof whose sides are steeper than its end: the ridge is of the sides, not of the end that meets the direction better.
static void test_ridge(void) {
  static const gjk_vec3 points[6] = {{0, 0, 0},          {ONE, 0, 0},       {-ONE, -HALF, -ONE},
                                     {ONE, -HALF, -ONE}, {ONE, HALF, -ONE}, {-ONE, HALF, -ONE}};
  static const uint16_t corners[18] = {0, 5, 2, 0, 1, 4, 5, 1, 0, 2, 3, 1, 3, 4, 2, 5, 4, 3},
                        ends[5] = {3, 7, 11, 14, 18};
  static const gjk_hull_faces faces = {corners, ends, 5};
  static const gjk_shape roof = GJK_HULL_WITH_FACES(points, 6, &faces);
  const gjk_manifold m = meet(&roof, origin, &box, at(0, 0, ONE + 100), 4);
  HAS(m, 2, {0, 0, 100}, {ONE, 0, 100});
  CHECK(m.feature_a == 256);
}

// A triangle that leans to either side stands on the edge of its two lower vertices.
static void test_leaning_triangle(void) {
  for (int first = 0; first < 3; first++) {
    for (int sign = -1; sign <= 1; sign += 2) {
      const int second = (first + 1) % 3, third = (first + 2) % 3;
      gjk_vec3 corners[3] = {{0, 0, 0}, {0, 0, 0}, {sign * ONE, 0, ONE}};
      corners[third] = corners[2];
      corners[first].x = corners[second].x = 0;
      corners[first].z = corners[second].z = 0;
      corners[first].y = -HALF;
      corners[second].y = HALF;
      const gjk_shape sheet = GJK_TRIANGLE(corners);
      const gjk_manifold m = meet(&sheet, origin, &box, at(0, 0, -ONE - 100), 4);
      const int low = first < second ? first : second, high = first < second ? second : first;
      HAS(m, 2, {0, -HALF, 100}, {0, HALF, 100});
      CHECK_MSG(m.feature_a == 256 * high + low, "%d of %d and %d", m.feature_a, first, second);
    }
  }
}

// Boxes without thickness stand on an edge: the lower one, though the upright one be longer.
static void test_standing_sheets(void) {
  for (int flat = 0; flat < 2; flat++) {
    for (int sign = -1; sign <= 1; sign += 2) {
      const gjk_shape sheet = GJK_BOX(flat == 0 ? 0 : HALF, flat == 1 ? 0 : HALF, 2 * ONE);
      const gjk_q16 x = flat == 0 ? 0 : HALF, y = flat == 1 ? 0 : HALF;
      const gjk_manifold m = meet(&box, origin, &sheet, at(0, 0, sign * (3 * ONE + 9)), 4);
      HAS(m, 2, {x, y, 9}, {-x, -y, 9});
    }
  }
}

// Boxes without thickness are edges, in whichever direction they lie; edges without length are points, whatever the
// collider held before.
static void test_flat_shapes(void) {
  for (int axis = 0; axis < 3; axis++) {
    const gjk_shape needle = GJK_BOX(axis == 0 ? HALF : 0, axis == 1 ? HALF : 0, axis == 2 ? HALF : 0);
    const gjk_pose down = axis == 2 ? turned(at(0, 0, ONE - 9), &axis_y, QUARTER_TURN) : at(0, 0, ONE - 9);
    gjk_manifold m = meet(&box, origin, &needle, down, 4);
    HAS(m, 2, {axis == 1 ? 0 : HALF, axis == 1 ? HALF : 0, -9}, {axis == 1 ? 0 : -HALF, axis == 1 ? -HALF : 0, -9});
    m = meet(&needle, down, &box, origin, 4);
    CHECK(m.count == 2);
    const gjk_shape splinter = GJK_BOX(axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0);
    m = meet(&box, origin, &splinter, down, 4);
    CHECK(m.count == 2);
    CHECK(m.contact[0].id != m.contact[1].id);
  }
  static const gjk_shape none = GJK_BOX(0, 0, 0), stub = GJK_CAPSULE(HALF, 0), ball = GJK_SPHERE(HALF), dot = GJK_POINT;
  static const gjk_shape *const points[] = {&none, &stub, &ball, &dot};
  for (int i = 0; i < 4; i++) {
    const gjk_pose on_top = at(100, 200, ONE + points[i]->convex_radius - 9);
    gjk_collider a, b;
    gjk_manifold m;
    a = posed(&box, &origin);
    for (int poison = 0; poison < 256; poison += 85) {
      memset(&b, poison, sizeof b);
      CHECK(gjk_collider_init(&b, points[i], NULL, 0) == GJK_OK);
      CHECK(gjk_collider_pose(&b, &on_top) == GJK_OK);
      CHECK(gjk_contacts(&a, &b, MARGIN, 4, NULL, &workspace, &m) == GJK_OK);
      HAS(m, 1, {100, 200, -9});
      CHECK(m.contact[0].point_b.z == ONE - 9);
      CHECK(m.feature_b == 0);
    }
  }
}

// Beyond 2^29 along an axis there is the nearest point alone; up to it, all that faces cover.
static void test_reach(void) {
  static const gjk_shape ball = GJK_SPHERE(HALF);
  const gjk_q16 reach = INT32_C(1) << 29;
  const gjk_manifold corners = meet(&ball, origin, &ball, at(ONE, 0, 0), 1);
  gjk_collider a, b;
  gjk_manifold m;
  a = posed(&box, &origin);
  for (int axis = 0; axis < 3; axis++) {
    for (int sign = -1; sign <= 1; sign += 2) {
      for (gjk_q16 beyond = 0; beyond < 2; beyond++) {
        const gjk_q16 by = sign * (reach + beyond);
        const gjk_pose there = at(axis == 0 ? by : 0, axis == 1 ? by : 0, axis == 2 ? by : 0);
        b = posed(&box, &there);
        CHECK(gjk_contacts(&a, &b, reach - 2 * ONE + beyond, 8, NULL, &workspace, &m) == GJK_OK);
        CHECK(m.count == (beyond != 0 ? 1 : 4));
        CHECK(m.contact[0].distance == reach - 2 * ONE + beyond);
        CHECK(beyond == 0 || (m.feature_a == 0 && m.feature_b == 0 && m.contact[0].id == corners.contact[0].id));
        CHECK(gjk_contacts(&a, &b, reach - 2 * ONE + beyond - 1, 8, NULL, &workspace, &m) == GJK_OK);
        CHECK(m.count == 0);
      }
    }
  }
}

// Twice the area of the largest triangle, or quadrilateral, that has a corner at contact 0 of few, the others among m's.
static int64_t largest(const gjk_manifold *few, const gjk_manifold *m, unsigned axis, bool quadrilateral) {
  int64_t found = 0;
  struct {
    int64_t x, y;
  } s[GJK_CONTACTS_MAX];
  for (unsigned i = 0; i < m->count; i++) {
    const gjk_vec3 *p = &m->contact[i].point_a, *o = &few->contact[0].point_a;
    s[i].x = axis == 0 ? p->y - o->y : p->x - o->x;
    s[i].y = axis == 2 ? p->y - o->y : p->z - o->z;
  }
  for (unsigned k = 0; k < m->count; k++) {
    int64_t most[2] = {0, 0};  // to either side
    for (unsigned i = 0; i < m->count; i++) {
      const int64_t area = s[k].x * s[i].y - s[k].y * s[i].x;
      for (int side = 0; side < 2; side++) {
        if ((side == 0 ? area : -area) > most[side]) {
          most[side] = side == 0 ? area : -area;
        }
      }
    }
    const int larger = most[0] > most[1] ? 0 : 1;
    const int64_t area = quadrilateral ? most[0] + most[1] : most[larger];
    found = area > found ? area : found;
  }
  return found;
}

static int64_t squared_apart(const gjk_contact *a, const gjk_contact *b) {
  const int64_t x = a->point_a.x - b->point_a.x, y = a->point_a.y - b->point_a.y, z = a->point_a.z - b->point_a.z;
  return x * x + y * y + z * z;
}

// How far contact c is from the nearest of the first n of m, squared.
static int64_t clearance(const gjk_contact *c, const gjk_manifold *m, unsigned n) {
  int64_t least = INT64_MAX;
  for (unsigned i = 0; i < n; i++) {
    const int64_t squared = squared_apart(c, &m->contact[i]);
    least = squared < least ? squared : least;
  }
  return least;
}

static bool has_contact(const gjk_manifold *m, unsigned n, uint16_t id) {
  for (unsigned i = 0; i < n; i++) {
    if (m->contact[i].id == id) {
      return true;
    }
  }
  return false;
}

// The one of the lowest id within 4 LSB of the deepest; all of these are as deep.
static uint16_t first_deep(const gjk_manifold *m) {
  const gjk_q16 least = least_of(m);
  uint16_t id = UINT16_MAX;
  for (unsigned i = 0; i < m->count; i++) {
    id = m->contact[i].distance <= least + 4 && m->contact[i].id < id ? m->contact[i].id : id;
  }
  return id;
}

// Fewer than there are: one of the deepest, then 9/10 at least of the largest triangle or quadrilateral with it unless they
// lie on a line, then what is as far from those as the farthest.
static void check_fewer(const gjk_collider *a, const gjk_collider *b, unsigned axis, bool line) {
  gjk_manifold m, few;
  CHECK(gjk_contacts(a, b, MARGIN, 8, NULL, &workspace, &m) == GJK_OK);
  CHECK(m.count > 4);
  for (unsigned most = 1; most < m.count; most++) {
    CHECK(gjk_contacts(a, b, MARGIN, most, NULL, &workspace, &few) == GJK_OK);
    CHECK(few.count == most);
    CHECK(few.contact[0].id == first_deep(&m));
    for (unsigned i = 0; i < most; i++) {
      CHECK(has_contact(&m, m.count, few.contact[i].id));
      CHECK(!has_contact(&few, i, few.contact[i].id));
    }
    const unsigned corners = most < 3 || line ? 1 : most == 3 ? 3 : 4;
    if (most >= 3) {
      gjk_manifold kept = few;
      kept.count = (uint8_t)corners;
      const int64_t wanted = largest(&few, &m, axis, most > 3), found = largest(&few, &kept, axis, most > 3);
      CHECK_MSG((wanted > 0) != line, "%u of %u", most, m.count);
      CHECK_MSG(found * 10 >= wanted * 9, "%u of %u", most, m.count);
    }
    for (unsigned i = corners; i < most; i++) {
      const int64_t kept = clearance(&few.contact[i], &few, i);
      for (unsigned k = 0; k < m.count; k++) {
        CHECK(has_contact(&few, i, m.contact[k].id) || clearance(&m.contact[k], &few, i) * 9 <= kept * 10);
      }
    }
  }
}

static void test_fewer(void) {
  random_state random = random_seed(check_seed(62));
  static case_posed shown;
  const gjk_vec3 *const axes[3] = {&axis_x, &axis_y, &axis_z};
  for (int i = 0; i < 600; i++) {
    gjk_collider a, b;
    const unsigned axis = (unsigned)i % 3;
    const gjk_shape flat = GJK_BOX(axis == 0 ? ONE / 2 : ONE, axis == 1 ? ONE / 2 : ONE, axis == 2 ? ONE / 2 : ONE);
    const gjk_q16 up = ONE - random_range(&random, 0, 500), side = random_range(&random, -ONE / 8, ONE / 8),
                  side2 = random_range(&random, -ONE / 8, ONE / 8);
    const gjk_pose turn = turned(at(axis == 0 ? up : side,
                                    axis == 1   ? up
                                    : axis == 0 ? side
                                                : side2,
                                    axis == 2 ? up : side2),
                                 axes[axis], EIGHTH_TURN + random_range(&random, -ONE / 8, ONE / 8));
    shown = (case_posed){flat, flat, origin, turn};
    check_trial((unsigned long)i, case_show_posed, &shown);
    a = posed(&flat, &origin);
    b = posed(&flat, &turn);
    check_fewer(&a, &b, axis, false);
    check_fewer(&b, &a, axis, false);
  }
}

// An octagon of which many points are equally far from others; a triangle and a square with corners within their edges; a line
// along which polygons meet.
static void test_fewer_of_few_kinds(void) {
  static const gjk_shape cylinder = GJK_CYLINDER(HALF, ONE);
  static const gjk_vec3 points[8] = {{-HALF, -HALF, 0}, {0, -HALF, 0},       {HALF, -HALF, 0}, {HALF, -HALF / 2, 0},
                                     {HALF, 0, 0},      {HALF, HALF / 2, 0}, {HALF, HALF, 0},  {0, 0, 0}};
  static const uint16_t around[8] = {0, 1, 2, 3, 4, 5, 6, 7}, end[1] = {8};
  static const gjk_hull_faces faces = {around, end, 1};
  static const gjk_shape triangle = GJK_HULL_WITH_FACES(points, 8, &faces);
  static const gjk_vec3 border[8] = {{-HALF, -HALF, 0}, {0, -HALF, 0}, {HALF, -HALF, 0}, {HALF, 0, 0},
                                     {HALF, HALF, 0},   {0, HALF, 0},  {-HALF, HALF, 0}, {-HALF, 0, 0}};
  static const gjk_shape square = GJK_HULL_WITH_FACES(border, 8, &faces);
  const gjk_pose on_top = at(0, 0, 2 * ONE - 100), above = at(0, 0, ONE + 100), beside = at(HALF + ONE, 0, ONE + 100),
                 below = at(0, 0, -ONE - 100), over = {{0, 0, 0}, {GJK_Q30_ONE, 0, 0, 0}};
  gjk_collider a, b;
  a = posed(&box, &origin);
  b = posed(&cylinder, &on_top);
  check_fewer(&a, &b, 2, false);
  a = posed(&triangle, &origin);
  b = posed(&box, &above);
  check_fewer(&a, &b, 2, false);
  b = posed(&box, &beside);
  check_fewer(&a, &b, 2, true);
  a = posed(&square, &origin);
  b = posed(&box, &above);
  check_fewer(&a, &b, 2, false);
  a = posed(&square, &over);  // the other way around
  b = posed(&box, &below);
  check_fewer(&a, &b, 2, false);
}

// A hull's faces are the caller's: ones that cross themselves give contacts that are none of the polygons', but no more
// than there is room for, each on both planes.
static void test_crossing_faces(void) {
  static gjk_vec3 star[2][24];
  static uint16_t around[24];
  static const uint16_t ends[2] = {12, 24};
  const gjk_hull_faces faces = {around, ends, 2};
  for (int i = 0; i < 24; i++) {
    const double angle = 6.283185307179586 * (i % 12) / 12, step = angle + 0.09;
    const gjk_q16 z = i < 12 ? -ONE : ONE;
    star[0][i] = (gjk_vec3){(gjk_q16)(ONE * cos(angle)), (gjk_q16)(ONE * sin(angle)), z};
    star[1][i] = (gjk_vec3){(gjk_q16)(ONE * cos(step)), (gjk_q16)(ONE * sin(step)), z};
    around[i] = (uint16_t)(i < 12 ? 5 * (11 - i) % 12 : 12 + 5 * (i - 12) % 12);
  }
  const gjk_shape one = GJK_HULL_WITH_FACES(star[0], 24, &faces), two = GJK_HULL_WITH_FACES(star[1], 24, &faces);
  const gjk_manifold m = meet(&one, origin, &two, at(0, 0, 2 * ONE - 100), 8);
  CHECK(m.count == 8);
  for (unsigned i = 0; i < m.count; i++) {
    CHECK(m.contact[i].distance == -100);
    CHECK(m.contact[i].point_a.z == ONE);
    CHECK(m.contact[i].point_b.z == ONE - 100);
  }
}

// A corner that a face names twice in a row is there once; the edge between covers nothing and leaves nothing out.
static void test_repeated_corner(void) {
  static const uint16_t doubled[25] = {0, 2, 3, 1, 4, 5, 7, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
  static const uint16_t ends[6] = {4, 9, 13, 17, 21, 25};
  static const gjk_hull_faces faces = {doubled, ends, 6};
  static const gjk_shape hull = GJK_HULL_WITH_FACES(cube_vertices, 8, &faces);
  gjk_manifold m = meet(&hull, origin, &box, at(ONE, HALF, 2 * ONE - 100), 8);
  HAS(m, 4, {0, -HALF, -100}, {ONE, -HALF, -100}, {0, ONE, -100}, {ONE, ONE, -100});
  CHECK(m.feature_a == 1);
}

// Cylinders across each other at a small angle: the ends of what their sides share lie aside of each other. The point between
// them is aside^2 / 4 / (2 radius) LSB off the thinner one: 1/2 LSB at 512.
static void test_crossing_sides(void) {
  static const gjk_shape thin = GJK_CYLINDER(ONE, ONE), thick = GJK_CYLINDER(2 * ONE, ONE);
  for (int aside = 448; aside < 576; aside += 4) {
    const gjk_pose there = turned(at(3 * ONE + 20, 0, 0), &axis_x, aside);
    const gjk_manifold m = meet(&thin, origin, &thick, there, 8), n = meet(&thick, there, &thin, origin, 8);
    CHECK(m.feature_a == 2 && m.feature_b == 2);
    CHECK_MSG(abs(aside - 512) < 4 || (m.count == (aside < 512 ? 2 : 1) && n.count == m.count), "%d aside", aside);
  }
}

// A bar that leans from a cylinder and overlaps it by half a unit shares the cylinder's side up to its ends, and no more: what
// the slope makes of the overlap is no offset aside.
static void test_leaning_sides(void) {
  static const gjk_shape cylinder = GJK_CYLINDER(ONE, ONE), bar = GJK_CAPSULE(ONE, 4 * ONE);
  for (int slope = -9; slope <= 9; slope++) {
    const gjk_manifold m =
        meet(&cylinder, origin, &bar, turned(at(ONE + HALF, 0, HALF), &axis_y, slope * GJK_ANGLE(0.01)), 8);
    CHECK(m.count == 2 && m.feature_a == 2);
    for (unsigned i = 0; i < m.count; i++) {
      const gjk_vec3 *p = &m.contact[i].point_a;
      CHECK_MSG(is_near(p->x, ONE, 1) && is_near(p->y, 0, 1) && is_near(p->z, i == 0 ? -ONE : ONE, 1), "%ld %ld %ld",
                (long)p->x, (long)p->y, (long)p->z);
    }
  }
}

int main(void) {
  test_features();
  test_crossing_sides();
  test_leaning_sides();
  test_edge_over_corner();
  test_leaning_triangle();
  test_ridge();
  test_standing_sheets();
  test_flat_shapes();
  test_reach();
  test_fewer();
  test_fewer_of_few_kinds();
  test_crossing_faces();
  test_repeated_corner();
  return check_done("contacts_cases");
}
