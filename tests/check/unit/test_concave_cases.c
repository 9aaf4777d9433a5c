// Concave parts in a scene: bodies that move and turn, with parts at poses of their own, against a look at every part; and
// what is refused, what few cells and full pools do, and what is removed or given another shape.
#include <string.h>

#include "check.h"
#include "gjk/gjk.h"
#include "placed.h"
#include "reference/random_shape.h"
#include "scene/concave_world.h"

#define SEED UINT64_C(0x43617365)
#define ONE GJK_Q16_ONE
#define TRIALS 40
#define REPORTS 400
#define MOVERS 8

static struct { unsigned long pairs, near, both, manifolds, small; } tally;

static concave_world w;
static uint32_t block[40000];
static gjk_epa_cell cells[GJK_EPA_CELLS(64)];
static const gjk_workspace workspace = {cells, sizeof cells / sizeof cells[0]};
static gjk_scene scene;
static gjk_report reports[REPORTS];
static gjk_manifold manifolds[REPORTS];
static const gjk_shape *shapes[CONCAVE_BODIES + MOVERS + 1];

static void start(uint8_t detail, uint32_t used_cells, uint32_t pairs) {
  const gjk_scene_config config = {.bodies = 30,
                                   .parts = 60,
                                   .own_poses = 30,
                                   .pairs = pairs,
                                   .box_margin = 1000,
                                   .detail = detail,
                                   .persist = 1,
                                   .workspace_cells = used_cells};
  const gjk_scene_bindings bindings = {.details = &gjk_scene_contacts,
                                       .workspace = &workspace,
                                       .manifolds = detail == GJK_DETAIL_CONTACTS ? manifolds : NULL};
  CHECK(gjk_scene_bytes(&config) <= sizeof block);
  CHECK(gjk_scene_init(&scene, &config, block, sizeof block, shapes, CONCAVE_BODIES + MOVERS + 1, &bindings) == GJK_OK);
}

static gjk_pose any_pose(random_state *random, int32_t size) {
  gjk_pose pose;
  pose.position = random_vector(random, 6.0 * size * random_unit(random));
  pose.rotation = random_rotation(random);
  return pose;
}

// Are two parts of bodies near, and how far apart, by a look at every part of each?
static bool look(gjk_body_id a, uint16_t part_a, gjk_body_id b, uint16_t part_b, gjk_q16 margin, gjk_q16 *distance) {
  gjk_parts parts[2];
  gjk_collider whole[2], c[2];
  gjk_parts_room room[2];
  const bool many[2] = {gjk_scene_parts(&scene, a, part_a, &parts[0]) == GJK_OK,
                        gjk_scene_parts(&scene, b, part_b, &parts[1]) == GJK_OK};
  bool near = false;
  CHECK(gjk_scene_collider(&scene, a, part_a, &whole[0]) == (many[0] ? GJK_ERROR_UNSUPPORTED : GJK_OK));
  CHECK(gjk_scene_collider(&scene, b, part_b, &whole[1]) == (many[1] ? GJK_ERROR_UNSUPPORTED : GJK_OK));
  *distance = INT32_MAX;
  for (uint32_t i = 0; i < (many[0] ? gjk_parts_count(&parts[0]) : 1); i++) {
    for (uint32_t k = 0; k < (many[1] ? gjk_parts_count(&parts[1]) : 1); k++) {
      gjk_decision decision;
      gjk_distance_result gap;
      if ((many[0] && gjk_parts_place(&parts[0], i, &room[0], &c[0]) != GJK_OK) ||
          (many[1] && gjk_parts_place(&parts[1], k, &room[1], &c[1]) != GJK_OK)) {
        continue;  // a hole
      }
      const gjk_collider *p = many[0] ? &c[0] : &whole[0], *q = many[1] ? &c[1] : &whole[1];
      CHECK(gjk_within(p, q, margin, NULL, &decision) == GJK_OK);
      if (decision.yes) {
        CHECK(gjk_distance(p, q, NULL, &gap) == GJK_OK);
        near = true;
        *distance = gap.distance < *distance ? gap.distance : *distance;
      }
    }
  }
  tally.both += many[0] && many[1] && near;
  return near;
}

