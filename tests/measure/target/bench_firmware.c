// Firmware: instructions and stack per query on an emulated core, one line per solver and
// family: SOLVER|FAMILY|mean|worst|iterations x 100, mean|most iterations|bytes of stack|bytes of workspace, the most needed
//
// Fails where a solver's answer is another than the library's: these pairs are easy.
#include "bench.h"
#include "count.h"
#include "print.h"

#define PAINT 0x5AA5C33Cu

// Paints the free stack but for 16 words, which this function may be using itself. Returns where the stack stands: a
// function of its own, so that nothing of the caller's lies below.
__attribute__((noinline)) static uintptr_t paint_stack(void) {
  volatile uint32_t here = 0;
  const uintptr_t top = (uintptr_t)&here;
  for (volatile uint32_t *p = board_stack_low; (uintptr_t)p < top - 64; p++) {
    *p = PAINT;
  }
  return top;
}

// Bytes of stack below top that were written since it was painted.
static uint32_t painted_depth(uintptr_t top) {
  const volatile uint32_t *p = board_stack_low;
  while ((uintptr_t)p < top && *p == PAINT) {
    p++;
  }
  return (uint32_t)(top - (uintptr_t)p);
}

static void field(uint32_t value) {
  board_print("|");
  print_decimal(board_print, value);
}

// The same decision, and a distance within 16 LSB, which is more than a float is off on these pairs.
static bool agrees(const bench_family *family, const bench_answer *answer) {
  const gjk_q16 error = answer->distance - bench_expected.distance;
  return answer->intersecting == bench_expected.intersecting &&
         (family->query == BENCH_INTERSECT || (error >= -16 && error <= 16));
}

// Returns whether every answer was right.
static bool measure(const bench_solver *solver, const bench_family *family, uint32_t calibration) {
  uint32_t sum = 0, worst = 0, iterations = 0, most_iterations = 0, stack = 0, cells = 0, wrong = 0;
  const unsigned pairs = bench_pair_count(family);
  bench_start();
  for (unsigned i = 0; i < pairs; i++) {
    wrong += !bench_next(family);
    solver->pose(bench_pair[0], bench_pair[1]);
    bench_answer answer;
    const uintptr_t top = paint_stack();
    const uint32_t start = board_ticks();
    solver->run(family->query, &answer);
    const uint32_t count = count_instructions(board_ticks() - start, calibration);
    const uint32_t depth = painted_depth(top);
    sum += count;
    worst = count > worst ? count : worst;
    iterations += answer.iterations;
    most_iterations = answer.iterations > most_iterations ? answer.iterations : most_iterations;
    stack = depth > stack ? depth : stack;
    wrong += !agrees(family, &answer);
    const uint32_t needed = bench_cells_needed(family);
    cells = needed > cells ? needed : cells;
  }
  board_print(solver->name);
  board_print("|");
  board_print(family->name);
  field(sum / pairs);
  field(worst);
  field(iterations * 100 / pairs);
  field(most_iterations);
  field(stack);
  field(cells * (uint32_t)sizeof(gjk_epa_cell));
  board_print("\n");
  return wrong == 0;
}

int firmware_main(void) {
  static const bench_solver *const solvers[] = {&bench_gjk, &bench_float, &bench_double};
  const uint32_t calibration = count_calibrate();
  if (calibration == 0) {
    board_print("the counter does not count instructions\n");
    return 1;
  }
  for (unsigned s = 0; s < sizeof solvers / sizeof solvers[0]; s++) {
    for (unsigned i = 0; i < bench_family_count; i++) {
      if (bench_families[i].query <= solvers[s]->last && !measure(solvers[s], &bench_families[i], calibration)) {
        board_print("wrong answers\n");
        return 1;
      }
    }
  }
  return 0;
}
