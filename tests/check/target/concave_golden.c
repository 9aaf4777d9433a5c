// A fixed run of a scene with concave bodies and its hash, without libc and with little RAM.
#include "concave_golden.h"

#include "gjk/concave.h"
#include "gjk/gjk.h"
#include "gjk/slide.h"
#include "golden_mix.h"

#define ONE GJK_Q16_ONE
#define SIDE 4
#define CELLS 120
#define MANIFOLDS 3
#define AT(x, y, z)        \
  {                        \
    {x, y, z}, {           \
      0, 0, 0, GJK_Q30_ONE \
    }                      \
  }

enum { MESH, FIELD, CHAIR, CRATE, BALL, CAPSULE, SHAPES };
enum { FIRST_MOVER = 2, BODIES = 8 };

static const gjk_shape seat = GJK_BOX(ONE / 2, ONE / 2, ONE / 8), back = GJK_BOX(ONE / 8, ONE / 2, ONE / 2),
                       knob = GJK_SPHERE(ONE / 4);
static const gjk_compound_part chair_parts[] = {
    {&seat, AT(0, 0, 0)}, {&back, AT(-ONE / 2, 0, ONE / 2)}, {&knob, AT(-ONE / 2, 0, ONE)}};
static const gjk_shape crate = GJK_BOX(ONE / 3, ONE / 4, ONE / 4), ball = GJK_SPHERE(ONE / 3),
                       capsule = GJK_CAPSULE(ONE / 4, ONE / 3);

static gjk_vec3 corners[(SIDE + 1) * (SIDE + 1)];
static gjk_mesh_triangle triangles[2 * SIDE * SIDE];
static gjk_mesh_node mesh_nodes[GJK_MESH_NODES(2 * SIDE * SIDE)];
static gjk_mesh mesh;
static int16_t heights[(SIDE + 1) * (SIDE + 1)];
static const gjk_height_field field = GJK_HEIGHT_FIELD(heights, SIDE + 1, SIDE + 1, ONE, ONE, 4000);
static gjk_compound_node nodes[GJK_COMPOUND_NODES(3)];
static gjk_compound chair;
static gjk_concave concave[CHAIR + 1];
static gjk_shape concave_shape[CHAIR + 1];
static const gjk_shape *const shapes[SHAPES] = {
    &concave_shape[MESH], &concave_shape[FIELD], &concave_shape[CHAIR], &crate, &ball, &capsule};
static uint32_t block[2400];
static gjk_epa_cell cells[CELLS];
static gjk_manifold of_report;
static gjk_manifold manifolds[MANIFOLDS];

static struct {
  gjk_body_id id;
  gjk_vec3 step;
  gjk_quat turn;
} mover[BODIES];

static bool fine;

static void need(gjk_status status) {
  fine = fine && status == GJK_OK;
}

static void mix_manifold(const gjk_manifold *m) {
  mix(m->count);
  mix_unit(&m->normal);
  mix_contacts_of(m);
}

// Both grounds are 4 units long and wide: the mesh from x = -4 on, the field from x = 0 on, with a hole.
static void make_grounds(random_state *random) {
  uint32_t count = 0;
  for (unsigned k = 0; k < (SIDE + 1) * (SIDE + 1); k++) {
    corners[k].x = ((int32_t)(k % (SIDE + 1)) - SIDE) * ONE;
    corners[k].y = ((int32_t)(k / (SIDE + 1)) - SIDE / 2) * ONE;
    corners[k].z = random_range(random, 0, 2) * (ONE / 5);
    heights[k] = (int16_t)(k == 8 ? GJK_HEIGHT_HOLE : random_range(random, -3, 3));
  }
  for (uint32_t k = 0; k < (uint32_t)SIDE * SIDE; k++) {
    const uint32_t a = k / SIDE * (SIDE + 1) + k % SIDE, b = a + 1, c = a + SIDE + 2, d = a + SIDE + 1;
    const gjk_mesh_triangle first = {{a, b, c}}, second = {{a, c, d}};
    triangles[count++] = first;
    triangles[count++] = second;
  }
  need(gjk_mesh_build(corners, (SIDE + 1) * (SIDE + 1), triangles, count, false, mesh_nodes,
                      sizeof mesh_nodes / sizeof mesh_nodes[0], &mesh));
  need(gjk_compound_build(chair_parts, 3, nodes, sizeof nodes / sizeof nodes[0], &chair));
  const gjk_parts of[] = {GJK_PARTS_OF_MESH(&mesh), GJK_PARTS_OF_HEIGHT_FIELD(&field), GJK_PARTS_OF_COMPOUND(&chair)};
  for (unsigned i = 0; i <= CHAIR; i++) {
    need(gjk_concave_init(&of[i], &concave[i], &concave_shape[i]));
  }
}

