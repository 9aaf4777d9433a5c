// Scenes of the plane under random changes against a search of all pairs, with all skips and with none; and while they
// are saved, restored, moved to other memory and updated in slices.

// Depths of smooth shapes in the middle of each other, which GJK2_DEPTH_ITERATIONS_MAX need not settle.
#define FAMILY_MAY_STAY_OPEN(options) ((options)->detail == GJK_DETAIL_DEPTH)

#include "scene/plane_names.h"
#include "scene/session.h"
#include "scene_families.h"

#define SEED 7700
#define SESSIONS check_trials(60)
#define CHANGES 400u

static void check_session(random_state *random, session *s) {
  const world_options options = session_options(random);
  CHECK(session_start(s, &options));
  for (unsigned i = 0; i < CHANGES; i++) {
    uint32_t what;
    const bool fine = session_change(s, random, &what);
    CHECK_MSG(fine, "change %u: %u", i, what);
    if (!fine) {
      break;
    }
  }
  session_end(s);
}

int main(void) {
  static session s;
  random_state random = random_seed(check_seed(SEED) + 100);
  for (unsigned i = 0; i < SESSIONS; i++) {
    check_trial(i, NULL, NULL);
    check_session(&random, &s);
  }
  printf("sessions: %lu updates, %lu restores, %lu begun\n", s.updates, s.restores, s.begun);
  CHECK(s.updates > 17 * SESSIONS && s.restores > 5 * SESSIONS && s.begun > 17 * SESSIONS);
  for (unsigned i = 0; i < FAMILIES; i++) {
    run_family(i, check_seed(SEED));
  }
  CHECK(unsettled < 100 || world_is_tight());
  return check_done("plane_scene_random");
}
