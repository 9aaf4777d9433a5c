// The reference in float.
#define REFERENCE_REAL float
#define REFERENCE_NAME(name) reference_float_##name
#include "reference.c"
