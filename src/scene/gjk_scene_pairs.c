// The pairs of a scene: made, matched to the boxes, dropped.
//
// Each part has a list of its pairs, and each pair is in the lists of its two parts. See gjk_scene_linked_pair.
#include "gjk_scene_pairs.h"

#include "../arith/gjk_memory.h"
#include "gjk_scene_part.h"
#include "gjk_scene_tree.h"

static uint32_t next_of(const gjk_scene_view *v, uint32_t link) {
  return gjk_scene_next(&v->pairs[link / 2], link % 2);
}

// Puts one side of a pair at the front of its part's list.
static void link_side(gjk_scene_view *v, uint32_t link) {
  gjk_scene_pair *pair = &v->pairs[link / 2];
  const uint32_t at = gjk_scene_end(pair, link % 2);
  //@ assert at < v->header->parts.capacity;
  gjk_scene_part *part = &v->parts[at];
  const uint32_t next = part->pairs;
  gjk_scene_set_next(pair, link % 2, next);
  gjk_scene_set_previous(pair, link % 2, GJK_SCENE_NONE);
  if (next != GJK_SCENE_NONE) {
    gjk_scene_set_previous(&v->pairs[next / 2], next % 2, link);
  }
  part->pairs = GJK_SCENE_INDEX(link);
}

static void unlink_side(gjk_scene_view *v, uint32_t link) {
  const gjk_scene_pair *pair = &v->pairs[link / 2];
  const uint32_t next = gjk_scene_next(pair, link % 2), previous = gjk_scene_previous(pair, link % 2);
  const uint32_t part = gjk_scene_end(pair, link % 2);
  //@ assert next == GJK_SCENE_NONE || next < 2 * v->header->pairs.capacity;
  //@ assert previous == GJK_SCENE_NONE || previous < 2 * v->header->pairs.capacity;
  //@ assert part < v->header->parts.capacity;
  if (previous == GJK_SCENE_NONE) {
    v->parts[part].pairs = GJK_SCENE_INDEX(next);
  } else {
    gjk_scene_set_next(&v->pairs[previous / 2], previous % 2, next);
  }
  if (next != GJK_SCENE_NONE) {
    gjk_scene_set_previous(&v->pairs[next / 2], next % 2, previous);
  }
}

static void unlink(gjk_scene_view *v, uint32_t index) {
  unlink_side(v, 2 * index);
  unlink_side(v, 2 * index + 1);
}

bool gjk_scene_pair_stays(const gjk_scene_view *v, const gjk_scene_pair *pair) {
  const uint32_t at_a = gjk_scene_end(pair, 0), at_b = gjk_scene_end(pair, 1);
  //@ assert at_a < v->header->parts.capacity && at_b < v->header->parts.capacity;
  const gjk_scene_part *a = &v->parts[at_a], *b = &v->parts[at_b];
  return (pair->state & GJK_SCENE_PAIR_NEAR) != 0 ||
         (gjk_aabb_meet(&a->enlarged, &b->enlarged) && gjk_scene_may_pair(&v->bodies[a->body], &v->bodies[b->body]));
}

// Makes a pair of two parts of different bodies, about which nothing is known. Poses both. Pre: there is room for it.
static void make_pair(gjk_scene_view *v, uint32_t a, uint32_t b) {
  gjk_scene_part_settle(v, a);
  gjk_scene_part_settle(v, b);
  const uint32_t index = gjk_scene_pool_take(v, &v->header->pairs, sizeof(gjk_scene_pair));
  gjk_scene_pair *pair = &v->pairs[index];
  const unsigned side = v->parts[a].body > v->parts[b].body ? 1 : 0;
  gjk_scene_set_end(pair, side, a);
  gjk_scene_set_end(pair, 1 - side, b);
  pair->gap = 0;
  gjk_scene_clear_hint(pair);
  pair->state = GJK_SCENE_PAIR_LIVE;
  pair->outcome = GJK_SCENE_PENDING;
  if (v->caches != NULL) {
    gjk_zero(&v->caches[index], sizeof v->caches[index]);
  }
  link_side(v, 2 * index);
  link_side(v, 2 * index + 1);
}

void gjk_scene_pair_drop(gjk_scene_view *v, uint32_t index) {
  unlink(v, index);
  v->pairs[index].state = 0;
  gjk_scene_pool_give(v, &v->header->pairs, sizeof(gjk_scene_pair), index);
}

// Makes a linked pair that is near one that is gone.
static void make_gone(gjk_scene_view *v, uint32_t index) {
  gjk_scene_pair *pair = &v->pairs[index];
  unlink(v, index);
  gjk_scene_side side[2];
  for (unsigned i = 0; i < 2; i++) {
    side[i] = gjk_scene_linked_side(v, pair, i);
  }
  gjk_scene_set_gone(pair, side, v->header->gone);
  pair->state = GJK_SCENE_PAIR_LIVE | GJK_SCENE_PAIR_NEAR | GJK_SCENE_PAIR_GONE;
  v->header->gone = index;
}

void gjk_scene_pairs_forget(gjk_scene_view *v, uint32_t part) {
  // Ends: each turn takes one pair out of the list.
  for (uint32_t link = v->parts[part].pairs; link != GJK_SCENE_NONE; link = v->parts[part].pairs) {
    const uint32_t index = link / 2;
    if ((v->pairs[index].state & GJK_SCENE_PAIR_NEAR) != 0) {
      make_gone(v, index);
    } else {
      gjk_scene_pair_drop(v, index);
    }
  }
}

