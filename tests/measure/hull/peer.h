// Hull builders to compare with.
#ifndef HULL_PEER_H
#define HULL_PEER_H

#include "gjk/hull.h"

#ifdef __cplusplus
extern "C" {
#endif

// What a builder says: 0 vertices where it refuses. faces: merged ones, 0 where it does not merge.
typedef struct hull_count {
  unsigned vertices, faces;
} hull_count;

// Builds a hull of points, count of them.
typedef void hull_builder(const gjk_vec3 *points, unsigned count, hull_count *out);

hull_builder hull_by_gjk, hull_by_qhull, hull_by_cgal;

#ifdef __cplusplus
}
#endif

#endif
