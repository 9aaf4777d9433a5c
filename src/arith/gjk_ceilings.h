// The ceilings on casts. A build may define lower ones, for tests. They affect answers, so a scene's block states those
// that it was made with.
#ifndef GJK_SRC_CEILINGS_H
#define GJK_SRC_CEILINGS_H

// Iterations of a cast of polytopes without a convex radius or a margin.
#ifndef GJK_CAST_ITERATIONS_MAX
#define GJK_CAST_ITERATIONS_MAX 250
#endif
#if GJK_CAST_ITERATIONS_MAX < 1 || GJK_CAST_ITERATIONS_MAX > 1000
#error "GJK_CAST_ITERATIONS_MAX must be from 1 to 1000"
#endif

// Rounds of any other cast, each a measurement of the gap. Polytopes end before this ceiling (gjk_advance.c). For a
// curved pair GJK_ITERATIONS_MAX also bounds the iterations of all rounds together.
#ifndef GJK_ADVANCE_ROUNDS_MAX
#define GJK_ADVANCE_ROUNDS_MAX 64
#endif
#if GJK_ADVANCE_ROUNDS_MAX < 1 || GJK_ADVANCE_ROUNDS_MAX > 1000
#error "GJK_ADVANCE_ROUNDS_MAX must be from 1 to 1000"
#endif

// The same in the plane.
#ifndef GJK2_ADVANCE_ROUNDS_MAX
#define GJK2_ADVANCE_ROUNDS_MAX 72
#endif
#if GJK2_ADVANCE_ROUNDS_MAX < 1 || GJK2_ADVANCE_ROUNDS_MAX > 1000
#error "GJK2_ADVANCE_ROUNDS_MAX must be from 1 to 1000"
#endif

#endif
