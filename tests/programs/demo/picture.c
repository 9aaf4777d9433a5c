// Writes an answered scene as an SVG picture.
#include "picture.h"

#include <math.h>
#include <string.h>

#include "draw.h"
#include "labels.h"

#define WIDTH 1480.0
#define HEIGHT 860.0
#define PANEL_LEFT 1070.0
#define TOP 64.0

// Where the camera stands: angle about the vertical, and above the horizon, radians.
#define AZIMUTH 0.38
#define ELEVATION 0.40

#define INK "#1d2733"
#define FAINT "#6b7785"
#define SWING "#8a2be2"

static const char *const relation_colour[] = {"#0b6fc2", "#0a8a4b", "#d0202e"};

static const colour palette[] = {
    {1.00, 0.60, 0.16}, {0.56, 0.66, 0.78}, {0.90, 0.22, 0.25}, {0.82, 0.66, 0.45}, {0.45, 0.72, 0.58},
    {0.44, 0.48, 0.56}, {0.70, 0.80, 0.84}, {0.98, 0.82, 0.20}, {0.93, 0.94, 0.95}, {0.75, 0.20, 0.60},
    {0.62, 0.52, 0.80}, {0.76, 0.70, 0.62}, {0.35, 0.62, 0.85}, {0.45, 0.75, 0.40}, {0.95, 0.45, 0.35},
};

typedef struct picture {
  FILE *file;
  const scene *s;
  view camera;
  label_page page;
  label_rectangle box[SCENE_BODIES_MAX];  // of each body on the page
  size_t order[SCENE_BODIES_MAX];         // of drawing, the farthest first
} picture;

void picture_gap_text(char text[24], gjk_q16 gap) {
  double mm = gap * (1000.0 / 65536.0), size = fabs(mm);
  snprintf(text, 24, size < 1 ? "%.3f mm" : size < 100 ? "%.1f mm" : "%.0f mm", mm);
}

static label_rectangle body_box(const view *v, const case_shape *shape) {
  point2 outline[OUTLINE_POINTS];
  draw_outline(v, shape, outline);
  point2 low = outline[0], high = outline[0];
  for (int i = 1; i < OUTLINE_POINTS; i++) {
    low.x = fmin(low.x, outline[i].x);
    low.y = fmin(low.y, outline[i].y);
    high.x = fmax(high.x, outline[i].x);
    high.y = fmax(high.y, outline[i].y);
  }
  label_rectangle box = {low.x, low.y, high.x - low.x, high.y - low.y};
  return box;
}

static bool boxes_meet(const label_rectangle *a, const label_rectangle *b) {
  return a->left < b->left + b->width && b->left < a->left + a->width && a->top < b->top + b->height &&
         b->top < a->top + a->height;
}

// Scales and moves the view so that the bodies fill their part of the page.
static void fit(picture *p) {
  view *v = &p->camera;
  double left = 1e9, top = 1e9, right = -1e9, bottom = -1e9;
  for (size_t i = 0; i < p->s->bodies; i++) {
    label_rectangle b = body_box(v, &p->s->body[i].shape);
    left = fmin(left, b.left);
    top = fmin(top, b.top);
    right = fmax(right, b.left + b.width);
    bottom = fmax(bottom, b.top + b.height);
  }
  double room_x = p->page.area.width - 40, room_y = p->page.area.height - 40;
  v->scale = fmin(room_x / fmax(right - left, 1e-6), room_y / fmax(bottom - top, 1e-6));
  v->left = p->page.area.left + 20 + (room_x - v->scale * (right - left)) / 2 - v->scale * left;
  v->top = p->page.area.top + 20 + (room_y - v->scale * (bottom - top)) / 2 - v->scale * top;
  for (size_t i = 0; i < p->s->bodies; i++) {
    p->box[i] = body_box(v, &p->s->body[i].shape);
  }
}

