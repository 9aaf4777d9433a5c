// Checks every index and invariant of a block, which may hold anything.
//
// Each pass ends whatever the block holds: it visits each record once, or follows a list no longer than there are
// records. A pass reads a record through an index only after it or an earlier pass has checked that index.
#include "gjk_scene_pairs.h"
#include "gjk_scene_part.h"
#include "gjk_scene_tree.h"

static bool live_part(const gjk_scene_view *v, uint32_t index) {
  return index < v->header->parts.fresh && (v->parts[index].state & GJK_SCENE_LIVE) != 0;
}

static bool live_pair(const gjk_scene_view *v, uint32_t index) {
  return index < v->header->pairs.fresh && (v->pairs[index].state & GJK_SCENE_PAIR_LIVE) != 0;
}

static bool is_gone(const gjk_scene_pair *pair) {
  return (pair->state & GJK_SCENE_PAIR_GONE) != 0;
}

// Is a record of own_poses in use? Then its next is the part that has it, and that part names it. The next of a free
// one is a free one or none.
static bool own_pose_is_used(const gjk_scene_view *v, uint32_t index) {
  const uint32_t part = v->own_poses[index].next;
  return live_part(v, part) && v->parts[part].own_pose == index;
}

// The list of free records has fresh - count members, none of them in use, and then ends.
static bool check_free(const gjk_scene_view *v, const gjk_scene_pool *pool, uint32_t size) {
  const gjk_scene_header *h = v->header;
  uint32_t at = pool->free;
  for (uint32_t left = pool->fresh - pool->count; left > 0; left--) {
    if (at >= pool->fresh || (pool == &h->parts && live_part(v, at)) || (pool == &h->pairs && live_pair(v, at)) ||
        (pool == &h->nodes && v->nodes[at].height != 0) || (pool == &h->own_poses && own_pose_is_used(v, at))) {
      return false;
    }
    const void *record = (const unsigned char *)(const void *)h + (size_t)(pool->at + at * size);
    at = *(const uint32_t *)record;
  }
  return at == GJK_SCENE_NONE;
}

static bool check_own_pose(const gjk_scene_view *v, uint32_t index, uint32_t *own_poses) {
  const uint32_t at = v->parts[index].own_pose;
  if (at == GJK_SCENE_NONE) {
    return true;
  }
  (*own_poses)++;
  return at < v->header->own_poses.fresh && v->own_poses[at].next == index &&
         gjk_scene_is_rotation(&v->own_poses[at].pose.rotation);
}

static bool same_box(const gjk_aabb *a, const gjk_aabb *b) {
  return gjk_scene_same_vec3(&a->lower, &b->lower) && gjk_scene_same_vec3(&a->upper, &b->upper);
}

// Does a part hold exactly what posing its shape gave? Posing repeats bit for bit.
static bool check_posed(const gjk_scene_part *p, const gjk_collider *c, const gjk_aabb *box) {
  return gjk_scene_holds(p, c) && same_box(&p->exact, box);
}

// Is a part that is not posed one that nothing takes for posed? An update poses parts with pairs before it tests any,
// but only those of bodies that moved. What posing leaves as it is must be 0, and exact must hold the part.
static bool check_unposed(const gjk_scene_view *v, const gjk_scene_body *body, const gjk_scene_part *p,
                          const gjk_collider *c, const gjk_aabb *box) {
  return gjk_scene_holds_unposed(p, c) && gjk_aabb_inside(box, &p->exact) &&
         (p->pairs == GJK_SCENE_NONE || (v->header->phase == GJK_SCENE_IDLE && (body->flags & GJK_SCENE_MOVED) != 0));
}

// Is a part where posing its shape puts it? Then all that queries assume of a collider holds for the part.
static bool check_pose(const gjk_scene_view *v, const gjk_scene_body *body, const gjk_scene_part *p) {
  const uint32_t own_pose = p->own_pose;
  gjk_pose pose;
  gjk_aabb box;
  gjk_collider c;
  pose.position = body->position;
  pose.rotation = body->rotation;
  //@ assert own_pose == GJK_SCENE_NONE || own_pose < v->header->own_poses.fresh;
  if (gjk_scene_part_build(v, p->shape, &pose, own_pose == GJK_SCENE_NONE ? NULL : &v->own_poses[own_pose].pose, &c) !=
      GJK_OK) {
    return false;
  }
  (void)gjk_collider_aabb(&c, &box);  // posed, so it cannot fail
  return gjk_scene_holds_shape(p, &c) &&
         ((p->state & GJK_SCENE_UNPOSED) != 0 ? check_unposed(v, body, p, &c, &box) : check_posed(p, &c, &box));
}

