// The families of pairs in the plane that decisions and costs are measured on.
#ifndef PLANE_FAMILIES_H
#define PLANE_FAMILIES_H

#include <stdint.h>

#include "case/case2.h"
#include "plane.h"
#include "random.h"

// least, most: what the maker needs two numbers for. own: shapes that no other method is given. moved: a method that keeps a
// cache is asked as well, each time about the other of two places of B.
typedef struct plane_family {
  const char *name;
  plane_query query;
  void (*generate)(const struct plane_family *family, random_state *random, size_t index, case2_pair *pair);
  case2_kind a, b;
  gjk_q16 least, most;
  bool own, moved;
} plane_family;

extern const plane_family plane_decision_families[], plane_cost_families[];
extern const size_t plane_decision_family_count, plane_cost_family_count;

// Makes count pairs of a family; a seed makes the same ones each time.
plane_pair *plane_pairs_make(const plane_family *family, uint64_t seed, size_t count);
void plane_pairs_free(plane_pair *pairs, size_t count);

#endif
