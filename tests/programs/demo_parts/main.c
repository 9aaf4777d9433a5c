// A bracket, a torus and a rock, cut into convex parts that enclose them; a gripper closes on each, and its contacts are drawn.
//
// usage: gjk-demo-parts FOLDER SVG: the meshes' folder, and the picture to write.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../convert/paint.h"
#include "gjk/cast.h"
#include "gjk/contacts.h"

enum { FILE_BYTES = 1 << 20, FINGERS = 2, CONTACTS = 64, CELLS = 600, WIDTH = 1440, HEIGHT = 480 };

// What is shown: how it is cut, and where its gripper closes, along x or y, in 64ths of its box.
typedef struct exhibit {
  const char *name, *title;
  decompose_options how;
  int axis, across, height;
} exhibit;

static const exhibit exhibits[] = {
    {"bracket", "Bracket", {-1, 0}, 0, 40, 8},
    {"torus", "Torus", {-1, 12}, 0, 32, 32},
    {"rock", "Rock", {200, 0}, 0, 30, 32},
};

typedef struct finger {
  gjk_shape shape;
  gjk_pose pose;
  part drawn;
  gjk_contact contact[CONTACTS];
  size_t contacts;
} finger;

static bool read_solid(const char *folder, const char *name, solid *s) {
  static char text[FILE_BYTES];
  char path[256], problem[200] = "cannot be read";
  mesh m = {NULL, NULL, NULL, 0, 0, 0, 0, 0, 0};
  snprintf(path, sizeof path, "%s/%s.obj", folder, name);
  mesh_file file = {path, text, 0, 65.536, 0, "", NULL};
  FILE *f = fopen(path, "rb");
  bool done = f != NULL;
  if (done) {
    file.bytes = fread(text, 1, sizeof text, f);
    fclose(f);
    done = mesh_read(&m, &file);
    mesh_weld(&m);
    done = done && solid_from_mesh(s, &m, problem, sizeof problem);
  }
  if (!done) {
    fprintf(stderr, "%s: %s\n", path, file.problem[0] != '\0' ? file.problem : problem);
  }
  mesh_free(&m);
  return done;
}

// A part as a shape at rest; counted from the solid's origin. Its vertices are the caller's.
static gjk_shape shape_of(const part *p, gjk_vec3 *vertex, gjk_hull_faces *faces) {
  for (unsigned i = 0; i < p->points; i++) {
    vertex[i].x = p->point[i][0];
    vertex[i].y = p->point[i][1];
    vertex[i].z = p->point[i][2];
  }
  const gjk_hull_faces own = {p->corner, p->end, (uint16_t)p->faces};
  *faces = own;
  const gjk_shape shape = GJK_HULL_WITH_FACES(vertex, (uint16_t)p->points, faces);
  return shape;
}

// Brings a finger from 'from' as far as 'to', or until it touches.
static bool close_finger(finger *f, const gjk_collider *part_collider, size_t parts, gjk_vec3 from, gjk_vec3 to) {
  const gjk_cast_path path = {&to, NULL, 0};
  gjk_collider collider = {0};
  gjk_q30 least = GJK_Q30_ONE;
  f->pose = (gjk_pose)GJK_POSE_IDENTITY;
  f->pose.position = from;
  if (gjk_collider_init(&collider, &f->shape, NULL, 0) != GJK_OK || gjk_collider_pose(&collider, &f->pose) != GJK_OK) {
    return false;
  }
  gjk_vec3 rest = to;
  for (size_t i = 0; i < parts; i++) {
    gjk_cast_result hit;
    if (gjk_cast(&collider, &part_collider[i], &path, &hit) == GJK_OK && hit.hit && hit.fraction < least) {
      least = hit.fraction;
      rest = hit.rest_a;
    }
  }
  f->pose.position = rest;
  if (least == GJK_Q30_ONE || gjk_collider_pose(&collider, &f->pose) != GJK_OK) {
    return false;
  }
  static gjk_epa_cell cells[CELLS];
  const gjk_workspace workspace = {cells, CELLS};
  for (size_t i = 0; i < parts; i++) {
    gjk_manifold m;
    const gjk_status status = gjk_contacts(&collider, &part_collider[i], 2, 4, NULL, &workspace, &m);
    for (unsigned n = 0; status == GJK_OK && n < m.count && f->contacts < CONTACTS; n++) {
      f->contact[f->contacts++] = m.contact[n];
    }
  }
  return true;
}

