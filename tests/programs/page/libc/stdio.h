// The part of stdio that the readers and writers of cases use, on memory.
#ifndef PAGE_STDIO_H
#define PAGE_STDIO_H

#include <stdarg.h>
#include <stddef.h>

#define EOF (-1)

// A text that is read from, or one that is written to: what finds no room is left out.
typedef struct page_file {
  char *text;
  size_t at, size;
} FILE;

extern FILE page_stdout, page_stderr;
#define stdout (&page_stdout)
#define stderr (&page_stderr)

int getc(FILE *file);
int fputc(int c, FILE *file);
int ferror(FILE *file);

// %s %c %d %u %ld %lu %lld %llu %% alone.
int fprintf(FILE *file, const char *format, ...);
int vfprintf(FILE *file, const char *format, va_list arguments);
int snprintf(char *text, size_t size, const char *format, ...);

#endif
