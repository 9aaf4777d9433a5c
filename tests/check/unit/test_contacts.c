// Contact manifolds: scenes worked out by hand, and on random pairs what every manifold must keep to.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "case/case.h"
#include "contacts_scene.h"
#include "random_vec.h"

#define PAIRS ((int)check_trials(60000))

static void test_boxes(void) {
  gjk_manifold m = meet(&box, origin, &box, at(0, 0, 2 * ONE - 100), 4);
  CHECK(has_corners(&m, ONE, -100));
  CHECK(m.feature_a == 4);
  CHECK(m.feature_b == 5);
  CHECK(m.normal.z == GJK_Q30_ONE);
  m = meet(&box, origin, &box, at(0, 0, 2 * ONE + 300), 4);
  CHECK(has_corners(&m, ONE, 300));
  m = meet(&box, origin, &box, at(0, 0, 2 * ONE + MARGIN + 1), 4);
  CHECK(m.count == 0);
  m = meet(&box, origin, &box, at(0, 0, 2 * ONE + MARGIN), 4);
  CHECK(has_corners(&m, ONE, MARGIN));
  // Moved aside by half: what the faces share.
  m = meet(&box, origin, &box, at(ONE, 0, 2 * ONE - 7), 4);
  HAS(m, 4, {0, ONE, -7}, {ONE, -ONE, -7}, {ONE, ONE, -7});
  // Turned by an eighth: an octagon, of which four points far apart are kept on demand.
  const gjk_pose eighth = turned(at(0, 0, 2 * ONE - 50), &axis_z, EIGHTH_TURN);
  const gjk_q16 corner = 27146;  // tan 22.5 degrees
  m = meet(&box, origin, &box, eighth, 8);
  HAS(m, 8, {corner, ONE, -50}, {-ONE, -corner, -50});
  m = meet(&box, origin, &box, eighth, 4);
  CHECK(m.count == 4);
  gjk_q16 low = ONE, high = -ONE;
  for (unsigned i = 0; i < m.count; i++) {
    low = m.contact[i].point_a.x < low ? m.contact[i].point_a.x : low;
    high = m.contact[i].point_a.x > high ? m.contact[i].point_a.x : high;
  }
  CHECK(is_near(low, -ONE, 3));
  CHECK(is_near(high, ONE, 3));
  m = meet(&box, origin, &box, eighth, 1);
  CHECK(m.count == 1);
  CHECK(is_near(m.contact[0].distance, -50, 2));
}

// The same scenes with a hull for the box; without faces it has one point.
static void test_hulls(void) {
  gjk_manifold m = meet(&cube, origin, &box, at(0, 0, 2 * ONE - 100), 4);
  CHECK(has_corners(&m, ONE, -100));
  CHECK(m.feature_a == 1);
  CHECK(m.feature_b == 5);
  m = meet(&cube, turned(origin, &axis_x, QUARTER_TURN), &cube, at(0, 0, 2 * ONE - 100), 4);
  CHECK(has_corners(&m, ONE, -100));
  m = meet(&bare_cube, origin, &box, at(0, 0, 2 * ONE - 100), 4);
  CHECK(m.count == 1);
  CHECK(m.contact[0].distance == -100);
}

static void test_edges(void) {
  const gjk_q16 height = 92682;  // sqrt(2)
  const gjk_pose edge_up = turned(origin, &axis_x, EIGHTH_TURN);
  gjk_manifold m = meet(&box, origin, &box, turned(at(0, 0, ONE + height - 40), &axis_x, EIGHTH_TURN), 4);
  HAS(m, 2, {-ONE, 0, -40}, {ONE, 0, -40});
  m = meet(&box, edge_up, &box, turned(at(HALF, 0, 2 * height + 40), &axis_x, EIGHTH_TURN), 4);
  HAS(m, 2, {-HALF, 0, 40}, {ONE, 0, 40});
  m = meet(&box, edge_up, &box, turned(at(0, 0, 2 * height - 40), &axis_y, EIGHTH_TURN), 4);
  HAS(m, 1, {0, 0, -39});
}

