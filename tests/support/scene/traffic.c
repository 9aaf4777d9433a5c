// Scenes that move by rule.
#include "traffic.h"

static const gjk_vec3 corners[8] = {{30000, 2000, 1000},   {-28000, 9000, -3000},  {5000, 31000, 2000},
                                    {-3000, -30000, 4000}, {1000, 2000, 33000},    {-2000, 900, -31000},
                                    {20000, 20000, 12000}, {-19000, -18000, -9000}};
static const gjk_shape crate = GJK_BOX(GJK_Q16(0.5), GJK_Q16(0.5), GJK_Q16(0.5)), ball = GJK_SPHERE(GJK_Q16(0.5));
static const gjk_shape capsule = GJK_CAPSULE(GJK_Q16(0.25), GJK_Q16(0.4)), stone = GJK_HULL(corners, 8);
static const gjk_shape plate = GJK_BOX(GJK_Q16(1.0), GJK_Q16(1.0), GJK_Q16(0.25));

const gjk_shape *const traffic_shapes[TRAFFIC_SHAPES] = {&crate, &ball, &capsule, &stone, &plate};

#define PLATE 4
#define COLUMN 8  // crates on a plate

gjk_scene_config traffic_config(traffic_kind kind, uint32_t count) {
  gjk_scene_config c = {count, count, 0, 0, GJK_Q16(0.1), GJK_DETAIL_TOUCH, 0, 0, 0, 0, 0};
  c.pairs = kind == TRAFFIC_CROWDED ? 10 * count + 64 : 6 * count + 64;
  return c;
}

static gjk_vec3 random_vector(random_state *random, gjk_vec3 reach) {
  gjk_vec3 v;
  v.x = random_range(random, -reach.x, reach.x);
  v.y = random_range(random, -reach.y, reach.y);
  v.z = random_range(random, -reach.z, reach.z);
  return v;
}

static gjk_quat random_turn(random_state *random, int32_t size) {
  const gjk_quat q = {random_range(random, -size, size), random_range(random, -size, size),
                      random_range(random, -size, size), 10000};
  gjk_quat unit = {0, 0, 0, GJK_Q30_ONE};
  gjk_quat_normalize(&q, &unit);
  return unit;
}

// The smallest n with n^3 >= x.
static int32_t cube_root(uint32_t x) {
  int32_t n = 1;
  while ((uint32_t)(n * n * n) < x) {
    n++;
  }
  return n;
}

static void place_in_pile(traffic *t, traffic_body *b, uint32_t index) {
  const uint32_t column = index / (COLUMN + 1), level = index % (COLUMN + 1);
  const uint32_t side = 2 + (uint32_t)cube_root(t->count / (COLUMN + 1)) * 3;
  const gjk_pose at = GJK_POSE_IDENTITY;
  b->pose = at;
  b->pose.position.x = (int32_t)(column % side) * GJK_Q16(2.5);
  b->pose.position.y = (int32_t)(column / side) * GJK_Q16(2.5);
  b->pose.position.z = level == 0 ? 0 : (int32_t)level * GJK_Q16(1.0) - GJK_Q16(0.25);
  b->shape = level == 0 ? PLATE : 0;
  b->moves = b->moves && level > 0;
}

static void place(traffic *t, traffic_body *b, uint32_t index) {
  const gjk_vec3 step = {GJK_Q16(0.04), GJK_Q16(0.04), GJK_Q16(0.04)};
  random_state *random = &t->random;
  b->shape = (uint8_t)random_below(random, PLATE);
  b->moves = random_below(random, 100) < t->percent;
  b->pose.position = random_vector(random, t->reach);
  b->pose.rotation = random_turn(random, 20000);
  b->step = random_vector(random, step);
  b->turn = random_turn(random, 100);
  if (t->kind == TRAFFIC_PILES) {
    place_in_pile(t, b, index);
  } else if (t->kind == TRAFFIC_STREAMING) {
    b->shape = b->moves ? b->shape : PLATE;
    b->pose.position.x = t->ahead + (int32_t)((int64_t)t->reach.x * (int32_t)index / (int32_t)t->count) * 2;
  }
}

