// Makes the families of pairs for which instructions are counted.
#include "bench.h"

#include "random.h"

const bench_family bench_families[] = {
    {.name = "8-point hulls apart: distance", .query = BENCH_DISTANCE, .vertices = 8, .gap = BENCH_APART},
    {.name = "8-point hulls apart: intersect", .query = BENCH_INTERSECT, .vertices = 8, .gap = BENCH_APART},
    {.name = "8-point hulls close: distance", .query = BENCH_DISTANCE, .vertices = 8, .gap = BENCH_CLOSE},
    {.name = "8-point hulls close: intersect", .query = BENCH_INTERSECT, .vertices = 8, .gap = BENCH_CLOSE},
    {.name = "8-point hulls overlapping: intersect", .query = BENCH_INTERSECT, .vertices = 8, .gap = BENCH_OVERLAPPING},
    {.name = "64-point hulls apart: distance", .query = BENCH_DISTANCE, .vertices = 64, .gap = BENCH_APART},
    {.name = "64-point hulls close: intersect", .query = BENCH_INTERSECT, .vertices = 64, .gap = BENCH_CLOSE},
    {.name = "boxes apart: distance", .query = BENCH_DISTANCE, .gap = BENCH_APART},
    {.name = "boxes apart: intersect", .query = BENCH_INTERSECT, .gap = BENCH_APART},
    {.name = "boxes close: intersect", .query = BENCH_INTERSECT, .gap = BENCH_CLOSE},
    {.name = "boxes overlapping: intersect", .query = BENCH_INTERSECT, .gap = BENCH_OVERLAPPING},
    {.name = "boxes overlapping: depth", .query = BENCH_DEPTH, .gap = BENCH_OVERLAPPING},
    {.name = "8-point hulls overlapping: depth", .query = BENCH_DEPTH, .vertices = 8, .gap = BENCH_OVERLAPPING},
    {.name = "32-point hulls overlapping: depth", .query = BENCH_DEPTH, .vertices = 32, .gap = BENCH_OVERLAPPING},
    {.name = "boxes face to face: contacts", .query = BENCH_CONTACTS, .gap = BENCH_PRESSED},
    {.name = "boxes face to face within the margin: contacts", .query = BENCH_CONTACTS, .gap = BENCH_HOVERING},
    {.name = "8-point hulls face to face: contacts", .query = BENCH_CONTACTS, .vertices = 8, .gap = BENCH_PRESSED},
    {.name = "boxes that turn: impact", .query = BENCH_IMPACT, .gap = BENCH_MOVING},
    {.name = "8-point hulls that turn: impact", .query = BENCH_IMPACT, .vertices = 8, .gap = BENCH_MOVING},
};
const unsigned bench_family_count = sizeof bench_families / sizeof bench_families[0];

// Cells enough for the depths of the 32-point hulls here.
#define BENCH_CELLS GJK_EPA_CELLS(24)

static random_state random;
static gjk_epa_cell cells[BENCH_CELLS];
static gjk_vec3 vertices[2][BENCH_VERTICES], buffers[2][BENCH_VERTICES];
static gjk_shape shapes[2];
static gjk_collider colliders[2];

static const uint16_t frustum_corners[24] = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
static const uint16_t frustum_ends[6] = {4, 8, 12, 16, 20, 24};
static const gjk_hull_faces frustum_faces = {frustum_corners, frustum_ends, 6};

gjk_motion bench_motion[2];
const gjk_collider *const bench_pair[2] = {&colliders[0], &colliders[1]};
bench_answer bench_expected;
const gjk_workspace bench_workspace = {cells, BENCH_CELLS};

static gjk_vec3 random_vector(int32_t size) {
  gjk_vec3 v;
  v.x = random_range(&random, -size, size);
  v.y = random_range(&random, -size, size);
  v.z = random_range(&random, -size, size);
  return v;
}

