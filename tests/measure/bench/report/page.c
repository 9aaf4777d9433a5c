// Writes the page of a run.
#include "page.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../../programs/demo/svg.h"
#include "opening.h"
#include "plot.h"
#include "style.h"
#include "text.h"

// Errors below this, in LSB, are drawn in the band of 0.
#define ERROR_FLOOR 1e-4
#define ITERATIONS_MAX 24

// A method's point in a plot with a series for each series of the table.
static void add_method_point(const table *t, plot *p, const char *method, plot_point point) {
  const size_t s = table_series(t, method, &point.number);
  point.title = method;
  if (table_series_size(t, t->series.name[s]) == 1) {
    point.number = 0;
  }
  plot_add_point(&p->series[s], point);
}

// Is it one of several settings of a method that stops early? Such a method decides nothing until it is sure.
static bool is_stopped(const table *t, const char *method) {
  int setting;
  return table_series_size(t, t->series.name[table_series(t, method, &setting)]) > 1;
}

static void add_all_series(const table *t, plot *p) {
  for (size_t s = 0; s < t->series.count; s++) {
    plot_add_series(p, t->series.name[s], (unsigned)s, table_series_size(t, t->series.name[s]) > 1);
  }
}

// Plots a measure against the time, a point for each method. tail: another measure, at which a thin line from the point
// ends, or NULL.
static void put_against_time(FILE *file, const table *t, const char *family, const char *query, const char *measure,
                             const char *tail, const char *y_label, double floor) {
  static plot p;
  char title[80];
  snprintf(title, sizeof title, "%s: %s", family, query);
  const bool of_pairs = strcmp(measure, "wrong") == 0, of_distance = strcmp(query, "distance") == 0,
             of_contacts = strcmp(query, "contacts") == 0;
  plot_start(&p, title, "time per query, ns", y_label);
  p.x.logarithmic = p.y.logarithmic = true;
  p.y.floor = floor;
  if (strcmp(measure, "error_most") == 0) {
    p.mark = of_distance ? 0.5 : of_contacts ? 2 : 1;
    p.mark_name = of_distance ? "½ LSB" : of_contacts ? "2 LSB" : "1 LSB";
  }
  add_all_series(t, &p);
  for (size_t m = 0; m < t->methods.count; m++) {
    const char *method = t->methods.name[m];
    if (of_pairs && is_stopped(t, method)) {
      continue;
    }
    const double share = of_pairs ? 100 / table_get(t, family, query, method, "pairs") : 1;
    const plot_point point = {table_get(t, family, query, method, "time"),
                              share * table_get(t, family, query, method, measure),
                              tail != NULL ? table_get(t, family, query, method, tail) : NAN, NULL, 0};
    add_method_point(t, &p, method, point);
  }
  plot_write_points(file, &p);
}

static void put_error_plots(FILE *file, const table *t, const char *query) {
  for (size_t f = 0; f < t->families.count; f++) {
    if (table_asked(t, t->families.name[f], query)) {
      put_against_time(file, t, t->families.name[f], query, "error_most", "error_mean",
                       "error, LSB: largest (mark) to mean (line's end)", ERROR_FLOOR);
    }
  }
}

// What is wrong: decisions, or for depths and contacts, answers.
static const char *wrong_what(const char *query) {
  return strcmp(query, "depth") == 0 || strcmp(query, "contacts") == 0 ? "answers" : "decisions";
}

// Plots the families in which any method decides wrongly.
static void put_wrong_plots(FILE *file, const table *t, const char *query) {
  char label[64];
  snprintf(label, sizeof label, "wrong %s, %% of the pairs", wrong_what(query));
  for (size_t f = 0; f < t->families.count; f++) {
    double wrong = 0;
    for (size_t m = 0; m < t->methods.count; m++) {
      const double of_method = table_get(t, t->families.name[f], query, t->methods.name[m], "wrong");
      wrong += isfinite(of_method) ? of_method : 0;
    }
    if (wrong > 0) {
      put_against_time(file, t, t->families.name[f], query, "wrong", NULL, label, 0.01);
    }
  }
}

static bool is_drawn(const plot *p) {
  size_t points = 0;
  for (size_t s = 0; s < p->count; s++) {
    points += p->series[s].count;
  }
  return points > 0;
}

