// gjk2_cast, gjk2_cast_ray and gjk2_check_cast against brute force: the way clipped by every edge of A - B, in fractions of
// 128 bits.
#include "placed2.h"
#include "plane.h"
#include "wide_root.h"

#define SEED 2014
#define TRIALS check_trials(40000)

// LSB. By how much a distance may be off of centres more than 16384 units, and less than 32768, apart.
#define FAR_ERROR 1

typedef struct cast_case {
  plane_body pair[2];
  gjk2_vec to_a, to_b;
  bool moves_a;
  gjk_q16 margin;
  plane_point t;  // of B against A
  plane_truth truth;
} cast_case;

// p / q, q > 0.
typedef struct rational {
  plane_wide p, q;
} rational;

// The sign of a - b. Pre: p and q below 2^67 in size, products as four parts.
static int compare_fractions(rational a, rational b) {
  // Whole parts first, then remainders: products stay below 2^127 where q < 2^63.
  const plane_wide left = a.p * b.q, right = b.p * a.q;
  return (left > right) - (left < right);
}

typedef struct cast_truth {
  bool hit, inside;
  rational enters;
  plane_point normal;  // of a half plane that it enters by
} cast_truth;

// Clips the way by n . x <= height. False: nothing is left of it.
static bool clip(plane_point n, plane_wide height, plane_point t, cast_truth *out, rational *leaves) {
  const plane_wide ahead = (plane_wide)n.x * t.x + (plane_wide)n.y * t.y;
  out->inside = out->inside && height >= 0;
  if (ahead == 0) {
    return height >= 0;
  }
  const rational at = {ahead > 0 ? height : -height, ahead > 0 ? ahead : -ahead};
  if (ahead > 0) {
    *leaves = compare_fractions(at, *leaves) < 0 ? at : *leaves;
  } else if (compare_fractions(at, out->enters) >= 0) {
    out->enters = at;
    out->normal = n;
  }
  return true;
}

// Where does the way enter the hull of A - B? Whatever its dimension: of a segment two ends bound it, of a point four sides.
static void cast_truth_of(const plane_truth *c, plane_point t, cast_truth *out) {
  const plane_point sides[4] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  rational leaves = {1, 1};
  cast_truth found = {true, true, {0, 1}, {0, 0}};
  for (int i = 0; i < 4 && c->count == 1; i++) {
    const plane_point p = c->hull[0];
    found.hit =
        clip(sides[i], (plane_wide)sides[i].x * p.x + (plane_wide)sides[i].y * p.y, t, &found, &leaves) && found.hit;
  }
  for (int i = 0; i < c->count && c->count > 1; i++) {
    const plane_point p = c->hull[i], q = c->hull[(i + 1) % c->count], n = {q.y - p.y, p.x - q.x};
    found.hit = clip(n, (plane_wide)n.x * p.x + (plane_wide)n.y * p.y, t, &found, &leaves) && found.hit;
    if (c->count == 2) {
      const plane_point e = {q.x - p.x, q.y - p.y};
      found.hit = clip(e, (plane_wide)e.x * q.x + (plane_wide)e.y * q.y, t, &found, &leaves) && found.hit;
    }
  }
  found.hit = found.hit && compare_fractions(found.enters, leaves) <= 0;
  found.inside = found.inside && found.hit;
  *out = found;
}

// The sign of 2 d - twice for the distance d of the segment from p to q from the point o.
static int compare_from(plane_point o, plane_point p, plane_point q, int64_t twice) {
  const plane_point a = {p.x - o.x, p.y - o.y}, b = {q.x - o.x, q.y - o.y};
  return plane_compare_edge(a, b, twice);
}

static bool starts_within(const plane_truth *c, int64_t radius) {
  return c->overlap || plane_compare_distance(c, 2 * radius) <= 0;
}

// Does the way come within radius of A - B? Pre: |t| <= 2^30.
static bool comes_within(const plane_truth *c, plane_point t, int64_t radius) {
  cast_truth cores;
  const plane_point origin = {0, 0};
  cast_truth_of(c, t, &cores);
  if (cores.hit) {
    return true;
  }
  for (int i = 0; i < c->count; i++) {
    const plane_point p = c->hull[i], q = c->hull[(i + 1) % c->count];
    if (compare_from(origin, p, q, 2 * radius) <= 0 || compare_from(t, p, q, 2 * radius) <= 0 ||
        compare_from(p, origin, t, 2 * radius) <= 0) {
      return true;
    }
  }
  return false;
}

static void print_case(const void *subject) {
  const cast_case *c = (const cast_case *)subject;
  plane_print(c->pair);
  printf("  margin %d, A %d to (%d, %d) from (%d, %d), B to (%d, %d) from (%d, %d)\n", c->margin, c->moves_a, c->to_a.x,
         c->to_a.y, c->pair[0].pose.position.x, c->pair[0].pose.position.y, c->to_b.x, c->to_b.y,
         c->pair[1].pose.position.x, c->pair[1].pose.position.y);
}

static struct { unsigned long exact_hits, exact_misses, inside, round_hits, round_misses, iterations_most; } tally;

// floor(p / q)
static int64_t floor_of(plane_wide p, plane_wide q) {
  return (int64_t)(p / q - (p % q < 0));
}

// way s, rounded along up; to the nearest integer where up is 0, a tie up.
static int64_t part_of(int64_t way, rational s, int64_t up) {
  const plane_wide p = (plane_wide)way * s.p;
  return up > 0 ? -floor_of(-p, s.q) : up < 0 ? floor_of(p, s.q) : floor_of(2 * p + s.q, 2 * (plane_wide)s.q);
}

static bool overlap_inside(const gjk2_collider *a, const gjk2_collider *b, gjk_q16 margin) {
  gjk2_penetration_result p;
  gjk2_distance_result gap;
  if (margin > 0) {
    CHECK(gjk2_distance(a, b, NULL, &gap) == GJK_OK);
    return gap.intersecting || gap.distance < margin;
  }
  CHECK(gjk2_penetration(a, b, NULL, &p) == GJK_OK);
  return p.intersecting && p.depth > 0;
}

// With both at rest the shapes share no inner point, or are the margin apart; off: LSB by which that may be measured wrong.
static void check_rest(const cast_case *c, int64_t off, const gjk2_cast_result *out) {
  gjk2_collider a = c->pair[0].collider, b = c->pair[1].collider;
  CHECK(gjk2_collider_move(&a, &out->rest_a) == GJK_OK);
  CHECK(gjk2_collider_move(&b, &out->rest_b) == GJK_OK);
  CHECK(!overlap_inside(&a, &b, c->margin - (gjk_q16)off));
}

// Both moved by the rational and a number of steps of 2^-30 on top, to the nearest LSB.
static void place_at(const cast_case *c, int64_t part, gjk2_collider *a, gjk2_collider *b) {
  *a = c->pair[0].collider;
  *b = c->pair[1].collider;
  const gjk2_vec from_a = c->pair[0].pose.position, from_b = c->pair[1].pose.position;
  gjk2_vec at_a = from_a, at_b = from_b;
  const double at = (double)part / 1073741824.0;
  if (c->moves_a) {
    at_a.x = (int32_t)(from_a.x + llround(((double)c->to_a.x - from_a.x) * at));
    at_a.y = (int32_t)(from_a.y + llround(((double)c->to_a.y - from_a.y) * at));
  }
  at_b.x = (int32_t)(from_b.x + llround(((double)c->to_b.x - from_b.x) * at));
  at_b.y = (int32_t)(from_b.y + llround(((double)c->to_b.y - from_b.y) * at));
  CHECK(gjk2_collider_move(a, &at_a) == GJK_OK);
  CHECK(gjk2_collider_move(b, &at_b) == GJK_OK);
}

