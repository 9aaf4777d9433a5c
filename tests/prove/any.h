// Arbitrary values for the analysis: a driver's inputs in their stated ranges.
#ifndef PROVE_ANY_H
#define PROVE_ANY_H

#include <stdbool.h>
#include <stdint.h>

#include "__fc_builtin.h"
#include "gjk/gjk.h"

// The largest size of a component of a vertex of a posed core, from the collider's centre: core_radius at most
// GJK_RADIUS_MAX + 4 (collider.c).
#define ANY_OFFSET (GJK_RADIUS_MAX + 4)

static int32_t any_between(int32_t least, int32_t most) {
  return (int32_t)Frama_C_long_interval(least, most);
}

static int32_t any_int32(void) {
  return any_between(INT32_MIN, INT32_MAX);
}

static bool any_bool(void) {
  return any_between(0, 1) != 0;
}

static uint16_t any_uint16(void) {
  return (uint16_t)any_between(0, UINT16_MAX);
}

static gjk_vec3 any_vec3(int32_t size) {
  const gjk_vec3 v = {any_between(-size, size), any_between(-size, size), any_between(-size, size)};
  return v;
}

static gjk_vec3 any_position(void) {
  const gjk_vec3 v = {any_int32(), any_int32(), any_int32()};
  return v;
}

static gjk_quat any_quat(void) {
  const gjk_quat q = {any_int32(), any_int32(), any_int32(), any_int32()};
  return q;
}

static gjk_pose any_pose(void) {
  const gjk_pose pose = {any_position(), any_quat()};
  return pose;
}

#endif
