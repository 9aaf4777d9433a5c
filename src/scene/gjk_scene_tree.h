// The tree of enlarged boxes (BVH).
#ifndef GJK_SRC_SCENE_TREE_H
#define GJK_SRC_SCENE_TREE_H

#include "gjk_scene_block.h"

// Inserts a part with its enlarged box.
void gjk_scene_tree_insert(gjk_scene_view *v, uint32_t part);

// Takes a part out of the tree.
void gjk_scene_tree_remove(gjk_scene_view *v, uint32_t part);

static inline const gjk_aabb *gjk_scene_node_box(const gjk_scene_view *v, uint32_t node) {
  return (node & GJK_SCENE_LEAF) != 0 ? &v->parts[node & ~GJK_SCENE_LEAF].enlarged : &v->nodes[node].box;
}

// A walk over the tree: start it, then take nodes until NONE. For each inner node that is worth going into, call
// gjk_scene_walk_descend.
typedef struct gjk_scene_walk {
  uint32_t waiting[GJK_SCENE_DEPTH];
  unsigned count;
} gjk_scene_walk;

static inline void gjk_scene_walk_start(const gjk_scene_view *v, gjk_scene_walk *walk) {
  walk->waiting[0] = v->header->root;
  walk->count = v->header->root != GJK_SCENE_NONE ? 1 : 0;
}

static inline uint32_t gjk_scene_walk_next(gjk_scene_walk *walk) {
  return walk->count > 0 ? walk->waiting[--walk->count] : GJK_SCENE_NONE;
}

// Makes a node the next one. Each level leaves one waiting.
static inline void gjk_scene_walk_wait(gjk_scene_walk *walk, uint32_t node) {
  //@ assert walk->count <= GJK_SCENE_DEPTH - 1;
  walk->waiting[walk->count++] = node;
}

// Makes the children of a node the next ones. Each level leaves one node waiting, the deepest two:
// count <= depth + 1 <= 30
static inline void gjk_scene_walk_descend(const gjk_scene_view *v, gjk_scene_walk *walk, uint32_t node) {
  //@ assert walk->count <= GJK_SCENE_DEPTH - 2;
  walk->waiting[walk->count++] = v->nodes[node].child[1];
  walk->waiting[walk->count++] = v->nodes[node].child[0];
}

// The next part whose enlarged box shares a point with box, or NONE.
uint32_t gjk_scene_walk_meeting(const gjk_scene_view *v, gjk_scene_walk *walk, const gjk_aabb *box);

#endif
