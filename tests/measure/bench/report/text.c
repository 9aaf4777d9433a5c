// Writes the figures as tables in plain text.
#include "text.h"

#include <math.h>
#include <string.h>

// A value in parts of the first method's.
static double ratio(const table *t, const char *family, const char *query, const char *method, const char *measure) {
  return table_get(t, family, query, method, measure) / table_get(t, family, query, t->methods.name[0], measure);
}

// The mean of a measure that was counted by its `at`; NAN: it was not.
static double mean(const table *t, const char *family, const char *query, const char *method, const char *measure) {
  double counts[256], sum = 0;
  const double count = table_histogram(t, family, query, method, measure, 255, counts);
  for (int i = 0; i < 256; i++) {
    sum += i * counts[i];
  }
  return sum / count;
}

const text_column text_columns[] = {
    {.heading = "ns", .format = "%.0f", .measure = "time", .get = table_get},
    {.heading = "x gjk", .format = "%.2f", .measure = "time", .get = ratio},
    {.heading = "instructions", .format = "%.0f", .measure = "instructions", .get = table_get},
    {.heading = "iterations", .format = "%.1f", .measure = "iterations", .get = mean},
    {.heading = "wrong", .format = "%.0f", .measure = "wrong", .get = table_get},
    {.heading = "undecided", .format = "%.0f", .measure = "undecided", .get = table_get},
    {.heading = "failed", .format = "%.0f", .measure = "failed", .get = table_get},
    {.heading = "apart", .format = "%.0f", .measure = "says_apart", .get = table_get},
    {.heading = "too small", .format = "%.0f", .measure = "too_small", .get = table_get},
    {.heading = "too large", .format = "%.0f", .measure = "too_large", .get = table_get},
    {.heading = "contacts", .format = "%.2f", .measure = "contacts", .get = table_get},
    {.heading = "mean error", .format = "%.3g", .measure = "error_mean", .get = table_get},
    {.heading = "largest error", .format = "%.3g", .measure = "error_most", .get = table_get},
};
const size_t text_column_count = sizeof text_columns / sizeof text_columns[0];

bool text_column_used(const text_column *column, const table *t, const char *family, const char *query) {
  for (size_t m = 0; m < t->methods.count; m++) {
    if (isfinite(column->get(t, family, query, t->methods.name[m], column->measure))) {
      return true;
    }
  }
  return false;
}

static void put(FILE *file, int width, const char *format, double value) {
  char text[32] = "-";
  if (isfinite(value)) {
    snprintf(text, sizeof text, format, value);
  }
  fprintf(file, "%*s", width, text);
}

static int width_of(const text_column *column) {
  const int length = (int)strlen(column->heading);
  return (length < 8 ? 8 : length) + 2;
}

static void put_family(FILE *file, const table *t, const char *family, const char *query) {
  fprintf(file, "\n%s, %s: %s\n%-22s", family, query, table_text(t, family, "", "", "what"), "");
  for (size_t c = 0; c < text_column_count; c++) {
    if (text_column_used(&text_columns[c], t, family, query)) {
      fprintf(file, "%*s", width_of(&text_columns[c]), text_columns[c].heading);
    }
  }
  fprintf(file, "\n");
  for (size_t m = 0; m < t->methods.count; m++) {
    const char *method = t->methods.name[m];
    if (!isfinite(table_get(t, family, query, method, "pairs"))) {
      continue;
    }
    fprintf(file, "%-22s", method);
    for (size_t c = 0; c < text_column_count; c++) {
      const text_column *column = &text_columns[c];
      if (text_column_used(column, t, family, query)) {
        put(file, width_of(column), column->format, column->get(t, family, query, method, column->measure));
      }
    }
    fprintf(file, "\n");
  }
}

// Sums up the families that a method was asked about: the geometric mean of the ratios, the sum of the wrong answers,
// the largest error.
static void put_summary(FILE *file, const table *t, const char *query) {
  fprintf(file, "\nall families, %s\n%-22s%8s%9s%7s%11s%12s%9s\n", query, "", "x gjk", "pairs", "wrong", "undecided",
          "most error", "outside");
  for (size_t m = 0; m < t->methods.count; m++) {
    const char *method = t->methods.name[m];
    double logs = 0, families = 0, pairs = 0, wrong = 0, undecided = 0, most = NAN, outside = 0;
    for (size_t f = 0; f < t->families.count; f++) {
      const char *family = t->families.name[f];
      const double error = table_get(t, family, query, method, "error_most");
      const double asked = table_get(t, family, query, method, "pairs");
      if (isnan(asked)) {
        continue;
      }
      logs += log(ratio(t, family, query, method, "time"));
      families++;
      pairs += asked;
      wrong += table_get(t, family, query, method, "wrong");
      undecided += table_get(t, family, query, method, "undecided");
      outside += table_get(t, family, query, method, "outside");
      most = error > most || isnan(most) ? error : most;
    }
    if (pairs > 0) {
      fprintf(file, "%-22s", method);
      put(file, 8, "%.2f", exp(logs / families));
      put(file, 9, "%.0f", pairs);
      put(file, 7, "%.0f", wrong);
      put(file, 11, "%.0f", undecided);
      put(file, 12, "%.3g", most);
      put(file, 9, "%.0f", outside);
      fprintf(file, "\n");
    }
  }
}

void text_write(FILE *file, const table *t) {
  for (size_t f = 0; f < t->families.count; f++) {
    for (size_t q = 0; q < t->queries.count; q++) {
      if (table_asked(t, t->families.name[f], t->queries.name[q])) {
        put_family(file, t, t->families.name[f], t->queries.name[q]);
      }
    }
  }
  for (size_t q = 0; q < t->queries.count; q++) {
    put_summary(file, t, t->queries.name[q]);
  }
  fprintf(
      file,
      "\nx gjk: time against gjk cold (all families: geometric mean). Errors in LSB of 2^-16 unit, against the exact\n"
      "real distance or depth. outside: true distances outside of bounds that were called proven. Depths are wrong "
      "when\n"
      "more than 1 LSB and more than 1 %% too small or too large, when the method failed or says that they are "
      "apart.\n");
}
