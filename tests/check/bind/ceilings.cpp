// With a library whose ceiling on iterations is low: what gjk.hpp, gjk_parts.hpp and gjk_scene.hpp say of balls around a
// drum, against the distance by its formula. Exits with 0 if the bounds hold and nothing that touches is missed.
#include <cmath>
#include <cstdio>

#include "gjk_parts.hpp"
#include "gjk_scene.hpp"
#include "random.h"

using namespace gjk::literals;

namespace {

constexpr gjk_shape drum = gjk::cylinder(1_q16, 1_q16), ball = gjk::sphere(0.5_q16);
constexpr const gjk_shape *shapes[] = {&drum, &ball};
constexpr uint64_t seed = 9;
constexpr double rounding = 4;
constexpr int count = 200;

int failed = 0;

void check(bool condition, const char *what, const gjk_vec3 &at) {
  if (!condition) {
    std::printf("failed: %s, seed %d, ball at %d %d %d\n", what, static_cast<int>(seed), at.x, at.y, at.z);
    failed++;
  }
}

// 0: the ball overlaps the drum at the origin.
double distance_to(const gjk_vec3 &at) {
  const double beside = std::fmax(std::hypot(at.x, at.y) - 65536, 0), above = std::fmax(std::abs(at.z) - 65536.0, 0);
  return std::fmax(std::hypot(beside, above) - 32768, 0);
}

// Is the answer open? Then its bounds hold; else it is right.
template <typename Gap>
bool is_open(const gjk::result<Gap> &gap, double exact, const gjk_vec3 &at) {
  const Gap &found = gap.partial();
  check(gap || gap.status() == GJK_ERROR_ITERATION_LIMIT, "the status", at);
  check(found.lower <= exact + rounding && found.upper >= exact - rounding, "the bounds", at);
  check(!gap || std::fabs(found.distance - exact) <= rounding, "the distance", at);
  return !gap;
}

}  // namespace

int main() {
  random_state random = random_seed(seed);
  const gjk_compound_part drums[] = {{&drum, gjk::origin}};
  gjk_compound_node nodes[1];
  const auto compound = gjk::make_compound(drums, nodes);
  const gjk_scene_config config = gjk::scene_config(2);
  static uint32_t block[2000];
  auto scene = gjk::make_scene(config, block, shapes);
  const gjk_part first[] = {gjk::part(0)}, second[] = {gjk::part(1)};
  const auto a = gjk::place(drum);
  auto b = gjk::place(ball);
  if (!a || !b || !compound || !scene || !gjk::add(*scene, gjk::body(first))) {
    return 1;
  }
  const auto moved = gjk::add(*scene, gjk::body(second, gjk::origin, GJK_BODY_DYNAMIC));
  int open = 0, near = 0, missed = 0;
  bool touching = false;
  for (int i = 0; i < count; i++) {
    const gjk_vec3 at = {random_range(&random, -3_q16, 3_q16), random_range(&random, -3_q16, 3_q16),
                         random_range(&random, -3_q16, 3_q16)};
    const double exact = distance_to(at);
    if (gjk::move(*b, at) != GJK_OK || gjk::move(*scene, *moved, {at, gjk::upright}) != GJK_OK) {
      return 1;
    }
    open += is_open(gjk::distance(*a, *b), exact, at);
    open += is_open(gjk::distance(gjk::parts(*compound), *b), exact, at);
    check(gjk::update_each(*scene, [&](const gjk_report &report) { touching = report.event == GJK_EVENT_BEGIN; }) ==
              GJK_OK,
          "an update", at);
    near += touching;
    missed += !touching && exact <= 0;
  }
  std::printf("ceiling %d: %d of %d distances open, %d near\n", GJK_ITERATIONS_MAX, open, 2 * count, near);
  return failed != 0 || missed != 0 || open < 10 || open == 2 * count || near < 10;
}
