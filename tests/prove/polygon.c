// src/contact/gjk_contact_polygon.h with any collider of a kind, CASE, from any direction. A polygon is all that this
// leaves behind.
#include "colliders.h"
#include "polygons.h"

enum { SMOOTH, POINT, SEGMENT, BOX, TRIANGLE, HULL, CYLINDER, CONE };

#define CORNERS (2 * GJK_FACE_CORNERS_MAX)

// As the classes of the library: any vertex that there is.
static bool any_existing(const gjk_collider *c, uint16_t number, gjk_vec3 *offset) {
  const unsigned vertices = c->shape->type->kind == GJK_KIND_AXES ? 1u << c->count : c->count;
  //@ assert number < vertices;
  *offset = any_vec3(ANY_OFFSET);
  return true;
}

static const gjk_shape_class axes = {.measure = any_measure,
                                     .pose = keep_pose,
                                     .support = any_support,
                                     .refine = any_refine,
                                     .vertex = any_existing,
                                     .kind = GJK_KIND_AXES};
static const gjk_shape_class triangle = {.measure = any_measure,
                                         .pose = keep_pose,
                                         .support = any_support,
                                         .refine = any_refine,
                                         .vertex = any_existing,
                                         .count = 3,
                                         .kind = GJK_KIND_VERTICES};
static const gjk_shape_class hull = {.measure = any_measure,
                                     .pose = keep_pose,
                                     .support = any_support,
                                     .refine = any_refine,
                                     .vertex = any_existing,
                                     .buffered = true,
                                     .kind = GJK_KIND_VERTICES};
static const gjk_shape_class cylinder = {.measure = any_measure,
                                         .pose = keep_pose,
                                         .support = any_curved_support,
                                         .stalls = any_stalls,
                                         .kind = GJK_KIND_CYLINDER};
static const gjk_shape_class cone = {.measure = any_measure,
                                     .pose = keep_pose,
                                     .support = any_curved_support,
                                     .stalls = any_stalls,
                                     .kind = GJK_KIND_CONE};

static void ask(const gjk_collider *c) {
  const gjk_vec3 position = any_vec3(INT32_C(1) << 29), direction = any_vec3(ANY_UNIT);
  gjk_polygon p;
  gjk_contact_polygon(c, &position, &direction, &p);
  //@ split p.count;
  check_polygon(&p);
}

// A hull of the most vertices, without faces, or with one of any number of corners and one of few or many.
static void ask_hull(gjk_collider *c, gjk_shape *shape) {
  uint16_t corner[CORNERS], end[2];
  gjk_hull_faces faces = {corner, end, 0};
  c->count = UINT16_MAX;
  for (int i = 0; i < CORNERS; i++) {
    corner[i] = (uint16_t)any_between(0, c->count - 1);
  }
  ask(c);
  shape->faces = &faces;
  ask(c);
  for (uint16_t i = 3; i <= GJK_FACE_CORNERS_MAX; i++) {
    end[0] = i;
    faces.count = 1;
    ask(c);
    faces.count = 2;
    end[1] = (uint16_t)(i + 3);
    ask(c);
    end[1] = (uint16_t)(i + GJK_FACE_CORNERS_MAX);
    ask(c);
  }
}

int main(void) {
  static const gjk_shape_class *const types[] = {&curved, &axes, &axes, &axes, &triangle, &hull, &cylinder, &cone};
  gjk_shape shape = {0};
  gjk_collider c = {0};
  any_collider(&c, &shape, types[CASE]);
  if (CASE == CYLINDER || CASE == CONE) {
    for (int i = 0; i < 3; i++) {
      c.frame[i] = any_vec3(GJK_Q30_ONE);
    }
    shape.size.x = any_between(0, GJK_RADIUS_MAX);
    shape.size.z = any_between(0, GJK_RADIUS_MAX);
  }
  if (CASE == HULL) {
    ask_hull(&c, &shape);
  } else {
    c.count = CASE == SEGMENT ? 1 : CASE == BOX || CASE == TRIANGLE ? 3 : 0;
    ask(&c);
  }
  return 0;
}
