// The test of fast bodies, on scenes of the plane.
#include "scene/plane_names.h"
#include "scene/session.h"

#define TEST_NAME "plane_scene_fast"

#include "test_scene_fast.c"
