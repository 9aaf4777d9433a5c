// The library for C++17: literals, constexpr shapes, queries that return their answer with its status.
//
//     using namespace gjk::literals;
//     static constexpr gjk_shape crate = gjk::box(0.5_q16, 0.5_q16, 0.5_q16);  // a constant, fit for flash
//     static constexpr gjk_shape ball = gjk::sphere(0.25_q16);
//
//     auto a = gjk::place(crate), b = gjk::place(ball, {{1.5_q16, 0, 0}, gjk::upright});
//     if (a && b) {
//       if (auto gap = gjk::distance(*a, *b)) use(gap->distance);
//     }
//
// Everything here is a thin inline layer: values are the structures of the C headers, which also say what each call
// answers, how exactly, and with which statuses. No exceptions, no heap, no runtime type information, nothing of the
// standard library, and at most a store more for each call than in C; so it serves firmware, too. gjk2.hpp is the same in
// the plane; gjk_scene.hpp has scenes, gjk_parts.hpp bodies of many parts, hulls of points and masses.
#ifndef GJK_HPP
#define GJK_HPP

#if __cplusplus < 201703L
#error "gjk.hpp needs C++17: compile with -std=c++17, or use the C headers, which any C++ takes"
#endif

#include "gjk/gjk.h"

namespace gjk {

// A value and how it came about. Contextually true where the status is GJK_OK; then *r and r->field are the value.
template <typename Value>
class [[nodiscard]] result {
 public:
  explicit constexpr operator bool() const { return status_ == GJK_OK; }
  constexpr gjk_status status() const { return status_; }

  // Only where the result is true.
  constexpr Value &operator*() { return value_; }
  constexpr const Value &operator*() const { return value_; }
  constexpr Value *operator->() { return &value_; }
  constexpr const Value *operator->() const { return &value_; }

  // What the call has written, whatever its status: after GJK_ERROR_ITERATION_LIMIT and GJK_ERROR_CAPACITY the fields that
  // the header of the query names, and nothing after any other error.
  constexpr const Value &partial() const { return value_; }

  constexpr Value value_or(const Value &other) const { return status_ == GJK_OK ? value_ : other; }

  // The result of call(&value), which returns a status. The value is not set before.
  template <typename Call>
  static result of(Call call) {
    result r;
    r.status_ = call(&r.value_);
    return r;
  }

 private:
  result() {}  // leaves the value to the call: setting it before would cost more than in C

  Value value_;
  gjk_status status_;
};

// A contiguous range that someone else keeps: an array, or a container with data() and size() that is no temporary.
template <typename Item>
class span {
 public:
  constexpr span() = default;
  constexpr span(Item *data, size_t size) : data_(data), size_(size) {}
  template <size_t count>
  constexpr span(Item (&items)[count]) : data_(items), size_(count) {}
  template <typename Container, typename = decltype(static_cast<Item *>(static_cast<Container *>(nullptr)->data()))>
  constexpr span(Container &items) : data_(items.data()), size_(items.size()) {}

  constexpr Item *data() const { return data_; }
  constexpr size_t size() const { return size_; }
  constexpr Item *begin() const { return data_; }
  constexpr Item *end() const { return data_ + size_; }

  // The size as the C functions take it: of vertices 0 where a hull cannot have so many, which they refuse as EMPTY; of room
  // for them the most that they can use.
  constexpr uint16_t count() const { return size_ <= UINT16_MAX ? static_cast<uint16_t>(size_) : 0; }
  constexpr uint16_t room() const { return size_ <= UINT16_MAX ? static_cast<uint16_t>(size_) : UINT16_MAX; }
  constexpr uint32_t count32() const { return size_ <= UINT32_MAX ? static_cast<uint32_t>(size_) : UINT32_MAX; }

