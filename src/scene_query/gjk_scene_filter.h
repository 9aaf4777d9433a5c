// Which parts a query of shapes looks at.
#ifndef GJK_SRC_SCENE_FILTER_H
#define GJK_SRC_SCENE_FILTER_H

#include "../scene/gjk_scene_block.h"

// May the query look at this part, by categories, masks and the body to ignore?
static inline bool gjk_scene_may_accept(const gjk_scene_view *v, const gjk_scene_filter *filter, uint32_t part) {
  const gjk_scene_part *p = &v->parts[part];
  const gjk_scene_body *body = &v->bodies[p->body];
  return filter == NULL || ((filter->category & body->mask) != 0 && (body->category & filter->mask) != 0 &&
                            !(filter->ignore.slot == p->body && filter->ignore.generation == body->generation));
}

// Does the query look at this part?
static inline bool gjk_scene_accepts(const gjk_scene_view *v, const gjk_scene_filter *filter, uint32_t part) {
  const gjk_scene_part *p = &v->parts[part];
  return gjk_scene_may_accept(v, filter, part) &&
         (filter == NULL || filter->accept == NULL ||
          filter->accept(filter->user, gjk_scene_id_of(v, p->body), v->bodies[p->body].user, p->number));
}

#endif
