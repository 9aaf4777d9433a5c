// The exact oracle: depths, their directions and points, from their certificates.
#include <math.h>

#include "depth.h"
#include "judge.h"

// Cells enough for most moved shapes.
#define CELLS GJK_EPA_CELLS(24 * 24)

// A facet: three pairs span its plane, and no a - b lies beyond it.
static bool is_facet(judge *j, const gjk_certificate *certificate, exact_plane *out) {
  if (!judge_load(j, certificate, 3)) {
    return false;
  }
  if (j->count != 3) {
    return judge_refuse(j, "%u pairs for a facet", j->count);
  }
  const exact_point e = exact_subtract(&j->w[1], &j->w[0]), f = exact_subtract(&j->w[2], &j->w[0]);
  const exact_vector normal = exact_cross(&e, &f);
  const exact_int height = exact_dot(&normal, &j->w[0]);
  exact_plane_make(&normal, &height, out);
  if (out->squared.sign == 0) {
    return judge_refuse(j, "the facet is flat");
  }
  if (!judge_none_before(j->a, j->count_a, &j->at_a[0], &normal, -1)) {
    return judge_refuse(j, "a vertex of A lies beyond the plane");
  }
  return judge_none_before(j->b, j->count_b, &j->at_b[0], &normal, 1) ||
         judge_refuse(j, "a vertex of B lies beyond the plane");
}

// A direction along which no a - b lies beyond the origin, while the pairs hold the origin.
static bool is_through_origin(judge *j, const gjk_certificate *certificate, exact_plane *out) {
  const gjk_vec3 *d = &certificate->direction;
  const exact_vector direction = {{exact_from(d->x), exact_from(d->y), exact_from(d->z)}};
  const exact_int zero = exact_from(0);
  exact_plane_make(&direction, &zero, out);
  if (out->squared.sign == 0) {
    return judge_refuse(j, "no direction");
  }
  if (!judge_load(j, certificate, 3)) {
    return false;
  }
  if (!exact_encloses(j->w, j->count)) {
    return judge_refuse(j, "the pairs do not hold the origin");
  }
  // If nothing lies beyond the plane, pairs that hold the origin lie in the plane.
  return (judge_none_before(j->a, j->count_a, &j->at_a[0], &direction, -1) &&
          judge_none_before(j->b, j->count_b, &j->at_b[0], &direction, 1)) ||
         judge_refuse(j, "a vertex lies beyond the plane through the origin");
}

static bool find_plane(judge *j, const gjk_certificate *certificate, exact_plane *out) {
  switch (certificate->proof) {
    case GJK_PROOF_FACET: return is_facet(j, certificate, out);
    case GJK_PROOF_PLANE: return is_through_origin(j, certificate, out);
    case GJK_PROOF_NEAREST:
      if (!judge_nearest(j, certificate)) {
        return false;
      }
      exact_plane_behind(&j->feature, out);
      return out->squared.sign > 0 || judge_refuse(j, "the cores are not apart");
    default: return judge_refuse(j, "proof %u for a depth", certificate->proof);
  }
}

static bool is_depth(judge *j, const exact_plane *plane, const gjk_penetration_result *result) {
  if (result->lower != result->depth || result->upper != result->depth) {
    return judge_refuse(j, "bounds differ from the depth");
  }
  if (exact_plane_compare(plane, -j->radius) < 0) {
    return judge_refuse(j, "the plane leaves them apart");
  }
  const int64_t core = result->depth - j->radius;  // rounded up: core - 1 < height <= core
  return (exact_plane_compare(plane, core) <= 0 && exact_plane_compare(plane, core - 1) > 0) ||
         judge_refuse(j, "depth %ld, the plane's is %.4f", (long)result->depth,
                      exact_plane_height(plane) + (double)j->radius);
}

// Is the point within 1 LSB of the shape? If the named vertices do not tell, a query of the library does, whose answer
// is proven here.
static bool is_of_shape(const gjk_vec3 *point, const gjk_collider *shape, const exact_point *vertices, unsigned count) {
  static const gjk_shape point_shape = GJK_POINT;
  const exact_point at = {{point->x, point->y, point->z}};
  if (judge_is_cut(point) || (count <= 3 && judge_at(&at, vertices, count, shape->shape->convex_radius + 1))) {
    return true;
  }
  gjk_collider other = {0};
  gjk_pose pose = GJK_POSE_IDENTITY;
  gjk_decision decision;
  char why[128];
  pose.position = *point;
  return gjk_collider_init(&other, &point_shape, NULL, 0) == GJK_OK && gjk_collider_pose(&other, &pose) == GJK_OK &&
         gjk_within(shape, &other, 1, NULL, &decision) == GJK_OK && decision.yes &&
         exact_check_decision(shape, &other, 1, &decision, why, sizeof why);
}

// point_a - point_b must be the exact depth along the exact normal, within 2 LSB: both points are rounded, the depth is
// not. The lengths are below 2^32 and known to 2^-15.
static bool is_gap(judge *j, const exact_plane *plane, const gjk_penetration_result *result) {
  const double scale = (exact_plane_height(plane) + (double)j->radius) / sqrt(exact_to_double(&plane->squared));
  const double gap[3] = {(double)result->point_a.x - result->point_b.x, (double)result->point_a.y - result->point_b.y,
                         (double)result->point_a.z - result->point_b.z};
  double off = 0;
  for (int i = 0; i < 3; i++) {
    const double difference = gap[i] - scale * exact_to_double(&plane->normal.x[i]);
    off += difference * difference;
  }
  return judge_is_cut(&result->point_a) || judge_is_cut(&result->point_b) || sqrt(off) <= 2.001 ||
         judge_refuse(j, "the points are %.4f LSB off depth times normal", sqrt(off));
}

