// The workspace that depths and contacts of a scene use.
#include "../scene/gjk_scene_block.h"

bool gjk_scene_workspace(const gjk_scene *scene, gjk_workspace *out) {
  const gjk_scene_header *h = (const gjk_scene_header *)scene->block;
  const gjk_workspace *given = scene->bindings.workspace;
  out->count = h->config.workspace_cells;
  out->cells = given != NULL ? given->cells : NULL;
  return out->count == 0 || (out->cells != NULL && given->count >= out->count);
}
