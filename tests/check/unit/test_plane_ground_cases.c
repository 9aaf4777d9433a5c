// Ground where the answer is known by hand: ends of ways, limits, ties, neighbours at a corner, and turning ground.
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "filled.h"
#include "gjk2/gjk2.h"
#include "gjk2/ground.h"
#include "placed2.h"
#include "random.h"
#include "src/ground/gjk2_ground_walk.h"
#include "src/plane/gjk2_line.h"
#include "whorl2.h"

#define SEED 33

#define ONE GJK_Q16_ONE

static gjk2_ground ground;
static gjk2_shape ground_shape;
static const gjk2_pose origin = GJK2_POSE_IDENTITY;
static const gjk2_shape disc = GJK2_CIRCLE(ONE), dot = GJK2_POINT;

static void make_chain(const gjk2_vec *vertices, uint16_t count) {
  static gjk2_polyline chain;
  chain.vertices = vertices;
  chain.count = count;
  chain.index = NULL;
  CHECK(gjk2_ground_of_chain(&chain, &ground, &ground_shape) == GJK_OK);
}

// Where the ground comes to rest that rises and goes aside below a ball.
static void check_rest(void) {
  static const gjk2_vec level[] = {{20 * ONE, 0}, {-20 * ONE, 0}};
  const gjk2_pose pose = {{100, 200}, {GJK_Q30_ONE, 0}};
  const gjk2_vec to = {100 + 3000, 200 + 8 * ONE};
  const gjk2_cast_path path = {&to, NULL, 0};
  const gjk2_collider ball = placed2(&disc, 0, 200 + 5 * ONE);
  gjk2_cast_result hit;
  uint32_t segment;
  make_chain(level, 2);
  CHECK(gjk2_ground_cast(&ground, &pose, &ball, &path, &hit, &segment) == GJK_OK && hit.hit);
  CHECK_MSG(abs(hit.rest_a.x - 1600) <= 1 && abs(hit.rest_a.y - 200 - 4 * ONE) <= 1, "rests at %d, %d",
            (int)hit.rest_a.x, (int)hit.rest_a.y);
  CHECK(hit.rest_b.x == 0 && abs(hit.rest_b.y - 200 - 5 * ONE) <= 1);
}

// The least width, the largest shift, and a box that ends where the profile begins.
static void check_profiles(void) {
  static const int16_t steps[] = {1, 1}, flat[] = {0, 0, 0};
  gjk2_heights profile = {steps, 2, ONE, 13};
  const gjk2_vec from = {ONE / 2, 9 * ONE}, to = {ONE / 2, 0};
  gjk2_cast_result hit;
  uint32_t segment;
  bool yes = false;
  CHECK(gjk2_ground_of_heights(&profile, &ground, &ground_shape) == GJK_OK);
  CHECK(gjk2_ground_cast_ray(&ground, &origin, &from, &to, &hit, &segment) == GJK_OK && hit.hit);
  CHECK(hit.point_a.y == 1 << 13);
  profile.heights = flat;
  profile.count = 3;
  profile.width = 1;
  CHECK(gjk2_ground_of_heights(&profile, &ground, &ground_shape) == GJK_OK);
  const gjk2_collider first = placed2(&dot, 0, 0), last = placed2(&dot, 2, 0);
  CHECK(gjk2_ground_within(&ground, &origin, &first, 0, &yes) == GJK_OK && yes);
  CHECK(gjk2_ground_within(&ground, &origin, &last, 0, &yes) == GJK_OK && yes);
}

// A ball falls onto a corner of a closed chain: of both sides, which it meets at once, the first counts, although the normal
// is that of the last.
static void check_tie(void) {
  static const gjk2_vec roof[] = {{0, 0}, {-9 * ONE, -9 * ONE}, {9 * ONE, -9 * ONE}, {9 * ONE, 0}, {0, 0}};
  const gjk2_collider ball = placed2(&disc, 0, 5 * ONE);
  const gjk2_vec to = {0, 0};
  const gjk2_cast_path path = {NULL, &to, 0};
  gjk2_cast_result hit;
  uint32_t segment = 9;
  make_chain(roof, 5);
  CHECK(gjk2_ground_cast(&ground, &origin, &ball, &path, &hit, &segment) == GJK_OK && hit.hit);
  CHECK_MSG(segment == 0 && hit.normal.x == 0, "segment %u", (unsigned)segment);
}