// Two chairs, a crate, a ball, two capsules. The ball, one chair and one capsule are fast.
static void add(gjk_scene *scene, random_state *random, uint32_t slot) {
  static const uint16_t shape[BODIES] = {MESH, FIELD, CHAIR, CHAIR, CRATE, BALL, CAPSULE, CAPSULE};
  static const uint8_t detail[BODIES] = {GJK_DETAIL_TOUCH,    GJK_DETAIL_TOUCH,    GJK_DETAIL_CONTACTS,
                                         GJK_DETAIL_CONTACTS, GJK_DETAIL_CONTACTS, GJK_DETAIL_DISTANCE,
                                         GJK_DETAIL_DEPTH,    GJK_DETAIL_TOUCH};
  const gjk_part part = {shape[slot], false, GJK_POSE_IDENTITY};
  const bool fixed = slot < FIRST_MOVER;
  const gjk_quat turn = {random_range(random, -900, 900), random_range(random, -900, 900),
                         random_range(random, -900, 900), 30000};
  gjk_body_setup setup = {GJK_POSE_IDENTITY, &part, 1,          (uint8_t)(fixed ? GJK_BODY_STATIC : GJK_BODY_DYNAMIC),
                          detail[slot],      1,     UINT32_MAX, slot,
                          ONE / 16};
  if (!fixed) {
    setup.pose.position.x = ((int32_t)slot - 5) * ONE;
    setup.pose.position.y = random_range(random, -ONE, ONE);
    setup.pose.position.z = ONE + ONE / 4;
  }
  if (slot == FIELD) {
    setup.pose.position.y = -SIDE / 2 * ONE;
  }
  mover[slot].step.x = random_range(random, -6000, 6000);
  mover[slot].step.y = random_range(random, -6000, 6000);
  mover[slot].step.z = random_range(random, -2000, 2000);
  need(gjk_quat_normalize(&turn, &mover[slot].turn));
  need(gjk_scene_add_at(scene, slot, &setup, &mover[slot].id));
  if (slot == 3 || slot == 5 || slot == 6) {
    need(gjk_scene_set_motion(scene, mover[slot].id, GJK_MOTION_FAST));
  }
}

static int32_t bounced(int32_t at, int32_t step, int32_t low, int32_t high) {
  return (at > high && step > 0) || (at < low && step < 0) ? -step : step;
}

static void move(gjk_scene *scene, uint32_t slot) {
  gjk_body_state state;
  gjk_vec3 *step = &mover[slot].step, *at = &state.pose.position;
  const gjk_status status = gjk_scene_get(scene, mover[slot].id, &state);
  need(status);
  if (status != GJK_OK) {
    return;
  }
  step->z -= 300;
  step->x = bounced(at->x, step->x, -3 * ONE, 3 * ONE);
  step->y = bounced(at->y, step->y, -3 * ONE / 2, 3 * ONE / 2);
  step->z = bounced(at->z, step->z, 0, 2 * ONE);
  at->x += step->x;
  at->y += step->y;
  at->z += step->z;
  if (slot != 3) {  // only where neither turns are concave bodies that meet on their way found
    gjk_quat_compose(&mover[slot].turn, &state.pose.rotation, &state.pose.rotation);
  }
  need(gjk_scene_move(scene, mover[slot].id, &state.pose));
}

// What is touched pushes a mover away a little: the next ticks depend on the bits of these.
static void react(const gjk_scene *scene, const gjk_report *r) {
  unsigned count = 0;
  mix(r->a.slot | r->b.slot << 8 | (uint32_t)r->event << 16);
  mix((uint32_t)r->distance);
  mix((uint32_t)r->fraction);
  if (r->event == GJK_EVENT_END || r->event == GJK_EVENT_IMPACT) {
    return;
  }
  if (r->manifold != NULL) {
    mix_manifold(r->manifold);
  }
  const gjk_status status = gjk_scene_manifolds(scene, r, 4, manifolds, MANIFOLDS, &count);
  mix((uint32_t)status);
  mix(count);
  for (unsigned i = 0; i < count && (status == GJK_OK || status == GJK_ERROR_CAPACITY); i++) {
    mix_manifold(&manifolds[i]);
    mover[r->b.slot].step.x += manifolds[i].normal.x / (1 << 18);
    mover[r->b.slot].step.y += manifolds[i].normal.y / (1 << 18);
    mover[r->b.slot].step.z += manifolds[i].normal.z / (1 << 18) + (manifolds[i].count & 1);
  }
}

static void mix_hit(bool found, const gjk_scene_hit *hit, const gjk_cast_result *result) {
  mix((uint32_t)found);
  if (found) {
    mix(hit->body.slot);
    mix((uint32_t)result->fraction);
    mix_unit(&result->normal);
    mix_vector(&result->rest_b);
  }
}

