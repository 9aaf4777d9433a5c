// A small lockstep game.
#include "match.h"

static const gjk_vec3 corners[8] = {{30000, 2000, 1000},   {-28000, 9000, -3000},  {5000, 31000, 2000},
                                    {-3000, -30000, 4000}, {1000, 2000, 33000},    {-2000, 900, -31000},
                                    {20000, 20000, 12000}, {-19000, -18000, -9000}};
static const gjk_shape crate = GJK_BOX(GJK_Q16(0.5), GJK_Q16(0.5), GJK_Q16(0.5)), ball = GJK_SPHERE(GJK_Q16(0.5));
static const gjk_shape capsule = GJK_CAPSULE(GJK_Q16(0.25), GJK_Q16(0.4)), stone = GJK_HULL(corners, 8);
static const gjk_shape drum = GJK_CYLINDER(GJK_Q16(0.5), GJK_Q16(0.375));
static const gjk_shape wall = GJK_BOX(GJK_Q16(6.0), GJK_Q16(6.0), GJK_Q16(0.25));
static const gjk_shape *const shapes[] = {&crate, &ball, &capsule, &stone, &drum, &wall};

#define SHAPES 6
#define WALL 5
#define REACH GJK_Q16(3)

// All matches use this memory in turn; nothing stays in it.
#define CELLS 400
static gjk_epa_cell cells[CELLS];
static const gjk_workspace workspace = {cells, CELLS};
static gjk_manifold manifold;

static const gjk_scene_bindings bindings = {
    .details = &gjk_scene_contacts, .workspace = &workspace, .manifolds = &manifold};

static const gjk_scene_config config = {
    MATCH_BODIES, 2 * MATCH_BODIES, MATCH_BODIES, MATCH_PAIRS, GJK_Q16(0.1), GJK_DETAIL_TOUCH, 1, 0, 0, CELLS, 0};

#define AXES 3

static gjk_q16 *along(gjk_vec3 *v, uint32_t axis) {
  return axis == 0 ? &v->x : axis == 1 ? &v->y : &v->z;
}

#include "match_rules.h"

static gjk_quat turn_of(uint32_t slot, uint32_t tick) {
  const gjk_quat turn = {dice(slot, tick, 4, 300), dice(slot, tick, 5, 300), dice(slot, tick, 6, 300), 30000};
  return turn;
}

static int32_t sum_of(const gjk_manifold *m) {
  int32_t sum = m->normal.x % 5 + m->normal.y % 7 + m->normal.z % 11 + m->feature_a + m->feature_b;
  for (int i = 0; i < m->count; i++) {
    const gjk_contact *c = &m->contact[i];
    sum += c->point_a.x % 5 + c->point_a.y % 7 + c->point_b.z % 11 + c->distance % 13 + c->id;
  }
  return sum;
}
