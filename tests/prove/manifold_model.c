// Stands in for the steps of src/query/gjk_contacts.c under contacts of surfaces: any candidates and contacts, as
// tests/prove/contacts.c shows.
#include "candidates.h"
#include "src/query/gjk_manifold.h"

void gjk_manifold_find(const gjk_collider *a, const gjk_collider *b, gjk_q16 margin, gjk_candidates *candidates,
                       gjk_manifold *out) {
  static const int32_t counts[] = {0, 1, GJK_CANDIDATES_MAX};
  const int32_t kind = any_between(0, 2);
  //@ assert a->shape != \null && b->shape != \null && margin >= 0;
  check_size(out->normal.x, ANY_UNIT);
  check_size(out->normal.y, ANY_UNIT);
  check_size(out->normal.z, ANY_UNIT);
  //@ split kind;
  candidates->candidate[0].id = any_uint16();
  any_candidates(candidates, counts[kind]);
  out->feature_a = any_uint16();
  out->feature_b = any_uint16();
}

void gjk_manifold_keep(gjk_candidates *candidates, const gjk_distance_result *nearest, unsigned most,
                       gjk_manifold *out) {
  //@ assert most >= 1 && most <= GJK_CONTACTS_MAX;
  //@ assert candidates->count <= GJK_CANDIDATES_MAX;
  check_size(out->normal.x, ANY_UNIT);
  if (nearest != NULL) {
    check_position(&nearest->point_a);
    check_position(&nearest->point_b);
    check_size(nearest->distance, INT64_C(1) << 31);
  }
  const int32_t count = any_between(nearest != NULL || candidates->count > 0 ? 1 : 0, GJK_CONTACTS_MAX);
  out->count = (uint8_t)count;
  for (int i = 0; i < GJK_CONTACTS_MAX; i++) {
    out->contact[i].point_a = any_position();
    out->contact[i].point_b = any_position();
    out->contact[i].distance = any_int32();
    out->contact[i].id = any_uint16();
  }
}