// A ball that passes a ridge by an LSB does not meet it. A ray that begins on the surface enters there.
static void check_grazing(void) {
  static const gjk2_vec ridge[] = {{5 * ONE, -5 * ONE}, {0, 0}, {-5 * ONE, -5 * ONE}};
  const gjk2_collider ball = placed2(&disc, -3 * ONE, ONE + 1), lower = placed2(&disc, -3 * ONE, ONE - 2);
  const gjk2_vec to = {3 * ONE, ONE + 1}, lower_to = {3 * ONE, ONE - 2}, on = {-ONE, -ONE}, under = {-ONE, -2 * ONE};
  const gjk2_cast_path path = {NULL, &to, 0}, lower_path = {NULL, &lower_to, 0};
  gjk2_cast_result hit;
  uint32_t segment;
  make_chain(ridge, 3);
  CHECK(gjk2_ground_cast(&ground, &origin, &ball, &path, &hit, &segment) == GJK_OK && !hit.hit);
  CHECK(gjk2_ground_cast(&ground, &origin, &lower, &lower_path, &hit, &segment) == GJK_OK && hit.hit);
  CHECK(gjk2_ground_cast_ray(&ground, &origin, &on, &under, &hit, &segment) == GJK_OK && hit.hit && hit.fraction == 0);
}

// A ball that grazes a ridge just at its margin: the hit is reported while it still comes nearer, so it counts.
static void check_tangential(void) {
  static const gjk2_vec ridge[] = {{5 * ONE, -5 * ONE}, {0, 0}, {-5 * ONE, -5 * ONE}};
  const gjk2_vec to = {3 * ONE, ONE + 64};
  const gjk2_cast_path path = {NULL, &to, 64};
  const gjk2_collider ball = placed2(&disc, -3 * ONE, ONE + 64);
  gjk2_cast_result hit;
  uint32_t segment;
  make_chain(ridge, 3);
  CHECK(gjk2_ground_cast(&ground, &origin, &ball, &path, &hit, &segment) == GJK_OK && hit.hit);
  CHECK(hit.normal.x < 0 && hit.fraction < GJK_Q30_ONE / 2);
}

// The longest way of a body against ground is an LSB below 2^32, either way.
static void check_longest_way(void) {
  static const gjk2_vec level[] = {{ONE, 0}, {0, 0}};
  gjk2_cast_result hit;
  uint32_t segment;
  make_chain(level, 2);
  for (int back = 0; back < 4; back++) {
    const bool along_y = back >= 2, down = back % 2 != 0;
    const gjk_q16 first = down ? INT32_MAX : INT32_MIN, last = down ? INT32_MIN : INT32_MAX, aside = INT32_C(1) << 30;
    const gjk2_collider point = along_y ? placed2(&dot, aside, first) : placed2(&dot, first, aside);
    const gjk2_vec to = {along_y ? aside : last, along_y ? last : aside};
    gjk2_vec goes = {0, 0};
    const gjk2_cast_path path = {&goes, &to, 0};
    CHECK(gjk2_ground_cast(&ground, &origin, &point, &path, &hit, &segment) == GJK_OK && !hit.hit);
    *(along_y ? &goes.y : &goes.x) = down ? 1 : -1;
    CHECK(gjk2_ground_cast(&ground, &origin, &point, &path, &hit, &segment) == GJK_ERROR_RANGE);
  }
}

// As far from the origin as ground may be, along a diagonal that a turn puts upright.
static void check_far(void) {
  static const gjk2_vec corner[] = {{GJK2_GROUND_REACH, GJK2_GROUND_REACH - ONE},
                                    {GJK2_GROUND_REACH - ONE, GJK2_GROUND_REACH}};
  const gjk2_pose turned = {{0, 0}, {759250125, 759250125}};
  gjk2_vec at;
  bool yes = false;
  make_chain(corner, 2);
  CHECK(gjk2_pose_apply(&turned, &corner[0], &at) == GJK_OK && at.y > GJK2_GROUND_REACH / 4 * 5);
  const gjk2_collider point = placed2(&dot, at.x, at.y + 10);
  CHECK(gjk2_ground_within(&ground, &turned, &point, 20, &yes) == GJK_OK && yes);
}

// The nearest segment of a body that is much farther away than ground reaches; and a ray along the line of a segment, which
// does not enter it.
static void check_beside(void) {
  static const gjk2_vec level[] = {{ONE, 0}, {0, 0}};
  const gjk2_collider ball = placed2(&disc, INT32_C(3) << 29, ONE);
  const gjk2_vec from = {3 * ONE, 0}, to = {-3 * ONE, 0};
  gjk2_distance_result gap;
  gjk2_cast_result hit;
  uint32_t segment;
  bool found = false;
  make_chain(level, 2);
  CHECK(gjk2_ground_distance(&ground, &origin, &ball, &gap, &segment, &found) == GJK_OK && found);
  CHECK(abs(gap.distance - ((INT32_C(3) << 29) - 2 * ONE)) <= 8);
  CHECK(gjk2_ground_cast_ray(&ground, &origin, &from, &to, &hit, &segment) == GJK_OK && !hit.hit);
}

// All of a shape is written, whatever was there; and the smallest tiles are refused for their size.
static void check_made(void) {
  static const gjk2_vec level[] = {{ONE, 0}, {0, 0}};
  static const gjk2_tile full[] = {GJK2_TILE(4, 4)};
  static const uint8_t cells[] = {0};
  const gjk2_tiles grid = {cells, 1, 1, 1, 1, full};
  memset(&ground_shape, 0x5A, sizeof ground_shape);
  make_chain(level, 2);
  CHECK(ground_shape.type == &gjk2_class_ground && ground_shape.user == &ground);
  CHECK(ground_shape.vertices == NULL && ground_shape.support == NULL);
  CHECK(ground_shape.convex_radius == 0 && ground_shape.count == 0);
  CHECK(gjk2_ground_of_tiles(&grid, &ground, &ground_shape) == GJK_ERROR_SIZE);
}

