// Scenes of the plane for C++17: what gjk_scene.hpp is in space, in namespace gjk2 (gjk2/scene.h, gjk2/probe.h).
#ifndef GJK2_SCENE_HPP
#define GJK2_SCENE_HPP

#include "gjk2.hpp"
#include "gjk2/probe.h"
#include "gjk2/scene.h"
#include "gjk_scene.hpp"

namespace gjk2 {

// For so many bodies, of one part each; the other fields may be set, and are 0 so far.
constexpr gjk2_scene_config scene_config(uint32_t bodies, gjk_detail detail = GJK_DETAIL_TOUCH) {
  gjk2_scene_config config = {};
  config.bodies = config.parts = bodies;
  config.pairs = 16 * bodies;
  config.detail = static_cast<uint8_t>(detail);
  return config;
}

// A part at the pose of its body, or at one in its frame. shape: its number in the scene's table.
constexpr gjk2_part part(uint16_t shape) { return {shape, false, origin}; }
constexpr gjk2_part part(uint16_t shape, const gjk2_pose &pose) { return {shape, true, pose}; }

// A body of category 1 that meets all others; the other fields may be set.
constexpr gjk2_body_setup body(span<const gjk2_part> parts, const gjk2_pose &pose = origin,
                               gjk_body_kind kind = GJK_BODY_STATIC) {
  return {pose, parts.data(), parts.count(), static_cast<uint8_t>(kind), GJK_DETAIL_TOUCH, 1, UINT32_MAX, 0, 0};
}

// Scenes. block, shapes and what bindings point to stay the caller's.

inline result<gjk2_scene> make_scene(const gjk2_scene_config &config, span<uint32_t> block,
                                     span<const gjk2_shape *const> shapes, const gjk2_scene_bindings &bindings = {}) {
  return result<gjk2_scene>::of([&](auto *out) {
    return gjk2_scene_init(out, &config, block.data(), 4 * block.size(), shapes.data(), shapes.count(), &bindings);
  });
}

// Of a sealed block that may come from anywhere.
inline result<gjk2_scene> open_scene(span<uint32_t> block, span<const gjk2_shape *const> shapes,
                                     const gjk2_scene_bindings &bindings = {}) {
  return result<gjk2_scene>::of([&](auto *out) {
    return gjk2_scene_open(out, block.data(), 4 * block.size(), shapes.data(), shapes.count(), &bindings);
  });
}

// Of a copy of a block that this program made itself.
inline result<gjk2_scene> attach_scene(span<uint32_t> block, span<const gjk2_shape *const> shapes,
                                       const gjk2_scene_bindings &bindings = {}) {
  return result<gjk2_scene>::of([&](auto *out) {
    return gjk2_scene_attach(out, block.data(), 4 * block.size(), shapes.data(), shapes.count(), &bindings);
  });
}

inline result<uint64_t> hash(const gjk2_scene &scene) {
  return result<uint64_t>::of([&](auto *out) { return gjk2_scene_hash(&scene, out); });
}

[[nodiscard]] inline gjk_status seal(gjk2_scene &scene) { return gjk2_scene_seal(&scene); }

[[nodiscard]] inline gjk_status check(const gjk2_scene &scene) { return gjk2_scene_check(&scene); }

inline result<gjk_scene_stats> stats(const gjk2_scene &scene) {
  return result<gjk_scene_stats>::of([&](auto *out) { return gjk2_scene_get_stats(&scene, out); });
}

// Bodies.

inline result<gjk_body_id> add(gjk2_scene &scene, const gjk2_body_setup &setup) {
  return result<gjk_body_id>::of([&](auto *out) { return gjk2_scene_add(&scene, &setup, out); });
}

inline result<gjk_body_id> add_at(gjk2_scene &scene, uint32_t slot, const gjk2_body_setup &setup) {
  return result<gjk_body_id>::of([&](auto *out) { return gjk2_scene_add_at(&scene, slot, &setup, out); });
}

[[nodiscard]] inline gjk_status remove(gjk2_scene &scene, gjk_body_id id) { return gjk2_scene_remove(&scene, id); }

[[nodiscard]] inline gjk_status move(gjk2_scene &scene, gjk_body_id id, const gjk2_pose &pose) {
  return gjk2_scene_move(&scene, id, &pose);
}

[[nodiscard]] inline gjk_status teleport(gjk2_scene &scene, gjk_body_id id, const gjk2_pose &pose) {
  return gjk2_scene_teleport(&scene, id, &pose);
}

[[nodiscard]] inline gjk_status sleep(gjk2_scene &scene, gjk_body_id id) { return gjk2_scene_sleep(&scene, id); }

[[nodiscard]] inline gjk_status wake(gjk2_scene &scene, gjk_body_id id) { return gjk2_scene_wake(&scene, id); }

[[nodiscard]] inline gjk_status set_motion(gjk2_scene &scene, gjk_body_id id, gjk_body_motion motion) {
  return gjk2_scene_set_motion(&scene, id, static_cast<uint8_t>(motion));
}

[[nodiscard]] inline gjk_status set_shape(gjk2_scene &scene, gjk_body_id id, uint16_t part, uint16_t shape) {
  return gjk2_scene_set_shape(&scene, id, part, shape);
}

[[nodiscard]] inline gjk_status set_filter(gjk2_scene &scene, gjk_body_id id, uint32_t category, uint32_t mask) {
  return gjk2_scene_set_filter(&scene, id, category, mask);
}

[[nodiscard]] inline gjk_status set_user(gjk2_scene &scene, gjk_body_id id, uint32_t user) {
  return gjk2_scene_set_user(&scene, id, user);
}

// The next update tests all pairs of the body again.
[[nodiscard]] inline gjk_status refilter(gjk2_scene &scene, gjk_body_id id) { return gjk2_scene_refilter(&scene, id); }

inline result<gjk2_body_state> get(const gjk2_scene &scene, gjk_body_id id) {
  return result<gjk2_body_state>::of([&](auto *out) { return gjk2_scene_get(&scene, id, out); });
}

inline result<gjk2_collider> collider(const gjk2_scene &scene, gjk_body_id id, uint16_t part = 0) {
  return result<gjk2_collider>::of([&](auto *out) { return gjk2_scene_collider(&scene, id, part, out); });
}

// Updates.

// reports: those that do not fit are left for the next call, as progress says.
inline result<gjk_progress> update(gjk2_scene &scene, span<gjk2_report> reports) {
  return result<gjk_progress>::of(
      [&](auto *out) { return gjk2_scene_update(&scene, reports.data(), reports.count32(), out); });
}

// Calls each(report), which must not change the scene and must not throw.
template <typename Each>
[[nodiscard]] gjk_status update_each(gjk2_scene &scene, Each each) {
  return gjk2_scene_update_each(
      &scene, [](void *user, const gjk2_report *report) { (*static_cast<Each *>(user))(*report); }, &each);
}

// Queries of the current poses. filter: nullptr for all.

// What is met first. hit and answer are set only if found.
struct first_hit {
  bool found;
  gjk_scene_hit hit;
  gjk2_cast_result answer;
};

inline result<first_hit> cast_ray(const gjk2_scene &scene, const gjk2_vec &from, const gjk2_vec &to,
                                  const gjk_scene_filter *filter = nullptr) {
  return result<first_hit>::of(
      [&](auto *out) { return gjk2_scene_cast_ray(&scene, &from, &to, filter, &out->hit, &out->answer, &out->found); });
}

inline result<first_hit> cast(const gjk2_scene &scene, const gjk2_collider &collider, const gjk2_vec &to,
                              gjk_q16 margin = 0, const gjk_scene_filter *filter = nullptr) {
  return result<first_hit>::of([&](auto *out) {
    return gjk2_scene_cast(&scene, &collider, &to, margin, filter, &out->hit, &out->answer, &out->found);
  });
}

// Hits in order, after the one given: how many there are, of which the first stand in room.
inline result<uint32_t> cast_ray_all(const gjk2_scene &scene, const gjk2_vec &from, const gjk2_vec &to,
                                     span<gjk_scene_hit> room, const gjk_scene_filter *filter = nullptr,
                                     const gjk_scene_hit *after = nullptr) {
  return result<uint32_t>::of([&](auto *out) {
    return gjk2_scene_cast_ray_all(&scene, &from, &to, filter, after, room.data(), room.count32(), out);
  });
}

inline result<uint32_t> within(const gjk2_scene &scene, const gjk2_collider &collider, gjk_q16 reach,
                               span<gjk_scene_hit> room, const gjk_scene_filter *filter = nullptr,
                               const gjk_scene_hit *after = nullptr) {
  return result<uint32_t>::of([&](auto *out) {
    return gjk2_scene_query_within(&scene, &collider, reach, filter, after, room.data(), room.count32(), out);
  });
}

// The nearest part. hit and distance are set only if found.
struct nearest_hit {
  bool found;
  gjk_scene_hit hit;
  gjk_q16 distance;
};

inline result<nearest_hit> nearest(const gjk2_scene &scene, const gjk2_collider &collider, gjk_q16 reach,
                                   const gjk_body_id *ignore = nullptr) {
  return result<nearest_hit>::of([&](auto *out) {
    return gjk2_scene_query_nearest(&scene, &collider, reach, ignore, &out->hit, &out->distance, &out->found);
  });
}

}  // namespace gjk2

#endif
