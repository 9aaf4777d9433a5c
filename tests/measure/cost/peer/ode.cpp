// ODE, in the precision that it was built for: its collider of two boxes. A yes-or-no question asks for one contact
// that need not be a good one.
#include <ode/ode.h>

#include "../cost.h"

namespace {

struct Prepared {
  dGeomID geom[2];
  cost_place place[2];
};

void place(const cost_place &place, dGeomID geom) {
  const double *p = place.position, *q = place.rotation;
  const dQuaternion rotation = {static_cast<dReal>(q[3]), static_cast<dReal>(q[0]), static_cast<dReal>(q[1]),
                                static_cast<dReal>(q[2])};
  dGeomSetPosition(geom, static_cast<dReal>(p[0]), static_cast<dReal>(p[1]), static_cast<dReal>(p[2]));
  dGeomSetQuaternion(geom, rotation);
}

void *prepare(const cost_pair *pair, cost_query) {
  static const int started = dInitODE2(0);
  Prepared *p = new Prepared;
  (void)started;
  for (int i = 0; i < 2; i++) {
    const double *half = pair->solid[i].half;
    p->geom[i] = dCreateBox(nullptr, static_cast<dReal>(2 * half[0]), static_cast<dReal>(2 * half[1]),
                            static_cast<dReal>(2 * half[2]));
    p->place[i] = pair->solid[i].at;
    place(p->place[i], p->geom[i]);
  }
  return p;
}

template <cost_query query, bool posed>
double run(void *prepared) {
  Prepared *p = static_cast<Prepared *>(prepared);
  dContactGeom contacts[8];
  if (posed) {
    place(p->place[0], p->geom[0]);
    place(p->place[1], p->geom[1]);
  }
  const int flags = query == COST_INTERSECT ? 1 : 8;
  const int count = dCollide(p->geom[0], p->geom[1], flags, contacts, sizeof contacts[0]);
  if (query == COST_INTERSECT) {
    return count > 0;
  }
  double depth = 0;
  for (int i = 0; i < count; i++) {
    const double of_contact = static_cast<double>(contacts[i].depth);
    depth = of_contact > depth ? of_contact : depth;
  }
  return depth;
}

cost_run *choose(cost_kind a, cost_kind b, cost_query query, cost_mode mode) {
  const bool posed = mode == COST_POSED;
  if (a != COST_BOX || b != COST_BOX || (mode != COST_COLD && !posed)) {
    return nullptr;
  }
  switch (query) {
    case COST_INTERSECT: return posed ? run<COST_INTERSECT, true> : run<COST_INTERSECT, false>;
    case COST_DEPTH: return posed ? run<COST_DEPTH, true> : run<COST_DEPTH, false>;
    default: return nullptr;
  }
}

void release(void *prepared) {
  Prepared *p = static_cast<Prepared *>(prepared);
  dGeomDestroy(p->geom[0]);
  dGeomDestroy(p->geom[1]);
  delete p;
}

const cost_method boxes = {"ODE", "ODE box-box", choose, prepare, release};

}  // namespace

cost_method_list cost_ode_methods = {&boxes, nullptr};
