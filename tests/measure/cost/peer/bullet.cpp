// Bullet, in the precision that it was built for: the pair detector that its dispatcher uses, with EPA2 for depths and
// the last axis when warm; the GJK and EPA of EPA2 alone; and the detector that its dispatcher uses for two boxes. Shapes
// are its own (box, capsule, sphere, hull), margins 0. Yes-or-no questions stop as soon as the shapes are known to be
// apart.
#include <BulletCollision/CollisionDispatch/btBoxBoxDetector.h>
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpa2.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <memory>

#include "../cost.h"

namespace {

btScalar scalar(double x) {
  return static_cast<btScalar>(x);
}

btVector3 vector(const double v[3]) {
  return btVector3(scalar(v[0]), scalar(v[1]), scalar(v[2]));
}

btTransform transform(const cost_place &place) {
  const double *q = place.rotation;
  return btTransform(btQuaternion(scalar(q[0]), scalar(q[1]), scalar(q[2]), scalar(q[3])), vector(place.position));
}

std::unique_ptr<btConvexShape> make_shape(const cost_solid &solid) {
  std::unique_ptr<btConvexShape> shape;
  switch (solid.kind) {
    case COST_BOX: shape = std::make_unique<btBoxShape>(vector(solid.half)); break;
    case COST_CAPSULE: return std::make_unique<btCapsuleShapeZ>(scalar(solid.radius), scalar(2 * solid.half[2]));
    case COST_SPHERE: return std::make_unique<btSphereShape>(scalar(solid.radius));
    case COST_HULL: {
      auto hull = std::make_unique<btConvexHullShape>();
      for (size_t i = 0; i < solid.count; i++) {
        hull->addPoint(vector(solid.vertices[i]), false);
      }
      hull->recalcLocalAabb();
      shape = std::move(hull);
    }
  }
  shape->setMargin(0);
  return shape;
}

struct Prepared {
  std::unique_ptr<btConvexShape> a, b;
  cost_place place_a, place_b;
  btTransform at_a, at_b;
  btVector3 axis;  // of the detector, one step ago
  btVoronoiSimplexSolver simplex;
  btGjkEpaPenetrationDepthSolver depth;
};

template <bool posed>
void place(Prepared *p) {
  if (posed) {
    p->at_a = transform(p->place_a);
    p->at_b = transform(p->place_b);
  }
}

template <cost_query query>
double detect(Prepared *p, btGjkPairDetector &detector) {
  btGjkPairDetector::ClosestPointInput input;
  btPointCollector found;
  input.m_transformA = p->at_a;
  input.m_transformB = p->at_b;
  if (query == COST_INTERSECT) {
    input.m_maximumDistanceSquared = 0;
  }
  detector.getClosestPoints(input, found, nullptr);
  if (query == COST_INTERSECT) {
    return found.m_hasResult;
  }
  const double distance = found.m_hasResult ? static_cast<double>(found.m_distance) : 0;
  return query == COST_DEPTH ? -distance : distance;
}

template <cost_query query, bool posed, bool warm>
double run_detector(void *prepared) {
  Prepared *p = static_cast<Prepared *>(prepared);
  btGjkPairDetector detector(p->a.get(), p->b.get(), &p->simplex, &p->depth);
  place<posed>(p);
  if (warm) {
    detector.setCachedSeparatingAxis(p->axis);
  }
  return detect<query>(p, detector);
}

template <cost_query query, bool posed>
double run_epa2(void *prepared) {
  Prepared *p = static_cast<Prepared *>(prepared);
  btGjkEpaSolver2::sResults found;
  place<posed>(p);
  const btVector3 guess = p->at_b.getOrigin() - p->at_a.getOrigin();
  if (query == COST_DEPTH) {
    return btGjkEpaSolver2::Penetration(p->a.get(), p->at_a, p->b.get(), p->at_b, guess, found)
               ? -static_cast<double>(found.distance)
               : 0;
  }
  const bool apart = btGjkEpaSolver2::Distance(p->a.get(), p->at_a, p->b.get(), p->at_b, guess, found);
  return query == COST_INTERSECT ? !apart : apart ? static_cast<double>(found.distance) : 0;
}

struct Deepest : btDiscreteCollisionDetectorInterface::Result {
  bool any = false;
  double depth = 0;
  void setShapeIdentifiersA(int, int) override {
  }
  void setShapeIdentifiersB(int, int) override {
  }
  void addContactPoint(const btVector3 &, const btVector3 &, btScalar distance) override {
    depth = static_cast<double>(-distance) > depth ? static_cast<double>(-distance) : depth;
    any = true;
  }
};

template <cost_query query, bool posed>
double run_boxes(void *prepared) {
  Prepared *p = static_cast<Prepared *>(prepared);
  btBoxBoxDetector detector(static_cast<btBoxShape *>(p->a.get()), static_cast<btBoxShape *>(p->b.get()));
  btDiscreteCollisionDetectorInterface::ClosestPointInput input;
  Deepest found;
  place<posed>(p);
  input.m_transformA = p->at_a;
  input.m_transformB = p->at_b;
  detector.getClosestPoints(input, found, nullptr);
  return query == COST_INTERSECT ? found.any : found.depth;
}

void *prepare(const cost_pair *pair, cost_query) {
  Prepared *p = new Prepared;
  p->a = make_shape(pair->solid[0]);
  p->b = make_shape(pair->solid[1]);
  p->place_a = pair->solid[0].before;
  p->place_b = pair->solid[1].before;
  place<true>(p);
  btGjkPairDetector detector(p->a.get(), p->b.get(), &p->simplex, &p->depth);
  detect<COST_DISTANCE>(p, detector);
  p->axis = detector.getCachedSeparatingAxis();
  p->place_a = pair->solid[0].at;
  p->place_b = pair->solid[1].at;
  place<true>(p);
  return p;
}

template <cost_query query>
cost_run *choose_detector_of(cost_mode mode) {
  static cost_run *const runs[COST_MODES] = {run_detector<query, false, false>, run_detector<query, false, true>,
                                             run_detector<query, true, false>, run_detector<query, true, true>};
  return runs[mode];
}

cost_run *choose_detector(cost_kind, cost_kind, cost_query query, cost_mode mode) {
  switch (query) {
    case COST_DISTANCE: return choose_detector_of<COST_DISTANCE>(mode);
    case COST_INTERSECT: return choose_detector_of<COST_INTERSECT>(mode);
    case COST_DEPTH: return mode == COST_COLD || mode == COST_POSED ? choose_detector_of<COST_DEPTH>(mode) : nullptr;
    default: return nullptr;
  }
}

// EPA2 takes a sphere for its centre, and a capsule for its segment.
cost_run *choose_epa2(cost_kind a, cost_kind, cost_query query, cost_mode mode) {
  const bool posed = mode == COST_POSED;
  if (a == COST_SPHERE || a == COST_CAPSULE || (mode != COST_COLD && !posed)) {
    return nullptr;
  }
  switch (query) {
    case COST_DISTANCE: return posed ? run_epa2<COST_DISTANCE, true> : run_epa2<COST_DISTANCE, false>;
    case COST_INTERSECT: return posed ? run_epa2<COST_INTERSECT, true> : run_epa2<COST_INTERSECT, false>;
    case COST_DEPTH: return posed ? run_epa2<COST_DEPTH, true> : run_epa2<COST_DEPTH, false>;
    default: return nullptr;
  }
}

cost_run *choose_boxes(cost_kind a, cost_kind b, cost_query query, cost_mode mode) {
  const bool posed = mode == COST_POSED;
  if (a != COST_BOX || b != COST_BOX || (mode != COST_COLD && !posed)) {
    return nullptr;
  }
  switch (query) {
    case COST_INTERSECT: return posed ? run_boxes<COST_INTERSECT, true> : run_boxes<COST_INTERSECT, false>;
    case COST_DEPTH: return posed ? run_boxes<COST_DEPTH, true> : run_boxes<COST_DEPTH, false>;
    default: return nullptr;
  }
}

void release(void *prepared) {
  delete static_cast<Prepared *>(prepared);
}

const cost_method detector = {"Bullet", "Bullet pair detector", choose_detector, prepare, release};
const cost_method epa2 = {"Bullet", "Bullet EPA2", choose_epa2, prepare, release};
const cost_method boxes = {"Bullet", "Bullet box-box", choose_boxes, prepare, release};

}  // namespace

cost_method_list cost_bullet_methods = {&detector, &epa2, &boxes, nullptr};
