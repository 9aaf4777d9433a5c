// Convex parts beside those of others: how many, in what time, how far they reach beyond the solid, and what they leave out.
//
// main MESH...: meshes in millimetres. MESH=PARTS: measures parts that some other program made, instead: an OBJ file, each
// part's vertices after a line 'o NAME' or 'g NAME', as V-HACD and CoACD write them.
//
// Each is to reach no farther beyond the solid than 2.5 % of its longest side, CoACD's default threshold. HACD's own measure is
// another one, so it is run with many settings, and that counts which has the fewest parts of those that reach no farther and leave
// out nothing that is farther from them; if none does, the one of the least error. All parts are rounded to the nearest LSB and judged alike.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "peer.h"
#include "tests/programs/convert/decompose.h"

enum { CELLS = 10000, SAMPLES = 200 };

// What is measured of parts.
typedef struct judgement {
  size_t parts, flat;    // flat: those without volume, which are left out
  double seconds;        // processor time
  excess_bounds excess;  // LSB
  bool enclosed;         // exactly
  double left_out;       // how far a point of the surface is outside all parts, at least; the farthest of many, LSB
} judgement;

static double seconds_since(clock_t begin) {
  return (double)(clock() - begin) / CLOCKS_PER_SEC;
}

// How far a point is beyond some face; below the distance, or it.
static double beyond(const part *p, const double x[3]) {
  double most = 0;
  for (unsigned f = 0; f < p->faces; f++) {
    const double n[3] = {(double)p->plane[f].n[0], (double)p->plane[f].n[1], (double)p->plane[f].n[2]};
    const double height = n[0] * x[0] + n[1] * x[1] + n[2] * x[2] - (double)p->plane[f].d;
    most = fmax(most, height / sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]));
  }
  return most;
}

// Points spread over all triangles.
static double left_out_by(const solid *s, const part *p, size_t parts, double step) {
  double most = 0;
  for (size_t t = 0; t < s->triangles; t++) {
    const int32_t *a = s->point[s->triangle[t][0]], *b = s->point[s->triangle[t][1]], *c = s->point[s->triangle[t][2]];
    double length = 0;
    for (int j = 0; j < 3; j++) {
      length = fmax(length, fmax(fabs((double)b[j] - a[j]), fabs((double)c[j] - a[j])));
    }
    const int count = 1 + (int)(length / step);
    for (int u = 0; u <= count; u++) {
      for (int v = 0; u + v <= count; v++) {
        double x[3], least = INFINITY;
        for (int j = 0; j < 3; j++) {
          x[j] = a[j] + ((double)b[j] - a[j]) * u / count + ((double)c[j] - a[j]) * v / count;
        }
        for (size_t i = 0; i < parts && least > most; i++) {
          least = fmin(least, beyond(&p[i], x));
        }
        most = fmax(most, least);
      }
    }
  }
  return most;
}

static double longest_side(const solid *s) {
  return fmax(s->high[0], fmax(s->high[1], s->high[2]));
}

static void judge(const solid *s, const part *p, size_t parts, judgement *out) {
  nearest_tree tree;
  enclose_report *report = solid_allocate(1, sizeof *report);
  nearest_build(&tree, s);
  out->parts = parts;
  out->excess.at_least = out->excess.at_most = 0;
  for (size_t i = 0; i < parts; i++) {
    if (!enclose_is_inside(s, &p[i])) {
      const excess_bounds one = excess_of(&tree, &p[i], 0.5L, INFINITY, CELLS);
      out->excess.at_least = fmaxl(out->excess.at_least, one.at_least);
      out->excess.at_most = fmaxl(out->excess.at_most, one.at_most);
    }
  }
  out->enclosed = enclose_check(s, p, parts, report);
  out->left_out = left_out_by(s, p, parts, longest_side(s) / SAMPLES);
  enclose_free(report);
  free(report);
  nearest_free(&tree);
}

// Rounds what others made, and judges it.
static void judge_others(const solid *s, const peer_parts *found, judgement *out) {
  part *p = solid_allocate(found->parts + 1, sizeof p[0]);
  size_t parts = 0, begin = 0;
  for (size_t i = 0; i < found->parts; begin = found->end[i++]) {
    const size_t points = found->end[i] - begin;
    int32_t(*point)[3] = solid_allocate(points + 1, sizeof point[0]);
    for (size_t n = 0; n < points; n++) {
      for (int j = 0; j < 3; j++) {
        point[n][j] = (int32_t)rint(fmin(SOLID_EXTENT, fmax(-SOLID_EXTENT, found->point[begin + n][j])));
      }
    }
    parts += part_build(&p[parts], point, points) ? 1 : 0;
    free(point);
  }
  judge(s, p, parts, out);
  out->flat = found->parts - parts;
  for (size_t i = 0; i < parts; i++) {
    part_free(&p[i]);
  }
  free(p);
}

static void print(const char *mesh, const char *method, const solid *s, const judgement *j) {
  const char *name = strrchr(mesh, '/');
  printf("| %s | %s | %zu | %.2f | %.2f %% | %s | %.2f %% |\n", name == NULL ? mesh : name + 1, method, j->parts,
         j->seconds, 100 * (double)j->excess.at_most / longest_side(s), j->enclosed ? "yes" : "no",
         100 * j->left_out / longest_side(s));
}

