// Skips to the last LSB: what a pair's record claims is so, motion bounds what moves, and paths that spend each gap in full
// are told as a scene without skips and brute force tell them, tick by tick.

#include "check.h"
#include "generate/polytope.h"
#include "src/scene/gjk_scene_block.h"
#include "src/shape/gjk_shape_class.h"

#define SEED 740
#define PATHS 3000u
#define TICKS 60u
#define MOVES 20000u
#define FACES 20000u

static const gjk_pose identity = GJK_POSE_IDENTITY;

static uint64_t seed;
static uint32_t quick_block[300], plain_block[300];
static gjk_scene quick, plain;  // with all skips, with none
static const gjk_shape *shapes[2];
static gjk_pose pose[2], offset;  // of the bodies; of both parts in them, if own_pose
static bool own_pose;
static gjk_body_id body[2];
static gjk_q16 margin;  // of both together
static unsigned motion_count, boxes_count, direction_count, near_count, far_count, edge_count, deep_count;
static unsigned manifold_count;
static bool contacts;  // of the scene with skips: its manifolds prove gaps, too

#define CELLS 2000u
static gjk_epa_cell cells[CELLS];
static const gjk_workspace workspace = {cells, CELLS};

static void start_scene(gjk_scene *scene, uint32_t *block, size_t bytes, gjk_q16 box_margin, uint8_t retest_all) {
  static gjk_manifold manifold;
  const bool asks = contacts && retest_all == 0;
  const gjk_scene_config config = {
      2, 2, 2, 1, box_margin, asks ? GJK_DETAIL_CONTACTS : GJK_DETAIL_TOUCH, asks ? 1 : 0, retest_all, 0, CELLS, 0};
  const gjk_scene_bindings bindings = {.details = &gjk_scene_contacts, .workspace = &workspace, .manifolds = &manifold};
  CHECK(gjk_scene_init(scene, &config, block, bytes, shapes, 2, &bindings) == GJK_OK);
  for (uint16_t i = 0; i < 2; i++) {
    const gjk_part part = {i, own_pose, offset};
    gjk_body_setup setup = {pose[i], &part, 1, GJK_BODY_DYNAMIC, GJK_DETAIL_TOUCH, 1, 1, 0, 0};
    setup.margin = i == 0 ? margin / 2 : margin - margin / 2;
    CHECK(gjk_scene_add(scene, &setup, &body[i]) == GJK_OK);
  }
}

// Both scenes, of the shapes at their poses.
static void start(gjk_q16 box_margin) {
  contacts = !contacts;
  start_scene(&quick, quick_block, sizeof quick_block, box_margin, 0);
  start_scene(&plain, plain_block, sizeof plain_block, box_margin, 1);
}

static gjk_collider collider_of(unsigned i) {
  gjk_collider c;
  CHECK(gjk_scene_collider(&quick, body[i], 0, &c) == GJK_OK);
  return c;
}

static const gjk_scene_part *part_of(unsigned i) {
  gjk_scene_view v;
  CHECK(gjk_scene_view_of(&quick, &v) == GJK_OK);
  return &v.parts[v.bodies[i].first];
}

// The record of the pair, NULL when its boxes do not meet.
static const gjk_scene_pair *record(void) {
  gjk_scene_view v;
  CHECK(gjk_scene_view_of(&quick, &v) == GJK_OK);
  return v.header->pairs.count == 0 ? NULL : &v.pairs[0];
}

static bool is_near(void) {
  return record() != NULL && (record()->state & GJK_SCENE_PAIR_NEAR) != 0;
}

static bool is_curved(const gjk_shape *shape) {
  return shape->type->vertex == NULL;
}

// Updates a scene. Is the pair near?
static bool update(gjk_scene *scene) {
  gjk_report report;
  gjk_progress progress;
  uint32_t cursor = 0;
  bool found = false;
  CHECK(gjk_scene_update(scene, &report, 1, &progress) == GJK_OK);
  CHECK(gjk_scene_next_near(scene, &cursor, &report, &found) == GJK_OK);
  return found;
}

static void move(unsigned i) {
  CHECK(gjk_scene_move(&quick, body[i], &pose[i]) == GJK_OK);
  CHECK(gjk_scene_move(&plain, body[i], &pose[i]) == GJK_OK);
}

