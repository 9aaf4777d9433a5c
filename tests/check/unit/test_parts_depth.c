// Bodies of many parts: depth and contacts against every part by the pair's query, bit for bit, with the tree and without;
// workspaces of every size, rooms for 0 manifolds to all, two bodies against each other.
#include <string.h>

#include "check.h"
#include "parts_answers.h"
#include "parts_bodies.h"
#include "parts_brute.h"
#include "placed.h"

#define TRIALS 250
#define VISITORS 8
#define CELLS 4000

static gjk_epa_cell cells[CELLS];
static gjk_parts_manifold expected[GENERATE_BODY_PARTS * 8], found[GENERATE_BODY_PARTS * 8];
static unsigned overlapping, apart, short_of_cells, many, short_of_room, touching;

static uint32_t some_cells(random_state *random) {
  const uint32_t choice = random_below(random, 4);
  return choice == 0 ? random_below(random, 12) : choice == 1 ? random_below(random, 120) : CELLS;
}

static void check_depth(const gjk_collider *b, uint32_t count) {
  const gjk_workspace workspace = {cells, count};
  gjk_penetration_result best, answer[2];
  uint32_t part[2];
  gjk_status of_best;
  unsigned long ties = 0;
  const uint32_t deepest = brute_depth(&body.tree, b, &workspace, &best, &of_best, &ties);
  overlapping += deepest != GJK_PARTS_NONE;
  apart += deepest == GJK_PARTS_NONE;
  short_of_cells += of_best == GJK_ERROR_CAPACITY;
  memset(answer, 0x5A, sizeof answer);
  CHECK(gjk_parts_penetration(&body.tree, b, &workspace, &part[0], &answer[0]) == of_best);
  CHECK(gjk_parts_penetration(&body.flat, b, &workspace, &part[1], &answer[1]) == of_best);
  for (int i = 0; i < 2; i++) {
    CHECK(part[i] == deepest && same_penetration(&answer[i], &best));  // of no part: 0 everywhere
  }
}

static void check_contacts(random_state *random, const gjk_collider *b, gjk_q16 margin, uint32_t count) {
  const gjk_workspace workspace = {cells, count};
  const unsigned most = 1 + random_below(random, 8);
  gjk_parts_room room;
  gjk_collider c;
  uint32_t wanted = 0, all;
  gjk_status joined = GJK_OK;
  for (uint32_t i = 0; i < body.count; i++) {
    CHECK(gjk_parts_place(&body.tree, i, &room, &c) == GJK_OK);
    const gjk_status status = gjk_contacts(&c, b, margin, most, NULL, &workspace, &expected[wanted].manifold);
    CHECK(status == GJK_OK || status == GJK_ERROR_CAPACITY);
    if (expected[wanted].manifold.count > 0) {
      expected[wanted++].part = i;
      joined = status != GJK_OK ? status : joined;
    }
  }
  many += wanted > 1;
  const uint32_t rooms[3] = {GENERATE_BODY_PARTS, random_below(random, 4), wanted};
  for (int k = 0; k < 3; k++) {
    const uint32_t capacity = rooms[k], kept = wanted < capacity ? wanted : capacity;
    const gjk_parts *a = random_below(random, 2) == 0 ? &body.tree : &body.flat;
    const gjk_status status = wanted > capacity ? GJK_ERROR_CAPACITY : joined;
    memset(found, 0x5A, sizeof found[0] * (kept + 1));
    CHECK(gjk_parts_contacts(a, b, margin, most, &workspace, capacity > 0 ? found : NULL, capacity, &all) == status);
    CHECK(all == wanted);
    short_of_room += wanted > capacity;
    for (uint32_t i = 0; i < kept; i++) {
      CHECK(found[i].part == expected[i].part && found[i].part_of_b == 0);
      CHECK(same_manifold(&found[i].manifold, &expected[i].manifold));
    }
    CHECK(kept < capacity || found[kept].part == 0x5A5A5A5A);
  }
}

// Two bodies against each other.
static void check_both(gjk_q16 margin) {
  const gjk_workspace workspace = {cells, CELLS};
  gjk_parts_room room;
  gjk_collider c;
  gjk_penetration_result best = {0}, trial, answer;
  gjk_parts_pair pair, deepest = {GJK_PARTS_NONE, GJK_PARTS_NONE};
  uint32_t wanted = 0, all;
  gjk_q16 lower = 0;
  memset(&answer, 0x5A, sizeof answer);
  for (uint32_t j = 0; j < other.count; j++) {
    uint32_t part, count;
    gjk_status status;
    CHECK(gjk_parts_place(&other.tree, j, &room, &c) == GJK_OK);
    status = gjk_parts_penetration(&body.tree, &c, &workspace, &part, &trial);
    CHECK(status == GJK_OK || status == GJK_ERROR_CAPACITY);
    lower = part != GJK_PARTS_NONE && trial.lower > lower ? trial.lower : lower;
    if (part != GJK_PARTS_NONE && (deepest.b == GJK_PARTS_NONE || trial.depth > best.depth)) {
      deepest.a = part;
      deepest.b = j;
      best = trial;
    }
    gjk_parts_contacts(&body.tree, &c, margin, 4, &workspace, &expected[wanted], GENERATE_BODY_PARTS, &count);
    for (uint32_t i = 0; i < count; i++) {
      expected[wanted++].part_of_b = j;
    }
  }
  gjk_parts_both_penetration(&body.tree, &other.flat, &workspace, &pair, &answer);
  best.lower = lower;
  CHECK(pair.a == deepest.a && pair.b == deepest.b && same_penetration(&answer, &best));
  gjk_parts_both_contacts(&body.tree, &other.tree, margin, 4, &workspace, found, GENERATE_BODY_PARTS * 8, &all);
  CHECK(all == wanted);
  touching += all > 0;
  for (uint32_t i = 0; i < all && i < wanted; i++) {
    CHECK(found[i].part == expected[i].part && found[i].part_of_b == expected[i].part_of_b);
    CHECK(same_manifold(&found[i].manifold, &expected[i].manifold));
  }
}

