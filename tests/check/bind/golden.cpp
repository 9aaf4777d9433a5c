// The golden set of queries of tests/check/target/golden.c through gjk.hpp: golden PAIRS. Exits with 0 if the hash is that
// of golden.h.
#include "gjk.hpp"

#include <cstdio>
#include <cstdlib>

#include "check/target/golden.h"
#include "fnv.h"
#include "random.h"

namespace {

constexpr uint32_t vertices_max = 16;

uint64_t hash = FNV_START;
random_state dice = random_seed(2026);
gjk::workspace<20> memory;

template <typename... Words>
void mix(Words... words) {
  ((hash = fnv_word(hash, static_cast<uint32_t>(words))), ...);
}

void mix(const gjk_vec3 &v) {
  mix(v.x, v.y, v.z);
}
void mix(const gjk_unit3 &v) {
  mix(v.x, v.y, v.z);
}

// Brace initialisation evaluates from left to right.
gjk_vec3 random_vector(int32_t size) {
  return {random_range(&dice, -size, size), random_range(&dice, -size, size), random_range(&dice, -size, size)};
}

// Two bodies, and what is asked about them.
class pair {
 public:
  void query() {
    gjk_cache cache = {};
    ask_distance(nullptr);
    ask_decision(gjk::intersect(a.collider, b.collider));
    ask_decision(gjk::within(a.collider, b.collider, found.distance));
    ask_distance(&cache);
    ask_penetration(&cache);
    ask_contacts(0);
    if (!found.intersecting && !far) {
      approach();
      ask_distance(&cache);
      ask_decision(gjk::intersect(a.collider, b.collider, &cache));
      ask_decision(gjk::within(a.collider, b.collider, 1));
      ask_within_until(1 + size / 32, 1);
      ask_within_until(found.distance, 2);
      ask_distance_until({2, 0});
      ask_distance_until({0, 1 + size / 16});
      ask_penetration(nullptr);
      ask_contacts(size / 8);
    }
  }

 private:
  struct body {
    gjk_vec3 vertices[vertices_max], buffer[vertices_max];
    gjk_shape shape;
    gjk_collider collider;

    body(int32_t largest, int32_t reach) {
      shape = make_shape(largest);
      const gjk_pose pose = make_pose(reach);
      const bool is_baked = random_below(&dice, 2) == 0;
      const auto placed = is_baked ? gjk::place(shape, pose, buffer) : gjk::place(shape, pose);
      collider = *placed;
      mix(GJK_OK, placed.status());  // of gjk_collider_init, too
    }

    // Every kind gets all three lengths, though some use less: golden.c does so.
    gjk_shape make_shape(int32_t largest) {
      static constexpr uint8_t choices[] = {0, 1, 2, 3, 3, 4, 4, 4, 5, 6, 7};  // boxes and hulls more often
      const uint8_t kind = choices[random_below(&dice, sizeof choices)];
      const gjk_vec3 lengths = {random_range(&dice, 1, largest), random_range(&dice, 1, largest),
                                random_range(&dice, 1, largest)};
      const uint32_t count = kind == 2 ? 3 : 4 + random_below(&dice, vertices_max - 3);
      const int32_t grid = random_below(&dice, 4) == 0 ? largest / 2 + 1 : 1;  // coarse: ties, and parallel faces
      for (uint32_t i = 0; i < count; i++) {
        const gjk_vec3 v = random_vector(largest);
        vertices[i] = {v.x / grid * grid, v.y / grid * grid, v.z / grid * grid};
      }
      const gjk_q16 radius = random_below(&dice, 4) == 0 ? random_range(&dice, 0, largest / 2) : 0;
      gjk_shape made = of_kind(kind, lengths, count, radius);
      made.size = lengths;
      return made;
    }

    gjk_shape of_kind(uint8_t kind, const gjk_vec3 &lengths, uint32_t count, gjk_q16 radius) const {
      switch (kind) {
        case 0: return gjk::sphere(radius);
        case 1: return gjk::capsule(radius, lengths.z);
        case 2: return gjk::triangle({vertices, 3}, radius);
        case 3: return gjk::box(lengths.x, lengths.y, lengths.z, radius);
        case 4: return gjk::hull({vertices, count}, radius);
        case 5: return gjk::cylinder(lengths.x, lengths.z, radius);
        case 6: return gjk::cone(lengths.x, lengths.z, radius);
        default: return gjk::ellipsoid(lengths.x, lengths.y, lengths.z, radius);
      }
    }

