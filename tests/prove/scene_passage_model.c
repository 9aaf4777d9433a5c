// Stands in for src/scene/gjk_scene_passage.c: any parts, as tests/prove/scene_tree.c shows.
#include "scene_any.h"
#include "src/scene/gjk_scene_passage.h"

void gjk_scene_passage_start(const gjk_scene_view *v, gjk_scene_passage *p, const gjk_aabb *box, int64_t grow,
                             const gjk_vec3 *from, const gjk_vec3 *to) {
  //@ assert grow >= 0 && grow < 0x800000000;
  check_size(box->lower.x ^ box->lower.y ^ box->lower.z, INT64_C(1) << 31);
  check_size(box->upper.x ^ box->upper.y ^ box->upper.z, INT64_C(1) << 31);
  check_size(from->x ^ from->y ^ from->z, INT64_C(1) << 31);
  check_size(to->x ^ to->y ^ to->z, INT64_C(1) << 31);
  p->latest = (uint32_t)GJK_Q30_ONE;
}

uint32_t gjk_scene_passage_next(const gjk_scene_view *v, gjk_scene_passage *p, uint32_t *entered) {
  //@ assert p->latest <= 0x40000000;
  *entered = Frama_C_unsigned_long_interval(0, p->latest);
  return any_index(PARTS);
}
