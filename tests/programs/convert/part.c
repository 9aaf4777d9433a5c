// Convex parts of integer points.
#include "part.h"

#include <stdlib.h>
#include <string.h>

#include "gjk/hull.h"

// The plane of a face: of the first three corners that are not on a line. Faces may begin with such.
static solid_plane plane_of_face(const part *p, unsigned begin, unsigned end) {
  solid_plane plane = {{0, 0, 0}, 0};
  for (unsigned i = begin + 1; i + 1 < end && plane.n[0] == 0 && plane.n[1] == 0 && plane.n[2] == 0; i++) {
    plane = solid_plane_of(p->point[p->corner[begin]], p->point[p->corner[i]], p->point[p->corner[i + 1]]);
  }
  return plane;
}

static void measure(part *p) {
  p->volume6 = 0;
  memcpy(p->low, p->point[0], sizeof p->low);
  memcpy(p->high, p->point[0], sizeof p->high);
  for (unsigned i = 0; i < p->points; i++) {
    for (int j = 0; j < 3; j++) {
      p->low[j] = p->point[i][j] < p->low[j] ? p->point[i][j] : p->low[j];
      p->high[j] = p->point[i][j] > p->high[j] ? p->point[i][j] : p->high[j];
    }
  }
}

static bool take_faces(part *p, const gjk_hull *hull) {
  // Facets are cut where they have many corners, so there are more of them, and two more corners for each.
  const size_t room = 3 * (size_t)hull->corners < 65535 ? 3 * (size_t)hull->corners : 65535;
  gjk_hull_faces faces = {NULL, NULL, 0};
  p->corner = solid_allocate(room, sizeof p->corner[0]);
  p->end = solid_allocate(room, sizeof p->end[0]);
  if (gjk_hull_write_faces(hull, p->corner, (uint16_t)room, p->end, (uint16_t)room, &faces) != GJK_OK) {
    return false;
  }
  p->faces = faces.count;
  p->plane = solid_allocate(p->faces, sizeof p->plane[0]);
  for (unsigned f = 0, begin = 0; f < p->faces; begin = p->end[f++]) {
    p->plane[f] = plane_of_face(p, begin, p->end[f]);
  }
  measure(p);
  gjk_hull_volume volume = {0, 0};
  gjk_hull_get_volume(hull, &volume);
  p->volume6 = (solid_wide)volume.high << 64 | (solid_wide)volume.low;
  return true;
}

bool part_build(part *p, int32_t (*point)[3], size_t points) {
  memset(p, 0, sizeof *p);
  if (points < 4 || points > GJK_HULL_POINTS_MAX) {
    return false;
  }
  gjk_vec3 *vertex = solid_allocate(points, sizeof vertex[0]);
  for (size_t i = 0; i < points; i++) {
    vertex[i].x = point[i][0];
    vertex[i].y = point[i][1];
    vertex[i].z = point[i][2];
  }
  gjk_hull hull;
  void *workspace = solid_allocate(GJK_HULL_WORKSPACE(points), 1);
  bool done = gjk_hull_build(vertex, (uint16_t)points, workspace, GJK_HULL_WORKSPACE(points), &hull) == GJK_OK &&
              hull.dimension == 3;
  if (done) {
    gjk_vec3 *extreme = solid_allocate(hull.vertices, sizeof extreme[0]);
    gjk_hull_vertices(&hull, extreme, hull.vertices);
    p->points = hull.vertices;
    p->point = solid_allocate(p->points, sizeof p->point[0]);
    for (unsigned i = 0; i < p->points; i++) {
      p->point[i][0] = extreme[i].x;
      p->point[i][1] = extreme[i].y;
      p->point[i][2] = extreme[i].z;
    }
    free(extreme);
    done = take_faces(p, &hull);
  }
  free(workspace);
  free(vertex);
  if (!done) {
    part_free(p);
  }
  return done;
}

void part_free(part *p) {
  free(p->point);
  free(p->corner);
  free(p->end);
  free(p->plane);
  memset(p, 0, sizeof *p);
}

bool part_has(const part *p, const int32_t x[3]) {
  for (int i = 0; i < 3; i++) {
    if (x[i] < p->low[i] || x[i] > p->high[i]) {
      return false;
    }
  }
  for (unsigned f = 0; f < p->faces; f++) {
    if (solid_height(&p->plane[f], x) > 0) {
      return false;
    }
  }
  return true;
}
