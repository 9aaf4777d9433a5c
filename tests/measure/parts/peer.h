// Other decompositions into convex parts to compare with.
#ifndef PARTS_PEER_H
#define PARTS_PEER_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

// Points of all parts, for free, three numbers each, and where each part's end.
typedef struct peer_parts {
  double (*point)[3];
  size_t *end;
  size_t parts;
} peer_parts;

typedef struct peer_settings {
  double concavity;  // the most that it may leave, of a mesh whose box's diagonal is 1000
  int more;          // looks at the faces' middles, the neighbours and more points as well
} peer_settings;

// Bullet's HACD. The triangles turn counterclockwise, seen from outside. No parts: it fails.
void parts_by_hacd(const int32_t (*point)[3], size_t points, const uint32_t (*triangle)[3], size_t triangles,
                   const peer_settings *settings, peer_parts *out);

#ifdef __cplusplus
}
#endif

#endif
