// ODE, in the precision that it was built for: dSpaceCollide of a hash space, and dCollide for up to 4 contacts a pair.
#include <ode/ode.h>

#include <vector>

#include "gjk/mesh.h"
#include "gjk/pose.h"

#include "../rest.h"

namespace {

struct World {
  const rest_stage *stage;
  dSpaceID moving, fixed;
  std::vector<dGeomID> geoms;
  dTriMeshDataID mesh = nullptr;
  std::vector<float> vertices;
  std::vector<dTriIndex> indices;
  unsigned frame = 0;
  rest_found found;
};

const gjk_pose &pose_of(const World *w, unsigned frame, unsigned body) {
  return static_cast<const gjk_pose *>(w->stage->poses)[frame * w->stage->bodies + body];
}

dReal to_real(int32_t x, double one) {
  return static_cast<dReal>(x / one);
}

void place(dGeomID geom, const gjk_pose &pose) {
  const double one = 1 << 30;
  const dQuaternion q = {to_real(pose.rotation.w, one), to_real(pose.rotation.x, one), to_real(pose.rotation.y, one),
                         to_real(pose.rotation.z, one)};
  dGeomSetPosition(geom, to_real(pose.position.x, 65536), to_real(pose.position.y, 65536),
                   to_real(pose.position.z, 65536));
  dGeomSetQuaternion(geom, q);
}

bool same(const gjk_pose &a, const gjk_pose &b) {
  return a.position.x == b.position.x && a.position.y == b.position.y && a.position.z == b.position.z &&
         a.rotation.x == b.rotation.x && a.rotation.y == b.rotation.y && a.rotation.z == b.rotation.z &&
         a.rotation.w == b.rotation.w;
}

void meet(void *world, dGeomID a, dGeomID b) {
  World *w = static_cast<World *>(world);
  dContactGeom contacts[4];
  w->found.pairs++;
  w->found.near += dCollide(a, b, 4, contacts, sizeof contacts[0]) > 0;
}

bool go(void *world, unsigned frame, rest_found *found) {
  World *w = static_cast<World *>(world);
  w->found = rest_found{};
  for (unsigned i = 0; i < w->stage->bodies; i++) {
    if (!w->stage->body[i].fixed && !same(pose_of(w, frame, i), pose_of(w, w->frame, i))) {
      place(w->geoms[i], pose_of(w, frame, i));
      w->found.moved++;
    }
  }
  w->frame = frame;
  dSpaceCollide(w->moving, w, meet);
  dSpaceCollide2(reinterpret_cast<dGeomID>(w->moving), reinterpret_cast<dGeomID>(w->fixed), w, meet);
  w->found.manifolds = w->found.near;
  *found = w->found;
  return true;
}

dGeomID add_mesh(World *w) {
  const gjk_mesh *m = static_cast<const gjk_mesh *>(w->stage->mesh);
  for (uint32_t i = 0; i < m->vertex_count; i++) {
    const gjk_vec3 &v = m->vertices[i];
    for (int32_t x : {v.x, v.y, v.z}) {
      w->vertices.push_back(static_cast<float>(x / 65536.0));
    }
  }
  for (uint32_t i = 0; i < m->triangle_count; i++) {
    for (uint32_t corner : m->triangles[i].corner) {
      w->indices.push_back(GJK_MESH_NUMBER(corner));
    }
  }
  w->mesh = dGeomTriMeshDataCreate();
  dGeomTriMeshDataBuildSingle(w->mesh, w->vertices.data(), 3 * sizeof(float), static_cast<int>(m->vertex_count),
                              w->indices.data(), static_cast<int>(w->indices.size()), 3 * sizeof(dTriIndex));
  return dCreateTriMesh(w->fixed, w->mesh, nullptr, nullptr, nullptr);
}

void *start(const rest_stage *stage) {
  static const int started = dInitODE2(0);
  (void)started;
  dAllocateODEDataForThread(dAllocateMaskAll);
  World *w = new World;
  w->stage = stage;
  w->moving = dHashSpaceCreate(nullptr);
  w->fixed = dSimpleSpaceCreate(nullptr);
  for (unsigned i = 0; i < stage->bodies; i++) {
    const float *half = stage->half[stage->body[i].shape];
    const bool mesh = stage->mesh != nullptr && stage->body[i].shape == 0;
    w->geoms.push_back(mesh ? add_mesh(w)
                            : dCreateBox(stage->body[i].fixed ? w->fixed : w->moving, static_cast<dReal>(2 * half[0]),
                                         static_cast<dReal>(2 * half[1]), static_cast<dReal>(2 * half[2])));
    place(w->geoms.back(), pose_of(w, 0, i));
  }
  return w;
}

void stop(void *world) {
  World *w = static_cast<World *>(world);
  dSpaceDestroy(w->moving);
  dSpaceDestroy(w->fixed);
  if (w->mesh != nullptr) {
    dGeomTriMeshDataDestroy(w->mesh);
  }
  delete w;
}

}  // namespace

extern "C" const rest_method rest_ode = {.name = "ODE", .plane = false, .start = start, .go = go, .stop = stop};
