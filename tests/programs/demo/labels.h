// Places labels near what they name, out of each other's way.
#ifndef LABELS_H
#define LABELS_H

#include <stdbool.h>
#include <stddef.h>

#include "svg.h"

enum { LABEL_RECTANGLES_MAX = 512 };

typedef struct label_rectangle {
  double left, top, width, height;
} label_rectangle;

// What is already on the page, and what labels should keep clear of.
typedef struct label_page {
  label_rectangle area;
  label_rectangle taken[LABEL_RECTANGLES_MAX];
  double weight[LABEL_RECTANGLES_MAX];  // of an overlap with it
  size_t count;
} label_page;

void label_take(label_page *page, label_rectangle r, double weight);

// Finds the best place for a label of that size near the anchor, and takes it. nearest: the smallest distance from the
// anchor to the middle of the label; 0 lets it lie on the anchor.
label_rectangle label_place(label_page *page, point2 anchor, double width, double height, double nearest);

#endif