static void check_points(const cast_case *c, const gjk2_cast_result *out) {
  gjk2_collider a, b;
  place_at(c, out->fraction, &a, &b);
  if (out->saturated) {
    return;
  }
  const long double slack = 1.5L + (fabsl((long double)c->t.x) + fabsl((long double)c->t.y)) / 1073741824.0L;
  const long double from_a = plane_distance_from(&a, &out->point_a) - a.shape->convex_radius;
  const long double from_b = plane_distance_from(&b, &out->point_b) - b.shape->convex_radius;
  CHECK_MSG(from_a <= slack, "A %Lf", from_a);
  CHECK_MSG(from_b <= slack, "B %Lf", from_b);
  const long double gap =
      hypotl((long double)out->point_b.x - out->point_a.x, (long double)out->point_b.y - out->point_a.y);
  CHECK_MSG(fabsl(gap - c->margin) <= slack + 2, "%Lf", gap);
}

static void check_exact(const cast_case *c, const gjk2_cast_result *out) {
  cast_truth truth;
  cast_truth_of(&c->truth, c->t, &truth);
  CHECK(out->hit == truth.hit);
  if (!truth.hit || !out->hit) {
    tally.exact_misses++;
    return;
  }
  CHECK(out->inside == truth.inside);
  if (truth.inside) {
    tally.inside++;
    CHECK(out->fraction == 0 && out->normal.x == 0 && out->normal.y == 0);
    CHECK(gjk2_equal(out->rest_a, c->pair[0].pose.position) && gjk2_equal(out->rest_b, c->pair[1].pose.position));
    return;
  }
  tally.exact_hits++;
  const int64_t expected = floor_of(truth.enters.p << 30, truth.enters.q);
  CHECK_MSG(out->fraction == expected, "%d, not %lld", out->fraction, (long long)expected);
  const gjk2_vec n = out->certificate.direction;
  const gjk2_vec from_a = c->pair[0].pose.position, from_b = c->pair[1].pose.position;
  const int64_t x = c->moves_a ? (int64_t)c->to_a.x - from_a.x : 0, y = c->moves_a ? (int64_t)c->to_a.y - from_a.y : 0;
  CHECK(out->rest_a.x == from_a.x + part_of(x, truth.enters, 0));
  CHECK(out->rest_a.y == from_a.y + part_of(y, truth.enters, 0));
  CHECK(out->rest_b.x - out->rest_a.x ==
        (int64_t)from_b.x - from_a.x + part_of((int64_t)c->to_b.x - from_b.x - x, truth.enters, n.x));
  CHECK(out->rest_b.y - out->rest_a.y ==
        (int64_t)from_b.y - from_a.y + part_of((int64_t)c->to_b.y - from_b.y - y, truth.enters, n.y));
  // The normal leads against the way, and across it nothing of A - B lies beyond the place of entry.
  const long double size = hypotl(out->normal.x, out->normal.y);
  CHECK(fabsl(size - 1073741824.0L) <= 4);
  const long double s = (long double)truth.enters.p / (long double)truth.enters.q;
  for (int i = 0; i < c->truth.count; i++) {
    const long double u = c->truth.hull[i].x - s * c->t.x, v = c->truth.hull[i].y - s * c->t.y;
    CHECK_MSG((u * out->normal.x + v * out->normal.y) / size <= hypotl(u, v) * 0x1p-27L + 0x1p-20L, "%d", i);
  }
  CHECK((plane_wide)n.x * c->t.x + (plane_wide)n.y * c->t.y < 0);
  check_points(c, out);
}

// How far the core of B at a rational is from that of A, LSB.
static long double distance_at(const cast_case *c, long double s) {
  long double least = INFINITY;
  bool inside = c->truth.count > 2;
  for (int i = 0; i < c->truth.count; i++) {
    const plane_point p = c->truth.hull[i], q = c->truth.hull[(i + 1) % c->truth.count];
    const long double x = q.x - p.x, y = q.y - p.y, u = s * c->t.x - p.x, v = s * c->t.y - p.y;
    const long double length = x * x + y * y;
    long double at = length > 0 ? (u * x + v * y) / length : 0;
    at = at < 0 ? 0 : at > 1 ? 1 : at;
    const long double distance = hypotl(u - at * x, v - at * y);
    least = distance < least ? distance : least;
    inside = inside && x * v - y * u >= 0;
  }
  return inside ? -least : least;
}

// Are decisions exact? Centres of shapes whose bounding circles meet are at most 16384 units apart then.
static bool is_near(const cast_case *c, int64_t radius) {
  return radius + c->pair[0].collider.core_radius + c->pair[1].collider.core_radius <= INT32_C(1) << 30;
}

static void check_round(const cast_case *c, int64_t radius, const gjk2_cast_result *out) {
  const int64_t off = is_near(c, radius) ? 0 : FAR_ERROR;
  CHECK(out->hit ? comes_within(&c->truth, c->t, radius + off) : !comes_within(&c->truth, c->t, radius - off));
  if (!out->hit) {
    tally.round_misses++;
    return;
  }
  CHECK(out->inside ? starts_within(&c->truth, radius + off) : !starts_within(&c->truth, radius - off));
  if (out->inside) {
    tally.inside++;
    CHECK(out->fraction == 0);
    CHECK(gjk2_equal(out->rest_a, c->pair[0].pose.position) && gjk2_equal(out->rest_b, c->pair[1].pose.position));
    return;
  }
  tally.round_hits++;
  const long double gap = distance_at(c, out->fraction / 1073741824.0L) - radius;
  CHECK_MSG(gap >= -0x1p-20L, "before contact: %Lf", gap);
  CHECK_MSG(gap <= 2 + (fabsl((long double)c->t.x) + fabsl((long double)c->t.y)) / 1073741824.0L, "at contact: %Lf",
            gap);
  check_rest(c, off, out);
  check_points(c, out);
}

static struct { unsigned long proven, unsupported, forged; } checks;

