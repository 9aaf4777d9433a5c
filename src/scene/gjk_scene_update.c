// The update: which pairs are to be tested, the tests, what they come to, and the reports in order.
#include "gjk_scene_pairs.h"

// Enters a pair at that place of the queue, unless it is queued. Returns how many it has then.
static uint32_t queue_pair(gjk_scene_view *v, uint32_t index, uint32_t at) {
  gjk_scene_pair *pair = &v->pairs[index];
  const unsigned state = pair->state;
  if ((state & GJK_SCENE_PAIR_QUEUED) != 0) {
    return at;
  }
  pair->state = (uint8_t)((state | GJK_SCENE_PAIR_QUEUED) & ~GJK_SCENE_PAIR_NEAR_NOW);
  //@ assert at < v->header->pairs.capacity;
  pair->outcome = GJK_SCENE_PENDING;
  v->queue[at] = index;
  return at + 1;
}

// The pairs of the bodies that moved; with retest_all all.
static void fill_queue(gjk_scene_view *v) {
  gjk_scene_header *h = v->header;
  uint32_t queued = 0;
  h->next_test = 0;
  if (h->config.retest_all != 0) {
    for (uint32_t i = 0; i < h->pairs.fresh; i++) {
      if ((v->pairs[i].state & (GJK_SCENE_PAIR_LIVE | GJK_SCENE_PAIR_GONE)) == GJK_SCENE_PAIR_LIVE) {
        queued = queue_pair(v, i, queued);
      }
    }
    h->queued = queued;
    return;
  }
  for (uint32_t slot = h->moved; slot != GJK_SCENE_NONE; slot = v->bodies[slot].next_moved) {
    for (uint32_t i = v->bodies[slot].first; i != GJK_SCENE_NONE; i = v->parts[i].next) {
      for (uint32_t link = v->parts[i].pairs; link != GJK_SCENE_NONE; link = v->pairs[link / 2].next[link % 2]) {
        queued = queue_pair(v, link / 2, queued);
      }
    }
  }
  h->queued = queued;
}

// Does the handle have what the details asked for take?
static gjk_status check_details(const gjk_scene_view *v) {
  const gjk_scene_details *details = v->scene->details;
  const uint32_t most = v->header->most_detail;
  gjk_workspace workspace;
  const bool lacking =
      most > GJK_DETAIL_DISTANCE && (details == NULL || (most == GJK_DETAIL_CONTACTS && details->manifold == NULL) ||
                                     !gjk_scene_workspace(v->scene, &workspace));
  return lacking ? GJK_ERROR_UNSUPPORTED : GJK_OK;
}

static gjk_status begin(gjk_scene_view *v) {
  gjk_scene_header *h = v->header;
  const gjk_status able = check_details(v);
  if (able != GJK_OK) {
    return able;
  }
  h->sealed = 0;
  if (h->phase != GJK_SCENE_IDLE) {
    return GJK_OK;
  }
  const gjk_status status = gjk_scene_pairs_match(v);
  if (status == GJK_OK) {
    fill_queue(v);
    h->phase = GJK_SCENE_TESTING;
  }
  return status;
}

// Tests at most tests pairs that are not tested yet.
static void test_some(gjk_scene_view *v, uint32_t tests) {
  gjk_scene_header *h = v->header;
  for (; h->next_test < h->queued; h->next_test++) {
    gjk_scene_pair *pair = &v->pairs[v->queue[h->next_test]];
    if (pair->outcome == GJK_SCENE_PENDING) {
      if (tests == 0) {
        return;
      }
      tests--;
      gjk_scene_narrow_phase(v, pair);
    }
  }
}

static bool awake(const gjk_scene_view *v, uint32_t part) {
  const gjk_scene_body *body = &v->bodies[v->parts[part].body];
  return (body->kind_detail & 15u) != GJK_BODY_STATIC && (body->flags & GJK_SCENE_ASLEEP) == 0;
}

static bool persists(const gjk_scene_view *v, const gjk_scene_pair *pair) {
  return v->header->config.persist != 0 && (awake(v, pair->part[0]) || awake(v, pair->part[1]));
}

// The counter of an outcome: both are in the same order.
static uint32_t *counter_of(gjk_scene_stats *s, unsigned outcome) {
  uint32_t *words = (void *)s;
  return words + offsetof(gjk_scene_stats, filtered) / sizeof *words + (outcome - GJK_SCENE_FILTERED);
}

static void keep_event(gjk_scene_view *v, uint32_t index, gjk_event event, uint32_t *kept) {
  gjk_scene_stats *s = &v->header->stats;
  uint32_t *counter = event == GJK_EVENT_BEGIN ? &s->begun : event == GJK_EVENT_END ? &s->ended : &s->persisting;
  (*counter)++;
  //@ assert *kept < v->header->pairs.capacity;
  v->pairs[index].outcome = (uint8_t)event;
  v->queue[(*kept)++] = index;
}