static void check_moving(random_state *random) {
  const int32_t size = 1 << random_range(random, 8, 16);
  const gjk_q16 margin = random_range(random, 0, size / 4);
  gjk_body_id id[CONCAVE_BODIES + MOVERS];
  concave_world_make(&w, random, size);
  for (unsigned i = 0; i < CONCAVE_BODIES + MOVERS; i++) {
    shapes[i] = i < CONCAVE_BODIES ? &w.body[i].shape : &w.mover[i - CONCAVE_BODIES];
  }
  start(GJK_DETAIL_DISTANCE, 0, 1000);
  for (uint16_t i = 0; i < CONCAVE_BODIES + MOVERS; i++) {
    const gjk_part part[2] = {{i, i % 2 != 0, any_pose(random, size / 4)},
                              {CONCAVE_BODIES, true, any_pose(random, size / 4)}};
    const gjk_body_setup setup = {any_pose(random, size),
                                  part,
                                  i % 3 == 0 ? 2 : 1,
                                  i < CONCAVE_BODIES - 1 ? GJK_BODY_KINEMATIC : GJK_BODY_DYNAMIC,
                                  0,
                                  1,
                                  1,
                                  i,
                                  margin};
    CHECK(gjk_scene_add(&scene, &setup, &id[i]) == GJK_OK);
  }
  for (unsigned u = 0; u < 6; u++) {
    gjk_progress progress;
    unsigned expected = 0;
    CHECK(gjk_scene_update(&scene, reports, REPORTS, &progress) == GJK_OK && progress.reports_left == 0);
    CHECK(gjk_scene_check(&scene) == GJK_OK);
    for (unsigned a = 0; a < CONCAVE_BODIES + MOVERS; a++) {
      for (unsigned b = a + 1; b < CONCAVE_BODIES + MOVERS; b++) {
        for (uint16_t part = 0; part < 4; part++) {
          gjk_q16 distance;
          const uint16_t i = part / 2, k = part % 2;
          if ((i == 1 && a % 3 != 0) || (k == 1 && b % 3 != 0)) {
            continue;
          }
          const bool near = look(id[a], i, id[b], k, 2 * margin, &distance);
          bool found = false;
          for (uint32_t n = 0; n < progress.reports; n++) {
            const gjk_report *r = &reports[n];
            if (r->a.slot == id[a].slot && r->b.slot == id[b].slot && r->part_a == i && r->part_b == k &&
                r->event != GJK_EVENT_END) {
              found = true;
              CHECK_MSG(r->distance == distance, "bodies %u and %u: %d, expected %d", a, b, (int)r->distance,
                        (int)distance);
            }
          }
          CHECK_MSG(found == near, "bodies %u and %u, parts %u and %u: %d", a, b, i, k, found);
          expected += near;
          tally.pairs++;
          tally.near += near;
        }
      }
    }
    for (unsigned i = 0; i < CONCAVE_BODIES + MOVERS; i++) {
      gjk_body_state state;
      CHECK(gjk_scene_get(&scene, id[i], &state) == GJK_OK);
      const uint32_t how = random_below(random, 4);
      const gjk_vec3 off = random_vector(random, size * (how == 0 ? 3.0 : 0.05));
      state.pose.position =
          (gjk_vec3){state.pose.position.x + off.x, state.pose.position.y + off.y, state.pose.position.z + off.z};
      state.pose.rotation = how == 1 ? random_rotation(random) : state.pose.rotation;
      CHECK(how == 2 || gjk_scene_move(&scene, id[i], &state.pose) == GJK_OK);
    }
  }
  // Another shape for a part, and bodies removed.
  CHECK(gjk_scene_set_shape(&scene, id[CONCAVE_BODIES], 0, 0) == GJK_OK && gjk_scene_check(&scene) == GJK_OK);
  CHECK(gjk_scene_remove(&scene, id[0]) == GJK_OK && gjk_scene_remove(&scene, id[1]) == GJK_OK);
  gjk_progress progress;
  CHECK(gjk_scene_update(&scene, reports, REPORTS, &progress) == GJK_OK && gjk_scene_check(&scene) == GJK_OK);
  concave_world_free(&w);
}

