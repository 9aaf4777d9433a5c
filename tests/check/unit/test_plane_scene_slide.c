// The test of move and slide, on scenes of the plane.
#include "scene/plane_names.h"

#define TEST_NAME "plane_scene_slide"
#define SPACE 0

#include "test_scene_slide.c"
