// The figures as tables in plain text.
#include "text.h"

#include <math.h>

double text_ratio(const table *t, const char *family, const char *query, const char *method) {
  return table_get(t, family, query, method, "time") / table_get(t, family, query, t->methods.name[0], "time");
}

double text_mean_rounds(const table *t, const char *family, const char *query, const char *method) {
  double counts[256], sum = 0;
  const double count = table_histogram(t, family, query, method, "rounds", 255, counts);
  for (int i = 0; i < 256; i++) {
    sum += i * counts[i];
  }
  return sum / count;
}

static void put(FILE *file, int width, const char *format, double value) {
  char text[32] = "-";
  if (isfinite(value)) {
    snprintf(text, sizeof text, format, value);
  }
  fprintf(file, "%*s", width, text);
}

static void put_family(FILE *file, const table *t, const char *family, const char *query) {
  fprintf(file, "\n%s, %s: %s\n", family, query, table_text(t, family, "", "", "what"));
  fprintf(file, "%-22s%10s%8s%12s%7s%7s%11s%12s%12s\n", "", "ns", "x gjk", "instruct.", "rounds", "wrong", "undecided",
          "mean error", "most error");
  for (size_t m = 0; m < t->methods.count; m++) {
    const char *method = t->methods.name[m];
    if (!isfinite(table_get(t, family, query, method, "pairs"))) {
      continue;
    }
    fprintf(file, "%-22s", method);
    put(file, 10, "%.0f", table_get(t, family, query, method, "time"));
    put(file, 8, "%.2f", text_ratio(t, family, query, method));
    put(file, 12, "%.0f", table_get(t, family, query, method, "instructions"));
    put(file, 7, "%.1f", text_mean_rounds(t, family, query, method));
    put(file, 7, "%.0f", table_get(t, family, query, method, "wrong"));
    put(file, 11, "%.0f", table_get(t, family, query, method, "undecided"));
    put(file, 12, "%.3g", table_get(t, family, query, method, "error_mean"));
    put(file, 12, "%.3g", table_get(t, family, query, method, "error_most"));
    fprintf(file, "\n");
  }
}

// Over all families: the geometric mean of the ratios, the sum of the wrong decisions, the largest error.
static void put_summary(FILE *file, const table *t, const char *query) {
  fprintf(file, "\nall families, %s\n%-22s%8s%9s%7s%11s%12s%9s\n", query, "", "x gjk", "pairs", "wrong", "undecided",
          "most error", "outside");
  for (size_t m = 0; m < t->methods.count; m++) {
    const char *method = t->methods.name[m];
    double logs = 0, pairs = 0, wrong = 0, undecided = 0, most = NAN, outside = 0;
    for (size_t f = 0; f < t->families.count; f++) {
      const char *family = t->families.name[f];
      const double error = table_get(t, family, query, method, "error_most");
      logs += log(text_ratio(t, family, query, method)) / (double)t->families.count;
      pairs += table_get(t, family, query, method, "pairs");
      wrong += table_get(t, family, query, method, "wrong");
      undecided += table_get(t, family, query, method, "undecided");
      outside += table_get(t, family, query, method, "outside");
      most = error > most || isnan(most) ? error : most;
    }
    if (isfinite(pairs)) {
      fprintf(file, "%-22s", method);
      put(file, 8, "%.2f", exp(logs));
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
      put_family(file, t, t->families.name[f], t->queries.name[q]);
    }
  }
  for (size_t q = 0; q < t->queries.count; q++) {
    put_summary(file, t, t->queries.name[q]);
  }
  fprintf(
      file,
      "\nx gjk: time against gjk cold (all families: geometric mean). Errors in LSB of 2^-16 unit, against the exact\n"
      "real distance. outside: true distances outside of bounds that were called proven.\n");
}
