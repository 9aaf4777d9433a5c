// Debug drawing: which lines and points there are of each kind of shape, that they lie on its surface, what is drawn of
// contacts, rays, casts and scenes, and what is refused.
#ifndef TEST_NAME
#include "gjk/draw.h"
#include "gjk/gjk.h"
#include "gjk/probe.h"
#define TEST_NAME "draw"
#define SPACE 1
#endif

#include "placed.h"

#include <math.h>
#include <string.h>

#include "check.h"
#include "random.h"
#include "src/arith/gjk_circle.h"

#define SEED 9300
#define TRIALS check_trials(300)
#define LINES 160
#define ONE GJK_Q16_ONE

#if SPACE
#define SIDES 12  // of a box
#define ROUND 72  // lines of three silhouettes
static const gjk_vec3 corners[6] = {{-30000, -30000, -30000}, {30000, -30000, -30000}, {-30000, 30000, -30000},
                                    {30000, 30000, -30000},   {0, -30000, 30000},      {0, 30000, 30000}};
// A wedge: its base, two slopes, two ends.
static const uint16_t corner_of[18] = {0, 2, 3, 1, 0, 1, 4, 2, 5, 3, 0, 4, 5, 2, 1, 3, 5, 4},
                      end_of[5] = {4, 7, 10, 14, 18};
static const gjk_hull_faces faces = {corner_of, end_of, 5};
static const gjk_shape shapes[] = {GJK_POINT,
                                   GJK_SEGMENT(ONE),
                                   GJK_TRIANGLE(corners),
                                   GJK_BOX(ONE, ONE / 2, ONE / 3),
                                   GJK_HULL_WITH_FACES(corners, 6, &faces),
                                   GJK_HULL(corners, 6),
                                   GJK_SPHERE(ONE),
                                   GJK_CAPSULE(ONE / 4, ONE),
                                   GJK_ROUNDED_BOX(ONE, ONE / 2, ONE / 3, ONE / 8),
                                   GJK_ROUNDED_HULL_WITH_FACES(corners, 6, &faces, ONE / 8),
                                   GJK_CYLINDER(ONE, ONE / 2),
                                   GJK_CONE(ONE, ONE / 2),
                                   GJK_ELLIPSOID(ONE, ONE / 2, ONE / 3)};
#else
#define SIDES 4
#define ROUND 24
static const gjk_vec3 corners[6] = {{-30000, -30000}, {0, -36000}, {30000, -30000},
                                    {36000, 9000},    {0, 30000},  {-33000, 4000}};
static const gjk_vec3 shuffled[6] = {{30000, -30000}, {-30000, -30000}, {0, 30000},
                                     {36000, 9000},   {0, 0},           {-33000, 4000}};
static const gjk_shape shapes[] = {GJK2_POINT,
                                   GJK2_SEGMENT(ONE),
                                   GJK2_TRIANGLE(corners),
                                   GJK2_BOX(ONE, ONE / 2),
                                   GJK2_POLYGON(corners, 6),
                                   GJK2_POLYGON(shuffled, 6),
                                   GJK2_CIRCLE(ONE),
                                   GJK2_CAPSULE(ONE / 4, ONE),
                                   GJK2_ROUNDED_BOX(ONE, ONE / 2, ONE / 8),
                                   GJK2_ROUNDED_POLYGON(corners, 6, ONE / 8),
                                   GJK2_ELLIPSE(ONE, ONE / 2)};
#endif
#define SHAPES (sizeof shapes / sizeof shapes[0])

// The lines of each shape: exactly so many, or of silhouettes at most.
#if SPACE
static const unsigned edges[SHAPES] = {0, 1, 3, 12, 9, 0, 0, 1, 12, 9, 0, 0, 0};
#else
static const unsigned edges[SHAPES] = {0, 1, 3, 4, 6, 0, 0, 0, 0, 0, 0};
#endif

typedef struct drawing {
  gjk_vec3 from[LINES], to[LINES], point[LINES];
  gjk_draw_role role[LINES], role_of_point[LINES];
  unsigned lines, points;
} drawing;

static drawing drawn;

static void take_line(void *user, const gjk_vec3 *from, const gjk_vec3 *to, gjk_draw_role role) {
  drawing *d = user;
  CHECK(memcmp(from, to, sizeof *from) != 0);
  CHECK(d->lines < LINES);
  if (d->lines < LINES) {
    d->from[d->lines] = *from;
    d->to[d->lines] = *to;
    d->role[d->lines++] = role;
  }
}

