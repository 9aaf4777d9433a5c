// Host program: searches for pairs that take the most rounds: worst_host FAMILY SEED MEASUREMENTS
#include "worst.h"

#include <stdio.h>
#include <stdlib.h>

static uint32_t rounds(const worst_family *family, const worst_pair *pair) {
  return worst_pose(pair) ? worst_query(family) : 0;
}

static void print(const char *text) {
  fputs(text, stdout);
}

int main(int argc, char **argv) {
  static worst_pair most;
  const unsigned long number = argc == 4 ? strtoul(argv[1], NULL, 10) : worst_family_count;
  if (number >= worst_family_count) {
    fprintf(stderr, "usage: worst_host FAMILY SEED MEASUREMENTS, FAMILY from 0 to %u\n", worst_family_count - 1);
    return 2;
  }
  const worst_family *family = &worst_families[number];
  const uint32_t measurements = (uint32_t)strtoul(argv[3], NULL, 10);
  const uint32_t most_rounds = worst_search(family, rounds, strtoull(argv[2], NULL, 10), measurements, &most);
  worst_print(print, family, "rounds", &most);
  printf("# rounds %lu\n", (unsigned long)most_rounds);
  return 0;
}