// Does a body have as many parts as it says, numbered in order? Adds up its parts and their own poses.
static bool check_parts(const gjk_scene_view *v, uint32_t slot, uint32_t *parts, uint32_t *own_poses) {
  uint32_t number = 0;
  for (uint32_t i = v->bodies[slot].first; i != GJK_SCENE_NONE; i = v->parts[i].next) {
    if (!live_part(v, i)) {
      return false;
    }
    const gjk_scene_part *p = &v->parts[i];
    if (p->body != slot || p->number != number || (p->state & GJK_SCENE_MARK) != 0 || !gjk_scene_part_fits(v, p) ||
        !check_own_pose(v, i, own_poses) || !check_pose(v, &v->bodies[slot], p)) {
      return false;
    }
    number++;
  }
  *parts += number;
  return number == gjk_scene_part_count(&v->bodies[slot], v->parts) && number > 0;
}

static bool check_body(const gjk_scene_view *v, uint32_t slot) {
  const gjk_scene_body *body = &v->bodies[slot];
  return (body->kind_detail & 15u) <= GJK_BODY_DYNAMIC &&
         (gjk_scene_is_sensor(body) || (uint32_t)body->kind_detail >> 4 <= v->header->most_detail) &&
         body->margin >= 0 && body->margin <= GJK_RADIUS_MAX && gjk_scene_is_rotation(&body->rotation);
}

static bool check_bodies(const gjk_scene_view *v) {
  const gjk_scene_header *h = v->header;
  uint32_t bodies = 0, parts = 0, own_poses = 0;
  for (uint32_t slot = 0; slot < h->config.bodies; slot++) {
    const gjk_scene_body *body = &v->bodies[slot];
    const bool free = (v->slots[slot / 32] >> slot % 32 & 1u) != 0, live = body->generation % 2 != 0;
    if ((free && (live || slot / 32 < h->lowest)) || (!free && !live && body->generation != 0) ||
        (slot >= h->bodies.fresh && body->generation != 0)) {
      return false;
    }
    if (live) {
      bodies++;
      if (!check_body(v, slot) || !check_parts(v, slot, &parts, &own_poses)) {
        return false;
      }
    } else if ((body->generation != 0 || (body->flags & GJK_SCENE_MOVED) != 0) && body->first != GJK_SCENE_NONE) {
      return false;  // a slot that was never used has first 0, but is in no list
    }
  }
  const uint32_t last = h->config.bodies % 32;  // bits beyond the last slot must be 0
  if (last != 0 && v->slots[h->config.bodies / 32] >> last != 0) {
    return false;
  }
  return bodies == h->bodies.count && parts == h->parts.count && own_poses == h->own_poses.count;
}

// Does the list of moved bodies have each flagged body once?
static bool check_moved(const gjk_scene_view *v) {
  const gjk_scene_header *h = v->header;
  uint32_t flagged = 0, listed = 0;
  for (uint32_t slot = 0; slot < h->config.bodies; slot++) {
    flagged += (v->bodies[slot].flags & GJK_SCENE_MOVED) != 0 ? 1 : 0;
  }
  for (uint32_t slot = h->moved; slot != GJK_SCENE_NONE; slot = v->bodies[slot].next_moved) {
    if (slot >= h->config.bodies || (v->bodies[slot].flags & GJK_SCENE_MOVED) == 0 || listed++ == flagged) {
      return false;
    }
  }
  return listed == flagged;
}

static uint32_t parent_of(const gjk_scene_view *v, uint32_t node) {
  return (node & GJK_SCENE_LEAF) != 0 ? v->parts[node & ~GJK_SCENE_LEAF].parent : v->nodes[node].parent;
}

static uint32_t height_of(const gjk_scene_view *v, uint32_t node) {
  return (node & GJK_SCENE_LEAF) != 0 ? 0 : v->nodes[node].height;
}

