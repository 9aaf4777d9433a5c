// The reports of an update, and the pairs that were near at the last one.
#include "gjk_scene_update.h"

// Tells of one side of a pair.
static inline void describe_side(const gjk_scene_side *side, gjk_body_id *id, uint16_t *part) {
  id->slot = side->slot;
  id->generation = side->generation;
  *part = side->part;
}

// Fills what reports of all pairs have in common, but for event and distance. The manifold, if one is wanted, is added later.
static inline void describe_pair(const gjk_scene_view *v, uint32_t index, const gjk_scene_side *a,
                                 const gjk_scene_side *b, gjk_report *out) {
  describe_side(a, &out->a, &out->part_a);
  describe_side(b, &out->b, &out->part_b);
  out->manifold = NULL;
  out->words = gjk_scene_words_of(v, index);
  out->fraction = 0;
}

// The user word of a body; 0: it was removed.
static uint32_t user_of(const gjk_scene_view *v, gjk_body_id id) {
  gjk_scene_body *body;
  return gjk_scene_body_of(v, id, &body) == GJK_OK ? body->user : 0;
}

static void describe_gone(const gjk_scene_view *v, uint32_t index, gjk_report *out) {
  const gjk_scene_pair *pair = &v->pairs[index];
  const gjk_scene_side a = gjk_scene_gone_side(pair, 0), b = gjk_scene_gone_side(pair, 1);
  describe_pair(v, index, &a, &b, out);
  out->user_a = user_of(v, out->a);
  out->user_b = user_of(v, out->b);
  out->detail = v->header->config.detail;
  out->still = false;
}

// The part on one side of a pair that is not gone.
static inline const gjk_scene_part *part_on(const gjk_scene_view *v, const gjk_scene_pair *pair, unsigned side) {
  const uint32_t at = gjk_scene_end(pair, side);
  //@ assert at < v->header->parts.capacity;
  return &v->parts[at];
}

static inline void describe_linked(const gjk_scene_view *v, uint32_t index, const gjk_scene_part *a,
                                   const gjk_scene_part *b, gjk_report *out) {
  const gjk_scene_body *on_a = &v->bodies[a->body], *on_b = &v->bodies[b->body];
  const gjk_scene_side of_a = {a->body, on_a->generation, a->number}, of_b = {b->body, on_b->generation, b->number};
  describe_pair(v, index, &of_a, &of_b, out);
  out->user_a = on_a->user;
  out->user_b = on_b->user;
  out->detail = gjk_scene_detail(v, on_a, on_b);
  out->still = (v->pairs[index].outcome & GJK_SCENE_TOLD) != 0;
}

// Reports the end of a pair that is gone, and drops it: its report was all that it was kept for.
static void report_gone(gjk_scene_view *v, uint32_t index, gjk_report *out) {
  gjk_scene_pair *pair = &v->pairs[index];
  describe_gone(v, index, out);
  out->event = GJK_EVENT_END;
  out->distance = 0;
  pair->state = 0;
  gjk_scene_pool_give(v, &v->header->pairs, sizeof *pair, index);
}

// The least distance of a manifold's contacts is above the exact one, or above minus the exact depth, by less than this:
//
// the contacts   6, see gjk/contacts.h
// the distance   1; of centres more than 8192 units apart 2^-28 of less than 2^32: 8 more
#define MANIFOLD_SLACK 16

// Step 1 of the narrow phase starts from what a manifold proves: the pair is so much nearer than its margins. To part
// shapes by so much, their points must move as far together. Curved pairs do not take that step.
//
// margin < 2^29, distance > -2^31:  the sum < 2^32
static void keep_gap(const gjk_scene_view *v, const gjk_scene_part *a, const gjk_scene_part *b, gjk_q16 distance,
                     gjk_scene_pair *pair) {
  const int32_t margin = v->bodies[a->body].margin + v->bodies[b->body].margin;
  const int64_t within = (int64_t)margin - distance - MANIFOLD_SLACK;
  if (within > pair->gap) {
    pair->gap = gjk_saturate(within);
  }
}