// Contacts: the first manifold of a pair is the deepest; few cells leave answers that are safe, and are counted.
static void check_contacts(random_state *random, uint32_t used_cells) {
  const int32_t size = 1 << 14;
  gjk_progress progress;
  gjk_body_id id;
  concave_world_make(&w, random, size);
  for (unsigned i = 0; i < CONCAVE_BODIES + MOVERS; i++) {
    shapes[i] = i < CONCAVE_BODIES ? &w.body[i].shape : &w.mover[i - CONCAVE_BODIES];
  }
  start(GJK_DETAIL_CONTACTS, used_cells, 1000);
  for (uint16_t i = 0; i < CONCAVE_BODIES + MOVERS; i++) {
    const gjk_part part = {i, false, GJK_POSE_IDENTITY};
    const gjk_body_setup setup = {
        any_pose(random, size), &part, 1, i < CONCAVE_BODIES ? GJK_BODY_STATIC : GJK_BODY_DYNAMIC, 0, 1, 1, i, 0};
    CHECK(gjk_scene_add_at(&scene, 20u - i, &setup, &id) == GJK_OK);
  }
  CHECK(gjk_scene_update(&scene, reports, REPORTS, &progress) == GJK_OK && progress.reports_left == 0);
  for (uint32_t n = 0; n < progress.reports; n++) {
    gjk_manifold all[GJK_PARTS_MANIFOLDS_MAX], one;
    unsigned count = 0;
    const gjk_status status = gjk_scene_manifolds(&scene, &reports[n], 4, all, GJK_PARTS_MANIFOLDS_MAX, &count);
    CHECK(status == GJK_OK || status == GJK_ERROR_CAPACITY);
    CHECK(gjk_scene_manifold(&scene, &reports[n], 4, &one) == status);
    CHECK(one.count == reports[n].manifold->count &&
          (one.count == 0 || memcmp(&one.normal, &reports[n].manifold->normal, sizeof one.normal) == 0));
    gjk_q16 before = INT32_MIN;
    for (unsigned i = 0; i < count; i++) {
      gjk_q16 least = INT32_MAX;
      for (unsigned k = 0; k < all[i].count; k++) {
        least = all[i].contact[k].distance < least ? all[i].contact[k].distance : least;
        for (unsigned j = 0; j < k; j++) {
          CHECK(all[i].contact[k].id != all[i].contact[j].id);
        }
      }
      CHECK(all[i].count >= 1 && all[i].count <= 4 && least >= before && least <= 0);
      before = least;
      tally.manifolds++;
    }
    CHECK(count == 0 || reports[n].distance <= 0);
    tally.small += status == GJK_ERROR_CAPACITY;
    count = 55;  // stays so
    CHECK(gjk_scene_manifolds(&scene, &reports[n], 4, all, 0, &count) == GJK_ERROR_RANGE);
    CHECK(gjk_scene_manifolds(&scene, &reports[n], 4, all, GJK_PARTS_MANIFOLDS_MAX + 1, &count) == GJK_ERROR_RANGE);
    CHECK(gjk_scene_manifolds(&scene, &reports[n], 9, all, 1, &count) == GJK_ERROR_RANGE);
    CHECK(gjk_scene_manifolds(&scene, &reports[n], 4, NULL, 1, &count) == GJK_ERROR_NULL);
    CHECK(count == 55);
  }
  concave_world_free(&w);
}

