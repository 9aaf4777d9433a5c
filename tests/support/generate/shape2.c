// Makes random shapes and poses of the plane.
#include "shape2.h"

#include <math.h>

#define PI 3.14159265358979323846

double generate2_unit(random_state *random) {
  return random_u32(random) / 4294967296.0;
}

gjk_q16 generate2_reach(random_state *random) {
  return (gjk_q16)(3 * exp(generate2_unit(random) * log(GENERATE2_REACH_MAX / 3.0)));
}

gjk2_vec generate2_vector(random_state *random, double length) {
  const double angle = 2 * PI * generate2_unit(random);
  const gjk2_vec v = {(gjk_q16)lrint(length * cos(angle)), (gjk_q16)lrint(length * sin(angle))};
  return v;
}

gjk2_rotation generate2_rotation(random_state *random) {
  static const gjk2_rotation quarter[4] = {{GJK_Q30_ONE, 0}, {0, GJK_Q30_ONE}, {-GJK_Q30_ONE, 0}, {0, -GJK_Q30_ONE}};
  const double angle = 2 * PI * generate2_unit(random), one = GJK_Q30_ONE;
  gjk2_rotation r = quarter[random_below(random, 4)];
  switch (random_below(random, 8)) {
    case 0: return quarter[0];
    case 1: return r;
    case 2: {
      const int32_t disturbance = random_range(random, -1, 1) * (1 << random_below(random, 14));
      r.c += r.c == 0 ? disturbance : 0;
      r.s += r.s == 0 ? disturbance : 0;
      return r;
    }
    default:
      r.c = (gjk_q30)lrint(one * cos(angle));
      r.s = (gjk_q30)lrint(one * sin(angle));
      return r;
  }
}

case2_kind generate2_kind(random_state *random) {
  return (case2_kind)random_below(random, CASE2_POLYGON + 1);
}

// The number of points: mostly few, one in sixteen from 65.
static size_t point_count(random_state *random) {
  switch (random_below(random, 16)) {
    case 0: return 65 + random_below(random, GENERATE2_VERTICES_MAX - 65 - 64);
    case 1:
    case 2: return 9 + random_below(random, 56);
    case 3: return 1 + random_below(random, 3);
    default: return 3 + random_below(random, 6);
  }
}

static gjk2_vec in_box(random_state *random, gjk_q16 x, gjk_q16 y) {
  const gjk2_vec v = {random_range(random, -x, x), random_range(random, -y, y)};
  return v;
}

// Half the edge of a square within reach.
static gjk_q16 square_within(gjk_q16 reach) {
  return (gjk_q16)((int64_t)reach * 7 / 10);
}

static void fill(random_state *random, gjk_q16 reach, case2_shape *out) {
  const gjk_q16 square = square_within(reach), step = reach / 4 > 0 ? reach / 4 : 1;
  const unsigned style = random_below(random, 4);
  const gjk_q16 flat = random_range(random, 0, square);
  for (size_t i = 0; i < out->count; i++) {
    gjk2_vec *v = &out->vertices[i];
    switch (style) {
      case 0: *v = generate2_vector(random, reach * 0.98); break;
      case 1:
        *v = in_box(random, 2, 2);
        v->x *= step;
        v->y *= step;
        break;
      case 2: {
        const gjk2_vec near = generate2_vector(random, square / 16.0);
        *v = i < 3 ? in_box(random, square / 2, square / 2) : out->vertices[random_below(random, 3)];
        v->x += i < 3 ? 0 : near.x;
        v->y += i < 3 ? 0 : near.y;
        break;
      }
      default: *v = in_box(random, square, flat); break;
    }
  }
}

void generate2_order(case2_shape *polygon) {
  static exact2_point point[GENERATE2_VERTICES_MAX];
  static exact2_hull hull;
  for (size_t i = 0; i < polygon->count; i++) {
    point[i].x = polygon->vertices[i].x;
    point[i].y = polygon->vertices[i].y;
  }
  exact2_hull_find(point, (unsigned)polygon->count, &hull);
  case2_shape_set_count(polygon, hull.count);
  for (unsigned i = 0; i < hull.count; i++) {
    polygon->vertices[i].x = (gjk_q16)hull.vertex[i].x;
    polygon->vertices[i].y = (gjk_q16)hull.vertex[i].y;
  }
}

