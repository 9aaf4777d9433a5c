// Space against the plane: prisms that are high enough decide and measure in gjk_ what their sections do in gjk2_.
//
// Posing rounds, so both get the same posed integers. A prism stands on the vertices that the plane's collider has
// posed, at any rotation; or both shapes are posed by themselves, turned by quarters, which are exact.
#include "gjk/gjk.h"
#include "plane.h"

#define SEED 1977
#define TRIALS check_trials(60000)
#define PRISM_VERTICES (2 * PLANE_VERTICES)

typedef struct solid {
  gjk_vec3 vertices[PRISM_VERTICES], buffer[PRISM_VERTICES];
  gjk_shape shape;
  gjk_pose pose;
  gjk_collider collider;
} solid;

static gjk_epa_cell cells[GJK_EPA_CELLS(2048)];
static const gjk_workspace workspace = {cells, GJK_EPA_CELLS(2048)};

static struct { unsigned long apart, together, near, touching; } tally;

static gjk_pose pose_at(int32_t x, int32_t y, int32_t z) {
  gjk_pose pose = GJK_POSE_IDENTITY;
  pose.position.x = x;
  pose.position.y = y;
  pose.position.z = z;
  return pose;
}

static void place_solid(solid *s) {
  s->collider.state = 0;
  CHECK(gjk_collider_init(&s->collider, &s->shape, s->buffer, PRISM_VERTICES) == GJK_OK);
  CHECK(gjk_collider_pose(&s->collider, &s->pose) == GJK_OK);
}

// Stands a hull on the posed vertices of a body: half high up and down; half 0: flat.
static void raise_prism(const plane_body *body, int32_t half, int32_t z, solid *out) {
  plane_point points[PLANE_VERTICES];
  const int n = plane_vertices(&body->collider, points);
  const gjk2_vec centre = body->collider.centre;
  uint16_t count = 0;
  for (int side = half > 0 ? -1 : 1; side <= 1; side += 2) {
    for (int i = 0; i < n; i++) {
      gjk_vec3 *v = &out->vertices[count++];
      v->x = (int32_t)(points[i].x - centre.x);
      v->y = (int32_t)(points[i].y - centre.y);
      v->z = side * half;
    }
  }
  const gjk_shape hull = GJK_ROUNDED_HULL(out->vertices, count, body->shape.convex_radius);
  out->shape = hull;
  out->pose = pose_at(centre.x, centre.y, z);
  place_solid(out);
}

// Both are shapes that lie within their circles, so this is higher than any depth in the plane.
static int32_t high_enough(const plane_body pair[2]) {
  return pair[0].collider.radius + pair[1].collider.radius + 1;
}

// The direction from A to B is unique where they are apart, and lies in the plane.
static void check_normal(const gjk_distance_result *high, const gjk2_distance_result *flat) {
  CHECK(abs(high->normal.x - flat->normal.x) <= 8);
  CHECK(abs(high->normal.y - flat->normal.y) <= 8);
  CHECK(abs(high->normal.z) <= 4);
}

static void check_within(const plane_body pair[2], const solid raised[2], gjk_q16 distance) {
  gjk2_decision flat;
  gjk_decision high;
  if (distance >= 0) {
    CHECK(gjk2_within(&pair[0].collider, &pair[1].collider, distance, NULL, &flat) == GJK_OK);
    CHECK(gjk_within(&raised[0].collider, &raised[1].collider, distance, NULL, &high) == GJK_OK);
    CHECK(flat.yes == high.yes);
  }
}

// Two capsules that cross in space leave each other out of the plane.
static bool both_are_capsules(const solid raised[2]) {
  return raised[0].shape.type == &gjk_class_segment && raised[1].shape.type == &gjk_class_segment;
}

static void check_depth(const plane_body pair[2], const solid raised[2]) {
  gjk2_penetration_result flat;
  gjk_penetration_result high;
  CHECK(gjk2_penetration(&pair[0].collider, &pair[1].collider, NULL, &flat) == GJK_OK);
  CHECK(gjk_penetration(&raised[0].collider, &raised[1].collider, NULL, &workspace, &high) == GJK_OK);
  CHECK(flat.intersecting == high.intersecting);
  if (flat.intersecting && high.intersecting) {
    CHECK_MSG(flat.depth == high.depth, "%d in the plane, %d in space", flat.depth, high.depth);
    tally.touching += flat.depth == 0;
  }
}

