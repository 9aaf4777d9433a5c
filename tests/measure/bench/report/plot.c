// Writes plots as SVG.
#include "plot.h"

#include <math.h>
#include <string.h>

#include "../../../programs/demo/labels.h"

#define WIDTH 620.0
#define HEIGHT 400.0
#define LEFT 80.0
#define RIGHT 26.0
#define TOP 14.0
#define BOTTOM 52.0
#define BAND 34.0  // of an axis for what is below its floor
#define TICKS_MAX 64
#define NAME_WIDTH 50.0  // of the name of the line across

// The place of a value on the page.
typedef struct scale {
  const plot_axis *axis;
  double low, high;  // the axis' own, or their logarithms
  double from, to;   // pixels
  double below;      // pixel of the band's middle
} scale;

typedef struct ticks {
  double value[TICKS_MAX];
  size_t count;
} ticks;

void plot_start(plot *p, const char *title, const char *x_label, const char *y_label) {
  memset(p, 0, sizeof *p);
  p->title = title;
  p->x.label = x_label;
  p->y.label = y_label;
  p->x.low = p->y.low = INFINITY;
  p->x.high = p->y.high = -INFINITY;
  p->mark = NAN;
}

plot_series *plot_add_series(plot *p, const char *name, unsigned style, bool line) {
  plot_series *s = &p->series[p->count < PLOT_SERIES_MAX ? p->count++ : PLOT_SERIES_MAX - 1];
  s->name = name;
  s->style = style;
  s->line = line;
  s->count = 0;
  return s;
}

void plot_add_point(plot_series *s, plot_point point) {
  if (isfinite(point.x) && isfinite(point.y) && s->count < PLOT_POINTS_MAX) {
    s->points[s->count++] = point;
  }
}

static void widen(plot_axis *axis, double value) {
  if (isfinite(value) && value >= axis->floor && (!axis->logarithmic || value > 0)) {
    axis->low = value < axis->low ? value : axis->low;
    axis->high = value > axis->high ? value : axis->high;
  }
}

// Sets both axes from what is to be drawn.
static void fit(plot *p) {
  for (size_t i = 0; i < p->count; i++) {
    for (size_t k = 0; k < p->series[i].count; k++) {
      widen(&p->x, p->series[i].points[k].x);
      widen(&p->y, p->series[i].points[k].y);
      widen(&p->y, p->series[i].points[k].tail);
    }
  }
  widen(&p->y, p->mark);
}

// The largest of 1, 2, 5 times a power of ten that is at most x, or the smallest that is at least x.
static double round_to_125(double x, bool up) {
  const double power = pow(10, floor(log10(x) + 1e-9)), lead = x / power;
  if (up) {
    return power * (lead <= 1 + 1e-9 ? 1 : lead <= 2 ? 2 : lead <= 5 ? 5 : 10);
  }
  return power * (lead >= 5 ? 5 : lead >= 2 ? 2 : 1);
}

static double step_of(const plot_axis *axis) {
  return round_to_125((axis->high - axis->low) / 10, true);
}

// Rounds the ends outward.
static void round_ends(plot_axis *axis) {
  if (axis->floor > 0) {
    axis->low = axis->floor;
    axis->high = axis->high > axis->low ? axis->high : axis->low;
  }
  if (!(axis->low <= axis->high)) {
    axis->low = axis->high = 1;
  }
  if (axis->logarithmic) {
    const bool decades = axis->high / axis->low > 1000;
    axis->low = decades ? pow(10, floor(log10(axis->low))) : round_to_125(axis->low, false);
    axis->high = decades ? pow(10, ceil(log10(axis->high))) : round_to_125(axis->high, true);
    axis->high = axis->high > axis->low ? axis->high : 10 * axis->low;
  } else {
    axis->high = axis->high > axis->low ? axis->high : axis->low + 1;
    axis->high = step_of(axis) * ceil(axis->high / step_of(axis) - 1e-9);
  }
}

static double place(const scale *s, double value) {
  if (value < s->axis->floor) {
    return s->below;
  }
  const double at = s->axis->logarithmic ? log10(value) : value;
  return s->from + (s->to - s->from) * (at - s->low) / (s->high - s->low);
}

static scale make_scale(const plot_axis *axis, double from, double to) {
  const double sign = to > from ? 1 : -1;
  scale s = {axis, axis->low, axis->high, from, to, from};
  if (axis->logarithmic) {
    s.low = log10(axis->low);
    s.high = log10(axis->high);
  }
  if (axis->floor > 0) {
    s.below = from + sign * BAND / 2;
    s.from = from + sign * BAND;
  }
  return s;
}

