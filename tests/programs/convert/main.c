// gjk-convert: makes hulls, convex parts and surfaces of files of points and meshes.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "decompose.h"
#include "gjk/hull.h"
#include "machine.h"
#include "mesh.h"
#include "read.h"
#include "simplify.h"
#include "write.h"
#include "write_arm.h"
#include "write_mesh.h"
#include "write_parts.h"

enum { EXIT_DONE = 0, EXIT_INPUT = 2 };

static const char help[] =
    "usage: gjk-convert [OPTION]... FILE\n"
    "Makes the convex hull of a file's points, exactly, and writes it to standard output.\n"
    "\n"
    "  --hull         the convex hull of all points (default)\n"
    "  --vertices N   of a hull: at most N vertices, 4 or more, that enclose it; says how far they reach beyond\n"
    "  --table LEVEL  of a hull: with a table for queries (gjk/table.h), of level 0 to 4\n"
    "  --decompose    convex parts that enclose the solid which the file's triangles bound\n"
    "  --mesh         the file's triangles as a surface for gjk/mesh.h, with what is known of their edges and a tree\n"
    "  --two-sided    of a surface: bodies touch it from both sides\n"
    "  --excess LSB   parts may reach beyond the solid by so much; the default is 0 where a solid has few edges\n"
    "                 at which it is not convex, else a 64th of its longest side; a message tells if it is not "
    "reached\n"
    "  --parts N      no more than so many parts, whatever their excess\n"
    "  --picture SVG  draws the parts into that file, too\n"
    "  --info         one line about it instead of C:\n"
    "                 points=N vertices=V faces=F volume6=K watertight=yes|no\n"
    "                 N points of the file, V extreme ones, F faces after those in one plane are merged,\n"
    "                 K six times the volume in cubic LSB; watertight: the file's own triangles close\n"
    "                 with --decompose: parts=P excess=E enclosed=yes|no\n"
    "                 E the farthest that a part reaches beyond the solid, LSB, rounded up; enclosed: checked exactly\n"
    "                 with --mesh: triangles=T vertices=V convex=A flat=B concave=C open=D fault=F watertight=yes|no\n"
    "                 the kinds of edges, each side counted; F is a gjk_mesh_fault, 0 for a sound surface\n"
    "  --case         a case for gjk-query instead of C: the hull against itself, moved by its own length\n"
    "  --units        a number in the file is a unit, 65536 LSB (default)\n"
    "  --millimetres  1000 of them are a unit\n"
    "  --urdf         the machine of gjk/arm.h that a robot's URDF describes: its links, joints and collision shapes,\n"
    "                 enclosed; meshes as hulls, with --vertices simpler ones, with --decompose as convex parts\n"
    "  --srdf FILE    of a robot: which pairs of links are never tested; else those that touched in each of many "
    "samples\n"
    "  --scale UNITS  of a robot: so many units are a metre, instead of 1\n"
    "                 with --info: links=L values=V parts=P vertices=N never=K, K pairs of links\n"
    "                 with --case: a machine for gjk-query --arm, to which obstacles and edges are to be added\n"
    "  --name NAME    of the C constants; the default is the file's own name\n"
    "  --help         this text\n"
    "\n"
    "FILE ends in .obj, .stl (text or binary), .ply (text or binary), .off, or .txt: lines of three integers, LSB; a "
    "robot's as it\n"
    "likes. Its meshes are looked for beside it; of package://NAME/REST NAME/REST and REST, and in four folders above, "
    "too.\n"
    "What it did goes to standard error. Exit status 2: the file cannot be read; the message says where and why.\n";

typedef struct options {
  const char *file, *name, *picture, *srdf;
  double scale, metre;  // LSB of a number; units
  bool info, cases, parts, mesh, two_sided, urdf;
  int vertices, table;  // -1: as many as there are; none
  decompose_options how;
} options;

static int usage(const char *problem, const char *subject) {
  fprintf(stderr, "gjk-convert: %s%s; --help tells more\n", problem, subject);
  return EXIT_INPUT;
}

// A number from 0 to 'most'.
static bool read_number(const char *word, double most, double *out) {
  char *end;
  *out = strtod(word, &end);
  return end != word && *end == '\0' && *out >= 0 && *out <= most;
}

