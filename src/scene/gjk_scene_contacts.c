// The manifold of a pair, and the constant that binds contacts to a scene.
#include "gjk/contacts.h"
#include "gjk_scene_block.h"

gjk_status gjk_scene_manifold(const gjk_scene *scene, const gjk_report *report, unsigned most, gjk_manifold *out) {
  gjk_collider a, b;
  gjk_body_state of_a, of_b;
  gjk_workspace workspace;
  if (report == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  gjk_status status = gjk_scene_collider(scene, report->a, report->part_a, &a);
  if (status == GJK_OK) {
    status = gjk_scene_collider(scene, report->b, report->part_b, &b);
  }
  if (status != GJK_OK) {
    return status;
  }
  if (!gjk_scene_workspace(scene, &workspace)) {
    return GJK_ERROR_UNSUPPORTED;
  }
  (void)gjk_scene_get(scene, report->a, &of_a);  // cannot fail: gjk_scene_collider found both
  (void)gjk_scene_get(scene, report->b, &of_b);
  return gjk_contacts(&a, &b, of_a.margin + of_b.margin, most, NULL, &workspace, out);
}

const gjk_scene_details gjk_scene_contacts = {.signed_distance = gjk_signed_distance, .manifold = gjk_scene_manifold};
