// Depth and contacts in a scene's reports: each manifold is that of the colliders, the statuses around them, and the function
// for single pairs.
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "filled.h"
#include "gjk/compound.h"
#include "gjk/concave.h"
#include "gjk/slide.h"
#include "placed.h"
#include "same.h"
#include "scene/world.h"
#include "scene_bodies.h"
#include "whorl.h"

#define UPDATES 150

static gjk_epa_cell cells[WORLD_CELLS];
static const gjk_workspace workspace = {cells, WORLD_CELLS};
static gjk_workspace of_worlds;
static world w;

typedef struct tally {
  unsigned manifolds, points, negative, others;
} tally;

static gjk_q16 margin_of(gjk_body_id body) {
  return w.bodies[body.slot].setup.margin;
}

// Does a report hold what the library says of the two colliders?
static void check_report(const gjk_report *r, tally *t) {
  gjk_collider a, b;
  gjk_manifold expected, single;
  if (r->event == GJK_EVENT_END) {
    CHECK(r->manifold == NULL);
    CHECK(r->distance == 0);
    return;
  }
  t->negative += r->distance < 0;
  if (r->detail != GJK_DETAIL_CONTACTS) {
    CHECK(r->manifold == NULL);
    t->others++;
    return;
  }
  CHECK(gjk_scene_collider(&w.scene, r->a, r->part_a, &a) == GJK_OK);
  CHECK(gjk_scene_collider(&w.scene, r->b, r->part_b, &b) == GJK_OK);
  const gjk_q16 margin = margin_of(r->a) + margin_of(r->b);
  memset(&expected, 0, sizeof expected);  // as it is reported where the ceiling on iterations is reached
  const gjk_status status = gjk_contacts(&a, &b, margin, 4, NULL, &of_worlds, &expected);
  CHECK(status == GJK_OK || world_is_tight());
  CHECK(r->manifold != NULL);
  CHECK(same_manifold(r->manifold, &expected));
  CHECK(gjk_scene_manifold(&w.scene, r, 4, &single) == status);
  CHECK(status == GJK_ERROR_ITERATION_LIMIT || same_manifold(&single, &expected));
  CHECK(expected.count == 0 || r->distance <= margin + 2);
  t->manifolds++;
  t->points += expected.count;
}

static void take_report(void *user, const gjk_report *report) {
  CHECK(report->manifold == NULL || report->manifold == world_manifolds);
  check_report(report, user);
}

static void check_world(void) {
  static gjk_report reports[WORLD_REPORTS];
  const world_options options = {WORLD_BODIES, GJK_Q16(2), GJK_Q16(0.1), GJK_DETAIL_DEPTH, 1, 0, false, true, false,
                                 false,        0,          false};
  const gjk_scene_config config = world_config(&options);
  const size_t bytes = gjk_scene_bytes(&config);
  random_state random = random_seed(check_seed(31));
  tally t = {0, 0, 0, 0};
  CHECK(world_start(&w, &options, malloc(bytes), bytes));
  for (int i = 0; i < UPDATES; i++) {
    gjk_progress progress;
    check_trial((unsigned long)i, NULL, NULL);
    for (int k = 0; k < 20; k++) {
      CHECK(world_change(&w, &random));
    }
    if (i % 2 == 0) {
      CHECK(gjk_scene_update_each(&w.scene, take_report, &t) == GJK_OK);
      continue;
    }
    CHECK(gjk_scene_update(&w.scene, reports, WORLD_REPORTS, &progress) == GJK_OK);
    for (uint32_t n = 0; n < progress.reports; n++) {
      CHECK(reports[n].manifold == NULL || reports[n].manifold == &world_manifolds[n]);
      check_report(&reports[n], &t);
    }
  }
  printf("%u manifolds with %u points, %u other reports, %u of all negative\n", t.manifolds, t.points, t.others,
         t.negative);
  CHECK(t.manifolds > 15 * UPDATES);
  CHECK(t.points > t.manifolds / (world_is_tight() ? 2 : 1));
  CHECK(t.others > UPDATES);
  CHECK(t.negative > 10 * UPDATES);
  free(w.scene.block);
}

static const gjk_vec3 tetrahedron[4] = {
    {-40000, -40000, -40000}, {40000, -40000, -40000}, {0, 40000, -40000}, {0, 0, 40000}};
static const gjk_shape solid = GJK_HULL(tetrahedron, 4), crate = GJK_BOX(GJK_Q16(0.5), GJK_Q16(0.5), GJK_Q16(0.5));
static const gjk_shape *const shapes[] = {&solid, &crate};

