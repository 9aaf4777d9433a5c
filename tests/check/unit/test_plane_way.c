// The way of a cast in the plane against exact arithmetic: sides, distances from its line, what lies ahead, parts of it, and
// where it enters. Ways and distances of all sizes up to the limits; vertices on the line, and as near to it as integers come.
#include "src/plane_motion/gjk2_entry.h"

#include "plane.h"
#include "wide_root.h"

#define TRIALS check_trials(40000)

static struct { unsigned wide, near, on_line, met, apart, exact, entered, passed; } tally;

static int sign_of(plane_wide x) {
  return (x > 0) - (x < 0);
}

// Up to 2^bits in size, of every size.
static int32_t any_step(random_state *r, unsigned bits) {
  const uint32_t below = random_below(r, 2) == 0 ? bits : random_below(r, bits + 1);
  const int32_t most = below == 0 ? 0 : (int32_t)((UINT32_C(1) << below) - 1);
  return random_range(r, -most, most);
}

static gjk_q16 clamped(int64_t x) {
  return (gjk_q16)(x < INT32_MIN / 8 * 7 ? INT32_MIN / 8 * 7 : x > INT32_MAX / 8 * 7 ? INT32_MAX / 8 * 7 : x);
}

// A way of any size between two shapes, often along the line of their centres or of a corner of A - B.
static void make_way(random_state *r, plane_body pair[2], gjk2_way *way) {
  plane_any_pair(r, 4, pair);
  const unsigned bits = random_below(r, 3) == 0 ? 31 : 5 + random_below(r, 27);
  gjk2_vec to[2];
  for (int i = 0; i < 2; i++) {
    const gjk2_vec from = pair[i].collider.position,
                   at = {clamped((int64_t)from.x + any_step(r, bits)), clamped((int64_t)from.y + any_step(r, bits))};
    CHECK(gjk2_collider_move(&pair[i].collider, &at) == GJK_OK);
    to[i].x = clamped((int64_t)at.x + any_step(r, bits));
    to[i].y = clamped((int64_t)at.y + any_step(r, bits));
  }
  const bool along = random_below(r, 3) == 0, stays = along || random_below(r, 3) == 0;
  if (along) {  // B goes to A's centre, or so that the nearest corner of A - B lies on the line; nearly, or as far beyond
    const gjk2_vec at = pair[1].collider.position, *a = &pair[0].collider.centre, *b = &pair[1].collider.centre;
    const int64_t times = 1 + random_below(r, 2), x = (int64_t)a->x - b->x, y = (int64_t)a->y - b->y;
    const gjk2_vec ahead = {(int32_t)(x / 16), (int32_t)(y / 16)}, back = {-ahead.x, -ahead.y};
    gjk2_support of_a = {{0, 0}, 0}, of_b = {{0, 0}, 0};
    if (random_below(r, 2) == 0 && (ahead.x != 0 || ahead.y != 0)) {
      pair[0].collider.shape->type->support(&pair[0].collider, &back, &of_a);
      pair[1].collider.shape->type->support(&pair[1].collider, &ahead, &of_b);
    }
    const uint32_t off = random_below(r, 2);
    to[1].x = clamped(at.x + times * (x + of_a.offset.x - of_b.offset.x) + any_step(r, 5 * off));
    to[1].y = clamped(at.y + times * (y + of_a.offset.y - of_b.offset.y) + any_step(r, 5 * off));
  }
  const gjk2_cast_path path = {stays ? NULL : &to[0], &to[1], 0};
  CHECK(gjk2_way_set(way, &pair[0].collider, &pair[1].collider, &path, way) == GJK_OK);
  const gjk2_vec *a = &pair[0].collider.position, *b = &pair[1].collider.position;
  CHECK(way->t.x == (int64_t)to[1].x - b->x - (path.to_a == NULL ? 0 : (int64_t)to[0].x - a->x));
  CHECK(way->t.y == (int64_t)to[1].y - b->y - (path.to_a == NULL ? 0 : (int64_t)to[0].y - a->y));
  CHECK(way->scans == 0);
  tally.wide += way->wide;
}