// Adds the manifold to the report of a linked pair, and its least distance. Without an answer the manifold is zero.
static void add_manifold(const gjk_scene_view *v, uint32_t index, const gjk_scene_part *a, const gjk_scene_part *b,
                         gjk_manifold *room, gjk_report *out) {
  const gjk_status status = v->scene->bindings.details->manifold(v, a, b, GJK_SCENE_CONTACTS,
                                                                 v->caches != NULL ? &v->caches[index] : NULL, room);
  if (status != GJK_OK && status != GJK_ERROR_CAPACITY) {
    gjk_scene_no_normal(room);
    room->count = 0;
    room->feature_a = room->feature_b = 0;
  }
  v->header->stats.unsettled += status != GJK_OK;
  v->header->stats.manifolds++;
  gjk_q16 least = room->count > 0 ? room->contact[0].distance : 0;
  for (unsigned i = 1; i < room->count; i++) {
    least = room->contact[i].distance < least ? room->contact[i].distance : least;
  }
  out->manifold = room;
  out->distance = least;
  if (status == GJK_OK && room->count > 0) {
    keep_gap(v, a, b, least, &v->pairs[index]);
  }
}

// Reports a linked pair, and drops it if its report was all that it was kept for. room: for its manifold; NULL: none is wanted.
static void report_linked(gjk_scene_view *v, uint32_t index, gjk_manifold *room, gjk_report *out) {
  const gjk_scene_bindings *bindings = &v->scene->bindings;
  gjk_scene_pair *pair = &v->pairs[index];
  const gjk_scene_part *a = part_on(v, pair, 0), *b = part_on(v, pair, 1);
  describe_linked(v, index, a, b, out);
  out->event = (uint8_t)(pair->outcome & ~GJK_SCENE_TOLD);
  out->distance = 0;
  if (out->event == GJK_EVENT_END) {
    if (!gjk_scene_pair_stays(v, pair)) {
      gjk_scene_pair_drop(v, index);
    }
    return;
  }
  pair->outcome |= GJK_SCENE_TOLD;
  if (gjk_scene_wants_distance(out->detail)) {
    out->distance = pair->gap;
  } else if (out->detail == GJK_DETAIL_CONTACTS && room != NULL && !(out->still && bindings->keeps_manifolds)) {
    add_manifold(v, index, a, b, room, out);
  }
}

void gjk_scene_write_reports(gjk_scene_view *v, gjk_report *reports, uint32_t capacity, gjk_progress *progress) {
  gjk_scene_header *h = v->header;
  gjk_manifold *room = v->scene->bindings.manifolds;
  uint32_t written = progress->reports;
  for (; h->next_report < h->queued && written < capacity; written++) {
    const uint32_t index = v->queue[h->next_report++];
    //@ assert index < h->pairs.capacity;
    if ((v->pairs[index].state & GJK_SCENE_PAIR_GONE) != 0) {
      report_gone(v, index, &reports[written]);
    } else {
      report_linked(v, index, room != NULL ? &room[written] : NULL, &reports[written]);
    }
  }
  progress->reports = written;
  progress->reports_left = h->queued - h->next_report;
  if (h->next_report >= h->queued) {
    h->updates++;
    h->queued = 0;
    h->phase = GJK_SCENE_IDLE;
  }
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
      if (gone) {
        describe_gone(&v, *cursor - 1, out);
      } else {
        describe_linked(&v, *cursor - 1, part_on(&v, pair, 0), part_on(&v, pair, 1), out);
      }
      out->event = gone ? GJK_EVENT_END : GJK_EVENT_PERSIST;
      out->distance = !gone && gjk_scene_wants_distance(out->detail) ? pair->gap : 0;
      *found = true;
    }
  }
  return GJK_OK;
}
