// Reads and draws the figures that scene-bench writes: what the tick of a scene costs, and what saves it.
#ifndef REPORT_SCENE_H
#define REPORT_SCENE_H

#include <stdbool.h>
#include <stdio.h>

#define SCENE_COLUMNS_MAX 32
#define SCENE_ROWS_MAX 256

typedef struct scene_table {
  char columns[SCENE_COLUMNS_MAX][32];
  unsigned column_count, row_count;
  char names[SCENE_ROWS_MAX][16];                    // first column
  double values[SCENE_ROWS_MAX][SCENE_COLUMNS_MAX];  // NAN where there is none
} scene_table;

// False, with a message, if it is not such a table.
bool scene_read(scene_table *out, FILE *file, const char *name);

// Writes the page's sections about scenes.
void scene_write(FILE *file, const scene_table *t);

#endif
