// Opens the page: one chart and one table of all methods over all families.
#include "opening.h"

#include <math.h>
#include <string.h>

#include "../../../programs/demo/labels.h"
#include "../../../programs/demo/svg.h"

// The chart is drawn so large that it can be read at half its size.
#define WIDTH 960.0
#define HEIGHT 560.0
#define LEFT 120.0
#define RIGHT 30.0
#define TOP 20.0
#define BOTTOM 86.0
#define BAND 68.0  // at the bottom, for methods that are never wrong
#define MARK 10.0
#define LETTER 13.5  // mean width of a label's letter
#define LINE 28.0    // height of a label

#define QUERIES 3
static const char *const queries[QUERIES] = {"distance", "intersect", "depth"};

// A method over all families.
typedef struct standing {
  const char *method;
  size_t series;
  double time[QUERIES];                 // geometric mean, in parts of the first method's; NAN: not asked
  double wrong[QUERIES];                // share of the pairs
  double mean[QUERIES], most[QUERIES];  // error, LSB
  double all_time, all_wrong;
} standing;

typedef struct sums {
  double logs, families, pairs, wrong, errors, most;
} sums;

static void add_family(const table *t, const char *family, const char *query, const char *method, sums *out) {
  const double pairs = table_get(t, family, query, method, "pairs");
  if (isfinite(pairs)) {
    const double most = table_get(t, family, query, method, "error_most");
    out->logs +=
        log(table_get(t, family, query, method, "time") / table_get(t, family, query, t->methods.name[0], "time"));
    out->families++;
    out->pairs += pairs;
    out->wrong += table_get(t, family, query, method, "wrong");
    out->errors += pairs * table_get(t, family, query, method, "error_mean");
    out->most = most > out->most ? most : out->most;
  }
}

static standing find_standing(const table *t, const char *method) {
  standing s = {.method = method};
  int setting;
  sums all = {0, 0, 0, 0, 0, 0};
  s.series = table_series(t, method, &setting);
  for (int q = 0; q < QUERIES; q++) {
    sums of_query = {0, 0, 0, 0, 0, 0};
    for (size_t f = 0; f < t->families.count; f++) {
      add_family(t, t->families.name[f], queries[q], method, &of_query);
    }
    s.time[q] = exp(of_query.logs / of_query.families);
    s.wrong[q] = of_query.wrong / of_query.pairs;
    s.mean[q] = of_query.errors / of_query.pairs;
    s.most[q] = of_query.most;
    all.logs += of_query.logs;
    all.families += of_query.families;
    all.pairs += of_query.pairs;
    all.wrong += of_query.wrong;
  }
  s.all_time = exp(all.logs / all.families);
  s.all_wrong = all.wrong / all.pairs;
  return s;
}

// The methods that are asked for whole answers: none that is stopped early.
static size_t find_standings(const table *t, standing out[TABLE_NAMES_MAX]) {
  size_t count = 0;
  for (size_t m = 0; m < t->methods.count; m++) {
    const standing s = find_standing(t, t->methods.name[m]);
    if (isfinite(s.all_time) && table_series_size(t, t->series.name[s.series]) == 1) {
      out[count++] = s;
    }
  }
  return count;
}

// Logarithmic axes. low_x and low_y are at the ends of the axes; below low_y there is the band.
typedef struct axes {
  double low_x, high_x, low_y, high_y;
} axes;

static double place_x(const axes *a, double time) {
  return LEFT + (WIDTH - LEFT - RIGHT) * log(time / a->low_x) / log(a->high_x / a->low_x);
}

static double place_y(const axes *a, double share) {
  const double bottom = HEIGHT - BOTTOM - BAND;
  return share > 0 ? bottom - (bottom - TOP) * log(share / a->low_y) / log(a->high_y / a->low_y) : bottom + BAND / 2;
}

