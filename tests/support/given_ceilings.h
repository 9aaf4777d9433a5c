// The library's ceilings as numbers that a program takes from its environment, so that one build serves all of them: it is
// included before each source, with -include. In #if, where names count as 0, each ceiling is 1.
#ifndef GIVEN_CEILINGS_H
#define GIVEN_CEILINGS_H

// One less than GJK_TEST_ITERATIONS, GJK_TEST_CAST_ITERATIONS and GJK_TEST_ROUNDS; without these, than the usual ceilings.
extern int given_iterations, given_cast_iterations, given_rounds, given_plane_rounds;

#define GJK_ITERATIONS_MAX (given_iterations + 1)
#define GJK_CAST_ITERATIONS_MAX (given_cast_iterations + 1)
#define GJK_ADVANCE_ROUNDS_MAX (given_rounds + 1)
#define GJK2_ADVANCE_ROUNDS_MAX (given_plane_rounds + 1)
#define CEILINGS_OPEN_CASTS (given_rounds < 63)

#endif
