// Are given faces the surface of a hull? One fault after the other, each by integers alone.
//
// Faces without a fault are the surface, once: each lies in it, since no vertex is beyond its plane. They close: each
// edge has its opposite. So they cover the surface, each place equally often. At an extreme vertex they go once around,
// so they cover it once.
#include "gjk_hull_grow.h"

typedef struct face_check {
  const gjk_vec3 *vertex;
  const gjk_hull_faces *faces;
  gjk_hull_report *report;
} face_check;

// A face's first corner in the list, and how many it has.
static uint16_t face_begin(const gjk_hull_faces *faces, uint16_t face) {
  return face == 0 ? 0 : faces->end[face - 1];
}

static uint16_t face_corners(const gjk_hull_faces *faces, uint16_t face) {
  return (uint16_t)(faces->end[face] - face_begin(faces, face));
}

// A corner of a face, counted around it. Pre: corner is less than twice the number of corners.
static const gjk_vec3 *face_corner(const face_check *c, uint16_t face, uint32_t corner) {
  const uint32_t corners = face_corners(c->faces, face);
  return &c->vertex[c->faces->corner[face_begin(c->faces, face) + (corner < corners ? corner : corner - corners)]];
}

static bool report_fault(const face_check *c, gjk_hull_fault fault, uint16_t face, uint32_t corner) {
  c->report->fault = (uint8_t)fault;
  c->report->face = face;
  c->report->corner = (uint16_t)corner;
  return true;
}

static bool has_few_corners(const face_check *c) {
  for (uint16_t face = 0; face < c->faces->count; face++) {
    const uint16_t first = face_begin(c->faces, face);
    if (c->faces->end[face] < first || c->faces->end[face] - first < 3) {
      return report_fault(c, GJK_HULL_FEW, face, 0);
    }
  }
  return c->faces->count == 0 && report_fault(c, GJK_HULL_FEW, 0, 0);
}

static bool has_wrong_number(const face_check *c, uint16_t count) {
  for (uint16_t face = 0; face < c->faces->count; face++) {
    const uint16_t first = face_begin(c->faces, face);
    for (uint16_t i = 0; i < face_corners(c->faces, face); i++) {
      if (c->faces->corner[first + i] >= count) {
        return report_fault(c, GJK_HULL_NUMBER, face, i);
      }
    }
  }
  return false;
}

// Vertices are at most 2^29 apart along each axis, so below 2^30 apart: |n| < 2^60, |n . v| < 2^90.
static void set_normal(const face_check *c, uint16_t face, uint32_t i, uint32_t j, uint32_t k, gjk_long3 *n) {
  gjk_triangle_normal(face_corner(c, face, i), face_corner(c, face, j), face_corner(c, face, k), n);
}

static bool is_null(const gjk_long3 *n) {
  return n->x == 0 && n->y == 0 && n->z == 0;
}

static int side_of_face(const gjk_long3 *n, const gjk_vec3 *at, const gjk_vec3 *p) {
  const gjk_vec3 v = gjk_sub(*p, *at);
  return gjk_dot_sign(n, &v);
}

static bool has_bent_face(const face_check *c) {
  for (uint16_t face = 0; face < c->faces->count; face++) {
    gjk_long3 n;
    set_normal(c, face, 0, 1, 2, &n);
    for (uint32_t i = 3; i < face_corners(c->faces, face); i++) {
      if (side_of_face(&n, face_corner(c, face, 0), face_corner(c, face, i)) != 0) {
        return report_fault(c, GJK_HULL_BENT, face, i);
      }
    }
  }
  return false;
}

// Do two normals of one plane, either of them perhaps 0, point the same way?
static bool point_alike(const gjk_long3 *n, const gjk_long3 *m) {
  const int64_t of_n = n->x != 0 ? n->x : n->y != 0 ? n->y : n->z, of_m = n->x != 0 ? m->x : n->y != 0 ? m->y : m->z;
  return !is_null(n) && of_m != 0 && (of_n > 0) == (of_m > 0);
}

// A polygon is convex, and goes once around, if it turns the same way at each corner and seen from its first one.
static bool has_wrong_turn(const face_check *c) {
  for (uint16_t face = 0; face < c->faces->count; face++) {
    gjk_long3 n;
    set_normal(c, face, 0, 1, 2, &n);
    const uint32_t corners = face_corners(c->faces, face);
    for (uint32_t i = 0; i < corners; i++) {
      gjk_long3 at, fan;
      set_normal(c, face, i + corners - 1, i, i + 1, &at);
      set_normal(c, face, 0, i, i + 1, &fan);
      if (!point_alike(&n, &at) || (i >= 1 && i + 1 < corners && !point_alike(&n, &fan))) {
        return report_fault(c, GJK_HULL_TURN, face, i);
      }
    }
  }
  return false;
}

