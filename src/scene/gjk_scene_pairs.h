// The pairs of a scene: made, matched to the boxes, dropped, and tested.
#ifndef GJK_SRC_SCENE_PAIRS_H
#define GJK_SRC_SCENE_PAIRS_H

#include "gjk_scene_block.h"

// Do kind, category and mask of two bodies let their parts be pairs?
static inline bool gjk_scene_may_pair(const gjk_scene_body *a, const gjk_scene_body *b) {
  const bool both_static = (a->kind_detail & 15u) == GJK_BODY_STATIC && (b->kind_detail & 15u) == GJK_BODY_STATIC;
  return !both_static && (a->category & b->mask) != 0 && (b->category & a->mask) != 0;
}

// Do kinds, category and mask, or the predicate, refuse a pair of two bodies, the lower slot first?
static inline bool gjk_scene_is_refused(const gjk_scene_view *v, uint32_t slot_a, uint32_t slot_b) {
  const gjk_scene_bindings *bindings = &v->scene->bindings;
  const gjk_scene_body *a = &v->bodies[slot_a], *b = &v->bodies[slot_b];
  return !gjk_scene_may_pair(a, b) ||
         (bindings->predicate != NULL && !bindings->predicate(bindings->user, gjk_scene_id_of(v, slot_a), a->user,
                                                              gjk_scene_id_of(v, slot_b), b->user));
}

// Must this pair be there? It must if it was near at the last update. It must if it may be a pair and its enlarged
// boxes meet. Pre: it is not gone.
bool gjk_scene_pair_stays(const gjk_scene_view *v, const gjk_scene_pair *pair);

// Removes a pair that is not gone.
void gjk_scene_pair_drop(gjk_scene_view *v, uint32_t index);

// Drops the pairs of a part that is about to be removed. Those that were near become gone, until their end is reported.
void gjk_scene_pairs_forget(gjk_scene_view *v, uint32_t part);

// Step 2 of an update: makes and drops pairs, so that exactly those that must be there are. CAPACITY: they do not fit
// even with the least boxes. Some are then still to be made, and the next call goes on.
gjk_status gjk_scene_pairs_match(gjk_scene_view *v);

// Step 4 of an update: tests a pair that is queued, unless it is tested. Sets NEAR_NOW, gap and outcome. Writes only to
// the pair's record, so threads may test different pairs at the same time.
void gjk_scene_narrow_phase(const gjk_scene_view *v, gjk_scene_pair *pair);

// Is a queued pair still to be tested?
static inline bool gjk_scene_is_pending(const gjk_scene_pair *pair) {
  return (pair->outcome & ~GJK_SCENE_TOLD) == GJK_SCENE_PENDING;
}

// The detail of a pair: the largest of the configuration's and its two bodies'; TOUCH if one is a sensor.
static inline uint8_t gjk_scene_detail(const gjk_scene_view *v, const gjk_scene_body *a, const gjk_scene_body *b) {
  const uint8_t least = v->header->config.detail;
  const uint8_t first = a->kind_detail >> 4, second = b->kind_detail >> 4;
  const uint8_t more = first > second ? first : second;
  if (more == GJK_DETAIL_SENSOR) {  // the largest
    return GJK_DETAIL_TOUCH;
  }
  return more > least ? more : least;
}

// Does a near pair of this detail have its distance, or minus its depth, in gap?
static inline bool gjk_scene_wants_distance(uint8_t detail) {
  return detail == GJK_DETAIL_DISTANCE || detail == GJK_DETAIL_DEPTH;
}

// What a report says of one side of a linked pair.
static inline gjk_scene_side gjk_scene_linked_side(const gjk_scene_view *v, const gjk_scene_pair *pair, unsigned side) {
  const uint32_t at = gjk_scene_end(pair, side);
  //@ assert at < v->header->parts.capacity;
  const gjk_scene_part *part = &v->parts[at];
  const gjk_scene_side result = {part->body, v->bodies[part->body].generation, part->number};
  return result;
}

// The same, gone or not.
static inline gjk_scene_side gjk_scene_side_of(const gjk_scene_view *v, const gjk_scene_pair *pair, unsigned side) {
  return (pair->state & GJK_SCENE_PAIR_GONE) != 0 ? gjk_scene_gone_side(pair, side)
                                                  : gjk_scene_linked_side(v, pair, side);
}

#endif
