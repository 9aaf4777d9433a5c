// Convex parts as a picture: as they are, and moved apart.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "paint.h"
#include "write_parts.h"

bool write_parts_picture(const solid *s, const decomposition *d, const char *file) {
  FILE *out = fopen(file, "w");
  if (out == NULL) {
    return false;
  }
  paint_open(out, 960, 480);
  const double widest = fmax(s->high[0], fmax(s->high[1], s->high[2]));
  for (int i = 0; i < 2; i++) {
    const paint_view view = {240 + 480 * i, 240, 250 / widest, i == 0 ? 0 : 0.35};
    paint_parts(out, &view, s, d);
  }
  return paint_close(out);
}