// All that is said of a vertex of A - B.
static void check_vertex(random_state *r, gjk2_way *way, gjk2_vec o) {
  const plane_wide x = way->delta.x + o.x, y = way->delta.y + o.y, tx = way->t.x, ty = way->t.y;
  const plane_wide side = tx * y - ty * x, squared = tx * tx + ty * ty;
  CHECK(sign_of(gjk2_way_side(way, o)) == sign_of(side));
  CHECK(gjk2_way_side(way, o) == (int64_t)side || (way->wide && (side >> 61 > 0 || side >> 61 < -1)));
  CHECK(gjk2_way_is_ahead(way, o, false) == sign_of(tx * x + ty * y));
  CHECK(gjk2_way_is_ahead(way, o, true) == sign_of(tx * (x - tx) + ty * (y - ty)));
  tally.on_line += side == 0 && squared != 0;
  // Radii next to the distance, where side^2 and radius^2 |t|^2 fit: |side| < 2^62, radius < 2^31.
  const plane_wide size = side < 0 ? -side : side;
  const int64_t distance = squared > 0 && size >> 60 == 0 ? wide_root(size * size / squared) : 0;
  for (int by = -1; by <= 2; by++) {
    const int64_t radius = by == 2 ? random_range(r, 0, INT32_MAX) : distance + by;
    if (radius >= 0 && radius >> 30 == 0 && size >> 62 == 0) {
      CHECK(gjk2_way_is_beside(way, o, radius) == (size * size > (plane_wide)radius * radius * squared));
      tally.near += by != 2 && distance > 0;
    }
  }
  const gjk2_vec n = {any_step(r, 29), any_step(r, 29)};
  CHECK(gjk2_way_along(way, n, o) == (int64_t)(n.x * x + n.y * y));
  CHECK(gjk2_way_ahead(way, n) == (int64_t)(n.x * tx + n.y * ty));
  const int64_t side_before = gjk2_way_side(way, o);
  gjk2_way_reverse(way);
  CHECK(gjk2_way_side(way, o) == -side_before && gjk2_way_ahead(way, n) == (int64_t)(-n.x * tx - n.y * ty));
  gjk2_way_reverse(way);
}

// The outermost vertices, against all.
static void check_outermost(gjk2_way *way) {
  static plane_point a[PLANE_VERTICES], b[PLANE_VERTICES];
  const int n = plane_vertices(way->a, a), m = plane_vertices(way->b, b);
  for (int left = 0; left < 2; left++) {
    gjk2_span span;
    gjk2_way_outermost(way, left != 0, &span);
    CHECK(span.o.x == span.a.offset.x - span.b.offset.x && span.o.y == span.a.offset.y - span.b.offset.y);
    const plane_wide tx = way->t.x, ty = way->t.y;
    const plane_wide side = tx * (way->delta.y + span.o.y) - ty * (way->delta.x + span.o.x);
    for (int i = 0; i < n; i++) {
      for (int j = 0; j < m; j++) {
        const plane_wide other = tx * (a[i].y - b[j].y) - ty * (a[i].x - b[j].x);
        CHECK(left != 0 ? other <= side : other >= side);
      }
    }
  }
}

// Where the line enters the cores, against all their vertices. Pre: the way's circles may meet.
static void check_entry(gjk2_way *way) {
  static plane_point a[PLANE_VERTICES], b[PLANE_VERTICES];
  const int n = plane_vertices(way->a, a), m = plane_vertices(way->b, b);
  const plane_wide tx = way->t.x, ty = way->t.y;
  gjk2_entry e;
  memset(&e, 0xA5, sizeof e);
  const bool enters = gjk2_entry_find(way, &e);
  const plane_wide px = way->delta.x + e.p.o.x, py = way->delta.y + e.p.o.y, side = tx * py - ty * px;
  CHECK(!enters || e.count == 1 || e.count == 2);
  CHECK(!enters || e.along == (int64_t)(e.n.x * px + e.n.y * py));
  const plane_wide closing = -(e.n.x * tx + e.n.y * ty);
  CHECK(!enters || (closing > 0 && e.closing == (uint64_t)closing));
  CHECK(enters ? (e.count == 1 ? side == 0 : side <= 0 && side == e.side_p) : side != 0);
  if (enters && e.count == 2) {
    const plane_wide qx = way->delta.x + e.q.o.x, qy = way->delta.y + e.q.o.y;
    CHECK(e.along == (int64_t)(e.n.x * qx + e.n.y * qy));
    CHECK(tx * qy - ty * qx >= 0 && e.side_q == (int64_t)(tx * qy - ty * qx));
  }
  for (int i = 0; i < n; i++) {
    for (int j = 0; j < m; j++) {
      const plane_wide x = a[i].x - b[j].x, y = a[i].y - b[j].y, of = tx * y - ty * x;
      CHECK(enters ? e.n.x * x + e.n.y * y <= e.along : side > 0 ? of >= side : of <= side);
    }
  }
  tally.entered += enters;
  tally.passed += !enters;
}

// How near the centres come to each other on the way.
static long double least_between(const gjk2_way *way) {
  const long double x = way->delta.x, y = way->delta.y, tx = way->t.x, ty = way->t.y, squared = tx * tx + ty * ty;
  long double s = squared > 0 ? (x * tx + y * ty) / squared : 0;
  s = s < 0 ? 0 : s > 1 ? 1 : s;
  return hypotl(x - s * tx, y - s * ty);
}

