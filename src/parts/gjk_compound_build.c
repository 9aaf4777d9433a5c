// Builds the boxes of a compound.
//
// A tree over k parts takes 2 k - 1 nodes in a row: its root, the tree over the first half of the parts, the tree over the
// other half. Before it is split, its parts' leaves lie in its last k nodes. So there is always room for the root:
//
// 1. Write a leaf for each part, in the order of their numbers; of a tree into its last nodes.
// 2. Go through the nodes from the first to the last. A leaf is done. Else the node is a root of a tree yet to be split:
// 3. Its box holds those of its leaves. Sort these along the longest side of the box of their middles, equal ones by their
//    numbers.
// 4. Move the leaves of the first half down to the end of where their tree is to be. The others are in place.
// 5. Mark the root of each half of more than one part.
#include "../arith/gjk_root.h"
#include "../arith/gjk_sort.h"
#include "gjk/compound.h"
#include "gjk/pose.h"

#define NO_LEAF UINT16_MAX

static void copy_leaf(gjk_compound_node *to, const gjk_compound_node *from) {
  to->box.lower.x = from->box.lower.x;
  to->box.lower.y = from->box.lower.y;
  to->box.lower.z = from->box.lower.z;
  to->box.upper.x = from->box.upper.x;
  to->box.upper.y = from->box.upper.y;
  to->box.upper.z = from->box.upper.z;
  to->skip = from->skip;
  to->part = from->part;
}

// Leaves to sort along an axis.
typedef struct leaf_order {
  gjk_compound_node *leaf;
  unsigned axis;
} leaf_order;

// Twice the middle of a box along an axis.
static int64_t middle_along(const gjk_compound_node *n, unsigned axis) {
  const gjk_vec3 *a = &n->box.lower, *b = &n->box.upper;
  return axis == 0 ? (int64_t)a->x + b->x : axis == 1 ? (int64_t)a->y + b->y : (int64_t)a->z + b->z;
}

static bool leaf_before(const void *items, uint32_t i, uint32_t j) {
  const leaf_order *order = (const leaf_order *)items;
  const int64_t a = middle_along(&order->leaf[i], order->axis), b = middle_along(&order->leaf[j], order->axis);
  return a != b ? a < b : order->leaf[i].part < order->leaf[j].part;
}

static void exchange_leaves(void *items, uint32_t i, uint32_t j) {
  const leaf_order *order = (const leaf_order *)items;
  gjk_compound_node leaf;
  copy_leaf(&leaf, &order->leaf[i]);
  copy_leaf(&order->leaf[i], &order->leaf[j]);
  copy_leaf(&order->leaf[j], &leaf);
}

static gjk_q16 least_of(gjk_q16 a, gjk_q16 b) {
  return a < b ? a : b;
}

static gjk_q16 most_of(gjk_q16 a, gjk_q16 b) {
  return a > b ? a : b;
}

// Makes a box hold another one.
static void hold_box(gjk_aabb *box, const gjk_aabb *other) {
  box->lower.x = least_of(box->lower.x, other->lower.x);
  box->lower.y = least_of(box->lower.y, other->lower.y);
  box->lower.z = least_of(box->lower.z, other->lower.z);
  box->upper.x = most_of(box->upper.x, other->upper.x);
  box->upper.y = most_of(box->upper.y, other->upper.y);
  box->upper.z = most_of(box->upper.z, other->upper.z);
}

// The axis along which the middles of the leaves are farthest apart.
static unsigned longest_axis(const gjk_compound_node *leaf, uint32_t count) {
  unsigned axis = 0;
  int64_t longest = -1;
  for (unsigned i = 0; i < 3; i++) {
    int64_t low = middle_along(&leaf[0], i), high = low;
    for (uint32_t j = 1; j < count; j++) {
      const int64_t middle = middle_along(&leaf[j], i);
      low = middle < low ? middle : low;
      high = middle > high ? middle : high;
    }
    if (high - low > longest) {
      longest = high - low;
      axis = i;
    }
  }
  return axis;
}

