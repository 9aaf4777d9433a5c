// Worlds of the plane.
#include "world_plane.h"

#include "world.c"
