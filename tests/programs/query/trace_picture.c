// Draws traces.
//
// A panel has a heading, two plots, and two lines of text:
//   left     the shapes, the support points of the iteration, and the directions in which they are farthest
//   right    A - B, the origin, the simplex before (dashed) and after, the vertex found; in the plane the line across
//            the direction through that vertex, beyond which A - B does not reach
#include "trace_picture.h"

#include <math.h>
#include <string.h>

#include "trace_plot.h"

#define WIDTH 1240.0
#define MARGIN 20.0
#define GAP 16.0
#define COLUMNS 2u
#define PANEL_WIDTH ((WIDTH - 2 * MARGIN - GAP) / COLUMNS)
#define PANEL_HEIGHT 352.0
#define PLOT_TOP 44.0
#define PLOT_HEIGHT 244.0
#define PLOT_WIDTH (PANEL_WIDTH / 2 - 12)
#define TITLE_HEIGHT 56.0
enum { TEXT_MAX = 200, NAMES_MAX = 96 };

// librsvg and old viewers know no variables in style sheets: each colour is written out, twice where dark differs.
static const char style[] =
    "<style>"
    ".page{fill:#eef1f5}.panel{fill:#fff;stroke:#cdd5dd}.ink,.tl{fill:#1d2733}.faint{fill:#56616e}"
    ".sa{fill:#cfe1f8;stroke:#1f66b5}.sb{fill:#fbdcb6;fill-opacity:.75;stroke:#a85d00}.sd{fill:#e3e7ec;stroke:#6a7684}"
    ".core,.hid,.edge{fill:none}.hid{stroke-width:1;stroke-dasharray:2 4;stroke-opacity:.7}"
    ".la{fill:#124a8c}.lb{fill:#7a4300}.ld{fill:#4d5864}"
    ".before{fill:none;stroke:#8a5bb5;stroke-width:2;stroke-dasharray:7 5}"
    ".after{stroke:#7b1fa2;stroke-width:3.5;stroke-linecap:round}.face{fill:#7b1fa2;fill-opacity:.2}"
    ".vertex{fill:#7b1fa2}.old{fill:#fff;stroke:#8a5bb5;stroke-width:1.6}"
    ".found{fill:none;stroke:#c4151c;stroke-width:2.4}.fl{fill:#b0121a}"
    ".way{stroke:#0a7a45;stroke-width:2.4}.tip{fill:#0a7a45}.line{stroke:#0a7a45;stroke-width:1.6;stroke-dasharray:4 4}"
    ".gap{stroke:#1d2733;stroke-width:1.5;stroke-dasharray:2 4}.origin{stroke:#1d2733;stroke-width:2.2}"
    ".disc{fill:#1d2733;fill-opacity:.08;stroke:#1d2733;stroke-dasharray:5 4}.dot{fill:#1d2733}"
    ".halo{stroke:#fff;stroke-width:4;stroke-opacity:.85;paint-order:stroke;stroke-linejoin:round}"
    ".stop{fill:#b0121a}.lattice{fill:#8a96a3}"
    "@media(prefers-color-scheme:dark){"
    ".page{fill:#11161b}.panel{fill:#1a2027;stroke:#39434e}.ink,.tl{fill:#e8edf2}.faint{fill:#a3afbb}"
    ".sa{fill:#1e3a5c;stroke:#6fb1ff}.sb{fill:#55391a;stroke:#f0a850}.sd{fill:#2d353e;stroke:#97a4b1}"
    ".la{fill:#a9d0ff}.lb{fill:#ffcf94}.ld{fill:#c3ccd6}"
    ".before{stroke:#b48ade}.after{stroke:#c77dff}.face{fill:#c77dff}.vertex{fill:#c77dff}.old{fill:#1a2027;stroke:#"
    "b48ade}"
    ".found{stroke:#ff6b70}.fl,.stop{fill:#ff8a8e}.way,.line{stroke:#43cf8a}.tip{fill:#43cf8a}"
    ".gap,.origin,.disc{stroke:#e8edf2}.disc,.dot{fill:#e8edf2}.halo{stroke:#1a2027}}"
    "</style>\n";

static const real3 zero = {0, 0, 0};

static label_rectangle area_at(double left, double top) {
  const label_rectangle area = {left, top, PLOT_WIDTH, PLOT_HEIGHT};
  return area;
}

// The left plot.

