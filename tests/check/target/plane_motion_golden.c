// The fixed set of casts, rays and times of impact in the plane and its hash, without libc and with little RAM.
#include "fnv.h"
#include "gjk2/cast.h"
#include "gjk2/gjk2.h"
#include "gjk2/impact.h"
#include "motion_golden.h"
#include "random.h"

#define VERTICES 10

typedef struct body {
  gjk2_vec vertices[VERTICES], buffer[VERTICES];
  gjk2_shape shape;
  gjk2_collider collider;
  gjk2_motion motion;
} body;

static uint64_t hash;

static void mix(uint32_t value) {
  hash = fnv_word(hash, value);
}

static void mix_vector(const gjk2_vec *v) {
  mix((uint32_t)v->x);
  mix((uint32_t)v->y);
}

static void mix_unit(const gjk2_unit *n) {
  mix((uint32_t)n->x);
  mix((uint32_t)n->y);
}

static void mix_rotation(const gjk2_rotation *r) {
  mix((uint32_t)r->c);
  mix((uint32_t)r->s);
}

static gjk2_vec random_vector(random_state *random, int32_t size) {
  gjk2_vec v;
  v.x = random_range(random, -size, size);
  v.y = random_range(random, -size, size);
  return v;
}

static int32_t random_spin(random_state *random, int32_t most) {
  return random_range(random, -most, most);
}

// A shape of one of six kinds, of about that size; every fourth has a convex radius.
static void make_shape(random_state *random, body *b, int32_t size) {
  static const gjk2_shape kinds[] = {GJK2_POINT,     GJK2_SEGMENT(0),    GJK2_TRIANGLE(0),
                                     GJK2_BOX(0, 0), GJK2_POLYGON(0, 0), GJK2_ELLIPSE(0, 0)};
  // Segments, boxes and polygons are chosen more often.
  static const uint8_t choices[] = {0, 1, 1, 2, 3, 3, 3, 4, 4, 4, 4, 5};
  b->shape = kinds[choices[random_below(random, sizeof choices)]];
  const bool has_length = b->shape.type != &gjk2_class_point;
  const bool has_width = has_length && b->shape.type != &gjk2_class_segment;
  const bool flat =
      has_length && b->shape.type != &gjk2_class_ellipse && random_below(random, 4) == 0;  // corners at one place
  b->shape.size.x = has_length && !flat ? random_range(random, 1, size) : 0;
  b->shape.size.y = has_width ? random_range(random, 1, size) : 0;
  b->shape.vertices = b->vertices;
  b->shape.count = (uint16_t)(b->shape.type == &gjk2_class_triangle ? 3 : 1 + random_below(random, VERTICES));
  const int32_t grid = random_below(random, 4) == 0 ? size / 2 + 1 : 1;  // coarse: ties, and parallel faces
  for (unsigned i = 0; i < b->shape.count; i++) {
    const gjk2_vec v = random_vector(random, size);
    b->vertices[i].x = v.x / grid * grid;
    b->vertices[i].y = v.y / grid * grid;
  }
  b->shape.convex_radius = random_below(random, 4) == 0 ? random_range(random, 0, size / 2) : 0;
}

static void turn(random_state *random, gjk2_rotation *out) {
  const gjk2_rotation r = {random_range(random, -1000, 1000), random_range(random, -1000, 1001)};
  if (random_below(random, 3) != 0) {
    mix((uint32_t)gjk2_rotation_normalize(&r, out));
  }
}

// The names of the common part in the plane.
#undef GJK_POSE_IDENTITY
#define GJK_POSE_IDENTITY GJK2_POSE_IDENTITY
#define gjk_cast gjk2_cast
#define gjk_cast_path gjk2_cast_path
#define gjk_cast_ray gjk2_cast_ray
#define gjk_cast_result gjk2_cast_result
#define gjk_check_cast gjk2_check_cast
#define gjk_collider_init gjk2_collider_init
#define gjk_collider_pose gjk2_collider_pose
#define gjk_impact_result gjk2_impact_result
#define gjk_impact_setup gjk2_impact_setup
#define gjk_motion gjk2_motion
#define gjk_motion_pose gjk2_motion_pose
#define gjk_pose gjk2_pose
#define gjk_time_of_impact gjk2_time_of_impact
#define random_in_cube random_vector
#define GJK_IMPACT_TOLERANCE_MIN GJK2_IMPACT_TOLERANCE_MIN
#include "motion_golden_common.h"

uint64_t plane_motion_golden_hash(uint32_t pairs) {
  return hash_of_pairs(2029, pairs);
}
