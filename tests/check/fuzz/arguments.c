// Every public function on hostile arguments. Each must return a status that it may return, and an error must leave
// outputs as they were.
#include <string.h>

#include "hostile.h"

#define POISON HOSTILE_POISON
#define VERTICES HOSTILE_VERTICES
#define CELLS 128

// All objects that the calls below work on.
typedef struct world {
  hostile_shape shape[2];
  gjk_vec3 buffer[2][VERTICES];
  gjk_collider collider[2];
  gjk_pose pose[2];
  gjk_epa_cell cells[CELLS];
} world;

static world w;
static fuzz_bytes bytes;

static void place(int i) {
  gjk_collider *c = &w.collider[i], before;
  memset(c, fuzz_u8(&bytes) % 2 == 0 ? 0 : POISON, sizeof *c);
  hostile_make_shape(&bytes, &w.shape[i]);
  gjk_vec3 *const buffers[] = {w.buffer[i], w.shape[i].vertices, (gjk_vec3 *)c, NULL};
  gjk_vec3 *buffer = buffers[fuzz_u8(&bytes) % 8 < 4 ? fuzz_u8(&bytes) % 4 : 0];
  const uint16_t capacity = (uint16_t)(fuzz_u8(&bytes) % 8 == 0 ? 3 : VERTICES);
  memcpy(&before, c, sizeof before);
  const gjk_status status = gjk_collider_init(MAYBE(c), MAYBE(&w.shape[i].shape), buffer, capacity);
  hostile_check(status, NULL, 0);
  if (status != GJK_OK && memcmp(c, &before, sizeof before) != 0) {
    fuzz_fail("gjk_collider_init wrote");
  }
  w.pose[i].position = fuzz_vec3(&bytes);
  w.pose[i].rotation = hostile_quat(&bytes);
  memcpy(&before, c, sizeof before);
  if (gjk_collider_pose(MAYBE(c), MAYBE(&w.pose[i])) != GJK_OK && memcmp(c, &before, sizeof before) != 0) {
    fuzz_fail("gjk_collider_pose wrote");
  }
  gjk_aabb box;
  memset(&box, POISON, sizeof box);
  hostile_check(gjk_collider_aabb(MAYBE(c), &box), &box, sizeof box);
  const gjk_vec3 position = fuzz_vec3(&bytes);
  memcpy(&before, c, sizeof before);
  if (gjk_collider_move(MAYBE(c), MAYBE(&position)) != GJK_OK && memcmp(c, &before, sizeof before) != 0) {
    fuzz_fail("gjk_collider_move wrote");
  }
}

static gjk_certificate any_certificate(void) {
  gjk_certificate c;
  c.direction = fuzz_vec3(&bytes);
  for (int i = 0; i < 4; i++) {
    c.a[i] = (uint16_t)(fuzz_u8(&bytes) % 9);
    c.b[i] = (uint16_t)(fuzz_u8(&bytes) % 9);
  }
  c.count = fuzz_u8(&bytes);
  c.proof = fuzz_u8(&bytes);
  return c;
}