static void take_point(void *user, const gjk_vec3 *at, gjk_draw_role role) {
  drawing *d = user;
  CHECK(d->points < LINES);
  if (d->points < LINES) {
    d->point[d->points] = *at;
    d->role_of_point[d->points++] = role;
  }
}

static const gjk_draw out = {take_line, take_point, &drawn}, nothing = {NULL, NULL, NULL};

static void clear(void) {
  drawn.lines = drawn.points = 0;
}

static gjk_vec3 at(gjk_q16 x, gjk_q16 y) {
  gjk_vec3 v = {0};
  v.x = x;
  v.y = y;
  return v;
}

static gjk_collider place_at(const gjk_shape *shape, gjk_q16 x, gjk_q16 y) {
  return placed(shape, at(x, y));
}

static gjk_pose random_pose(random_state *random) {
  gjk_pose pose = GJK_POSE_IDENTITY;
  int32_t *word = (int32_t *)(void *)&pose.rotation;
  do {
    for (size_t i = 0; i < sizeof pose.rotation / sizeof *word; i++) {
      word[i] = random_range(random, -ONE, ONE);
    }
  } while (gjk_quat_normalize(&pose.rotation, &pose.rotation) != GJK_OK);
  pose.position = at(random_range(random, -9 * ONE, 9 * ONE), random_range(random, -9 * ONE, 9 * ONE));
  return pose;
}

// How far outside of a shape a point is, or minus how deep inside.
static gjk_q16 height_of(const gjk_vec3 *p, const gjk_collider *c) {
  gjk_pose pose = GJK_POSE_IDENTITY;
  pose.position = *p;
  const gjk_collider point = posed(&shapes[0], &pose);
  gjk_distance_result gap;
#if SPACE
  static gjk_epa_cell cells[GJK_EPA_CURVED_CELLS];
  const gjk_workspace workspace = {cells, GJK_EPA_CURVED_CELLS};
  CHECK(gjk_signed_distance(&point, c, NULL, &workspace, &gap) == GJK_OK);
#else
  CHECK(gjk_signed_distance(&point, c, NULL, &gap) == GJK_OK);
#endif
  return gap.distance;
}

static bool is_end(const gjk_vec3 *p) {
  unsigned ends = 0;
  for (unsigned i = 0; i < drawn.lines; i++) {
    ends += memcmp(p, &drawn.from[i], sizeof *p) == 0;
    ends += memcmp(p, &drawn.to[i], sizeof *p) == 0;
  }
  return ends >= 2;
}

// Every kind at random poses: how many lines, all on the surface; vertices exactly; what is closed is closed.
static void check_outlines(void) {
  random_state random = random_seed(check_seed(SEED));
  for (unsigned long n = 0; n < TRIALS; n++) {
    check_trial(n, NULL, NULL);
    const unsigned kind = (unsigned)(n % SHAPES);
    const gjk_shape *shape = &shapes[kind];
    const gjk_pose pose = random_pose(&random);
    const gjk_collider c = posed(shape, &pose);
    clear();
    CHECK(gjk_draw_collider(&out, &c, GJK_DRAW_SENSOR) == GJK_OK);
    const bool round = edges[kind] == 0 || shape->convex_radius > 0;
    if (kind == 0) {
      CHECK(drawn.lines == 0 && drawn.points == 1 && drawn.role_of_point[0] == GJK_DRAW_SENSOR);
      CHECK(memcmp(&drawn.point[0], &pose.position, sizeof pose.position) == 0);
      continue;
    }
    CHECK(drawn.points == 0);
    CHECK_MSG(round ? drawn.lines > edges[kind] + ROUND / 24 * 2 && drawn.lines <= edges[kind] + ROUND
                    : drawn.lines == edges[kind],
              "kind %u: %u lines", kind, drawn.lines);
    for (unsigned i = 0; i < drawn.lines; i++) {
      const bool edge = i < edges[kind];  // of the core
      const gjk_q16 from = height_of(&drawn.from[i], &c) + (edge ? shape->convex_radius : 0);
      const gjk_q16 to = height_of(&drawn.to[i], &c) + (edge ? shape->convex_radius : 0),
                    most = edge && !shape->convex_radius ? 0 : 4;
      CHECK_MSG(from <= most && from >= -most && to <= most && to >= -most, "kind %u: %d %d", kind, (int)from, (int)to);
      CHECK(drawn.role[i] == GJK_DRAW_SENSOR);
      CHECK(edges[kind] == 1 || (is_end(&drawn.from[i]) && is_end(&drawn.to[i])));
      for (unsigned k = 0; k < i && edge; k++) {  // each edge comes once
        CHECK(memcmp(&drawn.from[i], &drawn.from[k], sizeof *drawn.from) != 0 ||
              memcmp(&drawn.to[i], &drawn.to[k], sizeof *drawn.to) != 0);
        CHECK(memcmp(&drawn.from[i], &drawn.to[k], sizeof *drawn.from) != 0 ||
              memcmp(&drawn.to[i], &drawn.from[k], sizeof *drawn.to) != 0);
      }
    }
    CHECK(gjk_draw_collider(&nothing, &c, GJK_DRAW_SENSOR) == GJK_OK);
  }
}

