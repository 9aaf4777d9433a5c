// Shapes of cases and colliders for GJK in floating point, in the scalar type `real` of the including file.
//
// Nothing here is shared with the library but the public types. The including file defines `real` and
// `static real real_sqrt(real)` first. Lengths are in units (65536 LSB), so that squares do not overflow a float.
#ifndef SOLVER_H
#define SOLVER_H

#include "case/case.h"
#include "signed_volumes.h"

#define SOLVER_LSB ((real)1 / (real)65536)

// A shape: all points within convex_radius of centre + x axes[0] + y axes[1] + z axes[2], for the points (x, y, z) of
// the local shape that kind, size and vertices say. Local lengths are in LSB; axes scale them to units.
typedef struct solver_shape {
  case_kind kind;
  const gjk_vec3 *vertices;
  size_t count;
  real size[3];
  real axes[3][3];
  real centre[3];
  real convex_radius;
} solver_shape;

static void set_vec3(real out[3], gjk_vec3 v) {
  out[0] = (real)v.x;
  out[1] = (real)v.y;
  out[2] = (real)v.z;
}

static void set_scale_axes(solver_shape *shape) {
  for (int i = 0; i < 3; i++) {
    for (int k = 0; k < 3; k++) {
      shape->axes[i][k] = i == k ? SOLVER_LSB : 0;
    }
  }
}

// Sets the rotation by q / |q|: axes[i] is the image of the i-th local axis.
static void set_rotation(solver_shape *shape, const gjk_quat *q) {
  real x = (real)q->x, y = (real)q->y, z = (real)q->z, w = (real)q->w;
  real s = 2 / (x * x + y * y + z * z + w * w);
  real axes[3][3] = {{1 - s * (y * y + z * z), s * (x * y + w * z), s * (x * z - w * y)},
                     {s * (x * y - w * z), 1 - s * (x * x + z * z), s * (y * z + w * x)},
                     {s * (x * z + w * y), s * (y * z - w * x), 1 - s * (x * x + y * y)}};
  for (int i = 0; i < 3; i++) {
    for (int k = 0; k < 3; k++) {
      shape->axes[i][k] = axes[i][k] * SOLVER_LSB;
    }
  }
}

// Sets centre to at - origin, exactly in double.
static void set_centre(solver_shape *shape, gjk_vec3 at, gjk_vec3 origin) {
  shape->centre[0] = (real)((int64_t)at.x - origin.x) * SOLVER_LSB;
  shape->centre[1] = (real)((int64_t)at.y - origin.y) * SOLVER_LSB;
  shape->centre[2] = (real)((int64_t)at.z - origin.z) * SOLVER_LSB;
}

// A shape of a case at its pose in the reals, relative to origin.
static inline void solver_from_case(solver_shape *out, const case_shape *shape, gjk_vec3 origin) {
  out->kind = shape->kind;
  out->vertices = shape->vertices;
  out->count = shape->count;
  out->convex_radius = (real)shape->convex_radius * SOLVER_LSB;
  set_vec3(out->size, shape->size);
  set_rotation(out, &shape->pose.rotation);
  set_centre(out, shape->pose.position, origin);
}

// Sets the rotation matrix that the collider of a lazy hull or curved shape keeps, rows in Q2.30.
static void set_rows(solver_shape *shape, const gjk_collider *collider) {
  real local[3], rows[3][3];
  set_vec3(local, collider->local_centre);
  for (int k = 0; k < 3; k++) {
    set_vec3(rows[k], collider->frame[k]);
    for (int i = 0; i < 3; i++) {
      shape->axes[i][k] = rows[k][i] / (real)GJK_Q30_ONE * SOLVER_LSB;
      shape->centre[k] -= shape->axes[i][k] * local[i];
    }
  }
}

