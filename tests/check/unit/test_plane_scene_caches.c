// The test of what a block keeps for queries, on scenes of the plane.
#include "plane_same.h"
#include "scene/plane_names.h"
#include "scene/world.h"

#define TEST_NAME "plane_scene_caches"

#include "test_scene_caches.c"
