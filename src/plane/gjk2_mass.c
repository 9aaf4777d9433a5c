// Mass properties in the plane. What src/mass does in space, with one number for the inertia.
//
// Polygons are sums over triangles from their first vertex. w is twice a triangle's area, s the sum of its vertices. Let
// S = sum w, F = sum w s, M = sum w (s s + sum v v). The inertia for a mass of 1 is
//   M / (12 S) - F F / (3 S)^2 = (3 S M - 4 F F) / (36 S^2)
// S < 2^60, |s| < 2^31, so F < 2^91, M < 2^124, all within 256 bits.
//
// A box of half extents a, b with a radius r is the box, slabs of thickness r, and quarters of a disc. Their centres are
// 4 r / (3 pi) from their sides. So the area A and the integral X of x^2 are
//   A    = 4 a b + 4 r (a + b) + pi r^2
//   12 X = 16 (a^3 b + b r (3 a^2 + 3 a r + r^2) + a^3 r) + 32 a r^3 + pi (12 a^2 r^2 + 3 r^4)
// Lengths are below 2^28, so 12 X < 2^120; in units of 2^-61, < 2^181.
#include "gjk2/mass.h"

#include "gjk2_class.h"
#include "gjk2_moments.h"
#include "gjk2_outline.h"
#include "gjk2_rotation.h"

// pi 2^61, to the nearest.
#define PLANE_PI_Q61 INT64_C(0x6487ED5110B4611A)

// Most of an inertia, square LSB: a radius of gyration of 2^30 LSB.
#define PLANE_INERTIA_MAX (INT64_C(1) << 60)

// sum += factor a b c d.
static void add_four(gjk_big *sum, uint32_t factor, int32_t a, int32_t b, int32_t c, int32_t d) {
  const int32_t length[4] = {a, b, c, d};
  gjk_big product;
  gjk_big_set(&product, factor);
  for (int i = 0; i < 4; i++) {
    gjk_big_scale(&product, (uint32_t)length[i]);
  }
  gjk_big_add(sum, &product);
}

// *plain = 2^61 *plain + 2^61 pi *of_pi.
static void join_pi(gjk_big *plain, const gjk_big *of_pi) {
  gjk_big_scale(plain, UINT32_C(1) << 30);
  gjk_big_scale(plain, UINT32_C(1) << 31);
  gjk_big_add_product(plain, of_pi, PLANE_PI_Q61);
}

// sum, of_pi += 12 X.
static void add_mean_square(int32_t a, int32_t b, int32_t r, gjk_big *sum, gjk_big *of_pi) {
  add_four(sum, 16, a, a, a, b);
  add_four(sum, 48, a, a, b, r);
  add_four(sum, 48, a, b, r, r);
  add_four(sum, 16, b, r, r, r);
  add_four(sum, 16, a, a, a, r);
  add_four(sum, 32, a, r, r, r);
  add_four(of_pi, 12, a, a, r, r);
  add_four(of_pi, 3, r, r, r, r);
}

// The number nearest to x / 2^61.
static uint64_t plane_area_of(gjk_big *x) {
  gjk_big one;
  gjk_big_set(&one, INT64_C(1) << 61);
  return (uint64_t)gjk_big_nearest(x, &one);
}

// The number nearest to (a^2 + b^2) / part.
static int64_t mean_of_squares(int32_t a, int32_t b, int64_t part) {
  gjk_big squares, whole;
  gjk_big_set(&squares, gjk_mul32(a, a) + gjk_mul32(b, b));
  gjk_big_set(&whole, part);
  return gjk_big_nearest(&squares, &whole);
}

static void mass_of_plane_axes(int32_t a, int32_t b, int32_t r, gjk2_mass *out) {
  gjk_big square, of_pi, area, whole;
  gjk_big_set(&square, 0);
  gjk_big_set(&of_pi, 0);
  add_mean_square(a, b, r, &square, &of_pi);
  add_mean_square(b, a, r, &square, &of_pi);
  join_pi(&square, &of_pi);
  gjk_big_set(&area, 0);
  gjk_big_set(&of_pi, 0);
  add_four(&area, 4, a, b, 1, 1);
  add_four(&area, 4, r, a, 1, 1);
  add_four(&area, 4, r, b, 1, 1);
  add_four(&of_pi, 1, r, r, 1, 1);
  join_pi(&area, &of_pi);
  gjk_big_copy(&whole, &area);
  gjk_big_scale(&whole, 12);
  const int64_t inertia = r > 0 ? gjk_big_nearest(&square, &whole) : mean_of_squares(a, b, 3);
  gjk2_set_body(plane_area_of(&area), inertia, out);
}

