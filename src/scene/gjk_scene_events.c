// The events of an update: which of its pairs began to be near, stayed near, or ended, in the order of reports.
#include "../arith/gjk_sort.h"
#include "gjk_scene_update.h"

// Up to so many events are sorted by insertion.
#define FEW 8

// Where at least one in so many bodies, parts and pairs has an event, all are walked. A step of such a walk takes about 8
// instructions; to sort an event takes 20 for each doubling of their number.
#define GATHER 16

static bool is_awake(const gjk_scene_body *body) {
  return (body->kind_detail & 15u) != GJK_BODY_STATIC && (body->flags & GJK_SCENE_ASLEEP) == 0;
}

// Is a pair that stays near to be reported? Pre: config.persist.
static inline bool persists(const gjk_scene_view *v, const gjk_scene_pair *pair) {
  const gjk_scene_body *a = &v->bodies[v->parts[gjk_scene_end(pair, 0)].body];
  const gjk_scene_body *b = &v->bodies[v->parts[gjk_scene_end(pair, 1)].body];
  return (is_awake(a) || is_awake(b)) && !gjk_scene_is_sensor(a) && !gjk_scene_is_sensor(b);
}

// The counter of an outcome: they are in the order of outcomes.
static uint32_t *counter_of(gjk_scene_counters *s, unsigned outcome) {
  uint32_t *words = (uint32_t *)(void *)s;
  return words + offsetof(gjk_scene_counters, filtered) / sizeof *words + (outcome - GJK_SCENE_FILTERED);
}

// Step 5. Pairs that are gone are no pairs of this update.
static void start_stats(gjk_scene_view *v) {
  gjk_scene_header *h = v->header;
  gjk_scene_counters *s = &h->stats;
  s->refused = h->refused;
  s->pairs = h->pairs.count;
  for (uint32_t i = h->gone; i != GJK_SCENE_NONE; i = gjk_scene_gone_next(&v->pairs[i])) {
    //@ assert i < h->pairs.fresh;
    s->pairs--;
  }
  s->resting = s->pairs - h->queued;
  s->filtered = s->motion = s->boxes = s->direction = s->warm = s->cold = 0;
  s->begun = s->persisting = s->ended = s->unsettled = s->measured = s->manifolds = 0;
}

// Adds a pair with its event to the events kept, which overwrite the queue from its start.
static void keep_event(gjk_scene_view *v, uint32_t index, gjk_event event, uint32_t *kept) {
  gjk_scene_counters *s = &v->header->stats;
  uint32_t *counter = event == GJK_EVENT_BEGIN ? &s->begun : event == GJK_EVENT_END ? &s->ended : &s->persisting;
  (*counter)++;
  //@ assert *kept < v->header->pairs.capacity;
  const unsigned told = event == GJK_EVENT_PERSIST ? v->pairs[index].outcome & GJK_SCENE_TOLD : 0;
  v->pairs[index].outcome = (uint8_t)(event | told | GJK_SCENE_LISTED);
  v->queue[(*kept)++] = index;
}

// The words of a pair that begins.
static void clear_words(const gjk_scene_view *v, uint32_t index) {
  uint32_t *words = gjk_scene_words_of(v, index);
  for (uint32_t i = 0; i < v->header->config.pair_words; i++) {
    words[i] = 0;
  }
}

// Step 6, pairs that were tested. Each makes at most one event, so no entry is overwritten before it is read.
//
// With persist, those that are near keep QUEUED, so that keep_resting does not find them again.
static void keep_tested(gjk_scene_view *v, uint32_t *kept) {
  gjk_scene_header *h = v->header;
  for (uint32_t i = 0; i < h->queued; i++) {
    const uint32_t index = v->queue[i];
    gjk_scene_pair *pair = &v->pairs[index];
    const unsigned state = pair->state, outcome = pair->outcome;
    const bool was = (state & GJK_SCENE_PAIR_NEAR) != 0, now = (state & GJK_SCENE_PAIR_NEAR_NOW) != 0;
    const unsigned kind = outcome & (GJK_SCENE_UNSETTLED - 1u);
    //@ assert kind >= GJK_SCENE_FILTERED && kind <= GJK_SCENE_COLD;
    (*counter_of(&h->stats, kind))++;
    h->stats.unsettled += (outcome & GJK_SCENE_UNSETTLED) != 0;
    h->stats.measured += (outcome & GJK_SCENE_MEASURED) != 0;
    pair->state = (uint8_t)((state & ~(GJK_SCENE_PAIR_NEAR | GJK_SCENE_PAIR_QUEUED | GJK_SCENE_PAIR_NEAR_NOW)) |
                            (now ? GJK_SCENE_PAIR_NEAR : 0u));
    if (now && !was) {
      clear_words(v, index);
    }
    if (was != now) {
      keep_event(v, index, now ? GJK_EVENT_BEGIN : GJK_EVENT_END, kept);
    } else if (now && h->config.persist != 0 && persists(v, pair)) {
      keep_event(v, index, GJK_EVENT_PERSIST, kept);
    }
    if (now && h->config.persist != 0) {
      pair->state |= GJK_SCENE_PAIR_QUEUED;
    }
  }
}

