// Plots as SVG for a page: points and lines, bars, and maps of numbers. Colours are classes of the page's style sheet.
#ifndef REPORT_PLOT_H
#define REPORT_PLOT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#define PLOT_SERIES_MAX 32
#define PLOT_POINTS_MAX 64

// An axis. low and high are widened to 1, 2 or 5 times a power of ten (log), or to round numbers.
typedef struct plot_axis {
  const char *label;  // with its unit
  bool logarithmic;
  double low, high;
  double floor;  // log: what is below is drawn in a band of its own at the low end; 0: no band
} plot_axis;

typedef struct plot_point {
  double x, y;
  double tail;        // where a thin line from the point ends, on the y axis; NAN: none
  const char *title;  // shown under the pointer
  int number;         // written beside the point; 0: nothing
} plot_point;

typedef struct plot_series {
  const char *name;
  unsigned style;  // which colour and mark
  bool line;
  plot_point points[PLOT_POINTS_MAX];
  size_t count;
} plot_series;

typedef struct plot {
  const char *title;
  plot_axis x, y;
  double mark;  // a dashed line across at this y, with its name; NAN: none
  const char *mark_name;
  plot_series series[PLOT_SERIES_MAX];
  size_t count;
} plot;

// Makes an empty plot.
void plot_start(plot *p, const char *title, const char *x_label, const char *y_label);
plot_series *plot_add_series(plot *p, const char *name, unsigned style, bool line);
// Adds a point to a series. Points that are not numbers are left out.
void plot_add_point(plot_series *s, plot_point point);

// Writes points, joined where a series is a line, with a legend.
void plot_write_points(FILE *file, const plot *p);
// Writes bars from 0, side by side; x are small integers.
void plot_write_bars(FILE *file, const plot *p);
// Writes bars of 0 to 100, one for each name. Each is a stack of the points of all series there.
void plot_write_stacks(FILE *file, const plot *p, const char *const *names, size_t count);

// Writes a map of numbers: a cell for each row and column, the redder the nearer it is to 1, with the text in it.
typedef struct plot_cell {
  double share;  // 0 to 1; NAN: no cell
  char text[16];
} plot_cell;

void plot_write_map(FILE *file, const char *title, const char *x_label, const char *const *rows, size_t row_count,
                    const char *const *columns, size_t column_count, const plot_cell *cells);

#endif
