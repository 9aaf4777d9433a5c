// The test of the caller's words, on scenes of the plane.
#include "scene/plane_names.h"

#define TEST_NAME "plane_scene_words"
#define SPACE 0

#include "test_scene_words.c"
