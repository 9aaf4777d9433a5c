// Every query on any two colliders: shapes of a model class whose supports are any offsets that a class may give
// (tests/prove/shape.c shows that each class of the library gives no others), with vertices or without.
#include "shape_class.h"
#include "simplex_any.h"

// Values of CASE.
#define INTERSECT 1
#define WITHIN 2
#define DISTANCE 3
#define CHECK_DECISION 4
#define CHECK_DISTANCE 5
#define UNTIL 6
#define PENETRATION 7
#define AXES 8
#define SIGNED 9
#define CHECK_PENETRATION 10
#define CONTACTS 11

static bool any_offset(gjk_vec3 *offset) {
  if (any_bool()) {
    return false;
  }
  *offset = any_vec3(ANY_OFFSET);
  return true;
}

static void support(const gjk_collider *c, const gjk_vec3 *d, bool exact, gjk_support *out) {
  check_vec3(d, ANY_W);
  out->offset = any_vec3(ANY_OFFSET);
  out->vertex = any_uint16();
  out->tie = exact ? false : any_bool();
}

static void curved_support(const gjk_collider *c, const gjk_vec3 *d, bool exact, gjk_support *out) {
  check_vec3(d, ANY_W);
  out->offset = any_vec3(ANY_OFFSET);
  out->vertex = 0;
  out->tie = false;
}

static bool refine(const gjk_collider *c, const gjk_vec3 *d, const gjk_direction *direction, bool negated,
                   gjk_support *at) {
  check_vec3(d, ANY_W);
  at->vertex = any_uint16();
  return any_offset(&at->offset);
}

static bool vertex(const gjk_collider *c, uint16_t number, gjk_vec3 *offset) {
  return any_offset(offset);
}

static void pose(gjk_collider *c, const gjk_vec3 rows[3]) {
}

static gjk_status measure(const gjk_shape *shape, gjk_extent *out) {
  return GJK_ERROR_NULL;
}

static const gjk_shape_class polytope = {measure, pose, support, refine, vertex, false, 0};
static const gjk_shape_class axes = {measure, pose, support, refine, vertex, false, 0, GJK_KIND_AXES};
static const gjk_shape_class curved = {measure, pose, curved_support, NULL, NULL, false, 0};

static void any_collider(gjk_collider *c, gjk_shape *shape, bool has_vertices) {
  shape->type = has_vertices ? (CASE == AXES ? &axes : &polytope) : &curved;
  for (int i = 0; i < 3; i++) {
    c->frame[i] = any_vec3(ANY_OFFSET);
  }
  shape->round = any_between(0, GJK_RADIUS_MAX);
  c->shape = shape;
  c->centre = any_position();
  c->core_radius = any_between(4, ANY_OFFSET);
  c->radius = c->core_radius;
  c->state = any_bool() ? GJK_STATE_POSED : (uint32_t)any_int32();
}

static void any_certificate(gjk_certificate *certificate) {
  certificate->direction = any_position();
  for (int i = 0; i < 4; i++) {
    certificate->a[i] = any_uint16();
    certificate->b[i] = any_uint16();
  }
  const int32_t count = any_between(0, 5);
  //@ split count;
  certificate->count = (uint8_t)(count < 5 ? count : any_between(5, UINT8_MAX));
  certificate->proof = (uint8_t)any_between(0, UINT8_MAX);
}

static void any_cache(gjk_cache *cache) {
  for (int i = 0; i < 3; i++) {
    cache->direction[i] = (int16_t)any_between(INT16_MIN, INT16_MAX);
  }
  cache->count = any_uint16();
  for (int i = 0; i < 4; i++) {
    cache->a[i] = any_uint16();
    cache->b[i] = any_uint16();
  }
}

static void any_axes(gjk_collider *c) {
  const int32_t count = any_between(0, 2);
  //@ split count;
  c->count = (uint16_t)(count < 2 ? count : 3);
}

static void any_workspace(gjk_workspace *workspace) {
  static gjk_cell cells[1];
  workspace->cells = any_bool() ? cells : NULL;
  workspace->count = (uint32_t)any_int32();
}

static void ask(const gjk_collider *a, const gjk_collider *b, gjk_cache *cache) {
  gjk_decision decision;
  gjk_distance_result distance;
  gjk_penetration_result penetration;
  gjk_manifold manifold;
  gjk_workspace workspace;
  any_workspace(&workspace);
#if CASE == INTERSECT
  (void)gjk_intersect(a, b, cache, &decision);
#elif CASE == WITHIN
  (void)gjk_within(a, b, any_int32(), cache, &decision);
#elif CASE == DISTANCE
  (void)gjk_distance(a, b, cache, &distance);
#elif CASE == UNTIL
  const gjk_effort effort = {(uint8_t)any_between(0, UINT8_MAX), any_int32()};
  (void)gjk_distance_until(a, b, &effort, cache, &distance);
#elif CASE == PENETRATION || CASE == AXES
  (void)gjk_penetration(a, b, cache, &workspace, &penetration);
#elif CASE == SIGNED
  (void)gjk_signed_distance(a, b, cache, &workspace, &distance);
#elif CASE == CONTACTS
  (void)gjk_contacts(a, b, any_int32(), (unsigned)any_int32(), cache, &workspace, &manifold);
#elif CASE == CHECK_DECISION
  any_certificate(&decision.certificate);
  decision.yes = any_bool();
  (void)gjk_check_decision(a, b, any_int32(), &decision);
#elif CASE == CHECK_DISTANCE
  any_certificate(&distance.certificate);
  distance.intersecting = any_bool();
  distance.distance = any_int32();
  (void)gjk_check_distance(a, b, &distance);
#else
  any_certificate(&penetration.certificate);
  penetration.intersecting = any_bool();
  penetration.depth = any_int32();
  (void)gjk_check_penetration(a, b, &penetration);
#endif
}

int main(void) {
  gjk_shape shapes[2] = {0};
  gjk_collider a = {0}, b = {0};
  gjk_cache cache;
  const unsigned kinds = (unsigned)any_between(CASE == AXES ? 3 : 0, 3), warm = (unsigned)any_between(0, 1);
  //@ split kinds;
  any_collider(&a, &shapes[0], (kinds & 1u) != 0);
  any_collider(&b, &shapes[1], (kinds & 2u) != 0);
#if CASE == AXES
  any_axes(&a);
  any_axes(&b);
#endif
  any_cache(&cache);
  //@ split warm;
  ask(&a, &b, warm != 0 ? &cache : NULL);
  return 0;
}
