// A scene's shapes, boxes and pairs, for debug drawing in the plane: the source that space has, under the plane's names.
#include "gjk2_scene_names.h"

#include "../scene_query/gjk_scene_draw.c"
