// Move and slide: floors, walls, corners, slopes, steps and gaps, capsules and boxes; at random, that it passes through
// nothing, overlaps nothing, keeps its gap and ends where casts of its own steps end.
#include <stdlib.h>
#include <string.h>

#include "ceilings.h"
#include "check.h"
#include "random.h"

// The test of the plane has included the plane's.
#ifndef TEST_NAME
#include "gjk/gjk.h"
#include "gjk/slide.h"
#define TEST_NAME "scene_slide"
#define SPACE 1
#endif

#include "placed.h"
#include "scene_bodies.h"

#define SEED 7790
#define ROOMS check_trials(160)
#define WALKS 60
#define ONE GJK_Q16_ONE
#define SKIN 328  // 0.005 units
#define BODIES 24

#if SPACE
#define VECTOR(x, y, z) \
  { x, y, z }
static const gjk_shape ground = GJK_BOX(20 * ONE, ONE, 20 * ONE), crate = GJK_BOX(ONE / 2, ONE / 2, ONE / 2);
static const gjk_shape tread = GJK_BOX(ONE, ONE / 8, 20 * ONE), pole = GJK_CYLINDER(ONE, ONE / 4);
static const gjk_shape man = GJK_CAPSULE(GJK_Q16(0.3), GJK_Q16(0.5)), robot = GJK_BOX(ONE / 3, ONE / 2, ONE / 4);
static const gjk_unit3 up = {0, GJK_Q30_ONE, 0};
#else
#define VECTOR(x, y, z) \
  { x, y }
static const gjk_shape ground = GJK2_BOX(20 * ONE, ONE), crate = GJK2_BOX(ONE / 2, ONE / 2);
static const gjk_shape tread = GJK2_BOX(ONE, ONE / 8), pole = GJK2_ELLIPSE(ONE / 3, ONE);
static const gjk_shape man = GJK2_CAPSULE(GJK_Q16(0.3), GJK_Q16(0.5)), robot = GJK2_BOX(ONE / 3, ONE / 2);
static const gjk_unit3 up = {0, GJK_Q30_ONE};
#endif

static const gjk_shape *const shapes[] = {&ground, &crate, &tread, &pole};
static gjk_scene scene;
static uint32_t block[8000];
static unsigned long slid, stood, climbed, stuck_count, blocked, free_walks;
static unsigned most_casts;

static void start_scene(void) {
  const gjk_scene_config config = {.bodies = BODIES, .parts = BODIES, .pairs = 1};
  CHECK(gjk_scene_bytes(&config) <= sizeof block);
  CHECK(gjk_scene_init(&scene, &config, block, sizeof block, shapes, 4, NULL) == GJK_OK);
}

static gjk_body_id add_at(uint16_t shape, gjk_q16 x, gjk_q16 y, gjk_q16 z) {
  gjk_pose pose = GJK_POSE_IDENTITY;
  const gjk_vec3 position = VECTOR(x, y, z);
  (void)z;
  pose.position = position;
  return scene_add_shape(&scene, shape, GJK_BODY_STATIC, &pose);
}

static void set_walker(gjk_collider *c, const gjk_shape *shape, gjk_vec3 position) {
  gjk_pose pose = GJK_POSE_IDENTITY;
  pose.position = position;
#if SPACE
  if (shape == &man) {  // upright: its segment is along z
    const gjk_quat upright = {-759250125, 0, 0, 759250125};
    CHECK(gjk_quat_normalize(&upright, &pose.rotation) == GJK_OK);
  }
#else
  if (shape == &man) {
    pose.rotation = (gjk_quat){0, GJK_Q30_ONE};
  }
#endif
  *c = posed(shape, &pose);
}

static gjk_slide_setup usual(void) {
  gjk_slide_setup s = {0};
  s.up = up;
  s.slope = GJK_Q30_ONE / 2;  // 60 degrees
  s.skin = SKIN;
  s.step = ONE / 3;
  s.reach = ONE / 8;
  return s;
}

