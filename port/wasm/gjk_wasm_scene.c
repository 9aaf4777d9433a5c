// Scenes for JavaScript, each with its block, its shapes and room for one report's contacts.
#include "gjk/scene.h"

#include "../gjk_allocate.h"
#include "gjk/probe.h"
#include "gjk_wasm_shape.h"

struct gjk_wasm_scene {
  gjk_scene scene;
  gjk_manifold manifold;
  uint32_t bytes;             // of the block
  const gjk_shape *shapes[];  // scene.shape_count of them
};

static gjk_pose pose_of(const int32_t *n) {
  const gjk_pose pose = {{n[0], n[1], n[2]}, {n[3], n[4], n[5], n[6]}};
  return pose;
}

// The block of the shape that a scene has under a number.
static gjk_wasm_shape *holder_of(const gjk_shape *shape) {
  return (gjk_wasm_shape *)((unsigned char *)(uintptr_t)shape - offsetof(gjk_wasm_shape, shape));
}

static gjk_scene_bindings bindings_of(gjk_wasm_scene *scene) {
  const gjk_scene_bindings bindings = {.details = &gjk_scene_contacts,
                                       .workspace = &gjk_wasm_workspace,
                                       .manifolds = &scene->manifold,
                                       .motion = &gjk_scene_motion};
  return bindings;
}

gjk_wasm_scene *gjk_wasm_scene_make(gjk_collider *const *shapes, unsigned count, const int32_t *config) {
  const uint32_t cells = (uint32_t)config[9];
  const gjk_scene_config of = {.bodies = (uint32_t)config[0],
                               .parts = (uint32_t)config[1],
                               .own_poses = (uint32_t)config[2],
                               .pairs = (uint32_t)config[3],
                               .box_margin = config[4],
                               .detail = (uint8_t)config[5],
                               .persist = (uint8_t)config[6],
                               .retest_all = (uint8_t)config[7],
                               .workspace_cells = cells < gjk_wasm_workspace.count ? cells : gjk_wasm_workspace.count,
                               .motions = (uint32_t)config[10]};
  const size_t bytes = gjk_scene_bytes(&of);
  if (count > UINT16_MAX || bytes == 0) {
    return gjk_wasm_fails(GJK_ERROR_RANGE);
  }
  gjk_wasm_scene *made = gjk_port_allocate(sizeof *made + count * sizeof made->shapes[0]);
  void *block = gjk_port_allocate(bytes);
  gjk_status status = made != NULL && block != NULL ? GJK_OK : GJK_ERROR_CAPACITY;
  if (status == GJK_OK) {
    const gjk_scene_bindings bindings = bindings_of(made);
    made->bytes = (uint32_t)bytes;
    for (unsigned i = 0; i < count; i++) {
      made->shapes[i] = shapes[i]->shape;
    }
    status = gjk_scene_init(&made->scene, &of, block, bytes, made->shapes, (uint16_t)count, &bindings);
  }
  if (status != GJK_OK) {
    gjk_port_release(block);
    gjk_port_release(made);
    return gjk_wasm_fails(status);
  }
  for (unsigned i = 0; i < count; i++) {
    holder_of(made->shapes[i])->users++;
  }
  return made;
}

void gjk_wasm_scene_release(gjk_wasm_scene *scene) {
  for (unsigned i = 0; i < scene->scene.shape_count; i++) {
    gjk_wasm_release(&holder_of(scene->shapes[i])->collider);
  }
  gjk_port_release(scene->scene.block);
  gjk_port_release(scene);
}

