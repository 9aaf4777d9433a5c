// Nothing tunnels: thousands of small fast bodies against walls of a few LSB, which stand or come towards them, and rods
// that spin. Each that must hit is reported, with the fraction of a cast or time of impact of that pair.
//
// What must hit is known twice: from an exact query of each pair, and, without any, from poses in between at which
// gjk_within says yes, or from a way that leads through a wall which is far wider than the way is off.
#include <stdlib.h>
#include <string.h>

#include "ceilings.h"
#include "check.h"
#include "random.h"

// The test of the plane has included the plane's.
#ifndef TEST_NAME
#include "gjk/cast.h"
#include "gjk/gjk.h"
#include "gjk/impact.h"
#include "gjk/scene.h"
#define TEST_NAME "scene_bullets"
#define SPACE 1
#endif

#include "placed.h"
#include "scene_bodies.h"

#define SEED 7780
#define VOLLEYS check_trials(16)
#define WALLS 12
#define BULLETS 200
#define BODIES (WALLS + BULLETS)
#define ONE GJK_Q16_ONE
#define APART (8 * ONE)  // of walls

#if SPACE
#define VECTOR(x, y, z) \
  { x, y, z }
static const gjk_vec3 splinter[4] = {{-3000, 0, 0}, {4000, 500, -700}, {0, 900, 800}, {200, -1500, 300}};
static const gjk_shape sheet = GJK_BOX(2, 40 * ONE, 40 * ONE), board = GJK_BOX(200, 40 * ONE, 40 * ONE);
static const gjk_shape foil = GJK_BOX(0, 40 * ONE, 40 * ONE), ball = GJK_SPHERE(GJK_Q16(0.02)), speck = GJK_POINT;
static const gjk_shape pellet = GJK_BOX(700, 500, 900), shard = GJK_HULL(splinter, 4);
static const gjk_shape pill = GJK_CAPSULE(GJK_Q16(0.01), GJK_Q16(0.03));
static const gjk_shape rod = GJK_CAPSULE(GJK_Q16(0.01), GJK_Q16(1.0)), stave = GJK_BOX(300, ONE, 300);
#else
#define VECTOR(x, y, z) \
  { x, y }
static const gjk_vec3 splinter[4] = {{-3000, -200}, {4000, -500}, {2000, 900}, {-1500, 700}};
static const gjk_shape sheet = GJK2_BOX(2, 40 * ONE), board = GJK2_BOX(200, 40 * ONE), foil = GJK2_BOX(0, 40 * ONE);
static const gjk_shape ball = GJK2_CIRCLE(GJK_Q16(0.02)), speck = GJK2_POINT, pellet = GJK2_BOX(700, 500);
static const gjk_shape shard = GJK2_POLYGON(splinter, 4), pill = GJK2_CAPSULE(GJK_Q16(0.01), GJK_Q16(0.03));
static const gjk_shape rod = GJK2_CAPSULE(GJK_Q16(0.01), GJK_Q16(1.0)), stave = GJK2_BOX(300, ONE);
#endif

static const gjk_shape *const shapes[] = {&sheet, &board, &foil, &ball, &speck, &pellet, &shard, &pill, &rod, &stave};
enum { FIRST_BULLET = 3, FIRST_ROD = 8, SHAPES = 10 };

typedef struct thing {
  gjk_body_id id;
  uint16_t shape;
  gjk_pose from, to;
  bool turns;
} thing;

static thing things[BODIES];
static gjk_scene scene;
static gjk_report reports[4 * BODIES];
static const gjk_report *impact_of[BODIES];
static unsigned long hits, turning_hits, moving_hits, through, sampled, misses, starts;

static void collider_at(const thing *t, const gjk_pose *pose, gjk_collider *c) {
  *c = posed(shapes[t->shape], pose);
}

