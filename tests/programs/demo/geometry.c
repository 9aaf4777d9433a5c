// Finds support points and faces in real numbers.
#include "geometry.h"

#include <math.h>

// Vertices at most this far from a plane, in units, lie in it.
#define PLANE_TOLERANCE 1e-5

real3 real_unit(real3 a) {
  double length = sqrt(real_dot(a, a));
  return length > 0 ? real_scale(1 / length, a) : a;
}

real3 real_from_q16(gjk_vec3 a) {
  real3 out = {a.x / 65536.0, a.y / 65536.0, a.z / 65536.0};
  return out;
}

// v turned by the quaternion, with its vector part multiplied by sign.
static real3 turn(const case_shape *shape, real3 v, double sign) {
  const gjk_quat *q = &shape->pose.rotation;
  const double one = (double)GJK_Q30_ONE;
  real3 axis = {sign * q->x / one, sign * q->y / one, sign * q->z / one};
  real3 t = real_scale(2, real_cross(axis, v));
  return real_add(v, real_add(real_scale(q->w / one, t), real_cross(axis, t)));
}

real3 geometry_turn(const case_shape *shape, real3 local) {
  return turn(shape, local, 1);
}

real3 geometry_turn_back(const case_shape *shape, real3 world) {
  return turn(shape, world, -1);
}

static double with_sign(double magnitude, double of) {
  return of < 0 ? -magnitude : magnitude;
}

static real3 farthest_vertex(const case_shape *shape, real3 d) {
  real3 best = real_from_q16(shape->vertices[0]);
  for (size_t i = 1; i < shape->count; i++) {
    real3 v = real_from_q16(shape->vertices[i]);
    if (real_dot(v, d) > real_dot(best, d)) {
      best = v;
    }
  }
  return best;
}

// The support point of the core, in the frame of the shape.
static real3 local_support(const case_shape *shape, real3 d) {
  real3 s = real_from_q16(shape->size);
  real3 corner = {with_sign(s.x, d.x), with_sign(s.y, d.y), with_sign(s.z, d.z)};
  double flat = hypot(d.x, d.y);
  switch (shape->kind) {
    case CASE_TRIANGLE:
    case CASE_HULL: return farthest_vertex(shape, d);
    case CASE_ELLIPSOID: {
      real3 scaled = {s.x * d.x, s.y * d.y, s.z * d.z};
      real3 unit = real_unit(scaled);
      real3 point = {s.x * unit.x, s.y * unit.y, s.z * unit.z};
      return point;
    }
    case CASE_CYLINDER:
    case CASE_CONE: {
      real3 rim = {flat > 0 ? s.x * d.x / flat : 0, flat > 0 ? s.x * d.y / flat : 0, corner.z};
      real3 apex = {0, 0, s.z};
      if (shape->kind == CASE_CYLINDER) {
        return rim;
      }
      rim.z = -s.z;
      return real_dot(apex, d) > real_dot(rim, d) ? apex : rim;
    }
    default: return corner;
  }
}

real3 geometry_support(const case_shape *shape, real3 direction) {
  real3 core = geometry_turn(shape, local_support(shape, geometry_turn_back(shape, direction)));
  real3 out = real_scale(shape->convex_radius / 65536.0, real_unit(direction));
  return real_add(real_from_q16(shape->pose.position), real_add(core, out));
}

static real3 to_world(const case_shape *shape, real3 local, real3 normal) {
  real3 raised = real_scale(shape->convex_radius / 65536.0, normal);
  return real_add(real_from_q16(shape->pose.position), real_add(geometry_turn(shape, local), raised));
}

static size_t box_faces(const case_shape *shape, real_face *faces) {
  static const int corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  const double half[3] = {shape->size.x / 65536.0, shape->size.y / 65536.0, shape->size.z / 65536.0};
  for (int f = 0; f < 6; f++) {
    int axis = f / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
    double normal[3] = {0, 0, 0};
    normal[axis] = f % 2 == 0 ? -1 : 1;
    real3 n = {normal[0], normal[1], normal[2]};
    faces[f].normal = geometry_turn(shape, n);
    faces[f].count = 4;
    for (int i = 0; i < 4; i++) {
      double p[3];
      p[axis] = normal[axis] * half[axis];
      p[u] = corner[i][0] * half[u];
      p[v] = corner[i][1] * half[v];
      real3 local = {p[0], p[1], p[2]};
      faces[f].vertex[i] = to_world(shape, local, faces[f].normal);
    }
  }
  return 6;
}

