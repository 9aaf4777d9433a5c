// gjk2_penetration and gjk2_signed_distance against brute force: the least depth over all directions, to the last LSB.
#include "plane.h"

#define SEED 2002
#define TRIALS check_trials(60000)

static struct {
  unsigned long apart, deep, shallow, touching;
  long double worst_point, worst_normal;
} tally;

static int64_t away(gjk_q16 depth, gjk_q30 u) {
  const int64_t size = ((int64_t)depth * (u < 0 ? -(int64_t)u : u) + (INT64_C(1) << 30) - 1) >> 30;
  return u < 0 ? -size : size;
}

// Has A - B moved by the depth along the normal come clear of the origin, or does it touch it?
static bool is_parted(const plane_truth *truth, const gjk2_penetration_result *out, int64_t radii) {
  static plane_truth moved;
  moved = *truth;
  for (int i = 0; i < moved.count; i++) {
    moved.hull[i].x -= away(out->depth, out->normal.x);
    moved.hull[i].y -= away(out->depth, out->normal.y);
  }
  bool outside = moved.count < 3;
  for (int i = 0; i < moved.count; i++) {
    const plane_point p = moved.hull[i], q = moved.hull[(i + 1) % moved.count], origin = {0, 0};
    outside = outside || plane_cross(p, q, origin) <= 0;
  }
  return outside && plane_compare_distance(&moved, 2 * radii) >= 0;
}

static void check_points(const plane_body *pair, const gjk2_penetration_result *out) {
  const gjk2_collider *a = &pair[0].collider, *b = &pair[1].collider;
  const long double from_a = plane_distance_from(a, &out->point_a) - a->shape->convex_radius;
  const long double from_b = plane_distance_from(b, &out->point_b) - b->shape->convex_radius;
  CHECK_MSG(from_a <= 1.0L, "%Lf", from_a);
  CHECK_MSG(from_b <= 1.0L, "%Lf", from_b);
  const long double scale = ldexpl(out->depth, -30);
  const long double x = (long double)out->point_a.x - out->point_b.x - scale * out->normal.x;
  const long double y = (long double)out->point_a.y - out->point_b.y - scale * out->normal.y;
  const long double off = hypotl(x, y) - ldexpl(out->depth, -28);
  CHECK_MSG(off <= 3, "%Lf", off);
  tally.worst_point = off > tally.worst_point ? off : tally.worst_point;
  const long double n = fabsl(hypotl(out->normal.x, out->normal.y) - 1073741824.0L);
  CHECK_MSG(n <= 5, "%Lf", n);
  tally.worst_normal = n > tally.worst_normal ? n : tally.worst_normal;
}

static void check_pair(plane_body *pair) {
  static plane_truth truth;
  const gjk2_collider *a = &pair[0].collider, *b = &pair[1].collider;
  const int64_t radii = (int64_t)a->shape->convex_radius + b->shape->convex_radius;
  plane_truth_of(a, b, &truth);
  const bool together = truth.overlap || (radii > 0 && plane_compare_distance(&truth, 2 * radii) <= 0);
  gjk2_penetration_result out;
  gjk2_distance_result line, measured;
  gjk2_distance_result again;
  gjk2_cache cache;
  memset(&cache, 0, sizeof cache);
  memset(&line, 0, sizeof line);
  CHECK(gjk2_penetration(a, b, NULL, &out) == GJK_OK);
  CHECK(gjk2_signed_distance(a, b, NULL, &line) == GJK_OK);
  CHECK(out.intersecting == together);
  CHECK(line.intersecting == together);
  for (int i = 0; i < 2; i++) {
    CHECK(gjk2_signed_distance(a, b, &cache, &again) == GJK_OK);
    CHECK(again.distance == line.distance && again.intersecting == line.intersecting);
  }
  if (!together) {
    CHECK(gjk2_distance(a, b, NULL, &measured) == GJK_OK);
    CHECK(measured.distance == line.distance);
    CHECK(measured.lower == line.lower && measured.upper == line.upper);
    tally.apart++;
    return;
  }
  CHECK(line.distance == -out.depth && line.lower == line.distance && line.upper == line.distance);
  CHECK(out.lower == out.depth && out.upper == out.depth);
  if (truth.overlap) {
    const int64_t core = out.depth - radii;
    CHECK_MSG(plane_compare_depth(&truth, core) <= 0, "%d too small", out.depth);
    CHECK_MSG(core == 0 || plane_compare_depth(&truth, core - 1) > 0, "%d too large", out.depth);
    CHECK(core >= 0);
    tally.touching += core == 0;
    tally.deep++;
  } else {
    const int64_t gap = radii - out.depth;  // the distance of the cores, rounded down
    CHECK_MSG(plane_compare_distance(&truth, 2 * gap) >= 0, "%d too small", out.depth);
    CHECK_MSG(plane_compare_distance(&truth, 2 * gap + 2) < 0, "%d too large", out.depth);
    tally.shallow++;
  }
  CHECK_MSG(is_parted(&truth, &out, radii), "depth %d normal %d %d", out.depth, out.normal.x, out.normal.y);
  check_points(pair, &out);
}

int main(void) {
  static plane_body pair[2];
  const uint64_t seed = check_seed(SEED);
  for (unsigned long i = 0; i < TRIALS; i++) {
    random_state r = random_seed(seed + i);
    check_trial(i, plane_print, pair);
    plane_any_pair(&r, 3, pair);
    check_pair(pair);
  }
  printf("apart %lu, deep %lu, shallow %lu, just touching %lu; points off by %Lf, normals by %Lf LSB\n", tally.apart,
         tally.deep, tally.shallow, tally.touching, tally.worst_point, tally.worst_normal);
  CHECK(tally.apart > TRIALS / 8 && tally.deep > TRIALS / 5 && tally.shallow > TRIALS / 100 &&
        tally.touching > TRIALS / 100);
  return check_done("plane_penetration");
}