static bool is_node(const gjk_scene_view *v, uint32_t node) {
  return (node & GJK_SCENE_LEAF) != 0 ? live_part(v, node & ~GJK_SCENE_LEAF)
                                      : node < v->header->nodes.fresh && v->nodes[node].height != 0;
}

// Do the children of an inner node name it as their parent, lie in its box, and differ in height by at most 1?
static bool check_inner(const gjk_scene_view *v, uint32_t node) {
  const gjk_scene_node *n = &v->nodes[node];
  if (n->child[0] == n->child[1]) {
    return false;
  }
  uint32_t heights[2];
  for (int i = 0; i < 2; i++) {
    const uint32_t child = n->child[i];
    if (!is_node(v, child) || parent_of(v, child) != node || !gjk_aabb_inside(gjk_scene_node_box(v, child), &n->box)) {
      return false;
    }
    heights[i] = height_of(v, child);
  }
  const uint32_t a = heights[0], b = heights[1];
  return a <= b + 1 && b <= a + 1 && n->height == (a > b ? a : b) + 1;
}

// Is all of the tree sound? A walk reaches each node at most once, because a node has one parent.
static bool check_tree(const gjk_scene_view *v) {
  const gjk_scene_header *h = v->header;
  gjk_scene_walk walk;
  uint32_t leaves = 0, inner = 0;
  if (h->root != GJK_SCENE_NONE && (!is_node(v, h->root) || parent_of(v, h->root) != GJK_SCENE_NONE)) {
    return false;
  }
  gjk_scene_walk_start(v, &walk);
  for (uint32_t node = gjk_scene_walk_next(&walk); node != GJK_SCENE_NONE; node = gjk_scene_walk_next(&walk)) {
    if ((node & GJK_SCENE_LEAF) != 0) {
      leaves++;
      continue;
    }
    //@ assert node < h->nodes.fresh;
    // not reached: more than count: all others are free, and each is reached at most once
    if (!check_inner(v, node) || inner++ == h->nodes.count || walk.count > GJK_SCENE_DEPTH - 2) {
      return false;
    }
    gjk_scene_walk_descend(v, &walk, node);
  }
  return leaves == h->parts.count && inner == h->nodes.count;
}

// Do both neighbours of a link in its list point back to it? Pre: part is the live part of that side.
static bool check_link(const gjk_scene_view *v, uint32_t link, uint32_t part) {
  const gjk_scene_pair *pair = &v->pairs[link / 2];
  const uint32_t next = gjk_scene_next(pair, link % 2), previous = gjk_scene_previous(pair, link % 2);
  const uint32_t after = next / 2, before = previous / 2;
  if (previous == GJK_SCENE_NONE ? v->parts[part].pairs != link
                                 : !live_pair(v, before) || is_gone(&v->pairs[before]) ||
                                       gjk_scene_next(&v->pairs[before], previous % 2) != link ||
                                       gjk_scene_end(&v->pairs[before], previous % 2) != part) {
    return false;
  }
  return next == GJK_SCENE_NONE ||
         (live_pair(v, after) && !is_gone(&v->pairs[after]) && gjk_scene_previous(&v->pairs[after], next % 2) == link);
}

// May gap be negative? It may be minus the depth of a near pair: near in this update, if it was tested, or in the last
// one.
static bool may_be_deep(const gjk_scene_view *v, const gjk_scene_pair *pair, uint32_t slot_a, uint32_t slot_b) {
  const bool tested = (pair->state & GJK_SCENE_PAIR_QUEUED) != 0 && !gjk_scene_is_pending(pair);
  return gjk_scene_detail(v, &v->bodies[slot_a], &v->bodies[slot_b]) == GJK_DETAIL_DEPTH &&
         (pair->state & (tested ? GJK_SCENE_PAIR_NEAR_NOW : GJK_SCENE_PAIR_NEAR)) != 0;
}

