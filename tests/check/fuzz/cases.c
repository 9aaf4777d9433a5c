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

static bool same_shape2(const case2_shape *a, const case2_shape *b) {
  return a->kind == b->kind && memcmp(&a->size, &b->size, sizeof a->size) == 0 &&
         a->convex_radius == b->convex_radius && memcmp(&a->pose, &b->pose, sizeof a->pose) == 0 &&
         a->count == b->count &&
         (a->count == 0 || memcmp(a->vertices, b->vertices, a->count * sizeof *a->vertices) == 0);
}

// One of the two pairs is read, as found says.
static void check_printed(case_found found, const case_pair *pair, const case2_pair *plane) {
  static case_pair again;
  static case2_pair again2;
  static case_reader reader;
  char *text = NULL;
  size_t size = 0;
  bool same;
  FILE *memory = open_memstream(&text, &size);
  if (found == CASE_FOUND_PLANE) {
    case2_print(memory, plane);
  } else {
    case_print(memory, pair);
  }
  fclose(memory);
  memory = fmemopen(text, size, "r");
  case_reader_open(&reader, memory, "again");
  if (case_reader_next_any(&reader, &again, &again2) != found) {
    same = false;
  } else if (found == CASE_FOUND_PLANE) {
    same = strcmp(plane->id, again2.id) == 0 && same_shape2(&plane->a, &again2.a) && same_shape2(&plane->b, &again2.b);
  } else {
    same = strcmp(pair->id, again.id) == 0 && same_shape(&pair->a, &again.a) && same_shape(&pair->b, &again.b);
  }
  if (!same) {
    fuzz_fail("a case, printed and read again, is another");
  }
  fclose(memory);
  free(text);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  static case_pair pair;
  static case2_pair plane;
  static case_reader reader;
  case_found found;
  if (size == 0) {
    return 0;
  }
  char *copy = malloc(size);
  memcpy(copy, data, size);
  FILE *file = fmemopen(copy, size, "r");
  case_reader_open(&reader, file, "fuzz");
  while ((found = case_reader_next_any(&reader, &pair, &plane)) != CASE_FOUND_NONE) {
    check_printed(found, &pair, &plane);
  }
  fclose(file);
  free(copy);
  return 0;
}