// Of a ball all lines are chords of its circles, all round.
static void check_ball(void) {
  const gjk_collider c = place_at(&shapes[6], 5 * ONE, -ONE);
  gjk_aabb box, seen;
  clear();
  CHECK(gjk_draw_collider(&out, &c, GJK_DRAW_MOVING) == GJK_OK);
  CHECK(drawn.lines == ROUND && gjk_collider_aabb(&c, &box) == GJK_OK);
  seen.lower = seen.upper = drawn.from[0];
  for (unsigned i = 0; i < drawn.lines; i++) {
    const gjk_vec3 *p = &drawn.from[i], *q = &drawn.to[i];
    const int64_t x = (int64_t)q->x - p->x, y = (int64_t)q->y - p->y;
    int64_t squared = x * x + y * y;
#if SPACE
    squared += ((int64_t)q->z - p->z) * ((int64_t)q->z - p->z);
    seen.upper.z = p->z > seen.upper.z ? p->z : seen.upper.z;
    seen.lower.z = p->z < seen.lower.z ? p->z : seen.lower.z;
#endif
    CHECK(squared > INT64_C(17100) * 17100 && squared < INT64_C(17120) * 17120);  // 2 sin(7.5 degrees) = 0.26105
    seen.upper.x = p->x > seen.upper.x ? p->x : seen.upper.x;
    seen.lower.x = p->x < seen.lower.x ? p->x : seen.lower.x;
    seen.upper.y = p->y > seen.upper.y ? p->y : seen.upper.y;
    seen.lower.y = p->y < seen.lower.y ? p->y : seen.lower.y;
  }
  CHECK(memcmp(&seen, &box, sizeof box) == 0);
}

// Boxes, flat ones too, and those at the ends of the world.
static void check_boxes(void) {
  gjk_aabb box = {0};
  clear();
  CHECK(gjk_draw_box(&out, &box, GJK_DRAW_BOX) == GJK_OK && drawn.lines == 0);
  box.upper.x = 5;
  CHECK(gjk_draw_box(&out, &box, GJK_DRAW_BOX) == GJK_OK && drawn.lines == SIDES / (SPACE ? 3 : 2));
  memset(&box.lower, 0x80, sizeof box.lower);
  memset(&box.upper, 0x7F, sizeof box.upper);
  clear();
  CHECK(gjk_draw_box(&out, &box, GJK_DRAW_BOX) == GJK_OK && drawn.lines == SIDES);
  for (unsigned i = 0; i < SIDES; i++) {
    const gjk_vec3 *p = &drawn.from[i], *q = &drawn.to[i];
    int differ = (p->x != q->x) + (p->y != q->y);
#if SPACE
    differ += p->z != q->z;
#endif
    CHECK(differ == 1);
    CHECK(is_end(p) && is_end(q) && drawn.role[i] == GJK_DRAW_BOX);
  }
  gjk_collider c = place_at(&shapes[3], INT32_MAX, INT32_MIN);
  clear();
  CHECK(gjk_draw_collider(&out, &c, GJK_DRAW_STATIC) == GJK_OK && drawn.lines > 0);
  for (unsigned i = 0; i < drawn.lines; i++) {
    CHECK(drawn.from[i].x > 0 && drawn.from[i].y < 0);  // saturated, not wrapped
  }
}

