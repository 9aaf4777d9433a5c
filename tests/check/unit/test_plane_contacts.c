// gjk2_contacts: points on the surfaces, opposite each other, the least distance among them, two where
// edges meet, and ids that hold still.
#include "placed2.h"
#include "plane.h"
#include "plane_same.h"

#define SEED 2004
#define TRIALS check_trials(40000)
#define RESTS check_trials(4000)

static struct {
  unsigned long none, one, two, kept, lost;
  long double off, askew, gap;
} tally;

static long double off_surface(const gjk2_collider *c, const gjk2_vec *point) {
  const gjk_q16 radius = c->shape->convex_radius;
  return radius == 0 ? plane_boundary_distance(c, point, NULL) : plane_distance_from(c, point) - radius;
}

static long double larger(long double x, long double y) {
  return x > y ? x : y;
}

static void check_contact(const plane_body *pair, const gjk2_manifold *m, const gjk2_contact *c, bool nearest) {
  const long double nx = ldexpl(m->normal.x, -30), ny = ldexpl(m->normal.y, -30);
  const long double x = (long double)c->point_b.x - c->point_a.x, y = (long double)c->point_b.y - c->point_a.y;
  const long double gap = x * nx + y * ny, askew = fabsl(y * nx - x * ny);
  const long double slack = nearest ? 3 + ldexpl(fabsl(gap), -28) : 2;
  CHECK_MSG(fabsl(gap - c->distance) <= slack, "gap %Lf, distance %d", gap, c->distance);
  CHECK_MSG(askew <= 3 + ldexpl(fabsl(gap), -28), "%Lf askew", askew);
  for (int i = 0; i < 2; i++) {
    const long double off = off_surface(&pair[i].collider, i == 0 ? &c->point_a : &c->point_b);
    CHECK_MSG(off <= 4, "%Lf off", off);
    tally.off = larger(tally.off, off);
  }
  tally.askew = larger(tally.askew, askew);
  tally.gap = larger(tally.gap, fabsl(gap - c->distance));
}

static void check_pair(random_state *r, const plane_body *pair) {
  const gjk2_collider *a = &pair[0].collider, *b = &pair[1].collider;
  gjk2_manifold m, first;
  gjk2_distance_result nearest;
  const gjk_q16 margin = random_below(r, 2) == 0 ? 0 : (gjk_q16)random_below(r, UINT32_C(1) << random_below(r, 28));
  CHECK(gjk2_signed_distance(a, b, NULL, &nearest) == GJK_OK);
  CHECK(gjk2_contacts(a, b, margin, 2, NULL, &m) == GJK_OK);
  CHECK((m.count > 0) == (nearest.distance <= margin));
  CHECK(m.count <= 2);
  gjk_q16 least = INT32_MAX;
  for (int i = 0; i < m.count; i++) {
    check_contact(pair, &m, &m.contact[i], m.contact[i].distance == nearest.distance);
    CHECK(m.contact[i].distance <= margin || m.count == 1);
    least = m.contact[i].distance < least ? m.contact[i].distance : least;
  }
  CHECK_MSG(m.count == 0 || (least >= nearest.distance - 2 && least <= nearest.distance + 2), "%d, nearest %d", least,
            nearest.distance);
  CHECK(m.count < 2 || m.contact[0].id != m.contact[1].id);
  CHECK(gjk2_contacts(a, b, margin, 1, NULL, &first) == GJK_OK);
  CHECK(first.count == (m.count > 0));
  CHECK(m.count == 0 || first.contact[0].distance == least);
  tally.none += m.count == 0;
  tally.one += m.count == 1;
  tally.two += m.count == 2;
}

static void pose_at(plane_body *body, int32_t x, int32_t y, gjk_angle turn) {
  body->pose.position.x = x;
  body->pose.position.y = y;
  CHECK(gjk2_rotation_from_angle(turn, &body->pose.rotation) == GJK_OK);
  plane_place(body, true);
}

