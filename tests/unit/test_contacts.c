// Contact manifolds: scenes worked out by hand, and on random pairs what every manifold must keep to.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../check.h"
#include "../random.h"
#include "gjk/gjk.h"

#define ONE GJK_Q16_ONE
#define HALF (ONE / 2)
#define QUARTER_TURN GJK_Q16(1.5707963)
#define EIGHTH_TURN GJK_Q16(0.7853982)
#define MARGIN 655
#define CELLS GJK_POLYTOPE_CELLS(64)
#define PAIRS ((int)check_trials(60000))

static gjk_cell cells[CELLS];
static const gjk_workspace workspace = {cells, CELLS};
static const gjk_pose origin = GJK_POSE_IDENTITY;
static const gjk_vec3 axis_x = {ONE, 0, 0}, axis_y = {0, ONE, 0}, axis_z = {0, 0, ONE};

static const gjk_vec3 cube_vertices[8] = {{-ONE, -ONE, -ONE}, {ONE, -ONE, -ONE}, {-ONE, ONE, -ONE}, {ONE, ONE, -ONE},
                                          {-ONE, -ONE, ONE},  {ONE, -ONE, ONE},  {-ONE, ONE, ONE},  {ONE, ONE, ONE}};
static const uint16_t cube_corners[24] = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
static const uint16_t cube_ends[6] = {4, 8, 12, 16, 20, 24};
static const gjk_hull_faces cube_faces = {cube_corners, cube_ends, 6};

static const gjk_shape box = GJK_BOX(ONE, ONE, ONE);
static const gjk_shape cube = GJK_HULL_WITH_FACES(cube_vertices, 8, &cube_faces);
static const gjk_shape bare_cube = GJK_HULL(cube_vertices, 8);

static gjk_pose at(gjk_q16 x, gjk_q16 y, gjk_q16 z) {
  gjk_pose pose = GJK_POSE_IDENTITY;
  pose.position.x = x;
  pose.position.y = y;
  pose.position.z = z;
  return pose;
}

static gjk_pose turned(gjk_pose pose, const gjk_vec3 *axis, gjk_q16 angle) {
  CHECK(gjk_quat_from_axis_angle(axis, angle, &pose.rotation) == GJK_OK);
  return pose;
}

static void place(const gjk_shape *shape, const gjk_pose *pose, gjk_collider *out) {
  memset(out, 0, sizeof *out);
  CHECK(gjk_collider_init(out, shape, NULL, 0) == GJK_OK && gjk_collider_pose(out, pose) == GJK_OK);
}

static gjk_manifold meet(const gjk_shape *a, gjk_pose pose_a, const gjk_shape *b, gjk_pose pose_b, unsigned most) {
  gjk_collider one, two;
  gjk_manifold m;
  memset(&m, 0, sizeof m);
  place(a, &pose_a, &one);
  place(b, &pose_b, &two);
  CHECK(gjk_contacts(&one, &two, MARGIN, most, NULL, &workspace, &m) == GJK_OK);
  return m;
}

static bool is_near(gjk_q16 a, gjk_q16 b, gjk_q16 tolerance) {
  return a - b <= tolerance && b - a <= tolerance;
}

// Is there a contact of A's point at (x, y), to 3 LSB, as deep as is said?
static bool has_point(const gjk_manifold *m, gjk_q16 x, gjk_q16 y, gjk_q16 distance) {
  for (unsigned i = 0; i < m->count; i++) {
    const gjk_contact *c = &m->contact[i];
    if (is_near(c->point_a.x, x, 3) && is_near(c->point_a.y, y, 3) && is_near(c->distance, distance, 2)) {
      return true;
    }
  }
  return false;
}

static bool has_corners(const gjk_manifold *m, gjk_q16 half, gjk_q16 distance) {
  return m->count == 4 && has_point(m, half, half, distance) && has_point(m, -half, half, distance) &&
         has_point(m, half, -half, distance) && has_point(m, -half, -half, distance);
}

