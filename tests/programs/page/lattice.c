// Answers of a pair with B at the points of a lattice.
#include "lattice.h"

#include <stdio.h>
#include <string.h>

#include "case/parse.h"
#include "gjk/check.h"

static case_reader reader;
static case_pair pair;
static case2_pair plane;
static case_collider a, b;
static uint8_t cells[PAGE_LATTICE_MAX * PAGE_LATTICE_MAX];

int page_lattice_open(const char *cases) {
  FILE in = {(char *)(uintptr_t)cases, 0, strlen(cases)};
  case_reader_open(&reader, &in, "the page");
  return case_reader_next_any(&reader, &pair, &plane) == CASE_FOUND_SPACE &&
         case_collider_build(&a, &pair.a, false) == GJK_OK && case_collider_build(&b, &pair.b, false) == GJK_OK;
}

static uint8_t answer_at(const gjk_vec3 *position) {
  gjk_decision decision;
  reference_result in_double, in_float;
  if (gjk_collider_move(&b.collider, position) != GJK_OK ||
      gjk_intersect(&a.collider, &b.collider, NULL, &decision) != GJK_OK) {
    return 0;
  }
  lattice_reference_query_posed(&pair, &a, &b, &in_double);
  reference_float_query_posed(&pair, &a, &b, &in_float);
  return (uint8_t)((decision.yes ? PAGE_SAYS_GJK : 0) | (in_double.intersecting ? PAGE_SAYS_DOUBLE : 0) |
                   (in_float.intersecting ? PAGE_SAYS_FLOAT : 0) |
                   (gjk_check_decision(&a.collider, &b.collider, 0, &decision) == GJK_OK ? PAGE_PROVEN : 0));
}

const uint8_t *page_lattice(const page_steps *steps, unsigned count, double tolerance) {
  const gjk_vec3 base = pair.b.pose.position;
  const int32_t from[3] = {base.x + steps->start[0], base.y + steps->start[1], base.z + steps->start[2]};
  lattice_tolerance = tolerance;
  for (unsigned k = 0; k < count; k++) {
    for (unsigned i = 0; i < count; i++) {
      int32_t at[3];
      for (unsigned m = 0; m < 3; m++) {
        at[m] = from[m] + (int32_t)i * steps->u[m] + (int32_t)k * steps->v[m];
      }
      const gjk_vec3 position = {at[0], at[1], at[2]};
      cells[k * count + i] = answer_at(&position);
    }
  }
  return cells;
}
