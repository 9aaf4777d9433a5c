// Pictures of convex parts.
#include "paint.h"

#include <math.h>
#include <stdlib.h>

// The eye looks along -TOWARD; z is up.
static const double right[3] = {0.788, -0.616, 0}, up[3] = {-0.285, -0.365, 0.886}, toward[3] = {0.546, 0.698, 0.463};
static const double light[3] = {0.80, 0.30, 0.52};

static const double palette[][3] = {{0.36, 0.58, 0.80}, {0.93, 0.62, 0.30}, {0.47, 0.71, 0.57}, {0.80, 0.42, 0.46},
                                    {0.62, 0.54, 0.80}, {0.85, 0.74, 0.40}, {0.42, 0.70, 0.75}, {0.80, 0.57, 0.70}};

static double dot(const double a[3], const double b[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void paint_open(FILE *out, int width, int height) {
  fprintf(out,
          "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" width=\"%d\" height=\"%d\" "
          "font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\">\n"
          "<rect width=\"100%%\" height=\"100%%\" fill=\"#e6ebf0\"/>\n",
          width, height, width, height);
}

bool paint_close(FILE *out) {
  fprintf(out, "</svg>\n");
  return fclose(out) == 0;
}

void paint_project(const paint_view *v, const solid *s, const double x[3], double page[2], double *depth) {
  double from[3];
  for (int j = 0; j < 3; j++) {
    from[j] = x[j] - s->high[j] / 2.0;
  }
  page[0] = v->x + v->scale * dot(right, from);
  page[1] = v->y - v->scale * dot(up, from);
  *depth = dot(toward, from);
}

static void normal_of(const solid_plane *plane, double n[3]) {
  double length = 0;
  for (int j = 0; j < 3; j++) {
    n[j] = (double)plane->n[j];
    length += n[j] * n[j];
  }
  for (int j = 0; j < 3; j++) {
    n[j] /= sqrt(length);
  }
}

void paint_part(FILE *out, const paint_view *v, const solid *s, const part *p, const double shift[3],
                const double colour[3], double opacity) {
  for (unsigned f = 0, begin = 0; f < p->faces; begin = p->end[f++]) {
    double n[3];
    normal_of(&p->plane[f], n);
    if (dot(n, toward) <= 0) {
      continue;
    }
    const double shade = 0.62 + 0.38 * fmax(0, dot(n, light)) + 0.06 * n[2];
    int rgb[3], line[3];
    for (int j = 0; j < 3; j++) {
      rgb[j] = (int)fmin(255, 255 * colour[j] * shade * 1.12);
      line[j] = (int)(rgb[j] * 0.72);
    }
    fprintf(
        out, "<polygon fill=\"#%02x%02x%02x\" stroke=\"#%02x%02x%02x\" stroke-width=\"0.6\" stroke-linejoin=\"round\"",
        (unsigned)rgb[0], (unsigned)rgb[1], (unsigned)rgb[2], (unsigned)line[0], (unsigned)line[1], (unsigned)line[2]);
    if (opacity < 1) {
      fprintf(out, " opacity=\"%.2f\"", opacity);
    }
    fprintf(out, " points=\"");
    for (unsigned i = begin; i < p->end[f]; i++) {
      const int32_t *at = p->point[p->corner[i]];
      const double x[3] = {at[0] + shift[0], at[1] + shift[1], at[2] + shift[2]};
      double page[2], depth;
      paint_project(v, s, x, page, &depth);
      fprintf(out, "%s%.1f,%.1f", i > begin ? " " : "", page[0], page[1]);
    }
    fprintf(out, "\"/>\n");
  }
}

// By how much b is beyond some face of a that the eye sees: then a must be drawn first. Below 0: beyond none.
static double beyond(const part *a, const part *b, const double shift[3]) {
  double best = -INFINITY;
  for (unsigned f = 0; f < a->faces; f++) {
    double n[3], least = INFINITY;
    normal_of(&a->plane[f], n);
    if (dot(n, toward) <= 1e-6) {
      continue;
    }
    for (unsigned i = 0; i < b->points; i++) {
      const double x[3] = {b->point[i][0] - a->point[a->corner[a->end[f] - 1]][0] + shift[0],
                           b->point[i][1] - a->point[a->corner[a->end[f] - 1]][1] + shift[1],
                           b->point[i][2] - a->point[a->corner[a->end[f] - 1]][2] + shift[2]};
      least = fmin(least, dot(n, x));
    }
    best = fmax(best, least);
  }
  return best;
}

void paint_parts(FILE *out, const paint_view *v, const solid *s, const decomposition *d) {
  double(*shift)[3] = solid_allocate(d->parts, sizeof shift[0]);
  bool *drawn = solid_allocate(d->parts, sizeof drawn[0]);
  for (size_t i = 0; i < d->parts; i++) {
    for (int j = 0; j < 3; j++) {
      shift[i][j] = v->apart * ((d->part[i].low[j] + (double)d->part[i].high[j]) / 2 - s->high[j] / 2.0);
    }
  }
  for (size_t k = 0; k < d->parts; k++) {  // the next one is in front of the fewest that are not drawn, or the farthest
    size_t next = d->parts;
    double least = INFINITY;
    for (size_t i = 0; i < d->parts; i++) {
      if (drawn[i]) {
        continue;
      }
      const double middle[3] = {(d->part[i].low[0] + (double)d->part[i].high[0]) / 2 + shift[i][0],
                                (d->part[i].low[1] + (double)d->part[i].high[1]) / 2 + shift[i][1],
                                (d->part[i].low[2] + (double)d->part[i].high[2]) / 2 + shift[i][2]};
      double key = dot(toward, middle);
      for (size_t j = 0; j < d->parts; j++) {
        if (j != i && !drawn[j]) {
          const double way[3] = {shift[i][0] - shift[j][0], shift[i][1] - shift[j][1], shift[i][2] - shift[j][2]};
          const double back[3] = {-way[0], -way[1], -way[2]};
          const double in_front = beyond(&d->part[j], &d->part[i], way),
                       behind = beyond(&d->part[i], &d->part[j], back);
          key += in_front > behind ? 1e12 : 0;
        }
      }
      if (key < least) {
        least = key;
        next = i;
      }
    }
    drawn[next] = true;
    paint_part(out, v, s, &d->part[next], shift[next], palette[next % (sizeof palette / sizeof palette[0])], 1);
  }
  free(shift);
  free(drawn);
}
