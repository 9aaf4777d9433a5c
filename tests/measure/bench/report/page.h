// Writes the page of a run: plots, and the same numbers in tables. It is one HTML file that needs nothing else.
#ifndef REPORT_PAGE_H
#define REPORT_PAGE_H

#include "scene.h"
#include "table.h"

// scenes: NULL if none were measured.
void page_write(FILE *file, const table *t, const scene_table *scenes);

#endif
