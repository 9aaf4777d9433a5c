// The figures of a run: rows of family, query, method, measure, at and value, as gjk-bench writes them.
#ifndef REPORT_TABLE_H
#define REPORT_TABLE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

typedef struct table_row {
  char *family, *query, *method, *measure, *at, *text;
  double value;  // of text; NAN when it is none
} table_row;

#define TABLE_NAMES_MAX 64

// Names in the order in which they first come, each once.
typedef struct table_names {
  const char *name[TABLE_NAMES_MAX];
  size_t count;
} table_names;

typedef struct table {
  table_row *rows;
  size_t count, capacity;
  table_names families, queries, methods, series;
} table;

// False, with a message, for what is not such a table.
bool table_read(table *out, FILE *file, const char *name);
void table_free(table *t);

// NULL or NAN when there is no such row. Any of the keys may be "".
const char *table_text(const table *t, const char *family, const char *query, const char *method, const char *measure);
double table_get(const table *t, const char *family, const char *query, const char *method, const char *measure);
double table_at(const table *t, const char *family, const char *query, const char *method, const char *measure, int at);
// The same, added up over all families; 0 when there is none.
double table_sum_at(const table *t, const char *query, const char *method, const char *measure, int at);

// Was the query asked about the family's pairs?
bool table_asked(const table *t, const char *family, const char *query);

// Adds up the values of a measure by their at, from 0 to most; what is beyond goes to most. family: NULL for all.
// Returns the sum of them all.
double table_histogram(const table *t, const char *family, const char *query, const char *method, const char *measure,
                       int most, double *counts);

// The series of a method, as its place in t->series, and the method's place within it.
size_t table_series(const table *t, const char *method, int *setting);
// How many methods a series has.
size_t table_series_size(const table *t, const char *series);

#endif
