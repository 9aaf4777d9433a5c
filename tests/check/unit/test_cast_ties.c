// Casts where ties are the rule: boxes along the axes, equal or flat ones, ways within a face's plane, along an edge or into a
// corner, and an LSB to either side of that. The truth is the slab test in whole numbers, and with a radius or margin, for
// ways along an axis, Pythagoras. A way in two halves and the cast of A against B tell the same.
#include <string.h>

#include "check.h"
#include "random.h"

// The test of the plane has included the plane's.
#ifndef TEST_NAME
#include "gjk/cast.h"
#include "gjk/gjk.h"
#define TEST_NAME "cast_ties"
#define SPACE 1
#endif
#include "placed.h"

#define SEED 9119
#define TRIALS check_trials(60000)
#define AXES (SPACE ? 3 : 2)
#define CORNERS (SPACE ? 8 : 4)

__extension__ typedef __int128 wide;

// B's place against A at the start, and its way, over the boxes' half extents together.
typedef struct trial {
  gjk_vec3 corners[2][8];
  gjk_shape shape[2];
  int64_t half[3], start[3], way[3], radius;
  gjk_vec3 at, share;  // A's place, and what both go beside the way
  gjk_q16 margin;
} trial;

typedef struct truth {
  bool hit, inside;
  int64_t numerator, denominator;  // of the fraction
} truth;

static struct { unsigned long hits, misses, inside, later, flips, rounded_hits, rounded_misses, halves; } tally;

static gjk_vec3 vec(int64_t x, int64_t y, int64_t z) {
#if SPACE
  const gjk_vec3 v = {(gjk_q16)x, (gjk_q16)y, (gjk_q16)z};
#else
  const gjk_vec3 v = {(gjk_q16)x, (gjk_q16)y};
  (void)z;
#endif
  return v;
}

static void show(const void *subject) {
  const trial *t = (const trial *)subject;
  for (int k = 0; k < AXES; k++) {
    printf("  axis %d: half %lld start %lld way %lld\n", k, (long long)t->half[k], (long long)t->start[k],
           (long long)t->way[k]);
  }
  printf("  radii %ld %ld margin %ld\n", (long)t->shape[0].convex_radius, (long)t->shape[1].convex_radius,
         (long)t->margin);
}

static int64_t size_of(int64_t x) {
  return x < 0 ? -x : x;
}

// The slab test. Products are below 2^60.
static truth slabs(const trial *t) {
  truth out = {true, true, 0, 1};
  int64_t leave_numerator = 1, leave_denominator = 1;
  for (int k = 0; k < AXES; k++) {
    const int64_t h = t->half[k], o = t->start[k], v = t->way[k], size = size_of(v);
    out.inside = out.inside && size_of(o) <= h;
    if (v == 0) {
      out.hit = out.hit && size_of(o) <= h;
      continue;
    }
    const int64_t enter = v > 0 ? -h - o : o - h, leave = v > 0 ? h - o : o + h;
    if ((wide)enter * out.denominator > (wide)out.numerator * size) {
      out.numerator = enter;
      out.denominator = size;
    }
    if ((wide)leave * leave_denominator < (wide)leave_numerator * size) {
      leave_numerator = leave;
      leave_denominator = size;
    }
  }
  out.hit = out.hit && (wide)out.numerator * leave_denominator <= (wide)leave_numerator * out.denominator;
  out.inside = out.inside && out.hit;
  return out;
}

// Is the gap at a fraction, or at the nearest place of the whole way where that is below 0, less than radius LSB (-1), that
// (0) or more (1)? Of a way along one axis.
static int compare_gap(const trial *t, int64_t fraction, int64_t radius) {
  wide square = 0;
  for (int k = 0; k < AXES; k++) {
    const wide from = (wide)t->start[k] * GJK_Q30_ONE, to = from + (wide)t->way[k] * GJK_Q30_ONE;
    wide at = from + (wide)t->way[k] * fraction;
    if (fraction < 0) {
      at = (from > 0) != (to > 0) ? 0 : (from > 0) == (from < to) ? from : to;
    }
    const wide beyond = (at < 0 ? -at : at) - (wide)t->half[k] * GJK_Q30_ONE;
    square += beyond > 0 ? beyond * beyond : 0;
  }
  const wide limit = ((wide)radius * radius) << 60;
  return (square > limit) - (square < limit);
}

