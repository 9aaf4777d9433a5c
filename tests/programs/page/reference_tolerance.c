// The reference in double, with a tolerance that the page sets.
#include "lattice.h"

double lattice_tolerance = 1e-30;

#define REFERENCE_ENCLOSING lattice_tolerance
#define REFERENCE_REAL double
#define REFERENCE_NAME(name) lattice_reference_##name
#include "tests/support/reference/reference.c"
