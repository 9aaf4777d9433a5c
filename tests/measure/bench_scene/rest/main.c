// Scenes at rest and falling, replayed: see usage. A pass goes through a recording and back, 2 REST_TICKS ticks.
#define _POSIX_C_SOURCE 199309L
#include "../../measuring.h"
#include "gjk/pose.h"
#include "gjk2/pose.h"
#include "rest.h"

static const char usage[] =
    "usage: gjk-rest record DIR   lets all scenes fall under a solver, and writes their poses\n"
    "       gjk-rest time DIR     ns a tick, of each scene and method\n"
    "       gjk-rest count DIR    under callgrind: a dump of each scene and method\n";

#define PASSES 15
#define WARM_UP 2

// A library that is not linked has no method.
#pragma weak rest_bullet
#pragma weak rest_ode
static const rest_method *const methods[] = {&rest_gjk_manifolds, &rest_gjk_kept, &rest_gjk_near,
                                             &rest_bullet,        &rest_ode,      &rest_gjk2_manifolds,
                                             &rest_gjk2_kept,     &rest_gjk2_near};
#define METHODS (sizeof methods / sizeof methods[0])

static size_t pose_bytes(const rest_stage *s) {
  return (size_t)s->bodies * (REST_TICKS + 1) * (s->plane ? sizeof(gjk2_pose) : sizeof(gjk_pose));
}

static FILE *open_recording(const char *dir, const rest_stage *s, const char *mode) {
  char path[1000];
  snprintf(path, sizeof path, "%s/%s.poses", dir, s->name);
  return fopen(path, mode);
}

static bool write_recording(const char *dir, const rest_stage *s) {
  FILE *file = open_recording(dir, s, "wb");
  const bool fine = file != NULL && fwrite(s->poses, 1, pose_bytes(s), file) == pose_bytes(s);
  return file != NULL && fclose(file) == 0 && fine;
}

static bool read_recording(const char *dir, rest_stage *s) {
  FILE *file = open_recording(dir, s, "rb");
  const bool fine = file != NULL && fread(s->poses, 1, pose_bytes(s), file) == pose_bytes(s);
  if (file != NULL) {
    fclose(file);
  }
  return fine;
}

static bool pass(const rest_method *m, void *world, rest_found *found) {
  bool fine = true;
  for (unsigned i = 1; i <= 2 * REST_TICKS && fine; i++) {
    fine = m->go(world, i <= REST_TICKS ? i : 2 * REST_TICKS - i, found);
  }
  return fine;
}

// The others' worlds are there at the same time, so all methods are measured in turn.
static bool measure(const rest_stage *s) {
  void *world[METHODS] = {NULL};
  static double ns[METHODS][PASSES];
  rest_found found[METHODS] = {{0, 0, 0, 0, 0}};
  bool fine = true;
  for (unsigned p = 0; p < WARM_UP + PASSES; p++) {
    for (unsigned i = 0; i < METHODS && fine; i++) {
      if (methods[i] != NULL && methods[i]->plane == s->plane) {
        world[i] = world[i] != NULL ? world[i] : methods[i]->start(s);
        const double from = measuring_ns(CLOCK_PROCESS_CPUTIME_ID);
        fine = world[i] != NULL && pass(methods[i], world[i], &found[i]);
        ns[i][p < WARM_UP ? 0 : p - WARM_UP] = (measuring_ns(CLOCK_PROCESS_CPUTIME_ID) - from) / (2 * REST_TICKS);
      }
    }
  }
  for (unsigned i = 0; i < METHODS; i++) {
    if (world[i] != NULL) {
      const rest_found *f = &found[i];
      printf("%s;%s;ns;%.0f\n", s->name, methods[i]->name, measuring_median(ns[i], PASSES));
      printf("%s;%s;found;%u of %u moved, %u pairs, %u near, %u manifolds, %u queried\n", s->name, methods[i]->name,
             f->moved, s->bodies, f->pairs, f->near, f->manifolds, f->queried);
      methods[i]->stop(world[i]);
    }
  }
  fflush(stdout);
  return fine;
}

static bool count(const rest_stage *s) {
  bool fine = true;
  for (unsigned i = 0; i < METHODS && fine; i++) {
    if (methods[i] != NULL && methods[i]->plane == s->plane) {
      rest_found found = {0, 0, 0, 0, 0};
      char label[200];
      void *world = methods[i]->start(s);
      snprintf(label, sizeof label, "%s;%s", s->name, methods[i]->name);
      fine = world != NULL && pass(methods[i], world, &found) && measuring_count() && pass(methods[i], world, &found);
      measuring_dump(label);
      methods[i]->stop(world);
    }
  }
  return fine;
}

static bool record(const char *dir, rest_stage *s) {
  return (s->plane ? rest_record_plane(s) : rest_record(s)) && write_recording(dir, s);
}

int main(int argc, char **argv) {
  static rest_stage stage;
  const char *what = argc == 3 || argc == 4 ? argv[1] : "", *only = argc == 4 ? argv[3] : "";
  if (strcmp(what, "record") != 0 && strcmp(what, "time") != 0 && strcmp(what, "count") != 0) {
    fputs(usage, stderr);
    return 2;
  }
  for (unsigned i = 0; i < 100; i++) {
    const bool plane = i >= 50;
    if (!(plane ? rest_build_plane(i - 50, &stage) : rest_build(i, &stage)) || strstr(stage.name, only) == NULL) {
      rest_free(&stage);
      continue;
    }
    const bool recorded = what[0] == 'r' ? record(argv[2], &stage) : read_recording(argv[2], &stage);
    if (!recorded || !(what[0] == 'r' || (what[0] == 't' ? measure(&stage) : count(&stage)))) {
      fprintf(stderr, "gjk-rest: %s: failed\n", stage.name);
      return 1;
    }
    rest_free(&stage);
  }
  return 0;
}
