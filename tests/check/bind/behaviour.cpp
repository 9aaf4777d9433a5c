// What gjk.hpp and gjk2.hpp do around the queries: literals, ranges, results. Exits with 0 if all is as it should be.
#include <array>
#include <cstdio>
#include <utility>
#include <vector>

#include "gjk.hpp"
#include "gjk2.hpp"

using namespace gjk::literals;

static_assert(0.5_q16 == GJK_Q16(0.5) && -1.25_q16 == GJK_Q16(-1.25) && 3_q16 == GJK_Q16(3) && .1_q16 == GJK_Q16(0.1));
static_assert(32767.999984741_q16 == INT32_MAX && 0_q16 == 0 && 1'000_q16 == GJK_Q16(1000));
static_assert(0.999999999_q30 == GJK_Q30(0.999999999) && 3.141592654_angle == GJK_ANGLE(3.141592654));
static_assert(0.000007629_q16 == 0 && 0.00000763_q16 == 1);  // on either side of half an LSB

// Constants: the compiler makes them.
static constexpr gjk_shape crate = gjk::box(0.5_q16, 0.5_q16, 0.5_q16);
static constexpr gjk_vec3 corners[] = {{0, 0, 0}, {1_q16, 0, 0}, {0, 1_q16, 0}, {0, 0, 1_q16}};
static constexpr gjk_shape wedge = gjk::hull(corners, 0.1_q16);
static constexpr gjk2_shape tile = gjk2::box(0.5_q16, 0.5_q16);
static_assert(crate.size == gjk_vec3{32768, 32768, 32768} && wedge.count == 4 && wedge.convex_radius == 6554);
static_assert(crate.size != gjk_vec3{32768, 32768, 0} && tile.size == gjk2_vec{32768, 32768});

// A shape that is a temporary has no collider: nothing may point to it afterwards.
template <typename Shape, typename = void>
constexpr bool can_place = false;
template <typename Shape>
constexpr bool can_place<Shape, decltype(void(gjk::place(std::declval<Shape>())))> = true;
static_assert(can_place<const gjk_shape &> && !can_place<gjk_shape> && !can_place<const gjk_shape>);

static int failed = 0;

static void check(bool condition, const char *what) {
  if (!condition) {
    std::printf("failed: %s\n", what);
    failed++;
  }
}

static void results() {
  const auto a = gjk::place(crate);
  const auto b = gjk::place(wedge, {{2_q16, 0, 0}, gjk::upright});
  check(a && b && a.status() == GJK_OK, "placed");
  const auto gap = gjk::distance(*a, *b);
  check(gap && gap->distance == 2_q16 - 0.5_q16 - 6554, "distance");
  check(gjk::check(*a, *b, *gap) == GJK_OK, "proven");
  check(gjk::intersect(*a, *a)->yes && !gjk::intersect(*a, *b)->yes, "intersect");
  check(gjk::within(*a, *b, 2_q16)->yes && !gjk::within(*a, *b, 1_q16)->yes, "within");
  const auto refused = gjk::within(*a, *b, -1);
  check(!refused && refused.status() == GJK_ERROR_NEGATIVE, "an error is false");
  const gjk_decision other = {};
  check(!refused.value_or(other).yes, "value_or");
  const gjk_pose bent = {{0, 0, 0}, {0, 0, 0, 5}};
  check(gjk::place(crate, bent).status() == GJK_ERROR_ROTATION, "a pose that is none");
  const gjk_shape empty = gjk::hull({});
  check(gjk::place(empty).status() == GJK_ERROR_NULL, "a hull without vertices");
  const gjk_shape too_many = gjk::hull(gjk::span<const gjk_vec3>(corners, 65536));
  check(gjk::place(too_many).status() == GJK_ERROR_EMPTY, "a hull of too many vertices");
  const gjk_shape no_triangle = gjk::triangle(corners);
  check(gjk::place(no_triangle).status() == GJK_ERROR_RANGE, "a triangle of four vertices");
}

static void ranges() {
  const std::vector<gjk_vec3> points(corners, corners + 4);
  const std::array<gjk2_vec, 3> flat = {{{0, 0}, {1_q16, 0}, {0, 1_q16}}};
  std::vector<gjk_vec3> buffer(4), small(3);
  const gjk_shape hull = gjk::hull(points);
  const gjk2_shape polygon = gjk2::polygon(flat);
  const auto baked = gjk::place(hull, gjk::origin, buffer), lazy = gjk::place(hull);
  check(baked && lazy && baked->buffer == buffer.data() && lazy->buffer == nullptr, "a buffer");
  check(gjk::place(hull, gjk::origin, small).status() == GJK_ERROR_CAPACITY, "a buffer that is too small");
  check(gjk2::place(polygon)->count == 3, "a polygon");
  const auto floor = gjk::place(crate), on_top = gjk::place(crate, {{0, 0, 0.75_q16}, gjk::upright});
  unsigned count = 0;
  const auto touch = gjk::contacts(*floor, *on_top);
  for (const gjk_contact &contact : *touch) {
    check(contact.distance == -0.25_q16, "as deep as it is");
    count++;
  }
  check(count == 4, "four contacts");
  gjk::workspace<20> memory;
  const auto deep = gjk::penetration(*baked, *lazy, memory);
  check(deep && deep->intersecting && gjk::check(*baked, *lazy, *deep) == GJK_OK, "depth");
  const auto bounded = gjk::penetration(*baked, *lazy);
  check(bounded.status() == GJK_ERROR_CAPACITY && bounded.partial().depth >= deep->depth, "depth without memory");
}

static void motion() {
  const gjk_shape thin = gjk::box(0.05_q16, 2_q16, 2_q16), ball = gjk::sphere(0.01_q16);
  const auto wall = gjk::place(thin), bullet = gjk::place(ball, {{-8_q16, 0, 0}, gjk::upright});
  const gjk_vec3 to = {8_q16, 1_q16, 0};
  const gjk_cast_path path = {nullptr, &to, 0};
  const auto hit = gjk::cast(*wall, *bullet, path);
  check(hit && hit->hit && gjk::check(*wall, *bullet, path, *hit) == GJK_OK, "cast");
  check(gjk::cast_ray(*wall, {-8_q16, 0, 0}, {0, 0, 0})->point_a.x == -0.05_q16, "ray");
  const gjk_motion still = {gjk::origin, gjk::origin, {0, 0, 0}};
  const gjk_motion flight = {{{-8_q16, 0, 0}, gjk::upright}, {{8_q16, 0, 0}, gjk::upright}, {0, 0, 40_angle}};
  check(gjk::time_of_impact(*wall, still, *bullet, flight)->hit, "time of impact");
  check(gjk::pose_at(flight, GJK_Q30_ONE / 2)->position == gjk_vec3{0, 0, 0}, "the pose on the way");
  const auto quarter = gjk::rotation({0, 0, 1}, 1.570796327_angle);
  check(gjk::apply(*quarter, {1_q16, 0, 0})->y == 1_q16, "a quarter of a turn");
  check(gjk::compose(*quarter, *gjk::invert(*quarter))->w == GJK_Q30_ONE, "a rotation and its inverse");
}

static void in_the_plane() {
  const auto a = gjk2::place(tile);
  const auto b = gjk2::place(tile, {{2_q16, 0}, gjk2::upright}), c = gjk2::place(tile, {{0.75_q16, 0}, gjk2::upright});
  const auto gap = gjk2::distance(*a, *b);
  check(gap && gap->distance == 1_q16 && gjk2::check(*a, *b, *gap) == GJK_OK, "distance in the plane");
  check(gjk2::penetration(*a, *c)->depth == 0.25_q16, "depth in the plane");
  unsigned count = 0;
  const auto touch = gjk2::contacts(*a, *c);
  for (const gjk2_contact &contact : *touch) {
    count += contact.distance == -0.25_q16;
  }
  check(count == 2, "contacts in the plane");
  const gjk2_vec to = {0, 0};
  check(gjk2::cast(*a, *b, {nullptr, &to, 0})->fraction == GJK_Q30_ONE / 2, "cast in the plane");
  const gjk2_motion still = {gjk2::origin, gjk2::origin, 0};
  const gjk2_motion nearer = {{{2_q16, 0}, gjk2::upright}, gjk2::origin, 9_angle};
  check(gjk2::time_of_impact(*a, still, *b, nearer)->hit, "time of impact in the plane");
  check(gjk2::apply(*gjk2::rotation(1.570796327_angle), {1_q16, 0})->y == 1_q16, "a quarter of a turn in the plane");
}

int main() {
  results();
  ranges();
  motion();
  in_the_plane();
  return failed != 0;
}
