// Stands in for src/hull/gjk_hull_grow.c under the builder: any triangles. tests/prove/hull_grow.c shows the parts of the
// workspace; here each part is memory of its own, with room for what the part holds.
#include "hull_any.h"

static gjk_hull_triangle triangles[ANY_PLACES];
static uint32_t of[ANY_POINTS];
static uint16_t order[ANY_POINTS];
static uint16_t next[ANY_POINTS + 20];  // the rest of the workspace

gjk_hull_work gjk_hull_work_of(const gjk_vec3 *points, void *workspace, uint32_t count) {
  //@ assert \valid((char *)workspace + (0 .. 40 * count + 39));
  gjk_hull_work w;
  w.points = points;
  w.triangle = triangles;
  w.of = of;
  w.order = order;
  w.next = next;
  w.distinct = count;
  w.triangles = 0;
  w.free = GJK_HULL_NO_LINK;
  return w;
}

bool gjk_hull_fits(const gjk_vec3 *points, uint32_t count) {
  //@ assert \valid_read(points + (0 .. count - 1));
  return any_bool();
}

void gjk_hull_set_plane(const gjk_hull_work *w, const gjk_hull_triangle *t, gjk_hull_plane *out) {
  check_triangle(t, w->distinct, w->triangles);
  out->at = gjk_hull_point(w, t->vertex[0]);
  out->n.x = Frama_C_long_long_interval(-(INT64_C(1) << 60), INT64_C(1) << 60);
  out->n.y = Frama_C_long_long_interval(-(INT64_C(1) << 60), INT64_C(1) << 60);
  out->n.z = Frama_C_long_long_interval(-(INT64_C(1) << 60), INT64_C(1) << 60);
}

void gjk_hull_grow(gjk_hull_work *w, const uint16_t corner[4]) {
  for (int i = 0; i < 4; i++) {
    //@ assert corner[i] < w->distinct;
  }
  //@ assert w->distinct >= 4;
  const uint32_t triangles_used = (uint32_t)any_between(4, 2 * ANY_POINTS - 4);
  //@ split triangles_used;
  w->triangles = triangles_used;
  for (uint32_t i = 0; i < 2 * ANY_POINTS - 4; i++) {
    any_triangle(&w->triangle[i], w->distinct, w->triangles);
  }
  for (uint32_t i = 0; i < ANY_POINTS; i++) {
    w->of[i] = GJK_HULL_NO_TRIANGLE;
    w->next[i] = any_uint16();
  }
}
