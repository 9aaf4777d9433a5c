// The hits of a query, in the plane: the source that space has, under the plane's names.
#include "gjk2_scene_names.h"

#include "../scene_query/gjk_scene_hits.c"
