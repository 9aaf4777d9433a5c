// Stands in for src/scene/gjk_scene_tree.c under the operations: any tree, and any parts that meet a box.
#include "scene_any.h"
#include "src/scene/gjk_scene_tree.h"

static void any_change(gjk_scene_view *v) {
  any_tree(v->header);
  any_pool(&v->header->nodes, PARTS);
  for (int i = 0; i < PARTS; i++) {
    any_inner(&v->nodes[i]);
    v->parts[i].parent = any_index(PARTS);
  }
}

void gjk_scene_tree_insert(gjk_scene_view *v, uint32_t part) {
  //@ assert part < PARTS;
  any_change(v);
}

void gjk_scene_tree_remove(gjk_scene_view *v, uint32_t part) {
  //@ assert part < PARTS;
  any_change(v);
}

uint32_t gjk_scene_walk_meeting(const gjk_scene_view *v, gjk_scene_walk *walk, const gjk_aabb *box) {
  return any_index(PARTS);
}
