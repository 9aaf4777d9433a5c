// A scene's shapes, boxes and pairs, for debug drawing.
#include "../scene/gjk_scene_block.h"

#ifndef GJK_SCENE_OF_PLANE
#include "gjk_scene_drawing.h"
#endif

static gjk_draw_role role_of(const gjk_body_state *state) {
  return state->detail == GJK_DETAIL_SENSOR ? GJK_DRAW_SENSOR
         : state->kind == GJK_BODY_STATIC   ? GJK_DRAW_STATIC
         : state->asleep                    ? GJK_DRAW_ASLEEP
                                            : GJK_DRAW_MOVING;
}

static void draw_parts(const gjk_draw *draw, const gjk_scene *scene, const gjk_body_id *id, unsigned what) {
  gjk_body_state state;
  gjk_collider c;
  gjk_aabb box;
  (void)gjk_scene_get(scene, *id, &state);  // cannot fail: the slot has this body
  for (unsigned part = 0; part < state.part_count; part++) {
    if (gjk_scene_collider(scene, *id, (uint16_t)part, &c) != GJK_OK) {
      continue;
    }
    if ((what & GJK_DRAW_SHAPES) != 0) {
      (void)gjk_draw_collider(draw, &c, role_of(&state));  // posed, as for the box
    }
    if ((what & GJK_DRAW_BOXES) != 0) {
      (void)gjk_collider_aabb(&c, &box);
      (void)gjk_draw_box(draw, &box, GJK_DRAW_BOX);
    }
  }
}

// Pairs of bodies that were removed have no centres any more.
static void draw_pairs(const gjk_draw *draw, const gjk_scene *scene) {
  gjk_report pair;
  gjk_collider a, b;
  uint32_t cursor = 0;
  bool found = draw->line != NULL;
  while (found && gjk_scene_next_near(scene, &cursor, &pair, &found) == GJK_OK && found) {
    if (gjk_scene_collider(scene, pair.a, pair.part_a, &a) == GJK_OK &&
        gjk_scene_collider(scene, pair.b, pair.part_b, &b) == GJK_OK && !gjk_scene_same_vec3(&a.centre, &b.centre)) {
      draw->line(draw->user, &a.centre, &b.centre, GJK_DRAW_PAIR);
    }
  }
}

gjk_status gjk_draw_scene(const gjk_draw *draw, const gjk_scene *scene, unsigned what) {
  gjk_body_id id;
  uint32_t slot = 0;
  if (draw == NULL) {
    return GJK_ERROR_NULL;
  }
  if (what >= 2 * GJK_DRAW_PAIRS) {
    return GJK_ERROR_RANGE;
  }
  gjk_status status = gjk_scene_body_at(scene, slot, &id);
  for (; status == GJK_OK; status = gjk_scene_body_at(scene, ++slot, &id)) {  // ends: slots do
    if (id.generation != 0 && (what & (GJK_DRAW_SHAPES | GJK_DRAW_BOXES)) != 0) {
      draw_parts(draw, scene, &id, what);
    }
  }
  if (status != GJK_ERROR_RANGE) {
    return status;
  }
  if ((what & GJK_DRAW_PAIRS) != 0) {
    draw_pairs(draw, scene);
  }
  return GJK_OK;
}
