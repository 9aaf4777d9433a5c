// The tables of scenes of the plane by a function, for other languages.
#include "gjk2/bind.h"

gjk_status gjk2_scene_bind_all(gjk2_scene_bindings *out) {
  if (out == NULL) {
    return GJK_ERROR_NULL;
  }
  out->predicate = NULL;
  out->user = NULL;
  out->details = &gjk2_scene_contacts;
  out->manifolds = NULL;
  out->motion = &gjk2_scene_motion;
  out->keeps_manifolds = false;
  return GJK_OK;
}
