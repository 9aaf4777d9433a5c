// Reads numbers as people write them in cases and options, to fixed point.
#ifndef CASE_NUMBER_H
#define CASE_NUMBER_H

#include <stdbool.h>
#include <stdint.h>

// Without a decimal point, text is the raw integer. With one (1.5e-3: an exponent is allowed), it is a decimal that is
// multiplied by 2^fraction_bits and rounded exactly to the nearest integer, ties away from zero. Returns false if text
// is no number or the result is not an int32_t; *out is untouched then.
bool case_number_parse(const char *text, int fraction_bits, int32_t *out);

#endif
