// Drawing of parts and of a scene's concave bodies, against every part one by one: those with a point in a box are drawn, those
// whose boxes do not meet it are not; as many as fit, in an order that does not depend on how many; and what is refused.
#include <string.h>

#include "check.h"
#include "gjk/draw.h"
#include "gjk/gjk.h"
#include "placed.h"
#include "reference/random_shape.h"
#include "scene/concave_world.h"

#define SEED 9301
#define TRIALS check_trials(60)
#define LINES 60000
#define ONE GJK_Q16_ONE

static concave_world world;
static gjk_scene scene;
static uint32_t block[4000];

typedef struct drawing {
  gjk_vec3 from[LINES], to[LINES];
  unsigned lines;
  gjk_draw_role role;
} drawing;

static drawing drawn, other, of_one;
static struct { unsigned long drawn, in, out, holes, cut; } tally;

static void take_line(void *user, const gjk_vec3 *from, const gjk_vec3 *to, gjk_draw_role role) {
  drawing *d = user;
  CHECK(d->lines < LINES);
  if (d->lines < LINES) {
    d->from[d->lines] = *from;
    d->to[d->lines++] = *to;
    d->role = role;
  }
}

static gjk_draw to(drawing *d) {
  const gjk_draw draw = {take_line, NULL, d};
  d->lines = 0;
  return draw;
}

// Is what was drawn of one part among the lines?
static bool has_part(void) {
  for (unsigned k = 0; k + of_one.lines <= drawn.lines; k++) {
    if (memcmp(&drawn.from[k], of_one.from, of_one.lines * sizeof *of_one.from) == 0 &&
        memcmp(&drawn.to[k], of_one.to, of_one.lines * sizeof *of_one.to) == 0) {
      return true;
    }
  }
  return false;
}

static bool boxes_meet(const gjk_aabb *a, const gjk_aabb *b) {
  return a->lower.x <= b->upper.x && b->lower.x <= a->upper.x && a->lower.y <= b->upper.y && b->lower.y <= a->upper.y &&
         a->lower.z <= b->upper.z && b->lower.z <= a->upper.z;
}

// As many as there are at least and at most, by every part.
static void check_parts(random_state *random, const gjk_parts *parts, const gjk_aabb *near) {
  const gjk_shape cube = GJK_BOX((near->upper.x - near->lower.x) / 2, (near->upper.y - near->lower.y) / 2,
                                 (near->upper.z - near->lower.z) / 2);
  gjk_pose middle = GJK_POSE_IDENTITY;
  uint32_t count = 0, fewer = 0, least = 0, most = 0;
  const gjk_draw out = to(&drawn);
  CHECK(gjk_draw_parts(&out, parts, near, UINT32_MAX, GJK_DRAW_SENSOR, &count) == GJK_OK);
  CHECK(count == 0 || drawn.role == GJK_DRAW_SENSOR);
  middle.position = (gjk_vec3){near->lower.x + cube.size.x, near->lower.y + cube.size.y, near->lower.z + cube.size.z};
  const gjk_collider box = posed(&cube, &middle);
  for (uint32_t i = 0; i < gjk_parts_count(parts); i++) {
    gjk_parts_room room;
    gjk_collider c;
    gjk_aabb own;
    gjk_decision in = {0};
    if (gjk_parts_place(parts, i, &room, &c) != GJK_OK) {
      tally.holes++;
      continue;
    }
    CHECK(gjk_collider_aabb(&c, &own) == GJK_OK && gjk_intersect(&c, &box, NULL, &in) == GJK_OK);
    const gjk_draw one = to(&of_one);
    CHECK(gjk_draw_collider(&one, &c, GJK_DRAW_SENSOR) == GJK_OK);
    CHECK(!in.yes || has_part());
    least += in.yes;
    most += boxes_meet(&own, near);
  }
  CHECK_MSG(count >= least && count <= most, "%lu of %lu to %lu", (unsigned long)count, (unsigned long)least,
            (unsigned long)most);
  tally.drawn += count;
  tally.in += least > 0;
  tally.out += most == 0;
  if (count > 0) {
    const uint32_t some = random_below(random, count);
    const gjk_draw few = to(&other);
    CHECK(gjk_draw_parts(&few, parts, near, some, GJK_DRAW_SENSOR, &fewer) == GJK_ERROR_CAPACITY && fewer == some);
    CHECK(other.lines <= drawn.lines && memcmp(other.from, drawn.from, other.lines * sizeof *other.from) == 0);
    const gjk_draw all = to(&other);
    CHECK(gjk_draw_parts(&all, parts, near, count, GJK_DRAW_SENSOR, NULL) == GJK_OK && other.lines == drawn.lines);
    tally.cut++;
  }
}