static gjk_pose random_pose(random_state *random, int32_t x, int32_t spread, bool turned) {
  gjk_pose pose = GJK_POSE_IDENTITY;
  const gjk_vec3 p = VECTOR(x, random_range(random, -spread, spread), random_range(random, -spread, spread));
  pose.position = p;
  if (turned) {
#if SPACE
    const gjk_quat any = {random_range(random, -999, 999), random_range(random, -999, 999),
                          random_range(random, -999, 999), 300};
#else
    const gjk_quat any = {random_range(random, -999, 999), random_range(random, -999, 999) | 1};
#endif
    CHECK(gjk_quat_normalize(&any, &pose.rotation) == GJK_OK);
  }
  return pose;
}

// Walls stand across x, each at its place. Some move towards the bullets, by half the room between two of them.
static void place_walls(random_state *random) {
  for (int i = 0; i < WALLS; i++) {
    thing *t = &things[i];
    t->shape = (uint16_t)random_below(random, FIRST_BULLET);
    t->from = random_pose(random, i * APART, 0, false);
    t->to = t->from;
    t->turns = false;
    if (i % 3 == 1) {
      t->to.position.x -= APART / 2;
    } else if (i % 3 == 2) {
      t->to.position.y += 777;
    }
  }
}

// Bullets fly along x, mostly; rods turn beside a wall or on their way.
static void place_bullets(random_state *random) {
  for (int i = WALLS; i < BODIES; i++) {
    thing *t = &things[i];
    const bool long_one = random_below(random, 3) == 0;
    const int32_t near = (int32_t)random_below(random, WALLS) * APART;
    t->shape = (uint16_t)(long_one ? FIRST_ROD + random_below(random, SHAPES - FIRST_ROD)
                                   : FIRST_BULLET + random_below(random, FIRST_ROD - FIRST_BULLET));
    t->turns = long_one || random_below(random, 3) == 0;
    t->from = random_pose(random, near - random_range(random, 1, long_one ? ONE : 3 * ONE), 8 * ONE, true);
    t->to = random_pose(random, t->from.position.x, 0, true);
    t->to.position = t->from.position;
    if (!t->turns) {
      t->to.rotation = t->from.rotation;
    }
    if (!long_one || random_below(random, 2) == 0) {
      t->to.position.x += random_range(random, -ONE, 30 * ONE);
      t->to.position.y += random_range(random, -ONE, ONE);
    }
  }
}

static void start_scene(void *block, size_t bytes, const gjk_scene_config *config) {
  const gjk_scene_bindings bindings = {.motion = &gjk_scene_motion};
  CHECK(gjk_scene_init(&scene, config, block, bytes, shapes, SHAPES, &bindings) == GJK_OK);
  for (uint32_t i = 0; i < BODIES; i++) {
    const bool wall = i < WALLS, moving = wall && i % 3 != 0;
    const gjk_part part = {things[i].shape, false, GJK_POSE_IDENTITY};
    gjk_body_setup setup = {0};
    setup.pose = things[i].from;
    setup.parts = &part;
    setup.part_count = 1;
    setup.kind = (uint8_t)(!wall ? GJK_BODY_DYNAMIC : moving ? GJK_BODY_KINEMATIC : GJK_BODY_STATIC);
    setup.category = wall ? 1 : 2;
    setup.mask = wall ? UINT32_MAX : 1;
    CHECK(gjk_scene_add_at(&scene, i, &setup, &things[i].id) == GJK_OK);
    const gjk_status status = gjk_scene_set_motion(&scene, things[i].id, wall ? GJK_MOTION_KEPT : GJK_MOTION_FAST);
    CHECK(status == (wall && !moving ? GJK_ERROR_RANGE : GJK_OK));
  }
}

static uint32_t update(void) {
  return scene_update(&scene, reports, 4 * BODIES);
}

