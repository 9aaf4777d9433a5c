// Bodies of many parts: intersect, within and distance against every part by the pair's query, bit for bit; with the tree
// and without; two bodies against each other; and every certificate.

#include <string.h>

#include "check.h"
#include "parts_answers.h"
#include "parts_bodies.h"
#include "random_vec.h"

#define TRIALS 400
#define VISITORS 12

static unsigned touching, apart, ties, several;

static uint32_t count_of(random_state *random) {
  const uint32_t choice = random_below(random, 4);
  return choice == 0   ? 1 + random_below(random, 9)
         : choice == 1 ? 9 + random_below(random, 8)
                       : 1 + random_below(random, GENERATE_BODY_PARTS);
}

// The body's place: in the middle, anywhere, or as near to a corner of the world as its reach allows.
static gjk_vec3 place_of(random_state *random, const gjk_compound *c) {
  gjk_vec3 p = {0, 0, 0};
  const uint32_t choice = random_below(random, 3);
  const int32_t most = (int32_t)(INT32_MAX - c->reach);
  if (choice == 1) {
    p = random_in_cube(random, most);
  } else if (choice == 2) {
    p.x = random_below(random, 2) == 0 ? most : -most;
    p.y = random_below(random, 2) == 0 ? most : -most;
    p.z = random_below(random, 2) == 0 ? most : -most;
  }
  return p;
}

static void check_decisions(const gjk_collider *b, gjk_q16 distance) {
  gjk_parts_room room;
  gjk_collider c;
  gjk_decision expected, found[2];
  uint32_t least = GJK_PARTS_NONE, part[2] = {7, 7};
  bool limited = false;
  for (uint32_t i = 0; i < body.count && least == GJK_PARTS_NONE; i++) {
    CHECK(gjk_parts_place(&body.tree, i, &room, &c) == GJK_OK);
    const gjk_status status = gjk_within(&c, b, distance, NULL, &expected);
    limited = limited || status != GJK_OK;
    if (status == GJK_OK && expected.yes) {
      least = i;
      CHECK(gjk_check_decision(&c, b, distance, &expected) != GJK_ERROR_UNPROVEN);
    }
  }
  CHECK(!limited);
  if (least == GJK_PARTS_NONE) {
    memset(&expected, 0, sizeof expected);
  }
  memset(found, 0x5A, sizeof found);
  CHECK(gjk_parts_within(&body.tree, b, distance, &part[0], &found[0]) == GJK_OK);
  CHECK(gjk_parts_within(&body.flat, b, distance, &part[1], &found[1]) == GJK_OK);
  CHECK(part[0] == least && part[1] == least);
  CHECK(same_decision(&found[0], &expected) && same_decision(&found[1], &expected));
  if (distance == 0) {
    touching += least != GJK_PARTS_NONE;
    apart += least == GJK_PARTS_NONE;
    CHECK(gjk_parts_intersect(&body.tree, b, &part[0], &found[0]) == GJK_OK && part[0] == least);
  }
}

static void check_distance(const gjk_collider *b) {
  gjk_parts_room room;
  gjk_collider c;
  gjk_distance_result best = {0}, trial, found;
  uint32_t least = GJK_PARTS_NONE, part, equal = 0;
  for (uint32_t i = 0; i < body.count; i++) {
    CHECK(gjk_parts_place(&body.tree, i, &room, &c) == GJK_OK);
    CHECK(gjk_distance(&c, b, NULL, &trial) == GJK_OK);
    const bool nearer = trial.intersecting != best.intersecting ? trial.intersecting : trial.distance < best.distance;
    equal += least != GJK_PARTS_NONE && !nearer && trial.intersecting == best.intersecting &&
             trial.distance == best.distance;
    if (least == GJK_PARTS_NONE || nearer) {
      least = i;
      best = trial;
    }
  }
  ties += equal > 0;
  CHECK(gjk_parts_distance(&body.tree, b, &part, &found) == GJK_OK);
  CHECK_MSG(part == least && same_distance(&found, &best), "tree: part %lu, %ld; not part %lu, %ld",
            (unsigned long)part, (long)found.distance, (unsigned long)least, (long)best.distance);
  CHECK(gjk_parts_place(&body.tree, part, &room, &c) == GJK_OK);
  CHECK(gjk_check_distance(&c, b, &found) != GJK_ERROR_UNPROVEN);
  CHECK(gjk_parts_distance(&body.flat, b, &part, &found) == GJK_OK);
  CHECK(part == least && same_distance(&found, &best));
}

