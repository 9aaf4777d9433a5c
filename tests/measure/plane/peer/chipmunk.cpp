// Chipmunk2D, in double: cpShapesCollide, its GJK and EPA and then its contact points, on polygons of radius 0.
#include <chipmunk/chipmunk.h>

#include <algorithm>
#include <vector>

#include "../plane.h"

namespace {

struct Prepared {
  cpBody *body[2];
  cpShape *shape[2];
};

void *prepare(const plane_pair *pair) {
  Prepared *p = new Prepared;
  for (int i = 0; i < 2; i++) {
    const plane_solid &solid = pair->solid[i];
    std::vector<cpVect> corner;
    for (size_t k = 0; k < solid.count; k++) {
      corner.push_back(cpv(solid.corner[k][0], solid.corner[k][1]));
    }
    p->body[i] = cpBodyNewKinematic();
    cpBodySetPosition(p->body[i], cpv(solid.centre[0], solid.centre[1]));
    p->shape[i] = cpPolyShapeNewRaw(p->body[i], static_cast<int>(solid.count), corner.data(), 0);
    cpShapeCacheBB(p->shape[i]);
  }
  return p;
}

void release(void *prepared) {
  Prepared *p = static_cast<Prepared *>(prepared);
  for (int i = 0; i < 2; i++) {
    cpShapeFree(p->shape[i]);
    cpBodyFree(p->body[i]);
  }
  delete p;
}

cpContactPointSet collide(void *prepared) {
  const Prepared *p = static_cast<Prepared *>(prepared);
  return cpShapesCollide(p->shape[0], p->shape[1]);
}

double run_contacts(void *prepared) {
  return collide(prepared).count;
}

double run_intersect(void *prepared) {
  return collide(prepared).count > 0;
}

double run_depth(void *prepared) {
  const cpContactPointSet set = collide(prepared);
  double least = 0;
  for (int i = 0; i < set.count; i++) {
    least = std::min(least, set.points[i].distance);
  }
  return -least;
}

plane_run *choose(plane_query query) {
  return query == PLANE_DEPTH       ? run_depth
         : query == PLANE_CONTACTS  ? run_contacts
         : query == PLANE_INTERSECT ? run_intersect
                                    : nullptr;
}

const plane_method collision = {"Chipmunk", choose, prepare, release};

}  // namespace

plane_method_list plane_chipmunk_methods = {&collision, nullptr};
