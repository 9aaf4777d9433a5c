// FCL, in double: its two GJK solvers with the tolerances that they set themselves, on its own shapes, for which it has
// closed forms (two boxes, two capsules). Hulls in two forms: all points, which FCL scans; or corners alone and faces,
// along whose edges FCL climbs from 33 corners on. Warm: the guess of the solver that has one.
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/detail/gjk_solver_indep.h>
#include <fcl/narrowphase/detail/gjk_solver_libccd.h>

#include <cmath>
#include <exception>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "../cost.h"

namespace {

using Points = std::vector<fcl::Vector3d>;
using Ccd = fcl::detail::GJKSolver_libccdd;
using Indep = fcl::detail::GJKSolver_indepd;

// The point that an edge's plane meets last when it turns about the edge: all others lie on one side of it.
int last_met(const Points &points, const fcl::Vector3d &from, const fcl::Vector3d &to) {
  int found = -1;
  for (size_t i = 0; i < points.size(); i++) {
    const fcl::Vector3d at = points[i];
    if (at == from || at == to) {
      continue;
    }
    if (found < 0 || (to - from).cross(points[static_cast<size_t>(found)] - from).dot(at - from) > 0) {
      found = static_cast<int>(i);
    }
  }
  return found;
}

// The triangles of a hull, outside counterclockwise, by gift wrapping.
std::vector<int> wrap(const Points &points) {
  std::vector<int> faces;
  std::set<std::pair<int, int>> done;
  std::vector<std::pair<int, int>> open;
  int lowest = 0;
  for (size_t i = 0; i < points.size(); i++) {
    lowest = points[i].z() < points[static_cast<size_t>(lowest)].z() ? static_cast<int>(i) : lowest;
  }
  const fcl::Vector3d start = points[static_cast<size_t>(lowest)];
  open.emplace_back(lowest, last_met(points, start, start + fcl::Vector3d::UnitX()));
  while (!open.empty()) {
    const std::pair<int, int> edge = open.back();
    open.pop_back();
    if (done.count(edge) != 0) {
      continue;
    }
    const int third =
        last_met(points, points[static_cast<size_t>(edge.first)], points[static_cast<size_t>(edge.second)]);
    const int corner[4] = {edge.first, edge.second, third, edge.first};
    faces.push_back(3);
    for (int k = 0; k < 3; k++) {
      faces.push_back(corner[k]);
      done.emplace(corner[k], corner[k + 1]);
      open.emplace_back(corner[k + 1], corner[k]);
    }
  }
  return faces;
}

// Drops the points that are no corners.
void prune(Points *points, std::vector<int> *faces) {
  std::vector<int> name(points->size(), -1);
  Points kept;
  for (size_t i = 0; i < faces->size(); i++) {
    if (i % 4 != 0) {
      const size_t corner = static_cast<size_t>((*faces)[i]);
      if (name[corner] < 0) {
        name[corner] = static_cast<int>(kept.size());
        kept.push_back((*points)[corner]);
      }
      (*faces)[i] = name[corner];
    }
  }
  *points = kept;
}

fcl::Convexd make_convex(const cost_solid &solid, bool with_faces) {
  Points points;
  std::vector<int> faces;
  for (size_t i = 0; i < solid.count; i++) {
    points.emplace_back(solid.vertices[i][0], solid.vertices[i][1], solid.vertices[i][2]);
  }
  if (with_faces) {
    faces = wrap(points);
    prune(&points, &faces);
  }
  const int count = static_cast<int>(faces.size() / 4);
  return fcl::Convexd(std::make_shared<const Points>(points), count, std::make_shared<const std::vector<int>>(faces));
}

template <typename Shape>
Shape make_shape(const cost_solid &solid, bool with_faces);
template <>
fcl::Boxd make_shape<fcl::Boxd>(const cost_solid &solid, bool) {
  return fcl::Boxd(2 * solid.half[0], 2 * solid.half[1], 2 * solid.half[2]);
}
template <>
fcl::Capsuled make_shape<fcl::Capsuled>(const cost_solid &solid, bool) {
  return fcl::Capsuled(solid.radius, 2 * solid.half[2]);
}
template <>
fcl::Sphered make_shape<fcl::Sphered>(const cost_solid &solid, bool) {
  return fcl::Sphered(solid.radius);
}
template <>
fcl::Convexd make_shape<fcl::Convexd>(const cost_solid &solid, bool with_faces) {
  return make_convex(solid, with_faces);
}

fcl::Transform3d place(const cost_place &place) {
  const double *p = place.position, *q = place.rotation;
  fcl::Transform3d at = fcl::Transform3d::Identity();
  at.linear() = fcl::Quaterniond(q[3], q[0], q[1], q[2]).toRotationMatrix();
  at.translation() = fcl::Vector3d(p[0], p[1], p[2]);
  return at;
}

struct Released {
  virtual ~Released() = default;
};

template <typename Solver, typename A, typename B>
struct Prepared : Released {
  A a;
  B b;
  cost_place place_a, place_b;
  fcl::Transform3d at_a, at_b;
  fcl::Vector3d guess;
  Solver cold, warm;