static void check_contacts(void) {
  const gjk_collider a = place_at(&shapes[3], 0, 0), b = place_at(&shapes[3], 2 * ONE + 100, 0);
  gjk_manifold m;
#if SPACE
  CHECK(gjk_contacts(&a, &b, ONE, 4, NULL, NULL, &m) == GJK_OK && m.count == 4);
#else
  CHECK(gjk_contacts(&a, &b, ONE, 2, NULL, &m) == GJK_OK && m.count == 2);
#endif
  clear();
  CHECK(gjk_draw_manifold(&out, &m, ONE) == GJK_OK);
  CHECK(drawn.lines == 2u * m.count && drawn.points == 2u * m.count);
  for (unsigned i = 0; i < m.count; i++) {
    CHECK(drawn.role[2 * i] == GJK_DRAW_CONTACT && drawn.role[2 * i + 1] == GJK_DRAW_NORMAL);
    CHECK(memcmp(&drawn.point[2 * i], &m.contact[i].point_a, sizeof *drawn.point) == 0);
    CHECK(memcmp(&drawn.point[2 * i + 1], &m.contact[i].point_b, sizeof *drawn.point) == 0);
    CHECK(drawn.to[2 * i].x - drawn.from[2 * i].x == 100);
    CHECK(drawn.to[2 * i + 1].x - drawn.from[2 * i + 1].x == ONE && drawn.to[2 * i + 1].y == drawn.from[2 * i + 1].y);
  }
  m.count = 0;
  clear();
  CHECK(gjk_draw_manifold(&out, &m, INT32_MIN) == GJK_OK && drawn.lines + drawn.points == 0);
  CHECK(gjk_draw_manifold(&nothing, &m, ONE) == GJK_OK);
}

static void check_casts(void) {
  const gjk_collider wall = place_at(&shapes[3], 0, 0), ball = place_at(&shapes[6], -9 * ONE, 0);
  const gjk_vec3 from = at(-9 * ONE, 0), to = at(9 * ONE, 0), past = at(9 * ONE, 9 * ONE);
  gjk_cast_result result;
  gjk_collider unposed = {0};
  CHECK(gjk_cast_ray(&wall, &from, &to, &result) == GJK_OK && result.hit);
  clear();
  CHECK(gjk_draw_ray(&out, &from, &to, &result, ONE) == GJK_OK && drawn.lines == 2 && drawn.points == 1);
  CHECK(drawn.role[0] == GJK_DRAW_WAY && drawn.to[0].x == -ONE && drawn.role[1] == GJK_DRAW_NORMAL);
  CHECK(drawn.to[1].x == -2 * ONE && drawn.role_of_point[0] == GJK_DRAW_CONTACT);
  CHECK(gjk_cast_ray(&wall, &from, &past, &result) == GJK_OK && !result.hit);
  clear();
  CHECK(gjk_draw_ray(&out, &from, &past, &result, ONE) == GJK_OK && drawn.lines == 1 && drawn.points == 0);
  CHECK(drawn.to[0].y == past.y);
  CHECK(gjk_cast_ray(&wall, &wall.centre, &past, &result) == GJK_OK && result.inside);
  clear();
  CHECK(gjk_draw_ray(&out, &wall.centre, &past, &result, ONE) == GJK_OK && drawn.lines + drawn.points == 0);

  const gjk_cast_path path = {NULL, &to, 0};
  CHECK(gjk_cast(&wall, &ball, &path, &result) == GJK_OK && result.hit);
  gjk_draw few = out;
  few.line = NULL;
  clear();
  CHECK(gjk_draw_cast(&few, &ball, &to, &result, ONE) == GJK_OK && drawn.lines == 0 && drawn.points == 1);
  for (int miss = 0; miss < 2; miss++) {  // the way to the hit, and to the end without one
    result.hit = miss == 0;
    clear();
    CHECK(gjk_draw_cast(&out, &ball, &to, &result, ONE) == GJK_OK);
    CHECK(drawn.lines == 2 * ROUND + (miss ? 1u : 2u) && drawn.points == (miss ? 0u : 1u));
    const gjk_q16 end = miss ? 9 * ONE : result.rest_b.x, way = end - ball.centre.x;
    CHECK(drawn.from[2 * ROUND].x == -9 * ONE && drawn.to[2 * ROUND].x == end && drawn.role[0] == GJK_DRAW_WAY);
    for (unsigned i = 0; i < ROUND; i++) {  // the same outline
      CHECK(drawn.from[ROUND + i].x - drawn.from[i].x == way && drawn.from[ROUND + i].y == drawn.from[i].y);
    }
  }
  clear();
  CHECK(gjk_draw_cast(&out, &unposed, &to, &result, ONE) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk_draw_cast(&out, NULL, &to, &result, ONE) == GJK_ERROR_NULL);
  CHECK(gjk_draw_cast(&out, &ball, NULL, &result, ONE) == GJK_ERROR_NULL);
  CHECK(gjk_draw_cast(&out, &ball, &to, NULL, ONE) == GJK_ERROR_NULL);
  CHECK(gjk_draw_cast(NULL, &ball, &to, &result, ONE) == GJK_ERROR_NULL);
  CHECK(gjk_draw_ray(NULL, &from, &to, &result, ONE) == GJK_ERROR_NULL);
  CHECK(gjk_draw_ray(&out, NULL, &to, &result, ONE) == GJK_ERROR_NULL);
  CHECK(gjk_draw_ray(&out, &from, NULL, &result, ONE) == GJK_ERROR_NULL);
  CHECK(gjk_draw_ray(&out, &from, &to, NULL, ONE) == GJK_ERROR_NULL);
  CHECK(gjk_draw_manifold(NULL, NULL, ONE) == GJK_ERROR_NULL && gjk_draw_manifold(&out, NULL, ONE) == GJK_ERROR_NULL);
  CHECK(gjk_draw_box(&out, NULL, GJK_DRAW_BOX) == GJK_ERROR_NULL);
  CHECK(gjk_draw_collider(&out, NULL, GJK_DRAW_BOX) == GJK_ERROR_NULL);
  CHECK(gjk_draw_collider(NULL, &ball, GJK_DRAW_BOX) == GJK_ERROR_NULL);
  CHECK(gjk_draw_collider(&out, &unposed, GJK_DRAW_BOX) == GJK_ERROR_UNINITIALISED);
  CHECK(drawn.lines + drawn.points == 0);
}

