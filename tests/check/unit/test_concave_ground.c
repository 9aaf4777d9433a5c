// Bodies that slide and roll over grounds of thousands of triangles, in a scene, under the tests' solver: a mesh and a
// height field, flat, tilted and gently bent. Each contact's normal is one that the ground has there; nothing that goes
// over the joints is stopped or thrown up by them; and a body at rest stays.
#include <math.h>
#include <string.h>

#include "check.h"
#include "generate/surface.h"
#include "gjk/gjk.h"
#include "gjk/probe.h"
#include "placed.h"
#include "reference/random_shape.h"
#include "solver/solver.h"

#define SEED UINT64_C(0x47726E64)
#define ONE GJK_Q16_ONE
#define MOVERS 6
#define TICKS 240
#define SIDE 61
#define STEP (ONE / 2)

static struct {
  unsigned long contacts, manifolds, ticks, edges;
  double travelled;
} tally;

static solver_world world;
static gjk_scene scene;
static uint32_t block[20000];
static gjk_epa_cell cells[GJK_EPA_CELLS(64)];
static const gjk_workspace workspace = {cells, sizeof cells / sizeof cells[0]};
static gjk_body_id body[MOVERS + 1];
static bool near[MOVERS + 1][MOVERS + 1];
static gjk_parts ground;
static double steepest;  // of the ground's triangles: the least cosine with up

static double component(gjk_q30 x) {
  return (double)x / GJK_Q30_ONE;
}

// The normals of the triangles that are near a point, and up to how far a contact's may be from one of them: an edge's
// lies between those of its neighbours.
static bool has_normal(const gjk_vec3 *at, const gjk_unit3 *normal) {
  static const gjk_shape point = GJK_SPHERE(ONE / 64);
  const gjk_pose pose = {*at, {0, 0, 0, GJK_Q30_ONE}};
  double low = 1, best = -2;
  double normals[16][3];
  unsigned count = 0;
  const gjk_collider ball = posed(&point, &pose);
  for (uint32_t i = 0; i < gjk_parts_count(&ground) && count < 16; i++) {
    gjk_parts_room room;
    gjk_collider t;
    gjk_decision touch;
    gjk_aabb box, own;
    CHECK(gjk_parts_place(&ground, i, &room, &t) == GJK_OK);
    CHECK(gjk_collider_aabb(&t, &box) == GJK_OK && gjk_collider_aabb(&ball, &own) == GJK_OK);
    if (box.lower.x > own.upper.x || own.lower.x > box.upper.x || box.lower.y > own.upper.y ||
        own.lower.y > box.upper.y || gjk_intersect(&t, &ball, NULL, &touch) != GJK_OK || !touch.yes) {
      continue;
    }
    const double ax = (double)t.frame[1].x - t.frame[0].x, ay = (double)t.frame[1].y - t.frame[0].y,
                 az = (double)t.frame[1].z - t.frame[0].z, bx = (double)t.frame[2].x - t.frame[0].x,
                 by = (double)t.frame[2].y - t.frame[0].y, bz = (double)t.frame[2].z - t.frame[0].z;
    const double x = ay * bz - az * by, y = az * bx - ax * bz, z = ax * by - ay * bx,
                 length = sqrt(x * x + y * y + z * z);
    normals[count][0] = x / length;
    normals[count][1] = y / length;
    normals[count][2] = z / length;
    for (unsigned k = 0; k < count; k++) {
      const double cosine =
          normals[k][0] * normals[count][0] + normals[k][1] * normals[count][1] + normals[k][2] * normals[count][2];
      low = cosine < low ? cosine : low;
    }
    const double cosine = normals[count][0] * component(normal->x) + normals[count][1] * component(normal->y) +
                          normals[count][2] * component(normal->z);
    best = cosine > best ? cosine : best;
    count++;
  }
  tally.edges += count > 1;
  // 3 degrees are what contacts of one manifold may differ by.
  return count > 0 && acos(best > 1 ? 1 : best) <= acos(low < -1 ? -1 : low) + 3.1 * 3.14159265 / 180;
}

