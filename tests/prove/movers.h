// Any bodies of a time of impact, as src/motion/gjk_impact_separation.h has them.
#ifndef PROVE_MOVERS_H
#define PROVE_MOVERS_H

#include "colliders.h"
#include "src/motion/gjk_impact_separation.h"

// Half of the angle of a turning, in units of 2^-48 turns: |spin| is at most sqrt(3) 2^31.
#define ANY_HALF_TURNS (INT64_C(3) << 59)

// How far a core reaches from its body's position: the position stays within int32 with the arm around it.
#define ANY_REACH ((INT64_C(1) << 31) + GJK_RADIUS_MAX + 4)

static gjk_unit3 any_unit3(void) {
  const gjk_unit3 u = {any_between(-ANY_UNIT, ANY_UNIT), any_between(-ANY_UNIT, ANY_UNIT),
                       any_between(-ANY_UNIT, ANY_UNIT)};
  return u;
}

static void check_unit3(const gjk_unit3 *u) {
  check_size(u->x, ANY_UNIT);
  check_size(u->y, ANY_UNIT);
  check_size(u->z, ANY_UNIT);
}

static void any_turning(gjk_turning *turning) {
  turning->half_turns = (uint64_t)Frama_C_long_long_interval(0, ANY_HALF_TURNS);
  turning->deviation = Frama_C_long_long_interval(-(INT64_C(1) << 44), INT64_C(1) << 44);
  turning->axis.x = any_between(-GJK_Q30_ONE, GJK_Q30_ONE);
  turning->axis.y = any_between(-GJK_Q30_ONE, GJK_Q30_ONE);
  turning->axis.z = any_between(-GJK_Q30_ONE, GJK_Q30_ONE);
}

static void check_turning(const gjk_turning *turning) {
  //@ assert turning->half_turns <= ANY_HALF_TURNS;
  check_size(turning->axis.x, GJK_Q30_ONE);
  check_size(turning->axis.y, GJK_Q30_ONE);
  check_size(turning->axis.z, GJK_Q30_ONE);
}

#endif
