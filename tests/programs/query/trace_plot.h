// A plot of a trace: a part of the page with a view of its own, and what is drawn in it.
#ifndef QUERY_TRACE_PLOT_H
#define QUERY_TRACE_PLOT_H

#include "../demo/labels.h"
#include "trace_body.h"

// Sizes of the font, pixels.
#define PLOT_FONT 18.0
#define PLOT_CHARACTER 10.4

// class: a name of the style sheet in trace_picture.c.
typedef struct plot {
  FILE *file;
  view camera;
  label_page page;
} plot;

typedef struct extent2 {
  point2 low, high;
} extent2;

real3 plot_real(const trace_point *p);

// The point of a simplex of 1 to 3 vertices that is nearest to the origin. Pre: its projection lies inside.
real3 plot_nearest_point(const trace_simplex *s);

// Opens a plot in a rectangle of the page; the view is at scale 1.
void plot_open(plot *p, FILE *file, const trace_bodies *bodies, label_rectangle area);

void plot_extend(extent2 *e, const view *v, const trace_body *body);

// Scales and moves the view so that the extent, taken at scale 1, fills the plot but for a border.
void plot_fit(plot *p, const extent2 *e, double border);

// Keep labels off a point, or a line.
void plot_take(plot *p, point2 at, double size);
void plot_take_line(plot *p, point2 a, point2 b);

void plot_polygon(plot *p, const char *class, const point2 *point, size_t n);
void plot_line(plot *p, const char *class, point2 a, point2 b);
void plot_dot(plot *p, const char *class, point2 at, double radius);

// An arrow from a point along a direction; its length says how much of the direction lies in the page.
void plot_arrow(plot *p, point2 from, real3 direction);

// A label near a point, out of the way of what is there. nearest: the least distance of its middle; 0: on the point.
void plot_label(plot *p, const char *class, point2 at, const char *text, double nearest);

// class: of fill and outline.
void plot_body(plot *p, const char *class, const trace_body *body);
point2 plot_middle(const plot *p, const trace_body *body);

// The origin, and the disc of the radius that the cores are compared with.
void plot_origin(plot *p, const trace *t);

// Is the origin of a traced pair so close to the border of A - B that only a magnified plot shows on which side it is?
bool plot_magnifies(const trace *t, const trace_bodies *bodies);

// Draws A - B around the origin, with a dot for each point of the lattice. Returns how many times larger it is than in
// a plot that shows all of A - B.
double plot_magnified(FILE *file, const trace *t, const trace_bodies *bodies, label_rectangle area);

#endif
