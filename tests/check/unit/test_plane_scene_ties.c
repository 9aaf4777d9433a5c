// The test of first hits with ties, on scenes of the plane.
#include "scene/plane_names.h"
#include "scene/world.h"

#define TEST_NAME "plane_scene_ties"
#define WORLD_OF_PLANE
#define BOX GJK2_BOX(HALF, HALF)
#define BALL GJK2_CIRCLE(HALF)

#include "test_scene_ties.c"
