// What the sets of levels.h in space and in the plane have in common: levels.c includes this, and plane_levels.c under the
// plane's names. Each has of its own a shape of every kind, in the order of the levels, sizes, and turns.
#ifndef LEVELS_COMMON_H
#define LEVELS_COMMON_H

#define VERTICES 8
#define KINDS (sizeof kinds / sizeof kinds[0])
#define CORNERS ((uint16_t)(sizeof corners / sizeof corners[0]))

typedef struct body {
  gjk_vec3 vertices[VERTICES];
  gjk_shape shape;
  gjk_collider collider;
  gjk_pose pose;
} body;

static body bodies[2];
static uint64_t *hashes;
static const uint8_t known[] = {0, 1, 2, 3, 5, KINDS - 1};  // by levels

static void mix(levels_query of, uint32_t value) {
  hashes[of] = fnv_word(hashes[of], value);
}

static void mix_three(levels_query of, int32_t x, int32_t y, int32_t z) {
  mix(of, (uint32_t)x);
  mix(of, (uint32_t)y);
  mix(of, (uint32_t)z);
}

static void mix_vector(levels_query of, gjk_vec3 v) {
  for (unsigned axis = 0; axis < AXES; axis++) {
    mix(of, (uint32_t)*component(&v, axis));
  }
}

static void mix_points(levels_query of, const gjk_distance_result *out) {
  mix(of, (uint32_t)out->saturated);
  mix_vector(of, out->point_a);
  mix_vector(of, out->point_b);
  mix_vector(of, vector_of(&out->normal));
}

// Results are static: what a query does not set is the same in every build.
static void query_touch(gjk_q16 distance, gjk_cache *cache) {
  const gjk_collider *a = &bodies[0].collider, *b = &bodies[1].collider;
  static gjk_decision out;
  mix(LEVELS_TOUCH, (uint32_t)gjk_within(a, b, distance, cache, &out));
  mix(LEVELS_TOUCH, (uint32_t)out.yes);
  mix(LEVELS_PROOFS, (uint32_t)gjk_check_decision(a, b, distance, &out));
}

static void query_gap(gjk_cache *cache, gjk_distance_result *out) {
  const gjk_collider *a = &bodies[0].collider, *b = &bodies[1].collider;
  mix(LEVELS_GAP, (uint32_t)gjk_distance(a, b, cache, out));
  mix(LEVELS_GAP, (uint32_t)out->intersecting);
  mix_three(LEVELS_GAP, out->distance, out->lower, out->upper);
  if (!out->intersecting) {
    mix_points(LEVELS_GAP, out);
  }
  mix(LEVELS_PROOFS, (uint32_t)gjk_check_distance(a, b, out));
}

static void query_until(gjk_q16 distance, uint8_t iterations) {
  const gjk_collider *a = &bodies[0].collider, *b = &bodies[1].collider;
  const gjk_effort effort = {iterations, distance};
  static gjk_within_result decision;
  static gjk_distance_result out;
  mix(LEVELS_UNTIL, (uint32_t)gjk_within_until(a, b, distance, iterations, NULL, &decision));
  mix(LEVELS_UNTIL, (uint32_t)decision.answer);
  mix(LEVELS_UNTIL, (uint32_t)gjk_distance_until(a, b, &effort, NULL, &out));
  mix(LEVELS_UNTIL, (uint32_t)out.intersecting);
  mix_three(LEVELS_UNTIL, out.distance, out.lower, out.upper);
  if (!out.intersecting) {
    mix_points(LEVELS_UNTIL, &out);
  }
}