static void check_refusals(random_state *random) {
  static const gjk_shape far_box = GJK_BOX(ONE, ONE, ONE),
                         wide_box = GJK_BOX(GJK_Q16(2300), GJK_Q16(2300), GJK_Q16(2300));
  const gjk_pose identity = GJK_POSE_IDENTITY;
  gjk_compound_part part[2] = {{&far_box, GJK_POSE_IDENTITY}, {&far_box, GJK_POSE_IDENTITY}};
  gjk_compound_node nodes[GJK_COMPOUND_NODES(2)];
  gjk_compound compound;
  gjk_concave out;
  gjk_shape shape;
  gjk_collider c = {0};
  part[1].pose.position.x = 8195 * ONE;
  CHECK(gjk_compound_build(part, 2, nodes, GJK_COMPOUND_NODES(2), &compound) == GJK_OK);
  gjk_parts parts = GJK_PARTS_OF_COMPOUND(&compound);
  CHECK(gjk_concave_init(&parts, &out, &shape) == GJK_ERROR_SIZE);  // beyond the reach
  part[1].pose.position.x = 8189 * ONE;
  CHECK(gjk_compound_build(part, 2, nodes, GJK_COMPOUND_NODES(2), &compound) == GJK_OK);
  CHECK(gjk_concave_init(&parts, &out, &shape) == GJK_ERROR_SIZE);  // too long
  part[0].shape = part[1].shape = &wide_box;
  part[1].pose.position.x = ONE;
  CHECK(gjk_compound_build(part, 2, nodes, GJK_COMPOUND_NODES(2), &compound) == GJK_OK);
  CHECK(gjk_concave_init(&parts, &out, &shape) == GJK_OK);
  CHECK(gjk_concave_init(NULL, &out, &shape) == GJK_ERROR_NULL &&
        gjk_concave_init(&parts, NULL, &shape) == GJK_ERROR_NULL &&
        gjk_concave_init(&parts, &out, NULL) == GJK_ERROR_NULL);
  const gjk_parts nothing = {parts.type, NULL, GJK_POSE_IDENTITY};
  CHECK(gjk_concave_init(&nothing, &out, &shape) == GJK_ERROR_NULL);
  CHECK(gjk_collider_init(&c, &shape, NULL, 0) == GJK_ERROR_UNSUPPORTED && c.state == 0);
  shapes[0] = &shape;
  shapes[1] = &far_box;
  for (unsigned i = 2; i <= CONCAVE_BODIES + MOVERS; i++) {
    shapes[i] = NULL;
  }
  start(GJK_DETAIL_TOUCH, 0, 2);
  const gjk_part of_body[2] = {{0, false, GJK_POSE_IDENTITY}, {1, true, identity}};
  gjk_body_setup setup = {GJK_POSE_IDENTITY, of_body, 2, GJK_BODY_DYNAMIC, 0, 1, 1, 0, 0};
  gjk_body_id id, other;
  gjk_parts found;
  // Constants that nobody made: a half extent below 0 or beyond the largest on each axis, and no body.
  const gjk_shape made = shape;
  for (unsigned i = 0; i < 6; i++) {
    gjk_q16 *const half = i / 2 == 0 ? &shape.size.x : i / 2 == 1 ? &shape.size.y : &shape.size.z;
    *half = i % 2 == 0 ? -1 : GJK_RADIUS_MAX + 1;
    CHECK(gjk_scene_add(&scene, &setup, &id) == (i % 2 == 0 ? GJK_ERROR_NEGATIVE : GJK_ERROR_SIZE));
    shape = made;
  }
  shape.user = NULL;
  CHECK(gjk_scene_add(&scene, &setup, &id) == GJK_ERROR_NULL);
  shape = made;
  setup.pose.position.x = INT32_MAX - 4 * ONE;  // some rotation would take it out
  CHECK(gjk_scene_add(&scene, &setup, &id) == GJK_ERROR_RANGE);
  setup.pose.position.x = 0;
  CHECK(gjk_scene_add(&scene, &setup, &id) == GJK_OK);
  setup.pose.position.x = INT32_MIN + 5 * ONE;
  CHECK(gjk_scene_move(&scene, id, &setup.pose) == GJK_ERROR_RANGE);
  CHECK(gjk_scene_check(&scene) == GJK_OK);
  CHECK(gjk_scene_parts(&scene, id, 0, &found) == GJK_OK && found.data == &compound && found.pose.position.x == 0);
  CHECK(gjk_scene_parts(&scene, id, 1, &found) == GJK_ERROR_UNSUPPORTED);
  CHECK(gjk_scene_parts(&scene, id, 2, &found) == GJK_ERROR_RANGE);
  CHECK(gjk_scene_parts(&scene, id, 0, NULL) == GJK_ERROR_NULL);
  other = id;
  other.generation += 2;
  CHECK(gjk_scene_parts(&scene, other, 0, &found) == GJK_ERROR_BODY_ID);
  // Steps up to where it is refused, by ways short and long.
  gjk_pose pose = GJK_POSE_IDENTITY;
  for (int32_t x = 0; x <= INT32_MAX - GJK_CONCAVE_REACH - 3000 * ONE; x += 2999 * ONE) {
    gjk_progress progress;
    pose.position.x = x;
    pose.rotation = random_rotation(random);
    CHECK(gjk_scene_move(&scene, id, &pose) == GJK_OK && gjk_scene_check(&scene) == GJK_OK);
    CHECK(gjk_scene_update(&scene, reports, REPORTS, &progress) == GJK_OK);
  }
}

