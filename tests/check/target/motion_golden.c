// The fixed set of casts, rays and times of impact in space and its hash, without libc and with little RAM.
#include "motion_golden.h"

#include "gjk/cast.h"
#include "gjk/gjk.h"
#include "gjk/impact.h"
#include "random.h"

#define VERTICES 10

typedef struct body {
  gjk_vec3 vertices[VERTICES], buffer[VERTICES];
  gjk_shape shape;
  gjk_collider collider;
  gjk_motion motion;
} body;

static body bodies[2];
static uint64_t hash;

// FNV-1a over the bytes of a value, lowest first.
static void mix(uint32_t value) {
  for (int i = 0; i < 4; i++) {
    hash = (hash ^ (value & 0xFFu)) * UINT64_C(0x100000001B3);
    value >>= 8;
  }
}

static void mix_vector(const gjk_vec3 *v) {
  mix((uint32_t)v->x);
  mix((uint32_t)v->y);
  mix((uint32_t)v->z);
}

static void mix_unit(const gjk_unit3 *n) {
  mix((uint32_t)n->x);
  mix((uint32_t)n->y);
  mix((uint32_t)n->z);
}

static void mix_pose(const gjk_pose *pose) {
  mix_vector(&pose->position);
  mix((uint32_t)pose->rotation.x);
  mix((uint32_t)pose->rotation.y);
  mix((uint32_t)pose->rotation.z);
  mix((uint32_t)pose->rotation.w);
}

static void mix_cast(gjk_status status, const gjk_cast_result *out) {
  mix((uint32_t)status);
  if (status != GJK_OK) {
    return;
  }
  mix((uint32_t)out->hit);
  mix(out->iterations);
  mix(out->certificate.proof);
  mix(out->certificate.count);
  for (int i = 0; i < out->certificate.count; i++) {
    mix((uint32_t)out->certificate.a[i] << 16 | out->certificate.b[i]);
  }
  if (out->hit) {
    mix((uint32_t)out->inside);
    mix((uint32_t)out->saturated);
    mix((uint32_t)out->fraction);
    mix_unit(&out->normal);
    mix_vector(&out->rest_a);
    mix_vector(&out->rest_b);
    if (!out->inside) {
      mix_vector(&out->point_a);
      mix_vector(&out->point_b);
    }
  }
}

// margin: with 0 the certificate is checked as well.
static void query_cast(gjk_q16 margin, bool both) {
  const gjk_cast_path path = {both ? &bodies[0].motion.to.position : NULL, &bodies[1].motion.to.position, margin};
  gjk_cast_result out;
  const gjk_status status = gjk_cast(&bodies[0].collider, &bodies[1].collider, &path, &out);
  mix_cast(status, &out);
  if (status == GJK_OK) {
    mix((uint32_t)gjk_check_cast(&bodies[0].collider, &bodies[1].collider, &path, &out));
  }
}

static void query_ray(void) {
  gjk_cast_result out;
  const gjk_status status =
      gjk_cast_ray(&bodies[0].collider, &bodies[1].motion.from.position, &bodies[1].motion.to.position, &out);
  mix_cast(status, &out);
}

static void query_impact(gjk_q16 margin, uint8_t iterations) {
  const gjk_impact_setup setup = {margin, GJK_IMPACT_TOLERANCE_MIN, iterations};
  gjk_impact_result out;
  const gjk_status status =
      gjk_time_of_impact(&bodies[0].collider, &bodies[0].motion, &bodies[1].collider, &bodies[1].motion, &setup, &out);
  mix((uint32_t)status);
  if (status != GJK_OK && status != GJK_ERROR_ITERATION_LIMIT) {
    return;
  }
  mix((uint32_t)out.hit);
  mix((uint32_t)out.overlap);
  mix((uint32_t)out.lower);
  mix((uint32_t)out.upper);
  mix(out.iterations);
  mix_pose(&out.pose_a);
  mix_pose(&out.pose_b);
  if (out.hit && !out.overlap && out.distance > 0) {
    mix((uint32_t)out.distance);
    mix_vector(&out.point_a);
    mix_vector(&out.point_b);
    mix_unit(&out.normal);
  }
}

static void query_pose(random_state *random) {
  gjk_pose out;
  const gjk_q30 fraction = random_range(random, 0, GJK_Q30_ONE);
  if (gjk_motion_pose(&bodies[1].motion, fraction, &out) == GJK_OK) {
    mix_pose(&out);
  }
}

static gjk_vec3 random_vector(random_state *random, int32_t size) {
  gjk_vec3 v;
  v.x = random_range(random, -size, size);
  v.y = random_range(random, -size, size);
  v.z = random_range(random, -size, size);
  return v;
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
  b->shape.size.z = random_range(random, 1, size);
  b->shape.vertices = b->vertices;
  b->shape.count = (uint16_t)(b->shape.type == &gjk_class_triangle ? 3 : 1 + random_below(random, VERTICES));
  const int32_t grid = random_below(random, 4) == 0 ? size / 2 + 1 : 1;  // coarse: ties, and parallel faces
  for (unsigned i = 0; i < b->shape.count; i++) {
    const gjk_vec3 v = random_vector(random, size);
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

// From one place to another, towards the other body or past it; the body turns by some way.
static void make_motion(random_state *random, body *b, int32_t reach, bool far) {
  static const gjk_motion rest = {.from = GJK_POSE_IDENTITY, .to = GJK_POSE_IDENTITY};
  b->motion = rest;
  turn(random, &b->motion.from.rotation);
  turn(random, &b->motion.to.rotation);
  b->motion.from.position = random_vector(random, far ? INT32_MAX : reach);
  b->motion.to.position = random_vector(random, reach);
  if (random_below(random, 4) == 0) {
    b->motion.spin = random_vector(random, INT32_C(1) << (14 + random_below(random, 6)));
  }
}

static void place(random_state *random, body *b) {
  const bool baked = random_below(random, 2) == 0;
  b->collider.state = 0;
  mix((uint32_t)gjk_collider_init(&b->collider, &b->shape, baked ? b->buffer : NULL, VERTICES));
  mix((uint32_t)gjk_collider_pose(&b->collider, &b->motion.from));
}

static void query_pair(random_state *random) {
  const int32_t size = INT32_C(1) << (3 + random_below(random, 23));
  const bool far = random_below(random, 8) == 0;
  for (int i = 0; i < 2; i++) {
    make_shape(random, &bodies[i], size);
    make_motion(random, &bodies[i], 2 * size, far && i == 1);
    place(random, &bodies[i]);
  }
  query_cast(0, false);
  query_cast(0, true);
  query_cast(size / 16, false);
  query_ray();
  query_pose(random);
  if (random_below(random, 8) == 0) {
    query_impact(0, 40);
    query_impact(size / 16, (uint8_t)(1 + random_below(random, 6)));
  }
}

uint64_t motion_golden_hash(uint32_t pairs) {
  random_state random = random_seed(2028);
  hash = UINT64_C(0xCBF29CE484222325);
  for (uint32_t i = 0; i < pairs; i++) {
    query_pair(&random);
  }
  return hash;
}
