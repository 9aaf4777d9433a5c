// The plane's decision checker with what it calls, as it is shipped, under the contracts of plane.h.
#include "plane_depth.h"
#include "src/plane/gjk2_check.c"
#include "src/plane/gjk2_measure.c"
#include "src/plane/gjk2_outward.c"
#include "src/plane/gjk2_search_frame.c"
