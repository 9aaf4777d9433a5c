// Plots of a trace.
#include "trace_plot.h"

#include <math.h>
#include <string.h>

#define ARROW 38.0

static const real3 zero = {0, 0, 0};

real3 plot_real(const trace_point *p) {
  const real3 out = {(double)p->x[0] / 65536, (double)p->x[1] / 65536, (double)p->x[2] / 65536};
  return out;
}

// The point of a simplex of 1 to 3 vertices that is nearest to the origin; its projection lies inside.
real3 plot_nearest_point(const trace_simplex *s) {
  const real3 a = plot_real(&s->vertex[0].w);
  if (s->count == 1) {
    return a;
  }
  const real3 ab = real_sub(plot_real(&s->vertex[1].w), a);
  if (s->count == 2) {
    return real_sub(a, real_scale(real_dot(a, ab) / real_dot(ab, ab), ab));
  }
  const real3 normal = real_cross(ab, real_sub(plot_real(&s->vertex[2].w), a));
  return real_scale(real_dot(a, normal) / fmax(real_dot(normal, normal), 1e-300), normal);
}

// Fitting.

static void extend(extent2 *e, point2 p) {
  e->low.x = fmin(e->low.x, p.x);
  e->low.y = fmin(e->low.y, p.y);
  e->high.x = fmax(e->high.x, p.x);
  e->high.y = fmax(e->high.y, p.y);
}

void plot_extend(extent2 *e, const view *v, const trace_body *body) {
  for (size_t i = 0; i < body->outlines; i++) {
    extend(e, view_project(v, body->outline[i]));
  }
}

// Scales and moves the view of a plot so that the extent, taken at scale 1, fills it.
void plot_fit(plot *p, const extent2 *e, double border) {
  const double width = e->high.x - e->low.x, height = e->high.y - e->low.y;
  const label_rectangle *area = &p->page.area;
  view *v = &p->camera;
  v->scale = fmin((area->width - 2 * border) / fmax(width, 1e-9), (area->height - 2 * border) / fmax(height, 1e-9));
  v->left = area->left + area->width / 2 - v->scale * (e->low.x + width / 2);
  v->top = area->top + area->height / 2 - v->scale * (e->low.y + height / 2);
}

void plot_open(plot *p, FILE *file, const trace_bodies *bodies, label_rectangle area) {
  memset(p, 0, sizeof *p);
  p->file = file;
  p->camera = bodies->camera;
  p->camera.scale = 1;
  p->page.area = area;
}

void plot_take(plot *p, point2 at, double size) {
  const label_rectangle r = {at.x - size / 2, at.y - size / 2, size, size};
  label_take(&p->page, r, 12);
}

// Keeps labels off a line.
void plot_take_line(plot *p, point2 a, point2 b) {
  const int steps = 1 + (int)(fmin(hypot(b.x - a.x, b.y - a.y), 1000) / 10);
  for (int i = 0; i <= steps; i++) {
    const point2 at = {a.x + (b.x - a.x) * i / steps, a.y + (b.y - a.y) * i / steps};
    plot_take(p, at, 5);
  }
}

// Pieces.

void plot_polygon(plot *p, const char *class, const point2 *point, size_t n) {
  fprintf(p->file, "<polygon class=\"%s\" points=\"", class);
  svg_points(p->file, point, n);
  fprintf(p->file, "\"/>\n");
}

void plot_line(plot *p, const char *class, point2 a, point2 b) {
  fprintf(p->file, "<line class=\"%s\" x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\"/>\n", class, a.x, a.y, b.x, b.y);
}

void plot_dot(plot *p, const char *class, point2 at, double radius) {
  fprintf(p->file, "<circle class=\"%s\" cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\"/>\n", class, at.x, at.y, radius);
}

// A label near a point, out of the way of what is there.
void plot_label(plot *p, const char *class, point2 at, const char *text, double nearest) {
  const double width = PLOT_CHARACTER * (double)strlen(text);
  const label_rectangle r = label_place(&p->page, at, width, PLOT_FONT, nearest);
  fprintf(p->file, "<text class=\"%s halo\" x=\"%.1f\" y=\"%.1f\" text-anchor=\"middle\">", class, r.left + width / 2,
          r.top + PLOT_FONT - 3.5);
  svg_text(p->file, text);
  fprintf(p->file, "</text>\n");
}