static void mass_of_ellipse(int32_t a, int32_t b, gjk2_mass *out) {
  gjk_big area, of_pi;
  gjk_big_set(&area, 0);
  gjk_big_set(&of_pi, gjk_mul32(a, b));
  join_pi(&area, &of_pi);
  gjk2_set_body(plane_area_of(&area), mean_of_squares(a, b, 4), out);
}

// Adds the triangle of 0, p, q.
static void add_plane_triangle(gjk2_moments *sums, gjk2_vec p, gjk2_vec q) {
  gjk_big weight;
  gjk_big_set(&weight, gjk2_cross(p, q));
  gjk2_moments_add(sums, &weight, gjk2_add(p, q), gjk2_moments_squares(p, q));
}

// Pre: the outline is sound.
static void mass_of_outline(const gjk2_vec *v, uint32_t count, int32_t radius, gjk2_mass *out) {
  if (radius > 0) {
    gjk2_mass_of_rounded(v, count, radius, out);
    return;
  }
  gjk2_moments sums;
  gjk_big square, inertia, whole;
  int64_t centre[2];
  gjk2_moments_start(&sums);
  for (uint32_t i = 1; i + 1 < count; i++) {
    add_plane_triangle(&sums, gjk2_sub(v[i], v[0]), gjk2_sub(v[i + 1], v[0]));
  }
  gjk_big_multiply(&inertia, &sums.weight, &sums.second);
  gjk_big_scale(&inertia, 3);
  for (int i = 0; i < 2; i++) {
    gjk_big_multiply(&square, &sums.first[i], &sums.first[i]);
    gjk_big_scale(&square, 4);
    gjk_big_subtract(&inertia, &square);
  }
  gjk_big_multiply(&whole, &sums.weight, &sums.weight);
  gjk_big_scale(&whole, 36);
  const int64_t mean = gjk_big_nearest(&inertia, &whole);
  gjk_big_copy(&whole, &sums.weight);
  gjk_big_scale(&whole, 3);
  for (int i = 0; i < 2; i++) {
    gjk_big_scale(&sums.first[i], UINT32_C(1) << 16);
    gjk_big_divide(&sums.first[i], &whole);
    centre[i] = gjk_shl64(i == 0 ? v[0].x : v[0].y, 16) + gjk_big_low(&sums.first[i]);
  }
  gjk2_set_body((uint64_t)(gjk_sar64(gjk_big_low(&sums.weight) + 1, 1)), mean, out);
  gjk2_set_centre(centre, out);
}

// The segment from a to b, which may be one point: the inertia is |b - a|^2 / 12.
static void mass_of_plane_segment(gjk2_vec a, gjk2_vec b, int32_t radius, gjk2_mass *out) {
  if (radius > 0) {
    gjk2_vec ends[2];
    gjk2_copy(&ends[0], &a);
    gjk2_copy(&ends[1], &b);
    gjk2_mass_of_rounded(ends, gjk2_equal(a, b) ? 1 : 2, radius, out);
    return;
  }
  const gjk2_vec e = gjk2_sub(b, a);
  const int64_t centre[2] = {gjk_shl64((int64_t)a.x + b.x, 15), gjk_shl64((int64_t)a.y + b.y, 15)};
  gjk2_set_body(0, mean_of_squares(e.x, e.y, 12), out);
  gjk2_set_centre(centre, out);
}