// The edge of that number, with its neighbours.
static bool edge_of(uint32_t number, gjk2_ground_edge *edge) {
  static const gjk2_aabb all = {{INT32_MIN, INT32_MIN}, {INT32_MAX, INT32_MAX}};
  gjk2_ground_walk walk;
  gjk2_line line;
  CHECK(gjk2_ground_place(&ground, &origin, &walk) == GJK_OK);
  gjk2_ground_begin(&walk, &all);
  while (gjk2_ground_next(&walk, &line, edge)) {
    if (edge->number == number) {
      gjk2_ground_set_neighbours(&walk, &line, edge);
      return true;
    }
  }
  return false;
}

// Each segment of a closed chain and of an open one has the vertices before and after it, past those that come twice.
static void check_chain_neighbours(void) {
  static const gjk2_vec square[] = {{0, 0}, {0, 0}, {ONE, 0}, {ONE, ONE}, {ONE, ONE}, {0, ONE}, {0, 0}};
  gjk2_ground_edge edge;
  make_chain(square, 7);
  CHECK(edge_of(1, &edge) && !edge.open_before && !edge.open_after);
  CHECK(edge.vertex[0].x == 0 && edge.vertex[0].y == ONE && edge.vertex[3].x == ONE && edge.vertex[3].y == ONE);
  CHECK(edge_of(2, &edge) && edge.vertex[0].x == 0 && edge.vertex[0].y == 0);
  CHECK(edge.vertex[3].x == 0 && edge.vertex[3].y == ONE);
  CHECK(edge_of(4, &edge) && edge.vertex[0].x == ONE && edge.vertex[0].y == 0);
  CHECK(edge.vertex[3].x == 0 && edge.vertex[3].y == 0);
  CHECK(edge_of(5, &edge) && edge.vertex[0].x == ONE && edge.vertex[0].y == ONE);
  CHECK(edge.vertex[3].x == ONE && edge.vertex[3].y == 0);
  make_chain(square + 1, 5);
  CHECK(edge_of(0, &edge) && edge.open_before && !edge.open_after && edge.vertex[3].y == ONE);
  CHECK(edge_of(3, &edge) && !edge.open_before && edge.open_after && edge.vertex[0].y == 0);
}

// Where two sides turn right at a corner, the one that turns more follows: of a platform that falls away below a full tile.
// And where two turn right to the side that begins there, the one that turns more precedes it.
static void check_tile_neighbours(void) {
  static const gjk2_tile forms[] = {GJK2_TILE(0, 0), GJK2_TILE(4, 4), {4, 0, 2, true}, GJK2_TILE_ONE_WAY(4, 0)};
  static uint8_t cells[] = {1, 2, 0, 1};
  static gjk2_tiles grid = {cells, 2, 2, 4, 4, forms};
  gjk2_ground_edge edge;
  CHECK(gjk2_ground_of_tiles(&grid, &ground, &ground_shape) == GJK_OK);
  CHECK(edge_of(4 * 0 + 1, &edge) && !edge.open_after);
  CHECK(edge.vertex[2].x == 4 && edge.vertex[2].y == 4);
  CHECK_MSG(edge.vertex[3].x == 8 && edge.vertex[3].y == 0, "%d, %d", (int)edge.vertex[3].x, (int)edge.vertex[3].y);
  cells[1] = 3;
  CHECK(edge_of(4 * 3, &edge) && !edge.open_before);
  CHECK(edge.vertex[1].x == 4 && edge.vertex[1].y == 4);
  CHECK_MSG(edge.vertex[0].x == 8 && edge.vertex[0].y == 0, "%d, %d", (int)edge.vertex[0].x, (int)edge.vertex[0].y);
}

// A grid that nobody checked, without forms: it has no surface.
static void check_no_forms(void) {
  static const uint8_t cells[] = {0, 1, 2, 3};
  static const gjk2_tiles grid = {cells, 2, 2, 4, 3, NULL};
  const gjk2_ground forged = {&gjk2_ground_tiles, &grid, {0, 0}};
  const gjk2_collider ball = placed2(&disc, 0, 0);
  bool yes = true;
  CHECK(gjk2_ground_within(&forged, &origin, &ball, 0, &yes) == GJK_OK && !yes);
}

// A profile without heights, and a grid whose forms are not there, have no segments, whatever made them.
static void check_no_data(void) {
  static const uint8_t cells[] = {0};
  const gjk2_heights bare = {NULL, 5, ONE, 0};
  const gjk2_tiles formless = {cells, 1, 1, ONE, 1, NULL};
  const gjk2_ground made[] = {{&gjk2_ground_heights, &bare, {0, 0}}, {&gjk2_ground_tiles, &formless, {0, 0}}};
  const gjk2_collider ball = placed2(&disc, ONE, ONE);
  for (int i = 0; i < 2; i++) {
    bool yes = true;
    CHECK(gjk2_ground_within(&made[i], &origin, &ball, ONE, &yes) == GJK_OK && !yes);
  }
}

