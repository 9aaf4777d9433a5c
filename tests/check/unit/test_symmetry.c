// What must not change an answer: the order of vertices, which shape is A, where in the world the pair stands, the
// direction of the axes, and whether a box is written as a box or as a hull.

#include "check.h"
#include "exact/exact.h"
#include "generate/generate.h"
#include "generate/place.h"

#define SEED 3301
#define PAIRS_PER_FAMILY check_trials(1500)
#define SHUFFLES 4
#define PERMUTED_MAX 5  // vertices: all orders of them are tried, 120

// The decisions and the distance of a pair, and the points where it is apart.
typedef struct answer {
  bool posed, far, intersecting, touch, within, beyond, saturated;
  gjk_q16 distance;
  gjk_vec3 centre, point_a, point_b;  // centre: of A
} answer;

typedef struct subject {
  case_pair original, changed;
  case_collider a, b;
  answer expected;
  unsigned long changes, out_of_range, points[2];  // points: with the centre of A beyond 2^30 along an axis, and not
} subject;

static answer find_answer(subject *s, const case_shape *shape_a, const case_shape *shape_b, gjk_q16 distance) {
  const gjk_collider *a = &s->a.collider, *b = &s->b.collider;
  answer found = {0};
  gjk_distance_result r;
  gjk_decision touch, within, beyond;
  found.posed =
      case_collider_build(&s->a, shape_a, false) == GJK_OK && case_collider_build(&s->b, shape_b, false) == GJK_OK;
  if (!found.posed || gjk_distance(a, b, NULL, &r) != GJK_OK || gjk_intersect(a, b, NULL, &touch) != GJK_OK) {
    return found;
  }
  found.far = exact_is_far(a, b);
  distance = distance < 0 ? r.distance : distance;
  CHECK(gjk_within(a, b, distance, NULL, &within) == GJK_OK);
  CHECK(gjk_within(a, b, distance > 0 ? distance - 1 : 0, NULL, &beyond) == GJK_OK);
  found.intersecting = r.intersecting;
  found.distance = r.distance;
  found.centre = a->centre;
  if (!r.intersecting) {
    found.saturated = r.saturated;
    found.point_a = r.point_a;
    found.point_b = r.point_b;
  }
  found.touch = touch.yes;
  found.within = within.yes;
  found.beyond = beyond.yes;
  return found;
}

// If the centres are more than 16384 units apart, each of the two distances is within 2^-28 of the real one.
static bool same(const answer *a, const answer *b) {
  if (a->far) {
    const int64_t difference = (int64_t)a->distance - b->distance, slack = a->distance >> 27;
    return a->intersecting == b->intersecting && a->touch == b->touch && difference <= slack && difference >= -slack;
  }
  return a->intersecting == b->intersecting && a->distance == b->distance && a->touch == b->touch &&
         a->within == b->within && a->beyond == b->beyond;
}

// Are v - w and v0 - w0 the same?
static bool moved_alike(const gjk_vec3 *v, const gjk_vec3 *w, const gjk_vec3 *v0, const gjk_vec3 *w0) {
  return (int64_t)v->x - w->x == (int64_t)v0->x - w0->x && (int64_t)v->y - w->y == (int64_t)v0->y - w0->y &&
         (int64_t)v->z - w->z == (int64_t)v0->z - w0->z;
}

static bool is_beyond(gjk_q16 x) {
  return x > INT32_C(1) << 30 || x < -(INT32_C(1) << 30);
}

// Both shapes were moved by the same way, so a query takes the same steps: the points move by that way, bit for bit.
static void compare_points(subject *s, const answer *found) {
  const answer *was = &s->expected;
  if (found->intersecting || found->saturated || was->saturated) {
    return;
  }
  s->points[is_beyond(found->centre.x) || is_beyond(found->centre.y) || is_beyond(found->centre.z) ? 0 : 1]++;
  CHECK_MSG(moved_alike(&found->point_a, &found->centre, &was->point_a, &was->centre) &&
                moved_alike(&found->point_b, &found->centre, &was->point_b, &was->centre),
            "%s: the points have not moved as the shapes have", s->original.id);
}

// Asks about the changed pair, or about swapped shapes. A change may move a centre out of int32_t.
static answer compare(subject *s, bool swapped, const char *what) {
  const case_shape *a = swapped ? &s->changed.b : &s->changed.a, *b = swapped ? &s->changed.a : &s->changed.b;
  const answer found = find_answer(s, a, b, s->expected.distance);
  if (!found.posed) {
    s->out_of_range++;
    return found;
  }
  const bool equal = same(&found, &s->expected);
  CHECK_MSG(equal, "%s: %s: distance %ld, was %ld", s->original.id, what, (long)found.distance,
            (long)s->expected.distance);
  if (!equal) {
    case_print(stdout, &s->original);
    case_print(stdout, &s->changed);
  }
  s->changes++;
  return found;
}

static void restore(subject *s) {
  case_shape_copy(&s->changed.a, &s->original.a);
  case_shape_copy(&s->changed.b, &s->original.b);
}

static void exchange(gjk_vec3 *v, gjk_vec3 *w) {
  const gjk_vec3 kept = *v;
  *v = *w;
  *w = kept;
}

static void shuffle(random_state *random, case_shape *shape) {
  for (size_t i = shape->count; i > 1; i--) {
    exchange(&shape->vertices[i - 1], &shape->vertices[random_below(random, (uint32_t)i)]);
  }
}

