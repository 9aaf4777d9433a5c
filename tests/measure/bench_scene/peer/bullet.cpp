// Bullet's broad phase of dynamic trees with its hashed cache of pairs, in the precision that it was built for; its
// margins and settings as it sets them.
//
// A tick: setAabb of the bodies that changed (whose boxes are ready made), and calculateOverlappingPairs. The pairs stay
// in the cache from tick to tick; some of them no longer meet, as its clean-up goes through the cache bit by bit.
#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>

#include <vector>

#include "../method.h"

namespace {

struct World {
  btHashedOverlappingPairCache pairs;
  btDbvtBroadphase broad{&pairs};
  std::vector<btBroadphaseProxy *> proxies;
};

btVector3 to_vector(const float v[3]) {
  return btVector3(v[0], v[1], v[2]);
}

void add(World *w, const scene_box &box) {
  const int all = btBroadphaseProxy::AllFilter, still = btBroadphaseProxy::StaticFilter;
  w->proxies[box.body] = w->broad.createProxy(
      to_vector(box.lower), to_vector(box.upper), BOX_SHAPE_PROXYTYPE, &w->proxies[box.body],
      box.fixed ? still : static_cast<int>(btBroadphaseProxy::DefaultFilter), box.fixed ? all ^ still : all, nullptr);
}

bool tick(void *world, const scene_tick *changes) {
  World *w = static_cast<World *>(world);
  for (uint32_t i = 0; i < changes->count; i++) {
    const scene_box &box = changes->boxes[i];
    if (box.anew) {
      w->broad.destroyProxy(w->proxies[box.body], nullptr);
      add(w, box);
    } else {
      w->broad.setAabb(w->proxies[box.body], to_vector(box.lower), to_vector(box.upper), nullptr);
    }
  }
  w->broad.calculateOverlappingPairs(nullptr);
  return true;
}

void *start(const scene_tick *all) {
  World *w = new World;
  w->proxies.resize(all->count);
  for (uint32_t i = 0; i < all->count; i++) {
    add(w, all->boxes[i]);
  }
  w->broad.calculateOverlappingPairs(nullptr);
  return w;
}

uint32_t body_of(const World *w, const btBroadphaseProxy *proxy) {
  return static_cast<uint32_t>(static_cast<btBroadphaseProxy **>(proxy->m_clientObject) - w->proxies.data());
}

void count(void *world, scene_meet *meet, const void *user, uint32_t *held, uint32_t *meeting) {
  World *w = static_cast<World *>(world);
  const btBroadphasePairArray &pairs = w->pairs.getOverlappingPairArray();
  *held = static_cast<uint32_t>(pairs.size());
  *meeting = 0;
  for (int i = 0; i < pairs.size(); i++) {
    *meeting += meet(user, body_of(w, pairs[i].m_pProxy0), body_of(w, pairs[i].m_pProxy1));
  }
}

void stop(void *world) {
  World *w = static_cast<World *>(world);
  for (btBroadphaseProxy *proxy : w->proxies) {
    w->broad.destroyProxy(proxy, nullptr);
  }
  delete w;
}

}  // namespace

extern "C" const scene_method scene_bullet = {
    .name = "Bullet btDbvtBroadphase", .start = start, .tick = tick, .count = count, .stop = stop};