// Step 5: a root of a tree of count parts. A tree of one part is its leaf.
static void mark_root(gjk_compound_node *nodes, uint32_t at, uint32_t count) {
  nodes[at].skip = (uint16_t)(at + 2 * count - 1);  // at most 65533, the number of nodes
  if (count > 1) {
    nodes[at].part = NO_LEAF;
  }
}

// Steps 3 to 5.
static void split_tree(gjk_compound_node *nodes, uint32_t at) {
  static const gjk_sort_order order_of_leaves = {.before = leaf_before, .exchange = exchange_leaves};
  const uint32_t count = (nodes[at].skip - at + 1) / 2, first = count / 2;
  gjk_compound_node *leaf = &nodes[at + count - 1];
  leaf_order order;
  order.leaf = leaf;
  order.axis = longest_axis(leaf, count);
  nodes[at].box.lower = leaf[0].box.lower;
  nodes[at].box.upper = leaf[0].box.upper;
  for (uint32_t i = 1; i < count; i++) {
    hold_box(&nodes[at].box, &leaf[i].box);
  }
  gjk_sort(&order_of_leaves, &order, count);
  for (uint32_t i = 0; i < first; i++) {  // Step 4: at + first <= at + count - 1
    copy_leaf(&nodes[at + first + i], &leaf[i]);
  }
  mark_root(nodes, at + 1, first);
  mark_root(nodes, at + 2 * first, count - first);
}

// How far from the origin a point is at most, at any rotation, roundings included.
//   each square at most 2^62, their root below 0.87 2^32, so that a radius may be added
static uint32_t reach_of_point(const gjk_vec3 *v) {
  const uint64_t squared =
      (uint64_t)gjk_mul32(v->x, v->x) + (uint64_t)gjk_mul32(v->y, v->y) + (uint64_t)gjk_mul32(v->z, v->z);
  return gjk_isqrt64(squared) + 32;
}

// Step 1 for one part.
static gjk_status set_leaf(const gjk_compound_part *part, uint16_t number, gjk_compound_node *leaf, uint32_t *reach) {
  gjk_collider c;
  gjk_status status = gjk_collider_init(&c, part->shape, NULL, 0);
  status = status == GJK_OK ? gjk_collider_pose(&c, &part->pose) : status;
  status = status == GJK_OK ? gjk_collider_aabb(&c, &leaf->box) : status;
  if (status == GJK_OK) {
    const uint32_t position = reach_of_point(&part->pose.position),
                   centre = reach_of_point(&c.centre) + (uint32_t)c.radius;
    *reach = position > *reach ? position : *reach;
    *reach = centre > *reach ? centre : *reach;
    leaf->part = number;
  }
  return status;
}

gjk_status gjk_compound_build(const gjk_compound_part *parts, uint16_t count, gjk_compound_node *nodes,
                              uint32_t capacity, gjk_compound *out) {
  if (parts == NULL || nodes == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  if (count == 0 || count > GJK_COMPOUND_PARTS_MAX) {
    return count == 0 ? GJK_ERROR_EMPTY : GJK_ERROR_SIZE;
  }
  const uint32_t needed = (uint32_t)count <= GJK_COMPOUND_LIST_MAX ? count : 2 * (uint32_t)count - 1;
  if (capacity < needed) {
    return GJK_ERROR_CAPACITY;
  }
  const uint32_t start = needed - count;  // 0 of a list, count - 1 of a tree
  uint32_t reach = 0;
  for (uint16_t i = 0; i < count; i++) {
    gjk_compound_node *leaf = &nodes[start + i];
    const gjk_status status = set_leaf(&parts[i], i, leaf, &reach);
    if (status != GJK_OK) {
      return status;
    }
    leaf->skip = (uint16_t)(start + i + 1);
  }
  if (start > 0) {
    mark_root(nodes, 0, count);
    for (uint32_t i = 0; i < needed; i++) {  // Step 2
      if (nodes[i].part == NO_LEAF) {
        split_tree(nodes, i);
      } else {
        nodes[i].skip = (uint16_t)(i + 1);
      }
    }
  }
  out->parts = parts;
  out->nodes = nodes;
  out->reach = reach;
  out->count = count;
  out->node_count = (uint16_t)needed;
  return GJK_OK;
}
