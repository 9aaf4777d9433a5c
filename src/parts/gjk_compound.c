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

static bool next_in_compound(const void *data, const gjk_region *region, gjk_parts_walk *walk, uint32_t *number) {
  const gjk_compound *c = compound_of(data);
  while (walk->node < c->node_count) {  // ends: walk->node rises
    const gjk_compound_node *n = &c->nodes[walk->node];
    if (!gjk_region_meets(region, &n->box)) {
      walk->node = after_node(c, walk->node);
      continue;
    }
    walk->node++;
    if (is_leaf(n)) {
      *number = n->part;
      return true;
    }
  }
  return false;
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