// Where a bullet meets a wall, by the query of that pair alone. *open: it has no answer, where the ceiling is low.
static bool meets(const thing *wall, const thing *bullet, uint32_t *fraction, bool *at_start, bool *open) {
  gjk_collider a, b;
  collider_at(wall, &wall->from, &a);
  collider_at(bullet, &bullet->from, &b);
  if (!bullet->turns || bullet->shape == 3 || bullet->shape == 4) {  // a ball and a speck do not turn
    const gjk_cast_path path = {&wall->to.position, &bullet->to.position, 0};
    gjk_cast_result result;
    const gjk_status status = gjk_cast(&a, &b, &path, &result);
    *open = *open || (status == GJK_ERROR_ITERATION_LIMIT && CEILINGS_OPEN_CASTS);
    CHECK(status == GJK_OK || *open);
    if (status != GJK_OK) {
      return false;
    }
    *fraction = result.hit ? (uint32_t)result.fraction : 0;
    *at_start = result.hit && result.inside;
    return result.hit;
  }
  gjk_motion of_a = {0}, of_b;
  of_b = of_a;
  of_a.from = wall->from;
  of_a.to = wall->to;
  of_b.from = bullet->from;
  of_b.to = bullet->to;
#if SPACE
  const gjk_impact_setup setup = {0, GJK_IMPACT_TOLERANCE_MIN, 0};
#else
  const gjk_impact_setup setup = {0, GJK2_IMPACT_TOLERANCE_MIN, 0};
#endif
  gjk_impact_result result;
  const gjk_status status = gjk_time_of_impact(&a, &of_a, &b, &of_b, &setup, &result);
  *open = *open || (status == GJK_ERROR_ITERATION_LIMIT && GJK_ITERATIONS_MAX < 100);
  CHECK(status == GJK_OK || *open);
  *fraction = (uint32_t)result.lower;
  *at_start = result.lower == 0;
  return result.hit;
}

// The first wall that a bullet meets, and where.
static int first_wall(const thing *bullet, uint32_t *fraction, bool *open) {
  int first = -1;
  for (int i = 0; i < WALLS; i++) {
    uint32_t here;
    bool at_start;
    if (!meets(&things[i], bullet, &here, &at_start, open)) {
      misses++;
    } else if (at_start && here == 0) {
      starts++;  // was near at the update before
    } else if (first < 0 || here < *fraction) {
      first = i;
      *fraction = here;
    }
  }
  return first;
}

static int32_t between(int32_t from, int32_t to, int i, int n) {
  return (int32_t)(from + ((int64_t)to - from) * i / n);
}

// Poses in between, without the queries of motion: where bullet and wall share a point, an impact was not later. Turning
// bodies are sampled by steps of their own, so only those that do not turn are.
static void check_samples(const thing *bullet, const gjk_report *impact) {
  enum { STEPS = 40 };
  gjk_collider a, b;
  gjk_decision decision = {0};
  for (int w = 0; w < WALLS && !bullet->turns; w++) {
    collider_at(&things[w], &things[w].from, &a);
    collider_at(bullet, &bullet->from, &b);
    CHECK(gjk_within(&a, &b, 0, NULL, &decision) == GJK_OK);
    for (int i = 1; i <= STEPS && !decision.yes; i++) {
      gjk_vec3 at_a = things[w].from.position, at_b = bullet->from.position;
      at_a.x = between(at_a.x, things[w].to.position.x, i, STEPS);
      at_a.y = between(at_a.y, things[w].to.position.y, i, STEPS);
      at_b.x = between(at_b.x, bullet->to.position.x, i, STEPS);
      at_b.y = between(at_b.y, bullet->to.position.y, i, STEPS);
      CHECK(gjk_collider_move(&a, &at_a) == GJK_OK && gjk_collider_move(&b, &at_b) == GJK_OK);
      CHECK(gjk_within(&a, &b, 0, NULL, &decision) == GJK_OK);
      if (decision.yes) {
        sampled++;
        // Rounding of places in between: 1 LSB of a way of at least an LSB a step.
        CHECK_MSG(impact != NULL && impact->fraction <= (gjk_q30)(((int64_t)GJK_Q30_ONE * i + 65536) / STEPS + 65536),
                  "bullet %u, wall %d", bullet->id.slot, w);
      }
    }
  }
}

