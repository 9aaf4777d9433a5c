// The sets of pairs and queries of levels.h in space, without libc and with little RAM.
#include "levels.h"

#include "fnv.h"
#include "gjk/gjk.h"
#include "gjk/impact.h"
#include "random.h"

#define VERTICES 8

typedef struct body {
  gjk_vec3 vertices[VERTICES];
  gjk_shape shape;
  gjk_collider collider;
  gjk_pose pose;
} body;

static body bodies[2];
static uint64_t *hashes;
static gjk_epa_cell cells[GJK_EPA_CELLS(20)];
static const gjk_workspace workspace = {cells, GJK_EPA_CELLS(20)};

static void mix(levels_query of, uint32_t value) {
  hashes[of] = fnv_word(hashes[of], value);
}

static void mix_vector(levels_query of, int32_t x, int32_t y, int32_t z) {
  mix(of, (uint32_t)x);
  mix(of, (uint32_t)y);
  mix(of, (uint32_t)z);
}

static void mix_points(levels_query of, const gjk_distance_result *out) {
  mix(of, (uint32_t)out->saturated);
  mix_vector(of, out->point_a.x, out->point_a.y, out->point_a.z);
  mix_vector(of, out->point_b.x, out->point_b.y, out->point_b.z);
  mix_vector(of, out->normal.x, out->normal.y, out->normal.z);
}

static void query_touch(gjk_q16 distance, gjk_cache *cache) {
  const gjk_collider *a = &bodies[0].collider, *b = &bodies[1].collider;
  gjk_decision out;
  mix(LEVELS_TOUCH, (uint32_t)gjk_within(a, b, distance, cache, &out));
  mix(LEVELS_TOUCH, (uint32_t)out.yes);
  mix(LEVELS_PROOFS, (uint32_t)gjk_check_decision(a, b, distance, &out));
}

static void query_gap(gjk_cache *cache, gjk_distance_result *out) {
  const gjk_collider *a = &bodies[0].collider, *b = &bodies[1].collider;
  mix(LEVELS_GAP, (uint32_t)gjk_distance(a, b, cache, out));
  mix(LEVELS_GAP, (uint32_t)out->intersecting);
  mix_vector(LEVELS_GAP, out->distance, out->lower, out->upper);
  if (!out->intersecting) {
    mix_points(LEVELS_GAP, out);
  }
  mix(LEVELS_PROOFS, (uint32_t)gjk_check_distance(a, b, out));
}

static void query_until(gjk_q16 distance, uint8_t iterations) {
  const gjk_collider *a = &bodies[0].collider, *b = &bodies[1].collider;
  const gjk_effort effort = {iterations, distance};
  gjk_within_result decision;
  gjk_distance_result out;
  mix(LEVELS_UNTIL, (uint32_t)gjk_within_until(a, b, distance, iterations, NULL, &decision));
  mix(LEVELS_UNTIL, (uint32_t)decision.answer);
  mix(LEVELS_UNTIL, (uint32_t)gjk_distance_until(a, b, &effort, NULL, &out));
  mix(LEVELS_UNTIL, (uint32_t)out.intersecting);
  mix_vector(LEVELS_UNTIL, out.distance, out.lower, out.upper);
  if (!out.intersecting) {
    mix_points(LEVELS_UNTIL, &out);
  }
}

static bool query_depth(gjk_cache *cache) {
  const gjk_collider *a = &bodies[0].collider, *b = &bodies[1].collider;
  gjk_penetration_result out;
  gjk_distance_result gap;
  mix(LEVELS_DEPTH, (uint32_t)gjk_penetration(a, b, cache, &workspace, &out));
  mix(LEVELS_DEPTH, (uint32_t)out.intersecting);
  if (out.intersecting) {
    mix_vector(LEVELS_DEPTH, out.depth, out.lower, out.upper);
    mix_vector(LEVELS_DEPTH, out.point_a.x, out.point_a.y, out.point_a.z);
    mix_vector(LEVELS_DEPTH, out.point_b.x, out.point_b.y, out.point_b.z);
    mix_vector(LEVELS_DEPTH, out.normal.x, out.normal.y, out.normal.z);
  }
  mix(LEVELS_PROOFS, (uint32_t)gjk_check_penetration(a, b, &out));
  mix(LEVELS_DEPTH, (uint32_t)gjk_signed_distance(a, b, cache, &workspace, &gap));
  mix_vector(LEVELS_DEPTH, gap.distance, gap.lower, gap.upper);
  mix_points(LEVELS_DEPTH, &gap);
  return out.intersecting;
}

