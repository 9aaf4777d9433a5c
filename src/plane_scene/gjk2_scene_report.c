// The reports of an update, in the plane: the source that space has, under the plane's names.
#include "gjk2_scene_names.h"

#include "../scene_update/gjk_scene_report.c"
