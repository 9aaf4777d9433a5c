#include "wide.h"
#include "limbs.h"
#include "src/arith/gjk_wide.c"