static void query_contacts(gjk_q16 margin, unsigned most) {
  static gjk_manifold out;
  mix(LEVELS_CONTACTS,
      (uint32_t)gjk_contacts(&bodies[0].collider, &bodies[1].collider, margin, most, NULL, &workspace, &out));
  mix_vector(LEVELS_CONTACTS, out.normal.x, out.normal.y, out.normal.z);
  mix_vector(LEVELS_CONTACTS, out.count, out.feature_a, out.feature_b);
  for (unsigned i = 0; i < out.count; i++) {
    const gjk_contact *c = &out.contact[i];
    mix_vector(LEVELS_CONTACTS, c->point_a.x, c->point_a.y, c->point_a.z);
    mix_vector(LEVELS_CONTACTS, c->point_b.x, c->point_b.y, c->point_b.z);
    mix_vector(LEVELS_CONTACTS, c->distance, c->id, 0);
  }
}

static void query_cast(gjk_q16 margin) {
  const gjk_collider *a = &bodies[0].collider, *b = &bodies[1].collider;
  const gjk_cast_path path = {NULL, &bodies[0].pose.position, margin};
  gjk_cast_result cast;
  mix(LEVELS_MOTION, (uint32_t)gjk_cast(a, b, &path, &cast));
  mix_vector(LEVELS_MOTION, cast.hit, cast.hit && cast.inside, cast.hit ? cast.fraction : 0);
  if (cast.hit) {
    mix_vector(LEVELS_MOTION, cast.normal.x, cast.normal.y, cast.normal.z);
    mix_vector(LEVELS_MOTION, cast.rest_b.x, cast.rest_b.y, cast.rest_b.z);
  }
  mix(LEVELS_PROOFS, (uint32_t)gjk_check_cast(a, b, &path, &cast));
}

static void query_impact(random_state *random, gjk_q16 margin) {
  const gjk_collider *a = &bodies[0].collider, *b = &bodies[1].collider;
  if (random_below(random, 8) == 0) {
    const gjk_motion still = {.from = bodies[0].pose, .to = bodies[0].pose};
    const gjk_motion moving = {
        .from = bodies[1].pose, .to = bodies[0].pose, .spin = {random_range(random, -90000, 90000), 30000, 0}};
    const gjk_impact_setup setup = {margin, GJK_IMPACT_TOLERANCE_MIN, 40};
    gjk_impact_result out;
    const gjk_status status = gjk_time_of_impact(a, &still, b, &moving, &setup, &out);
    mix(LEVELS_MOTION, (uint32_t)status);
    if (status == GJK_OK) {
      mix_vector(LEVELS_MOTION, out.hit, out.lower, out.upper);
    }
  }
}

// Points alone have no casts.
static void query_motion(random_state *random, unsigned level, gjk_q16 margin) {
  if (level > 1) {
    query_cast(margin);
  }
  query_impact(random, margin);
}

static gjk_vec3 random_vector(random_state *random, int32_t size) {
  gjk_vec3 v;
  v.x = random_range(random, -size, size);
  v.y = random_range(random, -size, size);
  v.z = random_range(random, -size, size);
  return v;
}

static void gjk_levels_support(const void *user, const gjk_vec3 *direction, gjk_vec3 *out) {
  (void)user;
  out->x = direction->x < 0 ? -4 : 4;
}

#define KINDS 9

static const gjk_shape kinds[KINDS] = {
    GJK_POINT,       GJK_SEGMENT(0),         GJK_BOX(0, 0, 0),
    GJK_TRIANGLE(0), GJK_HULL(0, 0),         GJK_CYLINDER(0, 0),
    GJK_CONE(0, 0),  GJK_ELLIPSOID(0, 0, 0), GJK_CUSTOM(gjk_levels_support, 0, 9),
};
static const uint8_t known[] = {0, 1, 2, 3, 5, KINDS - 1};  // by levels