// The result is proven; one that says something else is not.
static void check_proof(random_state *r, const cast_case *c, const gjk2_cast_path *path, int64_t radius,
                        const gjk2_cast_result *out) {
  const gjk2_collider *a = &c->pair[0].collider, *b = &c->pair[1].collider;
  const gjk_status status = gjk2_check_cast(a, b, path, out);
  if (status == GJK_ERROR_UNSUPPORTED) {
    CHECK(radius > 0);
    checks.unsupported++;
    return;
  }
  if (status == GJK_ERROR_UNPROVEN && !is_near(c, radius)) {
    checks.unsupported++;
    return;
  }
  CHECK_MSG(status == GJK_OK, "%s, proof %d", status == GJK_ERROR_UNPROVEN ? "unproven" : "unsupported",
            out->certificate.proof);
  checks.proven++;
  gjk2_cast_result huge = *out;  // a direction whose square does not fit 64 bits
  huge.certificate.direction.x = huge.certificate.direction.y = INT32_MIN;
  CHECK(gjk2_check_cast(a, b, path, &huge) != GJK_OK || out->certificate.proof != GJK2_CAST_PROOF_SHORT);
  // Of a hit no direction across the way shows a miss, also where the way only touches.
  for (int i = 0; i < 14 && out->hit && llabs(c->t.x) <= GJK_Q30_ONE / 2 && llabs(c->t.y) <= GJK_Q30_ONE / 2; i++) {
    const gjk_q30 sign = i % 2 == 0 ? 1 : -1;
    gjk2_cast_result across = *out;
    across.hit = false;
    across.certificate.proof = (uint8_t)(i / 2);
    across.certificate.direction.x = -sign * (gjk_q30)c->t.y;
    across.certificate.direction.y = sign * (gjk_q30)c->t.x;
    CHECK_MSG(gjk2_check_cast(a, b, path, &across) != GJK_OK, "across the way, proof %d", i / 2);
  }
  for (int i = 0; i < 5; i++) {
    gjk2_cast_result forged = *out;
    const gjk_q16 off = random_below(r, 2) == 0 ? 1 : -1;
    switch (random_below(r, 8)) {
      case 0: forged.hit = !forged.hit; break;
      case 1:
        forged.fraction += radius == 0 ? off : llabs(c->t.x) + llabs(c->t.y) > 64 ? 1 << 29 : -1 - forged.fraction;
        break;
      case 2: forged.rest_b.x += off; break;
      case 3: forged.rest_b.y += off; break;
      case 4: forged.rest_a.x += off; break;
      case 5: forged.inside = !forged.inside; break;
      case 6: forged.normal.x += 9 * off; break;
      default: forged.point_a.y += 4 * off; break;
    }
    if (!out->hit && forged.hit == out->hit) {
      continue;  // a miss has no other fields
    }
    if (!out->hit) {
      forged.certificate.proof = (uint8_t)random_below(r, 7);
      forged.certificate.count = (uint8_t)random_below(r, 4);
      forged.inside = random_below(r, 2) == 0;
      forged.fraction = random_range(r, 0, GJK_Q30_ONE);
    } else if (!forged.hit) {
      forged.certificate.proof = (uint8_t)random_below(r, 7);
    }
    checks.forged++;
    CHECK_MSG(gjk2_check_cast(a, b, path, &forged) != GJK_OK,
              "hit %d inside %d proof %d count %d fraction %d; is %d %d %d %d", forged.hit, forged.inside,
              forged.certificate.proof, forged.certificate.count, forged.fraction, out->hit, out->inside,
              out->certificate.proof, out->fraction);
  }
}

static void check_case(random_state *r, const cast_case *c) {
  const gjk2_collider *a = &c->pair[0].collider, *b = &c->pair[1].collider;
  const int64_t radius = (int64_t)a->shape->convex_radius + b->shape->convex_radius + c->margin;
  const gjk2_cast_path path = {c->moves_a ? &c->to_a : NULL, &c->to_b, c->margin};
  gjk2_cast_result out = {0};
  CHECK(gjk2_cast(a, b, &path, &out) == GJK_OK);
  tally.iterations_most = out.iterations > tally.iterations_most ? out.iterations : tally.iterations_most;
  CHECK(out.certificate.proof != GJK2_CAST_PROOF_SPHERES || out.iterations == 0);
  if (radius == 0) {
    check_exact(c, &out);
  } else {
    check_round(c, radius, &out);
  }
  check_proof(r, c, &path, radius, &out);
  // Reversed: A against B, by the same ways.
  const gjk2_cast_path reversed = {&c->to_b, c->moves_a ? &c->to_a : NULL, c->margin};
  gjk2_cast_result back;
  CHECK(gjk2_cast(b, a, &reversed, &back) == GJK_OK);
  CHECK(back.hit == out.hit || !is_near(c, radius));
  if (out.hit && back.hit) {
    CHECK(!is_near(c, radius) || back.inside == out.inside);
    CHECK(radius > 0 || back.fraction == out.fraction);
  }
}

static void finish_case(cast_case *c) {
  for (int i = 0; i < 2; i++) {
    plane_place(&c->pair[i], i == 0);
  }
  const gjk2_vec from_a = c->pair[0].pose.position, from_b = c->pair[1].pose.position;
  c->t.x = (int64_t)c->to_b.x - from_b.x - (c->moves_a ? (int64_t)c->to_a.x - from_a.x : 0);
  c->t.y = (int64_t)c->to_b.y - from_b.y - (c->moves_a ? (int64_t)c->to_a.y - from_a.y : 0);
  plane_truth_of(&c->pair[0].collider, &c->pair[1].collider, &c->truth);
}

static void test_random(random_state *r) {
  static cast_case c;
  static const int32_t sizes[] = {3, 20, 1000, 60000, 3000000, 100000000};
  for (unsigned long i = 0; i < TRIALS; i++) {
    check_trial(i, print_case, &c);
    const int32_t size = sizes[random_below(r, 6)];
    plane_random_pair(r, size, size * 3, c.pair);
    for (int k = 0; k < 2 && random_below(r, 3) != 0; k++) {
      c.pair[0].shape.convex_radius = 0;
      c.pair[1].shape.convex_radius = 0;
    }
    c.moves_a = random_below(r, 3) == 0;
    c.margin = random_below(r, 4) == 0 ? random_range(r, 0, size / 4) : 0;
    const gjk2_vec from_a = c.pair[0].pose.position, from_b = c.pair[1].pose.position;
    const gjk2_vec centre = c.pair[0].collider.centre, other = c.pair[1].collider.centre;
    // Towards A, and past it.
    const int32_t far = random_range(r, 1, 4), aside = random_range(r, 0, size);
    c.to_a.x = from_a.x + random_range(r, -size, size);
    c.to_a.y = from_a.y + random_range(r, -size, size);
    c.to_b.x = from_b.x + (centre.x - other.x) / 2 * far + random_range(r, -aside, aside);
    c.to_b.y = from_b.y + (centre.y - other.y) / 2 * far + random_range(r, -aside, aside);
    if (random_below(r, 8) == 0) {
      c.to_b.x = from_b.x;
    }
    if (random_below(r, 20) == 0) {
      c.to_b = from_b;
    }
    finish_case(&c);
    check_case(r, &c);
  }
}

// A body of a few LSB or more, without radius, at a place that keeps it in the world.
static void place_small(random_state *r, int32_t size, gjk2_vec centre, plane_body *body) {
  plane_random_shape(r, size, body);
  body->shape.convex_radius = 0;
  body->pose.rotation = plane_random_rotation(r);
  body->pose.position.x = 0;
  body->pose.position.y = 0;
  plane_place(body, true);
  body->pose.position.x = centre.x - body->collider.centre.x;
  body->pose.position.y = centre.y - body->collider.centre.y;
}

// x a + y b = the greatest common divisor, which is returned.
static int64_t bezout(int64_t a, int64_t b, int64_t *x, int64_t *y) {
  if (b == 0) {
    *x = a < 0 ? -1 : 1;
    *y = 0;
    return a < 0 ? -a : a;
  }
  int64_t u, v;
  const int64_t divisor = bezout(b, a % b, &u, &v);
  *x = v;
  *y = u - a / b * v;
  return divisor;
}

