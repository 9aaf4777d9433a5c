// The test of small fast bodies, on scenes of the plane.
#include "scene/plane_names.h"

#define TEST_NAME "plane_scene_bullets"
#define SPACE 0

#include "test_scene_bullets.c"
