// Depths of boxes, segments and points against all 15 planes, measured one by one in exact integers: the least by
// height and number is the one reported, whatever the cache holds; and the cheap bounds of heights hold.
#include <math.h>
#include <string.h>

#include "check.h"
#include "exact/depth.h"
#include "exact/integer.h"
#include "gjk/gjk.h"
#include "random.h"
#include "src/depth/gjk_box_heights.h"
#include "src/gjk/gjk_frame.h"

#define SEED 20261124
#define TRIALS check_trials(200000)
#define CHECK_EVERY 16

static const gjk_shape point = GJK_SPHERE(0);
static random_state now;
static gjk_shape shapes[2];
static gjk_collider a, b;
static unsigned long overlaps, apart, flat, ties, edges, unique;

// A plane that may bound A - B, in LSB: its height is along / |n|.
typedef struct plane {
  bool is;
  int64_t n[3];
  exact_int along, squared;
  double height;  // within 2^-16
} plane;

static int32_t random_length(void) {
  switch (random_below(&now, 8)) {
    case 0: return 0;
    case 1: return 65536;
    case 2: return (int32_t)random_below(&now, 4);
    case 3: return random_range(&now, 1, INT32_C(1) << random_below(&now, 28));
    default: return random_range(&now, 20000, 100000);
  }
}

static void random_shape(gjk_shape *shape) {
  static const gjk_shape box = GJK_BOX(0, 0, 0), segment = GJK_CAPSULE(0, 0);
  const unsigned kind = random_below(&now, 8);
  *shape = kind == 0 ? point : kind == 1 ? segment : box;
  if (kind > 0) {
    shape->size.z = random_length();
  }
  if (kind > 1) {
    shape->size.x = random_below(&now, 3) == 0 ? shape->size.z : random_length();
    shape->size.y = random_below(&now, 3) == 0 ? shape->size.x : random_length();
  }
}

static gjk_quat random_turn(void) {
  gjk_quat q = {0, 0, 0, GJK_Q30_ONE};
  gjk_vec3 axis = {random_range(&now, -1, 1), random_range(&now, -1, 1), random_range(&now, -1, 1)};
  switch (random_below(&now, 4)) {
    case 0: break;
    case 1: gjk_quat_from_euler(102944 * random_range(&now, 0, 3), 102944 * random_range(&now, 0, 3), 0, &q); break;
    case 2: (void)gjk_quat_from_axis_angle(&axis, random_range(&now, -200000, 200000), &q); break;
    default:
      q.x = random_range(&now, -GJK_Q30_ONE, GJK_Q30_ONE);
      q.y = random_range(&now, -GJK_Q30_ONE, GJK_Q30_ONE);
      q.z = random_range(&now, -GJK_Q30_ONE, GJK_Q30_ONE);
      (void)gjk_quat_normalize(&q, &q);
      break;
  }
  return q;
}

static int32_t random_offset(int32_t reach) {
  switch (random_below(&now, 4)) {
    case 0: return 0;
    case 1: return reach;
    case 2: return reach - random_range(&now, -3, 300);
    default: return random_range(&now, -reach, reach);
  }
}

// Poses the pair: turned alike, nearly alike or at random, and moved along A's axes.
static void random_pair(void) {
  gjk_pose pose_a = {{0, 0, 0}, random_turn()}, pose_b = pose_a;
  random_shape(&shapes[0]);
  random_shape(&shapes[1]);
  if (random_below(&now, 4) == 0) {
    shapes[1] = shapes[0];
  }
  const unsigned turned = random_below(&now, 4);
  if (turned == 0) {
    pose_b.rotation = random_turn();
  } else if (turned == 1) {
    const gjk_vec3 axis = {random_range(&now, -9, 9), random_range(&now, -9, 9), random_range(&now, 1, 9)};
    gjk_quat little;
    (void)gjk_quat_from_axis_angle(&axis, random_range(&now, 0, 150) >> random_below(&now, 8), &little);
    (void)gjk_quat_compose(&little, &pose_a.rotation, &pose_b.rotation);
  }
  const gjk_vec3 offset = {random_offset(shapes[0].size.x + shapes[1].size.x),
                           random_offset(shapes[0].size.y + shapes[1].size.y),
                           random_offset(shapes[0].size.z + shapes[1].size.z)};
  if (random_below(&now, 4) == 0) {
    pose_a.position.x = random_range(&now, -GJK_Q30_ONE, GJK_Q30_ONE);
    pose_a.position.y = random_range(&now, -GJK_Q30_ONE, GJK_Q30_ONE);
  }
  (void)gjk_pose_apply(&pose_a, &offset, &pose_b.position);
  memset(&a, 0, sizeof a);
  memset(&b, 0, sizeof b);
  CHECK(gjk_collider_init(&a, &shapes[0], NULL, 0) == GJK_OK && gjk_collider_init(&b, &shapes[1], NULL, 0) == GJK_OK);
  CHECK(gjk_collider_pose(&a, &pose_a) == GJK_OK && gjk_collider_pose(&b, &pose_b) == GJK_OK);
}