static void shuffle(random_state *random, case2_shape *polygon) {
  for (size_t i = polygon->count; i > 1; i--) {
    const size_t k = random_below(random, (uint32_t)i);
    const gjk2_vec kept = polygon->vertices[i - 1];
    polygon->vertices[i - 1] = polygon->vertices[k];
    polygon->vertices[k] = kept;
  }
}

static void reverse(case2_shape *polygon) {
  for (size_t i = 0; i < polygon->count / 2; i++) {
    const gjk2_vec kept = polygon->vertices[i];
    polygon->vertices[i] = polygon->vertices[polygon->count - 1 - i];
    polygon->vertices[polygon->count - 1 - i] = kept;
  }
}

void generate2_disorder(random_state *random, case2_shape *polygon) {
  const size_t n = polygon->count, room = GENERATE2_VERTICES_MAX - n, spare = room < 8 ? room : random_below(random, 8);
  case2_shape_set_count(polygon, n + spare);
  for (size_t i = n; i < n + spare; i++) {
    const gjk2_vec a = polygon->vertices[random_below(random, (uint32_t)n)];
    const gjk2_vec b = polygon->vertices[random_below(random, (uint32_t)n)];
    // The middle of two points whose sum is even lies on the segment; else the first is repeated.
    const int64_t x = (int64_t)a.x + b.x, y = (int64_t)a.y + b.y;
    const bool even = x % 2 == 0 && y % 2 == 0;
    polygon->vertices[i].x = even ? (gjk_q16)(x / 2) : a.x;
    polygon->vertices[i].y = even ? (gjk_q16)(y / 2) : a.y;
  }
  if (random_below(random, 3) == 0) {
    reverse(polygon);
  } else {
    shuffle(random, polygon);
  }
}

void generate2_shape(random_state *random, case2_kind kind, gjk_q16 reach, case2_shape *out) {
  const gjk_q16 square = square_within(reach);
  case2_shape_reset(out);
  out->kind = kind;
  switch (kind) {
    case CASE2_SEGMENT: out->size.x = reach; break;
    case CASE2_BOX:
      out->size.x = random_range(random, square / 8, square);
      out->size.y = random_range(random, square / 8, square);
      break;
    case CASE2_TRIANGLE:
    case CASE2_POLYGON:
      case2_shape_set_count(out, kind == CASE2_TRIANGLE ? 3 : point_count(random));
      fill(random, reach, out);
      if (kind == CASE2_POLYGON && random_below(random, 2) == 0) {
        generate2_order(out);
      } else if (kind == CASE2_POLYGON) {
        generate2_disorder(random, out);
      }
      break;
    default: break;
  }
}

void generate2_sliver(random_state *random, case2_kind kind, gjk_q16 reach, case2_shape *out) {
  const gjk_q16 square = square_within(reach), thin = square / 10000;
  generate2_shape(random, kind, reach, out);
  out->size.y = kind == CASE2_BOX ? thin : 0;
  out->size.x = kind == CASE2_BOX ? square : out->size.x;
  for (size_t i = 0; i < out->count; i++) {
    out->vertices[i] = in_box(random, square, thin);
  }
}

// A component of a local point at its pose.
static exact2_point posed(const case2_shape *shape, gjk2_vec local) {
  const gjk2_rotation *r = &shape->pose.rotation;
  const gjk2_vec *p = &shape->pose.position;
  exact2_point out = {(int64_t)p->x + local.x, (int64_t)p->y + local.y};
  if (r->s != 0 || r->c < 0) {
    const long double length = hypotl(r->c, r->s), c = r->c / length, s = r->s / length;
    out.x = p->x + llrintl(c * local.x - s * local.y);
    out.y = p->y + llrintl(s * local.x + c * local.y);
  }
  return out;
}

