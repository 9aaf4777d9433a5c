// What the match of scene_golden.cpp has of its own in the plane.
#include "check/target/plane_scene_golden.h"
#include "gjk2_scene.hpp"

using namespace gjk::literals;

namespace {

namespace lib = gjk2;

constexpr uint32_t bodies = 24;

uint32_t scramble(uint32_t x) {
  x = (x ^ x >> 16) * UINT32_C(0x7FEB352D);
  x = (x ^ x >> 15) * UINT32_C(0x846CA68B);
  return x ^ x >> 16;
}

int32_t dice(uint32_t a, uint32_t b, uint32_t c, int32_t limit) {
  const uint32_t any = scramble(scramble(scramble(a) ^ b) ^ c);
  return static_cast<int32_t>(any % (2 * static_cast<uint32_t>(limit) + 1)) - limit;
}

using world = gjk2_scene;
using vector = gjk2_vec;
using turning = gjk2_rotation;

constexpr uint32_t golden_ticks = PLANE_SCENE_GOLDEN_TICKS, axes = 2, wall_shape = 6;
constexpr uint64_t golden_hash = PLANE_SCENE_GOLDEN_HASH;
constexpr gjk_q16 reach = 4_q16;
constexpr gjk_q16 vector::*along[] = {&vector::x, &vector::y};

constexpr gjk2_vec corners[6] = {{30000, 2000},   {9000, 29000},   {-25000, 20000},
                                 {-28000, -9000}, {-3000, -30000}, {19000, -18000}};
constexpr gjk2_vec sail[3] = {{-40000, -9000}, {41000, 0}, {3000, 52000}};
constexpr gjk2_shape crate = gjk2::box(0.5_q16, 0.5_q16), ball = gjk2::circle(0.5_q16);
constexpr gjk2_shape capsule = gjk2::capsule(0.25_q16, 0.4_q16), stone = gjk2::polygon(corners);
constexpr gjk2_shape egg = gjk2::ellipse(0.5_q16, 0.375_q16), flag = gjk2::triangle(sail);
constexpr gjk2_shape wall = gjk2::box(6_q16, 0.25_q16);
constexpr const gjk2_shape *shapes[] = {&crate, &ball, &capsule, &stone, &egg, &flag, &wall};

gjk2_manifold manifold;

void configure(gjk2_scene_config &) {
}

gjk2_scene_bindings bindings() {
  gjk2_scene_bindings b = {};
  b.details = &gjk2_scene_contacts;
  b.manifolds = &manifold;
  return b;
}

gjk2_rotation turn_of(uint32_t slot, uint32_t tick) {
  return {30000, dice(slot, tick, 4, 500)};
}

int32_t sum_of(const gjk2_manifold &m) {
  int32_t sum = m.normal.x % 5 + m.normal.y % 7 + m.feature_a + m.feature_b;
  for (const gjk2_contact &c : m) {
    sum += c.point_a.x % 5 + c.point_a.y % 7 + c.point_b.x % 11 + c.distance % 13 + c.id;
  }
  return sum;
}

}  // namespace
