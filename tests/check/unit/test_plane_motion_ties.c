// The test of casts where ties are the rule, in the plane.
#include "gjk2/check.h"
#include "scene/plane_names.h"

#define gjk_check_cast gjk2_check_cast
#define TEST_NAME "plane_motion_ties"
#define SPACE 0

#include "test_cast_ties.c"
