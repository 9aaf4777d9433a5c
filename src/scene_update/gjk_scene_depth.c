// The constant that binds depths to a scene.
#include "../scene/gjk_scene_block.h"
#include "gjk/penetration.h"

const gjk_scene_details gjk_scene_depth = {.signed_distance = gjk_signed_distance, .manifold = NULL};
