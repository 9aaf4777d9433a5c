// A long match in the plane with random inputs, and its hash.
#include "plane_scene_golden.h"

#include "scene/plane_match.h"

#define MATCH_OF_PLANE
#define match plane_match
#define match_input plane_match_input
#define match_start plane_match_start
#define match_tick plane_match_tick
#define match_hash plane_match_hash
#define scene_golden_hash plane_scene_golden_hash

#include "scene_golden.c"
