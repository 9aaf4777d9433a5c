// Stands in for src/parts/gjk_region.c: any region, as tests/prove/region.c shows.
#include "src/parts/gjk_region.h"

#include "simplex_any.h"

static void any_region_box(gjk_region *r) {
  r->box.lower = any_position();
  r->box.upper = any_position();
}

void gjk_region_start(gjk_region *r, const gjk_vec3 rows[3], const gjk_vec3 *position, const gjk_aabb *world,
                      const gjk_long3 *way) {
  for (int i = 0; i < 3; i++) {
    check_vec3(&rows[i], GJK_Q30_ONE);
  }
  check_size(position->x ^ position->y ^ position->z, INT64_C(1) << 31);
  check_size(world->lower.x ^ world->lower.y ^ world->lower.z, INT64_C(1) << 31);
  check_size(world->upper.x ^ world->upper.y ^ world->upper.z, INT64_C(1) << 31);
  if (way != NULL) {
    check_size(way->x, (INT64_C(1) << 32) - 1);
    check_size(way->y, (INT64_C(1) << 32) - 1);
    check_size(way->z, (INT64_C(1) << 32) - 1);
  }
  any_region_box(r);
  for (int i = 0; i < 3; i++) {
    r->lower[i] = Frama_C_long_long_interval(-(INT64_C(1) << 34), INT64_C(1) << 34);
    r->upper[i] = Frama_C_long_long_interval(-(INT64_C(1) << 34), INT64_C(1) << 34);
    r->way[i] = Frama_C_long_long_interval(-(INT64_C(1) << 34), INT64_C(1) << 34);
  }
  r->moves = way != NULL && any_bool();
  r->grow = 0;
  r->latest = GJK_Q30_ONE;
}

void gjk_region_grow(gjk_region *r, int64_t grow) {
  //@ assert grow >= 0 && grow < 1LL << 40;
  r->grow = grow;
  any_region_box(r);
}

void gjk_region_cut(gjk_region *r, gjk_q30 latest) {
  //@ assert latest >= 0 && latest <= GJK_Q30_ONE;
  r->latest = latest;
  any_region_box(r);
}

bool gjk_region_meets_on_way(const gjk_region *r, const gjk_aabb *box) {
  check_size(r->box.lower.x ^ box->lower.x, INT64_C(1) << 31);
  return any_bool();
}
