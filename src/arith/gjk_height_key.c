// Keys that order planes by their height over the origin.
#include "gjk_height_key.h"

// Each of the two is cut to 16 bits, which makes the quotient wrong by less than 2^-14 and 2^-15 of itself; so does
// cutting that off to 16 bits of fraction, by 2^-14 with the bits lost before.
uint32_t gjk_height_key(int64_t along, int64_t squared) {
  if (along <= 0) {
    return 0;
  }
  const unsigned n = gjk_clz64((uint64_t)along), m = gjk_clz64((uint64_t)squared);
  const uint32_t top = (uint32_t)((uint64_t)along << n >> 48), bottom = (uint32_t)((uint64_t)squared << m >> 48);
  //@ assert top >= 0x8000 && bottom >= 0x8000;
  // From 2^14 to below 2^17.
  const uint32_t quotient = top * top / bottom;
  const unsigned zeros = gjk_clz32(quotient);
  // The square is quotient 2^(48 + m - 2 n); that below 1 counts as 0.
  const int exponent = 31 - (int)zeros + 48 + (int)m - 2 * (int)n;
  return exponent < 0 ? 0 : (uint32_t)exponent << 16 | ((quotient << zeros >> 15) & 0xFFFFu);
}