static bool check_pair(const gjk_scene_view *v, uint32_t index) {
  const gjk_scene_pair *pair = &v->pairs[index];
  const uint32_t a = gjk_scene_end(pair, 0), b = gjk_scene_end(pair, 1);
  const unsigned outcome = pair->outcome & (GJK_SCENE_UNSETTLED - 1u);
  if (pair->state >> GJK_SCENE_PAIR_CACHED > 4 || outcome >= GJK_SCENE_OUTCOMES ||
      (pair->outcome & GJK_SCENE_NO_FLAG) != 0 || (outcome == GJK_SCENE_PENDING && !gjk_scene_is_pending(pair))) {
    return false;
  }
  if (is_gone(pair)) {
    return (pair->state & GJK_SCENE_PAIR_NEAR) != 0;
  }
  if (!live_part(v, a) || !live_part(v, b)) {
    return false;
  }
  const uint32_t slot_a = v->parts[a].body, slot_b = v->parts[b].body;
  //@ assert slot_b < v->header->config.bodies;
  return slot_a < slot_b && check_link(v, 2 * index, a) && check_link(v, 2 * index + 1, b) &&
         (pair->gap >= 0 || may_be_deep(v, pair, slot_a, slot_b));
}

static bool check_pairs(const gjk_scene_view *v) {
  const gjk_scene_header *h = v->header;
  uint32_t pairs = 0, missing = 0, linked = 0, listed = 0, queued = 0;
  for (uint32_t i = 0; i < h->pairs.fresh; i++) {
    if (live_pair(v, i)) {
      pairs++;
      queued += (v->pairs[i].state & GJK_SCENE_PAIR_QUEUED) != 0 ? 1 : 0;
      missing += is_gone(&v->pairs[i]);
      if (!check_pair(v, i)) {
        return false;
      }
    } else if (v->pairs[i].state != 0) {
      return false;
    }
  }
  // The lists of all parts together have every link, so no links form a ring outside of the lists.
  for (uint32_t i = 0; i < h->parts.fresh; i++) {
    uint32_t link = live_part(v, i) ? v->parts[i].pairs : GJK_SCENE_NONE;
    while (link != GJK_SCENE_NONE) {
      const uint32_t index = link / 2;
      if (!live_pair(v, index) || gjk_scene_end(&v->pairs[index], link % 2) != i || linked++ == 2 * pairs) {
        return false;
      }
      link = gjk_scene_next(&v->pairs[index], link % 2);
    }
  }
  for (uint32_t i = h->gone; i != GJK_SCENE_NONE; i = gjk_scene_gone_next(&v->pairs[i])) {
    if (!live_pair(v, i) || !is_gone(&v->pairs[i]) || listed++ == missing) {
      return false;
    }
  }
  for (uint32_t i = h->next_report; h->phase == GJK_SCENE_REPORTING && i < h->queued; i++) {
    const uint32_t index = v->queue[i];
    //@ assert index < h->pairs.fresh;
    listed += is_gone(&v->pairs[index]) ? 1 : 0;
  }
  return pairs == h->pairs.count && linked == 2 * (pairs - missing) && listed == missing &&
         queued == (h->phase == GJK_SCENE_TESTING ? h->queued : 0);
}

// May the queue have this pair at this place, in this phase?
static bool check_entry(const gjk_scene_view *v, uint32_t at, const gjk_scene_pair *pair) {
  const gjk_scene_header *h = v->header;
  const bool queued = (pair->state & GJK_SCENE_PAIR_QUEUED) != 0;
  if (h->phase == GJK_SCENE_TESTING) {
    return queued && !is_gone(pair) && (at >= h->next_test || !gjk_scene_is_pending(pair));
  }
  const unsigned event = pair->outcome & ~GJK_SCENE_TOLD;
  return !queued && event >= (is_gone(pair) ? GJK_EVENT_END : GJK_EVENT_BEGIN) && event <= GJK_EVENT_END;
}

// Does the queue have each pair at most once? The first loop flips QUEUED of each pair in it, so check_entry refuses a
// pair that comes again. The second loop flips them back.
static bool check_entries(const gjk_scene_view *v) {
  const gjk_scene_header *h = v->header;
  const uint32_t first = h->phase == GJK_SCENE_REPORTING ? h->next_report : 0;
  uint32_t end = first;
  for (; end < h->queued; end++) {
    const uint32_t index = v->queue[end];
    if (!live_pair(v, index) || !check_entry(v, end, &v->pairs[index])) {
      break;
    }
    v->pairs[index].state ^= GJK_SCENE_PAIR_QUEUED;
  }
  for (uint32_t i = first; i < end; i++) {
    const uint32_t index = v->queue[i];
    //@ assert index < h->pairs.fresh;
    v->pairs[index].state ^= GJK_SCENE_PAIR_QUEUED;
  }
  return end >= h->queued;
}

