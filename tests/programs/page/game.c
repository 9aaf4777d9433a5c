// The platform game: the example itself, and its debug drawing.
#define PLATFORM_IS_MEASURED
#include "game.h"

#include "gjk2/draw.h"
#include "tests/programs/examples/platform.c"

#define RECORDS 2048
#define FIELDS 5
#define RUNNER 100
#define GROUND 101

static int32_t records[RECORDS * FIELDS];
static uint32_t count;
static int now;
static bool jumps;

static void add_record(int32_t role, const gjk2_vec *from, const gjk2_vec *to) {
  if (count < RECORDS) {
    int32_t *out = &records[FIELDS * count++];
    out[0] = role;
    out[1] = from->x;
    out[2] = from->y;
    out[3] = to->x;
    out[4] = to->y;
  }
}

static void add_line(void *user, const gjk2_vec *from, const gjk2_vec *to, gjk_draw_role role) {
  const int32_t *other = user;
  add_record(other != NULL ? *other : (int32_t)role, from, to);
}

static void add_segment(void *user, const gjk2_vec *from, const gjk2_vec *to, uint32_t segment) {
  (void)user;
  (void)segment;
  add_record(GROUND, from, to);
}

int page_game_start(void) {
  now = 0;
  rise = 0;
  jumps = false;
  for (int i = 0; i < BODIES; i++) {
    speed[i] = 0;
  }
  return start();
}

void page_game_jump(void) {
  jumps = true;
}

int page_game_tick(void) {
  if (jumps && rise == -300) {  // as tick() leaves it on the ground
    rise = 9000;
  }
  jumps = false;
  return tick(now++);
}

uint64_t page_game_hash(void) {
  uint64_t hash = 0;
  (void)gjk2_scene_hash(&scene, &hash);
  return (hash ^ (uint32_t)runner.position.x) * UINT64_C(0x100000001b3) ^ (uint32_t)runner.position.y;
}

uint32_t page_game_look(void) {
  static const int32_t of_runner = RUNNER;
  static const gjk2_aabb all = {{0, 0}, {GJK_Q16(40), GJK_Q16(3)}};
  const gjk2_draw bodies = {add_line, NULL, NULL}, self = {add_line, NULL, (void *)&of_runner};
  count = 0;
  (void)gjk2_ground_visit(&ground, &pose[LEVEL], &all, add_segment, NULL);
  (void)gjk2_draw_scene(&bodies, &scene, GJK_DRAW_SHAPES);
  (void)gjk2_draw_collider(&self, &runner, GJK_DRAW_MOVING);
  return count;
}

const int32_t *page_game_records(void) {
  return records;
}
