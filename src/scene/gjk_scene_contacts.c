// The manifolds of a pair, and the constant that binds contacts to a scene.
#include "gjk/contacts.h"
#include "gjk_scene_concave.h"
#include "gjk_scene_part.h"

// One side of a reported pair.
typedef struct reported_side {
  gjk_collider collider;
  gjk_pose pose;
  gjk_q16 margin;
} reported_side;

static gjk_status set_reported_side(const gjk_scene_view *v, gjk_body_id id, uint16_t number, reported_side *out) {
  gjk_scene_body *body;
  const gjk_status status = gjk_scene_body_of(v, id, &body);
  if (status != GJK_OK) {
    return status;
  }
  const uint32_t index = gjk_scene_part_of(v, body, number);
  if (index == GJK_SCENE_NONE) {
    return GJK_ERROR_RANGE;
  }
  gjk_scene_pose_of(body, &out->pose);
  (void)gjk_scene_part_at(v, &v->parts[index], &out->pose, &out->collider);  // cannot fail: the body was taken there
  gjk_scene_part_pose(v, &v->parts[index], &out->pose);
  out->margin = body->margin;
  return GJK_OK;
}

gjk_status gjk_scene_manifolds(const gjk_scene *scene, const gjk_report *report, unsigned most, gjk_manifold *out,
                               unsigned capacity, unsigned *count) {
  gjk_scene_view v;
  reported_side a, b;
  gjk_workspace workspace;
  gjk_status status = report == NULL || out == NULL || count == NULL ? GJK_ERROR_NULL : gjk_scene_view_of(scene, &v);
  status = status == GJK_OK ? set_reported_side(&v, report->a, report->part_a, &a) : status;
  status = status == GJK_OK ? set_reported_side(&v, report->b, report->part_b, &b) : status;
  if (status != GJK_OK) {
    return status;
  }
  if (!gjk_scene_workspace(scene, &workspace)) {
    return GJK_ERROR_UNSUPPORTED;
  }
  if (capacity < 1 || capacity > GJK_PARTS_MANIFOLDS_MAX) {
    return GJK_ERROR_RANGE;
  }
  const gjk_q16 margin = a.margin + b.margin;
  const struct gjk_scene_concave *queries = a.collider.shape->type->concave;
  queries = queries != NULL ? queries : b.collider.shape->type->concave;
  if (queries != NULL) {
    const gjk_scene_solid of_a = {&a.collider, &a.pose}, of_b = {&b.collider, &b.pose};
    return queries->manifolds(&of_a, &of_b, margin, most, &workspace, out, capacity, count);
  }
  status = gjk_contacts(&a.collider, &b.collider, margin, most, NULL, &workspace, out);
  if (status == GJK_OK || status == GJK_ERROR_CAPACITY) {
    *count = out->count > 0;
  }
  return status;
}

gjk_status gjk_scene_manifold(const gjk_scene *scene, const gjk_report *report, unsigned most, gjk_manifold *out) {
  unsigned count = 0;
  const gjk_status status = gjk_scene_manifolds(scene, report, most, out, 1, &count);
  if (count == 0 && (status == GJK_OK || status == GJK_ERROR_CAPACITY)) {
    out->count = 0;
  }
  return status;
}

const gjk_scene_details gjk_scene_contacts = {.signed_distance = gjk_signed_distance, .manifold = gjk_scene_manifold};