static void add_tick(ticks *t, const plot_axis *axis, double value) {
  if (value >= axis->low * (1 - 1e-9) - 1e-12 && (axis->floor == 0 || value > axis->floor * 1.01) &&
      value <= axis->high * (1 + 1e-9) && t->count < TICKS_MAX) {
    t->value[t->count++] = value;
  }
}

static ticks make_ticks(const plot_axis *axis) {
  ticks t = {{0}, 0};
  if (!axis->logarithmic) {
    const double step = step_of(axis);
    for (int i = 0; i < TICKS_MAX; i++) {
      add_tick(&t, axis, step * (ceil(axis->low / step - 1e-9) + i));
    }
    return t;
  }
  const int first = (int)floor(log10(axis->low) + 1e-9), last = (int)ceil(log10(axis->high) - 1e-9);
  const int every = last - first > 8 ? 2 : 1;
  for (int decade = first; decade <= last; decade += every) {
    add_tick(&t, axis, pow(10, decade));
    for (int lead = 2; lead <= 8 && last - first <= 3; lead++) {
      if (lead == 2 || lead == 5 || (axis->high / axis->low < 6 && lead != 7)) {
        add_tick(&t, axis, lead * pow(10, decade));
      }
    }
  }
  return t;
}

static void put_number(FILE *file, double value) {
  const double size = fabs(value);
  if (size != 0 && (size >= 1e6 || size < 1e-3)) {
    const int power = (int)floor(log10(size) + 1e-9);
    const double lead = value / pow(10, power);
    if (fabs(lead - 1) > 1e-6) {
      fprintf(file, "%.3g×", lead);
    }
    fprintf(file, "10<tspan dy=\"-5\" font-size=\"10\">%d</tspan>", power);
  } else {
    fprintf(file, "%.6g", value);
  }
}

static void open_svg(FILE *file, const char *title, double width, double height) {
  fprintf(file, "<svg viewBox=\"0 0 %.0f %.0f\" role=\"img\" aria-label=\"", width, height);
  svg_text(file, title);
  fprintf(file, "\">\n");
}

static void open_figure(FILE *file, const char *kind, const char *title) {
  fprintf(file, "<figure class=\"%s\">\n<figcaption>", kind);
  svg_text(file, title);
  fprintf(file, "</figcaption>\n");
}

static void put_x_label(FILE *file, const plot_axis *axis) {
  fprintf(file, "<text text-anchor=\"middle\" x=\"%.1f\" y=\"%.1f\">", (LEFT + WIDTH - RIGHT) / 2, HEIGHT - 10);
  svg_text(file, axis->label);
  fprintf(file, "</text>\n");
}

static void put_x_axis(FILE *file, const scale *s) {
  const ticks t = make_ticks(s->axis);
  for (size_t i = 0; i < t.count; i++) {
    const double x = place(s, t.value[i]);
    fprintf(file, "<path class=\"grid\" d=\"M%.1f %.1fV%.1f\"/><text text-anchor=\"middle\" x=\"%.1f\" y=\"%.1f\">", x,
            TOP, HEIGHT - BOTTOM, x, HEIGHT - BOTTOM + 18);
    put_number(file, t.value[i]);
    fprintf(file, "</text>\n");
  }
  put_x_label(file, s->axis);
}

static void put_y_axis(FILE *file, const scale *s) {
  const ticks t = make_ticks(s->axis);
  for (size_t i = 0; i < t.count; i++) {
    const double y = place(s, t.value[i]);
    fprintf(file, "<path class=\"grid\" d=\"M%.1f %.1fH%.1f\"/><text text-anchor=\"end\" x=\"%.1f\" y=\"%.1f\">", LEFT,
            y, WIDTH - RIGHT, LEFT - 8, y + 4.5);
    put_number(file, t.value[i]);
    fprintf(file, "</text>\n");
  }
  if (s->axis->floor > 0) {
    fprintf(file, "<rect class=\"band\" x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\"/>", LEFT,
            s->below - BAND / 2, WIDTH - LEFT - RIGHT, BAND);
    fprintf(file, "<text text-anchor=\"end\" x=\"%.1f\" y=\"%.1f\">&lt; ", LEFT - 8, s->below + 4.5);
    put_number(file, s->axis->floor);
    fprintf(file, "</text>\n");
  }
  fprintf(file, "<text text-anchor=\"middle\" transform=\"translate(15 %.1f) rotate(-90)\">",
          (TOP + HEIGHT - BOTTOM) / 2);
  svg_text(file, s->axis->label);
  fprintf(file, "</text>\n");
}

