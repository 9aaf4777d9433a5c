// What the code of scenes takes from space about debug drawing.
#ifndef GJK_SRC_SCENE_DRAWING_H
#define GJK_SRC_SCENE_DRAWING_H

#include "gjk/draw.h"

#endif
