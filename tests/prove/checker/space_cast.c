// The checker of casts in space and what it calls, as they are shipped, under the contracts of space_cast.h.
#include "space_cast.h"
#include "src/motion/gjk_check_cast.c"
#include "src/motion/gjk_spheres.c"
#include "src/motion/gjk_swept.c"
#include "src/motion/gjk_way.c"
