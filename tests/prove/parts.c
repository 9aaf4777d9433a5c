// Every query of bodies of many parts, on two bodies of a model class: any parts, numbers and places; any collider,
// distance, path, motion, room for answers, null pointers. What is answered is set.
#include "gjk/draw.h"
#include "parts_any.h"

// Values of CASE.
#define NEAR 1
#define DISTANCE 2
#define DEPTH 3
#define CONTACTS 4
#define MANIFOLDS 5
#define CAST 6
#define RAY 7
#define IMPACT 8
#define CAST_AHEAD 9
#define IMPACT_AHEAD 10
#define DRAW 11
#define BOTH_NEAR 12
#define BOTH_DISTANCE 13
#define BOTH_DEPTH 14
#define BOTH_CONTACTS 15
#define BOTH_MANIFOLDS 16
#define BOTH_CAST 17
#define BOTH_IMPACT 18

// Of pairs_model.c.
extern int32_t pairs_results_set;

// What a call takes.
typedef struct parts_arguments {
  const gjk_parts *a, *b;
  const gjk_collider *c;
  uint32_t *part;
  gjk_parts_pair *pair;
} parts_arguments;

#if CASE == CONTACTS || CASE == BOTH_CONTACTS || CASE == MANIFOLDS || CASE == BOTH_MANIFOLDS || CASE == DEPTH || \
    CASE == BOTH_DEPTH
static const gjk_workspace *any_workspace(void) {
  static gjk_epa_cell cells[1];
  static gjk_workspace workspace;
  workspace.cells = cells;
  workspace.count = 1;
  return any_bool() ? &workspace : NULL;
}
#endif

#if CASE == MANIFOLDS || CASE == CONTACTS || CASE == BOTH_MANIFOLDS || CASE == BOTH_CONTACTS
#define HAS_ROOM
#define ROOM 2
static void check_manifold(const gjk_manifold *m) {
  //@ assert m->count >= 1 && m->count <= GJK_CONTACTS_MAX;
  check_unit(&m->normal);
  check_size(m->feature_a, UINT16_MAX);
  check_size(m->feature_b, UINT16_MAX);
  check_point(&m->contact[0].point_a);
  check_point(&m->contact[0].point_b);
  check_size(m->contact[0].distance, INT64_C(1) << 31);
  check_size(m->contact[0].id, UINT16_MAX);
}
#endif

