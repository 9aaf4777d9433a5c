// This library, and the reference in double, as methods.
#include <stdio.h>
#include <stdlib.h>

#include "case/case2.h"
#include "gjk2/chain.h"
#include "plane.h"
#include "reference/reference2.h"

// Contacts are kept up to this far apart, LSB.
#define MARGIN 655

static void fail(gjk_status status) {
  fprintf(stderr, "gjk-plane: the library answers %s\n", gjk_status_name(status));
  exit(1);
}

// What this library keeps of a pair between queries. place: where B is.
typedef struct own_pair {
  const gjk2_collider *a, *b[2];
  gjk2_collider there;  // B, moved a little
  gjk2_chain chain;
  gjk2_cache cache;
  unsigned place;
} own_pair;

static const gjk2_collider *side(const void *prepared, int i) {
  const own_pair *p = prepared;
  return i == 0 ? p->a : p->b[0];
}

// B at the other one of its places.
static const gjk2_collider *moved_side(own_pair *p) {
  p->place = 1 - p->place;
  return p->b[p->place];
}

static double intersect(void *p) {
  gjk2_decision out;
  const gjk_status status = gjk2_intersect(side(p, 0), side(p, 1), NULL, &out);
  if (status != GJK_OK) {
    fail(status);
  }
  return out.yes;
}

static double distance(void *p) {
  gjk2_distance_result out;
  const gjk_status status = gjk2_distance(side(p, 0), side(p, 1), NULL, &out);
  if (status != GJK_OK) {
    fail(status);
  }
  return out.distance / PLANE_LSB_PER_UNIT;
}

static double depth(void *p) {
  gjk2_penetration_result out;
  const gjk_status status = gjk2_penetration(side(p, 0), side(p, 1), NULL, &out);
  if (status != GJK_OK) {
    fail(status);
  }
  return out.intersecting ? out.depth / PLANE_LSB_PER_UNIT : 0;
}

static double contacts(void *p) {
  gjk2_manifold out;
  const gjk_status status = gjk2_contacts(side(p, 0), side(p, 1), MARGIN, GJK2_CONTACTS_MAX, NULL, &out);
  if (status != GJK_OK) {
    fail(status);
  }
  return out.count;
}

static double chain_contacts(void *p) {
  gjk2_chain_contact out[4];
  uint16_t count = 0;
  const own_pair *pair = p;
  const gjk_status status = gjk2_chain_contacts(&pair->chain, pair->b[0], NULL, MARGIN, out, 4, &count);
  if (status != GJK_OK) {
    fail(status);
  }
  return count;
}

static double moved_distance(void *p) {
  gjk2_distance_result out;
  own_pair *pair = p;
  const gjk_status status = gjk2_distance(pair->a, moved_side(pair), &pair->cache, &out);
  if (status != GJK_OK) {
    fail(status);
  }
  return out.distance / PLANE_LSB_PER_UNIT;
}

static double moved_contacts(void *p) {
  gjk2_manifold out;
  own_pair *pair = p;
  const gjk_status status = gjk2_contacts(pair->a, moved_side(pair), MARGIN, GJK2_CONTACTS_MAX, &pair->cache, &out);
  if (status != GJK_OK) {
    fail(status);
  }
  return out.count;
}

static plane_run *choose(plane_query query) {
  static plane_run *const runs[] = {[PLANE_INTERSECT] = intersect,
                                    [PLANE_DISTANCE] = distance,
                                    [PLANE_DEPTH] = depth,
                                    [PLANE_CONTACTS] = contacts,
                                    [PLANE_CHAIN] = chain_contacts};
  return runs[query];
}

static plane_run *choose_moved(plane_query query) {
  return query == PLANE_DISTANCE ? moved_distance : query == PLANE_CONTACTS ? moved_contacts : NULL;
}

// The colliders are the pair's own.
static void *prepare(const plane_pair *pair) {
  own_pair *p = calloc(1, sizeof *p);
  if (p != NULL) {
    const gjk2_vec origin = {0, 0};
    const gjk2_shape *ground = pair->collider[0]->collider.shape;
    p->a = &pair->collider[0]->collider;
    p->b[0] = &pair->collider[1]->collider;
    p->b[1] = &p->there;
    p->there = *p->b[0];
    const gjk2_vec there = {p->there.position.x + 150, p->there.position.y + 70};
    (void)gjk2_collider_move(&p->there, &there);
    if (ground->vertices != NULL) {
      (void)gjk2_chain_init(&p->chain, ground->vertices, ground->count, &origin);
    }
  }
  return p;
}

typedef struct reference_pair {
  reference2_shape shape[2];
} reference_pair;

static double reference_intersect(void *prepared) {
  const reference_pair *p = prepared;
  reference2_result out;
  reference2_query(&p->shape[0], &p->shape[1], &out);
  return out.intersecting;
}

static double reference_distance(void *prepared) {
  const reference_pair *p = prepared;
  reference2_result out;
  reference2_query(&p->shape[0], &p->shape[1], &out);
  return (out.distance > 0 ? out.distance : -out.distance) / PLANE_LSB_PER_UNIT;
}

static plane_run *reference_choose(plane_query query) {
  return query == PLANE_INTERSECT ? reference_intersect : query >= PLANE_CONTACTS ? NULL : reference_distance;
}

static void reference_release(void *prepared) {
  reference_pair *p = prepared;
  for (int i = 0; i < 2; i++) {
    free((void *)(uintptr_t)p->shape[i].point);
  }
  free(p);
}

static void *reference_prepare(const plane_pair *pair) {
  reference_pair *p = calloc(1, sizeof *p);
  for (int i = 0; p != NULL && i < 2; i++) {
    const plane_solid *s = &pair->solid[i];
    double(*points)[2] = calloc(s->count, sizeof *points);
    if (points == NULL) {
      reference_release(p);
      return NULL;
    }
    for (size_t k = 0; k < s->count; k++) {
      points[k][0] = (s->centre[0] + s->corner[k][0]) * PLANE_LSB_PER_UNIT;
      points[k][1] = (s->centre[1] + s->corner[k][1]) * PLANE_LSB_PER_UNIT;
    }
    p->shape[i].point = (const double(*)[2])points;
    p->shape[i].count = s->count;
  }
  return p;
}

static const plane_method gjk = {"gjk", choose, prepare, free};
static const plane_method gjk_moved = {"gjk with a cache", choose_moved, prepare, free};
static const plane_method reference = {"double", reference_choose, reference_prepare, reference_release};

plane_method_list plane_own_methods = {&gjk, &gjk_moved, &reference, NULL};
