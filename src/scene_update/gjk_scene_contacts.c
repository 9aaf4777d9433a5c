// The manifolds of a pair, and the constant that binds contacts to a scene.
#include "../scene/gjk_scene_concave.h"
#include "../scene/gjk_scene_part.h"
#include "gjk/contacts.h"

// All manifolds of two parts, or those that room is for. Pre: 1 <= capacity <= GJK_PARTS_MANIFOLDS_MAX.
static gjk_status find_scene_manifolds(const gjk_scene_view *v, const gjk_scene_part *a, const gjk_scene_part *b,
                                       unsigned most, gjk_cache *cache, gjk_manifold *out, unsigned capacity,
                                       unsigned *count) {
  gjk_collider on_a, on_b;
  gjk_workspace workspace;
  if (!gjk_scene_workspace(v->scene, &workspace)) {
    return GJK_ERROR_UNSUPPORTED;
  }
  gjk_scene_part_placed(v, a, &on_a);
  gjk_scene_part_placed(v, b, &on_b);
  const gjk_q16 margin = v->bodies[a->body].margin + v->bodies[b->body].margin;
  const struct gjk_scene_concave *queries = on_a.shape->type->concave;
  queries = queries != NULL ? queries : on_b.shape->type->concave;
  if (queries != NULL) {
    gjk_pose at_a, at_b;
    gjk_scene_part_pose(v, a, &at_a);
    gjk_scene_part_pose(v, b, &at_b);
    const gjk_scene_solid of_a = {&on_a, &at_a}, of_b = {&on_b, &at_b};
    return queries->manifolds(&of_a, &of_b, margin, most, &workspace, out, capacity, count);
  }
  const gjk_status status = gjk_contacts(&on_a, &on_b, margin, most, cache, &workspace, out);
  if (status == GJK_OK || status == GJK_ERROR_CAPACITY) {
    *count = out->count > 0;
  }
  return status;
}

// The first of them.
static gjk_status find_manifold(const gjk_scene_view *v, const gjk_scene_part *a, const gjk_scene_part *b,
                                unsigned most, gjk_cache *cache, gjk_manifold *out) {
  unsigned count = 0;
  const gjk_status status = find_scene_manifolds(v, a, b, most, cache, out, 1, &count);
  if (count == 0 && (status == GJK_OK || status == GJK_ERROR_CAPACITY)) {
    out->count = 0;
  }
  return status;
}

// Opens a scene and finds the parts of a report.
static gjk_status open_report(const gjk_scene *scene, const gjk_report *report, gjk_scene_view *v,
                              const gjk_scene_part *parts[2]) {
  gjk_status status = report == NULL ? GJK_ERROR_NULL : gjk_scene_view_of(scene, v);
  status = status == GJK_OK ? gjk_scene_find_part(v, report->a, report->part_a, &parts[0]) : status;
  return status == GJK_OK ? gjk_scene_find_part(v, report->b, report->part_b, &parts[1]) : status;
}

gjk_status gjk_scene_manifolds(const gjk_scene *scene, const gjk_report *report, unsigned most, gjk_manifold *out,
                               unsigned capacity, unsigned *count) {
  gjk_scene_view v;
  const gjk_scene_part *parts[2];
  const gjk_status status = out == NULL || count == NULL ? GJK_ERROR_NULL : open_report(scene, report, &v, parts);
  if (status != GJK_OK) {
    return status;
  }
  if (capacity < 1 || capacity > GJK_PARTS_MANIFOLDS_MAX) {
    return GJK_ERROR_RANGE;
  }
  return find_scene_manifolds(&v, parts[0], parts[1], most, NULL, out, capacity, count);
}

gjk_status gjk_scene_manifold(const gjk_scene *scene, const gjk_report *report, unsigned most, gjk_manifold *out) {
  gjk_scene_view v;
  const gjk_scene_part *parts[2];
  const gjk_status status = out == NULL ? GJK_ERROR_NULL : open_report(scene, report, &v, parts);
  return status == GJK_OK ? find_manifold(&v, parts[0], parts[1], most, NULL, out) : status;
}

const gjk_scene_details gjk_scene_contacts = {.signed_distance = gjk_signed_distance, .manifold = find_manifold};