// Step 6, with persist: pairs that rest near.
static void keep_resting(gjk_scene_view *v, uint32_t *kept) {
  const gjk_scene_header *h = v->header;
  for (uint32_t i = 0; h->config.persist != 0 && i < h->pairs.fresh; i++) {
    gjk_scene_pair *pair = &v->pairs[i];
    const unsigned flags = pair->state & (GJK_SCENE_PAIR_LIVE | GJK_SCENE_PAIR_NEAR | GJK_SCENE_PAIR_GONE);
    if (flags == (GJK_SCENE_PAIR_LIVE | GJK_SCENE_PAIR_NEAR) && (pair->state & GJK_SCENE_PAIR_QUEUED) == 0 &&
        persists(v, pair)) {
      keep_event(v, i, GJK_EVENT_PERSIST, kept);
    }
    pair->state = (uint8_t)(pair->state & ~GJK_SCENE_PAIR_QUEUED);
  }
}

// Step 6, pairs that are gone: all of them were near.
static void keep_gone(gjk_scene_view *v, uint32_t *kept) {
  gjk_scene_header *h = v->header;
  for (uint32_t i = h->gone; i != GJK_SCENE_NONE; i = gjk_scene_gone_next(&v->pairs[i])) {
    //@ assert i < h->pairs.fresh;
    keep_event(v, i, GJK_EVENT_END, kept);
  }
  h->gone = GJK_SCENE_NONE;
}

// Step 7. Every pair of a moved body is tested, so motion counts from these poses on.
static void forget_motion(gjk_scene_view *v) {
  gjk_scene_header *h = v->header;
  for (uint32_t slot = h->moved; slot != GJK_SCENE_NONE; slot = v->bodies[slot].next_moved) {
    gjk_scene_body *body = &v->bodies[slot];
    body->flags = (uint8_t)(body->flags & ~GJK_SCENE_MOVED);
    for (uint32_t i = body->first; i != GJK_SCENE_NONE; i = v->parts[i].next) {
      v->parts[i].motion = 0;
    }
  }
  h->moved = GJK_SCENE_NONE;
}

// The slot of one of a pair's bodies.
static uint32_t slot_of(const gjk_scene_view *v, const gjk_scene_pair *pair, unsigned side) {
  return (pair->state & GJK_SCENE_PAIR_GONE) != 0 ? gjk_scene_gone_side(pair, side).slot
                                                  : v->parts[gjk_scene_end(pair, side)].body;
}

// Entries of the queue while they are sorted. The lower bits of an entry are its pair's index. The upper ones are those
// of the slot of one of the pair's bodies, as many as fit; of the other bodies all slots are the same.
typedef struct sorted_queue {
  const gjk_scene_view *v;
  uint32_t *entries;
  uint32_t index_mask;
} sorted_queue;

// Does the report of one pair come before that of another one?
GJK_OUT_OF_LINE static bool is_before(const gjk_scene_view *v, uint32_t i, uint32_t j) {
  //@ assert i < v->header->pairs.capacity && j < v->header->pairs.capacity;
  const gjk_scene_pair *pair_i = &v->pairs[i], *pair_j = &v->pairs[j];
  for (unsigned side = 0; side < 2; side++) {
    const gjk_scene_side a = gjk_scene_side_of(v, pair_i, side), b = gjk_scene_side_of(v, pair_j, side);
    if (a.slot != b.slot) {
      return a.slot < b.slot;
    }
    if (a.generation != b.generation) {
      return a.generation < b.generation;
    }
    if (a.part != b.part) {
      return a.part < b.part;
    }
  }
  return false;
}