// A ray, a cast and a walk over both grounds.
static void ask(const gjk_scene *scene, random_state *random) {
  const gjk_vec3 from = {random_range(random, -3 * ONE, 3 * ONE), random_range(random, -ONE, ONE), 3 * ONE},
                 to = {random_range(random, -3 * ONE, 3 * ONE), random_range(random, -ONE, ONE), -ONE};
  const gjk_pose start = {from, {0, 0, 0, GJK_Q30_ONE}};
  const gjk_slide_setup setup = {{0, 0, GJK_Q30_ONE}, GJK_Q30_ONE / 2, 328, ONE / 3, ONE / 8, true, NULL};
  static gjk_collider walker;
  gjk_scene_hit hit;
  gjk_cast_result result;
  gjk_slide_result slide;
  bool found = false;
  mix((uint32_t)gjk_scene_cast_ray(scene, &from, &to, NULL, &hit, &result, &found));
  mix((uint32_t)found);
  if (found) {
    mix(hit.body.slot);
    mix((uint32_t)result.fraction);
    mix_unit(&result.normal);
  }
  need(gjk_collider_init(&walker, random_below(random, 2) == 0 ? &crate : &capsule, NULL, 0));
  need(gjk_collider_pose(&walker, &start));
  mix((uint32_t)gjk_scene_cast(scene, &walker, &to, 400, NULL, &hit, &result, &found));
  mix_hit(found, &hit, &result);
  const gjk_status status = gjk_slide(scene, &walker, &to, &setup, &slide);
  mix((uint32_t)status);
  if (status == GJK_OK) {
    mix_vector(&slide.position);
    mix(slide.count | (uint32_t)slide.on_ground << 8 | (uint32_t)slide.stepped << 9 | (uint32_t)slide.stuck << 10);
  }
}

// Both chairs, moving and turning from where they are.
static void meet(const gjk_scene *scene) {
  const gjk_impact_setup setup = {ONE / 100, 64, 40};
  gjk_motion motion[2];
  gjk_parts of[2];
  gjk_parts_pair pair = {0, 0};
  gjk_impact_result impact;
  for (uint32_t i = 0; i < 2; i++) {
    static const gjk_vec3 still = {0, 0, 0};
    need(gjk_scene_parts(scene, mover[FIRST_MOVER + i].id, 0, &of[i]));
    motion[i].from = of[i].pose;
    motion[i].to = of[i].pose;
    motion[i].spin = still;
    motion[i].to.position.x += i == 0 ? 3 * ONE : -ONE;
    gjk_quat_compose(&mover[FIRST_MOVER].turn, &of[i].pose.rotation, &motion[i].to.rotation);
  }
  const gjk_status status =
      fine ? gjk_parts_both_time_of_impact(&of[0], &motion[0], &of[1], &motion[1], &setup, &pair, &impact)
           : GJK_ERROR_NULL;
  mix((uint32_t)status);
  if (status == GJK_OK || status == GJK_ERROR_ITERATION_LIMIT) {
    mix(pair.a ^ pair.b << 16);
    mix((uint32_t)impact.hit | (uint32_t)impact.overlap << 1);
    mix((uint32_t)impact.lower);
    mix((uint32_t)impact.upper);
  }
}

static void play(gjk_scene *scene, random_state *random) {
  gjk_report report;
  gjk_progress progress;
  for (uint32_t i = FIRST_MOVER; i < BODIES; i++) {
    move(scene, i);
  }
  do {
    progress.reports = progress.reports_left = 0;
    need(gjk_scene_update(scene, &report, 1, &progress));
    if (progress.reports > 0) {
      react(scene, &report);
    }
  } while (progress.reports_left > 0);
  ask(scene, random);
  meet(scene);
}

uint64_t concave_golden_hash(uint32_t ticks) {
  static const gjk_workspace workspace = {cells, CELLS};
  static const gjk_scene_bindings bindings = {
      .details = &gjk_scene_contacts, .workspace = &workspace, .manifolds = &of_report, .motion = &gjk_scene_motion};
  const gjk_scene_config config = {BODIES, BODIES, 0, 28, ONE / 16, GJK_DETAIL_TOUCH, 1, 0, 0, CELLS, BODIES};
  gjk_scene scene;
  uint64_t state = 0;
  random_state random = random_seed(20261123);
  hash = FNV_START;
  fine = true;
  make_grounds(&random);
  need(gjk_scene_init(&scene, &config, block, sizeof block, shapes, SHAPES, &bindings));
  for (uint32_t i = 0; i < BODIES && fine; i++) {
    add(&scene, &random, i);
  }
  for (uint32_t i = 0; i < ticks && fine; i++) {
    play(&scene, &random);
  }
  need(gjk_scene_hash(&scene, &state));
  mix((uint32_t)state);
  mix((uint32_t)(state >> 32));
  return fine ? hash : 0;
}
