// gjk-demo: answers a scene, checks the answers, prints them as a table, and draws the scene.
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "arm.h"
#include "picture.h"
#include "scene.h"
#include "source.h"
#include "swing.h"

static const char usage[] =
    "usage: gjk-demo SCENE OUT.svg     answers and certifies the cases, prints a table, draws a picture\n"
    "       gjk-demo --c-source SCENE  prints the cases and answers as C (see tests/programs/demo/demo_scene.h)\n";

static void put_line(const scene *s, size_t i) {
  const scene_pair *pair = &s->pair[i];
  const gjk_penetration_result *deep = &pair->overlap;
  const double unit = GJK_Q30_ONE;
  unsigned iterations = pair->answer.iterations;
  char names[160], gap[24] = "", lsb[16] = "", out[40] = "";
  snprintf(names, sizeof names, "%s - %s", s->body[pair->a].name, s->body[pair->b].name);
  if (pair->relation == SCENE_APART) {
    picture_gap_text(gap, pair->answer.distance);
    snprintf(lsb, sizeof lsb, "%ld", (long)pair->answer.distance);
  } else {
    iterations = deep->iterations;
  }
  if (pair->relation == SCENE_OVERLAPPING) {
    picture_gap_text(gap, -deep->depth);
    snprintf(lsb, sizeof lsb, "%ld", -(long)deep->depth);
    snprintf(out, sizeof out, "%.2f,%.2f,%.2f", deep->normal.x / unit, deep->normal.y / unit, deep->normal.z / unit);
  }
  printf("%3lu  %-32s %-12s %10s %12s  %-16s %6u  %s\n", (unsigned long)(i + 1), names,
         scene_relation_name(pair->relation), lsb, gap, out, iterations, scene_verdict_name(pair->verdict));
}

static int put_table(const scene *s) {
  unsigned long verdicts[3] = {0, 0, 0};
  printf("%3s  %-32s %-12s %10s %12s  %-16s %6s  %s\n", "", "pair", "answer", "gap in LSB", "(unit: 1 m)",
         "way out for B", "iterations", "certificate");
  for (size_t i = 0; i < s->pairs; i++) {
    put_line(s, i);
    verdicts[s->pair[i].verdict]++;
  }
  printf("%lu pairs: %lu proven in exact integers, %lu curved and within accurate bounds, %lu wrong\n",
         (unsigned long)s->pairs, verdicts[CERTIFY_PROVEN], verdicts[CERTIFY_UNCERTIFIED], verdicts[CERTIFY_WRONG]);
  return verdicts[CERTIFY_WRONG] > 0 ? 1 : 0;
}

// The first impact of the arm's swing, where the scene has an arm.
static void put_swing(const scene *s, const scene_swing *swing) {
  if (swing->found) {
    printf("swing: %s hits %s after %.3f degrees, and not before: proven with %u distances\n", s->body[swing->a].name,
           s->body[swing->b].name, swing_degrees(swing), swing->impact.iterations);
  }
}

static long farthest(const gjk_vec3 *a, const gjk_vec3 *b) {
  const long x = labs((long)a->x - b->x), y = labs((long)a->y - b->y), z = labs((long)a->z - b->z);
  return x > y ? (x > z ? x : z) : (y > z ? y : z);
}

// How far the arm's joints put its bodies from where the scene has them: centres, and points a unit up from these.
static void put_arm(const scene *s) {
  gjk_joint joints[ARM_JOINTS];
  gjk_pose frames[ARM_JOINTS];
  unsigned found = 0;
  long most = 0;
  if (!arm_make(joints) || !arm_frames(joints, frames)) {
    return;
  }
  for (size_t b = 0; b < s->bodies; b++) {
    for (unsigned i = 0; i < ARM_BODIES; i++) {
      for (gjk_q16 up = 0; up <= GJK_Q16_ONE && strcmp(s->body[b].name, arm_bodies[i].name) == 0; up += GJK_Q16_ONE) {
        const gjk_vec3 local = {0, 0, up}, along = {0, 0, arm_bodies[i].along + up};
        gjk_vec3 has, is;
        if (gjk_pose_apply(&s->body[b].shape.pose, &local, &has) == GJK_OK &&
            gjk_pose_apply(&frames[arm_bodies[i].joint], &along, &is) == GJK_OK) {
          most = farthest(&has, &is) > most ? farthest(&has, &is) : most;
          found += up == 0;
        }
      }
    }
  }
  if (found > 0) {
    printf("arm: %d joints put %u bodies within %ld LSB of the scene\n", ARM_JOINTS, found, most);
  }
}

static int draw(const scene *s, const scene_swing *swing, const char *name, const char *title) {
  FILE *file = fopen(name, "w");
  if (file == NULL) {
    fprintf(stderr, "%s: %s\n", name, strerror(errno));
    return 2;
  }
  picture_write(file, s, swing, title);
  bool failed = ferror(file) != 0;
  if (fclose(file) != 0 || failed) {
    fprintf(stderr, "%s: cannot write the picture\n", name);
    return 2;
  }
  printf("picture: %s\n", name);
  return 0;
}

int main(int argc, char **argv) {
  static scene s;
  bool source = argc == 3 && strcmp(argv[1], "--c-source") == 0;
  if (argc != 3 || (argv[1][0] == '-' && !source)) {
    fputs(usage, stderr);
    return 2;
  }
  const char *name = argv[source ? 2 : 1];
  FILE *file = fopen(name, "r");
  if (file == NULL) {
    fprintf(stderr, "%s: %s\n", name, strerror(errno));
    return 2;
  }
  bool good = scene_read(&s, file, name);
  fclose(file);
  int result = 2;
  if (good && source) {
    result = source_write(stdout, &s) ? 0 : 2;
  } else if (good) {
    const char *slash = strrchr(name, '/');
    int wrong = put_table(&s);
    scene_swing swing;
    swing_find(&s, &swing);
    put_swing(&s, &swing);
    put_arm(&s);
    int drawn = draw(&s, &swing, argv[2], slash == NULL ? name : slash + 1);
    result = drawn != 0 ? drawn : wrong;
  }
  scene_free(&s);
  if (fflush(stdout) != 0 || ferror(stdout) != 0) {
    fprintf(stderr, "gjk-demo: cannot write the table: %s\n", strerror(errno));
    return 2;
  }
  return result;
}
