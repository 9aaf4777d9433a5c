// The level of the platform game, in flash: its tiles, and the shapes of all that is in it.
#ifndef PLATFORM_LEVEL_H
#define PLATFORM_LEVEL_H

#include "gjk2/ground.h"

static const uint8_t level[] =
    "########################################"  // the bottom row
    "#     /##\\    /\\             /#\\       #"
    "#     ----                    ---       #";
static const gjk2_tile forms[128] = {
    ['#'] = GJK2_TILE(4, 4), ['/'] = GJK2_TILE(0, 4), ['\\'] = GJK2_TILE(4, 0), ['-'] = GJK2_TILE_ONE_WAY(4, 4)};
static const gjk2_tiles tiles = {level, 40, 3, GJK_Q16(1), 128, forms};
static const gjk2_ground ground = {&gjk2_ground_tiles, &tiles, {GJK_Q16(20), GJK_Q16(1.5)}};
static const gjk2_shape ground_shape = GJK2_GROUND(&ground, GJK_Q16(20), GJK_Q16(1.5));
static const gjk2_shape plank = GJK2_BOX(GJK_Q16(1), GJK_Q16(0.1)), crate = GJK2_BOX(GJK_Q16(0.2), GJK_Q16(0.2));
static const gjk2_shape body = GJK2_CAPSULE(GJK_Q16(0.3), GJK_Q16(0.2));
static const gjk2_shape *const shapes[] = {&ground_shape, &plank, &crate};

#endif