static void print_pair(const void *subject) {
  (void)subject;
  const gjk_collider *const of[2] = {&a, &b};
  for (int s = 0; s < 2; s++) {
    printf("  %u half axes at %ld %ld %ld:", of[s]->count, (long)of[s]->centre.x, (long)of[s]->centre.y,
           (long)of[s]->centre.z);
    for (unsigned k = 0; k < of[s]->count; k++) {
      printf(" (%ld %ld %ld)", (long)of[s]->frame[k].x, (long)of[s]->frame[k].y, (long)of[s]->frame[k].z);
    }
    printf("\n");
  }
}

static const unsigned half_axes[15][2] = {{1, 2}, {2, 0}, {0, 1}, {4, 5}, {5, 3}, {3, 4}, {0, 3}, {0, 4},
                                          {0, 5}, {1, 3}, {1, 4}, {1, 5}, {2, 3}, {2, 4}, {2, 5}};

static exact_int exact_size(const int64_t n[3], const gjk_vec3 *v) {
  const int64_t of_v[3] = {v->x, v->y, v->z};
  exact_int sum = exact_from(0);
  for (int i = 0; i < 3; i++) {
    const exact_int x = exact_from(n[i]), y = exact_from(of_v[i]), product = exact_mul(&x, &y);
    sum = exact_add(&sum, &product);
  }
  return sum.sign < 0 ? exact_negate(sum) : sum;
}

// Measures all planes. Half axes as of gjk_box_heights.h.
static void measure(const gjk_vec3 axis[6], const gjk_vec3 *delta, plane out[15]) {
  for (unsigned k = 0; k < 15; k++) {
    const gjk_vec3 *g = &axis[half_axes[k][0]], *h = &axis[half_axes[k][1]];
    plane *p = &out[k];
    p->n[0] = (int64_t)g->y * h->z - (int64_t)g->z * h->y;
    p->n[1] = (int64_t)g->z * h->x - (int64_t)g->x * h->z;
    p->n[2] = (int64_t)g->x * h->y - (int64_t)g->y * h->x;
    p->is = (p->n[0] | p->n[1] | p->n[2]) != 0;
    if (p->is) {
      const exact_int across = exact_size(p->n, delta);
      p->along = exact_negate(across);
      p->squared = exact_from(0);
      for (unsigned i = 0; i < 6; i++) {
        const exact_int size = exact_size(p->n, &axis[i]);
        p->along = exact_add(&p->along, &size);
      }
      for (int i = 0; i < 3; i++) {
        const exact_int x = exact_from(p->n[i]), square = exact_mul(&x, &x);
        p->squared = exact_add(&p->squared, &square);
      }
      p->height = exact_to_double(&p->along) / sqrt(exact_to_double(&p->squared));
    }
  }
}

// The sign of p's height less q's, of which one is not negative.
static int compare(const plane *p, const plane *q) {
  if (fabs(p->height - q->height) > 1e-3) {
    return p->height < q->height ? -1 : 1;
  }
  if (p->along.sign < 0 || q->along.sign < 0) {
    return p->along.sign - q->along.sign;
  }
  exact_int x = exact_mul(&p->along, &p->along), y = exact_mul(&q->along, &q->along);
  x = exact_mul(&x, &q->squared);
  y = exact_mul(&y, &p->squared);
  return exact_compare(&x, &y);
}

