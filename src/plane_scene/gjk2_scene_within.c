// The parts within a distance of a collider, in the plane: the source that space has, under the plane's names.
#include "gjk2_scene_names.h"

#include "../scene_query/gjk_scene_within.c"