static void test_boxes(void) {
  gjk_manifold m = meet(&box, origin, &box, at(0, 0, 2 * ONE - 100), 4);
  CHECK(has_corners(&m, ONE, -100) && m.feature_a == 4 && m.feature_b == 5 && m.normal.z == GJK_Q30_ONE);
  m = meet(&box, origin, &box, at(0, 0, 2 * ONE + 300), 4);
  CHECK(has_corners(&m, ONE, 300));
  m = meet(&box, origin, &box, at(0, 0, 2 * ONE + MARGIN + 1), 4);
  CHECK(m.count == 0);
  m = meet(&box, origin, &box, at(0, 0, 2 * ONE + MARGIN), 4);
  CHECK(has_corners(&m, ONE, MARGIN));
  // Moved aside by half: what the faces share.
  m = meet(&box, origin, &box, at(ONE, 0, 2 * ONE - 7), 4);
  CHECK(m.count == 4 && has_point(&m, 0, ONE, -7) && has_point(&m, ONE, -ONE, -7) && has_point(&m, ONE, ONE, -7));
  // Turned by an eighth: an octagon, of which four points far apart are kept on demand.
  const gjk_pose eighth = turned(at(0, 0, 2 * ONE - 50), &axis_z, EIGHTH_TURN);
  const gjk_q16 corner = 27146;  // tan 22.5 degrees
  m = meet(&box, origin, &box, eighth, 8);
  CHECK(m.count == 8 && has_point(&m, corner, ONE, -50) && has_point(&m, -ONE, -corner, -50));
  m = meet(&box, origin, &box, eighth, 4);
  CHECK(m.count == 4);
  gjk_q16 low = ONE, high = -ONE;
  for (unsigned i = 0; i < m.count; i++) {
    low = m.contact[i].point_a.x < low ? m.contact[i].point_a.x : low;
    high = m.contact[i].point_a.x > high ? m.contact[i].point_a.x : high;
  }
  CHECK(is_near(low, -ONE, 3) && is_near(high, ONE, 3));
  m = meet(&box, origin, &box, eighth, 1);
  CHECK(m.count == 1 && is_near(m.contact[0].distance, -50, 2));
}

// The same scenes with a hull for the box; without faces it has one point.
static void test_hulls(void) {
  gjk_manifold m = meet(&cube, origin, &box, at(0, 0, 2 * ONE - 100), 4);
  CHECK(has_corners(&m, ONE, -100) && m.feature_a == 1 && m.feature_b == 5);
  m = meet(&cube, turned(origin, &axis_x, QUARTER_TURN), &cube, at(0, 0, 2 * ONE - 100), 4);
  CHECK(has_corners(&m, ONE, -100));
  m = meet(&bare_cube, origin, &box, at(0, 0, 2 * ONE - 100), 4);
  CHECK(m.count == 1 && m.contact[0].distance == -100);
}

static void test_edges(void) {
  const gjk_q16 height = 92682;  // sqrt(2)
  const gjk_pose edge_up = turned(origin, &axis_x, EIGHTH_TURN);
  gjk_manifold m = meet(&box, origin, &box, turned(at(0, 0, ONE + height - 40), &axis_x, EIGHTH_TURN), 4);
  CHECK(m.count == 2 && has_point(&m, -ONE, 0, -40) && has_point(&m, ONE, 0, -40));
  m = meet(&box, edge_up, &box, turned(at(HALF, 0, 2 * height + 40), &axis_x, EIGHTH_TURN), 4);
  CHECK(m.count == 2 && has_point(&m, -HALF, 0, 40) && has_point(&m, ONE, 0, 40));
  m = meet(&box, edge_up, &box, turned(at(0, 0, 2 * height - 40), &axis_y, EIGHTH_TURN), 4);
  CHECK(m.count == 1 && has_point(&m, 0, 0, -39));
}

