// The functions of libc that compilers call on their own, for firmware without one. The library's source calls none of them.
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

#ifdef __ARM_EABI__
// The same under the names of ARM's run-time ABI, which clang prefers; the digits promise an alignment.
#define ARM_NAMES(digit)                                                 \
  void __aeabi_memcpy##digit(void *to, const void *from, size_t bytes);  \
  void __aeabi_memset##digit(void *to, size_t bytes, int value);         \
  void __aeabi_memclr##digit(void *to, size_t bytes);                    \
  void __aeabi_memcpy##digit(void *to, const void *from, size_t bytes) { \
    memcpy(to, from, bytes);                                             \
  }                                                                      \
  void __aeabi_memset##digit(void *to, size_t bytes, int value) {        \
    memset(to, value, bytes);                                            \
  }                                                                      \
  void __aeabi_memclr##digit(void *to, size_t bytes) {                   \
    memset(to, 0, bytes);                                                \
  }

ARM_NAMES()
ARM_NAMES(4)
ARM_NAMES(8)
#endif
