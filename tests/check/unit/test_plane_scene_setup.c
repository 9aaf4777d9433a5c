// The test of what a program forgets to set, on scenes of the plane.
#include "scene/plane_names.h"

#define TEST_NAME "plane_scene_setup"
#define SPACE 0

#include "test_scene_setup.c"