static uint32_t block[1000];
static gjk_scene scene;
static gjk_manifold manifolds[2];
static gjk_report report;
static gjk_progress progress;

static gjk_status update(void) {
  return gjk_scene_update(&scene, &report, 1, &progress);
}

// Binds these to the scene.
static void rebind(const gjk_scene_details *details, const gjk_workspace *given, gjk_manifold *room) {
  const gjk_scene_bindings bindings = {.details = details, .workspace = given, .manifolds = room};
  CHECK(gjk_scene_attach(&scene, block, sizeof block, shapes, 2, &bindings) == GJK_OK);
}

// Two solids, the second beside the first, that overlap deeply. They are added through a handle that has all, and left to
// one that has nothing.
static void start(gjk_detail least, gjk_detail of_body, uint32_t workspace_cells) {
  const gjk_scene_config config = {2, 2, 0, 4, 0, (uint8_t)least, 1, 0, 0, workspace_cells, 0};
  const gjk_part part = {0, false, GJK_POSE_IDENTITY};
  gjk_body_setup setup = {GJK_POSE_IDENTITY, &part, 1, GJK_BODY_DYNAMIC, (uint8_t)of_body, 1, 1, 0, 0};
  gjk_body_id body;
  const gjk_scene_bindings all = {.details = &gjk_scene_contacts};
  CHECK(gjk_scene_init(&scene, &config, block, sizeof block, shapes, 2, &all) == GJK_OK);
  CHECK(gjk_scene_add(&scene, &setup, &body) == GJK_OK);
  setup.pose.position.x = 9000;
  CHECK(gjk_scene_add(&scene, &setup, &body) == GJK_OK);
  CHECK(gjk_scene_attach(&scene, block, sizeof block, shapes, 2, NULL) == GJK_OK);
  CHECK(scene.bindings.details == NULL);
  CHECK(scene.bindings.workspace == NULL);
  CHECK(scene.bindings.manifolds == NULL);
}

// A detail that the handle has nothing for stops the update before it has done anything.
static void check_unsupported(void) {
  uint32_t pairs;
  start(GJK_DETAIL_TOUCH, GJK_DETAIL_CONTACTS, 0);
  const uint64_t before = scene_hash(&scene);
  CHECK(update() == GJK_ERROR_UNSUPPORTED);
  CHECK(gjk_scene_update_begin(&scene, &pairs) == GJK_ERROR_UNSUPPORTED);
  rebind(&gjk_scene_depth, NULL, NULL);
  CHECK(update() == GJK_ERROR_UNSUPPORTED);
  CHECK(scene_hash(&scene) == before);
  rebind(&gjk_scene_contacts, NULL, NULL);
  CHECK(gjk_scene_update_begin(&scene, &pairs) == GJK_OK);
  CHECK(pairs == 1);
  rebind(NULL, NULL, NULL);
  CHECK(gjk_scene_test_pairs(&scene, 0, 1) == GJK_ERROR_UNSUPPORTED);
  CHECK(update() == GJK_ERROR_UNSUPPORTED);
  rebind(&gjk_scene_contacts, NULL, NULL);
  CHECK(update() == GJK_OK);
  CHECK(progress.reports == 1);
  CHECK(report.detail == GJK_DETAIL_CONTACTS);
  CHECK(report.manifold == NULL);
  CHECK(report.distance == 0);  // no room was given
  CHECK(gjk_scene_check(&scene) == GJK_OK);
}

// So does a workspace of fewer cells than are configured, where depths are asked for.
static void check_lacking(void) {
  const gjk_workspace small = {cells, 99}, none = {NULL, 100}, enough = {cells, 100};
  gjk_manifold out;
  uint32_t pairs;
  start(GJK_DETAIL_DISTANCE, GJK_DETAIL_TOUCH, 100);
  CHECK(update() == GJK_OK);
  CHECK(progress.reports == 1);
  CHECK(gjk_scene_manifold(&scene, &report, 4, &out) == GJK_ERROR_UNSUPPORTED);
  start(GJK_DETAIL_TOUCH, GJK_DETAIL_DEPTH, 100);
  rebind(&gjk_scene_depth, NULL, NULL);
  CHECK(update() == GJK_ERROR_UNSUPPORTED);
  rebind(&gjk_scene_depth, &small, NULL);
  CHECK(update() == GJK_ERROR_UNSUPPORTED);
  rebind(&gjk_scene_depth, &none, NULL);
  CHECK(update() == GJK_ERROR_UNSUPPORTED);
  rebind(&gjk_scene_depth, &enough, NULL);
  CHECK(gjk_scene_update_begin(&scene, &pairs) == GJK_OK);
  CHECK(pairs == 1);
  rebind(&gjk_scene_depth, &small, NULL);
  CHECK(gjk_scene_test_pairs(&scene, 0, 1) == GJK_ERROR_UNSUPPORTED);
  rebind(&gjk_scene_depth, &enough, NULL);
  CHECK(gjk_scene_test_pairs(&scene, 0, 1) == GJK_OK);
  CHECK(update() == GJK_OK);
  CHECK(progress.reports == 1);
  CHECK(gjk_scene_manifold(&scene, &report, 4, &out) == GJK_OK);
}

