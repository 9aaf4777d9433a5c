// Reads the figures of a run: rows of family, query, method, measure, at and value, as gjk-bench writes them.
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

// Different names, in the order in which they first occur.
typedef struct table_names {
  const char *name[TABLE_NAMES_MAX];
  size_t count;
} table_names;

typedef struct table {
  table_row *rows;
  size_t count, capacity;
  table_names families, queries, methods, series;
} table;

// False, with a message, if it is not such a table.
bool table_read(table *out, FILE *file, const char *name);
void table_free(table *t);

// NULL or NAN if there is no such row. Any of the keys may be "".
const char *table_text(const table *t, const char *family, const char *query, const char *method, const char *measure);
double table_get(const table *t, const char *family, const char *query, const char *method, const char *measure);
double table_at(const table *t, const char *family, const char *query, const char *method, const char *measure, int at);
// A value added up over all families; 0 if there is none.
double table_sum_at(const table *t, const char *query, const char *method, const char *measure, int at);

// Was the query asked about the pairs of the family?
bool table_asked(const table *t, const char *family, const char *query);

// Adds up the values of a measure in counts[at], for at from 0 to most; larger ones go to counts[most]. Returns the sum
// of all. family: NULL for all.
double table_histogram(const table *t, const char *family, const char *query, const char *method, const char *measure,
                       int most, double *counts);

// The series of a method, an index into t->series, and the place of the method within it.
size_t table_series(const table *t, const char *method, int *setting);
// How many methods a series has.
size_t table_series_size(const table *t, const char *series);

#endif
