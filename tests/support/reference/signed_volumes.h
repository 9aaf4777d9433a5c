// The point of a simplex nearest to the origin, by signed volumes, for the scalar type `real` of the including file.
//
// After Montanari, Petrinic and Barbieri, "Improving the GJK algorithm for faster and more reliable distance
// queries between convex objects", 2017, section 4. Departure: where the paper keeps the newest vertex of a
// segment, the nearer one is kept.
#ifndef SIGNED_VOLUMES_H
#define SIGNED_VOLUMES_H

#include <stdbool.h>

static inline real real_dot(const real a[3], const real b[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void real_sub(const real a[3], const real b[3], real out[3]) {
  for (int k = 0; k < 3; k++) {
    out[k] = a[k] - b[k];
  }
}

static inline void real_cross(const real a[3], const real b[3], real out[3]) {
  out[0] = a[1] * b[2] - a[2] * b[1];
  out[1] = a[2] * b[0] - a[0] * b[2];
  out[2] = a[0] * b[1] - a[1] * b[0];
}

static inline real real_length(const real a[3]) {
  return real_sqrt(real_dot(a, a));
}

static inline real real_magnitude(real a) {
  return a < 0 ? -a : a;
}

static inline bool same_sign(real a, real b) {
  return (a > 0 && b > 0) || (a < 0 && b < 0);
}

static inline void weighted_sum(const real *const s[], const real weight[], int count, real out[3]) {
  for (int k = 0; k < 3; k++) {
    out[k] = 0;
    for (int i = 0; i < count; i++) {
      out[k] += weight[i] * s[i][k];
    }
  }
}

static void nearest_on_segment(const real *const s[2], real weight[2]) {
  real t[3];
  real_sub(s[0], s[1], t);
  int axis = 0;
  for (int k = 1; k < 3; k++) {
    axis = real_magnitude(t[k]) > real_magnitude(t[axis]) ? k : axis;
  }
  weight[0] = 0;
  weight[1] = 1;
  if (t[axis] != 0) {
    real foot = s[1][axis] - real_dot(s[1], t) / real_dot(t, t) * t[axis];
    real share = (foot - s[1][axis]) / t[axis];
    weight[0] = share <= 0 ? 0 : (share >= 1 ? 1 : share);
    weight[1] = 1 - weight[0];
  }
}

// The weights of the nearest point of all faces that lie opposite to a vertex which `behind` marks.
static void nearest_on_faces(const real *const s[], int count, const bool behind[],
                             void (*nearest)(const real *const[], real[]), real weight[]) {
  real best = -1;
  for (int j = 0; j < count; j++) {
    const real *face[3];
    real face_weight[3], point[3];
    if (!behind[j]) {
      continue;
    }
    for (int i = 0; i < count - 1; i++) {
      face[i] = s[i < j ? i : i + 1];
    }
    nearest(face, face_weight);
    weighted_sum(face, face_weight, count - 1, point);
    if (best < 0 || real_dot(point, point) < best) {
      best = real_dot(point, point);
      for (int i = 0; i < count; i++) {
        weight[i] = i == j ? 0 : face_weight[i < j ? i : i - 1];
      }
    }
  }
}

// Sets the weights of the origin from the signed volume that it spans with the face opposite to each vertex. False: the
// origin lies beyond a face; `behind` marks the vertex opposite to each such face.
static bool inside_weights(const real part[], real whole, int count, bool behind[], real weight[]) {
  bool inside = true;
  for (int j = 0; j < count; j++) {
    behind[j] = !same_sign(part[j], whole);
    inside = inside && !behind[j];
    weight[j] = inside ? part[j] / whole : 0;
  }
  return inside;
}

static real area(const real *a, const real *b, const real *c, int k, int l) {
  return (b[k] - a[k]) * (c[l] - a[l]) - (b[l] - a[l]) * (c[k] - a[k]);
}

static void nearest_on_triangle(const real *const s[3], real weight[3]) {
  real e1[3], e2[3], n[3], foot[3];
  real_sub(s[1], s[0], e1);
  real_sub(s[2], s[0], e2);
  real_cross(e1, e2, n);
  real nn = real_dot(n, n);
  int axis = 0;
  for (int k = 0; k < 3; k++) {
    foot[k] = nn > 0 ? n[k] * (real_dot(s[0], n) / nn) : 0;
    axis = real_magnitude(n[k]) > real_magnitude(n[axis]) ? k : axis;
  }
  int k = (axis + 1) % 3, l = (axis + 2) % 3;
  real part[3] = {area(foot, s[1], s[2], k, l), area(s[0], foot, s[2], k, l), area(s[0], s[1], foot, k, l)};
  bool behind[3];
  if (!inside_weights(part, n[axis], 3, behind, weight)) {
    nearest_on_faces(s, 3, behind, nearest_on_segment, weight);
  }
}

static real volume(const real *a, const real *b, const real *c) {
  real n[3];
  real_cross(a, b, n);
  return real_dot(n, c);
}

static void nearest_on_tetrahedron(const real *const s[4], real weight[4]) {
  real part[4] = {-volume(s[1], s[2], s[3]), volume(s[0], s[2], s[3]), -volume(s[0], s[1], s[3]),
                  volume(s[0], s[1], s[2])};
  bool behind[4];
  if (!inside_weights(part, part[0] + part[1] + part[2] + part[3], 4, behind, weight)) {
    nearest_on_faces(s, 4, behind, nearest_on_triangle, weight);
  }
}

// The weights of the simplex's point nearest to the origin; 0 for vertices that it does not need. Pre: 1 <= count <= 4.
static void nearest_on_simplex(const real *const s[], int count, real weight[]) {
  switch (count) {
    case 1: weight[0] = 1; break;
    case 2: nearest_on_segment(s, weight); break;
    case 3: nearest_on_triangle(s, weight); break;
    default: nearest_on_tetrahedron(s, weight); break;
  }
}

#endif
