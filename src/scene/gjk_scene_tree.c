// The tree of enlarged boxes (BVH): leaves are parts, and the box of an inner node holds those of its two children.
//
// The heights of siblings differ by at most 1 always, which bounds every walk (Adelson-Velsky, Landis 1962). Leaves
// have no order, so one kind of rotation is enough. The shape of the tree decides no answer.
//
// Insertion of a leaf:
//
// 1. Go down from the root to a sibling for the leaf: always to the child that the leaf makes costlier by less. A box
//    costs the sum of its sides. Stop at a leaf, or at the parent of two leaves where that is cheaper. Higher up
//    the new node's children could differ in height by more than one rotation mends.
// 2. Put a new node in the place of the sibling, with the sibling and the leaf as its children.
// 3. From the new node up, refit each node: its box and height follow from its children. Then rotate, if their heights
//    differ by 2. Stop where nothing changes.
//
// Removal of a leaf puts its sibling in the place of their parent, and goes on at 3 above it.
//
// Rotation of a node N, whose taller child R is 2 higher than the other one, S:
//
// a. R takes the place of N.
// b. One child of R moves into N, where R was: the lower one, or else the one whose box with S costs less. N takes that
//    child's place in R.
// c. Refit N, then R.
#include "gjk_scene_tree.h"

static uint32_t height(const gjk_scene_view *v, uint32_t node) {
  return (node & GJK_SCENE_LEAF) != 0 ? 0 : v->nodes[node].height;
}

static void set_parent(gjk_scene_view *v, uint32_t node, uint32_t parent) {
  if ((node & GJK_SCENE_LEAF) != 0) {
    v->parts[node & ~GJK_SCENE_LEAF].parent = GJK_SCENE_INDEX(parent);
  } else {
    v->nodes[node].parent = GJK_SCENE_INDEX(parent);
  }
}

static uint32_t cost_of_hull(const gjk_aabb *a, const gjk_aabb *b) {
  const gjk_aabb box = gjk_aabb_hull(a, b);
  return gjk_scene_cost(&box);
}

// Sets the box and height of a node from its children. Returns whether anything changed.
static bool refit(gjk_scene_view *v, uint32_t index) {
  gjk_scene_node *n = &v->nodes[index];
  const uint32_t a = height(v, n->child[0]), b = height(v, n->child[1]);
  const uint32_t taller = (a > b ? a : b) + 1;
  const gjk_aabb box = gjk_aabb_hull(gjk_scene_node_box(v, n->child[0]), gjk_scene_node_box(v, n->child[1]));
  const bool changed = taller != n->height || !gjk_aabb_inside(&box, &n->box) || !gjk_aabb_inside(&n->box, &box);
  n->height = GJK_SCENE_HEIGHT(taller);
  n->box = box;
  return changed;
}

// Puts another node in the place of a child of parent, or of the root when parent is none.
static void replace_child(gjk_scene_view *v, uint32_t parent, uint32_t child, uint32_t other) {
  if (parent == GJK_SCENE_NONE) {
    v->header->root = other;
  } else {
    v->nodes[parent].child[v->nodes[parent].child[1] == child] = other;
  }
  set_parent(v, other, parent);
}

// Rotates a node if the heights of its children differ by 2. Returns the node that is in its place then. Pre: they do
// not differ by more.
static uint32_t balance(gjk_scene_view *v, uint32_t index) {
  gjk_scene_node *n = &v->nodes[index];
  const uint32_t left = height(v, n->child[0]), right = height(v, n->child[1]);
  if (left <= right + 1 && right <= left + 1) {
    return index;
  }
  const unsigned tall = right > left ? 1 : 0;
  const uint32_t rising = n->child[tall];
  //@ assert rising < v->header->nodes.capacity;
  gjk_scene_node *r = &v->nodes[rising];
  const uint32_t first = height(v, r->child[0]), second = height(v, r->child[1]);
  unsigned low = second < first ? 1 : 0;  // the child of the rising node whose place index takes
  if (first == second) {
    const gjk_aabb *stays = gjk_scene_node_box(v, n->child[1 - tall]);
    const uint32_t a = cost_of_hull(stays, gjk_scene_node_box(v, r->child[0]));
    const uint32_t b = cost_of_hull(stays, gjk_scene_node_box(v, r->child[1]));
    low = b < a ? 1 : 0;
  }
  replace_child(v, n->parent, index, rising);  // Step a
  n->child[tall] = r->child[low];              // Step b
  set_parent(v, n->child[tall], index);
  r->child[low] = index;
  n->parent = GJK_SCENE_INDEX(rising);
  refit(v, index);  // Step c
  refit(v, rising);
  return rising;
}