static void number_text(char text[24], const char *letter, unsigned number, bool curved) {
  if (curved) {
    snprintf(text, 24, "%s", letter);
  } else {
    snprintf(text, 24, "%s%u", letter, number);
  }
}

static void put_shapes(FILE *file, const trace *t, const trace_bodies *bodies, unsigned i, double left, double top) {
  static plot p;
  const trace_vertex *found = &t->iteration[i].found;
  const real3 way = plot_real(&t->iteration[i].direction);
  extent2 e = {{1e30, 1e30}, {-1e30, -1e30}};
  char text[24];
  plot_open(&p, file, bodies, area_at(left, top));
  plot_extend(&e, &p.camera, &bodies->a);
  plot_extend(&e, &p.camera, &bodies->b);
  plot_fit(&p, &e, 42);
  plot_body(&p, "sa", &bodies->a);
  plot_body(&p, "sb", &bodies->b);
  const point2 a = view_project(&p.camera, plot_real(&found->a)), b = view_project(&p.camera, plot_real(&found->b));
  plot_arrow(&p, a, way);
  plot_arrow(&p, b, real_scale(-1, way));
  plot_dot(&p, "la", a, 5);
  plot_dot(&p, "lb", b, 5);
  plot_take(&p, a, 12);
  plot_take(&p, b, 12);
  number_text(text, "a", found->number_a, t->curved);
  plot_label(&p, "la", a, text, 18);
  number_text(text, "b", found->number_b, t->curved);
  plot_label(&p, "lb", b, text, 18);
  plot_label(&p, "la", plot_middle(&p, &bodies->a), "A", 0);
  plot_label(&p, "lb", plot_middle(&p, &bodies->b), "B", 0);
}

// The right plot.

// class: before, dashed lines; after, lines and the faces between them.
static void put_simplex(plot *p, const char *class, const trace_simplex *s, bool faces) {
  point2 corner[4];
  for (unsigned i = 0; i < s->count; i++) {
    corner[i] = view_project(&p->camera, plot_real(&s->vertex[i].w));
  }
  for (unsigned skip = 0; skip < 4 && s->count >= 3 && faces; skip++) {  // the triangle, or those of the tetrahedron
    point2 face[3];
    unsigned n = 0;
    for (unsigned i = 0; i < s->count && n < 3; i++) {
      if (i != skip || s->count == 3) {
        face[n++] = corner[i];
      }
    }
    if (s->count == 4 || skip == 0) {
      plot_polygon(p, "face", face, 3);
    }
  }
  for (unsigned i = 0; i < s->count; i++) {
    for (unsigned k = 0; k < i; k++) {
      plot_take_line(p, corner[i], corner[k]);
      plot_line(p, class, corner[i], corner[k]);
    }
  }
}

static void put_vertices(plot *p, const trace_iteration *it) {
  const point2 found = view_project(&p->camera, plot_real(&it->found.w));
  for (unsigned i = 0; i < it->before.count; i++) {
    const point2 at = view_project(&p->camera, plot_real(&it->before.vertex[i].w));
    plot_dot(p, "old", at, 5);
    plot_take(p, at, 12);
  }
  for (unsigned i = 0; i < it->after.count; i++) {
    const point2 at = view_project(&p->camera, plot_real(&it->after.vertex[i].w));
    plot_dot(p, "vertex", at, 5);
    plot_take(p, at, 12);
  }
  plot_dot(p, "found", found, 9);
  plot_take(p, found, 18);
}

static void name_vertices(plot *p, const trace_iteration *it) {
  unsigned named[9], names = 0;
  for (unsigned i = 0; i < 1 + it->before.count + it->after.count; i++) {
    const trace_vertex *v = i == 0                     ? &it->found
                            : i - 1 < it->before.count ? &it->before.vertex[i - 1]
                                                       : &it->after.vertex[i - 1 - it->before.count];
    bool known = v->name == 0;
    for (unsigned k = 0; k < names; k++) {
      known = known || named[k] == v->name;
    }
    if (!known) {
      char text[16];
      snprintf(text, sizeof text, "w%u", v->name);
      named[names++] = v->name;
      plot_label(p, i == 0 ? "fl" : "ink", view_project(&p->camera, plot_real(&v->w)), text, 20);
    }
  }
}