static unsigned scene_manifolds(void *user, unsigned a, unsigned b, gjk_manifold *out, unsigned capacity) {
  gjk_report report = {0};
  unsigned count = 0;
  (void)user;
  if (!near[a][b]) {
    return 0;
  }
  report.a = body[a];
  report.b = body[b];
  CHECK(gjk_scene_manifolds(&scene, &report, SOLVER_POINTS_MAX, out, capacity, &count) == GJK_OK);
  tally.manifolds += count;
  for (unsigned n = 0; n < count && a == 0; n++) {
    CHECK_MSG(component(out[n].normal.z) >= steepest - 1e-4, "normal z %f, the ground's at least %f",
              component(out[n].normal.z), steepest);
    for (unsigned i = 0; i < out[n].count; i++) {
      tally.contacts++;
      CHECK_MSG(tally.contacts % 64 != 0 || has_normal(&out[n].contact[i].point_a, &out[n].normal),
                "a normal (%f, %f, %f) that the ground has not", component(out[n].normal.x), component(out[n].normal.y),
                component(out[n].normal.z));
      for (unsigned k = 0; k < i; k++) {
        CHECK(out[n].contact[i].id != out[n].contact[k].id);
      }
    }
  }
  return count;
}

static void find_near(void) {
  gjk_report reports[100];
  gjk_progress progress;
  memset(near, 0, sizeof near);
  for (unsigned i = 1; i <= MOVERS; i++) {
    CHECK(gjk_scene_move(&scene, body[i], &world.body[i].pose) == GJK_OK);
  }
  CHECK(gjk_scene_update(&scene, reports, 100, &progress) == GJK_OK && progress.reports_left == 0);
  for (uint32_t i = 0; i < progress.reports; i++) {
    near[reports[i].a.slot][reports[i].b.slot] = reports[i].event != GJK_EVENT_END;
  }
}

static const gjk_vec3 half = {ONE / 2, ONE / 2, ONE / 2};

// Six bodies on their way over a ground, each on a track of its own.
static void build(random_state *random, const gjk_parts *parts, const gjk_shape *shape, const gjk_shape *movers,
                  double speed) {
  static const gjk_shape bound = GJK_BOX(GJK_Q16(60), GJK_Q16(60), GJK_Q16(60));
  static const gjk_shape *shapes[MOVERS + 1];
  const gjk_scene_config config = {
      MOVERS + 1, MOVERS + 1, 0, 100, ONE / 8, GJK_DETAIL_TOUCH, 1, 0, 0, sizeof cells / sizeof cells[0], 0};
  const gjk_scene_bindings bindings = {.details = &gjk_scene_contacts, .workspace = &workspace};
  shapes[0] = shape;
  for (unsigned i = 0; i < MOVERS; i++) {
    shapes[i + 1] = &movers[i];
  }
  CHECK(gjk_scene_bytes(&config) <= sizeof block);
  CHECK(gjk_scene_init(&scene, &config, block, sizeof block, shapes, MOVERS + 1, &bindings) == GJK_OK);
  solver_init(&world, 10);
  world.manifolds = scene_manifolds;
  ground = *parts;
  for (uint16_t i = 0; i <= MOVERS; i++) {
    const gjk_part part = {i, false, GJK_POSE_IDENTITY};
    gjk_body_setup setup = {parts->pose,          &part, 1, i == 0 ? GJK_BODY_STATIC : GJK_BODY_DYNAMIC, 0, 1, 1, i,
                            SOLVER_MARGIN / 2 + 1};
    if (i > 0) {
      const gjk_vec3 from = {-8 * ONE, (5 - 2 * (int)i) * ONE * 2 + 3 * ONE, 20 * ONE},
                     to = {from.x, from.y, -20 * ONE};
      gjk_scene_hit hit;
      gjk_cast_result result;
      bool found = false;
      const gjk_pose start = {from,
                              random_below(random, 2) ? random_rotation(random) : (gjk_quat){0, 0, 0, GJK_Q30_ONE}};
      const gjk_collider c = posed(&movers[i - 1], &start);
      const gjk_scene_filter filter = {1, 1, {0, 0}, NULL, NULL};
      CHECK(gjk_scene_cast(&scene, &c, &to, 0, &filter, &hit, &result, &found) == GJK_OK && found);
      setup.pose = start;
      setup.pose.position = result.rest_b;
      setup.pose.position.z += 200;
    }
    CHECK(gjk_scene_add_at(&scene, i, &setup, &body[i]) == GJK_OK);
    CHECK(solver_add(&world, i == 0 ? &bound : &movers[i - 1], half, &setup.pose, i == 0) == i);
    world.body[i].velocity.x = i == 0 ? 0 : (solver_fix)(speed * (double)SOLVER_ONE);
  }
}