static void test_round_shapes(void) {
  static const gjk_shape ball = GJK_SPHERE(HALF), capsule = GJK_CAPSULE(HALF / 2, HALF),
                         rounded = GJK_ROUNDED_BOX(HALF, HALF, HALF, HALF / 2), cylinder = GJK_CYLINDER(HALF, ONE),
                         cone = GJK_CONE(HALF, ONE), ellipsoid = GJK_ELLIPSOID(HALF, ONE, HALF);
  gjk_manifold m = meet(&box, origin, &ball, at(100, 200, ONE + HALF - 9), 4);
  HAS(m, 1, {100, 200, -9});
  m = meet(&box, origin, &capsule, turned(at(0, 0, ONE + HALF / 2 - 9), &axis_y, QUARTER_TURN), 4);
  HAS(m, 2, {HALF, 0, -9}, {-HALF, 0, -9});
  m = meet(&capsule, turned(origin, &axis_y, QUARTER_TURN), &capsule,
           turned(at(HALF, 0, HALF - 9), &axis_y, QUARTER_TURN), 4);
  HAS(m, 2, {HALF, 0, -9}, {0, 0, -9});
  m = meet(&capsule, turned(origin, &axis_y, QUARTER_TURN), &capsule, turned(at(0, 0, HALF - 9), &axis_x, QUARTER_TURN),
           4);
  HAS(m, 1, {0, 0, -9});
  m = meet(&rounded, origin, &box, at(0, 0, HALF + HALF / 2 + ONE - 77), 4);
  CHECK(has_corners(&m, HALF, -77));
  m = meet(&box, origin, &cylinder, at(0, 0, 2 * ONE - 36), 4);
  HAS(m, 4, {HALF, 0, -36}, {0, -HALF, -36});
  CHECK(m.feature_b == 1);
  m = meet(&box, origin, &cylinder, turned(at(0, 0, ONE + HALF - 36), &axis_y, QUARTER_TURN), 4);
  HAS(m, 2, {ONE, 0, -36}, {-ONE, 0, -36});
  CHECK(m.feature_b == 2);
  m = meet(&box, origin, &cone, at(0, 0, 2 * ONE - 36), 4);
  HAS(m, 4, {-HALF, 0, -36}, {0, HALF, -36});
  m = meet(&box, origin, &ellipsoid, at(7, 8, ONE + HALF - 36), 4);
  CHECK(m.count == 1);
  CHECK(is_near(m.contact[0].distance, -36, 4));
}

// Of points that are about as deep as the deepest one is kept, within 4 LSB of it: the ends of a tilted disc in a coin.
static void test_reduced_deepest(void) {
  static const gjk_shape disc = GJK_ROUNDED_CYLINDER(213063, 756, 9020), coin = GJK_ROUNDED_CYLINDER(49206, 0, 820);
  const gjk_pose tilted = {{-14092, -3172, 0}, {15454, -5824, 0, GJK_Q30_ONE}}, beside = at(2421, 0, 2426);
  gjk_collider a, b;
  gjk_distance_result d;
  a = posed(&disc, &tilted);
  b = posed(&coin, &beside);
  CHECK(gjk_signed_distance(&a, &b, NULL, &workspace, &d) == GJK_OK);
  for (unsigned most = 1; most <= GJK_CONTACTS_MAX; most++) {
    const gjk_manifold m = meet(&disc, tilted, &coin, beside, most);
    CHECK_MSG(m.count <= most, "%ld of %ld", (long)least_of(&m), (long)d.distance);
    CHECK_MSG(is_near(least_of(&m), d.distance, m.count < most ? 2 : 6), "%ld of %ld", (long)least_of(&m),
              (long)d.distance);
  }
}

