// Sessions of the plane.
#include "plane_names.h"

#include "session.c"