// A box that rests on another, congruent or aside, and trembles by an LSB and by 1e-7 radian.
static void check_rest(random_state *r, plane_body *pair) {
  const gjk_q16 x = random_range(r, 20000, 90000), y = random_range(r, 20000, 90000);
  pair[0].shape = (gjk2_shape)GJK2_BOX(x, y);
  pair[1].shape = (gjk2_shape)GJK2_BOX(random_below(r, 2) == 0 ? x : x / 2, y);
  const int32_t aside = random_below(r, 3) == 0 ? random_range(r, -x, x) : 0;
  gjk2_manifold now, before;
  for (int tick = 0; tick < 8; tick++) {
    const gjk2_rotation tremble = {GJK_Q30_ONE, random_range(r, -107, 107)};
    pose_at(&pair[0], 1000, -2000, 0);
    pose_at(&pair[1], 1000 + aside + random_range(r, -1, 1), -2000 + 2 * y - 3 + random_range(r, -1, 1), 0);
    pair[1].pose.rotation = tremble;
    plane_place(&pair[1], true);
    CHECK(gjk2_contacts(&pair[0].collider, &pair[1].collider, 655, 2, NULL, &now) == GJK_OK);
    CHECK(now.count == 2);
    for (int i = 0; i < 2 && tick > 0; i++) {
      const bool kept = now.contact[i].id == before.contact[0].id || now.contact[i].id == before.contact[1].id;
      tally.kept += kept;
      tally.lost += !kept;
    }
    before = now;
  }
}

// A 45 degree corner on a face: one contact. A capsule on a box: two. A circle: one.
static void check_kinds(plane_body *pair) {
  const gjk2_shape box = GJK2_BOX(65536, 65536), ball = GJK2_CIRCLE(65536), capsule = GJK2_CAPSULE(30000, 65536);
  gjk2_manifold m;
  pair[0].shape = box;
  pose_at(&pair[0], 0, 0, 0);
  pair[1].shape = box;
  pose_at(&pair[1], 0, 65536 + 92000, GJK_ANGLE(0.7853981633974483));
  CHECK(gjk2_contacts(&pair[0].collider, &pair[1].collider, 655, 2, NULL, &m) == GJK_OK);
  CHECK(m.count == 1);
  CHECK(m.contact[0].id >> 8 == 255);
  CHECK((m.contact[0].id & 255) < 4);
  pair[1].shape = capsule;
  pose_at(&pair[1], 0, 65536 + 29900, 0);
  CHECK(gjk2_contacts(&pair[0].collider, &pair[1].collider, 655, 2, NULL, &m) == GJK_OK);
  CHECK(m.count == 2);
  CHECK(m.contact[0].distance == -100 && m.contact[1].distance == -100);
  pair[1].shape = ball;
  pose_at(&pair[1], 0, 65536 + 65436, 0);
  CHECK(gjk2_contacts(&pair[0].collider, &pair[1].collider, 655, 2, NULL, &m) == GJK_OK);
  CHECK(m.count == 1);
  CHECK(m.contact[0].distance == -100);
  CHECK(m.normal.x == 0 && m.normal.y == GJK_Q30_ONE);
  CHECK(m.feature_b == 0);
}

// Large polygons face to face: their contacts are the same with their corners posed in a buffer and without one.
static void check_buffers(random_state *r, plane_body *pair) {
  const int32_t s = random_range(r, INT32_C(1) << 24, INT32_C(1) << 27), h = s / 2;
  const gjk2_vec corner[5] = {{-s, 0}, {s, 0}, {s, h}, {0, s}, {-s, h}};
  gjk2_manifold with, without;
  gjk2_vec down;
  for (int i = 0; i < 2; i++) {
    memcpy(pair[i].vertices, corner, sizeof corner);
    pair[i].shape = (gjk2_shape)GJK2_POLYGON(pair[i].vertices, 5);
    if (i == 0) {
      pair[i].pose.rotation = plane_random_rotation(r);
    } else {
      pair[i].pose.rotation.c = -pair[0].pose.rotation.c;
      pair[i].pose.rotation.s = -pair[0].pose.rotation.s;
    }
    const gjk2_pose turn = {{0, 0}, pair[0].pose.rotation};
    const gjk2_vec below = {random_range(r, -h, h), random_range(r, -9, 9)};
    CHECK(gjk2_pose_apply(&turn, &below, &down) == GJK_OK);
    pair[i].pose.position.x = i == 0 ? 0 : down.x;
    pair[i].pose.position.y = i == 0 ? 0 : down.y;
    plane_place(&pair[i], true);
  }
  CHECK(gjk2_contacts(&pair[0].collider, &pair[1].collider, 99, 2, NULL, &with) == GJK_OK && with.count == 2);
  plane_place(&pair[0], false);
  plane_place(&pair[1], false);
  CHECK(gjk2_contacts(&pair[0].collider, &pair[1].collider, 99, 2, NULL, &without) == GJK_OK);
  CHECK(same_manifold(&with, &without));
}

