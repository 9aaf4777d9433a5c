// A workspace of a thread's own, bound to its copy of a scene.
#ifndef WORKSPACE_SPACE_H
#define WORKSPACE_SPACE_H

#include "world.h"

typedef struct world_workspace {
  gjk_workspace workspace;
  gjk_epa_cell cells[WORLD_CELLS];
} world_workspace;

static void world_bind_workspace(world_workspace *w, gjk_scene_bindings *bindings) {
  w->workspace.cells = w->cells;
  w->workspace.count = world_cells();
  bindings->workspace = &w->workspace;
}

#endif
