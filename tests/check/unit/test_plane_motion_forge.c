// The test of gjk_check_cast and forged results, in the plane.
#include "gjk2/check.h"
#include "scene/plane_names.h"

#define gjk_check_cast gjk2_check_cast
#define TEST_NAME "plane_motion_forge"
#define SPACE 0

#include "test_cast_forge.c"