// A point 0.8 to 1 unit from the origin.
static gjk_vec3 shell_vector(void) {
  for (;;) {
    const gjk_vec3 v = random_vector(GJK_Q16_ONE);
    const int64_t squared = (int64_t)v.x * v.x + (int64_t)v.y * v.y + (int64_t)v.z * v.z;
    const int64_t unit = (int64_t)GJK_Q16_ONE * GJK_Q16_ONE;
    if (squared <= unit && squared * 25 >= unit * 16) {
      return v;
    }
  }
}

static gjk_quat random_rotation(int32_t xy, int32_t z, int32_t least_w) {
  const gjk_quat q = {random_range(&random, -xy, xy), random_range(&random, -xy, xy), random_range(&random, -z, z),
                      random_range(&random, least_w, 1001)};
  gjk_quat unit = {0, 0, 0, GJK_Q30_ONE};
  gjk_quat_normalize(&q, &unit);
  return unit;
}

static void place(int i, const gjk_pose *pose) {
  colliders[i].state = 0;
  gjk_collider_init(&colliders[i], &shapes[i], buffers[i], BENCH_VERTICES);
  gjk_collider_pose(&colliders[i], pose);
}

static void make_body(const bench_family *family, int i) {
  const gjk_shape hull = GJK_HULL(vertices[i], 0);
  const gjk_shape box = GJK_BOX(0, 0, 0);
  shapes[i] = family->vertices != 0 ? hull : box;
  shapes[i].count = family->vertices;
  for (unsigned k = 0; k < family->vertices; k++) {
    vertices[i][k] = shell_vector();
  }
  shapes[i].size.x = random_range(&random, GJK_Q16(0.2), GJK_Q16(1.0));
  shapes[i].size.y = random_range(&random, GJK_Q16(0.2), GJK_Q16(1.0));
  shapes[i].size.z = random_range(&random, GJK_Q16(0.2), GJK_Q16(1.0));
  gjk_pose pose;
  pose.rotation = random_rotation(1000, 1000, -1000);
  pose.position = random_vector(GJK_Q16(3.0));
  bench_motion[i].from = pose;
  place(i, &pose);
}

// A turns in place; B moves to within a unit of it, and turns, each by about half a turn.
static void make_motion(void) {
  const gjk_vec3 away = random_vector(GJK_Q16(0.57));
  for (int i = 0; i < 2; i++) {
    const gjk_vec3 axis = shell_vector();
    gjk_motion *m = &bench_motion[i];
    m->to = m->from;
    m->spin.x = (int32_t)((int64_t)axis.x * 7 / 2);
    m->spin.y = (int32_t)((int64_t)axis.y * 7 / 2);
    m->spin.z = (int32_t)((int64_t)axis.z * 7 / 2);
  }
  bench_motion[1].to.position.x = bench_motion[0].from.position.x + away.x;
  bench_motion[1].to.position.y = bench_motion[0].from.position.y + away.y;
  bench_motion[1].to.position.z = bench_motion[0].from.position.z + away.z;
}

// Do the shapes share a point at a sixteenth of the way? Then they meet for sure.
static bool meets(void) {
  gjk_decision touch = {.yes = false};
  for (int k = 0; k <= 16 && !touch.yes; k++) {
    for (int i = 0; i < 2; i++) {
      gjk_pose pose = GJK_POSE_IDENTITY;
      gjk_motion_pose(&bench_motion[i], k * (GJK_Q30_ONE / 16), &pose);
      gjk_collider_pose(&colliders[i], &pose);
    }
    gjk_intersect(&colliders[0], &colliders[1], NULL, &touch);
  }
  return touch.yes;
}

// The frustum of a pyramid that stands in the body's box. Its top is half as large to as large as its base.
static void make_frustum(int i) {
  const gjk_vec3 size = shapes[i].size;
  const int32_t share = random_range(&random, 128, 256);
  for (unsigned k = 0; k < 8; k++) {
    gjk_vec3 *v = &vertices[i][k];
    const int32_t wide = k < 4 ? 256 : share;
    v->x = (k % 2 == 0 ? -size.x : size.x) / 256 * wide;
    v->y = (k / 2 % 2 == 0 ? -size.y : size.y) / 256 * wide;
    v->z = k < 4 ? -size.z : size.z;
  }
  const gjk_shape frustum = GJK_HULL_WITH_FACES(vertices[i], 8, &frustum_faces);
  shapes[i] = frustum;
  shapes[i].size = size;
}

