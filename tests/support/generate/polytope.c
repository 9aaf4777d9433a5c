// Makes random polytopes, sizes and rotations.
#include "polytope.h"

#include <math.h>

double generate_unit(random_state *random) {
  return random_u32(random) / 4294967296.0;
}

gjk_q16 generate_reach(random_state *random) {
  return (gjk_q16)(3 * exp(generate_unit(random) * log(GENERATE_REACH_MAX / 3.0)));
}

static double symmetric(random_state *random) {
  return 2 * generate_unit(random) - 1;
}

gjk_q16 generate_bound(gjk_q16 reach) {
  return reach > GENERATE_REACH_MAX / 2 ? reach : GENERATE_REACH_MAX / 2;
}

gjk_vec3 generate_vector(random_state *random, double length) {
  double x, y, z, squared;
  do {
    x = symmetric(random);
    y = symmetric(random);
    z = symmetric(random);
    squared = x * x + y * y + z * z;
  } while (squared > 1 || squared < 0.01);
  const double scale = length / sqrt(squared);
  const gjk_vec3 v = {(gjk_q16)lrint(x * scale), (gjk_q16)lrint(y * scale), (gjk_q16)lrint(z * scale)};
  return v;
}

// Changes each component of 0 or 1 (Q30) by up to the given amount, or by nothing.
static gjk_quat quarter_turn(random_state *random, int32_t disturbance) {
  gjk_quat q;
  do {
    q.x = (int32_t)random_below(random, 2) * (GJK_Q30_ONE / 2);
    q.y = (int32_t)random_below(random, 2) * (GJK_Q30_ONE / 2);
    q.z = (int32_t)random_below(random, 2) * (GJK_Q30_ONE / 2);
    q.w = (int32_t)random_below(random, 2) * (GJK_Q30_ONE / 2);
  } while ((q.x | q.y | q.z | q.w) == 0);
  q.x += random_range(random, -disturbance, disturbance);
  q.y += random_range(random, -disturbance, disturbance);
  return q;
}

gjk_quat generate_rotation(random_state *random) {
  gjk_quat q = {0, 0, 0, GJK_Q30_ONE};
  switch (random_below(random, 16)) {
    case 0: return q;
    case 1: q = quarter_turn(random, 0); break;
    case 2:
    case 3: q = quarter_turn(random, 1 << random_below(random, 24)); break;
    default:
      q.x = random_range(random, -GJK_Q30_ONE, GJK_Q30_ONE);
      q.y = random_range(random, -GJK_Q30_ONE, GJK_Q30_ONE);
      q.z = random_range(random, -GJK_Q30_ONE, GJK_Q30_ONE);
      q.w = random_range(random, -GJK_Q30_ONE, GJK_Q30_ONE) | 1;
      break;
  }
  gjk_quat_normalize(&q, &q);
  return q;
}

case_kind generate_kind(random_state *random) {
  return (case_kind)random_below(random, CASE_HULL + 1);
}

// The number of points: mostly few, one in eight from 65 to 256.
static size_t hull_count(random_state *random) {
  switch (random_below(random, 8)) {
    case 0: return 65 + random_below(random, 192);
    case 1: return 17 + random_below(random, 48);
    default: return 4 + random_below(random, 13);
  }
}

static gjk_vec3 in_box(random_state *random, const gjk_vec3 *half) {
  const gjk_vec3 v = {random_range(random, -half->x, half->x), random_range(random, -half->y, half->y),
                      random_range(random, -half->z, half->z)};
  return v;
}

static gjk_vec3 on_lattice(random_state *random, gjk_q16 step) {
  const gjk_vec3 v = {random_range(random, -2, 2) * step, random_range(random, -2, 2) * step,
                      random_range(random, -2, 2) * step};
  return v;
}

// Half the edge of a cube that stays within 0.96 of reach.
static gjk_q16 cube_within(gjk_q16 reach) {
  return (gjk_q16)((int64_t)reach * 5 / 9);
}

