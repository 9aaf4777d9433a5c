// The fixed set of queries in the plane and its hash, without libc and with little RAM, so that it also runs on an
// 8-bit core. Iterations and certificates tell of the way to an answer, so they are not in it.
#include "plane_golden.h"

#include "fnv.h"
#include "gjk2/gjk2.h"
#include "random.h"

#define VERTICES 12

typedef struct body {
  gjk2_vec vertices[VERTICES], buffer[VERTICES];
  gjk2_shape shape;
  gjk2_collider collider;
  gjk2_pose pose;
} body;

static body bodies[2];
static uint64_t hash;

static void mix(uint32_t value) {
  hash = fnv_word(hash, value);
}

static void mix_status(gjk_status status) {
  mix((uint32_t)status);
}

static void mix_two(int32_t x, int32_t y) {
  mix((uint32_t)x);
  mix((uint32_t)y);
}

static void mix_gap(const gjk2_distance_result *out) {
  mix((uint32_t)out->intersecting);
  mix_two(out->lower, out->upper);
}

static void mix_points(const gjk2_distance_result *out) {
  mix((uint32_t)out->saturated);
  mix((uint32_t)out->distance);
  mix_two(out->point_a.x, out->point_a.y);
  mix_two(out->point_b.x, out->point_b.y);
  mix_two(out->normal.x, out->normal.y);
}

static void mix_distance(gjk2_cache *cache, gjk2_distance_result *out) {
  const gjk_status status = gjk2_distance(&bodies[0].collider, &bodies[1].collider, cache, out);
  mix_status(status);
  mix_gap(out);
  if (!out->intersecting) {
    mix_points(out);
  }
  if (status == GJK_OK) {
    mix_status(gjk2_check_distance(&bodies[0].collider, &bodies[1].collider, out));
  }
}

static void mix_until(uint8_t iterations, gjk_q16 error) {
  const gjk2_effort effort = {iterations, error};
  gjk2_distance_result out;
  mix_status(gjk2_distance_until(&bodies[0].collider, &bodies[1].collider, &effort, NULL, &out));
  mix_gap(&out);
  if (!out.intersecting) {
    mix_points(&out);
  }
}

// distance below 0: gjk2_intersect.
static void mix_decision(gjk_q16 distance, gjk2_cache *cache) {
  gjk2_decision decision;
  const gjk2_collider *a = &bodies[0].collider, *b = &bodies[1].collider;
  const gjk_status status =
      distance < 0 ? gjk2_intersect(a, b, cache, &decision) : gjk2_within(a, b, distance, cache, &decision);
  mix_status(status);
  if (status == GJK_OK) {
    mix((uint32_t)decision.yes);
    mix_status(gjk2_check_decision(a, b, distance < 0 ? 0 : distance, &decision));
  }
}

static void mix_within_until(gjk_q16 distance, uint8_t iterations) {
  gjk2_within_result out;
  mix_status(gjk2_within_until(&bodies[0].collider, &bodies[1].collider, distance, iterations, NULL, &out));
  mix((uint32_t)out.answer);
}

static void mix_penetration(gjk2_cache *cache) {
  gjk2_penetration_result out;
  const gjk_status status = gjk2_penetration(&bodies[0].collider, &bodies[1].collider, cache, &out);
  mix_status(status);
  if (status == GJK_ERROR_ITERATION_LIMIT) {
    return;
  }
  mix((uint32_t)out.intersecting);
  if (out.intersecting) {
    mix_two(out.lower, out.upper);
    mix((uint32_t)out.depth);
    mix_two(out.point_a.x, out.point_a.y);
    mix_two(out.point_b.x, out.point_b.y);
    mix_two(out.normal.x, out.normal.y);
  }
  if (status == GJK_OK) {
    mix_status(gjk2_check_penetration(&bodies[0].collider, &bodies[1].collider, &out));
  }
}

static void mix_signed_distance(gjk2_cache *cache) {
  gjk2_distance_result out;
  const gjk_status status = gjk2_signed_distance(&bodies[0].collider, &bodies[1].collider, cache, &out);
  mix_status(status);
  mix_two(out.lower, out.upper);
  if (status != GJK_ERROR_ITERATION_LIMIT) {
    mix_points(&out);
  }
}

