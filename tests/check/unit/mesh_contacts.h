// The contacts of a body with a surface, and whether the surface has their normals, in doubles.
#ifndef MESH_CONTACTS_H
#define MESH_CONTACTS_H

#include <math.h>
#include <string.h>

#include "check.h"
#include "gjk/surface.h"
#include "src/mesh/gjk_triangle.h"

#define FOUND_MAX 600
#define NEAR_MAX 4000

typedef struct found_contacts {
  uint16_t count;
  gjk_surface_contact contact[FOUND_MAX];
} found_contacts;

typedef struct dvec {
  double x, y, z;
} dvec;

// A triangle near the body, in the world.
typedef struct near_triangle {
  uint32_t number;
  gjk_vec3 world[3];
  dvec normal;  // of length 1; 0: in a line
} near_triangle;

typedef struct near_surface {
  unsigned count;
  near_triangle triangle[NEAR_MAX];
} near_surface;

static dvec of_vec3(const gjk_vec3 *v) {
  return (dvec){v->x, v->y, v->z};
}

static dvec minus(dvec a, dvec b) {
  return (dvec){a.x - b.x, a.y - b.y, a.z - b.z};
}

static dvec add_scaled(dvec a, double s, dvec b) {
  return (dvec){a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
}

static double dot_of(dvec a, dvec b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

static dvec cross_of(dvec a, dvec b) {
  return (dvec){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static double length_of(dvec a) {
  return sqrt(dot_of(a, a));
}

// The triangles near the body.
static void find_near(const gjk_parts *parts, const gjk_collider *body, gjk_q16 margin, near_surface *out) {
  gjk_parts_frame frame;
  gjk_region region;
  gjk_parts_walk walk;
  uint32_t number;
  out->count = 0;
  CHECK(gjk_parts_open(&frame, &region, parts, body) == GJK_OK);
  gjk_region_grow(&region, margin + 4096);
  gjk_parts_walk_start(&walk);
  while (gjk_parts_next(&frame, &region, &walk, &number) && out->count < NEAR_MAX) {
    near_triangle *t = &out->triangle[out->count++];
    gjk_parts_room room;
    gjk_parts_local local;
    parts->type->local(parts->data, number, &room, &local);
    CHECK(gjk_triangle_turn(&frame, room.vertices, t->world));
    const dvec a = of_vec3(&t->world[0]);
    const dvec n = cross_of(minus(of_vec3(&t->world[1]), a), minus(of_vec3(&t->world[2]), a));
    const dvec none = {0, 0, 0};
    t->number = number;
    t->normal = length_of(n) > 0 ? add_scaled(none, 1 / length_of(n), n) : none;
  }
}

// The distance of a point from a triangle.
static double distance_from(const near_triangle *t, dvec p) {
  double best = 1e300;
  bool inside = true;
  for (int i = 0; i < 3; i++) {
    const dvec a = of_vec3(&t->world[i]), e = minus(of_vec3(&t->world[(i + 1) % 3]), a), v = minus(p, a);
    const double square = dot_of(e, e), s = square > 0 ? fmin(1, fmax(0, dot_of(v, e) / square)) : 0;
    best = fmin(best, length_of(minus(v, add_scaled((dvec){0, 0, 0}, s, e))));
    inside = inside && dot_of(cross_of(t->normal, e), v) >= 0;
  }
  return inside && length_of(t->normal) > 0 ? fmin(best, fabs(dot_of(t->normal, minus(p, of_vec3(&t->world[0])))))
                                            : best;
}

// Is n the triangle's own normal, up to an angle?
static bool is_normal_of(const near_triangle *t, dvec n, bool two_sided, double angle) {
  return length_of(cross_of(t->normal, n)) < angle && (two_sided || dot_of(t->normal, n) > 0.5);
}

// Does the surface have the normal at p: is it that of a triangle there, or do all triangles there lie behind the plane
// across it? slack: LSB; angle: of the normal.
static bool surface_has(const near_surface *near, dvec p, dvec n, bool two_sided, double slack, double angle) {
  bool behind = true;
  for (unsigned i = 0; i < near->count; i++) {
    const near_triangle *t = &near->triangle[i];
    if (distance_from(t, p) > slack) {
      continue;
    }
    if (is_normal_of(t, n, two_sided, 1e-8)) {
      return true;
    }
    for (int k = 0; k < 3; k++) {
      const dvec v = minus(of_vec3(&t->world[k]), p);
      behind = behind && dot_of(v, n) <= 8 + angle * length_of(v);
    }
  }
  return behind;
}

// The same at p or, where p is at an end of an edge of the triangle, along that edge. A point is within 4 LSB of its place, so
// a corner that is near may be meant or not.
static bool surface_has_near(const near_surface *near, uint32_t number, dvec p, dvec n, bool two_sided, double angle) {
  if (surface_has(near, p, n, two_sided, 8, angle) || surface_has(near, p, n, two_sided, 1, angle)) {
    return true;
  }
  for (unsigned i = 0; i < near->count; i++) {
    for (int k = 0; k < 3 && near->triangle[i].number == number; k++) {
      const gjk_vec3 *a = &near->triangle[i].world[k], *b = &near->triangle[i].world[(k + 1) % 3];
      const near_triangle edge = {0, {*a, *b, *a}, {0, 0, 0}};
      const dvec middle = add_scaled(of_vec3(a), 0.5, minus(of_vec3(b), of_vec3(a)));
      if (distance_from(&edge, p) <= 8 && surface_has(near, middle, n, two_sided, 1, angle)) {
        return true;
      }
    }
  }
  return false;
}

#endif