 private:
  Item *data_ = nullptr;
  size_t size_ = 0;
};

namespace detail {

// A literal of decimal digits times scale, at most 2^30: the nearest integer, a half up. -1: it is no such number, has more
// than 9 digits after the point, or leaves int32.
template <char... characters>
constexpr int32_t fixed(uint64_t scale) {
  const char text[] = {characters...};
  uint64_t whole = 0, fraction = 0, unit = 1;
  bool is_fraction = false;
  for (const char c : text) {
    const bool is_digit = c >= '0' && c <= '9';
    if ((!is_digit && c != '.' && c != '\'') || whole > INT32_MAX || (is_digit && unit == 1000000000)) {
      return -1;
    }
    if (is_digit && is_fraction) {
      fraction = 10 * fraction + static_cast<uint64_t>(c - '0');
      unit *= 10;
    } else if (is_digit) {
      whole = 10 * whole + static_cast<uint64_t>(c - '0');
    }
    is_fraction = is_fraction || c == '.';
  }
  if (whole > INT32_MAX) {
    return -1;
  }
  // fraction < unit <= 10^9 < 2^30:  whole * scale < 2^61,  2 * fraction * scale + unit < 2^62
  const uint64_t nearest = whole * scale + (2 * fraction * scale + unit) / (2 * unit);
  return nearest <= INT32_MAX ? static_cast<int32_t>(nearest) : -1;
}

}  // namespace detail

// Numbers in units, which the compiler turns into integers: 0.5_q16, -1.25_q16, 3.14159_angle.
namespace literals {

template <char... characters>
constexpr gjk_q16 operator""_q16() {
  constexpr int32_t value = detail::fixed<characters...>(65536);
  static_assert(value >= 0, "a length is below 32768, with at most 9 digits after the point");
  return value;
}

template <char... characters>
constexpr gjk_q30 operator""_q30() {
  constexpr int32_t value = detail::fixed<characters...>(1073741824);
  static_assert(value >= 0, "a number in Q2.30 is below 2, with at most 9 digits after the point");
  return value;
}

template <char... characters>
constexpr gjk_angle operator""_angle() {
  constexpr int32_t value = detail::fixed<characters...>(65536);
  static_assert(value >= 0, "an angle is below 32768 radians, with at most 9 digits after the point");
  return value;
}

}  // namespace literals

// Shapes: gjk/shape.h. radius is the convex radius around the core. What a shape points to stays the caller's.

constexpr gjk_shape point() { return GJK_POINT; }
constexpr gjk_shape sphere(gjk_q16 radius) { return GJK_SPHERE(radius); }
constexpr gjk_shape segment(gjk_q16 half) { return GJK_SEGMENT(half); }
constexpr gjk_shape capsule(gjk_q16 radius, gjk_q16 half) { return GJK_CAPSULE(radius, half); }

// Of three vertices; others are refused as RANGE.
constexpr gjk_shape triangle(span<const gjk_vec3> vertices, gjk_q16 radius = 0) {
  gjk_shape shape = GJK_ROUNDED_TRIANGLE(vertices.data(), radius);
  shape.count = vertices.count();
  return shape;
}

constexpr gjk_shape box(gjk_q16 half_x, gjk_q16 half_y, gjk_q16 half_z, gjk_q16 radius = 0) {
  return GJK_ROUNDED_BOX(half_x, half_y, half_z, radius);
}

// The convex hull of vertices in any order. faces: only contacts need them.
constexpr gjk_shape hull(span<const gjk_vec3> vertices, gjk_q16 radius = 0, const gjk_hull_faces *faces = nullptr) {
  return GJK_ROUNDED_HULL_WITH_FACES(vertices.data(), vertices.count(), faces, radius);
}

constexpr gjk_shape cylinder(gjk_q16 base_radius, gjk_q16 half, gjk_q16 radius = 0) {
  return GJK_ROUNDED_CYLINDER(base_radius, half, radius);
}

constexpr gjk_shape cone(gjk_q16 base_radius, gjk_q16 half, gjk_q16 radius = 0) {
  return GJK_ROUNDED_CONE(base_radius, half, radius);
}

constexpr gjk_shape ellipsoid(gjk_q16 radius_x, gjk_q16 radius_y, gjk_q16 radius_z, gjk_q16 radius = 0) {
  return GJK_ROUNDED_ELLIPSOID(radius_x, radius_y, radius_z, radius);
}

constexpr gjk_shape custom(gjk_support_function *support, const void *user, gjk_q16 bound, gjk_q16 radius = 0) {
  return GJK_ROUNDED_CUSTOM(support, user, bound, radius);
}

// Rotations and poses: gjk/pose.h.

inline constexpr gjk_quat upright = {0, 0, 0, GJK_Q30_ONE};
inline constexpr gjk_pose origin = GJK_POSE_IDENTITY;

// By an angle about an axis of any length.
inline result<gjk_quat> rotation(const gjk_vec3 &axis, gjk_angle angle) {
  return result<gjk_quat>::of([&](auto *out) { return gjk_quat_from_axis_angle(&axis, angle, out); });
}

// About fixed x, then fixed y, then fixed z.
inline result<gjk_quat> rotation(gjk_angle x, gjk_angle y, gjk_angle z) {
  return result<gjk_quat>::of([&](auto *out) { return gjk_quat_from_euler(x, y, z, out); });
}

inline result<gjk_quat> normalize(const gjk_quat &q) {
  return result<gjk_quat>::of([&](auto *out) { return gjk_quat_normalize(&q, out); });
}

// First b, then a.
inline result<gjk_quat> compose(const gjk_quat &a, const gjk_quat &b) {
  return result<gjk_quat>::of([&](auto *out) { return gjk_quat_compose(&a, &b, out); });
}

inline result<gjk_pose> compose(const gjk_pose &a, const gjk_pose &b) {
  return result<gjk_pose>::of([&](auto *out) { return gjk_pose_compose(&a, &b, out); });
}

inline result<gjk_quat> invert(const gjk_quat &q) {
  return result<gjk_quat>::of([&](auto *out) { return gjk_quat_invert(&q, out); });
}

inline result<gjk_pose> invert(const gjk_pose &p) {
  return result<gjk_pose>::of([&](auto *out) { return gjk_pose_invert(&p, out); });
}

// The vector, rotated; the world position of a point of a pose's frame.
inline result<gjk_vec3> apply(const gjk_quat &q, const gjk_vec3 &v) {
  return result<gjk_vec3>::of([&](auto *out) { return gjk_quat_apply(&q, &v, out); });
}

inline result<gjk_vec3> apply(const gjk_pose &p, const gjk_vec3 &v) {
  return result<gjk_vec3>::of([&](auto *out) { return gjk_pose_apply(&p, &v, out); });
}

// Colliders: gjk/collider.h. The shape must outlive its collider, so a temporary one does not compile. buffer: room for the
// posed vertices of a hull, which is then baked.

inline result<gjk_collider> place(const gjk_shape &shape, const gjk_pose &pose = origin, span<gjk_vec3> buffer = {}) {
  return result<gjk_collider>::of([&](gjk_collider *out) {
    const gjk_status status = gjk_collider_init(out, &shape, buffer.data(), buffer.room());
    return status == GJK_OK ? gjk_collider_pose(out, &pose) : status;
  });
}

result<gjk_collider> place(const gjk_shape &&, const gjk_pose & = origin, span<gjk_vec3> = {}) = delete;

[[nodiscard]] inline gjk_status pose(gjk_collider &collider, const gjk_pose &pose) {
  return gjk_collider_pose(&collider, &pose);
}

[[nodiscard]] inline gjk_status move(gjk_collider &collider, const gjk_vec3 &position) {
  return gjk_collider_move(&collider, &position);
}

inline result<gjk_aabb> aabb(const gjk_collider &collider) {
  return result<gjk_aabb>::of([&](auto *out) { return gjk_collider_aabb(&collider, out); });
}

// Decisions and distances: gjk/intersect.h, gjk/distance.h. cache: the caller's, or none.

inline result<gjk_decision> intersect(const gjk_collider &a, const gjk_collider &b, gjk_cache *cache = nullptr) {
  return result<gjk_decision>::of([&](auto *out) { return gjk_intersect(&a, &b, cache, out); });
}

inline result<gjk_decision> within(const gjk_collider &a, const gjk_collider &b, gjk_q16 most,
                                   gjk_cache *cache = nullptr) {
  return result<gjk_decision>::of([&](auto *out) { return gjk_within(&a, &b, most, cache, out); });
}

inline result<gjk_within_result> within_until(const gjk_collider &a, const gjk_collider &b, gjk_q16 most,
                                              uint8_t iterations, gjk_cache *cache = nullptr) {
  return result<gjk_within_result>::of(
      [&](auto *out) { return gjk_within_until(&a, &b, most, iterations, cache, out); });
}

inline result<gjk_distance_result> distance(const gjk_collider &a, const gjk_collider &b, gjk_cache *cache = nullptr) {
  return result<gjk_distance_result>::of([&](auto *out) { return gjk_distance(&a, &b, cache, out); });
}

inline result<gjk_distance_result> distance_until(const gjk_collider &a, const gjk_collider &b,
                                                  const gjk_effort &effort, gjk_cache *cache = nullptr) {
  return result<gjk_distance_result>::of([&](auto *out) { return gjk_distance_until(&a, &b, &effort, cache, out); });
}

// Depths and contacts: gjk/penetration.h, gjk/contacts.h. In the plane they need no workspace.

// Memory for an EPA hull of so many vertices. It may serve one query after another.
template <unsigned vertices>
class workspace {
 public:
  operator gjk_workspace() { return {cells, GJK_EPA_CELLS(vertices)}; }

