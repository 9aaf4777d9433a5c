// Bullet's collision world, with its persistent manifolds: performDiscreteCollisionDetection. Margins and settings are its
// own.
#include <btBulletCollisionCommon.h>

#include <memory>
#include <vector>

#include "gjk/mesh.h"
#include "gjk/pose.h"

#include "../rest.h"

namespace {

struct World {
  const rest_stage *stage;
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broad;
  btCollisionWorld world{&dispatcher, &broad, &configuration};
  btTriangleMesh triangles;
  std::vector<std::unique_ptr<btCollisionShape>> shapes;
  std::vector<std::unique_ptr<btCollisionObject>> objects;
  unsigned frame = 0;
};

const gjk_pose &pose_of(const World *w, unsigned frame, unsigned body) {
  return static_cast<const gjk_pose *>(w->stage->poses)[frame * w->stage->bodies + body];
}

btScalar to_scalar(int32_t x, double one) {
  return static_cast<btScalar>(x / one);
}

btVector3 to_vector(const gjk_vec3 &v) {
  return btVector3(to_scalar(v.x, 65536), to_scalar(v.y, 65536), to_scalar(v.z, 65536));
}

btTransform to_transform(const gjk_pose &pose) {
  const double one = 1 << 30;
  const gjk_quat &q = pose.rotation;
  return btTransform(btQuaternion(to_scalar(q.x, one), to_scalar(q.y, one), to_scalar(q.z, one), to_scalar(q.w, one)),
                     to_vector(pose.position));
}

bool same(const gjk_pose &a, const gjk_pose &b) {
  return a.position.x == b.position.x && a.position.y == b.position.y && a.position.z == b.position.z &&
         a.rotation.x == b.rotation.x && a.rotation.y == b.rotation.y && a.rotation.z == b.rotation.z &&
         a.rotation.w == b.rotation.w;
}

bool go(void *world, unsigned frame, rest_found *found) {
  World *w = static_cast<World *>(world);
  found->moved = 0;
  for (unsigned i = 0; i < w->stage->bodies; i++) {
    if (!w->stage->body[i].fixed && !same(pose_of(w, frame, i), pose_of(w, w->frame, i))) {
      w->objects[i]->setWorldTransform(to_transform(pose_of(w, frame, i)));
      found->moved++;
    }
  }
  w->frame = frame;
  w->world.performDiscreteCollisionDetection();
  found->pairs = static_cast<uint32_t>(w->broad.getOverlappingPairCache()->getNumOverlappingPairs());
  found->near = found->queried = 0;
  found->manifolds = static_cast<uint32_t>(w->dispatcher.getNumManifolds());
  for (int i = 0; i < w->dispatcher.getNumManifolds(); i++) {
    found->near += w->dispatcher.getManifoldByIndexInternal(i)->getNumContacts() > 0;
  }
  return true;
}

btCollisionShape *shape_of(World *w, unsigned shape) {
  const rest_stage *s = w->stage;
  if (shape != 0 || s->mesh == nullptr) {
    return new btBoxShape(btVector3(s->half[shape][0], s->half[shape][1], s->half[shape][2]));
  }
  const gjk_mesh *m = static_cast<const gjk_mesh *>(s->mesh);
  for (uint32_t i = 0; i < m->triangle_count; i++) {
    btVector3 corner[3];
    for (int k = 0; k < 3; k++) {
      corner[k] = to_vector(m->vertices[GJK_MESH_NUMBER(m->triangles[i].corner[k])]);
    }
    w->triangles.addTriangle(corner[0], corner[1], corner[2]);
  }
  return new btBvhTriangleMeshShape(&w->triangles, true);
}

void *start(const rest_stage *stage) {
  World *w = new World;
  w->stage = stage;
  for (unsigned i = 0; i < REST_SHAPES; i++) {
    w->shapes.emplace_back(stage->half[i][0] > 0 ? shape_of(w, i) : nullptr);
  }
  w->world.setForceUpdateAllAabbs(false);
  for (unsigned i = 0; i < stage->bodies; i++) {
    w->objects.emplace_back(new btCollisionObject);
    btCollisionObject *o = w->objects.back().get();
    o->setCollisionShape(w->shapes[stage->body[i].shape].get());
    o->setWorldTransform(to_transform(pose_of(w, 0, i)));
    if (stage->body[i].fixed) {
      o->setCollisionFlags(o->getCollisionFlags() | btCollisionObject::CF_STATIC_OBJECT);
      w->world.addCollisionObject(o, btBroadphaseProxy::StaticFilter,
                                  btBroadphaseProxy::AllFilter ^ btBroadphaseProxy::StaticFilter);
    } else {
      w->world.addCollisionObject(o);
    }
  }
  return w;
}

void stop(void *world) {
  World *w = static_cast<World *>(world);
  for (auto &object : w->objects) {
    w->world.removeCollisionObject(object.get());
  }
  delete w;
}

}  // namespace

extern "C" const rest_method rest_bullet = {.name = "Bullet", .plane = false, .start = start, .go = go, .stop = stop};