// Turns what the tests found into events: those of the pairs tested, pairs that rest near, pairs that are gone. They replace
// the queue, whose length they cannot exceed the pairs.
static void collect_events(gjk_scene_view *v) {
  gjk_scene_header *h = v->header;
  uint32_t kept = 0;
  for (uint32_t i = 0; i < h->queued; i++) {
    const uint32_t index = v->queue[i];
    gjk_scene_pair *pair = &v->pairs[index];
    const unsigned state = pair->state, outcome = pair->outcome;
    const bool was = (state & GJK_SCENE_PAIR_NEAR) != 0, now = (state & GJK_SCENE_PAIR_NEAR_NOW) != 0;
    const unsigned kind = outcome & (GJK_SCENE_UNSETTLED - 1u);
    //@ assert kind >= GJK_SCENE_FILTERED && kind <= GJK_SCENE_COLD;
    (*counter_of(&h->stats, kind))++;
    h->stats.unsettled += (outcome & GJK_SCENE_UNSETTLED) != 0;
    pair->state = (uint8_t)((state & ~(GJK_SCENE_PAIR_NEAR | GJK_SCENE_PAIR_QUEUED | GJK_SCENE_PAIR_NEAR_NOW)) |
                            (now ? GJK_SCENE_PAIR_NEAR : 0u));
    if (was != now) {
      keep_event(v, index, now ? GJK_EVENT_BEGIN : GJK_EVENT_END, &kept);
    } else if (now && persists(v, pair)) {
      keep_event(v, index, GJK_EVENT_PERSIST, &kept);
    }
    if (now && h->config.persist != 0) {
      pair->state |= GJK_SCENE_PAIR_QUEUED;  // not to be found again below
    }
  }
  for (uint32_t i = 0; h->config.persist != 0 && i < h->pairs.fresh; i++) {
    gjk_scene_pair *pair = &v->pairs[i];
    const unsigned flags = pair->state & (GJK_SCENE_PAIR_LIVE | GJK_SCENE_PAIR_NEAR | GJK_SCENE_PAIR_GONE);
    if (flags == (GJK_SCENE_PAIR_LIVE | GJK_SCENE_PAIR_NEAR) && (pair->state & GJK_SCENE_PAIR_QUEUED) == 0 &&
        persists(v, pair)) {
      keep_event(v, i, GJK_EVENT_PERSIST, &kept);
    }
    pair->state = (uint8_t)(pair->state & ~GJK_SCENE_PAIR_QUEUED);
  }
  for (uint32_t i = h->gone; i != GJK_SCENE_NONE; i = v->pairs[i].previous[0]) {
    //@ assert i < h->pairs.fresh;
    keep_event(v, i, GJK_EVENT_END, &kept);
  }
  h->gone = GJK_SCENE_NONE;
  h->queued = kept;
  h->next_report = 0;
}