// Asks for answers, and checks answers that no query gave.
static void query(void) {
  const gjk_collider *a = MAYBE(&w.collider[0]), *b = MAYBE(&w.collider[1]);
  gjk_cache cache = fuzz_cache(&bytes);
  gjk_decision decision;
  gjk_distance_result distance;
  gjk_penetration_result depth;
  gjk_manifold manifold;
  const unsigned most = fuzz_u8(&bytes) % (GJK_CONTACTS_MAX + 2);
  const gjk_effort effort = {fuzz_u8(&bytes), fuzz_i32(&bytes)};
  const gjk_q16 asked = fuzz_i32(&bytes);
  const gjk_workspace workspace = {MAYBE(w.cells), fuzz_u8(&bytes) % (CELLS + 1)};
  memset(&decision, POISON, sizeof decision);
  hostile_check(gjk_intersect(a, b, MAYBE(&cache), &decision), &decision, sizeof decision);
  memset(&decision, POISON, sizeof decision);
  hostile_check(gjk_within(a, b, asked, MAYBE(&cache), &decision), &decision, sizeof decision);
  gjk_within_result within;
  memset(&within, POISON, sizeof within);
  hostile_check(gjk_within_until(a, b, asked, effort.iterations, MAYBE(&cache), &within), &within, sizeof within);
  memset(&distance, POISON, sizeof distance);
  hostile_check(gjk_distance(a, b, MAYBE(&cache), &distance), &distance, sizeof distance);
  memset(&distance, POISON, sizeof distance);
  hostile_check(gjk_distance_until(a, b, MAYBE(&effort), MAYBE(&cache), &distance), &distance, sizeof distance);
  memset(&depth, POISON, sizeof depth);
  hostile_check(gjk_penetration(a, b, MAYBE(&cache), MAYBE(&workspace), &depth), &depth, sizeof depth);
  memset(&distance, POISON, sizeof distance);
  hostile_check(gjk_signed_distance(a, b, MAYBE(&cache), MAYBE(&workspace), &distance), &distance, sizeof distance);
  memset(&manifold, POISON, sizeof manifold);
  hostile_check(gjk_contacts(a, b, asked, most, MAYBE(&cache), MAYBE(&workspace), &manifold), &manifold,
                sizeof manifold);
  hostile_check(gjk_intersect(a, b, NULL, NULL), NULL, 0);
  memset(&decision, 0, sizeof decision);
  memset(&distance, 0, sizeof distance);
  memset(&depth, 0, sizeof depth);
  decision.yes = distance.intersecting = depth.intersecting = fuzz_u8(&bytes) % 2 == 0;
  decision.certificate = distance.certificate = depth.certificate = any_certificate();
  distance.distance = depth.depth = depth.lower = depth.upper = fuzz_i32(&bytes);
  distance.lower = distance.upper = distance.distance;
  distance.saturated = fuzz_u8(&bytes) % 2 == 0;
  distance.point_a = depth.point_a = fuzz_vec3(&bytes);
  distance.point_b = depth.point_b = fuzz_vec3(&bytes);
  const gjk_vec3 n = fuzz_vec3(&bytes);
  distance.normal.x = depth.normal.x = n.x;
  distance.normal.y = depth.normal.y = n.y;
  distance.normal.z = depth.normal.z = n.z;
  hostile_check(gjk_check_decision(a, b, asked, MAYBE(&decision)), NULL, 0);
  hostile_check(gjk_check_distance(a, b, MAYBE(&distance)), NULL, 0);
  hostile_check(gjk_check_penetration(a, b, MAYBE(&depth)), NULL, 0);
}

static void turn(void) {
  const gjk_quat p = hostile_quat(&bytes), q = hostile_quat(&bytes);
  const gjk_pose *pose = &w.pose[0], *other = &w.pose[1];
  const gjk_vec3 v = fuzz_vec3(&bytes);
  const gjk_q16 x = fuzz_i32(&bytes), y = fuzz_i32(&bytes), z = fuzz_i32(&bytes);
  gjk_quat out;
  gjk_vec3 moved;
  gjk_pose place_of;
  memset(&out, POISON, sizeof out);
  hostile_check(gjk_quat_from_axis_angle(MAYBE(&v), x, &out), &out, sizeof out);
  hostile_check(gjk_quat_from_euler(x, y, z, MAYBE(&out)), NULL, 0);
  memset(&out, POISON, sizeof out);
  hostile_check(gjk_quat_normalize(MAYBE(&p), &out), &out, sizeof out);
  memset(&out, POISON, sizeof out);
  hostile_check(gjk_quat_compose(MAYBE(&p), MAYBE(&q), &out), &out, sizeof out);
  memset(&out, POISON, sizeof out);
  hostile_check(gjk_quat_invert(MAYBE(&p), &out), &out, sizeof out);
  memset(&moved, POISON, sizeof moved);
  hostile_check(gjk_quat_apply(MAYBE(&p), MAYBE(&v), &moved), &moved, sizeof moved);
  memset(&moved, POISON, sizeof moved);
  hostile_check(gjk_pose_apply(MAYBE(pose), MAYBE(&v), &moved), &moved, sizeof moved);
  memset(&place_of, POISON, sizeof place_of);
  hostile_check(gjk_pose_compose(MAYBE(pose), MAYBE(other), &place_of), &place_of, sizeof place_of);
  memset(&place_of, POISON, sizeof place_of);
  hostile_check(gjk_pose_invert(MAYBE(pose), &place_of), &place_of, sizeof place_of);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  bytes.at = data;
  bytes.end = data + size;
  place(0);
  place(1);
  query();
  turn();
  return 0;
}