// A shape as the library posed it, relative to origin: a polytope by its integer vertices, another by its rotation
// matrix.
static void solver_from_collider(solver_shape *out, const case_collider *posed, case_kind kind, gjk_vec3 origin) {
  const gjk_collider *collider = &posed->collider;
  const gjk_vec3 *frame = collider->frame;
  out->kind = kind;
  out->vertices = kind == CASE_TRIANGLE ? frame : collider->buffer;
  out->count = collider->shape->count;
  out->convex_radius = (real)collider->shape->convex_radius * SOLVER_LSB;
  set_vec3(out->size, collider->shape->size);
  set_scale_axes(out);
  set_centre(out, collider->centre, origin);
  if (kind == CASE_BOX || kind == CASE_SEGMENT) {
    for (int i = 0; i < 3; i++) {
      set_vec3(out->axes[i], frame[kind == CASE_BOX ? i : 0]);
      for (int k = 0; k < 3; k++) {
        out->axes[i][k] *= SOLVER_LSB;
      }
      out->size[i] = 1;
    }
  } else if (kind > CASE_HULL || (kind == CASE_HULL && collider->buffer == NULL)) {
    out->vertices = collider->shape->vertices;
    set_rows(out, collider);
  }
}

static void farthest_vertex(const solver_shape *shape, const real d[3], real out[3]) {
  real best = 0;
  for (size_t i = 0; i < shape->count; i++) {
    real v[3];
    set_vec3(v, shape->vertices[i]);
    real along = real_dot(v, d);
    if (i == 0 || along > best) {
      best = along;
      out[0] = v[0];
      out[1] = v[1];
      out[2] = v[2];
    }
  }
}

// The point farthest along d of the circle of radius size[0] in the plane z = 0; its centre if d is along z.
static void farthest_on_rim(const real size[3], const real d[3], real out[3]) {
  real length = real_sqrt(d[0] * d[0] + d[1] * d[1]);
  out[0] = length > 0 ? size[0] * d[0] / length : 0;
  out[1] = length > 0 ? size[0] * d[1] / length : 0;
  out[2] = 0;
}

static void farthest_local(const solver_shape *shape, const real d[3], real out[3]) {
  const real *size = shape->size;
  real scaled[3] = {size[0] * d[0], size[1] * d[1], size[2] * d[2]};
  real length = real_length(scaled);
  for (int k = 0; k < 3; k++) {
    out[k] = 0;
  }
  switch (shape->kind) {
    case CASE_POINT: break;
    case CASE_SEGMENT: out[2] = d[2] < 0 ? -size[2] : size[2]; break;
    case CASE_BOX:
      for (int k = 0; k < 3; k++) {
        out[k] = d[k] < 0 ? -size[k] : size[k];
      }
      break;
    case CASE_TRIANGLE:
    case CASE_HULL: farthest_vertex(shape, d, out); break;
    case CASE_CYLINDER:
      farthest_on_rim(size, d, out);
      out[2] = d[2] < 0 ? -size[2] : size[2];
      break;
    case CASE_CONE:
      farthest_on_rim(size, d, out);
      out[2] = -size[2];
      if (size[2] * d[2] > real_dot(out, d)) {
        out[0] = out[1] = 0;
        out[2] = size[2];
      }
      break;
    case CASE_ELLIPSOID:
      for (int k = 0; k < 3; k++) {
        out[k] = length > 0 ? size[k] * scaled[k] / length : 0;
      }
      break;
  }
}

// The support point of the core along d, in units.
static void farthest(const solver_shape *shape, const real d[3], real out[3]) {
  real local_d[3], local[3];
  for (int i = 0; i < 3; i++) {
    local_d[i] = real_dot(shape->axes[i], d);
  }
  farthest_local(shape, local_d, local);
  for (int k = 0; k < 3; k++) {
    out[k] =
        shape->centre[k] + local[0] * shape->axes[0][k] + local[1] * shape->axes[1][k] + local[2] * shape->axes[2][k];
  }
}

#include "solver_loop.h"

#endif