// Plots a measure against the number of vertices of each shape, over the families of hulls.
static void put_vertex_plot(FILE *file, const table *t, const char *query, const char *measure, const char *y_label) {
  static plot p;
  char title[80];
  snprintf(title, sizeof title, "hulls: %s", query);
  plot_start(&p, title, "vertices of each hull", y_label);
  p.x.logarithmic = p.y.logarithmic = true;
  for (size_t m = 0; m < t->methods.count; m++) {
    const char *method = t->methods.name[m];
    int setting;
    const size_t s = table_series(t, method, &setting);
    if (is_stopped(t, method)) {
      continue;
    }
    plot_series *series = plot_add_series(&p, method, (unsigned)s, true);
    for (size_t f = 0; f < t->families.count; f++) {
      const char *family = t->families.name[f];
      if (strstr(family, "hulls-") != NULL) {
        const plot_point point = {table_get(t, family, "", "", "vertices"),
                                  table_get(t, family, query, method, measure), NAN, NULL, 0};
        plot_add_point(series, point);
      }
    }
  }
  if (is_drawn(&p)) {
    plot_write_points(file, &p);
  }
}

// Plots how many queries take how many iterations, all families together.
static void put_iterations_plot(FILE *file, const table *t, const char *query) {
  static plot p;
  char title[80];
  snprintf(title, sizeof title, "all families: %s", query);
  plot_start(&p, title, "iterations (24 stands for more as well)", "queries, %");
  for (size_t m = 0; m < t->methods.count; m++) {
    const char *method = t->methods.name[m];
    double counts[ITERATIONS_MAX + 1];
    const double sum = table_histogram(t, NULL, query, method, "iterations", ITERATIONS_MAX, counts);
    int setting;
    const size_t s = table_series(t, method, &setting);
    if (sum > 0 && !is_stopped(t, method)) {
      plot_series *series = plot_add_series(&p, method, (unsigned)s, false);
      for (int i = 0; i <= ITERATIONS_MAX; i++) {
        const plot_point point = {i, 100 * counts[i] / sum, NAN, NULL, 0};
        if (counts[i] > 0) {
          plot_add_point(series, point);
        }
      }
    }
  }
  if (is_drawn(&p)) {
    plot_write_bars(file, &p);
  }
}

static bool is_listed(const char *const *names, size_t count, const char *name) {
  for (size_t i = 0; i < count; i++) {
    if (strcmp(names[i], name) == 0) {
      return true;
    }
  }
  return false;
}

static int compare_gaps(const void *a, const void *b) {
  const int x = atoi(*(const char *const *)a), y = atoi(*(const char *const *)b);
  return (x > y) - (x < y);
}

// The gaps at which the pairs of a family were placed, or the depths that they have, in order. family: NULL for all.
static size_t find_gaps(const table *t, const char *family, const char *query, const char *gaps[TABLE_NAMES_MAX]) {
  size_t count = 0;
  for (size_t i = 0; i < t->count; i++) {
    const table_row *r = &t->rows[i];
    if (count < TABLE_NAMES_MAX && strcmp(r->measure, "gap_pairs") == 0 &&
        (family == NULL || strcmp(r->family, family) == 0) && strcmp(r->query, query) == 0 &&
        strcmp(r->method, t->methods.name[0]) == 0 && !is_listed(gaps, count, r->at)) {
      gaps[count++] = r->at;
    }
  }
  qsort(gaps, count, sizeof *gaps, compare_gaps);
  return count;
}

// A share of wrong or undecided answers as it is written: in percent, at least 1.
static plot_cell share_cell(double wrong, double undecided) {
  plot_cell cell = {wrong, ""};
  if (wrong > 0 || undecided == 0) {
    snprintf(cell.text, sizeof cell.text, "%.0f", wrong > 0 && wrong < 0.01 ? 1 : 100 * wrong);
  } else if (undecided > 0) {
    snprintf(cell.text, sizeof cell.text, "?%.0f", 100 * undecided);
  }
  return cell;
}

static plot_cell gap_cell(const table *t, const char *family, const char *query, const char *method, const char *gap) {
  const int at = atoi(gap);
  const double pairs = table_at(t, family, query, method, "gap_pairs", at);
  return share_cell(table_at(t, family, query, method, "gap_wrong", at) / pairs,
                    table_at(t, family, query, method, "gap_undecided", at) / pairs);
}

// Plots wrong depths against the true depth, all families together.
static void put_depth_map(FILE *file, const table *t) {
  static plot_cell cells[TABLE_NAMES_MAX * TABLE_NAMES_MAX];
  const char *depths[TABLE_NAMES_MAX], *methods[TABLE_NAMES_MAX];
  const size_t columns = find_gaps(t, NULL, "depth", depths);
  size_t rows = 0;
  for (size_t m = 0; m < t->methods.count && columns > 0; m++) {
    const char *method = t->methods.name[m];
    methods[rows] = method;
    bool asked = false;
    for (size_t k = 0; k < columns; k++) {
      const double pairs = table_sum_at(t, "depth", method, "gap_pairs", atoi(depths[k]));
      const double wrong = table_sum_at(t, "depth", method, "gap_wrong", atoi(depths[k]));
      cells[rows * columns + k] = share_cell(wrong / pairs, 0);
      asked = asked || pairs > 0;
    }
    rows += asked;
  }
  if (rows > 0) {
    plot_write_map(file, "all families: depth", "true depth, LSB: at most, and more than the one before", methods, rows,
                   depths, columns, cells);
  }
}

