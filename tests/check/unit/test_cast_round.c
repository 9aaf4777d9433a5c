// Casts of rounded and of curved shapes: the fraction between exact bounds, the place of rest, points, normal.
//
// Shapes whose edges lie along the axes have their gap in closed form, so that each fraction is judged in integers. Of any
// others the accurate oracle bounds the gap at the fraction, and exact queries judge the places of rest.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "gjk/cast.h"
#include "gjk/check.h"
#include "placed.h"
#include "random.h"
#include "reference/accurate.h"
#include "reference/random_shape.h"
#include "reference/reference.h"
#include "wide_root.h"

#define SEED 7301

__extension__ typedef __int128 wide;

static const gjk_vec3 origin = {0, 0, 0};

// The place of B against A at a fraction, times 2^30.
static void place_at(const gjk_collider *a, const gjk_collider *b, const gjk_cast_path *path, int64_t fraction,
                     int64_t out[3]) {
  const gjk_vec3 *to_a = path->to_a != NULL ? path->to_a : &a->position;
  const gjk_vec3 *to_b = path->to_b != NULL ? path->to_b : &b->position;
  const int64_t from[3] = {(int64_t)b->position.x - a->position.x, (int64_t)b->position.y - a->position.y,
                           (int64_t)b->position.z - a->position.z};
  const int64_t to[3] = {(int64_t)to_b->x - to_a->x, (int64_t)to_b->y - to_a->y, (int64_t)to_b->z - to_a->z};
  for (int k = 0; k < 3; k++) {
    out[k] = from[k] * GJK_Q30_ONE + (to[k] - from[k]) * fraction;
  }
}

// Of a box of half extents (x, y, z) about the origin and a place times 2^30: is the distance less than radius LSB (-1), that
// (0) or more (1)? Places are below 2^61 here.
static int compare_aligned(const int64_t place[3], const int64_t half[3], int64_t radius) {
  wide square = 0;
  for (int k = 0; k < 3; k++) {
    const int64_t beyond = (place[k] < 0 ? -place[k] : place[k]) - half[k] * GJK_Q30_ONE;
    square += beyond > 0 ? (wide)beyond * beyond : 0;
  }
  const wide limit = (wide)radius * radius << 60;
  return (square > limit) - (square < limit);
}

// The length of B's way against A's, LSB.
static long double length_of(const gjk_collider *a, const gjk_collider *b, const gjk_cast_path *path) {
  int64_t from[3], to[3];
  place_at(a, b, path, 0, from);
  place_at(a, b, path, GJK_Q30_ONE, to);
  long double square = 0;
  for (int k = 0; k < 3; k++) {
    const long double t = ldexpl((long double)to[k] - (long double)from[k], -60);
    square += t * t;
  }
  return ldexpl(sqrtl(square), 30);
}

// The largest rounding of the fraction, where it may be more than an LSB: a step of it.
static int64_t step_of(const gjk_collider *a, const gjk_collider *b, const gjk_cast_path *path) {
  const long double step = ldexpl(length_of(a, b, path), -30);
  return step <= 1 ? 0 : (int64_t)ceill(step);
}

// Whole LSB, between the ends of the way, less than an LSB from the exact place on each axis, and of B on the side to which
// the normal points, of A on the other one.
static void check_rest(const gjk_vec3 *from, const gjk_vec3 *to, gjk_q30 fraction, const gjk_unit3 *normal, int side,
                       const gjk_vec3 *rest) {
  const int64_t p[3] = {from->x, from->y, from->z}, q[3] = {to->x, to->y, to->z}, r[3] = {rest->x, rest->y, rest->z};
  const int64_t n[3] = {normal->x * side, normal->y * side, normal->z * side};
  for (int k = 0; k < 3; k++) {
    const int64_t off = (r[k] - p[k]) * GJK_Q30_ONE - (q[k] - p[k]) * fraction;
    CHECK(off > -GJK_Q30_ONE && off < GJK_Q30_ONE);
    CHECK(n[k] == 0 || (n[k] > 0 ? off >= 0 : off <= 0));
    CHECK(r[k] >= (p[k] < q[k] ? p[k] : q[k]) && r[k] <= (p[k] > q[k] ? p[k] : q[k]));
  }
}

static gjk_collider moved_to(const gjk_collider *c, const gjk_vec3 *at) {
  gjk_collider moved = *c;
  CHECK(gjk_collider_move(&moved, at) == GJK_OK);
  return moved;
}

