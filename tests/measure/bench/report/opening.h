// Opens the page: one chart and one table of all methods over all families.
#ifndef REPORT_OPENING_H
#define REPORT_OPENING_H

#include "table.h"

void opening_write(FILE *file, const table *t);

#endif