static struct { unsigned long hits, misses; } grazing;

// A line that touches A - B in a corner or along an edge, or passes it by the least that the lattice allows.
static void test_grazing(random_state *r) {
  static cast_case c;
  for (unsigned long i = 0; i < TRIALS / 4; i++) {
    check_trial(i, print_case, &c);
    const int32_t size = random_below(r, 2) == 0 ? 40 : 200000;
    const gjk2_vec centre = {0, 0};
    place_small(r, size, centre, &c.pair[0]);
    place_small(r, size, centre, &c.pair[1]);
    c.moves_a = false;
    c.margin = 0;
    c.to_b = c.pair[1].pose.position;
    finish_case(&c);
    // Along an edge of A - B, or any way.
    const int k = (int)random_below(r, (uint32_t)c.truth.count);
    const plane_point p = c.truth.hull[k], q = c.truth.hull[(k + 1) % c.truth.count];
    plane_point t = {random_range(r, -size, size), random_range(r, -size, size)};
    if (random_below(r, 2) == 0 && c.truth.count > 1) {
      t.x = q.x - p.x;
      t.y = q.y - p.y;
    }
    int64_t x, y;
    const int64_t divisor = bezout(t.x, t.y, &x, &y);
    if (divisor == 0) {
      continue;
    }
    t.x /= divisor;
    t.y /= divisor;
    int64_t side = 0;
    for (int n = 0; n < c.truth.count; n++) {
      const int64_t at = t.x * c.truth.hull[n].y - t.y * c.truth.hull[n].x;
      side = n == 0 || at > side ? at : side;
    }
    // Moving B by (u, v) lowers every side by t x (u, v) = t.x v - t.y u.
    const int64_t wanted = side + random_range(r, -1, 1);
    plane_wide u = -(plane_wide)y * wanted, v = (plane_wide)x * wanted;
    // Back along the way, so that A - B lies ahead.
    const int64_t long_way = 4 * (int64_t)size, norm = llabs(t.x) + llabs(t.y);
    const plane_wide back = (u * t.x + v * t.y) / (t.x * t.x + t.y * t.y) + long_way / norm + 1;
    u -= back * t.x;
    v -= back * t.y;
    c.pair[1].pose.position.x += (int32_t)u;
    c.pair[1].pose.position.y += (int32_t)v;
    const int64_t times = 2 * (long_way / norm + 1);
    c.to_b.x = (int32_t)(c.pair[1].pose.position.x + times * t.x);
    c.to_b.y = (int32_t)(c.pair[1].pose.position.y + times * t.y);
    finish_case(&c);
    check_case(r, &c);
    cast_truth truth;
    cast_truth_of(&c.truth, c.t, &truth);
    grazing.hits += truth.hit;
    grazing.misses += !truth.hit;
  }
}

static struct { unsigned long hits, misses; } closest;

// A place before the edge from p on with the outward normal n, where n . (place - p) = rise times n's divisor, and rise is the
// last one within the radius or the first one beyond: at most an LSB / |n| apart.
static plane_point before_edge(random_state *r, plane_point p, plane_point n, int64_t radius) {
  int64_t x, y;
  const int64_t divisor = bezout(n.x, n.y, &x, &y);
  const plane_point m = {n.x / divisor, n.y / divisor};
  const plane_wide square = (plane_wide)m.x * m.x + (plane_wide)m.y * m.y;
  const plane_wide rise = wide_root(radius * (plane_wide)radius * square) + random_below(r, 2);
  plane_wide u = x * rise, v = y * rise;
  const plane_wide along = m.x * v - m.y * u;
  const plane_wide past = (along % square + square) % square + square * random_below(r, (uint32_t)divisor);
  const plane_wide steps = (past - along) / square;
  u += -m.y * steps;
  v += m.x * steps;
  const plane_point place = {p.x + (int64_t)u, p.y + (int64_t)v};
  return place;
}

// A vertex that lies farthest along d.
static plane_point outermost(const plane_truth *c, plane_point d) {
  plane_point best = c->hull[0];
  for (int i = 1; i < c->count; i++) {
    const plane_point p = c->hull[i];
    best = d.x * (p.x - best.x) + d.y * (p.y - best.y) > 0 ? p : best;
  }
  return best;
}

// Ways that end, or begin, where the gap is the margin, or as little more as the lattice allows: before an edge, or an LSB
// aside of where a vertex is met.
static void test_ends(random_state *r) {
  static cast_case c;
  static const int32_t sizes[] = {40, 200000, 60000000};
  for (unsigned long i = 0; i < TRIALS / 4; i++) {
    check_trial(i, print_case, &c);
    const int32_t size = sizes[random_below(r, 3)];
    const gjk2_vec centre = {0, 0};
    place_small(r, size, centre, &c.pair[0]);
    place_small(r, size, centre, &c.pair[1]);
    c.moves_a = false;
    c.margin = random_range(r, 1, random_below(r, 4) == 0 ? INT32_C(1) << 30 : 2 * size);
    c.to_b = c.pair[1].pose.position;
    finish_case(&c);
    const int k = (int)random_below(r, (uint32_t)c.truth.count);
    const plane_point p = c.truth.hull[k], q = c.truth.hull[(k + 1) % c.truth.count], n = {q.y - p.y, p.x - q.x};
    const int side = random_below(r, 2) == 0 ? -1 : 1, upright = (int)random_below(r, 2);
    const plane_point d = {upright ? 0 : side, upright ? side : 0}, tip = outermost(&c.truth, d);
    const int aside = random_range(r, -1, 1);
    plane_point place = {tip.x + d.x * c.margin + d.y * aside, tip.y + d.y * c.margin + d.x * aside};
    const bool of_edge = c.truth.count > 1 && random_below(r, 4) != 0;
    if (of_edge) {
      place = before_edge(r, p, n, c.margin);
    }
    const gjk2_vec at = c.pair[1].pose.position, near = {at.x + (int32_t)place.x, at.y + (int32_t)place.y};
    const int32_t far = 8 * size;
    gjk2_vec away = {near.x + (n.x < 0 ? -1 : 1) * random_range(r, 0, far),
                     near.y + (n.y < 0 ? -1 : 1) * random_range(r, 0, far)};
    if (!of_edge && random_below(r, 2) == 0) {
      *(upright ? &away.y : &away.x) = upright ? near.y : near.x;  // the line passes the vertex at the margin
    }
    const bool begins = random_below(r, 2) == 0;
    c.pair[1].pose.position = begins ? near : away;
    c.to_b = begins ? away : near;
    finish_case(&c);
    check_case(r, &c);
    const bool hit = comes_within(&c.truth, c.t, c.margin);
    closest.hits += hit;
    closest.misses += !hit;
  }
}

static struct { unsigned long hits, misses; } wide;