// What holds of each hit of polytopes that is not one at the start. extra: LSB on top of the gap that is allowed.
static void check_hit(const gjk_collider *a, const gjk_collider *b, const gjk_cast_path *path, const gjk_cast_result *r,
                      int64_t extra) {
  const gjk_vec3 *to_a = path->to_a != NULL ? path->to_a : &a->position;
  const gjk_vec3 *to_b = path->to_b != NULL ? path->to_b : &b->position;
  gjk_decision decision;
  gjk_distance_result gap;
  CHECK(r->fraction >= 0 && r->fraction <= GJK_Q30_ONE);
  check_rest(&a->position, to_a, r->fraction, &r->normal, -1, &r->rest_a);
  check_rest(&b->position, to_b, r->fraction, &r->normal, 1, &r->rest_b);
  const gjk_collider at_a = moved_to(a, &r->rest_a), at_b = moved_to(b, &r->rest_b);
  CHECK(gjk_within(&at_a, &at_b, path->margin, NULL, &decision) == GJK_OK);
  CHECK(!decision.yes);
  CHECK(gjk_check_decision(&at_a, &at_b, path->margin, &decision) != GJK_ERROR_UNPROVEN);
  CHECK(gjk_distance(&at_a, &at_b, NULL, &gap) == GJK_OK);
  // 2 sqrt(3) LSB for the roundings of both places
  CHECK_MSG(gap.distance <= (int64_t)path->margin + 6 + extra, "gap %ld of margin %ld at rest", (long)gap.distance,
            (long)path->margin);
  const long double n[3] = {r->normal.x, r->normal.y, r->normal.z};
  const long double length = ldexpl(sqrtl(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]), -30);
  CHECK(fabsl(length - 1) <= ldexpl(1, -28));
  const long double between[3] = {(long double)r->point_b.x - r->point_a.x, (long double)r->point_b.y - r->point_a.y,
                                  (long double)r->point_b.z - r->point_a.z};
  for (int k = 0; k < 3 && !r->saturated; k++) {
    CHECK(fabsl(between[k] - ldexpl(n[k], -30) * path->margin) <= 1);
  }
}

// Aligned shapes: A and B are boxes, segments along z or points, with convex radii; half, of A - B.
typedef struct aligned {
  gjk_shape shape[2];
  int64_t half[3], radius;
} aligned;

static gjk_shape random_aligned(random_state *random, int32_t size) {
  const gjk_q16 radius = random_below(random, 3) == 0 ? random_range(random, 0, 3) : random_range(random, 0, size);
  const gjk_shape ball = GJK_SPHERE(radius), capsule = GJK_CAPSULE(random_range(random, 0, size), radius);
  const gjk_shape box = GJK_ROUNDED_BOX(random_range(random, 0, size), random_range(random, 0, size),
                                        random_range(random, 0, size), radius);
  switch (random_below(random, 3)) {
    case 0: return ball;
    case 1: return capsule;
    default: return box;
  }
}

static void make_aligned(random_state *random, int32_t size, aligned *out) {
  out->shape[0] = random_aligned(random, size);
  out->shape[1] = random_aligned(random, random_below(random, 4) == 0 ? 1 + size / 1000 : size);
  const gjk_vec3 *s = &out->shape[0].size, *t = &out->shape[1].size;
  out->half[0] = (int64_t)s->x + t->x;
  out->half[1] = (int64_t)s->y + t->y;
  out->half[2] = (int64_t)s->z + t->z;
  out->radius = (int64_t)out->shape[0].convex_radius + out->shape[1].convex_radius;
}

typedef struct tally {
  unsigned long hits, misses, inside, best, rounds;
} tally;

// Is the place within the margin at a fraction? By integers.
static int side_at(const aligned *shapes, const gjk_collider *a, const gjk_collider *b, const gjk_cast_path *path,
                   int64_t fraction, int64_t extra) {
  int64_t place[3];
  place_at(a, b, path, fraction, place);
  return compare_aligned(place, shapes->half, shapes->radius + path->margin + extra);
}

static void check_aligned(const aligned *shapes, const gjk_collider *a, const gjk_collider *b,
                          const gjk_cast_path *path, tally *t) {
  gjk_cast_result r;
  CHECK(gjk_cast(a, b, path, &r) == GJK_OK);
  const gjk_status checked = gjk_check_cast(a, b, path, &r);
  CHECK(checked == GJK_OK || checked == GJK_ERROR_UNSUPPORTED);
  const bool starts = side_at(shapes, a, b, path, 0, 0) <= 0;
  CHECK(starts == (r.hit && r.inside));
  if (!r.hit) {
    t->misses++;
    for (int i = 1; i <= 64; i++) {
      CHECK(side_at(shapes, a, b, path, (int64_t)i * (GJK_Q30_ONE / 64), 0) > 0);
    }
    return;
  }
  if (r.inside) {
    t->inside++;
    CHECK(r.fraction == 0);
    return;
  }
  t->hits++;
  if (shapes->radius + path->margin == 0) {
    return;  // exact, of other tests
  }
  const int64_t step = step_of(a, b, path);
  CHECK(side_at(shapes, a, b, path, r.fraction, 0) >= 0);
  CHECK_MSG(side_at(shapes, a, b, path, r.fraction, 2 + step) <= 0, "fraction %ld", (long)r.fraction);
  const int64_t eighth = (int64_t)(0x1p27L / length_of(a, b, path)) + 1;
  t->best += side_at(shapes, a, b, path, r.fraction + eighth, 0) <= 0;
  check_hit(a, b, path, &r, step);
}

