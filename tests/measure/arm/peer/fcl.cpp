// FCL in double with its own GJK: collide at a sample, conservative advancement on the way, obstacles in its dynamic tree.
// Convex shapes get no faces, so that all vertices are scanned, as by every other method here.
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/continuous_collision.h>

#include <exception>
#include <memory>
#include <vector>

#include "../sweep.h"

namespace {

struct Prepared {
  std::vector<std::unique_ptr<fcl::CollisionObjectd>> parts, obstacles;
  std::vector<std::pair<size_t, size_t>> pairs;
  fcl::DynamicAABBTreeCollisionManagerd tree;
};

std::unique_ptr<fcl::CollisionObjectd> make_object(const sweep_solid &solid) {
  fcl::Transform3d at = fcl::Transform3d::Identity();
  std::shared_ptr<fcl::CollisionGeometryd> shape;
  if (solid.radius > 0) {
    shape = std::make_shared<fcl::Sphered>(solid.radius);
    at.translation() = fcl::Vector3d(solid.points[0][0], solid.points[0][1], solid.points[0][2]);
  } else {
    auto vertices = std::make_shared<std::vector<fcl::Vector3d>>();
    for (size_t i = 0; i < solid.count; i++) {
      vertices->emplace_back(solid.points[i][0], solid.points[i][1], solid.points[i][2]);
    }
    shape = std::make_shared<fcl::Convexd>(vertices, 0, std::make_shared<std::vector<int>>());
  }
  shape->computeLocalAABB();
  return std::make_unique<fcl::CollisionObjectd>(shape, at);
}

void *prepare(const sweep_scene *scene) {
  auto *p = new Prepared;
  for (size_t i = 0; i < scene->part_count; i++) {
    p->parts.push_back(make_object(scene->parts[i]));
  }
  for (size_t i = 0; i < scene->obstacle_count; i++) {
    p->obstacles.push_back(make_object(scene->obstacles[i]));
    p->obstacles.back()->computeAABB();
    p->tree.registerObject(p->obstacles.back().get());
  }
  for (size_t i = 0; i < scene->pair_count; i++) {
    p->pairs.emplace_back(scene->pairs[i][0], scene->pairs[i][1]);
  }
  p->tree.setup();
  return p;
}

fcl::Transform3d to_transform(const sweep_pose &pose) {
  fcl::Transform3d t = fcl::Transform3d::Identity();
  t.linear() = fcl::Quaterniond(pose.q[3], pose.q[0], pose.q[1], pose.q[2]).toRotationMatrix();
  t.translation() = fcl::Vector3d(pose.p[0], pose.p[1], pose.p[2]);
  return t;
}

// FCL throws on configurations that it finds degenerate.
bool collides(fcl::CollisionObjectd *a, fcl::CollisionObjectd *b) {
  fcl::CollisionRequestd request(1, false);
  fcl::CollisionResultd result;
  request.gjk_solver_type = fcl::GST_INDEP;
  try {
    return fcl::collide(a, b, request, result) > 0;
  } catch (const std::exception &) {
    return false;
  }
}

bool stop_at_first(fcl::CollisionObjectd *a, fcl::CollisionObjectd *b, void *found) {
  auto *yes = static_cast<bool *>(found);
  *yes = *yes || collides(a, b);
  return *yes;
}

bool touches(void *prepared, const sweep_pose *at) {
  auto *p = static_cast<Prepared *>(prepared);
  for (size_t i = 0; i < p->parts.size(); i++) {
    p->parts[i]->setTransform(to_transform(at[i]));
    p->parts[i]->computeAABB();
  }
  for (const auto &pair : p->pairs) {
    if (p->parts[pair.first]->getAABB().overlap(p->parts[pair.second]->getAABB()) &&
        collides(p->parts[pair.first].get(), p->parts[pair.second].get())) {
      return true;
    }
  }
  bool found = false;
  for (size_t i = 0; !found && i < p->parts.size(); i++) {
    p->tree.collide(p->parts[i].get(), &found, stop_at_first);
  }
  return found;
}

bool meets(const fcl::CollisionObjectd &a, const fcl::Transform3d a_at[2], const fcl::CollisionObjectd &b,
           const fcl::Transform3d b_at[2]) {
  const fcl::ContinuousCollisionRequestd request(100, 1e-6, fcl::CCDM_LINEAR, fcl::GST_INDEP,
                                                 fcl::CCDC_CONSERVATIVE_ADVANCEMENT);
  fcl::ContinuousCollisionResultd result;
  try {
    fcl::continuousCollide(a.collisionGeometry().get(), a_at[0], a_at[1], b.collisionGeometry().get(), b_at[0], b_at[1],
                           request, result);
    return result.is_collide;
  } catch (const std::exception &) {
    return false;
  }
}

bool sweeps(void *prepared, const sweep_pose *from, const sweep_pose *to) {
  auto *p = static_cast<Prepared *>(prepared);
  std::vector<fcl::Transform3d> at(2 * p->parts.size());
  for (size_t i = 0; i < p->parts.size(); i++) {
    at[2 * i] = to_transform(from[i]);
    at[2 * i + 1] = to_transform(to[i]);
  }
  for (const auto &pair : p->pairs) {
    if (meets(*p->parts[pair.first], &at[2 * pair.first], *p->parts[pair.second], &at[2 * pair.second])) {
      return true;
    }
  }
  for (size_t i = 0; i < p->parts.size(); i++) {
    // The sphere around the part at both ends and between them, against boxes.
    const auto &geometry = *p->parts[i]->collisionGeometry();
    const fcl::Vector3d a = at[2 * i] * geometry.aabb_center, b = at[2 * i + 1] * geometry.aabb_center;
    const double reach = geometry.aabb_radius + 0.25 * (a - b).norm();
    fcl::AABBd box(a, b);
    box.expand(fcl::Vector3d(reach, reach, reach));
    for (const auto &obstacle : p->obstacles) {
      const fcl::Transform3d still[2] = {obstacle->getTransform(), obstacle->getTransform()};
      if (box.overlap(obstacle->getAABB()) && meets(*p->parts[i], &at[2 * i], *obstacle, still)) {
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

const sweep_method sweep_fcl = {"FCL", prepare, touches, sweeps, release};