// Step 3 from a node up.
static void restore(gjk_scene_view *v, uint32_t index) {
  // not reached: the ceiling
  for (unsigned level = 0; index != GJK_SCENE_NONE && level < GJK_SCENE_DEPTH; level++) {
    const bool changed = refit(v, index);
    const uint32_t top = balance(v, index);
    if (!changed && top == index) {
      return;
    }
    index = v->nodes[top].parent;
  }
}

// Step 1. Returns a leaf, or the parent of two.
static uint32_t best_sibling(const gjk_scene_view *v, const gjk_aabb *box) {
  uint32_t node = v->header->root;
  // not reached: the ceiling
  for (unsigned level = 0; (node & GJK_SCENE_LEAF) == 0 && level < GJK_SCENE_DEPTH; level++) {
    const gjk_scene_node *n = &v->nodes[node];
    uint32_t cost[2];  // of what is made below the node, or what grows there
    for (int i = 0; i < 2; i++) {
      const gjk_aabb *child = gjk_scene_node_box(v, n->child[i]);
      const uint32_t hull = cost_of_hull(child, box);
      cost[i] = (n->child[i] & GJK_SCENE_LEAF) != 0 ? hull : hull - gjk_scene_cost(child);
    }
    if (n->height == 1) {
      const uint32_t whole = cost_of_hull(&n->box, box), grows = whole - gjk_scene_cost(&n->box);  // sums < 3 2^30
      if (whole <= grows + cost[0] && whole <= grows + cost[1]) {
        return node;
      }
    }
    node = n->child[cost[1] < cost[0]];
  }
  return node;
}

void gjk_scene_tree_insert(gjk_scene_view *v, uint32_t part) {
  gjk_scene_header *h = v->header;
  const uint32_t leaf = part | GJK_SCENE_LEAF;
  if (h->root == GJK_SCENE_NONE) {
    h->root = leaf;
    v->parts[part].parent = GJK_SCENE_NONE;
    return;
  }
  const uint32_t sibling = best_sibling(v, &v->parts[part].enlarged);
  const uint32_t parent =
      (sibling & GJK_SCENE_LEAF) != 0 ? v->parts[sibling & ~GJK_SCENE_LEAF].parent : v->nodes[sibling].parent;
  // Step 2
  const uint32_t index = gjk_scene_pool_take(v, &h->nodes, sizeof(gjk_scene_node));
  replace_child(v, parent, sibling, index);
  v->nodes[index].child[0] = sibling;
  v->nodes[index].child[1] = leaf;
  v->nodes[index].height = 0;  // set by refit, which sees that it changes
  set_parent(v, sibling, index);
  v->parts[part].parent = GJK_SCENE_INDEX(index);
  restore(v, index);
}

void gjk_scene_tree_remove(gjk_scene_view *v, uint32_t part) {
  gjk_scene_header *h = v->header;
  const uint32_t index = v->parts[part].parent;
  if (index == GJK_SCENE_NONE) {
    h->root = GJK_SCENE_NONE;
    return;
  }
  const gjk_scene_node *n = &v->nodes[index];
  const uint32_t sibling = n->child[n->child[0] == (part | GJK_SCENE_LEAF)], parent = n->parent;
  replace_child(v, parent, index, sibling);
  v->nodes[index].height = 0;  // free
  gjk_scene_pool_give(v, &h->nodes, sizeof(gjk_scene_node), index);
  restore(v, parent);
}

// A node that waits meets the box, unless it is the root. Of two children that do the first is next, and the other waits.
uint32_t gjk_scene_walk_meeting(const gjk_scene_view *v, gjk_scene_walk *walk, const gjk_aabb *box) {
  uint32_t node = gjk_scene_walk_next(walk);
  if (node == GJK_SCENE_NONE || (node == v->header->root && !gjk_aabb_meet(box, gjk_scene_node_box(v, node)))) {
    return GJK_SCENE_NONE;
  }
  while ((node & GJK_SCENE_LEAF) == 0) {  // ends: each node is taken once
    const gjk_scene_node *n = &v->nodes[node];
    const uint32_t first = n->child[0], second = n->child[1];
    const bool meets = gjk_aabb_meet(box, gjk_scene_node_box(v, first));
    if (gjk_aabb_meet(box, gjk_scene_node_box(v, second))) {
      if (meets) {
        gjk_scene_walk_wait(walk, second);
      }
      node = meets ? first : second;
    } else {
      node = meets ? first : gjk_scene_walk_next(walk);
      if (node == GJK_SCENE_NONE) {
        return node;
      }
    }
  }
  return node & ~GJK_SCENE_LEAF;
}