static gjk_slide_result walk(const gjk_collider *c, gjk_vec3 to, const gjk_slide_setup *setup) {
  gjk_slide_result result;
  memset(&result, 0x5A, sizeof result);
  CHECK(gjk_slide(&scene, c, &to, setup, &result) == GJK_OK);
  most_casts = result.casts > most_casts ? result.casts : most_casts;
  CHECK(result.casts <= GJK_SLIDE_CASTS);
  return result;
}

// Is x within a few LSB of y, or of y and the skin?
static bool is_near(gjk_q16 x, int64_t y, int64_t error) {
  return x >= y - error && x <= y + error;
}

// On a floor, along it, into a wall, into a corner, up a step, and not up two.
static void check_floor(const gjk_shape *shape, gjk_q16 half_width, gjk_q16 half_height) {
  gjk_collider c;
  gjk_slide_setup setup = usual();
  start_scene();
  add_at(0, 0, -ONE, 0);
  add_at(1, 4 * ONE, ONE / 2, 0);
  const gjk_vec3 start = VECTOR(0, half_height, 0), right = VECTOR(2 * ONE, half_height, 0);
  set_walker(&c, shape, start);  // touches the floor
  gjk_slide_result r = walk(&c, right, &setup);
  CHECK(!r.stuck && r.on_ground && !r.stepped && r.ground.normal.y > GJK_Q30_ONE - 8);
  CHECK(is_near(r.position.x, 2 * ONE, 8) && r.position.y > half_height && r.position.y <= half_height + SKIN + 8);
  // Down into the floor and on: it slides.
  const gjk_vec3 down = VECTOR(2 * ONE, -3 * ONE, 0);
  r = walk(&c, down, &setup);
  CHECK(r.on_ground && r.count >= 1 && is_near(r.position.x, 2 * ONE, 8));
  CHECK(r.position.y > half_height + SKIN - 8 && r.position.y <= half_height + SKIN + 8);
  // Into the crate: a wall, higher than a step.
  const gjk_vec3 far = VECTOR(30 * ONE, half_height, 0);
  r = walk(&c, far, &setup);
  CHECK(r.on_ground && !r.stepped && is_near(r.position.x, 4 * ONE - ONE / 2 - half_width - SKIN, 8));
  // With a step as high as the crate it climbs it.
  setup.step = ONE + ONE / 4;
  const gjk_vec3 onto = VECTOR(4 * ONE, half_height, 0);
  r = walk(&c, onto, &setup);
  CHECK(r.on_ground && r.stepped && is_near(r.position.x, 4 * ONE, 16));
  CHECK(is_near(r.position.y, ONE + half_height + SKIN, 8));
  // So it does where a ceiling leaves it less than a whole step.
  const gjk_body_id ceiling = add_at(0, 0, 2 * half_height + 2 * ONE + ONE / 8, 0);
  r = walk(&c, onto, &setup);
  CHECK(r.on_ground && r.stepped && is_near(r.position.x, 4 * ONE, 16));
  CHECK(is_near(r.position.y, ONE + half_height + SKIN, 8));
  CHECK(gjk_scene_remove(&scene, ceiling) == GJK_OK);
  // Up: off the ground.
  const gjk_vec3 high = VECTOR(0, 5 * ONE, 0);
  r = walk(&c, high, &setup);
  CHECK(!r.on_ground && r.count == 0 && is_near(r.position.y, 5 * ONE, 0));
  // With snap it comes down to ground in reach.
  setup.snap = true;
  const gjk_vec3 little = VECTOR(0, half_height + ONE / 10, 0);
  r = walk(&c, little, &setup);
  CHECK(r.on_ground && is_near(r.position.y, half_height + SKIN, 8));
  // In the floor: stuck.
  const gjk_vec3 below = VECTOR(0, -half_height / 2, 0);
  set_walker(&c, shape, below);
  r = walk(&c, right, &setup);
  CHECK(r.stuck && r.position.x == 0 && r.position.y == -half_height / 2);
  // Only what the filter lets through counts.
  const gjk_scene_filter none = {.category = 2, .mask = 2};
  setup.filter = &none;
  r = walk(&c, down, &setup);
  CHECK(!r.stuck && !r.on_ground && r.position.y == -3 * ONE);
}

