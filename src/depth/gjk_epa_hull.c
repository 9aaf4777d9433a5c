// The expanding polytope.
//
// After   Gino van den Bergen, Proximity Queries and Penetration Depth Computation on 3D Game Objects, 2001, and the
//         incremental convex hull of Clarkson and Shor 1989. Departures: visibility is an exact sign, so the hull stays
//         convex and closed, no face is degenerate, and the seen faces always form one patch with one cycle of edges
//         around it: a vertex in the plane of a face does not see it, and all faces of one plane agree.
#include "gjk_epa_hull.h"

// Marks a face that a new vertex sees; the low 16 bits then name the next such face.
#define SEEN (UINT32_C(1) << 31)
#define NONE UINT16_C(0xFFFF)

// Faces are numbered below this.
#define FACES_MAX 32764

void gjk_epa_hull_load(const gjk_epa_hull *p, uint16_t vertex, gjk_vertex *out) {
  const gjk_epa_cell *cell = &p->cells[(uint32_t)vertex * p->stride];
  out->w = cell->vertex.w;
  out->a.vertex = cell->vertex.a;
  out->b = cell->vertex.b;
  if (p->stride == 2) {
    out->a.offset = cell[1].vertex.w;
  }
}

static void store_vertex(gjk_epa_hull *p, const gjk_vertex *v) {
  gjk_epa_cell *cell = &p->cells[(uint32_t)p->vertices * p->stride];
  cell->vertex.w = v->w;
  cell->vertex.a = v->a.vertex;
  cell->vertex.b = v->b;
  if (p->stride == 2) {
    cell[1].vertex.w = v->a.offset;
  }
  p->vertices++;
}

void gjk_epa_hull_normal(const gjk_epa_hull *p, const uint16_t corner[3], gjk_long3 *n) {
  gjk_triangle_normal(gjk_epa_hull_vertex(p, corner[0]), gjk_epa_hull_vertex(p, corner[1]),
                      gjk_epa_hull_vertex(p, corner[2]), n);
}

static void set_face(gjk_epa_hull *p, uint16_t face, uint16_t u, uint16_t v, uint16_t w) {
  gjk_epa_face *f = gjk_epa_hull_face(p, face);
  gjk_long3 n;
  gjk_search_direction d;
  f->corner[0] = u;
  f->corner[1] = v;
  f->corner[2] = w;
  gjk_epa_hull_normal(p, f->corner, &n);
  gjk_search_direction_of(&n, &d);
  f->height_key = gjk_height_key(gjk_dot(&d.d, gjk_epa_hull_vertex(p, u)), gjk_dot(&d.d, &d.d));
}

// Does w lie strictly beyond the face?
static bool sees(const gjk_epa_hull *p, const gjk_epa_face *f, const gjk_vec3 *w) {
  gjk_long3 n;
  const gjk_vec3 step = gjk_sub(*w, *gjk_epa_hull_vertex(p, f->corner[0]));
  gjk_epa_hull_normal(p, f->corner, &n);
  return gjk_dot_sign(&n, &step) > 0;
}

