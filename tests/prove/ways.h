// Any way of a cast, as src/motion/gjk_way.h has it.
#ifndef PROVE_WAYS_H
#define PROVE_WAYS_H

#include "colliders.h"
#include "src/motion/gjk_way.h"

// A component of the way.
#define ANY_WAY ((INT64_C(1) << 32) - 1)

static void any_way(gjk_way *way) {
  way->end_a = any_position();
  way->end_b = any_position();
  way->t.x = any_long(ANY_WAY);
  way->t.y = any_long(ANY_WAY);
  way->t.z = any_long(ANY_WAY);
}

static void check_way(const gjk_way *way) {
  check_size(way->end_a.x, INT64_C(1) << 31);
  check_size(way->end_a.y, INT64_C(1) << 31);
  check_size(way->end_a.z, INT64_C(1) << 31);
  check_size(way->end_b.x, INT64_C(1) << 31);
  check_size(way->end_b.y, INT64_C(1) << 31);
  check_size(way->end_b.z, INT64_C(1) << 31);
  check_size(way->t.x, ANY_WAY);
  check_size(way->t.y, ANY_WAY);
  check_size(way->t.z, ANY_WAY);
}

#endif
