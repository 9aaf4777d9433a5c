// CGAL's convex_hull_3 with exact predicates. It gives triangles, which are not merged.
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include "peer.h"

void hull_by_cgal(const gjk_vec3 *points, unsigned count, hull_count *out) {
  typedef CGAL::Exact_predicates_inexact_constructions_kernel kernel;
  std::vector<kernel::Point_3> at;
  CGAL::Surface_mesh<kernel::Point_3> mesh;
  for (unsigned i = 0; i < count; i++) {
    at.emplace_back(points[i].x, points[i].y, points[i].z);
  }
  CGAL::convex_hull_3(at.begin(), at.end(), mesh);
  out->vertices = static_cast<unsigned>(mesh.number_of_vertices());
  out->faces = 0;
}
