// Random bodies of many parts.
#include "generate/body.h"

#include <math.h>
#include <string.h>

#include "reference/random_shape.h"

static const case_kind polytopes[] = {CASE_POINT, CASE_SEGMENT, CASE_TRIANGLE, CASE_BOX, CASE_BOX, CASE_HULL};
static const case_kind curved_kinds[] = {CASE_CYLINDER, CASE_CONE, CASE_ELLIPSOID};

static case_kind kind_of(random_state *random, bool curved) {
  return curved && random_below(random, 2) == 0 ? curved_kinds[random_below(random, 3)]
                                                : polytopes[random_below(random, 6)];
}

static gjk_q16 size_of(random_state *random, gjk_q16 spread) {
  const double most = spread < RANDOM_REACH_MAX ? spread : RANDOM_REACH_MAX;
  const double size = most * exp(-5 * random_unit(random));
  return size < 8 ? 8 : (gjk_q16)size;
}

static void make_part(random_state *random, generate_body *body, gjk_q16 spread, uint16_t i) {
  case_shape *s = &body->source[i];
  if (body->layout == GENERATE_ROW) {
    const gjk_q16 half = spread / GENERATE_BODY_PARTS + 1;
    const gjk_vec3 size = {half, half, half};
    case_shape_reset(s);
    s->kind = CASE_BOX;
    s->size = size;
    s->pose.position.x = 2 * half * ((int32_t)i - body->count / 2);
    return;
  }
  random_shape(random, kind_of(random, body->layout == GENERATE_CURVED), size_of(random, spread), s);
  if (body->layout != GENERATE_PILE) {
    s->pose.position.x = random_range(random, -spread, spread);
    s->pose.position.y = random_range(random, -spread, spread);
    s->pose.position.z = random_range(random, -spread, spread);
  }
}

// The leaves of the tree in the order of their numbers.
static void make_list(generate_body *body) {
  uint32_t leaves = 0;
  for (uint32_t i = 0; i < body->with_tree.node_count; i++) {
    const gjk_compound_node *n = &body->nodes[i];
    if (n->part != UINT16_MAX) {
      body->list[n->part] = *n;
      body->list[n->part].skip = (uint16_t)(n->part + 1);
      leaves++;
    }
  }
  body->without = body->with_tree;
  body->without.nodes = body->list;
  body->without.node_count = (uint16_t)leaves;
}

void generate_body_make(generate_layout layout, uint64_t seed, uint16_t count, gjk_q16 spread, const gjk_vec3 *position,
                        generate_body *body) {
  random_state random = random_seed(seed);
  body->seed = seed;
  body->layout = layout;
  body->count = count;
  for (uint16_t i = 0; i < count; i++) {
    make_part(&random, body, spread, i);
    if (case_collider_build(&body->part[i], &body->source[i], true) != GJK_OK) {
      printf("generate_body_make: part %d is refused\n", (int)i);
    }
    body->parts[i].shape = &body->part[i].shape;
    body->parts[i].pose = body->source[i].pose;
  }
  const gjk_status status =
      gjk_compound_build(body->parts, count, body->nodes, GJK_COMPOUND_NODES((uint32_t)count), &body->with_tree);
  if (status != GJK_OK) {
    printf("generate_body_make: %s\n", gjk_status_name(status));
  }
  make_list(body);
  const gjk_parts of_tree = GJK_PARTS_OF_COMPOUND(&body->with_tree), of_list = GJK_PARTS_OF_COMPOUND(&body->without);
  body->tree = of_tree;
  body->tree.pose.position = *position;
  body->tree.pose.rotation = random_rotation(&random);
  body->flat = of_list;
  body->flat.pose = body->tree.pose;
}

void generate_body_free(generate_body *body) {
  for (unsigned i = 0; i < GENERATE_BODY_PARTS; i++) {
    case_collider_free(&body->part[i]);
    case_shape_free(&body->source[i]);
  }
}

static gjk_q16 beside(gjk_q16 x, int64_t way) {
  const int64_t sum = x + way;
  return sum > INT32_MAX ? INT32_MAX : sum < INT32_MIN ? INT32_MIN : (gjk_q16)sum;
}

void generate_visitor(random_state *random, const generate_body *body, gjk_q16 spread, bool curved, case_shape *shape) {
  gjk_parts_room room;
  gjk_collider near;
  const gjk_q16 size = size_of(random, spread);
  random_shape(random, kind_of(random, curved), size, shape);
  memset(&near, 0, sizeof near);
  gjk_parts_place(&body->tree, random_below(random, body->count), &room, &near);
  const double reach = ((double)near.radius + size) * 2 * random_unit(random);
  const gjk_vec3 way = random_vector(random, reach < 1e9 ? reach : 1e9);
  shape->pose.position.x = beside(near.centre.x, way.x);
  shape->pose.position.y = beside(near.centre.y, way.y);
  shape->pose.position.z = beside(near.centre.z, way.z);
}

void generate_body_show(const void *body) {
  const generate_body *b = (const generate_body *)body;
  printf("  body %llu: layout %d, %d parts\n", (unsigned long long)b->seed, (int)b->layout, (int)b->count);
}
