// The magnified origin of pairs in the plane that almost touch.
#include <math.h>

#include "trace_plot.h"

static const real3 zero = {0, 0, 0};

// Cuts a convex polygon along the line at offset across axis (0: x, 1: y); keeps what lies on the side of sign.
static size_t cut(const point2 *in, size_t n, int axis, double sign, double offset, point2 *out) {
  size_t count = 0;
  for (size_t i = 0; i < n; i++) {
    const point2 a = in[i], b = in[(i + 1) % n];
    const double from = sign * ((axis == 0 ? a.x : a.y) - offset), to = sign * ((axis == 0 ? b.x : b.y) - offset);
    if (from >= 0) {
      out[count++] = a;
    }
    if ((from < 0) != (to < 0)) {
      const double t = from / (from - to);
      out[count].x = a.x + t * (b.x - a.x);
      out[count++].y = a.y + t * (b.y - a.y);
    }
  }
  return count;
}

// How far the last simplex is from the origin, LSB; negative: it holds it, and no vertex or edge comes as near as that.
static double last_gap(const trace *t) {
  const trace_simplex *s = &t->iteration[t->count - 1].after;
  double least = INFINITY;
  for (unsigned i = 0; i < s->count; i++) {
    const trace_simplex edge = {2, {s->vertex[i], s->vertex[(i + 1) % s->count]}};
    const real3 e = real_sub(plot_real(&edge.vertex[1].w), plot_real(&edge.vertex[0].w));
    const real3 at = plot_nearest_point(real_dot(e, e) > 0 ? &edge : s);
    least = fmin(least, 65536 * sqrt(real_dot(at, at)));
  }
  return least;
}

static double size_of(const trace_body *body) {
  double most = 0;
  for (size_t i = 0; i < body->outlines; i++) {
    most = fmax(most, sqrt(real_dot(body->outline[i], body->outline[i])));
  }
  return most;
}

bool plot_magnifies(const trace *t, const trace_bodies *bodies) {
  return t->dimensions == 2 && t->count > 0 && t->radius == 0 && last_gap(t) < 8 &&
         65536 * size_of(&bodies->difference) > 1000;
}

static size_t clip(plot *p, const trace_body *body, point2 piece[2][OUTLINE_POINTS + 8]) {
  const label_rectangle *own = &p->page.area;
  const label_rectangle wide = {own->left - 9, own->top - 9, own->width + 18, own->height + 18}, *area = &wide;
  size_t n = body->outlines;
  for (size_t i = 0; i < n; i++) {
    piece[0][i] = view_project(&p->camera, body->outline[i]);
  }
  n = cut(piece[0], n, 0, 1, area->left, piece[1]);
  n = cut(piece[1], n, 0, -1, area->left + area->width, piece[0]);
  n = cut(piece[0], n, 1, 1, area->top, piece[1]);
  return cut(piece[1], n, 1, -1, area->top + area->height, piece[0]);
}

double plot_magnified(FILE *file, const trace *t, const trace_bodies *bodies, label_rectangle area) {
  static plot p;
  static point2 piece[2][OUTLINE_POINTS + 8];
  extent2 all = {{0, 0}, {0, 0}};
  plot_open(&p, file, bodies, area);
  plot_extend(&all, &p.camera, &bodies->difference);
  plot_fit(&p, &all, 30);
  const double reach = fmax(3, 2 * ceil(last_gap(t))), step = area.height / (2 * reach + 1);
  const double larger = 65536 * step / p.camera.scale;
  p.camera.scale = 65536 * step;
  p.camera.left = area.left + area.width / 2;
  p.camera.top = area.top + area.height / 2;
  const size_t n = clip(&p, &bodies->difference, piece);
  fprintf(file,
          "<svg x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" viewBox=\"%.1f %.1f %.1f %.1f\">\n<g "
          "stroke-width=\"2\">",
          area.left, area.top, area.width, area.height, area.left, area.top, area.width, area.height);
  plot_polygon(&p, "sd", piece[0], n);
  fprintf(file, "</g>\n");
  const int rows = (int)reach, columns = (int)(area.width / step / 2);
  for (int y = -rows; y <= rows; y++) {
    for (int x = -columns; x <= columns; x++) {
      const point2 at = {p.camera.left + x * step, p.camera.top - y * step};
      plot_dot(&p, "lattice", at, 2);
      plot_take(&p, at, 4);
    }
  }
  plot_origin(&p, t);
  plot_label(&p, "ink", view_project(&p.camera, zero), "O", 18);
  fprintf(file, "</svg>\n");
  return larger;
}
