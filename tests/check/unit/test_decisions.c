// Decisions whose truth is known without a certificate: by the way the pair was made, or by brute force over a lattice.
#include <string.h>

#include "check.h"
#include "exact/exact.h"
#include "generate/generate.h"

#define SEED 4471
#define SMALLEST_PAIRS ((int)check_trials(4000))

typedef struct subject {
  case_pair pair;
  case_collider a, b;
} subject;

static void show_if(bool failed, const case_pair *pair) {
  if (failed) {
    case_print(stdout, pair);
  }
}

static bool intersects(const subject *s) {
  gjk_decision d = {0};
  CHECK(gjk_intersect(&s->a.collider, &s->b.collider, NULL, &d) == GJK_OK);
  return d.yes;
}

static bool is_within(const subject *s, gjk_q16 distance) {
  gjk_decision d = {0};
  CHECK(gjk_within(&s->a.collider, &s->b.collider, distance, NULL, &d) == GJK_OK);
  return d.yes;
}

static gjk_distance_result distance_of(const subject *s) {
  gjk_distance_result r = {0};
  CHECK(gjk_distance(&s->a.collider, &s->b.collider, NULL, &r) == GJK_OK);
  return r;
}

// The gap is at most 1 / |normal|, so the sign of one determinant that is -1, 0 or 1 decides. Thin shapes have no
// inside to overlap with: they intersect only at 0.
static bool contact_is_right(const subject *s, const generate_height *height, bool thick) {
  const bool meet = thick ? height->side <= 0 : height->side == 0;
  const gjk_distance_result r = distance_of(s);
  return intersects(s) == meet && is_within(s, 0) == meet && r.intersecting == meet && r.distance == 0 &&
         is_within(s, 1);
}

// The gap is next to level / 2. If that is an integer, it decides "within" and contact at the convex radii; if it is a
// half, the reported distance steps there.
static bool level_is_right(subject *s, const generate_height *height) {
  const gjk_q16 below = (gjk_q16)(height->level / 2);
  if (height->level % 2 != 0) {
    const gjk_q16 rounded = height->side >= 0 ? below + 1 : below;
    return distance_of(s).distance == rounded && !is_within(s, below) && is_within(s, below + 1);
  }
  bool right =
      is_within(s, below) == (height->side <= 0) && !is_within(s, below - 1) && distance_of(s).distance == below;
  s->pair.a.convex_radius = below / 3;
  s->pair.b.convex_radius = below - below / 3;
  CHECK(case_pair_build(&s->pair, false, &s->a, &s->b));
  return right && intersects(s) == (height->side <= 0) && distance_of(s).intersecting == (height->side <= 0);
}

typedef struct tally {
  unsigned long pairs, below, above;
  unsigned bits;
} tally;

static void check_smallest(random_state *random, subject *s, generate_contact contact, tally *t) {
  const int64_t level = random_below(random, 2) == 0 ? 0 : random_range(random, 2, 40);
  const bool thick = random_below(random, 2) == 0;
  generate_height height;
  generate_smallest(random, contact, level, thick, &s->pair, &height);
  snprintf(s->pair.id, sizeof s->pair.id, "smallest-%d-%lu", (int)contact, t->pairs);
  bool right = case_pair_build(&s->pair, false, &s->a, &s->b);
  if (right) {
    right = level == 0 ? contact_is_right(s, &height, thick) : level_is_right(s, &height);
  }
  CHECK_MSG(right, "%s: level %d, side %d, thick %d", s->pair.id, (int)level, height.side, (int)thick);
  show_if(!right, &s->pair);
  t->pairs++;
  t->below += height.side < 0;
  t->above += height.side > 0;
  t->bits = height.bits > t->bits ? height.bits : t->bits;
}