// The largest grids, along each axis, and those that are a tile larger.
static void check_largest_grids(void) {
  static const gjk2_tile full[] = {GJK2_TILE(4, 4)};
  static const uint8_t cells[4096];
  gjk2_tiles grid = {cells, 1, 4095, ONE, 1, full};
  bool yes = false;
  for (int along_x = 0; along_x < 2; along_x++) {
    grid.columns = along_x ? 4095 : 1;
    grid.rows = along_x ? 1 : 4095;
    CHECK(gjk2_ground_of_tiles(&grid, &ground, &ground_shape) == GJK_OK);
    const gjk2_collider ball = placed2(&disc, grid.columns * grid.size / 2, grid.rows * grid.size + ONE);
    CHECK(gjk2_ground_within(&ground, &origin, &ball, 0, &yes) == GJK_OK && yes);
    *(along_x ? &grid.columns : &grid.rows) = 4096;
    CHECK(gjk2_ground_of_tiles(&grid, &ground, &ground_shape) == GJK_ERROR_SIZE);
  }
}

// The one segment of a turned chain is farther away than GJK2_GROUND_REACH, and found.
static void check_far_distance(void) {
  static const gjk2_vec corner[] = {{GJK2_GROUND_REACH - ONE, GJK2_GROUND_REACH},
                                    {GJK2_GROUND_REACH, GJK2_GROUND_REACH - ONE}};
  const gjk2_pose turned = {{0, 0}, {759250125, 759250125}};
  const gjk2_collider point = placed2(&dot, 0, 0);
  gjk2_distance_result gap;
  uint32_t segment;
  bool found = false;
  make_chain(corner, 2);
  CHECK(gjk2_ground_distance(&ground, &turned, &point, &gap, &segment, &found) == GJK_OK && found);
  CHECK(gap.distance > GJK2_GROUND_REACH / 4 * 5);
}

static bool same_vec(gjk2_vec a, gjk2_vec b) {
  return a.x == b.x && a.y == b.y;
}

static bool same_hit(const gjk2_cast_result *a, const gjk2_cast_result *b) {
  const gjk2_cast_certificate *c = &a->certificate, *d = &b->certificate;
  if (!a->hit || !b->hit || a->inside || b->inside) {
    return a->hit == b->hit && (!a->hit || a->inside == b->inside);
  }
  bool same = a->fraction == b->fraction && a->normal.x == b->normal.x && a->normal.y == b->normal.y &&
              same_vec(a->point_a, b->point_a) && same_vec(a->point_b, b->point_b) && same_vec(a->rest_a, b->rest_a) &&
              same_vec(a->rest_b, b->rest_b) && c->proof == d->proof && c->count == d->count &&
              same_vec(c->direction, d->direction);
  for (int i = 0; i < c->count && same; i++) {
    same = c->a[i] == d->a[i] && c->b[i] == d->b[i];
  }
  return same;
}

// Casts at segments are those of gjk2_cast, on coordinates so few that ends, feet and margins often meet exactly.
static void check_line_casts(void) {
  static const gjk2_shape bodies[] = {GJK2_CIRCLE(2), GJK2_CAPSULE(4, 1), GJK2_ROUNDED_BOX(3, 2, 1), GJK2_BOX(2, 2)};
  random_state r = random_seed(check_seed(SEED));
  unsigned hits = 0, trials = 0;
  for (int i = 0; i < 40000; i++) {
    const gjk2_vec p = {random_range(&r, -8, 8), random_range(&r, -3, 3)};
    const gjk2_vec q = {random_range(&r, -8, 8), i % 2 != 0 ? p.y : random_range(&r, -3, 3)};
    const gjk2_pose at = {{random_range(&r, -9, 9), random_range(&r, -12, 12)},
                          {i % 3 != 0 ? GJK_Q30_ONE : 0, i % 3 != 0 ? 0 : GJK_Q30_ONE}};
    const gjk2_vec to = {at.position.x + (i % 4 != 0 ? random_range(&r, -6, 6) : 0), random_range(&r, -12, 12)};
    const gjk2_cast_path path = {NULL, &to, random_range(&r, 0, 2)};
    gjk2_collider line;
    gjk2_cast_result hit, expected;
    if (same_vec(p, q)) {
      continue;
    }
    const gjk2_collider body = posed2(&bodies[i % 4], &at);
    gjk2_line_collider(p, q, &line);
    CHECK(gjk2_line_cast(&line, &body, &path, &hit) == GJK_OK && gjk2_cast(&line, &body, &path, &expected) == GJK_OK);
    CHECK_MSG(same_hit(&hit, &expected), "%d", i);
    hits += hit.hit && !hit.inside;
    trials++;
  }
  CHECK_MSG(hits > trials / 8 && hits < trials / 2, "%u hits of %u", hits, trials);
}

