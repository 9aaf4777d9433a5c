// The fixed set of casts, rays and times of impact in space and its hash, without libc and with little RAM.
#include "motion_golden.h"
#include "gjk/cast.h"
#include "gjk/gjk.h"
#include "gjk/impact.h"
#include "golden_mix.h"

#define VERTICES 10

typedef struct body {
  gjk_vec3 vertices[VERTICES], buffer[VERTICES];
  gjk_shape shape;
  gjk_collider collider;
  gjk_motion motion;
} body;

static void mix_rotation(const gjk_quat *q) {
  mix((uint32_t)q->x);
  mix((uint32_t)q->y);
  mix((uint32_t)q->z);
  mix((uint32_t)q->w);
}

// Turns about three axes.
static gjk_vec3 random_spin(random_state *random, int32_t most) {
  return random_in_cube(random, most);
}

// A shape of one of eight kinds, of about that size; every fourth has a convex radius.
static void make_shape(random_state *random, body *b, int32_t size) {
  static const gjk_shape kinds[] = {
      GJK_POINT,      GJK_SEGMENT(0),     GJK_TRIANGLE(0), GJK_BOX(0, 0, 0),
      GJK_HULL(0, 0), GJK_CYLINDER(0, 0), GJK_CONE(0, 0),  GJK_ELLIPSOID(0, 0, 0),
  };
  // Boxes and hulls are chosen more often.
  static const uint8_t choices[] = {0, 1, 2, 3, 3, 3, 4, 4, 4, 4, 5, 6, 7};
  b->shape = kinds[choices[random_below(random, sizeof choices)]];
  b->shape.size.x = random_range(random, 1, size);
  b->shape.size.y = random_range(random, 1, size);
  const bool may_be_flat = b->shape.type == &gjk_class_segment || b->shape.type == &gjk_class_box;
  b->shape.size.z =
      may_be_flat && random_below(random, 4) == 0 ? 0 : random_range(random, 1, size);  // corners at one place
  b->shape.vertices = b->vertices;
  b->shape.count = (uint16_t)(b->shape.type == &gjk_class_triangle ? 3 : 1 + random_below(random, VERTICES));
  const int32_t grid = random_below(random, 4) == 0 ? size / 2 + 1 : 1;  // coarse: ties, and parallel faces
  for (unsigned i = 0; i < b->shape.count; i++) {
    const gjk_vec3 v = random_in_cube(random, size);
    b->vertices[i].x = v.x / grid * grid;
    b->vertices[i].y = v.y / grid * grid;
    b->vertices[i].z = v.z / grid * grid;
  }
  b->shape.convex_radius = random_below(random, 4) == 0 ? random_range(random, 0, size / 2) : 0;
}

static void turn(random_state *random, gjk_quat *out) {
  const gjk_quat q = {random_range(random, -1000, 1000), random_range(random, -1000, 1000),
                      random_range(random, -1000, 1000), random_range(random, -1000, 1001)};
  if (random_below(random, 3) != 0) {
    mix((uint32_t)gjk_quat_normalize(&q, out));
  }
}

#include "motion_golden_common.h"

uint64_t motion_golden_hash(uint32_t pairs) {
  return hash_of_pairs(2028, pairs);
}
