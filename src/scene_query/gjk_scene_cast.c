// Casts of a collider against the shapes of a scene.
#include "../arith/gjk_memory.h"
#include "../scene/gjk_scene_solid.h"
#include "../scene/gjk_scene_tree.h"
#include "gjk_scene_filter.h"
#include "gjk_scene_inquiry.h"

static gjk_status ask_cast(const gjk_scene_inquiry *inquiry, const gjk_scene_view *v, const gjk_scene_part *part,
                           const gjk_collider *on, gjk_cast_result *out) {
  const gjk_cast_path path = {NULL, inquiry->to, inquiry->margin};
  return gjk_scene_ask_cast(v, part, on, inquiry->collider, &path, out);
}

// Does a coordinate of the centre stay in int32 while the position goes from one place to another?
static bool stays(int32_t centre, int32_t from, int32_t to) {
  const int64_t end = (int64_t)centre - from + to;
  return end >= INT32_MIN && end <= INT32_MAX;
}

static bool is_in_range(const gjk_collider *c, const gjk_vec3 *to) {
  return stays(c->centre.x, c->position.x, to->x) && stays(c->centre.y, c->position.y, to->y)
#if GJK_SCENE_AXES == 3
         && stays(c->centre.z, c->position.z, to->z)
#endif
      ;
}

void gjk_scene_look_round(const gjk_scene_view *v, const gjk_scene_filter *filter, gjk_scene_vicinity *near) {
  gjk_scene_walk walk;
  near->count = 0;
  gjk_scene_walk_start(v, &walk);
  for (;;) {  // ends: each part comes once
    const uint32_t part = gjk_scene_walk_meeting(v, &walk, &near->box);
    near->whole = part == GJK_SCENE_NONE;
    if (near->whole) {
      return;
    }
    if (gjk_aabb_meet(&near->box, &v->parts[part].exact) && gjk_scene_may_accept(v, filter, part)) {
      if (near->count == GJK_SCENE_NEAR) {
        return;
      }
      near->part[near->count++] = part;
    }
  }
}

// Starts a passage. near: NULL: of no vicinity.
static void start_passage(const gjk_scene_view *v, const gjk_scene_vicinity *near, const gjk_aabb *box,
                          const gjk_scene_inquiry *inquiry, gjk_scene_passage *passage) {
  const int64_t grow = (int64_t)inquiry->margin + GJK_SCENE_EARLY;
  if (near != NULL && near->whole) {
    gjk_aabb swept;
    gjk_vec3 way;
    gjk_copy(&swept, box, sizeof swept);
    gjk_scene_way(inquiry->from, inquiry->to, &way);
    gjk_scene_grow(&swept, (int32_t)grow, &way, 1);
    if (gjk_aabb_inside(&swept, &near->box)) {
      gjk_scene_passage_start_among(v, passage, box, grow, inquiry->from, inquiry->to, near->part, near->count);
      return;
    }
  }
  gjk_scene_passage_start(v, passage, box, grow, inquiry->from, inquiry->to);
}

static gjk_status start_cast(const gjk_scene_view *v, const gjk_scene_vicinity *near, const gjk_collider *collider,
                             const gjk_vec3 *to, gjk_q16 margin, const gjk_scene_filter *filter,
                             gjk_scene_inquiry *inquiry, gjk_scene_passage *passage) {
  gjk_aabb box;
  const gjk_status status = gjk_collider_aabb(collider, &box);
  if (status != GJK_OK) {
    return status;
  }
  if (margin < 0) {
    return GJK_ERROR_NEGATIVE;
  }
  if (!is_in_range(collider, to)) {
    return GJK_ERROR_RANGE;
  }
  inquiry->ask = ask_cast;
  inquiry->collider = collider;
  inquiry->from = &collider->position;
  inquiry->to = to;
  inquiry->margin = margin;
  inquiry->filter = filter;
  start_passage(v, near, &box, inquiry, passage);
  return GJK_OK;
}

gjk_status gjk_scene_cast_near(const gjk_scene *scene, const gjk_scene_vicinity *near, const gjk_collider *collider,
                               const gjk_vec3 *to, gjk_q16 margin, const gjk_scene_filter *filter, gjk_scene_hit *hit,
                               gjk_cast_result *result, bool *found) {
  gjk_scene_view v;
  gjk_scene_passage passage;
  gjk_scene_inquiry inquiry;
  gjk_status status =
      to == NULL || hit == NULL || result == NULL || found == NULL ? GJK_ERROR_NULL : gjk_scene_view_of(scene, &v);
  if (status == GJK_OK) {
    status = start_cast(&v, near, collider, to, margin, filter, &inquiry, &passage);
  }
  return status == GJK_OK ? gjk_scene_find_first(&v, &inquiry, &passage, hit, result, found) : status;
}

gjk_status gjk_scene_cast(const gjk_scene *scene, const gjk_collider *collider, const gjk_vec3 *to, gjk_q16 margin,
                          const gjk_scene_filter *filter, gjk_scene_hit *hit, gjk_cast_result *result, bool *found) {
  return gjk_scene_cast_near(scene, NULL, collider, to, margin, filter, hit, result, found);
}

gjk_status gjk_scene_cast_all(const gjk_scene *scene, const gjk_collider *collider, const gjk_vec3 *to, gjk_q16 margin,
                              const gjk_scene_filter *filter, const gjk_scene_hit *after, gjk_scene_hit *hits,
                              uint32_t capacity, uint32_t *count) {
  gjk_scene_view v;
  gjk_scene_passage passage;
  gjk_scene_inquiry inquiry;
  gjk_status status = to == NULL ? GJK_ERROR_NULL : gjk_scene_open_query(scene, collider, hits, capacity, count, &v);
  if (status == GJK_OK) {
    status = start_cast(&v, NULL, collider, to, margin, filter, &inquiry, &passage);
  }
  if (status != GJK_OK) {
    return status;
  }
  gjk_scene_hits c = {hits, capacity, 0, 0, after};
  gjk_scene_find_all(&v, &inquiry, &passage, &c);
  *count = gjk_scene_sort_hits(&c);
  return GJK_OK;
}