// EXIT_DONE: go on; other values: stop with that status.
static int read_options(int argc, char **argv, options *o) {
  for (int i = 1; i < argc; i++) {
    const char *word = argv[i];
    if (strcmp(word, "--info") == 0) {
      o->info = true;
    } else if (strcmp(word, "--case") == 0) {
      o->cases = true;
    } else if (strcmp(word, "--units") == 0) {
      o->scale = 65536;
    } else if (strcmp(word, "--millimetres") == 0) {
      o->scale = 65.536;
    } else if (strcmp(word, "--name") == 0 && i + 1 < argc) {
      o->name = argv[++i];
    } else if (strcmp(word, "--decompose") == 0) {
      o->parts = true;
    } else if (strcmp(word, "--mesh") == 0) {
      o->mesh = true;
    } else if (strcmp(word, "--urdf") == 0) {
      o->urdf = true;
    } else if (strcmp(word, "--srdf") == 0 && i + 1 < argc) {
      o->srdf = argv[++i];
    } else if (strcmp(word, "--scale") == 0 && i + 1 < argc) {
      if (!read_number(argv[++i], 65536, &o->metre) || o->metre < 1.0 / 1024) {
        return usage("no number of units from 1/1024 to 65536: ", argv[i]);
      }
    } else if (strcmp(word, "--two-sided") == 0) {
      o->two_sided = true;
    } else if (strcmp(word, "--picture") == 0 && i + 1 < argc) {
      o->picture = argv[++i];
    } else if (strcmp(word, "--excess") == 0 && i + 1 < argc) {
      double excess;
      if (!read_number(argv[++i], SOLID_EXTENT, &excess)) {
        return usage("no excess: ", argv[i]);
      }
      o->how.excess = excess;
    } else if (strcmp(word, "--vertices") == 0 && i + 1 < argc) {
      double vertices;
      if (!read_number(argv[++i], GJK_HULL_POINTS_MAX, &vertices) || vertices < GJK_HULL_SIMPLE_MIN ||
          vertices != (int)vertices) {
        return usage("no number of vertices from 4 to 65535: ", argv[i]);
      }
      o->vertices = (int)vertices;
    } else if (strcmp(word, "--table") == 0 && i + 1 < argc) {
      double level;
      if (!read_number(argv[++i], GJK_TABLE_LEVEL_MAX, &level) || level != (int)level) {
        return usage("no level of a table: ", argv[i]);
      }
      o->table = (int)level;
    } else if (strcmp(word, "--parts") == 0 && i + 1 < argc) {
      double parts;
      if (!read_number(argv[++i], 1000, &parts) || parts < 1 || parts != (unsigned)parts) {
        return usage("no number of parts from 1 to 1000: ", argv[i]);
      }
      o->how.parts = (unsigned)parts;
    } else if (strcmp(word, "--hull") != 0 && word[0] == '-' && word[1] != '\0') {
      return usage("unknown option ", word);
    } else if (word[0] != '-') {
      if (o->file != NULL) {
        return usage("more than one file: ", word);
      }
      o->file = word;
    }
  }
  if (o->mesh && (o->parts || o->cases)) {
    return usage("--mesh goes with neither --decompose nor --case", "");
  }
  if (o->urdf ? o->mesh || o->picture != NULL || o->table >= 0 : o->srdf != NULL || o->metre > 0) {
    return usage("--srdf and --scale go with --urdf alone, which goes with neither --mesh, --picture nor --table", "");
  }
  if ((o->mesh || (o->parts && !o->urdf)) && (o->vertices >= 0 || o->table >= 0)) {
    return usage("--vertices and --table go with hulls alone", "");
  }
  return o->file == NULL ? usage("no file", "") : EXIT_DONE;
}

static int report_problem(const mesh_file *file) {
  if (file->line > 0) {
    fprintf(stderr, "%s:%lu: %s\n", file->name, file->line, file->problem);
  } else {
    fprintf(stderr, "%s: %s\n", file->name, file->problem);
  }
  return EXIT_INPUT;
}

