// The library for C++17 in the plane: what gjk.hpp is in space, in namespace gjk2.
//
//     using namespace gjk::literals;
//     static constexpr gjk2_shape crate = gjk2::box(0.5_q16, 0.5_q16);
//     auto a = gjk2::place(crate);
#ifndef GJK2_HPP
#define GJK2_HPP

#include "gjk.hpp"
#include "gjk2/gjk2.h"

namespace gjk2 {

using gjk::result;
using gjk::span;

// Shapes: gjk2/shape.h. radius is the convex radius around the core. What a shape points to stays the caller's.

constexpr gjk2_shape point() { return GJK2_POINT; }
constexpr gjk2_shape circle(gjk_q16 radius) { return GJK2_CIRCLE(radius); }
constexpr gjk2_shape segment(gjk_q16 half) { return GJK2_SEGMENT(half); }
constexpr gjk2_shape capsule(gjk_q16 radius, gjk_q16 half) { return GJK2_CAPSULE(radius, half); }

// Of three vertices; others are refused as RANGE.
constexpr gjk2_shape triangle(span<const gjk2_vec> vertices, gjk_q16 radius = 0) {
  gjk2_shape shape = GJK2_ROUNDED_TRIANGLE(vertices.data(), radius);
  shape.count = vertices.count();
  return shape;
}

constexpr gjk2_shape box(gjk_q16 half_x, gjk_q16 half_y, gjk_q16 radius = 0) {
  return GJK2_ROUNDED_BOX(half_x, half_y, radius);
}

// The convex hull of vertices in any order.
constexpr gjk2_shape polygon(span<const gjk2_vec> vertices, gjk_q16 radius = 0) {
  return GJK2_ROUNDED_POLYGON(vertices.data(), vertices.count(), radius);
}

constexpr gjk2_shape ellipse(gjk_q16 radius_x, gjk_q16 radius_y, gjk_q16 radius = 0) {
  return GJK2_ROUNDED_ELLIPSE(radius_x, radius_y, radius);
}

constexpr gjk2_shape custom(gjk2_support_function *support, const void *user, gjk_q16 bound, gjk_q16 radius = 0) {
  return GJK2_ROUNDED_CUSTOM(support, user, bound, radius);
}

// Rotations and poses: gjk2/pose.h.

inline constexpr gjk2_rotation upright = {GJK_Q30_ONE, 0};
inline constexpr gjk2_pose origin = GJK2_POSE_IDENTITY;

inline result<gjk2_rotation> rotation(gjk_angle angle) {
  return result<gjk2_rotation>::of([&](auto *out) { return gjk2_rotation_from_angle(angle, out); });
}

inline result<gjk2_rotation> normalize(const gjk2_rotation &r) {
  return result<gjk2_rotation>::of([&](auto *out) { return gjk2_rotation_normalize(&r, out); });
}

// First b, then a.
inline result<gjk2_rotation> compose(const gjk2_rotation &a, const gjk2_rotation &b) {
  return result<gjk2_rotation>::of([&](auto *out) { return gjk2_rotation_compose(&a, &b, out); });
}

inline result<gjk2_pose> compose(const gjk2_pose &a, const gjk2_pose &b) {
  return result<gjk2_pose>::of([&](auto *out) { return gjk2_pose_compose(&a, &b, out); });
}

inline result<gjk2_rotation> invert(const gjk2_rotation &r) {
  return result<gjk2_rotation>::of([&](auto *out) { return gjk2_rotation_invert(&r, out); });
}

inline result<gjk2_pose> invert(const gjk2_pose &p) {
  return result<gjk2_pose>::of([&](auto *out) { return gjk2_pose_invert(&p, out); });
}

// The vector, rotated; the world position of a point of a pose's frame.
inline result<gjk2_vec> apply(const gjk2_rotation &r, const gjk2_vec &v) {
  return result<gjk2_vec>::of([&](auto *out) { return gjk2_rotation_apply(&r, &v, out); });
}

inline result<gjk2_vec> apply(const gjk2_pose &p, const gjk2_vec &v) {
  return result<gjk2_vec>::of([&](auto *out) { return gjk2_pose_apply(&p, &v, out); });
}

// Colliders: gjk2/collider.h. The shape must outlive its collider, so a temporary one does not compile. buffer: room for
// the posed vertices of a polygon, which is then baked.

inline result<gjk2_collider> place(const gjk2_shape &shape, const gjk2_pose &pose = origin,
                                   span<gjk2_vec> buffer = {}) {
  return result<gjk2_collider>::of([&](gjk2_collider *out) {
    const gjk_status status = gjk2_collider_init(out, &shape, buffer.data(), buffer.room());
    return status == GJK_OK ? gjk2_collider_pose(out, &pose) : status;
  });
}

result<gjk2_collider> place(const gjk2_shape &&, const gjk2_pose & = origin, span<gjk2_vec> = {}) = delete;

[[nodiscard]] inline gjk_status pose(gjk2_collider &collider, const gjk2_pose &pose) {
  return gjk2_collider_pose(&collider, &pose);
}

[[nodiscard]] inline gjk_status move(gjk2_collider &collider, const gjk2_vec &position) {
  return gjk2_collider_move(&collider, &position);
}

inline result<gjk2_aabb> aabb(const gjk2_collider &collider) {
  return result<gjk2_aabb>::of([&](auto *out) { return gjk2_collider_aabb(&collider, out); });
}

// Decisions and distances: gjk2/intersect.h, gjk2/distance.h. cache: the caller's, or none.

inline result<gjk2_decision> intersect(const gjk2_collider &a, const gjk2_collider &b, gjk2_cache *cache = nullptr) {
  return result<gjk2_decision>::of([&](auto *out) { return gjk2_intersect(&a, &b, cache, out); });
}

inline result<gjk2_decision> within(const gjk2_collider &a, const gjk2_collider &b, gjk_q16 most,
                                    gjk2_cache *cache = nullptr) {
  return result<gjk2_decision>::of([&](auto *out) { return gjk2_within(&a, &b, most, cache, out); });
}

inline result<gjk2_within_result> within_until(const gjk2_collider &a, const gjk2_collider &b, gjk_q16 most,
                                               uint8_t iterations, gjk2_cache *cache = nullptr) {
  return result<gjk2_within_result>::of(
      [&](auto *out) { return gjk2_within_until(&a, &b, most, iterations, cache, out); });
}

inline result<gjk2_distance_result> distance(const gjk2_collider &a, const gjk2_collider &b,
                                             gjk2_cache *cache = nullptr) {
  return result<gjk2_distance_result>::of([&](auto *out) { return gjk2_distance(&a, &b, cache, out); });
}

inline result<gjk2_distance_result> distance_until(const gjk2_collider &a, const gjk2_collider &b,
                                                   const gjk2_effort &effort, gjk2_cache *cache = nullptr) {
  return result<gjk2_distance_result>::of([&](auto *out) { return gjk2_distance_until(&a, &b, &effort, cache, out); });
}

// Depths and contacts: gjk2/penetration.h, gjk2/contacts.h. A manifold is a range of its contacts.

inline result<gjk2_penetration_result> penetration(const gjk2_collider &a, const gjk2_collider &b,
                                                   gjk2_cache *cache = nullptr) {
  return result<gjk2_penetration_result>::of([&](auto *out) { return gjk2_penetration(&a, &b, cache, out); });
}

inline result<gjk2_distance_result> signed_distance(const gjk2_collider &a, const gjk2_collider &b,
                                                    gjk2_cache *cache = nullptr) {
  return result<gjk2_distance_result>::of([&](auto *out) { return gjk2_signed_distance(&a, &b, cache, out); });
}

inline result<gjk2_manifold> contacts(const gjk2_collider &a, const gjk2_collider &b, gjk_q16 margin = 0,
                                      unsigned most = 2, gjk2_cache *cache = nullptr) {
  return result<gjk2_manifold>::of([&](auto *out) { return gjk2_contacts(&a, &b, margin, most, cache, out); });
}

// Casts and times of impact: gjk2/cast.h, gjk2/impact.h.

inline result<gjk2_cast_result> cast(const gjk2_collider &a, const gjk2_collider &b, const gjk2_cast_path &path) {
  return result<gjk2_cast_result>::of([&](auto *out) { return gjk2_cast(&a, &b, &path, out); });
}

inline result<gjk2_cast_result> cast_ray(const gjk2_collider &a, const gjk2_vec &from, const gjk2_vec &to) {
  return result<gjk2_cast_result>::of([&](auto *out) { return gjk2_cast_ray(&a, &from, &to, out); });
}

inline result<gjk2_pose> pose_at(const gjk2_motion &motion, gjk_q30 fraction) {
  return result<gjk2_pose>::of([&](auto *out) { return gjk2_motion_pose(&motion, fraction, out); });
}

inline result<gjk2_impact_result> time_of_impact(const gjk2_collider &a, const gjk2_motion &motion_a,
                                                 const gjk2_collider &b, const gjk2_motion &motion_b,
                                                 const gjk2_impact_setup &setup = {0, GJK2_IMPACT_TOLERANCE_MIN, 0}) {
  return result<gjk2_impact_result>::of(
      [&](auto *out) { return gjk2_time_of_impact(&a, &motion_a, &b, &motion_b, &setup, out); });
}

// Proofs: gjk2/check.h. GJK_OK: the answer is true of these colliders.

[[nodiscard]] inline gjk_status check(const gjk2_collider &a, const gjk2_collider &b, const gjk2_decision &decision,
                                      gjk_q16 most = 0) {
  return gjk2_check_decision(&a, &b, most, &decision);
}

[[nodiscard]] inline gjk_status check(const gjk2_collider &a, const gjk2_collider &b,
                                      const gjk2_distance_result &result) {
  return gjk2_check_distance(&a, &b, &result);
}

[[nodiscard]] inline gjk_status check(const gjk2_collider &a, const gjk2_collider &b,
                                      const gjk2_penetration_result &result) {
  return gjk2_check_penetration(&a, &b, &result);
}

[[nodiscard]] inline gjk_status check(const gjk2_collider &a, const gjk2_collider &b, const gjk2_cast_path &path,
                                      const gjk2_cast_result &result) {
  return gjk2_check_cast(&a, &b, &path, &result);
}

}  // namespace gjk2

// Where the structures are, so that a loop over a range and a comparison find them.

constexpr const gjk2_contact *begin(const gjk2_manifold &manifold) { return manifold.contact; }
constexpr const gjk2_contact *end(const gjk2_manifold &manifold) { return manifold.contact + manifold.count; }

constexpr bool operator==(const gjk2_vec &a, const gjk2_vec &b) { return a.x == b.x && a.y == b.y; }
constexpr bool operator==(const gjk2_unit &a, const gjk2_unit &b) { return a.x == b.x && a.y == b.y; }
constexpr bool operator!=(const gjk2_vec &a, const gjk2_vec &b) { return !(a == b); }
constexpr bool operator!=(const gjk2_unit &a, const gjk2_unit &b) { return !(a == b); }

#endif
