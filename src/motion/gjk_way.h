// The way of a cast: how two colliders move in a straight line, both in step.
#ifndef GJK_SRC_WAY_H
#define GJK_SRC_WAY_H

#include "../arith/gjk_vector.h"
#include "gjk/cast.h"

// The colliders stand at the start. At fraction s of the way a vertex w of A - B is at w - s t, so the shapes share a
// point there if s t lies in A - B as it is at the start.
//   centres   int32 at the start and at the end, so on the whole way
//   t         each component below 2^32 in size
typedef struct gjk_way {
  gjk_vec3 end_a, end_b;  // the centres at the end
  gjk_long3 t;            // how far B moves against A: (end_b - b->centre) - (end_a - a->centre)
} gjk_way;

// Sets the way. Statuses: NULL, NEGATIVE, RANGE as of gjk_cast; then nothing is set. Pre: a and b are posed.
gjk_status gjk_way_set(gjk_way *way, const gjk_collider *a, const gjk_collider *b, const gjk_cast_path *path);

#endif
