// Prints numbers as text, without libc, for programs that also run as firmware.
#ifndef PRINT_H
#define PRINT_H

#include <stdint.h>

typedef void print_function(const char *text);  // writes text

static inline void print_hex(print_function *print, uint64_t value) {
  char text[17];
  for (int i = 15; i >= 0; i--) {
    text[i] = "0123456789abcdef"[value & 15u];
    value >>= 4;
  }
  text[16] = '\0';
  print(text);
}

static inline void print_decimal(print_function *print, uint32_t value) {
  char text[11];
  int i = 10;
  text[i] = '\0';
  do {
    text[--i] = (char)('0' + value % 10);
    value /= 10;
  } while (value != 0);
  print(text + i);
}

#endif