// A shape of a kind of the level, of about that size; every other has a convex radius. Every fourth has sizes of 0 or equal ones.
static void make_shape(random_state *random, body *b, unsigned level, int32_t size) {
  b->shape = kinds[random_below(random, known[level])];
  const bool coarse = random_below(random, 3) == 0;
  const int32_t grid = coarse ? size / 2 + 1 : 1;
  const gjk_vec3 v = random_vector(random, size);
  b->shape.size.x = (v.x < 0 ? -v.x : v.x) / grid * grid;
  b->shape.size.y = (v.y < 0 ? -v.y : v.y) / grid * grid;
  b->shape.size.z = (v.z < 0 ? -v.z : v.z) / grid * grid;
  if (b->shape.type == &gjk_class_point || b->shape.type == &gjk_class_segment) {
    b->shape.size.x = b->shape.size.y = 0;
  }
  if (b->shape.type == &gjk_class_point) {
    b->shape.size.z = 0;
  }
  b->shape.vertices = b->vertices;
  b->shape.count = (uint16_t)(b->shape.type == &gjk_class_triangle ? 3 : 4 + random_below(random, VERTICES - 3));
  for (unsigned i = 0; i < b->shape.count; i++) {
    const gjk_vec3 w = random_vector(random, size);
    b->vertices[i].x = w.x / grid * grid;
    b->vertices[i].y = w.y / grid * grid;
    b->vertices[i].z = w.z / grid * grid;
  }
  b->shape.convex_radius = random_below(random, 2) == 0 ? random_range(random, 0, size) : 0;
}

// Every other pose is not turned, or by a quarter, and on a grid: parallel edges, crossing ones, and shapes that touch.
static void make_pose(random_state *random, body *b, int32_t reach) {
  static const gjk_pose identity = GJK_POSE_IDENTITY;
  const gjk_quat quarter = {0, 1000, 0, 1000}, other = {1000, 0, 0, 1000};
  const uint32_t way = random_below(random, 8);
  b->pose = identity;
  b->pose.position = random_vector(random, reach);
  if (way < 4) {
    const int32_t grid = way < 2 ? reach / 4 + 1 : 1;
    b->pose.position.x = b->pose.position.x / grid * grid;
    b->pose.position.y = b->pose.position.y / grid * grid;
    b->pose.position.z = way == 3 ? b->pose.position.z : b->pose.position.z / grid * grid;
    if (way > 0) {
      (void)gjk_quat_normalize(way < 3 ? &quarter : &other, &b->pose.rotation);
    }
    return;
  }
  const gjk_quat q = {random_range(random, -1000, 1000), random_range(random, -1000, 1000),
                      random_range(random, -1000, 1000), random_range(random, -1000, 1001)};
  (void)gjk_quat_normalize(&q, &b->pose.rotation);
}

// Moves B along the normal until the gap is near 0.
static void approach(random_state *random, const gjk_distance_result *result) {
  body *b = &bodies[1];
  const int32_t by = result->distance + random_range(random, -2, 2);
  b->pose.position.x -= (int32_t)((int64_t)result->normal.x * by / GJK_Q30_ONE);
  b->pose.position.y -= (int32_t)((int64_t)result->normal.y * by / GJK_Q30_ONE);
  b->pose.position.z -= (int32_t)((int64_t)result->normal.z * by / GJK_Q30_ONE);
  mix(LEVELS_GAP, (uint32_t)gjk_collider_move(&b->collider, &b->pose.position));
}

static bool query_pair(random_state *random, unsigned level) {
  static const gjk_cache cold = {{0, 0, 0}, 0, {0, 0, 0, 0}, {0, 0, 0, 0}};
  const int32_t size = INT32_C(1) << (1 + random_below(random, 25));
  const bool far = random_below(random, 8) == 0, near = random_below(random, 2) == 0;
  for (int i = 0; i < 2; i++) {
    make_shape(random, &bodies[i], level, size);
    make_pose(random, &bodies[i], far ? INT32_MAX : near ? size / 4 + 1 : size);
    bodies[i].collider.state = 0;
    mix(LEVELS_GAP, (uint32_t)gjk_collider_init(&bodies[i].collider, &bodies[i].shape, NULL, 0));
    mix(LEVELS_GAP, (uint32_t)gjk_collider_pose(&bodies[i].collider, &bodies[i].pose));
  }
  gjk_cache cache = cold;
  gjk_distance_result gap;
  query_gap(NULL, &gap);
  query_touch(0, NULL);
  query_touch(gap.distance, NULL);
  query_until(size / 16, 1);
  query_until(0, 2);
  query_until(gap.distance, 1);
  query_gap(&cache, &gap);
  const bool overlap = query_depth(&cache);
  query_contacts(size / 16, 4);
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
  static const gjk_vec3 corners[4] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}};
  uint32_t refused = 0;
  for (unsigned i = 0; i < KINDS; i++) {
    bodies[0].shape = kinds[i];
    bodies[0].shape.vertices = corners;
    bodies[0].shape.count = bodies[0].shape.type == &gjk_class_triangle ? 3 : 4;
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
