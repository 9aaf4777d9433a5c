// What gjk2_ground.hpp does around ground: its kinds, queries, scenes. Exits with 0 if all is as it should be.
#include <array>
#include <cstdio>
#include <utility>

#include "gjk2_ground.hpp"
#include "gjk2_scene.hpp"

using namespace gjk::literals;

namespace {

constexpr gjk2_shape disc = gjk2::circle(0.5_q16);

template <typename Data, typename = void>
constexpr bool makes = false;
template <typename Data>
constexpr bool makes<Data, decltype(void(gjk2::make_ground(std::declval<Data>(), std::declval<gjk2_ground &>())))> =
    true;
static_assert(makes<gjk2_tiles &> && makes<const gjk2_heights &> && makes<gjk2_polyline &>);
static_assert(!makes<gjk2_tiles> && !makes<gjk2_heights> && !makes<const gjk2_polyline>);

int failed = 0;

void check(bool condition, const char *what) {
  if (!condition) {
    std::printf("failed: %s\n", what);
    failed++;
  }
}

gjk2_collider ball(gjk_q16 x, gjk_q16 y) {
  return *gjk2::place(disc, {{x, y}, gjk2::upright});
}

void chain() {
  constexpr gjk2_vec vertices[] = {{2_q16, 0}, {1_q16, 0}, {0, 0}};
  gjk2_polyline data = {vertices, 3, nullptr};
  std::array<gjk2_index_box, GJK2_INDEX_BOXES(3)> boxes;
  const auto index = gjk2::make_index(data, boxes);
  gjk2_ground ground;
  check(bool(index), "an index");
  data.index = &*index;
  check(bool(gjk2::make_ground(data, ground)), "a chain");
  check(*gjk2::within(ground, ball(0.5_q16, 2_q16), 1.5_q16), "within");
  check(!*gjk2::within(ground, ball(0.5_q16, 2_q16), 1_q16), "not within");
  const auto near = gjk2::distance(ground, ball(0.5_q16, 2_q16));
  check(near && near->found && near->segment == 1 && near->answer.distance == 1.5_q16, "the nearest segment");
  check(!gjk2::distance(ground, ball(0.5_q16, -2_q16))->found, "from behind");
  gjk2_chain_contact room[1];
  check(*gjk2::contacts(ground, ball(0.5_q16, 0.4_q16), room) == 1 && room[0].segment == 1, "contacts");
  const gjk2_vec to = {0.5_q16, 0};
  const auto fall = gjk2::cast(ground, ball(0.5_q16, 2_q16), {nullptr, &to, 0});
  check(fall && fall->hit && fall->segment == 1 && fall->fraction >> 10 == (3 * (GJK_Q30_ONE / 4) - 1) >> 10, "a cast");
  check(!gjk2::cast_ray(ground, to, {0.5_q16, 1_q16})->hit, "a ray from behind");
  check(gjk2::cast_ray(ground, {0.5_q16, 1_q16}, {0.5_q16, -1_q16})->segment == 1, "a ray");
}

void tiles() {
  constexpr gjk2_tile forms[] = {GJK2_TILE(0, 0), GJK2_TILE(4, 4)};
  uint8_t cells[] = {1, 1, 1, 1};
  const gjk2_tiles data = {cells, 4, 1, 1_q16, 2, forms};
  gjk2_ground ground;
  const auto shape = gjk2::make_ground(data, ground);
  check(bool(shape), "a grid");
  const gjk2_shape *shapes[] = {&*shape, &disc};
  const gjk2_part parts[] = {gjk2::part(0), gjk2::part(1)};
  std::array<uint32_t, 1000> block;
  const auto made = gjk2::make_scene(gjk2::scene_config(2), block, shapes);
  check(bool(made), "a scene");
  gjk2_scene scene = *made;
  const auto floor = gjk2::add(scene, gjk2::body({&parts[0], 1}));
  check(floor && gjk2::add(scene, gjk2::body({&parts[1], 1}, {{1.5_q16, 1.4_q16}, gjk2::upright}, GJK_BODY_DYNAMIC)),
        "bodies");
  gjk2_report reports[2];
  check(gjk2::update(scene, reports)->reports == 1 && reports[0].event == GJK_EVENT_BEGIN, "on a tile");
  cells[1] = 0;
  check(gjk2::refilter(scene, *floor) == GJK_OK, "told");
  check(gjk2::update(scene, reports)->reports == 1 && reports[0].event == GJK_EVENT_END, "a tile fewer");
  const gjk2_heights flat = {nullptr, 0, 1, 0};
  check(gjk2::make_ground(flat, ground).status() != GJK_OK, "no heights");
}

}  // namespace

int main() {
  chain();
  tiles();
  return failed != 0;
}