static int write_hull(const options *o, const gjk_hull *hull, size_t points, bool watertight) {
  if (o->info) {
    write_info(hull, points, watertight);
  } else if (o->cases) {
    return write_case(hull, o->name) ? EXIT_DONE : EXIT_INPUT;
  } else {
    return write_source(hull, o->name, o->table) ? EXIT_DONE : EXIT_INPUT;
  }
  return EXIT_DONE;
}

// Builds the hull of m's points and writes what is asked for. points: how many the file has.
static int convert(const options *o, mesh_file *file, mesh *m, size_t points) {
  gjk_hull hull;
  uint32_t excess = 0;
  if (m->points > GJK_HULL_POINTS_MAX) {
    fprintf(stderr, "%s: %zu different points, and a hull takes %d\n", file->name, m->points, GJK_HULL_POINTS_MAX);
    return EXIT_INPUT;
  }
  const size_t different = m->points;
  const bool watertight = mesh_is_watertight(m);
  if (o->vertices >= 0 && !simplify(file, m, o->vertices, &excess)) {
    return EXIT_INPUT;
  }
  const size_t bytes = GJK_HULL_WORKSPACE(m->points);
  void *workspace = solid_allocate(bytes, 1);
  int result = EXIT_INPUT;
  if (gjk_hull_build(m->point, (uint16_t)m->points, workspace, bytes, &hull) != GJK_OK) {
    fprintf(stderr, "%s: the points are more than 8190 units apart along an axis\n", file->name);
  } else {
    result = write_hull(o, &hull, points, watertight);
  }
  if (result == EXIT_DONE && !o->info) {
    fprintf(stderr, "%zu points, %zu different; %d vertices, %lu faces; rounded by at most %.2f LSB; %s\n", points,
            different, hull.vertices, (unsigned long)hull.faces, m->most_rounding,
            m->triangles == 0 ? "no triangles"
            : watertight      ? "watertight"
                              : "not watertight");
  }
  if (result == EXIT_DONE && o->vertices >= 0) {
    fprintf(stderr, "all points are enclosed, exactly; the vertices reach at most %lu LSB beyond\n",
            (unsigned long)excess);
  }
  free(workspace);
  return result;
}

// Cuts the solid into convex parts and writes what is asked for.
static int convert_to_parts(const options *o, mesh_file *file, const mesh *m) {
  char problem[200];
  solid s;
  decomposition d;
  if (!solid_from_mesh(&s, m, problem, sizeof problem)) {
    fprintf(stderr, "%s: %s\n", file->name, problem);
    solid_free(&s);
    return EXIT_INPUT;
  }
  decompose(&s, &o->how, &d);
  int result = EXIT_DONE;
  if (o->info) {
    write_parts_info(&d);
  } else if (!write_parts_fit(&d)) {
    result = EXIT_INPUT;
  } else if (o->cases) {
    write_parts_case(&s, &d, o->name);
  } else {
    write_parts_source(&s, &d, o->name);
  }
  if (o->picture != NULL && !write_parts_picture(&s, &d, o->picture)) {
    fprintf(stderr, "%s: cannot be written\n", o->picture);
    result = EXIT_INPUT;
  }
  if (!d.enclosed) {
    fprintf(stderr, "%s: the parts do not enclose the solid: %s\n", file->name, d.problem);
  }
  if ((o->how.parts == 0 || o->how.excess >= 0) && d.excess.at_most > d.wanted) {
    fprintf(stderr, "%s: the excess is %.0Lf LSB instead of %.0Lf\n", file->name, ceill(d.excess.at_most), d.wanted);
  }
  if (!o->info) {
    fprintf(
        stderr,
        "%zu triangles, %zu edges where the solid is not convex; %zu parts, %s; excess between %.2Lf and %.2Lf LSB; "
        "points rounded by at most %.2f LSB\n",
        s.triangles, d.notches, d.parts, d.enclosed ? "enclosing it, proven" : "not enclosing it", d.excess.at_least,
        d.excess.at_most, m->most_rounding);
  }
  decompose_free(&d);
  solid_free(&s);
  return result;
}

