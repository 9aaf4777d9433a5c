// The functions of libc that compilers call on their own, for firmware without one. The library needs none of them.
#include <stddef.h>

void *memcpy(void *to, const void *from, size_t bytes);
void *memset(void *to, int value, size_t bytes);

void *memcpy(void *to, const void *from, size_t bytes) {
  char *out = to;
  const char *in = from;
  for (size_t i = 0; i < bytes; i++) {
    out[i] = in[i];
  }
  return to;
}

void *memset(void *to, int value, size_t bytes) {
  char *out = to;
  for (size_t i = 0; i < bytes; i++) {
    out[i] = (char)value;
  }
  return to;
}