// Stands B on A.
static void make_stack(const bench_family *family) {
  const bench_family boxes = {"", family->query, 0, family->gap};
  gjk_pose below = GJK_POSE_IDENTITY, above;
  gjk_vec3 offset;
  for (int i = 0; i < 2; i++) {
    make_body(&boxes, i);
    if (family->vertices == 8) {
      make_frustum(i);
    }
  }
  offset.x = random_range(&random, -shapes[0].size.x / 2, shapes[0].size.x / 2);
  offset.y = random_range(&random, -shapes[0].size.y / 2, shapes[0].size.y / 2);
  offset.z = shapes[0].size.z + shapes[1].size.z + random_range(&random, -GJK_Q16(0.05), BENCH_MARGIN);
  below.rotation = random_rotation(1000, 1000, -1000);
  below.position = random_vector(GJK_Q16(3.0));
  const gjk_quat spin = random_rotation(6, 1000, 1000);
  gjk_quat_compose(&below.rotation, &spin, &above.rotation);
  gjk_pose_apply(&below, &offset, &above.position);
  place(0, &below);
  place(1, &above);
}

void bench_start(void) {
  random = random_seed(50);
}

static bool is_in_family(const bench_family *family, const gjk_distance_result *gap) {
  switch (family->gap) {
    case BENCH_APART:
    case BENCH_MOVING: return gap->distance >= GJK_Q16(0.1) && gap->distance <= GJK_Q16(2.0);
    case BENCH_CLOSE: return gap->distance < GJK_Q16(0.1) && !gap->intersecting;
    case BENCH_OVERLAPPING: return gap->intersecting;
    case BENCH_PRESSED: return gap->distance <= 0 && gap->distance >= -GJK_Q16(0.05);
    case BENCH_HOVERING: return gap->distance > 0 && gap->distance <= BENCH_MARGIN;
  }
  return false;
}

static bool is_depth_proven(void) {
  gjk_penetration_result depth;
  return gjk_penetration(&colliders[0], &colliders[1], NULL, &bench_workspace, &depth) == GJK_OK &&
         gjk_check_penetration(&colliders[0], &colliders[1], &depth) == GJK_OK;
}

bool bench_next(const bench_family *family) {
  const bool stacked = family->gap == BENCH_PRESSED || family->gap == BENCH_HOVERING,
             deep = family->query == BENCH_DEPTH || family->query == BENCH_CONTACTS;
  for (;;) {
    gjk_distance_result gap;
    if (stacked) {
      make_stack(family);
    } else {
      make_body(family, 0);
      make_body(family, 1);
    }
    if (deep) {
      gjk_signed_distance(&colliders[0], &colliders[1], NULL, &bench_workspace, &gap);
    } else {
      gjk_distance(&colliders[0], &colliders[1], NULL, &gap);
    }
    const bool moving = family->gap == BENCH_MOVING;
    if (moving) {
      make_motion();
    }
    if (is_in_family(family, &gap) && (!moving || meets())) {
      bench_expected.intersecting = gap.intersecting || moving;  // of those that move: a hit, close to touching
      bench_expected.distance = moving ? 0 : gap.distance;
      return !deep || is_depth_proven();
    }
  }
}

// Finds the number of cells by bisection: with fewer the query fails.
uint32_t bench_cells_needed(const bench_family *family) {
  uint32_t low = 0, high = BENCH_CELLS;
  while (low < high && (family->query == BENCH_DEPTH || family->query == BENCH_CONTACTS)) {
    const gjk_workspace tried = {cells, low + (high - low) / 2};
    gjk_distance_result gap;
    if (gjk_signed_distance(&colliders[0], &colliders[1], NULL, &tried, &gap) == GJK_OK) {
      high = tried.count;
    } else {
      low = tried.count + 1;
    }
  }
  return low;
}
