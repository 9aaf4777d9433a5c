// One kind of shape, CASE, from any sizes, vertices and pose: what gjk/collider.h does with it, and what a query then
// asks of its class, in the ranges that tests/prove/query.c shows to be all it asks.
#include "any.h"
#include "src/shape/gjk_shape_class.h"

#define VERTICES 5
#define ENTRIES 8

enum { POINT, SEGMENT, TRIANGLE, BOX, BAKED, LAZY, TABLE, TABLE_LAZY, CYLINDER, CONE, ELLIPSOID, CUSTOM };

static gjk_vec3 vertices[VERTICES], buffer[VERTICES];
static uint16_t entries[ENTRIES], ends[GJK_TABLE_CELLS(GJK_TABLE_LEVEL_MAX)];
static gjk_hull_table table;

static void any_support(const void *user, const gjk_vec3 *direction, gjk_vec3 *out) {
  const gjk_q16 bound = *(const gjk_q16 *)user;
  (void)direction;
  *out = any_vec3(bound);
}

// Any table that gjk_table_measure may let pass for VERTICES vertices, its lists within entries.
static void any_table(void) {
  table.vertex = entries;
  table.end = ends;
  table.level = (uint8_t)any_between(0, GJK_TABLE_LEVEL_MAX);
  for (int i = 0; i < ENTRIES; i++) {
    entries[i] = (uint16_t)any_between(0, VERTICES - 1);
  }
  for (int i = 0; i < GJK_TABLE_CELLS(GJK_TABLE_LEVEL_MAX); i++) {
    ends[i] = (uint16_t)any_between(0, ENTRIES);
  }
}

static void any_shape(gjk_shape *shape, const gjk_q16 *bound) {
  const gjk_shape kinds[] = {[POINT] = GJK_POINT,
                             [SEGMENT] = GJK_SEGMENT(0),
                             [TRIANGLE] = GJK_TRIANGLE(vertices),
                             [BOX] = GJK_BOX(0, 0, 0),
                             [BAKED] = GJK_HULL(vertices, VERTICES),
                             [LAZY] = GJK_HULL(vertices, VERTICES),
                             [TABLE] = GJK_HULL_WITH_TABLE(vertices, VERTICES, &table),
                             [TABLE_LAZY] = GJK_HULL_WITH_TABLE(vertices, VERTICES, &table),
                             [CYLINDER] = GJK_CYLINDER(0, 0),
                             [CONE] = GJK_CONE(0, 0),
                             [ELLIPSOID] = GJK_ELLIPSOID(0, 0, 0),
                             [CUSTOM] = GJK_CUSTOM(any_support, bound, 0)};
  *shape = kinds[CASE];
  if (CASE == TABLE || CASE == TABLE_LAZY) {
    any_table();
  }
  shape->size = any_position();
  shape->convex_radius = any_int32();
  if (CASE == CUSTOM) {
    shape->size.x = *bound;
  }
  if (shape->count == VERTICES) {
    shape->count = (uint16_t)any_between(0, VERTICES);
  }
  for (int i = 0; i < VERTICES; i++) {
    vertices[i] = any_position();
  }
}

static void check_offset(const gjk_vec3 *offset) {
  //@ assert offset->x >= -ANY_OFFSET && offset->x <= ANY_OFFSET;
  //@ assert offset->y >= -ANY_OFFSET && offset->y <= ANY_OFFSET;
  //@ assert offset->z >= -ANY_OFFSET && offset->z <= ANY_OFFSET;
}

static int64_t any_long(int64_t most) {
  return Frama_C_long_long_interval(-most, most);
}

static void any_direction(gjk_direction *direction, const gjk_vec3 ends[2], gjk_long3 *n, uint16_t level[3]) {
  for (int i = 0; i < 3; i++) {
    level[i] = (uint16_t)any_between(0, 7);
  }
  direction->level = any_bool() ? level : NULL;
  direction->spanning = (uint8_t)any_between(1, 3);
  direction->a = &ends[0];
  direction->b = &ends[1];
  direction->n = n;
  direction->opposite = any_bool();
  direction->ta = Frama_C_long_long_interval(1, INT64_C(1) << 61);
  direction->tb = Frama_C_long_long_interval(1, INT64_C(1) << 61);
  n->x = any_long((INT64_C(1) << 62) - 1);
  n->y = any_long((INT64_C(1) << 62) - 1);
  n->z = any_long((INT64_C(1) << 62) - 1);
}

// The class's functions on the posed collider.
static void use(const gjk_collider *c) {
  const int32_t most = INT32_C(3) << 29;
  const gjk_vec3 d = any_vec3(INT32_MAX), ends[2] = {any_vec3(most), any_vec3(most)};
  gjk_long3 n;
  gjk_direction direction;
  gjk_support found;
  uint16_t level[3];
  any_direction(&direction, ends, &n, level);
  if (d.x != 0 || d.y != 0 || d.z != 0) {
    c->shape->type->support(c, &d, &found);
    check_offset(&found.offset);
    if (c->shape->type->refine != NULL && c->shape->type->refine(c, &d, &direction, &found)) {
      check_offset(&found.offset);
    }
  }
  if (c->shape->type->stalls != NULL) {
    (void)c->shape->type->stalls(&d, &ends[0], &ends[1], any_between(-3, 29), any_bool());
  }
  if (c->shape->type->vertex != NULL && c->shape->type->vertex(c, any_uint16(), &found.offset)) {
    check_offset(&found.offset);
  }
}

int main(void) {
  const gjk_q16 bound = any_between(0, GJK_RADIUS_MAX);
  const gjk_vec3 place = any_position();
  const gjk_pose pose = any_pose();
  gjk_shape shape;
  gjk_collider c = {0};
  gjk_aabb box;
  any_shape(&shape, &bound);
  if (gjk_collider_init(&c, &shape, CASE == BAKED || CASE == TABLE ? buffer : NULL, any_uint16()) == GJK_OK) {
    if (CASE != POINT && CASE != TRIANGLE && CASE != BAKED && CASE != LAZY && CASE != TABLE && CASE != TABLE_LAZY) {
      //@ assert shape.size.x <= GJK_RADIUS_MAX && shape.size.y <= GJK_RADIUS_MAX && shape.size.z <= GJK_RADIUS_MAX;
    }
    if (gjk_collider_pose(&c, &pose) == GJK_OK) {
      (void)gjk_collider_move(&c, &place);
      (void)gjk_collider_aabb(&c, &box);
      use(&c);
    }
  }
  return 0;
}