// Does a hide a part of b? The library finds a plane between the two; the one on the side of the camera is nearer.
static bool hides(const picture *p, size_t a, size_t b) {
  if (a == b || !boxes_meet(&p->box[a], &p->box[b])) {
    return false;
  }
  const gjk_unit3 direction = scene_direction(&p->s->body[a], &p->s->body[b]);
  const real3 normal = {direction.x, direction.y, direction.z};
  return real_dot(normal, p->camera.toward) < -1e-4 * (double)GJK_Q30_ONE;
}

// Painter's order: a body is drawn after all bodies that it hides. Of those that may be next, the farthest is.
static void sort_bodies(picture *p) {
  bool drawn[SCENE_BODIES_MAX] = {false};
  size_t n = p->s->bodies;
  for (size_t k = 0; k < n; k++) {
    double best = 1e30;
    for (size_t i = 0; i < n; i++) {
      real3 centre = real_from_q16(p->s->body[i].collider.collider.centre);
      double key = real_dot(centre, p->camera.toward);
      if (drawn[i]) {
        continue;
      }
      for (size_t j = 0; j < n; j++) {
        key += !drawn[j] && hides(p, i, j) ? 1e6 : 0;
      }
      if (key < best) {
        best = key;
        p->order[k] = i;
      }
    }
    drawn[p->order[k]] = true;
  }
}

// Bodies whose names have the same part before '-' get the same colour.
static colour body_colour(const scene *s, size_t body) {
  size_t group = 0;
  for (size_t i = 0; i < body; i++) {
    size_t length = strcspn(s->body[i].name, "-");
    bool seen = false;
    if (strncmp(s->body[i].name, s->body[body].name, length) == 0 && strcspn(s->body[body].name, "-") == length) {
      break;
    }
    for (size_t j = 0; j < i; j++) {
      seen =
          seen || (strcspn(s->body[j].name, "-") == length && strncmp(s->body[j].name, s->body[i].name, length) == 0);
    }
    group += !seen;
  }
  return palette[group % (sizeof palette / sizeof palette[0])];
}

static void put_shadows(const picture *p, const scene_body *floor) {
  const real3 down = {0, 0, 1};
  double height = geometry_support(&floor->shape, down).z;
  point2 outline[OUTLINE_POINTS];
  draw_outline(&p->camera, &floor->shape, outline);
  fprintf(p->file, "<clipPath id=\"floor\"><polygon points=\"");
  svg_points(p->file, outline, OUTLINE_POINTS);
  fprintf(p->file, "\"/></clipPath>\n<g clip-path=\"url(#floor)\" fill=\"#27313d\" fill-opacity=\"0.13\">\n");
  for (size_t i = 0; i < p->s->bodies; i++) {
    const case_shape *shape = &p->s->body[i].shape;
    if (&p->s->body[i] != floor) {
      draw_shadow_outline(&p->camera, shape, height, outline);
      fprintf(p->file, "<polygon points=\"");
      svg_points(p->file, outline, OUTLINE_POINTS);
      fprintf(p->file, "\"/>\n");
    }
  }
  fprintf(p->file, "</g>\n");
}

static void put_bodies(const picture *p) {
  for (size_t k = 0; k < p->s->bodies; k++) {
    size_t i = p->order[k];
    const scene_body *body = &p->s->body[i];
    point2 outline[OUTLINE_POINTS];
    fprintf(p->file, "<g><title>");
    svg_text(p->file, body->name);
    fprintf(p->file, "</title>\n");
    draw_body(p->file, &p->camera, &body->shape, body_colour(p->s, i), i);
    draw_outline(&p->camera, &body->shape, outline);
    fprintf(p->file, "<polygon fill=\"none\" stroke=\"%s\" stroke-width=\"%s\" points=\"",
            body->overlapping ? relation_colour[SCENE_OVERLAPPING] : INK, body->overlapping ? "2" : "0.7");
    svg_points(p->file, outline, OUTLINE_POINTS);
    fprintf(p->file, "\"/></g>\n");
    if (strcmp(body->name, "floor") == 0) {
      put_shadows(p, body);
    }
  }
}