static void test_round_shapes(void) {
  static const gjk_shape ball = GJK_SPHERE(HALF), capsule = GJK_CAPSULE(HALF / 2, HALF),
                         rounded = GJK_ROUNDED_BOX(HALF, HALF, HALF, HALF / 2), cylinder = GJK_CYLINDER(HALF, ONE),
                         cone = GJK_CONE(HALF, ONE), ellipsoid = GJK_ELLIPSOID(HALF, ONE, HALF);
  gjk_manifold m = meet(&box, origin, &ball, at(100, 200, ONE + HALF - 9), 4);
  CHECK(m.count == 1 && has_point(&m, 100, 200, -9));
  m = meet(&box, origin, &capsule, turned(at(0, 0, ONE + HALF / 2 - 9), &axis_y, QUARTER_TURN), 4);
  CHECK(m.count == 2 && has_point(&m, HALF, 0, -9) && has_point(&m, -HALF, 0, -9));
  m = meet(&capsule, turned(origin, &axis_y, QUARTER_TURN), &capsule,
           turned(at(HALF, 0, HALF - 9), &axis_y, QUARTER_TURN), 4);
  CHECK(m.count == 2 && has_point(&m, HALF, 0, -9) && has_point(&m, 0, 0, -9));
  m = meet(&capsule, turned(origin, &axis_y, QUARTER_TURN), &capsule, turned(at(0, 0, HALF - 9), &axis_x, QUARTER_TURN),
           4);
  CHECK(m.count == 1 && has_point(&m, 0, 0, -9));
  m = meet(&rounded, origin, &box, at(0, 0, HALF + HALF / 2 + ONE - 77), 4);
  CHECK(has_corners(&m, HALF, -77));
  m = meet(&box, origin, &cylinder, at(0, 0, 2 * ONE - 36), 4);
  CHECK(m.count == 4 && has_point(&m, HALF, 0, -36) && has_point(&m, 0, -HALF, -36) && m.feature_b == 1);
  m = meet(&box, origin, &cylinder, turned(at(0, 0, ONE + HALF - 36), &axis_y, QUARTER_TURN), 4);
  CHECK(m.count == 2 && has_point(&m, ONE, 0, -36) && has_point(&m, -ONE, 0, -36) && m.feature_b == 2);
  m = meet(&box, origin, &cone, at(0, 0, 2 * ONE - 36), 4);
  CHECK(m.count == 4 && has_point(&m, -HALF, 0, -36) && has_point(&m, 0, HALF, -36));
  m = meet(&box, origin, &ellipsoid, at(7, 8, ONE + HALF - 36), 4);
  CHECK(m.count == 1 && is_near(m.contact[0].distance, -36, 4));
}

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
    CHECK(m.count == 4 && m.feature_a == side && m.feature_b == (side ^ 1));
    m = meet(&cube, origin, &box, pose, 4);
    CHECK(m.count == 4 && m.feature_a == hull_face[side] && m.feature_b == (side ^ 1));
  }
  for (int sign = -1; sign <= 1; sign += 2) {
    const gjk_pose pose = at(0, 0, sign * (ONE - 100)), beyond = at(0, 0, sign * (2 * ONE - 100)),
                   beside = at(sign * (ONE + HALF - 100), 0, 0);
    gjk_manifold m = meet(&sheet, origin, &box, pose, 8);
    CHECK(m.count == 3 && m.feature_a == (sign < 0) && m.feature_b == (sign < 0 ? 4 : 5));
    CHECK(has_point(&m, -ONE, -ONE, -100) && has_point(&m, ONE, -ONE, -100) && has_point(&m, 0, ONE, -100));
    m = meet(&cylinder, origin, &box, beyond, 8);
    CHECK(m.count == 8 && m.feature_a == (sign < 0));
    const gjk_q16 diagonal = 23170;  // half of cos 45 degrees
    CHECK(has_point(&m, HALF, 0, -100) && has_point(&m, 0, -HALF, -100) && has_point(&m, diagonal, -diagonal, -100) &&
          has_point(&m, -diagonal, diagonal, -100));
    m = meet(&cylinder, origin, &box, beside, 8);
    CHECK(m.count == 2 && m.feature_a == 2 && is_near(m.contact[0].point_a.x, sign * HALF, 3));
    if (sign < 0) {
      m = meet(&cone, origin, &box, beyond, 8);
      CHECK(m.count == 8 && m.feature_a == 1 && has_point(&m, -HALF, 0, -100) &&
            has_point(&m, diagonal, diagonal, -100));
    } else {
      m = meet(&cone, origin, &box, beyond, 8);
      CHECK(m.count == 1 && m.feature_a == 2 && has_point(&m, 0, 0, -100));
    }
  }
  // Only the lower face is given.
  static const uint16_t end[1] = {4};
  static const gjk_hull_faces lower = {cube_corners, end, 1};
  static const gjk_shape half_open = GJK_HULL_WITH_FACES(cube_vertices, 8, &lower);
  gjk_manifold m = meet(&half_open, origin, &box, at(0, 0, 100 - 2 * ONE), 4);
  CHECK(m.count == 4 && m.feature_a == 0);
  for (int i = 0; i < 4; i++) {  // a corner of the upper face is highest when it leans there
    gjk_pose pose = at(0, 0, 0);
    const gjk_vec3 lean = {i < 2 ? -ONE : ONE, i % 2 == 0 ? ONE : -ONE, 0};
    CHECK(gjk_quat_from_axis_angle(&lean, EIGHTH_TURN / 4, &pose.rotation) == GJK_OK);
    gjk_collider c;
    gjk_vec3 high = {0, 0, 0};
    place(&half_open, &pose, &c);
    gjk_aabb bounds;
    CHECK(gjk_collider_aabb(&c, &bounds) == GJK_OK);
    m = meet(&half_open, pose, &box, at(0, 0, bounds.upper.z + ONE - 100), 4);
    CHECK(m.count == 1 && m.feature_a >= 4 && m.feature_a < 8);
    CHECK(gjk_pose_apply(&pose, &cube_vertices[m.feature_a], &high) == GJK_OK);
    CHECK(is_near(high.z, bounds.upper.z, 3));
  }
}

