// Are given faces the surface of a hull? One fault after the other, each by integers alone.
//
// Faces without a fault are the surface, once:
//
//   1. Each lies in it, since no vertex is beyond its plane, and turns counterclockwise.
//   2. Each edge has one opposite edge, so faces join to closed surfaces. Across an edge they go on in the hull's surface.
//      Points in a plane have a surface of two sides, which meet at the outline alone: elsewhere an edge's opposite is on
//      its own side.
//   3. So a closed surface covers the hull's surface k times, and turns k times around each extreme vertex, if one way
//      around passes all corners there. All such surfaces meet there, so there is one.
//   4. Its Euler characteristic is at most 2 k - e (k - 1) with e extreme vertices (Riemann and Hurwitz). Since e is at least
//      three, it is 2 for k = 1 alone.
#include "gjk_hull_grow.h"

typedef struct face_check {
  const gjk_vec3 *vertex;
  const gjk_hull_faces *faces;
  gjk_hull_report *report;
  uint16_t count;  // of vertices
  bool flat;       // are they all in a plane? Known once no vertex is beyond a face
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

static bool has_wrong_number(const face_check *c) {
  for (uint16_t face = 0; face < c->faces->count; face++) {
    const uint16_t first = face_begin(c->faces, face);
    for (uint16_t i = 0; i < face_corners(c->faces, face); i++) {
      if (c->faces->corner[first + i] >= c->count) {
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

static bool has_vertex_beyond(const face_check *c) {
  for (uint16_t face = 0; face < c->faces->count; face++) {
    gjk_long3 n;
    set_normal(c, face, 0, 1, 2, &n);
    for (uint16_t i = 0; i < c->count; i++) {
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

// Are all vertices in the plane of the first face?
static bool is_flat(const face_check *c) {
  gjk_long3 n;
  set_normal(c, 0, 0, 1, 2, &n);
  for (uint16_t i = 0; i < c->count; i++) {
    if (side_of_face(&n, face_corner(c, 0, 0), &c->vertex[i]) != 0) {
      return false;
    }
  }
  return true;
}

// Of points in a plane: are two faces on the same side of it? Else all are.
static bool on_same_side(const face_check *c, uint16_t f, uint16_t g) {
  gjk_long3 n, m;
  if (!c->flat || f == g) {
    return true;
  }
  set_normal(c, f, 0, 1, 2, &n);
  set_normal(c, g, 0, 1, 2, &m);
  return point_alike(&n, &m);
}

// Of points in a plane: are none of them on one side of the line through a and b? Pre: a and b are corners of face.
static bool is_on_outline(const face_check *c, uint16_t face, const gjk_vec3 *a, const gjk_vec3 *b) {
  gjk_long3 n, m;
  bool left = false, right = false;
  set_normal(c, face, 0, 1, 2, &n);
  for (uint16_t i = 0; i < c->count; i++) {
    gjk_triangle_normal(a, b, &c->vertex[i], &m);
    const bool alike = point_alike(&n, &m);
    left = left || alike;
    right = right || (!alike && !is_null(&m));
  }
  return !left || !right;
}

// A corner of a face. It begins an edge.
typedef struct face_place {
  uint16_t face;
  uint32_t corner;
} face_place;

// How many faces that may be beside a face along an edge have it from a to b. *last: where the last of them has it.
static uint32_t count_edges(const face_check *c, uint16_t beside, const gjk_vec3 *a, const gjk_vec3 *b,
                            face_place *last) {
  const bool any = !c->flat || is_on_outline(c, beside, a, b);
  uint32_t found = 0;
  for (uint16_t f = 0; f < c->faces->count; f++) {
    for (uint32_t i = 0; i < face_corners(c->faces, f); i++) {
      if (same_place(face_corner(c, f, i), a) && same_place(face_corner(c, f, i + 1), b) &&
          (any || on_same_side(c, f, beside))) {
        found++;
        last->face = f;
        last->corner = i;
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
      face_place other;
      if (kind == GJK_HULL_OPEN ? count_edges(c, face, b, a, &other) == 0 : count_edges(c, face, a, b, &other) > 1) {
        return report_fault(c, kind, face, i);
      }
    }
  }
  return false;
}

// How many corners of faces are at that of a place, on its side, or on both.
static uint32_t corners_there(const face_check *c, const face_place *place, bool both) {
  uint32_t found = 0;
  for (uint16_t f = 0; f < c->faces->count; f++) {
    for (uint32_t i = 0; i < face_corners(c->faces, f); i++) {
      found += same_place(face_corner(c, f, i), face_corner(c, place->face, place->corner)) &&
                       (both || on_same_side(c, f, place->face))
                   ? 1u
                   : 0u;
    }
  }
  return found;
}

// Is no corner before that of a place at the same vertex, on the same side?
static bool is_first_there(const face_check *c, const face_place *place) {
  for (uint16_t f = 0; f <= place->face; f++) {
    for (uint32_t i = 0; i < (f < place->face ? face_corners(c->faces, f) : place->corner); i++) {
      if (same_place(face_corner(c, f, i), face_corner(c, place->face, place->corner)) &&
          on_same_side(c, f, place->face)) {
        return false;
      }
    }
  }
  return true;
}

// Goes around a corner's vertex, from face to face. Does the way pass all corners there? *both: it passes both sides.
// Pre: each edge has one opposite, so the way returns to where it began.
static bool goes_around_all(const face_check *c, const face_place *first, bool *both) {
  const gjk_vec3 *vertex = face_corner(c, first->face, first->corner);
  const uint32_t most = corners_there(c, first, true);
  face_place at = {first->face, first->corner};
  uint32_t around = 0;
  *both = false;
  do {
    const uint32_t before = at.corner + face_corners(c->faces, at.face) - 1u;
    (void)count_edges(c, at.face, vertex, face_corner(c, at.face, before), &at);
    *both = *both || !on_same_side(c, at.face, first->face);
    around++;
  } while (around < most && (at.face != first->face || at.corner != first->corner));
  return around == corners_there(c, first, *both || !c->flat);
}

// Do the faces cover the surface more than once? Each vertex counts twice, or once for each side that it is on.
static bool has_layers(const face_check *c) {
  uint32_t twice = 0, corners = 0;  // below 2^17 and 2^16
  for (uint16_t face = 0; face < c->faces->count; face++) {
    for (uint32_t i = 0; i < face_corners(c->faces, face); i++, corners++) {
      const face_place place = {face, i};
      bool both;
      if (is_first_there(c, &place)) {
        if (!goes_around_all(c, &place, &both)) {
          return report_fault(c, GJK_HULL_LAYERS, face, i);
        }
        twice += both ? 1u : 2u;
      }
    }
  }
  // Vertices and faces less edges, of which there are half as many as corners.
  return twice + UINT32_C(2) * c->faces->count != corners + 4 && report_fault(c, GJK_HULL_LAYERS, 0, 0);
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
  face_check c = {vertices, faces, out, count, false};
  out->fault = GJK_HULL_SOUND;
  out->face = out->corner = out->vertex = 0;
  if (has_few_corners(&c) || has_wrong_number(&c) || has_bent_face(&c) || has_wrong_turn(&c) || has_vertex_beyond(&c)) {
    return GJK_OK;
  }
  c.flat = is_flat(&c);
  if (!has_edge_fault(&c, GJK_HULL_OPEN) && !has_edge_fault(&c, GJK_HULL_DOUBLED)) {
    (void)has_layers(&c);
  }
  return GJK_OK;
}