int gjk_wasm_scene_add(gjk_wasm_scene *scene, int slot, const int32_t *setup, const int32_t *parts, unsigned count) {
  if (count > UINT16_MAX) {
    return GJK_ERROR_CAPACITY;
  }
  gjk_part *room = gjk_port_allocate((count + 1) * sizeof *room);  // not NULL for no parts: they are EMPTY
  if (room == NULL) {
    return GJK_ERROR_CAPACITY;
  }
  for (unsigned i = 0; i < count; i++, parts += 9) {
    const gjk_part part = {(uint16_t)parts[0], parts[1] != 0, pose_of(parts + 2)};
    room[i] = part;
  }
  const gjk_body_setup body = {.pose = pose_of(setup),
                               .parts = room,
                               .part_count = (uint16_t)count,
                               .kind = (uint8_t)setup[7],
                               .detail = (uint8_t)setup[8],
                               .category = (uint32_t)setup[9],
                               .mask = (uint32_t)setup[10],
                               .user = (uint32_t)setup[11],
                               .margin = setup[12]};
  gjk_body_id id;
  const gjk_status status =
      slot < 0 ? gjk_scene_add(&scene->scene, &body, &id) : gjk_scene_add_at(&scene->scene, (uint32_t)slot, &body, &id);
  gjk_port_release(room);
  if (status == GJK_OK) {
    gjk_wasm_begin();
    gjk_wasm_put((int32_t)id.slot);
    gjk_wasm_put((int32_t)id.generation);
  }
  return status;
}

int gjk_wasm_scene_move(gjk_wasm_scene *scene, uint32_t slot, uint32_t generation, const int32_t *pose, bool teleport) {
  const gjk_body_id id = {slot, generation};
  const gjk_pose to = pose_of(pose);
  return teleport ? gjk_scene_teleport(&scene->scene, id, &to) : gjk_scene_move(&scene->scene, id, &to);
}

int gjk_wasm_scene_change(gjk_wasm_scene *scene, int change, uint32_t slot, uint32_t generation, uint32_t first,
                          uint32_t second) {
  const gjk_body_id id = {slot, generation};
  gjk_scene *s = &scene->scene;
  switch (change) {
    case GJK_WASM_REMOVE: return gjk_scene_remove(s, id);
    case GJK_WASM_SLEEP: return gjk_scene_sleep(s, id);
    case GJK_WASM_WAKE: return gjk_scene_wake(s, id);
    case GJK_WASM_SET_MOTION: return gjk_scene_set_motion(s, id, (uint8_t)first);
    case GJK_WASM_SET_SHAPE: return gjk_scene_set_shape(s, id, (uint16_t)first, (uint16_t)second);
    case GJK_WASM_SET_FILTER: return gjk_scene_set_filter(s, id, first, second);
    case GJK_WASM_SET_USER: return gjk_scene_set_user(s, id, first);
    default: return GJK_ERROR_RANGE;
  }
}

int gjk_wasm_scene_get(const gjk_wasm_scene *scene, uint32_t slot, uint32_t generation) {
  const gjk_body_id id = {slot, generation};
  gjk_body_state state;
  const gjk_status status = gjk_scene_get(&scene->scene, id, &state);
  if (status == GJK_OK) {
    const gjk_quat *q = &state.pose.rotation;
    gjk_wasm_begin();
    gjk_wasm_put_vector(state.pose.position.x, state.pose.position.y, state.pose.position.z);
    gjk_wasm_put_vector(q->x, q->y, q->z);
    gjk_wasm_put(q->w);
    gjk_wasm_put_vector((int32_t)state.category, (int32_t)state.mask, (int32_t)state.user);
    gjk_wasm_put_vector(state.margin, state.part_count, state.kind);
    gjk_wasm_put_vector(state.detail, state.asleep, state.motion);
  }
  return status;
}

static void put_report(const gjk_report *r) {
  const gjk_manifold none = {.count = 0};
  gjk_wasm_put((int32_t)r->a.slot);
  gjk_wasm_put((int32_t)r->a.generation);
  gjk_wasm_put((int32_t)r->b.slot);
  gjk_wasm_put((int32_t)r->b.generation);
  gjk_wasm_put_vector(r->part_a, r->part_b, r->event);
  gjk_wasm_put_vector(r->detail, r->distance, r->fraction);
  gjk_wasm_put_manifold(r->manifold != NULL ? r->manifold : &none);
}

