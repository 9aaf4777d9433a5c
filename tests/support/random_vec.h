// Random vectors.
#ifndef RANDOM_VEC_H
#define RANDOM_VEC_H

#include "gjk/shape.h"
#include "random.h"

// Each component from -most to most.
static inline gjk_vec3 random_in_cube(random_state *random, int32_t most) {
  gjk_vec3 v;
  v.x = random_range(random, -most, most);
  v.y = random_range(random, -most, most);
  v.z = random_range(random, -most, most);
  return v;
}

#endif