static bool query_depth(gjk_cache *cache) {
  const gjk_collider *a = &bodies[0].collider, *b = &bodies[1].collider;
  static gjk_penetration_result out;
  static gjk_distance_result gap;
  mix(LEVELS_DEPTH, (uint32_t)ask_depth(a, b, cache, &out));
  mix(LEVELS_DEPTH, (uint32_t)out.intersecting);
  if (out.intersecting) {
    mix_three(LEVELS_DEPTH, out.depth, out.lower, out.upper);
    mix_vector(LEVELS_DEPTH, out.point_a);
    mix_vector(LEVELS_DEPTH, out.point_b);
    mix_vector(LEVELS_DEPTH, vector_of(&out.normal));
  }
  mix(LEVELS_PROOFS, (uint32_t)gjk_check_penetration(a, b, &out));
  mix(LEVELS_DEPTH, (uint32_t)ask_signed_distance(a, b, cache, &gap));
  mix_three(LEVELS_DEPTH, gap.distance, gap.lower, gap.upper);
  mix_points(LEVELS_DEPTH, &gap);
  return out.intersecting;
}

static void query_contacts(gjk_q16 margin, unsigned most) {
  static gjk_manifold out;
  mix(LEVELS_CONTACTS, (uint32_t)ask_contacts(&bodies[0].collider, &bodies[1].collider, margin, most, &out));
  mix_vector(LEVELS_CONTACTS, vector_of(&out.normal));
  mix_three(LEVELS_CONTACTS, out.count, out.feature_a, out.feature_b);
  for (unsigned i = 0; i < out.count; i++) {
    mix_vector(LEVELS_CONTACTS, out.contact[i].point_a);
    mix_vector(LEVELS_CONTACTS, out.contact[i].point_b);
    mix_three(LEVELS_CONTACTS, out.contact[i].distance, out.contact[i].id, 0);
  }
}

static void query_cast(gjk_q16 margin) {
  const gjk_collider *a = &bodies[0].collider, *b = &bodies[1].collider;
  const gjk_cast_path path = {NULL, &bodies[0].pose.position, margin};
  static gjk_cast_result cast;
  mix(LEVELS_MOTION, (uint32_t)gjk_cast(a, b, &path, &cast));
  mix_three(LEVELS_MOTION, cast.hit, cast.hit && cast.inside, cast.hit ? cast.fraction : 0);
  if (cast.hit) {
    mix_vector(LEVELS_MOTION, vector_of(&cast.normal));
    mix_vector(LEVELS_MOTION, cast.rest_b);
  }
  mix(LEVELS_PROOFS, (uint32_t)gjk_check_cast(a, b, &path, &cast));
}

static void query_impact(random_state *random, gjk_q16 margin) {
  const gjk_collider *a = &bodies[0].collider, *b = &bodies[1].collider;
  if (random_below(random, 8) == 0) {
    const gjk_motion still = {.from = bodies[0].pose, .to = bodies[0].pose};
    const gjk_motion moving = {
        .from = bodies[1].pose, .to = bodies[0].pose, .spin = SPIN(random_range(random, -90000, 90000))};
    const gjk_impact_setup setup = {margin, GJK_IMPACT_TOLERANCE_MIN, 40};
    gjk_impact_result out;
    const gjk_status status = gjk_time_of_impact(a, &still, b, &moving, &setup, &out);
    mix(LEVELS_MOTION, (uint32_t)status);
    if (status == GJK_OK) {
      mix_three(LEVELS_MOTION, out.hit, out.lower, out.upper);
    }
  }
}

static void query_motion(random_state *random, unsigned level, gjk_q16 margin) {
  if (level >= CASTS_FROM) {
    query_cast(margin);
  }
  query_impact(random, margin);
}

static gjk_vec3 random_vector(random_state *random, int32_t size) {
  gjk_vec3 v;
  for (unsigned axis = 0; axis < AXES; axis++) {
    *component(&v, axis) = random_range(random, -size, size);
  }
  return v;
}

static gjk_vec3 on_grid(gjk_vec3 v, int32_t grid) {
  for (unsigned axis = 0; axis < AXES; axis++) {
    *component(&v, axis) = *component(&v, axis) / grid * grid;
  }
  return v;
}

