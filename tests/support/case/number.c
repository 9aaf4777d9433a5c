// Reads numbers as people write them: decimal digits to fixed point, without floating point between.
#include "number.h"

#include <stddef.h>
#include <stdlib.h>

// Most digits: more than any line of a case holds, with the zeros after the point that still matter.
#define DIGITS_MAX 1200
#define LEADING_ZEROS_MAX 20

// 0.d1 d2 d3 ... times 10^point.
typedef struct decimal {
  char digits[DIGITS_MAX];
  size_t count;
  long point;
  bool has_point;
} decimal;

static bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

static bool read_decimal(const char *text, decimal *out) {
  out->count = 0;
  out->point = 0;
  out->has_point = false;
  for (; is_digit(*text) || (*text == '.' && !out->has_point); text++) {
    if (*text == '.') {
      out->has_point = true;
      out->point = (long)out->count;
    } else if (out->count < DIGITS_MAX) {
      out->digits[out->count++] = (char)(*text - '0');
    } else {
      return false;
    }
  }
  if (!out->has_point) {
    out->point = (long)out->count;
  } else if (out->count > 0 && (*text == 'e' || *text == 'E')) {
    const char *exponent = text + 1;
    const char *first = exponent + (*exponent == '-' || *exponent == '+');
    char *end;
    long value = strtol(exponent, &end, 10);
    if (!is_digit(*first) || value < -99999 || value > 99999) {
      return false;
    }
    out->point += value;
    text = end;
  }
  return out->count > 0 && *text == '\0';
}

// Reads the part before the point; saturates far beyond int32_t.
static int64_t whole_part(const decimal *number) {
  int64_t whole = 0;
  for (long i = 0; i < number->point && whole <= INT32_MAX; i++) {
    whole = whole * 10 + ((size_t)i < number->count ? number->digits[i] : 0);
  }
  return whole;
}

// Returns whole plus the part after the point, times 2^bits, rounded half up. The fraction is doubled in decimal; each
// carry out of it is the next bit.
static int64_t scaled(const decimal *number, int64_t whole, int bits) {
  char fraction[DIGITS_MAX + LEADING_ZEROS_MAX];
  size_t count = 0;
  if (number->point < -LEADING_ZEROS_MAX) {
    return 0;
  }
  for (long i = number->point; i < 0; i++) {
    fraction[count++] = 0;
  }
  for (size_t i = number->point > 0 ? (size_t)number->point : 0; i < number->count; i++) {
    fraction[count++] = number->digits[i];
  }
  for (int bit = 0; bit < bits; bit++) {
    int carry = 0;
    for (size_t i = count; i-- > 0;) {
      int doubled = 2 * fraction[i] + carry;
      fraction[i] = (char)(doubled % 10);
      carry = doubled / 10;
    }
    whole = 2 * whole + carry;
  }
  return whole + (count > 0 && fraction[0] >= 5 ? 1 : 0);
}

bool case_number_parse(const char *text, int fraction_bits, int32_t *out) {
  decimal number;
  bool negative = *text == '-';
  if (!read_decimal(text + (*text == '-' || *text == '+'), &number)) {
    return false;
  }
  int64_t value = whole_part(&number);
  if (number.has_point && value <= INT32_MAX) {
    value = scaled(&number, value, fraction_bits);
  }
  value = negative ? -value : value;
  if (value < INT32_MIN || value > INT32_MAX) {
    return false;
  }
  *out = (int32_t)value;
  return true;
}