// Constants that name no body, none with parts, or a mesh whose corners are no vertices.
static void check_unchecked(void) {
  static const gjk_vec3 vertex[3] = {{0, 0, 0}, {ONE, 0, 0}, {0, ONE, 0}};
  static const gjk_mesh_node node = {{0, 0, 0}, {UINT16_MAX, UINT16_MAX, UINT16_MAX}};
  static const gjk_mesh_triangle triangle = {{5, 6, 7}};
  static const gjk_mesh lost = {vertex, &triangle, &node, 3, 1, {0, 0, 0}, {ONE, ONE, 0}, {1, 1, 0}, false};
  static const gjk_mesh empty = {vertex, &triangle, &node, 3, 0, {0, 0, 0}, {ONE, ONE, 0}, {1, 1, 0}, false};
  static const gjk_concave concaves[4] = {{{NULL, &lost, GJK_POSE_IDENTITY}, {0, 0, 0}},
                                          {{&gjk_parts_class_mesh, NULL, GJK_POSE_IDENTITY}, {0, 0, 0}},
                                          {GJK_PARTS_OF_MESH(&empty), {0, 0, 0}},
                                          {GJK_PARTS_OF_MESH(&lost), {0, 0, 0}}};
  static const gjk_shape refused[4] = {
      GJK_CONCAVE(&concaves[0], ONE, ONE, ONE), GJK_CONCAVE(&concaves[1], ONE, ONE, ONE),
      GJK_CONCAVE(&concaves[2], ONE, ONE, ONE), GJK_CONCAVE(&concaves[3], ONE, ONE, ONE)};
  static const gjk_status expected[4] = {GJK_ERROR_EMPTY, GJK_ERROR_EMPTY, GJK_ERROR_EMPTY, GJK_OK};
  static const gjk_shape ball = GJK_SPHERE(ONE);
  gjk_progress progress;
  gjk_scene_hit hit;
  gjk_q16 distance[2];
  const gjk_pose at = {{ONE / 2, 0, 0}, {0, 0, 0, GJK_Q30_ONE}};
  for (unsigned i = 0; i <= CONCAVE_BODIES + MOVERS; i++) {
    shapes[i] = i < 4 ? &refused[i] : &ball;
  }
  start(GJK_DETAIL_DISTANCE, 0, 10);
  for (uint16_t i = 0; i < 5; i++) {
    const gjk_part part = {i, false, GJK_POSE_IDENTITY};
    const gjk_body_setup setup = {GJK_POSE_IDENTITY, &part, 1, GJK_BODY_DYNAMIC, 0, 1, 1, 0, 0};
    gjk_body_id id = {77, 78};
    const gjk_status status = i < 4 ? expected[i] : GJK_OK;
    CHECK(gjk_scene_add(&scene, &setup, &id) == status);
    CHECK(status == GJK_OK || (id.slot == 77 && id.generation == 78));
  }
  CHECK(gjk_scene_update(&scene, reports, REPORTS, &progress) == GJK_OK && progress.reports == 0);
  const gjk_collider c = posed(&ball, &at);
  for (unsigned k = 0; k < 2; k++) {
    bool found;
    CHECK(gjk_scene_query_nearest(&scene, &c, 100 * ONE, NULL, &hit, &distance[k], &found) == GJK_OK && found);
  }
  CHECK(distance[0] == 0 && distance[1] == 0 && hit.body.slot == 0);
}

int main(void) {
  const uint64_t seed = check_seed(SEED);
  for (unsigned long i = 0; i < TRIALS; i++) {
    random_state random = random_seed(seed + i);
    check_trial(i, NULL, NULL);
    check_moving(&random);
    check_contacts(&random, i % 2 == 0 ? sizeof cells / sizeof cells[0] : (uint32_t)(i % 30));
  }
  random_state random = random_seed(seed + TRIALS);
  check_refusals(&random);
  check_unchecked();
  printf("%lu pairs, %lu near, %lu of two concave parts, %lu manifolds, %lu with few cells\n", tally.pairs, tally.near,
         tally.both, tally.manifolds, tally.small);
  CHECK(tally.near > 1000 && tally.both > 50 && tally.manifolds > 100 && tally.small > 2);
  return check_done("concave_cases");
}
