// Host program: prints the golden hashes of this build, and what to write into the headers for those that are others.
#include "golden.h"

#include <inttypes.h>
#include <stdbool.h>
#include <stdio.h>

#include "concave_golden.h"
#include "hull_golden.h"
#include "motion_golden.h"
#include "parts_golden.h"
#include "plane_golden.h"
#include "scene_golden.h"

// Prints the hash; and if it is not the expected one, the header's line.
static bool is_golden(const char *name, uint64_t hash, uint64_t expected) {
  printf("%016" PRIx64 " ", hash);
  if (hash != expected) {
    fprintf(stderr, "#define %s UINT64_C(0x%016" PRIx64 ")\n", name, hash);
  }
  return hash == expected;
}

int main(void) {
  bool same = is_golden("GOLDEN_FEW_HASH", golden_hash(GOLDEN_FEW_PAIRS), GOLDEN_FEW_HASH);
  same = is_golden("GOLDEN_HASH", golden_hash(GOLDEN_PAIRS), GOLDEN_HASH) && same;
  same =
      is_golden("SCENE_GOLDEN_FEW_HASH", scene_golden_hash(SCENE_GOLDEN_FEW_TICKS, 1), SCENE_GOLDEN_FEW_HASH) && same;
  same = is_golden("CONCAVE_GOLDEN_HASH", concave_golden_hash(CONCAVE_GOLDEN_TICKS), CONCAVE_GOLDEN_HASH) && same;
  same = is_golden("PLANE_GOLDEN_FEW_HASH", plane_golden_hash(PLANE_GOLDEN_FEW_PAIRS), PLANE_GOLDEN_FEW_HASH) && same;
  same = is_golden("PLANE_GOLDEN_HASH", plane_golden_hash(PLANE_GOLDEN_PAIRS), PLANE_GOLDEN_HASH) && same;
  same =
      is_golden("MOTION_GOLDEN_FEW_HASH", motion_golden_hash(MOTION_GOLDEN_FEW_PAIRS), MOTION_GOLDEN_FEW_HASH) && same;
  same = is_golden("MOTION_GOLDEN_HASH", motion_golden_hash(MOTION_GOLDEN_PAIRS), MOTION_GOLDEN_HASH) && same;
  same = is_golden("PLANE_MOTION_GOLDEN_FEW_HASH", plane_motion_golden_hash(MOTION_GOLDEN_FEW_PAIRS),
                   PLANE_MOTION_GOLDEN_FEW_HASH) &&
         same;
  same =
      is_golden("PLANE_MOTION_GOLDEN_HASH", plane_motion_golden_hash(MOTION_GOLDEN_PAIRS), PLANE_MOTION_GOLDEN_HASH) &&
      same;
  same = is_golden("PARTS_GOLDEN_FEW_HASH", parts_golden_hash(PARTS_GOLDEN_FEW_BODIES), PARTS_GOLDEN_FEW_HASH) && same;
  same = is_golden("PARTS_GOLDEN_HASH", parts_golden_hash(PARTS_GOLDEN_BODIES), PARTS_GOLDEN_HASH) && same;
  same = is_golden("PARTS_CONTACTS_GOLDEN_FEW_HASH", parts_contacts_golden_hash(PARTS_GOLDEN_FEW_BODIES),
                   PARTS_CONTACTS_GOLDEN_FEW_HASH) &&
         same;
  same = is_golden("PARTS_CONTACTS_GOLDEN_HASH", parts_contacts_golden_hash(PARTS_GOLDEN_BODIES),
                   PARTS_CONTACTS_GOLDEN_HASH) &&
         same;
  same = is_golden("PARTS_MOTION_GOLDEN_FEW_HASH", parts_motion_golden_hash(PARTS_GOLDEN_FEW_BODIES),
                   PARTS_MOTION_GOLDEN_FEW_HASH) &&
         same;
  same =
      is_golden("PARTS_MOTION_GOLDEN_HASH", parts_motion_golden_hash(PARTS_GOLDEN_BODIES), PARTS_MOTION_GOLDEN_HASH) &&
      same;
  same = is_golden("HULL_GOLDEN_FEW_HASH", hull_golden_hash(HULL_GOLDEN_FEW_SETS), HULL_GOLDEN_FEW_HASH) && same;
  same = is_golden("HULL_GOLDEN_HASH", hull_golden_hash(HULL_GOLDEN_SETS), HULL_GOLDEN_HASH) && same;
  printf("\n");
  return same ? 0 : 1;
}