// A place at most 2^29 from the origin along each axis, often near a face, edge or corner of the box of half extents.
static gjk_vec3 place_around(random_state *random, const aligned *shapes, int64_t reach) {
  int32_t x[3];
  for (int k = 0; k < 3; k++) {
    const int64_t border = shapes->half[k] + (random_below(random, 2) == 0 ? shapes->radius : 0);
    const int64_t near = border + random_range(random, -2, 2),
                  any = random_range(random, -(int32_t)reach, (int32_t)reach);
    const int64_t chosen = random_below(random, 3) == 0 ? (random_below(random, 2) == 0 ? near : -near) : any;
    x[k] = (int32_t)(chosen > 1 << 29 ? 1 << 29 : chosen < -(1 << 29) ? -(1 << 29) : chosen);
  }
  return (gjk_vec3){x[0], x[1], x[2]};
}

static void test_aligned(void) {
  static const int32_t sizes[] = {1, 3, 20, 1000, 65536, 10000000, 70000000};
  random_state random = random_seed(check_seed(SEED));
  tally t = {0, 0, 0, 0, 0};
  const unsigned long trials = check_trials(60000);
  for (unsigned long i = 0; i < trials; i++) {
    aligned shapes;
    check_trial(i, NULL, NULL);
    const int32_t size = sizes[random_below(&random, 7)];
    make_aligned(&random, size, &shapes);
    const int64_t reach = 1 + shapes.radius + 3 * (int64_t)size;
    const gjk_vec3 at = random_below(&random, 2) == 0 ? random_vector(&random, 1e8) : origin;
    const gjk_vec3 offset = place_around(&random, &shapes, reach < 1 << 29 ? reach : 1 << 29);
    const gjk_vec3 aim = place_around(&random, &shapes, reach < 1 << 28 ? reach : 1 << 28);
    const gjk_vec3 from = {at.x + offset.x, at.y + offset.y, at.z + offset.z};
    gjk_vec3 to = {at.x + aim.x, at.y + aim.y, at.z + aim.z}, to_a = random_vector(&random, 1e6);
    const gjk_cast_path path = {random_below(&random, 4) == 0 ? &to_a : NULL, &to,
                                random_below(&random, 2) == 0 ? 0 : random_range(&random, 0, size)};
    if (path.to_a != NULL) {
      to.x += to_a.x;
      to.y += to_a.y;
      to.z += to_a.z;
      to_a.x += at.x;
      to_a.y += at.y;
      to_a.z += at.z;
    }
    const gjk_collider a = placed(&shapes.shape[0], at), b = placed(&shapes.shape[1], from);
    check_aligned(&shapes, &a, &b, &path, &t);
  }
  printf("aligned: %lu hits, %lu of them to 1/8 LSB of the way; %lu misses, %lu at the start\n", t.hits, t.best,
         t.misses, t.inside);
  CHECK(t.hits > trials / 5 && t.misses > trials / 10 && t.inside > trials / 50);
  CHECK(t.best > t.hits / 2);
}

static gjk_cast_result cast_of(const gjk_shape *sa, const gjk_shape *sb, gjk_vec3 from, gjk_vec3 to, gjk_q16 margin) {
  const gjk_collider a = placed(sa, origin), b = placed(sb, from);
  const gjk_cast_path path = {NULL, &to, margin};
  gjk_cast_result r;
  memset(&r, 0, sizeof r);
  CHECK(gjk_cast(&a, &b, &path, &r) == GJK_OK);
  const gjk_status checked = gjk_check_cast(&a, &b, &path, &r);
  CHECK(checked == GJK_OK || checked == GJK_ERROR_UNSUPPORTED);
  if (r.hit && !r.inside && (int64_t)sa->convex_radius + sb->convex_radius + margin > 0) {
    check_hit(&a, &b, &path, &r, step_of(&a, &b, &path));
  }
  return r;
}

