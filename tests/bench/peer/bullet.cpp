// Bullet, in the precision that it was built for: the pair detector that its dispatcher uses, and the GJK of EPA2.
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpa2.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include "../method.h"

namespace {

btVector3 to_vector(const double v[3]) {
  return btVector3(static_cast<btScalar>(v[0]), static_cast<btScalar>(v[1]), static_cast<btScalar>(v[2]));
}

struct Prepared {
  btConvexHullShape a, b;
  btTransform at_a, at_b;
  btVoronoiSimplexSolver simplex;
  btGjkEpaPenetrationDepthSolver depth;
};

void fill(const bench_solid &solid, btConvexHullShape *shape, btTransform *at) {
  for (size_t i = 0; i < solid.count; i++) {
    shape->addPoint(to_vector(solid.vertices[i]), false);
  }
  shape->setMargin(0);
  shape->recalcLocalAabb();
  at->setIdentity();
  at->setOrigin(to_vector(solid.centre));
}

void *prepare(const bench_method *, const bench_pair *pair) {
  Prepared *p = new Prepared;
  fill(pair->solid[0], &p->a, &p->at_a);
  fill(pair->solid[1], &p->b, &p->at_b);
  return p;
}

// A pair that the detector reports nothing about has no gap that it knows of.
void run_detector(const bench_method *, void *prepared, bench_query, bench_answer *out) {
  Prepared *p = static_cast<Prepared *>(prepared);
  btGjkPairDetector detector(&p->a, &p->b, &p->simplex, &p->depth);
  btGjkPairDetector::ClosestPointInput input;
  btPointCollector found;
  input.m_transformA = p->at_a;
  input.m_transformB = p->at_b;
  detector.getClosestPoints(input, found, nullptr);
  const bool apart = found.m_hasResult && found.m_distance > 0;
  out->decision = apart ? BENCH_APART : BENCH_TOGETHER;
  out->distance = apart ? static_cast<double>(found.m_distance) * BENCH_LSB_PER_UNIT : 0;
  out->rounds = static_cast<unsigned>(detector.m_curIter);
}

void run_epa2(const bench_method *, void *prepared, bench_query, bench_answer *out) {
  Prepared *p = static_cast<Prepared *>(prepared);
  btGjkEpaSolver2::sResults found;
  const btVector3 guess = p->at_b.getOrigin() - p->at_a.getOrigin();
  const bool apart = btGjkEpaSolver2::Distance(&p->a, p->at_a, &p->b, p->at_b, guess, found);
  out->decision = apart ? BENCH_APART : BENCH_TOGETHER;
  out->distance = apart ? static_cast<double>(found.distance) * BENCH_LSB_PER_UNIT : 0;
}

void release(void *prepared) {
  delete static_cast<Prepared *>(prepared);
}

const bench_method detector = {
    "Bullet pair detector", "Bullet pair detector", 0, false, false, prepare, run_detector, release};
const bench_method epa2 = {"Bullet GJK of EPA2", "Bullet GJK of EPA2", 0, false, false, prepare, run_epa2, release};

}  // namespace

bench_method_list bench_bullet_methods = {&detector, &epa2, nullptr};
