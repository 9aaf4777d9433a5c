// Searches for expensive pairs by random restarts and hill climbing, without libc.
#include "worst.h"

#include "print.h"

#define CLIMB 400  // changes without success that end a climb

const worst_family worst_families[] = {
    {.name = "boxes-distance", .kind = WORST_BOXES, .distance = true},
    {.name = "boxes-intersect", .kind = WORST_BOXES},
    {.name = "hulls8-distance", .kind = WORST_HULLS, .vertices = 8, .distance = true},
    {.name = "hulls8-intersect", .kind = WORST_HULLS, .vertices = 8},
    {.name = "hulls64-distance", .kind = WORST_HULLS, .vertices = 64, .distance = true},
    {.name = "hulls64-intersect", .kind = WORST_HULLS, .vertices = 64},
    {.name = "rounded-distance", .kind = WORST_ROUNDED, .vertices = 8, .distance = true},
    {.name = "rounded-intersect", .kind = WORST_ROUNDED, .vertices = 8},
    {.name = "curved-distance", .kind = WORST_CURVED, .distance = true},
    {.name = "curved-intersect", .kind = WORST_CURVED},
};
const unsigned worst_family_count = sizeof worst_families / sizeof worst_families[0];

static random_state random;
static gjk_shape shapes[2];
static gjk_collider colliders[2];
static gjk_vec3 buffers[2][WORST_VERTICES];

const worst_family *worst_family_of(const char *id) {
  for (unsigned f = 0; f < worst_family_count; f++) {
    const char *name = worst_families[f].name;
    unsigned i = 0;
    while (name[i] != '\0' && name[i] == id[i]) {
      i++;
    }
    if (name[i] == '\0' && id[i] == '-') {
      return &worst_families[f];
    }
  }
  return NULL;
}

bool worst_pose(const worst_pair *pair) {
  for (int i = 0; i < 2; i++) {
    const worst_body *body = &pair->body[i];
    shapes[i] = body->shape;
    shapes[i].vertices = body->vertices;
    if (gjk_collider_init(&colliders[i], &shapes[i], buffers[i], WORST_VERTICES) != GJK_OK ||
        gjk_collider_pose(&colliders[i], &body->pose) != GJK_OK) {
      return false;
    }
  }
  return true;
}

const gjk_collider *worst_collider(int number) {
  return &colliders[number];
}

unsigned worst_query(const worst_family *family) {
  static gjk_distance_result result;
  static gjk_decision decision;
  if (family->distance) {
    gjk_distance(&colliders[0], &colliders[1], NULL, &result);
    return result.iterations;
  }
  gjk_intersect(&colliders[0], &colliders[1], NULL, &decision);
  return decision.iterations;
}

// Random pairs.

static gjk_vec3 random_vector(int32_t x, int32_t y, int32_t z) {
  gjk_vec3 v;
  v.x = random_range(&random, -x, x);
  v.y = random_range(&random, -y, y);
  v.z = random_range(&random, -z, z);
  return v;
}

// A number from 1 to 2^bits; every order of magnitude is equally likely.
static int32_t random_length(unsigned bits) {
  const int32_t top = INT32_C(1) << random_below(&random, bits);
  return random_range(&random, top, 2 * top - 1);
}

static void random_rotation(gjk_quat *out) {
  static const gjk_quat identity = {0, 0, 0, GJK_Q30_ONE};
  const gjk_quat q = {random_range(&random, -1000, 1000), random_range(&random, -1000, 1000),
                      random_range(&random, -1000, 1000), random_range(&random, -1000, 1001)};
  if (random_below(&random, 4) == 0 || gjk_quat_normalize(&q, out) != GJK_OK) {
    *out = identity;
  }
}

