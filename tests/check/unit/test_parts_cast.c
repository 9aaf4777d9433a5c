// Bodies of many parts in motion: casts, rays and times of impact against every part by the pair's query, bit for bit, with
// the tree and without. Bodies that turn: against distances at fractions before and at the impact.
#include <string.h>

#include "check.h"
#include "parts_answers.h"
#include "parts_bodies.h"
#include "parts_brute.h"

#define TRIALS 150
#define VISITORS 8

static unsigned hits, misses, inside, ray_hits, ray_misses, impacts, free_ways, overlaps;

static gjk_q16 capped(int64_t x) {
  const int64_t most = INT32_MAX - (1 << 29);
  return (gjk_q16)(x > most ? most : x < -most ? -most : x);
}

static gjk_vec3 way_from(random_state *random, const gjk_vec3 *from, double most) {
  const gjk_vec3 by = random_vector(random, most * random_unit(random));
  gjk_vec3 to;
  to.x = capped((int64_t)from->x + by.x);
  to.y = capped((int64_t)from->y + by.y);
  to.z = capped((int64_t)from->z + by.z);
  return to;
}

static void check_cast(random_state *random, const gjk_collider *b, gjk_q16 spread) {
  gjk_parts_room room;
  gjk_collider c;
  gjk_cast_result best, answer;
  uint32_t part;
  const gjk_vec3 *at = &body.tree.pose.position;
  const gjk_vec3 to_a = way_from(random, at, 2.0 * spread), to_b = way_from(random, &b->position, 4.0 * spread);
  const bool a_moves = random_below(random, 2) == 0;
  const gjk_cast_path path = {a_moves ? &to_a : NULL, random_below(random, 8) > 0 ? &to_b : NULL,
                              random_below(random, 2) == 0 ? 0 : random_range(random, 0, spread / 4)};
  gjk_vec3 offset = {0, 0, 0};
  const uint32_t first = brute_cast(&body.tree, b, &path, &best);
  if (first != GJK_PARTS_NONE) {
    CHECK(gjk_parts_place(&body.tree, first, &room, &c) == GJK_OK);
    offset.x = c.position.x - at->x;
    offset.y = c.position.y - at->y;
    offset.z = c.position.z - at->z;
  }
  hits += first != GJK_PARTS_NONE;
  misses += first == GJK_PARTS_NONE;
  inside += best.inside;
  for (int k = 0; k < 2; k++) {
    memset(&answer, 0x5A, sizeof answer);
    CHECK(gjk_parts_cast(k == 0 ? &body.tree : &body.flat, b, &path, &part, &answer) == GJK_OK);
    CHECK_MSG(part == first && same_cast(&answer, &best), "part %ld not %ld, fraction %ld not %ld", (long)part,
              (long)first, (long)answer.fraction, (long)best.fraction);
    if (answer.hit && part == first) {
      CHECK(same_vec3(&answer.rest_b, &best.rest_b));
      CHECK(answer.rest_a.x == best.rest_a.x - offset.x && answer.rest_a.y == best.rest_a.y - offset.y &&
            answer.rest_a.z == best.rest_a.z - offset.z);
    }
  }
}

static void check_ray(random_state *random, gjk_q16 spread) {
  gjk_parts_room room;
  gjk_collider c;
  gjk_cast_result best = {0}, trial, answer;
  uint32_t first = GJK_PARTS_NONE, part;
  const gjk_vec3 from = way_from(random, &body.tree.pose.position, 3.0 * spread);
  gjk_vec3 to = way_from(random, random_below(random, 2) == 0 ? &from : &body.tree.pose.position, 3.0 * spread);
  if (random_below(random, 3) > 0) {  // through a part's middle
    CHECK(gjk_parts_place(&body.tree, random_below(random, body.count), &room, &c) == GJK_OK);
    to.x = capped(2 * (int64_t)c.centre.x - from.x);
    to.y = capped(2 * (int64_t)c.centre.y - from.y);
    to.z = capped(2 * (int64_t)c.centre.z - from.z);
  }
  for (uint32_t i = 0; i < body.count; i++) {
    CHECK(gjk_parts_place(&body.tree, i, &room, &c) == GJK_OK);
    CHECK(gjk_cast_ray(&c, &from, &to, &trial) == GJK_OK);
    if (brute_comes_first(&trial, &best, first)) {
      first = i;
      best = trial;
    }
  }
  ray_hits += first != GJK_PARTS_NONE;
  ray_misses += first == GJK_PARTS_NONE;
  for (int k = 0; k < 2; k++) {
    memset(&answer, 0x5A, sizeof answer);
    CHECK(gjk_parts_cast_ray(k == 0 ? &body.tree : &body.flat, &from, &to, &part, &answer) == GJK_OK);
    CHECK(part == first && same_cast(&answer, &best));
  }
}

