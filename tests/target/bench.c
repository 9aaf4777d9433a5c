// The families of pairs that instructions are counted on.
#include "bench.h"

#include "../random.h"

const bench_family bench_families[] = {
    {"8-point hulls apart: distance", BENCH_DISTANCE, 8, BENCH_APART},
    {"8-point hulls apart: intersect", BENCH_INTERSECT, 8, BENCH_APART},
    {"8-point hulls close: distance", BENCH_DISTANCE, 8, BENCH_CLOSE},
    {"8-point hulls close: intersect", BENCH_INTERSECT, 8, BENCH_CLOSE},
    {"8-point hulls overlapping: intersect", BENCH_INTERSECT, 8, BENCH_OVERLAPPING},
    {"64-point hulls apart: distance", BENCH_DISTANCE, 64, BENCH_APART},
    {"64-point hulls close: intersect", BENCH_INTERSECT, 64, BENCH_CLOSE},
    {"boxes apart: distance", BENCH_DISTANCE, 0, BENCH_APART},
    {"boxes apart: intersect", BENCH_INTERSECT, 0, BENCH_APART},
    {"boxes close: intersect", BENCH_INTERSECT, 0, BENCH_CLOSE},
    {"boxes overlapping: intersect", BENCH_INTERSECT, 0, BENCH_OVERLAPPING},
};
const unsigned bench_family_count = sizeof bench_families / sizeof bench_families[0];

static random_state random;
static gjk_vec3 vertices[2][BENCH_VERTICES], buffers[2][BENCH_VERTICES];
static gjk_shape shapes[2];
static gjk_collider colliders[2];

const gjk_collider *const bench_pair[2] = {&colliders[0], &colliders[1]};
bench_answer bench_expected;

static gjk_vec3 random_vector(int32_t size) {
  gjk_vec3 v;
  v.x = random_range(&random, -size, size);
  v.y = random_range(&random, -size, size);
  v.z = random_range(&random, -size, size);
  return v;
}

// A point within 0.8 and 1 unit of the origin.
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
  const gjk_quat q = {random_range(&random, -1000, 1000), random_range(&random, -1000, 1000),
                      random_range(&random, -1000, 1000), random_range(&random, -1000, 1001)};
  gjk_pose pose = GJK_POSE_IDENTITY;
  gjk_quat_normalize(&q, &pose.rotation);
  pose.position = random_vector(GJK_Q16(3.0));
  colliders[i].state = 0;
  gjk_collider_init(&colliders[i], &shapes[i], buffers[i], BENCH_VERTICES);
  gjk_collider_pose(&colliders[i], &pose);
}

void bench_start(void) {
  random = random_seed(50);
}

static bench_gap gap_of(const gjk_distance_result *result) {
  if (result->intersecting) {
    return BENCH_OVERLAPPING;
  }
  return result->distance < GJK_Q16(0.1) ? BENCH_CLOSE : BENCH_APART;
}

void bench_next(const bench_family *family) {
  for (;;) {
    gjk_distance_result result;
    make_body(family, 0);
    make_body(family, 1);
    gjk_distance(&colliders[0], &colliders[1], NULL, &result);
    if (gap_of(&result) == family->gap && result.distance <= GJK_Q16(2.0)) {
      bench_expected.intersecting = result.intersecting;
      bench_expected.distance = result.distance;
      return;
    }
  }
}

static void keep(const gjk_collider *a, const gjk_collider *b) {
  (void)a;
  (void)b;
}

static void run(bench_query query, bench_answer *out) {
  static gjk_distance_result result;
  static gjk_decision decision;
  if (query == BENCH_DISTANCE) {
    gjk_distance(&colliders[0], &colliders[1], NULL, &result);
    out->intersecting = result.intersecting;
    out->distance = result.distance;
    out->rounds = result.iterations;
  } else {
    gjk_intersect(&colliders[0], &colliders[1], NULL, &decision);
    out->intersecting = decision.yes;
    out->rounds = decision.iterations;
  }
}

const bench_solver bench_gjk = {"gjk", keep, run};