static void random_shape(const worst_family *family, worst_body *body) {
  static const gjk_shape kinds[] = {GJK_BOX(0, 0, 0),   GJK_HULL(0, 0), GJK_SEGMENT(0),        GJK_TRIANGLE(0),
                                    GJK_CYLINDER(0, 0), GJK_CONE(0, 0), GJK_ELLIPSOID(0, 0, 0)};
  switch (family->kind) {
    case WORST_BOXES: body->shape = kinds[0]; break;
    case WORST_HULLS: body->shape = kinds[1]; break;
    case WORST_ROUNDED: body->shape = kinds[random_below(&random, 4)]; break;
    case WORST_CURVED: body->shape = kinds[4 + random_below(&random, 3)]; break;
  }
  if (body->shape.type == &gjk_class_hull) {
    body->shape.count = family->vertices;
  }
}

// Shapes of sizes below 2^bits LSB, every second one with extents of different orders of magnitude. Points of hulls lie
// on a ball, on a coarse lattice, or anywhere.
static void random_body(const worst_family *family, unsigned bits, worst_body *body) {
  const int32_t size = random_length(bits);
  const bool flat = random_below(&random, 2) == 0;
  const int32_t x = flat ? random_length(bits) : size, y = flat ? random_length(bits) : size;
  const int32_t grid = random_below(&random, 4) == 0 ? size / 2 + 1 : 1;
  const bool ball = random_below(&random, 2) == 0;
  random_shape(family, body);
  body->shape.size.x = x;
  body->shape.size.y = y;
  body->shape.size.z = size;
  body->shape.convex_radius = family->kind == WORST_ROUNDED ? random_length(bits) : 0;
  for (unsigned i = 0; i < WORST_VERTICES; i++) {
    gjk_vec3 *v = &body->vertices[i];
    const gjk_unit3 unit = {random_range(&random, -1000, 1000), random_range(&random, -1000, 1000),
                            random_range(&random, -1000, 1000)};
    gjk_quat q = {unit.x, unit.y, unit.z, 0};
    *v = random_vector(x, y, size);
    if (ball && gjk_quat_normalize(&q, &q) == GJK_OK) {
      v->x = (int32_t)((int64_t)q.x * x / GJK_Q30_ONE);
      v->y = (int32_t)((int64_t)q.y * y / GJK_Q30_ONE);
      v->z = (int32_t)((int64_t)q.z * size / GJK_Q30_ONE);
    }
    v->x = v->x / grid * grid;
    v->y = v->y / grid * grid;
    v->z = v->z / grid * grid;
  }
  random_rotation(&body->pose.rotation);
  const int32_t reach = 2 * size;
  body->pose.position = random_vector(reach, reach, reach);
}

// Moves B along the normal until the gap is about 0.
static void touch(worst_pair *pair) {
  gjk_distance_result result;
  if (!worst_pose(pair) || gjk_distance(&colliders[0], &colliders[1], NULL, &result) != GJK_OK || result.intersecting ||
      result.saturated) {
    return;
  }
  const int32_t by = result.distance + random_range(&random, -3, 3);
  gjk_vec3 *position = &pair->body[1].pose.position;
  position->x -= (int32_t)((int64_t)result.normal.x * by / GJK_Q30_ONE);
  position->y -= (int32_t)((int64_t)result.normal.y * by / GJK_Q30_ONE);
  position->z -= (int32_t)((int64_t)result.normal.z * by / GJK_Q30_ONE);
}

static void random_pair(const worst_family *family, worst_pair *pair) {
  const unsigned bits = 3 + random_below(&random, 24);
  random_body(family, bits, &pair->body[0]);
  random_body(family, bits, &pair->body[1]);
  if (random_below(&random, 2) == 0) {
    touch(pair);
  }
}

// Changes.

static void nudge(int32_t *value, int32_t low) {
  const int32_t by = random_length(26);
  const int64_t changed = (int64_t)*value + (random_below(&random, 2) == 0 ? by : -by);
  if (changed >= low && changed <= GJK_RADIUS_MAX) {
    *value = (int32_t)changed;
  }
}

static int32_t *component(gjk_vec3 *v) {
  switch (random_below(&random, 3)) {
    case 0: return &v->x;
    case 1: return &v->y;
    default: return &v->z;
  }
}