static gjk2_scene scene;
static gjk_body_id id[2];
static gjk2_report report;

// A scene of ground that may move and of a body.
static void make_scene(const gjk2_pose *of_ground, const gjk2_shape *body, const gjk2_pose *of_body, uint8_t detail) {
  static uint32_t block[500];
  static const gjk2_shape *shapes[2];
  const gjk2_scene_config config = {.bodies = 2, .parts = 2, .pairs = 2, .detail = detail, .motions = 2};
  const gjk2_scene_bindings bindings = {.details = &gjk2_scene_depth, .motion = &gjk2_scene_motion};
  const gjk2_part parts[] = {{.shape = 0}, {.shape = 1}};
  gjk2_body_setup setup = {*of_ground, &parts[0], 1, GJK_BODY_KINEMATIC, 0, 1, 1, 0, 0};
  shapes[0] = &ground_shape;
  shapes[1] = body;
  CHECK(gjk2_scene_init(&scene, &config, block, sizeof block, shapes, 2, &bindings) == GJK_OK);
  CHECK(gjk2_scene_add(&scene, &setup, &id[0]) == GJK_OK);
  setup.parts = &parts[1];
  setup.kind = GJK_BODY_DYNAMIC;
  setup.pose = *of_body;
  CHECK(gjk2_scene_add(&scene, &setup, &id[1]) == GJK_OK);
}

// What an update reports: one event or none.
static gjk_event update(void) {
  gjk_progress progress;
  CHECK(gjk2_scene_update(&scene, &report, 1, &progress) == GJK_OK && progress.reports_left == 0);
  return progress.reports == 1 ? (gjk_event)report.event : (gjk_event)0;
}

// A fast crate that stands, or turns a little, and ground that goes from one pose to another.
static gjk_event meet(const gjk2_pose *from, const gjk2_pose *to, gjk2_vec at, bool turns) {
  static const gjk2_shape crate = GJK2_BOX(ONE / 2, ONE / 2);
  const gjk2_pose stands = {at, {GJK_Q30_ONE, 0}};
  make_scene(from, &crate, &stands, GJK_DETAIL_TOUCH);
  CHECK(gjk2_scene_set_motion(&scene, id[0], GJK_MOTION_KEPT) == GJK_OK);
  CHECK(gjk2_scene_set_motion(&scene, id[1], GJK_MOTION_FAST) == GJK_OK);
  CHECK(update() == 0);
  CHECK(gjk2_scene_move(&scene, id[0], to) == GJK_OK);
  if (turns) {
    gjk2_pose turned = stands;
    CHECK(gjk2_rotation_from_angle(100, &turned.rotation) == GJK_OK);
    CHECK(gjk2_scene_move(&scene, id[1], &turned) == GJK_OK);
  }
  return update();
}

// Ground that turns from 30 degrees below to 30 above, so that the cosine is the same: its far end comes by, from below.
// From behind, on its way back, it does not count.
static void check_turning(void) {
  static const gjk2_vec arm[] = {{12 * ONE, 0}, {9 * ONE, 0}, {8 * ONE, 0}};
  gjk2_pose low = GJK2_POSE_IDENTITY, high = GJK2_POSE_IDENTITY;
  const gjk2_vec beside = {10 * ONE, 0};
  make_chain(arm, 3);
  CHECK(gjk2_rotation_from_angle(-34315, &low.rotation) == GJK_OK);
  CHECK(gjk2_rotation_from_angle(34315, &high.rotation) == GJK_OK);
  CHECK(low.rotation.c == high.rotation.c && low.rotation.s == -high.rotation.s);
  CHECK(meet(&low, &high, beside, false) == GJK_EVENT_IMPACT);
  CHECK(meet(&high, &low, beside, false) == 0);
}

// Ground below the origin that turns a little and rises through a crate, in one tick; and that sinks away.
static void check_rising(void) {
  static const gjk2_vec level[] = {{9 * ONE, 0}, {-9 * ONE, 0}};
  gjk2_pose low = {{0, -50 * ONE}, {GJK_Q30_ONE, 0}}, high = {{0, -10 * ONE}, {GJK_Q30_ONE, 0}};
  const gjk2_vec between = {0, -30 * ONE};
  make_chain(level, 2);
  for (int turns = 0; turns < 2; turns++) {
    CHECK(meet(&low, &high, between, turns != 0) == GJK_EVENT_IMPACT);
    CHECK(meet(&high, &low, between, turns != 0) == 0);
  }
  CHECK(gjk2_rotation_from_angle(100, &high.rotation) == GJK_OK);
  CHECK(meet(&low, &high, between, false) == GJK_EVENT_IMPACT);
}

