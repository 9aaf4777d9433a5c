// Triangle and hull: a list of vertices, posed beforehand (baked) or on demand (lazy).
//
// A lazy hull rotates the direction into the shape's frame, scans there, and rotates the few vertices that come
// near the farthest; so it finds the very vertex that the baked hull finds.
#include "rotation.h"
#include "scan.h"
#include "shape_class.h"

// How far rounding the direction can mislead a comparison of two vertices, in units of 4: each component is off by less
// than 1, so by less than |u.x| + |u.y| + |u.z| <= sqrt(3) 2 core_radius for their difference u.
static uint32_t rounding_slack(const gjk_collider *c, bool exact) {
  return exact ? 0 : (uint32_t)c->core_radius;
}

static void scan_posed(const gjk_collider *c, const gjk_vec3 *vertices, const gjk_vec3 *d, bool exact,
                       gjk_support *out) {
  const gjk_farthest found = gjk_scan(vertices, c->count, c->bits, d, rounding_slack(c, exact));
  out->offset = vertices[found.index];
  out->vertex = found.index;
  out->tie = found.tie;
}

// Pre: offsets of the vertices at most core_radius; *at is among the farthest along d.
GJK_OUT_OF_LINE static bool refine_posed(const gjk_collider *c, const gjk_vec3 *vertices, const gjk_vec3 *d,
                                         const gjk_direction *direction, gjk_support *at) {
  const int64_t limit = gjk_dot(&at->offset, d) - 4 * (int64_t)rounding_slack(c, false);
  const uint16_t before = at->vertex;
  for (uint32_t i = 0; i < c->count; i++) {
    if (gjk_dot(&vertices[i], d) >= limit) {
      const gjk_vec3 step = gjk_sub(vertices[i], at->offset);
      if (gjk_direction_sign(direction, &step) > 0) {
        at->offset = vertices[i];
        at->vertex = (uint16_t)i;
      }
    }
  }
  return at->vertex != before;
}

static gjk_vec3 pose_vertex(const gjk_collider *c, const gjk_vec3 rows[3], uint32_t i) {
  gjk_vec3 local = gjk_sub(c->shape->vertices[i], c->local_centre);  // at most GJK_RADIUS_MAX, by measure
  return gjk_rotate(rows, &local);
}

// d in the shape's frame, and how far it misleads a comparison of two vertices u apart there, in units of 4: each of
// its components is off by at most 1/2, |d.x| + |d.y| + |d.z| < 2^32 for the rounding of both vertices, rounding_slack.
static uint32_t local_direction(const gjk_collider *c, const gjk_vec3 *d, bool exact, gjk_vec3 *local) {
  *local = gjk_rotate_back(c->frame, d);
  return (uint32_t)c->core_radius / 2 + gjk_norm1(*d) / 4 + rounding_slack(c, exact) + 2;
}

// The vertices of the shape are scanned as they are, not relative to its centre: that shifts all products alike.
GJK_OUT_OF_LINE static void support_lazy(const gjk_collider *c, const gjk_vec3 *direction, bool exact,
                                         gjk_support *out) {
  const gjk_vec3 *vertices = c->shape->vertices;
  const gjk_vec3 d = gjk_scale_direction(direction);
  gjk_vec3 local;
  const uint32_t slack = local_direction(c, &d, exact, &local);
  const gjk_farthest found = gjk_scan(vertices, c->count, 31, &local, slack);
  out->vertex = found.index;
  out->offset = pose_vertex(c, c->frame, out->vertex);
  out->tie = found.tie && !exact;
  if (!found.tie) {
    return;
  }
  const int64_t limit = gjk_dot(&vertices[out->vertex], &local) - 4 * (int64_t)slack;
  int64_t farthest = gjk_dot(&out->offset, &d);
  for (uint32_t i = 0; i < c->count; i++) {
    if (gjk_dot(&vertices[i], &local) >= limit) {
      const gjk_vec3 offset = pose_vertex(c, c->frame, i);
      const int64_t along = gjk_dot(&offset, &d);
      if (along > farthest || (along == farthest && i < out->vertex)) {
        farthest = along;
        out->offset = offset;
        out->vertex = (uint16_t)i;
      }
    }
  }
}

GJK_OUT_OF_LINE static bool refine_lazy(const gjk_collider *c, const gjk_vec3 *d, const gjk_direction *direction,
                                        gjk_support *at) {
  const gjk_vec3 *vertices = c->shape->vertices;
  gjk_vec3 local;
  const uint32_t slack = local_direction(c, d, false, &local);
  const int64_t limit = gjk_dot(&vertices[at->vertex], &local) - 4 * (int64_t)slack;
  const uint16_t before = at->vertex;
  for (uint32_t i = 0; i < c->count; i++) {
    if (gjk_dot(&vertices[i], &local) >= limit) {
      gjk_vec3 offset = pose_vertex(c, c->frame, i);
      const gjk_vec3 step = gjk_sub(offset, at->offset);
      if (gjk_direction_sign(direction, &step) > 0) {
        at->offset = offset;
        at->vertex = (uint16_t)i;
      }
    }
  }
  return at->vertex != before;
}