// One mark: circle, square, triangle, diamond, cross, ring, in turn.
static void put_mark(FILE *file, unsigned style, double x, double y) {
  fprintf(file, "<path class=\"s%u mark%s\" d=\"", style, style % 6 > 3 ? " open" : "");
  switch (style % 6) {
    case 0:
    case 5: fprintf(file, "M%.1f %.1fa5 5 0 1 0 10 0a5 5 0 1 0 -10 0", x - 5, y); break;
    case 1: fprintf(file, "M%.1f %.1fh9v9h-9z", x - 4.5, y - 4.5); break;
    case 2: fprintf(file, "M%.1f %.1fl5.5 9.5h-11z", x, y - 5.5); break;
    case 3: fprintf(file, "M%.1f %.1fl6 6l-6 6l-6 -6z", x, y - 6); break;
    default: fprintf(file, "M%.1f %.1fl9 9m0 -9l-9 9", x - 4.5, y - 4.5); break;
  }
  fprintf(file, "\"/>");
}

// bars: a swatch for each series instead of its mark.
static void put_legend(FILE *file, const plot *p, bool bars) {
  fprintf(file, "<ul class=\"legend\">");
  for (size_t i = 0; i < p->count; i++) {
    if (p->series[i].count > 0) {
      fprintf(file, "<li><svg viewBox=\"0 0 24 16\" width=\"24\" height=\"16\">");
      if (p->series[i].line) {
        fprintf(file, "<path class=\"s%u line\" d=\"M0 8H24\"/>", p->series[i].style);
      }
      if (bars) {
        fprintf(file, "<rect class=\"s%u bar\" x=\"6\" y=\"2\" width=\"12\" height=\"12\"/>", p->series[i].style);
      } else {
        put_mark(file, p->series[i].style, 12, 8);
      }
      fprintf(file, "</svg>");
      svg_text(file, p->series[i].name);
      fprintf(file, "</li>\n");
    }
  }
  fprintf(file, "</ul>\n");
}

static void put_line(FILE *file, const plot_series *s, const scale *x, const scale *y) {
  point2 points[PLOT_POINTS_MAX];
  for (size_t i = 0; i < s->count; i++) {
    points[i].x = place(x, s->points[i].x);
    points[i].y = place(y, s->points[i].y);
  }
  fprintf(file, "<polyline class=\"s%u line\" points=\"", s->style);
  svg_points(file, points, s->count);
  fprintf(file, "\"/>\n");
}

static void put_point(FILE *file, const plot_series *s, const plot_point *point, const scale *x, const scale *y) {
  const double px = place(x, point->x), py = place(y, point->y);
  fprintf(file, "<g><title>");
  svg_text(file, point->title != NULL ? point->title : s->name);
  fprintf(file, ": %.4g, %.4g</title>", point->x, point->y);
  if (isfinite(point->tail)) {
    fprintf(file, "<path class=\"s%u tail\" d=\"M%.1f %.1fV%.1fm-3 0h6\"/>", s->style, px, py, place(y, point->tail));
  }
  put_mark(file, s->style, px, py);
  fprintf(file, "</g>\n");
}

// Marks as taken what a line between two pixels covers.
static void take_line(label_page *page, double x, double y, double to_x, double to_y) {
  const int steps = (int)(hypot(to_x - x, to_y - y) / 12) + 1;
  for (int i = 0; i < steps; i++) {
    const double share = (i + 0.5) / steps;
    const label_rectangle taken = {x + share * (to_x - x) - 3, y + share * (to_y - y) - 3, 6, 6};
    label_take(page, taken, 3);
  }
}

static void take_marks(label_page *page, const plot *p, const scale *x, const scale *y) {
  for (size_t i = 0; i < p->count; i++) {
    const plot_series *s = &p->series[i];
    for (size_t k = 0; k < s->count; k++) {
      const double px = place(x, s->points[k].x), py = place(y, s->points[k].y);
      const label_rectangle taken = {px - 6, py - 6, 12, 12};
      label_take(page, taken, 10);
      if (s->line && k > 0) {
        take_line(page, place(x, s->points[k - 1].x), place(y, s->points[k - 1].y), px, py);
      }
    }
  }
}