// Ways that touch or miss by an LSB: beside, at the end, at the start.
static void test_grazing(void) {
  static const int32_t units[] = {1, 7, 1000, 65536, 20000000};
  for (int i = 0; i < 5; i++) {
    const int32_t k = units[i];
    const gjk_shape ball = GJK_SPHERE(3 * k), other = GJK_SPHERE(2 * k);
    // 5 k is the length of (0, 3 k, 4 k).
    for (int32_t off = -1; off <= 1; off++) {
      const gjk_vec3 from = {-9 * k, 3 * k, 4 * k + off}, to = {9 * k, 3 * k, 4 * k + off};
      const gjk_cast_result r = cast_of(&ball, &other, from, to, 0);
      CHECK_MSG(r.hit == (off <= 0), "k %ld off %ld", (long)k, (long)off);
      CHECK(!r.hit || (r.fraction > 0 && r.fraction <= GJK_Q30_ONE / 2));
      const gjk_vec3 apart = {-9 * k, 3 * k, 4 * k}, end = {off, 3 * k, 4 * k};
      CHECK(cast_of(&ball, &other, apart, end, 0).hit == (off >= 0));
      const gjk_vec3 start = {0, 3 * k, 4 * k + off}, away = {0, 6 * k, 8 * k};
      const gjk_cast_result leaving = cast_of(&ball, &other, start, away, 0);
      CHECK(leaving.hit == (off <= 0) && leaving.inside == (off <= 0));
      const gjk_vec3 aside = {9 * k, 3 * k, 4 * k + off};
      CHECK(cast_of(&ball, &other, start, aside, 0).hit == (off <= 0));
    }
    // The same gaps by a margin larger than the radii.
    const gjk_shape point = GJK_POINT;
    for (int32_t off = -1; off <= 1; off++) {
      const gjk_vec3 from = {-9 * k, 3 * k, 4 * k + off}, to = {9 * k, 3 * k, 4 * k + off};
      CHECK(cast_of(&point, &point, from, to, 5 * k).hit == (off <= 0));
    }
  }
}

// A corner of a triangle at the origin, and a place outside it: over the face, beside an edge or before the corner, at a distance
// of radius or as little more as the lattice allows.
typedef struct closest_end {
  gjk_vec3 corner[3], place, outward;
  gjk_q16 radius;
  bool within;
} closest_end;

static void make_closest_end(random_state *random, closest_end *c) {
  static const int32_t slopes[] = {2, 300, 8000}, radii[] = {40, 200000, 200000000};
  const int32_t most = slopes[random_below(random, 3)], size = 64 + (int32_t)random_below(random, 130000000) / most / 8;
  const int32_t m = random_range(random, 1, most), k = random_range(random, -most, most);
  const int32_t aside = random_range(random, -1, 1);
  const unsigned kind = random_below(random, 3);
  memset(c, 0, sizeof *c);
  c->radius = random_range(random, 1, radii[random_below(random, 3)]);
  c->within = aside == 0;
  if (kind == 0) {  // across n = (m, k, 1)
    const int64_t square = (int64_t)m * m + (int64_t)k * k + 1;
    const int64_t least = wide_root((wide)c->radius * c->radius * square), height = least + random_range(random, 0, 1);
    const int32_t u = (int32_t)(height * m / square) + size / 4, v = (int32_t)(height * k / square) + size / 4;
    const gjk_vec3 to_x = {size, 0, -m * size}, to_y = {0, size, -k * size};
    const gjk_vec3 place = {u, v, (int32_t)(height - (int64_t)m * u - (int64_t)k * v)}, outward = {m, k, 1};
    c->corner[1] = to_x;
    c->corner[2] = to_y;
    c->place = place;
    c->outward = outward;
    c->within = (wide)height * height <= (wide)c->radius * c->radius * square;
  } else if (kind == 1) {  // an edge along (m, 1, 0)
    const gjk_vec3 along = {m * size, size, 0}, below = {0, 0, -size}, outward = {0, 0, 1};
    const gjk_vec3 place = {size / 2 * m + aside, size / 2, c->radius};
    c->corner[1] = along;
    c->corner[2] = below;
    c->place = place;
    c->outward = outward;
  } else {
    const gjk_vec3 on = {m * size, size, k}, other = {size, -k, m}, place = {-c->radius, aside, 0},
                   outward = {-1, 0, 0};
    c->corner[1] = on;
    c->corner[2] = other;
    c->place = place;
    c->outward = outward;
  }
}

// Ways that end, or begin, at such a place: hit or miss by integers.
static void test_closest_ends(void) {
  random_state random = random_seed(check_seed(SEED));
  const unsigned long trials = check_trials(20000);
  unsigned long hits = 0, misses = 0;
  for (unsigned long i = 0; i < trials; i++) {
    closest_end c;
    check_trial(i, NULL, NULL);
    make_closest_end(&random, &c);
    const uint32_t slope = (uint32_t)(abs(c.outward.x) + abs(c.outward.y) + 1);
    const int32_t far = 1 + (int32_t)random_below(&random, random_below(&random, 2) == 0 ? 1000 : 100000000 / slope);
    const gjk_vec3 away = {
        c.place.x + c.outward.x * far + (c.outward.x == 0 ? random_range(&random, -far / 2, far / 2) : 0),
        c.place.y + c.outward.y * far + (c.outward.y == 0 ? random_range(&random, -far / 2, far / 2) : 0),
        c.place.z + c.outward.z * far};
    const bool begins = random_below(&random, 4) == 0;
    const gjk_shape triangle = GJK_TRIANGLE(c.corner);
    const gjk_q16 own =
        random_below(&random, 2) == 0 ? 0 : random_range(&random, 0, c.radius < GJK_RADIUS_MAX ? c.radius : 0);
    const gjk_shape ball = GJK_SPHERE(own);
    const gjk_vec3 from = begins ? c.place : away, to = begins ? away : c.place;
    const gjk_cast_result r = cast_of(&triangle, &ball, from, to, c.radius - own);
    CHECK_MSG(r.hit == c.within, "radius %ld, from (%ld, %ld, %ld)", (long)c.radius, (long)from.x, (long)from.y,
              (long)from.z);
    CHECK(r.inside == (r.hit && begins));
    const gjk_collider a = placed(&triangle, origin), b = placed(&ball, from);
    const gjk_cast_path back = {&to, NULL, c.radius - own};
    gjk_cast_result reversed;
    CHECK(gjk_cast(&b, &a, &back, &reversed) == GJK_OK && reversed.hit == r.hit);
    hits += r.hit;
    misses += !r.hit;
  }
  printf("closest ends: %lu hits, %lu misses\n", hits, misses);
  CHECK(hits > trials / 5 && misses > trials / 5);
}

