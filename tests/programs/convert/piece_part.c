// A piece parted into what is connected.
//
// Faces are connected that share an edge. But one face may be in several places, which may touch at a corner, and a cut through
// a tube leaves a face with a hole: so the edges of a face are first parted into loops, and holes are given to the loops around
// them. A bubble shares no edge with what is around it, and is given to that at the end.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "piece.h"

static uint32_t root_of(uint32_t *up, uint32_t i) {
  while (up[i] != i) {
    up[i] = up[up[i]];
    i = up[i];
  }
  return i;
}

static void join(uint32_t *up, uint32_t a, uint32_t b) {
  a = root_of(up, a);
  b = root_of(up, b);
  up[a > b ? a : b] = a > b ? b : a;
}

typedef struct end {
  uint64_t key;
  uint32_t edge;
} end;

static int by_key(const void *a, const void *b) {
  const end *x = a, *y = b;
  return x->key != y->key ? (x->key > y->key) - (x->key < y->key) : (x->edge > y->edge) - (x->edge < y->edge);
}

// Joins all edges with the same key.
static void join_equal(end *e, size_t count, uint32_t *up) {
  qsort(e, count, sizeof e[0], by_key);
  for (size_t i = 1; i < count; i++) {
    if (e[i].key == e[i - 1].key) {
      join(up, e[i].edge, e[i - 1].edge);
    }
  }
}

// The two axes in which a face is seen counterclockwise from outside.
static void axes_of(const solid_plane *plane, int *p, int *q) {
  int axis = 0;
  for (int i = 1; i < 3; i++) {
    axis = fabsl((long double)plane->n[i]) > fabsl((long double)plane->n[axis]) ? i : axis;
  }
  *p = plane->n[axis] >= 0 ? (axis + 1) % 3 : (axis + 2) % 3;
  *q = plane->n[axis] >= 0 ? (axis + 2) % 3 : (axis + 1) % 3;
}

typedef struct face_view {
  const piece *p;
  const piece_pool *pool;
  uint32_t *up;
  size_t begin, end;
  int x, y;
} face_view;

static long double area_of(const face_view *v, uint32_t root) {
  long double sum = 0;
  const long double *o = v->pool->at[v->p->edge[root].from];
  for (size_t i = v->begin; i < v->end; i++) {
    if (root_of(v->up, (uint32_t)i) == root) {
      const long double *a = v->pool->at[v->p->edge[i].from], *b = v->pool->at[v->p->edge[i].to];
      sum += (a[v->x] - o[v->x]) * (b[v->y] - o[v->y]) - (a[v->y] - o[v->y]) * (b[v->x] - o[v->x]);
    }
  }
  return sum;
}

// Is the middle of an edge within a loop?
static bool is_around(const face_view *v, uint32_t root, uint32_t edge) {
  const long double *c = v->pool->at[v->p->edge[edge].from], *d = v->pool->at[v->p->edge[edge].to];
  const long double x = (c[v->x] + d[v->x]) / 2, y = (c[v->y] + d[v->y]) / 2;
  bool in = false;
  for (size_t i = v->begin; i < v->end; i++) {
    if (root_of(v->up, (uint32_t)i) == root) {
      const long double *a = v->pool->at[v->p->edge[i].from], *b = v->pool->at[v->p->edge[i].to];
      if ((a[v->y] > y) != (b[v->y] > y) && x < a[v->x] + (y - a[v->y]) / (b[v->y] - a[v->y]) * (b[v->x] - a[v->x])) {
        in = !in;
      }
    }
  }
  return in;
}

