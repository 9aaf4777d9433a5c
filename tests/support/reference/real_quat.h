// Rotations in long double.
#ifndef REAL_QUAT_H
#define REAL_QUAT_H

#include <math.h>

#include "gjk/pose.h"

typedef struct real_quat {
  long double x, y, z, w;
} real_quat;

// Of length 1.
static inline real_quat real_quat_of(const gjk_quat *q) {
  const long double x = q->x, y = q->y, z = q->z, w = q->w, length = sqrtl(x * x + y * y + z * z + w * w);
  const real_quat unit = {x / length, y / length, z / length, w / length};
  return unit;
}

static inline real_quat real_quat_product(real_quat a, real_quat b) {
  const real_quat p = {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y + a.y * b.w + a.z * b.x - a.x * b.z,
                       a.w * b.z + a.z * b.w + a.x * b.y - a.y * b.x, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
  return p;
}

#endif
