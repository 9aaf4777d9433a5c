// The manifold of a pair, and the constant that binds contacts to a scene of the plane.
#include "gjk2/contacts.h"

#include "gjk2_scene_names.h"
// The view of a block, under the plane's names.
#include "../scene/gjk_scene_part.h"
#include "../scene/gjk_scene_solid.h"

static gjk_status plane_manifold(const gjk2_scene_view *v, const gjk2_scene_part *a, const gjk2_scene_part *b,
                                 unsigned most, gjk2_cache *cache, gjk2_manifold *out) {
  gjk2_collider on_a, on_b;
  gjk2_scene_part_placed(v, a, &on_a);
  gjk2_scene_part_placed(v, b, &on_b);
  const gjk_q16 margin = v->bodies[a->body].margin + v->bodies[b->body].margin;
  const struct gjk2_ground_queries *ground = gjk2_scene_ground_of(&on_a, &on_b);
  return ground != NULL ? ground->manifold(v, a, b, &on_a, &on_b, margin, most, out)
                        : gjk2_contacts(&on_a, &on_b, margin, most, cache, out);
}

gjk_status gjk2_scene_manifold(const gjk2_scene *scene, const gjk2_report *report, unsigned most, gjk2_manifold *out) {
  gjk2_scene_view v;
  const gjk2_scene_part *parts[2];
  gjk_status status = report == NULL || out == NULL ? GJK_ERROR_NULL : gjk2_scene_view_of(scene, &v);
  status = status == GJK_OK ? gjk2_scene_find_part(&v, report->a, report->part_a, &parts[0]) : status;
  status = status == GJK_OK ? gjk2_scene_find_part(&v, report->b, report->part_b, &parts[1]) : status;
  return status == GJK_OK ? plane_manifold(&v, parts[0], parts[1], most, NULL, out) : status;
}

const gjk2_scene_details gjk2_scene_contacts = {.signed_distance = gjk2_signed_distance, .manifold = plane_manifold};