// Ways of up to 2^32, from one corner of the world to another, past a body of any size; half of them up to 2^30, the most that
// gjk2_check_cast proves with a radius.
static void test_wide(random_state *r) {
  static cast_case c;
  for (unsigned long i = 0; i < TRIALS / 4; i++) {
    check_trial(i, print_case, &c);
    const bool checked = random_below(r, 2) == 0;
    const int32_t size = 1 << random_range(r, 2, 22), far = (checked ? 1 << 29 : INT32_MAX) - (1 << 24);
    const gjk2_vec centre = plane_random_vec(r, far);
    // Through about the centre, as far as the world lets it; or from there to anywhere.
    const bool leaves = random_below(r, 8) == 0;
    const bool across = checked && random_below(r, 2) == 0;
    const gjk2_vec away = {across ? centre.x < 0 ? far : -far : random_range(r, -far, far),
                           across ? centre.y < 0 ? far : -far : random_range(r, -far, far)},
                   near = {centre.x + random_range(r, -size, size), centre.y + random_range(r, -size, size)},
                   start = leaves ? near : away;
    place_small(r, size, centre, &c.pair[0]);
    place_small(r, size, start, &c.pair[1]);
    c.moves_a = random_below(r, 4) == 0;
    c.margin = checked ? 1 << random_range(r, 0, 27) : 0;
    const double longer = random_below(r, 4) == 0 ? 0.9 : 1 + random_below(r, 1000) / 1000.0;
    const int32_t aside = random_below(r, 3) == 0 ? 0 : 2 * size;
    double x =
        (double)c.pair[1].pose.position.x + longer * ((double)centre.x - start.x) + random_range(r, -aside, aside);
    double y =
        (double)c.pair[1].pose.position.y + longer * ((double)centre.y - start.y) + random_range(r, -aside, aside);
    c.to_a.x = c.pair[0].pose.position.x + random_range(r, -size, size);
    c.to_a.y = c.pair[0].pose.position.y + random_range(r, -size, size);
    x = leaves ? away.x : x < -far ? -far : x > far ? far : x;
    y = leaves ? away.y : y < -far ? -far : y > far ? far : y;
    c.to_b.x = (int32_t)x;
    c.to_b.y = (int32_t)y;
    finish_case(&c);
    if (llabs(c.t.x) >> 32 != 0 || llabs(c.t.y) >> 32 != 0) {
      continue;
    }
    check_case(r, &c);
    cast_truth truth;
    cast_truth_of(&c.truth, c.t, &truth);
    wide.hits += truth.hit;
    wide.misses += !truth.hit;
  }
}

// One way in two halves hits where the whole does; a ray does what a point does.
static void test_halves_and_rays(random_state *r) {
  static cast_case c;
  static const gjk2_shape point = GJK2_POINT;
  for (unsigned long i = 0; i < TRIALS / 4; i++) {
    check_trial(i, print_case, &c);
    const int32_t size = random_below(r, 2) == 0 ? 30 : 300000;
    plane_random_pair(r, size, size * 3, c.pair);
    c.pair[0].shape.convex_radius = 0;
    c.pair[1].shape.convex_radius = 0;
    c.moves_a = false;
    const gjk2_vec from = c.pair[1].pose.position;
    const gjk2_vec half = plane_random_vec(r, 2 * size);
    c.to_b.x = from.x + 2 * half.x;
    c.to_b.y = from.y + 2 * half.y;
    finish_case(&c);
    const gjk2_collider *a = &c.pair[0].collider;
    gjk2_collider later = c.pair[1].collider;
    const gjk2_vec middle = {from.x + half.x, from.y + half.y};
    gjk2_cast_result whole, first, second;
    const gjk2_cast_path path = {NULL, &c.to_b, 0}, to_middle = {NULL, &middle, 0};
    CHECK(gjk2_cast(a, &later, &path, &whole) == GJK_OK);
    CHECK(gjk2_cast(a, &later, &to_middle, &first) == GJK_OK);
    CHECK(gjk2_collider_move(&later, &middle) == GJK_OK);
    CHECK(gjk2_cast(a, &later, &path, &second) == GJK_OK);
    CHECK(whole.hit == (first.hit || second.hit));
    if (first.hit) {
      CHECK(first.inside == whole.inside && first.fraction / 2 == whole.fraction);
    }
    gjk2_cast_result ray;
    const gjk2_collider end = placed2(&point, from.x, from.y);
    CHECK(gjk2_cast(a, &end, &path, &whole) == GJK_OK);
    CHECK(gjk2_cast_ray(a, &from, &c.to_b, &ray) == GJK_OK);
    CHECK(ray.hit == whole.hit);
    if (whole.hit) {
      CHECK(ray.fraction == whole.fraction && ray.inside == whole.inside && gjk2_equal(ray.point_a, whole.point_a) &&
            gjk2_equal(ray.point_b, whole.point_b) && gjk2_equal(ray.rest_b, whole.rest_b) &&
            ray.normal.x == whole.normal.x && ray.normal.y == whole.normal.y);
    }
  }
}

// Ellipses: no contact before the fraction, and little gap at it.
static void test_curved(random_state *r) {
  static cast_case c;
  unsigned long hits = 0, misses = 0;
  for (unsigned long i = 0; i < TRIALS / 10; i++) {
    check_trial(i, NULL, NULL);
    const int32_t size = random_below(r, 2) == 0 ? 2000 : 300000;
    plane_random_pair(r, size, size * 2, c.pair);
    c.pair[0].shape = (gjk2_shape)GJK2_ELLIPSE(random_range(r, 1, size), random_range(r, 1, size));
    c.moves_a = false;
    c.margin = random_below(r, 2) == 0 ? 0 : random_range(r, 0, size / 4);
    const gjk2_vec from = c.pair[1].pose.position, at = c.pair[0].pose.position, other = c.pair[1].collider.centre;
    c.to_b.x = from.x + 2 * (at.x - other.x) + random_range(r, -5 * size, 5 * size);
    c.to_b.y = from.y + 2 * (at.y - other.y) + random_range(r, -5 * size, 5 * size);
    for (int k = 0; k < 2; k++) {
      plane_place(&c.pair[k], k == 0);
    }
    const gjk2_cast_path path = {NULL, &c.to_b, c.margin};
    gjk2_cast_result out;
    const gjk_status status = gjk2_cast(&c.pair[0].collider, &c.pair[1].collider, &path, &out);
    if (status == GJK_ERROR_ITERATION_LIMIT) {  // of a build with a low ceiling
      CHECK(GJK_ITERATIONS_MAX < 128);
      continue;
    }
    CHECK(status == GJK_OK);
    hits += out.hit;
    misses += !out.hit;
    gjk2_collider a, b;
    gjk2_distance_result gap;
    for (int k = 0; k <= 20; k++) {
      const int64_t limit = out.hit ? out.fraction : GJK_Q30_ONE;
      place_at(&c, limit * k / 20, &a, &b);
      CHECK(gjk2_distance(&a, &b, NULL, &gap) == GJK_OK || GJK_ITERATIONS_MAX < 128);
      if (!out.hit || !out.inside) {
        CHECK_MSG(gap.distance >= c.margin - 4, "gap %d at %d", gap.distance, k);
      }
    }
    if (out.hit) {
      CHECK_MSG(gap.intersecting || gap.distance <= c.margin + 5, "gap %d", gap.distance);
    }
  }
  CHECK_MSG(GJK_ITERATIONS_MAX < 128 || (hits > TRIALS / 40 && misses > TRIALS / 100), "%lu hits, %lu misses", hits,
            misses);
}