// The normal of two edges has up to 58 bits, whether they are of one shape or of both; if both shapes have a face, 60.
static void test_smallest(random_state *random, subject *s, generate_contact contact, unsigned bits) {
  tally t = {0, 0, 0, 0};
  for (int i = 0; i < SMALLEST_PAIRS; i++) {
    check_smallest(random, s, contact, &t);
  }
  printf("contact %d: %lu pairs, %lu below, %lu above, normals of up to %u bits\n", (int)contact, t.pairs, t.below,
         t.above, t.bits);
  CHECK(t.pairs < 1000 || (t.below > t.pairs * 3 / 10 && t.above > t.pairs * 3 / 10));
  CHECK_MSG(t.pairs < 1000 || t.bits >= bits, "%u bits", t.bits);
}

static bool equals_brute(const subject *s, unsigned long *together) {
  const gjk_collider *a = &s->a.collider, *b = &s->b.collider;
  exact_truth truth;
  exact_brute(a, b, &truth);
  const gjk_distance_result r = distance_of(s);
  bool right =
      r.distance == exact_truth_distance(&truth, a, b) && r.intersecting == exact_truth_within(&truth, a, b, 0);
  for (gjk_q16 distance = 0; distance <= 4; distance++) {
    right = right && is_within(s, distance) == exact_truth_within(&truth, a, b, distance);
  }
  *together += r.intersecting;
  return right && intersects(s) == r.intersecting;
}

static void set_hull(case_shape *shape, const gjk_vec3 *vertices, size_t count) {
  case_shape_reset(shape);
  shape->kind = CASE_HULL;
  case_shape_set_count(shape, count);
  memcpy(shape->vertices, vertices, count * sizeof *vertices);
}

static gjk_vec3 lattice_point(unsigned number) {
  return (gjk_vec3){(gjk_q16)(number & 3) - 1, (gjk_q16)(number >> 2 & 3) - 1, (gjk_q16)(number >> 4 & 3) - 1};
}

// Every segment between points of a 4 x 4 x 4 lattice, also degenerate ones, against small shapes in its middle.
static void test_lattice(subject *s) {
  static const struct {
    gjk_vec3 vertices[5];
    size_t count;
    gjk_q16 convex_radius;
  } shapes[] = {
      {.vertices = {{0, 0, 0}}, .count = 1, .convex_radius = 1},
      {.vertices = {{0, 0, 0}, {1, 1, 1}}, .count = 2},
      {.vertices = {{0, 0, 0}, {1, 0, 1}, {0, 1, 1}}, .count = 3},
      {.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, .count = 4},
      {.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, .count = 4, .convex_radius = 1},
      {.vertices = {{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, .count = 4},
      {.vertices = {{0, 0, 0}, {0, 0, 0}, {1, 1, 2}, {2, 0, 1}, {1, 1, 1}}, .count = 5},
  };
  unsigned long pairs = 0, together = 0;
  for (size_t k = 0; k < sizeof shapes / sizeof shapes[0]; k++) {
    set_hull(&s->pair.a, shapes[k].vertices, shapes[k].count);
    s->pair.a.convex_radius = shapes[k].convex_radius;
    for (unsigned i = 0; i < 64; i++) {
      for (unsigned j = i; j < 64; j++) {
        const gjk_vec3 ends[2] = {lattice_point(i), lattice_point(j)};
        set_hull(&s->pair.b, ends, 2);
        snprintf(s->pair.id, sizeof s->pair.id, "lattice-%lu-%u-%u", (unsigned long)k, i, j);
        const bool right = case_pair_build(&s->pair, false, &s->a, &s->b) && equals_brute(s, &together);
        CHECK_MSG(right, "%s", s->pair.id);
        show_if(!right, &s->pair);
        pairs++;
      }
    }
  }
  printf("%lu lattice pairs, %lu together\n", pairs, together);
  CHECK(together > pairs / 10);
  CHECK(together < pairs * 9 / 10);
}

int main(void) {
  static subject s;
  random_state random = random_seed(check_seed(SEED));
  test_smallest(&random, &s, GENERATE_FACE_VERTEX, 58);
  test_smallest(&random, &s, GENERATE_FACE_FACE, 60);
  test_smallest(&random, &s, GENERATE_EDGE_EDGE, 58);
  test_lattice(&s);
  case_pair_release(&s.pair, &s.a, &s.b);
  return check_done("decisions");
}
