// The linear scan for the vertex farthest along a direction.
#include "scan.h"

gjk_scan_result gjk_scan(const gjk_vec3 *vertices, uint32_t n, const gjk_vec3 *d, int64_t slack) {
  const int32_t x = d->x, y = d->y, z = d->z;
  const gjk_vec3 *const end = vertices + n;
  const gjk_vec3 *best = vertices;
  int64_t limit = gjk_dot(*vertices, *d) - slack;  // whatever exceeds this may matter
  bool tie = false;
  for (const gjk_vec3 *v = vertices + 1; v != end; v++) {
    int64_t along = gjk_mul32(v->x, x) + gjk_mul32(v->y, y) + gjk_mul32(v->z, z);
    if (along > limit) {
      int64_t lead = along - limit;
      tie = lead <= 2 * slack;
      if (lead > slack) {
        best = v;
        limit = along - slack;
      }
    }
  }
  gjk_scan_result result = {(uint16_t)(best - vertices), tie};
  return result;
}