// Where the name of the line across begins: at the left end, or at the right if a mark is in its way.
static double reference_name_left(const plot *p, const scale *x, const scale *y) {
  for (size_t i = 0; i < p->count; i++) {
    for (size_t k = 0; k < p->series[i].count; k++) {
      const plot_point *point = &p->series[i].points[k];
      if (place(x, point->x) < LEFT + NAME_WIDTH + 6 && fabs(place(y, point->y) - place(y, p->mark) + 8) < 20) {
        return WIDTH - RIGHT - NAME_WIDTH;
      }
    }
  }
  return LEFT;
}

// Writes numbers beside their points, clear of marks, lines and each other.
static void put_numbers(FILE *file, const plot *p, const scale *x, const scale *y) {
  static label_page page;
  const label_rectangle area = {LEFT, TOP, WIDTH - LEFT - RIGHT, HEIGHT - TOP - BOTTOM};
  page.area = area;
  page.count = 0;
  take_marks(&page, p, x, y);
  if (isfinite(p->mark)) {
    const label_rectangle named = {reference_name_left(p, x, y), place(y, p->mark) - 18, NAME_WIDTH, 18};
    label_take(&page, named, 10);
  }
  for (size_t i = 0; i < p->count; i++) {
    for (size_t k = 0; k < p->series[i].count; k++) {
      const plot_point *point = &p->series[i].points[k];
      const point2 anchor = {place(x, point->x), place(y, point->y)};
      if (point->number != 0) {
        const double width = 8 * floor(log10(point->number) + 1.01) + 2;
        const label_rectangle r = label_place(&page, anchor, width, 12, 11);
        fprintf(file, "<text class=\"s%u number\" text-anchor=\"middle\" x=\"%.1f\" y=\"%.1f\">%d</text>\n",
                p->series[i].style, r.left + r.width / 2, r.top + 10, point->number);
      }
    }
  }
}

static void put_reference_line(FILE *file, const plot *p, const scale *x, const scale *y) {
  if (isfinite(p->mark)) {
    const double at = place(y, p->mark);
    fprintf(file, "<path class=\"reference\" d=\"M%.1f %.1fH%.1f\"/>", LEFT, at, WIDTH - RIGHT);
    fprintf(file, "<text class=\"small\" x=\"%.1f\" y=\"%.1f\">", reference_name_left(p, x, y) + 4, at - 5);
    svg_text(file, p->mark_name);
    fprintf(file, "</text>\n");
  }
}

void plot_write_points(FILE *file, const plot *given) {
  static plot p;
  p = *given;
  fit(&p);
  round_ends(&p.x);
  round_ends(&p.y);
  const scale x = make_scale(&p.x, LEFT, WIDTH - RIGHT), y = make_scale(&p.y, HEIGHT - BOTTOM, TOP);
  open_figure(file, "plot", p.title);
  open_svg(file, p.title, WIDTH, HEIGHT);
  put_x_axis(file, &x);
  put_y_axis(file, &y);
  put_reference_line(file, &p, &x, &y);
  for (size_t i = p.count; i-- > 0;) {  // the first series on top
    if (p.series[i].line) {
      put_line(file, &p.series[i], &x, &y);
    }
    for (size_t k = 0; k < p.series[i].count; k++) {
      put_point(file, &p.series[i], &p.series[i].points[k], &x, &y);
    }
  }
  put_numbers(file, &p, &x, &y);
  fprintf(file, "</svg>\n");
  put_legend(file, &p, false);
  fprintf(file, "</figure>\n");
}

void plot_write_bars(FILE *file, const plot *given) {
  static plot p;
  p = *given;
  fit(&p);
  widen(&p.y, 0);
  round_ends(&p.y);
  p.x.low -= 0.5;
  p.x.high += 0.5;
  const scale x = make_scale(&p.x, LEFT, WIDTH - RIGHT), y = make_scale(&p.y, HEIGHT - BOTTOM, TOP);
  const double bar = 0.8 * (place(&x, 1) - place(&x, 0)) / (double)p.count;
  open_figure(file, "plot", p.title);
  open_svg(file, p.title, WIDTH, HEIGHT);
  put_x_axis(file, &x);
  put_y_axis(file, &y);
  for (size_t i = 0; i < p.count; i++) {
    for (size_t k = 0; k < p.series[i].count; k++) {
      const plot_point *point = &p.series[i].points[k];
      const double left = place(&x, point->x) + bar * ((double)i - (double)p.count / 2), top = place(&y, point->y);
      fprintf(file, "<rect class=\"s%u bar\" x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\"><title>",
              p.series[i].style, left, top, bar, place(&y, 0) - top);
      svg_text(file, p.series[i].name);
      fprintf(file, ", %g: %.3g</title></rect>\n", point->x, point->y);
    }
  }
  fprintf(file, "</svg>\n");
  put_legend(file, &p, true);
  fprintf(file, "</figure>\n");
}