// Gives each hole of a face to the least loop around it.
static void place_holes(const face_view *v) {
  for (size_t i = v->begin; i < v->end; i++) {
    if (root_of(v->up, (uint32_t)i) != i || area_of(v, (uint32_t)i) > 0) {
      continue;
    }
    long double least = INFINITY;
    uint32_t around = (uint32_t)i;
    for (size_t j = v->begin; j < v->end; j++) {
      const long double area = root_of(v->up, (uint32_t)j) == j && j != i ? area_of(v, (uint32_t)j) : 0;
      if (area > 0 && area < least && is_around(v, (uint32_t)j, (uint32_t)i)) {
        least = area;
        around = (uint32_t)j;
      }
    }
    // Joined at once: a hole does not change which loops are around others, and areas of joined loops only lose holes.
    join(v->up, (uint32_t)i, around);
  }
}

// How far an edge that ends at a corner is turned counterclockwise from one that begins there, seen from the corner.
static long double turn_of(const face_view *v, uint32_t begins, uint32_t ends) {
  const long double *at = v->pool->at[v->p->edge[begins].from], *a = v->pool->at[v->p->edge[begins].to],
                    *b = v->pool->at[v->p->edge[ends].from];
  const long double turn =
      atan2l(b[v->y] - at[v->y], b[v->x] - at[v->x]) - atan2l(a[v->y] - at[v->y], a[v->x] - at[v->x]);
  return turn > 0 ? turn : turn + 6.283185307179586477L;
}

// Joins each edge that begins at a corner with the next one that ends there: between them is the face. Takes all of one corner.
static void join_at_corner(const face_view *v, end *e, size_t count) {
  for (size_t i = 0; i < count; i++) {
    if (v->p->edge[e[i].edge].from == e[i].key) {
      size_t next = count;
      for (size_t j = 0; j < count; j++) {
        const bool ends = e[j].key == e[i].key && v->p->edge[e[j].edge].to == e[i].key;
        if (ends && (next == count || turn_of(v, e[i].edge, e[j].edge) < turn_of(v, e[i].edge, e[next].edge))) {
          next = j;
        }
      }
      if (next < count) {
        join(v->up, e[i].edge, e[next].edge);
        e[next].key = UINT64_MAX;  // taken
      }
    }
  }
}

static void part_faces(const piece *p, const piece_pool *pool, uint32_t *up) {
  end *e = solid_allocate(2 * p->edges, sizeof e[0]);
  for (size_t i = 0, next; i < p->edges; i = next) {
    size_t count = 0;
    for (next = i; next < p->edges && p->edge[next].face == p->edge[i].face; next++) {
      e[count].key = p->edge[next].from;
      e[count++].edge = (uint32_t)next;
      e[count].key = p->edge[next].to;
      e[count++].edge = (uint32_t)next;
    }
    face_view v = {p, pool, up, i, next, 0, 0};
    axes_of(&p->face[p->edge[i].face], &v.x, &v.y);
    qsort(e, count, sizeof e[0], by_key);
    for (size_t first = 0, last = 0; first < count; first = last) {
      while (last < count && e[last].key == e[first].key) {
        last++;
      }
      join_at_corner(&v, e + first, last - first);
    }
    bool loops = false;
    for (size_t j = i; j < next && !loops; j++) {
      loops = root_of(up, (uint32_t)j) != root_of(up, (uint32_t)i);
    }
    if (loops) {
      place_holes(&v);
    }
  }
  free(e);
}

// The edges with a root, as a piece.
static piece gather(const piece *p, uint32_t *up, const uint32_t *face, uint32_t root) {
  piece one = {NULL, NULL, 0, 0};
  size_t room = 0, faces = 0;
  uint32_t last = UINT32_MAX;
  for (size_t i = 0; i < p->edges; i++) {
    if (root_of(up, (uint32_t)i) != root) {
      continue;
    }
    if (face[i] != last) {
      last = face[i];
      if (one.faces == faces) {
        one.face = solid_grow(one.face, &faces, sizeof one.face[0]);
      }
      one.face[one.faces++] = p->face[p->edge[i].face];
    }
    if (one.edges == room) {
      one.edge = solid_grow(one.edge, &room, sizeof one.edge[0]);
    }
    one.edge[one.edges] = p->edge[i];
    one.edge[one.edges++].face = (uint32_t)(one.faces - 1);
  }
  return one;
}

