// The class of compounds: several shapes at poses, and the boxes above them.
#include "gjk/compound.h"
#include "gjk/pose.h"

#include "gjk_parts_class.h"

static const gjk_compound *compound_of(const void *data) {
  return (const gjk_compound *)data;
}

static uint32_t count_of_compound(const void *data) {
  const gjk_compound *c = compound_of(data);
  return c->parts == NULL || c->nodes == NULL || c->node_count == 0 ? 0 : c->count;
}

static uint32_t reach_of_compound(const void *data) {
  return compound_of(data)->reach;
}

static bool is_leaf(const gjk_compound_node *n) {
  return n->part != UINT16_MAX;
}

// By how much a span lies below or above another one.
static int64_t box_gap_along(gjk_q16 lower, gjk_q16 upper, gjk_q16 own_lower, gjk_q16 own_upper) {
  return lower > own_upper ? (int64_t)lower - own_upper : own_lower > upper ? (int64_t)own_lower - upper : 0;
}

// How far a box is from another one: the sum of the gaps along the axes, below 3 2^32.
static int64_t box_gap(const gjk_aabb *box, const gjk_aabb *own) {
  return box_gap_along(box->lower.x, box->upper.x, own->lower.x, own->upper.x) +
         box_gap_along(box->lower.y, box->upper.y, own->lower.y, own->upper.y) +
         box_gap_along(box->lower.z, box->upper.z, own->lower.z, own->upper.z);
}

// The next node of a walk that leaves out what is below node i. Nodes that are not as built never lead back.
static uint32_t after_node(const gjk_compound *c, uint32_t i) {
  return c->nodes[i].skip > i ? c->nodes[i].skip : i + 1;
}

// Of a list the nearest box; in a tree down to a leaf, always to the nearer one of two boxes.
static uint32_t guess_in_compound(const void *data, const gjk_region *region) {
  const gjk_compound *c = compound_of(data);
  const uint32_t end = c->node_count;
  uint32_t best = 0;
  if (is_leaf(&c->nodes[0])) {
    int64_t least = box_gap(&c->nodes[0].box, &region->box);
    for (uint32_t i = 1; i < end && least > 0; i++) {
      const int64_t gap = box_gap(&c->nodes[i].box, &region->box);
      if (gap < least) {
        least = gap;
        best = i;
      }
    }
  } else {
    while (!is_leaf(&c->nodes[best]) && best + 1 < end) {  // ends: best rises
      const uint32_t left = best + 1, right = after_node(c, left);
      best = right < end && box_gap(&c->nodes[right].box, &region->box) < box_gap(&c->nodes[left].box, &region->box)
                 ? right
                 : left;
    }
  }
  return c->nodes[best].part < c->count ? c->nodes[best].part : 0;
}

// The next leaf in the order of the nodes, but one. False: there is none.
static bool next_part_but(const gjk_compound *c, const gjk_region *region, gjk_parts_walk *walk, uint32_t but) {
  while (walk->node < c->node_count) {  // ends: walk->node rises
    const uint32_t i = walk->node;
    const gjk_compound_node *n = &c->nodes[i];
    if (i != but && gjk_region_meets(region, &n->box)) {
      walk->node++;
      if (is_leaf(n)) {
        return true;
      }
    } else {
      walk->node = after_node(c, i);
    }
  }
  return false;
}

// A node and how many leaves there are from it on: a tree over k leaves takes 2 k - 1 nodes, as it is built.
typedef struct compound_tree {
  uint32_t at, leaves;
} compound_tree;

// One half of a tree.
static compound_tree half_of_tree(const compound_tree *t, bool right) {
  const uint32_t left = t->leaves / 2;
  const compound_tree half = {right ? t->at + 2 * left : t->at + 1, right ? t->leaves - left : left};
  return half;
}

static int64_t rise_along(gjk_q16 lower, gjk_q16 upper, gjk_q16 to_lower, gjk_q16 to_upper) {
  return (int64_t)to_lower + to_upper - lower - upper;
}

// Does a way come to the right half of a tree first?
static bool right_is_first(const gjk_compound *c, const gjk_region *region, const compound_tree *t) {
  const gjk_aabb *a = &c->nodes[half_of_tree(t, false).at].box, *b = &c->nodes[half_of_tree(t, true).at].box;
  const int64_t rise[3] = {rise_along(a->lower.x, a->upper.x, b->lower.x, b->upper.x),
                           rise_along(a->lower.y, a->upper.y, b->lower.y, b->upper.y),
                           rise_along(a->lower.z, a->upper.z, b->lower.z, b->upper.z)};
  return gjk_region_comes_back(region, rise);
}

// The tree that a path from the root leads to. path: 1, and a bit for each half, the last one lowest: 1 for the right one.
static compound_tree tree_at(const gjk_compound *c, uint32_t path) {
  compound_tree t = {0, (c->node_count + UINT32_C(1)) / 2};
  for (unsigned i = 31 - gjk_clz32(path); i > 0; i--) {
    t = half_of_tree(&t, (path >> (i - 1) & 1u) != 0);
  }
  return t;
}

