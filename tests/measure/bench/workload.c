// Makes the pairs that are measured: posed, proven, and in the form that other libraries take.
#define _POSIX_C_SOURCE 200112L
#include "workload.h"

#include "../measuring.h"
#include "case/case.h"
#include "exact/exact.h"
#include "truth.h"

// So many pairs apart, a depth is proven thoroughly.
#define THOROUGH_EVERY 5

static void fail(const bench_pair *pair, const char *why) {
  fprintf(stderr, "bench: a pair without a proven answer: %s\n", why);
  case_print(stderr, pair->shapes);
  exit(1);
}

static bool asks_depth(const bench_family *family) {
  return bench_asks(family, BENCH_DEPTH) || bench_asks(family, BENCH_CONTACTS);
}

static void set_distance(bench_pair *pair) {
  char why[160] = "";
  if (!bench_find_distance(pair, why, sizeof why)) {
    fail(pair, why);
  }
}

static bench_depth_proof set_depth(bench_pair *pair, bool thorough) {
  char why[160] = "";
  const bench_depth_proof proof = bench_find_depth(pair, thorough, why, sizeof why);
  if (proof == BENCH_DEPTH_UNPROVEN) {
    fail(pair, why);
  }
  return proof;
}

static void set_vector(gjk_vec3 v, double out[3]) {
  out[0] = (double)v.x / BENCH_LSB_PER_UNIT;
  out[1] = (double)v.y / BENCH_LSB_PER_UNIT;
  out[2] = (double)v.z / BENCH_LSB_PER_UNIT;
}

static void set_solid(const gjk_collider *collider, bench_solid *out) {
  const gjk_vec3 centre = collider->centre;
  const int64_t c[3] = {centre.x, centre.y, centre.z};
  out->count = exact_vertex_count(collider);
  out->convex_radius = (double)collider->shape->convex_radius / BENCH_LSB_PER_UNIT;
  set_vector(centre, out->centre);
  for (int i = 0; i < 3; i++) {
    set_vector(collider->frame[i], out->half_axes[i]);
  }
  out->vertices = measuring_allocate(out->count, sizeof *out->vertices);
  for (unsigned i = 0; i < out->count; i++) {
    const exact_point vertex = exact_vertex(collider, i);
    for (int k = 0; k < 3; k++) {
      out->vertices[i][k] = (double)(vertex.x[k] - c[k]) / BENCH_LSB_PER_UNIT;
    }
  }
}

// Is the pair as it was meant to be? Placing reaches the gap to within an LSB, as coordinates are integers. A depth may
// be less, along another direction.
static bool is_as_placed(const bench_family *family, const bench_pair *pair) {
  if (asks_depth(family)) {
    return pair->intersecting;
  }
  return pair->placed == BENCH_NOT_PLACED ||
         (pair->placed < 0 ? pair->intersecting : fabs(pair->distance - pair->placed) <= 1);
}

static void make_pair(const bench_family *family, random_state *random, bench_pair *pair) {
  do {
    pair->placed = BENCH_NOT_PLACED;
    case_shape_reset(&pair->shapes->a);
    case_shape_reset(&pair->shapes->b);
    family->make(family, random, pair->shapes, &pair->placed);
    if (case_collider_build(pair->a, &pair->shapes->a, false) != GJK_OK ||
        case_collider_build(pair->b, &pair->shapes->b, false) != GJK_OK) {
      fail(pair, "it cannot be posed");
    }
    set_distance(pair);
  } while (!is_as_placed(family, pair));
}

bench_pair *bench_pairs_make(const bench_family *family, uint64_t seed, size_t count, size_t *exact) {
  bench_pair *pairs = measuring_allocate(count, sizeof *pairs);
  *exact = 0;
  for (size_t i = 0; i < count; i++) {
    random_state random = random_seed((seed << 32) + i);
    bench_pair *pair = &pairs[i];
    pair->shapes = measuring_allocate(1, sizeof *pair->shapes);
    pair->a = measuring_allocate(1, sizeof *pair->a);
    pair->b = measuring_allocate(1, sizeof *pair->b);
    make_pair(family, &random, pair);
    if (asks_depth(family)) {
      *exact += set_depth(pair, i % THOROUGH_EVERY == 0) == BENCH_DEPTH_EXACT;
    }
    set_solid(&pair->a->collider, &pair->solid[0]);
    set_solid(&pair->b->collider, &pair->solid[1]);
  }
  return pairs;
}

void bench_pairs_free(bench_pair *pairs, size_t count) {
  for (size_t i = 0; i < count; i++) {
    case_pair_free(pairs[i].shapes);
    case_collider_free(pairs[i].a);
    case_collider_free(pairs[i].b);
    free(pairs[i].shapes);
    free(pairs[i].a);
    free(pairs[i].b);
    free(pairs[i].solid[0].vertices);
    free(pairs[i].solid[1].vertices);
  }
  free(pairs);
}