static void check_scene(random_state *random, const gjk_aabb *near) {
  static const gjk_shape *shapes[CONCAVE_BODIES + 1];
  const gjk_scene_config config = {.bodies = CONCAVE_BODIES + 2, .parts = CONCAVE_BODIES + 1, .pairs = 1};
  uint32_t count = 0, sum = 0, fewer = 0;
  unsigned lines = 0;
  CHECK(gjk_scene_bytes(&config) <= sizeof block);
  for (uint16_t i = 0; i < CONCAVE_BODIES; i++) {
    shapes[i] = &world.body[i].shape;
  }
  shapes[CONCAVE_BODIES] = &world.mover[0];
  CHECK(gjk_scene_init(&scene, &config, block, sizeof block, shapes, CONCAVE_BODIES + 1, NULL) == GJK_OK);
  for (uint16_t i = 0; i <= CONCAVE_BODIES; i++) {
    const gjk_part part = {i, false, GJK_POSE_IDENTITY};
    gjk_body_setup setup = {GJK_POSE_IDENTITY, &part, 1, GJK_BODY_STATIC, 0, 1, 1, i, 0};
    gjk_body_id id;
    uint32_t of_body = 0;
    if (i < CONCAVE_BODIES) {
      setup.pose = world.body[i].parts.pose;
      const gjk_draw out = to(&other);
      CHECK(gjk_draw_parts(&out, &world.body[i].parts, near, UINT32_MAX, GJK_DRAW_STATIC, &of_body) == GJK_OK);
      sum += of_body;
      lines += other.lines;
    }
    CHECK(gjk_scene_add(&scene, &setup, &id) == GJK_OK);
  }
  const gjk_draw out = to(&drawn);
  CHECK(gjk_draw_scene_concave(&out, &scene, near, UINT32_MAX, GJK_DRAW_STATIC, &count) == GJK_OK);
  CHECK(count == sum && drawn.lines == lines);
  // The other query draws the convex part alone. One slot has no body.
  gjk_collider mover;
  gjk_body_id last;
  const gjk_draw alone = to(&of_one);
  CHECK(gjk_scene_body_at(&scene, CONCAVE_BODIES, &last) == GJK_OK);
  CHECK(gjk_scene_collider(&scene, last, 0, &mover) == GJK_OK);
  CHECK(gjk_draw_collider(&alone, &mover, GJK_DRAW_STATIC) == GJK_OK);
  const gjk_draw convex = to(&other);
  CHECK(gjk_draw_scene(&convex, &scene, GJK_DRAW_SHAPES) == GJK_OK && other.lines == of_one.lines);
  if (sum > 0) {
    const uint32_t some = random_below(random, sum);
    const gjk_draw few = to(&other);
    CHECK(gjk_draw_scene_concave(&few, &scene, near, some, GJK_DRAW_STATIC, &fewer) == GJK_ERROR_CAPACITY);
    CHECK(fewer == some && memcmp(other.from, drawn.from, other.lines * sizeof *other.from) == 0);
  }
}