// The gap at a fraction of both ways.
static gjk_distance_result gap_at(const gjk_motion motion[2], gjk_q30 fraction) {
  gjk_parts a = body.tree;
  gjk_pose pose;
  gjk_distance_result result;
  CHECK(gjk_motion_pose(&motion[0], fraction, &a.pose) == GJK_OK);
  CHECK(gjk_motion_pose(&motion[1], fraction, &pose) == GJK_OK);
  CHECK(gjk_collider_pose(&guest.collider, &pose) == GJK_OK);
  CHECK(gjk_parts_distance(&a, &guest.collider, NULL, &result) == GJK_OK);
  return result;
}

static void check_impact(random_state *random, gjk_q16 spread) {
  gjk_motion motion[2];
  gjk_impact_result best, answer;
  uint32_t part;
  bool limited;
  const gjk_impact_setup setup = {random_below(random, 2) == 0 ? 0 : random_range(random, 0, 1000), 512 + 11, 0};
  memset(motion, 0, sizeof motion);
  motion[0].from = body.tree.pose;
  motion[0].to = motion[0].from;
  motion[0].to.position = way_from(random, &motion[0].from.position, spread);
  motion[1].from = visitor.pose;
  motion[1].to = motion[1].from;
  motion[1].to.position = way_from(random, &body.tree.pose.position, 2.0 * spread);
  if (random_below(random, 3) > 0) {
    motion[0].to.rotation = random_rotation(random);
  }
  if (random_below(random, 2) == 0) {
    motion[1].spin = random_vector(random, 400000);
  }
  memset(&answer, 0x5A, sizeof answer);
  const uint32_t first = brute_impact(&body.tree, motion, &guest.collider, &setup, &best, &limited);
  const gjk_status status =
      gjk_parts_time_of_impact(&body.tree, &motion[0], &guest.collider, &motion[1], &setup, &part, &answer);
  if (status == GJK_ERROR_RANGE && body.with_tree.reach > 1000 * 65536) {
    return;  // takes a larger tolerance
  }
  CHECK_MSG(status == GJK_OK || (limited && status == GJK_ERROR_ITERATION_LIMIT), "%s", gjk_status_name(status));
  if (status != GJK_OK) {
    return;
  }
  if (first == GJK_PARTS_NONE) {
    best.lower = best.upper = GJK_Q30_ONE;
  }
  CHECK(part == first && same_impact(&answer, &best));
  for (int k = 0; k < 2; k++) {
    gjk_pose pose;
    CHECK(gjk_motion_pose(&motion[k], answer.lower, &pose) == GJK_OK);
    CHECK(memcmp(&pose, k == 0 ? &answer.pose_a : &answer.pose_b, sizeof pose) == 0);
  }
  impacts += answer.hit && !answer.overlap;
  overlaps += answer.overlap;
  free_ways += !answer.hit;
  gjk_impact_result flat;
  CHECK(gjk_parts_time_of_impact(&body.flat, &motion[0], &guest.collider, &motion[1], &setup, &part, &flat) == GJK_OK);
  CHECK(part == first && flat.hit == answer.hit && flat.lower == answer.lower);
  if (answer.hit) {
    const gjk_distance_result gap = gap_at(motion, answer.upper);
    CHECK_MSG(gap.distance <= setup.margin + setup.tolerance + 24, "gap %ld", (long)gap.distance);
  }
  for (int k = 0; k < 6 && answer.lower > 0; k++) {
    const gjk_q30 before = (gjk_q30)((double)(answer.lower - 1) * (k < 2 ? 1 - k * 1e-6 : random_unit(random)));
    const gjk_distance_result gap = gap_at(motion, before);
    CHECK_MSG(!gap.intersecting && gap.distance >= setup.margin, "gap %ld at %ld", (long)gap.distance, (long)before);
  }
}

