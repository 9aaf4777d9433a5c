// The hits of a query, in order.
#include "gjk_scene_hits.h"

#include "../arith/gjk_sort.h"

static bool hit_before(const void *hits, uint32_t i, uint32_t j) {
  const gjk_scene_hit *all = (const gjk_scene_hit *)hits;
  return gjk_scene_comes_before(&all[i], &all[j]);
}

static void exchange_hits(void *hits, uint32_t i, uint32_t j) {
  gjk_scene_hit *all = (gjk_scene_hit *)hits;
  const gjk_scene_hit hit = all[i];
  all[i] = all[j];
  all[j] = hit;
}

static const gjk_sort_order order_of_hits = {.before = hit_before, .exchange = exchange_hits};

void gjk_scene_collect(gjk_scene_hits *c, const gjk_scene_view *v, uint32_t part, uint32_t fraction) {
  const gjk_scene_hit hit = gjk_scene_hit_of(v, &v->parts[part], fraction);
  if (c->after != NULL && !gjk_scene_comes_before(c->after, &hit)) {
    return;
  }
  c->found++;
  if (c->kept < c->capacity) {
    c->hits[c->kept++] = hit;
    if (c->kept == c->capacity) {
      gjk_sort_make_heap(&order_of_hits, c->hits, c->kept);
    }
  } else if (c->capacity > 0 && gjk_scene_comes_before(&hit, &c->hits[0])) {
    c->hits[0] = hit;
    gjk_sort_sink(&order_of_hits, c->hits, 0, c->kept);
  }
}

uint32_t gjk_scene_sort_hits(const gjk_scene_hits *c) {
  gjk_sort(&order_of_hits, c->hits, c->kept);
  return c->found;
}

gjk_status gjk_scene_open_query(const gjk_scene *scene, const void *question, const gjk_scene_hit *hits,
                                uint32_t capacity, const uint32_t *count, gjk_scene_view *v) {
  return question == NULL || count == NULL || (hits == NULL && capacity > 0) ? GJK_ERROR_NULL
                                                                             : gjk_scene_view_of(scene, v);
}
