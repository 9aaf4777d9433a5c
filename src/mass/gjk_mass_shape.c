// The mass properties of a shape, by what its class says of its kind.
#include "../arith/gjk_root.h"
#include "../shape/gjk_shape_class.h"
#include "gjk_mass_round.h"
#include "gjk_mass_rounded.h"

// Where a face begins and ends among the corners of all faces.
static uint32_t mass_face_start(const gjk_hull_faces *faces, uint32_t face) {
  return face == 0 ? 0 : faces->end[face - 1];
}

// Visits the triangles of all faces: corner 0 of each, and two that follow each other. If flat, it adds their areas,
// projected along an axis, otherwise tetrahedra from the origin. False: one would count negatively, so the faces are not
// sound.
static bool add_faces(const gjk_shape *shape, bool flat, unsigned axis, gjk_moments *m) {
  const gjk_hull_faces *faces = shape->faces;
  for (uint32_t face = 0; face < faces->count; face++) {
    const uint32_t first = mass_face_start(faces, face);
    const gjk_vec3 *corner[3];
    corner[0] = &shape->vertices[faces->corner[first]];
    for (uint32_t i = first + 1; i + 1 < faces->end[face]; i++) {
      corner[1] = &shape->vertices[faces->corner[i]];
      corner[2] = &shape->vertices[faces->corner[i + 1]];
      if (flat) {
        gjk_moments_add_flat(m, axis, corner);
      } else if (!gjk_moments_add_tetrahedron(m, corner)) {
        return false;
      }
    }
  }
  return true;
}

static gjk_status mass_of_faces(const gjk_shape *shape, gjk_mass *out) {
  const uint16_t *corner = shape->faces->corner;
  const gjk_vec3 *v = shape->vertices;
  gjk_moments m;
  gjk_moments_start(&m, &v[corner[0]]);
  if (!add_faces(shape, false, 0, &m)) {
    return GJK_ERROR_RANGE;
  }
  if (!gjk_big_is_zero(&m.weight)) {
    gjk_moments_finish(&m, 4, out);
    return GJK_OK;
  }
  const unsigned axis = gjk_longest_axis(&v[corner[0]], &v[corner[1]], &v[corner[2]]);
  if (axis == 3) {
    return GJK_ERROR_RANGE;
  }
  (void)add_faces(shape, true, axis, &m);
  gjk_moments_finish(&m, 3, out);
  return GJK_OK;
}

// Does a come before b, by x, then y, then z?
static bool comes_before(const gjk_vec3 *a, const gjk_vec3 *b) {
  return a->x != b->x ? a->x < b->x : a->y != b->y ? a->y < b->y : a->z < b->z;
}

// One to three vertices.
static void mass_of_few(const gjk_shape *shape, gjk_mass *out) {
  static const uint16_t two_sided[6] = {0, 1, 2, 0, 2, 1}, ends[2] = {3, 6};
  static const gjk_hull_faces both = {two_sided, ends, 2};
  const gjk_vec3 *v = shape->vertices;
  const gjk_vec3 *corner[3];
  corner[0] = &v[0];
  corner[1] = &v[shape->count - 1];
  corner[2] = &v[shape->count / 2];
  const unsigned axis = gjk_longest_axis(corner[0], corner[1], corner[2]);
  if (axis < 3 && shape->convex_radius > 0) {
    (void)gjk_mass_of_rounded_faces(v, &both, shape->convex_radius, out);
    return;
  }
  if (axis < 3) {
    gjk_moments m;
    gjk_moments_start(&m, &v[0]);
    gjk_moments_add_flat(&m, axis, corner);
    gjk_moments_finish(&m, 3, out);
    return;
  }
  const gjk_vec3 *first = corner[0], *last = corner[0];  // of points in a line
  for (int i = 1; i < 3; i++) {
    first = comes_before(corner[i], first) ? corner[i] : first;
    last = comes_before(last, corner[i]) ? corner[i] : last;
  }
  if (shape->convex_radius > 0) {
    gjk_mass_of_rounded_segment(first, last, shape->convex_radius, out);
  } else {
    gjk_moments_of_segment(first, last, out);
  }
}

static gjk_status mass_of_vertices(const gjk_shape *shape, gjk_mass *out) {
  if (shape->faces != NULL && shape->faces->count > 0) {
    return shape->convex_radius > 0
               ? gjk_mass_of_rounded_faces(shape->vertices, shape->faces, shape->convex_radius, out)
               : mass_of_faces(shape, out);
  }
  if (shape->count > 3) {
    return GJK_ERROR_UNSUPPORTED;
  }
  mass_of_few(shape, out);
  return GJK_OK;
}

static gjk_status mass_of_curved(const gjk_shape *shape, gjk_mass *out) {
  static const int32_t none[3] = {0, 0, 0};
  const int32_t radius[3] = {shape->size.x, shape->size.y, shape->size.z}, rounding = shape->convex_radius;
  const bool cone = shape->type->kind == GJK_KIND_CONE,
             ball = !cone && radius[0] == radius[1] && radius[1] == radius[2],
             point = cone && radius[0] == 0 && radius[2] == 0;
  if (shape->support != NULL || (rounding > 0 && !cone && !ball)) {
    return GJK_ERROR_UNSUPPORTED;
  }
  if (rounding > 0 && (ball || point)) {
    gjk_mass_of_axes(none, radius[0] + rounding, out);
  } else if (rounding > 0) {
    gjk_mass_of_rounded_cone(radius[0], radius[2], rounding, out);
  } else if (cone) {
    gjk_mass_of_cone(radius[0], radius[2], out);
  } else {
    gjk_mass_of_ellipsoid(radius, out);
  }
  return GJK_OK;
}

// The checks of gjk_collider_init.
static gjk_status check_mass_shape(const gjk_shape *shape) {
  gjk_extent extent;
  if (shape->type == NULL) {
    return GJK_ERROR_NULL;
  }
  const gjk_status status = shape->convex_radius < 0 ? GJK_ERROR_NEGATIVE : shape->type->measure(shape, &extent);
  if (status != GJK_OK) {
    return status;
  }
  const int64_t room = (int64_t)GJK_RADIUS_MAX - shape->convex_radius;
  return room < 0 || extent.squared > (uint64_t)(room * room) ? GJK_ERROR_SIZE : GJK_OK;
}

gjk_status gjk_mass_of_shape(const gjk_shape *shape, gjk_mass *out) {
  if (shape == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  const gjk_status status = check_mass_shape(shape);
  if (status != GJK_OK) {
    return status;
  }
  const unsigned axes = shape->type->count;  // of a point none, of a segment z alone
  const int32_t half[3] = {axes == 3 ? shape->size.x : 0, axes == 3 ? shape->size.y : 0, axes > 0 ? shape->size.z : 0};
  const unsigned kind = shape->type->kind;
  if (kind == GJK_KIND_VERTICES) {
    return mass_of_vertices(shape, out);
  }
  if (kind == GJK_KIND_CONE || kind == GJK_KIND_SMOOTH) {
    return mass_of_curved(shape, out);
  }
  if (kind == GJK_KIND_CYLINDER) {
    gjk_mass_of_cylinder(shape->size.x, shape->size.z, shape->convex_radius, out);
  } else {
    gjk_mass_of_axes(half, shape->convex_radius, out);
  }
  return GJK_OK;
}