// A rod that stands upright and flies along a level, turning by little, with a gap that is less than what an impact allows:
// its end is as far from its middle as anything of it.
static void check_passing(void) {
  static const gjk2_vec level[] = {{30 * ONE, -ONE - 5}, {-30 * ONE, -ONE - 5}};
  static const gjk2_shape rod = GJK2_SEGMENT(ONE);
  const gjk2_pose from = {{0, 0}, {0, GJK_Q30_ONE}}, to = {{4 * ONE, 0}, {20, GJK_Q30_ONE}};
  make_chain(level, 2);
  make_scene(&origin, &rod, &from, GJK_DETAIL_TOUCH);
  CHECK(gjk2_scene_set_motion(&scene, id[1], GJK_MOTION_FAST) == GJK_OK);
  CHECK(update() == 0);
  CHECK(gjk2_scene_move(&scene, id[1], &to) == GJK_OK);
  CHECK(update() == GJK_EVENT_IMPACT);
}

// How deep a crate is in the ground, as a scene reports it.
static void check_depth(void) {
  static const gjk2_vec level[] = {{9 * ONE, 0}, {-9 * ONE, 0}};
  static const gjk2_shape crate = GJK2_BOX(ONE / 2, ONE / 2);
  const gjk2_pose at = {{0, ONE / 2 - 1000}, {GJK_Q30_ONE, 0}};
  make_chain(level, 2);
  make_scene(&origin, &crate, &at, GJK_DETAIL_DEPTH);
  CHECK(update() == GJK_EVENT_BEGIN);
  CHECK_MSG(report.distance == -1000, "%d", (int)report.distance);
}

// Two grounds never touch, and none hits the other however it moves.
static void check_two_grounds(void) {
  static const gjk2_vec level[] = {{9 * ONE, 0}, {-9 * ONE, 0}};
  const gjk2_pose above = {{0, ONE}, {GJK_Q30_ONE, 0}}, below = {{0, -ONE}, {GJK_Q30_ONE, 0}};
  gjk2_chain_contact contact;
  uint16_t count = 0;
  make_chain(level, 2);
  make_scene(&origin, &ground_shape, &origin, GJK_DETAIL_DEPTH);
  CHECK(update() == 0);
  make_scene(&origin, &ground_shape, &above, GJK_DETAIL_TOUCH);
  CHECK(gjk2_scene_set_motion(&scene, id[1], GJK_MOTION_FAST) == GJK_OK);
  CHECK(update() == 0);
  CHECK(gjk2_scene_move(&scene, id[1], &below) == GJK_OK);
  CHECK(update() == 0);
  const gjk2_report pair = {.a = id[0], .b = id[1]};
  CHECK(gjk2_scene_ground_contacts(&scene, &pair, &contact, 1, &count) == GJK_ERROR_UNSUPPORTED);
  // Of two grounds no contact either.
  gjk2_manifold none;
  none.count = 9;
  CHECK(gjk2_scene_manifold(&scene, &pair, 2, &none) == GJK_OK && none.count == 0);
  const gjk2_pose turned = {{0, ONE}, {0, GJK_Q30_ONE}};
  CHECK(gjk2_scene_move(&scene, id[1], &turned) == GJK_OK);
  CHECK(update() == 0);
}

// What is behind all of a ground is near none of it. What has become no vertex has no segment, and joins none.
static void check_behind(void) {
  static gjk2_vec steps[] = {{9 * ONE, 0}, {0, 0}, {-9 * ONE, 0}, {-9 * ONE, ONE}};
  const gjk2_collider above = placed2(&disc, 4 * ONE, ONE), below = placed2(&disc, -10 * ONE, -ONE);
  const gjk2_collider left = placed2(&disc, -4 * ONE, ONE);
  gjk2_chain_contact contact;
  gjk_scene_hit hit;
  gjk_q16 distance;
  uint16_t count;
  bool found = true, yes = false;
  make_chain(steps, 4);
  make_scene(&origin, &dot, &origin, GJK_DETAIL_TOUCH);
  CHECK(gjk2_scene_remove(&scene, id[1]) == GJK_OK);
  CHECK(gjk2_scene_query_nearest(&scene, &below, 9 * ONE, NULL, &hit, &distance, &found) == GJK_OK && !found);
  CHECK(gjk2_ground_within(&ground, &origin, &left, 0, &yes) == GJK_OK && yes);
  steps[2].x = INT32_MIN;
  CHECK(gjk2_ground_within(&ground, &origin, &left, 0, &yes) == GJK_OK && !yes);
  CHECK(gjk2_ground_within(&ground, &origin, &above, 0, &yes) == GJK_OK && yes);
  CHECK(gjk2_ground_contacts(&ground, &origin, &above, 0, &contact, 1, &count) == GJK_OK && count == 1);
}

