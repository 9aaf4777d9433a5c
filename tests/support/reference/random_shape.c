// Random shapes of one kind at random poses.
#include "random_shape.h"

#include <math.h>

double random_unit(random_state *random) {
  return (double)random_u32(random) / 4294967295.0;
}

gjk_q16 random_reach(random_state *random) {
  const double orders = log((double)RANDOM_REACH_MAX / RANDOM_REACH_MIN);
  return (gjk_q16)lround(RANDOM_REACH_MIN * exp(random_unit(random) * orders));
}

static void random_direction(random_state *random, int dimensions, double out[]) {
  double squared;
  do {
    squared = 0;
    for (int k = 0; k < dimensions; k++) {
      out[k] = 2 * random_unit(random) - 1;
      squared += out[k] * out[k];
    }
  } while (squared > 1 || squared < 1e-4);
  for (int k = 0; k < dimensions; k++) {
    out[k] /= sqrt(squared);
  }
}

gjk_vec3 random_vector(random_state *random, double length) {
  double d[3];
  random_direction(random, 3, d);
  gjk_vec3 v = {(gjk_q16)lround(d[0] * length), (gjk_q16)lround(d[1] * length), (gjk_q16)lround(d[2] * length)};
  return v;
}

gjk_quat random_rotation(random_state *random) {
  static const gjk_quat identity = {0, 0, 0, GJK_Q30_ONE};
  static const gjk_quat quarter = {759250125, 0, 0, 759250125};
  uint32_t choice = random_below(random, 8);
  if (choice < 2) {
    return choice == 0 ? identity : quarter;
  }
  double q[4];
  random_direction(random, 4, q);
  // The squared length may be 2^-16 off; this is 2^-17.
  double scale = GJK_Q30_ONE * (1 + (random_unit(random) - 0.5) / 131072);
  for (int k = 0; k < 4; k++) {
    q[k] = fmin(fmax(q[k] * scale, INT32_MIN / 2), INT32_MAX / 2);
  }
  gjk_quat rotation = {(gjk_q30)lround(q[0]), (gjk_q30)lround(q[1]), (gjk_q30)lround(q[2]), (gjk_q30)lround(q[3])};
  return rotation;
}

// A length up to reach, at most 10,000 times smaller for a sliver, 4 times otherwise; one in 16 is 0.
static gjk_q16 random_length(random_state *random, double reach, bool sliver) {
  if (random_below(random, 16) == 0) {
    return 0;
  }
  double orders = log(sliver ? 10000.0 : 4.0);
  return (gjk_q16)floor(reach * exp(-orders * random_unit(random)));
}

static void random_vertices(random_state *random, const gjk_vec3 *half, size_t count, case_shape *out) {
  gjk_vec3 offset = {0, 0, 0};
  if (random_below(random, 2) == 0) {
    offset = random_vector(random, RANDOM_REACH_MAX * random_unit(random));
  }
  case_shape_set_count(out, count);
  for (size_t i = 0; i < count; i++) {
    out->vertices[i].x = offset.x + random_range(random, -half->x, half->x);
    out->vertices[i].y = offset.y + random_range(random, -half->y, half->y);
    out->vertices[i].z = offset.z + random_range(random, -half->z, half->z);
  }
}

void random_shape(random_state *random, case_kind kind, gjk_q16 reach, case_shape *out) {
  case_shape_reset(out);
  if (random_below(random, 3) == 0) {
    out->convex_radius = kind == CASE_POINT ? reach : random_length(random, reach / 2, true);
  }
  // Of a box, of a cylinder or cone, and of an ellipsoid or segment that all stay within the reach.
  const double share = kind == CASE_ELLIPSOID || kind == CASE_SEGMENT ? 1
                       : kind == CASE_CYLINDER || kind == CASE_CONE   ? sqrt(0.5)
                                                                      : sqrt(1.0 / 3);
  const double core = (reach - out->convex_radius) * share;
  const bool sliver = random_below(random, 2) == 0;
  const gjk_q16 x = random_length(random, core, sliver), y = random_length(random, core, sliver),
                z = random_length(random, core, sliver);
  const gjk_vec3 extent = {x, y, z}, disc_base = {x, x, z}, along = {0, 0, z}, none = {0, 0, 0};
  out->kind = kind;
  out->pose.rotation = random_rotation(random);
  switch (kind) {
    case CASE_POINT: out->size = none; break;
    case CASE_SEGMENT: out->size = along; break;
    case CASE_TRIANGLE: random_vertices(random, &extent, 3, out); break;
    case CASE_HULL: random_vertices(random, &extent, 4 + random_below(random, 61), out); break;
    case CASE_CYLINDER:
    case CASE_CONE: out->size = disc_base; break;
    default: out->size = extent; break;
  }
}
