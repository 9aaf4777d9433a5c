// Scenes of the plane: bodies that fall and rest, on a floor or on ground of boxes.
#define FLAT_BODIES 2400
#define FLAT_POINTS 24000
#define ITERATIONS 45

#include <stdlib.h>
#include <string.h>

#include "random.h"
#include "rest.h"
#include "tests/programs/demo_plane/flat_solver.c"

#define FLOOR 0
#define SIDE 1
#define CRATE 2
#define KINDS 5  // from CRATE on

static const gjk2_vec pentagon[] = {{32000, 0}, {9900, 30400}, {-25900, 18800}, {-25900, -18800}, {9900, -30400}};
static const gjk2_shape slab = GJK2_BOX(GJK_Q16(100.0), GJK_Q16(1.0)), side = GJK2_BOX(GJK_Q16(1.0), GJK_Q16(80.0)),
                        crate = GJK2_BOX(GJK_Q16(0.5), GJK_Q16(0.5)), plank = GJK2_BOX(GJK_Q16(0.7), GJK_Q16(0.3)),
                        disc = GJK2_CIRCLE(GJK_Q16(0.45)), pill = GJK2_CAPSULE(GJK_Q16(0.3), GJK_Q16(0.4)),
                        gem = GJK2_POLYGON(pentagon, 5);
static const gjk2_shape *const shapes[REST_SHAPES] = {&slab, &side, &crate, &plank, &disc, &pill, &gem};

static void add(rest_stage *s, uint8_t shape, bool fixed, int32_t x, int32_t y) {
  const gjk2_pose none = GJK2_POSE_IDENTITY;
  gjk2_pose *pose = (gjk2_pose *)s->poses + s->bodies;
  s->body[s->bodies].shape = shape;
  s->body[s->bodies].fixed = fixed;
  s->bodies++;
  *pose = none;
  pose->position.x = x;
  pose->position.y = y;
}

static void add_pyramid(rest_stage *s, int32_t base) {
  for (int32_t row = 0; row < base; row++) {
    for (int32_t i = 0; i < base - row; i++) {
      add(s, CRATE, false, (2 * i + row - base) * (ONE * 21 / 40), ONE / 2 + row * ONE);
    }
  }
}

// Bodies of all kinds in rows, so many in each.
static void add_rain(rest_stage *s, int32_t across, int32_t count, int32_t lowest) {
  random_state random = random_seed(12);
  for (int32_t i = 0; i < count; i++) {
    const int32_t x = (2 * (i % across) + 1 - across) * (ONE * 3 / 4), y = lowest + i / across * (ONE * 3 / 2);
    add(s, (uint8_t)(CRATE + random_below(&random, KINDS)), false, x + random_range(&random, -ONE / 20, ONE / 20), y);
  }
}

bool rest_build_plane(unsigned number, rest_stage *s) {
  static const struct {
    const char *name;
    unsigned before;
  } stages[] = {{"plane: pyramid of 1830", 200},
                {"plane: 2000 mixed, falling", 50},
                {"plane: 2000 mixed, at rest", 550},
                {"plane: 400 on ground of boxes", 300}};
  memset(s, 0, sizeof *s);
  if (number >= sizeof stages / sizeof stages[0]) {
    return false;
  }
  s->name = stages[number].name;
  s->before = stages[number].before;
  s->plane = true;
  s->poses = calloc((size_t)REST_BODIES * (REST_TICKS + 1), sizeof(gjk2_pose));
  for (unsigned i = 0; i < REST_SHAPES; i++) {
    s->shape[i] = shapes[i];
  }
  if (s->poses == NULL) {
    return false;
  }
  if (number < 3) {
    add(s, FLOOR, true, 0, -ONE);
  }
  if (number == 0) {
    add_pyramid(s, 60);
    return true;
  }
  const int32_t across = number == 3 ? 100 : 50;
  for (int sign = -1; sign <= 1; sign += 2) {
    add(s, SIDE, true, sign * (across * (ONE * 3 / 4) + ONE), 70 * ONE);
  }
  random_state random = random_seed(13);
  for (int32_t i = 0; number == 3 && i < 152; i++) {
    add(s, CRATE, true, (i - 76) * ONE, -ONE / 2 - random_range(&random, 0, ONE / 8));
  }
  add_rain(s, across, number == 3 ? 400 : 2000, ONE);
  return true;
}

bool rest_record_plane(rest_stage *s) {
  gjk2_pose *poses = s->poses;
  flat_world *w = calloc(1, sizeof *w);
  for (unsigned i = 0; i < s->bodies; i++) {
    const int32_t mass = s->body[i].fixed ? 0 : ONE;
    (void)flat_add(w, s->shape[s->body[i].shape], poses[i].position, 0, mass, s->body[i].fixed ? 0 : ONE / 6);
  }
  for (unsigned tick = 0; tick < s->before; tick++) {
    flat_step(w);
  }
  for (unsigned frame = 0; frame <= REST_TICKS; frame++) {
    for (unsigned i = 0; i < s->bodies; i++) {
      poses[frame * s->bodies + i] = w->body[i].pose;
    }
    flat_step(w);
  }
  const bool fits = w->points[w->now] < FLAT_POINTS;
  free(w);
  return fits;
}