bool traffic_is_static(const traffic_body *b) {
  return b->shape == PLATE;
}

gjk_status traffic_add(gjk_scene *scene, uint32_t slot, traffic_body *b) {
  gjk_part part = {0, false, GJK_POSE_IDENTITY};
  part.shape = b->shape;
  gjk_body_setup setup = {GJK_POSE_IDENTITY, &part, 1, GJK_BODY_DYNAMIC, GJK_DETAIL_TOUCH, 1, UINT32_MAX, 0, 0};
  setup.pose = b->pose;
  setup.kind = traffic_is_static(b) ? GJK_BODY_STATIC : GJK_BODY_DYNAMIC;
  return gjk_scene_add_at(scene, slot, &setup, &b->id);
}

gjk_status traffic_start(traffic *t, gjk_scene *scene, traffic_kind kind, uint32_t count, uint32_t percent,
                         traffic_body *bodies) {
  const gjk_q16 spacing = kind == TRAFFIC_CROWDED ? GJK_Q16(1.5) : GJK_Q16(4);
  t->kind = kind;
  t->count = count;
  t->percent = percent;
  t->bodies = bodies;
  t->oldest = 0;
  t->ahead = 0;
  t->random = random_seed(17);
  t->reach.x = cube_root(count) * (spacing / 2);
  t->reach.y = t->reach.x;
  t->reach.z = t->reach.x;
  for (uint32_t i = 0; i < count; i++) {
    place(t, &bodies[i], i);
    const gjk_status status = traffic_add(scene, i, &bodies[i]);
    if (status != GJK_OK) {
      return status;
    }
  }
  return GJK_OK;
}

// Turns a body back where the room ends.
static int32_t bounce(int32_t at, int32_t step, int32_t reach) {
  return (at > reach && step > 0) || (at < -reach && step < 0) ? -step : step;
}

void traffic_plan(traffic *t) {
  for (uint32_t i = 0; i < t->count; i++) {
    traffic_body *b = &t->bodies[i];
    if (!b->moves) {
      continue;
    }
    if (t->kind == TRAFFIC_PILES) {  // trembles
      b->step.x = -b->step.x;
      b->step.y = -b->step.y;
      b->step.z = -b->step.z;
      b->pose.position.x += b->step.x / 64;
      b->pose.position.y += b->step.y / 64;
      b->pose.position.z += b->step.z / 64;
      continue;
    }
    b->step.x = t->kind == TRAFFIC_STREAMING ? b->step.x : bounce(b->pose.position.x, b->step.x, t->reach.x);
    b->step.y = bounce(b->pose.position.y, b->step.y, t->reach.y);
    b->step.z = bounce(b->pose.position.z, b->step.z, t->reach.z);
    b->pose.position.x += b->step.x;
    b->pose.position.y += b->step.y;
    b->pose.position.z += b->step.z;
    gjk_quat_compose(&b->turn, &b->pose.rotation, &b->pose.rotation);
  }
}

// One body in a hundred is removed behind the window, and as many are added ahead, in the same slots.
static gjk_status stream(traffic *t, gjk_scene *scene) {
  for (uint32_t n = 0; n < 1 + t->count / 100; n++) {
    traffic_body *b = &t->bodies[t->oldest];
    gjk_status status = gjk_scene_remove(scene, b->id);
    t->ahead += t->reach.x / (int32_t)t->count * 2;
    place(t, b, t->count);
    status = status == GJK_OK ? traffic_add(scene, t->oldest, b) : status;
    t->oldest = (t->oldest + 1) % t->count;
    if (status != GJK_OK) {
      return status;
    }
  }
  return GJK_OK;
}

gjk_status traffic_apply(traffic *t, gjk_scene *scene) {
  for (uint32_t i = 0; i < t->count; i++) {
    const traffic_body *b = &t->bodies[i];
    const gjk_status status = b->moves ? gjk_scene_move(scene, b->id, &b->pose) : GJK_OK;
    if (status != GJK_OK) {
      return status;
    }
  }
  return t->kind == TRAFFIC_STREAMING ? stream(t, scene) : GJK_OK;
}