static gjk_body_id add(gjk_scene *scene, uint8_t kind, uint8_t detail, gjk_q16 x, uint16_t parts) {
  static const gjk_part part[2] = {{0, false, GJK_POSE_IDENTITY}, {0, false, GJK_POSE_IDENTITY}};
  gjk_body_setup setup = {.pose = GJK_POSE_IDENTITY, .category = 1, .mask = 1};
  gjk_body_id id = {0, 0};
  setup.parts = part;
  setup.part_count = parts;
  setup.kind = kind;
  setup.detail = detail;
  setup.pose.position = at(x, 0);
  CHECK(gjk_scene_add(scene, &setup, &id) == GJK_OK);
  return id;
}

static unsigned lines_of(gjk_draw_role role) {
  unsigned count = 0;
  for (unsigned i = 0; i < drawn.lines; i++) {
    count += drawn.role[i] == role;
  }
  return count;
}

static void check_scene(void) {
  static uint32_t block[4096];
  static const gjk_shape *const kinds[] = {&shapes[3]};
  const gjk_scene_config config = {.bodies = 8, .parts = 9, .pairs = 20};
  gjk_scene scene;
  gjk_report reports[20];
  gjk_progress progress;
  CHECK(gjk_scene_init(&scene, &config, block, sizeof block, kinds, 1, NULL) == GJK_OK);
  clear();
  CHECK(gjk_draw_scene(&out, &scene, 7) == GJK_OK && drawn.lines == 0);  // nothing in it
  const gjk_body_id fixed = add(&scene, GJK_BODY_STATIC, GJK_DETAIL_TOUCH, 0, 1);
  const gjk_body_id mover = add(&scene, GJK_BODY_DYNAMIC, GJK_DETAIL_TOUCH, ONE, 2);
  const gjk_body_id asleep = add(&scene, GJK_BODY_DYNAMIC, GJK_DETAIL_TOUCH, 20 * ONE, 1);
  (void)add(&scene, GJK_BODY_KINEMATIC, GJK_DETAIL_SENSOR, 40 * ONE, 1);
  CHECK(gjk_scene_sleep(&scene, asleep) == GJK_OK);
  CHECK(gjk_scene_update(&scene, reports, 20, &progress) == GJK_OK && progress.reports == 2);
  clear();
  CHECK(gjk_draw_scene(&out, &scene, GJK_DRAW_SHAPES | GJK_DRAW_PAIRS) == GJK_OK);
  CHECK(lines_of(GJK_DRAW_STATIC) == SIDES && lines_of(GJK_DRAW_MOVING) == 2 * SIDES);
  CHECK(lines_of(GJK_DRAW_ASLEEP) == SIDES && lines_of(GJK_DRAW_SENSOR) == SIDES && lines_of(GJK_DRAW_PAIR) == 2);
  CHECK(drawn.lines == 5 * SIDES + 2);
  const unsigned last = drawn.lines - 1;
  CHECK(drawn.from[last].x == 0 && drawn.to[last].x == ONE);
  clear();
  CHECK(gjk_draw_scene(&out, &scene, GJK_DRAW_BOXES) == GJK_OK && lines_of(GJK_DRAW_BOX) == 5 * SIDES);
  CHECK(drawn.lines == 5 * SIDES && drawn.from[0].x == -ONE);
  clear();
  CHECK(gjk_draw_scene(&out, &scene, 0) == GJK_OK && drawn.lines == 0);
  CHECK(gjk_draw_scene(&nothing, &scene, 7) == GJK_OK);
  // A pair whose body is gone has no line, though it is near until its end is reported.
  CHECK(gjk_scene_remove(&scene, fixed) == GJK_OK);
  CHECK(gjk_draw_scene(&out, &scene, GJK_DRAW_SHAPES | GJK_DRAW_PAIRS) == GJK_OK);
  CHECK(lines_of(GJK_DRAW_PAIR) == 0 && lines_of(GJK_DRAW_STATIC) == 0 && lines_of(GJK_DRAW_MOVING) == 2 * SIDES);
  (void)mover;
  clear();
  CHECK(gjk_draw_scene(&out, &scene, 8) == GJK_ERROR_RANGE && gjk_draw_scene(&out, &scene, 15) == GJK_ERROR_RANGE);
  CHECK(gjk_draw_scene(NULL, &scene, 7) == GJK_ERROR_NULL && gjk_draw_scene(&out, NULL, 7) == GJK_ERROR_NULL);
  block[0]++;
  CHECK(gjk_draw_scene(&out, &scene, 7) == GJK_ERROR_CORRUPT);
  CHECK(drawn.lines == 0);
}

