// What the fixed sets of casts, rays and times of impact in space and in the plane have in common: motion_golden.c includes
// this, and plane_motion_golden.c under the plane's names.
#ifndef MOTION_GOLDEN_COMMON_H
#define MOTION_GOLDEN_COMMON_H

static body bodies[2];

static void mix_pose(const gjk_pose *pose) {
  mix_vector(&pose->position);
  mix_rotation(&pose->rotation);
}

static void mix_cast(gjk_status status, const gjk_cast_result *out) {
  mix((uint32_t)status);
  if (status != GJK_OK) {
    return;
  }
  mix((uint32_t)out->hit);
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

// From one place to another, towards the other body or past it; the body turns by some way.
static void make_motion(random_state *random, body *b, int32_t reach, bool far) {
  static const gjk_motion rest = {.from = GJK_POSE_IDENTITY, .to = GJK_POSE_IDENTITY};
  b->motion = rest;
  turn(random, &b->motion.from.rotation);
  turn(random, &b->motion.to.rotation);
  b->motion.from.position = random_in_cube(random, far ? INT32_MAX : reach);
  b->motion.to.position = random_in_cube(random, reach);
  if (random_below(random, 4) == 0) {
    b->motion.spin = random_spin(random, INT32_C(1) << (14 + random_below(random, 6)));
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

// The hash over the first pairs of the set of a seed.
static uint64_t hash_of_pairs(uint64_t seed, uint32_t pairs) {
  random_state random = random_seed(seed);
  hash = FNV_START;
  for (uint32_t i = 0; i < pairs; i++) {
    query_pair(&random);
  }
  return hash;
}

#endif