static axes find_axes(const standing *s, size_t count) {
  axes a = {1, 1, 0.1, 1};
  for (size_t i = 0; i < count; i++) {
    a.low_x = fmin(a.low_x, s[i].all_time);
    a.high_x = fmax(a.high_x, s[i].all_time);
    a.low_y = s[i].all_wrong > 0 ? fmin(a.low_y, s[i].all_wrong) : a.low_y;
  }
  a.low_x /= 1.3;
  a.high_x *= 1.3;
  a.low_y = pow(10, floor(log10(a.low_y)));
  return a;
}

static void put_text(FILE *file, const char *class, const char *anchor, double x, double y, const char *text) {
  fprintf(file, "<text class=\"%s\" text-anchor=\"%s\" x=\"%.1f\" y=\"%.1f\">", class, anchor, x, y);
  svg_text(file, text);
  fprintf(file, "</text>\n");
}

static void put_axes(FILE *file, const axes *a) {
  static const double leads[] = {1, 2, 5};
  const double bottom = HEIGHT - BOTTOM;
  char text[32];
  fprintf(file, "<rect class=\"band\" x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\"/>\n", LEFT, bottom - BAND,
          WIDTH - LEFT - RIGHT, BAND);
  put_text(file, "tick", "end", LEFT - 12, place_y(a, 0) + 8, "none");
  for (double share = a->low_y; share < 1.5; share *= 10) {
    fprintf(file, "<path class=\"grid\" d=\"M%.1f %.1fH%.1f\"/>\n", LEFT, place_y(a, share), WIDTH - RIGHT);
    snprintf(text, sizeof text, "%g %%", 100 * share);
    put_text(file, "tick", "end", LEFT - 12, place_y(a, share) + 8, text);
  }
  for (int power = -2; power <= 3; power++) {
    for (size_t k = 0; k < sizeof leads / sizeof leads[0]; k++) {
      const double time = leads[k] * pow(10, power);
      if (time >= a->low_x && time <= a->high_x) {
        fprintf(file, "<path class=\"grid\" d=\"M%.1f %.1fV%.1f\"/>\n", place_x(a, time), TOP, bottom);
        snprintf(text, sizeof text, "%g", time);
        put_text(file, "tick", "middle", place_x(a, time), bottom + 30, text);
      }
    }
  }
  put_text(file, "axis", "middle", (LEFT + WIDTH - RIGHT) / 2, HEIGHT - 14, "time a question, in parts of gjk's");
  fprintf(
      file,
      "<text class=\"axis\" text-anchor=\"middle\" transform=\"translate(26 %.1f) rotate(-90)\">wrong answers</text>\n",
      (TOP + bottom) / 2);
}

// Names beside their marks, clear of marks and of each other.
static void put_marks(FILE *file, const axes *a, const standing *s, size_t count) {
  static label_page page;
  const label_rectangle area = {LEFT + 4, TOP, WIDTH - LEFT - RIGHT, HEIGHT - TOP - BOTTOM};
  page.area = area;
  page.count = 0;
  for (size_t i = 0; i < count; i++) {
    const label_rectangle taken = {place_x(a, s[i].all_time) - MARK - 2, place_y(a, s[i].all_wrong) - MARK - 2,
                                   2 * MARK + 4, 2 * MARK + 4};
    label_take(&page, taken, 10);
  }
  for (size_t i = 0; i < count; i++) {
    const point2 at = {place_x(a, s[i].all_time), place_y(a, s[i].all_wrong)};
    const double width = LETTER * (double)strlen(s[i].method);
    fprintf(file, "<circle class=\"s%zu\" cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\"/>\n", s[i].series, at.x, at.y, MARK);
    const label_rectangle r = label_place(&page, at, width, LINE, MARK + LINE / 2 + 2);
    char class[32];
    snprintf(class, sizeof class, "name s%zu%s", s[i].series, i == 0 ? " own" : "");
    put_text(file, class, "middle", r.left + r.width / 2, r.top + 21, s[i].method);
  }
}