#if CASE == NEAR || CASE == BOTH_NEAR
static void ask(const parts_arguments *of) {
  gjk_decision r;
#if CASE == NEAR
  const int status = any_bool() ? gjk_parts_within(of->a, of->c, any_int32(), of->part, any_bool() ? &r : NULL)
                                : gjk_parts_intersect(of->a, of->c, of->part, &r);
#else
  const int status = gjk_parts_both_within(of->a, of->b, any_int32(), of->pair, any_bool() ? &r : NULL);
#endif
  //@ split status;
  if (status == GJK_OK) {
    check_size(r.yes, 1);
    check_size(r.iterations, UINT8_MAX);
    check_size(r.certificate.proof, UINT8_MAX);
    check_size(r.certificate.count, UINT8_MAX);
  }
}
#elif CASE == DISTANCE || CASE == BOTH_DISTANCE
static void ask(const parts_arguments *of) {
  gjk_distance_result r;
#if CASE == DISTANCE
  const int status = gjk_parts_distance(of->a, of->c, of->part, any_bool() ? &r : NULL);
#else
  const int status = gjk_parts_both_distance(of->a, of->b, of->pair, any_bool() ? &r : NULL);
#endif
  //@ split status;
  if (status == GJK_OK || status == GJK_ERROR_ITERATION_LIMIT) {
    check_size(r.intersecting, 1);
    check_size(r.distance, INT64_C(1) << 31);
    check_size(r.lower, INT64_C(1) << 31);
    check_size(r.upper, INT64_C(1) << 31);
    check_size(r.certificate.proof, UINT8_MAX);
  }
}
#elif CASE == DEPTH || CASE == BOTH_DEPTH
static void ask(const parts_arguments *of) {
  gjk_penetration_result r;
#if CASE == DEPTH
  const int status = gjk_parts_penetration(of->a, of->c, any_workspace(), of->part, any_bool() ? &r : NULL);
#else
  const int status = gjk_parts_both_penetration(of->a, of->b, any_workspace(), of->pair, any_bool() ? &r : NULL);
#endif
  //@ split status;
  if (status == GJK_OK || status == GJK_ERROR_CAPACITY) {
    //@ split r.intersecting;
    if (r.intersecting) {
      check_size(r.depth, INT64_C(1) << 31);
      check_size(r.lower, INT64_C(1) << 31);
      check_unit(&r.normal);
    }
    check_size(r.iterations, UINT8_MAX);
    check_size(r.certificate.proof, UINT8_MAX);
  }
}
#elif CASE == CONTACTS || CASE == BOTH_CONTACTS
static void ask(const parts_arguments *of, uint32_t capacity) {
  gjk_parts_manifold room[ROOM];
  uint32_t count;
  gjk_parts_manifold *out = any_bool() ? room : NULL;
#if CASE == CONTACTS
  const int status = gjk_parts_contacts(of->a, of->c, any_int32(), (unsigned)any_between(0, 9), any_workspace(), out,
                                        capacity, any_bool() ? &count : NULL);
#else
  const int status = gjk_parts_both_contacts(of->a, of->b, any_int32(), (unsigned)any_between(0, 9), any_workspace(),
                                             out, capacity, any_bool() ? &count : NULL);
#endif
  //@ split status;
  if (status == GJK_OK || status == GJK_ERROR_CAPACITY || status == GJK_ERROR_ITERATION_LIMIT) {
    check_size(count, UINT32_MAX);
    if (count > 0 && capacity > 0) {
      check_manifold(&room[0].manifold);
      check_size(room[0].part, UINT32_MAX);
      check_size(room[0].part_of_b, UINT32_MAX);
    }
  }
}
#elif CASE == MANIFOLDS || CASE == BOTH_MANIFOLDS
static void ask(const parts_arguments *of, uint32_t room_for) {
  gjk_manifold room[ROOM];
  unsigned count;
  const unsigned capacity = (unsigned)room_for;
#if CASE == MANIFOLDS
  const int status = gjk_parts_manifolds(of->a, of->c, any_int32(), (unsigned)any_between(0, 9), any_workspace(),
                                         any_bool() ? room : NULL, capacity, any_bool() ? &count : NULL);
#else
  const int status = gjk_parts_both_manifolds(of->a, of->b, any_int32(), (unsigned)any_between(0, 9), any_workspace(),
                                              any_bool() ? room : NULL, capacity, any_bool() ? &count : NULL);
#endif
  //@ split status;
  if (status == GJK_OK || status == GJK_ERROR_CAPACITY || status == GJK_ERROR_ITERATION_LIMIT) {
    //@ assert count <= capacity;
    if (count > 0) {
      check_manifold(&room[0]);
    }
  }
}
#elif CASE == CAST || CASE == RAY || CASE == BOTH_CAST || CASE == CAST_AHEAD
static void ask(const parts_arguments *of) {
  gjk_cast_result r;
  const gjk_vec3 to_a = any_position(), to_b = any_position();
  const gjk_cast_path path = {any_bool() ? &to_a : NULL, any_bool() ? &to_b : NULL, any_int32()};
  const gjk_cast_path *way = any_bool() ? &path : NULL;
  gjk_cast_result *out = any_bool() ? &r : NULL;
#if CASE == CAST
  const int status = gjk_parts_cast(of->a, of->c, way, of->part, out);
#elif CASE == RAY
  const int status = gjk_parts_cast_ray(of->a, any_bool() ? &to_a : NULL, any_bool() ? &to_b : NULL, of->part, out);
#elif CASE == CAST_AHEAD
  const int status = gjk_parts_cast_ahead(of->a, of->c, way, of->part, out);
#else
  const int status = gjk_parts_both_cast(of->a, of->b, way, of->pair, out);
#endif
  //@ split status;
  if (status == GJK_OK || status == GJK_ERROR_ITERATION_LIMIT) {
    //@ split r.hit;
    check_size(r.hit, 1);
    check_size(r.iterations, UINT8_MAX);
    if (r.hit) {
      //@ assert r.fraction >= 0 && r.fraction <= GJK_Q30_ONE;
      check_size(r.inside, 1);
      check_point(&r.rest_a);
      check_point(&r.rest_b);
      check_unit(&r.normal);
    }
  }
}
#elif CASE == IMPACT || CASE == IMPACT_AHEAD || CASE == BOTH_IMPACT
static void ask(const parts_arguments *of) {
  gjk_impact_result r;
  const gjk_motion motion_a = {any_pose(), any_pose(), any_position()},
                   motion_b = {any_pose(), any_pose(), any_position()};
  const gjk_impact_setup setup = {any_int32(), any_int32(), (uint8_t)any_between(0, UINT8_MAX)};
  const gjk_motion *a = any_bool() ? &motion_a : NULL, *b = any_bool() ? &motion_b : NULL;
#if CASE == IMPACT
  const int status =
      gjk_parts_time_of_impact(of->a, a, of->c, b, any_bool() ? &setup : NULL, of->part, any_bool() ? &r : NULL);
#elif CASE == IMPACT_AHEAD
  const int status =
      gjk_parts_impact_ahead(of->a, a, of->c, b, any_bool() ? &setup : NULL, of->part, any_bool() ? &r : NULL);
#else
  const int status =
      gjk_parts_both_time_of_impact(of->a, a, of->b, b, any_bool() ? &setup : NULL, of->pair, any_bool() ? &r : NULL);
#endif
  //@ split status;
  if (status == GJK_OK || status == GJK_ERROR_ITERATION_LIMIT) {
    check_size(r.hit, 1);
    check_size(r.overlap, 1);
    //@ assert r.lower >= 0 && r.lower <= GJK_Q30_ONE;
    //@ assert r.upper >= 0 && r.upper <= GJK_Q30_ONE;
    check_point(&r.pose_a.position);
    check_point(&r.pose_b.position);
    check_size(r.iterations, UINT8_MAX);
  }
}
#else
static void ask(const parts_arguments *of) {
  static const gjk_draw draw;
  const gjk_aabb box = any_box();
  uint32_t drawn;
  gjk_parts_room room;
  gjk_collider c;
  (void)gjk_draw_parts(any_bool() ? &draw : NULL, of->a, any_bool() ? &box : NULL, any_uint32(), GJK_DRAW_STATIC,
                       any_bool() ? &drawn : NULL);
  (void)gjk_parts_place(of->a, any_uint32(), any_bool() ? &room : NULL, any_bool() ? &c : NULL);
}
#endif

static void any_body(gjk_parts *body, const gjk_parts_class *type) {
  static const int data;
  body->type = any_bool() ? type : NULL;
  body->data = any_bool() ? &data : NULL;
  body->pose = any_pose();
}

int main(void) {
  gjk_shape shape;
  gjk_parts a, b;
  gjk_collider c;
  uint32_t part;
  gjk_parts_pair pair;
  gjk_parts_class surface = any_class, few = any_class;
  surface.edges = any_edges;
  few.count = any_few;
  any_body(&a, CASE != CAST_AHEAD && CASE != IMPACT_AHEAD ? &any_class : any_bool() ? &any_class : &surface);
  any_body(&b, &few);
  any_bound_collider(&c, &shape, any_bool() ? &polytope : &curved);
  const parts_arguments of = {any_bool() ? &a : NULL, any_bool() ? &b : NULL, any_bool() ? &c : NULL,
                              any_bool() ? &part : NULL, any_bool() ? &pair : NULL};
#ifdef HAS_ROOM
  for (int32_t capacity = 0; capacity <= ROOM; capacity++) {
    pairs_results_set = 0;
    ask(&of, (uint32_t)capacity);
  }
#else
  ask(&of);
#endif
  return 0;
}