static void try_body(random_state *random, uint64_t seed) {
  const gjk_vec3 origin = {0, 0, 0};
  const generate_layout layout = (generate_layout)random_below(random, GENERATE_LAYOUTS);
  const gjk_q16 spread = random_reach(random) + 200;
  const uint16_t count = (uint16_t)(1 + random_below(random, layout == GENERATE_PILE ? 12 : 60));
  generate_body_make(layout, seed, count, spread, &origin, &body);
  for (unsigned k = 0; k < VISITORS; k++) {
    generate_visitor(random, &body, spread, false, &visitor);
    if (case_collider_build(&guest, &visitor, false) == GJK_OK) {
      // With curved parts a depth from all cells takes long.
      const uint32_t cells_now = layout == GENERATE_CURVED ? random_below(random, 150) : some_cells(random);
      check_depth(&guest.collider, cells_now);
      check_contacts(random, &guest.collider, random_range(random, 0, spread / 8), cells_now);
    }
  }
  if (layout != GENERATE_CURVED && random_below(random, 2) == 0) {
    const gjk_vec3 aside = {random_range(random, -spread, spread) / 16, random_range(random, -spread, spread) / 16, 0};
    generate_body_make(GENERATE_ROW, seed + 1, (uint16_t)(1 + random_below(random, 8)), spread, &aside, &other);
    check_both(spread / 50);
  }
}

// A ball between two walls: each is as deep, the first is reported; a move by it leads into the other.
static void check_walls(void) {
  static const gjk_shape wall = GJK_BOX(GJK_Q16(1), GJK_Q16(10), GJK_Q16(10)), ball = GJK_SPHERE(GJK_Q16(2));
  const gjk_compound_part parts[2] = {{&wall, {{GJK_Q16(2), 0, 0}, {0, 0, 0, GJK_Q30_ONE}}},
                                      {&wall, {{GJK_Q16(-2), 0, 0}, {0, 0, 0, GJK_Q30_ONE}}}};
  gjk_compound_node nodes[GJK_COMPOUND_NODES(2)];
  gjk_compound c;
  gjk_penetration_result result;
  uint32_t part;
  CHECK(gjk_compound_build(parts, 2, nodes, GJK_COMPOUND_NODES(2), &c) == GJK_OK);
  const gjk_parts body_of_walls = GJK_PARTS_OF_COMPOUND(&c);
  const gjk_collider b = placed_at(&ball, 0, 0, 0);
  CHECK(gjk_parts_penetration(&body_of_walls, &b, NULL, &part, &result) == GJK_OK);
  CHECK_MSG(part == 0 && result.depth == GJK_Q16(1) && result.normal.x <= -GJK_Q30_ONE + 4,
            "part %lu depth %ld normal %ld", (unsigned long)part, (long)result.depth, (long)result.normal.x);
  CHECK(gjk_parts_contacts(&body_of_walls, &b, -1, 4, NULL, NULL, 0, &part) == GJK_ERROR_NEGATIVE);
  CHECK(gjk_parts_contacts(&body_of_walls, &b, 0, 0, NULL, NULL, 0, &part) == GJK_ERROR_RANGE);
  CHECK(gjk_parts_contacts(&body_of_walls, &b, 0, 9, NULL, NULL, 0, &part) == GJK_ERROR_RANGE);
  const gjk_collider far = placed_at(&ball, GJK_Q16(100), 0, 0);  // refused as well where no part is near
  CHECK(gjk_parts_contacts(&body_of_walls, &far, -1, 4, NULL, NULL, 0, &part) == GJK_ERROR_NEGATIVE);
  CHECK(gjk_parts_contacts(&body_of_walls, &far, 0, 0, NULL, NULL, 0, &part) == GJK_ERROR_RANGE);
  CHECK(gjk_parts_contacts(&body_of_walls, &far, 0, 9, NULL, NULL, 0, &part) == GJK_ERROR_RANGE);
  CHECK(gjk_parts_contacts(&body_of_walls, &b, 0, 4, NULL, NULL, 1, &part) == GJK_ERROR_NULL);
  gjk_manifold manifold;
  unsigned count = 77;
  CHECK(gjk_parts_manifolds(&body_of_walls, &b, -1, 4, NULL, &manifold, 1, &count) == GJK_ERROR_NEGATIVE &&
        count == 77);
  CHECK(gjk_parts_manifolds(&body_of_walls, &far, -1, 4, NULL, &manifold, 1, &count) == GJK_ERROR_NEGATIVE &&
        count == 77);
  CHECK(gjk_parts_contacts(&body_of_walls, &b, 0, 4, NULL, NULL, 0, &part) == GJK_ERROR_CAPACITY && part == 2);
}

int main(void) {
  const unsigned long trials = check_trials_least(TRIALS, 40);
  check_walls();
  try_bodies(check_seed(20260722), trials);
  CHECK(overlapping > trials / 2 && apart > trials / 2 && touching > trials / 20);
  CHECK(short_of_cells > trials / 20 && many > trials / 2 && short_of_room > trials / 4);
  return check_done("test_parts_depth");
}
