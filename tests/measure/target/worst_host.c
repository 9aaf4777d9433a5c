// Host program: searches for pairs that take the most iterations: worst_host FAMILY SEED MEASUREMENTS
//
// What a search does among the vertices that it has seen counts as well.
#include "src/gjk/gjk_search.h"
#include "worst.h"

#include <stdio.h>
#include <stdlib.h>

static uint32_t steps(const worst_family *family, const worst_pair *pair) {
  const gjk_goal goal = family->distance ? GJK_GOAL_DISTANCE : GJK_GOAL_WITHIN;
  gjk_iteration it;
  if (!worst_pose(pair)) {
    return 0;
  }
  const gjk_collider *a = worst_collider(0), *b = worst_collider(1);
  if (!gjk_iteration_start(&it, a, b, goal, (int64_t)a->shape->convex_radius + b->shape->convex_radius)) {
    return 1;
  }
  it.recalls = 0;
  gjk_search(&it, goal, NULL, GJK_NO_LIMIT);
  return (uint32_t)it.iterations + it.recalls;
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
  const uint32_t most_iterations = worst_search(family, steps, strtoull(argv[2], NULL, 10), measurements, &most);
  worst_print(print, family, "iterations", &most);
  printf("# iterations %lu\n", (unsigned long)most_iterations);
  return 0;
}
