// Meshes and height fields whose arrays are as long as they say, of any content: what gjk_mesh_build and gjk_mesh_check make
// of them, and each function of their classes. Regions that stand, or move on a way.
#include "gjk/mesh.h"

#include "any.h"
#include "gjk/height_field.h"
#include "src/mesh/gjk_mesh_tree.h"

// Values of CASE.
#define BUILD 1
#define CHECK 2
#define WALK 3
#define FIELD 4

#define VERTICES 3
#if CASE == WALK
#define TRIANGLES (GJK_MESH_LEAF + 1)
#else
#define TRIANGLES 2
#endif
#define NODES GJK_MESH_NODES(TRIANGLES)
#define SIDE 3

static gjk_vec3 vertices[VERTICES];
static gjk_mesh_triangle triangles[TRIANGLES];
static gjk_mesh_node nodes[NODES];
static int16_t heights[SIDE * SIDE];

// Contacts with triangles need pairs: surface.c is their driver.
gjk_status gjk_surface_meet(const gjk_parts_frame *frame, uint32_t number, const gjk_collider *b, gjk_q16 margin,
                            unsigned most, gjk_cache *cache, const gjk_workspace *workspace, gjk_manifold *out) {
  return GJK_ERROR_NULL;
}

bool gjk_surface_settle(const gjk_parts_frame *frame, uint32_t number, const gjk_collider *b, gjk_manifold *m) {
  return false;
}

static void any_arrays(void) {
  for (int i = 0; i < VERTICES; i++) {
    vertices[i] = any_position();
  }
  for (int i = 0; i < TRIANGLES; i++) {
    for (int k = 0; k < 3; k++) {
      triangles[i].corner[k] = (uint32_t)any_int32();
    }
  }
  for (int i = 0; i < NODES; i++) {
    for (int k = 0; k < 3; k++) {
      nodes[i].lower[k] = any_uint16();
      nodes[i].upper[k] = any_uint16();
    }
  }
}

static gjk_mesh any_mesh(void) {
  gjk_mesh m;
  any_arrays();
  m.vertices = any_bool() ? vertices : NULL;
  m.triangles = any_bool() ? triangles : NULL;
  m.nodes = any_bool() ? nodes : NULL;
  m.vertex_count = (uint32_t)any_between(0, VERTICES);
  m.triangle_count = (uint32_t)any_between(0, TRIANGLES);
  m.lower = any_position();
  m.upper = any_position();
  for (int i = 0; i < 3; i++) {
    m.shift[i] = (uint8_t)any_between(0, UINT8_MAX);
  }
  m.two_sided = any_bool();
  return m;
}

// As gjk_parts_frame_set leaves it: its reach is what the class says.
static void use_class(const gjk_parts_class *type, const void *data, uint32_t parts) {
  gjk_parts_frame frame;
  gjk_region region;
  gjk_parts_walk walk;
  gjk_parts_room room;
  gjk_parts_local local;
  gjk_collider c;
  uint32_t number;
  const gjk_aabb box = {any_position(), any_position()};
  const gjk_long3 way = {Frama_C_long_long_interval(-INT64_C(0xFFFFFFFF), INT64_C(0xFFFFFFFF)),
                         Frama_C_long_long_interval(-INT64_C(0xFFFFFFFF), INT64_C(0xFFFFFFFF)),
                         Frama_C_long_long_interval(-INT64_C(0xFFFFFFFF), INT64_C(0xFFFFFFFF))};
  const gjk_parts body = {type, data, any_pose()};
  const uint32_t count = type->count(data);
  if (count == 0) {
    return;
  }
  //@ assert count <= parts;
  (void)type->reach(data);
  frame.parts = &body;
  frame.is_level = any_bool();
  for (int i = 0; i < 3; i++) {
    frame.rows[i] = any_vec3(GJK_Q30_ONE);
  }
  gjk_region_start(&region, frame.rows, &body.pose.position, &box, any_bool() ? &way : NULL);
  //@ split region.moves;
  gjk_parts_walk_start(&walk);
  const uint32_t guess = type->guess(data, &region);
  //@ assert guess < count;
  (void)type->place(&frame, guess, &room, &c);
  while (type->next(data, &region, &walk, &number)) {
    //@ assert number < count;
    (void)type->place(&frame, number, &room, &c);
    (void)type->local(data, number, &room, &local);
    (void)type->edges(data, number);
  }
}

int main(void) {
#if CASE == BUILD
  gjk_mesh m;
  any_arrays();
  (void)gjk_mesh_build(any_bool() ? vertices : NULL, (uint32_t)any_between(0, VERTICES), any_bool() ? triangles : NULL,
                       (uint32_t)any_between(0, TRIANGLES), any_bool(), any_bool() ? nodes : NULL,
                       (uint32_t)any_between(0, NODES), any_bool() ? &m : NULL);
#elif CASE == CHECK
  const gjk_mesh m = any_mesh();
  gjk_mesh_report report;
  (void)gjk_mesh_check(any_bool() ? &m : NULL, any_bool() ? &report : NULL);
#elif CASE == WALK
  const gjk_mesh m = any_mesh();
  use_class(&gjk_parts_class_mesh, &m, TRIANGLES);
#else
  for (int i = 0; i < SIDE * SIDE; i++) {
    heights[i] = (int16_t)any_between(INT16_MIN, INT16_MAX);
  }
  const gjk_height_field field = {any_bool() ? heights : NULL,
                                  (uint16_t)any_between(0, SIDE),
                                  (uint16_t)any_between(0, SIDE),
                                  any_int32(),
                                  any_int32(),
                                  any_int32()};
  (void)gjk_height_field_check(any_bool() ? &field : NULL);
  use_class(&gjk_parts_class_height_field, &field, 2 * (SIDE - 1) * (SIDE - 1));
#endif
  return 0;
}
