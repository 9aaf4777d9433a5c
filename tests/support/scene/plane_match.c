// A small lockstep game in the plane.
#include "plane_match.h"

#include "plane_names.h"

#define match plane_match
#define match_body plane_match_body
#define match_input plane_match_input
#define match_scene plane_match_scene
#define match_start plane_match_start
#define match_tick plane_match_tick
#define match_hash plane_match_hash

static const gjk2_vec corners[6] = {{30000, 2000},   {9000, 29000},   {-25000, 20000},
                                    {-28000, -9000}, {-3000, -30000}, {19000, -18000}};
static const gjk2_vec sail[3] = {{-40000, -9000}, {41000, 0}, {3000, 52000}};
static const gjk2_shape crate = GJK2_BOX(GJK_Q16(0.5), GJK_Q16(0.5)), ball = GJK2_CIRCLE(GJK_Q16(0.5));
static const gjk2_shape capsule = GJK2_CAPSULE(GJK_Q16(0.25), GJK_Q16(0.4)), stone = GJK2_POLYGON(corners, 6);
static const gjk2_shape egg = GJK2_ELLIPSE(GJK_Q16(0.5), GJK_Q16(0.375)), flag = GJK2_TRIANGLE(sail);
static const gjk2_shape wall = GJK2_BOX(GJK_Q16(6.0), GJK_Q16(0.25));
static const gjk2_shape *const shapes[] = {&crate, &ball, &capsule, &stone, &egg, &flag, &wall};

#define SHAPES 7
#define WALL 6
#define REACH GJK_Q16(4)

// All matches use this memory in turn; nothing stays in it.
static gjk2_manifold manifold;

static const gjk2_scene_bindings bindings = {.details = &gjk2_scene_contacts, .manifolds = &manifold};

static const gjk2_scene_config config = {
    MATCH_BODIES, 2 * MATCH_BODIES, MATCH_BODIES, MATCH_PAIRS, GJK_Q16(0.1), GJK_DETAIL_TOUCH, 1, 0, 0, 0};

#define AXES 2

static gjk_q16 *along(gjk2_vec *v, uint32_t axis) {
  return axis == 0 ? &v->x : &v->y;
}

#include "match_rules.h"

static gjk2_rotation turn_of(uint32_t slot, uint32_t tick) {
  const gjk2_rotation turn = {30000, dice(slot, tick, 4, 500)};
  return turn;
}

static int32_t sum_of(const gjk2_manifold *m) {
  int32_t sum = m->normal.x % 5 + m->normal.y % 7 + m->feature_a + m->feature_b;
  for (int i = 0; i < m->count; i++) {
    const gjk2_contact *c = &m->contact[i];
    sum += c->point_a.x % 5 + c->point_a.y % 7 + c->point_b.x % 11 + c->distance % 13 + c->id;
  }
  return sum;
}
