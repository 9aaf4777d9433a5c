// The plane's checker of casts and the way, as they are shipped, under the contracts of plane_cast.h.
#include "plane_cast.h"
#include "src/plane_motion/gjk2_check_cast.c"
#include "src/plane_motion/gjk2_way.c"
