// The test of rays, casts and distances against shapes, on scenes of the plane.
#include "scene/plane_names.h"
#include "scene/world.h"

#define TEST_NAME "plane_scene_motion"
#define WORLD_OF_PLANE

#include "test_scene_motion.c"