static int64_t move_component(int64_t depth, int64_t normal) {
  const int64_t product = depth * normal, unit = GJK_Q30_ONE;  // 2^61
  return product < 0 ? -((-product + unit - 1) / unit) : (product + unit - 1) / unit;
}

exact_point exact_move(const gjk_penetration_result *result) {
  const exact_point t = {{move_component(result->depth, result->normal.x),
                          move_component(result->depth, result->normal.y),
                          move_component(result->depth, result->normal.z)}};
  return t;
}

// No a - b lies beyond the plane. So after a move by t no a - b - t lies beyond height - normal . t. Is that at least
// radius behind the origin?
static bool parts(const judge *j, const exact_plane *plane, const exact_point *t) {
  const exact_int along = exact_dot(&plane->normal, t);
  exact_plane moved = *plane;
  moved.height = exact_sub(&plane->height, &along);
  return exact_plane_compare(&moved, -j->radius) <= 0;
}

static bool move_collider(const gjk_collider *from, const exact_point *by, gjk_collider *out) {
  const int64_t x = from->position.x + by->x[0], y = from->position.y + by->x[1], z = from->position.z + by->x[2];
  const gjk_vec3 position = {(gjk_q16)x, (gjk_q16)y, (gjk_q16)z};
  *out = *from;
  return x == position.x && y == position.y && z == position.z && gjk_collider_move(out, &position) == GJK_OK;
}

// Depth 0 is shown by a certificate, or by a trial of every direction.
static bool touch(const gjk_collider *a, const gjk_collider *b) {
  static gjk_epa_cell cells[CELLS];
  static const gjk_workspace workspace = {cells, CELLS};
  gjk_penetration_result r;
  char why[128];
  exact_overlap overlap;
  if (gjk_penetration(a, b, NULL, &workspace, &r) == GJK_OK) {
    return r.intersecting && r.depth == 0 && exact_check_depth(a, b, &r, why, sizeof why);
  }
  return exact_overlap_find(a, b, &overlap) && overlap.touching;
}

// Moves the shapes themselves, in the middle of the world, where there is room. The library may find the answer, as
// only its proof counts.
static bool parts_shapes(const judge *j, const exact_point *t) {
  const gjk_vec3 *c = &j->a->centre;
  const exact_point back = {{c->x, c->y, c->z}}, zero = {{0, 0, 0}};
  const exact_point by_a = exact_subtract(&zero, &back), by_b = exact_subtract(t, &back);
  gjk_collider a, b;
  gjk_distance_result r;
  char why[128];
  if (!move_collider(j->a, &by_a, &a) || !move_collider(j->b, &by_b, &b)) {
    return false;
  }
  if (gjk_distance(&a, &b, NULL, &r) == GJK_OK && !r.intersecting) {
    return exact_check_gap(&a, &b, &r, why, sizeof why);
  }
  return touch(&a, &b);
}

bool exact_check_move(const gjk_collider *a, const gjk_collider *b, const gjk_penetration_result *result, char *why,
                      size_t n) {
  judge j;
  exact_plane plane;
  const exact_point t = exact_move(result);
  if (!judge_start(&j, a, b, 0, why, n)) {
    return false;
  }
  if ((find_plane(&j, &result->certificate, &plane) && parts(&j, &plane, &t)) || parts_shapes(&j, &t)) {
    why[0] = '\0';
    return true;
  }
  return judge_refuse(&j, "moving by %ld %ld %ld does not part them", (long)t.x[0], (long)t.x[1], (long)t.x[2]);
}

static bool is_apart(judge *j, const gjk_penetration_result *result) {
  gjk_decision decision = {0};
  decision.certificate = result->certificate;
  return exact_check_decision(j->a, j->b, 0, &decision, j->why, j->size);
}

bool exact_check_depth(const gjk_collider *a, const gjk_collider *b, const gjk_penetration_result *result, char *why,
                       size_t n) {
  judge j;
  exact_plane plane;
  return judge_start(&j, a, b, 0, why, n) &&
         (result->intersecting ? find_plane(&j, &result->certificate, &plane) && is_depth(&j, &plane, result)
                               : is_apart(&j, result));
}

bool exact_check_penetration(const gjk_collider *a, const gjk_collider *b, const gjk_penetration_result *result,
                             char *why, size_t n) {
  judge j;
  exact_plane plane;
  if (!judge_start(&j, a, b, 0, why, n)) {
    return false;
  }
  if (!result->intersecting) {
    return is_apart(&j, result);
  }
  if (!find_plane(&j, &result->certificate, &plane) || !is_depth(&j, &plane, result) ||
      !judge_normal(&j, &plane.normal, &result->normal) || !is_gap(&j, &plane, result)) {
    return false;
  }
  if (!is_of_shape(&result->point_a, a, j.at_a, j.count)) {
    return judge_refuse(&j, "the point of A is off");
  }
  if (!is_of_shape(&result->point_b, b, j.at_b, j.count)) {
    return judge_refuse(&j, "the point of B is off");
  }
  const exact_point t = exact_move(result);
  return parts(&j, &plane, &t) || exact_check_move(a, b, result, why, n);
}