static gjk_vec3 along(const trial *t, int half_ways) {
  return vec(t->start[0] + t->way[0] / 2 * half_ways, t->start[1] + t->way[1] / 2 * half_ways,
             AXES == 3 ? t->start[2] + t->way[2] / 2 * half_ways : 0);
}

static gjk_vec3 sum(gjk_vec3 a, gjk_vec3 b) {
#if SPACE
  return vec((int64_t)a.x + b.x, (int64_t)a.y + b.y, (int64_t)a.z + b.z);
#else
  return vec((int64_t)a.x + b.x, (int64_t)a.y + b.y, 0);
#endif
}

// The cast from one half of the way to another, 0 to 2; turned: of A against B. share is gone by both.
static gjk_cast_result cast(const trial *t, int from, int to, bool turned) {
  const gjk_vec3 at_a = t->at, end_a = sum(t->at, t->share), at_b = sum(t->at, along(t, from)),
                 end_b = sum(end_a, along(t, to));
  const gjk_collider a = placed(&t->shape[0], at_a), b = placed(&t->shape[1], at_b);
  const gjk_cast_path path = {turned ? &end_b : &end_a, turned ? &end_a : &end_b, t->margin};
  const gjk_collider *first = turned ? &b : &a, *second = turned ? &a : &b;
  gjk_cast_result r;
  memset(&r, 0, sizeof r);
  CHECK(gjk_cast(first, second, &path, &r) == GJK_OK);
  const gjk_status checked = gjk_check_cast(first, second, &path, &r);
  // In the plane a hit that grazes may have no line to show for it.
  CHECK(checked == GJK_OK || (!SPACE && t->radius > 0 && r.hit && checked == GJK_ERROR_UNPROVEN));
  return r;
}

// Both halves of the way tell what the whole does, and so does A's way against B.
static void check_parts(const trial *t, const gjk_cast_result *whole) {
  const gjk_cast_result first = cast(t, 0, 1, false), second = cast(t, 1, 2, false), turned = cast(t, 0, 2, true);
  CHECK(whole->hit == (first.hit || second.hit));
  CHECK(turned.hit == whole->hit);
  CHECK(!whole->hit || turned.inside == whole->inside);
  CHECK(!first.hit || first.inside == whole->inside);
  tally.halves += whole->hit && !first.hit;
  if (t->radius == 0 && whole->hit) {
    CHECK(turned.fraction == whole->fraction);
    CHECK(whole->fraction ==
          (first.hit ? first.fraction / 2 : (gjk_q30)((GJK_Q30_ONE + (int64_t)second.fraction) / 2)));
  }
}

static void check_exact(const trial *t) {
  const truth exact = slabs(t);
  const gjk_cast_result r = cast(t, 0, 2, false);
  CHECK(r.hit == exact.hit);
  tally.misses += !exact.hit;
  tally.hits += exact.hit;
  if (exact.hit && r.hit) {
    CHECK(r.inside == exact.inside);
    tally.inside += exact.inside;
    tally.later += !exact.inside;
    const int64_t fraction = (int64_t)(((wide)exact.numerator << 30) / exact.denominator);
    CHECK_MSG(r.fraction == fraction, "%ld, not %ld", (long)r.fraction, (long)fraction);
  }
  check_parts(t, &r);
  // An LSB to a side.
  for (int k = 0; k < AXES; k++) {
    for (int side = -1; side <= 1; side += 2) {
      trial moved = *t;
      moved.start[k] += side;
      const bool hit = slabs(&moved).hit;
      CHECK(cast(&moved, 0, 2, false).hit == hit);
      tally.flips += hit != exact.hit;
    }
  }
}

static void check_rounded(const trial *t) {
  const bool hit = compare_gap(t, -1, t->radius) <= 0, inside = compare_gap(t, 0, t->radius) <= 0;
  const gjk_cast_result r = cast(t, 0, 2, false);
  CHECK(r.hit == hit);
  tally.rounded_hits += hit;
  tally.rounded_misses += !hit;
  if (hit && r.hit) {
    CHECK(r.inside == inside);
    CHECK(inside || (compare_gap(t, r.fraction, t->radius) >= 0 && compare_gap(t, r.fraction, t->radius + 2) <= 0));
  }
  check_parts(t, &r);
}