static void put_names(picture *p) {
  fprintf(p->file, "<g font-size=\"12\" fill=\"" INK
                   "\" stroke=\"#ffffff\" stroke-opacity=\"0.75\" stroke-width=\"3\" "
                   "paint-order=\"stroke\" text-anchor=\"middle\">\n");
  for (size_t i = 0; i < p->s->bodies; i++) {
    const scene_body *body = &p->s->body[i];
    const label_rectangle *box = &p->box[i];
    double width = 7.2 * (double)strlen(body->name);
    point2 middle = view_project(&p->camera, real_from_q16(body->collider.collider.centre));
    if (box->width < 0.7 * width || box->height < 16 || strcmp(body->name, "floor") == 0) {
      continue;  // the list names it; what stands on the floor hides its middle
    }
    label_rectangle r = label_place(&p->page, middle, width, 14, 0);
    fprintf(p->file, "<text x=\"%.1f\" y=\"%.1f\">", r.left + width / 2, r.top + 11);
    svg_text(p->file, body->name);
    fprintf(p->file, "</text>\n");
  }
  fprintf(p->file, "</g>\n");
}

static void take_point(label_page *page, point2 at) {
  label_rectangle r = {at.x - 3, at.y - 3, 6, 6};
  label_take(page, r, 12);
}

// An arrow from the deepest point of B along the way out, as long as the depth, or longer so that it is seen.
static void put_arrow(picture *p, const scene_pair *pair, const char *ink) {
  const gjk_unit3 *n = &pair->overlap.normal;
  const double unit = GJK_Q30_ONE, least = 36;
  const real3 from = real_from_q16(pair->mark_b), way = {n->x / unit, n->y / unit, n->z / unit};
  const point2 tail = view_project(&p->camera, from), ahead = view_project(&p->camera, real_add(from, way));
  const double x = ahead.x - tail.x, y = ahead.y - tail.y, per_unit = sqrt(x * x + y * y);
  if (per_unit < p->camera.scale / 20) {
    return;  // towards the camera or away from it
  }
  const double length = fmax(least, per_unit * pair->overlap.depth / 65536.0), u = x / per_unit, v = y / per_unit;
  const point2 tip = {tail.x + u * length, tail.y + v * length};
  for (int step = 0; step <= 6; step++) {
    const point2 at = {tail.x + (tip.x - tail.x) * step / 6, tail.y + (tip.y - tail.y) * step / 6};
    take_point(&p->page, at);
  }
  for (int layer = 0; layer < 2; layer++) {
    fprintf(p->file, "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\" stroke-width=\"%s\"/>\n",
            tail.x, tail.y, tip.x - 8 * u, tip.y - 8 * v, layer == 0 ? "#ffffff" : ink, layer == 0 ? "5" : "2.5");
  }
  fprintf(p->file, "<polygon points=\"%.1f,%.1f %.1f,%.1f %.1f,%.1f\" fill=\"%s\" stroke=\"#ffffff\"/>\n", tip.x, tip.y,
          tip.x - 11 * u + 5 * v, tip.y - 11 * v - 5 * u, tip.x - 11 * u - 5 * v, tip.y - 11 * v + 5 * u, ink);
}

// Draws the contact points of two bodies, halfway between the points on each.
static void put_contacts(picture *p, const scene_pair *pair, const char *ink) {
  for (int i = 0; i < pair->manifold.count; i++) {
    const gjk_contact *contact = &pair->manifold.contact[i];
    const point2 a = view_project(&p->camera, real_from_q16(contact->point_a));
    const point2 b = view_project(&p->camera, real_from_q16(contact->point_b));
    const point2 at = {(a.x + b.x) / 2, (a.y + b.y) / 2};
    take_point(&p->page, at);
    fprintf(p->file, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3\" fill=\"#ffffff\" stroke=\"%s\" stroke-width=\"1.8\"/>\n",
            at.x, at.y, ink);
  }
}

