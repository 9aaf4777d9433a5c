// All public headers of the plane. A program may include only those that it uses.
#ifndef GJK2_GJK2_H
#define GJK2_GJK2_H

#include "gjk/number.h"
#include "gjk/status.h"
#include "gjk/version.h"
#include "gjk2/bind.h"
#include "gjk2/cache.h"
#include "gjk2/cast.h"
#include "gjk2/certificate.h"
#include "gjk2/chain.h"
#include "gjk2/check.h"
#include "gjk2/collider.h"
#include "gjk2/contacts.h"
#include "gjk2/distance.h"
#include "gjk2/draw.h"
#include "gjk2/format.h"
#include "gjk2/ground.h"
#include "gjk2/hull.h"
#include "gjk2/impact.h"
#include "gjk2/intersect.h"
#include "gjk2/joint.h"
#include "gjk2/mass.h"
#include "gjk2/math.h"
#include "gjk2/penetration.h"
#include "gjk2/polygon.h"
#include "gjk2/pose.h"
#include "gjk2/probe.h"
#include "gjk2/scene.h"
#include "gjk2/shape.h"
#include "gjk2/slide.h"

#endif
