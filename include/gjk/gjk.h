// All public headers. A program may include only those that it uses.
#ifndef GJK_GJK_H
#define GJK_GJK_H

#include "gjk/bind.h"
#include "gjk/cast.h"
#include "gjk/check.h"
#include "gjk/collider.h"
#include "gjk/compound.h"
#include "gjk/concave.h"
#include "gjk/contacts.h"
#include "gjk/distance.h"
#include "gjk/format.h"
#include "gjk/hash.h"
#include "gjk/height_field.h"
#include "gjk/hull.h"
#include "gjk/impact.h"
#include "gjk/intersect.h"
#include "gjk/joint.h"
#include "gjk/mass.h"
#include "gjk/math.h"
#include "gjk/mesh.h"
#include "gjk/number.h"
#include "gjk/parts.h"
#include "gjk/penetration.h"
#include "gjk/pose.h"
#include "gjk/scene.h"
#include "gjk/shape.h"
#include "gjk/status.h"
#include "gjk/surface.h"
#include "gjk/table.h"
#include "gjk/version.h"

#endif