// Draws the gaps, the contact points of bodies that touch or overlap, and arrows where they overlap.
static void put_marks(picture *p) {
  for (size_t i = 0; i < p->s->pairs; i++) {
    const scene_pair *pair = &p->s->pair[i];
    const char *ink = relation_colour[pair->relation];
    point2 a = view_project(&p->camera, real_from_q16(pair->mark_a));
    point2 b = view_project(&p->camera, real_from_q16(pair->mark_b));
    for (int step = 0; step <= 6; step++) {
      point2 at = {a.x + (b.x - a.x) * step / 6, a.y + (b.y - a.y) * step / 6};
      take_point(&p->page, at);
    }
    if (pair->relation == SCENE_OVERLAPPING) {
      put_arrow(p, pair, ink);
    }
    if (pair->relation != SCENE_APART) {
      put_contacts(p, pair, ink);
      continue;
    }
    for (int layer = 0; layer < 2; layer++) {
      fprintf(p->file, "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\" stroke-width=\"%s\"%s/>\n",
              a.x, a.y, b.x, b.y, layer == 0 ? "#ffffff" : ink, layer == 0 ? "4.5" : "2",
              layer == 1 && pair->answer.distance > 20000 ? " stroke-dasharray=\"6 4\"" : "");
    }
    fprintf(p->file,
            "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3\" fill=\"%s\" stroke=\"#ffffff\"/>"
            "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3\" fill=\"%s\" stroke=\"#ffffff\"/>\n",
            a.x, a.y, ink, b.x, b.y, ink);
  }
}

// The text of a gap or depth; empty where bodies touch.
static void put_measure(char text[40], const scene_pair *pair) {
  text[0] = '\0';
  if (pair->relation != SCENE_TOUCHING) {
    picture_gap_text(text, pair->relation == SCENE_APART ? pair->answer.distance : pair->overlap.depth);
  }
  if (pair->relation == SCENE_OVERLAPPING) {
    strcat(text, " deep");
  }
}

// Writes the number of each pair, as in the list, with the gap or depth if there is one.
static void put_labels(picture *p) {
  for (size_t i = 0; i < p->s->pairs; i++) {
    const scene_pair *pair = &p->s->pair[i];
    const char *ink = relation_colour[pair->relation];
    point2 a = view_project(&p->camera, real_from_q16(pair->mark_a));
    point2 b = view_project(&p->camera, real_from_q16(pair->mark_b));
    point2 anchor = {(a.x + b.x) / 2, (a.y + b.y) / 2};
    char gap[40] = "";
    put_measure(gap, pair);
    double width = 22 + (gap[0] != '\0' ? 8.2 * (double)strlen(gap) + 8 : 0);
    label_rectangle r = label_place(&p->page, anchor, width, 18, 22);
    double end_x = fmin(fmax(anchor.x, r.left + 6), r.left + r.width - 6);
    fprintf(p->file, "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\" stroke-width=\"1\"/>\n",
            anchor.x, anchor.y, end_x, r.top + 9, ink);
    fprintf(p->file,
            "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"18\" rx=\"9\" fill=\"#ffffff\" stroke=\"%s\" "
            "stroke-width=\"1.2\"/>",
            r.left, r.top, r.width, ink);
    fprintf(p->file, "<rect x=\"%.1f\" y=\"%.1f\" width=\"22\" height=\"18\" rx=\"9\" fill=\"%s\"/>", r.left, r.top,
            ink);
    fprintf(p->file,
            "<text x=\"%.1f\" y=\"%.1f\" font-size=\"11\" font-weight=\"bold\" fill=\"#ffffff\" "
            "text-anchor=\"middle\">%lu</text>",
            r.left + 11, r.top + 13, (unsigned long)(i + 1));
    fprintf(p->file, "<text x=\"%.1f\" y=\"%.1f\" font-size=\"12\" fill=\"" INK "\">%s</text>\n", r.left + 26,
            r.top + 13.2, gap);
  }
}

