// What of the tree a box meets on a straight way, in the plane: the source that space has, under the plane's names.
#include "gjk2_scene_names.h"

#include "../scene/gjk_scene_passage.c"