static bool has_vertex_beyond(const face_check *c, uint16_t count) {
  for (uint16_t face = 0; face < c->faces->count; face++) {
    gjk_long3 n;
    set_normal(c, face, 0, 1, 2, &n);
    for (uint16_t i = 0; i < count; i++) {
      if (side_of_face(&n, face_corner(c, face, 0), &c->vertex[i]) > 0) {
        c->report->vertex = i;
        return report_fault(c, GJK_HULL_BEYOND, face, 0);
      }
    }
  }
  return false;
}

// Repeated vertices are the same place.
static bool same_place(const gjk_vec3 *a, const gjk_vec3 *b) {
  return a->x == b->x && a->y == b->y && a->z == b->z;
}

// How many faces have an edge from a to b. *face, *corner: where the last of them has it.
static uint32_t count_edges(const face_check *c, const gjk_vec3 *a, const gjk_vec3 *b, uint16_t *face,
                            uint32_t *corner) {
  uint32_t found = 0;
  for (uint16_t f = 0; f < c->faces->count; f++) {
    for (uint32_t i = 0; i < face_corners(c->faces, f); i++) {
      if (same_place(face_corner(c, f, i), a) && same_place(face_corner(c, f, i + 1), b)) {
        found++;
        *face = f;
        *corner = i;
      }
    }
  }
  return found;
}

// Has an edge no opposite one, or, asked for doubled ones, has another face the same?
static bool has_edge_fault(const face_check *c, gjk_hull_fault kind) {
  for (uint16_t face = 0; face < c->faces->count; face++) {
    for (uint32_t i = 0; i < face_corners(c->faces, face); i++) {
      const gjk_vec3 *a = face_corner(c, face, i), *b = face_corner(c, face, i + 1);
      uint16_t other;
      uint32_t at;
      if (kind == GJK_HULL_OPEN ? count_edges(c, b, a, &other, &at) == 0 : count_edges(c, a, b, &other, &at) > 1) {
        return report_fault(c, kind, face, i);
      }
    }
  }
  return false;
}

// How many corners of faces are at a vertex.
static uint32_t corners_there(const face_check *c, const gjk_vec3 *vertex) {
  uint32_t found = 0;
  for (uint16_t f = 0; f < c->faces->count; f++) {
    for (uint32_t i = 0; i < face_corners(c->faces, f); i++) {
      found += same_place(face_corner(c, f, i), vertex) ? 1u : 0u;
    }
  }
  return found;
}

// Goes around a corner's vertex, from face to face. Pre: each edge has one opposite.
static bool has_layers_at(const face_check *c, uint16_t face, uint32_t corner) {
  const gjk_vec3 *vertex = face_corner(c, face, corner);
  const uint32_t all = corners_there(c, vertex);
  uint16_t f = face;
  uint32_t i = corner;
  for (uint32_t around = 1; around <= all; around++) {
    count_edges(c, vertex, face_corner(c, f, i + face_corners(c->faces, f) - 1u), &f, &i);
    if (f == face && i == corner) {
      return around != all;
    }
  }
  return true;  // not reached: each edge has one opposite, so the way around returns to where it began
}

static bool has_layers(const face_check *c) {
  for (uint16_t face = 0; face < c->faces->count; face++) {
    for (uint32_t i = 0; i < face_corners(c->faces, face); i++) {
      if (has_layers_at(c, face, i)) {
        return report_fault(c, GJK_HULL_LAYERS, face, i);
      }
    }
  }
  return false;
}

gjk_status gjk_hull_check(const gjk_vec3 *vertices, uint16_t count, const gjk_hull_faces *faces, gjk_hull_report *out) {
  if (vertices == NULL || faces == NULL || out == NULL ||
      (faces->count > 0 && (faces->corner == NULL || faces->end == NULL))) {
    return GJK_ERROR_NULL;
  }
  if (count == 0) {
    return GJK_ERROR_EMPTY;
  }
  if (!gjk_hull_fits(vertices, count)) {
    return GJK_ERROR_SIZE;
  }
  const face_check c = {vertices, faces, out};
  out->fault = GJK_HULL_SOUND;
  out->face = out->corner = out->vertex = 0;
  if (!has_few_corners(&c) && !has_wrong_number(&c, count) && !has_bent_face(&c) && !has_wrong_turn(&c) &&
      !has_vertex_beyond(&c, count) && !has_edge_fault(&c, GJK_HULL_OPEN) && !has_edge_fault(&c, GJK_HULL_DOUBLED)) {
    (void)has_layers(&c);
  }
  return GJK_OK;
}