static void put_row(FILE *file, const scene *s, size_t i, double y, double step) {
  const scene_pair *pair = &s->pair[i];
  const char *ink = relation_colour[pair->relation];
  char gap[40];
  put_measure(gap, pair);
  if (i % 2 == 0) {
    fprintf(file, "<rect x=\"%.0f\" y=\"%.1f\" width=\"%.0f\" height=\"%.1f\" fill=\"#f1f4f7\"/>\n", PANEL_LEFT,
            y - step * 0.72, WIDTH - PANEL_LEFT - 24, step);
  }
  fprintf(file, "<text x=\"%.0f\" y=\"%.1f\" fill=\"%s\" font-weight=\"bold\" text-anchor=\"end\">%lu</text>",
          PANEL_LEFT + 26, y, ink, (unsigned long)(i + 1));
  fprintf(file, "<text x=\"%.0f\" y=\"%.1f\">", PANEL_LEFT + 36, y);
  svg_text(file, s->body[pair->a].name);
  fprintf(file, " &#8211; ");
  svg_text(file, s->body[pair->b].name);
  fprintf(file, "</text><text x=\"%.0f\" y=\"%.1f\" fill=\"%s\" text-anchor=\"end\">%s</text>", PANEL_LEFT + 318, y,
          ink, gap[0] != '\0' ? gap : scene_relation_name(pair->relation));
  fprintf(file, "<text x=\"%.0f\" y=\"%.1f\" fill=\"" FAINT "\">%s</text>\n", PANEL_LEFT + 332, y,
          scene_verdict_name(pair->verdict));
}

static void put_panel(const picture *p, const scene_swing *swing) {
  const scene *s = p->s;
  double step = fmin(24, (HEIGHT - TOP - 150) / (double)(s->pairs + 1));
  double y = TOP + 20;
  fprintf(p->file,
          "<rect x=\"%.0f\" y=\"%.0f\" width=\"%.0f\" height=\"%.0f\" rx=\"8\" fill=\"#ffffff\" "
          "stroke=\"#d5dbe1\"/>\n",
          PANEL_LEFT - 12, TOP - 8, WIDTH - PANEL_LEFT, HEIGHT - TOP - 12);
  fprintf(p->file, "<g font-size=\"%.1f\" fill=\"" INK "\">\n", fmin(13, step * 0.62));
  for (size_t i = 0; i < s->pairs; i++) {
    put_row(p->file, s, i, y + step * (double)i, step);
  }
  fprintf(p->file, "</g>\n<g font-size=\"12\" fill=\"" INK "\">\n");
  static const char *const meaning[] = {"apart: gap between the nearest points",
                                        "touching: contact points, depth 0 (curved: at most 3 LSB)",
                                        "overlapping: depth, and the way out (arrow)"};
  y = HEIGHT - 108;
  if (swing->found) {
    fprintf(p->file, "<circle cx=\"%.0f\" cy=\"%.0f\" r=\"6\" fill=\"" SWING "\"/><text x=\"%.0f\" y=\"%.0f\">",
            PANEL_LEFT + 16, y - 20, PANEL_LEFT + 32, y - 16);
    fprintf(p->file, "the arm swings until %s hits %s</text>\n", s->body[swing->a].name, s->body[swing->b].name);
  }
  for (int i = 0; i < 3; i++) {
    fprintf(p->file, "<circle cx=\"%.0f\" cy=\"%.0f\" r=\"6\" fill=\"%s\"/><text x=\"%.0f\" y=\"%.0f\">%s</text>\n",
            PANEL_LEFT + 16, y + 20 * i, relation_colour[i], PANEL_LEFT + 32, y + 20 * i + 4, meaning[i]);
  }
  fprintf(p->file,
          "<text x=\"%.0f\" y=\"%.0f\" fill=\"" FAINT
          "\">proven: certificate checked in exact integers</text>"
          "<text x=\"%.0f\" y=\"%.0f\" fill=\"" FAINT
          "\">curved: within 2 LSB, depth within 3, of proven bounds</text></g>\n",
          PANEL_LEFT + 10, y + 64, PANEL_LEFT + 10, y + 80);
}

