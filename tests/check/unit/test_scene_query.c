// Box, ray and nearest queries against a search of all parts; and continued in small buffers.
#include "check.h"
#include "gjk/gjk.h"
#include "placed.h"
#include "scene/world.h"

#define AXES 3
#define FAR_TRIALS 2000

#include "scene_queries.h"

static gjk_q16 *along(gjk_vec3 *v, int axis) {
  return axis == 0 ? &v->x : axis == 1 ? &v->y : &v->z;
}

static void aim(random_state *random, uint32_t how, const gjk_aabb *box, gjk_aabb *way) {
  if (how == 3) {
    return;
  }
  const gjk_vec3 step = random_vector(random, GJK_Q16(2)),
                 corner = random_below(random, 2) == 0 ? box->lower : box->upper;
  way->upper.x = how == 0 ? way->upper.x : corner.x;
  way->upper.y = how == 0 ? way->upper.y : corner.y;
  way->upper.z = corner.z;
  for (int axis = 0; how == 2 && axis < 3; axis++) {
    *along(&way->lower, axis) = component(corner, axis) - component(step, axis);
    *along(&way->upper, axis) = component(corner, axis) + component(step, axis);
  }
}

static void check_refusals(void) {
  const gjk_aabb flipped = {{0, 0, 0}, {5, -1, 5}}, flipped_x = {{1, 0, 0}, {0, 0, 0}},
                 flipped_z = {{0, 0, 3}, {0, 0, 2}}, point = {{0, 0, 0}, {0, 0, 0}};
  uint32_t count;
  gjk_scene_hit hit;
  gjk_q16 distance;
  bool found;
  gjk_collider c = {0};
  CHECK(gjk_scene_query_box(&w.scene, &flipped, NULL, &hit, 1, &count) == GJK_ERROR_RANGE);
  CHECK(gjk_scene_query_box(&w.scene, &flipped_x, NULL, &hit, 1, &count) == GJK_ERROR_RANGE);
  CHECK(gjk_scene_query_box(&w.scene, &flipped_z, NULL, &hit, 1, &count) == GJK_ERROR_RANGE);
  CHECK(gjk_scene_query_box(&w.scene, &point, NULL, NULL, 0, &count) == GJK_OK);
  CHECK(gjk_scene_query_box(NULL, &point, NULL, NULL, 0, &count) == GJK_ERROR_NULL);
  CHECK(gjk_scene_query_ray(NULL, &flipped.lower, &flipped.upper, NULL, &hit, 1, &count) == GJK_ERROR_NULL);
  CHECK(gjk_scene_query_box(&w.scene, NULL, NULL, &hit, 1, &count) == GJK_ERROR_NULL);
  CHECK(gjk_scene_query_box(&w.scene, &flipped, NULL, NULL, 1, &count) == GJK_ERROR_NULL);
  CHECK(gjk_scene_query_box(&w.scene, &flipped, NULL, &hit, 1, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_scene_query_ray(&w.scene, &flipped.lower, NULL, NULL, &hit, 1, &count) == GJK_ERROR_NULL);
  CHECK(gjk_scene_query_nearest(&w.scene, &c, 5, NULL, &hit, &distance, &found) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk_scene_query_nearest(&w.scene, NULL, 5, NULL, &hit, &distance, &found) == GJK_ERROR_NULL);
  CHECK(gjk_collider_init(&c, world_shapes[0], NULL, 0) == GJK_OK);
  const gjk_pose identity = GJK_POSE_IDENTITY;
  CHECK(gjk_collider_pose(&c, &identity) == GJK_OK);
  CHECK(gjk_scene_query_nearest(&w.scene, &c, -1, NULL, &hit, &distance, &found) == GJK_ERROR_NEGATIVE);
  CHECK(gjk_scene_query_nearest(NULL, &c, 0, NULL, &hit, &distance, &found) == GJK_ERROR_NULL);
  CHECK(gjk_scene_query_nearest(&w.scene, &c, 0, NULL, NULL, &distance, &found) == GJK_ERROR_NULL);
  CHECK(gjk_scene_query_nearest(&w.scene, &c, 0, NULL, &hit, NULL, &found) == GJK_ERROR_NULL);
  CHECK(gjk_scene_query_nearest(&w.scene, &c, 0, NULL, &hit, &distance, NULL) == GJK_ERROR_NULL);
}

// Among equally near parts the lowest slot, then the lowest part, whatever the order in which the tree holds them; a body
// is left out by its whole id.
static void check_equals(void) {
  static const gjk_shape ball = GJK_SPHERE(GJK_Q16(0.5));
  static const gjk_shape *const shapes[] = {&ball};
  static const gjk_scene_config config = {8, 16, 16, 1, 0, GJK_DETAIL_TOUCH, 0, 0, 0, 0, 0};
  static uint32_t block[1400];
  static const gjk_vec3 corner[8] = {{1, 1, 1},  {1, 1, -1},  {1, -1, 1},  {1, -1, -1},
                                     {-1, 1, 1}, {-1, 1, -1}, {-1, -1, 1}, {-1, -1, -1}};
  gjk_scene scene;
  gjk_scene_hit hit;
  gjk_q16 distance;
  bool found;
  const gjk_pose identity = GJK_POSE_IDENTITY;
  const gjk_collider c = posed(&ball, &identity);
  for (uint32_t first = 0; first < 8; first++) {  // slots from there on, in either order
    gjk_body_id bodies[8];
    CHECK(gjk_scene_init(&scene, &config, block, sizeof block, shapes, 1, NULL) == GJK_OK);
    for (uint32_t i = first; i < 8; i++) {
      gjk_part parts[2] = {{0, true, GJK_POSE_IDENTITY}, {0, true, GJK_POSE_IDENTITY}};
      for (int k = 0; k < 2; k++) {  // the second across the middle
        const gjk_vec3 *at = &corner[k == 0 ? i : 7 - i];
        parts[k].pose.position.x = at->x * GJK_Q16(2);
        parts[k].pose.position.y = at->y * GJK_Q16(2);
        parts[k].pose.position.z = at->z * GJK_Q16(2);
      }
      const gjk_body_setup setup = {GJK_POSE_IDENTITY, parts, 2, GJK_BODY_DYNAMIC, GJK_DETAIL_TOUCH, 1, 1, 0, 0};
      const uint32_t slot = first % 2 == 0 ? i : 7 - (i - first);
      CHECK(gjk_scene_add_at(&scene, slot, &setup, &bodies[slot]) == GJK_OK);
    }
    for (uint32_t slot = first; slot < 8; slot++) {
      CHECK(gjk_scene_query_nearest(&scene, &c, GJK_DISTANCE_MAX, NULL, &hit, &distance, &found) == GJK_OK);
      CHECK(found);
      CHECK(hit.body.slot == slot);
      CHECK(hit.part == 0);
      CHECK(distance == 161487);  // 2 sqrt(3) - 1
      CHECK(gjk_scene_query_nearest(&scene, &c, 161487, NULL, &hit, &distance, &found) == GJK_OK);
      CHECK(found);
      CHECK(gjk_scene_query_nearest(&scene, &c, 161486, NULL, &hit, &distance, &found) == GJK_OK);
      CHECK(!found);
      CHECK(gjk_scene_query_nearest(&scene, &c, 0, NULL, &hit, &distance, &found) == GJK_OK);
      CHECK(!found);
      CHECK(gjk_scene_query_nearest(&scene, &c, 161487, &bodies[slot], &hit, &distance, &found) == GJK_OK);
      CHECK(found == (slot < 7));
      CHECK(!found || hit.body.slot == slot + 1);
      const gjk_body_id stale = {slot, bodies[slot].generation + 2};
      CHECK(gjk_scene_query_nearest(&scene, &c, 161487, &stale, &hit, &distance, &found) == GJK_OK);
      CHECK(found);
      CHECK(hit.body.slot == slot);
      CHECK(gjk_scene_remove(&scene, bodies[slot]) == GJK_OK);
    }
    CHECK(gjk_scene_query_nearest(&scene, &c, GJK_DISTANCE_MAX, NULL, &hit, &distance, &found) == GJK_OK);
    CHECK(!found);
  }
}

// Beyond 16384 units a distance is reported up to 2 LSB off, less than the gap of the boxes, too: the nearest part is still the
// one that gjk_distance says is.
static void check_far(random_state *random) {
  static const gjk_shape slab = GJK_BOX(INT32_C(1) << 27, 9000, 9000);
  static const gjk_shape *const shapes[] = {&slab};
  static const gjk_scene_config config = {3, 3, 0, 1, 0, GJK_DETAIL_TOUCH, 0, 0, 0, 0, 0};
  static uint32_t block[600];
  const gjk_part part = {0, false, GJK_POSE_IDENTITY};
  gjk_body_setup setup = {GJK_POSE_IDENTITY, &part, 1, GJK_BODY_DYNAMIC, GJK_DETAIL_TOUCH, 1, 1, 0, 0};
  const unsigned trials = (unsigned)check_trials(FAR_TRIALS);
  unsigned below = 0;
  for (unsigned i = 0; i < trials; i++) {
    check_trial(i, NULL, NULL);
    gjk_scene scene;
    gjk_scene_hit hit;
    gjk_body_id bodies[3];
    gjk_collider part_collider;
    gjk_pose pose = GJK_POSE_IDENTITY;
    gjk_q16 distance, best = GJK_DISTANCE_MAX;
    uint32_t nearest = 0;
    bool found;
    const int32_t sign = random_below(random, 2) == 0 ? 1 : -1,
                  away = random_range(random, 1 << 30, (1 << 30) + (1 << 27) - 5);
    pose.position.x = -sign * away;
    const gjk_collider c = posed(&slab, &pose);
    CHECK(gjk_scene_init(&scene, &config, block, sizeof block, shapes, 1, NULL) == GJK_OK);
    for (unsigned k = 0; k < 3; k++) {
      setup.pose.position.x = sign * (away + random_range(random, 0, 4));
      setup.pose.position.y = random_range(random, -9000, 9000);
      CHECK(gjk_scene_add(&scene, &setup, &bodies[k]) == GJK_OK);
      CHECK(gjk_scene_collider(&scene, bodies[k], 0, &part_collider) == GJK_OK);
      gjk_distance_result r = {0};
      CHECK(gjk_distance(&c, &part_collider, NULL, &r) == GJK_OK);
      below += r.distance < (int64_t)away + sign * setup.pose.position.x - (1 << 28);
      nearest = r.distance < best ? k : nearest;
      best = r.distance < best ? r.distance : best;
    }
    CHECK(gjk_scene_query_nearest(&scene, &c, GJK_DISTANCE_MAX, NULL, &hit, &distance, &found) == GJK_OK);
    CHECK(found);
    CHECK(distance == best);
    CHECK(hit.body.slot == nearest);
  }
  CHECK(below > trials / 2);
}

// Ways along the faces and edges of a box, and an LSB beside them; ways that end at it; points.
static void check_borders(void) {
  static const gjk_shape crate = GJK_BOX(100, 100, 100);
  static const gjk_shape *const shapes[] = {&crate};
  static const gjk_scene_config config = {1, 1, 0, 1, 0, GJK_DETAIL_TOUCH, 0, 0, 0, 0, 0};
  static uint32_t block[400];
  const gjk_part part = {0, false, GJK_POSE_IDENTITY};
  const gjk_body_setup setup = {GJK_POSE_IDENTITY, &part, 1, GJK_BODY_DYNAMIC, GJK_DETAIL_TOUCH, 1, 1, 0, 0};
  gjk_scene scene;
  gjk_scene_hit hit;
  gjk_body_id body;
  gjk_collider c;
  gjk_aabb box;
  uint32_t count;
  CHECK(gjk_scene_init(&scene, &config, block, sizeof block, shapes, 1, NULL) == GJK_OK);
  CHECK(gjk_scene_add(&scene, &setup, &body) == GJK_OK);
  CHECK(gjk_scene_collider(&scene, body, 0, &c) == GJK_OK);
  CHECK(gjk_collider_aabb(&c, &box) == GJK_OK);
  CHECK(box.lower.x == -100);
  CHECK(box.upper.z == 100);
  for (int axis = 0; axis < 3; axis++) {
    for (gjk_q16 s = -101; s <= 101; s += s == -101 || s == 100 ? 1 : 200) {
      for (gjk_q16 t = -101; t <= 101; t += t == -101 || t == 100 ? 1 : 200) {
        const bool inside = s >= -100 && s <= 100 && t >= -100 && t <= 100;
        for (gjk_q16 end = -101; end <= 101; end++) {
          const gjk_vec3 from = {axis == 0 ? -300 : s, axis == 1 ? -300 : axis == 0 ? s : t, axis == 2 ? -300 : t};
          gjk_vec3 to = from, point = from;
          *(axis == 0 ? &to.x : axis == 1 ? &to.y : &to.z) = end;
          *(axis == 0 ? &point.x : axis == 1 ? &point.y : &point.z) = end;
          CHECK(gjk_scene_query_ray(&scene, &from, &to, NULL, &hit, 1, &count) == GJK_OK);
          CHECK(count == (inside && end >= -100 ? 1 : 0));
          const uint32_t fraction = (uint32_t)((UINT64_C(200) << 30) / (uint32_t)(end + 300));
          CHECK(count == 0 || hit.fraction == fraction);
          CHECK(gjk_scene_query_ray(&scene, &to, &from, NULL, &hit, 1, &count) == GJK_OK);
          CHECK(count == (inside && end >= -100 ? 1 : 0));
          CHECK(count == 0 || hit.fraction == (end <= 100 ? 0 : (uint32_t)((UINT64_C(1) << 30) / 401)));
          CHECK(gjk_scene_query_ray(&scene, &point, &point, NULL, &hit, 1, &count) == GJK_OK);
          CHECK(count == (inside && end >= -100 && end <= 100 ? 1 : 0));
          CHECK(count == 0 || hit.fraction == 0);
          const gjk_aabb dot = {point, point};
          CHECK(gjk_scene_query_box(&scene, &dot, NULL, &hit, 1, &count) == GJK_OK);
          CHECK(count == (inside && end >= -100 && end <= 100 ? 1 : 0));
        }
      }
    }
  }
}

// Bodies that turned since the last update: where they are counts, not the boxes around all that they may have turned
// to. The opposite quaternion is the same rotation. The part of one goes a long way around its body, to a post.
static void check_turned(void) {
  static const gjk_shape crate = GJK_BOX(100, 100, 100), point = GJK_POINT;
  static const gjk_shape *const shapes[] = {&crate};
  static const gjk_scene_config config = {3, 3, 1, 2, GJK_Q16_ONE, GJK_DETAIL_TOUCH, 0, 0, 0, 0, 0};
  static uint32_t block[800];
  const gjk_q16 away = INT32_C(1) << 28;
  const gjk_part part[2] = {{0, false, GJK_POSE_IDENTITY}, {0, true, {{away, 0, 0}, {0, 0, 0, GJK_Q30_ONE}}}};
  const gjk_vec3 beside = {110, 0, 0};
  const gjk_collider c = placed(&point, beside);
  gjk_body_setup setup = {GJK_POSE_IDENTITY, part, 1, GJK_BODY_DYNAMIC, GJK_DETAIL_TOUCH, 1, 1, 0, 0};
  gjk_pose pose = GJK_POSE_IDENTITY;
  gjk_scene scene;
  gjk_body_id turning, arm, post;
  gjk_scene_hit hit;
  gjk_report report;
  gjk_progress progress;
  uint32_t count;
  CHECK(gjk_scene_init(&scene, &config, block, sizeof block, shapes, 1, NULL) == GJK_OK);
  CHECK(gjk_scene_add(&scene, &setup, &turning) == GJK_OK);
  setup.pose.position.y = away;
  CHECK(gjk_scene_add(&scene, &setup, &post) == GJK_OK);
  setup.pose.position.y = 0;
  setup.parts = &part[1];
  CHECK(gjk_scene_add(&scene, &setup, &arm) == GJK_OK);
  CHECK(gjk_scene_update(&scene, &report, 1, &progress) == GJK_OK && progress.reports == 0);
  pose.rotation.z = pose.rotation.w = 759250125;  // a quarter, but for 2^-31
  for (unsigned i = 0; i < 2; i++) {
    CHECK(gjk_scene_move(&scene, turning, &pose) == GJK_OK && gjk_scene_move(&scene, arm, &pose) == GJK_OK);
    CHECK(gjk_scene_query_within(&scene, &c, 8, NULL, NULL, &hit, 1, &count) == GJK_OK && count == 0);
    CHECK(gjk_scene_query_within(&scene, &c, 12, NULL, NULL, &hit, 1, &count) == GJK_OK && count == 1);
    CHECK(gjk_scene_check(&scene) == GJK_OK);
    pose.rotation.z = -pose.rotation.z;
    pose.rotation.w = -pose.rotation.w;
  }
  CHECK(gjk_scene_update(&scene, &report, 1, &progress) == GJK_OK && progress.reports == 1);
  CHECK(report.event == GJK_EVENT_BEGIN && report.a.slot == post.slot && report.b.slot == arm.slot);
}

int main(void) {
  const world_options options = {WORLD_BODIES, GJK_Q16(4), GJK_Q16(0.2), GJK_DETAIL_TOUCH, 0, 0, false, false, false,
                                 false,        0,          false};
  random_state random = random_seed(check_seed(31));
  check_queries(&options, &random, NULL);
  check_refusals();
  check_equals();
  check_borders();
  check_turned();
  check_far(&random);
  free(w.scene.block);
  return check_done("scene_query");
}
