// The tables of scenes of space by a function, for other languages.
#include "gjk/bind.h"

gjk_status gjk_scene_bind_all(gjk_scene_bindings *out) {
  if (out == NULL) {
    return GJK_ERROR_NULL;
  }
  out->predicate = NULL;
  out->user = NULL;
  out->details = &gjk_scene_contacts;
  out->workspace = NULL;
  out->manifolds = NULL;
  out->motion = &gjk_scene_motion;
  out->keeps_manifolds = false;
  return GJK_OK;
}