static long double dot(const long double a[3], const long double b[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// How often a piece winds around a point, about: the sum of its triangles' solid angles.
static long double winding(const piece *p, const piece_pool *pool, const long double x[3]) {
  long double sum = 0;
  for (size_t i = 0, first = 0; i < p->edges; i++) {
    first = p->edge[i].face == p->edge[first].face ? first : i;
    const uint32_t corner[3] = {p->edge[first].from, p->edge[i].from, p->edge[i].to};
    long double v[3][3], length[3];
    for (int n = 0; n < 3; n++) {
      for (int j = 0; j < 3; j++) {
        v[n][j] = pool->at[corner[n]][j] - x[j];
      }
      length[n] = sqrtl(dot(v[n], v[n]));
    }
    const long double volume = v[0][0] * (v[1][1] * v[2][2] - v[1][2] * v[2][1]) +
                               v[0][1] * (v[1][2] * v[2][0] - v[1][0] * v[2][2]) +
                               v[0][2] * (v[1][0] * v[2][1] - v[1][1] * v[2][0]);
    const long double rest = length[0] * length[1] * length[2] + dot(v[0], v[1]) * length[2] +
                             dot(v[1], v[2]) * length[0] + dot(v[2], v[0]) * length[1];
    sum += 2 * atan2l(volume, rest);
  }
  return sum / 12.566370614359172953L;
}

static void append(piece *to, piece *from) {
  to->edge = realloc(to->edge, (to->edges + from->edges) * sizeof to->edge[0]);
  to->face = realloc(to->face, (to->faces + from->faces) * sizeof to->face[0]);
  if (to->edge == NULL || to->face == NULL) {
    abort();
  }
  for (size_t i = 0; i < from->edges; i++) {
    from->edge[i].face += (uint32_t)to->faces;
  }
  memcpy(to->edge + to->edges, from->edge, from->edges * sizeof to->edge[0]);
  memcpy(to->face + to->faces, from->face, from->faces * sizeof to->face[0]);
  to->edges += from->edges;
  to->faces += from->faces;
  piece_free(from);
}

// Puts bubbles, whose faces look inwards, into the least piece around them. first: where the pieces begin.
static void place_bubbles(piece_list *out, size_t first, const piece_pool *pool) {
  for (size_t i = first; i < out->count;) {
    size_t around = out->count;
    long double least = INFINITY;
    if (out->count - first > 1 && piece_volume6(&out->item[i], pool) < 0) {
      for (size_t j = first; j < out->count; j++) {
        const long double volume = piece_volume6(&out->item[j], pool);
        if (j != i && volume > 0 && volume < least &&
            winding(&out->item[j], pool, pool->at[out->item[i].edge[0].from]) > 0.4L) {
          least = volume;
          around = j;
        }
      }
    }
    if (around < out->count) {
      append(&out->item[around], &out->item[i]);
      memmove(&out->item[i], &out->item[i + 1], (--out->count - i) * sizeof out->item[0]);
    } else {
      i++;
    }
  }
}

typedef struct by_face {
  uint32_t face;
  piece_edge edge;
} by_face;

static int in_face_order(const void *a, const void *b) {
  const by_face *x = a, *y = b;
  return (x->face > y->face) - (x->face < y->face);
}

void piece_part(const piece *p, const piece_pool *pool, piece_list *out) {
  const size_t first = out->count;
  uint32_t *up = solid_allocate(p->edges, sizeof up[0]);
  for (size_t i = 0; i < p->edges; i++) {
    up[i] = (uint32_t)i;
  }
  part_faces(p, pool, up);
  // Loops of one face become faces of their own, in order.
  piece q = {solid_allocate(p->edges, sizeof q.edge[0]), p->face, p->edges, p->faces};
  by_face *sorted = solid_allocate(p->edges, sizeof sorted[0]);
  uint32_t *face = solid_allocate(p->edges, sizeof face[0]);
  for (size_t i = 0; i < p->edges; i++) {
    sorted[i].face = root_of(up, (uint32_t)i);
    sorted[i].edge = p->edge[i];
  }
  qsort(sorted, p->edges, sizeof sorted[0], in_face_order);
  for (size_t i = 0; i < p->edges; i++) {
    q.edge[i] = sorted[i].edge;
    face[i] = sorted[i].face;
    up[i] = (uint32_t)i;
  }
  for (size_t i = 1; i < p->edges; i++) {
    if (face[i] == face[i - 1]) {
      join(up, (uint32_t)i, (uint32_t)i - 1);
    }
  }
  end *e = solid_allocate(p->edges, sizeof e[0]);
  for (size_t i = 0; i < p->edges; i++) {
    const uint64_t a = q.edge[i].from, b = q.edge[i].to;
    e[i].key = a < b ? a << 32 | b : b << 32 | a;
    e[i].edge = (uint32_t)i;
  }
  join_equal(e, p->edges, up);
  for (size_t i = 0; i < p->edges; i++) {
    if (root_of(up, (uint32_t)i) == i) {
      piece_list_add(out, gather(&q, up, face, (uint32_t)i));
    }
  }
  place_bubbles(out, first, pool);
  free(e);
  free(face);
  free(sorted);
  free(up);
  free(q.edge);
}

piece piece_from_faces(const int32_t (*point)[3], unsigned points, const uint16_t *corner, const uint16_t *face_end,
                       const solid_plane *plane, unsigned faces, piece_pool *pool) {
  const size_t edges = faces > 0 ? face_end[faces - 1] : 0;
  piece p = {solid_allocate(edges, sizeof p.edge[0]), solid_allocate(faces, sizeof p.face[0]), edges, faces};
  memset(pool, 0, sizeof *pool);
  pool->at = solid_allocate(points, sizeof pool->at[0]);
  pool->count = pool->room = points;
  for (unsigned i = 0; i < points; i++) {
    for (int j = 0; j < 3; j++) {
      pool->at[i][j] = point[i][j];
    }
  }
  for (unsigned f = 0, begin = 0; f < faces; begin = face_end[f++]) {
    p.face[f] = plane[f];
    for (unsigned i = begin; i < face_end[f]; i++) {
      const piece_edge edge = {corner[i], corner[i + 1 < face_end[f] ? i + 1 : begin], f};
      p.edge[i] = edge;
    }
  }
  return p;
}

// How far a piece reaches beyond a plane, and behind it.
static void heights_of(const piece *p, const piece_pool *pool, const solid_plane *plane, long double *beyond,
                       long double *behind) {
  *beyond = *behind = 0;
  for (size_t i = 0; i < p->edges; i++) {
    const long double h = piece_height(plane, pool->at[p->edge[i].from]);
    *beyond = fmaxl(*beyond, h);
    *behind = fmaxl(*behind, -h);
  }
}

long double piece_volume6_behind(piece p, const solid_plane *plane, unsigned planes, piece_pool *pool) {
  const long double slack = 0x1p-10L;
  for (unsigned i = 0; i < planes; i++) {
    long double beyond, behind;
    piece_list half = {NULL, 0, 0};
    heights_of(&p, pool, &plane[i], &beyond, &behind);
    if (beyond <= slack) {
      continue;
    }
    if (behind > slack) {
      piece_cut(&p, &plane[i], slack, pool, &half);
    }
    piece_free(&p);
    for (size_t n = 0; n < half.count; n++) {
      heights_of(&half.item[n], pool, &plane[i], &beyond, &behind);
      if (behind > beyond && p.edges == 0) {
        p = half.item[n];
        memset(&half.item[n], 0, sizeof half.item[n]);
      }
    }
    piece_list_free(&half);
    if (p.edges == 0) {
      return 0;
    }
  }
  const long double volume6 = piece_volume6(&p, pool);
  piece_free(&p);
  return fmaxl(volume6, 0);
}
