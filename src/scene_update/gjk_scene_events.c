// The events of an update: which of its pairs began to be near, stayed near, or ended, in the order of reports.
#include "../arith/gjk_sort.h"
#include "gjk_scene_update.h"

// Up to so many events are sorted by insertion. A build for size does without that, and without the walk below.
#define FEW 8

// Where the last update had an event for one in so many bodies, parts and pairs, all of them are walked. A step of such a
// walk takes about 8 instructions; to sort an event takes 20 for each doubling of their number.
#define WALK 16

static bool is_awake(const gjk_scene_body *body) {
  return (body->flags & GJK_SCENE_ASLEEP) == 0 && (body->kind_detail & 15u) != GJK_BODY_STATIC;
}

// Is a pair of two bodies that stays near to be reported?
static inline bool persists(const gjk_scene_view *v, const gjk_scene_body *a, const gjk_scene_body *b) {
  return v->header->config.persist != 0 && (is_awake(a) || is_awake(b)) && !gjk_scene_is_sensor(a) &&
         !gjk_scene_is_sensor(b);
}

static bool pair_persists(const gjk_scene_view *v, const gjk_scene_pair *pair) {
  return persists(v, &v->bodies[v->parts[gjk_scene_end(pair, 0)].body],
                  &v->bodies[v->parts[gjk_scene_end(pair, 1)].body]);
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

// The words of a pair that begins.
static void clear_words(const gjk_scene_view *v, uint32_t index) {
  uint32_t *words = gjk_scene_words_of(v, index);
  for (uint32_t i = 0; i < v->header->config.pair_words; i++) {
    words[i] = 0;
  }
}

// Notes the event of a pair, and counts it.
static inline void note_event(const gjk_scene_view *v, gjk_scene_pair *pair, unsigned event) {
  gjk_scene_counters *s = &v->header->stats;
  s->begun += event == GJK_EVENT_BEGIN;
  s->persisting += event == GJK_EVENT_PERSIST;
  s->ended += event == GJK_EVENT_END;
  pair->outcome = (uint8_t)(event | (event == GJK_EVENT_PERSIST ? pair->outcome & GJK_SCENE_TOLD : 0));
}

// Counts what became of a pair that was tested, and whether it is near. Returns its event: PERSIST whether that is to be
// reported or not; 0: it has none.
static inline unsigned settle_tested(const gjk_scene_view *v, uint32_t index) {
  gjk_scene_header *h = v->header;
  gjk_scene_pair *pair = &v->pairs[index];
  const unsigned state = pair->state, outcome = pair->outcome;
  const bool was = (state & GJK_SCENE_PAIR_NEAR) != 0, now = (state & GJK_SCENE_PAIR_NEAR_NOW) != 0;
  const unsigned kind = outcome & (GJK_SCENE_UNSETTLED - 1u);
  //@ assert kind >= GJK_SCENE_FILTERED && kind <= GJK_SCENE_COLD;
  (*counter_of(&h->stats, kind))++;
  if ((outcome & (GJK_SCENE_UNSETTLED | GJK_SCENE_MEASURED)) != 0) {
    h->stats.unsettled += (outcome & GJK_SCENE_UNSETTLED) != 0;
    h->stats.measured += (outcome & GJK_SCENE_MEASURED) != 0;
  }
  pair->state = (uint8_t)((state & ~(GJK_SCENE_PAIR_NEAR | GJK_SCENE_PAIR_QUEUED | GJK_SCENE_PAIR_NEAR_NOW)) |
                          (now ? GJK_SCENE_PAIR_NEAR : 0u));
  if (now && !was) {
    clear_words(v, index);
  }
  if (now) {
    return was ? GJK_EVENT_PERSIST : GJK_EVENT_BEGIN;
  }
  return was ? (unsigned)GJK_EVENT_END : 0u;
}

// Adds a pair with its event to the events kept, which overwrite the queue from its start.
static void keep_event(gjk_scene_view *v, uint32_t index, unsigned event, uint32_t *kept) {
  note_event(v, &v->pairs[index], event);
  //@ assert *kept < v->header->pairs.capacity;
  v->queue[(*kept)++] = index;
}

// Step 6, pairs that were tested. Each makes at most one event, so no entry is overwritten before it is read.
static void keep_tested(gjk_scene_view *v, uint32_t *kept) {
  const gjk_scene_header *h = v->header;
  for (uint32_t i = 0; i < h->queued; i++) {
    const uint32_t index = v->queue[i];
    const unsigned event = settle_tested(v, index);
    if (event != 0 && (event != GJK_EVENT_PERSIST || pair_persists(v, &v->pairs[index]))) {
      keep_event(v, index, event, kept);
    }
  }
}

// The same of a pair, if it rests near.
static void keep_if_resting(gjk_scene_view *v, uint32_t index, uint32_t *kept) {
  const unsigned rests = GJK_SCENE_PAIR_LIVE | GJK_SCENE_PAIR_NEAR;
  const gjk_scene_pair *pair = &v->pairs[index];
  if ((pair->state & (rests | GJK_SCENE_PAIR_GONE | GJK_SCENE_PAIR_QUEUED)) == rests && pair_persists(v, pair)) {
    keep_event(v, index, GJK_EVENT_PERSIST, kept);
  }
}

// The same of the pairs of a part of an awake body. A pair of two such bodies is kept at its first one.
static void keep_resting_of(gjk_scene_view *v, uint32_t part, uint32_t *kept) {
  uint32_t next;
  for (uint32_t link = v->parts[part].pairs; link != GJK_SCENE_NONE; link = next) {
    const gjk_scene_pair *pair = &v->pairs[link / 2];
    next = gjk_scene_next(pair, link % 2);
    if (link % 2 == 0 || !is_awake(&v->bodies[v->parts[gjk_scene_end(pair, 0)].body])) {
      keep_if_resting(v, link / 2, kept);
    }
  }
}

// Step 6, with persist: pairs that rest near. Those of two bodies asleep are not to be reported, and not looked at but in a
// build for size.
static void keep_resting(gjk_scene_view *v, uint32_t *kept) {
  const gjk_scene_header *h = v->header;
  for (uint32_t i = 0; GJK_SMALL && i < h->pairs.fresh; i++) {
    keep_if_resting(v, i, kept);
  }
  for (uint32_t slot = 0; !GJK_SMALL && slot < h->bodies.fresh; slot++) {
    const gjk_scene_body *body = &v->bodies[slot];
    if (is_awake(body) && body->generation % 2 != 0) {
      for (uint32_t i = body->first; i != GJK_SCENE_NONE; i = v->parts[i].next) {
        keep_resting_of(v, i, kept);
      }
    }
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

// The slot of a pair's first body.
static uint32_t slot_of(const gjk_scene_view *v, const gjk_scene_pair *pair) {
  return (pair->state & GJK_SCENE_PAIR_GONE) != 0 ? gjk_scene_gone_side(pair, 0).slot
                                                  : v->parts[gjk_scene_end(pair, 0)].body;
}

// Entries of the queue while they are sorted. The lower bits of an entry are its pair's index. The upper ones are those
// of the slot of one of the pair's bodies, as many as fit; of the other bodies all slots are the same.
typedef struct sorted_queue {
  const gjk_scene_view *v;
  uint32_t *entries;
  uint32_t index_mask;
  unsigned slot_shift;  // slots are below bodies <= 2^20; indices are below capacity <= 2^22
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
  return false;  // not reached: two pairs differ
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

// The entry of a pair, with the slot of one of its bodies.
static inline uint32_t packed(const sorted_queue *q, uint32_t index, uint32_t slot) {
  return index | (slot << q->slot_shift & ~q->index_mask);
}

// Sorts count entries: a few by insertion, where each goes down to its place.
static void sort_entries(sorted_queue *q, uint32_t count) {
  static const gjk_sort_order order = {.before = reported_before, .exchange = exchange_events};
  if (GJK_SMALL || count > FEW) {
    gjk_sort(&order, q, count);
    return;
  }
  for (uint32_t i = 1; i < count; i++) {
    for (uint32_t k = i; k > 0 && reported_before(q, k, k - 1); k--) {
      exchange_events(q, k, k - 1);
    }
  }
}

// The event of a pair whose first body is own, as it is reported; other: the slot of its second body. 0: none is.
static inline unsigned walk_pair(const gjk_scene_view *v, uint32_t index, const gjk_scene_body *own, uint32_t other) {
  const unsigned state = v->pairs[index].state;
  unsigned event = (state & GJK_SCENE_PAIR_NEAR) != 0 ? (unsigned)GJK_EVENT_PERSIST : 0u;
  if ((state & GJK_SCENE_PAIR_QUEUED) != 0) {
    event = settle_tested(v, index);
  }
  return event != GJK_EVENT_PERSIST || persists(v, own, &v->bodies[other]) ? event : 0;
}

// Steps 6 and 8 for the pairs whose first part is this one: adds their events, and sorts them. Returns how many there are
// then.
static uint32_t walk_events_of(sorted_queue *q, uint32_t part, uint32_t count) {
  const gjk_scene_view *v = q->v;
  const gjk_scene_body *own = &v->bodies[v->parts[part].body];
  uint32_t *queue = v->queue, end = count;
  bool sorted = true;
  for (uint32_t link = v->parts[part].pairs; link != GJK_SCENE_NONE;
       link = gjk_scene_next(&v->pairs[link / 2], link % 2)) {
    if (link % 2 == 0) {
      gjk_scene_pair *pair = &v->pairs[link / 2];
      const uint32_t other = v->parts[gjk_scene_end(pair, 1)].body;
      const unsigned event = walk_pair(v, link / 2, own, other);
      if (event != 0) {
        note_event(v, pair, event);
        //@ assert end < v->header->pairs.capacity;
        queue[end] = packed(q, link / 2, other);
        sorted = sorted && (end == count || (queue[end - 1] | q->index_mask) < queue[end]);
        end++;
      }
    }
  }
  if (!sorted) {
    q->entries = queue + count;
    sort_entries(q, end - count);
  }
  return end;
}

// Steps 6 and 8, where none is gone: bodies, their parts, and the lists of parts are walked in the order of reports, so only
// the pairs of one part are left to sort. Every pair is in the list of its first part, so the queue is not needed.
static uint32_t walk_events(sorted_queue *q) {
  const gjk_scene_view *v = q->v;
  uint32_t count = 0;
  for (uint32_t slot = 0; slot < v->header->bodies.fresh; slot++) {
    // A slot that was never used is in no list, whatever its first part says.
    uint32_t i = v->bodies[slot].generation % 2 != 0 ? v->bodies[slot].first : GJK_SCENE_NONE;
    for (; i != GJK_SCENE_NONE; i = v->parts[i].next) {
      count = walk_events_of(q, i, count);
    }
  }
  return count;
}

// Steps 6 and 8 one after the other. gone: some pairs are gone, and in no list. Those that rest are found first, while those
// to be tested still say so, and wait behind the queue: no pair is in both.
static uint32_t keep_events(sorted_queue *q, gjk_scene_view *v) {
  const gjk_scene_header *h = v->header;
  uint32_t kept = 0, end = h->queued;
  if (h->config.persist != 0 && h->stats.resting > 0) {
    keep_resting(v, &end);
  }
  keep_tested(v, &kept);
  for (uint32_t i = h->queued; i < end; i++) {
    v->queue[kept++] = v->queue[i];
  }
  keep_gone(v, &kept);
  for (uint32_t i = 0; i < kept; i++) {
    v->queue[i] = packed(q, v->queue[i], slot_of(v, &v->pairs[v->queue[i]]));
  }
  sort_entries(q, kept);
  return kept;
}

void gjk_scene_make_events(gjk_scene_view *v) {
  gjk_scene_header *h = v->header;
  const uint32_t last = h->stats.begun + h->stats.persisting + h->stats.ended;
  const bool walks = !GJK_SMALL && h->gone == GJK_SCENE_NONE && last > FEW &&
                     last >= (h->bodies.fresh + h->parts.count + h->pairs.count) / WALK;
  sorted_queue q = {v, v->queue, UINT32_MAX >> gjk_clz32(h->pairs.capacity), gjk_clz32(h->config.bodies)};
  start_stats(v);
  const uint32_t kept = walks ? walk_events(&q) : keep_events(&q, v);
  for (uint32_t i = 0; i < kept; i++) {
    v->queue[i] &= q.index_mask;
  }
  h->queued = kept;
  h->next_report = 0;
  forget_motion(v);
  h->phase = GJK_SCENE_REPORTING;
}