// Goes on to the last half that was put off. False: there is none.
static bool take_half(gjk_parts_walk *walk) {
  while (walk->node > 1 && (walk->item & 1u) == 0) {  // ends: walk->node falls
    walk->node >>= 1;
    walk->item >>= 1;
  }
  if (walk->node == 1) {
    return false;
  }
  walk->node ^= 1u;
  walk->item ^= 1u;
  return true;
}

// The next leaf of a tree on a way, from near to far: of two halves that the region meets, the one that the way comes to
// first is next, and the other is put off. False: there is none.
//
// walk->node  the path to the leaf that came last; 0: none yet
// walk->item  a bit for each of the path's: 1: the other half is put off. Trees are at most 15 high, so both fit.
static bool next_part_on_way(const gjk_compound *c, const gjk_region *region, gjk_parts_walk *walk, uint32_t *number) {
  bool goes_on = walk->node == 0 || take_half(walk);
  walk->node = walk->node == 0 ? 1 : walk->node;
  while (goes_on) {  // ends: each node comes once
    compound_tree t = tree_at(c, walk->node);
    bool meets = gjk_region_touches(region, &c->nodes[t.at].box);  // across the way it did, or its halves tell
    while (meets && t.leaves > 1) {                                // ends: t.leaves falls
      const compound_tree left = half_of_tree(&t, false), right = half_of_tree(&t, true);
      const bool meets_left = gjk_region_meets(region, &c->nodes[left.at].box);
      const bool meets_right = gjk_region_meets(region, &c->nodes[right.at].box);
      const bool goes_right = meets_right && (!meets_left || right_is_first(c, region, &t));
      meets = meets_left || meets_right;
      t = goes_right ? right : left;
      walk->node = walk->node << 1 | (goes_right ? 1u : 0u);
      walk->item = walk->item << 1 | (meets_left && meets_right ? 1u : 0u);
    }
    if (meets) {
      *number = c->nodes[t.at].part;
      return true;
    }
    goes_on = take_half(walk);
  }
  return false;
}

// Of those boxes of a list that the region meets, the one that is nearest to where its way starts; NONE: it meets none.
static uint32_t first_of_list(const gjk_compound *c, const gjk_region *r) {
  const gjk_aabb start = {{gjk_saturate(r->lower[0]), gjk_saturate(r->lower[1]), gjk_saturate(r->lower[2])},
                          {gjk_saturate(r->upper[0]), gjk_saturate(r->upper[1]), gjk_saturate(r->upper[2])}};
  uint32_t best = GJK_PARTS_NONE;
  int64_t least = INT64_MAX;
  for (uint32_t i = 0; i < c->node_count; i++) {
    const gjk_aabb *box = &c->nodes[i].box;
    const int64_t gap = box_gap(box, &start);
    if (gap < least && gjk_region_meets(r, box)) {
      least = gap;
      best = i;
    }
  }
  return best;
}

static bool next_in_compound(const void *data, const gjk_region *region, gjk_parts_walk *walk, uint32_t *number) {
  const gjk_compound *c = compound_of(data);
  if (region->moves && !is_leaf(&c->nodes[0])) {
    return next_part_on_way(c, region, walk, number);
  }
  if (region->moves && walk->item == 0) {
    const uint32_t first = first_of_list(c, region);
    if (first == GJK_PARTS_NONE) {
      return false;
    }
    walk->item = first + 1;
    *number = c->nodes[first].part;
    return true;
  }
  if (!next_part_but(c, region, walk, walk->item - 1)) {
    return false;
  }
  *number = c->nodes[walk->node - 1].part;
  return true;
}

static gjk_status place_in_compound(const gjk_parts_frame *frame, uint32_t number, gjk_parts_room *room,
                                    gjk_collider *out) {
  const gjk_compound *c = compound_of(frame->parts->data);
  gjk_pose pose;
  (void)room;
  if (number >= c->count) {
    return GJK_ERROR_RANGE;
  }
  const gjk_compound_part *part = &c->parts[number];
  gjk_status status = gjk_collider_init(out, part->shape, NULL, 0);
  status = status == GJK_OK ? gjk_pose_compose(&frame->parts->pose, &part->pose, &pose) : status;
  return status == GJK_OK ? gjk_collider_pose(out, &pose) : status;
}

static gjk_status local_in_compound(const void *data, uint32_t number, gjk_parts_room *room, gjk_parts_local *out) {
  const gjk_compound *c = compound_of(data);
  (void)room;
  if (number >= c->count) {
    return GJK_ERROR_RANGE;
  }
  out->shape = c->parts[number].shape;
  out->own = &c->parts[number].pose;
  return GJK_OK;
}

const gjk_parts_class gjk_parts_class_compound = {
    .count = count_of_compound,
    .reach = reach_of_compound,
    .guess = guess_in_compound,
    .next = next_in_compound,
    .place = place_in_compound,
    .local = local_in_compound,
    .settle = NULL,
    .meet = NULL,
    .edges = NULL,
};
