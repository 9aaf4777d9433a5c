// Edges that cross at any angle, however small, touch where they cross: that point is always among the contacts, and the two
// points of each contact lie opposite each other along the normal.
#include <math.h>

#include "contacts_scene.h"
#include "random.h"

#define SEED 65
#define PAIRS ((int)check_trials(30000))

typedef struct edge {
  double from[3], along[3];
} edge;

// The highest (sign 1) or lowest edge along x of a box turned about x.
static edge edge_of(const gjk_collider *c, int sign) {
  const gjk_vec3 *f = c->frame;
  const double y = f[1].z * sign > 0 ? 1 : -1, z = f[2].z * sign > 0 ? 1 : -1;
  return (edge){{c->centre.x - f[0].x + y * f[1].x + z * f[2].x, c->centre.y - f[0].y + y * f[1].y + z * f[2].y,
                 c->centre.z - f[0].z + y * f[1].z + z * f[2].z},
                {2.0 * f[0].x, 2.0 * f[0].y, 2.0 * f[0].z}};
}

// Where e crosses f seen along z, as a part of e's length, and the sine of their angle.
static double cross_at(const edge *e, const edge *f, double *sine) {
  const double x = f->from[0] - e->from[0], y = f->from[1] - e->from[1];
  const double cross = e->along[0] * f->along[1] - e->along[1] * f->along[0];
  *sine = cross / (hypot(e->along[0], e->along[1]) * hypot(f->along[0], f->along[1]));
  return (x * f->along[1] - y * f->along[0]) / cross;
}

static double aside_of(const gjk_manifold *m, const gjk_contact *c) {
  const double x = (double)c->point_b.x - c->point_a.x, y = (double)c->point_b.y - c->point_a.y,
               z = (double)c->point_b.z - c->point_a.z, nx = ldexp(m->normal.x, -30), ny = ldexp(m->normal.y, -30),
               nz = ldexp(m->normal.z, -30), along = x * nx + y * ny + z * nz;
  return sqrt((x - along * nx) * (x - along * nx) + (y - along * ny) * (y - along * ny) +
              (z - along * nz) * (z - along * nz));
}

typedef struct pair {
  gjk_shape shape_a, shape_b;
  gjk_pose pose_a, pose_b;
  gjk_angle angle;
} pair;

static gjk_q16 part_of(random_state *random, gjk_q16 size, int32_t percent) {
  return (gjk_q16)((int64_t)size * random_range(random, -percent, percent) / 100);
}

// B's lowest edge over A's highest, at an angle of 0.0005 to 0.05 or, of one in ten, less, deep by 8 LSB or apart by up to 300.
static pair make_pair(random_state *random) {
  const gjk_q16 half_a = random_range(random, 3000, 4 * ONE), half_b = random_range(random, 3000, 4 * ONE),
                thick_a = half_a / random_range(random, 2, 30), thick_b = half_b / random_range(random, 2, 30);
  pair p = {GJK_BOX(half_a, thick_a, thick_a), GJK_BOX(half_b, thick_b, thick_b), origin, origin, 0};
  gjk_quat spin;
  p.angle = (random_below(random, 10) == 0 ? random_range(random, 0, 32) : random_range(random, 33, 3277)) *
            (random_below(random, 2) == 0 ? 1 : -1);
  p.pose_a = turned(origin, &axis_x, EIGHTH_TURN);
  CHECK(gjk_quat_from_axis_angle(&axis_z, p.angle, &spin) == GJK_OK);
  CHECK(gjk_quat_compose(&spin, &p.pose_a.rotation, &p.pose_b.rotation) == GJK_OK);
  const gjk_vec3 back = {part_of(random, half_b, 90), 0, 0};
  gjk_vec3 step;
  CHECK(gjk_quat_apply(&p.pose_b.rotation, &back, &step) == GJK_OK);
  p.pose_b.position.x = part_of(random, half_a, 90) - step.x;
  p.pose_b.position.y = -step.y;
  p.pose_b.position.z = (gjk_q16)lround(1.41421356 * ((double)thick_a + thick_b)) +
                        random_range(random, -8, random_below(random, 2) == 0 ? 0 : 300);
  return p;
}