  Prepared(const cost_pair *pair, bool with_faces)
      : a(make_shape<A>(pair->solid[0], with_faces)),
        b(make_shape<B>(pair->solid[1], with_faces)),
        place_a(pair->solid[0].at),
        place_b(pair->solid[1].at),
        at_a(place(place_a)),
        at_b(place(place_b)),
        guess(1, 0, 0) {
  }
};

template <cost_query query, typename P, typename Solver>
double ask(const P *p, const Solver &solver, const fcl::Transform3d &at_a, const fcl::Transform3d &at_b) {
  if (query == COST_DISTANCE) {
    double gap = 0;
    fcl::Vector3d on_a, on_b;
    return solver.shapeDistance(p->a, at_a, p->b, at_b, &gap, &on_a, &on_b) ? gap : 0;
  }
  if (query == COST_INTERSECT) {
    return solver.shapeIntersect(p->a, at_a, p->b, at_b, nullptr);
  }
  std::vector<fcl::ContactPoint<double>> contacts;
  double depth = 0;
  solver.shapeIntersect(p->a, at_a, p->b, at_b, &contacts);
  for (const auto &contact : contacts) {
    depth = std::fmax(depth, std::fabs(contact.penetration_depth));  // those of one solver are negative
  }
  return depth;
}

// FCL throws on configurations that it finds degenerate.
template <typename P, cost_query query, cost_mode mode>
double run(void *prepared) {
  P *p = static_cast<P *>(static_cast<Released *>(prepared));
  constexpr bool is_warm = mode == COST_WARM || mode == COST_POSED_WARM;
  if (mode == COST_POSED || mode == COST_POSED_WARM) {
    p->at_a = place(p->place_a);
    p->at_b = place(p->place_b);
  }
  if (is_warm) {
    p->warm.setCachedGuess(p->guess);
  }
  try {
    return ask<query>(p, is_warm ? p->warm : p->cold, p->at_a, p->at_b);
  } catch (const std::exception &) {
    return 0;
  }
}

template <typename Solver, bool with_faces, typename A, typename B>
void *prepare_as(const cost_pair *pair, cost_query query) {
  auto *p = new Prepared<Solver, A, B>(pair, with_faces);
  const fcl::Transform3d at_a = place(pair->solid[0].before), at_b = place(pair->solid[1].before);
  p->warm.enableCachedGuess(true);
  p->warm.setCachedGuess(p->guess);
  try {
    if (query == COST_DISTANCE) {
      ask<COST_DISTANCE>(p, p->warm, at_a, at_b);
    } else {
      ask<COST_INTERSECT>(p, p->warm, at_a, at_b);
    }
  } catch (const std::exception &) {
  }
  p->guess = p->warm.getCachedGuess();
  return static_cast<Released *>(p);
}

template <typename Solver, bool with_faces>
void *prepare(const cost_pair *pair, cost_query query) {
  switch (pair->solid[0].kind) {
    case COST_BOX: return prepare_as<Solver, with_faces, fcl::Boxd, fcl::Boxd>(pair, query);
    case COST_CAPSULE: return prepare_as<Solver, with_faces, fcl::Capsuled, fcl::Capsuled>(pair, query);
    case COST_SPHERE: return prepare_as<Solver, with_faces, fcl::Sphered, fcl::Convexd>(pair, query);
    default: return prepare_as<Solver, with_faces, fcl::Convexd, fcl::Convexd>(pair, query);
  }
}

template <typename P, cost_query query>
cost_run *choose_mode(cost_mode mode) {
  static cost_run *const runs[COST_MODES] = {run<P, query, COST_COLD>, run<P, query, COST_WARM>,
                                             run<P, query, COST_POSED>, run<P, query, COST_POSED_WARM>};
  return runs[mode];
}

template <typename Solver, cost_query query>
cost_run *choose_shapes(cost_kind a, cost_mode mode) {
  switch (a) {
    case COST_BOX: return choose_mode<Prepared<Solver, fcl::Boxd, fcl::Boxd>, query>(mode);
    case COST_CAPSULE: return choose_mode<Prepared<Solver, fcl::Capsuled, fcl::Capsuled>, query>(mode);
    case COST_SPHERE: return choose_mode<Prepared<Solver, fcl::Sphered, fcl::Convexd>, query>(mode);
    default: return choose_mode<Prepared<Solver, fcl::Convexd, fcl::Convexd>, query>(mode);
  }
}

cost_run *choose_indep(cost_kind a, cost_kind, cost_query query, cost_mode mode) {
  switch (query) {
    case COST_DISTANCE: return choose_shapes<Indep, COST_DISTANCE>(a, mode);
    case COST_INTERSECT: return choose_shapes<Indep, COST_INTERSECT>(a, mode);
    case COST_DEPTH:
      return mode == COST_COLD || mode == COST_POSED ? choose_shapes<Indep, COST_DEPTH>(a, mode) : nullptr;
    default: return nullptr;
  }
}

// This solver has no guess, and its depths are MPR's, which are not the least.
cost_run *choose_ccd(cost_kind a, cost_kind, cost_query query, cost_mode mode) {
  if (mode != COST_COLD && mode != COST_POSED) {
    return nullptr;
  }
  return query == COST_DISTANCE    ? choose_shapes<Ccd, COST_DISTANCE>(a, mode)
         : query == COST_INTERSECT ? choose_shapes<Ccd, COST_INTERSECT>(a, mode)
                                   : nullptr;
}

cost_run *choose_indep_faces(cost_kind a, cost_kind b, cost_query query, cost_mode mode) {
  return b == COST_HULL ? choose_indep(a, b, query, mode) : nullptr;
}

cost_run *choose_ccd_faces(cost_kind a, cost_kind b, cost_query query, cost_mode mode) {
  return b == COST_HULL ? choose_ccd(a, b, query, mode) : nullptr;
}

void release(void *prepared) {
  delete static_cast<Released *>(prepared);
}

const cost_method ccd = {"FCL", "FCL libccd", choose_ccd, prepare<Ccd, false>, release};
const cost_method ccd_faces = {"FCL", "FCL libccd faces", choose_ccd_faces, prepare<Ccd, true>, release};
const cost_method indep = {"FCL", "FCL indep", choose_indep, prepare<Indep, false>, release};
const cost_method indep_faces = {"FCL", "FCL indep faces", choose_indep_faces, prepare<Indep, true>, release};

}  // namespace

cost_method_list cost_fcl_methods = {&ccd, &ccd_faces, &indep, &indep_faces, nullptr};
