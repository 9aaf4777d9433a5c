// Bullet in the precision that it was built for: its GJK at a sample, and its convex cast with turning on the way. Margins 0.
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/NarrowPhaseCollision/btContinuousConvexCollision.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>
#include <LinearMath/btAabbUtil2.h>

#include <memory>
#include <vector>

#include "../sweep.h"

namespace {

struct Body {
  std::unique_ptr<btConvexShape> shape;
  btTransform at;
  btVector3 low, high;  // its box
};

struct Prepared {
  std::vector<Body> parts, obstacles;
  std::vector<std::pair<size_t, size_t>> pairs;
};

btVector3 to_vector(const double v[3]) {
  return btVector3(static_cast<btScalar>(v[0]), static_cast<btScalar>(v[1]), static_cast<btScalar>(v[2]));
}

Body make_body(const sweep_solid &solid) {
  Body body;
  body.at.setIdentity();
  if (solid.radius > 0) {
    body.shape = std::make_unique<btSphereShape>(static_cast<btScalar>(solid.radius));
    body.at.setOrigin(to_vector(solid.points[0]));
  } else {
    auto hull = std::make_unique<btConvexHullShape>();
    for (size_t i = 0; i < solid.count; i++) {
      hull->addPoint(to_vector(solid.points[i]), false);
    }
    hull->setMargin(0);
    hull->recalcLocalAabb();
    body.shape = std::move(hull);
  }
  body.shape->getAabb(body.at, body.low, body.high);
  return body;
}

void *prepare(const sweep_scene *scene) {
  auto *p = new Prepared;
  for (size_t i = 0; i < scene->part_count; i++) {
    p->parts.push_back(make_body(scene->parts[i]));
  }
  for (size_t i = 0; i < scene->obstacle_count; i++) {
    p->obstacles.push_back(make_body(scene->obstacles[i]));
  }
  for (size_t i = 0; i < scene->pair_count; i++) {
    p->pairs.emplace_back(scene->pairs[i][0], scene->pairs[i][1]);
  }
  return p;
}

btTransform to_transform(const sweep_pose &pose) {
  return btTransform(btQuaternion(static_cast<btScalar>(pose.q[0]), static_cast<btScalar>(pose.q[1]),
                                  static_cast<btScalar>(pose.q[2]), static_cast<btScalar>(pose.q[3])),
                     to_vector(pose.p));
}

bool collides(const Body &a, const Body &b) {
  if (!TestAabbAgainstAabb2(a.low, a.high, b.low, b.high)) {
    return false;
  }
  btVoronoiSimplexSolver simplex;
  btGjkEpaPenetrationDepthSolver depth;
  btGjkPairDetector detector(a.shape.get(), b.shape.get(), &simplex, &depth);
  btGjkPairDetector::ClosestPointInput input;
  btPointCollector out;
  input.m_transformA = a.at;
  input.m_transformB = b.at;
  detector.getClosestPoints(input, out, nullptr);
  return out.m_hasResult && out.m_distance <= 0;
}

bool touches(void *prepared, const sweep_pose *at) {
  auto *p = static_cast<Prepared *>(prepared);
  for (size_t i = 0; i < p->parts.size(); i++) {
    p->parts[i].at = to_transform(at[i]);
    p->parts[i].shape->getAabb(p->parts[i].at, p->parts[i].low, p->parts[i].high);
  }
  for (const auto &pair : p->pairs) {
    if (collides(p->parts[pair.first], p->parts[pair.second])) {
      return true;
    }
  }
  for (const auto &part : p->parts) {
    for (const auto &obstacle : p->obstacles) {
      if (collides(part, obstacle)) {
        return true;
      }
    }
  }
  return false;
}

bool meets(const Body &a, const btTransform a_at[2], const Body &b, const btTransform b_at[2]) {
  btVoronoiSimplexSolver simplex;
  btGjkEpaPenetrationDepthSolver depth;
  btContinuousConvexCollision cast(a.shape.get(), b.shape.get(), &simplex, &depth);
  btConvexCast::CastResult result;
  return cast.calcTimeOfImpact(a_at[0], a_at[1], b_at[0], b_at[1], result);
}

bool sweeps(void *prepared, const sweep_pose *from, const sweep_pose *to) {
  auto *p = static_cast<Prepared *>(prepared);
  std::vector<btTransform> at(2 * p->parts.size());
  for (size_t i = 0; i < p->parts.size(); i++) {
    at[2 * i] = to_transform(from[i]);
    at[2 * i + 1] = to_transform(to[i]);
  }
  for (const auto &pair : p->pairs) {
    if (meets(p->parts[pair.first], &at[2 * pair.first], p->parts[pair.second], &at[2 * pair.second])) {
      return true;
    }
  }
  for (size_t i = 0; i < p->parts.size(); i++) {
    btVector3 low, high, other_low, other_high;
    p->parts[i].shape->getAabb(at[2 * i], low, high);
    p->parts[i].shape->getAabb(at[2 * i + 1], other_low, other_high);
    low.setMin(other_low);
    high.setMax(other_high);
    const btScalar way = (at[2 * i].getOrigin() - at[2 * i + 1].getOrigin()).length();
    const btVector3 more(way, way, way);
    for (const auto &obstacle : p->obstacles) {
      const btTransform still[2] = {obstacle.at, obstacle.at};
      if (TestAabbAgainstAabb2(low - more, high + more, obstacle.low, obstacle.high) &&
          meets(p->parts[i], &at[2 * i], obstacle, still)) {
        return true;
      }
    }
  }
  return false;
}

void release(void *prepared) {
  delete static_cast<Prepared *>(prepared);
}

}  // namespace

const sweep_method sweep_bullet = {"Bullet", prepare, touches, sweeps, release};