int gjk_wasm_scene_update(gjk_wasm_scene *scene) {
  gjk_report report;
  gjk_progress progress;
  const gjk_status status = gjk_scene_update(&scene->scene, &report, 1, &progress);
  if (status == GJK_OK) {
    gjk_wasm_begin();
    gjk_wasm_put(progress.pairs_left != 0 || progress.reports_left != 0);
    gjk_wasm_put(progress.reports != 0);
    if (progress.reports != 0) {
      put_report(&report);
    }
  }
  return status;
}

int gjk_wasm_scene_cast_ray(const gjk_wasm_scene *scene, const int32_t *from, const int32_t *to,
                            const int32_t *filter) {
  const gjk_vec3 start = {from[0], from[1], from[2]}, end = {to[0], to[1], to[2]};
  const gjk_scene_filter seen = {.category = (uint32_t)filter[0],
                                 .mask = (uint32_t)filter[1],
                                 .ignore = {(uint32_t)filter[2], (uint32_t)filter[3]}};
  gjk_scene_hit hit = {{0, 0}, 0, 0, 0};
  gjk_cast_result result = {0};
  bool found = false;
  const gjk_status status = gjk_scene_cast_ray(&scene->scene, &start, &end, &seen, &hit, &result, &found);
  if (status == GJK_OK) {
    gjk_wasm_begin();
    gjk_wasm_put(found);
    gjk_wasm_put((int32_t)hit.body.slot);
    gjk_wasm_put((int32_t)hit.body.generation);
    gjk_wasm_put(hit.part);
    gjk_wasm_put((int32_t)hit.fraction);
    gjk_wasm_put_vector(result.point_a.x, result.point_a.y, result.point_a.z);
    gjk_wasm_put_vector(result.normal.x, result.normal.y, result.normal.z);
  }
  return status;
}

int gjk_wasm_scene_stats(const gjk_wasm_scene *scene) {
  gjk_scene_stats stats;
  const gjk_status status = gjk_scene_get_stats(&scene->scene, &stats);
  if (status == GJK_OK) {
    const uint32_t *field = &stats.bodies;  // all fields are uint32_t
    gjk_wasm_begin();
    for (unsigned i = 0; i < sizeof stats / sizeof *field; i++) {
      gjk_wasm_put((int32_t)field[i]);
    }
  }
  return status;
}

int gjk_wasm_scene_hash(const gjk_wasm_scene *scene) {
  uint64_t hash;
  const gjk_status status = gjk_scene_hash(&scene->scene, &hash);
  if (status == GJK_OK) {
    gjk_wasm_begin();
    gjk_wasm_put((int32_t)(uint32_t)hash);
    gjk_wasm_put((int32_t)(uint32_t)(hash >> 32));
  }
  return status;
}

int gjk_wasm_scene_save(gjk_wasm_scene *scene) {
  const gjk_status status = gjk_scene_seal(&scene->scene);
  if (status == GJK_OK) {
    gjk_wasm_begin();
    gjk_wasm_put((int32_t)(uintptr_t)scene->scene.block);
    gjk_wasm_put((int32_t)scene->bytes);
  }
  return status;
}

int gjk_wasm_scene_load(gjk_wasm_scene *scene, void *block, uint32_t bytes) {
  const gjk_scene_bindings bindings = bindings_of(scene);
  gjk_scene opened;
  if (bytes != scene->bytes) {
    return GJK_ERROR_CAPACITY;
  }
  const gjk_status status = gjk_scene_open(&opened, block, bytes, scene->shapes, scene->scene.shape_count, &bindings);
  if (status == GJK_OK) {
    gjk_port_release(scene->scene.block);
    scene->scene = opened;
  }
  return status;
}