static void settle_bodies(gjk_scene_view *v) {
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

static void describe(const gjk_scene_view *v, const gjk_scene_pair *pair, gjk_report *out) {
  if ((pair->state & GJK_SCENE_PAIR_GONE) != 0) {
    out->a.slot = pair->part[0];
    out->a.generation = pair->next[0];
    out->b.slot = pair->part[1];
    out->b.generation = pair->next[1];
    out->part_a = (uint16_t)pair->direction[0];
    out->part_b = (uint16_t)pair->direction[1];
    out->detail = v->header->config.detail;
    return;
  }
  const uint32_t at_a = pair->part[0], at_b = pair->part[1];
  //@ assert at_a < v->header->parts.capacity && at_b < v->header->parts.capacity;
  const gjk_scene_part *a = &v->parts[at_a], *b = &v->parts[at_b];
  out->a = gjk_scene_id_of(v, a->body);
  out->b = gjk_scene_id_of(v, b->body);
  out->part_a = a->number;
  out->part_b = b->number;
  out->detail = gjk_scene_detail(v, &v->bodies[a->body], &v->bodies[b->body]);
}

static int compare(uint32_t a, uint32_t b) {
  return (a > b) - (a < b);
}

// The slot of a pair's first body.
static uint32_t first_slot(const gjk_scene_view *v, const gjk_scene_pair *pair) {
  return (pair->state & GJK_SCENE_PAIR_GONE) != 0 ? pair->part[0] : v->parts[pair->part[0]].body;
}

// Slot a settles most.
static int order(const gjk_scene_view *v, uint32_t first, uint32_t second) {
  gjk_report x, y;
  int sign = compare(first_slot(v, &v->pairs[first]), first_slot(v, &v->pairs[second]));
  if (sign != 0) {
    return sign;
  }
  describe(v, &v->pairs[first], &x);
  describe(v, &v->pairs[second], &y);
  sign = compare(x.a.generation, y.a.generation);
  sign = sign != 0 ? sign : compare(x.part_a, y.part_a);
  sign = sign != 0 ? sign : compare(x.b.slot, y.b.slot);
  sign = sign != 0 ? sign : compare(x.b.generation, y.b.generation);
  return sign != 0 ? sign : compare(x.part_b, y.part_b);
}

// Lets the entry at sink into the heap below it, of count entries, the last in order on top.
static void sift_pair(gjk_scene_view *v, uint32_t at, uint32_t count) {
  const uint32_t sinking = v->queue[at];
  for (uint32_t child = 2 * at + 1; child < count; child = 2 * at + 1) {  // at most log2 count iterations
    if (child + 1 < count && order(v, v->queue[child + 1], v->queue[child]) > 0) {
      child++;
    }
    if (order(v, v->queue[child], sinking) <= 0) {
      break;
    }
    v->queue[at] = v->queue[child];
    at = child;
  }
  v->queue[at] = sinking;
}

static void sort_events(gjk_scene_view *v) {
  const uint32_t count = v->header->queued;
  for (uint32_t i = count / 2; i > 0; i--) {
    sift_pair(v, i - 1, count);
  }
  for (uint32_t end = count; end > 1; end--) {
    const uint32_t last = v->queue[0];
    v->queue[0] = v->queue[end - 1];
    v->queue[end - 1] = last;
    sift_pair(v, 0, end - 1);
  }
}

// Copies count words; volatile, lest the compiler make it a call of memcpy.
static void copy_words(uint32_t *to, const volatile uint32_t *from, unsigned count) {
  for (unsigned i = 0; i < count; i++) {
    to[i] = from[i];
  }
}

#define STATS_WORDS (sizeof(gjk_scene_stats) / sizeof(uint32_t))

static void start_stats(gjk_scene_view *v) {
  static const uint32_t zero[STATS_WORDS] = {0};
  gjk_scene_header *h = v->header;
  copy_words((void *)&h->stats, zero, STATS_WORDS);
  h->stats.refused = h->refused;
  h->stats.pairs = h->pairs.count;
  for (uint32_t i = h->gone; i != GJK_SCENE_NONE; i = v->pairs[i].previous[0]) {
    //@ assert i < h->pairs.fresh;
    h->stats.pairs--;
  }
  h->stats.resting = h->stats.pairs - h->queued;
}

static void finish_tests(gjk_scene_view *v) {
  start_stats(v);
  collect_events(v);
  settle_bodies(v);
  sort_events(v);
  v->header->phase = GJK_SCENE_REPORTING;
}

// Reports one pair, and drops it if that was all it was kept for.
static void report_pair(gjk_scene_view *v, uint32_t index, gjk_report *out) {
  gjk_scene_pair *pair = &v->pairs[index];
  describe(v, pair, out);
  out->event = pair->outcome;
  out->distance = 0;
  out->manifold = NULL;
  if (out->event != GJK_EVENT_END) {
    out->distance = gjk_scene_measures(out->detail) ? pair->gap : 0;
  } else if ((pair->state & GJK_SCENE_PAIR_GONE) != 0) {
    pair->state = 0;
    gjk_scene_give(v, &v->header->pairs, sizeof *pair, index);
  } else if (!gjk_scene_pair_stays(v, pair)) {
    gjk_scene_pair_drop(v, index);
  }
}

// Adds the manifold to a report, and its least distance.
static void add_manifold(const gjk_scene_view *v, gjk_manifold *room, gjk_report *out) {
  const gjk_status status = v->scene->details->manifold(v->scene, out, 4, room);
  if (status != GJK_OK && status != GJK_ERROR_CAPACITY) {
    room->normal.x = room->normal.y = room->normal.z = 0;
    room->count = 0;
    room->feature_a = room->feature_b = 0;
  }
  v->header->stats.unsettled += status != GJK_OK;
  out->manifold = room;
  out->distance = room->count > 0 ? room->contact[0].distance : 0;
  for (unsigned i = 1; i < room->count; i++) {
    out->distance = room->contact[i].distance < out->distance ? room->contact[i].distance : out->distance;
  }
}

static void report_some(gjk_scene_view *v, gjk_report *reports, uint32_t capacity, gjk_progress *progress) {
  gjk_scene_header *h = v->header;
  while (h->next_report < h->queued && progress->reports < capacity) {
    gjk_report *out = &reports[progress->reports];
    report_pair(v, v->queue[h->next_report++], out);
    if (out->detail == GJK_DETAIL_CONTACTS && out->event != GJK_EVENT_END && v->scene->manifolds != NULL) {
      add_manifold(v, &v->scene->manifolds[progress->reports], out);
    }
    progress->reports++;
  }
  progress->reports_left = h->queued - h->next_report;
  if (h->next_report >= h->queued) {
    h->updates++;
    h->queued = 0;
    h->phase = GJK_SCENE_IDLE;
  }
}

gjk_status gjk_scene_update_slice(gjk_scene *scene, uint32_t tests, gjk_report *reports, uint32_t capacity,
                                  gjk_progress *progress) {
  gjk_scene_view v;
  gjk_status status = gjk_scene_view_of(scene, &v);
  if (status == GJK_OK && (progress == NULL || (reports == NULL && capacity > 0))) {
    status = GJK_ERROR_NULL;
  }
  if (status == GJK_OK) {
    status = begin(&v);
  }
  if (status != GJK_OK) {
    return status;
  }
  progress->reports = 0;
  progress->pairs_left = 0;
  if (v.header->phase == GJK_SCENE_TESTING) {
    test_some(&v, tests);
    progress->pairs_left = v.header->queued - v.header->next_test;
    progress->reports_left = 0;
    if (progress->pairs_left > 0) {
      return GJK_OK;
    }
    finish_tests(&v);
  }
  report_some(&v, reports, capacity, progress);
  return GJK_OK;
}

gjk_status gjk_scene_update(gjk_scene *scene, gjk_report *reports, uint32_t capacity, gjk_progress *progress) {
  return gjk_scene_update_slice(scene, UINT32_MAX, reports, capacity, progress);
}

gjk_status gjk_scene_update_each(gjk_scene *scene, gjk_report_function *function, void *user) {
  gjk_report report;
  gjk_progress progress = {0, 0, 0};
  if (function == NULL) {
    return GJK_ERROR_NULL;
  }
  do {  // ends: each call writes a report or is the last
    const gjk_status status = gjk_scene_update(scene, &report, 1, &progress);
    if (status != GJK_OK) {
      return status;
    }
    if (progress.reports > 0) {
      function(user, &report);
    }
  } while (progress.reports_left > 0);
  return GJK_OK;
}

gjk_status gjk_scene_update_begin(gjk_scene *scene, uint32_t *pairs) {
  gjk_scene_view v;
  gjk_status status = gjk_scene_view_of(scene, &v);
  if (status == GJK_OK && pairs == NULL) {
    status = GJK_ERROR_NULL;
  }
  if (status == GJK_OK) {
    status = v.header->phase == GJK_SCENE_REPORTING ? GJK_ERROR_BUSY : begin(&v);
  }
  if (status == GJK_OK) {
    *pairs = v.header->queued;
  }
  return status;
}

gjk_status gjk_scene_test_pairs(gjk_scene *scene, uint32_t first, uint32_t end) {
  gjk_scene_view v;
  const gjk_status status = gjk_scene_view_of(scene, &v);
  if (status != GJK_OK) {
    return status;
  }
  if (v.header->phase != GJK_SCENE_TESTING || first > end || end > v.header->queued) {
    return GJK_ERROR_RANGE;
  }
  const gjk_status able = check_details(&v);
  if (able != GJK_OK) {
    return able;
  }
  for (uint32_t i = first; i < end; i++) {
    gjk_scene_narrow_phase(&v, &v.pairs[v.queue[i]]);
  }
  return GJK_OK;
}

gjk_status gjk_scene_next_near(const gjk_scene *scene, uint32_t *cursor, gjk_report *out, bool *found) {
  gjk_scene_view v;
  gjk_status status = gjk_scene_view_of(scene, &v);
  if (status == GJK_OK && (cursor == NULL || out == NULL || found == NULL)) {
    status = GJK_ERROR_NULL;
  }
  if (status != GJK_OK) {
    return status;
  }
  *found = false;
  while (*cursor < v.header->pairs.fresh && !*found) {
    const gjk_scene_pair *pair = &v.pairs[(*cursor)++];
    if ((pair->state & GJK_SCENE_PAIR_NEAR) != 0) {
      const bool gone = (pair->state & GJK_SCENE_PAIR_GONE) != 0;
      describe(&v, pair, out);
      out->event = gone ? GJK_EVENT_END : GJK_EVENT_PERSIST;
      out->distance = !gone && gjk_scene_measures(out->detail) ? pair->gap : 0;
      out->manifold = NULL;
      *found = true;
    }
  }
  return GJK_OK;
}

gjk_status gjk_scene_get_stats(const gjk_scene *scene, gjk_scene_stats *out) {
  gjk_scene_view v;
  gjk_status status = gjk_scene_view_of(scene, &v);
  if (status == GJK_OK && out == NULL) {
    status = GJK_ERROR_NULL;
  }
  if (status == GJK_OK) {
    copy_words((void *)out, (const void *)&v.header->stats, STATS_WORDS);
    out->updates = v.header->updates;
    out->bodies = v.header->bodies.count;
    out->parts = v.header->parts.count;
  }
  return status;
}