// The distance of the cores, to the nearest LSB; with deep, of those that overlap, minus their depth, rounded up.
static int64_t core_distance(bool deep) {
  gjk_collider c[2];
  gjk_shape core[2];
  gjk_distance_result r = {0};
  for (unsigned i = 0; i < 2; i++) {
    core[i] = *shapes[i];
    core[i].convex_radius = 0;
    c[i] = collider_of(i);
    c[i].shape = &core[i];
    c[i].radius = c[i].core_radius;
  }
  CHECK((deep ? gjk_signed_distance(&c[0], &c[1], NULL, &workspace, &r) : gjk_distance(&c[0], &c[1], NULL, &r)) ==
        GJK_OK);
  return r.distance;
}

// The record's gap against the distance of polytopes, which half an LSB of rounding is allowed.
static bool claim_holds(void) {
  const gjk_scene_pair *pair = record();
  if (pair == NULL || pair->gap == 0 || is_curved(shapes[0]) || is_curved(shapes[1])) {
    return true;
  }
  const int64_t limit = (int64_t)margin + shapes[0]->convex_radius + shapes[1]->convex_radius;
  const bool deep = (pair->state & GJK_SCENE_PAIR_NEAR) != 0 && pair->gap > limit;
  const int64_t distance = core_distance(deep);
  deep_count += deep;
  manifold_count += deep && contacts;
  return (pair->state & GJK_SCENE_PAIR_NEAR) != 0 ? distance <= limit - pair->gap : distance >= limit + pair->gap;
}

// Only a pair with a curved shape may reach the ceiling on iterations, where that is low.
static bool answered(gjk_status status) {
  const bool curved = is_curved(shapes[0]) || is_curved(shapes[1]);
  CHECK_MSG(status == GJK_OK || (curved && status == GJK_ERROR_ITERATION_LIMIT), "%s", gjk_status_name(status));
  return status == GJK_OK;
}

// Then the pair is near, unless the boxes tell.
static bool boxes_are_near(const gjk_collider *a, const gjk_collider *b) {
  gjk_aabb box, other;
  CHECK(gjk_collider_aabb(a, &box) == GJK_OK);
  CHECK(gjk_collider_aabb(b, &other) == GJK_OK);
  return gjk_aabb_gap(&box, &other) <= (uint32_t)margin;
}

// One update of both scenes, compared with brute force. Returns whether all agree.
static bool tick(void) {
  const gjk_collider a = collider_of(0), b = collider_of(1);
  gjk_decision truth = {0};
  gjk_scene_stats stats;
  if (!answered(gjk_within(&a, &b, margin, NULL, &truth))) {
    truth.yes = boxes_are_near(&a, &b);
  }
  const bool with = update(&quick), without = update(&plain);
  CHECK(gjk_scene_get_stats(&quick, &stats) == GJK_OK);
  motion_count += stats.motion;
  boxes_count += stats.boxes;
  direction_count += stats.direction;
  near_count += truth.yes;
  far_count += !truth.yes;
  return with == truth.yes && without == truth.yes && claim_holds();
}

// A motion that a path makes in one tick: LSB along the axes, and half turns in Q30.
typedef struct course {
  gjk_vec3 way;  // from A to B: Q30, or one axis
  bool along_axis, turning;
  int sign;  // 1: towards each other
} course;

static gjk_q16 part_way(int64_t amount, gjk_q30 along) {
  return (gjk_q16)(amount * along / GJK_Q30_ONE);
}

static void shift(unsigned i, const gjk_vec3 *way, int64_t amount) {
  pose[i].position.x += part_way(amount, way->x);
  pose[i].position.y += part_way(amount, way->y);
  pose[i].position.z += part_way(amount, way->z);
}