typedef struct tally {
  unsigned long crossings, pairs_of_ends, others;
  double off, aside;
} tally;

static void check_pair(const pair *p, int n, tally *t) {
  gjk_collider a, b;
  gjk_manifold m;
  a = posed(&p->shape_a, &p->pose_a);
  b = posed(&p->shape_b, &p->pose_b);
  CHECK(gjk_contacts(&a, &b, MARGIN, 4, NULL, &workspace, &m) == GJK_OK);
  CHECK(m.count > 0);
  double aside = 0;
  for (unsigned i = 0; i < m.count; i++) {
    aside = fmax(aside, aside_of(&m, &m.contact[i]));
  }
  t->aside = fmax(t->aside, aside);
  CHECK_MSG(aside <= 2, "pair %d: %g LSB aside", n, aside);
  if (m.feature_a < 256 || m.feature_b < 256) {  // a face
    t->others++;
    return;
  }
  const edge e = edge_of(&a, 1), f = edge_of(&b, -1);
  double sine, off = INFINITY, longest = 0;
  const double at = cross_at(&e, &f, &sine);
  for (unsigned i = 0; i < m.count; i++) {
    double far = 0;
    for (unsigned k = 0; k < 3; k++) {
      const gjk_vec3 *point = &m.contact[i].point_a;
      const double x = k == 0 ? point->x : k == 1 ? point->y : point->z, by = x - (e.from[k] + at * e.along[k]);
      far += by * by;
    }
    off = fmin(off, sqrt(far));
    longest = fmax(longest, sqrt(far));
  }
  // Two ends of what they share: the edges are across from each other all the way.
  const bool ends = m.count == 2 && (sine == 0 || longest * fabs(sine) <= 3);
  t->pairs_of_ends += ends;
  t->crossings += !ends;
  // At smaller angles yet, where they cross is a matter of how the nearest point is rounded.
  const double most = fabs(sine) < 0.0005 ? 1 / fabs(sine) : 3;
  t->off = ends || most > 3 ? t->off : fmax(t->off, off);
  CHECK_MSG(ends || (off <= most && m.count == 1), "pair %d at %g rad: the nearest of %u contacts is %g LSB off", n,
            asin(sine), m.count, off);
}

// The crossing alone, where both far ends of what the edges share lie level with it but 0.06 units aside.
static void test_long_boxes(void) {
  const gjk_shape stick = GJK_BOX(ONE, ONE / 20, ONE / 20);
  const gjk_pose edge_up = turned(origin, &axis_x, EIGHTH_TURN);
  pair p = {stick, stick, edge_up, edge_up, GJK_Q16(0.03)};
  gjk_quat spin;
  tally t = {0, 0, 0, 0, 0};
  CHECK(gjk_quat_from_axis_angle(&axis_z, p.angle, &spin) == GJK_OK);
  CHECK(gjk_quat_compose(&spin, &edge_up.rotation, &p.pose_b.rotation) == GJK_OK);
  p.pose_b.position.z = 9267;
  check_pair(&p, -1, &t);
  CHECK(t.crossings == 1);
}

int main(void) {
  random_state random = random_seed(check_seed(SEED));
  tally t = {0, 0, 0, 0, 0};
  test_long_boxes();
  for (int n = 0; n < PAIRS; n++) {
    const pair p = make_pair(&random);
    check_pair(&p, n, &t);
  }
  printf("%lu crossings, at most %.2f LSB off; %lu ends of level edges, %lu with a face; at most %.2f LSB aside\n",
         t.crossings, t.off, t.pairs_of_ends, t.others, t.aside);
  CHECK(t.crossings * 2 > (unsigned long)PAIRS);
  CHECK(t.pairs_of_ends * 1000 > (unsigned long)PAIRS || PAIRS < 10000);
  return check_done("contacts_crossing");
}
