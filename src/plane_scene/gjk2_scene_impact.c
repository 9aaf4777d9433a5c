// Parts on their way, in the plane: the source that space has, under the plane's names.
#include "gjk2_scene_names.h"

#include "../scene_update/gjk_scene_impact.c"
