// The library as methods: without a cache, with the cache of a pose before, and stopped early.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "case/case.h"
#include "method.h"

// How far B has moved since the cache was filled, in parts of its radius.
#define STEP_PARTS 100

#define GAP (BENCH_ASK(BENCH_DISTANCE) | BENCH_ASK(BENCH_INTERSECT))
#define ALL (GAP | BENCH_ASK(BENCH_DEPTH) | BENCH_ASK(BENCH_CONTACTS))
#define UNTIL BENCH_ASK(BENCH_DISTANCE)

#define CELLS GJK_EPA_CELLS(1024)

typedef struct prepared_pair {
  const gjk_collider *a, *b;
  gjk_cache caches[BENCH_QUERIES];  // as the query one step ago left them; zeroed: cold
  gjk_effort effort;
} prepared_pair;

static gjk_epa_cell cells[CELLS];
static const gjk_workspace workspace = {cells, CELLS};

static void *prepare(const bench_method *method, const bench_pair *pair) {
  prepared_pair *p = calloc(1, sizeof *p);
  (void)method;
  if (p != NULL) {
    p->a = &pair->a->collider;
    p->b = &pair->b->collider;
  }
  return p;
}

// The direction of the move differs from pair to pair, but is the same in every run.
static gjk_vec3 one_step_ago(const gjk_collider *b) {
  const gjk_vec3 p = b->position;
  const uint32_t word = ((uint32_t)p.x * 2654435761u) ^ ((uint32_t)p.y * 2246822519u) ^ (uint32_t)p.z;
  const double azimuth = 6.283185307 * (word >> 16) / 65536, z = 2.0 * (word & 0xffff) / 65536 - 1;
  const double length = (double)b->radius / STEP_PARTS, flat = length * sqrt(1 - z * z);
  gjk_vec3 at = p;
  at.x = (gjk_q16)((double)p.x + flat * cos(azimuth));
  at.y = (gjk_q16)((double)p.y + flat * sin(azimuth));
  at.z = (gjk_q16)((double)p.z + length * z);
  return at;
}

static void *prepare_warm(const bench_method *method, const bench_pair *pair) {
  prepared_pair *p = prepare(method, pair);
  gjk_collider before = pair->b->collider;
  const gjk_vec3 at = one_step_ago(&before);
  gjk_distance_result gap;
  gjk_decision decision;
  gjk_penetration_result depth;
  gjk_manifold manifold;
  if (p != NULL && gjk_collider_move(&before, &at) == GJK_OK) {
    gjk_distance(p->a, &before, &p->caches[BENCH_DISTANCE], &gap);
    gjk_intersect(p->a, &before, &p->caches[BENCH_INTERSECT], &decision);
    gjk_penetration(p->a, &before, &p->caches[BENCH_DEPTH], &workspace, &depth);
    gjk_contacts(p->a, &before, BENCH_MARGIN, BENCH_CONTACTS_KEPT, &p->caches[BENCH_CONTACTS], &workspace, &manifold);
  }
  return p;
}

static void fail(gjk_status status) {
  fprintf(stderr, "bench: the library answers %s\n", gjk_status_name(status));
  exit(1);
}

static void set_gap(const gjk_distance_result *gap, bench_answer *out) {
  out->decision = gap->intersecting ? BENCH_TOGETHER : BENCH_APART;
  out->distance = gap->distance;
  out->iterations = gap->iterations;
}

static void set_contacts(const gjk_manifold *manifold, bench_answer *out) {
  out->contacts = manifold->count;
  out->decision = manifold->count > 0 ? BENCH_TOGETHER : BENCH_APART;
  out->distance = GJK_DISTANCE_MAX;
  for (unsigned i = 0; i < manifold->count; i++) {
    const double distance = manifold->contact[i].distance;
    out->distance = distance < out->distance ? distance : out->distance;
  }
}

static gjk_status run_depth(const prepared_pair *p, gjk_cache *cache, bench_answer *out) {
  gjk_penetration_result depth;
  const gjk_status status = gjk_penetration(p->a, p->b, cache, &workspace, &depth);
  out->decision = depth.intersecting ? BENCH_TOGETHER : BENCH_APART;
  out->distance = -depth.depth;
  out->iterations = depth.iterations;
  return status;
}