// Turns by so much that points move by about amount, about any axis or one of the three.
static void turn(random_state *random, unsigned i, int64_t amount) {
  const int64_t half = amount * (GJK_Q30_ONE / 2) / collider_of(i).core_radius;
  const int32_t most = (int32_t)(half < GJK_Q30_ONE / 4 ? half : GJK_Q30_ONE / 4);
  const unsigned axis = random_below(random, 6);
  gjk_quat any = {0, 0, 0, GJK_Q30_ONE};
  any.x = axis == 1 || axis == 2 ? 0 : random_range(random, -most, most);
  any.y = axis == 0 || axis == 2 ? 0 : random_range(random, -most, most);
  any.z = axis == 0 || axis == 1 ? 0 : random_range(random, -most, most);
  gjk_quat by;
  CHECK(gjk_quat_normalize(&any, &by) == GJK_OK);
  CHECK(gjk_quat_compose(&by, &pose[i].rotation, &pose[i].rotation) == GJK_OK);
  CHECK(gjk_quat_normalize(&pose[i].rotation, &pose[i].rotation) == GJK_OK);
}

static gjk_vec3 main_axis(const gjk_vec3 *way) {
  const uint32_t x = gjk_magnitude32(way->x), y = gjk_magnitude32(way->y), z = gjk_magnitude32(way->z);
  gjk_vec3 axis = {0, 0, 0};
  gjk_q30 *const to = x >= y && x >= z ? &axis.x : y >= z ? &axis.y : &axis.z;
  const gjk_q30 from = x >= y && x >= z ? way->x : y >= z ? way->y : way->z;
  *to = from < 0 ? -GJK_Q30_ONE : GJK_Q30_ONE;
  return axis;
}

// The way between the shapes, unless they touch: then that of the last time.
static int64_t look(course *c) {
  const gjk_collider a = collider_of(0), b = collider_of(1);
  gjk_distance_result r = {0};
  answered(gjk_distance(&a, &b, NULL, &r));
  if (r.distance > 0) {
    const gjk_vec3 way = {r.normal.x, r.normal.y, r.normal.z};
    c->way = c->along_axis ? main_axis(&way) : way;
  }
  return r.distance;
}

// How far to go: what the record leaves, or an LSB less or more, or a share of the way to the border.
static int64_t choose_amount(random_state *random, int64_t distance) {
  const gjk_scene_pair *pair = record();
  const int64_t left = distance > margin ? distance - margin : margin - distance;
  if (pair != NULL && pair->gap > 1 && pair->gap < GJK_Q16(2000) && random_below(random, 3) == 0) {
    return pair->gap + random_range(random, -1, 1);
  }
  return 1 + (int64_t)random_below(random, (uint32_t)(left / (1 + random_below(random, 12)) + 4));
}

// Two numbers whose motions add up to amount along an axis: odd ones, which are not rounded up.
static void split(random_state *random, int64_t amount, int64_t share[2]) {
  const unsigned first = random_below(random, 2);
  share[first] = amount % 2 != 0 ? amount : 1 + 2 * (int64_t)random_below(random, (uint32_t)(amount / 2));
  share[1 - first] = amount - share[first];
}

// Goes on for one tick; false where a shape would leave the world.
static void advance(random_state *random, course *c) {
  const int64_t distance = look(c), amount = choose_amount(random, distance);
  int64_t share[2];
  if (distance > 3 * (int64_t)margin + GJK_Q16(1) || random_below(random, 16) == 0) {
    c->sign = distance > 3 * (int64_t)margin + GJK_Q16(1) ? 1 : -c->sign;
  }
  split(random, amount, share);
  shift(0, &c->way, c->sign * share[0]);
  shift(1, &c->way, -c->sign * share[1]);
  for (unsigned i = 0; i < 2; i++) {
    if (c->turning) {
      turn(random, i, share[i]);
    }
    if (share[i] != 0 || c->turning) {
      move(i);
    }
  }
}

static case_shape cases[2];
static case_collider built[2];

static gjk_q16 random_size(random_state *random, gjk_q16 reach) {
  return random_range(random, reach / 4 + 1, reach);
}

// A shape of about that reach; curved ones as sharp as a cone and as flat as a coin.
static void make_shape(random_state *random, unsigned i, gjk_q16 reach) {
  case_shape *shape = &cases[i];
  const uint32_t what = random_below(random, 8);
  if (what < 5) {
    generate_polytope(random, generate_kind(random), reach, shape);
  } else {
    case_shape_reset(shape);
    shape->kind = what == 5 ? CASE_CYLINDER : what == 6 ? CASE_CONE : CASE_ELLIPSOID;
    shape->size.x = random_size(random, reach / 2);
    shape->size.y = what == 7 ? random_size(random, reach / 2) : shape->size.x;
    shape->size.z = random_size(random, reach / 2);
  }
  shape->convex_radius = random_below(random, 3) == 0 ? random_range(random, 0, reach / 8) : 0;
  CHECK(case_collider_build(&built[i], shape, true) == GJK_OK);
  shapes[i] = &built[i].shape;
}

