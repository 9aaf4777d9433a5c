// Fast bodies: swept from where they were at the last update to where they are now.
//
// 1. Bound how far each body whose motion is kept went since the last update: a body on its way is never farther than that
//    from its boxes in the tree.
// 2. For each part of a fast body find the parts that stand and whose boxes its way meets (gjk_scene_passage.c).
// 3. Find the parts that moved, and whose motion is kept, likewise, with boxes enlarged by the bound of step 1.
// 4. Ask each pair where it first touches (gjk_scene_impact.c).
// 5. Keep the first impact in the order of (fraction, slot, part). What is met later is not asked any more.
// 6. Report the impacts after the pairs. Then the bodies' ways start where they are now.
//
// Parts that touch at the start are no impact if they were near at the last update: then that was reported. Without that
// rule what lies on the ground would touch nothing but the ground; without its condition a body that is put into a wall
// could leave it on the other side unseen.
#include "../arith/gjk_memory.h"
#include "../scene/gjk_scene_passage.h"
#include "gjk_scene_impact.h"
#include "gjk_scene_update.h"

// The sweep of one fast body.
typedef struct body_sweep {
  const gjk_scene_view *v;
  uint32_t slot;
  gjk_scene_mover self;
  uint32_t part;  // index of its part under way
  gjk_scene_passage passage;
  gjk_scene_kept *first;  // what it found: other, fraction, number, state
} body_sweep;