// Makes a surface of the triangles and writes what is asked for.
static int convert_to_surface(const options *o, mesh_file *file, const mesh *m) {
  char problem[200];
  built_mesh s;
  if (!built_mesh_of(&s, m, o->two_sided, problem, sizeof problem)) {
    fprintf(stderr, "%s: %s\n", file->name, problem);
    return EXIT_INPUT;
  }
  if (o->info) {
    write_mesh_info(&s, mesh_is_watertight(m));
  } else {
    write_mesh_source(&s, o->name);
    fprintf(stderr, "%zu triangles, %s; faults: %s; points rounded by at most %.2f LSB\n", m->triangles,
            mesh_is_watertight(m) ? "watertight" : "not watertight", built_mesh_fault(s.report.fault),
            m->most_rounding);
  }
  built_mesh_free(&s);
  return EXIT_DONE;
}

// Reads a robot and what its SRDF says. False: a reader has the problem.
static bool read_robot(robot *b, const options *o, xml_reader *r, const char *text, size_t bytes, xml_reader *pairs) {
  xml_open(r, o->file, text, bytes);
  if (!robot_read(b, r)) {
    return false;
  }
  if (o->srdf == NULL) {
    return true;
  }
  char *more = read_whole(o->srdf, &bytes);
  xml_open(pairs, o->srdf, more, more != NULL ? bytes : 0);
  const bool read = more != NULL ? robot_read_pairs(b, pairs) : xml_fail(pairs, 0, "cannot be read");
  free(more);
  return read;
}

// Makes a machine of a robot and writes what is asked for.
static int convert_to_machine(const options *o, const char *text, size_t bytes) {
  const machine_options how = {65536 * (o->metre > 0 ? o->metre : 1), o->vertices, o->parts, o->how};
  xml_reader r, pairs;
  robot *b = solid_allocate(1, sizeof *b);
  machine *m = solid_allocate(1, sizeof *m);
  m->parts = 0;
  xml_open(&pairs, "", "", 0);
  const bool made = read_robot(b, o, &r, text, bytes, &pairs) && machine_make(m, b, o->srdf != NULL, &how, &r);
  if (!made) {
    fprintf(stderr, "%s\n", r.problem[0] != '\0' ? r.problem : pairs.problem);
  } else if (o->info) {
    write_arm_info(m);
  } else if (o->cases) {
    write_arm_case(m);
  } else {
    write_arm_source(m, o->name);
  }
  if (made && !o->info) {
    fprintf(stderr, "%u links, %u of them moved by joints; %u parts; %zu vertices of meshes\n", m->links, m->values,
            m->parts, m->vertices);
  }
  machine_free(m);
  free(m);
  free(b);
  return made ? EXIT_DONE : EXIT_INPUT;
}

int main(int argc, char **argv) {
  options o = {NULL, NULL, NULL, NULL, 65536, 0, false, false, false, false, false, false, -1, -1, {-1, 0}};
  char name[64];
  mesh m = {NULL, NULL, NULL, 0, 0, 0, 0, 0, 0};
  for (int i = 1; i < argc; i++) {
    if (strcmp(argv[i], "--help") == 0) {
      fputs(help, stdout);
      return EXIT_DONE;
    }
  }
  int result = read_options(argc, argv, &o);
  if (result != EXIT_DONE) {
    return result;
  }
  write_name(name, sizeof name, o.name != NULL ? o.name : o.file, o.name == NULL);
  o.name = name;
  mesh_file file = {o.file, NULL, 0, o.scale, 0, "", NULL};
  char *text = read_whole(o.file, &file.bytes);
  if (text == NULL) {
    fprintf(stderr, "%s: cannot be read\n", o.file);
    return EXIT_INPUT;
  }
  file.text = text;
  if (o.urdf) {
    result = convert_to_machine(&o, text, file.bytes);
  } else if (mesh_read(&m, &file)) {
    const size_t points = m.points;
    mesh_weld(&m);
    result = o.parts  ? convert_to_parts(&o, &file, &m)
             : o.mesh ? convert_to_surface(&o, &file, &m)
                      : convert(&o, &file, &m, points);
  } else {
    result = report_problem(&file);
  }
  mesh_free(&m);
  free(text);
  return result;
}
