// What contracts.h says of vectors shorter than 2^31: each component is, and those of the cross product of two are
// below 2^62. For WP with an SMT solver, which is led by the squares: 2 (ay bz - az by) is what they leave of |a|^2 +
// |b|^2.
#include <stdint.h>

/*@ requires a: ax * ax + ay * ay + az * az < 0x4000000000000000;
    assigns \nothing;
    ensures -0x80000000 < ax < 0x80000000; */
void component(int64_t ax, int64_t ay, int64_t az) {
  //@ assert ay * ay >= 0 && az * az >= 0;
  //@ assert ax >= 0x80000000 ==> ax * ax >= 0x80000000 * 0x80000000;
  //@ assert ax <= -0x80000000 ==> ax * ax >= 0x80000000 * 0x80000000;
}

/*@ requires a: ax * ax + ay * ay + az * az < 0x4000000000000000;
    requires b: bx * bx + by * by + bz * bz < 0x4000000000000000;
    assigns \nothing;
    ensures -0x4000000000000000 < ay * bz - az * by < 0x4000000000000000; */
void cross_component(int32_t ax, int32_t ay, int32_t az, int32_t bx, int32_t by, int32_t bz) {
  //@ assert (ay - bz) * (ay - bz) + (az + by) * (az + by) >= 0;
  //@ assert (ay + bz) * (ay + bz) + (az - by) * (az - by) >= 0;
  //@ assert ax * ax >= 0 && bx * bx >= 0;
}
