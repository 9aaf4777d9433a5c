// The manifold of a pair, and the constant that binds contacts to a scene of the plane.
#include "gjk2/contacts.h"
#include "gjk2_scene_plane.h"

gjk_status gjk2_scene_manifold(const gjk2_scene *scene, const gjk2_report *report, unsigned most, gjk2_manifold *out) {
  gjk2_collider a, b;
  gjk2_body_state of_a, of_b;
  if (report == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  gjk_status status = gjk2_scene_collider(scene, report->a, report->part_a, &a);
  if (status == GJK_OK) {
    status = gjk2_scene_collider(scene, report->b, report->part_b, &b);
  }
  if (status != GJK_OK) {
    return status;
  }
  (void)gjk2_scene_get(scene, report->a, &of_a);  // cannot fail: gjk2_scene_collider found both
  (void)gjk2_scene_get(scene, report->b, &of_b);
  return gjk2_contacts(&a, &b, of_a.margin + of_b.margin, most, NULL, out);
}

const gjk2_scene_details gjk2_scene_contacts = {.signed_distance = gjk2_signed_distance,
                                                .manifold = gjk2_scene_manifold};