static void support_hull(const gjk_collider *c, const gjk_vec3 *d, bool exact, gjk_support *out) {
  if (c->buffer != NULL) {
    scan_posed(c, c->buffer, d, exact, out);
  } else {
    support_lazy(c, d, exact, out);
  }
}

static bool refine_hull(const gjk_collider *c, const gjk_vec3 *d, const gjk_direction *direction, gjk_support *at) {
  return c->buffer != NULL ? refine_posed(c, c->buffer, d, direction, at) : refine_lazy(c, d, direction, at);
}

static bool vertex_hull(const gjk_collider *c, uint16_t number, gjk_vec3 *offset) {
  if (number >= c->count) {
    return false;
  }
  *offset = c->buffer != NULL ? c->buffer[number] : pose_vertex(c, c->frame, number);
  return true;
}

static void pose_hull(gjk_collider *c, const gjk_vec3 rows[3]) {
  if (c->buffer == NULL) {
    for (int i = 0; i < 3; i++) {
      c->frame[i] = rows[i];
    }
    return;
  }
  for (uint32_t i = 0; i < c->count; i++) {
    c->buffer[i] = pose_vertex(c, rows, i);
  }
}

static void support_triangle(const gjk_collider *c, const gjk_vec3 *d, bool exact, gjk_support *out) {
  scan_posed(c, c->frame, d, exact, out);
}

static bool refine_triangle(const gjk_collider *c, const gjk_vec3 *d, const gjk_direction *direction, gjk_support *at) {
  return refine_posed(c, c->frame, d, direction, at);
}

static bool vertex_triangle(const gjk_collider *c, uint16_t number, gjk_vec3 *offset) {
  if (number >= c->count) {
    return false;
  }
  *offset = c->frame[number];
  return true;
}

static void pose_triangle(gjk_collider *c, const gjk_vec3 rows[3]) {
  for (uint32_t i = 0; i < 3; i++) {
    c->frame[i] = pose_vertex(c, rows, i);
  }
}

// The middle and half width, rounded up, of one coordinate of the vertices.
static uint32_t measure_axis(int32_t low, int32_t high, int32_t *middle) {
  *middle = (int32_t)gjk_sar64((int64_t)low + high, 1);
  return (uint32_t)((int64_t)high - *middle);
}

// Faces: polygons of vertices that there are.
static gjk_status check_faces(const gjk_hull_faces *faces, uint16_t vertices) {
  uint16_t first = 0;
  if (faces->corner == NULL || faces->end == NULL) {
    return GJK_ERROR_NULL;
  }
  for (uint32_t i = 0; i < faces->count; i++) {
    const uint16_t end = faces->end[i];
    if (end < first || end - first < 3 || end - first > GJK_FACE_CORNERS_MAX) {
      return GJK_ERROR_RANGE;
    }
    for (; first < end; first++) {
      if (faces->corner[first] >= vertices) {
        return GJK_ERROR_RANGE;
      }
    }
  }
  return GJK_OK;
}

static gjk_status measure(const gjk_shape *shape, gjk_extent *out) {
  const gjk_vec3 *v = shape->vertices;
  if (v == NULL) {
    return GJK_ERROR_NULL;
  }
  if (shape->count == 0) {
    return GJK_ERROR_EMPTY;
  }
  const gjk_status faces = shape->faces == NULL ? GJK_OK : check_faces(shape->faces, shape->count);
  if (faces != GJK_OK) {
    return faces;
  }
  gjk_vec3 low = v[0], high = v[0];
  for (uint32_t i = 1; i < shape->count; i++) {
    low.x = v[i].x < low.x ? v[i].x : low.x;
    low.y = v[i].y < low.y ? v[i].y : low.y;
    low.z = v[i].z < low.z ? v[i].z : low.z;
    high.x = v[i].x > high.x ? v[i].x : high.x;
    high.y = v[i].y > high.y ? v[i].y : high.y;
    high.z = v[i].z > high.z ? v[i].z : high.z;
  }
  uint32_t x = measure_axis(low.x, high.x, &out->centre.x);
  uint32_t y = measure_axis(low.y, high.y, &out->centre.y);
  uint32_t z = measure_axis(low.z, high.z, &out->centre.z);
  if ((x | y | z) >> 28 != 0) {
    return GJK_ERROR_SIZE;
  }
  out->squared = 0;
  for (uint32_t i = 0; i < shape->count; i++) {
    gjk_vec3 offset = gjk_sub(v[i], out->centre);  // each component below 2^28
    uint64_t squared = (uint64_t)gjk_dot(&offset, &offset);
    out->squared = squared > out->squared ? squared : out->squared;
  }
  return GJK_OK;
}

const gjk_shape_class gjk_class_triangle = {
    measure, pose_triangle, support_triangle, refine_triangle, vertex_triangle, NULL, false, 3, GJK_KIND_VERTICES};
const gjk_shape_class gjk_class_hull = {measure, pose_hull, support_hull,     refine_hull, vertex_hull, NULL,
                                        true,    0,         GJK_KIND_VERTICES};