// Sorts the vertices around their mean, counterclockwise as seen from outside.
static void sort_vertices(real_face *face) {
  real3 middle = {0, 0, 0};
  double angle[FACE_VERTICES_MAX];
  for (size_t i = 0; i < face->count; i++) {
    middle = real_add(middle, real_scale(1.0 / (double)face->count, face->vertex[i]));
  }
  real3 u = real_unit(real_sub(face->vertex[0], middle));
  real3 v = real_cross(face->normal, u);
  for (size_t i = 0; i < face->count; i++) {
    real3 vertex = face->vertex[i], arm = real_sub(vertex, middle);
    double own = atan2(real_dot(arm, v), real_dot(arm, u));
    size_t at = i;
    for (; at > 0 && angle[at - 1] > own; at--) {
      angle[at] = angle[at - 1];
      face->vertex[at] = face->vertex[at - 1];
    }
    angle[at] = own;
    face->vertex[at] = vertex;
  }
}

// Takes all points in the plane through p across normal. False: a point lies before the plane.
static bool collect_face(const real3 *point, size_t n, double tolerance, real3 p, real3 normal, real_face *face) {
  face->normal = normal;
  face->count = 0;
  for (size_t i = 0; i < n; i++) {
    double height = real_dot(real_sub(point[i], p), normal);
    if (height > tolerance) {
      return false;
    }
    if (height > -tolerance && face->count < FACE_VERTICES_MAX) {
      face->vertex[face->count++] = point[i];
    }
  }
  return true;
}

static bool is_known(const real_face *faces, size_t count, real3 normal) {
  for (size_t i = 0; i < count; i++) {
    if (real_dot(faces[i].normal, normal) > 1 - 1e-6) {
      return true;
    }
  }
  return false;
}

// Takes every plane through three points that has no point before it.
size_t geometry_hull_faces(const real3 *point, size_t n, double tolerance, real_face faces[FACES_MAX]) {
  size_t found = 0;
  n = n <= GEOMETRY_POINTS_MAX ? n : 0;
  for (size_t i = 0; i < n * n * n * 2 && found < FACES_MAX; i++) {
    real3 p = point[i / 2 % n], q = point[i / 2 / n % n], r = point[i / 2 / n / n];
    real3 across = real_cross(real_sub(q, p), real_sub(r, p));
    real3 normal = real_unit(real_scale(i % 2 == 0 ? 1 : -1, across));
    if (real_dot(across, across) < tolerance * tolerance * tolerance || is_known(faces, found, normal) ||
        !collect_face(point, n, tolerance, p, normal, &faces[found])) {
      continue;
    }
    sort_vertices(&faces[found++]);
  }
  return found;
}

static size_t hull_faces(const case_shape *shape, real_face *faces) {
  real3 point[GEOMETRY_POINTS_MAX];
  const size_t n = shape->count <= GEOMETRY_POINTS_MAX ? shape->count : 0;
  for (size_t i = 0; i < n; i++) {
    point[i] = real_from_q16(shape->vertices[i]);
  }
  const size_t found = geometry_hull_faces(point, n, PLANE_TOLERANCE, faces);
  for (size_t i = 0; i < found; i++) {
    faces[i].normal = geometry_turn(shape, faces[i].normal);
    for (size_t k = 0; k < faces[i].count; k++) {
      faces[i].vertex[k] = to_world(shape, faces[i].vertex[k], faces[i].normal);
    }
  }
  return found;
}

size_t geometry_faces(const case_shape *shape, real_face faces[FACES_MAX]) {
  switch (shape->kind) {
    case CASE_BOX: return box_faces(shape, faces);
    case CASE_TRIANGLE:
    case CASE_HULL: return hull_faces(shape, faces);
    default: return 0;
  }
}
