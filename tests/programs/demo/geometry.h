// Bodies as a picture needs them: in real numbers, in units.
#ifndef GEOMETRY_H
#define GEOMETRY_H

#include "case/case.h"

typedef struct real3 {
  double x, y, z;
} real3;

enum { FACE_VERTICES_MAX = 32, FACES_MAX = 128 };

// A flat face of a box, triangle or hull, moved out by the convex radius. Its vertices are in order around it.
typedef struct real_face {
  real3 normal;
  real3 vertex[FACE_VERTICES_MAX];
  size_t count;
} real_face;

static inline real3 real_add(real3 a, real3 b) {
  real3 sum = {a.x + b.x, a.y + b.y, a.z + b.z};
  return sum;
}

static inline real3 real_scale(double factor, real3 a) {
  real3 scaled = {factor * a.x, factor * a.y, factor * a.z};
  return scaled;
}

static inline real3 real_sub(real3 a, real3 b) {
  return real_add(a, real_scale(-1, b));
}

static inline double real_dot(real3 a, real3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline real3 real_cross(real3 a, real3 b) {
  real3 out = {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  return out;
}

real3 real_unit(real3 a);
real3 real_from_q16(gjk_vec3 a);

// Turns a direction from the frame of the shape to the world, and back.
real3 geometry_turn(const case_shape *shape, real3 local);
real3 geometry_turn_back(const case_shape *shape, real3 world);

// The support point of the shape along direction.
real3 geometry_support(const case_shape *shape, real3 direction);

// Most points of which faces are found.
#define GEOMETRY_POINTS_MAX 64

// Finds the faces of the convex hull of n points; none of more than GEOMETRY_POINTS_MAX. Points at most
// tolerance from a plane lie in it. Returns their number, at most FACES_MAX.
size_t geometry_hull_faces(const real3 *point, size_t n, double tolerance, real_face faces[FACES_MAX]);

// Finds the faces of a box, triangle or hull; other kinds have none. Returns their number, at most FACES_MAX.
size_t geometry_faces(const case_shape *shape, real_face faces[FACES_MAX]);

#endif
