// The page of a run: plots, and the same numbers in tables; one HTML file that needs nothing else.
#ifndef REPORT_PAGE_H
#define REPORT_PAGE_H

#include "table.h"

void page_write(FILE *file, const table *t);

#endif