// A triangle in either order; of vertices in a line the two ends count.
static void mass_of_plane_triangle(const gjk2_vec *v, int32_t radius, gjk2_mass *out) {
  const int64_t turn = gjk2_cross(gjk2_sub(v[1], v[0]), gjk2_sub(v[2], v[0]));
  if (turn != 0) {
    gjk2_vec ordered[3];
    gjk2_copy(&ordered[0], &v[0]);
    gjk2_copy(&ordered[1], &v[turn > 0 ? 1 : 2]);
    gjk2_copy(&ordered[2], &v[turn > 0 ? 2 : 1]);
    mass_of_outline(ordered, 3, radius, out);
    return;
  }
  unsigned first = 0, last = 0;
  for (unsigned i = 1; i < 3; i++) {
    first = v[i].x < v[first].x || (v[i].x == v[first].x && v[i].y < v[first].y) ? i : first;
    last = v[i].x > v[last].x || (v[i].x == v[last].x && v[i].y > v[last].y) ? i : last;
  }
  mass_of_plane_segment(v[first], v[last], radius, out);
}

static gjk_status mass_of_polygon(const gjk2_shape *shape, gjk2_mass *out) {
  const gjk2_vec *v = shape->vertices;
  const int32_t radius = shape->convex_radius;
  gjk2_hull_report report;
  if (shape->count == 3) {
    mass_of_plane_triangle(v, radius, out);
    return GJK_OK;
  }
  if (shape->count < 3) {
    mass_of_plane_segment(v[0], v[shape->count - 1], radius, out);
    return GJK_OK;
  }
  gjk2_outline_check(v, shape->count, &report);
  if (report.fault != GJK2_HULL_SOUND) {
    return GJK_ERROR_UNSUPPORTED;
  }
  mass_of_outline(v, shape->count, radius, out);
  return GJK_OK;
}

// The checks of gjk2_collider_init.
static gjk_status check_plane_mass_shape(const gjk2_shape *shape) {
  gjk2_extent extent;
  if (shape->type == NULL) {
    return GJK_ERROR_NULL;
  }
  const gjk_status status = shape->convex_radius < 0 ? GJK_ERROR_NEGATIVE : shape->type->measure(shape, &extent);
  if (status != GJK_OK) {
    return status;
  }
  const int64_t room = (int64_t)GJK2_RADIUS_MAX - shape->convex_radius;
  return room < 0 || extent.squared > (uint64_t)(room * room) ? GJK_ERROR_SIZE : GJK_OK;
}

