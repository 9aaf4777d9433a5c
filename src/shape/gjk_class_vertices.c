// Triangle and hull: a list of vertices, posed beforehand (baked) or on demand (lazy).
//
// A lazy hull rotates the direction into the shape's frame, scans there, and rotates the few vertices that come
// near the farthest; so it finds the very vertex that the baked hull finds.
#include "../arith/gjk_rotation.h"
#include "gjk_scan.h"
#include "gjk_shape_class.h"

// The posed vertices of a triangle or a baked hull.
static const gjk_vec3 *posed(const gjk_collider *c) {
  return c->buffer != NULL ? c->buffer : c->frame;
}

static void support_posed(const gjk_collider *c, const gjk_vec3 *d, gjk_support *out) {
  const gjk_vec3 *vertices = posed(c), *farthest = gjk_scan(vertices, vertices + c->count, c->bits, d);
  out->offset = *farthest;
  out->vertex = (uint16_t)(farthest - vertices);
}

// How far behind the farthest along a rounded direction the farthest along the exact one may stay: each component is off
// by less than 1, so by less than |u.x| + |u.y| + |u.z| <= sqrt(3) 2 core_radius for their difference u.
static int64_t rounding_slack(const gjk_collider *c) {
  return 4 * (int64_t)c->core_radius;
}

// Those of the vertices that come within slack of one of them along d: posed ones, or the shape's own, which are looked at as
// they are, not relative to its centre: that shifts all products alike.
static void reach_within(gjk_reach *reach, const gjk_collider *c, const gjk_vec3 *vertices, const gjk_vec3 *d,
                         const gjk_vec3 *one, int64_t slack) {
  reach->next = vertices;
  reach->end = vertices + c->count;
  reach->d = d;
  reach->limit = gjk_dot(one, d) - slack;
  gjk_reach_start(reach, vertices == c->shape->vertices ? 31 : c->bits);
}

// Pre: offsets of the vertices at most core_radius; *at is among the farthest along d.
GJK_OUT_OF_LINE static bool refine_posed(const gjk_collider *c, const gjk_vec3 *d, const gjk_direction *direction,
                                         gjk_support *at) {
  const gjk_vec3 *vertices = posed(c), *v;
  const uint16_t before = at->vertex;
  gjk_reach reach;
  reach_within(&reach, c, vertices, d, &at->offset, rounding_slack(c));
  while ((v = gjk_reach_next(&reach)) != NULL) {  // at most GJK_HULL_VERTICES_MAX
    const gjk_vec3 step = gjk_sub(*v, at->offset);
    if (gjk_direction_sign(direction, &step) > 0) {
      at->offset = *v;
      at->vertex = (uint16_t)(v - vertices);
    }
  }
  return at->vertex != before;
}

// The offset from the rounded centre, rounded once: from the exact one's fraction of an LSB on. So the vertex is within 0.5
// for that rounding, 2^-31 (|x| + |y| + |z|) < 0.22 for that of the matrix, 2^-8 and 2^-9 for the fraction: less than 3/4 LSB.
static gjk_vec3 pose_vertex(const gjk_collider *c, const gjk_vec3 rows[3], const gjk_vec3 *v) {
  const gjk_vec3 local = gjk_sub(*v, c->local_centre);  // at most GJK_RADIUS_MAX, by measure
  return gjk_rotate_onto(rows, &local, c->fraction);
}

// d in the shape's frame, and how far it misleads a comparison of two vertices u apart there: each of its components is
// off by at most 1/2, so by at most 2 core_radius, and by |d.x| + |d.y| + |d.z| < 2^32 for the rounding of both vertices.
static int64_t local_direction(const gjk_collider *c, const gjk_vec3 *d, gjk_vec3 *local) {
  *local = gjk_rotate_back(c->frame, d);
  return 2 * (int64_t)c->core_radius + gjk_norm1(*d) + 8;
}