// Writes a bar: the series' points at x, from 0 upwards, with those shares in it for which there is room.
static void put_stack(FILE *file, const plot *p, size_t at, double left, double width, const scale *y) {
  double below = 0;
  for (size_t i = 0; i < p->count; i++) {
    const double share = p->series[i].points[at].y, top = place(y, below + share), height = place(y, below) - top;
    fprintf(file, "<rect class=\"s%u bar\" x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\"><title>",
            p->series[i].style, left, top, width, height);
    svg_text(file, p->series[i].name);
    fprintf(file, ": %.1f %%</title></rect>\n", share);
    if (height >= 14) {
      fprintf(file, "<text class=\"onbar\" text-anchor=\"middle\" x=\"%.1f\" y=\"%.1f\">%.0f</text>\n",
              left + width / 2, top + height / 2 + 4.5, share);
    }
    below += share;
  }
}

void plot_write_stacks(FILE *file, const plot *given, const char *const *names, size_t count) {
  static plot p;
  p = *given;
  widen(&p.y, 0);
  widen(&p.y, 100);
  round_ends(&p.y);
  const scale y = make_scale(&p.y, HEIGHT - BOTTOM, TOP);
  const double step = (WIDTH - LEFT - RIGHT) / (double)count;
  open_figure(file, "plot", p.title);
  open_svg(file, p.title, WIDTH, HEIGHT);
  put_y_axis(file, &y);
  put_x_label(file, &p.x);
  for (size_t k = 0; k < count; k++) {
    const double left = LEFT + step * ((double)k + 0.15);
    put_stack(file, &p, k, left, 0.7 * step, &y);
    fprintf(file, "<text text-anchor=\"middle\" x=\"%.1f\" y=\"%.1f\">", left + 0.35 * step, HEIGHT - BOTTOM + 18);
    svg_text(file, names[k]);
    fprintf(file, "</text>\n");
  }
  fprintf(file, "</svg>\n");
  put_legend(file, &p, true);
  fprintf(file, "</figure>\n");
}

void plot_write_map(FILE *file, const char *title, const char *x_label, const char *const *rows, size_t row_count,
                    const char *const *columns, size_t column_count, const plot_cell *cells) {
  const double left = 150, width = 690, row = 20, column = (width - left - 4) / (double)column_count;
  const double height = 2 + row * (double)row_count + 46;
  open_figure(file, "map", title);
  open_svg(file, title, width, height);
  for (size_t i = 0; i < row_count; i++) {
    const double y = 2 + row * (double)i;
    fprintf(file, "<text class=\"small\" text-anchor=\"end\" x=\"%.1f\" y=\"%.1f\">", left - 8, y + 14.5);
    svg_text(file, rows[i]);
    fprintf(file, "</text>\n");
    for (size_t k = 0; k < column_count; k++) {
      const plot_cell *cell = &cells[i * column_count + k];
      const double x = left + column * (double)k;
      if (isfinite(cell->share)) {
        fprintf(file, "<rect class=\"cell\" x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\"/>", x, y, column - 1,
                row - 1);
        fprintf(file,
                "<rect class=\"hot\" fill-opacity=\"%.2f\" x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\"/>",
                0.85 * sqrt(cell->share), x, y, column - 1, row - 1);
        fprintf(file, "<text class=\"tiny\" text-anchor=\"middle\" x=\"%.1f\" y=\"%.1f\">%s</text>\n",
                x + (column - 1) / 2, y + 14, cell->text);
      }
    }
  }
  for (size_t k = 0; k < column_count; k++) {
    fprintf(file, "<text class=\"tiny\" text-anchor=\"middle\" x=\"%.1f\" y=\"%.1f\">%s</text>\n",
            left + column * ((double)k + 0.5), height - 30, columns[k]);
  }
  fprintf(file, "<text text-anchor=\"middle\" x=\"%.1f\" y=\"%.1f\">", (left + width) / 2, height - 8);
  svg_text(file, x_label);
  fprintf(file, "</text>\n</svg>\n</figure>\n");
}
