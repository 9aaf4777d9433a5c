// A pile of bodies under the solver of the tests, and its picture.
#ifndef DEMO_STACK_H
#define DEMO_STACK_H

#include <stdio.h>

#include "case/case.h"
#include "solver/solver.h"

enum { DEMO_MOMENTS = 3 };

typedef struct demo_stack {
  solver_world world;
  case_shape drawn[SOLVER_BODIES_MAX];  // each body, as it is drawn
  unsigned kind[SOLVER_BODIES_MAX];     // of the palette
  gjk_shape shape[SOLVER_BODIES_MAX];
} demo_stack;

void demo_stack_start(demo_stack *d);

// How many bodies move.
unsigned demo_stack_falling(const demo_stack *d);

// Writes the head of the picture; the caller ends it.
void demo_stack_open(FILE *file);

// Draws the present world at the place of its moment.
void demo_stack_draw(FILE *file, demo_stack *d, unsigned moment, unsigned tick);

#endif
