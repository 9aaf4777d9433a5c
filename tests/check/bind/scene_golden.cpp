// The match of tests/support/scene/match.c through gjk_scene.hpp, with saves and rollbacks as scene_golden.c has them:
// scene_golden [TICKS]. Exits with 0 if the hash is the golden one.
#include "check/target/scene_golden.h"

#include <cstdio>
#include <cstdlib>

#include "gjk_scene.hpp"
#include "random.h"

using namespace gjk::literals;

namespace {

constexpr uint32_t bodies = 24, pairs = 160, wall_shape = 5, cell_count = 400;
constexpr gjk_q16 reach = 3_q16;
constexpr uint64_t prime = 0x100000001B3;

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

uint32_t scramble(uint32_t x) {
  x = (x ^ x >> 16) * UINT32_C(0x7FEB352D);
  x = (x ^ x >> 15) * UINT32_C(0x846CA68B);
  return x ^ x >> 16;
}

int32_t dice(uint32_t a, uint32_t b, uint32_t c, int32_t limit) {
  const uint32_t any = scramble(scramble(scramble(a) ^ b) ^ c);
  return static_cast<int32_t>(any % (2 * static_cast<uint32_t>(limit) + 1)) - limit;
}

int32_t bounce(int32_t at, int32_t step) {
  return (at > reach && step > 0) || (at < -reach && step < 0) ? -step : step;
}

int32_t sum_of(const gjk_manifold &m) {
  int32_t sum = m.normal.x % 5 + m.normal.y % 7 + m.normal.z % 11 + m.feature_a + m.feature_b;
  for (const gjk_contact &c : m) {
    sum += c.point_a.x % 5 + c.point_a.y % 7 + c.point_b.z % 11 + c.distance % 13 + c.id;
  }
  return sum;
}

struct player {
  gjk_body_id id;
  gjk_vec3 step;
  gjk_quat turn;
};

// A plain value: a copy is a save.
struct match {
  uint32_t tick;
  player players[bodies];
  uint32_t block[5000];

  gjk_scene scene() {
    const auto made = gjk::attach_scene(block, shapes, bindings());
    return made ? *made : gjk_scene{};
  }

  static gjk_scene_bindings bindings() {
    gjk_scene_bindings b = {};
    b.details = &gjk_scene_contacts;
    b.workspace = &workspace;
    b.manifolds = &manifold;
    return b;
  }

  bool start() {
    gjk_scene_config config = gjk::scene_config(bodies);
    config.parts = 2 * bodies;
    config.own_poses = bodies;
    config.pairs = pairs;
    config.box_margin = 0.1_q16;
    config.persist = 1;
    config.workspace_cells = cell_count;
    auto made = gjk::make_scene(config, block, shapes, bindings());
    bool fine = made && gjk_scene_bytes(&config) <= sizeof block;
    for (uint32_t slot = 0; slot < bodies && fine; slot++) {
      fine = add(*made, slot);
    }
    return fine;
  }

  bool add(gjk_scene &scene, uint32_t slot) {
    static constexpr gjk_detail details[6] = {GJK_DETAIL_DISTANCE, GJK_DETAIL_TOUCH, GJK_DETAIL_TOUCH,
                                              GJK_DETAIL_DISTANCE, GJK_DETAIL_DEPTH, GJK_DETAIL_CONTACTS};
    const auto roll = [&](uint32_t c, int32_t limit) { return dice(slot, tick, c, limit); };
    const bool fixed = slot == bodies - 1;
    const gjk_part parts[2] = {gjk::part(static_cast<uint16_t>(fixed ? wall_shape : slot % wall_shape)),
                               gjk::part(1, {{0, 0, 0.75_q16}, gjk::upright})};
    const gjk_pose thrown = {{roll(1, reach), roll(2, reach), roll(3, reach)}, gjk::upright};
    gjk_body_setup setup =
        gjk::body({parts, slot % 6 == 5 && !fixed ? 2u : 1u}, fixed ? gjk_pose{{0, 0, -reach}, gjk::upright} : thrown,
                  fixed      ? GJK_BODY_STATIC
                  : slot < 2 ? GJK_BODY_KINEMATIC
                             : GJK_BODY_DYNAMIC);
    setup.detail = static_cast<uint8_t>(details[slot % 6]);
    setup.user = slot;
    setup.margin = slot % 4 == 0 ? 0.125_q16 : 0;
    const auto turn = gjk::normalize({roll(4, 300), roll(5, 300), roll(6, 300), 30000});
    const auto id = gjk::add_at(scene, slot, setup);
    if (!turn || !id) {
      return false;
    }
    const gjk_vec3 step = {roll(7, 3000), roll(8, 3000), roll(9, 3000)};
    players[slot] = {*id, slot < 2 ? gjk_vec3{0, 0, 0} : step, *turn};
    return true;
  }

