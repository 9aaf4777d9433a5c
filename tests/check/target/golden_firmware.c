// Firmware: the golden hashes of space, of the plane, of motion in both, of bodies of many parts and of hulls on an emulated
// core, and with GOLDEN_SCENE, for boards with 50 KB of memory, those of a match and of concave bodies in a scene. Exits with 0
// if they are those of the headers.
#include <stdbool.h>

#include "board/board.h"
#include "concave_golden.h"
#include "golden.h"
#include "hull_golden.h"
#include "motion_golden.h"
#include "parts_golden.h"
#include "plane_golden.h"
#include "print.h"
#include "scene_golden.h"

#ifndef GOLDEN_RUN_PAIRS
#define GOLDEN_RUN_PAIRS GOLDEN_PAIRS
#endif

// Which hashes are found: a sum of these. Small memories take one after the other.
#define AT_REST 1
#define MOVING 2
#define MOVING_IN_PLANE 4
#define MANY_PARTS 8
#define MANY_PARTS_TOUCHING 16
#define MANY_PARTS_MOVING 32
#define HULLS 64
#ifndef GOLDEN_PARTS
#define GOLDEN_PARTS 127
#endif

#define IS_FEW (GOLDEN_RUN_PAIRS != GOLDEN_PAIRS)

// Prints a hash.
static bool is_golden(uint64_t hash, uint64_t expected) {
  print_hex(board_print, hash);
  board_print(" ");
  return hash == expected;
}

#ifdef GOLDEN_SCENE
static bool scene_is_golden(void) {
  const bool match = is_golden(scene_golden_hash(SCENE_GOLDEN_FEW_TICKS, 1), SCENE_GOLDEN_FEW_HASH);
  return is_golden(concave_golden_hash(CONCAVE_GOLDEN_TICKS), CONCAVE_GOLDEN_HASH) && match;
}
#else
static bool scene_is_golden(void) {
  return true;
}
#endif

static bool is_golden_at_rest(void) {
  const bool space = is_golden(golden_hash(GOLDEN_RUN_PAIRS), IS_FEW ? GOLDEN_FEW_HASH : GOLDEN_HASH);
  const bool plane = is_golden(plane_golden_hash(IS_FEW ? PLANE_GOLDEN_FEW_PAIRS : PLANE_GOLDEN_PAIRS),
                               IS_FEW ? PLANE_GOLDEN_FEW_HASH : PLANE_GOLDEN_HASH);
  const bool scene = scene_is_golden();
  return space && plane && scene;
}

static bool many_parts_are_golden(void) {
  const uint32_t bodies = IS_FEW ? PARTS_GOLDEN_FEW_BODIES : PARTS_GOLDEN_BODIES;
  bool same = true;
  if ((GOLDEN_PARTS & MANY_PARTS) != 0) {
    same = is_golden(parts_golden_hash(bodies), IS_FEW ? PARTS_GOLDEN_FEW_HASH : PARTS_GOLDEN_HASH) && same;
  }
  if ((GOLDEN_PARTS & MANY_PARTS_TOUCHING) != 0) {
    same = is_golden(parts_contacts_golden_hash(bodies),
                     IS_FEW ? PARTS_CONTACTS_GOLDEN_FEW_HASH : PARTS_CONTACTS_GOLDEN_HASH) &&
           same;
  }
  if ((GOLDEN_PARTS & MANY_PARTS_MOVING) != 0) {
    same =
        is_golden(parts_motion_golden_hash(bodies), IS_FEW ? PARTS_MOTION_GOLDEN_FEW_HASH : PARTS_MOTION_GOLDEN_HASH) &&
        same;
  }
  return same;
}

int firmware_main(void) {
  const uint32_t pairs = IS_FEW ? MOTION_GOLDEN_FEW_PAIRS : MOTION_GOLDEN_PAIRS;
  bool same = true;
  if ((GOLDEN_PARTS & AT_REST) != 0) {
    same = is_golden_at_rest() && same;
  }
  if ((GOLDEN_PARTS & MOVING) != 0) {
    same = is_golden(motion_golden_hash(pairs), IS_FEW ? MOTION_GOLDEN_FEW_HASH : MOTION_GOLDEN_HASH) && same;
  }
  if ((GOLDEN_PARTS & MOVING_IN_PLANE) != 0) {
    same =
        is_golden(plane_motion_golden_hash(pairs), IS_FEW ? PLANE_MOTION_GOLDEN_FEW_HASH : PLANE_MOTION_GOLDEN_HASH) &&
        same;
  }
  same = many_parts_are_golden() && same;
  if ((GOLDEN_PARTS & HULLS) != 0) {
    same = is_golden(hull_golden_hash(IS_FEW ? HULL_GOLDEN_FEW_SETS : HULL_GOLDEN_SETS),
                     IS_FEW ? HULL_GOLDEN_FEW_HASH : HULL_GOLDEN_HASH) &&
           same;
  }
  board_print("\n");
  return same ? 0 : 1;
}