// In the plane: the line across the direction through the vertex found, from border to border.
static void put_support_line(plot *p, const trace_iteration *it) {
  const real3 way = plot_real(&it->direction);
  const point2 at = view_project(&p->camera, plot_real(&it->found.w));
  const double length = hypot(way.x, way.y), x = way.y / length, y = way.x / length;
  const label_rectangle *area = &p->page.area;
  double low = -1e9, high = 1e9;
  const double slope[2] = {x, y}, from[2] = {area->left - at.x, area->top - at.y};
  const double size[2] = {area->width, area->height};
  for (int k = 0; k < 2; k++) {
    if (fabs(slope[k]) > 1e-9) {
      const double s = from[k] / slope[k], e = (from[k] + size[k]) / slope[k];
      low = fmax(low, fmin(s, e));
      high = fmin(high, fmax(s, e));
    }
  }
  const point2 a = {at.x + low * x, at.y + low * y}, b = {at.x + high * x, at.y + high * y};
  plot_line(p, "line", a, b);
  plot_take_line(p, a, b);
}

static void put_difference(FILE *file, const trace *t, const trace_bodies *bodies, unsigned i, double left,
                           double top) {
  static plot p;
  const trace_iteration *it = &t->iteration[i];
  extent2 e = {{0, 0}, {0, 0}};
  plot_open(&p, file, bodies, area_at(left, top));
  plot_extend(&e, &p.camera, &bodies->difference);
  plot_fit(&p, &e, 30);
  fprintf(file, "<svg x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" viewBox=\"%.1f %.1f %.1f %.1f\">\n", left,
          top, PLOT_WIDTH, PLOT_HEIGHT, left, top, PLOT_WIDTH, PLOT_HEIGHT);
  plot_body(&p, "sd", &bodies->difference);
  if (t->dimensions == 2) {
    put_support_line(&p, it);
  }
  const real3 start = it->before.count > 0 && it->before.count < 4 ? plot_nearest_point(&it->before) : zero;
  const point2 from = it->before.count > 0 ? view_project(&p.camera, start) : plot_middle(&p, &bodies->difference);
  plot_origin(&p, t);
  put_simplex(&p, "before", &it->before, false);
  put_simplex(&p, "after", &it->after, true);
  if (it->after.count > 0 && it->after.count < (t->reason == TRACE_ENCLOSING && i + 1 == t->count ? 0u : 4u)) {
    const point2 nearest = view_project(&p.camera, plot_nearest_point(&it->after));
    plot_line(&p, "gap", nearest, view_project(&p.camera, zero));
    plot_take_line(&p, nearest, view_project(&p.camera, zero));
  }
  plot_arrow(&p, from, plot_real(&it->direction));
  put_vertices(&p, it);
  name_vertices(&p, it);
  plot_label(&p, "ink", view_project(&p.camera, zero), "O", 18);
  plot_label(&p, "ld", plot_middle(&p, &bodies->difference), "A \xE2\x88\x92 B", 0);
  fprintf(file, "</svg>\n");
}

// Text.

// Writes text in at most two lines, at most so many characters in the first.
static void put_wrapped(FILE *file, const char *class, double x, double y, const char *text) {
  const size_t most = (size_t)((PANEL_WIDTH - 28) / PLOT_CHARACTER);
  size_t cut = strlen(text);
  if (cut > most) {
    cut = most;
    while (cut > 0 && text[cut] != ' ') {
      cut--;
    }
  }
  char first[TEXT_MAX];
  snprintf(first, sizeof first, "%.*s", (int)cut, text);
  fprintf(file, "<text class=\"%s\" x=\"%.1f\" y=\"%.1f\">", class, x, y);
  svg_text(file, first);
  fprintf(file, "</text>\n");
  if (text[cut] == ' ') {
    fprintf(file, "<text class=\"%s\" x=\"%.1f\" y=\"%.1f\">", class, x, y + 23);
    svg_text(file, text + cut + 1);
    fprintf(file, "</text>\n");
  }
}

// The names of the vertices, with blanks between them.
static void simplex_words(const trace_simplex *s, char text[NAMES_MAX]) {
  trace_simplex_text(s, text, NAMES_MAX);
  for (char *c = text; *c != '\0'; c++) {
    *c = *c == ',' ? ' ' : *c;
  }
  if (s->count == 0) {
    snprintf(text, NAMES_MAX, "none");
  }
}