// Heap's algorithm without recursion: calls compare for every order of the vertices of A.
static void try_orders(subject *s) {
  case_shape *shape = &s->changed.a;
  size_t turns[PERMUTED_MAX] = {0};
  for (size_t i = 1; i < shape->count;) {
    if (turns[i] < i) {
      exchange(&shape->vertices[i % 2 == 0 ? 0 : turns[i]], &shape->vertices[i]);
      compare(s, false, "vertices reordered");
      turns[i]++;
      i = 1;
    } else {
      turns[i] = 0;
      i++;
    }
  }
}

static void test_orders(random_state *random, subject *s) {
  if (s->changed.a.count <= PERMUTED_MAX) {
    try_orders(s);
  }
  for (int i = 0; i < SHUFFLES; i++) {
    shuffle(random, &s->changed.a);
    shuffle(random, &s->changed.b);
    compare(s, i % 2 != 0, "vertices shuffled");
  }
}

// Adds as much of `by` as keeps both positions within int32_t.
static void shift(gjk_q16 *a, gjk_q16 *b, int64_t by) {
  const int64_t low = (*a < *b ? *a : *b) + by, high = (*a > *b ? *a : *b) + by;
  const int64_t moved = high > INT32_MAX ? by - (high - INT32_MAX) : low < INT32_MIN ? by + (INT32_MIN - low) : by;
  *a = (gjk_q16)(*a + moved);
  *b = (gjk_q16)(*b + moved);
}

static void compare_moved(subject *s) {
  const answer found = compare(s, false, "both moved");
  if (found.posed) {
    compare_points(s, &found);
  }
}

static void test_translations(random_state *random, subject *s) {
  for (int i = 0; i < SHUFFLES; i++) {
    gjk_vec3 *a = &s->changed.a.pose.position, *b = &s->changed.b.pose.position;
    restore(s);
    shift(&a->x, &b->x, (int32_t)random_u32(random));
    shift(&a->y, &b->y, (int32_t)random_u32(random));
    shift(&a->z, &b->z, (int32_t)random_u32(random));
    compare_moved(s);
    restore(s);  // A's centre to within 2 LSB of 2^30 or -2^30 along x
    const int64_t by = (i % 2 == 0 ? INT64_C(1) << 30 : -(INT64_C(1) << 30)) - s->expected.centre.x;
    shift(&a->x, &b->x, by + (int64_t)random_below(random, 5) - 2);
    compare_moved(s);
  }
}

// Permutes the axes (one of 6 orders) and reverses some (bits). A reversed coordinate p becomes -1 - p, so that all of
// int32_t has an image: a reflection, and a translation that both shapes share.
static gjk_vec3 turn(gjk_vec3 v, unsigned order, unsigned reversed, int32_t offset) {
  const gjk_q16 x[3] = {v.x, v.y, v.z};
  gjk_q16 y[3];
  for (unsigned i = 0; i < 3; i++) {
    const gjk_q16 from = x[(order < 3 ? order + i : order + 3 - i) % 3];
    y[i] = (reversed >> i & 1u) != 0 ? offset - from : from;
  }
  return (gjk_vec3){y[0], y[1], y[2]};
}

static void turn_shape(case_shape *shape, unsigned order, unsigned reversed) {
  shape->pose.position = turn(shape->pose.position, order, reversed, -1);
  for (size_t i = 0; i < shape->count; i++) {
    shape->vertices[i] = turn(shape->vertices[i], order, reversed, 0);
  }
}

// All 48 symmetries of a cube.
static void test_axes(subject *s) {
  for (unsigned order = 0; order < 6; order++) {
    for (unsigned reversed = 0; reversed < 8; reversed++) {
      restore(s);
      turn_shape(&s->changed.a, order, reversed);
      turn_shape(&s->changed.b, order, reversed);
      compare(s, false, "axes turned");
    }
  }
}

static void test_pair(random_state *random, subject *s) {
  s->expected = find_answer(s, &s->original.a, &s->original.b, -1);
  CHECK_MSG(s->expected.posed, "%s", s->original.id);
  restore(s);
  compare(s, true, "A and B swapped");
  test_translations(random, s);
  generate_bake(&s->original.a);
  generate_bake(&s->original.b);
  restore(s);
  compare(s, false, "written as hulls");
  test_orders(random, s);
  test_axes(s);
}

int main(void) {
  static subject s;
  random_state random = random_seed(check_seed(SEED));
  unsigned long pairs = 0;
  for (unsigned i = 0; i < generate_family_count; i++) {
    for (uint64_t k = 0; k < PAIRS_PER_FAMILY; k++) {
      generate_pair(&generate_families[i], check_seed(SEED) + k, &s.original);
      test_pair(&random, &s);
      pairs++;
    }
  }
  printf("%lu pairs, %lu changes, %lu out of range; points of %lu far out, %lu others\n", pairs, s.changes,
         s.out_of_range, s.points[0], s.points[1]);
  CHECK(s.out_of_range < s.changes / 20);
  CHECK(s.changes > 50 * pairs);
  CHECK(s.points[0] > pairs && s.points[1] > pairs);
  case_pair_free(&s.original);
  case_pair_release(&s.changed, &s.a, &s.b);
  return check_done("symmetry");
}