static void check_circles(random_state *r, const gjk2_way *way) {
  const long double least = least_between(way), start = hypotl((long double)way->delta.x, (long double)way->delta.y),
                    end = hypotl((long double)(way->delta.x - way->t.x), (long double)(way->delta.y - way->t.y));
  const int64_t cores = (int64_t)way->a->core_radius + way->b->core_radius;
  for (int i = 0; i < 4; i++) {
    const int64_t radius = i < 3 ? (int64_t)least - cores + i - 1 : random_range(r, 0, INT32_MAX);
    bool early, late;
    if (radius < 0 || radius >> 32 != 0) {
      continue;
    }
    const bool may = gjk2_way_may_meet(way, radius, &early, &late);
    const long double reach = (long double)(cores + radius);
    CHECK(may || least > reach - 0.001L);
    CHECK(early || start > reach - 0.001L);
    CHECK(late || end > reach - 0.001L);
    if (!way->wide && reach < INT32_MAX) {  // then it is exact
      CHECK(!may || least < reach + 0.001L);
      CHECK(!early || start < reach + 0.001L);
      CHECK(may || !late || end < reach + 0.001L);
    }
    tally.met += may;
    tally.apart += !may;
  }
}

static void check_portion(random_state *r) {
  const uint64_t den = 1 + (random_u64(r) >> (1 + random_below(r, 63)));
  uint64_t num = random_below(r, 2) == 0 ? random_u64(r) % (den + 1) : den - den / (2 + random_below(r, 1000));
  if (random_below(r, 3) == 0) {  // a quotient of few bits, or next to one
    num = (uint64_t)((plane_wide)den * random_below(r, 1025) >> 10);
    num = num > 0 && random_below(r, 2) == 0 ? num - 1 : num;
  }
  bool exact, exact_by;
  gjk_divisor divisor = {0, 0};
  const gjk_q30 q = gjk2_ratio(num, den, &exact);
  gjk2_ratio_set(&divisor, den);
  CHECK(gjk2_ratio_by(&divisor, num, den, &exact_by) == q && exact_by == exact);
  CHECK(q == (gjk_q30)(((plane_wide)num << 30) / den) && exact == (((plane_wide)num << 30) % den == 0));
  tally.exact += exact;
  const gjk2_portion portion = {num, den, q, exact};
  for (int i = 0; i < 4; i++) {
    const int64_t length = (int64_t)(random_u64(r) >> (31 + random_below(r, 33))) * (random_below(r, 2) == 0 ? 1 : -1);
    const plane_wide product = (plane_wide)length * num, whole = product / den;
    const int64_t floor = (int64_t)(whole - (product < 0 && whole * den != product));
    CHECK(gjk2_portion_floor_of(&portion, length) == floor && gjk2_portion_floor(&portion, length) == floor);
    if (length >> 32 == 0 || length >> 32 == -1) {
      const plane_wide twice = 2 * product + den, half = twice / (2 * (plane_wide)den);
      CHECK(gjk2_portion_nearest(&portion, length) == (int64_t)(half - (twice < 0 && half * 2 * den != twice)));
    }
  }
}

int main(void) {
  static plane_body pair[2];
  const uint64_t seed = check_seed(8209);
  for (unsigned long i = 0; i < TRIALS; i++) {
    random_state r = random_seed(seed + i);
    gjk2_way way;
    check_trial(i, plane_print, pair);
    make_way(&r, pair, &way);
    for (int k = 0; k < 4; k++) {
      gjk2_span span;
      const gjk2_vec d = {any_step(&r, 29), any_step(&r, 29)};
      gjk2_way_scan(&way, d, &span);
      check_vertex(&r, &way, span.o);
    }
    check_vertex(&r, &way, (gjk2_vec){0, 0});
    check_outermost(&way);
    check_circles(&r, &way);
    bool early, late;
    if ((way.t.x != 0 || way.t.y != 0) && gjk2_way_may_meet(&way, 0, &early, &late)) {
      check_entry(&way);
    }
    check_portion(&r);
  }
  printf("%u wide, %u distances, %u on the line, %u may meet, %u do not, %u enter, %u pass, %u exact quotients\n",
         tally.wide, tally.near, tally.on_line, tally.met, tally.apart, tally.entered, tally.passed, tally.exact);
  CHECK(tally.wide > TRIALS / 20 && tally.near > TRIALS && tally.on_line > TRIALS / 20 && tally.met > TRIALS / 10);
  CHECK(tally.apart > TRIALS / 10 && tally.exact > TRIALS / 20);
  CHECK(tally.entered > TRIALS / 20 && tally.passed > TRIALS / 20);
  return check_done("plane way");
}
