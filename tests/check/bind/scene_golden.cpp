// The matches of tests/support/scene through gjk_scene.hpp and, with OF_PLANE, gjk2_scene.hpp, with saves and rollbacks as
// scene_golden.c has them: scene_golden [TICKS]. Exits with 0 if the hash is the golden one.
#include <cstdio>
#include <cstdlib>

#include "random.h"

#ifdef OF_PLANE
#include "match_plane.hpp"
#else
#include "match_space.hpp"
#endif

namespace {

constexpr uint64_t prime = 0x100000001B3;

int32_t bounce(int32_t at, int32_t step) {
  return (at > reach && step > 0) || (at < -reach && step < 0) ? -step : step;
}

struct player {
  gjk_body_id id;
  vector step;
  turning turn;
};

// A plain value: a copy is a save.
struct match {
  uint32_t tick;
  player players[bodies];
  uint32_t block[5000];

  world scene() {
    const auto made = lib::attach_scene(block, shapes, bindings());
    return made ? *made : world{};
  }

  bool start() {
    auto config = lib::scene_config(bodies);
    config.parts = 2 * bodies;
    config.own_poses = bodies;
    config.pairs = 160;
    config.box_margin = 0.1_q16;
    config.persist = 1;
    configure(config);
    auto made = lib::make_scene(config, block, shapes, bindings());
    bool fine = static_cast<bool>(made);
    for (uint32_t slot = 0; slot < bodies && fine; slot++) {
      fine = add(*made, slot);
    }
    return fine;
  }

  bool add(world &scene, uint32_t slot) {
    static constexpr gjk_detail details[6] = {GJK_DETAIL_DISTANCE, GJK_DETAIL_TOUCH, GJK_DETAIL_TOUCH,
                                              GJK_DETAIL_DISTANCE, GJK_DETAIL_DEPTH, GJK_DETAIL_CONTACTS};
    const bool fixed = slot == bodies - 1;
    auto pose = lib::origin, up = lib::origin;
    up.position.*along[axes - 1] = 0.75_q16;
    vector step = {};
    for (uint32_t axis = 0; axis < axes; axis++) {
      const gjk_q16 wall_at = axis == axes - 1 ? -reach : 0;
      pose.position.*along[axis] = fixed ? wall_at : dice(slot, tick, 1 + axis, reach);
      step.*along[axis] = slot < 2 ? 0 : dice(slot, tick, 7 + axis, 3000);
    }
    const decltype(lib::part(0)) parts[2] = {lib::part(static_cast<uint16_t>(fixed ? wall_shape : slot % wall_shape)),
                                             lib::part(1, up)};
    auto setup = lib::body({parts, slot % 6 == 5 && !fixed ? 2u : 1u}, pose,
                           fixed      ? GJK_BODY_STATIC
                           : slot < 2 ? GJK_BODY_KINEMATIC
                                      : GJK_BODY_DYNAMIC);
    setup.detail = static_cast<uint8_t>(details[slot % 6]);
    setup.user = slot;
    setup.margin = slot % 4 == 0 ? 0.125_q16 : 0;
    const auto turn = lib::normalize(turn_of(slot, tick));
    const auto id = lib::add_at(scene, slot, setup);
    if (!turn || !id) {
      return false;
    }
    players[slot] = {*id, step, *turn};
    return true;
  }

  bool move(world &scene, uint32_t slot, unsigned input) {
    player &p = players[slot];
    auto state = lib::get(scene, p.id);
    if (!state || state->kind == GJK_BODY_STATIC || state->asleep) {
      return static_cast<bool>(state);
    }
    const int32_t push = (input & 8) != 0 ? -2000 : 2000;
    for (uint32_t axis = 0; axis < axes; axis++) {
      int32_t &at = state->pose.position.*along[axis], &step = p.step.*along[axis];
      step = bounce(at, (input & 1u << axis) != 0 ? push : step);
      at += step;
    }
    if (slot >= 2 || (input & 16) != 0) {
      state->pose.rotation = lib::compose(p.turn, state->pose.rotation).value_or(state->pose.rotation);
    }
    return lib::move(scene, p.id, state->pose) == GJK_OK;
  }

  bool act(world &scene, unsigned input) {
    const uint32_t slot = 2 + tick % (bodies - 3);
    bool fine = true;
    if ((input & 32) != 0 && tick % 5 == 0) {
      fine = lib::set_shape(scene, players[slot].id, 0, static_cast<uint16_t>(tick % wall_shape)) == GJK_OK;
    }
    if ((input & 64) != 0 && tick % 7 == 0) {
      fine = fine && lib::remove(scene, players[slot].id) == GJK_OK && add(scene, slot);
    }
    if ((input & 128) != 0 && tick % 3 == 0) {
      const gjk_body_id id = players[slot].id;
      const auto state = lib::get(scene, id);
      fine = fine && state && (state->asleep ? lib::wake(scene, id) : lib::sleep(scene, id)) == GJK_OK;
    }
    return fine;
  }

  template <typename Report>
  void react(const Report &report) {
    player &a = players[report.a.slot], &b = players[report.b.slot];
    if (a.id != report.a || b.id != report.b) {
      return;
    }
    if (report.event == GJK_EVENT_BEGIN) {
      const vector step = a.step;
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
    world s = scene();
    bool fine = true;
    for (uint32_t slot = 0; slot < bodies && fine; slot++) {
      fine = move(s, slot, slot == 0 ? first : slot == 1 ? second : 0);
    }
    fine = fine && act(s, first) && act(s, second) &&
           lib::update_each(s, [this](const auto &report) { react(report); }) == GJK_OK;
    tick++;
    return fine;
  }

  uint64_t hash() {
    uint64_t value = lib::hash(scene()).value_or(0);
    for (const player &p : players) {
      for (uint32_t axis = 0; axis < axes; axis++) {
        value = (value ^ static_cast<uint32_t>(p.step.*along[axis])) * prime;
      }
      value = (value ^ p.id.generation) * prime;
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
  const uint32_t ticks = count > 1 ? static_cast<uint32_t>(std::strtoul(arguments[1], nullptr, 10)) : golden_ticks;
  const uint64_t hash = hash_of(ticks);
  std::printf("%016llx\n", static_cast<unsigned long long>(hash));
  return hash != golden_hash;
}