bool gjk_epa_hull_start(gjk_epa_hull *p, const gjk_workspace *workspace, const gjk_simplex *tetrahedron, bool curved) {
  // Face i leaves out vertex i; across its edges lie the faces that leave out the third corner of each. They look
  // outwards: vertex 3 was added strictly beyond the others, along their normal.
  static const uint8_t corner[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  p->stride = curved ? 2 : 1;
  p->vertices = 0;
  p->faces = 4;
  if (workspace == NULL || workspace->cells == NULL || workspace->count < (uint32_t)4 * p->stride + 4) {
    return false;
  }
  p->cells = workspace->cells;
  p->count = workspace->count;
  for (int i = 0; i < 4; i++) {
    store_vertex(p, &tetrahedron->slot[tetrahedron->order[i]]);
  }
  for (uint16_t i = 0; i < 4; i++) {
    const uint8_t *c = corner[i];
    gjk_epa_face *f = gjk_epa_hull_face(p, i);
    set_face(p, i, c[0], c[1], c[2]);
    f->neighbour[0] = f->corner[2];
    f->neighbour[1] = f->corner[0];
    f->neighbour[2] = f->corner[1];
  }
  return true;
}

uint16_t gjk_epa_hull_lowest(const gjk_epa_hull *p) {
  const gjk_epa_cell *cell = &p->cells[p->count - 1], *end = cell - p->faces, *lowest = cell;
  uint32_t key = cell->face.height_key;
  while (--cell != end) {
    if (cell->face.height_key < key) {
      key = cell->face.height_key;
      lowest = cell;
    }
  }
  return (uint16_t)(&p->cells[p->count - 1] - lowest);
}

// Which edge of the face starts at the vertex, that being a corner of it?
static unsigned edge_from(const gjk_epa_face *f, uint16_t vertex) {
  return f->corner[0] == vertex ? 0 : f->corner[1] == vertex ? 1 : 2;
}

static bool is_seen(const gjk_epa_hull *p, uint16_t face) {
  return (gjk_epa_hull_face(p, face)->height_key & SEEN) != 0;
}

// Marks all faces that w sees, from the first on, and links them. Returns their number, which is below FACES_MAX.
static uint32_t mark_seen(gjk_epa_hull *p, uint16_t first, const gjk_vec3 *w) {
  uint16_t last = first;
  uint32_t seen = 1;
  gjk_epa_hull_face(p, first)->height_key = SEEN | NONE;
  for (uint16_t face = first; face != NONE;) {  // each face joins the list once
    gjk_epa_face *f = gjk_epa_hull_face(p, face);
    for (int i = 0; i < 3; i++) {
      const uint16_t next = f->neighbour[i];
      gjk_epa_face *g = gjk_epa_hull_face(p, next);
      if ((g->height_key & SEEN) == 0 && sees(p, g, w)) {
        g->height_key = SEEN | NONE;
        gjk_epa_hull_face(p, last)->height_key = SEEN | next;
        last = next;
        seen++;
      }
    }
    face = (uint16_t)(f->height_key & NONE);
    //@ assert face == NONE || face < p->faces;
  }
  return seen;
}

// An edge of a seen face, from its corner to the next.
typedef struct hull_edge {
  uint16_t face;
  uint8_t number;
} hull_edge;

static bool on_horizon(const gjk_epa_hull *p, hull_edge e) {
  return !is_seen(p, gjk_epa_hull_face(p, e.face)->neighbour[e.number]);
}

// Any edge between the seen faces and the rest. At least one face is unseen: the origin lies behind all of them or on
// some, and the vertex beyond; so there is one.
static hull_edge first_horizon(const gjk_epa_hull *p, uint16_t first) {
  hull_edge e = {first, 0};
  while (!on_horizon(p, e)) {  // at most three edges of each seen face
    if (e.number < 2) {
      e.number++;
    } else {
      e.face = (uint16_t)(gjk_epa_hull_face(p, e.face)->height_key & NONE);
      //@ assert e.face < p->faces;
      e.number = 0;
    }
  }
  return e;
}

// The horizon's edge that starts where e ends: around that vertex from seen face to seen face.
static hull_edge next_horizon(const gjk_epa_hull *p, hull_edge e) {
  e.number = (uint8_t)gjk_next(e.number);
  const uint16_t vertex = gjk_epa_hull_face(p, e.face)->corner[e.number];
  while (!on_horizon(p, e)) {  // at most once for each seen face
    e.face = gjk_epa_hull_face(p, e.face)->neighbour[e.number];
    e.number = (uint8_t)edge_from(gjk_epa_hull_face(p, e.face), vertex);
  }
  return e;
}

// Writes the corner and the unseen face of each edge of the horizon, in order, into the cells. Returns their number, at
// most seen + 2: the seen faces form a disc.
static uint32_t write_horizon(const gjk_epa_hull *p, uint16_t first, gjk_epa_cell *cells) {
  const hull_edge start = first_horizon(p, first);
  hull_edge e = start;
  uint32_t edges = 0;
  do {
    const gjk_epa_face *f = gjk_epa_hull_face(p, e.face);
    //@ assert edges < 4 * (p->count - p->faces - 2 - (p->vertices + (uint32_t)1) * p->stride);
    cells[edges / 4].horizon.corner[edges % 4] = f->corner[e.number];
    cells[edges / 4].horizon.face[edges % 4] = f->neighbour[e.number];
    edges++;
    e = next_horizon(p, e);
  } while (e.face != start.face || e.number != start.number);
  return edges;
}

// Faces from each edge of the horizon to the newest vertex. They take the place of the seen ones and of two more; of
// fewer only when a vertex among the seen faces is left inside, and then a seen one may stay behind, unused.
static void close(gjk_epa_hull *p, uint16_t seen, uint32_t edges, const gjk_epa_cell *cells) {
  const uint16_t top = (uint16_t)(p->vertices - 1), first = seen;
  uint16_t before = NONE;
  for (uint32_t i = 0; i < edges; i++) {
    const uint32_t next = i + 1 < edges ? i + 1 : 0;
    const uint16_t corner = cells[i / 4].horizon.corner[i % 4], outer = cells[i / 4].horizon.face[i % 4];
    const uint16_t end = cells[next / 4].horizon.corner[next % 4];
    uint16_t face = seen;
    if (seen != NONE) {
      seen = (uint16_t)(gjk_epa_hull_face(p, seen)->height_key & NONE);
      //@ assert seen == NONE || seen < p->faces;
    } else {
      face = p->faces++;
      //@ assert p->faces <= p->count - (uint32_t)p->vertices * p->stride - (edges + 3) / 4;
    }
    gjk_epa_face *f = gjk_epa_hull_face(p, face), *g = gjk_epa_hull_face(p, outer);
    g->neighbour[edge_from(g, end)] = face;
    f->neighbour[0] = outer;
    f->neighbour[2] = before;
    if (before != NONE) {
      gjk_epa_hull_face(p, before)->neighbour[1] = face;
    }
    set_face(p, face, corner, end, top);
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

bool gjk_epa_hull_add(gjk_epa_hull *p, uint16_t face, const gjk_vertex *vertex) {
  const uint32_t used = (uint32_t)(p->vertices + 1u) * p->stride, most = used + p->faces + 2u;
  if (most > p->count || p->faces + 2u > FACES_MAX) {
    return false;
  }
  const uint32_t seen = mark_seen(p, face, &vertex->w);
  if (most + (seen + 5) / 4 > p->count) {
    return false;
  }
  gjk_epa_cell *horizon = &p->cells[used];
  const uint32_t edges = write_horizon(p, face, horizon);
  store_vertex(p, vertex);
  close(p, face, edges, horizon);
  return true;
}
