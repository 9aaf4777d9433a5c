// Prints status and bounds of the distance, decisions, depths and contacts of seeded random pairs. test_limit.sh
// compares a build with a low ceiling on iterations with one that has the usual ceiling. Here it is checked that scenes
// report a ceiling as they should.
#include <stdio.h>
#include <string.h>

#include "gjk/gjk.h"
#include "gjk/scene.h"
#include "random.h"

#define PAIRS 6000
#define VERTICES 24

#define CELLS GJK_EPA_CELLS(256)

static gjk_vec3 vertices[2][VERTICES];

static gjk_pose poses[2];

static void make(random_state *random, int i, int32_t size, gjk_shape *shape, gjk_collider *collider) {
  const gjk_shape kinds[] = {GJK_HULL(vertices[i], VERTICES), GJK_BOX(size, size / 2 + 1, size / 3 + 1),
                             GJK_CYLINDER(size / 2 + 1, size), GJK_ELLIPSOID(size, size / 2 + 1, size / 5 + 1),
                             GJK_CAPSULE(size / 4 + 1, size)};
  const gjk_quat q = {random_range(random, -1000, 1000), random_range(random, -1000, 1000),
                      random_range(random, -1000, 1000), random_range(random, -1000, 1001)};
  gjk_pose pose = GJK_POSE_IDENTITY;
  *shape = kinds[random_below(random, 5)];
  for (int k = 0; k < VERTICES; k++) {
    vertices[i][k].x = random_range(random, -size, size);
    vertices[i][k].y = random_range(random, -size, size);
    vertices[i][k].z = random_range(random, -size, size);
  }
  gjk_quat_normalize(&q, &pose.rotation);
  pose.position.x = random_range(random, -3 * size, 3 * size);
  pose.position.y = random_range(random, -3 * size, 3 * size);
  pose.position.z = random_range(random, -3 * size, 3 * size);
  poses[i] = pose;
  collider->state = 0;
  gjk_collider_init(collider, shape, NULL, 0);
  gjk_collider_pose(collider, &pose);
}

static gjk_epa_cell cells[CELLS];
static const gjk_workspace workspace = {cells, CELLS};

// Makes a scene of both shapes, and updates it.
typedef struct two {
  gjk_scene scene;
  gjk_scene_stats stats;
  gjk_body_id bodies[2];
  gjk_report report;
  gjk_progress progress;
  gjk_manifold manifold;
} two;

static bool update(const gjk_shape *shape, gjk_q16 margin, uint8_t detail, uint8_t retest_all, two *out) {
  static uint32_t block[400];
  static const gjk_shape *table[2];
  const gjk_scene_config config = {2, 2, 0, 1, GJK_RADIUS_MAX, detail, 0, retest_all, 0, CELLS, 0};
  const gjk_part parts[2] = {{0, false, GJK_POSE_IDENTITY}, {1, false, GJK_POSE_IDENTITY}};
  const gjk_scene_bindings bindings = {
      .details = &gjk_scene_contacts, .workspace = &workspace, .manifolds = &out->manifold};
  gjk_scene *scene = &out->scene;
  table[0] = &shape[0];
  table[1] = &shape[1];
  bool right = gjk_scene_init(scene, &config, block, sizeof block, table, 2, &bindings) == GJK_OK;
  for (int i = 0; i < 2; i++) {
    const gjk_body_setup setup = {poses[i], &parts[i], 1, GJK_BODY_DYNAMIC,   GJK_DETAIL_TOUCH,
                                  1,        1,         0, i == 0 ? margin : 0};
    right = right && gjk_scene_add(scene, &setup, &out->bodies[i]) == GJK_OK;
  }
  return right && gjk_scene_update(scene, &out->report, 1, &out->progress) == GJK_OK &&
         gjk_scene_get_stats(scene, &out->stats) == GJK_OK;
}

// The part of body 1 must be the nearest to a, with body 0 left out.
static bool check_nearest(const two *t, const gjk_collider *a, gjk_q16 distance) {
  gjk_scene_hit hit;
  gjk_q16 nearest;
  bool found;
  return gjk_scene_query_nearest(&t->scene, a, GJK_DISTANCE_MAX, &t->bodies[0], &hit, &nearest, &found) == GJK_OK &&
         found && hit.body.slot == 1 && nearest == distance;
}

static int64_t larger(int64_t a, int64_t b) {
  return a > b ? a : b;
}

// How far apart the boxes are along an axis; negative if they overlap along all.
static int64_t gap_of_boxes(const gjk_collider *a, const gjk_collider *b) {
  gjk_aabb x, y;
  gjk_collider_aabb(a, &x);
  gjk_collider_aabb(b, &y);
  const int64_t along_x = larger((int64_t)x.lower.x - y.upper.x, (int64_t)y.lower.x - x.upper.x);
  const int64_t along_y = larger((int64_t)x.lower.y - y.upper.y, (int64_t)y.lower.y - x.upper.y);
  return larger(larger(along_x, along_y), larger((int64_t)x.lower.z - y.upper.z, (int64_t)y.lower.z - x.upper.z));
}

