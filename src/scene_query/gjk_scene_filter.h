// Which parts a query of shapes looks at.
#ifndef GJK_SRC_SCENE_FILTER_H
#define GJK_SRC_SCENE_FILTER_H

#include "../scene/gjk_scene_block.h"

// Does the query look at this part?
static inline bool gjk_scene_accepts(const gjk_scene_view *v, const gjk_scene_filter *filter, uint32_t part) {
  const gjk_scene_part *p = &v->parts[part];
  const gjk_scene_body *body = &v->bodies[p->body];
  if (filter == NULL) {
    return true;
  }
  if ((filter->category & body->mask) == 0 || (body->category & filter->mask) == 0 ||
      (filter->ignore.slot == p->body && filter->ignore.generation == body->generation)) {
    return false;
  }
  return filter->accept == NULL || filter->accept(filter->user, gjk_scene_id_of(v, p->body), body->user, p->number);
}

#endif