static void mix_contacts(gjk_q16 margin, unsigned most) {
  static gjk2_manifold out;
  const gjk_status status = gjk2_contacts(&bodies[0].collider, &bodies[1].collider, margin, most, NULL, &out);
  mix_status(status);
  if (status != GJK_OK && status != GJK_ERROR_CAPACITY) {
    return;
  }
  mix(out.count);
  if (out.count > 0) {
    mix_two(out.normal.x, out.normal.y);
    mix((uint32_t)out.feature_a << 16 | out.feature_b);
  }
  for (unsigned i = 0; i < out.count; i++) {
    const gjk2_contact *c = &out.contact[i];
    mix_two(c->point_a.x, c->point_a.y);
    mix_two(c->point_b.x, c->point_b.y);
    mix((uint32_t)c->distance);
    mix(c->id);
  }
}

static gjk2_vec random_vector(random_state *random, int32_t size) {
  gjk2_vec v;
  v.x = random_range(random, -size, size);
  v.y = random_range(random, -size, size);
  return v;
}

// A square on its corner, as a user's own shape.
static void diamond(const void *user, const gjk2_vec *direction, gjk2_vec *out) {
  const gjk_q16 reach = *(const gjk_q16 *)user;
  const int32_t x = direction->x < 0 ? -direction->x : direction->x,
                y = direction->y < 0 ? -direction->y : direction->y;
  if (x > y) {
    out->x = direction->x < 0 ? -reach : reach;
  } else {
    out->y = direction->y < 0 ? -reach : reach;
  }
}

static void make_vertices(random_state *random, body *b, int32_t size) {
  const int32_t grid = random_below(random, 4) == 0 ? size / 2 + 1 : 1;  // coarse: ties, repeated points, flat ones
  for (unsigned i = 0; i < b->shape.count; i++) {
    const gjk2_vec v = random_vector(random, size);
    b->vertices[i].x = v.x / grid * grid;
    b->vertices[i].y = v.y / grid * grid;
  }
  if (b->shape.type == &gjk2_class_polygon && random_below(random, 2) == 0) {
    mix_status(gjk2_polygon_order(b->vertices, b->shape.count, b->vertices, &b->shape.count));
    mix(b->shape.count);
  }
}

// A shape of one of seven kinds, of about that size; every fourth has a convex radius.
static void make_shape(random_state *random, body *b, int32_t size) {
  static const gjk2_shape kinds[] = {GJK2_POINT,         GJK2_SEGMENT(0),    GJK2_TRIANGLE(0),          GJK2_BOX(0, 0),
                                     GJK2_POLYGON(0, 0), GJK2_ELLIPSE(0, 0), GJK2_CUSTOM(diamond, 0, 0)};
  // Boxes and polygons are chosen more often.
  static const uint8_t choices[] = {0, 1, 2, 3, 3, 4, 4, 4, 5, 6};
  b->shape = kinds[choices[random_below(random, sizeof choices)]];
  const bool long_x = b->shape.type != &gjk2_class_point;
  b->shape.size.x = long_x ? random_range(random, 1, size) : 0;
  b->shape.size.y = long_x && b->shape.type != &gjk2_class_segment ? random_range(random, 1, size) : 0;
  b->shape.vertices = b->vertices;
  b->shape.user = &b->shape.size.x;
  b->shape.count = (uint16_t)(b->shape.type == &gjk2_class_triangle ? 3 : 2 + random_below(random, VERTICES - 1));
  make_vertices(random, b, size);
  b->shape.convex_radius = random_below(random, 4) == 0 ? random_range(random, 0, size / 2) : 0;
}

// No turn, a turn by an angle, by cosine and sine, or one composed of both.
static void make_rotation(random_state *random, gjk2_rotation *out) {
  const gjk2_rotation raw = {random_range(random, -1000, 1000), random_range(random, -1000, 1001)};
  const gjk_angle angle = random_range(random, -500000, 500000);
  gjk2_rotation other;
  switch (random_below(random, 4)) {
    case 0: break;
    case 1: mix_status(gjk2_rotation_from_angle(angle, out)); break;
    case 2: mix_status(gjk2_rotation_normalize(&raw, out)); break;
    default:
      mix_status(gjk2_rotation_from_angle(angle, out));
      mix_status(gjk2_rotation_normalize(&raw, &other));
      mix_status(gjk2_rotation_compose(out, &other, out));
  }
  mix_two(out->c, out->s);
}

