// libccd, in double: its GJK, which answers yes or no, and its EPA for depths. Its MPR is left out, as it loops without
// end on some of the smallest pairs.
#include <ccd/ccd.h>

#include <cmath>

#include "../method.h"

namespace {

struct Prepared {
  bench_solid solid[2];
  ccd_t ccd;
};

void support(const void *object, const ccd_vec3_t *direction, ccd_vec3_t *out) {
  const bench_solid *s = static_cast<const bench_solid *>(object);
  size_t farthest = 0;
  double best = 0;
  for (size_t i = 0; i < s->count; i++) {
    const double *v = s->vertices[i];
    const double along = v[0] * direction->v[0] + v[1] * direction->v[1] + v[2] * direction->v[2];
    if (i == 0 || along > best) {
      best = along;
      farthest = i;
    }
  }
  const double length = std::sqrt(direction->v[0] * direction->v[0] + direction->v[1] * direction->v[1] +
                                  direction->v[2] * direction->v[2]);
  const double out_by = s->convex_radius > 0 && length > 0 ? s->convex_radius / length : 0;
  for (int k = 0; k < 3; k++) {
    out->v[k] = s->centre[k] + s->vertices[farthest][k] + out_by * direction->v[k];
  }
}

// Its tolerances are those that it sets itself. The number of iterations, unlimited by default, gets a limit.
void *prepare(const bench_method *, const bench_pair *pair) {
  Prepared *p = new Prepared;
  p->solid[0] = pair->solid[0];
  p->solid[1] = pair->solid[1];
  CCD_INIT(&p->ccd);
  p->ccd.support1 = p->ccd.support2 = support;
  p->ccd.max_iterations = 500;
  return p;
}

// ccdGJKPenetration returns -1 for shapes that are apart and -2 if it failed.
void run_depth(const Prepared *p, bench_answer *out) {
  double depth = 0;
  ccd_vec3_t direction, position;
  const int status = ccdGJKPenetration(&p->solid[0], &p->solid[1], &p->ccd, &depth, &direction, &position);
  out->decision = status == 0 ? BENCH_TOGETHER : status == -1 ? BENCH_APART : BENCH_UNDECIDED;
  out->distance = -depth * BENCH_LSB_PER_UNIT;
}

void run_gjk(const bench_method *, void *prepared, bench_query query, bench_answer *out) {
  const Prepared *p = static_cast<Prepared *>(prepared);
  if (query == BENCH_DEPTH) {
    run_depth(p, out);
  } else {
    out->decision = ccdGJKIntersect(&p->solid[0], &p->solid[1], &p->ccd) != 0 ? BENCH_TOGETHER : BENCH_APART;
  }
}

void release(void *prepared) {
  delete static_cast<Prepared *>(prepared);
}

const bench_method gjk = {.name = "libccd GJK",
                          .series = "libccd GJK",
                          .setting = 0,
                          .answers = BENCH_ASK(BENCH_INTERSECT) | BENCH_ASK(BENCH_DEPTH),
                          .boxes_only = false,
                          .prepare = prepare,
                          .run = run_gjk,
                          .release = release};

}  // namespace

bench_method_list bench_ccd_methods = {&gjk, nullptr};
