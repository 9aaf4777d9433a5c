// The sets of pairs and queries of levels.h in the plane, without libc and with little RAM.
#include "fnv.h"
#include "gjk2/gjk2.h"
#include "levels.h"
#include "random.h"

#define VERTICES 8

typedef struct body {
  gjk2_vec vertices[VERTICES];
  gjk2_shape shape;
  gjk2_collider collider;
  gjk2_pose pose;
} body;

static body bodies[2];
static uint64_t *hashes;

static void mix(levels_query of, uint32_t value) {
  hashes[of] = fnv_word(hashes[of], value);
}

static void mix_two(levels_query of, int32_t x, int32_t y) {
  mix(of, (uint32_t)x);
  mix(of, (uint32_t)y);
}

static void mix_result(levels_query of, const gjk2_distance_result *out) {
  mix_two(of, out->intersecting, out->distance);
  mix_two(of, out->lower, out->upper);
}

static void mix_points(levels_query of, const gjk2_distance_result *out) {
  mix(of, (uint32_t)out->saturated);
  mix_two(of, out->point_a.x, out->point_a.y);
  mix_two(of, out->point_b.x, out->point_b.y);
  mix_two(of, out->normal.x, out->normal.y);
}

static void query_touch(gjk_q16 distance, gjk2_cache *cache) {
  const gjk2_collider *a = &bodies[0].collider, *b = &bodies[1].collider;
  gjk2_decision out;
  mix(LEVELS_TOUCH, (uint32_t)gjk2_within(a, b, distance, cache, &out));
  mix(LEVELS_TOUCH, (uint32_t)out.yes);
  mix(LEVELS_PROOFS, (uint32_t)gjk2_check_decision(a, b, distance, &out));
}

static void query_gap(gjk2_cache *cache, gjk2_distance_result *out) {
  const gjk2_collider *a = &bodies[0].collider, *b = &bodies[1].collider;
  mix(LEVELS_GAP, (uint32_t)gjk2_distance(a, b, cache, out));
  mix_result(LEVELS_GAP, out);
  if (!out->intersecting) {
    mix_points(LEVELS_GAP, out);
  }
  mix(LEVELS_PROOFS, (uint32_t)gjk2_check_distance(a, b, out));
}

static void query_until(gjk_q16 distance, uint8_t iterations) {
  const gjk2_collider *a = &bodies[0].collider, *b = &bodies[1].collider;
  const gjk2_effort effort = {iterations, distance};
  gjk2_within_result decision;
  gjk2_distance_result out;
  mix(LEVELS_UNTIL, (uint32_t)gjk2_within_until(a, b, distance, iterations, NULL, &decision));
  mix(LEVELS_UNTIL, (uint32_t)decision.answer);
  mix(LEVELS_UNTIL, (uint32_t)gjk2_distance_until(a, b, &effort, NULL, &out));
  mix_result(LEVELS_UNTIL, &out);
  if (!out.intersecting) {
    mix_points(LEVELS_UNTIL, &out);
  }
}

static bool query_depth(gjk2_cache *cache) {
  const gjk2_collider *a = &bodies[0].collider, *b = &bodies[1].collider;
  gjk2_penetration_result out;
  gjk2_distance_result gap;
  mix(LEVELS_DEPTH, (uint32_t)gjk2_penetration(a, b, cache, &out));
  mix(LEVELS_DEPTH, (uint32_t)out.intersecting);
  if (out.intersecting) {
    mix_two(LEVELS_DEPTH, out.depth, out.lower);
    mix_two(LEVELS_DEPTH, out.point_a.x, out.point_a.y);
    mix_two(LEVELS_DEPTH, out.point_b.x, out.point_b.y);
    mix_two(LEVELS_DEPTH, out.normal.x, out.normal.y);
  }
  mix(LEVELS_PROOFS, (uint32_t)gjk2_check_penetration(a, b, &out));
  mix(LEVELS_DEPTH, (uint32_t)gjk2_signed_distance(a, b, cache, &gap));
  mix_result(LEVELS_DEPTH, &gap);
  mix_points(LEVELS_DEPTH, &gap);
  return out.intersecting;
}