static bool are_parallel(const int64_t m[3], const int64_t n[3]) {
  for (int i = 0; i < 3; i++) {
    const int j = (i + 1) % 3;
    const exact_int p = exact_from(m[i]), q = exact_from(n[j]), r = exact_from(m[j]), s = exact_from(n[i]);
    const exact_int x = exact_mul(&p, &q), y = exact_mul(&r, &s);
    if (exact_compare(&x, &y) != 0) {
      return false;
    }
  }
  return true;
}

static void axes_of(unsigned shift, gjk_vec3 axis[6]) {
  for (unsigned k = 0; k < 6; k++) {
    const gjk_collider *c = k < 3 ? &a : &b;
    const gjk_vec3 zero = {0, 0, 0}, *v = k % 3 < c->count ? &c->frame[k % 3] : &zero;
    axis[k].x = v->x * (INT32_C(1) << shift);
    axis[k].y = v->y * (INT32_C(1) << shift);
    axis[k].z = v->z * (INT32_C(1) << shift);
  }
}

// The bounds of gjk_box_heights.h against the exact heights, as tight as they are stated.
static void check_bounds(const plane planes[15], const gjk_vec3 axis[6], const gjk_vec3 *delta) {
  gjk_box_heights h;
  const unsigned separating = gjk_box_heights_set(axis, delta, a.count, b.count, &h);
  CHECK(separating == GJK_BOX_PLANES || (separating < 6 && planes[separating].is && planes[separating].height < 0));
  for (unsigned k = 0; k < 15 && separating == GJK_BOX_PLANES; k++) {
    const bool has = (half_axes[k][0] % 3 < (half_axes[k][0] < 3 ? a.count : b.count)) &&
                     (half_axes[k][1] % 3 < (half_axes[k][1] < 3 ? a.count : b.count));
    CHECK(has || (h.squared[k] == 0 && gjk_box_height_exceeds(&h, k, gjk_box_height_square(INT32_MAX))));
    if (has && planes[k].is) {
      const double height = planes[k].height;
      int32_t low, high;
      gjk_box_height_bounds(&h, k, &low, &high);
      CHECK_MSG(low <= height + 1e-3 && high >= height - 1e-3, "%u: %ld, %f, %ld", k, (long)low, height, (long)high);
      const int32_t below = height < 1 ? 0 : (int32_t)height;
      CHECK(!gjk_box_height_exceeds(&h, k, gjk_box_height_square(below + 1)));
      CHECK(height < 0 || h.sum[k] >= -GJK_BOX_SUM_ERROR);
      CHECK_MSG(low == INT32_MIN || (double)high - low < 327684 + (fabs(height) + 262144) / 4, "%ld to %ld, %f",
                (long)low, (long)high, height);
    }
  }
}

static bool same_answer(const gjk_penetration_result *r, const gjk_penetration_result *s) {
  return r->depth == s->depth && memcmp(&r->normal, &s->normal, sizeof r->normal) == 0 &&
         memcmp(&r->point_a, &s->point_a, sizeof r->point_a) == 0 &&
         memcmp(&r->point_b, &s->point_b, sizeof r->point_b) == 0 && r->intersecting == s->intersecting &&
         memcmp(r->certificate.a, s->certificate.a, 6) == 0 && memcmp(r->certificate.b, s->certificate.b, 6) == 0;
}

static void check_caches(const gjk_penetration_result *cold) {
  static gjk_cache own;  // of the pair before, at first
  gjk_penetration_result r;
  for (unsigned i = 0; i < 4; i++) {
    gjk_cache rubbish;
    for (unsigned k = 0; k < sizeof rubbish; k++) {
      ((unsigned char *)&rubbish)[k] = (unsigned char)random_below(&now, i == 3 ? 16 : 256);
    }
    memset(&r, 0, sizeof r);
    CHECK(gjk_penetration(&a, &b, i < 2 ? &own : &rubbish, NULL, &r) == GJK_OK);
    CHECK(same_answer(&r, cold));
  }
}