static bool check_queue(const gjk_scene_view *v) {
  const gjk_scene_header *h = v->header;
  if (h->most_detail > GJK_DETAIL_CONTACTS || h->most_detail < h->config.detail || h->phase > GJK_SCENE_REPORTING ||
      h->queued > h->pairs.capacity || h->lowest > (h->config.bodies + 31) / 32 ||
      (h->phase == GJK_SCENE_IDLE && h->queued != 0) ||
      (h->phase == GJK_SCENE_TESTING && h->next_test > h->queued + h->kept) ||
      (h->phase == GJK_SCENE_REPORTING && (h->next_report > h->queued + h->kept || h->gone != GJK_SCENE_NONE))) {
    return false;
  }
  return check_entries(v);
}

// Can each part of a body be posed where it was?
static bool check_last(const gjk_scene_view *v, const gjk_scene_body *body, const gjk_pose *last) {
  gjk_collider c;
  for (uint32_t i = body->first; i != GJK_SCENE_NONE; i = v->parts[i].next) {
    if (gjk_scene_part_at(v, &v->parts[i], last, &c) != GJK_OK) {
      return false;
    }
  }
  return true;
}

// May a kept motion name this part? Between updates nothing reads it. In an update a body that is not swept has met none,
// and what a sweep found is read until it is reported.
static bool check_met(const gjk_scene_view *v, const gjk_scene_kept *k) {
  return v->header->phase == GJK_SCENE_IDLE || k->other == GJK_SCENE_NONE ||
         ((k->state & GJK_SCENE_SWEPT) != 0 && live_part(v, k->other));
}

// Do the kept motions name the flagged bodies, each once, in the order of slots?
static bool check_kept(const gjk_scene_view *v) {
  const gjk_scene_header *h = v->header;
  uint32_t flagged = 0;
  for (uint32_t slot = 0; slot < h->config.bodies; slot++) {
    const unsigned flags = v->bodies[slot].flags;
    flagged += (flags & GJK_SCENE_KEPT) != 0 ? 1 : 0;
    if ((flags & (GJK_SCENE_KEPT | GJK_SCENE_FAST)) == GJK_SCENE_FAST) {
      return false;
    }
  }
  for (uint32_t i = 0; i < h->kept; i++) {
    const gjk_scene_kept *k = &v->kept[i];
    if (k->slot >= h->config.bodies || (i > 0 && k->slot <= v->kept[i - 1].slot)) {
      return false;
    }
    const gjk_scene_body *body = &v->bodies[k->slot];
    if (body->generation % 2 == 0 || (body->flags & GJK_SCENE_KEPT) == 0 ||
        (body->kind_detail & 15u) == GJK_BODY_STATIC || gjk_scene_is_sensor(body) || !check_last(v, body, &k->last) ||
        !check_met(v, k)) {
      return false;
    }
  }
  return flagged == h->kept;
}

gjk_status gjk_scene_check(const gjk_scene *scene) {
  gjk_scene_view v;
  gjk_status status = gjk_scene_view_of(scene, &v);
  if (status == GJK_OK) {
    status = gjk_scene_check_header(scene->block, (size_t)v.header->bytes);
  }
  if (status != GJK_OK) {
    return status;
  }
  const gjk_scene_header *h = v.header;
  for (uint32_t i = 0; i < h->parts.fresh; i++) {
    const uint16_t shape = v.parts[i].shape;
    if (live_part(&v, i) && (shape >= scene->shape_count || scene->shapes[shape] == NULL)) {
      return GJK_ERROR_RANGE;
    }
  }
  const bool sound =
      check_free(&v, &h->parts, sizeof(gjk_scene_part)) && check_free(&v, &h->nodes, sizeof(gjk_scene_node)) &&
      check_free(&v, &h->own_poses, sizeof(gjk_scene_own_pose)) && check_free(&v, &h->pairs, sizeof(gjk_scene_pair)) &&
      check_bodies(&v) && check_moved(&v) && check_tree(&v) && check_queue(&v) && check_pairs(&v) && check_kept(&v);
  return sound ? GJK_OK : GJK_ERROR_CORRUPT;
}