static void put_gap_map(FILE *file, const table *t, const char *family, const char *query) {
  static plot_cell cells[TABLE_NAMES_MAX * TABLE_NAMES_MAX];
  const char *gaps[TABLE_NAMES_MAX], *methods[TABLE_NAMES_MAX];
  const size_t columns = find_gaps(t, family, query, gaps);
  size_t rows = 0;
  char title[80];
  for (size_t m = 0; m < t->methods.count; m++) {
    if (isfinite(table_get(t, family, query, t->methods.name[m], "pairs"))) {
      methods[rows] = t->methods.name[m];
      for (size_t k = 0; k < columns; k++) {
        cells[rows * columns + k] = gap_cell(t, family, query, methods[rows], gaps[k]);
      }
      rows++;
    }
  }
  if (columns > 0) {
    snprintf(title, sizeof title, "%s: %s", family, query);
    plot_write_map(file, title, "gap that the pair was placed at, LSB (below 0: overlap)", methods, rows, gaps, columns,
                   cells);
  }
}

static void put_number(FILE *file, const char *format, double value) {
  fprintf(file, "<td>");
  if (isfinite(value)) {
    fprintf(file, format, value);
  } else {
    fprintf(file, "–");
  }
  fprintf(file, "</td>");
}

static void put_table(FILE *file, const table *t, const char *family, const char *query) {
  fprintf(file, "<h3>%s: %s</h3>\n<div class=\"wide\"><table>\n<tr><th>method</th>", family, query);
  for (size_t c = 0; c < text_column_count; c++) {
    if (text_column_used(&text_columns[c], t, family, query)) {
      fprintf(file, "<th>%s</th>", text_columns[c].heading);
    }
  }
  fprintf(file, "</tr>\n");
  for (size_t m = 0; m < t->methods.count; m++) {
    const char *method = t->methods.name[m];
    if (!isfinite(table_get(t, family, query, method, "pairs"))) {
      continue;
    }
    fprintf(file, "<tr><td>");
    svg_text(file, method);
    fprintf(file, "</td>");
    for (size_t c = 0; c < text_column_count; c++) {
      const text_column *column = &text_columns[c];
      if (text_column_used(column, t, family, query)) {
        put_number(file, column->format, column->get(t, family, query, method, column->measure));
      }
    }
    fprintf(file, "</tr>\n");
  }
  fprintf(file, "</table></div>\n");
}

static void open_section(FILE *file, const char *heading, const char *text) {
  fprintf(file, "<h2>%s</h2>\n<p>%s</p>\n<div class=\"plots\">\n", heading, text);
}

static void put_head(FILE *file) {
  fprintf(file,
          "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>gjk: time against error</title>\n"
          "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<style>%s</style></head>\n"
          "<body>\n<h1>gjk: time against error</h1>\n",
          page_style);
}

// What was measured, and how.
static void put_about(FILE *file, const table *t) {
  fprintf(file, "<h2>What was measured</h2>\n<ul>\n");
  for (size_t i = 0; i < t->count; i++) {
    if (strcmp(t->rows[i].measure, "about") == 0) {
      fprintf(file, "<li>");
      svg_text(file, t->rows[i].text);
      fprintf(file, "</li>\n");
    }
  }
  fprintf(file, "</ul>\n<dl>\n");
  for (size_t f = 0; f < t->families.count; f++) {
    fprintf(file, "<dt>%s</dt><dd>", t->families.name[f]);
    svg_text(file, table_text(t, t->families.name[f], "", "", "what"));
    const double exact = table_get(t, t->families.name[f], "", "", "exact");
    if (isfinite(exact)) {
      fprintf(file, " (%.0f depths proven in exact integers)", exact);
    }
    fprintf(file, "</dd>\n");
  }
  fprintf(file, "</dl>\n");
}

static bool has(const table *t, const char *measure) {
  for (size_t i = 0; i < t->count; i++) {
    if (strcmp(t->rows[i].measure, measure) == 0) {
      return true;
    }
  }
  return false;
}