// Two random shapes apart, at random poses or, where they are to meet along an axis, one with its faces across the axes.
static void make_pair(random_state *random, bool level) {
  const gjk_q16 reach = generate_reach(random) / 2 + 20;
  double apart = 1;
  for (unsigned i = 0; i < 2; i++) {
    make_shape(random, i, reach);
    apart += built[i].collider.radius;
    pose[i].rotation = generate_rotation(random);
    const gjk_vec3 place = generate_vector(random, 1 << 27);
    pose[i].position = place;
  }
  own_pose = !level && random_below(random, 3) == 0;
  offset.position = generate_vector(random, reach);
  offset.rotation = generate_rotation(random);
  if (level) {
    pose[0].rotation = identity.rotation;
  }
  const gjk_vec3 way = generate_vector(random, apart * (1 + generate_unit(random)));
  pose[1].position.x = pose[0].position.x + way.x;
  pose[1].position.y = pose[0].position.y + way.y;
  pose[1].position.z = pose[0].position.z + way.z;
  margin = random_below(random, 2) == 0 ? 0 : random_range(random, 0, reach / 2);
}

// Towards each other, through the border and back, turning or not, in steps that spend what the last test left.
static void check_paths(void) {
  random_state random = random_seed(seed);
  for (unsigned i = 0; i < check_trials(PATHS); i++) {
    check_trial(i, NULL, NULL);
    const bool along_axis = random_below(&random, 2) == 0;
    course c = {{GJK_Q30_ONE, 0, 0}, along_axis, !along_axis && random_below(&random, 2) == 0, 1};
    make_pair(&random, along_axis);
    start(random_below(&random, 2) == 0 ? 0 : random_range(&random, 0, GJK_Q16(100)));
    bool fine = tick();
    for (unsigned k = 0; k < TICKS && fine; k++) {
      advance(&random, &c);
      fine = tick();
      CHECK_MSG(fine, "tick %u", k);
    }
    CHECK(gjk_scene_check(&quick) == GJK_OK);
  }
}

// One LSB less than the gap is skipped, the gap is not.
static void check_edges(void) {
  random_state random = random_seed(seed + 1);
  for (unsigned i = 0; i < check_trials(PATHS); i++) {
    check_trial(i, NULL, NULL);
    course c = {{GJK_Q30_ONE, 0, 0}, true, false, 1};
    make_pair(&random, true);
    start(GJK_Q16(4000));
    bool fine = tick();
    for (unsigned k = 0; k < 12 && fine; k++) {
      gjk_scene_stats stats;
      int64_t share[2];
      look(&c);
      const bool was = (record()->state & GJK_SCENE_PAIR_NEAR) != 0, skipped = random_below(&random, 2) == 0;
      const int64_t amount = record()->gap - (skipped ? 1 : 0);
      if (amount <= 0 || amount > GJK_Q16(2000)) {
        advance(&random, &c);
        fine = tick();
        continue;
      }
      split(&random, amount, share);
      for (unsigned n = 0; n < 2; n++) {
        shift(n, &c.way, (n == 0) == was ? -share[n] : share[n]);
        move(n);
      }
      fine = tick();
      CHECK_MSG(fine, "step %u", k);
      CHECK(gjk_scene_get_stats(&quick, &stats) == GJK_OK);
      // Curved pairs are asked anew in each update.
      const bool curved = is_curved(shapes[0]) || is_curved(shapes[1]);
      CHECK_MSG(stats.motion == (skipped && !curved ? 1 : 0), "step %u", k);
      edge_count++;
    }
  }
}