// Boxes so far apart that faces are not matched: one contact, of the nearest points.
static void check_far(void) {
  const gjk2_shape box = GJK2_BOX(1000, 1000);
  const gjk2_collider a = placed2(&box, -(INT32_C(1) << 29), 0), b = placed2(&box, INT32_C(1) << 29, 0);
  gjk2_manifold m;
  CHECK(gjk2_contacts(&a, &b, INT32_MAX, 2, NULL, &m) == GJK_OK && m.count == 1);
  CHECK(m.contact[0].distance == (INT32_C(1) << 30) - 2000 && m.normal.x >= GJK_Q30_ONE - 2);
  CHECK(m.contact[0].point_a.x == a.centre.x + 1000 && m.contact[0].point_b.x == b.centre.x - 1000);
}

static void check_arguments(const plane_body *pair) {
  gjk2_manifold m, before;
  const gjk2_collider *a = &pair[0].collider, *b = &pair[1].collider;
  gjk2_collider raw = {0};
  memset(&m, 7, sizeof m);
  before = m;
  CHECK(gjk2_contacts(NULL, b, 0, 2, NULL, &m) == GJK_ERROR_NULL);
  CHECK(gjk2_contacts(a, b, 0, 2, NULL, NULL) == GJK_ERROR_NULL);
  CHECK(gjk2_contacts(a, &raw, 0, 2, NULL, &m) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk2_contacts(a, b, -1, 2, NULL, &m) == GJK_ERROR_NEGATIVE);
  CHECK(gjk2_contacts(a, b, 0, 0, NULL, &m) == GJK_ERROR_RANGE);
  CHECK(gjk2_contacts(a, b, 0, 3, NULL, &m) == GJK_ERROR_RANGE);
  CHECK(memcmp(&m, &before, sizeof m) == 0);
}

int main(void) {
  static plane_body pair[2];
  const int32_t sizes[] = {1, 2, 3, 8, 40, 1000, 65536, 1 << 22, 1 << 26};
  const uint64_t seed = check_seed(SEED);
  check_kinds(pair);
  check_arguments(pair);
  check_far();
  for (unsigned long i = 0; i < TRIALS; i++) {
    random_state r = random_seed(seed + i);
    const int32_t size = sizes[random_below(&r, 9)];
    check_trial(i, plane_print, pair);
    plane_random_pair(&r, size, (int32_t)((int64_t)size * random_range(&r, 0, 4) / 2), pair);
    check_pair(&r, pair);
  }
  for (unsigned long i = 0; i < RESTS; i++) {
    random_state r = random_seed(~(seed + i));
    check_trial(i, plane_print, pair);
    check_rest(&r, pair);
    check_buffers(&r, pair);
  }
  printf("none %lu, one %lu, two %lu; off %Lf, askew %Lf, gap %Lf; ids kept %lu, lost %lu\n", tally.none, tally.one,
         tally.two, tally.off, tally.askew, tally.gap, tally.kept, tally.lost);
  CHECK(tally.none > TRIALS / 10 && tally.one > TRIALS / 10 && tally.two > TRIALS / 50);
  CHECK(tally.lost * 100 <= tally.kept);
  return check_done("plane_contacts");
}