static bool grip(const exhibit *e, const solid *s, const decomposition *d, finger fingers[FINGERS]) {
  gjk_collider *collider = solid_allocate(d->parts, sizeof collider[0]);
  gjk_shape *shape = solid_allocate(d->parts, sizeof shape[0]);
  gjk_hull_faces *faces = solid_allocate(d->parts, sizeof faces[0]);
  gjk_vec3 **vertex = solid_allocate(d->parts, sizeof vertex[0]);
  const gjk_pose still = GJK_POSE_IDENTITY;
  bool done = true;
  for (size_t i = 0; i < d->parts && done; i++) {
    vertex[i] = solid_allocate(2 * (size_t)d->part[i].points, sizeof vertex[i][0]);
    shape[i] = shape_of(&d->part[i], vertex[i], &faces[i]);
    done = gjk_collider_init(&collider[i], &shape[i], vertex[i] + d->part[i].points, (uint16_t)d->part[i].points) ==
               GJK_OK &&
           gjk_collider_pose(&collider[i], &still) == GJK_OK;
  }
  for (int k = 0; k < FINGERS && done; k++) {
    const gjk_vec3 half = e->axis == 0 ? (gjk_vec3){200, 460, 460} : (gjk_vec3){460, 200, 460};
    const int32_t way = k == 0 ? -1200 : s->high[e->axis] + 1200, middle = s->high[e->axis] / 2;
    const int32_t across = s->high[1 - e->axis] / 64 * e->across, height = s->high[2] / 64 * e->height;
    const gjk_vec3 from = {e->axis == 0 ? way : across, e->axis == 0 ? across : way, height};
    const gjk_vec3 to = {e->axis == 0 ? middle : across, e->axis == 0 ? across : middle, height};
    fingers[k].shape = (gjk_shape)GJK_BOX(half.x, half.y, half.z);
    fingers[k].contacts = 0;
    done = close_finger(&fingers[k], collider, d->parts, from, to);
    int32_t corner[8][3];
    const gjk_vec3 at = fingers[k].pose.position;
    for (int i = 0; i < 8 && done; i++) {
      corner[i][0] = at.x + (i & 1 ? half.x : -half.x);
      corner[i][1] = at.y + (i & 2 ? half.y : -half.y);
      corner[i][2] = at.z + (i & 4 ? half.z : -half.z);
    }
    done = done && part_build(&fingers[k].drawn, corner, 8);
  }
  for (size_t i = 0; i < d->parts; i++) {
    free(vertex[i]);
  }
  free(vertex);
  free(faces);
  free(shape);
  free(collider);
  return done;
}

static void draw_contacts(FILE *out, const paint_view *v, const solid *s, const finger *f) {
  for (size_t i = 0; i < f->contacts; i++) {
    const gjk_vec3 at = f->contact[i].point_b;
    const double x[3] = {at.x, at.y, at.z};
    double page[2], depth;
    paint_project(v, s, x, page, &depth);
    fprintf(out, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"4\" fill=\"#d5202a\" stroke=\"#ffffff\" stroke-width=\"1.2\"/>\n",
            page[0], page[1]);
  }
}

// The finger that the eye sees from behind the body is drawn before it, the other one after it.
static bool draw(FILE *out, const exhibit *e, int number, const char *folder) {
  static finger fingers[FINGERS];
  static const double still[3] = {0, 0, 0}, steel[3] = {0.55, 0.60, 0.66};
  solid s;
  decomposition d;
  if (!read_solid(folder, e->name, &s)) {
    return false;
  }
  decompose(&s, &e->how, &d);
  memset(fingers, 0, sizeof fingers);
  const bool done = d.enclosed && grip(e, &s, &d, fingers);
  if (done) {
    const double widest = fmax(s.high[0], fmax(s.high[1], s.high[2]));
    const paint_view v = {WIDTH / 6.0 + number * (WIDTH / 3.0), 290, 300 / widest, 0};
    paint_part(out, &v, &s, &fingers[0].drawn, still, steel, 1);
    paint_parts(out, &v, &s, &d);
    paint_part(out, &v, &s, &fingers[1].drawn, still, steel, 0.55);
    size_t contacts = 0;
    for (int k = 0; k < FINGERS; k++) {
      draw_contacts(out, &v, &s, &fingers[k]);
      contacts += fingers[k].contacts;
    }
    fprintf(out,
            "<text x=\"%.0f\" y=\"36\" font-size=\"19\" font-weight=\"bold\" text-anchor=\"middle\" fill=\"" PAINT_INK
            "\">%s</text>\n"
            "<text x=\"%.0f\" y=\"60\" font-size=\"14\" text-anchor=\"middle\" fill=\"" PAINT_FAINT
            "\">%zu triangles: %zu parts, proven to enclose it</text>\n"
            "<text x=\"%.0f\" y=\"80\" font-size=\"14\" text-anchor=\"middle\" fill=\"" PAINT_FAINT
            "\">excess %s%.2f mm; %zu contacts of the gripper</text>\n",
            v.x, e->title, v.x, s.triangles, d.parts, v.x, d.excess.at_most > 0 ? "at most " : "",
            (double)d.excess.at_most / 65.536, contacts);
    printf("%s: %zu parts, excess %.0Lf LSB, %zu contacts\n", e->name, d.parts, ceill(d.excess.at_most), contacts);
  } else {
    fprintf(stderr, "%s: not enclosed, or out of the gripper's reach\n", e->name);
  }
  for (int k = 0; k < FINGERS; k++) {
    part_free(&fingers[k].drawn);
  }
  decompose_free(&d);
  solid_free(&s);
  return done;
}

int main(int argc, char **argv) {
  if (argc != 3) {
    fprintf(stderr, "usage: gjk-demo-parts FOLDER SVG\n");
    return 2;
  }
  FILE *out = fopen(argv[2], "w");
  if (out == NULL) {
    fprintf(stderr, "%s: cannot be written\n", argv[2]);
    return 2;
  }
  bool done = true;
  paint_open(out, WIDTH, HEIGHT);
  for (size_t i = 0; i < sizeof exhibits / sizeof exhibits[0]; i++) {
    done = draw(out, &exhibits[i], (int)i, argv[1]) && done;
  }
  return paint_close(out) && done ? 0 : 2;
}
