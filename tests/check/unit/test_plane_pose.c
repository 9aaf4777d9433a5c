// Rotations, poses and colliders of the plane: errors against long double, baked against lazy, statuses, AABBs.
#include "plane.h"

#define SEED 2006
#define TRIALS check_trials(40000)
#define ONE 1073741824.0L

static long double worst[6];

static void note(int which, long double error, long double limit) {
  CHECK_MSG(error <= limit, "%d: %Lf", which, error);
  worst[which] = error > worst[which] ? error : worst[which];
}

static long double error_of(int64_t x, long double truth) {
  return fabsl((long double)x - truth);
}

static int32_t any_number(random_state *r) {
  const uint32_t bits = random_below(r, 33);
  const uint32_t x = bits == 32 ? random_u32(r) : random_u32(r) & ((UINT32_C(1) << bits) - 1);
  return random_below(r, 2) == 0 ? (int32_t)x : (int32_t)(0u - x);
}

// A rotation within the tolerance, mostly not a unit.
static gjk2_rotation any_rotation(random_state *r) {
  gjk2_rotation unit;
  CHECK(gjk2_rotation_from_angle(any_number(r), &unit) == GJK_OK);
  const long double scale = 1 + (random_range(r, -7000, 7000)) / ONE;
  unit.c = (gjk_q30)(unit.c * scale);
  unit.s = (gjk_q30)(unit.s * scale);
  return unit;
}

static void check_rotations(random_state *r) {
  const gjk_angle angle = any_number(r);
  gjk2_rotation out;
  CHECK(gjk2_rotation_from_angle(angle, &out) == GJK_OK);
  note(0, error_of(out.c, cosl(angle / 65536.0L) * ONE), 1);
  note(0, error_of(out.s, sinl(angle / 65536.0L) * ONE), 1);
  const gjk2_rotation raw = {any_number(r), any_number(r)};
  const gjk_status status = gjk2_rotation_normalize(&raw, &out);
  CHECK((status == GJK_OK) == (raw.c != 0 || raw.s != 0));
  if (status == GJK_OK) {
    const long double n = hypotl(raw.c, raw.s);
    note(1, error_of(out.c, raw.c / n * ONE), 0.501L);
    note(1, error_of(out.s, raw.s / n * ONE), 0.501L);
  }
  const gjk2_rotation a = any_rotation(r), b = any_rotation(r);
  CHECK(gjk2_rotation_compose(&a, &b, &out) == GJK_OK);
  const long double n = hypotl(a.c, a.s) * hypotl(b.c, b.s);
  note(2, error_of(out.c, ((long double)a.c * b.c - (long double)a.s * b.s) / n * ONE), 0.501L);
  note(2, error_of(out.s, ((long double)a.c * b.s + (long double)a.s * b.c) / n * ONE), 0.501L);
  const gjk2_vec v = {any_number(r), any_number(r)};
  gjk2_vec p;
  const long double size = hypotl(a.c, a.s);
  const long double x = ((long double)a.c * v.x - (long double)a.s * v.y) / size;
  const long double y = ((long double)a.s * v.x + (long double)a.c * v.y) / size;
  const gjk_status applied = gjk2_rotation_apply(&a, &v, &p);
  CHECK(applied == GJK_OK || fabsl(x) >= 2147483647 || fabsl(y) >= 2147483647);
  if (applied == GJK_OK) {
    note(3, error_of(p.x, x), 0.51L);
    note(3, error_of(p.y, y), 0.51L);
  }
  // There and back.
  const gjk2_pose pose = {{v.x / 4, v.y / 4}, a};
  const gjk2_vec q = {any_number(r) / 4, any_number(r) / 4};
  gjk2_pose inverse, both;
  gjk2_vec there, back;
  CHECK(gjk2_pose_invert(&pose, &inverse) == GJK_OK);
  CHECK(gjk2_pose_apply(&pose, &q, &there) == GJK_OK && gjk2_pose_apply(&inverse, &there, &back) == GJK_OK);
  note(4, error_of(back.x, q.x), 2);
  note(4, error_of(back.y, q.y), 2);
  CHECK(gjk2_pose_compose(&inverse, &pose, &both) == GJK_OK);
  note(5, error_of(both.position.x, 0), 2);
  note(5, error_of(both.rotation.s, 0), 2);
}

