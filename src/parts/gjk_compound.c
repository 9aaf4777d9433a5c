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

// How far a box is from a region: the sum of the gaps along the axes, below 3 2^32.
static int64_t box_gap(const gjk_aabb *box, const gjk_region *region) {
  const gjk_aabb *own = &region->box;
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
    int64_t least = box_gap(&c->nodes[0].box, region);
    for (uint32_t i = 1; i < end && least > 0; i++) {
      const int64_t gap = box_gap(&c->nodes[i].box, region);
      if (gap < least) {
        least = gap;
        best = i;
      }
    }
  } else {
    while (!is_leaf(&c->nodes[best]) && best + 1 < end) {  // ends: best rises
      const uint32_t left = best + 1, right = after_node(c, left);
      best = right < end && box_gap(&c->nodes[right].box, region) < box_gap(&c->nodes[left].box, region) ? right : left;
    }
  }
  return c->nodes[best].part < c->count ? c->nodes[best].part : 0;
}

// The next leaf in the order of the nodes, but one. False: there is none.
static bool next_part_but(const gjk_compound *c, const gjk_region *region, gjk_parts_walk *walk, uint32_t but) {
  while (walk->node < c->node_count) {  // ends: walk->node rises
    const uint32_t i = walk->node;
    const gjk_compound_node *n = &c->nodes[i];
    if (i == but || !gjk_region_meets(region, &n->box)) {
      walk->node = after_node(c, i);
      continue;
    }
    walk->node++;
    if (is_leaf(n)) {
      return true;
    }
  }
  return false;
}

// A quarter of twice a middle:  at most 2^30 in size
static int32_t middle_of_span(gjk_q16 lower, gjk_q16 upper) {
  return gjk_sar32(lower, 2) + gjk_sar32(upper, 2);
}

// Does a way come to the second of two nodes first?
static bool leads_first(const gjk_compound *c, const gjk_region *region, uint32_t first, uint32_t second) {
  const gjk_aabb *a = &c->nodes[first].box, *b = &c->nodes[second].box;
  const int32_t rise[3] = {middle_of_span(b->lower.x, b->upper.x) - middle_of_span(a->lower.x, a->upper.x),
                           middle_of_span(b->lower.y, b->upper.y) - middle_of_span(a->lower.y, a->upper.y),
                           middle_of_span(b->lower.z, b->upper.z) - middle_of_span(a->lower.z, a->upper.z)};
  return gjk_region_comes_back(region, rise);
}

// A way begins a list with the box that it comes to first, roughly.
static bool first_of_list(const gjk_compound *c, const gjk_region *region, gjk_parts_walk *walk, uint32_t *number) {
  uint32_t best = GJK_PARTS_NONE;
  for (uint32_t i = 0; i < c->node_count; i++) {
    if (gjk_region_meets(region, &c->nodes[i].box) && (best == GJK_PARTS_NONE || leads_first(c, region, best, i))) {
      best = i;
    }
  }
  walk->item = best + 1;
  *number = best != GJK_PARTS_NONE ? c->nodes[best].part : 0;
  return best != GJK_PARTS_NONE;
}

// A tree over k leaves takes 2 k - 1 nodes from its root on: the root, the tree over the first half, that over the other.
typedef struct compound_tree {
  uint32_t root, leaves;
} compound_tree;

static void take_half(compound_tree *t, bool right) {
  const uint32_t left = t->leaves / 2;
  t->root += right ? 2 * left : 1;
  t->leaves = right ? t->leaves - left : left;
}

// Goes on to the last half that was put off. False: there is none.
static bool take_back(const gjk_compound *c, gjk_parts_walk *walk, compound_tree *t) {
  t->root = 0;
  t->leaves = (c->node_count + UINT32_C(1)) / 2;
  if (walk->node == 0) {
    walk->node = 1;
    return true;
  }
  while (walk->node > 1 && (walk->item & 1u) == 0) {  // ends: walk->node falls
    walk->node >>= 1;
    walk->item >>= 1;
  }
  if (walk->node == 1) {
    return false;
  }
  walk->node ^= 1u;
  walk->item ^= 1u;
  for (unsigned i = 31 - gjk_clz32(walk->node); i > 0; i--) {
    take_half(t, (walk->node >> (i - 1) & 1u) != 0);
  }
  return true;
}

// The next leaf of a tree on a way, from near to far: of two halves that the region meets, the one that the way comes to
// first is next, and the other is put off. False: there is none.
//
// walk->node  the path to the leaf that came last: 1, and a bit for each half, 1 for the right one; 0: none yet
// walk->item  a bit for each of these: 1: the other half is put off. Trees are at most 15 high, so both fit.
static bool next_part_on_way(const gjk_compound *c, const gjk_region *region, gjk_parts_walk *walk, uint32_t *number) {
  compound_tree t;
  while (take_back(c, walk, &t)) {                                   // ends: each node comes once
    bool meets = gjk_region_touches(region, &c->nodes[t.root].box);  // across the way it did, or its halves tell
    while (meets && t.leaves > 1) {                                  // ends: t.leaves falls
      const uint32_t left = t.root + 1, right = t.root + t.leaves / 2 * 2;
      const bool meets_left = gjk_region_meets(region, &c->nodes[left].box);
      const bool meets_right = gjk_region_meets(region, &c->nodes[right].box);
      const bool goes_right = meets_right && (!meets_left || leads_first(c, region, left, right));
      meets = meets_left || meets_right;
      take_half(&t, goes_right);
      walk->node = walk->node << 1 | (goes_right ? 1u : 0u);
      walk->item = walk->item << 1 | (meets_left && meets_right ? 1u : 0u);
    }
    if (meets) {
      *number = c->nodes[t.root].part;
      return true;
    }
  }
  return false;
}

static bool next_in_compound(const void *data, const gjk_region *region, gjk_parts_walk *walk, uint32_t *number) {
  const gjk_compound *c = compound_of(data);
  if (region->moves && !is_leaf(&c->nodes[0])) {
    return next_part_on_way(c, region, walk, number);
  }
  if (region->moves && walk->item == 0) {
    return first_of_list(c, region, walk, number);
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
