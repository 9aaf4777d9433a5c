// What a scene needs for depths.
#include "gjk/penetration.h"
#include "gjk_scene_block.h"

const gjk_scene_details gjk_scene_depth = {gjk_signed_distance, NULL};