// A capsule and a rounded box over a face: parallel to it, an LSB above it and on it; down onto it.
static void test_sliding(void) {
  const gjk_shape floor = GJK_BOX(GJK_Q16(10.0), GJK_Q16(10.0), GJK_Q16(0.5));
  const gjk_shape capsule = GJK_CAPSULE(GJK_Q16(0.5), GJK_Q16(0.3)),
                  crate = GJK_ROUNDED_BOX(GJK_Q16(0.5), GJK_Q16(0.5), GJK_Q16(0.5), GJK_Q16(0.3));
  const gjk_shape *const shapes[] = {&capsule, &crate};
  const int32_t height = GJK_Q16(0.5) + GJK_Q16(0.5) + GJK_Q16(0.3);
  for (int i = 0; i < 2; i++) {
    for (int32_t gap = 0; gap <= 2; gap++) {
      const gjk_vec3 from = {GJK_Q16(-15.0), GJK_Q16(1.0), height + gap},
                     to = {GJK_Q16(15.0), GJK_Q16(-2.0), height + gap};
      const gjk_cast_result r = cast_of(&floor, shapes[i], from, to, 0);
      CHECK(r.hit == (gap == 0));
      const gjk_vec3 above = {100, 200, height + gap}, along = {GJK_Q16(3.0), 200, height + gap},
                     down = {GJK_Q16(3.0), 200, height - 1000};
      CHECK(cast_of(&floor, shapes[i], above, along, 0).hit == (gap == 0));
      const gjk_cast_result landed = cast_of(&floor, shapes[i], above, down, 0);
      CHECK(landed.hit && landed.inside == (gap == 0));
      if (gap > 0) {
        CHECK(landed.rest_b.z == height || landed.rest_b.z == height + 1);
        CHECK(landed.normal.z >= GJK_Q30_ONE - 4);
      }
    }
  }
}

// Ways of an LSB, and the longest ones; both ends of int32.
static void test_lengths(void) {
  const gjk_shape tiny = GJK_SPHERE(1), large = GJK_SPHERE(GJK_RADIUS_MAX);
  for (int32_t x = 2; x <= 5; x++) {
    const gjk_vec3 from = {x, 0, 0}, to = {x - 1, 0, 0};
    const gjk_cast_result r = cast_of(&tiny, &tiny, from, to, 0);
    CHECK(r.hit == (x <= 3) && r.inside == (x == 2));
    CHECK(x != 3 || (r.fraction >= GJK_Q30_ONE / 2 && r.rest_b.x == 3) || r.rest_b.x == 2);
  }
  const gjk_shape *const shapes[] = {&tiny, &large};
  for (int i = 0; i < 4; i++) {
    const gjk_vec3 from = {INT32_MIN, INT32_MAX, INT32_MIN}, to = {INT32_MAX, INT32_MIN, INT32_MAX};
    const gjk_cast_result r = cast_of(shapes[i & 1], shapes[i >> 1], from, to, 0);
    CHECK(r.hit && r.fraction < GJK_Q30_ONE / 2 + 1);
    // Both move, towards each other; the way of one against the other is below 2^32.
    const gjk_collider a = placed(shapes[i & 1], (gjk_vec3){INT32_MIN, 5, 0}),
                       b = placed(shapes[i >> 1], (gjk_vec3){0, 0, 0});
    const gjk_vec3 to_a = {0, 5, 0}, to_b = {INT32_MIN + 1, 0, 0};
    const gjk_cast_path path = {&to_a, &to_b, 0};
    gjk_cast_result both;
    CHECK(gjk_cast(&a, &b, &path, &both) == GJK_OK && (both.hit || i == 0));
    if (both.hit) {
      check_hit(&a, &b, &path, &both, step_of(&a, &b, &path));
    }
  }
}

