// The parts within a distance of a collider.
#include "../arith/gjk_memory.h"
#include "../scene/gjk_scene_part.h"
#include "../scene/gjk_scene_solid.h"
#include "../scene/gjk_scene_tree.h"
#include "gjk_scene_filter.h"
#include "gjk_scene_hits.h"

// Is a part whose box in the tree may be near enough so by its exact box, and by its shape?
static bool part_is_within(const gjk_scene_view *v, const gjk_collider *collider, const gjk_aabb *box, gjk_q16 reach,
                           const gjk_scene_part *p) {
  gjk_collider c;
  gjk_aabb exact;
  gjk_decision decision;
  if (gjk_aabb_gap(box, &p->exact) > (uint32_t)reach) {
    return false;
  }
  gjk_scene_part_now(v, p, &c, &exact);
  if (gjk_aabb_gap(box, &exact) > (uint32_t)reach) {
    return false;
  }
  return gjk_scene_ask_within(v, NULL, p, collider, &c, reach, NULL, &decision) != GJK_OK || decision.yes;
}

gjk_status gjk_scene_query_within(const gjk_scene *scene, const gjk_collider *collider, gjk_q16 reach,
                                  const gjk_scene_filter *filter, const gjk_scene_hit *after, gjk_scene_hit *hits,
                                  uint32_t capacity, uint32_t *count) {
  gjk_scene_view v;
  gjk_scene_walk walk;
  gjk_aabb box;
  gjk_status status = gjk_scene_open_query(scene, collider, hits, capacity, count, &v);
  if (status == GJK_OK) {
    status = gjk_collider_aabb(collider, &box);
  }
  if (status == GJK_OK && reach < 0) {
    status = GJK_ERROR_NEGATIVE;
  }
  if (status != GJK_OK) {
    return status;
  }
  gjk_aabb grown;
  gjk_copy(&grown, &box, sizeof grown);
  gjk_scene_grow(&grown, reach, &collider->centre, 0);
  gjk_scene_hits c = {hits, capacity, 0, 0, after};
  gjk_scene_walk_start(&v, &walk);
  for (;;) {  // ends: the walk takes each node once
    const uint32_t part = gjk_scene_walk_meeting(&v, &walk, &grown);
    if (part == GJK_SCENE_NONE) {
      break;
    }
    if (gjk_scene_accepts(&v, filter, part) && part_is_within(&v, collider, &box, reach, &v.parts[part])) {
      gjk_scene_collect(&c, &v, part, 0);
    }
  }
  *count = gjk_scene_sort_hits(&c);
  return GJK_OK;
}
