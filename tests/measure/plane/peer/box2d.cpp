// Box2D, in float: its GJK (b2Distance), which answers at 10 epsilons as b2TestOverlap does, or at exactly 0; and
// b2CollidePolygons, for up to 8 corners. Polygon radii are 0 throughout. Corners go into the shapes directly, since
// b2PolygonShape::Set welds corners nearer than half the linear slop.
#include <box2d/b2_collision.h>
#include <box2d/b2_distance.h>
#include <box2d/b2_polygon_shape.h>

#include <algorithm>
#include <vector>

#include "../plane.h"

namespace {

struct Prepared {
  std::vector<b2Vec2> corner[2];
  b2DistanceInput input;
  b2PolygonShape shape[2];
  bool fits;
};

void set_shape(const std::vector<b2Vec2> &corner, b2PolygonShape *out) {
  out->m_count = static_cast<int32>(corner.size());
  out->m_radius = 0;
  for (int32 i = 0; i < out->m_count; i++) {
    b2Vec2 edge = corner[(i + 1) % corner.size()] - corner[i];
    out->m_vertices[i] = corner[i];
    out->m_normals[i] = b2Cross(edge, 1.0f);
    out->m_normals[i].Normalize();
  }
}

void *prepare(const plane_pair *pair) {
  Prepared *p = new Prepared;
  p->fits = true;
  for (int i = 0; i < 2; i++) {
    const plane_solid &solid = pair->solid[i];
    for (size_t k = 0; k < solid.count; k++) {
      p->corner[i].push_back(b2Vec2(static_cast<float>(solid.corner[k][0]), static_cast<float>(solid.corner[k][1])));
    }
    b2Transform &at = i == 0 ? p->input.transformA : p->input.transformB;
    at.SetIdentity();
    at.p.Set(static_cast<float>(solid.centre[0]), static_cast<float>(solid.centre[1]));
    b2DistanceProxy &proxy = i == 0 ? p->input.proxyA : p->input.proxyB;
    proxy.Set(p->corner[i].data(), static_cast<int32>(solid.count), 0);
    p->fits = p->fits && solid.count <= b2_maxPolygonVertices;
  }
  p->input.useRadii = false;
  for (int i = 0; i < 2 && p->fits; i++) {
    set_shape(p->corner[i], &p->shape[i]);
  }
  return p;
}

float gap(const Prepared *p) {
  b2SimplexCache cache;
  b2DistanceOutput out;
  cache.count = 0;
  b2Distance(&out, &cache, &p->input);
  return out.distance;
}

double run_distance(void *prepared) {
  return gap(static_cast<Prepared *>(prepared));
}

double run_overlap(void *prepared) {
  return gap(static_cast<Prepared *>(prepared)) < 10 * b2_epsilon;
}

double run_overlap_exact(void *prepared) {
  return gap(static_cast<Prepared *>(prepared)) == 0;
}

void collide(const Prepared *p, b2Manifold *out) {
  b2CollidePolygons(out, &p->shape[0], p->input.transformA, &p->shape[1], p->input.transformB);
}

double run_contacts(void *prepared) {
  const Prepared *p = static_cast<Prepared *>(prepared);
  b2Manifold manifold;
  collide(p, &manifold);
  return manifold.pointCount;
}

double run_depth(void *prepared) {
  const Prepared *p = static_cast<Prepared *>(prepared);
  b2Manifold manifold;
  b2WorldManifold world;
  collide(p, &manifold);
  if (manifold.pointCount == 0) {
    return 0;
  }
  world.Initialize(&manifold, p->input.transformA, 0, p->input.transformB, 0);
  return -std::min(world.separations[0], manifold.pointCount == 2 ? world.separations[1] : world.separations[0]);
}

double run_collide(void *prepared) {
  return static_cast<Prepared *>(prepared)->fits ? run_contacts(prepared) > 0 : run_overlap(prepared);
}

plane_run *choose_gjk(plane_query query) {
  return query == PLANE_DISTANCE ? run_distance : query == PLANE_INTERSECT ? run_overlap : nullptr;
}

plane_run *choose_exact(plane_query query) {
  return query == PLANE_INTERSECT ? run_overlap_exact : nullptr;
}

plane_run *choose_collide(plane_query query) {
  return query == PLANE_DEPTH       ? run_depth
         : query == PLANE_CONTACTS  ? run_contacts
         : query == PLANE_INTERSECT ? run_collide
                                    : nullptr;
}

void release(void *prepared) {
  delete static_cast<Prepared *>(prepared);
}

const plane_method gjk = {"Box2D b2Distance", choose_gjk, prepare, release};
const plane_method exact = {"Box2D b2Distance 0", choose_exact, prepare, release};
const plane_method clip = {"Box2D b2CollidePolygons", choose_collide, prepare, release};

}  // namespace

plane_method_list plane_box2d_methods = {&gjk, &exact, &clip, nullptr};