// Margins of more than 8192 units: frames are coarse there, and fractions are proven to 2^-24 of the margin.
static void test_large_margins(void) {
  random_state random = random_seed(check_seed(SEED) + 3);
  const gjk_shape ball = GJK_SPHERE(1000), box = GJK_BOX(2000, 100000000, 3);
  unsigned long hits = 0, proven = 0, unsupported = 0;
  long double worst = 0;
  const unsigned long trials = check_trials(5000);
  for (unsigned long i = 0; i < trials; i++) {
    check_trial(i, NULL, NULL);
    const gjk_q16 margin = random_range(&random, 1 << 29, INT32_MAX);
    const gjk_vec3 from = random_vector(&random, 2.1e9), to = random_vector(&random, 1.6e9 * random_unit(&random));
    const gjk_vec3 at = {-from.x / 2, -from.y / 2, -from.z / 2};
    const gjk_collider a = placed(i % 2 == 0 ? &ball : &box, at), b = placed(&ball, from);
    const gjk_cast_path path = {NULL, &to, margin};
    gjk_cast_result r;
    CHECK(gjk_cast(&a, &b, &path, &r) == GJK_OK);
    const gjk_status checked = gjk_check_cast(&a, &b, &path, &r);
    CHECK(checked == GJK_OK || checked == GJK_ERROR_UNSUPPORTED);
    (*(checked == GJK_OK ? &proven : &unsupported))++;
    gjk_cast_result wrong = r;
    wrong.hit = !r.hit;
    wrong.inside = false;
    wrong.fraction = GJK_Q30_ONE / 2;
    CHECK(gjk_check_cast(&a, &b, &path, &wrong) != GJK_OK);
    if (!r.hit || r.inside) {
      continue;
    }
    const int64_t half[3] = {a.shape->size.x, a.shape->size.y, a.shape->size.z};
    int64_t place[3];
    long double square = 0;
    place_at(&a, &b, &path, r.fraction, place);
    for (int k = 0; k < 3; k++) {
      const long double beyond = fabsl(ldexpl((long double)place[k], -30)) - (long double)half[k];
      square += beyond > 0 ? beyond * beyond : 0;
    }
    const long double gap = sqrtl(square) - a.shape->convex_radius - 1000 - margin;
    CHECK_MSG(gap >= 0, "gap %Lg less than the margin", -gap);
    worst = fmaxl(worst, (gap - 2 - (long double)step_of(&a, &b, &path)) / margin);
    hits++;
  }
  printf("large margins: %lu hits, at most 2 LSB and %.3Lf 2^-24 too far\n", hits, ldexpl(worst, 24));
  CHECK(hits > trials / 20 && worst <= ldexpl(1, -24));
  CHECK_MSG(proven > trials / 10 && unsupported > trials / 10, "%lu proven, %lu unsupported", proven, unsupported);
}

// A pair of any shapes and a way towards each other.
static bool random_cast(random_state *random, bool curved, case_pair *pair, gjk_vec3 *to_a, gjk_vec3 *to_b,
                        gjk_q16 *margin) {
  const gjk_q16 reach = random_reach(random), other = random_below(random, 2) == 0 ? reach : random_reach(random);
  const unsigned kinds = curved ? 8 : 5;
  random_shape(random, (case_kind)random_below(random, kinds), reach, &pair->a);
  random_shape(random,
               curved ? (case_kind)(CASE_CYLINDER + random_below(random, 3)) : (case_kind)random_below(random, 5),
               other, &pair->b);
  *margin = random_below(random, 3) != 0 ? 0 : random_range(random, 0, 1 + (reach / 8 + other / 8));
  const double both = (double)reach + other + *margin;
  const unsigned how = random_below(random, 16);
  const double away = both * (how == 0 ? random_unit(random) : 1 + 3 * random_unit(random)) *
                      (how == 1 || how == 2 ? 100 * random_unit(random) : 1);
  const gjk_vec3 from = random_vector(random, fmin(away, 1e9)),
                 aim = random_vector(random, both * random_unit(random) / 2);
  const double further = random_below(random, 2) == 0 ? 1 : 1 + 20 * random_unit(random);
  const double to[3] = {from.x + (aim.x - (double)from.x) * further, from.y + (aim.y - (double)from.y) * further,
                        from.z + (aim.z - (double)from.z) * further};
  if (fabs(to[0]) > 1.6e9 || fabs(to[1]) > 1.6e9 || fabs(to[2]) > 1.6e9) {
    return false;
  }
  pair->a.pose.position = origin;
  pair->b.pose.position = from;
  *to_a = random_below(random, 4) == 0 ? random_vector(random, 1e8) : origin;
  to_b->x = (int32_t)to[0] + to_a->x;
  to_b->y = (int32_t)to[1] + to_a->y;
  to_b->z = (int32_t)to[2] + to_a->z;
  case_shape_move_to(&pair->a, to_a);
  case_shape_move_to(&pair->b, to_b);
  return true;
}

static case_pair pair;
static case_collider a, b;