static void put_title(const picture *p, const char *title) {
  unsigned long count[3] = {0, 0, 0};
  for (size_t i = 0; i < p->s->pairs; i++) {
    count[p->s->pair[i].relation]++;
  }
  fprintf(p->file, "<text x=\"28\" y=\"40\" font-size=\"20\" font-weight=\"bold\" fill=\"" INK "\">");
  svg_text(p->file, title);
  fprintf(p->file,
          "</text><text x=\"%.0f\" y=\"40\" font-size=\"14\" fill=\"" FAINT
          "\" text-anchor=\"end\">%lu bodies, %lu "
          "pairs: %lu apart, %lu touching, %lu overlapping</text>\n",
          WIDTH - 24, (unsigned long)p->s->bodies, (unsigned long)p->s->pairs, count[SCENE_APART],
          count[SCENE_TOUCHING], count[SCENE_OVERLAPPING]);
}

// Draws the arm where it hits something, as outlines, and the place where it does.
static void put_swing(picture *p, const scene_swing *swing) {
  const point2 at = view_project(&p->camera, real_from_q16(swing->impact.point_b));
  fprintf(p->file, "<g fill=\"" SWING "\" fill-opacity=\"0.10\" stroke=\"" SWING
                   "\" stroke-width=\"1.4\" stroke-dasharray=\"5 3\">\n");
  for (size_t i = 0; i < p->s->bodies; i++) {
    const scene_body *body = &p->s->body[i];
    case_shape moved = body->shape;
    point2 outline[OUTLINE_POINTS];
    if (!swing_moves(body)) {
      continue;
    }
    moved.pose = swing_pose(swing, &body->shape.pose);
    draw_outline(&p->camera, &moved, outline);
    fprintf(p->file, "<polygon points=\"");
    svg_points(p->file, outline, OUTLINE_POINTS);
    fprintf(p->file, "\"/>\n");
  }
  fprintf(p->file,
          "</g>\n<circle cx=\"%.1f\" cy=\"%.1f\" r=\"9\" fill=\"none\" stroke=\"#ffffff\" stroke-width=\"5\"/>"
          "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"9\" fill=\"none\" stroke=\"" SWING
          "\" stroke-width=\"2.5\"/>"
          "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3\" fill=\"" SWING "\"/>\n",
          at.x, at.y, at.x, at.y, at.x, at.y);
  take_point(&p->page, at);
}

// What the swing hits, and after how many degrees.
static void put_swing_label(picture *p, const scene_swing *swing) {
  const point2 at = view_project(&p->camera, real_from_q16(swing->impact.point_b));
  char text[40];
  snprintf(text, sizeof text, "hit after %.2f degrees", swing_degrees(swing));
  const double width = 7.0 * (double)strlen(text) + 12;
  const label_rectangle r = label_place(&p->page, at, width, 18, 26);
  fprintf(p->file,
          "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"" SWING
          "\" stroke-width=\"1\"/>"
          "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"18\" rx=\"9\" fill=\"#ffffff\" stroke=\"" SWING
          "\" stroke-width=\"1.2\"/><text x=\"%.1f\" y=\"%.1f\" font-size=\"12\" fill=\"" SWING "\">%s</text>\n",
          at.x, at.y, fmin(fmax(at.x, r.left + 6), r.left + r.width - 6), r.top + 9, r.left, r.top, r.width, r.left + 6,
          r.top + 13.2, text);
}

void picture_write(FILE *file, const scene *s, const scene_swing *swing, const char *title) {
  static picture p;
  p.file = file;
  p.s = s;
  p.camera = view_make(AZIMUTH, ELEVATION);
  label_rectangle area = {20, TOP, PANEL_LEFT - 44, HEIGHT - TOP - 20};
  p.page.area = area;
  fit(&p);
  sort_bodies(&p);
  fprintf(file,
          "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %.0f %.0f\" width=\"%.0f\" height=\"%.0f\" "
          "font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\">\n",
          WIDTH, HEIGHT, WIDTH, HEIGHT);
  fprintf(file, "<rect width=\"100%%\" height=\"100%%\" fill=\"#e6ebf0\"/>\n");
  put_title(&p, title);
  put_bodies(&p);
  if (swing->found) {
    put_swing(&p, swing);
  }
  put_marks(&p);
  put_names(&p);
  put_labels(&p);
  if (swing->found) {
    put_swing_label(&p, swing);
  }
  put_panel(&p, swing);
  fprintf(file, "</svg>\n");
}
