// Why an answer is refused.
#ifndef EXACT_REFUSE_H
#define EXACT_REFUSE_H

#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>

// Writes the reason, n bytes, and returns false.
static inline bool refuse(char *why, size_t n, const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(why, n, format, arguments);
  va_end(arguments);
  return false;
}

#endif
