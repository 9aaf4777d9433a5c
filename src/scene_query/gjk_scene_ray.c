// Rays against the shapes of a scene.
#include "../scene/gjk_scene_solid.h"
#include "gjk_scene_inquiry.h"

static gjk_status ask_ray(const gjk_scene_inquiry *inquiry, const gjk_scene_view *v, const gjk_scene_part *part,
                          const gjk_collider *on, gjk_cast_result *out) {
  return gjk_scene_ask_ray(v, part, on, inquiry->from, inquiry->to, out);
}

static void start_ray(const gjk_scene_view *v, const gjk_vec3 *from, const gjk_vec3 *to, const gjk_scene_filter *filter,
                      gjk_scene_inquiry *inquiry, gjk_scene_passage *passage) {
  gjk_aabb box;
  inquiry->ask = ask_ray;
  inquiry->collider = NULL;
  inquiry->from = from;
  inquiry->to = to;
  inquiry->margin = 0;
  inquiry->filter = filter;
  box.lower = *from;
  box.upper = *from;
  gjk_scene_passage_start(v, passage, &box, GJK_SCENE_EARLY, from, to);
}

gjk_status gjk_scene_cast_ray(const gjk_scene *scene, const gjk_vec3 *from, const gjk_vec3 *to,
                              const gjk_scene_filter *filter, gjk_scene_hit *hit, gjk_cast_result *result,
                              bool *found) {
  gjk_scene_view v;
  gjk_scene_passage passage;
  gjk_scene_inquiry inquiry;
  const gjk_status status = from == NULL || to == NULL || hit == NULL || result == NULL || found == NULL
                                ? GJK_ERROR_NULL
                                : gjk_scene_view_of(scene, &v);
  if (status != GJK_OK) {
    return status;
  }
  start_ray(&v, from, to, filter, &inquiry, &passage);
  return gjk_scene_find_first(&v, &inquiry, &passage, hit, result, found);
}

gjk_status gjk_scene_cast_ray_all(const gjk_scene *scene, const gjk_vec3 *from, const gjk_vec3 *to,
                                  const gjk_scene_filter *filter, const gjk_scene_hit *after, gjk_scene_hit *hits,
                                  uint32_t capacity, uint32_t *count) {
  gjk_scene_view v;
  gjk_scene_passage passage;
  gjk_scene_inquiry inquiry;
  const gjk_status status = to == NULL ? GJK_ERROR_NULL : gjk_scene_open_query(scene, from, hits, capacity, count, &v);
  if (status != GJK_OK) {
    return status;
  }
  gjk_scene_hits c = {hits, capacity, 0, 0, after};
  start_ray(&v, from, to, filter, &inquiry, &passage);
  gjk_scene_find_all(&v, &inquiry, &passage, &c);
  *count = gjk_scene_sort_hits(&c);
  return GJK_OK;
}
