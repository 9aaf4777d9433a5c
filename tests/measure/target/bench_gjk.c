// The library as the benchmark runs it.
#include "bench.h"

static void keep(const gjk_collider *a, const gjk_collider *b) {
  (void)a;
  (void)b;
}

static void run_distance(bench_answer *out) {
  static gjk_distance_result result;
  gjk_distance(bench_pair[0], bench_pair[1], NULL, &result);
  out->intersecting = result.intersecting;
  out->distance = result.distance;
  out->iterations = result.iterations;
}

static void run_intersect(bench_answer *out) {
  static gjk_decision decision;
  gjk_intersect(bench_pair[0], bench_pair[1], NULL, &decision);
  out->intersecting = decision.yes;
  out->iterations = decision.iterations;
}

static void run_depth(bench_answer *out) {
  static gjk_penetration_result result;
  gjk_penetration(bench_pair[0], bench_pair[1], NULL, &bench_workspace, &result);
  out->intersecting = result.intersecting;
  out->distance = -result.depth;
  out->iterations = result.iterations;
}

static void run_contacts(bench_answer *out) {
  static gjk_manifold manifold;
  gjk_contacts(bench_pair[0], bench_pair[1], BENCH_MARGIN, BENCH_CONTACTS_KEPT, NULL, &bench_workspace, &manifold);
  out->iterations = manifold.count;
  out->distance = GJK_DISTANCE_MAX;
  for (unsigned i = 0; i < manifold.count; i++) {
    const gjk_q16 distance = manifold.contact[i].distance;
    out->distance = distance < out->distance ? distance : out->distance;
  }
  out->intersecting = out->distance <= 0;
}

static void run_impact(bench_answer *out) {
  static const gjk_impact_setup setup = {0, GJK_IMPACT_TOLERANCE_MIN, 0};
  static gjk_impact_result result;
  gjk_time_of_impact(bench_pair[0], &bench_motion[0], bench_pair[1], &bench_motion[1], &setup, &result);
  out->intersecting = result.hit;
  out->distance = result.distance;
  out->iterations = result.iterations;
}

static void run(bench_query query, bench_answer *out) {
  static void (*const runs[])(bench_answer *) = {run_distance, run_intersect, run_depth, run_contacts, run_impact};
  runs[query](out);
}

const bench_solver bench_gjk = {.name = "gjk", .last = BENCH_IMPACT, .pose = keep, .run = run};
