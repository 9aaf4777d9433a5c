// The test of debug drawing, in the plane.
#include "scene/plane_names.h"

#define TEST_NAME "plane_draw"
#define SPACE 0

#include "test_draw.c"
