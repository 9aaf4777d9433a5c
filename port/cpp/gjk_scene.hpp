// Scenes for C++17: many bodies in a block of the caller's memory (gjk/scene.h, gjk/probe.h).
//
//     static uint32_t block[1000];
//     auto scene = gjk::make_scene(gjk::scene_config(8), block, shapes);
//     if (scene) {
//       const gjk_part parts[] = {gjk::part(0)};
//       auto floor = gjk::add(*scene, gjk::body(parts));
//       gjk::update_each(*scene, [](const gjk_report &report) { use(report.a, report.b); });
//     }
//
// A gjk_scene is the handle of a block, not its owner; it may be copied. A copy of the block is a save.
#ifndef GJK_SCENE_HPP
#define GJK_SCENE_HPP

#include "gjk.hpp"
#include "gjk/concave.h"
#include "gjk/probe.h"
#include "gjk/scene.h"

constexpr bool operator==(const gjk_body_id &a, const gjk_body_id &b) {
  return a.slot == b.slot && a.generation == b.generation;
}
constexpr bool operator!=(const gjk_body_id &a, const gjk_body_id &b) { return !(a == b); }

namespace gjk {

// For so many bodies, of one part each; the other fields may be set, and are 0 so far.
constexpr gjk_scene_config scene_config(uint32_t bodies, gjk_detail detail = GJK_DETAIL_TOUCH) {
  gjk_scene_config config = {};
  config.bodies = config.parts = bodies;
  config.pairs = 16 * bodies;
  config.detail = static_cast<uint8_t>(detail);
  return config;
}

// A part at the pose of its body, or at one in its frame. shape: its number in the scene's table.
constexpr gjk_part part(uint16_t shape) { return {shape, false, origin}; }
constexpr gjk_part part(uint16_t shape, const gjk_pose &pose) { return {shape, true, pose}; }

// A body of category 1 that meets all others; the other fields may be set.
constexpr gjk_body_setup body(span<const gjk_part> parts, const gjk_pose &pose = origin,
                              gjk_body_kind kind = GJK_BODY_STATIC) {
  return {pose, parts.data(), parts.count(), static_cast<uint8_t>(kind), GJK_DETAIL_TOUCH, 1, UINT32_MAX, 0, 0};
}

// Scenes. block, shapes and what bindings point to stay the caller's.

inline result<gjk_scene> make_scene(const gjk_scene_config &config, span<uint32_t> block,
                                    span<const gjk_shape *const> shapes, const gjk_scene_bindings &bindings = {}) {
  return result<gjk_scene>::of([&](auto *out) {
    return gjk_scene_init(out, &config, block.data(), 4 * block.size(), shapes.data(), shapes.count(), &bindings);
  });
}

// Of a sealed block that may come from anywhere.
inline result<gjk_scene> open_scene(span<uint32_t> block, span<const gjk_shape *const> shapes,
                                    const gjk_scene_bindings &bindings = {}) {
  return result<gjk_scene>::of([&](auto *out) {
    return gjk_scene_open(out, block.data(), 4 * block.size(), shapes.data(), shapes.count(), &bindings);
  });
}

// Of a copy of a block that this program made itself.
inline result<gjk_scene> attach_scene(span<uint32_t> block, span<const gjk_shape *const> shapes,
                                      const gjk_scene_bindings &bindings = {}) {
  return result<gjk_scene>::of([&](auto *out) {
    return gjk_scene_attach(out, block.data(), 4 * block.size(), shapes.data(), shapes.count(), &bindings);
  });
}

inline result<uint64_t> hash(const gjk_scene &scene) {
  return result<uint64_t>::of([&](auto *out) { return gjk_scene_hash(&scene, out); });
}

[[nodiscard]] inline gjk_status seal(gjk_scene &scene) { return gjk_scene_seal(&scene); }

[[nodiscard]] inline gjk_status check(const gjk_scene &scene) { return gjk_scene_check(&scene); }

inline result<gjk_scene_stats> stats(const gjk_scene &scene) {
  return result<gjk_scene_stats>::of([&](auto *out) { return gjk_scene_get_stats(&scene, out); });
}

// Bodies.

inline result<gjk_body_id> add(gjk_scene &scene, const gjk_body_setup &setup) {
  return result<gjk_body_id>::of([&](auto *out) { return gjk_scene_add(&scene, &setup, out); });
}

inline result<gjk_body_id> add_at(gjk_scene &scene, uint32_t slot, const gjk_body_setup &setup) {
  return result<gjk_body_id>::of([&](auto *out) { return gjk_scene_add_at(&scene, slot, &setup, out); });
}

[[nodiscard]] inline gjk_status remove(gjk_scene &scene, gjk_body_id id) { return gjk_scene_remove(&scene, id); }

[[nodiscard]] inline gjk_status move(gjk_scene &scene, gjk_body_id id, const gjk_pose &pose) {
  return gjk_scene_move(&scene, id, &pose);
}

[[nodiscard]] inline gjk_status teleport(gjk_scene &scene, gjk_body_id id, const gjk_pose &pose) {
  return gjk_scene_teleport(&scene, id, &pose);
}

[[nodiscard]] inline gjk_status sleep(gjk_scene &scene, gjk_body_id id) { return gjk_scene_sleep(&scene, id); }

[[nodiscard]] inline gjk_status wake(gjk_scene &scene, gjk_body_id id) { return gjk_scene_wake(&scene, id); }

[[nodiscard]] inline gjk_status set_motion(gjk_scene &scene, gjk_body_id id, gjk_body_motion motion) {
  return gjk_scene_set_motion(&scene, id, static_cast<uint8_t>(motion));
}

[[nodiscard]] inline gjk_status set_shape(gjk_scene &scene, gjk_body_id id, uint16_t part, uint16_t shape) {
  return gjk_scene_set_shape(&scene, id, part, shape);
}

[[nodiscard]] inline gjk_status set_filter(gjk_scene &scene, gjk_body_id id, uint32_t category, uint32_t mask) {
  return gjk_scene_set_filter(&scene, id, category, mask);
}

[[nodiscard]] inline gjk_status set_user(gjk_scene &scene, gjk_body_id id, uint32_t user) {
  return gjk_scene_set_user(&scene, id, user);
}

// The next update tests all pairs of the body again.
[[nodiscard]] inline gjk_status refilter(gjk_scene &scene, gjk_body_id id) { return gjk_scene_refilter(&scene, id); }

inline result<gjk_body_state> get(const gjk_scene &scene, gjk_body_id id) {
  return result<gjk_body_state>::of([&](auto *out) { return gjk_scene_get(&scene, id, out); });
}

inline result<gjk_collider> collider(const gjk_scene &scene, gjk_body_id id, uint16_t part = 0) {
  return result<gjk_collider>::of([&](auto *out) { return gjk_scene_collider(&scene, id, part, out); });
}

// Updates.

// reports: those that do not fit are left for the next call, as progress says.
inline result<gjk_progress> update(gjk_scene &scene, span<gjk_report> reports) {
  return result<gjk_progress>::of(
      [&](auto *out) { return gjk_scene_update(&scene, reports.data(), reports.count32(), out); });
}

// Calls each(report), which must not change the scene and must not throw.
template <typename Each>
[[nodiscard]] gjk_status update_each(gjk_scene &scene, Each each) {
  return gjk_scene_update_each(
      &scene, [](void *user, const gjk_report *report) { (*static_cast<Each *>(user))(*report); }, &each);
}

// All manifolds of a reported pair, the deepest first, with up to most contacts each: how many there are.
inline result<unsigned> manifolds(const gjk_scene &scene, const gjk_report &report, span<gjk_manifold> room,
                                  unsigned most = 4) {
  return result<unsigned>::of(
      [&](auto *out) { return gjk_scene_manifolds(&scene, &report, most, room.data(), room.count(), out); });
}

// Queries of the current poses. filter: nullptr for all.

// What is met first. hit and answer are set only if found.
struct first_hit {
  bool found;
  gjk_scene_hit hit;
  gjk_cast_result answer;
};

inline result<first_hit> cast_ray(const gjk_scene &scene, const gjk_vec3 &from, const gjk_vec3 &to,
                                  const gjk_scene_filter *filter = nullptr) {
  return result<first_hit>::of(
      [&](auto *out) { return gjk_scene_cast_ray(&scene, &from, &to, filter, &out->hit, &out->answer, &out->found); });
}

inline result<first_hit> cast(const gjk_scene &scene, const gjk_collider &collider, const gjk_vec3 &to,
                              gjk_q16 margin = 0, const gjk_scene_filter *filter = nullptr) {
  return result<first_hit>::of([&](auto *out) {
    return gjk_scene_cast(&scene, &collider, &to, margin, filter, &out->hit, &out->answer, &out->found);
  });
}

// Hits in order, after the one given: how many there are, of which the first stand in room.
inline result<uint32_t> cast_ray_all(const gjk_scene &scene, const gjk_vec3 &from, const gjk_vec3 &to,
                                     span<gjk_scene_hit> room, const gjk_scene_filter *filter = nullptr,
                                     const gjk_scene_hit *after = nullptr) {
  return result<uint32_t>::of([&](auto *out) {
    return gjk_scene_cast_ray_all(&scene, &from, &to, filter, after, room.data(), room.count32(), out);
  });
}

inline result<uint32_t> within(const gjk_scene &scene, const gjk_collider &collider, gjk_q16 reach,
                               span<gjk_scene_hit> room, const gjk_scene_filter *filter = nullptr,
                               const gjk_scene_hit *after = nullptr) {
  return result<uint32_t>::of([&](auto *out) {
    return gjk_scene_query_within(&scene, &collider, reach, filter, after, room.data(), room.count32(), out);
  });
}

// The nearest part. hit and distance are set only if found.
struct nearest_hit {
  bool found;
  gjk_scene_hit hit;
  gjk_q16 distance;
};

inline result<nearest_hit> nearest(const gjk_scene &scene, const gjk_collider &collider, gjk_q16 reach,
                                   const gjk_body_id *ignore = nullptr) {
  return result<nearest_hit>::of([&](auto *out) {
    return gjk_scene_query_nearest(&scene, &collider, reach, ignore, &out->hit, &out->distance, &out->found);
  });
}

}  // namespace gjk

#endif
