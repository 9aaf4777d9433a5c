// Hulls and convex parts of a robot's meshes, in the frames of their links.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "gjk/hull.h"
#include "machine.h"
#include "read.h"
#include "simplify.h"

enum { FOLDERS_UP = 4 };

// Reads a file by a path of three pieces. NULL: it is not there.
static char *try_path(const xml_reader *r, unsigned up, const char *rest, size_t *bytes) {
  char path[2 * ROBOT_FILE + 8 * FOLDERS_UP];
  const char *slash = strrchr(r->name, '/');
  const size_t folder = slash != NULL && rest[0] != '/' ? (size_t)(slash - r->name) + 1 : 0;
  if (folder >= ROBOT_FILE) {
    return NULL;
  }
  memcpy(path, r->name, folder);
  for (unsigned i = 0; i < up; i++) {
    memcpy(path + folder + 3 * i, "../", 3);
  }
  strcpy(path + folder + 3 * up, rest);
  return read_whole(path, bytes);
}

// Reads a mesh's file, relative to the robot's. Of package://NAME/REST it is NAME/REST or REST, in the robot's folder or
// in one of those above.
static char *find_mesh(const xml_reader *r, const char *file, size_t *bytes) {
  static const char package[] = "package://", plain[] = "file://";
  if (strncmp(file, package, sizeof package - 1) != 0) {
    return try_path(r, 0, file + (strncmp(file, plain, sizeof plain - 1) == 0 ? sizeof plain - 1 : 0), bytes);
  }
  const char *whole = file + sizeof package - 1, *slash = strchr(whole, '/');
  char *text = NULL;
  for (unsigned up = 0; up <= FOLDERS_UP && text == NULL; up++) {
    text = try_path(r, up, whole, bytes);
    text = text == NULL && slash != NULL ? try_path(r, up, slash + 1, bytes) : text;
  }
  return text;
}

// Adds the hull of integer points; they become the machine's.
static bool add_hull(machine *m, const robot_shape *s, unsigned link, gjk_vec3 *vertex, unsigned count, bool rounded) {
  const gjk_pose identity = GJK_POSE_IDENTITY;
  const gjk_shape hull = GJK_ROUNDED_HULL(vertex, (uint16_t)count, rounded ? 1 : 0);
  const bool added = machine_add_part(m, s, link, &hull, &identity);
  if (!added) {
    free(vertex);
  }
  return added;
}

// The vertices of the hull of the points.
static bool add_one(machine *m, const robot_shape *s, unsigned link, mesh_file *file, mesh *points) {
  uint32_t excess;
  if (points->points > GJK_HULL_POINTS_MAX) {
    return xml_fail(m->r, s->line, "mesh '%s' has %zu different points, and a hull takes %d", s->file, points->points,
                    GJK_HULL_POINTS_MAX);
  }
  if (m->how->vertices >= 0 && !simplify(file, points, m->how->vertices, &excess)) {
    return xml_fail(m->r, s->line, "no room for so few vertices around mesh '%s'", s->file);
  }
  const size_t bytes = GJK_HULL_WORKSPACE(points->points);
  void *workspace = solid_allocate(bytes, 1);
  gjk_hull hull;
  const bool built = gjk_hull_build(points->point, (uint16_t)points->points, workspace, bytes, &hull) == GJK_OK;
  gjk_vec3 *vertex = built ? solid_allocate(hull.vertices, sizeof vertex[0]) : NULL;
  if (built) {
    gjk_hull_vertices(&hull, vertex, hull.vertices);
  }
  free(workspace);
  return built
             ? add_hull(m, s, link, vertex, hull.vertices, points->most_rounding > 0)
             : xml_fail(m->r, s->line, "the points of mesh '%s' are more than 8190 units apart along an axis", s->file);
}

static bool add_pieces(machine *m, const robot_shape *s, unsigned link, const solid *bounded, const decomposition *d,
                       bool rounded) {
  bool added = true;
  for (size_t i = 0; i < d->parts && added; i++) {
    const part *p = &d->part[i];
    gjk_vec3 *vertex = solid_allocate(p->points, sizeof vertex[0]);
    for (unsigned n = 0; n < p->points; n++) {
      vertex[n].x = p->point[n][0] + bounded->origin.x;
      vertex[n].y = p->point[n][1] + bounded->origin.y;
      vertex[n].z = p->point[n][2] + bounded->origin.z;
    }
    added = add_hull(m, s, link, vertex, p->points, rounded);
  }
  return added;
}

// Where a solid's corners move by less than 1 LSB, so does its surface. What only the real one has is as near to the
// rounded one. So parts that enclose the rounded one, with a radius of 1 LSB, enclose the real one.
static bool add_solid(machine *m, const robot_shape *s, unsigned link, mesh_file *file, mesh *points) {
  char problem[200];
  solid bounded;
  decomposition d;
  if (!solid_from_mesh(&bounded, points, problem, sizeof problem)) {
    fprintf(stderr, "%s: %s; its hull is taken\n", s->file, problem);
    solid_free(&bounded);
    return add_one(m, s, link, file, points);
  }
  decompose(&bounded, &m->how->how, &d);
  const bool added =
      d.enclosed ? add_pieces(m, s, link, &bounded, &d, points->most_rounding > 0) : add_one(m, s, link, file, points);
  decompose_free(&d);
  solid_free(&bounded);
  return added;
}

bool machine_add_mesh(machine *m, const robot_shape *s, unsigned link) {
  double turn[3][3], place[3][4];
  machine_matrix(s->origin.rpy, turn);
  for (int i = 0; i < 3; i++) {
    for (int k = 0; k < 3; k++) {
      place[i][k] = turn[i][k] * s->size[k];
    }
    place[i][3] = s->origin.xyz[i];
  }
  mesh points = {NULL, NULL, NULL, 0, 0, 0, 0, 0, 0};
  mesh_file file = {s->file, NULL, 0, m->how->scale, 0, "", place};
  char *text = find_mesh(m->r, s->file, &file.bytes);
  if (text == NULL) {
    return xml_fail(m->r, s->line, "mesh '%s' cannot be read", s->file);
  }
  file.text = text;
  bool added = mesh_read(&points, &file);
  if (added) {
    mesh_weld(&points);
    added = m->how->parts ? add_solid(m, s, link, &file, &points) : add_one(m, s, link, &file, &points);
  } else if (file.line > 0) {
    xml_fail(m->r, s->line, "mesh '%s', line %lu: %s", s->file, file.line, file.problem);
  } else {
    xml_fail(m->r, s->line, "mesh '%s': %s", s->file, file.problem);
  }
  mesh_free(&points);
  free(text);
  return added;
}