static void run_query(prepared_pair *p, bench_query query, gjk_cache *cache, bench_answer *out) {
  gjk_status status;
  if (query == BENCH_DISTANCE) {
    gjk_distance_result gap;
    status = gjk_distance(p->a, p->b, cache, &gap);
    set_gap(&gap, out);
  } else if (query == BENCH_INTERSECT) {
    gjk_decision decision;
    status = gjk_intersect(p->a, p->b, cache, &decision);
    out->decision = decision.yes ? BENCH_TOGETHER : BENCH_APART;
    out->iterations = decision.iterations;
  } else if (query == BENCH_DEPTH) {
    status = run_depth(p, cache, out);
  } else {
    gjk_manifold manifold;
    status = gjk_contacts(p->a, p->b, BENCH_MARGIN, BENCH_CONTACTS_KEPT, cache, &workspace, &manifold);
    set_contacts(&manifold, out);
  }
  if (status != GJK_OK) {
    fail(status);
  }
}

static void run_cold(const bench_method *method, void *prepared, bench_query query, bench_answer *out) {
  (void)method;
  run_query(prepared, query, NULL, out);
}

// Every run starts from the cache of the pose before the move.
static void run_warm(const bench_method *method, void *prepared, bench_query query, bench_answer *out) {
  prepared_pair *p = prepared;
  gjk_cache cache = p->caches[query];
  (void)method;
  run_query(p, query, &cache, out);
}

static void *prepare_iterations(const bench_method *method, const bench_pair *pair) {
  prepared_pair *p = prepare(method, pair);
  if (p != NULL) {
    p->effort.iterations = (uint8_t)method->setting;
  }
  return p;
}

static void *prepare_error(const bench_method *method, const bench_pair *pair) {
  prepared_pair *p = prepare(method, pair);
  if (p != NULL) {
    p->effort.error = method->setting;
  }
  return p;
}

// An open answer decides nothing if its lower bound is 0.
static void run_until(const bench_method *method, void *prepared, bench_query query, bench_answer *out) {
  prepared_pair *p = prepared;
  gjk_distance_result gap;
  const gjk_status status = gjk_distance_until(p->a, p->b, &p->effort, NULL, &gap);
  (void)method;
  (void)query;
  if (status != GJK_OK) {
    fail(status);
  }
  set_gap(&gap, out);
  out->bounded = true;
  out->lower = gap.lower;
  out->upper = gap.upper;
  if (!gap.intersecting && gap.lower == 0 && gap.certificate.proof == GJK_PROOF_NONE) {
    out->decision = BENCH_UNDECIDED;
  }
}

static const bench_method cold = {
    .name = "gjk cold", .series = "gjk cold", .answers = ALL, .prepare = prepare, .run = run_cold, .release = free};
static const bench_method warm = {.name = "gjk warm",
                                  .series = "gjk warm",
                                  .answers = ALL,
                                  .prepare = prepare_warm,
                                  .run = run_warm,
                                  .release = free};

#define AFTER(n, unit)                                                                                      \
  {                                                                                                         \
    .name = "gjk after " #n " " unit, .series = "gjk after n iterations", .setting = (n), .answers = UNTIL, \
    .prepare = prepare_iterations, .run = run_until, .release = free                                        \
  }
static const bench_method after[] = {
    AFTER(1, "iteration"),  AFTER(2, "iterations"), AFTER(3, "iterations"), AFTER(4, "iterations"),
    AFTER(5, "iterations"), AFTER(6, "iterations"), AFTER(8, "iterations"),
};

#define TO(n)                                                                                            \
  {                                                                                                      \
    .name = "gjk to " #n " LSB", .series = "gjk to an error of n LSB", .setting = (n), .answers = UNTIL, \
    .prepare = prepare_error, .run = run_until, .release = free                                          \
  }
static const bench_method to[] = {TO(1), TO(16), TO(256)};

bench_method_list bench_gjk_methods = {&cold,     &warm,     &after[0], &after[1], &after[2], &after[3], &after[4],
                                       &after[5], &after[6], &to[0],    &to[1],    &to[2],    NULL};
