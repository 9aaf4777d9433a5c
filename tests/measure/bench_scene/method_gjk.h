// The library as a method.
#ifndef BENCH_SCENE_METHOD_GJK_H
#define BENCH_SCENE_METHOD_GJK_H

#include "gjk/scene.h"
#include "method.h"

// Of the last tick of scene_gjk_whole.
gjk_scene_stats method_gjk_stats(void *world);

#endif
