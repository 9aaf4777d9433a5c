// FCL's dynamic trees of boxes, in double, settings as it sets them: one of the bodies, one of those that are static.
//
// A tick: update of the bodies that changed (whose boxes are ready made), then collide of the bodies with each other and
// with the static ones, whose callback counts the pairs. Nothing is kept of the pairs from tick to tick.
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/shape/box.h>

#include <memory>
#include <vector>

#include "../method.h"

namespace {

using Object = fcl::CollisionObjectd;
using Tree = fcl::DynamicAABBTreeCollisionManagerd;

struct Body {
  std::shared_ptr<fcl::Boxd> geometry;
  std::unique_ptr<Object> object;
  bool fixed;
};

struct World {
  std::vector<Body> bodies;
  Tree trees[2];  // moving, static
  std::vector<Object *> changed[2];
  uint32_t pairs;
};

fcl::Vector3d to_vector(const float v[3]) {
  return fcl::Vector3d(v[0], v[1], v[2]);
}

// The box of a geometry at the identity is that of the object.
void set_box(Body *body, const scene_box &box) {
  body->geometry->aabb_local = fcl::AABBd(to_vector(box.lower), to_vector(box.upper));
  body->object->computeAABB();
}

void make(World *w, const scene_box &box) {
  Body &body = w->bodies[box.body];
  body.geometry = std::make_shared<fcl::Boxd>(1, 1, 1);
  body.object = std::make_unique<Object>(body.geometry);
  body.object->setUserData(&body);
  body.fixed = box.fixed;
  set_box(&body, box);
}

bool count_pair(Object *, Object *, void *world) {
  static_cast<World *>(world)->pairs++;
  return false;
}

template <typename User>
void find_pairs(World *w, User *user, fcl::CollisionCallBack<double> callback) {
  w->trees[0].collide(user, callback);
  w->trees[0].collide(&w->trees[1], user, callback);
}

bool tick(void *world, const scene_tick *changes) {
  World *w = static_cast<World *>(world);
  w->changed[0].clear();
  w->changed[1].clear();
  for (uint32_t i = 0; i < changes->count; i++) {
    const scene_box &box = changes->boxes[i];
    Body &body = w->bodies[box.body];
    if (box.anew) {
      w->trees[body.fixed].unregisterObject(body.object.get());
      make(w, box);
      w->trees[body.fixed].registerObject(body.object.get());
    } else {
      set_box(&body, box);
      w->changed[body.fixed].push_back(body.object.get());
    }
  }
  for (int i = 0; i < 2; i++) {
    w->trees[i].update(w->changed[i]);
  }
  w->pairs = 0;
  find_pairs(w, w, count_pair);
  return true;
}

void *start(const scene_tick *all) {
  World *w = new World;
  std::vector<Object *> objects[2];
  w->bodies.resize(all->count);
  for (uint32_t i = 0; i < all->count; i++) {
    make(w, all->boxes[i]);
    objects[all->boxes[i].fixed].push_back(w->bodies[i].object.get());
  }
  for (int i = 0; i < 2; i++) {
    w->trees[i].registerObjects(objects[i]);
    w->trees[i].setup();
  }
  return w;
}

struct Counting {
  const World *world;
  scene_meet *meet;
  const void *user;
  uint32_t held, meeting;
};

bool count_exact(Object *a, Object *b, void *user) {
  Counting *c = static_cast<Counting *>(user);
  const Body *first = c->world->bodies.data();
  c->held++;
  c->meeting += c->meet(c->user, static_cast<uint32_t>(static_cast<Body *>(a->getUserData()) - first),
                        static_cast<uint32_t>(static_cast<Body *>(b->getUserData()) - first));
  return false;
}

void count(void *world, scene_meet *meet, const void *user, uint32_t *held, uint32_t *meeting) {
  World *w = static_cast<World *>(world);
  Counting c = {w, meet, user, 0, 0};
  find_pairs(w, &c, count_exact);
  *held = c.held;
  *meeting = c.meeting;
}

void stop(void *world) {
  delete static_cast<World *>(world);
}

}  // namespace

extern "C" const scene_method scene_fcl = {
    .name = "FCL DynamicAABBTree", .start = start, .tick = tick, .count = count, .stop = stop};
