// Bullet's three casters, in the precision that it was built for.
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/NarrowPhaseCollision/btContinuousConvexCollision.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkConvexCast.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btSubSimplexConvexCast.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <memory>

#include "../cast.h"

namespace {

btVector3 to_vector(const double v[3]) {
  return btVector3(static_cast<btScalar>(v[0]), static_cast<btScalar>(v[1]), static_cast<btScalar>(v[2]));
}

struct Prepared {
  std::unique_ptr<btConvexShape> a, b;
  btTransform from_a, from_b, to_b;
  btVoronoiSimplexSolver simplex;
  btGjkEpaPenetrationDepthSolver depth;
  std::unique_ptr<btConvexCast> cast;
};

std::unique_ptr<btConvexShape> make_shape(const cast_solid &solid) {
  if (solid.count == 1 && solid.radius > 0) {
    return std::make_unique<btSphereShape>(static_cast<btScalar>(solid.radius));
  }
  auto hull = std::make_unique<btConvexHullShape>();
  for (size_t i = 0; i < solid.count; i++) {
    hull->addPoint(to_vector(solid.vertices[i]), false);
  }
  hull->setMargin(static_cast<btScalar>(solid.radius));
  hull->recalcLocalAabb();
  return hull;
}

Prepared *prepare(const cast_case *c) {
  Prepared *p = new Prepared;
  p->a = make_shape(c->solid[0]);
  p->b = make_shape(c->solid[1]);
  p->from_a.setIdentity();
  p->from_b.setIdentity();
  p->from_b.setOrigin(to_vector(c->solid[1].centre));
  const double end[3] = {c->solid[1].centre[0] + c->way[0], c->solid[1].centre[1] + c->way[1],
                         c->solid[1].centre[2] + c->way[2]};
  p->to_b = p->from_b;
  p->to_b.setOrigin(to_vector(end));
  return p;
}

template <typename Cast>
void *prepare_with(const cast_case *c) {
  Prepared *p = prepare(c);
  p->cast = std::make_unique<Cast>(p->a.get(), p->b.get(), &p->simplex);
  return p;
}

void *prepare_continuous(const cast_case *c) {
  Prepared *p = prepare(c);
  p->cast = std::make_unique<btContinuousConvexCollision>(p->a.get(), p->b.get(), &p->simplex, &p->depth);
  return p;
}

bool run(void *prepared, double *fraction) {
  Prepared *p = static_cast<Prepared *>(prepared);
  btConvexCast::CastResult result;
  const bool hit = p->cast->calcTimeOfImpact(p->from_a, p->from_a, p->from_b, p->to_b, result);
  *fraction = static_cast<double>(result.m_fraction);
  return hit && *fraction <= 1;
}

void release(void *prepared) {
  delete static_cast<Prepared *>(prepared);
}

const cast_method subsimplex = {
    .name = "Bullet subsimplex", .prepare = prepare_with<btSubsimplexConvexCast>, .run = run, .release = release};
const cast_method gjk = {
    .name = "Bullet GJK", .prepare = prepare_with<btGjkConvexCast>, .run = run, .release = release};
const cast_method continuous = {
    .name = "Bullet continuous", .prepare = prepare_continuous, .run = run, .release = release};

}  // namespace

cast_method_list cast_bullet_methods = {&subsimplex, &gjk, &continuous, nullptr};