// The place of the first kept motion of a slot that is not lower than this one.
static uint32_t place_of(const gjk_scene_view *v, uint32_t slot) {
  uint32_t low = 0, high = v->header->kept;
  while (low < high) {  // ends: halves
    const uint32_t middle = (low + high) / 2;
    if (v->kept[middle].slot < slot) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

static void set_mover(const gjk_scene_view *v, uint32_t slot, gjk_scene_mover *m) {
  const gjk_scene_body *body = &v->bodies[slot];
  gjk_scene_pose_of(body, &m->to);
  m->from = (body->flags & GJK_SCENE_KEPT) != 0 ? v->kept[place_of(v, slot)].last : m->to;
  m->turns = !gjk_scene_same_rotation(&m->from.rotation, &m->to.rotation);
  m->moves = m->turns || !gjk_scene_same_vec3(&m->from.position, &m->to.position);
}

// Step 1: how far the parts of a body are on its way from where they are now, along each axis.
static uint32_t longest_way(const gjk_scene_view *v, uint32_t slot) {
  gjk_scene_mover m;
  int64_t reach = 0;
  set_mover(v, slot, &m);
  for (uint32_t i = v->bodies[slot].first; m.turns && i != GJK_SCENE_NONE; i = v->parts[i].next) {
    const int64_t part = gjk_scene_reach_of(v, &v->parts[i]);
    reach = part > reach ? part : reach;
  }
  const uint32_t x = gjk_scene_difference(m.from.position.x, m.to.position.x);
  const uint32_t y = gjk_scene_difference(m.from.position.y, m.to.position.y);
  uint32_t way = gjk_scene_larger(x, y);
#if GJK_SCENE_AXES == 3
  way = gjk_scene_larger(way, gjk_scene_difference(m.from.position.z, m.to.position.z));
#endif
  const int64_t sum = way + 2 * reach;
  return sum > UINT32_MAX ? UINT32_MAX : (uint32_t)sum;
}

// Readies the records: each gets the longest way of all others as fraction. Ways of 2^32 - 1 reach all of the world.
static void begin_sweeps(gjk_scene_view *v) {
  uint32_t longest = 0, second = 0, at = 0;
  for (uint32_t i = 0; i < v->header->kept; i++) {
    gjk_scene_kept *k = &v->kept[i];
    const uint32_t way = longest_way(v, k->slot);
    k->other = GJK_SCENE_NONE;
    k->number = 0;
    k->state = 0;
    if (way > longest) {
      second = longest;
      longest = way;
      at = i;
    } else if (way > second) {
      second = way;
    }
  }
  for (uint32_t i = 0; i < v->header->kept; i++) {
    v->kept[i].fraction = i == at ? second : longest;
  }
}

// Was a pair of parts near at the last update?
static bool were_near(const gjk_scene_view *v, uint32_t part, uint32_t other) {
  uint32_t link = v->parts[part].pairs;
  while (link != GJK_SCENE_NONE) {
    const gjk_scene_pair *pair = &v->pairs[link / 2];
    if (gjk_scene_end(pair, 1 - link % 2) == other) {
      return (pair->state & GJK_SCENE_PAIR_NEAR) != 0;
    }
    link = gjk_scene_next(pair, link % 2);
  }
  return false;
}

// Step 5: does an impact come before the first one so far?
static bool comes_first(const body_sweep *s, uint32_t fraction, const gjk_scene_part *own,
                        const gjk_scene_part *other) {
  const gjk_scene_view *v = s->v;
  if (s->first->other == GJK_SCENE_NONE) {
    return true;
  }
  const gjk_scene_part *of_first = &v->parts[s->first->other];
  if (fraction != s->first->fraction) {
    return fraction < s->first->fraction;
  }
  if (other->body != of_first->body) {
    return other->body < of_first->body;
  }
  return other->number != of_first->number ? other->number < of_first->number : own->number < s->first->number;
}

// Steps 4 and 5 for one part that may be met. entered: before this fraction it is not.
static void meet_part(body_sweep *s, uint32_t other, const gjk_scene_mover *of_other, uint32_t entered) {
  const gjk_scene_view *v = s->v;
  const gjk_scene_part *own = &v->parts[s->part], *met = &v->parts[other];
  const unsigned side = s->slot > met->body ? 1 : 0;  // of the fast body: the lower slot is A
  if (gjk_scene_is_refused(v, side == 0 ? s->slot : met->body, side == 0 ? met->body : s->slot)) {
    return;
  }
  gjk_scene_mover m[2];
  const gjk_scene_part *p[2];
  gjk_copy(&m[side], &s->self, sizeof m[side]);
  gjk_copy(&m[1 - side], of_other, sizeof m[1 - side]);
  p[side] = own;
  p[1 - side] = met;
  gjk_scene_impact found;
  gjk_scene_find_impact(v, m, p, &found);
  if (found.hit && found.at_start && were_near(v, s->part, other)) {
    gjk_scene_find_impact_ahead(v, m, p, &found);
  }
  if (!found.hit) {
    return;
  }
  const uint32_t fraction = gjk_scene_larger(found.fraction, entered);
  if (comes_first(s, fraction, own, met)) {
    s->first->other = other;
    s->first->fraction = fraction;
    s->first->number = own->number;
  }
  if (found.unproven) {
    s->first->state |= GJK_SCENE_UNPROVEN;
  }
}

// Steps 2 and 3: the parts whose bodies stand, or those whose bodies moved by at most reach.
static void search_parts(body_sweep *s, bool moved, uint32_t reach) {
  const gjk_scene_view *v = s->v;
  const gjk_scene_part *own = &v->parts[s->part];
  const bool turns = gjk_scene_turns_with(v, &s->self, own);
  gjk_aabb box;
  gjk_collider c;
  if (turns) {
    box.lower = s->self.from.position;
    box.upper = s->self.from.position;
  } else {
    gjk_scene_at_start(v, &s->self, own, &c);
    (void)gjk_collider_aabb(&c, &box);  // posed, so it cannot fail
  }
  gjk_scene_passage_start(v, &s->passage, &box,
                          (int64_t)reach + GJK_SCENE_EARLY + (turns ? gjk_scene_reach_of(v, own) : 0),
                          &s->self.from.position, &s->self.to.position);
  for (;;) {  // ends: each part comes once
    gjk_scene_mover of_other;
    uint32_t entered;
    if (s->first->other != GJK_SCENE_NONE) {
      s->passage.latest = s->first->fraction;
    }
    const uint32_t other = gjk_scene_passage_next(v, &s->passage, &entered);
    if (other == GJK_SCENE_NONE) {
      return;
    }
    const uint32_t slot = v->parts[other].body;
    if (slot != s->slot && !gjk_scene_is_sensor(&v->bodies[slot])) {
      set_mover(v, slot, &of_other);
      if (of_other.moves == moved) {
        meet_part(s, other, &of_other, entered);
      }
    }
  }
}

// Sweeps the body of one record. Returns whether there was anything to do.
static bool sweep_body(const gjk_scene_view *v, gjk_scene_kept *k) {
  const unsigned flags = v->bodies[k->slot].flags;
  const uint32_t reach = k->fraction;
  body_sweep s;
  s.v = v;
  s.slot = k->slot;
  s.first = k;
  k->state = GJK_SCENE_SWEPT;
  k->fraction = 0;
  set_mover(v, k->slot, &s.self);
  if ((flags & GJK_SCENE_FAST) == 0 || (!s.self.moves && (reach == 0 || (flags & GJK_SCENE_ASLEEP) != 0))) {
    return false;
  }
  for (s.part = v->bodies[k->slot].first; s.part != GJK_SCENE_NONE; s.part = v->parts[s.part].next) {
    if (s.self.moves) {
      search_parts(&s, false, 0);
    }
    if (reach > 0) {
      search_parts(&s, true, reach);
    }
  }
  return true;
}

// Sweeps at most so many bodies that are not swept yet, in order.
static void sweep_bodies(gjk_scene_view *v, uint32_t tests) {
  gjk_scene_header *h = v->header;
  for (; h->next_test - h->queued < h->kept; h->next_test++) {
    gjk_scene_kept *k = &v->kept[h->next_test - h->queued];
    if ((k->state & GJK_SCENE_SWEPT) == 0) {
      if (tests == 0) {
        return;
      }
      tests -= sweep_body(v, k);
    }
  }
}

// Step 6.
static void end_sweeps(gjk_scene_view *v) {
  for (uint32_t i = 0; i < v->header->kept; i++) {
    gjk_scene_kept *k = &v->kept[i];
    gjk_scene_pose_of(&v->bodies[k->slot], &k->last);
    v->header->stats.unsettled += (k->state & GJK_SCENE_UNPROVEN) != 0;
  }
}

static void report_impact(const gjk_scene_view *v, const gjk_scene_kept *k, gjk_report *out) {
  //@ assert k->other < v->header->parts.capacity;
  const gjk_scene_part *other = &v->parts[k->other];
  out->a = gjk_scene_id_of(v, k->slot);
  out->b = gjk_scene_id_of(v, other->body);
  out->user_a = v->bodies[k->slot].user;
  out->user_b = v->bodies[other->body].user;
  out->part_a = k->number;
  out->part_b = other->number;
  out->event = GJK_EVENT_IMPACT;
  out->detail = gjk_scene_detail(v, &v->bodies[k->slot], &v->bodies[other->body]);
  out->still = false;
  out->distance = 0;
  out->manifold = NULL;
  out->words = NULL;
  out->fraction = gjk_int32(k->fraction);
}

// Step 9 of an update, impacts: those of the records from next_report on. Counts those that do not fit.
static void report_impacts(gjk_scene_view *v, gjk_report *reports, uint32_t capacity, gjk_progress *progress) {
  gjk_scene_header *h = v->header;
  for (uint32_t i = h->next_report; i < h->kept; i++) {
    const gjk_scene_kept *k = &v->kept[i];
    if (k->other != GJK_SCENE_NONE && progress->reports < capacity) {
      report_impact(v, k, &reports[progress->reports++]);
    } else if (k->other != GJK_SCENE_NONE) {
      progress->reports_left++;
    }
    h->next_report += progress->reports_left == 0;
  }
}

// Step 9. The pairs come first. Their last report would end the update; then the queue is empty, and impacts follow.
static void write_all_reports(gjk_scene_view *v, gjk_report *reports, uint32_t capacity, gjk_progress *progress) {
  gjk_scene_header *h = v->header;
  progress->reports_left = 0;
  if (h->queued > 0) {
    gjk_scene_write_reports(v, reports, capacity, progress);
    if (h->phase != GJK_SCENE_IDLE) {
      for (uint32_t i = 0; i < h->kept; i++) {
        progress->reports_left += v->kept[i].other != GJK_SCENE_NONE;
      }
      return;
    }
    h->phase = GJK_SCENE_REPORTING;
    h->updates--;
    h->next_report = 0;
  }
  report_impacts(v, reports, capacity, progress);
  if (progress->reports_left == 0) {
    h->updates++;
    h->phase = GJK_SCENE_IDLE;
  }
}

static void update_all(gjk_scene_view *v, uint32_t tests, gjk_report *reports, uint32_t capacity,
                       gjk_progress *progress) {
  gjk_scene_header *h = v->header;
  if (h->phase == GJK_SCENE_TESTING) {
    const uint32_t before = h->next_test;
    gjk_scene_test_queue(v, tests);
    if (h->next_test >= h->queued) {
      const uint32_t passed = before < h->queued ? h->queued - before : 0;
      sweep_bodies(v, tests > passed ? tests - passed : 0);
    }
    progress->pairs_left = h->queued + h->kept - h->next_test;
    progress->reports_left = 0;
    if (progress->pairs_left > 0) {
      return;
    }
    gjk_scene_make_events(v);
    end_sweeps(v);
  }
  write_all_reports(v, reports, capacity, progress);
}

static void restart_way(gjk_scene_view *v, uint32_t slot) {
  gjk_scene_pose_of(&v->bodies[slot], &v->kept[place_of(v, slot)].last);
}

static void forget_motion_of(gjk_scene_view *v, uint32_t slot) {
  gjk_scene_header *h = v->header;
  gjk_scene_body *body = &v->bodies[slot];
  body->flags = (uint8_t)(body->flags & ~(GJK_SCENE_KEPT | GJK_SCENE_FAST));
  h->kept--;
  for (uint32_t i = place_of(v, slot); i < h->kept; i++) {
    v->kept[i] = v->kept[i + 1];
  }
}

// Adds a record. Pre: there is room.
static void keep_motion(gjk_scene_view *v, uint32_t slot) {
  gjk_scene_header *h = v->header;
  const uint32_t at = place_of(v, slot);
  for (uint32_t i = h->kept; i > at; i--) {
    v->kept[i] = v->kept[i - 1];
  }
  h->kept++;
  v->kept[at].slot = slot;
  gjk_scene_pose_of(&v->bodies[slot], &v->kept[at].last);
  v->kept[at].other = GJK_SCENE_NONE;
  v->kept[at].fraction = 0;
  v->kept[at].number = v->kept[at].state = 0;
}

gjk_status gjk_scene_set_motion(gjk_scene *scene, gjk_body_id id, uint8_t motion) {
  gjk_scene_view v;
  gjk_scene_body *body;
  gjk_status status = gjk_scene_edit(scene, &v);
  if (status == GJK_OK) {
    status = gjk_scene_body_of(&v, id, &body);
  }
  if (status != GJK_OK) {
    return status;
  }
  if (motion > GJK_MOTION_FAST || (body->kind_detail & 15u) == GJK_BODY_STATIC || gjk_scene_is_sensor(body)) {
    return GJK_ERROR_RANGE;
  }
  if (scene->bindings.motion == NULL) {
    return GJK_ERROR_UNSUPPORTED;
  }
  const bool kept = (body->flags & GJK_SCENE_KEPT) != 0;
  if (!kept && motion != GJK_MOTION_NOT_KEPT) {
    if (v.header->kept == v.header->config.motions) {
      return GJK_ERROR_CAPACITY;
    }
    keep_motion(&v, id.slot);
  } else if (kept && motion == GJK_MOTION_NOT_KEPT) {
    forget_motion_of(&v, id.slot);
  }
  body->flags = (uint8_t)(body->flags & ~(GJK_SCENE_KEPT | GJK_SCENE_FAST));
  if (motion != GJK_MOTION_NOT_KEPT) {
    body->flags |= GJK_SCENE_KEPT;
  }
  if (motion == GJK_MOTION_FAST) {
    body->flags |= GJK_SCENE_FAST;
  }
  return GJK_OK;
}

// Opens a scene whose pairs are being tested.
static gjk_status open_sweeps(const gjk_scene *scene, gjk_scene_view *v) {
  const gjk_status status = gjk_scene_view_of(scene, v);
  return status == GJK_OK && v->header->phase != GJK_SCENE_TESTING ? GJK_ERROR_RANGE : status;
}

gjk_status gjk_scene_sweep_count(const gjk_scene *scene, uint32_t *count) {
  gjk_scene_view v;
  const gjk_status status = count == NULL ? GJK_ERROR_NULL : open_sweeps(scene, &v);
  if (status == GJK_OK) {
    *count = v.header->kept;
  }
  return status;
}

gjk_status gjk_scene_sweep(gjk_scene *scene, uint32_t first, uint32_t end) {
  gjk_scene_view v;
  const gjk_status status = open_sweeps(scene, &v);
  if (status != GJK_OK) {
    return status;
  }
  if (first > end || end > v.header->kept) {
    return GJK_ERROR_RANGE;
  }
  for (uint32_t i = first; i < end; i++) {
    if ((v.kept[i].state & GJK_SCENE_SWEPT) == 0) {
      (void)sweep_body(&v, &v.kept[i]);
    }
  }
  return GJK_OK;
}

const gjk_scene_motions gjk_scene_motion = {
    .prepare = begin_sweeps, .update = update_all, .restart = restart_way, .forget = forget_motion_of};