// Beside a crate that it touches, on either side it goes away by the skin. Between two that leave less it goes on as near.
static void check_beside(const gjk_shape *shape, gjk_q16 half_width, gjk_q16 half_depth) {
  const gjk_slide_setup setup = usual();
  const gjk_vec3 middle = VECTOR(0, 0, 0), high = VECTOR(0, 2 * ONE, 0);
  gjk_collider c;
  set_walker(&c, shape, middle);
  for (int side = -1; side <= 1; side += 2) {
    start_scene();
    add_at(1, side * (half_width + ONE / 2), 0, 0);
    const gjk_slide_result r = walk(&c, middle, &setup);
    CHECK(!r.stuck && is_near(r.position.x, -side * SKIN, 8) && r.position.y == 0);
#if SPACE
    start_scene();
    add_at(1, 0, 0, side * (half_depth + ONE / 2));
    const gjk_slide_result before = walk(&c, middle, &setup);
    CHECK(!before.stuck && before.position.x == 0 && before.position.y == 0);
    CHECK(is_near(before.position.z, -side * SKIN, 8));
#endif
  }
  (void)half_depth;
  for (gjk_q16 gap = SKIN / 2; gap > 0; gap /= 2) {
    start_scene();
    add_at(1, half_width + ONE / 2 + gap, 0, 0);
    add_at(1, -half_width - ONE / 2 - gap, 0, 0);
    const gjk_slide_result r = walk(&c, high, &setup);
    CHECK(!r.stuck && is_near(r.position.x, 0, 8) && is_near(r.position.y, 2 * ONE, 8));
  }
}

// A slope of 45 degrees whose middle is there.
static void add_slope(gjk_q16 x, gjk_q16 y) {
#if SPACE
  const gjk_quat turn = {0, 0, 41421356, 100000000};
#else
  const gjk_quat turn = {100000, 100000};
#endif
  const gjk_vec3 middle = VECTOR(x, y, 0);
  gjk_pose pose = GJK_POSE_IDENTITY;
  pose.position = middle;
  CHECK(gjk_quat_normalize(&turn, &pose.rotation) == GJK_OK);
  start_scene();
  scene_add_shape(&scene, 0, GJK_BODY_STATIC, &pose);
}

// It is ground if the cosine, sqrt(1/2), is at least what is asked for.
static void check_slope(void) {
  const gjk_vec3 start = VECTOR(0, 0, 0);
  gjk_slide_setup setup = usual();
  gjk_collider c;
  setup.reach = ONE;
  add_slope(GJK_Q16(1.2), -GJK_Q16(1.2));
  set_walker(&c, &robot, start);
  for (int sign = -1; sign <= 1; sign += 2) {
    setup.slope = 759250125 + sign * 100;
    const gjk_slide_result r = walk(&c, start, &setup);
    CHECK(r.on_ground == (sign < 0) && !r.stepped && r.count == 0 && r.left.x == 0);
  }
}

// Up a slope, which leads beyond the box that start and end span: under eaves there.
static void check_eaves(void) {
  const gjk_vec3 start = VECTOR(0, 0, 0), to = VECTOR(13 * ONE, 3 * ONE, 0);
  gjk_slide_setup setup = usual();
  gjk_collider c;
  setup.step = setup.reach = 0;
  add_slope(GJK_Q16(11.04), GJK_Q16(1.1));
  add_at(1, GJK_Q16(11.2), GJK_Q16(4.5), 0);
  set_walker(&c, &robot, start);
  const gjk_slide_result r = walk(&c, to, &setup);
  CHECK(r.count == 2 && is_near(r.position.y, 4 * ONE - ONE / 2 - SKIN, 8));
}

// Between two walls that leave so much room beside the skin, or less than it: it goes on along both. The slope at the
// end leads into the upper one.
static void check_corridor(gjk_q16 beside) {
  const gjk_q16 above = 3 * ONE / 2 + SKIN + beside;
  const gjk_vec3 start = VECTOR(0, 0, 0), to = VECTOR(12 * ONE, -9, 0);
  gjk_slide_setup setup = usual();
  gjk_collider c;
  setup.step = setup.reach = 0;
  add_slope(6 * ONE, 0);
  add_at(0, 0, above, 0);
  add_at(0, 0, -above, 0);
  set_walker(&c, &robot, start);
  const gjk_slide_result r = walk(&c, to, &setup);
  CHECK(!r.stuck && r.position.x > 3 * ONE && r.position.x < 6 * ONE);
  CHECK(r.position.y <= above - 3 * ONE / 2 && r.position.y >= 3 * ONE / 2 - above);
}

