// Pieces of SVG that every picture needs.
#include "svg.h"

#include <math.h>

// Points less than a tenth of a pixel from the one before are left out.
void svg_points(FILE *file, const point2 *point, size_t count) {
  point2 last = {-1e9, -1e9};
  for (size_t i = 0; i < count; i++) {
    if (hypot(point[i].x - last.x, point[i].y - last.y) > 0.1) {
      fprintf(file, "%.1f,%.1f ", point[i].x, point[i].y);
      last = point[i];
    }
  }
}

void svg_text(FILE *file, const char *text) {
  for (; *text != '\0'; text++) {
    switch (*text) {
      case '&': fputs("&amp;", file); break;
      case '<': fputs("&lt;", file); break;
      case '>': fputs("&gt;", file); break;
      default: fputc(*text, file); break;
    }
  }
}