// A way whose ends are a unit and more on either side of a wall, at both times, leads through it: walls are 80 units wide.
static void check_through(const thing *bullet, const gjk_report *impact) {
  for (int w = 0; w < WALLS; w++) {
    if (bullet->from.position.x + ONE + ONE / 4 < things[w].from.position.x &&
        bullet->to.position.x - ONE - ONE / 4 > things[w].to.position.x) {
      CHECK_MSG(impact != NULL, "bullet %u went through wall %d", bullet->id.slot, w);
      through++;
    }
  }
}

static void check_volley(random_state *random, void *block, size_t bytes, const gjk_scene_config *config) {
  place_walls(random);
  place_bullets(random);
  start_scene(block, bytes, config);
  update();
  for (int i = 0; i < BODIES; i++) {
    if (i >= WALLS || i % 3 != 0) {
      CHECK(gjk_scene_move(&scene, things[i].id, &things[i].to) == GJK_OK);
    }
  }
  const uint32_t count = update();
  memset(impact_of, 0, sizeof impact_of);
  uint32_t last = 0;
  for (uint32_t i = 0; i < count; i++) {
    if (reports[i].event == GJK_EVENT_IMPACT) {
      CHECK(reports[i].a.slot > last && reports[i].b.slot < WALLS);
      last = reports[i].a.slot;
      impact_of[last] = &reports[i];
    }
  }
  for (int i = WALLS; i < BODIES; i++) {
    const gjk_report *impact = impact_of[i];
    uint32_t fraction = 0;
    bool open = false;
    const int wall = first_wall(&things[i], &fraction, &open);
    CHECK_MSG(open || (impact != NULL) == (wall >= 0), "bullet %d, wall %d", i, wall);
    if (impact != NULL && wall >= 0 && !open) {
      CHECK_MSG(impact->fraction == (gjk_q30)fraction && impact->b.slot == (uint32_t)wall,
                "bullet %d: wall %u at %d, expected wall %d at %u", i, impact->b.slot, impact->fraction, wall,
                fraction);
      hits++;
      turning_hits += things[i].turns;
      moving_hits += wall % 3 != 0;
    }
    check_samples(&things[i], impact);
    check_through(&things[i], impact);
  }
  CHECK(gjk_scene_check(&scene) == GJK_OK);
  const uint32_t still = update();  // nobody moved
  for (uint32_t i = 0; i < still; i++) {
    CHECK(reports[i].event != GJK_EVENT_IMPACT);
  }
}

int main(void) {
  const gjk_scene_config config = {
      .bodies = BODIES, .parts = BODIES, .pairs = 40 * BODIES, .box_margin = ONE / 8, .motions = BODIES};
  const size_t bytes = gjk_scene_bytes(&config);
  void *block = malloc(bytes);
  random_state random = random_seed(check_seed(SEED));
  for (unsigned i = 0; i < VOLLEYS; i++) {
    check_trial(i, NULL, NULL);
    check_volley(&random, block, bytes, &config);
  }
  free(block);
  printf("%lu hits, %lu turning, %lu of walls that move; %lu through, %lu sampled, %lu misses, %lu at the start\n",
         hits, turning_hits, moving_hits, through, sampled, misses, starts);
  CHECK((hits > 1000 && turning_hits > 300) || GJK_ITERATIONS_MAX < 100 || CEILINGS_OPEN_CASTS || !check_is_full());
  CHECK(((moving_hits > 300 || CEILINGS_OPEN_CASTS) && through > 1000 && sampled > 100 && misses > 1000) ||
        !check_is_full());
  return check_done(TEST_NAME);
}
