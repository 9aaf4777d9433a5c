// The few functions of libc that the page's C code calls, without a system below.
#include "../../../../port/gjk_allocate.h"

#include <stdbool.h>
#include <stdint.h>

#include "stdio.h"
#include "stdlib.h"
#include "string.h"

FILE page_stdout, page_stderr;

int getc(FILE *file) {
  return file->at < file->size ? (unsigned char)file->text[file->at++] : EOF;
}

int fputc(int c, FILE *file) {
  if (file->at < file->size) {
    file->text[file->at] = (char)c;
  }
  file->at++;
  return c;
}

int ferror(FILE *file) {
  (void)file;
  return 0;
}

static void put_text(FILE *file, const char *text) {
  for (; *text != '\0'; text++) {
    fputc(*text, file);
  }
}

static void put_number(FILE *file, unsigned long long value) {
  char digit[24];
  unsigned count = 0;
  do {
    digit[count++] = (char)('0' + value % 10);
    value /= 10;
  } while (value != 0);
  while (count > 0) {
    fputc(digit[--count], file);
  }
}

static void put_signed(FILE *file, long long value) {
  if (value < 0) {
    fputc('-', file);
  }
  put_number(file, value < 0 ? 0 - (unsigned long long)value : (unsigned long long)value);
}

int vfprintf(FILE *file, const char *format, va_list arguments) {
  const size_t before = file->at;
  for (; *format != '\0'; format++) {
    unsigned longs = 0;
    if (*format != '%') {
      fputc(*format, file);
      continue;
    }
    while (*++format == 'l') {
      longs++;
    }
    switch (*format) {
      case 's': put_text(file, va_arg(arguments, const char *)); break;
      case 'c': fputc(va_arg(arguments, int), file); break;
      case 'd':
        put_signed(file, longs == 0   ? va_arg(arguments, int)
                         : longs == 1 ? va_arg(arguments, long)
                                      : va_arg(arguments, long long));
        break;
      case 'u':
        put_number(file, longs == 0   ? va_arg(arguments, unsigned)
                         : longs == 1 ? va_arg(arguments, unsigned long)
                                      : va_arg(arguments, unsigned long long));
        break;
      case '%': fputc('%', file); break;
      default: __builtin_trap();  // a format that is not supported
    }
  }
  return (int)(file->at - before);
}

int fprintf(FILE *file, const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  const int length = vfprintf(file, format, arguments);
  va_end(arguments);
  return length;
}

int snprintf(char *text, size_t size, const char *format, ...) {
  FILE file = {text, 0, size > 0 ? size - 1 : 0};
  va_list arguments;
  va_start(arguments, format);
  const int length = vfprintf(&file, format, arguments);
  va_end(arguments);
  if (size > 0) {
    text[(size_t)length < size ? (size_t)length : size - 1] = '\0';
  }
  return length;
}

// The size of a block stands 16 bytes in front of it.
static void *allocate(size_t size) {
  size_t *memory = size < SIZE_MAX - 16 ? gjk_port_allocate(size + 16) : NULL;
  if (memory == NULL) {
    return NULL;
  }
  memory[0] = size;
  return memory + 16 / sizeof(size_t);
}

static size_t size_of(const void *memory) {
  return *((const size_t *)memory - 16 / sizeof(size_t));
}

void *calloc(size_t count, size_t size) {
  void *memory = count > SIZE_MAX / (size + 1) ? NULL : allocate(count * size);
  return memory == NULL ? NULL : memset(memory, 0, count * size);
}

void *realloc(void *memory, size_t size) {
  void *grown = allocate(size);
  if (grown != NULL && memory != NULL) {
    memcpy(grown, memory, size_of(memory) < size ? size_of(memory) : size);
    free(memory);
  }
  return grown;
}

void free(void *memory) {
  if (memory != NULL) {
    gjk_port_release((size_t *)memory - 16 / sizeof(size_t));
  }
}

void exit(int status) {
  (void)status;
  __builtin_trap();
}

// Base 10 alone; stops at numbers of 10 digits, which no reader here takes.
long strtol(const char *text, char **end, int base) {
  const bool negative = *text == '-';
  const char *digit = text + (*text == '-' || *text == '+');
  long value = 0;
  for (; *digit >= '0' && *digit <= '9'; digit++) {
    value = value < 100000000 ? value * 10 + (*digit - '0') : value;
  }
  *end = (char *)(uintptr_t)digit;
  return base == 10 && negative ? -value : value;
}

void *memmove(void *to, const void *from, size_t bytes) {
  char *out = to;
  const char *in = from;
  if (out <= in) {
    return memcpy(to, from, bytes);
  }
  while (bytes > 0) {
    bytes--;
    out[bytes] = in[bytes];
  }
  return to;
}

int memcmp(const void *a, const void *b, size_t bytes) {
  const unsigned char *p = a, *q = b;
  for (size_t i = 0; i < bytes; i++) {
    if (p[i] != q[i]) {
      return p[i] < q[i] ? -1 : 1;
    }
  }
  return 0;
}

size_t strlen(const char *text) {
  size_t length = 0;
  while (text[length] != '\0') {
    length++;
  }
  return length;
}

int strncmp(const char *a, const char *b, size_t most) {
  for (size_t i = 0; i < most; i++) {
    if (a[i] != b[i] || a[i] == '\0') {
      return (unsigned char)a[i] < (unsigned char)b[i] ? -1 : a[i] != b[i];
    }
  }
  return 0;
}

int strcmp(const char *a, const char *b) {
  return strncmp(a, b, SIZE_MAX);
}

char *strchr(const char *text, int c) {
  for (; *text != (char)c; text++) {
    if (*text == '\0') {
      return NULL;
    }
  }
  return (char *)(uintptr_t)text;
}

char *strerror(int number) {
  (void)number;
  static char text[] = "error";
  return text;
}
