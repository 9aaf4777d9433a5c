// Contacts with surfaces of any triangles, seen by any collider: gjk_surface_contacts and gjk_surface_settle, with any
// margin, numbers, room for answers, null pointers.
#include "gjk/surface.h"

#define ANY_WALK 1
#include "parts_any.h"
#include "src/mesh/gjk_triangle.h"

// Values of CASE.
#define CONTACTS 1
#define SETTLE 2

// Coordinates of checked data; how far apart corners of one triangle are along an axis: gjk_mesh_check.
#define EXTENT GJK_MESH_COORDINATE_MAX

// A walk has found the triangle, so it is there.
static gjk_status any_triangle(const void *data, uint32_t number, gjk_parts_room *room, gjk_parts_local *out) {
  (void)data, (void)number, (void)out;
  for (int i = 0; i < 3; i++) {
    room->vertices[i] = any_vec3(EXTENT);
  }
  return GJK_OK;
}

static void check_manifold(const gjk_manifold *m) {
  //@ assert m->count >= 1 && m->count <= GJK_CONTACTS_MAX;
  check_unit(&m->normal);
  check_size(m->feature_a, UINT16_MAX);
  check_size(m->feature_b, UINT16_MAX);
  check_point(&m->contact[0].point_a);
  check_point(&m->contact[0].point_b);
  check_size(m->contact[0].distance, INT64_C(1) << 31);
}

#if CASE == CONTACTS
#define ROOM 1  // for manifolds
static void ask(const gjk_parts *a, const gjk_collider *b, uint16_t capacity) {
  gjk_surface_contact room[ROOM];
  uint16_t count;
  const int status =
      gjk_surface_contacts(any_bool() ? a : NULL, any_bool() ? b : NULL, any_int32(), (unsigned)any_between(0, 9), NULL,
                           any_bool() ? room : NULL, capacity, any_bool() ? &count : NULL);
  //@ split status;
  if (status == GJK_OK) {
    //@ assert count <= capacity;
    if (count > 0) {
      check_size(room[0].triangle, UINT32_MAX);
      check_manifold(&room[0].manifold);
    }
  }
}
#else
#define ROOM 0

// As gjk_contacts leaves it.
static void ask(const gjk_parts *a, const gjk_collider *b, uint16_t capacity) {
  gjk_parts_frame frame;
  gjk_manifold m;
  (void)capacity;
  frame.parts = a;
  frame.is_level = any_bool();
  for (int i = 0; i < 3; i++) {
    frame.rows[i] = any_vec3(GJK_Q30_ONE);
  }
  m.normal.x = any_between(-ANY_UNIT, ANY_UNIT);
  m.normal.y = any_between(-ANY_UNIT, ANY_UNIT);
  m.normal.z = any_between(-ANY_UNIT, ANY_UNIT);
  m.count = (uint8_t)any_between(0, GJK_CONTACTS_MAX);
  m.feature_a = any_uint16();
  m.feature_b = any_uint16();
  for (int i = 0; i < GJK_CONTACTS_MAX; i++) {
    m.contact[i].point_a = any_position();
    m.contact[i].point_b = any_position();
    m.contact[i].distance = any_int32();
    m.contact[i].id = any_uint16();
  }
  if (b->state == GJK_STATE_POSED) {
    const int32_t some = gjk_surface_settle(&frame, 0, b, &m);
    //@ split some;
    if (some != 0) {
      check_manifold(&m);
    }
  }
}
#endif

static gjk_shape_class kind_of(const gjk_shape_class *of, gjk_kind kind) {
  gjk_shape_class type = *of;
  type.kind = (uint8_t)kind;
  return type;
}

int main(void) {
  static const int data;
  gjk_shape shape;
  gjk_collider b;
  gjk_parts_class type = any_class;
  const gjk_shape_class box = kind_of(&polytope, GJK_KIND_AXES), hull = kind_of(&polytope, GJK_KIND_VERTICES);
  const gjk_parts a = {&type, any_bool() ? &data : NULL, any_pose()};
  const int32_t kind = any_between(0, 2);
  type.local = any_triangle;
  type.edges = any_edges;
  //@ split kind;
  any_bound_collider(&b, &shape, kind == 0 ? &box : kind == 1 ? &hull : &curved);
  b.count = (uint16_t)any_between(0, 3);  // half axes
  for (int32_t capacity = 0; capacity <= ROOM; capacity++) {
    ask(&a, &b, (uint16_t)capacity);
  }
  return 0;
}