static void check_refused(void) {
  gjk2_rotation out = {7, 7};
  gjk2_vec v = {3, 4}, p = {5, 6};
  const gjk2_rotation zero = {0, 0}, minus = {INT32_MIN, 0}, identity = {GJK_Q30_ONE, 0};
  // 2^30 (1 + 2^-17) is the last within the tolerance, exactly: c^2 = 2^60 + 2^44 + 2^26 is beyond, one less is not.
  const gjk2_rotation beyond = {GJK_Q30_ONE + 8192, 0}, within = {GJK_Q30_ONE + 8191, 0};
  CHECK(gjk2_rotation_normalize(&zero, &out) == GJK_ERROR_ROTATION);
  CHECK(gjk2_rotation_apply(&beyond, &v, &p) == GJK_ERROR_ROTATION);
  CHECK(gjk2_rotation_invert(&minus, &out) == GJK_ERROR_ROTATION);
  CHECK(gjk2_rotation_compose(&within, &beyond, &out) == GJK_ERROR_ROTATION);
  CHECK(gjk2_rotation_compose(NULL, &within, &out) == GJK_ERROR_NULL);
  CHECK(gjk2_rotation_from_angle(1, NULL) == GJK_ERROR_NULL);
  CHECK(out.c == 7 && out.s == 7 && p.x == 5 && p.y == 6);
  CHECK(gjk2_rotation_apply(&within, &v, &p) == GJK_OK);
  CHECK(gjk2_rotation_from_angle(0, &out) == GJK_OK && out.c == GJK_Q30_ONE && out.s == 0);
  const gjk2_vec far = {INT32_MAX, INT32_MIN};
  CHECK(gjk2_rotation_apply(&identity, &far, &p) == GJK_OK && p.x == INT32_MAX && p.y == INT32_MIN);
  const gjk2_pose aside = {{1, 0}, {GJK_Q30_ONE, 0}};
  CHECK(gjk2_pose_apply(&aside, &far, &p) == GJK_ERROR_RANGE);
}

// Posed vertices: within 3/4 LSB and the centre's rounding of their places; baked and lazy alike; the AABB is theirs.
static void check_collider(random_state *r, plane_body *body) {
  const int32_t sizes[] = {1, 3, 40, 65536, 1 << 26};
  plane_random_shape(r, sizes[random_below(r, 5)], body);
  body->pose.rotation = any_rotation(r);
  body->pose.position.x = any_number(r) / 4;
  body->pose.position.y = any_number(r) / 4;
  static plane_body lazy;
  lazy = *body;
  plane_place(&lazy, false);
  plane_place(body, true);
  plane_point vertices[PLANE_VERTICES], others[PLANE_VERTICES];
  const int n = plane_vertices(&body->collider, vertices);
  CHECK(plane_vertices(&lazy.collider, others) == n);
  CHECK(memcmp(vertices, others, (size_t)n * sizeof vertices[0]) == 0);
  const long double size = hypotl(body->pose.rotation.c, body->pose.rotation.s);
  const long double c = body->pose.rotation.c / size, s = body->pose.rotation.s / size;
  for (int i = 0; i < n && body->shape.vertices != NULL; i++) {
    const gjk2_vec v = body->vertices[i];
    CHECK(error_of(vertices[i].x, c * v.x - s * v.y + body->pose.position.x) <= 0.75L);
    CHECK(error_of(vertices[i].y, s * v.x + c * v.y + body->pose.position.y) <= 0.75L);
  }
  gjk2_aabb box;
  CHECK(gjk2_collider_aabb(&lazy.collider, &box) == GJK_OK);
  plane_point low = vertices[0], high = vertices[0];
  for (int i = 0; i < n; i++) {
    low.x = vertices[i].x < low.x ? vertices[i].x : low.x;
    low.y = vertices[i].y < low.y ? vertices[i].y : low.y;
    high.x = vertices[i].x > high.x ? vertices[i].x : high.x;
    high.y = vertices[i].y > high.y ? vertices[i].y : high.y;
    const long double x = vertices[i].x - body->collider.centre.x, y = vertices[i].y - body->collider.centre.y;
    CHECK(hypotl(x, y) <= body->collider.core_radius);
  }
  const gjk_q16 radius = body->shape.convex_radius;
  CHECK(box.lower.x == low.x - radius && box.lower.y == low.y - radius);
  CHECK(box.upper.x == high.x + radius && box.upper.y == high.y + radius);
  // Support along any direction: the same vertex.
  for (int i = 0; i < 4; i++) {
    const gjk2_vec d = {random_range(r, -(1 << (4 * i + 2)), 1 << (4 * i + 2)), random_range(r, -5, 5)};
    gjk2_support x, y;
    if (d.x != 0 || d.y != 0) {
      body->shape.type->support(&body->collider, &d, &x);
      lazy.shape.type->support(&lazy.collider, &d, &y);
      CHECK(x.vertex == y.vertex);
    }
  }
  // A move is a pose.
  gjk2_vec to = {body->pose.position.x + 77, body->pose.position.y - 5};
  CHECK(gjk2_collider_move(&lazy.collider, &to) == GJK_OK);
  CHECK(lazy.collider.centre.x == body->collider.centre.x + 77 &&
        lazy.collider.centre.y == body->collider.centre.y - 5);
  // In order: whatever the pose, the vertices are their hull.
  if (body->collider.ordered) {
    plane_point hull[PLANE_VERTICES + 2];
    CHECK(plane_hull(others, n, hull) == n);
  }
}