unsigned generate2_points(const case2_shape *shape, exact2_point out[GENERATE2_VERTICES_MAX]) {
  unsigned n = 0;
  if (shape->kind == CASE2_TRIANGLE || shape->kind == CASE2_POLYGON) {
    for (size_t i = 0; i < shape->count; i++) {
      out[n++] = posed(shape, shape->vertices[i]);
    }
    return n;
  }
  const unsigned corners = shape->kind == CASE2_BOX ? 4 : shape->kind == CASE2_SEGMENT ? 2 : 1;
  for (; n < corners; n++) {
    const gjk2_vec corner = {(n & 1u) != 0 ? shape->size.x : -shape->size.x,
                             (n & 2u) != 0 ? shape->size.y : -shape->size.y};
    out[n] = posed(shape, corner);
  }
  return n;
}

static gjk_q16 clamp(int64_t x) {
  return x > INT32_MAX ? INT32_MAX : x < INT32_MIN ? INT32_MIN : (gjk_q16)x;
}

static void move(case2_shape *shape, int64_t x, int64_t y) {
  shape->pose.position.x = clamp(shape->pose.position.x + x);
  shape->pose.position.y = clamp(shape->pose.position.y + y);
}

// How far the shape reaches from its origin.
static double reach_of(const case2_shape *shape) {
  exact2_point point[GENERATE2_VERTICES_MAX];
  const unsigned n = generate2_points(shape, point);
  double most = 0;
  for (unsigned i = 0; i < n; i++) {
    most =
        fmax(most, hypot((double)(point[i].x - shape->pose.position.x), (double)(point[i].y - shape->pose.position.y)));
  }
  return most + shape->convex_radius;
}

void generate2_apart(random_state *random, double factor, case2_pair *pair) {
  const gjk2_vec by = generate2_vector(random, factor * (reach_of(&pair->a) + reach_of(&pair->b)));
  pair->a.pose.rotation = generate2_rotation(random);
  pair->b.pose.rotation = generate2_rotation(random);
  pair->a.pose.position = generate2_vector(random, (double)generate2_reach(random));
  pair->b.pose.position = pair->a.pose.position;
  move(&pair->b, by.x, by.y);
}

// Moves B to the given gap, where the cores do not meet.
static void approach(gjk_q16 gap, case2_pair *pair) {
  exact2_point a[GENERATE2_VERTICES_MAX], b[GENERATE2_VERTICES_MAX];
  const exact2_shape core_a = {a, generate2_points(&pair->a, a), 0}, core_b = {b, generate2_points(&pair->b, b), 0};
  exact2_truth truth;
  exact2_find(&core_a, &core_b, &truth);
  if (!truth.cores_meet) {
    const double wanted = (double)gap + pair->a.convex_radius + pair->b.convex_radius;
    const double x = (double)truth.direction.x, y = (double)truth.direction.y, length = hypot(x, y);
    const double by = wanted - (double)truth.distance;
    move(&pair->b, llrint(by * x / length), llrint(by * y / length));
  }
}

void generate2_near(random_state *random, gjk_q16 gap, case2_pair *pair) {
  generate2_apart(random, 1.02, pair);
  // The first step stops before the cores touch. From there the second is as exact as integer coordinates allow.
  approach(8, pair);
  approach(gap, pair);
}

void generate2_outermost(random_state *random, case2_pair *pair) {
  exact2_point all[2 * GENERATE2_VERTICES_MAX];
  unsigned n = generate2_points(&pair->a, all);
  n += generate2_points(&pair->b, all + n);
  const bool right = random_below(random, 2) == 0, up = random_below(random, 2) == 0;
  const int64_t slack = random_range(random, 0, 99), end_x = right ? INT32_MAX - slack : INT32_MIN + slack;
  const int64_t end_y = up ? INT32_MAX - slack : INT32_MIN + slack;
  int64_t x = right ? INT64_MAX : INT64_MIN, y = up ? INT64_MAX : INT64_MIN;
  const gjk2_vec origin[2] = {pair->a.pose.position, pair->b.pose.position};
  for (unsigned i = 0; i < n + 2; i++) {
    const int64_t px = i < n ? all[i].x : origin[i - n].x, py = i < n ? all[i].y : origin[i - n].y;
    x = right ? (end_x - px < x ? end_x - px : x) : (end_x - px > x ? end_x - px : x);
    y = up ? (end_y - py < y ? end_y - py : y) : (end_y - py > y ? end_y - py : y);
  }
  move(&pair->a, x, y);
  move(&pair->b, x, y);
}