static void query_contacts(gjk_q16 margin, unsigned most) {
  static gjk2_manifold out;
  mix(LEVELS_CONTACTS, (uint32_t)gjk2_contacts(&bodies[0].collider, &bodies[1].collider, margin, most, NULL, &out));
  mix_two(LEVELS_CONTACTS, out.normal.x, out.normal.y);
  mix_two(LEVELS_CONTACTS, out.feature_a, out.feature_b);
  for (unsigned i = 0; i < out.count; i++) {
    const gjk2_contact *c = &out.contact[i];
    mix_two(LEVELS_CONTACTS, c->point_a.x, c->point_a.y);
    mix_two(LEVELS_CONTACTS, c->point_b.x, c->point_b.y);
    mix_two(LEVELS_CONTACTS, c->distance, c->id);
  }
}

static void query_motion(random_state *random, gjk_q16 margin) {
  const gjk2_collider *a = &bodies[0].collider, *b = &bodies[1].collider;
  const gjk2_cast_path path = {NULL, &bodies[0].pose.position, margin};
  gjk2_cast_result cast;
  mix(LEVELS_MOTION, (uint32_t)gjk2_cast(a, b, &path, &cast));
  mix_two(LEVELS_MOTION, cast.hit, cast.hit ? cast.fraction : 0);
  if (cast.hit) {
    mix_two(LEVELS_MOTION, cast.normal.x, cast.normal.y);
    mix_two(LEVELS_MOTION, cast.rest_b.x, cast.rest_b.y);
  }
  mix(LEVELS_PROOFS, (uint32_t)gjk2_check_cast(a, b, &path, &cast));
  if (random_below(random, 8) == 0) {
    const gjk2_motion still = {.from = bodies[0].pose, .to = bodies[0].pose};
    const gjk2_motion moving = {
        .from = bodies[1].pose, .to = bodies[0].pose, .spin = random_range(random, -90000, 90000)};
    const gjk2_impact_setup setup = {margin, GJK2_IMPACT_TOLERANCE_MIN, 40};
    gjk2_impact_result out;
    const gjk_status status = gjk2_time_of_impact(a, &still, b, &moving, &setup, &out);
    mix(LEVELS_MOTION, (uint32_t)status);
    if (status == GJK_OK) {
      mix(LEVELS_MOTION, (uint32_t)out.hit);
      mix_two(LEVELS_MOTION, out.lower, out.upper);
    }
  }
}

static gjk2_vec random_vector(random_state *random, int32_t size) {
  gjk2_vec v;
  v.x = random_range(random, -size, size);
  v.y = random_range(random, -size, size);
  return v;
}

static void gjk2_levels_support(const void *user, const gjk2_vec *direction, gjk2_vec *out) {
  (void)user;
  out->x = direction->x < 0 ? -4 : 4;
}

#define KINDS 7

static const gjk2_shape kinds[KINDS] = {
    GJK2_POINT,
    GJK2_SEGMENT(0),
    GJK2_BOX(0, 0),
    GJK2_TRIANGLE(0),
    GJK2_POLYGON(0, 0),
    GJK2_ELLIPSE(0, 0),
    GJK2_CUSTOM(gjk2_levels_support, 0, 9),
};
static const uint8_t known[] = {0, 1, 2, 3, 5, KINDS - 1};  // by levels

static void make_shape(random_state *random, body *b, unsigned level, int32_t size) {
  b->shape = kinds[random_below(random, known[level])];
  const int32_t grid = random_below(random, 3) == 0 ? size / 2 + 1 : 1;
  const gjk2_vec v = random_vector(random, size);
  b->shape.size.x = b->shape.type == &gjk2_class_point ? 0 : (v.x < 0 ? -v.x : v.x) / grid * grid;
  b->shape.size.y = b->shape.type == &gjk2_class_point || b->shape.type == &gjk2_class_segment
                        ? 0
                        : (v.y < 0 ? -v.y : v.y) / grid * grid;
  b->shape.vertices = b->vertices;
  b->shape.count = (uint16_t)(b->shape.type == &gjk2_class_triangle ? 3 : 3 + random_below(random, VERTICES - 2));
  for (unsigned i = 0; i < b->shape.count; i++) {
    const gjk2_vec w = random_vector(random, size);
    b->vertices[i].x = w.x / grid * grid;
    b->vertices[i].y = w.y / grid * grid;
  }
  b->shape.convex_radius = random_below(random, 2) == 0 ? random_range(random, 0, size) : 0;
}

