// Reads the figures of a run.
#include "table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static void add_name(table_names *names, const char *name) {
  for (size_t i = 0; i < names->count; i++) {
    if (strcmp(names->name[i], name) == 0) {
      return;
    }
  }
  if (*name != '\0' && names->count < TABLE_NAMES_MAX) {
    names->name[names->count++] = name;
  }
}

// Cuts a line at the first five commas; the value may hold more.
static bool split(char *line, table_row *out) {
  char **const fields[6] = {&out->family, &out->query, &out->method, &out->measure, &out->at, &out->text};
  char *end;
  for (int i = 0; i < 6; i++) {
    *fields[i] = line;
    if (i < 5) {
      line = strchr(line, ',');
      if (line == NULL) {
        return false;
      }
      *line++ = '\0';
    }
  }
  out->text[strcspn(out->text, "\r\n")] = '\0';
  out->value = strtod(out->text, &end);
  out->value = end == out->text || *end != '\0' ? NAN : out->value;
  return true;
}

static table_row *add_row(table *t) {
  if (t->count == t->capacity) {
    t->capacity = t->capacity == 0 ? 1024 : 2 * t->capacity;
    t->rows = realloc(t->rows, t->capacity * sizeof *t->rows);
    if (t->rows == NULL) {
      fprintf(stderr, "out of memory\n");
      exit(2);
    }
  }
  return &t->rows[t->count++];
}

bool table_read(table *out, FILE *file, const char *name) {
  static const char header[] = "family,query,method,measure,at,value\n";
  char line[512];
  unsigned long number = 0;
  memset(out, 0, sizeof *out);
  while (fgets(line, sizeof line, file) != NULL) {
    number++;
    if (number == 1 && strcmp(line, header) != 0) {
      break;
    }
    if (number > 1) {
      char *kept = malloc(strlen(line) + 1);
      table_row *row = add_row(out);
      if (kept == NULL || !split(strcpy(kept, line), row)) {
        fprintf(stderr, "%s:%lu: expected six fields\n", name, number);
        return false;
      }
      add_name(&out->families, row->family);
      add_name(&out->queries, row->query);
      add_name(&out->methods, row->method);
      if (strcmp(row->measure, "series") == 0) {
        add_name(&out->series, row->text);
      }
    }
  }
  if (out->count == 0) {
    fprintf(stderr, "%s: expected %s", name, header);
  }
  return out->count > 0;
}

void table_free(table *t) {
  for (size_t i = 0; i < t->count; i++) {
    free(t->rows[i].family);
  }
  free(t->rows);
}

static const table_row *find(const table *t, const char *family, const char *query, const char *method,
                             const char *measure, const char *at) {
  for (size_t i = 0; i < t->count; i++) {
    const table_row *r = &t->rows[i];
    if (strcmp(r->measure, measure) == 0 && strcmp(r->method, method) == 0 && strcmp(r->family, family) == 0 &&
        strcmp(r->query, query) == 0 && (at == NULL || strcmp(r->at, at) == 0)) {
      return r;
    }
  }
  return NULL;
}

const char *table_text(const table *t, const char *family, const char *query, const char *method, const char *measure) {
  const table_row *r = find(t, family, query, method, measure, NULL);
  return r != NULL ? r->text : NULL;
}

double table_get(const table *t, const char *family, const char *query, const char *method, const char *measure) {
  const table_row *r = find(t, family, query, method, measure, NULL);
  return r != NULL ? r->value : NAN;
}

double table_at(const table *t, const char *family, const char *query, const char *method, const char *measure,
                int at) {
  char text[16];
  snprintf(text, sizeof text, "%d", at);
  const table_row *r = find(t, family, query, method, measure, text);
  return r != NULL ? r->value : NAN;
}

double table_sum_at(const table *t, const char *query, const char *method, const char *measure, int at) {
  double sum = 0;
  for (size_t f = 0; f < t->families.count; f++) {
    const double value = table_at(t, t->families.name[f], query, method, measure, at);
    sum += isnan(value) ? 0 : value;
  }
  return sum;
}

bool table_asked(const table *t, const char *family, const char *query) {
  return find(t, family, query, t->methods.name[0], "pairs", NULL) != NULL;
}

double table_histogram(const table *t, const char *family, const char *query, const char *method, const char *measure,
                       int most, double *counts) {
  double sum = 0;
  memset(counts, 0, (size_t)(most + 1) * sizeof *counts);
  for (size_t i = 0; i < t->count; i++) {
    const table_row *r = &t->rows[i];
    if (strcmp(r->measure, measure) == 0 && strcmp(r->method, method) == 0 && strcmp(r->query, query) == 0 &&
        (family == NULL || strcmp(r->family, family) == 0)) {
      const int at = atoi(r->at);
      counts[at < 0 ? 0 : at < most ? at : most] += r->value;
      sum += r->value;
    }
  }
  return sum;
}

size_t table_series(const table *t, const char *method, int *setting) {
  const table_row *r = find(t, "", "", method, "series", NULL);
  *setting = r != NULL ? atoi(r->at) : 0;
  for (size_t i = 0; r != NULL && i < t->series.count; i++) {
    if (strcmp(t->series.name[i], r->text) == 0) {
      return i;
    }
  }
  return 0;
}

size_t table_series_size(const table *t, const char *series) {
  size_t size = 0;
  for (size_t i = 0; i < t->count; i++) {
    size += strcmp(t->rows[i].measure, "series") == 0 && strcmp(t->rows[i].text, series) == 0;
  }
  return size;
}