static unsigned flat_ordered, flat_bent;

// A corner 1 to 2 LSB below the line through its neighbours. Rounding of the posed vertices may lift it by up to 1.42 LSB: one
// that is in order still is a corner at any pose, and others may not be.
static void check_flat_corner(random_state *r) {
  const int32_t most[] = {8, 100, 10000, 1 << 25};
  const int32_t half = most[random_below(r, 4)],
                along = random_range(r, -half + 1, random_below(r, 2) == 0 ? half : 20);
  const gjk2_vec vertices[4] = {{-half, 0}, {along, -1}, {half, 1}, {0, half}};
  const gjk2_shape shape = GJK2_POLYGON(vertices, 4);
  gjk2_pose pose = GJK2_POSE_IDENTITY;
  gjk2_collider c;
  gjk2_vec posed[4];
  plane_point out[4], hull[6];
  CHECK(gjk2_collider_init(&c, &shape, posed, 4) == GJK_OK);
  flat_ordered += c.ordered;
  for (int i = 0; i < 25; i++) {
    // Near a diagonal, where rounding moves a vertex farthest across the line.
    const gjk_angle turn = (2 * random_range(r, 0, 3) + 1) * GJK_ANGLE(0.78539816) + random_range(r, -300, 300);
    CHECK(gjk2_rotation_from_angle(turn, &pose.rotation) == GJK_OK && gjk2_collider_pose(&c, &pose) == GJK_OK);
    const bool corner = plane_hull(out, plane_vertices(&c, out), hull) == 4;
    CHECK(corner || !c.ordered);
    flat_bent += !corner;
  }
}