 private:
  gjk_epa_cell cells[GJK_EPA_CELLS(vertices)];
};

// No workspace: enough for points, segments and boxes, with or without a convex radius.
inline constexpr gjk_workspace no_workspace = {nullptr, 0};

inline result<gjk_penetration_result> penetration(const gjk_collider &a, const gjk_collider &b,
                                                  const gjk_workspace &memory = no_workspace,
                                                  gjk_cache *cache = nullptr) {
  return result<gjk_penetration_result>::of([&](auto *out) { return gjk_penetration(&a, &b, cache, &memory, out); });
}

inline result<gjk_distance_result> signed_distance(const gjk_collider &a, const gjk_collider &b,
                                                   const gjk_workspace &memory = no_workspace,
                                                   gjk_cache *cache = nullptr) {
  return result<gjk_distance_result>::of([&](auto *out) { return gjk_signed_distance(&a, &b, cache, &memory, out); });
}

// A manifold is a range of its contacts: for (const gjk_contact &contact : *touch).
inline result<gjk_manifold> contacts(const gjk_collider &a, const gjk_collider &b, gjk_q16 margin = 0,
                                     unsigned most = 4, const gjk_workspace &memory = no_workspace,
                                     gjk_cache *cache = nullptr) {
  return result<gjk_manifold>::of([&](auto *out) { return gjk_contacts(&a, &b, margin, most, cache, &memory, out); });
}

// Casts and times of impact: gjk/cast.h, gjk/impact.h.

inline result<gjk_cast_result> cast(const gjk_collider &a, const gjk_collider &b, const gjk_cast_path &path) {
  return result<gjk_cast_result>::of([&](auto *out) { return gjk_cast(&a, &b, &path, out); });
}

inline result<gjk_cast_result> cast_ray(const gjk_collider &a, const gjk_vec3 &from, const gjk_vec3 &to) {
  return result<gjk_cast_result>::of([&](auto *out) { return gjk_cast_ray(&a, &from, &to, out); });
}

inline result<gjk_pose> pose_at(const gjk_motion &motion, gjk_q30 fraction) {
  return result<gjk_pose>::of([&](auto *out) { return gjk_motion_pose(&motion, fraction, out); });
}

inline result<gjk_impact_result> time_of_impact(const gjk_collider &a, const gjk_motion &motion_a,
                                                const gjk_collider &b, const gjk_motion &motion_b,
                                                const gjk_impact_setup &setup = {0, GJK_IMPACT_TOLERANCE_MIN, 0}) {
  return result<gjk_impact_result>::of(
      [&](auto *out) { return gjk_time_of_impact(&a, &motion_a, &b, &motion_b, &setup, out); });
}

// Proofs: gjk/check.h. GJK_OK: the answer is true of these colliders.

[[nodiscard]] inline gjk_status check(const gjk_collider &a, const gjk_collider &b, const gjk_decision &decision,
                                      gjk_q16 most = 0) {
  return gjk_check_decision(&a, &b, most, &decision);
}

[[nodiscard]] inline gjk_status check(const gjk_collider &a, const gjk_collider &b, const gjk_distance_result &result) {
  return gjk_check_distance(&a, &b, &result);
}

[[nodiscard]] inline gjk_status check(const gjk_collider &a, const gjk_collider &b,
                                      const gjk_penetration_result &result) {
  return gjk_check_penetration(&a, &b, &result);
}

[[nodiscard]] inline gjk_status check(const gjk_collider &a, const gjk_collider &b, const gjk_cast_path &path,
                                      const gjk_cast_result &result) {
  return gjk_check_cast(&a, &b, &path, &result);
}

}  // namespace gjk

// Where the structures are, so that a loop over a range and a comparison find them.

constexpr const gjk_contact *begin(const gjk_manifold &manifold) { return manifold.contact; }
constexpr const gjk_contact *end(const gjk_manifold &manifold) { return manifold.contact + manifold.count; }

constexpr bool operator==(const gjk_vec3 &a, const gjk_vec3 &b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
constexpr bool operator==(const gjk_unit3 &a, const gjk_unit3 &b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
constexpr bool operator!=(const gjk_vec3 &a, const gjk_vec3 &b) { return !(a == b); }
constexpr bool operator!=(const gjk_unit3 &a, const gjk_unit3 &b) { return !(a == b); }

#endif