#if SPACE
// Down between turned crates, all of which it is beside at the end.
static gjk_slide_result walk_down(const gjk_quat *turn, const gjk_vec3 *middle, unsigned crates, gjk_vec3 start,
                                  gjk_vec3 to) {
  gjk_slide_setup setup = usual();
  gjk_collider c;
  uint32_t count = 0;
  setup.step = setup.reach = 0;
  start_scene();
  for (unsigned i = 0; i < crates; i++) {
    gjk_pose pose = GJK_POSE_IDENTITY;
    pose.position = middle[i];
    CHECK(gjk_quat_normalize(&turn[i], &pose.rotation) == GJK_OK);
    scene_add_shape(&scene, 0, GJK_BODY_STATIC, &pose);
  }
  set_walker(&c, &robot, start);
  const gjk_slide_result r = walk(&c, to, &setup);
  CHECK(gjk_collider_move(&c, &r.position) == GJK_OK);
  CHECK(gjk_scene_query_within(&scene, &c, SKIN + 16, NULL, NULL, NULL, 0, &count) == GJK_OK && count == crates);
  return r;
}

// Down into the valley of two steep slopes, and on along it, beside both. Their normals are (-0.8276, 0.3793, 0.4138) and
// (0.9150, 0.3072, -0.2614); the line of both leads along (0.226, -0.162, 0.601).
static void check_valley(void) {
  static const gjk_quat turn[2] = {{30, 0, 60, 100}, {-20, 0, -70, 100}};
  static const gjk_vec3 middle[2] = {{GJK_Q16(0.8276), -GJK_Q16(0.3793), -GJK_Q16(0.4138)},
                                     {-GJK_Q16(0.915), -GJK_Q16(0.3072), GJK_Q16(0.2614)}};
  const gjk_vec3 start = {0, 2 * ONE, 0}, to = {0, -6 * ONE, 0};
  const gjk_slide_result r = walk_down(turn, middle, 2, start, to);
  CHECK(r.count == 2 && r.position.z > ONE);
}

// Down into a pit of three slopes, where no line of two of them leads on.
static void check_pit(void) {
  static const gjk_quat turn[3] = {{0, 0, -866, 1500}, {750, 0, 433, 1500}, {-750, 0, 433, 1500}};
  static const gjk_vec3 middle[3] = {{-GJK_Q16(0.866), -GJK_Q16(0.5), 0},
                                     {GJK_Q16(0.433), -GJK_Q16(0.5), -GJK_Q16(0.75)},
                                     {GJK_Q16(0.433), -GJK_Q16(0.5), GJK_Q16(0.75)}};
  const gjk_vec3 start = {ONE / 8, 6 * ONE, ONE / 16}, to = {ONE / 8, -6 * ONE, ONE / 16};
  const gjk_slide_result r = walk_down(turn, middle, 3, start, to);
  CHECK(r.count == 3 && r.left.x == 0 && r.left.y == 0 && r.left.z == 0);
}
#endif

static gjk_vec3 random_vector(random_state *random, int32_t size) {
  const gjk_vec3 v =
      VECTOR(random_range(random, -size, size), random_range(random, -size, size), random_range(random, -size, size));
  return v;
}

static void build_room(random_state *random) {
  start_scene();
  add_at(0, 0, -ONE, 0);
  for (int i = 1; i < BODIES; i++) {
    gjk_pose pose = GJK_POSE_IDENTITY;
    pose.position = random_vector(random, 4 * ONE);
    pose.position.y = random_range(random, 0, 2 * ONE);
    if (random_below(random, 2) == 0) {
#if SPACE
      const gjk_quat any = {random_range(random, -99, 99), random_range(random, -99, 99), random_range(random, -99, 99),
                            100};
#else
      const gjk_quat any = {100, random_range(random, -99, 99)};
#endif
      CHECK(gjk_quat_normalize(&any, &pose.rotation) == GJK_OK);
    }
    // Casts against a curved shape may have no answer where the ceiling is low.
    scene_add_shape(&scene, (uint16_t)(1 + random_below(random, GJK_ITERATIONS_MAX < 100 ? 2 : 3)), GJK_BODY_STATIC,
                    &pose);
  }
}