static void make_shape(random_state *random, int i, const int64_t half[3], gjk_q16 radius, trial *t) {
  for (int c = 0; c < CORNERS; c++) {
    t->corners[i][c] =
        vec((c & 1) != 0 ? half[0] : -half[0], (c & 2) != 0 ? half[1] : -half[1], (c & 4) != 0 ? half[2] : -half[2]);
  }
#if SPACE
  const gjk_shape box = GJK_ROUNDED_BOX((gjk_q16)half[0], (gjk_q16)half[1], (gjk_q16)half[2], radius);
  const gjk_shape hull = GJK_ROUNDED_HULL(t->corners[i], CORNERS, radius);
#else
  const gjk_shape box = GJK2_ROUNDED_BOX((gjk_q16)half[0], (gjk_q16)half[1], radius);
  const gjk_shape hull = GJK2_ROUNDED_POLYGON(t->corners[i], CORNERS, radius);
#endif
  t->shape[i] = random_below(random, 2) == 0 ? box : hull;
}

// A place on a face's plane, an LSB beside one, in the middle, or anywhere near.
static int64_t place(random_state *random, int64_t half) {
  const int64_t near = half + (int64_t)random_below(random, 3) - 1;
  switch (random_below(random, 4)) {
    case 0: return near;
    case 1: return -near;
    case 2: return 0;
    default: return random_range(random, (int32_t)(-3 * half - 4), (int32_t)(3 * half + 4));
  }
}

static void make(random_state *random, bool rounded, trial *t) {
  static const int32_t sizes[] = {1, 2, 7, 1000, 65536, 5000000};
  int64_t half[2][3] = {{0, 0, 0}, {0, 0, 0}};
  const int32_t size = sizes[random_below(random, 6)];
  const int32_t most = size > 9 ? 9 : size;
  gjk_q16 radius[2] = {0, 0};
  for (int k = 0; k < AXES; k++) {
    half[0][k] = random_below(random, 6) == 0 ? 0 : random_below(random, 2) == 0 ? size : random_range(random, 0, size);
    half[1][k] = random_below(random, 2) == 0 ? half[0][k] : random_range(random, 0, most);
    t->half[k] = half[0][k] + half[1][k];
  }
  t->margin = 0;
  if (rounded) {
    radius[0] = random_range(random, 0, size);
    radius[1] = random_below(random, 2) == 0 ? 0 : random_range(random, 0, 5);
    t->margin = random_below(random, 2) == 0 ? 1 : random_range(random, 1, size);
  }
  t->radius = (int64_t)radius[0] + radius[1] + t->margin;
  make_shape(random, 0, half[0], radius[0], t);
  make_shape(random, 1, half[1], radius[1], t);
  const int axis = (int)random_below(random, AXES);
  for (int k = 0; k < AXES; k++) {
    t->start[k] = place(random, t->half[k] + (random_below(random, 2) == 0 ? t->radius : 0));
    const int64_t end = place(random, t->half[k] + (random_below(random, 2) == 0 ? t->radius : 0));
    const bool still = rounded ? k != axis : random_below(random, 2) == 0;
    t->way[k] = still ? 0 : 2 * (end - t->start[k]);
  }
  for (int k = 0, earlier = random_below(random, 3) == 0; k < AXES && earlier; k++) {  // contact in the second half
    t->start[k] -= t->way[k];
    t->way[k] *= 2;
  }
  const int32_t far = random_below(random, 2) == 0 ? 0 : 1000000000, shared = random_below(random, 2) == 0 ? 0 : 77777;
  t->at = vec(random_range(random, -far, far), random_range(random, -far, far), random_range(random, -far, far));
  t->share = vec(random_range(random, -shared, shared), random_range(random, -shared, shared), 0);
}

int main(void) {
  random_state random = random_seed(check_seed(SEED));
  const unsigned long trials = TRIALS;
  static trial t;
  for (unsigned long i = 0; i < trials; i++) {
    check_trial(i, show, &t);
    make(&random, i % 2 != 0, &t);
    if (i % 2 != 0) {
      check_rounded(&t);
    } else {
      check_exact(&t);
    }
  }
  printf(
      "%lu hits, %lu of them at the start, %lu misses, %lu flips by an LSB; %lu rounded hits, %lu misses; "
      "%lu in the second half\n",
      tally.hits, tally.inside, tally.misses, tally.flips, tally.rounded_hits, tally.rounded_misses, tally.halves);
  CHECK(tally.hits > trials / 8 && tally.misses > trials / 10 && tally.later > trials / 40 &&
        tally.inside > trials / 40);
  CHECK(tally.flips > trials / 20 && tally.halves > trials / 100);
  CHECK(tally.rounded_hits > trials / 10 && tally.rounded_misses > trials / 20);
  return check_done(TEST_NAME);
}
