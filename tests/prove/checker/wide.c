#include "wide.h"
#include "src/arith/gjk_wide.c"