// Spheres inside of two shapes prove them near, and how deep at least.
static void check_deep(void) {
  random_state random = random_seed(seed + 4);
  const unsigned long trials = check_trials_least(PATHS, 500);
  unsigned settled = 0, asked = 0;
  for (unsigned i = 0; i < trials; i++) {
    check_trial(i, NULL, NULL);
    make_pair(&random, false);
    own_pose = false;
    gjk_shape boxes[2];
    int32_t reach = 0;
    for (unsigned k = 0; k < 2; k++) {
      const int32_t size = 1 << random_below(&random, 24);
      const gjk_shape box =
          GJK_ROUNDED_BOX(random_range(&random, size / 2, size), random_range(&random, size / 2, size),
                          random_range(&random, size / 2, size), 0);
      boxes[k] = box;
      boxes[k].convex_radius = random_below(&random, 3) == 0 ? size / 4 : 0;
      shapes[k] = random_below(&random, 8) != 0 ? &boxes[k] : shapes[k];
      reach += size;
    }
    const gjk_vec3 way = generate_vector(&random, (double)reach / 2);
    pose[1].position = gjk_add(pose[0].position, way);
    start(0);
    bool fine = tick();
    for (unsigned k = 0; k < 4 && fine; k++) {
      gjk_scene_stats stats;
      const bool was = is_near();
      turn(&random, k % 2, 1 + (int64_t)random_below(&random, (uint32_t)reach));
      move(k % 2);
      fine = tick();
      CHECK_MSG(fine, "tick %u", k);
      CHECK(gjk_scene_get_stats(&quick, &stats) == GJK_OK);
      settled += was && stats.boxes == 1 && is_near();
      asked += was && stats.warm == 1;
    }
  }
  CHECK(settled > trials / 8);
  CHECK(asked > trials / 8);
  printf("%u near by spheres inside, %u by a query\n", settled, asked);
}

// The farthest that a point has moved, squared, from colliders of polytopes; below 2^63.
static uint64_t farthest_moved(const gjk_collider *from, const gjk_collider *to) {
  uint64_t farthest = 0;
  const unsigned count = from->shape->vertices != NULL ? from->count : 1u << from->count;
  for (unsigned i = 0; i < count; i++) {
    gjk_vec3 v = {0, 0, 0}, w = {0, 0, 0};
    CHECK(from->shape->type->vertex(from, (uint16_t)i, &v));
    CHECK(to->shape->type->vertex(to, (uint16_t)i, &w));
    const int64_t x = (int64_t)to->centre.x + w.x - from->centre.x - v.x;
    const int64_t y = (int64_t)to->centre.y + w.y - from->centre.y - v.y;
    const int64_t z = (int64_t)to->centre.z + w.z - from->centre.z - v.z;
    const uint64_t squared = (uint64_t)(x * x) + (uint64_t)(y * y) + (uint64_t)(z * z);
    farthest = squared > farthest ? squared : farthest;
  }
  return farthest;
}

// What a part is said to have moved since the last update bounds what its vertices have, in one call or several.
static void check_motion(void) {
  random_state random = random_seed(seed + 2);
  unsigned tight = 0;
  for (unsigned i = 0; i < check_trials(MOVES); i++) {
    check_trial(i, NULL, NULL);
    make_pair(&random, false);
    if (is_curved(shapes[1])) {
      continue;
    }
    start(0);
    update(&quick);
    const gjk_collider from = collider_of(1);
    CHECK(from.radius == built[1].collider.radius);
    const unsigned calls = 1 + random_below(&random, 3);
    const int32_t most = (int32_t)(generate_reach(&random) / 2);
    const int64_t amount = random_range(&random, 0, most);
    for (unsigned k = 0; k < calls; k++) {
      const gjk_vec3 way = generate_vector(&random, random_below(&random, 2) == 0 ? 0 : (double)amount / 2);
      pose[1].position.x += way.x;
      pose[1].position.y += way.y;
      pose[1].position.z += way.z;
      if (random_below(&random, 3) != 0) {
        turn(&random, 1, random_below(&random, 2) == 0 ? 1 : amount);
      }
      move(1);
    }
    const gjk_collider to = collider_of(1);
    const uint64_t motion = part_of(1)->motion, squared = farthest_moved(&from, &to);
    CHECK_MSG(motion >= GJK_SCENE_UNBOUNDED || motion * motion >= squared, "%llu, squared %llu",
              (unsigned long long)motion, (unsigned long long)squared);
    tight += motion < 20 || motion / 2 * (motion / 2) < squared;
  }
  CHECK(tight > check_trials(MOVES) / 3);  // at most twice what was moved
}

