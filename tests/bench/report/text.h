// The figures as tables in plain text.
#ifndef REPORT_TEXT_H
#define REPORT_TEXT_H

#include "table.h"

// What each method is compared with: the first one.
double text_ratio(const table *t, const char *family, const char *query, const char *method);
// The mean of the "rounds" that were counted; NAN: none.
double text_mean_rounds(const table *t, const char *family, const char *query, const char *method);

void text_write(FILE *file, const table *t);

#endif
