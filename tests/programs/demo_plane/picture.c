// Draws the level as SVG, in light and dark.
#include "picture.h"

#include "gjk2/draw.h"

#define PIXELS 40.0
#define TOP 56.0
#define BOTTOM 46.0
#define WIDTH (LEVEL_WIDTH * PIXELS)
#define HEIGHT (LEVEL_HEIGHT * PIXELS + TOP + BOTTOM)
#define TICKS 4000

// A path is the places of a body every other tick.
static float path[FLAT_BODIES][TICKS / 2][2];
static unsigned noted;
static flat_world first;

static double unit(gjk_q16 x) {
  return x / 65536.0;
}

static double page_x(double x) {
  return x * PIXELS;
}

static double page_y(double y) {
  return TOP + (LEVEL_HEIGHT - y) * PIXELS;
}

void picture_note(const flat_world *w, uint32_t tick) {
  if (tick == 0) {
    level_start(&first);
    noted = 0;
  }
  for (unsigned i = 0; i < w->bodies && tick % 2 == 0 && noted < TICKS / 2; i++) {
    path[i][noted][0] = (float)unit(w->body[i].pose.position.x);
    path[i][noted][1] = (float)unit(w->body[i].pose.position.y);
  }
  noted += tick % 2 == 0 && noted < TICKS / 2;
}

static void open_picture(FILE *file, uint32_t ticks, uint64_t hash) {
  fprintf(
      file,
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %.0f %.0f\" width=\"%.0f\" height=\"%.0f\" "
      "font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\">\n"
      "<style>.page{fill:#eef3f8}.earth{fill:#b9c7a5;stroke:#4f6138}.thin{fill:none;stroke:#8a5a1f}"
      ".ink{fill:#1d2733}.faint{fill:#56616e}.start{fill:none;stroke:#8795a3;stroke-dasharray:3 3}"
      ".path{fill:none;stroke-linejoin:round}.p0{stroke:#c2410c}.p1{stroke:#1d4ed8}.p2{stroke:#64748b}"
      ".b0{fill:#f59b5f;stroke:#7c2a06}.b1{fill:#7fa8f5;stroke:#12348f}.b2{fill:#e9d3a6;stroke:#6b4c14}"
      ".b3{fill:#f0b6c4;stroke:#8a1f3c}.b4{fill:#b9e0cf;stroke:#14603f}"
      "@media(prefers-color-scheme:dark){.page{fill:#11161b}.earth{fill:#2f3a26;stroke:#93ab75}.thin{stroke:#d9a05b}"
      ".ink{fill:#e8edf2}.faint{fill:#a3afbb}.start{stroke:#66727e}.p0{stroke:#fb923c}.p1{stroke:#7eb0ff}"
      ".p2{stroke:#8b98a6}.b0{fill:#a5480f;stroke:#ffb483}.b1{fill:#1f4bb0;stroke:#a9c8ff}"
      ".b2{fill:#5d4a21;stroke:#e5c888}.b3{fill:#702339;stroke:#f5a3b8}.b4{fill:#1c5540;stroke:#8fdcbc}}"
      "</style>\n<rect class=\"page\" width=\"100%%\" height=\"100%%\"/>\n"
      "<text class=\"ink\" x=\"16\" y=\"34\" font-size=\"20\" font-weight=\"bold\">Two players in lockstep, %u ticks: "
      "each process sent its own keys alone</text>\n"
      "<text class=\"faint\" x=\"%.0f\" y=\"34\" font-size=\"14\" text-anchor=\"end\">end 0x%016llx, the same in "
      "both</text>\n",
      WIDTH, HEIGHT, WIDTH, HEIGHT, (unsigned)ticks, WIDTH - 16, (unsigned long long)hash);
}

static void put_point(FILE *file, double x, double y) {
  fprintf(file, "%.1f,%.1f ", page_x(x), page_y(y));
}

