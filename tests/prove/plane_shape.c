// One kind of shape of the plane, CASE, from any sizes, vertices and pose: what gjk2/collider.h does with it, and what a
// query then asks of its class and of src/plane/gjk2_hull.h, in the ranges that tests/prove/plane_query.c shows.
#include "plane_any.h"
#include "src/plane/gjk2_hull.h"

#define VERTICES 4

enum { POINT, SEGMENT, BOX, TRIANGLE, BAKED, LAZY, ELLIPSE, CUSTOM };

static gjk2_vec vertices[VERTICES], buffer[VERTICES];

static void any_support(const void *user, const gjk2_vec *direction, gjk2_vec *out) {
  (void)user;
  (void)direction;
  *out = any_position2();
}

static void any_shape(gjk2_shape *shape) {
  const gjk2_shape kinds[] = {[POINT] = GJK2_POINT,
                              [SEGMENT] = GJK2_SEGMENT(0),
                              [BOX] = GJK2_BOX(0, 0),
                              [TRIANGLE] = GJK2_TRIANGLE(vertices),
                              [BAKED] = GJK2_POLYGON(vertices, VERTICES),
                              [LAZY] = GJK2_POLYGON(vertices, VERTICES),
                              [ELLIPSE] = GJK2_ELLIPSE(0, 0),
                              [CUSTOM] = GJK2_CUSTOM(any_support, NULL, 0)};
  *shape = kinds[CASE];
  shape->size = any_position2();
  shape->convex_radius = any_int32();
  if (CASE == SEGMENT || CASE == CUSTOM) {
    shape->size.y = 0;
  }
  if (CASE == POINT) {
    shape->size.x = 0;
    shape->size.y = 0;
  }
  if (shape->count == VERTICES) {
    shape->count = (uint16_t)any_between(0, VERTICES);
  }
  for (int i = 0; i < VERTICES; i++) {
    vertices[i] = any_position2();
  }
}

static void check_support(const gjk2_support *found) {
  check_vec2(found->offset, ANY_OFFSET);
}

// The class's functions on the posed collider.
static void use(const gjk2_collider *c) {
  const gjk2_vec d = any_vec2(ANY_W);
  gjk2_support found, other;
  if (d.x == 0 && d.y == 0) {
    return;
  }
  c->shape->type->support(c, &d, &found);
  check_support(&found);
  if (c->shape->type->vertex == NULL) {
    return;
  }
  if (c->shape->type->vertex(c, any_uint16(), &found.offset)) {
    check_support(&found);
  }
  gjk2_hull_corner(c, d, &found);
  check_support(&found);
  if (gjk2_hull_neighbour(c, &found, any_bool(), &other)) {
    check_vec2(other.offset, 2 * ANY_OFFSET);
  }
}

int main(void) {
  const gjk2_vec place = any_position2();
  const gjk2_pose pose = any_pose2();
  gjk2_shape shape;
  gjk2_collider c = {0};
  gjk2_aabb box;
  any_shape(&shape);
  if (gjk2_collider_init(&c, &shape, CASE == BAKED ? buffer : NULL, any_uint16()) != GJK_OK) {
    return 0;
  }
  if (CASE == BOX || CASE == SEGMENT || CASE == ELLIPSE || CASE == CUSTOM) {
    //@ assert shape.size.x <= GJK2_RADIUS_MAX && shape.size.y <= GJK2_RADIUS_MAX;
  }
  if (gjk2_collider_pose(&c, &pose) == GJK_OK) {
    (void)gjk2_collider_move(&c, &place);
    (void)gjk2_collider_aabb(&c, &box);
    use(&c);
  }
  return 0;
}