static void gap_at(const gjk_cast_path *path, gjk_q30 fraction, accurate_result *out) {
  int64_t start[3], place[3];
  long double moved[3];
  place_at(&a.collider, &b.collider, path, 0, start);
  place_at(&a.collider, &b.collider, path, fraction, place);
  for (int k = 0; k < 3; k++) {
    moved[k] = ldexpl((long double)(place[k] - start[k]), -30);
  }
  accurate_distance_moved(&pair, &a, &b, moved, out);
}

static void reference_of(const gjk_cast_path *path, double margin, reference_cast_result *out) {
  int64_t from[3], to[3];
  double way[3];
  place_at(&a.collider, &b.collider, path, 0, from);
  place_at(&a.collider, &b.collider, path, GJK_Q30_ONE, to);
  for (int k = 0; k < 3; k++) {
    way[k] = ldexp((double)(to[k] - from[k]), -30);
  }
  reference_cast_posed(&pair, &a, &b, way, margin, out);
}

// Largest and least gap at a fraction less the margin, and how far the reference's gap is from it.
typedef struct extremes {
  long double least, most;
  unsigned long hits, misses, inside, differ;
} extremes;

static void check_gap(const gjk_cast_path *path, const gjk_cast_result *r, long double allowed, extremes *e) {
  accurate_result gap;
  gap_at(path, r->fraction, &gap);
  const long double step = (long double)step_of(&a.collider, &b.collider, path);
  const long double low = gap.lower - path->margin, high = gap.upper - path->margin - step;
  e->least = fminl(e->least, low);
  e->most = fmaxl(e->most, high);
  // The oracle's bounds are within 2^-12 LSB of each other and of the truth. At the start curved shapes that are not said to
  // be within the margin may be so, by what decisions err.
  const bool doubtful = r->fraction == 0 && r->certificate.proof == GJK_CAST_PROOF_NONE;
  CHECK_MSG(low >= (doubtful ? -2 : -ldexpl(1, -11)), "gap %Lg less than the margin", -low);
  CHECK_MSG(high <= allowed, "gap %Lg above the margin", high);
}

// Lazy hulls give the same bits.
static void check_lazy(const gjk_cast_path *path, const gjk_cast_result *expected) {
  static case_collider lazy;
  gjk_cast_result r;
  if (pair.a.kind == CASE_HULL && case_collider_build(&lazy, &pair.a, true) == GJK_OK) {
    memset(&r, 0, sizeof r);
    CHECK(gjk_cast(&lazy.collider, &b.collider, path, &r) == GJK_OK);
    CHECK(memcmp(&r, expected, sizeof r) == 0);
  }
  case_collider_free(&lazy);
  memset(&lazy, 0, sizeof lazy);
}

// The points lie on their shapes, which are looked at where they rest: within LSB of where they touch. The normal's plane
// parts the shapes at the fraction by the margin.
static void check_touch(const gjk_cast_path *path, const gjk_cast_result *r, bool curved) {
  case_collider at_a = a, at_b = b;  // with the memory of a and b
  case_shape shape_a = pair.a, shape_b = pair.b;
  at_a.collider = moved_to(&a.collider, &r->rest_a);
  at_b.collider = moved_to(&b.collider, &r->rest_b);
  shape_a.pose.position = r->rest_a;
  shape_b.pose.position = r->rest_b;
  const bool stands = path->to_a->x == 0 && path->to_a->y == 0 && path->to_a->z == 0;
  const long double rounding = sqrtl(3), step = (long double)step_of(&a.collider, &b.collider, path);
  const long double on_a = accurate_point_outside(&shape_a, &at_a, r->point_a);
  const long double on_b = accurate_point_outside(&shape_b, &at_b, r->point_b);
  CHECK_MSG(r->saturated || on_a <= (curved ? 2 : 1) + (stands ? 0 : rounding), "A's point is %Lg outside", on_a);
  CHECK_MSG(r->saturated || on_b <= (curved ? 5 : 3) + 2 * rounding + step, "B's point is %Lg outside", on_b);
  int64_t start[3], place[3];
  place_at(&a.collider, &b.collider, path, 0, start);
  place_at(&a.collider, &b.collider, path, r->fraction, place);
  const long double n[3] = {r->normal.x, r->normal.y, r->normal.z};
  long double gap = accurate_separation(&pair, &a, &b, &r->normal), length = 1e6L;
  for (int k = 0; k < 3; k++) {
    gap += ldexpl((long double)(place[k] - start[k]), -30) * ldexpl(n[k], -30);
    length += fabsl(ldexpl((long double)place[k], -30)) + fabsl(ldexpl((long double)(place[k] - start[k]), -30));
  }
  length += (long double)a.collider.radius + b.collider.radius;
  CHECK_MSG(gap >= path->margin - ldexpl(length, -27) - (curved ? 2 : 0), "the normal parts by %Lg of %ld", gap,
            (long)path->margin);
}

