// The hits of a query, in order.
//
// A query keeps the first hits in order, as many as fit. While there is room, hits are appended. When it is full, hits
// are made a heap with the last one on top, which every hit that comes before it replaces. In the end they are sorted.
#ifndef GJK_SRC_SCENE_HITS_H
#define GJK_SRC_SCENE_HITS_H

#include "../scene/gjk_scene_block.h"

typedef struct gjk_scene_hits {
  gjk_scene_hit *hits;
  uint32_t capacity, kept, found;
  const gjk_scene_hit *after;  // only hits after it count; NULL: all
} gjk_scene_hits;

static inline gjk_scene_hit gjk_scene_hit_of(const gjk_scene_view *v, const gjk_scene_part *p, uint32_t fraction) {
  gjk_scene_hit hit;
  hit.body = gjk_scene_id_of(v, p->body);
  hit.part = p->number;
  hit.fraction = fraction;
  hit.user = v->bodies[p->body].user;
  return hit;
}

// Does hit a come before hit b?
static inline bool gjk_scene_comes_before(const gjk_scene_hit *a, const gjk_scene_hit *b) {
  if (a->fraction != b->fraction) {
    return a->fraction < b->fraction;
  }
  return a->body.slot != b->body.slot ? a->body.slot < b->body.slot : a->part < b->part;
}

// Adds a hit.
void gjk_scene_collect(gjk_scene_hits *c, const gjk_scene_view *v, uint32_t part, uint32_t fraction);

// Puts the hits in order. Returns how many were found.
uint32_t gjk_scene_sort_hits(const gjk_scene_hits *c);

// Checks what queries with hits are given, and finds the arrays of the scene.
gjk_status gjk_scene_open_query(const gjk_scene *scene, const void *question, const gjk_scene_hit *hits,
                                uint32_t capacity, const uint32_t *count, gjk_scene_view *v);

#endif
