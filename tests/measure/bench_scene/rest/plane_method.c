// The library as a method, in the plane.
#include "scene/plane_names.h"

#define REST_OF_PLANE
#define REST_METHOD(kind) rest_gjk2_##kind
#define REST_NAME(kind) "gjk2: " kind
#define REST_PLANE true

#include "method.c"