static void put_gap_maps(FILE *file, const table *t) {
  for (size_t f = 0; f < t->families.count; f++) {
    for (size_t q = 0; q < t->queries.count; q++) {
      if (strcmp(t->queries.name[q], "depth") != 0) {
        put_gap_map(file, t, t->families.name[f], t->queries.name[q]);
      }
    }
  }
}

static void put_cost_plots(FILE *file, const table *t) {
  for (size_t q = 0; q < t->queries.count; q++) {
    put_vertex_plot(file, t, t->queries.name[q], "time", "time per query, ns");
  }
  for (size_t q = 0; q < t->queries.count && has(t, "instructions"); q++) {
    put_vertex_plot(file, t, t->queries.name[q], "instructions", "instructions per query");
  }
}

static void put_error_sections(FILE *file, const table *t) {
  static const char marks[] =
      "Each method a mark, at its largest error; a thin line leads from there to its mean error. Errors below "
      "10<sup>-4</sup> LSB, and 0, lie in the grey band.";
  static const struct {
    const char *query, *text;
  } sections[] = {
      {"distance",
       "Numbers at gjk stopped early: the iterations, or the error in LSB, that it was allowed. A pair that a method "
       "takes for touching counts with its whole gap."},
      {"depth",
       "Against the real least depth. Where a method gives no answer, or says apart, the whole depth counts. gjk "
       "rounds "
       "up to the next LSB, so that a move by the depth parts the shapes: its error is up to 1 LSB by contract. Depths "
       "of pairs that are not proven least in exact integers are those of a facet that the certificate names, while "
       "the "
       "reference in double knows of none that is lower by more than the rounding."},
      {"contacts", "Of the deepest contact of a manifold of four points at most, against the real least depth."}};
  for (size_t i = 0; i < sizeof sections / sizeof sections[0]; i++) {
    char heading[64], text[1024];
    snprintf(heading, sizeof heading, "Error against time: %s", sections[i].query);
    snprintf(text, sizeof text, "%s %s", marks, sections[i].text);
    open_section(file, heading, text);
    put_error_plots(file, t, sections[i].query);
    fprintf(file, "</div>\n");
  }
}

void page_write(FILE *file, const table *t, const scene_table *scenes) {
  put_head(file);
  opening_write(file, t);
  put_about(file, t);
  put_error_sections(file, t);
  for (size_t q = 0; q < t->queries.count; q++) {
    char heading[80];
    const char *what = wrong_what(t->queries.name[q]);
    snprintf(heading, sizeof heading, "Wrong %s against time: %s", what, t->queries.name[q]);
    open_section(
        file, heading,
        strcmp(what, "answers") == 0
            ? "The families in which any method is wrong; 0 lies in the grey band. Wrong: failed; says that the "
              "shapes are apart; more than 1 LSB and more than 1 % too small or too large. The tables tell "
              "them apart."
            : "The families in which any method decides wrongly; 0 lies in the grey band. gjk stopped early "
              "decides nothing that it has not proven: see the tables for what it leaves undecided.");
    put_wrong_plots(file, t, t->queries.name[q]);
    fprintf(file, "</div>\n");
  }
  open_section(
      file, "Wrong decisions against the gap",
      "Percent of the pairs of each gap that a method decides wrongly; ?n: percent that it leaves open, having "
      "been told to stop.");
  put_gap_maps(file, t);
  fprintf(file, "</div>\n");
  open_section(file, "Wrong answers against the depth",
               "Percent of the pairs that overlap by so much whose depth a method gets wrong, over all families of "
               "depths.");
  put_depth_map(file, t);
  fprintf(file, "</div>\n");
  open_section(file, "Iterations", "How many iterations (support scans of both shapes) the queries took.");
  for (size_t q = 0; q < t->queries.count; q++) {
    put_iterations_plot(file, t, t->queries.name[q]);
  }
  fprintf(file, "</div>\n");
  open_section(file, "Cost against the number of vertices", "Every method scans all vertices for a support point.");
  put_cost_plots(file, t);
  fprintf(file, "</div>\n");
  if (scenes != NULL) {
    scene_write(file, scenes);
  }
  fprintf(file,
          "<h2>All numbers</h2>\n<p>x gjk: time against that of gjk cold. Errors in LSB (2<sup>-16</sup> "
          "unit) against the exact real distance or depth.</p>\n<div class=\"tables\">\n");
  for (size_t f = 0; f < t->families.count; f++) {
    for (size_t q = 0; q < t->queries.count; q++) {
      if (table_asked(t, t->families.name[f], t->queries.name[q])) {
        fprintf(file, "<div>");
        put_table(file, t, t->families.name[f], t->queries.name[q]);
        fprintf(file, "</div>\n");
      }
    }
  }
  fprintf(file, "</div>\n</body></html>\n");
}