static void put_chart(FILE *file, const standing *s, size_t count) {
  const axes a = find_axes(s, count);
  fprintf(file,
          "<figure class=\"opening\">\n<svg viewBox=\"0 0 %.0f %.0f\" role=\"img\" aria-label=\"wrong answers against "
          "time\">\n",
          WIDTH, HEIGHT);
  put_axes(file, &a);
  put_marks(file, &a, s, count);
  fprintf(file, "</svg>\n</figure>\n");
}

static void put_cell(FILE *file, const char *format, double value) {
  fprintf(file, "<td>");
  if (isfinite(value)) {
    fprintf(file, format, value);
  } else {
    fprintf(file, "–");
  }
  fprintf(file, "</td>");
}

// An error to two digits.
static void put_error(FILE *file, double error) {
  char digits[32];
  if (!(error >= 1000)) {
    put_cell(file, error < 0.001 ? "&lt; 0.001" : "%.2g", error);
    return;
  }
  const double unit = pow(10, floor(log10(error)) - 1);
  const int length = snprintf(digits, sizeof digits, "%.0f", unit * round(error / unit));
  fprintf(file, "<td>");
  for (int i = 0; i < length; i++) {
    fprintf(file, "%s%c", i > 0 && (length - i) % 3 == 0 ? "," : "", digits[i]);
  }
  fprintf(file, "</td>");
}

static void put_share(FILE *file, double share) {
  put_cell(file, share == 0 || share >= 0.0995 ? "%.0f %%" : share >= 0.00995 ? "%.1f %%" : "%.2f %%", 100 * share);
}

static void put_table(FILE *file, const standing *s, size_t count) {
  fprintf(file,
          "<div class=\"wide opening\"><table>\n"
          "<tr><th></th><th colspan=\"2\">do they touch?</th><th colspan=\"4\">how far apart?</th>"
          "<th colspan=\"3\">how deep?</th></tr>\n"
          "<tr><th>method</th><th>time</th><th>wrong</th><th>time</th><th>wrong</th><th>mean error</th><th>largest</th>"
          "<th>time</th><th>wrong</th><th>largest error</th></tr>\n");
  for (size_t i = 0; i < count; i++) {
    fprintf(file, "<tr%s><td>", i == 0 ? " class=\"own\"" : "");
    svg_text(file, s[i].method);
    fprintf(file, "</td>");
    put_cell(file, "%.2f", s[i].time[1]);
    put_share(file, s[i].wrong[1]);
    put_cell(file, "%.2f", s[i].time[0]);
    put_share(file, s[i].wrong[0]);
    put_error(file, s[i].mean[0]);
    put_error(file, isfinite(s[i].time[0]) ? s[i].most[0] : NAN);
    put_cell(file, "%.2f", s[i].time[2]);
    put_share(file, s[i].wrong[2]);
    put_error(file, isfinite(s[i].time[2]) ? s[i].most[2] : NAN);
    fprintf(file, "</tr>\n");
  }
  fprintf(file, "</table></div>\n");
}

void opening_write(FILE *file, const table *t) {
  static standing standings[TABLE_NAMES_MAX];
  const size_t count = find_standings(t, standings);
  fprintf(
      file,
      "<p>Each method over all families that it was asked about, easy and hard alike: how often it is wrong, and what "
      "a question costs it. Left is faster, down is right.</p>\n");
  put_chart(file, standings, count);
  put_table(file, standings, count);
  fprintf(file,
          "<p class=\"note\">Time: geometric mean over the families, in parts of that of gjk without a cache. Wrong: "
          "touching for apart or the reverse; of a depth, more than 1 LSB and more than 1 %% off, or none. Errors in "
          "LSB, 2<sup>-16</sup> unit; a pair wrongly taken for touching counts with its whole gap.</p>\n");
}
