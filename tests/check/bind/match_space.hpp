// What the match of scene_golden.cpp has of its own in space.
#include "check/target/scene_golden.h"
#include "gjk_scene.hpp"

using namespace gjk::literals;

namespace {

namespace lib = gjk;

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

using world = gjk_scene;
using vector = gjk_vec3;
using turning = gjk_quat;

constexpr uint32_t golden_ticks = SCENE_GOLDEN_TICKS, axes = 3, wall_shape = 5, cell_count = 400;
constexpr uint64_t golden_hash = SCENE_GOLDEN_HASH;
constexpr gjk_q16 reach = 3_q16;
constexpr gjk_q16 vector::*along[] = {&vector::x, &vector::y, &vector::z};

constexpr gjk_vec3 corners[8] = {{30000, 2000, 1000},   {-28000, 9000, -3000},  {5000, 31000, 2000},
                                 {-3000, -30000, 4000}, {1000, 2000, 33000},    {-2000, 900, -31000},
                                 {20000, 20000, 12000}, {-19000, -18000, -9000}};
constexpr gjk_shape crate = gjk::box(0.5_q16, 0.5_q16, 0.5_q16), ball = gjk::sphere(0.5_q16);
constexpr gjk_shape capsule = gjk::capsule(0.25_q16, 0.4_q16), stone = gjk::hull(corners);
constexpr gjk_shape drum = gjk::cylinder(0.5_q16, 0.375_q16), wall = gjk::box(6_q16, 6_q16, 0.25_q16);
constexpr const gjk_shape *shapes[] = {&crate, &ball, &capsule, &stone, &drum, &wall};

gjk_epa_cell cells[cell_count];
const gjk_workspace workspace = {cells, cell_count};
gjk_manifold manifold;

void configure(gjk_scene_config &config) {
  config.workspace_cells = cell_count;
}

gjk_scene_bindings bindings() {
  gjk_scene_bindings b = {};
  b.details = &gjk_scene_contacts;
  b.workspace = &workspace;
  b.manifolds = &manifold;
  return b;
}

gjk_quat turn_of(uint32_t slot, uint32_t tick) {
  return {dice(slot, tick, 4, 300), dice(slot, tick, 5, 300), dice(slot, tick, 6, 300), 30000};
}

int32_t sum_of(const gjk_manifold &m) {
  int32_t sum = m.normal.x % 5 + m.normal.y % 7 + m.normal.z % 11 + m.feature_a + m.feature_b;
  for (const gjk_contact &c : m) {
    sum += c.point_a.x % 5 + c.point_a.y % 7 + c.point_b.z % 11 + c.distance % 13 + c.id;
  }
  return sum;
}

}  // namespace
