// The test of parts that run along arcs, on scenes of the plane.
#include "scene/plane_names.h"

#define TEST_NAME "plane_scene_arc"
#define SPACE 0

#include "test_scene_arc.c"