// Boxes without thickness are edges, in whichever direction they lie; edges without length are points, whatever the
// collider held before.
static void test_flat_shapes(void) {
  for (int axis = 0; axis < 3; axis++) {
    const gjk_shape needle = GJK_BOX(axis == 0 ? HALF : 0, axis == 1 ? HALF : 0, axis == 2 ? HALF : 0);
    const gjk_pose down = axis == 2 ? turned(at(0, 0, ONE - 9), &axis_y, QUARTER_TURN) : at(0, 0, ONE - 9);
    gjk_manifold m = meet(&box, origin, &needle, down, 4);
    CHECK(m.count == 2 && has_point(&m, axis == 1 ? 0 : HALF, axis == 1 ? HALF : 0, -9) &&
          has_point(&m, axis == 1 ? 0 : -HALF, axis == 1 ? -HALF : 0, -9));
    m = meet(&needle, down, &box, origin, 4);
    CHECK(m.count == 2);
  }
  static const gjk_shape none = GJK_BOX(0, 0, 0), stub = GJK_CAPSULE(HALF, 0), ball = GJK_SPHERE(HALF), dot = GJK_POINT;
  static const gjk_shape *const points[] = {&none, &stub, &ball, &dot};
  for (int i = 0; i < 4; i++) {
    const gjk_pose on_top = at(100, 200, ONE + points[i]->round - 9);
    gjk_collider a, b;
    gjk_manifold m;
    place(&box, &origin, &a);
    for (int poison = 0; poison < 256; poison += 85) {
      memset(&b, poison, sizeof b);
      CHECK(gjk_collider_init(&b, points[i], NULL, 0) == GJK_OK && gjk_collider_pose(&b, &on_top) == GJK_OK);
      CHECK(gjk_contacts(&a, &b, MARGIN, 4, NULL, &workspace, &m) == GJK_OK);
      CHECK(m.count == 1 && has_point(&m, 100, 200, -9) && m.contact[0].point_b.z == ONE - 9);
    }
  }
}

