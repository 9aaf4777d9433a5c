// Firmware: instructions and stack per query on an emulated core, one line per solver and
// family: SOLVER|FAMILY|mean|worst|iterations x 100, mean|most iterations|bytes of stack|bytes of workspace, the most needed
//
// Fails if an answer of a solver differs from the library's: these pairs are easy.
#include "bench.h"
#include "count.h"
#include "paint.h"

// The same decision, and a distance within 16 LSB, which is more than a float is off for these pairs.
static bool agrees(const bench_family *family, const bench_answer *answer) {
  const gjk_q16 error = answer->distance - bench_expected.distance;
  return answer->intersecting == bench_expected.intersecting &&
         (family->query == BENCH_INTERSECT || (error >= -16 && error <= 16));
}

// Measures a solver on a family. Returns whether every answer was right.
static bool measure(const bench_solver *solver, const bench_family *family) {
  count_tally t = {0, 0, 0};
  uint32_t iterations = 0, most_iterations = 0, stack = 0, cells = 0, wrong = 0;
  const unsigned pairs = bench_pair_count(family);
  bench_start();
  for (unsigned i = 0; i < pairs; i++) {
    wrong += !bench_next(family);
    solver->pose(bench_pair[0], bench_pair[1]);
    bench_answer answer;
    const uintptr_t top = paint_stack();
    const uint32_t start = board_ticks();
    solver->run(family->query, &answer);
    count_add(&t, count_since(start));
    const uint32_t depth = painted_depth(top);
    iterations += answer.iterations;
    most_iterations = answer.iterations > most_iterations ? answer.iterations : most_iterations;
    stack = depth > stack ? depth : stack;
    wrong += !agrees(family, &answer);
    const uint32_t needed = bench_cells_needed(family);
    cells = needed > cells ? needed : cells;
  }
  board_print(solver->name);
  board_print("|");
  count_line(family->name, &t);
  count_field(iterations * 100 / pairs);
  count_field(most_iterations);
  count_field(stack);
  count_field(cells * (uint32_t)sizeof(gjk_epa_cell));
  board_print("\n");
  return wrong == 0;
}

int firmware_main(void) {
  static const bench_solver *const solvers[] = {&bench_gjk, &bench_float, &bench_double};
  if (!count_prepare()) {
    return 1;
  }
  for (unsigned s = 0; s < sizeof solvers / sizeof solvers[0]; s++) {
    for (unsigned i = 0; i < bench_family_count; i++) {
      if (bench_families[i].query <= solvers[s]->last && !measure(solvers[s], &bench_families[i])) {
        board_print("wrong answers\n");
        return 1;
      }
    }
  }
  return 0;
}