static void turn(gjk_quat *q) {
  const int32_t most = random_length(30);
  gjk_quat turned;
  const gjk_vec3 by = random_vector(most, most, most);
  const gjk_quat changed = {q->x / 2 + by.x / 2, q->y / 2 + by.y / 2, q->z / 2 + by.z / 2, q->w / 2};
  if (gjk_quat_normalize(&changed, &turned) == GJK_OK) {
    *q = turned;
  }
}

// Adds a vertex (between two others, beside one, or a copy of the other body's), or removes one.
static void change_count(const worst_family *family, worst_pair *pair, worst_body *body) {
  gjk_shape *shape = &body->shape;
  const worst_body *from = &pair->body[random_below(&random, 2)];
  if (random_below(&random, 2) == 0 && shape->count < family->vertices && from->shape.type == &gjk_class_hull) {
    const gjk_vec3 *u = &from->vertices[random_below(&random, from->shape.count)];
    const gjk_vec3 *v = &from->vertices[random_below(&random, from->shape.count)];
    gjk_vec3 *added = &body->vertices[shape->count++];
    added->x = u->x / 2 + v->x / 2;
    added->y = u->y / 2 + v->y / 2;
    added->z = u->z / 2 + v->z / 2;
    nudge(component(added), -GJK_RADIUS_MAX);
  } else if (shape->count > 2) {
    body->vertices[random_below(&random, shape->count)] = body->vertices[shape->count - 1u];
    shape->count--;
  }
}

// Divides a coordinate of all vertices, or a half extent, by a power of two.
static void flatten(worst_body *body) {
  const int32_t by = INT32_C(1) << random_below(&random, 12);
  const uint32_t axis = random_below(&random, 3);
  for (unsigned i = 0; i < body->shape.count; i++) {
    gjk_vec3 *v = &body->vertices[i];
    int32_t *const at[] = {&v->x, &v->y, &v->z};
    *at[axis] /= by;
  }
  int32_t *const size[] = {&body->shape.size.x, &body->shape.size.y, &body->shape.size.z};
  *size[axis] /= by;
}

static void change_once(const worst_family *family, worst_pair *pair) {
  worst_body *body = &pair->body[random_below(&random, 2)];
  gjk_shape *shape = &body->shape;
  const uint32_t choice = random_below(&random, 10);
  if (choice == 0) {
    turn(&body->pose.rotation);
  } else if (choice < 3) {
    nudge(component(&body->pose.position), -GJK_RADIUS_MAX);
  } else if (choice == 3 && family->kind == WORST_ROUNDED) {
    nudge(&shape->convex_radius, 1);
  } else if (choice == 4) {
    touch(pair);
  } else if (choice == 8 && shape->type == &gjk_class_hull) {
    change_count(family, pair, body);
  } else if (choice == 9 && random_below(&random, 8) == 0) {
    flatten(body);
  } else if (shape->type == &gjk_class_hull || shape->type == &gjk_class_triangle) {
    nudge(component(&body->vertices[random_below(&random, shape->count)]), -GJK_RADIUS_MAX);
  } else {
    nudge(component(&shape->size), 0);
  }
}

// Climbs from *pair until CLIMB changes in a row have not made it more expensive. Returns the measure reached.
static uint32_t climb(const worst_family *family, worst_measure *measure, worst_pair *pair, uint32_t *left) {
  static worst_pair changed;
  uint32_t best = measure(family, pair);
  for (unsigned failures = 0; failures<CLIMB && * left> 0; (*left)--) {
    changed = *pair;
    for (uint32_t n = random_below(&random, 3) + 1; n > 0; n--) {
      change_once(family, &changed);
    }
    const uint32_t cost = measure(family, &changed);
    failures = cost > best ? 0 : failures + 1;
    if (cost >= best && cost > 0) {
      best = cost;
      *pair = changed;
    }
  }
  return best;
}

