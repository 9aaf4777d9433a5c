// Draws single bodies as SVG: a parallel projection, shaded faces, gradients on round surfaces.
#ifndef DRAW_H
#define DRAW_H

#include "geometry.h"
#include "svg.h"

// Unit vectors of the world; light points to the lamp. Lengths on the page are in pixels, y downwards.
typedef struct view {
  real3 right, up, toward, light;
  double scale, left, top;  // pixels per unit, and where the world's origin goes
} view;

typedef struct colour {
  double red, green, blue;  // 0 to 1
} colour;

enum { OUTLINE_POINTS = 144 };

view view_make(double azimuth, double elevation);
point2 view_project(const view *v, real3 point);

// The outline of the body on the page.
void draw_outline(const view *v, const case_shape *shape, point2 outline[OUTLINE_POINTS]);

// The outline of its shadow in the horizontal plane at height.
void draw_shadow_outline(const view *v, const case_shape *shape, double height, point2 outline[OUTLINE_POINTS]);

// id: a number of the body, for the names of its gradients.
void draw_body(FILE *file, const view *v, const case_shape *shape, colour base, size_t id);

#endif
