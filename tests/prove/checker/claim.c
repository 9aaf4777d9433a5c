// The plane's check of a normal, as it is shipped, under the contracts of claim.h.
#include "claim.h"
#include "src/plane/gjk2_claim.c"