// Two bodies: against each part of B by itself.
static void check_both(random_state *random, gjk_q16 spread) {
  gjk_parts_room room;
  gjk_collider c;
  gjk_cast_result best = {0}, trial, answer;
  gjk_parts_pair pair, first = {GJK_PARTS_NONE, GJK_PARTS_NONE};
  const gjk_vec3 *at = &other.tree.pose.position;
  const gjk_vec3 to_a = way_from(random, &body.tree.pose.position, 2.0 * spread),
                 to_b = way_from(random, at, 2.0 * spread);
  const gjk_cast_path path = {&to_a, &to_b, 0};
  gjk_vec3 offset = {0, 0, 0};
  for (uint32_t j = 0; j < other.count; j++) {
    uint32_t part;
    CHECK(gjk_parts_place(&other.tree, j, &room, &c) == GJK_OK);
    const gjk_vec3 to = {to_b.x - at->x + c.position.x, to_b.y - at->y + c.position.y, to_b.z - at->z + c.position.z};
    const gjk_cast_path own = {&to_a, &to, 0};
    CHECK(gjk_parts_cast(&body.tree, &c, &own, &part, &trial) == GJK_OK);
    if (brute_comes_first(&trial, &best, first.b)) {
      first.a = part;
      first.b = j;
      best = trial;
      offset.x = c.position.x - at->x;
      offset.y = c.position.y - at->y;
      offset.z = c.position.z - at->z;
    }
  }
  memset(&answer, 0x5A, sizeof answer);
  CHECK(gjk_parts_both_cast(&body.tree, &other.tree, &path, &pair, &answer) == GJK_OK);
  CHECK(pair.a == first.a && pair.b == first.b && same_cast(&answer, &best));
  if (answer.hit) {
    CHECK(same_vec3(&answer.rest_a, &best.rest_a));
    CHECK(answer.rest_b.x == best.rest_b.x - offset.x && answer.rest_b.y == best.rest_b.y - offset.y &&
          answer.rest_b.z == best.rest_b.z - offset.z);
  }
}

static void try_body(random_state *random, uint64_t seed) {
  const gjk_vec3 origin = {0, 0, 0};
  const generate_layout layout = (generate_layout)random_below(random, GENERATE_LAYOUTS);
  const gjk_q16 spread = (random_reach(random) + 200) / 2;
  const uint16_t count = (uint16_t)(1 + random_below(random, random_below(random, 3) == 0 ? GENERATE_BODY_PARTS : 20));
  generate_body_make(layout, seed, count, spread, &origin, &body);
  for (unsigned k = 0; k < VISITORS; k++) {
    generate_visitor(random, &body, spread, layout == GENERATE_CURVED, &visitor);
    if (case_collider_build(&guest, &visitor, true) == GJK_OK) {
      check_cast(random, &guest.collider, spread);
      check_ray(random, spread);
      if (k < 2 && count <= 40) {
        check_impact(random, spread);
      }
    }
  }
  if (random_below(random, 4) == 0) {
    const gjk_vec3 aside = {random_range(random, -spread, spread), random_range(random, -spread, spread), 0};
    generate_body_make(GENERATE_ROW, seed + 1, (uint16_t)(1 + random_below(random, 8)), spread, &aside, &other);
    check_both(random, spread);
  }
}

int main(void) {
  const unsigned long trials = check_trials_least(TRIALS, 40);
  try_bodies(check_seed(20260723), trials);
  CHECK(hits > trials && misses > trials && inside > trials / 2);
  CHECK(ray_hits > trials && ray_misses > trials);
  CHECK(impacts > trials / 8 && free_ways > trials / 8 && overlaps > trials / 16);
  printf("casts %u %u %u, rays %u %u, impacts %u %u %u\n", hits, misses, inside, ray_hits, ray_misses, impacts,
         free_ways, overlaps);
  return check_done("test_parts_cast");
}
