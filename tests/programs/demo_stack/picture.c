// Draws the pile at each moment with the pieces of tests/programs/demo.
#include <math.h>

#include "../demo/draw.h"
#include "demo_stack.h"

#define WIDTH 1480.0
#define HEIGHT 720.0
#define PIXELS_PER_UNIT 53.0
#define FLOOR_AT 530.0
#define INK "#1d2733"
#define FAINT "#6b7785"

static const colour palette[] = {{0.80, 0.83, 0.87}, {0.82, 0.66, 0.45}, {0.95, 0.60, 0.25}, {0.30, 0.55, 0.80},
                                 {0.45, 0.72, 0.58}, {0.75, 0.30, 0.38}, {0.62, 0.52, 0.80}};

void demo_stack_open(FILE *file) {
  fprintf(file,
          "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %.0f %.0f\" width=\"%.0f\" height=\"%.0f\" "
          "font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\">\n"
          "<rect width=\"100%%\" height=\"100%%\" fill=\"#e6ebf0\"/>\n"
          "<text x=\"28\" y=\"40\" font-size=\"20\" font-weight=\"bold\" fill=\"" INK
          "\">A pile falls and comes to rest</text>\n"
          "<text x=\"%.0f\" y=\"40\" font-size=\"14\" fill=\"" FAINT
          "\" text-anchor=\"end\">integers alone; impulses start from those of the contact with the same id</text>\n",
          WIDTH, HEIGHT, WIDTH, HEIGHT, WIDTH - 28);
}

// Is a behind b? Asked of bodies that may hide each other; a plane between them tells.
static bool is_behind(const demo_stack *d, const view *v, unsigned a, unsigned b) {
  gjk_distance_result gap;
  static gjk_epa_cell cells[GJK_EPA_CELLS(64)];
  const gjk_workspace workspace = {cells, sizeof cells / sizeof cells[0]};
  (void)gjk_signed_distance(&d->world.body[a].collider, &d->world.body[b].collider, NULL, &workspace, &gap);
  const real3 normal = {gap.normal.x, gap.normal.y, gap.normal.z};
  return real_dot(normal, v->toward) > 1e-4 * (double)GJK_Q30_ONE;
}

typedef struct extent2 {
  point2 low, high;
} extent2;

static extent2 extent_of(const view *v, const case_shape *shape) {
  point2 outline[OUTLINE_POINTS];
  draw_outline(v, shape, outline);
  extent2 e = {outline[0], outline[0]};
  for (int i = 1; i < OUTLINE_POINTS; i++) {
    e.low.x = fmin(e.low.x, outline[i].x);
    e.low.y = fmin(e.low.y, outline[i].y);
    e.high.x = fmax(e.high.x, outline[i].x);
    e.high.y = fmax(e.high.y, outline[i].y);
  }
  return e;
}

static bool extents_meet(const extent2 *a, const extent2 *b) {
  return a->low.x < b->high.x && b->low.x < a->high.x && a->low.y < b->high.y && b->low.y < a->high.y;
}

// Painter's order, after the floor: of the bodies that hide nothing still to be drawn, the farthest is next.
static void sort(const demo_stack *d, const view *v, unsigned order[SOLVER_BODIES_MAX]) {
  static extent2 extent[SOLVER_BODIES_MAX];
  bool drawn[SOLVER_BODIES_MAX] = {false};
  const unsigned n = d->world.bodies;
  for (unsigned i = 0; i < n; i++) {
    extent[i] = extent_of(v, &d->drawn[i]);
  }
  for (unsigned k = 0; k < n; k++) {
    double best = INFINITY;
    for (unsigned i = 0; i < n; i++) {
      double key = i == 0 ? -1e9 : real_dot(real_from_q16(d->drawn[i].pose.position), v->toward);
      for (unsigned j = 0; j < n && !drawn[i]; j++) {
        key += j != i && !drawn[j] && extents_meet(&extent[i], &extent[j]) && is_behind(d, v, j, i) ? 1e6 : 0;
      }
      if (!drawn[i] && key < best) {
        best = key;
        order[k] = i;
      }
    }
    drawn[order[k]] = true;
  }
}

static void put_shadows(FILE *file, const demo_stack *d, const view *v, unsigned moment) {
  point2 outline[OUTLINE_POINTS];
  draw_outline(v, &d->drawn[0], outline);
  fprintf(file, "<clipPath id=\"floor%u\"><polygon points=\"", moment);
  svg_points(file, outline, OUTLINE_POINTS);
  fprintf(file, "\"/></clipPath>\n<g clip-path=\"url(#floor%u)\" fill=\"#27313d\" fill-opacity=\"0.13\">\n", moment);
  for (unsigned i = 1; i < d->world.bodies; i++) {
    draw_shadow_outline(v, &d->drawn[i], 0, outline);
    fprintf(file, "<polygon points=\"");
    svg_points(file, outline, OUTLINE_POINTS);
    fprintf(file, "\"/>\n");
  }
  fprintf(file, "</g>\n");
}

void demo_stack_draw(FILE *file, demo_stack *d, unsigned moment, unsigned tick) {
  view v = view_make(0.38, 0.34);
  unsigned order[SOLVER_BODIES_MAX] = {0};
  point2 outline[OUTLINE_POINTS];
  v.scale = PIXELS_PER_UNIT;
  v.left = WIDTH * (2 * moment + 1) / (2 * DEMO_MOMENTS);
  v.top = FLOOR_AT;
  for (unsigned i = 0; i < d->world.bodies; i++) {
    d->drawn[i].pose = d->world.body[i].pose;
  }
  sort(d, &v, order);
  for (unsigned k = 0; k < d->world.bodies; k++) {
    const unsigned i = order[k];
    draw_body(file, &v, &d->drawn[i], palette[d->kind[i]], moment * SOLVER_BODIES_MAX + i);
    draw_outline(&v, &d->drawn[i], outline);
    fprintf(file, "<polygon fill=\"none\" stroke=\"" INK "\" stroke-width=\"0.7\" points=\"");
    svg_points(file, outline, OUTLINE_POINTS);
    fprintf(file, "\"/>\n");
    if (i == 0) {
      put_shadows(file, d, &v, moment);
    }
  }
  fprintf(file,
          "<text x=\"%.0f\" y=\"%.0f\" font-size=\"15\" fill=\"" INK
          "\" text-anchor=\"middle\">after %.1f s: the fastest moves at %.3f units a second</text>\n",
          v.left, HEIGHT - 24, (double)tick / SOLVER_RATE, (double)solver_speed(&d->world) / (double)SOLVER_ONE);
}