static bool touches(const gjk_collider *c, gjk_q16 reach) {
  uint32_t count = 0;
  CHECK(gjk_scene_query_within(&scene, c, reach, NULL, NULL, NULL, 0, &count) == GJK_OK);
  return count > 0;
}

// A random walk in a random room, of several ticks: it starts free, so it is never stuck, and ends free. Where it met
// nothing it got where it wanted.
static void check_walks(random_state *random) {
  gjk_collider c;
  gjk_slide_setup setup = usual();
  build_room(random);
  setup.step = random_below(random, 2) == 0 ? 0 : ONE / 2;
  setup.snap = random_below(random, 2) == 0;
  gjk_vec3 at = random_vector(random, 4 * ONE);
  at.y = random_range(random, ONE, 3 * ONE);
  set_walker(&c, random_below(random, 2) == 0 ? &man : &robot, at);
  if (touches(&c, 0)) {
    stuck_count++;
    return;
  }
  for (int i = 0; i < WALKS; i++) {
    gjk_vec3 way = random_vector(random, random_below(random, 8) == 0 ? 8 * ONE : ONE / 3), to = at;
    way.y = random_below(random, 4) == 0 ? way.y : -ONE / 20;
    to.x += way.x;
    to.y += way.y;
    gjk_slide_result r, again;
    const gjk_status status = gjk_slide(&scene, &c, &to, &setup, &r);
    CHECK(status == GJK_OK || (status == GJK_ERROR_ITERATION_LIMIT && CEILINGS_OPEN_CASTS));
    CHECK(gjk_slide(&scene, &c, &to, &setup, &again) == status);
    CHECK(memcmp(&r.position, &again.position, sizeof r.position) == 0 && r.casts == again.casts);
    CHECK(!r.stuck || status != GJK_OK);
    CHECK(r.casts <= GJK_SLIDE_CASTS && r.count <= GJK_SLIDE_PLANES);
    most_casts = r.casts > most_casts ? r.casts : most_casts;
    CHECK(gjk_collider_move(&c, &r.position) == GJK_OK);
    CHECK_MSG(!touches(&c, 0), "walk %d ends in something", i);
    if (r.count == 0 && !setup.snap && !touches(&c, SKIN)) {
      free_walks++;
    }
    slid += r.count > 0;
    stood += r.on_ground;
    climbed += r.stepped;
    blocked += r.count >= 2;
    at = r.position;
    if (abs(at.x) > 18 * ONE) {
      break;
    }
  }
}