static void make_pose(random_state *random, body *b, int32_t reach) {
  static const gjk2_pose identity = GJK2_POSE_IDENTITY;
  const gjk2_vec v = random_vector(random, reach);
  gjk2_pose inverse;
  gjk2_vec back;
  b->pose = identity;
  make_rotation(random, &b->pose.rotation);
  b->pose.position = random_vector(random, reach);
  if (reach < INT32_MAX / 4) {
    mix_status(gjk2_pose_apply(&b->pose, &v, &back));
    mix_two(back.x, back.y);
    mix_status(gjk2_pose_invert(&b->pose, &inverse));
    mix_two(inverse.position.x, inverse.position.y);
    mix_status(gjk2_pose_compose(&b->pose, &inverse, &inverse));
    mix_two(inverse.position.x, inverse.position.y);
  }
}

// False: the pose is out of range.
static bool place(random_state *random, body *b) {
  const bool baked = random_below(random, 2) == 0;
  gjk2_aabb box;
  b->collider.state = 0;
  mix_status(gjk2_collider_init(&b->collider, &b->shape, baked ? b->buffer : NULL, VERTICES));
  const gjk_status status = gjk2_collider_pose(&b->collider, &b->pose);
  mix_status(status);
  if (status != GJK_OK) {
    return false;
  }
  mix_status(gjk2_collider_aabb(&b->collider, &box));
  mix_two(box.lower.x, box.lower.y);
  mix_two(box.upper.x, box.upper.y);
  return true;
}

// Moves B along the normal until the gap is near 0.
static void approach(random_state *random, const gjk2_distance_result *result) {
  body *b = &bodies[1];
  const int32_t by = result->distance + random_range(random, -2, 2);
  gjk2_vec position = b->pose.position;
  position.x -= (int32_t)((int64_t)result->normal.x * by / GJK_Q30_ONE);
  position.y -= (int32_t)((int64_t)result->normal.y * by / GJK_Q30_ONE);
  mix_status(gjk2_collider_move(&b->collider, &position));
}

static void query_near(random_state *random, int32_t size, gjk2_cache *cache, gjk2_distance_result *result) {
  approach(random, result);
  mix_distance(cache, result);
  mix_decision(-1, cache);
  mix_decision(1, NULL);
  mix_within_until(1 + size / 32, 1);
  mix_within_until(result->distance, 2);
  mix_until(2, 0);
  mix_until(0, 1 + size / 16);
  mix_penetration(NULL);
  mix_contacts(size / 8, 2);
  mix_contacts(size / 8, 1);
}

static void query_pair(random_state *random) {
  static const gjk2_cache cold = {{0, 0}, 0, {0, 0}, {0, 0}};
  const int32_t size = INT32_C(1) << (3 + random_below(random, 23));
  const bool far = random_below(random, 8) == 0;
  bool placed = true;
  for (int i = 0; i < 2; i++) {
    make_shape(random, &bodies[i], size);
    make_pose(random, &bodies[i], far ? INT32_MAX : 2 * size);
    placed = place(random, &bodies[i]) && placed;
  }
  if (!placed) {
    return;
  }
  gjk2_cache cache = cold;
  gjk2_distance_result result;
  mix_distance(NULL, &result);
  mix_decision(-1, NULL);
  mix_decision(result.distance, NULL);
  mix_distance(&cache, &result);
  mix_penetration(&cache);
  mix_signed_distance(&cache);
  mix_contacts(0, 2);
  if (!result.intersecting && !far) {
    query_near(random, size, &cache, &result);
  }
}

// What queries answer where they refuse.
static void refuse(void) {
  static const gjk2_rotation none = {0, 0};
  const gjk2_collider *a = &bodies[0].collider;
  gjk2_collider unset = *a;
  gjk2_manifold manifold;
  gjk2_decision decision;
  gjk2_distance_result distance;
  gjk2_rotation out;
  unset.state = 0;
  mix_status(gjk2_intersect(a, &unset, NULL, &decision));
  mix_status(gjk2_within(a, a, -1, NULL, &decision));
  mix_status(gjk2_distance(NULL, a, NULL, &distance));
  mix_status(gjk2_contacts(a, a, 0, 3, NULL, &manifold));
  mix_status(gjk2_rotation_normalize(&none, &out));
}

uint64_t plane_golden_hash(uint32_t pairs) {
  random_state random = random_seed(2027);
  hash = FNV_START;
  for (uint32_t i = 0; i < pairs; i++) {
    query_pair(&random);
  }
  refuse();
  return hash;
}
