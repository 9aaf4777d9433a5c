// The hull of EPA. A face is seen by a vertex that lies strictly beyond its plane. To add a vertex:
//
//   Step 1   Mark the faces that it sees, starting from one that is known, across their edges. They form a list.
//   Step 2   Find an edge of the horizon: between a seen face and one that is not.
//   Step 3   Walk the horizon once around. Write the corner and the unseen face of each edge into the free cells.
//   Step 4   Make a face from each edge of the horizon to the vertex, in the cells of the seen faces and two more.
//
// After   Gino van den Bergen, Proximity Queries and Penetration Depth Computation on 3D Game Objects, 2001, and the
//         incremental convex hull of Clarkson and Shor 1989. Departures: visibility is an exact sign. So the hull stays
//         convex and closed, no face is degenerate, and the seen faces form one patch with one cycle of edges around
//         it. A vertex in the plane of a face does not see the face, so that all faces of one plane agree.
#include "gjk_epa_hull.h"

// In height_key: marks a face that the new vertex sees. The low 16 bits are then the next face of the list, or NONE.
// ON_HORIZON marks its edges that are on the horizon.
#define SEEN (UINT32_C(1) << 31)
#define ON_HORIZON(edge) (UINT32_C(1) << 16 << (edge))
#define NONE UINT16_C(0xFFFF)

// Faces are numbered below this.
#define FACES_MAX 32764

void gjk_epa_hull_load(const gjk_epa_hull *p, uint16_t vertex, gjk_vertex *out) {
  const gjk_epa_cell *cell = &p->cells[vertex];
  out->w = cell->vertex.w;
  out->a.vertex = cell->vertex.a;
  out->b = cell->vertex.b;
  if (p->stride == 2) {
    out->a.offset = cell[1].vertex.w;
  }
}

static void store_vertex(gjk_epa_hull *p, const gjk_vertex *v) {
  gjk_epa_cell *cell = &p->cells[p->used];
  cell->vertex.w = v->w;
  cell->vertex.a = v->a.vertex;
  cell->vertex.b = v->b;
  if (p->stride == 2) {
    cell[1].vertex.w = v->a.offset;
  }
  p->used = (uint16_t)(p->used + p->stride);
}

void gjk_epa_hull_normal(const gjk_epa_hull *p, const uint16_t corner[3], gjk_long3 *n) {
  gjk_triangle_normal(gjk_epa_hull_vertex(p, corner[0]), gjk_epa_hull_vertex(p, corner[1]),
                      gjk_epa_hull_vertex(p, corner[2]), n);
}

// The outward normal of a face: the one that is kept, or computed in room.
static const gjk_long3 *face_normal(const gjk_epa_hull *p, uint16_t face, gjk_long3 *room) {
#if GJK_EPA_PLANES
  if (face < GJK_EPA_PLANES) {
    return &p->plane[face].normal;
  }
#endif
  gjk_epa_hull_normal(p, gjk_epa_hull_face(p, face)->corner, room);
  return room;
}

void gjk_epa_hull_plane(const gjk_epa_hull *p, uint16_t face, gjk_long3 *normal, gjk_search_direction *direction) {
#if GJK_EPA_PLANES
  if (face < GJK_EPA_PLANES) {
    *normal = p->plane[face].normal;
    *direction = p->plane[face].direction;
    return;
  }
#endif
  gjk_epa_hull_normal(p, gjk_epa_hull_face(p, face)->corner, normal);
  gjk_search_direction_of(normal, direction);
}

// Where the plane of a face goes: where it is kept, or to room.
static gjk_epa_plane *place_of_plane(gjk_epa_hull *p, uint16_t face, gjk_epa_plane *room) {
#if GJK_EPA_PLANES
  room->direction.d.x = room->direction.d.y = room->direction.d.z = 0;  // as an analyser sees it, they may stay unset
  return face < GJK_EPA_PLANES ? &p->plane[face] : room;
#else
  (void)p;
  (void)face;
  return room;
#endif
}

// Rounds the normal of the face's plane, which goes through v, and sets its height key.
GJK_ONCE static void measure_plane(gjk_epa_face *f, gjk_epa_plane *plane, const gjk_vec3 *v) {
  const gjk_vec3 *d = &plane->direction.d;
  gjk_search_direction_of(&plane->normal, &plane->direction);
  f->height_key = gjk_height_key(gjk_dot(d, v), gjk_dot(d, d));
}

// Sets the plane and the height key of a face by its corners.
static void measure_face(gjk_epa_hull *p, uint16_t face) {
  gjk_epa_face *f = gjk_epa_hull_face(p, face);
  gjk_epa_plane room, *plane = place_of_plane(p, face, &room);
  gjk_epa_hull_normal(p, f->corner, &plane->normal);
  measure_plane(f, plane, gjk_epa_hull_vertex(p, f->corner[0]));
}

// Does w see the face?
static bool is_beyond_face(const gjk_epa_hull *p, uint16_t face, const gjk_vec3 *w) {
  gjk_long3 room;
  const gjk_vec3 step = gjk_sub(*w, *gjk_epa_hull_vertex(p, gjk_epa_hull_face(p, face)->corner[0]));
  return gjk_dot_sign(face_normal(p, face, &room), &step) > 0;
}

