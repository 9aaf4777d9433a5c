// Contacts, rays and casts, for debug drawing.
#include "../arith/gjk_memory.h"
#include "../scene/gjk_scene_block.h"

#ifndef GJK_SCENE_OF_PLANE
#include "gjk_scene_drawing.h"
#endif

static void mark_point(const gjk_draw *draw, const gjk_vec3 *at, gjk_draw_role role) {
  if (draw->point != NULL) {
    draw->point(draw->user, at, role);
  }
}

static void mark_line(const gjk_draw *draw, const gjk_vec3 *from, const gjk_vec3 *to, gjk_draw_role role) {
  if (draw->line != NULL && !gjk_scene_same_vec3(from, to)) {
    draw->line(draw->user, from, to, role);
  }
}

static void mark_normal(const gjk_draw *draw, const gjk_vec3 *at, const gjk_unit3 *normal, gjk_q16 length) {
  const gjk_vec3 end = gjk_scene_ahead(at, normal, length);
  mark_line(draw, at, &end, GJK_DRAW_NORMAL);
}

gjk_status gjk_draw_manifold(const gjk_draw *draw, const gjk_manifold *manifold, gjk_q16 length) {
  if (draw == NULL || manifold == NULL) {
    return GJK_ERROR_NULL;
  }
  for (unsigned i = 0; i < manifold->count; i++) {
    const gjk_vec3 *a = &manifold->contact[i].point_a, *b = &manifold->contact[i].point_b;
    mark_point(draw, a, GJK_DRAW_CONTACT);
    mark_point(draw, b, GJK_DRAW_CONTACT);
    mark_line(draw, a, b, GJK_DRAW_CONTACT);
    mark_normal(draw, b, &manifold->normal, length);
  }
  return GJK_OK;
}

// Where a result says that a shape is hit.
static void mark_hit(const gjk_draw *draw, const gjk_cast_result *result, gjk_q16 length) {
  if (result->hit && !result->inside) {
    mark_point(draw, &result->point_a, GJK_DRAW_CONTACT);
    mark_normal(draw, &result->point_a, &result->normal, length);
  }
}

gjk_status gjk_draw_ray(const gjk_draw *draw, const gjk_vec3 *from, const gjk_vec3 *to, const gjk_cast_result *result,
                        gjk_q16 length) {
  if (draw == NULL || from == NULL || to == NULL || result == NULL) {
    return GJK_ERROR_NULL;
  }
  mark_line(draw, from, !result->hit ? to : result->inside ? from : &result->point_b, GJK_DRAW_WAY);
  mark_hit(draw, result, length);
  return GJK_OK;
}

gjk_status gjk_draw_cast(const gjk_draw *draw, const gjk_collider *collider, const gjk_vec3 *to,
                         const gjk_cast_result *result, gjk_q16 length) {
  gjk_collider end;
  if (draw == NULL || collider == NULL || to == NULL || result == NULL) {
    return GJK_ERROR_NULL;
  }
  gjk_copy(&end, collider, sizeof end);
  const gjk_status status = gjk_collider_move(&end, result->hit ? &result->rest_b : to);
  if (status != GJK_OK) {
    return status;
  }
  (void)gjk_draw_collider(draw, collider, GJK_DRAW_WAY);  // cannot fail: both are posed
  (void)gjk_draw_collider(draw, &end, GJK_DRAW_WAY);
  mark_line(draw, &collider->position, &end.position, GJK_DRAW_WAY);
  mark_hit(draw, result, length);
  return GJK_OK;
}
