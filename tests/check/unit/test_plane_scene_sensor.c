// The test of sensors, on scenes of the plane.
#include "scene/plane_names.h"

#define TEST_NAME "plane_scene_sensor"
#define SPACE 0

#include "test_scene_sensor.c"
