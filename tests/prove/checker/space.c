// The checker of decisions, distances and depths of space with what it calls, as it is shipped, under the contracts of depth.h.

// Before the numbers of 192 bits, behind which the provers do not find the lemmas of geometry.
#include "space.h"

#include "depth.h"
#include "src/gjk/gjk_frame.c"
#include "src/gjk/gjk_iteration.c"
#include "src/gjk/gjk_simplex.c"
#include "src/query/gjk_check.c"

// Behind the others, whose obligations the provers find without it.
#include "src/arith/gjk_vector.c"
