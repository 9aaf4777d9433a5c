// Numbers as people write them in cases and options, to fixed point.
#ifndef CASE_NUMBER_H
#define CASE_NUMBER_H

#include <stdbool.h>
#include <stdint.h>

// Without a decimal point the integer as it stands; with one (exponent allowed: 1.5e-3) the decimal times
// 2^fraction_bits, rounded exactly to the nearest, ties away from zero. False when the text is not a number or
// the result leaves int32_t; *out is then untouched.
bool case_number_parse(const char *text, int fraction_bits, int32_t *out);

#endif