// Every other pose is not turned, or by a quarter, and on a grid.
static void make_pose(random_state *random, body *b, int32_t reach) {
  static const gjk2_pose identity = GJK2_POSE_IDENTITY;
  const gjk2_rotation raw = {random_range(random, -1000, 1000), random_range(random, -1000, 1001)};
  const uint32_t way = random_below(random, 4);
  b->pose = identity;
  b->pose.position = random_vector(random, reach);
  if (way < 2) {
    const int32_t grid = reach / 4 + 1;
    b->pose.position.x = b->pose.position.x / grid * grid;
    b->pose.position.y = b->pose.position.y / grid * grid;
    if (way == 1) {
      b->pose.rotation.c = 0;
      b->pose.rotation.s = GJK_Q30_ONE;
    }
    return;
  }
  (void)gjk2_rotation_normalize(&raw, &b->pose.rotation);
}

static void approach(random_state *random, const gjk2_distance_result *result) {
  body *b = &bodies[1];
  const int32_t by = result->distance + random_range(random, -2, 2);
  b->pose.position.x -= (int32_t)((int64_t)result->normal.x * by / GJK_Q30_ONE);
  b->pose.position.y -= (int32_t)((int64_t)result->normal.y * by / GJK_Q30_ONE);
  mix(LEVELS_GAP, (uint32_t)gjk2_collider_move(&b->collider, &b->pose.position));
}

static bool query_pair(random_state *random, unsigned level) {
  static const gjk2_cache cold = {{0, 0}, 0, {0, 0}, {0, 0}};
  const int32_t size = INT32_C(1) << (1 + random_below(random, 25));
  const bool far = random_below(random, 8) == 0, near = random_below(random, 2) == 0;
  for (int i = 0; i < 2; i++) {
    make_shape(random, &bodies[i], level, size);
    make_pose(random, &bodies[i], far ? INT32_MAX : near ? size / 4 + 1 : size);
    bodies[i].collider.state = 0;
    mix(LEVELS_GAP, (uint32_t)gjk2_collider_init(&bodies[i].collider, &bodies[i].shape, NULL, 0));
    mix(LEVELS_GAP, (uint32_t)gjk2_collider_pose(&bodies[i].collider, &bodies[i].pose));
  }
  gjk2_cache cache = cold;
  gjk2_distance_result gap;
  query_gap(NULL, &gap);
  query_touch(0, NULL);
  query_touch(gap.distance, NULL);
  query_until(size / 16, 1);
  query_until(0, 2);
  query_until(gap.distance, 1);
  query_gap(&cache, &gap);
  const bool overlap = query_depth(&cache);
  query_contacts(size / 16, 2);
  query_motion(random, size / 16);
  if (!gap.intersecting && !far) {
    approach(random, &gap);
    query_gap(&cache, &gap);
    query_touch(0, &cache);
    query_touch(1, NULL);
    query_depth(NULL);
    query_contacts(size / 8, 1);
    query_motion(random, 0);
  }
  return overlap;
}

uint32_t plane_levels_refused(void) {
  static const gjk2_vec corners[3] = {{1, 0}, {0, 1}, {0, 0}};
  uint32_t refused = 0;
  for (unsigned i = 0; i < KINDS; i++) {
    bodies[0].shape = kinds[i];
    bodies[0].shape.vertices = corners;
    bodies[0].shape.count = 3;
    const gjk_status status = gjk2_collider_init(&bodies[0].collider, &bodies[0].shape, NULL, 0);
    refused |= status == GJK_ERROR_UNSUPPORTED ? UINT32_C(1) << i : status != GJK_OK ? UINT32_C(1) << 31 : 0;
  }
  return refused;
}

uint32_t plane_levels_beyond(unsigned level) {
  return (UINT32_C(1) << KINDS) - (UINT32_C(1) << (level == 5 ? KINDS : known[level]));
}

uint32_t plane_levels_hash(unsigned level, uint32_t pairs, uint64_t hash[LEVELS_QUERIES]) {
  random_state random = random_seed(2035 + level);
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
