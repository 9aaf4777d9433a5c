// Integers of up to 512 bits, sign and magnitude: schoolbook arithmetic, to be read rather than to be fast.
#ifndef EXACT_INTEGER_H
#define EXACT_INTEGER_H

#include <stdbool.h>
#include <stdint.h>

#define EXACT_LIMBS 16

// sign is -1, 0 or 1; the magnitude is limb[0] + 2^32 limb[1] + ... up to limb[count - 1], which is not 0.
typedef struct exact_int {
  int sign;
  unsigned count;
  uint32_t limb[EXACT_LIMBS];
} exact_int;

// A result beyond 512 bits ends the program, since it is a fault of the test.
exact_int exact_from(int64_t value);
exact_int exact_negate(exact_int a);
exact_int exact_add(const exact_int *a, const exact_int *b);
exact_int exact_sub(const exact_int *a, const exact_int *b);
exact_int exact_mul(const exact_int *a, const exact_int *b);
exact_int exact_product(int64_t a, int64_t b);

// *sum += x
void exact_add_to(exact_int *sum, exact_int x);

// The sign of a - b.
int exact_compare(const exact_int *a, const exact_int *b);

// Is value = floor(scale x / y + half / 2), with y > 0? By value y <= scale x + half y / 2 < (value + 1) y, doubled.
bool exact_is_rounded(int64_t value, exact_int x, exact_int y, int64_t scale, int half);

// a, within 2^-51 of itself.
double exact_to_double(const exact_int *a);

#endif