// Of a miss: at no whole place near the way are the shapes deeper in each other than 6 LSB, of which 3 are those of depths,
// 2 those of decisions, and 1 the rounding of the place.
static void check_shallow(const gjk_cast_path *path) {
  static gjk_epa_cell cells[GJK_EPA_CELLS(256)];
  const gjk_workspace workspace = {cells, sizeof cells / sizeof cells[0]};
  const gjk_collider still = moved_to(&a.collider, &origin);
  for (int i = 0; i <= 64; i++) {
    int64_t place[3];
    gjk_distance_result gap;
    place_at(&a.collider, &b.collider, path, (int64_t)i * (GJK_Q30_ONE / 64), place);
    const gjk_vec3 at = {(int32_t)(place[0] >> 30), (int32_t)(place[1] >> 30), (int32_t)(place[2] >> 30)};
    const gjk_collider there = moved_to(&b.collider, &at);
    CHECK(gjk_signed_distance(&still, &there, NULL, &workspace, &gap) == GJK_OK);
    CHECK_MSG(gap.upper >= path->margin - 6, "gap %ld of a miss", (long)gap.upper);
  }
}

// The reference decides the same, or the way grazes: then it does with 3 LSB more or less. The reference knows no depths, so
// where the radius allows no less, a look at places along the way stands in.
static void check_decision(const gjk_cast_path *path, const gjk_cast_result *r, extremes *e) {
  reference_cast_result reference, lenient;
  reference_of(path, path->margin, &reference);
  if (reference.hit == r->hit) {
    return;
  }
  e->differ++;
  if (!r->hit && (int64_t)pair.a.convex_radius + pair.b.convex_radius + path->margin < 3) {
    check_shallow(path);
    return;
  }
  reference_of(path, path->margin + (r->hit ? 3.0 : -3.0), &lenient);
  CHECK_MSG(lenient.hit == r->hit, "hit %d, double's gap %g", r->hit, reference.gap);
}

static void test_random(bool curved) {
  random_state random = random_seed(check_seed(SEED) + (curved ? 2 : 1));
  extremes e = {1e9L, -1e9L, 0, 0, 0, 0};
  const unsigned long trials = check_trials(curved ? 30000 : 100000);
  for (unsigned long i = 0; i < trials; i++) {
    gjk_vec3 to_a, to_b;
    gjk_q16 margin;
    gjk_cast_result r;
    check_trial(i, case_show, &pair);
    if (!random_cast(&random, curved, &pair, &to_a, &to_b, &margin) || !case_pair_build(&pair, false, &a, &b)) {
      continue;
    }
    const gjk_cast_path path = {&to_a, &to_b, margin};
    memset(&r, 0, sizeof r);
    CHECK(gjk_cast(&a.collider, &b.collider, &path, &r) == GJK_OK);
    const gjk_status checked = gjk_check_cast(&a.collider, &b.collider, &path, &r);
    CHECK(checked == GJK_OK || checked == GJK_ERROR_UNSUPPORTED);
    check_lazy(&path, &r);
    e.hits += r.hit;
    e.misses += !r.hit;
    e.inside += r.hit && r.inside;
    check_decision(&path, &r, &e);
    if (!r.hit || r.inside || (!curved && (int64_t)pair.a.convex_radius + pair.b.convex_radius + margin == 0)) {
      continue;
    }
    check_gap(&path, &r, curved ? 4 : 2, &e);
    check_touch(&path, &r, curved);
    if (!curved) {
      check_hit(&a.collider, &b.collider, &path, &r, step_of(&a.collider, &b.collider, &path));
    }
  }
  printf(
      "%s: %lu hits, %lu of them at the start, %lu misses; double decides %lu otherwise; gaps at the fraction %Lg to "
      "%Lg\n",
      curved ? "curved" : "polytopes", e.hits, e.inside, e.misses, e.differ, e.least, e.most);
  CHECK(e.hits > trials / 5 && e.misses > trials / 10 && e.inside > trials / 200);
}

// Nothing moves, and the gap is 2^-17 LSB: the plane's gap is 0, so the rounds end at the start, but the shapes are apart.
// There the heading of the way, which is none, was read unset; valgrind shows that.
static void test_standing(void) {
  static const gjk_shape ball = GJK_SPHERE(GJK_Q16(0.5));
  const gjk_collider left = placed(&ball, origin), right = placed(&ball, (gjk_vec3){65536, 1, 0});
  const gjk_cast_path path = {NULL, NULL, 0};
  gjk_cast_result r;
  CHECK(gjk_cast(&left, &right, &path, &r) == GJK_OK);
  CHECK(!r.hit);
  CHECK(gjk_check_cast(&left, &right, &path, &r) == GJK_OK);
}

int main(void) {
  test_standing();
  test_grazing();
  test_closest_ends();
  test_sliding();
  test_lengths();
  test_large_margins();
  test_aligned();
  test_random(false);
  test_random(true);
  case_pair_release(&pair, &a, &b);
  return check_done("cast_round");
}