// An arrow from a point along a direction of the page; its length says how much of the direction lies in the page.
void plot_arrow(plot *p, point2 from, real3 direction) {
  const view *v = &p->camera;
  const double length = sqrt(real_dot(direction, direction));
  const double x = real_dot(direction, v->right) / length, y = -real_dot(direction, v->up) / length, size = hypot(x, y);
  if (length <= 0 || size < 0.2) {
    return;  // towards the camera or away from it
  }
  const point2 tip = {from.x + ARROW * x, from.y + ARROW * y};
  const double u = x / size, w = y / size;
  const point2 end = {tip.x - 9 * u, tip.y - 9 * w};
  const point2 head[3] = {
      tip, {tip.x - 12 * u + 5 * w, tip.y - 12 * w - 5 * u}, {tip.x - 12 * u - 5 * w, tip.y - 12 * w + 5 * u}};
  plot_line(p, "way", from, end);
  plot_polygon(p, "tip", head, 3);
  plot_take_line(p, from, tip);
}

static void put_faces(plot *p, const char *class, const trace_body *body, bool front) {
  point2 corner[FACE_VERTICES_MAX];
  for (size_t i = 0; i < body->face_count; i++) {
    const real_face *face = &body->faces[i];
    for (size_t k = 0; k < face->count; k++) {
      corner[k] = view_project(&p->camera, face->vertex[k]);
    }
    if ((real_dot(face->normal, p->camera.toward) > 1e-9) == front) {
      plot_polygon(p, class, corner, face->count);
    }
  }
}

// class: of the fill and outline, sa, sb or sd.
// Keeps labels off an outline: round ones have many short lines.
static void take_outline(plot *p, const point2 *line, size_t n) {
  const double spacing = 14;
  double left = 0;
  for (size_t i = 0; i < n; i++) {
    const point2 a = line[i], b = line[(i + 1) % n];
    const double length = hypot(b.x - a.x, b.y - a.y);
    for (; left < length; left += spacing) {
      const point2 at = {a.x + (b.x - a.x) * left / length, a.y + (b.y - a.y) * left / length};
      const label_rectangle r = {at.x - 4, at.y - 4, 8, 8};
      label_take(&p->page, r, 4);
    }
    left -= length;
  }
}

void plot_body(plot *p, const char *class, const trace_body *body) {
  point2 line[OUTLINE_POINTS];
  char inner[16];
  for (size_t i = 0; i < body->outlines; i++) {
    line[i] = view_project(&p->camera, body->outline[i]);
  }
  fprintf(p->file, "<g stroke-width=\"1.6\" stroke-linejoin=\"round\">\n");
  plot_polygon(p, class, line, body->outlines);
  take_outline(p, line, body->outlines);
  snprintf(inner, sizeof inner, "%s hid", class);
  if (body->round) {
    for (size_t i = 0; i < body->outlines; i++) {
      line[i] = view_project(&p->camera, body->core[i]);
    }
    fprintf(p->file, "<g fill-opacity=\"0\">");
    plot_polygon(p, inner, line, body->outlines);
    fprintf(p->file, "</g>");
  }
  fprintf(p->file, "<g fill-opacity=\"0\">\n");
  put_faces(p, inner, body, false);
  if (!body->round) {
    put_faces(p, class, body, true);
  }
  fprintf(p->file, "</g></g>\n");
}

point2 plot_middle(const plot *p, const trace_body *body) {
  point2 sum = {0, 0};
  for (size_t i = 0; i < body->outlines; i++) {
    const point2 at = view_project(&p->camera, body->outline[i]);
    sum.x += at.x / (double)body->outlines;
    sum.y += at.y / (double)body->outlines;
  }
  return sum;
}

void plot_origin(plot *p, const trace *t) {
  const point2 o = view_project(&p->camera, zero);
  const point2 left = {o.x - 9, o.y}, right = {o.x + 9, o.y}, up = {o.x, o.y - 9}, down = {o.x, o.y + 9};
  const double radius = (double)t->radius / 65536 * p->camera.scale;
  if (radius > 3 && radius < 2000) {
    plot_dot(p, "disc", o, radius);
  }
  plot_line(p, "origin", left, right);
  plot_line(p, "origin", up, down);
  plot_take(p, o, 20);
}