static void put_words(FILE *file, const trace *t, unsigned i, double left, double top) {
  const trace_iteration *it = &t->iteration[i];
  char before[NAMES_MAX], after[NAMES_MAX], a[24], b[24];
  number_text(a, "a", it->found.number_a, t->curved);
  number_text(b, "b", it->found.number_b, t->curved);
  simplex_words(&it->before, before);
  simplex_words(&it->after, after);
  fprintf(file,
          "<text class=\"ink\" x=\"%.1f\" y=\"%.1f\"><tspan font-weight=\"bold\">Iteration %u</tspan> finds w%u%s = %s "
          "\xE2\x88\x92 %s</text>\n",
          left + 14, top + 30, i + 1, it->found.name, it->found.name <= i ? " again" : "", a, b);
  if (i + 1 < t->count) {
    fprintf(file, "<text class=\"ink\" x=\"%.1f\" y=\"%.1f\">simplex: %s \xE2\x86\x92 %s</text>\n", left + 14,
            top + PANEL_HEIGHT - 42, before, after);
  } else {
    char stop[TEXT_MAX + 16];
    snprintf(stop, sizeof stop, "Stop: %s", trace_reason_text(t));
    put_wrapped(file, "stop", left + 14, top + PANEL_HEIGHT - 42, stop);
  }
}

bool trace_picture_open(trace_picture *p) {
  p->panels = tmpfile();
  p->height = MARGIN;
  return p->panels != NULL;
}

static void put_panel(trace_picture *p, const trace *t, const trace_bodies *bodies, unsigned i) {
  const double left = MARGIN + (i % COLUMNS) * (PANEL_WIDTH + GAP);
  const double top = p->height + (i / COLUMNS) * (PANEL_HEIGHT + GAP);
  fprintf(p->panels, "<rect class=\"panel\" x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" rx=\"8\"/>\n", left,
          top, PANEL_WIDTH, PANEL_HEIGHT);
  if (i < t->count) {
    put_shapes(p->panels, t, bodies, i, left + 6, top + PLOT_TOP);
    put_difference(p->panels, t, bodies, i, left + PANEL_WIDTH / 2 + 6, top + PLOT_TOP);
    put_words(p->panels, t, i, left, top);
    return;
  }
  const label_rectangle area = {left + 14, top + PLOT_TOP, PANEL_WIDTH - 28, PLOT_HEIGHT};
  const double larger = plot_magnified(p->panels, t, bodies, area);
  fprintf(p->panels,
          "<text class=\"ink\" x=\"%.1f\" y=\"%.1f\"><tspan font-weight=\"bold\">Around the origin</tspan>, %.0f times "
          "larger</text>\n<text class=\"ink\" x=\"%.1f\" y=\"%.1f\">A point for each pair of integers: they are an LSB "
          "apart</text>\n",
          left + 14, top + 30, larger, left + 14, top + PANEL_HEIGHT - 42);
}

void trace_picture_add(trace_picture *p, const char *answer, const trace *t, const trace_bodies *bodies) {
  const unsigned panels = t->count + (plot_magnifies(t, bodies) ? 1 : 0), rows = (panels + COLUMNS - 1) / COLUMNS;
  fprintf(p->panels, "<text class=\"ink\" x=\"%.1f\" y=\"%.1f\" font-size=\"20\" font-weight=\"bold\">", MARGIN,
          p->height + 24);
  svg_text(p->panels, answer);
  fprintf(p->panels, "</text>\n");
  if (panels == 0) {
    put_wrapped(p->panels, "stop", MARGIN, p->height + TITLE_HEIGHT, trace_reason_text(t));
  }
  p->height += panels == 0 ? TITLE_HEIGHT + 20 : TITLE_HEIGHT - 12;
  for (unsigned i = 0; i < panels; i++) {
    put_panel(p, t, bodies, i);
  }
  p->height += rows * (PANEL_HEIGHT + GAP) + 4;
}

bool trace_picture_close(trace_picture *p, const char *name) {
  FILE *file = fopen(name, "w");
  int c;
  bool written = file != NULL;
  if (written) {
    fprintf(file,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %.0f %.0f\" width=\"%.0f\" height=\"%.0f\" "
            "font-size=\"%.0f\" font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\">\n%s"
            "<rect class=\"page\" width=\"100%%\" height=\"100%%\"/>\n",
            WIDTH, p->height, WIDTH, p->height, PLOT_FONT, style);
    rewind(p->panels);
    while ((c = getc(p->panels)) != EOF) {
      putc(c, file);
    }
    fprintf(file, "</svg>\n");
    written = ferror(file) == 0;
    written = fclose(file) == 0 && written;
  }
  fclose(p->panels);
  return written;
}