// Circles on ways that graze an ellipse: what bounds the fraction may lie far ahead, beyond where the gap is least.
static void test_curved_grazing(void) {
  static const struct {
    gjk2_vec size, from, to;
    gjk_q16 radius;
  } rows[] = {{{107325, 1887319}, {33637, -1792830}, {-1388418, -9382137}, 2},
              {{1040, 15276}, {-8890, 188640}, {5702565, 481368}, 173589}};
  static cast_case c;
  for (unsigned i = 0; i < sizeof rows / sizeof rows[0]; i++) {
    const gjk2_shape ellipse = GJK2_ELLIPSE(rows[i].size.x, rows[i].size.y), circle = GJK2_CIRCLE(rows[i].radius);
    const gjk2_pose origin = GJK2_POSE_IDENTITY;
    c.pair[0].shape = ellipse;
    c.pair[1].shape = circle;
    c.pair[0].pose = c.pair[1].pose = origin;
    c.pair[1].pose.position = rows[i].from;
    c.to_b = rows[i].to;
    for (int k = 0; k < 2; k++) {
      plane_place(&c.pair[k], k == 0);
    }
    const gjk2_cast_path path = {NULL, &c.to_b, 0};
    gjk2_collider a, b;
    gjk2_cast_result out;
    gjk2_distance_result gap;
    if (gjk2_cast(&c.pair[0].collider, &c.pair[1].collider, &path, &out) != GJK_OK) {
      CHECK(GJK_ITERATIONS_MAX < 128);
      continue;
    }
    place_at(&c, out.fraction, &a, &b);
    CHECK(out.hit && gjk2_distance(&a, &b, NULL, &gap) == GJK_OK);
    CHECK_MSG(gap.intersecting || gap.distance <= 5, "gap %d", gap.distance);
  }
}

// Ellipses of equal radii, which are circles: how near they come follows from their centres. Of small ones, and of ways
// that end in touch, the search finds an overlap where the slack says that there is none yet.
static void test_circles(random_state *r) {
  unsigned long hits = 0, misses = 0;
  for (unsigned long i = 0; i < TRIALS; i++) {
    check_trial(i, NULL, NULL);
    const int32_t size = random_below(r, 2) == 0 ? 8 : random_below(r, 2) == 0 ? 2000 : 300000;
    const int32_t radius_a = random_range(r, 1, size), radius_b = random_range(r, 1, size), sum = radius_a + radius_b;
    const gjk2_shape shape_a = GJK2_ELLIPSE(radius_a, radius_a), shape_b = GJK2_ELLIPSE(radius_b, radius_b);
    gjk2_cast_result out;
    const gjk2_vec from = plane_random_vec(r, 4 * size);
    const gjk2_collider a = placed2(&shape_a, 0, 0), b = placed2(&shape_b, from.x, from.y);
    const gjk2_vec to = plane_random_vec(r, 4 * size);
    const gjk2_cast_path path = {NULL, &to, 0};
    const gjk_status status = gjk2_cast(&a, &b, &path, &out);
    if (status == GJK_ERROR_ITERATION_LIMIT) {  // of a build with a low ceiling
      CHECK(GJK_ITERATIONS_MAX < 128);
      continue;
    }
    CHECK(status == GJK_OK);
    const double px = from.x, py = from.y, tx = to.x - px, ty = to.y - py, way = tx * tx + ty * ty;
    const double least = way > 0 ? -(px * tx + py * ty) / way : 0, foot = least < 0 ? 0 : least > 1 ? 1 : least;
    const double nearest = hypot(px + foot * tx, py + foot * ty) - sum;
    CHECK_MSG(out.hit ? nearest <= 4 : nearest >= -3, "%g of %d and %d", nearest, radius_a, radius_b);
    hits += out.hit;
    misses += !out.hit;
    if (out.hit && !out.inside) {
      const double at = (double)out.fraction / GJK_Q30_ONE, x = px + at * tx, y = py + at * ty;
      const double gap = hypot(x, y) - sum;
      CHECK_MSG(gap >= -3 && gap <= 6, "gap %g of %d and %d", gap, radius_a, radius_b);
      const double off = hypot(x, y) < 64 ? 1 : 0.1;  // the centres are rounded to be measured
      CHECK_MSG((out.normal.x * x + out.normal.y * y) / GJK_Q30_ONE >= (1 - off) * hypot(x, y), "normal %d %d",
                (int)out.normal.x, (int)out.normal.y);
      CHECK(fabs(hypot(out.normal.x, out.normal.y) - GJK_Q30_ONE) < 4);
    }
  }
  CHECK_MSG(GJK_ITERATIONS_MAX < 128 || (hits > TRIALS / 10 && misses > TRIALS / 10), "%lu hits, %lu misses", hits,
            misses);
}

// Rays against circles: no contact before the fraction, and a gap of at most 2 LSB at it.
static void test_rays(random_state *r) {
  unsigned long hits = 0, misses = 0;
  for (unsigned long i = 0; i < TRIALS / 10; i++) {
    check_trial(i, NULL, NULL);
    const int32_t size = random_below(r, 2) == 0 ? 20 : 300000, radius = random_range(r, 1, size);
    const gjk2_shape circle = GJK2_CIRCLE(radius);
    const gjk2_vec from = plane_random_vec(r, 4 * size);
    const gjk2_vec to = plane_random_vec(r, 2 * size);
    const gjk2_collider a = placed2(&circle, 0, 0);
    gjk2_cast_result out;
    CHECK(gjk2_cast_ray(&a, &from, &to, &out) == GJK_OK);
    const double px = from.x, py = from.y, tx = to.x - px, ty = to.y - py, way = tx * tx + ty * ty;
    const double least = way > 0 ? -(px * tx + py * ty) / way : 0, foot = least < 0 ? 0 : least > 1 ? 1 : least;
    const double nearest = hypot(px + foot * tx, py + foot * ty) - radius;
    CHECK_MSG(out.hit ? nearest < 1e-6 : nearest > -1e-6, "%g of %d", nearest, radius);
    hits += out.hit;
    misses += !out.hit;
    if (out.hit) {
      const double at = (double)out.fraction / GJK_Q30_ONE, gap = hypot(px + at * tx, py + at * ty) - radius;
      CHECK_MSG(out.inside ? gap < 1e-6 : gap > -1e-6 && gap <= 2.1, "gap %g of %d", gap, radius);
    }
  }
  CHECK(hits > TRIALS / 100 && misses > TRIALS / 100);
}

// A ray of more than 2^30 LSB along a diagonal, on which a corner of the shape lies: it enters there, exactly, whatever lies
// beside the line.
static void test_diagonal(void) {
  static const gjk2_vec both[4] = {{-9, -9}, {9, -9}, {9, 9}, {-9, 9}}, right[3] = {{-9, -9}, {9, -9}, {9, 9}},
                        left[3] = {{-9, -9}, {9, 9}, {-9, 9}}, line[2] = {{-9, -9}, {9, 9}};
  const gjk2_shape shapes[4] = {GJK2_POLYGON(both, 4), GJK2_POLYGON(right, 3), GJK2_POLYGON(left, 3),
                                GJK2_POLYGON(line, 2)};
  const int32_t away = INT32_C(1300000000);
  const gjk2_vec from = {-away, -away}, to = {away, away};
  const gjk_q30 fraction = (gjk_q30)(((INT64_C(1) << 30) * (away - 9)) / (2 * (int64_t)away));
  for (int i = 0; i < 4; i++) {
    const gjk2_collider a = placed2(&shapes[i], 0, 0);
    gjk2_cast_result out;
    CHECK(gjk2_cast_ray(&a, &from, &to, &out) == GJK_OK && out.hit && !out.inside);
    CHECK_MSG(out.fraction == fraction, "%d: %d not %d", i, (int)out.fraction, (int)fraction);
    CHECK(out.normal.x <= 0 && out.normal.y <= 0);
  }
}

