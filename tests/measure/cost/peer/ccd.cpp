// libccd, in double, with support functions made for it: vertices posed beforehand, or rotated directions where posing
// is part of what is measured. Its GJK (depths: its EPA), and its MPR, which answers yes or no only. Tolerances are those
// that it sets itself; the number of iterations, unlimited by default, gets a limit.
#include <ccd/ccd.h>

#include <cmath>
#include <vector>

#include "../cost.h"

namespace {

struct Body {
  const double (*vertices)[3];  // about the position: in the world's axes, or in those of the body where it is rotated
  size_t count;
  double at[3], rotation[3][3], half[3];
};

struct Prepared {
  std::vector<double> own[2], posed[2];  // vertices
  Body world[2], local[2];               // a box has none: its axes are the rotation's columns
  cost_place place[2];
  ccd_t of_world, of_local;
};

void set_rotation(const double q[4], double r[3][3]) {
  const double x = q[0], y = q[1], z = q[2], w = q[3];
  r[0][0] = 1 - 2 * (y * y + z * z);
  r[0][1] = 2 * (x * y - z * w);
  r[0][2] = 2 * (x * z + y * w);
  r[1][0] = 2 * (x * y + z * w);
  r[1][1] = 1 - 2 * (x * x + z * z);
  r[1][2] = 2 * (y * z - x * w);
  r[2][0] = 2 * (x * z - y * w);
  r[2][1] = 2 * (y * z + x * w);
  r[2][2] = 1 - 2 * (x * x + y * y);
}

void set_place(const cost_place &place, Body *out) {
  for (int k = 0; k < 3; k++) {
    out->at[k] = place.position[k];
  }
  set_rotation(place.rotation, out->rotation);
}

const double *farthest(const Body *body, const double d[3]) {
  const double *best = body->vertices[0];
  double most = best[0] * d[0] + best[1] * d[1] + best[2] * d[2];
  for (size_t i = 1; i < body->count; i++) {
    const double *v = body->vertices[i];
    const double along = v[0] * d[0] + v[1] * d[1] + v[2] * d[2];
    if (along > most) {
      most = along;
      best = v;
    }
  }
  return best;
}

void support_world(const void *object, const ccd_vec3_t *direction, ccd_vec3_t *out) {
  const Body *body = static_cast<const Body *>(object);
  const double *v = farthest(body, direction->v);
  for (int k = 0; k < 3; k++) {
    out->v[k] = body->at[k] + v[k];
  }
}

void turn_back(const Body *body, const ccd_vec3_t *direction, double out[3]) {
  for (int k = 0; k < 3; k++) {
    out[k] = body->rotation[0][k] * direction->v[0] + body->rotation[1][k] * direction->v[1] +
             body->rotation[2][k] * direction->v[2];
  }
}

void place(const Body *body, const double v[3], ccd_vec3_t *out) {
  for (int k = 0; k < 3; k++) {
    out->v[k] = body->at[k] + body->rotation[k][0] * v[0] + body->rotation[k][1] * v[1] + body->rotation[k][2] * v[2];
  }
}

void support_local(const void *object, const ccd_vec3_t *direction, ccd_vec3_t *out) {
  const Body *body = static_cast<const Body *>(object);
  double d[3];
  turn_back(body, direction, d);
  place(body, farthest(body, d), out);
}

void support_box(const void *object, const ccd_vec3_t *direction, ccd_vec3_t *out) {
  const Body *body = static_cast<const Body *>(object);
  double d[3];
  turn_back(body, direction, d);
  const double v[3] = {std::copysign(body->half[0], d[0]), std::copysign(body->half[1], d[1]),
                       std::copysign(body->half[2], d[2])};
  place(body, v, out);
}

void centre(const void *object, ccd_vec3_t *out) {
  const Body *body = static_cast<const Body *>(object);
  for (int k = 0; k < 3; k++) {
    out->v[k] = body->at[k];
  }
}

void set_ccd(ccd_support_fn support, ccd_t *out) {
  CCD_INIT(out);
  out->support1 = out->support2 = support;
  out->center1 = out->center2 = centre;
  out->max_iterations = 500;
}

void set_vertices(const cost_solid &solid, const Body &body, std::vector<double> *own, std::vector<double> *posed) {
  for (size_t i = 0; i < solid.count; i++) {
    const double *v = solid.vertices[i];
    for (int k = 0; k < 3; k++) {
      own->push_back(v[k]);
      posed->push_back(body.rotation[k][0] * v[0] + body.rotation[k][1] * v[1] + body.rotation[k][2] * v[2]);
    }
  }
}

void *prepare(const cost_pair *pair, cost_query) {
  Prepared *p = new Prepared{};
  const bool is_box = pair->solid[0].kind == COST_BOX;
  for (int i = 0; i < 2; i++) {
    const cost_solid &solid = pair->solid[i];
    p->place[i] = solid.at;
    for (int k = 0; k < 3; k++) {
      p->local[i].half[k] = solid.half[k];
    }
    set_place(solid.at, &p->local[i]);
    set_vertices(solid, p->local[i], &p->own[i], &p->posed[i]);
    p->local[i].count = solid.count;
    p->world[i] = p->local[i];
    p->local[i].vertices = reinterpret_cast<const double(*)[3]>(p->own[i].data());
    p->world[i].vertices = reinterpret_cast<const double(*)[3]>(p->posed[i].data());
  }
  set_ccd(is_box ? support_box : support_world, &p->of_world);
  set_ccd(is_box ? support_box : support_local, &p->of_local);
  return p;
}

enum Way { GJK, EPA, MPR };

template <Way way>
double ask(const Body body[2], const ccd_t *ccd) {
  if (way == GJK) {
    return ccdGJKIntersect(&body[0], &body[1], ccd);
  }
  if (way == MPR) {
    return ccdMPRIntersect(&body[0], &body[1], ccd);
  }
  double depth = 0;
  ccd_vec3_t direction, position;
  return ccdGJKPenetration(&body[0], &body[1], ccd, &depth, &direction, &position) == 0 ? depth : 0;
}

template <Way way>
double run_cold(void *prepared) {
  Prepared *p = static_cast<Prepared *>(prepared);
  return ask<way>(p->world, &p->of_world);
}

template <Way way>
double run_posed(void *prepared) {
  Prepared *p = static_cast<Prepared *>(prepared);
  set_place(p->place[0], &p->local[0]);
  set_place(p->place[1], &p->local[1]);
  return ask<way>(p->local, &p->of_local);
}

template <Way way>
cost_run *choose_way(cost_mode mode) {
  return mode == COST_COLD ? run_cold<way> : mode == COST_POSED ? run_posed<way> : nullptr;
}

bool is_known(cost_kind a, cost_kind b) {
  return a == b && (a == COST_BOX || a == COST_HULL);
}

cost_run *choose_gjk(cost_kind a, cost_kind b, cost_query query, cost_mode mode) {
  if (!is_known(a, b)) {
    return nullptr;
  }
  return query == COST_INTERSECT ? choose_way<GJK>(mode) : query == COST_DEPTH ? choose_way<EPA>(mode) : nullptr;
}

cost_run *choose_mpr(cost_kind a, cost_kind b, cost_query query, cost_mode mode) {
  return is_known(a, b) && query == COST_INTERSECT ? choose_way<MPR>(mode) : nullptr;
}

void release(void *prepared) {
  delete static_cast<Prepared *>(prepared);
}

const cost_method gjk = {"libccd", "libccd GJK", choose_gjk, prepare, release};
const cost_method mpr = {"libccd", "libccd MPR", choose_mpr, prepare, release};

}  // namespace

cost_method_list cost_ccd_methods = {&gjk, &mpr, nullptr};