// Ground whose corner lies where no search settles whether a body is near: each query says so, and gives no answer. In
// a scene the pair counts as near, at a bound.
static void check_open(void) {
  const gjk2_vec level[] = {{whorl_point.x, whorl_point.z}, {whorl_point.x + ONE, whorl_point.z}};
  const gjk2_collider body = placed2(&whorl2, 0, 0);
  const gjk2_vec to = {ONE, ONE};
  const gjk_q16 reach = GJK_Q16(9.9992);
  const gjk2_cast_path path = {NULL, &to, reach};
  const gjk2_shape round = GJK2_ROUNDED_CUSTOM(whorl2_support, NULL, GJK_Q16(60), GJK_Q16(9.9992));
  gjk2_distance_result gap;
  gjk2_chain_contact contact;
  gjk2_cast_result hit;
  gjk2_manifold manifold;
  gjk_scene_stats stats;
  uint32_t segment = 77;
  uint16_t count = 77;
  bool yes = true;
  make_chain(level, 2);
  memset(&gap, POISON, sizeof gap);
  memset(&hit, POISON, sizeof hit);
  CHECK(gjk2_ground_within(&ground, &origin, &body, reach, &yes) == GJK_ERROR_ITERATION_LIMIT && yes);
  CHECK(gjk2_ground_distance(&ground, &origin, &body, &gap, &segment, &yes) == GJK_ERROR_ITERATION_LIMIT && yes);
  CHECK(gjk2_ground_contacts(&ground, &origin, &body, reach, &contact, 1, &count) == GJK_ERROR_ITERATION_LIMIT);
  CHECK(gjk2_ground_cast(&ground, &origin, &body, &path, &hit, &segment) == GJK_ERROR_ITERATION_LIMIT);
  CHECK(is_untouched(&gap, sizeof gap) && is_untouched(&hit, sizeof hit) && segment == 77 && count == 77);
  for (uint8_t detail = GJK_DETAIL_TOUCH; detail <= GJK_DETAIL_DEPTH; detail++) {
    make_scene(&origin, &round, &origin, detail);
    CHECK(update() == GJK_EVENT_BEGIN && (detail == GJK_DETAIL_DEPTH ? report.distance < 0 : report.distance == 0));
    CHECK(gjk2_scene_get_stats(&scene, &stats) == GJK_OK && stats.unsettled > 0);
  }
  memset(&manifold, POISON, sizeof manifold);
  CHECK(gjk2_scene_manifold(&scene, &report, 2, &manifold) == GJK_ERROR_ITERATION_LIMIT);
  CHECK(gjk2_scene_ground_contacts(&scene, &report, &contact, 1, &count) == GJK_ERROR_ITERATION_LIMIT && count == 77);
  CHECK(is_untouched(&manifold, sizeof manifold));
}

// A fast body whose arc leaves int32 between its ends, near ground: no impact is proven or ruled out. One is reported at
// the start.
static void check_arc_out_of_range(void) {
  static const gjk2_vec level[] = {{GJK2_GROUND_REACH, 0}, {GJK2_GROUND_REACH - ONE, 0}};
  static const gjk2_vec corner[3] = {{INT32_C(1) << 28, 0}, {(INT32_C(1) << 28) + ONE, 0}, {INT32_C(1) << 28, ONE}};
  static const gjk2_shape far = GJK2_TRIANGLE(corner);
  const gjk2_pose of_ground = {{INT32_MAX - 2 * GJK2_GROUND_REACH, 0}, {GJK_Q30_ONE, 0}};
  gjk2_pose from = {{INT32_MAX - (INT32_C(1) << 27), 0}, {GJK_Q30_ONE, 0}}, to = from;
  CHECK(gjk2_rotation_from_angle(GJK_ANGLE(1.4), &from.rotation) == GJK_OK);
  CHECK(gjk2_rotation_from_angle(-GJK_ANGLE(1.4), &to.rotation) == GJK_OK);
  make_chain(level, 2);
  make_scene(&of_ground, &far, &from, GJK_DETAIL_TOUCH);
  CHECK(gjk2_scene_set_motion(&scene, id[1], GJK_MOTION_FAST) == GJK_OK);
  CHECK(update() == 0);
  CHECK(gjk2_scene_move(&scene, id[1], &to) == GJK_OK);
  CHECK(update() == GJK_EVENT_IMPACT && report.fraction == 0);
}

