// The queue of an update: the pairs to be tested.
#include "gjk_scene_update.h"

// Adds a pair at the end of a queue of so many pairs, unless it is in the queue. Returns how many the queue then has.
static uint32_t queue_pair(gjk_scene_view *v, uint32_t index, uint32_t queued) {
  gjk_scene_pair *pair = &v->pairs[index];
  const unsigned state = pair->state;
  if ((state & GJK_SCENE_PAIR_QUEUED) != 0) {
    return queued;
  }
  pair->state = (uint8_t)((state | GJK_SCENE_PAIR_QUEUED) & ~GJK_SCENE_PAIR_NEAR_NOW);
  //@ assert queued < v->header->pairs.capacity;
  pair->outcome = GJK_SCENE_PENDING;
  v->queue[queued] = index;
  return queued + 1;
}

static bool is_moved(const gjk_scene_view *v, uint32_t part) {
  //@ assert part < v->header->parts.capacity;
  return (v->bodies[v->parts[part].body].flags & GJK_SCENE_MOVED) != 0;
}

// What was told of pairs whose bodies did not move still holds.
static uint32_t queue_all(gjk_scene_view *v) {
  uint32_t queued = 0;
  for (uint32_t i = 0; i < v->header->pairs.fresh; i++) {
    gjk_scene_pair *pair = &v->pairs[i];
    if ((pair->state & (GJK_SCENE_PAIR_LIVE | GJK_SCENE_PAIR_GONE)) == GJK_SCENE_PAIR_LIVE) {
      const bool moved = is_moved(v, gjk_scene_end(pair, 0)) || is_moved(v, gjk_scene_end(pair, 1));
      const unsigned told = moved ? 0 : pair->outcome & GJK_SCENE_TOLD;
      queued = queue_pair(v, i, queued);
      pair->outcome = (uint8_t)(pair->outcome | told);
    }
  }
  return queued;
}

static uint32_t queue_moved(gjk_scene_view *v) {
  uint32_t queued = 0;
  for (uint32_t slot = v->header->moved; slot != GJK_SCENE_NONE; slot = v->bodies[slot].next_moved) {
    for (uint32_t i = v->bodies[slot].first; i != GJK_SCENE_NONE; i = v->parts[i].next) {
      uint32_t link = v->parts[i].pairs;
      while (link != GJK_SCENE_NONE) {
        queued = queue_pair(v, link / 2, queued);
        link = gjk_scene_next(&v->pairs[link / 2], link % 2);
      }
    }
  }
  return queued;
}

void gjk_scene_fill_queue(gjk_scene_view *v) {
  gjk_scene_header *h = v->header;
  h->next_test = 0;
  h->queued = h->config.retest_all != 0 ? queue_all(v) : queue_moved(v);
}

void gjk_scene_test_queue(gjk_scene_view *v, uint32_t tests) {
  gjk_scene_header *h = v->header;
  for (; h->next_test < h->queued; h->next_test++) {
    gjk_scene_pair *pair = &v->pairs[v->queue[h->next_test]];
    if (gjk_scene_is_pending(pair)) {
      if (tests == 0) {
        return;
      }
      tests--;
      gjk_scene_narrow_phase(v, pair);
    }
  }
}