// Does the report at place i of the queue come before that at place j? What the entries have of slots decides most.
static bool reported_before(const void *queue, uint32_t i, uint32_t j) {
  const sorted_queue *q = (const sorted_queue *)queue;
  const uint32_t a = q->entries[i], b = q->entries[j], mask = q->index_mask;
  return (a ^ b) > mask ? a < b : is_before(q->v, a & mask, b & mask);
}

static void exchange_events(void *queue, uint32_t i, uint32_t j) {
  uint32_t *entries = ((const sorted_queue *)queue)->entries;
  const uint32_t entry = entries[i];
  entries[i] = entries[j];
  entries[j] = entry;
}

// The entry of a pair, with the slot of the body on one side. The pair is listed no more.
static inline uint32_t packed(const sorted_queue *q, uint32_t index, unsigned side) {
  // Slots are below bodies <= 2^20, indices below capacity <= 2^22.
  const unsigned shift = gjk_clz32(q->v->header->config.bodies);
  gjk_scene_pair *pair = &q->v->pairs[index];
  pair->outcome = (uint8_t)(pair->outcome & ~GJK_SCENE_LISTED);
  return index | (slot_of(q->v, pair, side) << shift & ~q->index_mask);
}

// Sorts count entries: a few by insertion, where each goes down to its place.
static void sort_entries(sorted_queue *q, uint32_t count) {
  static const gjk_sort_order order = {.before = reported_before, .exchange = exchange_events};
  if (count > FEW) {
    gjk_sort(&order, q, count);
    return;
  }
  for (uint32_t i = 1; i < count; i++) {
    for (uint32_t k = i; k > 0 && reported_before(q, k, k - 1); k--) {
      exchange_events(q, k, k - 1);
    }
  }
}

// Adds the events of the pairs whose first part is this one, which are flagged. Sorts them. Returns how many there are then.
static uint32_t gather_events_of(sorted_queue *q, uint32_t part, uint32_t count) {
  const gjk_scene_view *v = q->v;
  uint32_t *queue = v->queue, end = count;
  for (uint32_t link = v->parts[part].pairs; link != GJK_SCENE_NONE;
       link = gjk_scene_next(&v->pairs[link / 2], link % 2)) {
    if (link % 2 == 0 && (v->pairs[link / 2].outcome & GJK_SCENE_LISTED) != 0) {
      //@ assert end < v->header->pairs.capacity;
      queue[end++] = packed(q, link / 2, 1);
    }
  }
  q->entries = queue + count;
  sort_entries(q, end - count);
  return end;
}

// Step 8, where many of all pairs have an event and none is gone: bodies, their parts, and the lists of parts are walked
// in the order of reports, so only the pairs of one part are left to sort.
static void gather_events(sorted_queue *q) {
  const gjk_scene_view *v = q->v;
  uint32_t count = 0;
  for (uint32_t slot = 0; slot < v->header->bodies.fresh; slot++) {
    // A slot that was never used is in no list, whatever its first part says.
    uint32_t i = v->bodies[slot].generation % 2 != 0 ? v->bodies[slot].first : GJK_SCENE_NONE;
    for (; i != GJK_SCENE_NONE; i = v->parts[i].next) {
      count = gather_events_of(q, i, count);
    }
  }
}

// Step 8. Sorts the kept events. gone: some are of pairs that are gone, and in no list.
static void sort_events(const gjk_scene_view *v, uint32_t kept, bool gone) {
  const gjk_scene_header *h = v->header;
  sorted_queue q = {v, v->queue, UINT32_MAX >> gjk_clz32(h->pairs.capacity)};
  if (!gone && kept > FEW && kept >= (h->bodies.fresh + h->parts.count + h->pairs.count) / GATHER) {
    gather_events(&q);
  } else {
    for (uint32_t i = 0; i < kept; i++) {
      v->queue[i] = packed(&q, v->queue[i], 0);
    }
    sort_entries(&q, kept);
  }
  for (uint32_t i = 0; i < kept; i++) {
    v->queue[i] &= q.index_mask;
  }
}

void gjk_scene_make_events(gjk_scene_view *v) {
  gjk_scene_header *h = v->header;
  const bool gone = h->gone != GJK_SCENE_NONE;
  uint32_t kept = 0;
  start_stats(v);
  keep_tested(v, &kept);
  keep_resting(v, &kept);
  keep_gone(v, &kept);
  h->queued = kept;
  h->next_report = 0;
  forget_motion(v);
  sort_events(v, kept, gone);
  h->phase = GJK_SCENE_REPORTING;
}
