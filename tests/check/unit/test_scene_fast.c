// Fast bodies under random changes: every impact of every update against a search of all parts, while the scene is saved,
// restored, moved to other memory and updated in slices, with small buffers, and by threads.
#include <pthread.h>
#include <stdlib.h>

#include "check.h"
#include "scene/session.h"

// The test of the plane has included the plane's.
#ifndef TEST_NAME
#define TEST_NAME "scene_fast"
#endif

#define SEED 7760
#define SESSIONS check_trials(30)
#define CHANGES 1200u

static void check_session(random_state *random, session *s) {
  world_options options = session_options(random);
  options.motions = true;
  options.edges = false;
  options.detail = options.detail > GJK_DETAIL_DISTANCE ? GJK_DETAIL_TOUCH : options.detail;
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
  random_state random = random_seed(check_seed(SEED));
  for (unsigned i = 0; i < SESSIONS; i++) {
    check_trial(i, NULL, NULL);
    check_session(&random, &s);
  }
  printf("%lu updates, %lu restores, %lu impacts, %lu of parts that turn, %lu touch at the start\n", s.updates,
         s.restores, world_expected.impacts, world_expected.turning, world_expected.starts);
  CHECK((s.updates > 400 && s.restores > 100) || !check_is_full());
  CHECK((world_expected.impacts > 500 && world_expected.turning > 100 && world_expected.starts > 100) ||
        world_is_tight() || !check_is_full());
  return check_done(TEST_NAME);
}