static void check_statuses(void) {
  static const gjk2_vec square[4] = {{0, 0}, {9, 0}, {9, 9}, {0, 9}};
  gjk2_vec buffer[5];
  gjk2_collider c;
  const gjk2_shape good = GJK2_POLYGON(square, 4), empty = GJK2_POLYGON(square, 0), none = GJK2_POLYGON(NULL, 4);
  const gjk2_shape negative = GJK2_ROUNDED_BOX(1, 1, -1), inside = GJK2_BOX(-1, 1), large = GJK2_BOX(1 << 28, 1);
  const gjk2_shape most = GJK2_CIRCLE(GJK2_RADIUS_MAX), more = GJK2_CIRCLE(GJK2_RADIUS_MAX + 1);
  gjk2_shape triangle = GJK2_TRIANGLE(square);
  const gjk2_shape ellipse = GJK2_ELLIPSE(1, -1), custom = GJK2_CUSTOM(NULL, NULL, 1);
  memset(&c, 0, sizeof c);
  const gjk2_collider before = c;
  triangle.count = 4;
  CHECK(gjk2_collider_init(NULL, &good, NULL, 0) == GJK_ERROR_NULL);
  CHECK(gjk2_collider_init(&c, NULL, NULL, 0) == GJK_ERROR_NULL);
  CHECK(gjk2_collider_init(&c, &none, NULL, 0) == GJK_ERROR_NULL);
  CHECK(gjk2_collider_init(&c, &custom, NULL, 0) == GJK_ERROR_NULL);
  CHECK(gjk2_collider_init(&c, &empty, NULL, 0) == GJK_ERROR_EMPTY);
  CHECK(gjk2_collider_init(&c, &negative, NULL, 0) == GJK_ERROR_NEGATIVE);
  CHECK(gjk2_collider_init(&c, &inside, NULL, 0) == GJK_ERROR_NEGATIVE);
  CHECK(gjk2_collider_init(&c, &ellipse, NULL, 0) == GJK_ERROR_NEGATIVE);
  CHECK(gjk2_collider_init(&c, &large, NULL, 0) == GJK_ERROR_SIZE);
  CHECK(gjk2_collider_init(&c, &more, NULL, 0) == GJK_ERROR_SIZE);
  CHECK(gjk2_collider_init(&c, &triangle, NULL, 0) == GJK_ERROR_RANGE);
  CHECK(gjk2_collider_init(&c, &good, buffer, 3) == GJK_ERROR_CAPACITY);
  CHECK(gjk2_collider_init(&c, &good, (gjk2_vec *)&c, 4) == GJK_ERROR_OVERLAP);
  CHECK(memcmp(&c, &before, sizeof c) == 0);
  const gjk2_pose identity = GJK2_POSE_IDENTITY, bent = {{0, 0}, {5, 5}};
  gjk2_pose far = identity;
  gjk2_aabb box;
  CHECK(gjk2_collider_pose(&c, &identity) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk2_collider_init(&c, &good, buffer, 4) == GJK_OK);
  CHECK(c.ordered && c.count == 4);
  CHECK(gjk2_collider_move(&c, &identity.position) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk2_collider_aabb(&c, &box) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk2_collider_pose(&c, &bent) == GJK_ERROR_ROTATION);
  far.position.x = INT32_MAX - 3;
  CHECK(gjk2_collider_pose(&c, &far) == GJK_ERROR_RANGE);
  CHECK(gjk2_collider_pose(&c, NULL) == GJK_ERROR_NULL);
  CHECK(gjk2_collider_pose(&c, &identity) == GJK_OK);
  CHECK(gjk2_collider_move(&c, &far.position) == GJK_ERROR_RANGE);
  CHECK(c.centre.x == 4 && c.centre.y == 4);
  CHECK(gjk2_collider_init(&c, &most, NULL, 0) == GJK_OK);
  far.position.x = INT32_MAX;
  CHECK(gjk2_collider_pose(&c, &far) == GJK_OK);
  CHECK(gjk2_collider_aabb(&c, &box) == GJK_OK && box.upper.x == INT32_MAX);
}

int main(void) {
  static plane_body body;
  const uint64_t seed = check_seed(SEED);
  check_refused();
  check_statuses();
  for (unsigned long i = 0; i < TRIALS; i++) {
    random_state r = random_seed(seed + i);
    check_trial(i, NULL, NULL);
    check_rotations(&r);
    check_collider(&r, &body);
    check_flat_corner(&r);
  }
  CHECK(flat_ordered > TRIALS / 20 && flat_bent > TRIALS / 1000);
  printf("%u flat corners in order, %u lost by rounding\n", flat_ordered, flat_bent);
  printf("from angles %Lf, normalised %Lf, composed %Lf, applied %Lf, undone %Lf, inverse %Lf\n", worst[0], worst[1],
         worst[2], worst[3], worst[4], worst[5]);
  return check_done("plane_pose");
}
