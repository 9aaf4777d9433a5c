// gjk_slide on any scene that gjk_scene_check lets through: any collider, way and setup, null pointers too.
#include "gjk/slide.h"

#include "scene_any.h"

int main(void) {
  apart_block apart;
  gjk_scene scene;
  gjk_shape of_collider;
  gjk_collider collider = {0};
  const gjk_vec3 to = any_position();
  const gjk_vec3 up = any_position();
  const gjk_slide_setup setup = {{up.x, up.y, up.z}, any_int32(), any_int32(), any_int32(),
                                 any_int32(),        any_bool(),  NULL};
  gjk_slide_result result;
  if (!any_scene(&scene, &apart)) {
    return 0;
  }
  any_collider(&collider, &of_collider, &polytope);
  collider.position = any_position();
  const int status = gjk_slide(&scene, any_bool() ? &collider : NULL, any_bool() ? &to : NULL,
                               any_bool() ? &setup : NULL, any_bool() ? &result : NULL);
  //@ split status;
  if (status == GJK_OK) {
    //@ assert result.count <= GJK_SLIDE_PLANES && result.casts <= GJK_SLIDE_CASTS;
  }
  return 0;
}