static void put_chains(FILE *file, const flat_world *w) {
  for (unsigned i = 0; i < w->chains; i++) {
    const gjk2_chain *c = &w->chain[i].chain;
    const bool solid = i == 0 || c->closed;
    fprintf(file, "<%s class=\"%s\" stroke-width=\"%s\" points=\"", solid ? "polygon" : "polyline",
            solid ? "earth" : "thin", solid ? "2" : "5");
    for (unsigned k = 0; k < c->count; k++) {
      put_point(file, unit(c->vertices[k].x) + unit(c->position.x), unit(c->vertices[k].y) + unit(c->position.y));
    }
    if (i == 0) {  // the earth below
      put_point(file, 0, -BOTTOM / PIXELS);
      put_point(file, LEVEL_WIDTH, -BOTTOM / PIXELS);
    }
    fprintf(file, "\"/>\n");
  }
}

// The outline comes in order, so that where its lines start are its corners.
static void put_corner(void *user, const gjk2_vec *from, const gjk2_vec *to, gjk_draw_role role) {
  FILE *file = user;
  (void)to;
  (void)role;
  put_point(file, unit(from->x), unit(from->y));
}

static void put_body(FILE *file, const flat_body *b, const char *kind) {
  const gjk2_draw draw = {.line = put_corner, .user = file};
  gjk2_collider collider = b->collider;
  const double c = b->pose.rotation.c / 1073741824.0, s = b->pose.rotation.s / 1073741824.0;
  const double x = unit(b->pose.position.x), y = unit(b->pose.position.y), r = unit(b->shape.convex_radius);
  fprintf(file, "<g class=\"%s\" stroke-width=\"1.6\"><polygon points=\"", kind);
  (void)gjk2_collider_pose(&collider, &b->pose);  // before the first tick a player's is not
  (void)gjk2_draw_collider(&draw, &collider, GJK_DRAW_MOVING);
  fprintf(file, "\"/>");
  if (b->inverse_inertia != 0 && b->shape.vertices == NULL && b->shape.size.x == 0) {  // a spoke shows how a ball rolls
    fprintf(file, "<polyline points=\"");
    put_point(file, x, y);
    put_point(file, x + r * c, y + r * s);
    fprintf(file, "\"/>");
  }
  fprintf(file, "</g>\n");
}

static const char *kind_of(const flat_world *w, unsigned i) {
  static const char *const kinds[] = {"b0", "b1", "b2", "b3", "b4"};
  const gjk2_shape *shape = &w->body[i].shape;
  return kinds[i < LEVEL_PLAYERS ? i : shape->vertices != NULL ? 4 : shape->size.x == 0 ? 3 : 2];
}

static void put_paths(FILE *file, const flat_world *w) {
  for (unsigned k = 0; k < w->bodies; k++) {
    const unsigned i = w->bodies - 1 - k;  // the players on top
    const bool player = i < LEVEL_PLAYERS;
    fprintf(file, "<polyline class=\"path p%u\" stroke-width=\"%s\" stroke-opacity=\"%s\" points=\"",
            player ? i : LEVEL_PLAYERS, player ? "2.2" : "1.1", player ? "0.9" : "0.7");
    for (unsigned t = 0; t < noted; t++) {
      put_point(file, (double)path[i][t][0], (double)path[i][t][1]);
    }
    fprintf(file, "\"/>\n");
  }
}

void picture_draw(FILE *file, const flat_world *w, uint32_t ticks, uint64_t hash) {
  open_picture(file, ticks, hash);
  put_chains(file, w);
  for (unsigned i = 0; i < first.bodies; i++) {
    put_body(file, &first.body[i], "start");
  }
  put_paths(file, w);
  for (unsigned i = 0; i < w->bodies; i++) {
    put_body(file, &w->body[i], kind_of(w, i));
  }
  fprintf(
      file,
      "<text class=\"ink\" x=\"16\" y=\"%.0f\" font-size=\"14\">Dashed: the start. Lines: the paths, of the players "
      "orange and blue. Thin platforms let through what comes from below. %u contact points of pairs, %u of "
      "ground.</text>\n</svg>\n",
      HEIGHT - 15, (unsigned)w->met, (unsigned)w->met_ground);
}