  bool move(gjk_scene &scene, uint32_t slot, unsigned input) {
    player &p = players[slot];
    auto state = gjk::get(scene, p.id);
    if (!state || state->kind == GJK_BODY_STATIC || state->asleep) {
      return static_cast<bool>(state);
    }
    const int32_t push = (input & 8) != 0 ? -2000 : 2000;
    gjk_vec3 &at = state->pose.position;
    p.step.x = bounce(at.x, (input & 1) != 0 ? push : p.step.x);
    p.step.y = bounce(at.y, (input & 2) != 0 ? push : p.step.y);
    p.step.z = bounce(at.z, (input & 4) != 0 ? push : p.step.z);
    at = {at.x + p.step.x, at.y + p.step.y, at.z + p.step.z};
    if (slot >= 2 || (input & 16) != 0) {
      state->pose.rotation = gjk::compose(p.turn, state->pose.rotation).value_or(state->pose.rotation);
    }
    return gjk::move(scene, p.id, state->pose) == GJK_OK;
  }

  bool act(gjk_scene &scene, unsigned input) {
    const uint32_t slot = 2 + tick % (bodies - 3);
    bool fine = true;
    if ((input & 32) != 0 && tick % 5 == 0) {
      fine = gjk::set_shape(scene, players[slot].id, 0, static_cast<uint16_t>(tick % wall_shape)) == GJK_OK;
    }
    if ((input & 64) != 0 && tick % 7 == 0) {
      fine = fine && gjk::remove(scene, players[slot].id) == GJK_OK && add(scene, slot);
    }
    if ((input & 128) != 0 && tick % 3 == 0) {
      const gjk_body_id id = players[slot].id;
      const auto state = gjk::get(scene, id);
      fine = fine && state && (state->asleep ? gjk::wake(scene, id) : gjk::sleep(scene, id)) == GJK_OK;
    }
    return fine;
  }

  void react(const gjk_report &report) {
    player &a = players[report.a.slot], &b = players[report.b.slot];
    if (a.id != report.a || b.id != report.b) {
      return;
    }
    if (report.event == GJK_EVENT_BEGIN) {
      const gjk_vec3 step = a.step;
      a.step = b.step;
      b.step = step;
    } else if (report.event == GJK_EVENT_PERSIST) {
      b.step.x += (report.manifold != nullptr ? sum_of(*report.manifold) : report.distance) % 7 - 3;
    } else {
      b.step.y += report.part_b + 1;
    }
    b.step.x = b.step.x > 4000 ? 3000 : b.step.x < -4000 ? -3000 : b.step.x;
    b.step.y = b.step.y > 4000 ? -3000 : b.step.y;
  }

  bool play(unsigned first, unsigned second) {
    gjk_scene s = scene();
    bool fine = true;
    for (uint32_t slot = 0; slot < bodies && fine; slot++) {
      fine = move(s, slot, slot == 0 ? first : slot == 1 ? second : 0);
    }
    fine = fine && act(s, first) && act(s, second) &&
           gjk::update_each(s, [this](const gjk_report &report) { react(report); }) == GJK_OK;
    tick++;
    return fine;
  }

  uint64_t hash() {
    uint64_t value = gjk::hash(scene()).value_or(0);
    for (const player &p : players) {
      const int32_t words[] = {p.step.x, p.step.y, p.step.z, static_cast<int32_t>(p.id.generation)};
      for (const int32_t word : words) {
        value = (value ^ static_cast<uint32_t>(word)) * prime;
      }
    }
    return value;
  }
};

unsigned input_of(uint32_t tick, uint64_t number) {
  random_state random = random_seed(tick * UINT64_C(2) + number);
  const uint32_t any = random_u32(&random);
  return any & any >> 8 & 0xFFu;
}

// 0: a call failed, or nothing was rolled back.
uint64_t hash_of(uint32_t ticks) {
  static match playing, saved;
  uint64_t sum = UINT64_C(0xCBF29CE484222325), saved_sum = sum;
  random_state random = random_seed(3);
  unsigned rollbacks = 0;
  if (!playing.start()) {
    return 0;
  }
  saved = playing;
  for (uint32_t i = 0; i < ticks; i++) {
    const uint32_t what = random_below(&random, 100);
    if (what < 3 || i - saved.tick > 30) {
      saved = playing;
      saved_sum = sum;
    } else if (what < 5) {
      playing = saved;
      sum = saved_sum;
      i = saved.tick;
      rollbacks++;
    }
    if (!playing.play(input_of(i, 0), input_of(i, 1))) {
      return 0;
    }
    sum = (sum ^ playing.hash()) * prime;
  }
  return rollbacks > 0 ? sum : 0;
}

}  // namespace

int main(int count, char **arguments) {
  const uint32_t ticks =
      count > 1 ? static_cast<uint32_t>(std::strtoul(arguments[1], nullptr, 10)) : SCENE_GOLDEN_TICKS;
  const uint64_t hash = hash_of(ticks);
  std::printf("%016llx\n", static_cast<unsigned long long>(hash));
  return hash != SCENE_GOLDEN_HASH;
}
