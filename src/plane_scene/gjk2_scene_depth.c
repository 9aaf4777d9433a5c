// The constant that binds depths to a scene of the plane.
#include "gjk2/penetration.h"
#include "gjk2_scene_plane.h"

const gjk2_scene_details gjk2_scene_depth = {.signed_distance = gjk2_signed_distance, .manifold = NULL};