// Swapped: the opposite normal, where no other direction is of the least depth.
static void check_swapped(const gjk_penetration_result *r) {
  gjk_penetration_result s;
  CHECK(gjk_penetration(&b, &a, NULL, NULL, &s) == GJK_OK && s.depth == r->depth);
  CHECK(labs((long)r->normal.x + s.normal.x) <= 4 && labs((long)r->normal.y + s.normal.y) <= 4 &&
        labs((long)r->normal.z + s.normal.z) <= 4);
}

static void check_pair(unsigned long trial) {
  gjk_penetration_result r = {0};
  plane planes[15];
  gjk_vec3 axis[6];
  char why[200];
  gjk_iteration it;
  it.a = &a;
  it.b = &b;
  gjk_frame_set(&it, false, 0);
  axes_of((unsigned)it.shift, axis);
  measure(axis, &it.delta, planes);
  check_bounds(planes, axis, &it.delta);
  axes_of(0, axis);
  const gjk_vec3 delta = {a.centre.x - b.centre.x, a.centre.y - b.centre.y, a.centre.z - b.centre.z};
  measure(axis, &delta, planes);
  CHECK(gjk_penetration(&a, &b, NULL, NULL, &r) == GJK_OK);
  const plane *least = NULL;
  bool outside = false, tie = false;
  for (unsigned k = 0; k < 15; k++) {
    outside = outside || (planes[k].is && planes[k].along.sign < 0);
  }
  for (unsigned k = 0; k < 15 && !outside; k++) {
    least = planes[k].is && (least == NULL || compare(&planes[k], least) < 0) ? &planes[k] : least;
  }
  CHECK(!outside || !r.intersecting);
  apart += !r.intersecting;
  bool spatial = false;
  for (unsigned k = 0; k < 6 && least != NULL; k++) {
    spatial = spatial || exact_size(least->n, &axis[k]).sign != 0;
  }
  if (!r.intersecting || !spatial) {
    flat += r.intersecting;
    CHECK(outside || !spatial);
    return;
  }
  overlaps++;
  edges += least - planes >= 6;
  CHECK_MSG(r.depth == (gjk_q16)ceil(least->height - 1e-6) || r.depth == (gjk_q16)ceil(least->height + 1e-6),
            "%ld, not %f", (long)r.depth, least->height);
  CHECK(r.certificate.proof == GJK_PROOF_FACET && r.certificate.count == 3);
  // The certificate's plane, by its corners in LSB.
  int64_t e[2][3], n[3];
  for (int i = 0; i < 3; i++) {
    const exact_point p = exact_vertex(&a, r.certificate.a[i]), q = exact_vertex(&b, r.certificate.b[i]);
    for (int j = 0; j < 3; j++) {
      const int64_t x = p.x[j] - q.x[j];
      e[0][j] = i == 0 ? -x : i == 1 ? e[0][j] + x : e[0][j];
      e[1][j] = i == 0 ? -x : i == 2 ? e[1][j] + x : e[1][j];
    }
  }
  for (int i = 0; i < 3; i++) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    n[i] = e[0][j] * e[1][k] - e[0][k] * e[1][j];
  }
  CHECK_MSG(are_parallel(n, least->n), "not plane %d", (int)(least - planes));
  for (unsigned k = 0; k < 15; k++) {
    tie = tie || (planes[k].is && compare(&planes[k], least) == 0 && !are_parallel(planes[k].n, least->n));
  }
  ties += tie;
  check_caches(&r);
  // Across delta both sides are as near.
  if (!tie && exact_size(least->n, &delta).sign != 0) {
    unique++;
    check_swapped(&r);
  }
  if (trial % CHECK_EVERY == 0) {
    CHECK_MSG(exact_check_penetration(&a, &b, &r, why, sizeof why), "%s", why);
  }
}

int main(void) {
  now = random_seed(check_seed(SEED));
  for (unsigned long i = 0; i < TRIALS; i++) {
    random_pair();
    check_trial(i, print_pair, NULL);
    check_pair(i);
  }
  printf("%lu overlap, of them %lu with ties and %lu by edges; %lu swapped; %lu flat, %lu apart\n", overlaps, ties,
         edges, unique, flat, apart);
  if (check_is_full()) {
    CHECK(overlaps > TRIALS / 4 && apart > TRIALS / 8 && ties > TRIALS / 50 && edges > TRIALS / 50 && flat > 0);
  }
  return check_done("box depth");
}