// Two equal rectangles across (p, p, c), shifted far along each other: there a unit vector's last bit counts, and the distance
// is known. The corners are in opposite order, so that first ones found lie far apart.
typedef struct faces {
  gjk_vec3 corner[2][4], normal;
  gjk_shape shape[2];
  int64_t above;  // times the length of the normal: the distance
} faces;

static gjk_vec3 combine(const gjk_vec3 *a, int32_t i, const gjk_vec3 *b, int32_t k) {
  return (gjk_vec3){i * a->x + k * b->x, i * a->y + k * b->y, i * a->z + k * b->z};
}

// (x, y, z) turned by so many places.
static gjk_vec3 cycled(const gjk_vec3 *v, unsigned places) {
  const gjk_vec3 by[3] = {{v->x, v->y, v->z}, {v->z, v->x, v->y}, {v->y, v->z, v->x}};
  return by[places];
}

static void make_faces(random_state *random, faces *f) {
  own_pose = false;
  const unsigned places = random_below(random, 3);
  const int32_t p = 1 << random_below(random, 15), c = random_range(random, 1, 1 << 14);
  const gjk_vec3 n = {p, p, c}, across = {1, -1, 0}, up = {-c, -c, 2 * p};
  f->normal = cycled(&n, places);
  const gjk_vec3 e1 = cycled(&across, places), e2 = cycled(&up, places);
  int32_t m1 = 1 << 26, m2 = 1 << 26;  // powers of two, so that the normal found is the one here
  while ((int64_t)m2 * (p > c ? p : c) > INT32_C(3) << 25) {
    m2 /= 2;
  }
  m1 >>= random_below(random, 4);
  for (int i = 0; i < 4; i++) {
    f->corner[0][i] = combine(&e1, i % 2 != 0 ? m1 : -m1, &e2, i / 2 != 0 ? m2 : -m2);
    f->corner[1][i] = gjk_negate(f->corner[0][i]);
  }
  const gjk_vec3 aside = combine(&e1, random_range(random, -m1, m1), &e2, random_range(random, -m2, m2));
  const gjk_vec3 off = {random_range(random, 0, 999), random_range(random, 0, 999), random_range(random, 1, 999)};
  f->above = gjk_dot(&f->normal, &off);
  for (unsigned i = 0; i < 2; i++) {
    f->shape[i] = (gjk_shape)GJK_HULL(f->corner[i], 4);
    shapes[i] = &f->shape[i];
    pose[i] = identity;
  }
  pose[1].position = gjk_add(aside, off);
}

static void check_faces(void) {
  random_state random = random_seed(seed + 3);
  unsigned apart = 0, near = 0;
  for (unsigned i = 0; i < check_trials(FACES); i++) {
    check_trial(i, NULL, NULL);
    faces f;
    make_faces(&random, &f);
    margin = random_range(&random, 0, 1) == 0 ? 0 : random_range(&random, 0, 3000);
    start(GJK_Q16(1));
    const bool yes = update(&quick);
    const int64_t claimed = yes ? margin - record()->gap : margin + record()->gap;
    const int64_t square = f.above * f.above, bound = claimed * claimed * gjk_dot(&f.normal, &f.normal);
    CHECK(yes ? square <= bound : square >= bound);
    apart += !yes && record()->gap > 0;
    near += yes && record()->gap > 0;
  }
  CHECK(apart > check_trials(FACES) / 4);
  CHECK(near > check_trials(FACES) / 8);
}

int main(void) {
  seed = check_seed(SEED);
  check_motion();
  check_faces();
  check_edges();
  check_paths();
  check_deep();
  printf("%u near, %u far; %u skipped by motion, %u by boxes, %u by direction; %u edges; %u deep, %u by manifolds\n",
         near_count, far_count, motion_count, boxes_count, direction_count, edge_count, deep_count, manifold_count);
  CHECK(deep_count > check_trials(PATHS) / 8 && manifold_count > check_trials(PATHS));
  for (unsigned i = 0; i < 2; i++) {
    case_collider_free(&built[i]);
    case_shape_free(&cases[i]);
  }
  return check_done("scene_skips");
}