// Returns the signed distance in the plane, with its normal.
static gjk2_distance_result check_pair(random_state *r, const plane_body pair[2], const solid raised[2]) {
  const gjk2_collider *a = &pair[0].collider, *b = &pair[1].collider;
  gjk2_decision decision;
  gjk_decision high_decision;
  gjk2_distance_result flat, both;
  gjk_distance_result high;
  CHECK(gjk2_intersect(a, b, NULL, &decision) == GJK_OK);
  CHECK(gjk_intersect(&raised[0].collider, &raised[1].collider, NULL, &high_decision) == GJK_OK);
  CHECK(decision.yes == high_decision.yes);
  CHECK(gjk2_distance(a, b, NULL, &flat) == GJK_OK);
  CHECK(gjk_distance(&raised[0].collider, &raised[1].collider, NULL, &high) == GJK_OK);
  CHECK(flat.intersecting == high.intersecting);
  CHECK_MSG(flat.distance == high.distance, "%d in the plane, %d in space", flat.distance, high.distance);
  if (!flat.intersecting && !high.intersecting) {
    check_normal(&high, &flat);
  }
  for (gjk_q16 asked = flat.distance - 1; asked <= flat.distance + 1; asked++) {
    check_within(pair, raised, asked);
  }
  check_within(pair, raised, random_range(r, 0, INT32_MAX) >> random_below(r, 31));
  if (!both_are_capsules(raised)) {
    check_depth(pair, raised);
  }
  CHECK(gjk2_signed_distance(a, b, NULL, &both) == GJK_OK);
  tally.together += flat.intersecting;
  tally.apart += !flat.intersecting;
  return both;
}

// Moves B to about touching, in the plane and in space.
static void approach(random_state *r, const gjk2_distance_result *gap, plane_body pair[2], solid raised[2]) {
  const int64_t by = (int64_t)gap->distance + random_range(r, -2, 2);
  const int32_t x = (int32_t)(gap->normal.x * by / GJK_Q30_ONE), y = (int32_t)(gap->normal.y * by / GJK_Q30_ONE);
  pair[1].pose.position.x -= x;
  pair[1].pose.position.y -= y;
  raised[1].pose.position.x -= x;
  raised[1].pose.position.y -= y;
  CHECK(gjk2_collider_move(&pair[1].collider, &pair[1].pose.position) == GJK_OK);
  CHECK(gjk_collider_move(&raised[1].collider, &raised[1].pose.position) == GJK_OK);
}

static void check_both(random_state *r, plane_body pair[2], solid raised[2]) {
  const gjk2_distance_result gap = check_pair(r, pair, raised);
  approach(r, &gap, pair, raised);
  const gjk2_distance_result now = check_pair(r, pair, raised);
  tally.near += abs(now.distance) <= 6;
}

// Prisms on posed vertices. One of the two may be flat; B may stand higher or lower than A.
static void check_prisms(random_state *r) {
  static plane_body pair[2];
  static solid raised[2];
  const int32_t size = INT32_C(1) << random_range(r, 2, 23);
  plane_random_pair(r, size, 2 * size, pair);
  const int32_t high = high_enough(pair), lift = random_range(r, -high, high);
  const unsigned flat = random_below(r, 3);
  check_trial(check_now.trial + 1, plane_print, pair);
  raise_prism(&pair[0], flat == 0 ? 0 : 2 * high, 0, &raised[0]);
  raise_prism(&pair[1], flat == 1 ? 0 : 2 * high, lift, &raised[1]);
  check_both(r, pair, raised);
}

// The rotation by quarters about z. lying: first about y, which lays what stands along z along x.
static void turn_quarters(unsigned quarters, bool lying, gjk_quat *out) {
  static const gjk_quat about_z[4] = {{0, 0, 0, 1}, {0, 0, 1, 1}, {0, 0, 1, 0}, {0, 0, 1, -1}};
  static const gjk_quat about_y = {0, 1, 0, 1};
  CHECK(gjk_quat_normalize(&about_z[quarters], out) == GJK_OK);
  if (lying) {
    gjk_quat first;
    CHECK(gjk_quat_normalize(&about_y, &first) == GJK_OK);
    CHECK(gjk_quat_compose(out, &first, out) == GJK_OK);
  }
}

