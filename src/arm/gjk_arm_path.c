// A path of edges: how many of the first are free.
#include "gjk/arm.h"

gjk_status gjk_arm_path(gjk_arm *arm, const int32_t *path, unsigned count, const gjk_arm_setup *setup, uint32_t tests,
                        unsigned *edges, gjk_arm_edge_result *out) {
  if (arm == NULL || path == NULL || edges == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  if (count < 2) {
    return GJK_ERROR_EMPTY;
  }
  for (unsigned i = 0; i + 1 < count; i++) {
    const int32_t *from = path + (size_t)i * arm->value_count;
    gjk_status status = gjk_arm_edge_start(arm, from, from + arm->value_count, setup, NULL, NULL);
    if (status == GJK_OK) {
      status = gjk_arm_edge_run(arm, tests, out);
    }
    if (status != GJK_OK && status != GJK_ERROR_ITERATION_LIMIT) {
      return status;
    }
    *edges = i + (out->answer == GJK_ARM_FREE ? 1u : 0u);
    if (out->answer != GJK_ARM_FREE) {
      return status;
    }
  }
  return GJK_OK;
}