static void check_refused(void) {
  static const gjk_aabb inverted = {{1, 0, 0}, {0, 1, 1}};
  const gjk_parts *parts = &world.body[0].parts;
  gjk_parts bad = *parts;
  uint32_t count = 77;
  const gjk_draw out = to(&drawn), nothing = {NULL, NULL, NULL};
  CHECK(gjk_draw_parts(NULL, parts, NULL, 9, GJK_DRAW_STATIC, &count) == GJK_ERROR_NULL);
  CHECK(gjk_draw_parts(&out, NULL, NULL, 9, GJK_DRAW_STATIC, &count) == GJK_ERROR_NULL);
  CHECK(gjk_draw_parts(&out, parts, &inverted, 9, GJK_DRAW_STATIC, &count) == GJK_ERROR_RANGE);
  bad.pose.rotation.w = bad.pose.rotation.x = bad.pose.rotation.y = bad.pose.rotation.z = 0;
  CHECK(gjk_draw_parts(&out, &bad, NULL, 9, GJK_DRAW_STATIC, &count) == GJK_ERROR_ROTATION);
  CHECK(gjk_draw_scene_concave(NULL, &scene, NULL, 9, GJK_DRAW_STATIC, &count) == GJK_ERROR_NULL);
  CHECK(gjk_draw_scene_concave(&out, NULL, NULL, 9, GJK_DRAW_STATIC, &count) == GJK_ERROR_NULL);
  CHECK(gjk_draw_scene_concave(&out, &scene, &inverted, 9, GJK_DRAW_STATIC, &count) == GJK_ERROR_RANGE);
  CHECK(count == 77 && drawn.lines == 0);
  for (int axis = 0; axis < 3; axis++) {  // a box may be flat
    const gjk_aabb flat = {{0, 0, 0}, {axis != 0, axis != 1, axis != 2}};
    CHECK(gjk_draw_parts(&nothing, parts, &flat, UINT32_MAX, GJK_DRAW_STATIC, NULL) == GJK_OK);
    CHECK(gjk_draw_scene_concave(&nothing, &scene, &flat, UINT32_MAX, GJK_DRAW_STATIC, NULL) == GJK_OK);
  }
  CHECK(gjk_draw_parts(&out, parts, NULL, UINT32_MAX, GJK_DRAW_STATIC, &count) == GJK_OK);
  CHECK(count == gjk_parts_count(parts) && drawn.lines > 0);  // no box: all
  CHECK(gjk_draw_parts(&nothing, parts, NULL, UINT32_MAX, GJK_DRAW_STATIC, NULL) == GJK_OK);
  CHECK(gjk_draw_scene_concave(&nothing, &scene, NULL, UINT32_MAX, GJK_DRAW_STATIC, NULL) == GJK_OK);
  block[0] ^= 1;
  CHECK(gjk_draw_scene_concave(&out, &scene, NULL, 9, GJK_DRAW_STATIC, &count) == GJK_ERROR_CORRUPT);
}

int main(void) {
  const uint64_t seed = check_seed(SEED);
  for (unsigned i = 0; i < TRIALS; i++) {
    random_state random = random_seed(seed + 3 * i);
    const int32_t size = random_range(&random, ONE, 8 * ONE);
    check_trial(i, NULL, NULL);
    concave_world_free(&world);
    concave_world_make(&world, &random, size);
    for (unsigned k = 0; k < 6; k++) {
      const gjk_vec3 at = random_vector(&random, 2.0 * size), by = random_vector(&random, k == 0 ? 9.0 * size : size);
      const gjk_q16 x = by.x < 0 ? -by.x : by.x, y = by.y < 0 ? -by.y : by.y, z = by.z < 0 ? -by.z : by.z;
      const gjk_aabb near = {{at.x - x, at.y - y, at.z - z}, {at.x + x, at.y + y, at.z + z}};
      for (unsigned b = 0; b < CONCAVE_BODIES; b++) {
        world.body[b].parts.pose.position = random_vector(&random, size);
        world.body[b].parts.pose.rotation = random_rotation(&random);
        check_parts(&random, &world.body[b].parts, &near);
      }
      check_scene(&random, &near);
    }
  }
  printf("%lu drawn, %lu boxes with parts, %lu without, %lu cut, %lu holes\n", tally.drawn, tally.in, tally.out,
         tally.cut, tally.holes);
  CHECK((tally.in > TRIALS && tally.out > TRIALS && tally.cut > TRIALS && tally.holes > 0) || !check_is_full());
  check_refused();
  concave_world_free(&world);
  return check_done("draw_concave");
}