static double along_normal(const gjk_manifold *m, const gjk_contact *c) {
  return (((double)c->point_b.x - c->point_a.x) * m->normal.x + ((double)c->point_b.y - c->point_a.y) * m->normal.y +
          ((double)c->point_b.z - c->point_a.z) * m->normal.z) /
         1073741824.0;
}

// Two large balls: the points and the depth are rounded each on its own, together by more than 2 LSB.
static void test_large_balls(void) {
  static const gjk_q16 radius = 258961264;
  static const gjk_shape ball = GJK_SPHERE(258961264);
  const gjk_manifold m = meet(&ball, at(-radius, -radius, -radius), &ball, origin, 4);
  CHECK(m.count == 1);
  const double off = fabs(along_normal(&m, &m.contact[0]) - m.contact[0].distance);
  CHECK_MSG(off > 2, "%.3f LSB", off);
  CHECK_MSG(off < 3 + ldexp(fabs((double)m.contact[0].distance), -28), "%.3f LSB", off);
}

static void test_statuses(void) {
  gjk_collider a, b, blank = {0};
  gjk_manifold m, poison;
  memset(&poison, 0xA5, sizeof poison);
  m = poison;
  const gjk_pose near = at(0, 0, ONE);
  a = posed(&bare_cube, &origin);
  b = posed(&bare_cube, &near);
  CHECK(gjk_contacts(NULL, &b, 0, 4, NULL, NULL, &m) == GJK_ERROR_NULL);
  CHECK(gjk_contacts(&a, NULL, 0, 4, NULL, NULL, &m) == GJK_ERROR_NULL);
  CHECK(gjk_contacts(&a, &b, 0, 4, NULL, NULL, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_contacts(&a, &blank, 0, 4, NULL, NULL, &m) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk_contacts(&a, &b, -1, 4, NULL, NULL, &m) == GJK_ERROR_NEGATIVE);
  CHECK(gjk_contacts(&a, &b, 0, 0, NULL, NULL, &m) == GJK_ERROR_RANGE);
  CHECK(gjk_contacts(&a, &b, 0, 9, NULL, NULL, &m) == GJK_ERROR_RANGE);
  CHECK(memcmp(&m, &poison, sizeof m) == 0);
  CHECK(gjk_contacts(&a, &b, 0, 4, NULL, NULL, &m) == GJK_ERROR_CAPACITY);
  CHECK(m.count == 1);
}

static void test_faces(void) {
  static const uint16_t wrong_corner[3] = {0, 1, 8}, three[1] = {3}, two[1] = {2}, many[1] = {17};
  static const gjk_hull_faces none = {NULL, three, 1}, endless = {cube_corners, NULL, 1},
                              beyond = {wrong_corner, three, 1}, short_face = {cube_corners, two, 1},
                              long_face = {cube_corners, many, 1}, empty = {cube_corners, three, 0};
  static const uint16_t back[2] = {4, 3}, back_far[2] = {16, 0};
  static const gjk_hull_faces backwards = {cube_corners, back, 2}, far_back = {cube_corners, back_far, 2};
  const gjk_hull_faces *refused[] = {&beyond, &short_face, &long_face, &backwards, &far_back};
  gjk_collider c = {0};
  gjk_shape shape = cube;
  for (unsigned i = 0; i < 5; i++) {
    shape.faces = refused[i];
    CHECK(gjk_collider_init(&c, &shape, NULL, 0) == GJK_ERROR_RANGE);
  }
  shape.faces = &none;
  CHECK(gjk_collider_init(&c, &shape, NULL, 0) == GJK_ERROR_NULL);
  shape.faces = &endless;
  CHECK(gjk_collider_init(&c, &shape, NULL, 0) == GJK_ERROR_NULL);
  shape.faces = &empty;
  const gjk_manifold m = meet(&shape, origin, &box, at(0, 0, 2 * ONE - 100), 4);
  CHECK(m.count == 1);
}

// How far a point lies outside of a posed box, LSB; negative inside. Rounding has left its half axes a little askew, so its
// faces are taken as they are.
static double outside_box(const gjk_collider *c, const gjk_vec3 *p) {
  const double v[3] = {(double)p->x - c->centre.x, (double)p->y - c->centre.y, (double)p->z - c->centre.z};
  double worst = -1e30;
  for (int i = 0; i < 3; i++) {
    const gjk_vec3 *f = &c->frame[i], *g = &c->frame[(i + 1) % 3], *h = &c->frame[(i + 2) % 3];
    const double n[3] = {(double)g->y * h->z - (double)g->z * h->y, (double)g->z * h->x - (double)g->x * h->z,
                         (double)g->x * h->y - (double)g->y * h->x};
    const double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    const double along = fabs(v[0] * n[0] + v[1] * n[1] + v[2] * n[2]) / length;
    const double half = fabs(f->x * n[0] + f->y * n[1] + f->z * n[2]) / length;
    worst = along - half > worst ? along - half : worst;
  }
  return worst;
}

typedef struct tally {
  unsigned long met[GJK_CONTACTS_MAX + 1], apart, deep, kept;
} tally;

static gjk_pose random_pose(random_state *random, gjk_q16 reach) {
  const gjk_quat q = {random_range(random, -1000, 1000), random_range(random, -1000, 1000),
                      random_range(random, -1000, 1000), random_range(random, 1, 1001)};
  gjk_pose pose = GJK_POSE_IDENTITY;
  if (random_below(random, 3) != 0) {
    gjk_quat_normalize(&q, &pose.rotation);
  }
  pose.position = random_in_cube(random, reach);
  return pose;
}

// The same features and ids after a motion of an LSB or three, unless a point has come or gone.
static bool is_kept(const gjk_manifold *before, const gjk_manifold *after) {
  if (before->count != after->count || before->feature_a != after->feature_a || before->feature_b != after->feature_b) {
    return false;
  }
  for (unsigned i = 0; i < before->count; i++) {
    if (before->contact[i].id != after->contact[i].id) {
      return false;
    }
  }
  return true;
}

// How much above the least distance the points may be: some may have been left out.
static gjk_q16 room_of(const gjk_manifold *m, unsigned most) {
  return m->count < most ? 3 : 3 + 4;
}

static void check_pair(const gjk_collider *a, const gjk_collider *b, gjk_q16 margin, unsigned most, tally *t, int n) {
  gjk_manifold m, mirrored;
  gjk_distance_result d;
  CHECK_MSG(gjk_contacts(a, b, margin, most, NULL, &workspace, &m) == GJK_OK, "pair %d", n);
  CHECK_MSG(gjk_signed_distance(a, b, NULL, &workspace, &d) == GJK_OK, "pair %d", n);
  CHECK_MSG((m.count > 0) == (d.distance <= margin), "pair %d: %d contacts", n, m.count);
  CHECK_MSG(m.count <= most, "pair %d: %d contacts", n, m.count);
  t->apart += m.count == 0;
  t->deep += m.count > 0 && d.distance < 0;
  t->met[m.count]++;
  if (m.count == 0) {
    return;
  }
  const gjk_q16 least = least_of(&m);
  for (unsigned i = 0; i < m.count; i++) {
    const gjk_contact *c = &m.contact[i];
    CHECK_MSG(c->distance <= margin, "pair %d: %ld, %g", n, (long)c->distance, along_normal(&m, c));
    CHECK_MSG(fabs(along_normal(&m, c) - c->distance) <= 3, "pair %d: %ld, %g", n, (long)c->distance,
              along_normal(&m, c));
    CHECK_MSG(outside_box(a, &c->point_a) <= 3, "pair %d: %g %g outside", n, outside_box(a, &c->point_a),
              outside_box(b, &c->point_b));
    CHECK_MSG(outside_box(b, &c->point_b) <= 3, "pair %d: %g %g outside", n, outside_box(a, &c->point_a),
              outside_box(b, &c->point_b));
    for (unsigned k = 0; k < i; k++) {
      CHECK_MSG(m.contact[k].id != c->id, "pair %d: id twice", n);
    }
  }
  CHECK_MSG(is_near(least, d.distance, room_of(&m, most)), "pair %d: %ld instead of %ld", n, (long)least,
            (long)d.distance);
  // The other way around: as deep, whichever of two equally near ways out it takes.
  CHECK_MSG(gjk_contacts(b, a, margin, most, NULL, &workspace, &mirrored) == GJK_OK, "pair %d mirrored", n);
  CHECK_MSG(mirrored.count > 0, "pair %d mirrored", n);
  CHECK_MSG(is_near(least_of(&mirrored), least, room_of(&m, most)), "pair %d mirrored", n);
}

static void test_random(void) {
  random_state random = random_seed(check_seed(61));
  static case_posed shown;
  tally t = {0};
  unsigned long moved = 0;
  for (int n = 0; n < PAIRS; n++) {
    gjk_collider a, b;
    const gjk_shape shape_a =
        GJK_BOX(random_range(&random, 6000, ONE), random_range(&random, 6000, ONE), random_range(&random, 6000, ONE));
    const gjk_shape shape_b =
        GJK_BOX(random_range(&random, 6000, ONE), random_range(&random, 6000, ONE), random_range(&random, 6000, ONE));
    const gjk_pose pose_a = random_pose(&random, ONE), pose_b = random_pose(&random, ONE);
    const unsigned most = random_below(&random, 2) == 0 ? 4 : 8;
    const gjk_q16 margin = random_range(&random, 0, 5000);
    const case_posed now = {shape_a, shape_b, pose_a, pose_b};
    shown = now;
    check_trial((unsigned long)n, case_show_posed, &shown);
    a = posed(&shape_a, &pose_a);
    b = posed(&shape_b, &pose_b);
    check_pair(&a, &b, margin, most, &t, n);
    gjk_manifold before, after;
    if (gjk_contacts(&a, &b, margin, 8, NULL, &workspace, &before) == GJK_OK && before.count > 0) {
      gjk_vec3 position = pose_b.position;
      position.x += random_range(&random, -3, 3);
      position.y += random_range(&random, -3, 3);
      CHECK(gjk_collider_move(&b, &position) == GJK_OK);
      CHECK(gjk_contacts(&a, &b, margin, 8, NULL, &workspace, &after) == GJK_OK);
      moved++;
      t.kept += is_kept(&before, &after);
    }
  }
  printf("%d pairs, %lu apart, %lu deep; contacts 1: %lu, 2: %lu, 3: %lu, 4: %lu, 5 to 8: %lu; kept %lu of %lu\n",
         PAIRS, t.apart, t.deep, t.met[1], t.met[2], t.met[3], t.met[4], t.met[5] + t.met[6] + t.met[7] + t.met[8],
         t.kept, moved);
  const unsigned long few = (unsigned long)PAIRS / 600;
  CHECK(t.apart * 20 > (unsigned long)PAIRS);
  CHECK(t.deep * 5 > (unsigned long)PAIRS);
  CHECK(t.met[1] > few);
  CHECK(t.met[2] > few);
  CHECK(t.met[3] > few);
  CHECK(t.met[4] > few);
  CHECK(t.met[5] + t.met[6] + t.met[7] + t.met[8] > few);
  // A point at the margin comes and goes now and then.
  CHECK(t.kept * 50 > moved * 49);
}

int main(void) {
  test_boxes();
  test_hulls();
  test_edges();
  test_round_shapes();
  test_reduced_deepest();
  test_large_balls();
  test_statuses();
  test_faces();
  test_random();
  return check_done("contacts");
}