// With the usual options, if these cut exactly; else to the excess. False: the parts do not enclose the solid.
static bool by_gjk(const char *name, const solid *s, long double excess) {
  const decompose_options manners[] = {{-1, 0}, {excess, 0}};
  decomposition d;
  judgement own;
  memset(&own, 0, sizeof own);
  for (int i = 0; i < 2; i++) {
    const clock_t begin = clock();
    decompose(s, &manners[i], &d);
    own.seconds = seconds_since(begin);
    if (d.excess.at_most == 0 || i == 1) {
      break;
    }
    decompose_free(&d);
  }
  judge(s, d.part, d.parts, &own);
  decompose_free(&d);
  print(name, "gjk", s, &own);
  return own.enclosed;
}

#ifdef WITH_HACD
// What is too much, or too little.
static long double error_of(const judgement *j) {
  return fmaxl(j->excess.at_most, j->left_out);
}

static void by_hacd(const char *name, const solid *s, long double excess) {
  static const double concavities[] = {400, 280, 200, 140, 100, 70, 50, 35, 25, 18, 12, 9, 6, 3, 1.5, 0.75, 0.1};
  judgement best;
  memset(&best, 0, sizeof best);
  for (size_t i = 0; i < 2 * sizeof concavities / sizeof concavities[0]; i++) {
    const peer_settings settings = {concavities[i / 2], i % 2 == 1};
    peer_parts found;
    judgement one;
    const clock_t begin = clock();
    parts_by_hacd((const int32_t(*)[3])s->point, s->points, (const uint32_t(*)[3])s->triangle, s->triangles, &settings,
                  &found);
    one.seconds = seconds_since(begin);
    judge_others(s, &found, &one);
    const bool good = error_of(&one) <= excess, is_best_good = best.parts > 0 && error_of(&best) <= excess;
    if (one.parts > 0 && (best.parts == 0 || (good && (!is_best_good || one.parts < best.parts)) ||
                          (!good && !is_best_good && error_of(&one) < error_of(&best)))) {
      best = one;
    }
    free(found.point);
    free(found.end);
  }
  print(name, "HACD", s, &best);
}
#endif

static void *grow(void *memory, size_t bytes) {
  void *grown = realloc(memory, bytes);
  if (grown == NULL) {
    exit(2);
  }
  return grown;
}

// Parts of a file that another program wrote. False: it cannot be read.
static bool by_file(const char *name, const char *parts, const solid *s, double scale) {
  const int32_t origin[3] = {s->origin.x, s->origin.y, s->origin.z};
  FILE *file = fopen(parts, "r");
  char line[400];
  size_t count = 0;
  peer_parts found = {NULL, NULL, 0};
  judgement other;
  memset(&other, 0, sizeof other);
  while (file != NULL && fgets(line, sizeof line, file) != NULL) {
    double x[3];
    if (line[0] == 'o' || line[0] == 'g') {
      found.end = grow(found.end, (found.parts + 1) * sizeof found.end[0]);
      found.end[found.parts++] = count;
    } else if (found.parts > 0 && sscanf(line, "v %lf %lf %lf", &x[0], &x[1], &x[2]) == 3) {
      found.point = grow(found.point, (count + 1) * sizeof found.point[0]);
      for (int j = 0; j < 3; j++) {
        found.point[count][j] = x[j] * scale - origin[j];
      }
      found.end[found.parts - 1] = ++count;
    }
  }
  if (file != NULL) {
    fclose(file);
  }
  if (count > 0) {
    judge_others(s, &found, &other);
    print(name, "the file's", s, &other);
  }
  free(found.point);
  free(found.end);
  return count > 0;
}

static char *text_of(const char *name, size_t *bytes) {
  FILE *file = fopen(name, "rb");
  char *text = NULL;
  *bytes = 0;
  for (size_t got = 1; file != NULL && got > 0; *bytes += got) {
    text = grow(text, *bytes + 65536);
    got = fread(text + *bytes, 1, 65536, file);
  }
  if (file != NULL) {
    fclose(file);
  }
  return text;
}

// Measures one mesh. False: it cannot be read, or gjk's parts do not enclose it.
static bool measure(char *name) {
  const double scale = 65.536;
  char *parts = strchr(name, '='), problem[200];
  mesh m;
  solid s;
  memset(&m, 0, sizeof m);
  memset(&s, 0, sizeof s);
  if (parts != NULL) {
    *parts++ = '\0';
  }
  mesh_file file = {name, NULL, 0, scale, 0, "", NULL};
  char *text = text_of(name, &file.bytes);
  file.text = text;
  bool good = text != NULL && mesh_read(&m, &file);
  if (good) {
    mesh_weld(&m);
    good = solid_from_mesh(&s, &m, problem, sizeof problem);
  }
  if (good && parts != NULL) {
    good = by_file(name, parts, &s, scale);
  } else if (good) {
    const long double excess = longest_side(&s) / 40;
    good = by_gjk(name, &s, excess);
#ifdef WITH_HACD
    by_hacd(name, &s, excess);
#endif
  }
  if (!good) {
    fprintf(stderr, "%s: cannot be measured\n", name);
  }
  solid_free(&s);
  mesh_free(&m);
  free(text);
  return good;
}

int main(int argc, char **argv) {
  bool good = argc > 1;
  printf("| mesh | | parts | s | excess | encloses | left out |\n|---|---|---|---|---|---|---|\n");
  for (int i = 1; i < argc; i++) {
    good = measure(argv[i]) && good;
  }
  return good ? 0 : 1;
}