// Circles on ways of up to 5 2^29 LSB that pass each other: 5 beside LSB apart, since the way leads along (3, 4).
static void test_long_pass(random_state *r) {
  for (int i = 0; i < 300; i++) {
    const int32_t beside = random_range(r, 10, 1 << (4 + i % 22)), length = random_range(r, 1 << 28, 1 << 29);
    const gjk2_vec from = {-4 * beside - 3 * (length / 2), 3 * beside - 4 * (length / 2)};
    const gjk2_vec to = {from.x + 3 * length, from.y + 4 * length};
    for (int32_t less = -1; less <= 1; less++) {
      const gjk2_shape a = GJK2_CIRCLE(beside), b = GJK2_CIRCLE(4 * beside - less);
      const gjk2_collider c[2] = {placed2(&a, 0, 0), placed2(&b, from.x, from.y)};
      gjk2_cast_result out;
      const gjk2_cast_path path = {NULL, &to, 0};
      CHECK(gjk2_cast(&c[0], &c[1], &path, &out) == GJK_OK);
      CHECK_MSG(out.hit == (less <= 0), "%d beside, %d less", (int)beside, (int)less);
    }
  }
}

// A hit of a smaller circle, with the point of A moved out, is no hit of a larger one, which is met before.
static void test_late_claim(void) {
  static const gjk2_shape larger = GJK2_CIRCLE(1000), smaller = GJK2_CIRCLE(996), other = GJK2_CIRCLE(50);
  const gjk2_vec to = {-5000, 0};
  const gjk2_collider a = placed2(&larger, 0, 0), less = placed2(&smaller, 0, 0), b = placed2(&other, 5000, 0);
  const gjk2_cast_path path = {NULL, &to, 0};
  gjk2_cast_result claim;
  CHECK(gjk2_cast(&less, &b, &path, &claim) == GJK_OK && gjk2_check_cast(&less, &b, &path, &claim) == GJK_OK);
  claim.point_a.x += 4;
  CHECK(gjk2_check_cast(&a, &b, &path, &claim) == GJK_ERROR_UNPROVEN);
}

// Boxes 800 LSB apart, and claims about them at the ends of what holds: a miss that touches where it ends or starts is none,
// directions are longer than allowed or not, and a start within one margin is not within another.
static void test_claims_at_ends(void) {
  static const gjk2_shape box = GJK2_BOX(100, 100);
  static const int32_t aside[3] = {65536, 80000, 131072};
  const gjk2_collider a = placed2(&box, 0, 0), b = placed2(&box, 1000, 0);
  const gjk2_collider beside = placed2(&box, 200, 0), next = placed2(&box, 201, 0);
  const gjk2_vec touch = {200, 0}, short_of = {201, 0}, far = {INT32_MIN + 300, 0};
  const gjk2_cast_path touching = {NULL, &touch, 0}, missing = {NULL, &short_of, 0}, away = {NULL, &b.position, 0};
  const gjk2_cast_path within = {NULL, &short_of, 1}, near = {NULL, &touch, 900}, nearest = {NULL, &touch, INT32_MAX},
                       long_way = {NULL, &far, 0};
  gjk2_cast_result out, claim;
  CHECK(gjk2_cast(&a, &b, &missing, &claim) == GJK_OK && !claim.hit);
  claim.certificate.proof = GJK2_CAST_PROOF_SHORT;
  claim.certificate.direction = (gjk2_vec){1, 0};
  CHECK(gjk2_check_cast(&a, &b, &missing, &claim) == GJK_OK);
  CHECK(gjk2_check_cast(&a, &b, &touching, &claim) == GJK_ERROR_UNPROVEN);
  CHECK(gjk2_check_cast(&a, &beside, &away, &claim) == GJK_ERROR_UNPROVEN);
  CHECK(gjk2_check_cast(&a, &b, &within, &claim) == GJK_ERROR_UNPROVEN);
  for (int i = 0; i < 3; i++) {
    claim.certificate.direction = (gjk2_vec){INT32_C(1) << 30, aside[i]};
    CHECK(gjk2_check_cast(&a, &b, &missing, &claim) == (i < 2 ? GJK_OK : GJK_ERROR_UNPROVEN));
  }
  CHECK(gjk2_cast(&a, &b, &near, &out) == GJK_OK && out.inside && gjk2_check_cast(&a, &b, &near, &out) == GJK_OK);
  CHECK(gjk2_check_cast(&a, &b, &touching, &out) == GJK_ERROR_UNPROVEN);
  CHECK(gjk2_cast(&a, &b, &nearest, &out) == GJK_OK && gjk2_check_cast(&a, &b, &nearest, &out) == GJK_OK);
  CHECK(gjk2_cast(&a, &next, &long_way, &out) == GJK_OK && out.hit && !out.inside && out.fraction == 0);
  CHECK(gjk2_check_cast(&a, &next, &long_way, &out) == GJK_OK);
}

// A circle ends less than 2^-24 LSB short of a segment's end, and as little aside of its foot: a direction that is rounded to
// 2^-30 does not part them from the other end.
static void test_exact_direction(void) {
  for (int32_t length = 100000001; length < 200000000; length += 2345678) {
    const gjk2_vec ends[2] = {{0, 0}, {length, -1}}, from = {-1, 3 - 2 * length}, to = {-1, 1 - length};
    const gjk2_shape segment = GJK2_POLYGON(ends, 2), circle = GJK2_CIRCLE(length - 1);
    const gjk2_cast_path path = {NULL, &to, 0};
    const gjk2_collider a = placed2(&segment, 0, 0), b = placed2(&circle, from.x, from.y);
    gjk2_cast_result out;
    CHECK(gjk2_cast(&a, &b, &path, &out) == GJK_OK && !out.hit);
    CHECK(out.certificate.proof == GJK2_CAST_PROOF_SHORT && gjk2_check_cast(&a, &b, &path, &out) == GJK_OK);
  }
}

// A support that reaches farther with each call: no search for a distance ends.
static void growing_support(const void *user, const gjk2_vec *d, gjk2_vec *out) {
  static int32_t calls;
  (void)user;
  const int32_t reach = 200 * (calls++ % 700);
  out->x = d->x > 0 ? reach : -reach;
  out->y = d->y > 0 ? reach : -reach;
}