// What the calls about a scene's ground refuse; nothing is written then.
static void check_refusals(void) {
  static const gjk2_vec level[] = {{9 * ONE, 0}, {-9 * ONE, 0}};
  gjk2_chain_contact contact;
  gjk2_manifold manifold;
  gjk2_pose pose;
  const gjk2_ground *found;
  uint16_t count;
  make_chain(level, 2);
  make_scene(&origin, &dot, &origin, GJK_DETAIL_TOUCH);
  memset(&contact, POISON, sizeof contact);
  memset(&manifold, POISON, sizeof manifold);
  memset(&pose, POISON, sizeof pose);
  memset(&found, POISON, sizeof found);
  memset(&count, POISON, sizeof count);
  CHECK(gjk2_scene_ground(&scene, id[0], 0, NULL, &pose) == GJK_ERROR_NULL);
  CHECK(gjk2_scene_ground(&scene, id[0], 0, &found, NULL) == GJK_ERROR_NULL);
  CHECK(gjk2_scene_ground(NULL, id[0], 0, &found, &pose) == GJK_ERROR_NULL);
  CHECK(gjk2_scene_ground(&scene, id[0], 1, &found, &pose) == GJK_ERROR_RANGE);
  CHECK(gjk2_scene_ground(&scene, id[1], 0, &found, &pose) == GJK_ERROR_UNSUPPORTED);
  gjk_body_id gone = id[0];
  gone.generation += 2;
  CHECK(gjk2_scene_ground(&scene, gone, 0, &found, &pose) == GJK_ERROR_BODY_ID);
  const gjk2_report good = {.a = id[0], .b = id[1]}, bodies = {.a = id[1], .b = id[1]}, old = {.a = gone, .b = id[1]},
                    later = {.a = id[0], .b = gone}, part = {.a = id[0], .b = id[1], .part_b = 1};
  CHECK(gjk2_scene_ground_contacts(&scene, NULL, &contact, 1, &count) == GJK_ERROR_NULL);
  CHECK(gjk2_scene_ground_contacts(&scene, &good, NULL, 1, &count) == GJK_ERROR_NULL);
  CHECK(gjk2_scene_ground_contacts(&scene, &good, &contact, 1, NULL) == GJK_ERROR_NULL);
  CHECK(gjk2_scene_ground_contacts(&scene, &bodies, &contact, 1, &count) == GJK_ERROR_UNSUPPORTED);
  CHECK(gjk2_scene_ground_contacts(&scene, &old, &contact, 1, &count) == GJK_ERROR_BODY_ID);
  CHECK(gjk2_scene_ground_contacts(&scene, &later, &contact, 1, &count) == GJK_ERROR_BODY_ID);
  CHECK(gjk2_scene_ground_contacts(&scene, &part, &contact, 1, &count) == GJK_ERROR_RANGE);
  CHECK(gjk2_scene_manifold(&scene, &good, 0, &manifold) == GJK_ERROR_RANGE);
  CHECK(gjk2_scene_manifold(&scene, &good, GJK2_CONTACTS_MAX + 1, &manifold) == GJK_ERROR_RANGE);
  CHECK(is_untouched(&contact, sizeof contact) && is_untouched(&manifold, sizeof manifold) &&
        is_untouched(&pose, sizeof pose) && is_untouched(&found, sizeof found) && is_untouched(&count, sizeof count));
  CHECK(gjk2_scene_ground(&scene, id[0], 0, &found, &pose) == GJK_OK && found == &ground);
}

// Shapes of ground that nobody made are refused or taken by what they say, up to the largest one.
static void check_shapes(void) {
  static const gjk2_vec level[] = {{9 * ONE, 0}, {-9 * ONE, 0}};
  static const gjk2_ground none = {NULL, level, {0, 0}};
  static const struct {
    gjk2_vec half;
    gjk_status status;
  } sizes[] = {{{-1, 0}, GJK_ERROR_NEGATIVE},
               {{0, -1}, GJK_ERROR_NEGATIVE},
               {{GJK2_RADIUS_MAX, 1}, GJK_ERROR_SIZE},
               {{1, GJK2_RADIUS_MAX}, GJK_ERROR_SIZE},
               {{INT32_MAX, INT32_MAX}, GJK_ERROR_SIZE}};
  gjk2_shape made;
  make_chain(level, 2);
  make_scene(&origin, &dot, &origin, GJK_DETAIL_TOUCH);
  CHECK(gjk2_scene_remove(&scene, id[0]) == GJK_OK);
  const gjk2_body_setup setup = {origin, &(gjk2_part){.shape = 1}, 1, GJK_BODY_STATIC, 0, 1, 1, 0, 0};
  const gjk2_shape *const shapes[] = {&ground_shape, &made};
  made = ground_shape;
  scene.shapes = shapes;
  for (unsigned i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
    made.size = sizes[i].half;
    CHECK_MSG(gjk2_scene_add(&scene, &setup, &id[0]) == sizes[i].status, "size %u", i);
  }
  made.size.x = GJK2_RADIUS_MAX;
  made.size.y = 0;
  made.user = NULL;
  CHECK(gjk2_scene_add(&scene, &setup, &id[0]) == GJK_ERROR_NULL);
  made.user = &none;
  CHECK(gjk2_scene_add(&scene, &setup, &id[0]) == GJK_ERROR_NULL);
  made.user = &ground;
  CHECK(gjk2_scene_add(&scene, &setup, &id[0]) == GJK_OK);
}

int main(void) {
  check_rest();
  check_profiles();
  check_tie();
  check_grazing();
  check_tangential();
  check_longest_way();
  check_far();
  check_beside();
  check_made();
  check_chain_neighbours();
  check_tile_neighbours();
  check_no_forms();
  check_no_data();
  check_largest_grids();
  check_far_distance();
  check_line_casts();
  check_turning();
  check_rising();
  check_passing();
  check_depth();
  check_two_grounds();
  check_behind();
  check_open();
  check_arc_out_of_range();
  check_refusals();
  check_shapes();
  return check_done("plane ground cases");
}