static void test_statuses(void) {
  gjk_collider a, b, blank = {0};
  gjk_manifold m, poison;
  memset(&poison, 0xA5, sizeof poison);
  m = poison;
  const gjk_pose near = at(0, 0, ONE);
  place(&bare_cube, &origin, &a);
  place(&bare_cube, &near, &b);
  CHECK(gjk_contacts(NULL, &b, 0, 4, NULL, NULL, &m) == GJK_ERROR_NULL);
  CHECK(gjk_contacts(&a, NULL, 0, 4, NULL, NULL, &m) == GJK_ERROR_NULL);
  CHECK(gjk_contacts(&a, &b, 0, 4, NULL, NULL, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_contacts(&a, &blank, 0, 4, NULL, NULL, &m) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk_contacts(&a, &b, -1, 4, NULL, NULL, &m) == GJK_ERROR_NEGATIVE);
  CHECK(gjk_contacts(&a, &b, 0, 0, NULL, NULL, &m) == GJK_ERROR_RANGE);
  CHECK(gjk_contacts(&a, &b, 0, 9, NULL, NULL, &m) == GJK_ERROR_RANGE);
  CHECK(memcmp(&m, &poison, sizeof m) == 0);
  CHECK(gjk_contacts(&a, &b, 0, 4, NULL, NULL, &m) == GJK_ERROR_CAPACITY && m.count == 1);
}

static void test_faces(void) {
  static const uint16_t wrong_corner[3] = {0, 1, 8}, three[1] = {3}, two[1] = {2}, many[1] = {17};
  static const gjk_hull_faces none = {NULL, three, 1}, endless = {cube_corners, NULL, 1},
                              beyond = {wrong_corner, three, 1}, short_face = {cube_corners, two, 1},
                              long_face = {cube_corners, many, 1}, empty = {cube_corners, three, 0};
  static const uint16_t back[2] = {4, 3}, back_far[2] = {16, 0};
  static const gjk_hull_faces backwards = {cube_corners, back, 2}, far_back = {cube_corners, back_far, 2};
  const gjk_hull_faces *refused[] = {&beyond, &short_face, &long_face, &backwards, &far_back};
  gjk_collider c = {0};
  gjk_shape shape = cube;
  for (unsigned i = 0; i < 5; i++) {
    shape.faces = refused[i];
    CHECK(gjk_collider_init(&c, &shape, NULL, 0) == GJK_ERROR_RANGE);
  }
  shape.faces = &none;
  CHECK(gjk_collider_init(&c, &shape, NULL, 0) == GJK_ERROR_NULL);
  shape.faces = &endless;
  CHECK(gjk_collider_init(&c, &shape, NULL, 0) == GJK_ERROR_NULL);
  shape.faces = &empty;
  const gjk_manifold m = meet(&shape, origin, &box, at(0, 0, 2 * ONE - 100), 4);
  CHECK(m.count == 1);
}

static gjk_q16 least_of(const gjk_manifold *m) {
  gjk_q16 least = GJK_DISTANCE_MAX;
  for (unsigned i = 0; i < m->count; i++) {
    least = m->contact[i].distance < least ? m->contact[i].distance : least;
  }
  return least;
}

// Beyond 2^29 along an axis there is the nearest point alone; up to it, all that faces cover.
static void test_reach(void) {
  const gjk_q16 reach = INT32_C(1) << 29;
  gjk_collider a, b;
  gjk_manifold m;
  place(&box, &origin, &a);
  for (int axis = 0; axis < 3; axis++) {
    for (int sign = -1; sign <= 1; sign += 2) {
      for (gjk_q16 beyond = 0; beyond < 2; beyond++) {
        const gjk_q16 by = sign * (reach + beyond);
        const gjk_pose there = at(axis == 0 ? by : 0, axis == 1 ? by : 0, axis == 2 ? by : 0);
        place(&box, &there, &b);
        CHECK(gjk_contacts(&a, &b, reach - 2 * ONE + beyond, 8, NULL, &workspace, &m) == GJK_OK);
        CHECK(m.count == (beyond != 0 ? 1 : 4) && m.contact[0].distance == reach - 2 * ONE + beyond);
        CHECK(beyond == 0 || (m.feature_a == 0 && m.feature_b == 0));
        CHECK(gjk_contacts(&a, &b, reach - 2 * ONE + beyond - 1, 8, NULL, &workspace, &m) == GJK_OK && m.count == 0);
      }
    }
  }
}

// The largest triangle, or quadrilateral, that has a corner at contact 0 of few, with the others among m's: twice its area.
static int64_t largest(const gjk_manifold *few, const gjk_manifold *m, unsigned axis, bool quadrilateral) {
  int64_t most = 0;
  struct {
    int64_t x, y;
  } s[GJK_CONTACTS_MAX];
  for (unsigned i = 0; i < m->count; i++) {
    const gjk_vec3 *p = &m->contact[i].point_a, *o = &few->contact[0].point_a;
    s[i].x = axis == 0 ? p->y - o->y : p->x - o->x;
    s[i].y = axis == 2 ? p->y - o->y : p->z - o->z;
  }
  for (unsigned k = 0; k < m->count; k++) {
    int64_t left = 0, right = 0;
    for (unsigned i = 0; i < m->count; i++) {
      const int64_t area = s[k].x * s[i].y - s[k].y * s[i].x;
      left = area > left ? area : left;
      right = -area > right ? -area : right;
    }
    const int64_t area = quadrilateral ? left + right : left > right ? left : right;
    most = area > most ? area : most;
  }
  return most;
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

// Fewer than there are: the deepest, the largest triangle or quadrilateral with it, then what is farthest from those.
static void check_fewer(const gjk_collider *a, const gjk_collider *b, unsigned axis) {
  gjk_manifold m, few;
  CHECK(gjk_contacts(a, b, MARGIN, 8, NULL, &workspace, &m) == GJK_OK && m.count > 4);
  const gjk_q16 least = least_of(&m);
  for (unsigned most = 1; most < m.count; most++) {
    CHECK(gjk_contacts(a, b, MARGIN, most, NULL, &workspace, &few) == GJK_OK && few.count == most);
    unsigned first = 0;
    while (m.contact[first].distance > least + 1) {
      first++;
    }
    CHECK(few.contact[0].id == m.contact[first].id);
    for (unsigned i = 0; i < most; i++) {
      CHECK(has_contact(&m, m.count, few.contact[i].id) && !has_contact(&few, i, few.contact[i].id));
    }
    const unsigned corners = most < 3 ? 1 : most == 3 ? 3 : 4;
    if (most >= 3) {
      gjk_manifold kept = few;
      kept.count = (uint8_t)corners;
      const int64_t wanted = largest(&few, &m, axis, most > 3);
      CHECK_MSG(wanted > 0 && largest(&few, &kept, axis, most > 3) == wanted, "%u of %u", most, m.count);
    }
    for (unsigned i = corners; i < most; i++) {
      for (unsigned k = 0; k < m.count; k++) {
        CHECK(has_contact(&few, i, m.contact[k].id) ||
              clearance(&m.contact[k], &few, i) <= clearance(&few.contact[i], &few, i));
      }
    }
  }
}

static void test_fewer(void) {
  random_state random = random_seed(62);
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
    place(&flat, &origin, &a);
    place(&flat, &turn, &b);
    check_fewer(&a, &b, axis);
    check_fewer(&b, &a, axis);
  }
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
    const gjk_vec3 v = {(gjk_q16)(ONE * cos(angle)), (gjk_q16)(ONE * sin(angle)), z},
                   w = {(gjk_q16)(ONE * cos(step)), (gjk_q16)(ONE * sin(step)), z};
    star[0][i] = v;
    star[1][i] = w;
    around[i] = (uint16_t)(i < 12 ? 5 * (11 - i) % 12 : 12 + 5 * (i - 12) % 12);
  }
  const gjk_shape one = GJK_HULL_WITH_FACES(star[0], 24, &faces), two = GJK_HULL_WITH_FACES(star[1], 24, &faces);
  const gjk_manifold m = meet(&one, origin, &two, at(0, 0, 2 * ONE - 100), 8);
  CHECK(m.count == 8);
  for (unsigned i = 0; i < m.count; i++) {
    CHECK(m.contact[i].distance == -100 && m.contact[i].point_a.z == ONE && m.contact[i].point_b.z == ONE - 100);
  }
}