// Distances that stay open, with margins up to the largest: the sanitisers see the sums.
static void test_open_margins(void) {
  static const gjk2_shape growing = GJK2_CUSTOM(growing_support, NULL, 200000);
  const gjk2_collider c[2] = {placed2(&growing, -2000000000, 0), placed2(&growing, 2000000000, 0)};
  gjk2_cast_result out;
  gjk2_distance_result gap;
  unsigned open = 0;
  for (int k = 0; k < 80; k++) {
    const gjk2_vec to = {k / 8 * 100000000, 0};
    const gjk2_cast_path path = {NULL, &to, INT32_MAX - k % 8};
    const gjk_status status = gjk2_cast(&c[0], &c[1], &path, &out);
    CHECK(status == GJK_OK || status == GJK_ERROR_ITERATION_LIMIT);
    open += gjk2_distance(&c[0], &c[1], NULL, &gap) == GJK_ERROR_ITERATION_LIMIT;
  }
  CHECK(open > 0);
}

// Leaves numbers on the stack whose negation would trap, where the next call has its variables.
static void stain_stack(void) {
  volatile int32_t room[8192];
  for (unsigned i = 0; i < sizeof room / sizeof room[0]; i++) {
    room[i] = INT32_MIN;
  }
}

// An overlap has no normal: nothing is made of what stands in its place.
static void test_stained(void) {
  const gjk2_shape box = GJK2_BOX(5000, 3000), ellipse = GJK2_ELLIPSE(4000, 3000), circle = GJK2_CIRCLE(3000);
  const gjk2_shape *const shapes[] = {&box, &ellipse, &circle};
  const gjk2_vec to = {20000, 9};
  for (unsigned i = 0; i < 9; i++) {
    for (gjk_q16 x = -9000; x <= 9000; x += 600) {
      for (gjk_q16 margin = 0; margin <= 1000; margin += 500) {
        const gjk2_collider a = placed2(shapes[i / 3], 0, 0), b = placed2(shapes[i % 3], x, 77);
        const gjk2_cast_path path = {NULL, &to, margin};
        gjk2_cast_result out;
        stain_stack();
        CHECK(gjk2_cast(&a, &b, &path, &out) == GJK_OK && (out.hit || x > 0));
        gjk2_decision start;
        CHECK(gjk2_within(&a, &b, margin, NULL, &start) == GJK_OK && (!start.yes || (out.hit && out.inside)));
      }
    }
  }
}

static void test_statuses(void) {
  static const gjk2_shape box = GJK2_BOX(100, 50);
  gjk2_collider a = {0}, b = {0};
  gjk2_pose pose = GJK2_POSE_IDENTITY;
  gjk2_vec to = {1000, 0}, far = {INT32_MAX, INT32_MAX}, other = {INT32_MIN, 0};
  gjk2_cast_path path = {NULL, &to, 0};
  gjk2_cast_result out, before;
  memset(&out, 0x55, sizeof out);
  before = out;
  CHECK(gjk2_collider_init(&a, &box, NULL, 0) == GJK_OK && gjk2_collider_init(&b, &box, NULL, 0) == GJK_OK);
  CHECK(gjk2_cast(&a, &b, &path, &out) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk2_collider_pose(&a, &pose) == GJK_OK && gjk2_collider_pose(&b, &pose) == GJK_OK);
  CHECK(gjk2_cast(NULL, &b, &path, &out) == GJK_ERROR_NULL && gjk2_cast(&a, NULL, &path, &out) == GJK_ERROR_NULL);
  CHECK(gjk2_cast(&a, &b, NULL, &out) == GJK_ERROR_NULL && gjk2_cast(&a, &b, &path, NULL) == GJK_ERROR_NULL);
  CHECK(gjk2_cast_ray(&a, NULL, &to, &out) == GJK_ERROR_NULL && gjk2_cast_ray(&a, &to, NULL, &out) == GJK_ERROR_NULL);
  CHECK(gjk2_cast_ray(NULL, &to, &to, &out) == GJK_ERROR_NULL && gjk2_cast_ray(&a, &to, &to, NULL) == GJK_ERROR_NULL);
  path.margin = -1;
  CHECK(gjk2_cast(&a, &b, &path, &out) == GJK_ERROR_NEGATIVE);
  CHECK(gjk2_check_cast(&a, &b, &path, &out) == GJK_ERROR_NEGATIVE);
  path.margin = 0;
  // The way of one against the other: 2^32 - 1 and one more.
  pose.position.x = -2;
  CHECK(gjk2_collider_pose(&a, &pose) == GJK_OK && gjk2_collider_pose(&b, &pose) == GJK_OK);
  path.to_a = &other;
  path.to_b = &far;
  far.x = INT32_MAX;
  CHECK(gjk2_cast(&a, &b, &path, &out) == GJK_OK);
  out = before;
  gjk2_vec ends[2] = {{INT32_MIN, 0}, {INT32_MAX, 0}};
  CHECK(gjk2_collider_move(&a, &ends[1]) == GJK_OK && gjk2_collider_move(&b, &ends[0]) == GJK_OK);
  path.to_a = &ends[0];
  path.to_b = &ends[1];
  CHECK(gjk2_cast(&a, &b, &path, &out) == GJK_ERROR_RANGE);
  CHECK(memcmp(&out, &before, sizeof out) == 0);
  // A centre that leaves the world with its pose's position still in it.
  static const gjk2_vec corners[3] = {{1000, 0}, {2000, 0}, {1000, 900}};
  static const gjk2_shape triangle = GJK2_TRIANGLE(corners);
  CHECK(gjk2_collider_init(&b, &triangle, NULL, 0) == GJK_OK);
  pose.position.x = 0;
  CHECK(gjk2_collider_pose(&b, &pose) == GJK_OK);
  path.to_a = NULL;
  CHECK(gjk2_cast(&a, &b, &path, &out) == GJK_ERROR_RANGE);
  CHECK(memcmp(&out, &before, sizeof out) == 0);
}

int main(void) {
  random_state r = random_seed(check_seed(SEED));
  test_random(&r);
  test_grazing(&r);
  test_ends(&r);
  test_wide(&r);
  test_halves_and_rays(&r);
  test_curved(&r);
  test_curved_grazing();
  test_circles(&r);
  test_rays(&r);
  test_diagonal();
  test_long_pass(&r);
  test_late_claim();
  test_claims_at_ends();
  test_exact_direction();
  test_open_margins();
  test_stained();
  test_statuses();
  printf("grazing: %lu hits, %lu misses; long ways: %lu, %lu\n", grazing.hits, grazing.misses, wide.hits, wide.misses);
  printf("closest ends: %lu hits, %lu misses\n", closest.hits, closest.misses);
  CHECK(closest.hits > TRIALS / 20 && closest.misses > TRIALS / 20);
  CHECK(grazing.hits > TRIALS / 20 && grazing.misses > TRIALS / 40);
  CHECK(wide.hits > TRIALS / 20 && wide.misses > TRIALS / 40);
  printf("exact: %lu hits, %lu misses; rounded: %lu, %lu; inside %lu; at most %lu iterations\n", tally.exact_hits,
         tally.exact_misses, tally.round_hits, tally.round_misses, tally.inside, tally.iterations_most);
  printf("%lu proven, %lu unsupported, %lu forged\n", checks.proven, checks.unsupported, checks.forged);
  const unsigned long n = TRIALS;
  CHECK(tally.exact_hits > n / 10 && tally.exact_misses > n / 10);
  CHECK(tally.round_hits > n / 10 && tally.round_misses > n / 20);
  return check_done("plane_cast");
}
