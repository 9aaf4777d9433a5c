// This library as methods: hulls baked, and hulls lazy.
#include <stdio.h>
#include <stdlib.h>

#include "case/case.h"
#include "cost.h"

#define CELLS GJK_EPA_CELLS(1024)
#define COST_MARGIN GJK_Q16(0.02)

typedef struct prepared_pair {
  case_collider a, b;
  gjk_pose at_a, at_b;
  gjk_cache cache;  // as the query one step ago left it
} prepared_pair;

static gjk_epa_cell cells[CELLS];
static const gjk_workspace workspace = {cells, CELLS};

static void fail(gjk_status status) {
  fprintf(stderr, "cost: the library answers %s\n", gjk_status_name(status));
  exit(1);
}

static inline gjk_status ask(const prepared_pair *p, cost_query query, gjk_cache *cache, double *out) {
  const gjk_collider *a = &p->a.collider, *b = &p->b.collider;
  gjk_status status = GJK_OK;
  if (query == COST_DISTANCE) {
    gjk_distance_result gap;
    status = gjk_distance(a, b, cache, &gap);
    *out = gap.distance / COST_LSB_PER_UNIT;
  } else if (query == COST_INTERSECT) {
    gjk_decision decision;
    status = gjk_intersect(a, b, cache, &decision);
    *out = decision.yes;
  } else if (query == COST_DEPTH) {
    gjk_penetration_result depth;
    status = gjk_penetration(a, b, cache, &workspace, &depth);
    *out = depth.depth / COST_LSB_PER_UNIT;
  } else if (query == COST_CONTACTS) {
    gjk_manifold manifold;
    status = gjk_contacts(a, b, COST_MARGIN, 4, cache, &workspace, &manifold);
    *out = manifold.count;
    for (unsigned i = 0; i < manifold.count; i++) {
      *out += manifold.contact[i].distance / COST_LSB_PER_UNIT;
    }
  }
  return status;
}

// query and mode are constants wherever this is called.
static inline double answer(prepared_pair *p, cost_query query, cost_mode mode) {
  gjk_status status = GJK_OK;
  double out = 0;
  if (query == COST_POSE || mode == COST_POSED || mode == COST_POSED_WARM) {
    status = gjk_collider_pose(&p->a.collider, &p->at_a);
    out = p->a.collider.centre.x / COST_LSB_PER_UNIT;
  }
  if (query != COST_POSE && (mode == COST_POSED || mode == COST_POSED_WARM) && status == GJK_OK) {
    status = gjk_collider_pose(&p->b.collider, &p->at_b);
  }
  if (query != COST_POSE && status == GJK_OK) {
    const gjk_cache none = {{0, 0, 0}, 0, {0, 0, 0, 0}, {0, 0, 0, 0}};
    const bool is_warm = mode == COST_WARM || mode == COST_POSED_WARM;
    gjk_cache cache = is_warm ? p->cache : none;
    status = ask(p, query, is_warm ? &cache : NULL, &out);
  }
  if (status != GJK_OK) {
    fail(status);
  }
  return out;
}

#define RUN(query, mode)                        \
  static double run_##query##_##mode(void *p) { \
    return answer(p, query, mode);              \
  }
#define RUN_MODES(query) RUN(query, COST_COLD) RUN(query, COST_WARM) RUN(query, COST_POSED) RUN(query, COST_POSED_WARM)
#define MODES(query)                                  \
  [query] = {[COST_COLD] = run_##query##_COST_COLD,   \
             [COST_WARM] = run_##query##_COST_WARM,   \
             [COST_POSED] = run_##query##_COST_POSED, \
             [COST_POSED_WARM] = run_##query##_COST_POSED_WARM}

RUN_MODES(COST_DISTANCE)
RUN_MODES(COST_INTERSECT)
RUN_MODES(COST_DEPTH)
RUN_MODES(COST_CONTACTS)
RUN(COST_POSE, COST_COLD)

static cost_run *const runs[COST_QUERIES][COST_MODES] = {
    MODES(COST_DISTANCE), MODES(COST_INTERSECT), MODES(COST_DEPTH),
    MODES(COST_CONTACTS), [COST_POSE] = {[COST_COLD] = run_COST_POSE_COST_COLD}};

// Depths start cold, whatever the cache.
static cost_run *choose(cost_kind a, cost_kind b, cost_query query, cost_mode mode) {
  (void)a;
  (void)b;
  return query == COST_DEPTH && (mode == COST_WARM || mode == COST_POSED_WARM) ? NULL : runs[query][mode];
}

static cost_run *choose_lazy(cost_kind a, cost_kind b, cost_query query, cost_mode mode) {
  return a == COST_HULL || b == COST_HULL ? choose(a, b, query, mode) : NULL;
}

static void build(const case_pair *pair, bool is_lazy, prepared_pair *out) {
  gjk_status status = case_collider_build(&out->a, &pair->a, is_lazy);
  status = status == GJK_OK ? case_collider_build(&out->b, &pair->b, is_lazy) : status;
  if (status != GJK_OK) {
    fail(status);
  }
  out->at_a = pair->a.pose;
  out->at_b = pair->b.pose;
}

static void *prepare_either(const cost_pair *pair, cost_query query, bool is_lazy) {
  prepared_pair *p = calloc(1, sizeof *p);
  if (p != NULL) {
    gjk_cache cache = p->cache;
    double ignored;
    build(pair->before, is_lazy, p);
    const gjk_status status = ask(p, query, &cache, &ignored);
    // One step ago the shapes may have been apart: then there is no depth, and nothing to remember.
    if (status != GJK_OK) {
      fail(status);
    }
    p->cache = cache;
    build(pair->shapes, is_lazy, p);
  }
  return p;
}

static void *prepare(const cost_pair *pair, cost_query query) {
  return prepare_either(pair, query, false);
}

static void *prepare_lazy(const cost_pair *pair, cost_query query) {
  return prepare_either(pair, query, true);
}

static void release(void *prepared) {
  prepared_pair *p = prepared;
  case_collider_free(&p->a);
  case_collider_free(&p->b);
  free(p);
}

static const cost_method baked = {"gjk", "gjk", choose, prepare, release};
static const cost_method lazy = {"gjk", "gjk lazy", choose_lazy, prepare_lazy, release};

cost_method_list cost_gjk_methods = {&baked, &lazy, NULL};
