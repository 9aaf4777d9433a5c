// The library: cold, with a warm cache, and stopped early.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../case/case.h"
#include "method.h"

// How far B has moved since the cache was filled, in parts of its radius.
#define STEP_PARTS 100

typedef struct prepared_pair {
  const gjk_collider *a, *b;
  gjk_cache caches[BENCH_QUERIES];  // as the query one step ago left them; zeroed: cold
  gjk_effort effort;
} prepared_pair;

static void *prepare(const bench_method *method, const bench_pair *pair) {
  prepared_pair *p = calloc(1, sizeof *p);
  (void)method;
  if (p != NULL) {
    p->a = &pair->a->collider;
    p->b = &pair->b->collider;
  }
  return p;
}

// The direction of the step differs from pair to pair, but is the same in every run.
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
  if (p != NULL && gjk_collider_move(&before, &at) == GJK_OK) {
    gjk_distance(p->a, &before, &p->caches[BENCH_DISTANCE], &gap);
    gjk_intersect(p->a, &before, &p->caches[BENCH_INTERSECT], &decision);
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
  out->rounds = gap->iterations;
}

static void run_query(prepared_pair *p, bench_query query, gjk_cache *cache, bench_answer *out) {
  if (query == BENCH_DISTANCE) {
    gjk_distance_result gap;
    const gjk_status status = gjk_distance(p->a, p->b, cache, &gap);
    if (status != GJK_OK) {
      fail(status);
    }
    set_gap(&gap, out);
  } else {
    gjk_decision decision;
    const gjk_status status = gjk_intersect(p->a, p->b, cache, &decision);
    if (status != GJK_OK) {
      fail(status);
    }
    out->decision = decision.yes ? BENCH_TOGETHER : BENCH_APART;
    out->rounds = decision.iterations;
  }
}

static void run_cold(const bench_method *method, void *prepared, bench_query query, bench_answer *out) {
  (void)method;
  run_query(prepared, query, NULL, out);
}

// Every run starts from the cache of one step ago.
static void run_warm(const bench_method *method, void *prepared, bench_query query, bench_answer *out) {
  prepared_pair *p = prepared;
  gjk_cache cache = p->caches[query];
  (void)method;
  run_query(p, query, &cache, out);
}

static void *prepare_rounds(const bench_method *method, const bench_pair *pair) {
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

// An open answer decides nothing while its lower bound is 0.
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

static const bench_method cold = {"gjk cold", "gjk cold", 0, false, false, prepare, run_cold, free};
static const bench_method warm = {"gjk warm", "gjk warm", 0, false, false, prepare_warm, run_warm, free};

#define AFTER(n) \
  { "gjk after " #n " rounds", "gjk after n rounds", (n), true, false, prepare_rounds, run_until, free }
static const bench_method after[] = {
    {"gjk after 1 round", "gjk after n rounds", 1, true, false, prepare_rounds, run_until, free},
    AFTER(2),
    AFTER(3),
    AFTER(4),
    AFTER(5),
    AFTER(6),
    AFTER(8)};

#define TO(n) \
  { "gjk to " #n " LSB", "gjk to an error of n LSB", (n), true, false, prepare_error, run_until, free }
static const bench_method to[] = {TO(1), TO(16), TO(256)};

bench_method_list bench_gjk_methods = {&cold,     &warm,     &after[0], &after[1], &after[2], &after[3], &after[4],
                                       &after[5], &after[6], &to[0],    &to[1],    &to[2],    NULL};