// A shape of a kind of the level, of about that size; every other has a convex radius. Every third has sizes of 0 or equal ones.
static void make_shape(random_state *random, body *b, unsigned level, int32_t size) {
  b->shape = kinds[random_below(random, known[level])];
  const int32_t grid = random_below(random, 3) == 0 ? size / 2 + 1 : 1;
  const gjk_vec3 v = random_vector(random, size);
  set_size(&b->shape, on_grid(v, grid));
  b->shape.vertices = b->vertices;
  b->shape.count = (uint16_t)(b->shape.type == TRIANGLE ? 3 : CORNERS + random_below(random, VERTICES - CORNERS + 1));
  for (unsigned i = 0; i < b->shape.count; i++) {
    b->vertices[i] = on_grid(random_vector(random, size), grid);
  }
  b->shape.convex_radius = random_below(random, 2) == 0 ? random_range(random, 0, size) : 0;
}

// Moves B along the normal until the gap is near 0.
static void approach(random_state *random, const gjk_distance_result *result) {
  body *b = &bodies[1];
  gjk_vec3 normal = vector_of(&result->normal);
  const int32_t by = result->distance + random_range(random, -2, 2);
  for (unsigned axis = 0; axis < AXES; axis++) {
    *component(&b->pose.position, axis) -= (int32_t)((int64_t)*component(&normal, axis) * by / GJK_Q30_ONE);
  }
  mix(LEVELS_GAP, (uint32_t)gjk_collider_move(&b->collider, &b->pose.position));
}

static bool query_pair(random_state *random, unsigned level) {
  static const gjk_cache cold;
  const int32_t size = INT32_C(1) << (1 + random_below(random, 25));
  const bool far = random_below(random, 8) == 0, near = random_below(random, 2) == 0;
  for (int i = 0; i < 2; i++) {
    make_shape(random, &bodies[i], level, size);
    make_pose(random, &bodies[i].pose, far ? INT32_MAX : near ? size / 4 + 1 : size);
    bodies[i].collider.state = 0;
    mix(LEVELS_GAP, (uint32_t)gjk_collider_init(&bodies[i].collider, &bodies[i].shape, NULL, 0));
    mix(LEVELS_GAP, (uint32_t)gjk_collider_pose(&bodies[i].collider, &bodies[i].pose));
  }
  gjk_cache cache = cold;
  static gjk_distance_result gap;
  query_gap(NULL, &gap);
  query_touch(0, NULL);
  query_touch(gap.distance, NULL);
  query_until(size / 16, 1);
  query_until(0, 2);
  query_until(gap.distance, 1);
  query_gap(&cache, &gap);
  const bool overlap = query_depth(&cache);
  query_contacts(size / 16, CONTACTS_MOST);
  query_motion(random, level, size / 16);
  if (!gap.intersecting && !far) {
    approach(random, &gap);
    query_gap(&cache, &gap);
    query_touch(0, &cache);
    query_touch(1, NULL);
    query_depth(NULL);
    query_contacts(size / 8, 1);
    query_contacts(size / 8, 2);
    query_motion(random, level, 0);
  }
  return overlap;
}

uint32_t levels_refused(void) {
  uint32_t refused = 0;
  for (unsigned i = 0; i < KINDS; i++) {
    bodies[0].shape = kinds[i];
    bodies[0].shape.vertices = corners;
    bodies[0].shape.count = bodies[0].shape.type == TRIANGLE ? 3 : CORNERS;
    const gjk_status status = gjk_collider_init(&bodies[0].collider, &bodies[0].shape, NULL, 0);
    refused |= status == GJK_ERROR_UNSUPPORTED ? UINT32_C(1) << i : status != GJK_OK ? UINT32_C(1) << 31 : 0;
  }
  return refused;
}

uint32_t levels_beyond(unsigned level) {
  return (UINT32_C(1) << KINDS) - (UINT32_C(1) << (level == 5 ? KINDS : known[level]));
}

uint32_t levels_hash(unsigned level, uint32_t pairs, uint64_t hash[LEVELS_QUERIES]) {
  random_state random = random_seed(2029 + level);
  uint32_t overlaps = 0;
  hashes = hash;
  for (unsigned i = 0; i < LEVELS_QUERIES; i++) {
    hash[i] = FNV_START;
  }
  for (uint32_t i = 0; i < pairs; i++) {
    overlaps += query_pair(&random, level) ? 1 : 0;
  }
  return overlaps;
}

#endif
