// Writes the figures as tables in plain text.
#ifndef REPORT_TEXT_H
#define REPORT_TEXT_H

#include "table.h"

// A column of the table of a family and a query, which has a row for each method. Values that are not numbers are left
// out.
typedef struct text_column {
  const char *heading, *format, *measure;
  double (*get)(const table *t, const char *family, const char *query, const char *method, const char *measure);
} text_column;

extern const text_column text_columns[];
extern const size_t text_column_count;

// Has any method a value in this column?
bool text_column_used(const text_column *column, const table *t, const char *family, const char *query);

void text_write(FILE *file, const table *t);

#endif
