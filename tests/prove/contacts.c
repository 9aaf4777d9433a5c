// gjk_contacts on any two colliders, with any margin and number of contacts; what it answers is set.
#include "gjk/contacts.h"

#include <limits.h>

#include "candidates.h"
#include "colliders.h"

static void check_manifold(const gjk_manifold *m) {
  //@ assert m->count <= GJK_CONTACTS_MAX;
  check_size(m->normal.x, ANY_UNIT);
  check_size(m->normal.y, ANY_UNIT);
  check_size(m->normal.z, ANY_UNIT);
  check_size(m->feature_a, UINT16_MAX);
  check_size(m->feature_b, UINT16_MAX);
  for (unsigned i = 0; i < m->count; i++) {
    check_candidate(&m->contact[i]);
  }
}

static void ask(const gjk_collider *a, const gjk_collider *b, unsigned most) {
  gjk_manifold manifold;
  const gjk_status status = gjk_contacts(a, b, any_int32(), most, NULL, NULL, &manifold);
  if (status == GJK_OK || status == GJK_ERROR_CAPACITY) {
    //@ split manifold.count;
    check_manifold(&manifold);
  }
}

int main(void) {
  gjk_shape shapes[2] = {0};
  gjk_collider a = {0}, b = {0};
  any_collider(&a, &shapes[0], &polytope);
  any_collider(&b, &shapes[1], &curved);
  for (unsigned most = 0; most <= GJK_CONTACTS_MAX + 1; most++) {
    ask(&a, &b, most);
  }
  ask(&a, &b, UINT_MAX);
  return 0;
}
