// Where does the way of a point enter a box?
#ifndef GJK_SRC_SLAB_H
#define GJK_SRC_SLAB_H

#include "gjk_portal.h"

// Is A a box, and B a point? Builds for size leave this shortcut out.
static inline bool gjk_slab_may_find(const gjk_collider *a, const gjk_collider *b) {
  return !GJK_SMALL && GJK_SHAPES >= GJK_SHAPES_BOXES && b->count == 0 && a->count == 3 &&
         a->shape->type->kind == GJK_KIND_AXES && gjk_portal_is_point(b);
}

// Answers as gjk_portal_find, and sets what a report reads of p. It may find another proof of a miss. LIMIT: a tie or
// nearly one, a box far away, or a way of 0, which only gjk_portal_find can tell. Pre: gjk_slab_may_find.
gjk_passage gjk_slab_find(gjk_portal *p, const gjk_collider *a, const gjk_collider *b, const gjk_way *way);

#endif