    static gjk_pose make_pose(int32_t reach) {
      gjk_pose pose = gjk::origin;
      if (random_below(&dice, 4) != 0) {
        const gjk_quat q = {random_range(&dice, -1000, 1000), random_range(&dice, -1000, 1000),
                            random_range(&dice, -1000, 1000), random_range(&dice, -1000, 1001)};
        const auto turned = gjk::normalize(q);
        mix(turned.status());
        pose.rotation = turned.value_or(gjk::upright);
      }
      pose.position = random_vector(reach);
      return pose;
    }
  };

  void ask_distance(gjk_cache *cache) {
    const auto gap = gjk::distance(a.collider, b.collider, cache);
    found = gap.partial();
    mix(gap.status(), found.intersecting, found.saturated, found.distance);
    if (!found.intersecting) {
      mix(found.point_a);
      mix(found.point_b);
      mix(found.normal);
    }
  }

  static void ask_decision(const gjk::result<gjk_decision> &decision) {
    mix(decision.status(), decision.partial().yes);
  }

  void ask_within_until(gjk_q16 distance, uint8_t iterations) const {
    const auto within = gjk::within_until(a.collider, b.collider, distance, iterations);
    mix(within.status(), within.partial().answer);
  }

  void ask_distance_until(const gjk_effort &effort) const {
    const auto gap = gjk::distance_until(a.collider, b.collider, effort);
    const gjk_distance_result &out = gap.partial();
    mix(gap.status(), out.intersecting, out.distance, out.lower, out.upper);
    if (!out.intersecting) {
      mix(out.point_a);
    }
  }

  void ask_penetration(gjk_cache *cache) const {
    const auto overlap = gjk::penetration(a.collider, b.collider, memory, cache);
    const gjk_penetration_result &out = overlap.partial();
    mix(overlap.status(), out.intersecting);
    if (out.intersecting) {
      mix(out.depth, out.lower, out.upper);
      mix(out.point_a);
      mix(out.point_b);
      mix(out.normal);
    }
  }

  void ask_contacts(gjk_q16 margin) const {
    const auto touch = gjk::contacts(a.collider, b.collider, margin, 4, memory);
    mix(touch.status(), touch.partial().count);
    for (const gjk_contact &contact : touch.partial()) {
      mix(contact.point_a);
      mix(contact.point_b);
      mix(contact.distance, contact.id);
    }
  }

  // Moves B along the normal until the gap is near 0.
  void approach() {
    const int32_t by = found.distance + random_range(&dice, -2, 2);
    const auto part = [by](gjk_q30 component) { return static_cast<int32_t>(int64_t{component} * by / GJK_Q30_ONE); };
    const gjk_vec3 &at = b.collider.position;
    const gjk_vec3 to = {at.x - part(found.normal.x), at.y - part(found.normal.y), at.z - part(found.normal.z)};
    mix(gjk::move(b.collider, to));
  }

  // In this order their random numbers are taken.
  const int32_t size = INT32_C(1) << (3 + random_below(&dice, 23));
  const bool far = random_below(&dice, 8) == 0;
  body a = {size, far ? INT32_MAX : 2 * size};
  body b = {size, far ? INT32_MAX : 2 * size};
  gjk_distance_result found = {};
};

}  // namespace

int main(int argc, char **argv) {
  const uint32_t pairs = argc > 1 ? static_cast<uint32_t>(std::atoi(argv[1])) : GOLDEN_PAIRS;
  for (uint32_t i = 0; i < pairs; i++) {
    pair().query();
  }
  std::printf("%016llx\n", static_cast<unsigned long long>(hash));
  return hash == (pairs == GOLDEN_PAIRS ? GOLDEN_HASH : GOLDEN_FEW_HASH) ? 0 : 1;
}
