// The test of reports that are still, on scenes of the plane.
#include "plane_same.h"
#include "scene/plane_names.h"
#include "scene/world.h"

#define TEST_NAME "plane_scene_still"

#include "test_scene_still.c"