// So far along a direction, to the nearest LSB.
static gjk_q16 along(gjk_q30 x, gjk_q16 length) {
  return (gjk_q16)(((INT64_C(1) << 60) + GJK_Q30_ONE / 2 + (int64_t)x * length) / GJK_Q30_ONE - GJK_Q30_ONE);
}

// Directions of outlines, to the nearest LSB: as the header has them, and as the outlines of large balls show them.
static void check_directions(void) {
  for (unsigned i = 0; i < GJK_DRAW_DIRECTIONS; i++) {
    const double angle = i * 3.14159265358979323846 / (GJK_DRAW_DIRECTIONS / 2);
    gjk_q30 x, y;
    gjk_circle(i, &x, &y);
    CHECK(x == llround(cos(angle) * GJK_Q30_ONE) && y == llround(sin(angle) * GJK_Q30_ONE));
    for (gjk_q16 radius = GJK_RADIUS_MAX; radius > GJK_RADIUS_MAX / 2; radius -= 3000017) {
#if SPACE
      const gjk_shape ball = GJK_SPHERE(radius);
#else
      const gjk_shape ball = GJK2_CIRCLE(radius);
#endif
      const gjk_collider c = place_at(&ball, 0, 0);
      clear();
      CHECK(gjk_draw_collider(&out, &c, GJK_DRAW_MOVING) == GJK_OK && drawn.lines == ROUND);
      const gjk_vec3 *p = &drawn.from[ROUND - GJK_DRAW_DIRECTIONS + i];  // of the last silhouette
      CHECK(p->x == along(x, radius) && p->y == along(y, radius));
    }
  }
}

int main(void) {
  check_directions();
  check_outlines();
  check_ball();
  check_boxes();
  check_contacts();
  check_casts();
  check_scene();
  return check_done(TEST_NAME);
}