// Without a workspace the depth of hulls is one that is enough, and the pair counts as unsettled.
static void check_bounds(void) {
  gjk_scene_stats stats;
  gjk_q16 enough;
  start(GJK_DETAIL_DEPTH, GJK_DETAIL_TOUCH, 0);
  rebind(&gjk_scene_depth, NULL, NULL);
  CHECK(update() == GJK_OK);
  CHECK(report.event == GJK_EVENT_BEGIN);
  CHECK(report.distance < 0);
  CHECK(gjk_scene_get_stats(&scene, &stats) == GJK_OK);
  CHECK(stats.unsettled == 1);
  enough = report.distance;
  start(GJK_DETAIL_DEPTH, GJK_DETAIL_TOUCH, WORLD_CELLS);
  rebind(&gjk_scene_depth, &workspace, NULL);
  CHECK(update() == GJK_OK);
  CHECK(report.distance < 0);
  CHECK(report.distance >= enough);
  CHECK(gjk_scene_get_stats(&scene, &stats) == GJK_OK);
  CHECK(stats.unsettled == 0);
  start(GJK_DETAIL_CONTACTS, GJK_DETAIL_TOUCH, 0);
  rebind(&gjk_scene_contacts, NULL, manifolds);
  CHECK(update() == GJK_OK);
  CHECK(report.manifold == manifolds);
  CHECK(report.distance < 0);
  CHECK(gjk_scene_get_stats(&scene, &stats) == GJK_OK);
  CHECK(stats.unsettled == 1);
}

// Resting pairs are reported with the manifold that they had.
static void check_rest(void) {
  start(GJK_DETAIL_CONTACTS, GJK_DETAIL_TOUCH, WORLD_CELLS);
  rebind(&gjk_scene_contacts, &workspace, manifolds);
  CHECK(update() == GJK_OK);
  CHECK(report.event == GJK_EVENT_BEGIN);
  CHECK(report.manifold == manifolds);
  const gjk_manifold first = manifolds[0];
  const gjk_q16 distance = report.distance;
  CHECK(update() == GJK_OK);
  CHECK(report.event == GJK_EVENT_PERSIST);
  CHECK(report.distance == distance);
  CHECK(same_manifold(&first, report.manifold));
}

