// FCL's continuous collision, in double: conservative advancement with its own GJK, to 1e-6 of the way in at most 100 steps.
// Convex shapes get no faces, so that all vertices are scanned, as by every other method here.
#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/continuous_collision.h>

#include <exception>
#include <memory>
#include <vector>

#include "../cast.h"

namespace {

struct Prepared {
  std::shared_ptr<fcl::CollisionGeometryd> a, b;
  fcl::Transform3d at_a, from_b, to_b;
  fcl::ContinuousCollisionRequestd request;
};

std::shared_ptr<fcl::CollisionGeometryd> make_shape(const cast_solid &solid) {
  if (solid.count == 1 && solid.radius > 0) {
    auto ball = std::make_shared<fcl::Sphered>(solid.radius);
    ball->computeLocalAABB();
    return ball;
  }
  auto vertices = std::make_shared<std::vector<fcl::Vector3d>>();
  for (size_t i = 0; i < solid.count; i++) {
    vertices->emplace_back(solid.vertices[i][0], solid.vertices[i][1], solid.vertices[i][2]);
  }
  auto hull = std::make_shared<fcl::Convexd>(vertices, 0, std::make_shared<std::vector<int>>());
  hull->computeLocalAABB();
  return hull;
}

void *prepare(const cast_case *c) {
  auto *p = new Prepared;
  const double *at = c->solid[1].centre, *way = c->way;
  p->a = make_shape(c->solid[0]);
  p->b = make_shape(c->solid[1]);
  p->at_a = p->from_b = p->to_b = fcl::Transform3d::Identity();
  p->from_b.translation() = fcl::Vector3d(at[0], at[1], at[2]);
  p->to_b.translation() = fcl::Vector3d(at[0] + way[0], at[1] + way[1], at[2] + way[2]);
  p->request =
      fcl::ContinuousCollisionRequestd(100, 1e-6, fcl::CCDM_TRANS, fcl::GST_INDEP, fcl::CCDC_CONSERVATIVE_ADVANCEMENT);
  return p;
}

// FCL throws on configurations that it finds degenerate.
bool run(void *prepared, double *fraction) {
  const auto *p = static_cast<const Prepared *>(prepared);
  fcl::ContinuousCollisionResultd result;
  *fraction = 1;
  try {
    fcl::continuousCollide(p->a.get(), p->at_a, p->at_a, p->b.get(), p->from_b, p->to_b, p->request, result);
    *fraction = result.time_of_contact;
    return result.is_collide;
  } catch (const std::exception &) {
    return false;
  }
}

void release(void *prepared) {
  delete static_cast<Prepared *>(prepared);
}

const cast_method advancement = {.name = "FCL", .prepare = prepare, .run = run, .release = release};

}  // namespace

cast_method_list cast_fcl_methods = {&advancement, nullptr};