// Starts from the most expensive known case with the family's shapes, or if there is none, from a random pair.
static uint32_t start_known(const worst_family *family, worst_measure *measure, worst_pair *out) {
  random_pair(family, out);
  uint32_t best = measure(family, out);
  for (unsigned i = 0; i < worst_case_count; i++) {
    const worst_case *known = &worst_cases[i];
    const worst_family *of = worst_family_of(known->id);
    if (of != NULL && of->kind == family->kind && of->vertices == family->vertices) {
      const uint32_t cost = measure(family, &known->pair);
      if (cost > best) {
        best = cost;
        *out = known->pair;
      }
    }
  }
  return best;
}

// Starts from the best pair so far, or from the best of a few random pairs.
static void start_pair(const worst_family *family, worst_measure *measure, const worst_pair *most, worst_pair *out) {
  static worst_pair other;
  if (random_below(&random, 3) == 0) {
    *out = *most;
    return;
  }
  random_pair(family, out);
  uint32_t best = measure(family, out);
  for (int i = 0; i < 30; i++) {
    random_pair(family, &other);
    const uint32_t cost = measure(family, &other);
    if (cost > best) {
      best = cost;
      *out = other;
    }
  }
}

uint32_t worst_search(const worst_family *family, worst_measure *measure, uint64_t seed, uint32_t measurements,
                      worst_pair *most) {
  static worst_pair pair;
  random = random_seed(seed);
  uint32_t best = start_known(family, measure, most);
  while (measurements > 0) {
    start_pair(family, measure, most, &pair);
    const uint32_t reached = climb(family, measure, &pair, &measurements);
    if (reached > best) {
      best = reached;
      *most = pair;
    }
  }
  return best;
}

// Printing.

static void put_number(print_function *print, int32_t value) {
  print(value < 0 ? " -" : " ");
  print_decimal(print, value < 0 ? 0u - (uint32_t)value : (uint32_t)value);
}

static void put_vector(print_function *print, const gjk_vec3 *v) {
  put_number(print, v->x);
  put_number(print, v->y);
  put_number(print, v->z);
}

static void put_kind(print_function *print, const worst_body *body) {
  const gjk_shape *s = &body->shape;
  if (s->type == &gjk_class_box || s->type == &gjk_class_ellipsoid) {
    print(s->type == &gjk_class_box ? "box" : "ellipsoid");
    put_vector(print, &s->size);
  } else if (s->type == &gjk_class_segment) {
    print("segment");
    put_number(print, s->size.z);
  } else if (s->type == &gjk_class_cylinder || s->type == &gjk_class_cone) {
    print(s->type == &gjk_class_cone ? "cone" : "cylinder");
    put_number(print, s->size.x);
    put_number(print, s->size.z);
  } else {
    print(s->type == &gjk_class_triangle ? "triangle" : "hull");
    if (s->type == &gjk_class_hull) {
      put_number(print, s->count);
    }
    for (unsigned i = 0; i < s->count; i++) {
      print("\n ");
      put_vector(print, &body->vertices[i]);
    }
  }
}

static void put_body(print_function *print, const char *name, const worst_body *body) {
  const gjk_quat *q = &body->pose.rotation;
  print(name);
  put_kind(print, body);
  print("\n");
  if (body->shape.convex_radius != 0) {
    print(name);
    print("round");
    put_number(print, body->shape.convex_radius);
    print("\n");
  }
  print(name);
  print("at");
  put_vector(print, &body->pose.position);
  print("\n");
  print(name);
  print("turn");
  put_number(print, q->x);
  put_number(print, q->y);
  put_number(print, q->z);
  put_number(print, q->w);
  print("\n");
}

void worst_print(print_function *print, const worst_family *family, const char *measure, const worst_pair *pair) {
  print("case ");
  print(family->name);
  print("-");
  print(measure);
  print("\n");
  put_body(print, "A ", &pair->body[0]);
  put_body(print, "B ", &pair->body[1]);
}
