// A long run of random operations on a scene, saves and restores among them, against a search of all pairs.
//
// scene-soak OPERATIONS [SEED]
#include <stdlib.h>

#include "check.h"
#include "scene/session.h"

int main(int argc, char **argv) {
  static session s;
  const unsigned long operations = argc > 1 ? strtoul(argv[1], NULL, 10) : 20000;
  random_state random = random_seed(argc > 2 ? strtoul(argv[2], NULL, 10) : 1);
  unsigned long done = 0, failures = 0;
  bool fine = true;
  while (done < operations && fine) {
    const world_options options = session_options(&random);
    fine = session_start(&s, &options);
    for (int round = 0; round < 500 && fine && done < operations; round++) {
      const uint32_t changes = random_below(&random, 30);
      for (uint32_t i = 0; i < changes && fine; i++, done++) {
        fine = world_change(&s.now, &random);
      }
      fine = fine && gjk_scene_check(&s.now.scene) == GJK_OK && session_update(&s, &random);
      const uint32_t what = random_below(&random, 20);
      if (what == 0) {
        session_keep(&s);
      } else if (what < 3) {
        fine = session_move(&s, what == 2) && fine;
      }
    }
    CHECK_MSG(fine, "after %lu operations, %lu updates", done, s.updates);
    failures += s.now.failures;
    session_end(&s);
  }
  printf("%lu operations, %lu of them refused for lack of room; %lu updates, %lu restores, %lu touches begun\n", done,
         failures, s.updates, s.restores, s.begun);
  // The mix must still do all of it.
  CHECK(failures * 400 > done);
  CHECK(s.restores * 30 > s.updates);
  CHECK(s.begun * 5 > s.updates);
  return check_done("scene_soak");
}