static void check_statuses(void) {
  gjk_collider c, unposed = {0};
  gjk_slide_setup setup = usual();
  gjk_slide_result r;
  gjk_vec3 to = VECTOR(ONE, ONE, 0);
  start_scene();
  set_walker(&c, &robot, to);
  memset(&r, 0x5A, sizeof r);
  const gjk_slide_result untouched = r;
  CHECK(gjk_slide(NULL, &c, &to, &setup, &r) == GJK_ERROR_NULL);
  CHECK(gjk_slide(&scene, NULL, &to, &setup, &r) == GJK_ERROR_NULL);
  CHECK(gjk_slide(&scene, &c, NULL, &setup, &r) == GJK_ERROR_NULL);
  CHECK(gjk_slide(&scene, &c, &to, NULL, &r) == GJK_ERROR_NULL);
  CHECK(gjk_slide(&scene, &c, &to, &setup, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_slide(&scene, &unposed, &to, &setup, &r) == GJK_ERROR_UNINITIALISED);
#define REFUSED(field, value, status) \
  setup = usual();                    \
  setup.field = value;                \
  CHECK(gjk_slide(&scene, &c, &to, &setup, &r) == status)
  REFUSED(slope, -1, GJK_ERROR_RANGE);
  REFUSED(slope, GJK_Q30_ONE + 1, GJK_ERROR_RANGE);
  REFUSED(skin, GJK_SLIDE_SKIN_MIN - 1, GJK_ERROR_RANGE);
  REFUSED(skin, ONE + 1, GJK_ERROR_RANGE);
  REFUSED(step, -1, GJK_ERROR_RANGE);
  REFUSED(step, GJK_RADIUS_MAX + 1, GJK_ERROR_RANGE);
  REFUSED(reach, -1, GJK_ERROR_RANGE);
  REFUSED(reach, GJK_RADIUS_MAX + 1, GJK_ERROR_RANGE);
  REFUSED(up.y, GJK_Q30_ONE / 2, GJK_ERROR_ROTATION);
  REFUSED(up.x, INT32_MIN, GJK_ERROR_ROTATION);
#undef REFUSED
  for (unsigned long_ones = 1; long_ones < (SPACE ? 8 : 4); long_ones++) {  // whose squares would leave 64 bits
    setup = usual();
    setup.up.x = (long_ones & 1) != 0 ? INT32_MIN : 0;
    setup.up.y = (long_ones & 2) != 0 ? INT32_MIN : 0;
#if SPACE
    setup.up.z = (long_ones & 4) != 0 ? INT32_MIN : 0;
#endif
    CHECK(gjk_slide(&scene, &c, &to, &setup, &r) == GJK_ERROR_ROTATION);
  }
  CHECK(memcmp(&r, &untouched, sizeof r) == 0);
  setup = usual();
  setup.slope = GJK_Q30_ONE;
  setup.skin = ONE;
  setup.step = setup.reach = GJK_RADIUS_MAX;
  CHECK(gjk_slide(&scene, &c, &to, &setup, &r) == GJK_OK);
  const unsigned with_ground = r.casts;
  setup.reach = 0;  // no cast looks for ground
  CHECK(gjk_slide(&scene, &c, &to, &setup, &r) == GJK_OK && r.casts + 1u == with_ground && !r.on_ground);
  setup.slope = setup.step = 0;
  setup.skin = GJK_SLIDE_SKIN_MIN;
  const gjk_vec3 far = VECTOR((1 << 30) - ONE, ONE - (1 << 30), (1 << 30) - ONE);
  set_walker(&c, &robot, far);
  CHECK(gjk_slide(&scene, &c, &far, &setup, &r) == GJK_OK && r.count == 0 && r.position.y == far.y);
  set_walker(&c, &robot, to);
  memset(&r, 0x5A, sizeof r);
  setup = usual();
  to.x += 1 << 29;
  CHECK(gjk_slide(&scene, &c, &to, &setup, &r) == GJK_ERROR_RANGE);
  to.x = INT32_MAX;
  CHECK(gjk_slide(&scene, &c, &to, &setup, &r) == GJK_ERROR_RANGE);
  CHECK(memcmp(&r, &untouched, sizeof r) == 0);
}

int main(void) {
  random_state random = random_seed(check_seed(SEED));
  check_statuses();
  if (!CEILINGS_OPEN_CASTS) {
    check_floor(&robot, ONE / 3, ONE / 2);
    check_beside(&robot, ONE / 3, ONE / 4);
    check_floor(&man, GJK_Q16(0.3), GJK_Q16(0.8));
    check_beside(&man, GJK_Q16(0.3), GJK_Q16(0.3));
    check_slope();
    check_eaves();
#if SPACE
    check_valley();
    check_pit();
#endif
    for (gjk_q16 beside = -SKIN / 2; beside < 4; beside += beside < 0 ? SKIN / 2 : 1) {
      check_corridor(beside);
    }
  }
  for (unsigned i = 0; i < ROOMS; i++) {
    check_trial(i, NULL, NULL);
    check_walks(&random);
  }
  printf("%lu slid, %lu along more than one, %lu stood, %lu climbed, %lu free, %lu rooms full; at most %u casts\n",
         slid, blocked, stood, climbed, free_walks, stuck_count, most_casts);
  CHECK((slid > 300 && blocked > 50 && stood > 200 && climbed > 5 && free_walks > 100) || CEILINGS_OPEN_CASTS ||
        !check_is_full());
  return check_done(TEST_NAME);
}