static void check_manifold_statuses(void) {
  gjk_manifold out;
  start(GJK_DETAIL_TOUCH, GJK_DETAIL_TOUCH, WORLD_CELLS);
  rebind(NULL, &workspace, NULL);
  CHECK(update() == GJK_OK);
  CHECK(progress.reports == 1);
  CHECK(gjk_scene_manifold(&scene, &report, 4, &out) == GJK_OK);
  CHECK(out.count > 0);
  CHECK(gjk_scene_manifold(NULL, &report, 4, &out) == GJK_ERROR_NULL);
  CHECK(gjk_scene_manifold(&scene, NULL, 4, &out) == GJK_ERROR_NULL);
  CHECK(gjk_scene_manifold(&scene, &report, 4, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_scene_manifold(&scene, &report, 9, &out) == GJK_ERROR_RANGE);
  gjk_report other = report;
  other.part_b = 1;
  CHECK(gjk_scene_manifold(&scene, &other, 4, &out) == GJK_ERROR_RANGE);
  CHECK(gjk_scene_remove(&scene, report.a) == GJK_OK);
  CHECK(gjk_scene_manifold(&scene, &report, 4, &out) == GJK_ERROR_BODY_ID);
}

// A ball beside a shape that no search settles, alone or as a body of many parts: they count as near, at a bound and
// without contacts. To queries of the ball the other one counts as near too, and is not passed.
static void check_unsettled(bool concave, gjk_detail of_ball) {
  const gjk_compound_part one = {&whorl, GJK_POSE_IDENTITY};
  const gjk_scene_config config = {2, 2, 0, 4, 0, GJK_DETAIL_TOUCH, 0, 0, 0, WORLD_CELLS, 0};
  const gjk_scene_bindings all = {.details = &gjk_scene_contacts, .workspace = &workspace, .manifolds = manifolds};
  const gjk_part part[2] = {{0, false, GJK_POSE_IDENTITY}, {1, false, GJK_POSE_IDENTITY}};
  const gjk_collider ball = placed(&whorl_ball, whorl_point);
  const gjk_slide_setup walk = {{0, 0, GJK_Q30_ONE}, GJK_Q30_ONE / 2, GJK_SLIDE_SKIN_MIN, 0, 0, false, NULL};
  const gjk_shape small = GJK_SPHERE(GJK_Q16(0.5));
  const gjk_collider free_ball = placed(&small, whorl_point);
  const gjk_vec3 to = {0, 0, 0};
  gjk_body_setup setup = {GJK_POSE_IDENTITY, part, 1, GJK_BODY_STATIC, GJK_DETAIL_TOUCH, 1, 1, 0, 0};
  gjk_compound_node node;
  gjk_compound compound;
  gjk_concave body;
  gjk_shape many;
  gjk_body_id id[2];
  gjk_scene_stats stats;
  gjk_scene_hit hit[2];
  gjk_cast_result cast;
  gjk_slide_result slid;
  uint32_t count;
  bool found = false;
  CHECK(gjk_compound_build(&one, 1, &node, 1, &compound) == GJK_OK);
  const gjk_parts parts = GJK_PARTS_OF_COMPOUND(&compound);
  CHECK(gjk_concave_init(&parts, &body, &many) == GJK_OK);
  const gjk_shape *const both[] = {concave ? &many : &whorl, &whorl_ball};
  CHECK(gjk_scene_init(&scene, &config, block, sizeof block, both, 2, &all) == GJK_OK);
  CHECK(gjk_scene_add(&scene, &setup, &id[0]) == GJK_OK);
  // Queries of the ball, which is not there yet.
  memset(&cast, POISON, sizeof cast);
  CHECK(gjk_scene_query_within(&scene, &ball, 0, NULL, NULL, hit, 2, &count) == GJK_OK && count == 1);
  CHECK(gjk_scene_cast(&scene, &ball, &to, 0, NULL, &hit[0], &cast, &found) == GJK_ERROR_ITERATION_LIMIT && found);
  CHECK(hit[0].body.slot == id[0].slot && hit[0].fraction == 0 && is_untouched(&cast, sizeof cast));
  CHECK(gjk_scene_cast_all(&scene, &ball, &to, 0, NULL, NULL, hit, 2, &count) == GJK_OK && count == 1);
  CHECK(gjk_slide(&scene, &ball, &to, &walk, &slid) == GJK_ERROR_ITERATION_LIMIT && slid.stuck);
  CHECK(slid.position.x == whorl_point.x && slid.position.y == whorl_point.y && slid.position.z == whorl_point.z);
  CHECK(gjk_slide(&scene, &free_ball, &to, &walk, &slid) == GJK_ERROR_ITERATION_LIMIT && !slid.stuck);
  CHECK(slid.position.x == whorl_point.x && slid.position.y == whorl_point.y && slid.position.z == whorl_point.z);
  setup.pose.position = whorl_point;
  setup.parts = &part[1];
  setup.kind = GJK_BODY_DYNAMIC;
  setup.detail = (uint8_t)of_ball;
  CHECK(gjk_scene_add(&scene, &setup, &id[1]) == GJK_OK);
  memset(manifolds, POISON, sizeof manifolds);
  CHECK(update() == GJK_OK && progress.reports == 1 && report.event == GJK_EVENT_BEGIN);
  CHECK(gjk_scene_get_stats(&scene, &stats) == GJK_OK && stats.unsettled > 0);
  CHECK(of_ball == GJK_DETAIL_DEPTH ? report.distance < 0 : report.distance == 0);
  if (of_ball == GJK_DETAIL_CONTACTS) {
    const gjk_manifold *m = report.manifold;
    CHECK(m == manifolds && m->count == 0 && m->feature_a == 0 && m->feature_b == 0);
    CHECK(m->normal.x == 0 && m->normal.y == 0 && m->normal.z == 0);
  }
}

int main(void) {
  of_worlds = workspace;
  of_worlds.count = world_cells();
  check_world();
  check_unsupported();
  check_lacking();
  check_bounds();
  check_rest();
  check_manifold_statuses();
  for (unsigned k = 0; k < 8; k++) {
    check_unsettled(k / 4 != 0, (gjk_detail)(k % 4));
  }
  return check_done("scene_contacts");
}
