// Points and segments without a search give what the search gives: every field of every answer but iterations and
// certificate, bit by bit; and each answer has its proof. The search is reached by classes that lack the closed form.
//
// Half of the pairs stand on a small lattice: coincident, collinear, parallel, crossing, touching, without a length.
#include <string.h>

#include "check.h"
#include "generate/polytope.h"
#include "gjk/check.h"
#include "gjk/gjk.h"
#include "placed.h"
#include "same.h"
#include "src/shape/gjk_shape_class.h"

#define PAIRS check_trials(200000)
#define SEED 9700

static gjk_shape_class searched[2];
static gjk_epa_cell cells[64];

typedef struct answers {
  gjk_status pierced, parted, met, stopped;
  gjk_decision near;
  gjk_distance_result gap, until, apart;
  gjk_penetration_result depth;
  gjk_manifold contacts;
} answers;

static void ask(const gjk_collider *a, const gjk_collider *b, const gjk_cache *from, answers *out) {
  const gjk_workspace workspace = {cells, 64};
  const gjk_effort effort = {0, 1};
  gjk_cache c[5];
  for (int i = 0; i < 5; i++) {
    c[i] = *from;
  }
  memset(out, 0, sizeof *out);
  CHECK(gjk_within(a, b, 3, &c[0], &out->near) == GJK_OK);
  CHECK(gjk_distance(a, b, &c[1], &out->gap) == GJK_OK);
  out->pierced = gjk_penetration(a, b, &c[2], &workspace, &out->depth);
  out->parted = gjk_signed_distance(a, b, &c[3], &workspace, &out->apart);
  out->met = gjk_contacts(a, b, 3, GJK_CONTACTS_MAX, &c[4], &workspace, &out->contacts);
  CHECK(gjk_check_decision(a, b, 3, &out->near) == GJK_OK);
  CHECK(gjk_check_distance(a, b, &out->gap) == GJK_OK);
  CHECK(out->pierced != GJK_OK || gjk_check_penetration(a, b, &out->depth) == GJK_OK);
  CHECK(out->apart.intersecting || gjk_check_distance(a, b, &out->apart) == GJK_OK);
  out->stopped = gjk_distance_until(a, b, &effort, NULL, &out->until);
}

// Of shapes that touch gjk_distance reports no points and normal, and of shapes that are apart gjk_penetration nothing.
static bool same_set_gap(const gjk_distance_result *p, const gjk_distance_result *q) {
  return (p->intersecting && q->intersecting && p->distance == 0 && q->distance == 0) || same_gap(p, q);
}

static bool same_set_depth(const gjk_penetration_result *p, const gjk_penetration_result *q) {
  return (!p->intersecting && !q->intersecting) || same_depth(p, q);
}

static gjk_shape make_shape(random_state *random, bool lattice, gjk_q16 size) {
  const gjk_q16 radius = random_below(random, 3) == 0 ? 0 : lattice ? random_range(random, 0, 6) + size / 2 : 2 * size;
  const gjk_q16 half = lattice ? size * random_range(random, 0, 3) : size;
  if (random_below(random, 4) == 0) {
    return (gjk_shape)GJK_SPHERE(radius);
  }
  return (gjk_shape)GJK_CAPSULE(radius, half);
}

static gjk_pose make_pose(random_state *random, bool lattice, gjk_q16 size) {
  static const gjk_q30 h = 759250125;  // sqrt(1/2)
  const gjk_quat turns[4] = {{0, 0, 0, GJK_Q30_ONE}, {h, 0, 0, h}, {0, h, 0, h}, {GJK_Q30_ONE, 0, 0, 0}};
  gjk_pose pose = GJK_POSE_IDENTITY;
  if (lattice) {
    pose.rotation = turns[random_below(random, 4)];
    pose.position.x = size * random_range(random, -3, 3) + random_range(random, -1, 1);
    pose.position.y = size * random_range(random, -3, 3);
    pose.position.z = size * random_range(random, -3, 3);
  } else {
    pose.rotation = generate_rotation(random);
    pose.position = generate_vector(random, 4.0 * size * generate_unit(random));
  }
  return pose;
}

// The search is taken where both shapes lack the closed form.
static gjk_shape without_close(gjk_shape shape) {
  shape.type = shape.type == &gjk_class_point ? &searched[0] : &searched[1];
  return shape;
}

static void check_pairs(void) {
  unsigned touching = 0, edges[4] = {0, 0, 0, 0};
  for (unsigned i = 0; i < PAIRS; i++) {
    random_state random = random_seed(check_seed(SEED) + i);
    check_trial(i, NULL, NULL);
    const bool lattice = i % 2 == 0;
    const gjk_q16 size = lattice ? 1 << random_below(&random, 20) : generate_reach(&random) / 4 + 1;
    const gjk_shape shapes[2] = {make_shape(&random, lattice, size), make_shape(&random, lattice, size)};
    const gjk_shape slow[2] = {without_close(shapes[0]), without_close(shapes[1])};
    const gjk_pose poses[2] = {make_pose(&random, lattice, size), make_pose(&random, lattice, size)};
    gjk_collider a, b, slow_a, slow_b;
    gjk_cache cache = {0};
    answers closed, open;
    a = posed(&shapes[0], &poses[0]);
    b = posed(&shapes[1], &poses[1]);
    slow_a = posed(&slow[0], &poses[0]);
    slow_b = posed(&slow[1], &poses[1]);
    ask(&slow_a, &slow_b, &cache, &open);
    for (int k = 0; k < 4; k++) {
      cache.direction[k % 3] = (int16_t)random_range(&random, -32768, 32767);
      cache.a[k] = (uint16_t)random_below(&random, 4);
      cache.b[k] = (uint16_t)random_below(&random, 4);
    }
    cache.count = (uint16_t)random_below(&random, 5);
    ask(&a, &b, &cache, &closed);
    touching += closed.gap.intersecting;
    edges[closed.gap.certificate.count & 3u] += !closed.gap.intersecting;
    CHECK(closed.near.yes == open.near.yes);
    CHECK(same_set_gap(&closed.gap, &open.gap));
    CHECK(closed.pierced == open.pierced && same_set_depth(&closed.depth, &open.depth));
    CHECK(closed.parted == open.parted && same_set_gap(&closed.apart, &open.apart));
    CHECK(closed.met == open.met && same_manifold(&closed.contacts, &open.contacts));
    // With one iteration the search gives bounds.
    CHECK(closed.stopped == GJK_OK && (open.until.lower < open.until.upper || open.until.intersecting ||
                                       open.until.distance == closed.until.distance));
  }
  printf("%u touching; nearest: %u vertices, %u edges, %u triangles\n", touching, edges[1], edges[2], edges[3]);
  CHECK(touching > PAIRS / 8);
  CHECK(edges[1] > PAIRS / 50 && edges[2] > PAIRS / 50 && edges[3] > PAIRS / 100);
}

int main(void) {
  searched[0] = gjk_class_point;
  searched[1] = gjk_class_segment;
  searched[0].close = searched[1].close = NULL;
  check_pairs();
  return check_done("close");
}
