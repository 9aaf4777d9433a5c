// A pile that falls and comes to rest, as pictures one beside the other: gjk-demo-stack OUT.svg
#include <errno.h>
#include <string.h>

#include "demo_stack.h"

// Ticks.
static const unsigned moments[DEMO_MOMENTS] = {24, 60, 15 * SOLVER_RATE};

int main(int argc, char **argv) {
  static demo_stack d;
  if (argc != 2) {
    fputs("usage: gjk-demo-stack OUT.svg\n", stderr);
    return 2;
  }
  demo_stack_start(&d);
  FILE *file = fopen(argv[1], "w");
  if (file == NULL) {
    fprintf(stderr, "%s: %s\n", argv[1], strerror(errno));
    return 2;
  }
  demo_stack_open(file);
  for (unsigned tick = 0, k = 0; k < DEMO_MOMENTS; tick++) {
    if (tick == moments[k]) {
      demo_stack_draw(file, &d, k++, tick);
    }
    solver_step(&d.world);
  }
  fputs("</svg>\n", file);
  const bool failed = ferror(file) != 0;
  if (fclose(file) != 0 || failed) {
    fprintf(stderr, "%s: cannot write the picture\n", argv[1]);
    return 2;
  }
  const double speed = (double)solver_speed(&d.world) / (double)SOLVER_ONE;
  printf("%u bodies, %u pairs in contact, the fastest at %.4f units a second; picture: %s\n", demo_stack_falling(&d),
         d.world.pairs[d.world.now], speed, argv[1]);
  return 0;
}
