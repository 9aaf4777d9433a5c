// What the code of scenes takes from space about motion: casts, impacts, and the scene's own calls made of them.
#ifndef GJK_SRC_SCENE_TRAVEL_H
#define GJK_SRC_SCENE_TRAVEL_H

#include "gjk/impact.h"
#include "gjk/slide.h"

#endif
