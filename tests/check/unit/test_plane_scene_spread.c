// The test of updates that are spread, on scenes of the plane.
#include "scene/plane_names.h"
#include "scene/world.h"

#define TEST_NAME "plane_scene_spread"
#define WORLD_OF_PLANE

// The plane needs no workspace.
typedef struct world_workspace {
  uint8_t none;
} world_workspace;

static void world_bind_workspace(world_workspace *w, gjk2_scene_bindings *bindings) {
  (void)w;
  (void)bindings;
}

#include "test_scene_spread.c"
