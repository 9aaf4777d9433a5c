// The concave parts of a scene, for debug drawing.
#include "gjk/concave.h"
#include "gjk/draw.h"

gjk_status gjk_draw_scene_concave(const gjk_draw *draw, const gjk_scene *scene, const gjk_aabb *near, uint32_t most,
                                  gjk_draw_role role, uint32_t *drawn) {
  gjk_body_id id;
  uint32_t slot = 0, count = 0;
  bool left = false;
  if (draw == NULL) {
    return GJK_ERROR_NULL;
  }
  if (near != NULL &&
      (near->lower.x > near->upper.x || near->lower.y > near->upper.y || near->lower.z > near->upper.z)) {
    return GJK_ERROR_RANGE;
  }
  gjk_status status = gjk_scene_body_at(scene, slot, &id);
  for (; status == GJK_OK; status = gjk_scene_body_at(scene, ++slot, &id)) {  // ends: slots do
    gjk_body_state state;
    if (id.generation == 0 || gjk_scene_get(scene, id, &state) != GJK_OK) {
      continue;
    }
    for (unsigned part = 0; part < state.part_count; part++) {
      gjk_parts parts;
      uint32_t of_part = 0;
      if (gjk_scene_parts(scene, id, (uint16_t)part, &parts) == GJK_OK) {
        left = gjk_draw_parts(draw, &parts, near, most - count, role, &of_part) == GJK_ERROR_CAPACITY || left;
        count += of_part;
      }
    }
  }
  if (status != GJK_ERROR_RANGE) {
    return status;
  }
  if (drawn != NULL) {
    *drawn = count;
  }
  return left ? GJK_ERROR_CAPACITY : GJK_OK;
}
