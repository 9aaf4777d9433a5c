// The height key of a plane, from 16 leading bits of each operand.
#include "gjk_height_key.h"

// The square of the height is along^2 / squared, computed as top^2 / bottom. Relative errors of the key's fraction:
//   top     16 bits of along, squared below      < 2^-14
//   bottom  16 bits of squared                   < 2^-15
//   the quotient and its fraction, truncated     < 2^-14
uint32_t gjk_height_key(int64_t along, int64_t squared) {
  if (along <= 0) {
    return 0;
  }
  const unsigned n = gjk_clz64((uint64_t)along), m = gjk_clz64((uint64_t)squared);
  const uint32_t top = (uint32_t)((uint64_t)along << n >> 48), bottom = (uint32_t)((uint64_t)squared << m >> 48);
  //@ assert top >= 0x8000 && bottom >= 0x8000;
  const uint32_t quotient = top * top / bottom;  // 2^15 <= top, bottom < 2^16:  2^14 <= quotient < 2^17
  const unsigned zeros = gjk_clz32(quotient);
  // along^2 / squared = quotient 2^(48 + m - 2 n), and quotient has 32 - zeros bits. A square below 1 counts as 0.
  const int exponent = 31 - (int)zeros + 48 + (int)m - 2 * (int)n;
  return exponent < 0 ? 0 : (uint32_t)exponent << 16 | ((quotient << zeros >> 15) & 0xFFFFu);
}