// Two bodies: against every pair of parts, and with both exchanged.
static void check_both(void) {
  gjk_parts_room room[2];
  gjk_collider a, b;
  gjk_distance_result best = {0}, trial, found, back;
  gjk_parts_pair pair, turned, least = {GJK_PARTS_NONE, GJK_PARTS_NONE};
  gjk_decision decision;
  for (uint32_t j = 0; j < other.count; j++) {
    CHECK(gjk_parts_place(&other.tree, j, &room[1], &b) == GJK_OK);
    for (uint32_t i = 0; i < body.count; i++) {
      CHECK(gjk_parts_place(&body.tree, i, &room[0], &a) == GJK_OK);
      CHECK(gjk_distance(&a, &b, NULL, &trial) == GJK_OK);
      if (least.a == GJK_PARTS_NONE ||
          (trial.intersecting != best.intersecting ? trial.intersecting : trial.distance < best.distance)) {
        least.a = i;
        least.b = j;
        best = trial;
      }
    }
  }
  CHECK(gjk_parts_both_distance(&body.tree, &other.tree, &pair, &found) == GJK_OK);
  CHECK(pair.a == least.a && pair.b == least.b && same_distance(&found, &best));
  CHECK(gjk_parts_both_distance(&body.flat, &other.flat, &pair, &found) == GJK_OK);
  CHECK(pair.a == least.a && pair.b == least.b && same_distance(&found, &best));
  CHECK(gjk_parts_both_distance(&other.tree, &body.tree, &turned, &back) == GJK_OK);
  CHECK(back.intersecting == best.intersecting);
  if (body.layout != GENERATE_CURVED && other.layout != GENERATE_CURVED && best.distance < 8000 * 65536) {
    CHECK(back.distance == best.distance);
  }
  for (int k = -1; k <= 1; k++) {
    const gjk_q16 within = best.distance + k < 0 ? 0 : best.distance < INT32_MAX ? best.distance + k : best.distance;
    gjk_parts_pair near;
    CHECK(gjk_parts_both_within(&body.tree, &other.tree, within, &near, &decision) == GJK_OK);
    CHECK(k < 1 || best.distance > 8000 * 65536 || decision.yes);
    CHECK(decision.yes == (near.a != GJK_PARTS_NONE) && decision.yes == (near.b != GJK_PARTS_NONE));
  }
  several++;
}

static void try_body(random_state *random, uint64_t seed) {
  const gjk_vec3 origin = {0, 0, 0};
  const generate_layout layout = (generate_layout)random_below(random, GENERATE_LAYOUTS);
  const gjk_q16 spread = random_reach(random) + 200;
  const uint16_t count = (uint16_t)count_of(random);
  generate_body_make(layout, seed, count, spread, &origin, &body);
  body.tree.pose.position = place_of(random, &body.with_tree);
  body.flat.pose.position = body.tree.pose.position;
  for (unsigned k = 0; k < VISITORS; k++) {
    generate_visitor(random, &body, spread, layout == GENERATE_CURVED, &visitor);
    if (case_collider_build(&guest, &visitor, false) != GJK_OK) {
      continue;  // in a corner of the world a centre may be outside
    }
    check_decisions(&guest.collider, 0);
    check_decisions(&guest.collider, random_range(random, 0, spread));
    check_distance(&guest.collider);
  }
  if (random_below(random, 8) == 0) {
    const gjk_vec3 *at = &body.tree.pose.position;
    const gjk_vec3 aside = {at->x / 2 + random_range(random, -spread, spread), at->y / 2, at->z / 2};
    generate_body_make((generate_layout)random_below(random, GENERATE_LAYOUTS), seed + 1,
                       (uint16_t)(1 + random_below(random, 20)), spread, &aside, &other);
    if (gjk_parts_place(&other.tree, 0, &(gjk_parts_room){0}, &(gjk_collider){0}) == GJK_OK) {
      check_both();
    }
  }
}

int main(void) {
  const unsigned long trials = check_trials_least(TRIALS, 40);
  try_bodies(check_seed(20260721), trials);
  CHECK(touching > trials && apart > trials);
  CHECK(ties > trials / 4);
  CHECK(several > 0);
  return check_done("test_parts");
}
