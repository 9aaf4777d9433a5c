// The query tool's reader of cases on any text. What it accepts must be the same after printing and reading it again.
#define _POSIX_C_SOURCE 200809L
#include <stdlib.h>
#include <string.h>

#include "bytes.h"
#include "case/parse.h"

static bool same_shape(const case_shape *a, const case_shape *b) {
  return a->kind == b->kind && memcmp(&a->size, &b->size, sizeof a->size) == 0 &&
         a->convex_radius == b->convex_radius && memcmp(&a->pose, &b->pose, sizeof a->pose) == 0 &&
         a->count == b->count &&
         (a->count == 0 || memcmp(a->vertices, b->vertices, a->count * sizeof *a->vertices) == 0);
}

static void check_printed(const case_pair *pair) {
  static case_pair again;
  static case_reader reader;
  char *text = NULL;
  size_t size = 0;
  FILE *memory = open_memstream(&text, &size);
  case_print(memory, pair);
  fclose(memory);
  memory = fmemopen(text, size, "r");
  case_reader_open(&reader, memory, "again");
  if (!case_reader_next(&reader, &again) || strcmp(pair->id, again.id) != 0 || !same_shape(&pair->a, &again.a) ||
      !same_shape(&pair->b, &again.b)) {
    fuzz_fail("a case, printed and read again, is another");
  }
  fclose(memory);
  free(text);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  static case_pair pair;
  static case_reader reader;
  if (size == 0) {
    return 0;
  }
  char *copy = malloc(size);
  memcpy(copy, data, size);
  FILE *file = fmemopen(copy, size, "r");
  case_reader_open(&reader, file, "fuzz");
  while (case_reader_next(&reader, &pair)) {
    check_printed(&pair);
  }
  fclose(file);
  free(copy);
  return 0;
}