// A query that reaches the ceiling reports the pair as near, at the proven lower bound, and counts it as unsettled;
// unless the boxes are farther apart than the margin. The same if every pair is tested anew.
static bool check_scene(const gjk_shape *shape, const gjk_collider *a, const gjk_collider *b, gjk_q16 margin) {
  two t;
  gjk_distance_result gap;
  gjk_decision decision;
  const gjk_status decided = gjk_within(a, b, margin, NULL, &decision), measured = gjk_distance(a, b, NULL, &gap);
  const int64_t boxes = gap_of_boxes(a, b);
  const bool near = (decided != GJK_OK || decision.yes) && boxes <= margin;
  const bool open = near && (decided != GJK_OK || measured != GJK_OK);
  const gjk_q16 distance = measured == GJK_OK ? gap.distance : gap.lower;
  const gjk_q16 nearest = measured == GJK_OK || distance > boxes ? distance : (gjk_q16)boxes;
  for (uint8_t retest_all = 0; retest_all < 2; retest_all++) {
    if (!update(shape, margin, GJK_DETAIL_DISTANCE, retest_all, &t) || !check_nearest(&t, a, nearest) ||
        (t.stats.pairs == 1 && (t.progress.reports == 1) != near) || t.stats.unsettled != (open ? 1u : 0u) ||
        (t.progress.reports == 1 && t.report.distance != distance)) {
      return false;
    }
  }
  return true;
}

// The same for depths, and for contacts, of which there are none then.
static bool check_details(const gjk_shape *shape, const gjk_collider *a, const gjk_collider *b, gjk_q16 margin) {
  two t;
  gjk_distance_result depth;
  gjk_manifold m;
  gjk_decision decision;
  const bool decided = gjk_within(a, b, margin, NULL, &decision) == GJK_OK;
  const gjk_status measured = gjk_signed_distance(a, b, NULL, &workspace, &depth),
                   met = gjk_contacts(a, b, margin, 4, NULL, &workspace, &m);
  const gjk_q16 distance = measured == GJK_ERROR_ITERATION_LIMIT ? depth.lower : depth.distance;
  const unsigned count = met == GJK_ERROR_ITERATION_LIMIT ? 0 : m.count;
  for (uint8_t retest_all = 0; retest_all < 2; retest_all++) {
    if (!update(shape, margin, GJK_DETAIL_DEPTH, retest_all, &t) ||
        (t.progress.reports == 1 &&
         (t.report.distance != distance || (t.stats.unsettled == 1) != (!decided || measured != GJK_OK)))) {
      return false;
    }
    if (!update(shape, margin, GJK_DETAIL_CONTACTS, retest_all, &t) ||
        (t.progress.reports == 1 &&
         (t.report.manifold != &t.manifold || t.manifold.count != count || (count == 0 && t.report.distance != 0) ||
          t.stats.unsettled != (unsigned)!decided + (met != GJK_OK)))) {
      return false;
    }
  }
  return true;
}

int main(void) {
  random_state random = random_seed(7);
  for (int i = 0; i < PAIRS; i++) {
    const int32_t size = INT32_C(1) << (4 + random_below(&random, 22));
    gjk_shape shapes[2];
    gjk_collider a, b;
    gjk_distance_result result = {0};
    gjk_decision decision = {0};
    make(&random, 0, size, &shapes[0], &a);
    make(&random, 1, size, &shapes[1], &b);
    const gjk_status status = gjk_distance(&a, &b, NULL, &result);
    const gjk_effort full = {0, 0};
    gjk_distance_result until = {0};
    // With one more iteration at a time, gjk_distance_until must end where the whole query ends, with bounds at least
    // as narrow.
    if (gjk_distance_until(&a, &b, &full, NULL, &until) != status || until.iterations != result.iterations ||
        until.lower < result.lower || until.upper > result.upper) {
      printf("pair %d by iterations: %ld %ld\n", i, (long)until.lower, (long)until.upper);
      return 1;
    }
    const gjk_status decided = gjk_intersect(&a, &b, NULL, &decision);
    gjk_penetration_result depth = {0};
    gjk_distance_result signed_distance = {0};
    gjk_manifold contacts = {0};
    gjk_cache cache;
    memset(&cache, 0, sizeof cache);
    const gjk_status pierced = gjk_penetration(&a, &b, &cache, &workspace, &depth);
    memset(&cache, 0, sizeof cache);
    const gjk_status measured = gjk_signed_distance(&a, &b, &cache, &workspace, &signed_distance);
    const gjk_status met = gjk_contacts(&a, &b, size / 8, 4, NULL, &workspace, &contacts);
    if (!check_scene(shapes, &a, &b, size / 8) || !check_details(shapes, &a, &b, size / 8)) {
      printf("pair %d in a scene\n", i);
      return 1;
    }
    printf("%d %d %ld %ld %d %d %d %d %d %ld %d %ld %d %d %ld %ld\n", i, (int)status, (long)result.lower,
           (long)result.upper, result.iterations, (int)decided, decision.yes, (int)pierced, depth.intersecting,
           depth.intersecting ? (long)depth.depth : 0, (int)measured, (long)signed_distance.distance, (int)met,
           contacts.count, (long)signed_distance.lower, (long)signed_distance.upper);
  }
  return 0;
}