// The same kind in both, sizes and turn the same: a circle and a sphere, capsules, boxes, polygons and their prisms.
static void make_twins(random_state *r, int32_t size, plane_body *body, solid *twin) {
  static const gjk2_rotation turns[4] = {{GJK_Q30_ONE, 0}, {0, GJK_Q30_ONE}, {-GJK_Q30_ONE, 0}, {0, -GJK_Q30_ONE}};
  const unsigned quarters = random_below(r, 4), kind = random_below(r, 4);
  const gjk_q16 x = random_range(r, 1, size), y = random_range(r, 1, size), height = 8 * size;
  const gjk_q16 radius = kind < 2 || random_below(r, 2) == 0 ? random_range(r, 0, size) : 0;
  const uint16_t count = (uint16_t)(3 + random_below(r, 6));
  for (int i = 0; i < count; i++) {
    const gjk_vec3 v = {random_range(r, -size, size), random_range(r, -size, size), height};
    body->vertices[i].x = v.x;
    body->vertices[i].y = v.y;
    twin->vertices[i] = twin->vertices[count + i] = v;
    twin->vertices[i].z = -height;
  }
  const gjk2_shape flat[4] = {GJK2_CIRCLE(radius), GJK2_CAPSULE(radius, x), GJK2_ROUNDED_BOX(x, y, radius),
                              GJK2_ROUNDED_POLYGON(body->vertices, count, radius)};
  const gjk_shape high[4] = {GJK_SPHERE(radius), GJK_CAPSULE(radius, x), GJK_ROUNDED_BOX(x, y, height, radius),
                             GJK_ROUNDED_HULL(twin->vertices, (uint16_t)(2 * count), radius)};
  body->shape = flat[kind];
  twin->shape = high[kind];
  body->pose.rotation = turns[quarters];
  body->pose.position.x = random_range(r, -2 * size, 2 * size);
  body->pose.position.y = random_range(r, -2 * size, 2 * size);
  twin->pose = pose_at(body->pose.position.x, body->pose.position.y, 0);
  turn_quarters(quarters, kind == 1, &twin->pose.rotation);
  plane_place(body, random_below(r, 2) == 0);
  place_solid(twin);
}

// Quarter turns have moved both to the same integers.
static void check_boxes(const plane_body *body, const solid *twin) {
  gjk2_aabb flat;
  gjk_aabb high;
  CHECK(gjk2_collider_aabb(&body->collider, &flat) == GJK_OK);
  CHECK(gjk_collider_aabb(&twin->collider, &high) == GJK_OK);
  CHECK(flat.lower.x == high.lower.x && flat.lower.y == high.lower.y);
  CHECK(flat.upper.x == high.upper.x && flat.upper.y == high.upper.y);
}

static void check_twins(random_state *r) {
  static plane_body pair[2];
  static solid twins[2];
  const int32_t size = INT32_C(1) << random_range(r, 2, 23);
  for (int i = 0; i < 2; i++) {
    make_twins(r, size, &pair[i], &twins[i]);
    check_boxes(&pair[i], &twins[i]);
  }
  check_trial(check_now.trial + 1, plane_print, pair);
  check_both(r, pair, twins);
}

// Lower prisms leave each other by their lids: high enough means something.
static void check_low(void) {
  static plane_body pair[2];
  static solid raised[2];
  const gjk2_shape box = GJK2_BOX(1000, 1000);
  const gjk2_pose identity = GJK2_POSE_IDENTITY;
  gjk_penetration_result high;
  for (int i = 0; i < 2; i++) {
    pair[i].shape = box;
    pair[i].pose = identity;
    plane_place(&pair[i], false);
    raise_prism(&pair[i], 100, 0, &raised[i]);
  }
  CHECK(gjk_penetration(&raised[0].collider, &raised[1].collider, NULL, &workspace, &high) == GJK_OK);
  CHECK(high.depth == 200);
}

int main(void) {
  random_state r = random_seed(check_seed(SEED));
  check_low();
  for (unsigned long i = 0; i < TRIALS; i++) {
    check_prisms(&r);
    check_twins(&r);
  }
  printf("%lu pairs apart, %lu together, of these %lu touch; %lu within 6 LSB\n", tally.apart, tally.together,
         tally.touching, tally.near);
  CHECK(tally.apart > TRIALS);
  CHECK(tally.together > TRIALS);
  CHECK(tally.near > TRIALS * 3 / 2);
  CHECK(TRIALS < 1000 || tally.touching > TRIALS / 100);
  return check_done("plane prisms");
}
