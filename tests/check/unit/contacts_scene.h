// What tests of contacts share: shapes, poses, and a look at the points of a manifold.
#ifndef CONTACTS_SCENE_H
#define CONTACTS_SCENE_H

#include <string.h>

#include "check.h"
#include "gjk/gjk.h"
#include "placed.h"

#define ONE GJK_Q16_ONE
#define HALF (ONE / 2)
#define QUARTER_TURN GJK_ANGLE(1.5707963)
#define EIGHTH_TURN GJK_ANGLE(0.7853982)
#define MARGIN 655
#define CELLS GJK_EPA_CELLS(64)

static gjk_epa_cell cells[CELLS];
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

static inline gjk_pose at(gjk_q16 x, gjk_q16 y, gjk_q16 z) {
  gjk_pose pose = GJK_POSE_IDENTITY;
  pose.position.x = x;
  pose.position.y = y;
  pose.position.z = z;
  return pose;
}

static inline gjk_pose turned(gjk_pose pose, const gjk_vec3 *axis, gjk_angle angle) {
  CHECK(gjk_quat_from_axis_angle(axis, angle, &pose.rotation) == GJK_OK);
  return pose;
}

static inline gjk_manifold meet(const gjk_shape *a, gjk_pose pose_a, const gjk_shape *b, gjk_pose pose_b,
                                unsigned most) {
  const gjk_collider one = posed(a, &pose_a), two = posed(b, &pose_b);
  gjk_manifold m = {0};
  CHECK(gjk_contacts(&one, &two, MARGIN, most, NULL, &workspace, &m) == GJK_OK);
  return m;
}

static inline bool is_near(gjk_q16 a, gjk_q16 b, gjk_q16 tolerance) {
  return a - b <= tolerance && b - a <= tolerance;
}

// Is there a contact of A's point at (x, y), to 3 LSB, as deep as is said?
static inline bool has_point(const gjk_manifold *m, gjk_q16 x, gjk_q16 y, gjk_q16 distance) {
  for (unsigned i = 0; i < m->count; i++) {
    const gjk_contact *c = &m->contact[i];
    if (is_near(c->point_a.x, x, 3) && is_near(c->point_a.y, y, 3) && is_near(c->distance, distance, 2)) {
      return true;
    }
  }
  return false;
}

typedef struct known_point {
  gjk_q16 x, y, distance;
} known_point;

// So many contacts, among them the known ones.
static inline void check_points(const gjk_manifold *m, unsigned count, const known_point *known, size_t points,
                                int line) {
  CHECK_MSG(m->count == count, "line %d: %u", line, m->count);
  for (size_t i = 0; i < points; i++) {
    CHECK_MSG(has_point(m, known[i].x, known[i].y, known[i].distance), "line %d: point %u", line, (unsigned)i);
  }
}

#define HAS(m, count, ...)                                      \
  check_points(&(m), count, (const known_point[]){__VA_ARGS__}, \
               sizeof((const known_point[]){__VA_ARGS__}) / sizeof(known_point), __LINE__)

static inline bool has_corners(const gjk_manifold *m, gjk_q16 half, gjk_q16 distance) {
  return m->count == 4 && has_point(m, half, half, distance) && has_point(m, -half, half, distance) &&
         has_point(m, half, -half, distance) && has_point(m, -half, -half, distance);
}

static inline gjk_q16 least_of(const gjk_manifold *m) {
  gjk_q16 least = GJK_DISTANCE_MAX;
  for (unsigned i = 0; i < m->count; i++) {
    least = m->contact[i].distance < least ? m->contact[i].distance : least;
  }
  return least;
}

#endif
