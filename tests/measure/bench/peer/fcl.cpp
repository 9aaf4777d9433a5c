// FCL, in double: its two GJK solvers, tolerances as it sets them. Convex shapes without faces, so all vertices are
// scanned as every other method here does.
#include <fcl/geometry/shape/convex.h>
#include <fcl/narrowphase/detail/gjk_solver_indep.h>
#include <fcl/narrowphase/detail/gjk_solver_libccd.h>

#include <cmath>
#include <exception>
#include <memory>
#include <vector>

#include "../method.h"

namespace {

using Shape = fcl::Convexd;

std::shared_ptr<Shape> make_shape(const bench_solid &solid) {
  auto vertices = std::make_shared<std::vector<fcl::Vector3d>>();
  for (size_t i = 0; i < solid.count; i++) {
    vertices->emplace_back(solid.vertices[i][0], solid.vertices[i][1], solid.vertices[i][2]);
  }
  return std::make_shared<Shape>(vertices, 0, std::make_shared<std::vector<int>>());
}

fcl::Transform3d place(const bench_solid &solid) {
  fcl::Transform3d at = fcl::Transform3d::Identity();
  at.translation() = fcl::Vector3d(solid.centre[0], solid.centre[1], solid.centre[2]);
  return at;
}

template <typename Solver>
struct Prepared {
  std::shared_ptr<Shape> a, b;
  fcl::Transform3d at_a, at_b;
  double convex_radius;
  Solver solver;
};

template <typename Solver>
void *prepare(const bench_method *, const bench_pair *pair) {
  auto *p = new Prepared<Solver>;
  p->a = make_shape(pair->solid[0]);
  p->b = make_shape(pair->solid[1]);
  p->at_a = place(pair->solid[0]);
  p->at_b = place(pair->solid[1]);
  p->convex_radius = pair->solid[0].convex_radius + pair->solid[1].convex_radius;
  return p;
}

// Of the cores, and the rounding on top; a core that EPA has failed on counts as one that touches.
template <typename Solver>
void ask_depth(const Prepared<Solver> *p, bench_answer *out) {
  std::vector<fcl::ContactPoint<double>> contacts;
  double gap = 0;
  fcl::Vector3d on_a, on_b;
  double depth = p->convex_radius;
  if (p->solver.shapeIntersect(*p->a, p->at_a, *p->b, p->at_b, &contacts) && !contacts.empty()) {
    depth += std::abs(contacts[0].penetration_depth);  // this solver's are negative
  } else if (p->solver.shapeDistance(*p->a, p->at_a, *p->b, p->at_b, &gap, &on_a, &on_b)) {
    depth -= gap;
  } else {
    out->decision = BENCH_UNDECIDED;
    return;
  }
  out->decision = depth > 0 ? BENCH_TOGETHER : BENCH_APART;
  out->distance = -depth * BENCH_LSB_PER_UNIT;
}

template <typename Solver>
void ask(const Prepared<Solver> *p, bench_query query, bench_answer *out) {
  bool apart;
  if (query == BENCH_DISTANCE) {
    double gap = 0;
    fcl::Vector3d on_a, on_b;
    apart = p->solver.shapeDistance(*p->a, p->at_a, *p->b, p->at_b, &gap, &on_a, &on_b) && gap > 0;
    out->distance = apart ? gap * BENCH_LSB_PER_UNIT : 0;
  } else {
    apart = !p->solver.shapeIntersect(*p->a, p->at_a, *p->b, p->at_b, nullptr);
  }
  out->decision = apart ? BENCH_APART : BENCH_TOGETHER;
}

// On configurations that it finds degenerate it throws.
template <typename Solver>
void run(const bench_method *, void *prepared, bench_query query, bench_answer *out) {
  out->distance = 0;
  const auto *p = static_cast<const Prepared<Solver> *>(prepared);
  try {
    query == BENCH_DEPTH ? ask_depth(p, out) : ask(p, query, out);
  } catch (const std::exception &) {
    out->decision = BENCH_UNDECIDED;
  }
}

template <typename Solver>
void release(void *prepared) {
  delete static_cast<Prepared<Solver> *>(prepared);
}

using Ccd = fcl::detail::GJKSolver_libccdd;
using Indep = fcl::detail::GJKSolver_indepd;
// Its yes-or-no question and its depths run libccd's MPR, which loops without end on some of the smallest pairs.
const bench_method ccd = {"FCL libccd", "FCL libccd", 0,        BENCH_ASK(BENCH_DISTANCE),
                          false,        prepare<Ccd>, run<Ccd>, release<Ccd>};
const bench_method indep = {
    "FCL indep", "FCL indep",
    0,           BENCH_ASK(BENCH_DISTANCE) | BENCH_ASK(BENCH_INTERSECT) | BENCH_ASK(BENCH_DEPTH),
    false,       prepare<Indep>,
    run<Indep>,  release<Indep>};

}  // namespace

bench_method_list bench_fcl_methods = {&ccd, &indep, nullptr};
