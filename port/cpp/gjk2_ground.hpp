// Ground of the plane for C++17, in the caller's memory: chains, height profiles and grids of tiles (gjk2/ground.h).
//
//     static gjk2_ground ground;
//     const auto shape = gjk2::make_ground(tiles, ground);  // for a scene's table of shapes
//     if (auto near = gjk2::distance(ground, ball); near && near->found) use(near->segment, near->answer.distance);
#ifndef GJK2_GROUND_HPP
#define GJK2_GROUND_HPP

#include "gjk2.hpp"
#include "gjk2/ground.h"

namespace gjk2 {

// What ground is made of. data, and what it holds, must outlive ground, so a temporary does not compile.

inline result<gjk2_shape> make_ground(const gjk2_polyline &data, gjk2_ground &ground) {
  return result<gjk2_shape>::of([&](auto *out) { return gjk2_ground_of_chain(&data, &ground, out); });
}
inline result<gjk2_shape> make_ground(const gjk2_heights &data, gjk2_ground &ground) {
  return result<gjk2_shape>::of([&](auto *out) { return gjk2_ground_of_heights(&data, &ground, out); });
}
inline result<gjk2_shape> make_ground(const gjk2_tiles &data, gjk2_ground &ground) {
  return result<gjk2_shape>::of([&](auto *out) { return gjk2_ground_of_tiles(&data, &ground, out); });
}
result<gjk2_shape> make_ground(const gjk2_polyline &&, gjk2_ground &) = delete;
result<gjk2_shape> make_ground(const gjk2_heights &&, gjk2_ground &) = delete;
result<gjk2_shape> make_ground(const gjk2_tiles &&, gjk2_ground &) = delete;

// The index of a chain, which then may be the chain's own. boxes must outlive it.
inline result<gjk2_index> make_index(const gjk2_polyline &chain, span<gjk2_index_box> boxes) {
  return result<gjk2_index>::of([&](auto *out) { return gjk2_index_build(&chain, boxes.data(), boxes.room(), out); });
}

// Queries of ground at a pose, and of a body.

inline result<bool> within(const gjk2_ground &ground, const gjk2_collider &body, gjk_q16 most,
                           const gjk2_pose &pose = origin) {
  return result<bool>::of([&](auto *out) { return gjk2_ground_within(&ground, &pose, &body, most, out); });
}

// The nearest segment that counts. segment and answer are set only if found.
struct nearest_segment {
  bool found;
  uint32_t segment;
  gjk2_distance_result answer;
};

inline result<nearest_segment> distance(const gjk2_ground &ground, const gjk2_collider &body,
                                        const gjk2_pose &pose = origin) {
  return result<nearest_segment>::of(
      [&](auto *out) { return gjk2_ground_distance(&ground, &pose, &body, &out->answer, &out->segment, &out->found); });
}

// How many contacts there are, in room; after GJK_ERROR_CAPACITY there are more.
inline result<uint16_t> contacts(const gjk2_ground &ground, const gjk2_collider &body, span<gjk2_chain_contact> room,
                                 gjk_q16 margin = 0, const gjk2_pose &pose = origin) {
  return result<uint16_t>::of(
      [&](auto *out) { return gjk2_ground_contacts(&ground, &pose, &body, margin, room.data(), room.room(), out); });
}

// What is met first, with the number of its segment if there is a hit.
struct segment_cast : gjk2_cast_result {
  uint32_t segment;
};

inline result<segment_cast> cast(const gjk2_ground &ground, const gjk2_collider &body, const gjk2_cast_path &path,
                                 const gjk2_pose &pose = origin) {
  return result<segment_cast>::of(
      [&](auto *out) { return gjk2_ground_cast(&ground, &pose, &body, &path, out, &out->segment); });
}

inline result<segment_cast> cast_ray(const gjk2_ground &ground, const gjk2_vec &from, const gjk2_vec &to,
                                     const gjk2_pose &pose = origin) {
  return result<segment_cast>::of(
      [&](auto *out) { return gjk2_ground_cast_ray(&ground, &pose, &from, &to, out, &out->segment); });
}

}  // namespace gjk2

#endif
