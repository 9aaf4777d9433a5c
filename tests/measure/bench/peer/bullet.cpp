// Bullet, in the precision that it was built for. Three methods: the pair detector that its dispatcher uses, with EPA2
// for depths; the GJK and EPA of EPA2 alone; the detector that its dispatcher uses for two boxes.
#include <BulletCollision/CollisionDispatch/btBoxBoxDetector.h>
#include <BulletCollision/CollisionShapes/btBoxShape.h>
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
  shape->setMargin(static_cast<btScalar>(solid.convex_radius));
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

// If the detector reports nothing about a pair, it knows of no gap and no depth.
void run_detector(const bench_method *, void *prepared, bench_query query, bench_answer *out) {
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
  if (query == BENCH_DEPTH && !apart) {
    out->decision = found.m_hasResult ? BENCH_TOGETHER : BENCH_UNDECIDED;
    out->distance = static_cast<double>(found.m_distance) * BENCH_LSB_PER_UNIT;
  }
  out->iterations = query == BENCH_DEPTH ? 0 : static_cast<unsigned>(detector.m_curIter);  // EPA's are not told
}

void run_epa2(const bench_method *, void *prepared, bench_query query, bench_answer *out) {
  Prepared *p = static_cast<Prepared *>(prepared);
  btGjkEpaSolver2::sResults found;
  const btVector3 guess = p->at_b.getOrigin() - p->at_a.getOrigin();
  if (query == BENCH_DEPTH) {
    const bool deep = btGjkEpaSolver2::Penetration(&p->a, p->at_a, &p->b, p->at_b, guess, found);
    out->decision = deep                                                   ? BENCH_TOGETHER
                    : found.status == btGjkEpaSolver2::sResults::Separated ? BENCH_APART
                                                                           : BENCH_UNDECIDED;
    out->distance = static_cast<double>(found.distance) * BENCH_LSB_PER_UNIT;
    return;
  }
  const bool apart = btGjkEpaSolver2::Distance(&p->a, p->at_a, &p->b, p->at_b, guess, found);
  out->decision = apart ? BENCH_APART : BENCH_TOGETHER;
  out->distance = apart ? static_cast<double>(found.distance) * BENCH_LSB_PER_UNIT : 0;
}

void release(void *prepared) {
  delete static_cast<Prepared *>(prepared);
}

// Boxes as the detector takes them: with right angles. Posing has rounded the axes of ours.
struct PreparedBoxes {
  btBoxShape a, b;
  btTransform at_a, at_b;
};

btVector3 extents(const bench_solid &solid) {
  const btVector3 all(to_vector(solid.half_axes[0]).length(), to_vector(solid.half_axes[1]).length(),
                      to_vector(solid.half_axes[2]).length());
  return all;
}

btTransform place(const bench_solid &solid) {
  btVector3 axis[3];
  for (int i = 0; i < 3; i++) {
    axis[i] = to_vector(solid.half_axes[i]).normalized();
  }
  const btMatrix3x3 rows(axis[0].x(), axis[1].x(), axis[2].x(), axis[0].y(), axis[1].y(), axis[2].y(), axis[0].z(),
                         axis[1].z(), axis[2].z());
  return btTransform(rows, to_vector(solid.centre));
}

void *prepare_boxes(const bench_method *, const bench_pair *pair) {
  PreparedBoxes *p = new PreparedBoxes{btBoxShape(extents(pair->solid[0])), btBoxShape(extents(pair->solid[1])),
                                       place(pair->solid[0]), place(pair->solid[1])};
  p->a.setMargin(0);
  p->b.setMargin(0);
  return p;
}

void release_boxes(void *prepared) {
  delete static_cast<PreparedBoxes *>(prepared);
}

struct Deepest : btDiscreteCollisionDetectorInterface::Result {
  unsigned count = 0;
  double distance = 0;
  void setShapeIdentifiersA(int, int) override {
  }
  void setShapeIdentifiersB(int, int) override {
  }
  void addContactPoint(const btVector3 &, const btVector3 &, btScalar depth) override {
    distance = count == 0 || depth < distance ? static_cast<double>(depth) : distance;
    count++;
  }
};

void run_boxes(const bench_method *, void *prepared, bench_query, bench_answer *out) {
  const PreparedBoxes *p = static_cast<PreparedBoxes *>(prepared);
  btBoxBoxDetector detector(&p->a, &p->b);
  btDiscreteCollisionDetectorInterface::ClosestPointInput input;
  Deepest found;
  input.m_transformA = p->at_a;
  input.m_transformB = p->at_b;
  detector.getClosestPoints(input, found, nullptr);
  out->decision = found.count > 0 ? BENCH_TOGETHER : BENCH_APART;
  out->distance = found.distance * BENCH_LSB_PER_UNIT;
  out->contacts = found.count;
}

constexpr unsigned all = BENCH_ASK(BENCH_DISTANCE) | BENCH_ASK(BENCH_INTERSECT) | BENCH_ASK(BENCH_DEPTH);
const bench_method detector = {.name = "Bullet pair detector",
                               .series = "Bullet pair detector",
                               .setting = 0,
                               .answers = all,
                               .boxes_only = false,
                               .prepare = prepare,
                               .run = run_detector,
                               .release = release};
const bench_method epa2 = {.name = "Bullet EPA2",
                           .series = "Bullet EPA2",
                           .setting = 0,
                           .answers = all,
                           .boxes_only = false,
                           .prepare = prepare,
                           .run = run_epa2,
                           .release = release};
const bench_method boxes = {.name = "Bullet box-box",
                            .series = "Bullet box-box",
                            .setting = 0,
                            .answers = BENCH_ASK(BENCH_CONTACTS),
                            .boxes_only = true,
                            .prepare = prepare_boxes,
                            .run = run_boxes,
                            .release = release_boxes};

}  // namespace

bench_method_list bench_bullet_methods = {&detector, &epa2, &boxes, nullptr};
