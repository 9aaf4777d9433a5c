// Writes the page's sections about scenes.
#include "scene.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "plot.h"

#define SHARES_BODIES 10000
#define LINES_PERCENT 5

// Cuts a line at its commas. Returns how many fields it has, at most SCENE_COLUMNS_MAX.
static unsigned split(char *line, char *fields[SCENE_COLUMNS_MAX]) {
  unsigned count = 0;
  line[strcspn(line, "\r\n")] = '\0';
  while (line != NULL && count < SCENE_COLUMNS_MAX) {
    fields[count++] = line;
    line = strchr(line, ',');
    if (line != NULL) {
      *line++ = '\0';
    }
  }
  return count;
}

static double number(const char *text) {
  char *end;
  const double value = strtod(text, &end);
  return end == text || *end != '\0' ? NAN : value;
}

bool scene_read(scene_table *out, FILE *file, const char *name) {
  char line[512], *fields[SCENE_COLUMNS_MAX];
  memset(out, 0, sizeof *out);
  while (fgets(line, sizeof line, file) != NULL && out->row_count < SCENE_ROWS_MAX) {
    const unsigned count = split(line, fields);
    if (out->column_count == 0 && (count < 3 || strcmp(fields[0], "scene") != 0)) {
      break;
    }
    if (out->column_count == 0) {
      out->column_count = count;
      for (unsigned i = 0; i < count; i++) {
        snprintf(out->columns[i], sizeof out->columns[i], "%s", fields[i]);
      }
    } else if (count == out->column_count) {
      snprintf(out->names[out->row_count], sizeof out->names[0], "%s", fields[0]);
      for (unsigned i = 0; i < count; i++) {
        out->values[out->row_count][i] = number(fields[i]);
      }
      out->row_count++;
    } else {
      fprintf(stderr, "%s: a row of %u fields, expected %u\n", name, count, out->column_count);
      return false;
    }
  }
  if (out->row_count == 0) {
    fprintf(stderr, "%s: expected the figures of scene-bench\n", name);
  }
  return out->row_count > 0;
}

static double get(const scene_table *t, unsigned row, const char *column) {
  for (unsigned i = 0; i < t->column_count; i++) {
    if (strcmp(t->columns[i], column) == 0) {
      return t->values[row][i];
    }
  }
  return NAN;
}

// Does a row before have the same name of a scene?
static bool is_first(const scene_table *t, unsigned row) {
  for (unsigned i = 0; i < row; i++) {
    if (strcmp(t->names[i], t->names[row]) == 0) {
      return false;
    }
  }
  return true;
}

static void put_lines(FILE *file, const scene_table *t, const char *name) {
  static const struct {
    const char *column, *name;
    unsigned style;
  } lines[] = {
      {.column = "gjk whole tick ns", .name = "gjk: whole tick, exact answers", .style = 0},
      {.column = "gjk broad phase ns", .name = "gjk: posing and broad phase", .style = 4},
      {.column = "gjk posing ns", .name = "gjk: posing alone", .style = 11},
      {.column = "all pairs ns", .name = "boxes of all pairs", .style = 7},
      {.column = "Bullet ns", .name = "Bullet btDbvtBroadphase", .style = 6},
      {.column = "FCL ns", .name = "FCL DynamicAABBTree", .style = 9},
  };
  static plot p;
  char title[80];
  snprintf(title, sizeof title, "%s: %d %% of the bodies moving", name, LINES_PERCENT);
  plot_start(&p, title, "bodies", "CPU time per tick, µs");
  p.x.logarithmic = p.y.logarithmic = true;
  for (unsigned i = 0; i < sizeof lines / sizeof lines[0]; i++) {
    plot_series *s = plot_add_series(&p, lines[i].name, lines[i].style, true);
    for (unsigned row = 0; row < t->row_count; row++) {
      if (strcmp(t->names[row], name) == 0 && get(t, row, "percent moving") == LINES_PERCENT) {
        const plot_point point = {get(t, row, "bodies"), get(t, row, lines[i].column) / 1000, NAN, NULL, 0};
        plot_add_point(s, point);
      }
    }
  }
  plot_write_points(file, &p);
}

static void put_shares(FILE *file, const scene_table *t, const char *name) {
  static const struct {
    const char *column, *name;
    unsigned style;
  } skips[] = {
      {.column = "% resting", .name = "neither side moved", .style = 10},
      {.column = "% motion", .name = "moved less than was proven", .style = 0},
      {.column = "% boxes", .name = "boxes or spheres apart", .style = 1},
      {.column = "% direction", .name = "last direction still separates", .style = 4},
      {.column = "% warm", .name = "queried, warm", .style = 6},
      {.column = "% cold", .name = "queried, cold", .style = 7},
  };
  static plot p;
  static char labels[PLOT_POINTS_MAX][32];
  const char *names[PLOT_POINTS_MAX];
  char title[80];
  size_t count = 0;
  snprintf(title, sizeof title, "%s: %d bodies", name, SHARES_BODIES);
  plot_start(&p, title, "bodies moving (pairs whose boxes met)", "pairs, %");
  for (unsigned i = 0; i < sizeof skips / sizeof skips[0]; i++) {
    plot_series *s = plot_add_series(&p, skips[i].name, skips[i].style, false);
    count = 0;
    for (unsigned row = 0; row < t->row_count && count < PLOT_POINTS_MAX; row++) {
      const double pairs = get(t, row, "gjk pairs");
      if (strcmp(t->names[row], name) == 0 && get(t, row, "bodies") == SHARES_BODIES && pairs > 0) {
        const plot_point point = {(double)count, get(t, row, skips[i].column), NAN, NULL, 0};
        plot_add_point(s, point);
        snprintf(labels[count], sizeof labels[0], "%.0f %% (%.0f)", get(t, row, "percent moving"), pairs);
        names[count] = labels[count];
        count++;
      }
    }
  }
  if (count > 0) {
    plot_write_stacks(file, &p, names, count);
  }
}

static void put_plots(FILE *file, const scene_table *t, void (*put)(FILE *, const scene_table *, const char *)) {
  fprintf(file, "<div class=\"plots\">\n");
  for (unsigned row = 0; row < t->row_count; row++) {
    if (is_first(t, row)) {
      put(file, t, t->names[row]);
    }
  }
  fprintf(file, "</div>\n");
}

void scene_write(FILE *file, const scene_table *t) {
  fprintf(
      file,
      "<h2>Scenes: cost of a tick</h2>\n<p>CPU time, medians over repetitions of 10 ticks; all methods replay the "
      "same motion in one process. gjk poses the bodies that moved and takes their boxes, which Bullet, FCL and the "
      "test of all pairs get ready made: posing alone is a line of its own. Only the whole tick answers, exactly, "
      "which bodies touch; everything else stops at the boxes. FCL finds all pairs anew in each tick; gjk and Bullet "
      "keep them.</p>\n");
  put_plots(file, t, put_lines);
  fprintf(
      file,
      "<h2>Scenes: what becomes of the pairs</h2>\n<p>The pairs whose enlarged boxes met, by what settled them in a "
      "tick, cheapest first; only the last two kinds take a query. Under each bar the share of bodies that move, "
      "and how many pairs there were.</p>\n");
  put_plots(file, t, put_shares);
}