static void play(unsigned ticks, bool flat) {
  solver_vec from[MOVERS + 1];
  for (unsigned i = 1; i <= MOVERS; i++) {
    from[i] = world.body[i].position;
  }
  for (unsigned t = 0; t < ticks; t++) {
    find_near();
    solver_step(&world);
    tally.ticks++;
  }
  for (unsigned i = 1; i <= MOVERS; i++) {
    const solver_vec *p = &world.body[i].position;
    tally.travelled += (double)(p->x - from[i].x) / (double)SOLVER_ONE;
    const double up = (double)(p->z - from[i].z) / (double)SOLVER_ONE;
    CHECK_MSG(!flat || up < 0.6, "body %u was thrown up by %f", i, up);
  }
}

static void make_shape(random_state *random, gjk_shape *out) {
  static const gjk_shape kinds[] = {GJK_BOX(ONE / 2, ONE / 2, ONE / 2), GJK_SPHERE(ONE / 2),
                                    GJK_CAPSULE(ONE / 3, ONE / 3), GJK_ROUNDED_BOX(ONE / 3, ONE / 3, ONE / 3, ONE / 8)};
  *out = kinds[random_below(random, 4)];
}

static void try_ground(random_state *random, gjk_parts parts, bool flat) {
  gjk_concave concave;
  gjk_shape shape, movers[MOVERS];
  CHECK(gjk_concave_init(&parts, &concave, &shape) == GJK_OK);
  for (unsigned i = 0; i < MOVERS; i++) {
    make_shape(random, &movers[i]);
  }
  steepest = 1;
  for (uint32_t i = 0; i < gjk_parts_count(&parts); i++) {
    gjk_parts_room room;
    gjk_collider t;
    CHECK(gjk_parts_place(&parts, i, &room, &t) == GJK_OK);
    const double ax = (double)t.frame[1].x - t.frame[0].x, ay = (double)t.frame[1].y - t.frame[0].y,
                 az = (double)t.frame[1].z - t.frame[0].z, bx = (double)t.frame[2].x - t.frame[0].x,
                 by = (double)t.frame[2].y - t.frame[0].y, bz = (double)t.frame[2].z - t.frame[0].z;
    const double x = ay * bz - az * by, y = az * bx - ax * bz, z = ax * by - ay * bx;
    const double cosine = z / sqrt(x * x + y * y + z * z);
    steepest = cosine < steepest ? cosine : steepest;
  }
  build(random, &parts, &shape, movers, 3);
  play(TICKS, flat);
}

int main(void) {
  const uint64_t seed = check_seed(SEED);
  static int16_t heights[SIDE * SIDE];
  for (unsigned long i = 0; i < 8; i++) {
    random_state random = random_seed(seed + i);
    check_trial(i, NULL, NULL);
    const bool flat = i % 2 == 0;
    if (i < 4) {
      surface s;
      surface_make(&random, flat ? SURFACE_FLAT : SURFACE_BENT, 2 * SIDE * SIDE, STEP, false, &s);
      for (uint32_t k = 0; flat && k < s.vertex_count; k++) {
        s.vertices[k].z = s.vertices[k].z / 16;
      }
      CHECK(gjk_mesh_build(s.vertices, s.vertex_count, s.triangles, s.triangle_count, false, s.nodes, s.node_count,
                           &s.mesh) == GJK_OK);
      try_ground(&random, (gjk_parts)GJK_PARTS_OF_MESH(&s.mesh), flat);
      surface_free(&s);
    } else {
      for (int k = 0; k < SIDE * SIDE; k++) {
        const double x = k % SIDE, y = k / SIDE;
        heights[k] = (int16_t)(flat ? 0 : 700 * (sin(x / 6) + cos(y / 7)));
      }
      const gjk_height_field field = GJK_HEIGHT_FIELD(heights, SIDE, SIDE, STEP, STEP, 33);
      gjk_parts parts = GJK_PARTS_OF_HEIGHT_FIELD(&field);
      CHECK(gjk_height_field_check(&field) == GJK_OK);
      parts.pose.position.x = parts.pose.position.y = -(SIDE / 2) * STEP;
      try_ground(&random, parts, flat);
    }
  }
  printf("%lu contacts in %lu manifolds, %lu at edges, %lu ticks, %.1f units\n", tally.contacts, tally.manifolds,
         tally.edges, tally.ticks, tally.travelled);
  CHECK(tally.contacts > 10000 && tally.edges > 100 && tally.travelled > 8 * MOVERS);
  return check_done("concave_ground");
}