static void fill_hull(random_state *random, gjk_q16 reach, case_shape *out) {
  const unsigned style = random_below(random, 4);
  const gjk_q16 cube = cube_within(reach), step = reach / 4 > 0 ? reach / 4 : 1;
  gjk_vec3 half = {random_range(random, 0, cube), random_range(random, 0, cube), cube};
  for (size_t i = 0; i < out->count; i++) {
    gjk_vec3 *v = &out->vertices[i];
    switch (style) {
      case 0: *v = generate_vector(random, reach * 0.96); break;
      case 1: *v = on_lattice(random, step); break;
      case 2: {
        const gjk_vec3 near = generate_vector(random, cube / 16.0);
        *v = i < 4 ? in_box(random, &half) : out->vertices[random_below(random, 4)];
        v->x += near.x;
        v->y += near.y;
        v->z += near.z;
        break;
      }
      default: *v = in_box(random, &half); break;
    }
  }
}

// The middle of the extent of the vertices along an axis.
static double middle(const case_shape *shape, int axis) {
  int32_t low = INT32_MAX, high = INT32_MIN;
  for (size_t i = 0; i < shape->count; i++) {
    const gjk_vec3 *v = &shape->vertices[i];
    const int32_t x = axis == 0 ? v->x : axis == 1 ? v->y : v->z;
    low = x < low ? x : low;
    high = x > high ? x : high;
  }
  return ((double)low + high) / 2;
}

// Are all vertices within limit of the centre of their bounding box? That is what the library measures.
static bool keeps_within(const case_shape *shape, double limit) {
  const double cx = middle(shape, 0), cy = middle(shape, 1), cz = middle(shape, 2);
  for (size_t i = 0; i < shape->count; i++) {
    const gjk_vec3 *v = &shape->vertices[i];
    const double x = v->x - cx, y = v->y - cy, z = v->z - cz;
    if (x * x + y * y + z * z > limit * limit) {
      return false;
    }
  }
  return true;
}

static void set_triangle(case_shape *out, gjk_vec3 a, gjk_vec3 b, gjk_vec3 c) {
  case_shape_set_count(out, 3);
  out->vertices[0] = a;
  out->vertices[1] = b;
  out->vertices[2] = c;
}

void generate_polytope(random_state *random, case_kind kind, gjk_q16 reach, case_shape *out) {
  const gjk_q16 cube = cube_within(reach);
  const gjk_vec3 half = {cube, cube, cube};
  case_shape_reset(out);
  out->kind = kind;
  switch (kind) {
    case CASE_SEGMENT: out->size.z = reach; break;
    case CASE_BOX:
      out->size.x = random_range(random, cube / 8, cube);
      out->size.y = random_range(random, cube / 8, cube);
      out->size.z = random_range(random, cube / 8, cube);
      break;
    case CASE_TRIANGLE: {
      const gjk_vec3 a = in_box(random, &half), b = in_box(random, &half), c = in_box(random, &half);
      set_triangle(out, a, b, c);
      break;
    }
    case CASE_HULL:
      case_shape_set_count(out, hull_count(random));
      do {
        fill_hull(random, reach, out);
      } while (!keeps_within(out, generate_bound(reach)));
      break;
    default: break;
  }
}

void generate_sliver(random_state *random, case_kind kind, gjk_q16 reach, case_shape *out) {
  const gjk_q16 cube = cube_within(reach), thin = cube / 10000, broad = random_range(random, thin, cube);
  generate_polytope(random, kind, reach, out);
  if (kind == CASE_BOX) {
    out->size.x = thin;
    out->size.y = broad;
    out->size.z = cube;
  } else if (kind == CASE_TRIANGLE || kind == CASE_HULL) {
    const gjk_vec3 half = {thin, broad, cube};
    for (size_t i = 0; i < out->count; i++) {
      out->vertices[i] = in_box(random, &half);
    }
  }
}
