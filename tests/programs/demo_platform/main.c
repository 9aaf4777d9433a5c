// Draws the platform game of tests/programs/examples: while its crates fall, while they land and when they sleep, with the way
// of the runner so far. main PICTURE.svg
#define PLATFORM_IS_MEASURED
#include <stdio.h>

#include "gjk2/draw.h"
#include "tests/programs/examples/platform.c"

#define SCALE 24  // pixels a unit
#define WIDTH (40 * SCALE)
#define HEIGHT (10 * SCALE)
#define MOMENTS 3
#define TRAIL 600

static FILE *file;
static gjk2_vec trail[TRAIL];

static double pixel(gjk_q16 x) {
  return (double)x * SCALE / GJK_Q16_ONE;
}

static void draw_line(void *user, const gjk2_vec *from, const gjk2_vec *to, gjk_draw_role role) {
  static const char *const colours[] = {
      [GJK_DRAW_STATIC] = "#334155", [GJK_DRAW_MOVING] = "#c2410c", [GJK_DRAW_ASLEEP] = "#94a3b8"};
  (void)user;
  fprintf(file, "<path stroke=\"%s\" d=\"M%.1f %.1fL%.1f %.1f\"/>\n", colours[role], pixel(from->x), -pixel(from->y),
          pixel(to->x), -pixel(to->y));
}

static void draw_segment(void *user, const gjk2_vec *from, const gjk2_vec *to, uint32_t segment) {
  (void)segment;
  draw_line(user, from, to, GJK_DRAW_STATIC);
}

// The level, the bodies, the runner and its way of so many ticks.
static bool draw_moment(int moment, int ticks) {
  const gjk2_draw draw = {draw_line, NULL, NULL};
  const gjk2_aabb all = {{0, 0}, {GJK_Q16(40), GJK_Q16(3)}};
  fprintf(file,
          "<g transform=\"translate(0 %d)\"><text fill=\"#334155\" x=\"%d\" y=\"%d\">tick %d</text>\n<path "
          "stroke=\"#2563eb\" d=\"",
          (moment + 1) * HEIGHT - 4, SCALE, SCALE * 2 - HEIGHT, ticks);
  for (int i = 0; i < ticks; i++) {
    fprintf(file, "%c%.1f %.1f", i == 0 ? 'M' : 'L', pixel(trail[i].x), -pixel(trail[i].y));
  }
  fprintf(file, "\"/>\n");
  const bool fine = gjk2_ground_visit(&ground, &pose[LEVEL], &all, draw_segment, NULL) == GJK_OK &&
                    gjk2_draw_scene(&draw, &scene, GJK_DRAW_SHAPES) == GJK_OK &&
                    gjk2_draw_collider(&draw, &runner, GJK_DRAW_MOVING) == GJK_OK;
  fprintf(file, "</g>\n");
  return fine;
}

int main(int count, char **arguments) {
  static const int moments[MOMENTS] = {100, 150, 500};
  file = count == 2 ? fopen(arguments[1], "w") : NULL;
  if (file == NULL) {
    fprintf(stderr, "usage: gjk-demo-platform PICTURE.svg\n");
    return 1;
  }
  fprintf(
      file,
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" font-family=\"sans-serif\" font-size=\"14\">\n"
      "<rect width=\"%d\" height=\"%d\" fill=\"#fff\"/>\n<g fill=\"none\">\n",
      WIDTH, MOMENTS * HEIGHT, WIDTH, MOMENTS * HEIGHT);
  bool fine = start();
  int time = 0;
  for (int moment = 0; moment < MOMENTS; moment++) {
    for (; fine && time < moments[moment]; time++) {
      trail[time] = runner.position;
      fine = tick(time);
    }
    fine = fine && draw_moment(moment, time);
  }
  fprintf(file, "</g>\n</svg>\n");
  return fclose(file) != 0 || !fine;
}