// A corner that a face names twice in a row is there twice; the edge between covers nothing and leaves nothing out.
static void test_repeated_corner(void) {
  static const uint16_t doubled[25] = {0, 2, 3, 1, 4, 5, 7, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
  static const uint16_t ends[6] = {4, 9, 13, 17, 21, 25};
  static const gjk_hull_faces faces = {doubled, ends, 6};
  static const gjk_shape hull = GJK_HULL_WITH_FACES(cube_vertices, 8, &faces);
  gjk_manifold m = meet(&hull, origin, &box, at(ONE, HALF, 2 * ONE - 100), 8);
  CHECK(m.count == 5 && has_point(&m, 0, -HALF, -100) && has_point(&m, ONE, -HALF, -100) &&
        has_point(&m, 0, ONE, -100) && has_point(&m, ONE, ONE, -100) && m.feature_a == 1);
}

// How far a point lies outside of a posed box, LSB; negative inside. Rounding has left its half axes a little askew, so its
// faces are taken as they are.
static double outside_box(const gjk_collider *c, const gjk_vec3 *p) {
  const double v[3] = {(double)p->x - c->centre.x, (double)p->y - c->centre.y, (double)p->z - c->centre.z};
  double worst = -1e30;
  for (int i = 0; i < 3; i++) {
    const gjk_vec3 *f = &c->frame[i], *g = &c->frame[(i + 1) % 3], *h = &c->frame[(i + 2) % 3];
    const double n[3] = {(double)g->y * h->z - (double)g->z * h->y, (double)g->z * h->x - (double)g->x * h->z,
                         (double)g->x * h->y - (double)g->y * h->x};
    const double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    const double along = fabs(v[0] * n[0] + v[1] * n[1] + v[2] * n[2]) / length;
    const double half = fabs(f->x * n[0] + f->y * n[1] + f->z * n[2]) / length;
    worst = along - half > worst ? along - half : worst;
  }
  return worst;
}

static double along_normal(const gjk_manifold *m, const gjk_contact *c) {
  return (((double)c->point_b.x - c->point_a.x) * m->normal.x + ((double)c->point_b.y - c->point_a.y) * m->normal.y +
          ((double)c->point_b.z - c->point_a.z) * m->normal.z) /
         1073741824.0;
}

typedef struct tally {
  unsigned long met[GJK_CONTACTS_MAX + 1], apart, deep, kept;
} tally;

static gjk_pose random_pose(random_state *random, gjk_q16 reach) {
  const gjk_quat q = {random_range(random, -1000, 1000), random_range(random, -1000, 1000),
                      random_range(random, -1000, 1000), random_range(random, 1, 1001)};
  gjk_pose pose = GJK_POSE_IDENTITY;
  if (random_below(random, 3) != 0) {
    gjk_quat_normalize(&q, &pose.rotation);
  }
  pose.position.x = random_range(random, -reach, reach);
  pose.position.y = random_range(random, -reach, reach);
  pose.position.z = random_range(random, -reach, reach);
  return pose;
}

// The same features and ids after a motion of an LSB or three, unless a point has come or gone.
static bool is_kept(const gjk_manifold *before, const gjk_manifold *after) {
  if (before->count != after->count || before->feature_a != after->feature_a || before->feature_b != after->feature_b) {
    return false;
  }
  for (unsigned i = 0; i < before->count; i++) {
    if (before->contact[i].id != after->contact[i].id) {
      return false;
    }
  }
  return true;
}

static void check_pair(const gjk_collider *a, const gjk_collider *b, gjk_q16 margin, unsigned most, tally *t, int n) {
  gjk_manifold m, mirrored;
  gjk_distance_result d;
  CHECK_MSG(gjk_contacts(a, b, margin, most, NULL, &workspace, &m) == GJK_OK &&
                gjk_signed_distance(a, b, NULL, &workspace, &d) == GJK_OK,
            "pair %d", n);
  CHECK_MSG((m.count > 0) == (d.distance <= margin) && m.count <= most, "pair %d: %d contacts", n, m.count);
  t->apart += m.count == 0;
  t->deep += m.count > 0 && d.distance < 0;
  t->met[m.count]++;
  if (m.count == 0) {
    return;
  }
  const gjk_q16 least = least_of(&m);
  for (unsigned i = 0; i < m.count; i++) {
    const gjk_contact *c = &m.contact[i];
    CHECK_MSG(c->distance <= margin && fabs(along_normal(&m, c) - c->distance) <= 3, "pair %d: %ld, %g", n,
              (long)c->distance, along_normal(&m, c));
    CHECK_MSG(outside_box(a, &c->point_a) <= 3 && outside_box(b, &c->point_b) <= 3, "pair %d: %g %g outside", n,
              outside_box(a, &c->point_a), outside_box(b, &c->point_b));
    for (unsigned k = 0; k < i; k++) {
      CHECK_MSG(m.contact[k].id != c->id, "pair %d: id twice", n);
    }
  }
  CHECK_MSG(is_near(least, d.distance, 3), "pair %d: %ld instead of %ld", n, (long)least, (long)d.distance);
  // The other way around: as deep, whichever of two equally near ways out it takes.
  CHECK_MSG(gjk_contacts(b, a, margin, most, NULL, &workspace, &mirrored) == GJK_OK && mirrored.count > 0 &&
                is_near(least_of(&mirrored), least, 3),
            "pair %d mirrored", n);
}

static void test_random(void) {
  random_state random = random_seed(61);
  tally t;
  memset(&t, 0, sizeof t);
  unsigned long moved = 0;
  for (int n = 0; n < PAIRS; n++) {
    gjk_collider a, b;
    const gjk_shape shape_a =
        GJK_BOX(random_range(&random, 6000, ONE), random_range(&random, 6000, ONE), random_range(&random, 6000, ONE));
    const gjk_shape shape_b =
        GJK_BOX(random_range(&random, 6000, ONE), random_range(&random, 6000, ONE), random_range(&random, 6000, ONE));
    const gjk_pose pose_a = random_pose(&random, ONE), pose_b = random_pose(&random, ONE);
    const unsigned most = random_below(&random, 2) == 0 ? 4 : 8;
    const gjk_q16 margin = random_range(&random, 0, 5000);
    place(&shape_a, &pose_a, &a);
    place(&shape_b, &pose_b, &b);
    check_pair(&a, &b, margin, most, &t, n);
    gjk_manifold before, after;
    if (gjk_contacts(&a, &b, margin, 8, NULL, &workspace, &before) == GJK_OK && before.count > 0) {
      gjk_vec3 position = pose_b.position;
      position.x += random_range(&random, -3, 3);
      position.y += random_range(&random, -3, 3);
      CHECK(gjk_collider_move(&b, &position) == GJK_OK &&
            gjk_contacts(&a, &b, margin, 8, NULL, &workspace, &after) == GJK_OK);
      moved++;
      t.kept += is_kept(&before, &after);
    }
  }
  printf("%d pairs, %lu apart, %lu deep; contacts 1: %lu, 2: %lu, 3: %lu, 4: %lu, 5 to 8: %lu; kept %lu of %lu\n",
         PAIRS, t.apart, t.deep, t.met[1], t.met[2], t.met[3], t.met[4], t.met[5] + t.met[6] + t.met[7] + t.met[8],
         t.kept, moved);
  const unsigned long few = (unsigned long)PAIRS / 600;
  CHECK(t.apart * 20 > (unsigned long)PAIRS && t.deep * 5 > (unsigned long)PAIRS && t.met[1] > few && t.met[2] > few &&
        t.met[3] > few && t.met[4] > few && t.met[5] + t.met[6] + t.met[7] + t.met[8] > few);
  // A point at the margin comes and goes now and then.
  CHECK(t.kept * 50 > moved * 49);
}

int main(void) {
  test_boxes();
  test_hulls();
  test_edges();
  test_round_shapes();
  test_features();
  test_flat_shapes();
  test_statuses();
  test_faces();
  test_reach();
  test_fewer();
  test_crossing_faces();
  test_repeated_corner();
  test_random();
  return check_done("contacts");
}