bool gjk_epa_hull_start(gjk_epa_hull *p, const gjk_workspace *workspace, const gjk_simplex *tetrahedron, bool curved) {
  // Face i is opposite to vertex i. Across each of its edges lies the face opposite to its third corner. These orders
  // make the normals point outwards, since vertex 3 lies strictly beyond the others, along their normal.
  static const uint8_t corner[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  p->stride = curved ? 2 : 1;
  p->used = 0;
  p->faces = 4;
  if (workspace == NULL || workspace->cells == NULL || workspace->count < (uint32_t)4 * p->stride + 4) {
    return false;
  }
  p->cells = workspace->cells;
  p->count = workspace->count;
  p->last = &p->cells[p->count - 1];
  for (int i = 0; i < 4; i++) {
    store_vertex(p, &tetrahedron->slot[tetrahedron->order[i]]);
  }
  for (uint16_t i = 0; i < 4; i++) {
    const uint8_t *c = corner[i];
    gjk_epa_face *f = gjk_epa_hull_face(p, i);
    f->neighbour[1] = c[0];
    f->neighbour[2] = c[1];
    f->neighbour[0] = c[2];
    f->corner[0] = (uint16_t)(c[0] * p->stride);
    f->corner[1] = (uint16_t)(c[1] * p->stride);
    f->corner[2] = (uint16_t)(c[2] * p->stride);
    measure_face(p, i);
  }
  return true;
}

uint16_t gjk_epa_hull_lowest(const gjk_epa_hull *p) {
  const gjk_epa_cell *cell = p->last, *end = cell - p->faces, *lowest = cell;
#if GJK_CONDITIONAL_MOVES
  int64_t most = -(int64_t)cell->face.height_key;
  while (--cell != end) {
    const int64_t key = -(int64_t)cell->face.height_key;
    GJK_KEEP_LARGER(most, lowest, key, cell);
  }
#else
  uint32_t key = cell->face.height_key;
  while (--cell != end) {
    if (cell->face.height_key < key) {
      key = cell->face.height_key;
      lowest = cell;
    }
  }
#endif
  return (uint16_t)(p->last - lowest);
}

// Which edge of the face starts at the vertex? Pre: the vertex is a corner of the face.
static unsigned edge_from(const gjk_epa_face *f, uint16_t vertex) {
#if GJK_CONDITIONAL_MOVES
  const unsigned not_first = f->corner[0] != vertex;
  return not_first + (not_first & (unsigned)(f->corner[1] != vertex));
#else
  return f->corner[0] == vertex ? 0 : f->corner[1] == vertex ? 1 : 2;
#endif
}

// Step 1. first: a face that w sees. Returns the number of the seen faces, below FACES_MAX.
static uint32_t mark_seen_faces(gjk_epa_hull *p, uint16_t first, const gjk_vec3 *w) {
  gjk_epa_face *last = gjk_epa_hull_face(p, first);
  uint32_t seen = 1;
  last->height_key = SEEN | NONE;
  for (uint16_t face = first; face != NONE;) {  // each face joins the list once
    gjk_epa_face *f = gjk_epa_hull_face(p, face);
    for (unsigned i = 0; i < 3; i++) {
      const uint16_t next = f->neighbour[i];
      gjk_epa_face *g = gjk_epa_hull_face(p, next);
      if ((g->height_key & SEEN) == 0) {
        if (is_beyond_face(p, next, w)) {
          g->height_key = SEEN | NONE;
          last->height_key = (last->height_key & ~(uint32_t)NONE) | next;
          last = g;
          seen++;
        } else {
          f->height_key |= ON_HORIZON(i);
        }
      }
    }
    face = (uint16_t)(f->height_key & NONE);
    //@ assert face == NONE || face < p->faces;
  }
  return seen;
}

// An edge of a seen face, from corner[number] to the next corner.
typedef struct hull_edge {
  const gjk_epa_face *face;
  unsigned number;
} hull_edge;

static bool on_horizon(hull_edge e) {
  return (e.face->height_key & ON_HORIZON(e.number)) != 0;
}

// Step 2. There is such an edge, since a face is unseen: the origin lies behind or on all faces, so the vertex is not
// beyond all of them.
static hull_edge first_horizon(const gjk_epa_hull *p, uint16_t first) {
  hull_edge e = {gjk_epa_hull_face(p, first), 0};
  while (!on_horizon(e)) {  // at most three edges of each seen face
    if (e.number < 2) {
      e.number++;
    } else {
      const uint16_t next = (uint16_t)(e.face->height_key & NONE);
      //@ assert next < p->faces;
      e.face = gjk_epa_hull_face(p, next);
      e.number = 0;
    }
  }
  return e;
}

// Step 3. Returns the number of edges, at most seen faces + 2: the seen faces form a disc.
static uint32_t write_horizon(const gjk_epa_hull *p, uint16_t first, gjk_epa_cell *cells) {
  const hull_edge start = first_horizon(p, first);
  hull_edge e = start;
  uint32_t edges = 0;
  do {
    const unsigned end = gjk_next(e.number);
    const uint16_t corner = e.face->corner[end];
    //@ assert edges < 4 * (p->count - p->faces - 2 - (uint32_t)p->used - p->stride);
    cells[edges / 4].horizon.corner[edges % 4] = corner;
    cells[edges / 4].horizon.face[edges % 4] = e.face->neighbour[e.number];
    edges++;
    // The next edge starts where this one ends: turn around that corner from seen face to seen face.
    e.number = end;
    while (!on_horizon(e)) {  // at most once for each seen face
      e.face = gjk_epa_hull_face(p, e.face->neighbour[e.number]);
      e.number = edge_from(e.face, corner);
    }
  } while (e.face != start.face || e.number != start.number);
  return edges;
}

// The cell of the next new face: of *seen, the first of the seen faces, or behind the last face.
static uint16_t take_face(gjk_epa_hull *p, uint16_t *seen) {
  const uint16_t face = *seen;
  if (face == NONE) {
    return p->faces++;
  }
  *seen = (uint16_t)(gjk_epa_hull_face(p, face)->height_key & NONE);
  //@ assert *seen == NONE || *seen < p->faces;
  return face;
}

// Step 4: the faces, each between its neighbours. seen: the first of the seen faces. A vertex all of whose faces were
// seen is left inside the hull; the new faces are then fewer, and seen faces may stay behind: they count as settled.
static void connect_horizon(gjk_epa_hull *p, uint16_t seen, uint32_t edges, const gjk_epa_cell *cells) {
  const uint16_t top = (uint16_t)(p->used - p->stride), first = seen;
  uint16_t before = NONE, start = cells[(edges - 1) / 4].horizon.corner[(edges - 1) % 4];
  for (uint32_t i = 0; i < edges; i++) {
    const uint16_t end = cells[i / 4].horizon.corner[i % 4], outer = cells[i / 4].horizon.face[i % 4];
    const uint16_t face = take_face(p, &seen);
    //@ assert p->faces <= p->count - p->used - (edges + 3) / 4;
    gjk_epa_face *f = gjk_epa_hull_face(p, face), *g = gjk_epa_hull_face(p, outer);
    g->neighbour[edge_from(g, end)] = face;
    f->corner[0] = start;
    f->corner[1] = end;
    f->corner[2] = top;
    f->neighbour[0] = outer;
    f->neighbour[2] = before;
    if (before != NONE) {
      gjk_epa_hull_face(p, before)->neighbour[1] = face;
    }
    start = end;
    before = face;
  }
  gjk_epa_hull_face(p, first)->neighbour[2] = before;
  gjk_epa_hull_face(p, before)->neighbour[1] = first;
  while (seen != NONE) {  // at most the seen faces
    gjk_epa_face *unused = gjk_epa_hull_face(p, seen);
    seen = (uint16_t)(unused->height_key & NONE);
    //@ assert seen == NONE || seen < p->faces;
    unused->height_key = GJK_HEIGHT_KEY_SETTLED;
  }
}

// Step 4: their planes. Relative to the new vertex w, which all of them share, a face's normal is the product of its
// other corners, and the second of these is the first of the next face.
static void measure_new_faces(gjk_epa_hull *p, uint16_t face, uint32_t edges, const gjk_vec3 *w) {
#if GJK_SMALL
  (void)w;
  for (uint32_t i = 0; i < edges; i++) {
    measure_face(p, face);
    face = gjk_epa_hull_face(p, face)->neighbour[1];
    //@ assert face < p->faces;
  }
#else
  const gjk_vec3 *u = gjk_epa_hull_vertex(p, gjk_epa_hull_face(p, face)->corner[0]);
  gjk_vec3 a = gjk_sub(*u, *w);
  for (uint32_t i = 0; i < edges; i++) {
    gjk_epa_plane room, *plane = place_of_plane(p, face, &room);
    gjk_epa_face *f = gjk_epa_hull_face(p, face);
    const gjk_vec3 *v = gjk_epa_hull_vertex(p, f->corner[1]), b = gjk_sub(*v, *w);
    gjk_cross(&a, &b, &plane->normal);
    measure_plane(f, plane, u);
    u = v;
    a = b;
    face = f->neighbour[1];
    //@ assert face < p->faces;
  }
#endif
}

bool gjk_epa_hull_add(gjk_epa_hull *p, uint16_t face, const gjk_vertex *vertex) {
  const uint32_t used = (uint32_t)p->used + p->stride;  // cells of vertices
  const uint32_t most = used + p->faces + 2u;           // and of faces
  if (most > p->count || p->faces + 2u > FACES_MAX) {
    return false;
  }
  const uint32_t seen = mark_seen_faces(p, face, &vertex->w);
  if (most + (seen + 5) / 4 > p->count) {  // four of at most seen + 2 edges in a cell, rounded up
    return false;
  }
  gjk_epa_cell *horizon = &p->cells[used];
  const uint32_t edges = write_horizon(p, face, horizon);
  store_vertex(p, vertex);
  connect_horizon(p, face, edges, horizon);
  measure_new_faces(p, face, edges, &vertex->w);
  return true;
}
