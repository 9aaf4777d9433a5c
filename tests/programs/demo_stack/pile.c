// Makes the pile that falls: crates, balls, capsules and drums above a floor.
#include <string.h>

#include "demo_stack.h"
#include "random.h"

#define ONE GJK_Q16_ONE
#define LAYERS 6

static gjk_shape shape_of(const case_shape *c) {
  const gjk_vec3 *s = &c->size;
  const gjk_shape box = GJK_ROUNDED_BOX(s->x, s->y, s->z, c->convex_radius), ball = GJK_SPHERE(c->convex_radius),
                  capsule = GJK_CAPSULE(c->convex_radius, s->z), drum = GJK_CYLINDER(s->x, s->z);
  return c->kind == CASE_POINT ? ball : c->kind == CASE_SEGMENT ? capsule : c->kind == CASE_CYLINDER ? drum : box;
}

static void add(demo_stack *d, unsigned kind, const case_shape *drawn, bool fixed) {
  const unsigned i = d->world.bodies;
  const gjk_vec3 half = {drawn->size.x + drawn->convex_radius, drawn->size.y + drawn->convex_radius,
                         drawn->size.z + drawn->convex_radius};
  d->drawn[i] = *drawn;
  d->kind[i] = kind;
  d->shape[i] = shape_of(drawn);
  solver_add(&d->world, &d->shape[i], half, &drawn->pose, fixed);
}

static gjk_quat any_turn(random_state *random) {
  const gjk_quat q = {random_range(random, -500, 500), random_range(random, -500, 500),
                      random_range(random, -1000, 1000), 1000};
  gjk_quat unit;
  (void)gjk_quat_normalize(&q, &unit);
  return unit;
}

static case_shape make(case_kind kind, gjk_vec3 size, gjk_q16 convex_radius) {
  case_shape shape;
  memset(&shape, 0, sizeof shape);
  shape.kind = kind;
  shape.size = size;
  shape.convex_radius = convex_radius;
  shape.pose.rotation.w = GJK_Q30_ONE;
  return shape;
}

// Adds a floor at height 0 with a low rim.
static void add_tray(demo_stack *d) {
  const gjk_q16 x = ONE * 7 / 2, y = ONE * 14 / 5, rim = ONE / 8, low = ONE / 4, high = ONE / 2;
  const gjk_vec3 plate = {x, y, low}, side = {rim, y, high}, front = {x + 2 * rim, rim, high};
  case_shape part = make(CASE_BOX, plate, 0);
  part.pose.position.z = -low;
  add(d, 0, &part, true);
  for (int sign = -1; sign <= 1; sign += 2) {
    part = make(CASE_BOX, side, 0);
    part.pose.position.x = sign * (x + rim);
    add(d, 0, &part, true);
    part = make(CASE_BOX, front, 0);
    part.pose.position.y = sign * (y + rim);
    add(d, 0, &part, true);
  }
}

void demo_stack_start(demo_stack *d) {
  static const struct {
    case_kind kind;
    gjk_vec3 size;
    gjk_q16 convex_radius;
  } kinds[] = {
      {.kind = CASE_BOX, .size = {ONE / 2, ONE / 2, ONE / 2}},
      {.kind = CASE_BOX, .size = {ONE / 2, ONE / 3, ONE / 4}},
      {.kind = CASE_POINT, .size = {0, 0, 0}, .convex_radius = ONE * 2 / 5},
      {.kind = CASE_SEGMENT, .size = {0, 0, ONE * 2 / 5}, .convex_radius = ONE / 4},
      {.kind = CASE_CYLINDER, .size = {ONE * 2 / 5, ONE * 2 / 5, ONE / 2}},
      {.kind = CASE_BOX, .size = {ONE / 3, ONE / 3, ONE / 3}, .convex_radius = ONE / 12},
  };
  random_state random = random_seed(7);
  solver_init(&d->world, 20);
  d->world.damping = 5;
  add_tray(d);
  for (int layer = 0; layer < LAYERS; layer++) {
    for (int i = 0; i < 5; i++) {
      const unsigned kind = (unsigned)(5 * layer + i) % 6;
      case_shape shape = make(kinds[kind].kind, kinds[kind].size, kinds[kind].convex_radius);
      shape.pose.rotation = any_turn(&random);
      shape.pose.position.x = (i % 3 - 1) * ONE * 8 / 5 + random_range(&random, -ONE / 4, ONE / 4);
      shape.pose.position.y = (i / 3 * 2 - 1) * ONE * 4 / 5 + random_range(&random, -ONE / 4, ONE / 4);
      shape.pose.position.z = ONE + layer * ONE * 3 / 2;
      add(d, kind + 1, &shape, false);
    }
  }
}

unsigned demo_stack_falling(const demo_stack *d) {
  unsigned count = 0;
  for (unsigned i = 0; i < d->world.bodies; i++) {
    count += d->world.body[i].inverse_mass != 0;
  }
  return count;
}
