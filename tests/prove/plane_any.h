// Arbitrary values of the plane: vectors, colliders of a model class, and what the search may leave.
#ifndef PROVE_PLANE_ANY_H
#define PROVE_PLANE_ANY_H

#include "any.h"
#include "gjk2/gjk2.h"
#include "src/plane/gjk2_class.h"

// The largest component of a vertex of A - B in its frame (gjk2_search.h), and of a direction.
#define ANY_W (INT32_C(3) << 29)

// Of a rounded unit vector (gjk2_unit_set), grown by gjk2_outward_normal.
#define ANY_UNIT (GJK_Q30_ONE + 2)

static gjk2_vec any_vec2(int32_t size) {
  const gjk2_vec v = {any_between(-size, size), any_between(-size, size)};
  return v;
}

static gjk2_vec any_position2(void) {
  const gjk2_vec v = {any_int32(), any_int32()};
  return v;
}

static gjk2_rotation any_rotation(void) {
  const gjk2_rotation r = {any_int32(), any_int32()};
  return r;
}

static gjk2_pose any_pose2(void) {
  const gjk2_pose pose = {any_position2(), any_rotation()};
  return pose;
}

static void check_within(int64_t x, int64_t size) {
  //@ assert x >= -size && x <= size;
}

static void check_vec2(gjk2_vec v, int32_t size) {
  check_within(v.x, size);
  check_within(v.y, size);
}

static int64_t any_long(int64_t least, int64_t most) {
  return Frama_C_long_long_interval(least, most);
}

#endif