GJK_OUT_OF_LINE static void support_lazy(const gjk_collider *c, const gjk_vec3 *direction, gjk_support *out) {
  const gjk_vec3 *vertices = c->shape->vertices, *best = NULL;
  const gjk_vec3 d = gjk_scale_direction(direction);
  gjk_vec3 local;
  gjk_reach reach;
  const int64_t slack = local_direction(c, &d, &local);
  reach_within(&reach, c, vertices, &local, gjk_scan(vertices, vertices + c->count, 31, &local), slack);
  const gjk_vec3 *v = gjk_reach_next(&reach);
  int64_t farthest = 0;
  //@ assert v != 0;
  do {  // at least the one just found, at most GJK_HULL_VERTICES_MAX
    const gjk_vec3 offset = pose_vertex(c, c->frame, v);
    const int64_t along = gjk_dot(&offset, &d);
    if (best == NULL || along > farthest) {
      best = v;
      farthest = along;
      out->offset = offset;
    }
    v = gjk_reach_next(&reach);
  } while (v != NULL);
  out->vertex = (uint16_t)(best - vertices);
}

GJK_OUT_OF_LINE static bool refine_lazy(const gjk_collider *c, const gjk_vec3 *d, const gjk_direction *direction,
                                        gjk_support *at) {
  const gjk_vec3 *vertices = c->shape->vertices, *v;
  const uint16_t before = at->vertex;
  gjk_vec3 local;
  gjk_reach reach;
  const int64_t slack = local_direction(c, d, &local) + rounding_slack(c);
  reach_within(&reach, c, vertices, &local, &vertices[before], slack);
  while ((v = gjk_reach_next(&reach)) != NULL) {  // at most GJK_HULL_VERTICES_MAX
    const gjk_vec3 offset = pose_vertex(c, c->frame, v);
    const gjk_vec3 step = gjk_sub(offset, at->offset);
    if (gjk_direction_sign(direction, &step) > 0) {
      at->offset = offset;
      at->vertex = (uint16_t)(v - vertices);
    }
  }
  return at->vertex != before;
}

static void support_hull(const gjk_collider *c, const gjk_vec3 *d, gjk_support *out) {
  if (c->buffer != NULL) {
    support_posed(c, d, out);
  } else {
    support_lazy(c, d, out);
  }
}

static bool refine_hull(const gjk_collider *c, const gjk_vec3 *d, const gjk_direction *direction, gjk_support *at) {
  return c->buffer != NULL ? refine_posed(c, d, direction, at) : refine_lazy(c, d, direction, at);
}

static bool vertex_posed(const gjk_collider *c, uint16_t number, gjk_vec3 *offset) {
  if (number >= c->count) {
    return false;
  }
  *offset = posed(c)[number];
  return true;
}

static bool vertex_hull(const gjk_collider *c, uint16_t number, gjk_vec3 *offset) {
  if (c->buffer != NULL || number >= c->count) {
    return vertex_posed(c, number, offset);
  }
  *offset = pose_vertex(c, c->frame, &c->shape->vertices[number]);
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
    c->buffer[i] = pose_vertex(c, rows, &c->shape->vertices[i]);
  }
}

static void pose_triangle(gjk_collider *c, const gjk_vec3 rows[3]) {
  for (uint32_t i = 0; i < 3; i++) {
    c->frame[i] = pose_vertex(c, rows, &c->shape->vertices[i]);
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

static gjk_status measure_vertices(const gjk_shape *shape, gjk_extent *out) {
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

static gjk_status measure_triangle(const gjk_shape *shape, gjk_extent *out) {
  return shape->vertices == NULL || shape->count == 3 ? measure_vertices(shape, out) : GJK_ERROR_RANGE;
}

const gjk_shape_class gjk_class_triangle = {
    measure_triangle, pose_triangle, support_posed, refine_posed, vertex_posed, NULL, false, 3, GJK_KIND_VERTICES};
const gjk_shape_class gjk_class_hull = {
    measure_vertices, pose_hull, support_hull, refine_hull, vertex_hull, NULL, true, 0, GJK_KIND_VERTICES};