// Drops the pairs of a part that need not be there.
static void drop_pairs_of(gjk_scene_view *v, uint32_t part) {
  uint32_t next;
  for (uint32_t link = v->parts[part].pairs; link != GJK_SCENE_NONE; link = next) {
    next = next_of(v, link);
    if (!gjk_scene_pair_stays(v, &v->pairs[link / 2])) {
      gjk_scene_pair_drop(v, link / 2);
    }
  }
}

// Marks the parts that a part has pairs with, or removes the marks.
static void mark_partners(gjk_scene_view *v, uint32_t part, bool set) {
  for (uint32_t link = v->parts[part].pairs; link != GJK_SCENE_NONE; link = next_of(v, link)) {
    const uint32_t at = gjk_scene_end(&v->pairs[link / 2], 1 - link % 2);
    //@ assert at < v->header->parts.capacity;
    gjk_scene_part *partner = &v->parts[at];
    partner->state = (uint8_t)(set ? partner->state | GJK_SCENE_MARK : partner->state & ~GJK_SCENE_MARK);
  }
}

// Makes the pairs of a part that must be there and are not. CAPACITY: some of them do not fit.
static gjk_status make_pairs_of(gjk_scene_view *v, uint32_t part) {
  const gjk_scene_part *p = &v->parts[part];
  const gjk_scene_body *body = &v->bodies[p->body];
  gjk_scene_header *h = v->header;
  gjk_scene_walk walk;
  gjk_status status = GJK_OK;
  mark_partners(v, part, true);
  gjk_scene_walk_start(v, &walk);
  uint32_t other = gjk_scene_walk_meeting(v, &walk, &p->enlarged);
  while (other != GJK_SCENE_NONE && status == GJK_OK) {  // ends: the walk takes each node once
    const gjk_scene_part *q = &v->parts[other];
    const bool partner = q->body == p->body || (q->state & GJK_SCENE_MARK) != 0;
    if (!partner && !gjk_scene_may_pair(body, &v->bodies[q->body])) {
      h->refused++;
    } else if (!partner && h->pairs.count == h->pairs.capacity) {
      status = GJK_ERROR_CAPACITY;
    } else if (!partner) {
      make_pair(v, part, other);
    }
    other = gjk_scene_walk_meeting(v, &walk, &p->enlarged);
  }
  mark_partners(v, part, false);
  return status;
}

// Makes the pairs that must be there and are not. Only parts with stale pairs can lack one.
static gjk_status make_missing_pairs(gjk_scene_view *v) {
  for (uint32_t slot = v->header->moved; slot != GJK_SCENE_NONE; slot = v->bodies[slot].next_moved) {
    for (uint32_t i = v->bodies[slot].first; i != GJK_SCENE_NONE; i = v->parts[i].next) {
      if ((v->parts[i].state & GJK_SCENE_PAIRS_STALE) != 0) {
        const gjk_status status = make_pairs_of(v, i);
        if (status != GJK_OK) {
          return status;
        }
        v->parts[i].state = (uint8_t)(v->parts[i].state & ~GJK_SCENE_PAIRS_STALE);
      }
    }
  }
  return GJK_OK;
}

// Shrinks all boxes to what they must hold, and drops the pairs that need not be there then.
static void shrink_all_boxes(gjk_scene_view *v) {
  const gjk_scene_header *h = v->header;
  for (uint32_t i = 0; i < h->parts.fresh; i++) {
    if ((v->parts[i].state & GJK_SCENE_LIVE) != 0) {
      gjk_scene_part_shrink_box(v, i);
    }
  }
  for (uint32_t i = 0; i < h->pairs.fresh; i++) {
    const gjk_scene_pair *pair = &v->pairs[i];
    if ((pair->state & (GJK_SCENE_PAIR_LIVE | GJK_SCENE_PAIR_GONE)) == GJK_SCENE_PAIR_LIVE &&
        !gjk_scene_pair_stays(v, pair)) {
      gjk_scene_pair_drop(v, i);
    }
  }
}

// Poses the parts with pairs that moved. Drops the pairs that need not be there: only parts with stale pairs can have
// one. Is there such a part?
static bool settle_moved_parts(gjk_scene_view *v) {
  bool stale = false;
  for (uint32_t slot = v->header->moved; slot != GJK_SCENE_NONE; slot = v->bodies[slot].next_moved) {
    for (uint32_t i = v->bodies[slot].first; i != GJK_SCENE_NONE; i = v->parts[i].next) {
      const unsigned state = v->parts[i].state;
      if ((state & GJK_SCENE_PAIRS_STALE) != 0) {
        drop_pairs_of(v, i);
        stale = true;
      }
      if ((state & GJK_SCENE_UNPOSED) != 0 && v->parts[i].pairs != GJK_SCENE_NONE) {
        gjk_scene_part_settle(v, i);
      }
    }
  }
  return stale;
}

// Boxes in the tree are larger than needed, by an amount that depends on how bodies came to where they are. Whether
// there is room must not depend on that. So where pairs do not fit, the least boxes at these poses decide.
gjk_status gjk_scene_pairs_match(gjk_scene_view *v) {
  v->header->refused = 0;
  if (!settle_moved_parts(v) || make_missing_pairs(v) == GJK_OK) {
    return GJK_OK;
  }
  shrink_all_boxes(v);
  return make_missing_pairs(v);
}
