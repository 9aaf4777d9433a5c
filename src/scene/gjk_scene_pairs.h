// The pairs of a scene: made, matched to the boxes, dropped; and tested.
#ifndef GJK_SRC_SCENE_PAIRS_H
#define GJK_SRC_SCENE_PAIRS_H

#include "gjk_scene_block.h"

// Do kinds and filters of the bodies of two parts let them be a pair?
static inline bool gjk_scene_wanted(const gjk_scene_view *v, const gjk_scene_part *a, const gjk_scene_part *b) {
  const gjk_scene_body *body_a = &v->bodies[a->body], *body_b = &v->bodies[b->body];
  const bool both_static =
      (body_a->kind_detail & 15u) == GJK_BODY_STATIC && (body_b->kind_detail & 15u) == GJK_BODY_STATIC;
  return !both_static && (body_a->category & body_b->mask) != 0 && (body_b->category & body_a->mask) != 0;
}

// Must there be a record of this pair, near or not? Pre: not gone.
bool gjk_scene_pair_stays(const gjk_scene_view *v, const gjk_scene_pair *pair);

void gjk_scene_pair_drop(gjk_scene_view *v, uint32_t index);

// Drops the pairs of a part that is about to go; those that were near become gone, until their end is reported.
void gjk_scene_pairs_forget(gjk_scene_view *v, uint32_t part);

// Makes the pairs those whose enlarged boxes meet, and those that were near. CAPACITY: there is no room even for those that
// meet without box_margin and look-ahead; then some are still to be made, and the next call goes on.
gjk_status gjk_scene_pairs_match(gjk_scene_view *v);

// Tests a pair that is queued, unless that was done: sets NEAR_NOW, gap and outcome. Writes to its record alone.
void gjk_scene_narrow_phase(const gjk_scene_view *v, gjk_scene_pair *pair);

// What is asked of a pair: a gjk_detail.
static inline uint8_t gjk_scene_detail(const gjk_scene_view *v, const gjk_scene_body *a, const gjk_scene_body *b) {
  const uint8_t least = v->header->config.detail;
  const uint8_t first = a->kind_detail >> 4, second = b->kind_detail >> 4;
  const uint8_t more = first > second ? first : second;
  return more > least ? more : least;
}

// Is gap the distance of a pair that is near, or minus its depth?
static inline bool gjk_scene_measures(uint8_t detail) {
  return detail == GJK_DETAIL_DISTANCE || detail == GJK_DETAIL_DEPTH;
}

#endif