gjk_status gjk2_mass_of_shape(const gjk2_shape *shape, gjk2_mass *out) {
  if (shape == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  const gjk_status status = check_plane_mass_shape(shape);
  if (status != GJK_OK) {
    return status;
  }
  const gjk2_shape_class *type = shape->type;
  if (type->buffered || type->count == 3) {
    return mass_of_polygon(shape, out);
  }
  if (!gjk2_is_curved(shape)) {
    mass_of_plane_axes(type->count > 1 ? shape->size.x : 0, type->count > 2 ? shape->size.y : 0, shape->convex_radius,
                       out);
    return GJK_OK;
  }
  const bool round = shape->size.x == shape->size.y;  // a disc stays one with a radius
  if (shape->support != NULL || (shape->convex_radius > 0 && !round)) {
    return GJK_ERROR_UNSUPPORTED;
  }
  if (round) {
    mass_of_plane_axes(0, 0, shape->size.x + shape->convex_radius, out);
    return GJK_OK;
  }
  mass_of_ellipse(shape->size.x, shape->size.y, out);
  return GJK_OK;
}

gjk_status gjk2_mass_set_density(gjk2_mass *body, uint32_t density) {
  if (body == NULL) {
    return GJK_ERROR_NULL;
  }
  // area density / 2^32, to the nearest: 2^32 high + low is area density
  const uint32_t area_low = (uint32_t)(body->area & UINT32_MAX), area_high = (uint32_t)(body->area >> 32);
  const uint64_t low = gjk_umul32(area_low, density) + (UINT32_C(1) << 31);  // <= (2^32 - 1)^2 + 2^31
  const uint64_t high = gjk_umul32(area_high, density) + (low >> 32);
  if (high > UINT32_MAX) {
    return GJK_ERROR_RANGE;
  }
  body->mass = (uint32_t)high;
  return GJK_OK;
}

// *out = x y.
static void multiply_plane_longs(int64_t x, int64_t y, gjk_big *out) {
  gjk_big factor;
  gjk_big_set(&factor, x);
  gjk_big_set(out, 0);
  gjk_big_add_product(out, &factor, y);
}

// sum += 2^32 m n inertia.
static void add_plane_inertia(uint32_t m, uint32_t n, int64_t inertia, gjk_big *sum) {
  gjk_big weight;
  multiply_plane_longs(m, n, &weight);
  gjk_big_scale(&weight, UINT32_C(1) << 16);
  gjk_big_scale(&weight, UINT32_C(1) << 16);
  gjk_big_add_product(sum, &weight, inertia);
}

// A part's centre in the body's frame, 2^-16 LSB, and whether it fits.
static bool place_plane_part(const gjk2_mass *part, const gjk2_pose *pose, int64_t at[2]) {
  static const int8_t none[2] = {0, 0};
  gjk2_vec unit;
  const gjk2_vec fraction = {part->fraction[0], part->fraction[1]};
  if (!gjk2_rotation_with_point(&pose->rotation, &part->centre, &unit, at)) {
    return false;
  }
  const gjk2_vec rest = gjk2_rotate_onto(&unit, fraction, none);
  at[0] = gjk_sar64(at[0], 14) + rest.x + gjk_shl64(pose->position.x, 16);  // |rotated| <= 2^62:  |at| < 2^50
  at[1] = gjk_sar64(at[1], 14) + rest.y + gjk_shl64(pose->position.y, 16);
  return true;
}

// (2^32 M (m I + n J) + m n |2^16 d|^2) / (2^32 M^2), with M = m + n < 2^32: as in src/mass/gjk_mass_add.c.
static int64_t join_plane_inertia(const gjk2_mass *body, const gjk2_mass *part, const int64_t d[2]) {
  const uint32_t whole = body->mass + part->mass;
  gjk_big sum, square, product, other;
  gjk_big_set(&sum, 0);
  multiply_plane_longs(body->mass, part->mass, &product);
  for (int i = 0; i < 2; i++) {
    multiply_plane_longs(d[i], d[i], &square);
    gjk_big_multiply(&other, &square, &product);
    gjk_big_add(&sum, &other);
  }
  add_plane_inertia(whole, body->mass, body->inertia, &sum);
  add_plane_inertia(whole, part->mass, part->inertia, &sum);
  gjk_big_set(&other, 0);
  add_plane_inertia(whole, whole, 1, &other);
  return gjk_big_nearest(&sum, &other);
}

static bool is_plane_inertia(int64_t inertia) {
  return inertia >= 0 && inertia <= PLANE_INERTIA_MAX;
}

gjk_status gjk2_mass_add(gjk2_mass *body, const gjk2_mass *part, const gjk2_pose *pose) {
  if (body == NULL || part == NULL || pose == NULL) {
    return GJK_ERROR_NULL;
  }
  if (body == part) {
    return GJK_ERROR_OVERLAP;
  }
  if (part->mass == 0 || part->mass > UINT32_MAX - body->mass || !is_plane_inertia(body->inertia) ||
      !is_plane_inertia(part->inertia)) {
    return GJK_ERROR_RANGE;
  }
  int64_t at[2], own[2], d[2];
  if (!place_plane_part(part, pose, at)) {
    return GJK_ERROR_ROTATION;
  }
  own[0] = body->mass == 0 ? at[0] : gjk_shl64(body->centre.x, 16) + body->fraction[0];
  own[1] = body->mass == 0 ? at[1] : gjk_shl64(body->centre.y, 16) + body->fraction[1];
  for (int i = 0; i < 2; i++) {
    const int64_t nearest = gjk_sar64(at[i] + INT64_C(0x8000), 16);
    d[i] = at[i] - own[i];
    if (nearest < INT32_MIN || nearest > INT32_MAX || gjk_magnitude64(d[i]) > UINT64_C(1) << 46) {
      return GJK_ERROR_RANGE;
    }
  }
  const int64_t inertia = join_plane_inertia(body, part, d);  // at most 2^60 + 2^59
  if (!is_plane_inertia(inertia)) {
    return GJK_ERROR_RANGE;
  }
  for (int i = 0; i < 2; i++) {
    gjk_big way, all;
    multiply_plane_longs(d[i], part->mass, &way);
    gjk_big_set(&all, (int64_t)body->mass + part->mass);
    gjk_big_divide(&way, &all);
    own[i] += gjk_big_low(&way);
  }
  gjk2_set_centre(own, body);
  body->inertia = inertia;
  body->mass += part->mass;
  body->area += part->area;
  return GJK_OK;
}
