// Pieces: cut, parted where they are not connected, measured.
#include "piece.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void piece_free(piece *p) {
  free(p->edge);
  free(p->face);
  memset(p, 0, sizeof *p);
}

void piece_list_free(piece_list *list) {
  for (size_t i = 0; i < list->count; i++) {
    piece_free(&list->item[i]);
  }
  free(list->item);
  memset(list, 0, sizeof *list);
}

void piece_list_add(piece_list *list, piece p) {
  if (list->count == list->room) {
    list->item = solid_grow(list->item, &list->room, sizeof list->item[0]);
  }
  list->item[list->count++] = p;
}

static uint32_t pool_add(piece_pool *pool, const long double x[3]) {
  if (pool->count == pool->room) {
    pool->at = solid_grow(pool->at, &pool->room, sizeof pool->at[0]);
  }
  memcpy(pool->at[pool->count], x, sizeof pool->at[0]);
  return (uint32_t)pool->count++;
}

void piece_pool_from(piece_pool *pool, const solid *s) {
  memset(pool, 0, sizeof *pool);
  for (size_t i = 0; i < s->points; i++) {
    const long double x[3] = {s->point[i][0], s->point[i][1], s->point[i][2]};
    pool_add(pool, x);
  }
}

piece piece_from(const solid *s) {
  piece p = {solid_allocate(3 * s->triangles, sizeof p.edge[0]), solid_allocate(s->triangles, sizeof p.face[0]),
             3 * s->triangles, s->triangles};
  for (size_t t = 0; t < s->triangles; t++) {
    p.face[t] = s->plane[t];
    for (size_t i = 0; i < 3; i++) {
      const piece_edge edge = {s->triangle[t][i], s->triangle[t][(i + 1) % 3], (uint32_t)t};
      p.edge[3 * t + i] = edge;
    }
  }
  return p;
}

long double piece_height(const solid_plane *plane, const long double x[3]) {
  const long double n[3] = {(long double)plane->n[0], (long double)plane->n[1], (long double)plane->n[2]};
  const long double length = sqrtl(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  return length > 0 ? (n[0] * x[0] + n[1] * x[1] + n[2] * x[2] - (long double)plane->d) / length : 0;
}

static int by_number(const void *a, const void *b) {
  const uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;
  return (x > y) - (x < y);
}

uint32_t *piece_corners(const piece *p, size_t *count) {
  uint32_t *corner = solid_allocate(p->edges, sizeof corner[0]);
  for (size_t i = 0; i < p->edges; i++) {
    corner[i] = p->edge[i].from;
  }
  qsort(corner, p->edges, sizeof corner[0], by_number);
  *count = 0;
  for (size_t i = 0; i < p->edges; i++) {
    if (i == 0 || corner[i] != corner[i - 1]) {
      corner[(*count)++] = corner[i];
    }
  }
  return corner;
}

long double piece_volume6(const piece *p, const piece_pool *pool) {
  long double sum = 0;
  const long double *o = p->edges > 0 ? pool->at[p->edge[0].from] : NULL;
  for (size_t i = 0, first = 0; i < p->edges; i++) {
    first = p->edge[i].face == p->edge[first].face ? first : i;
    long double a[3], b[3], c[3];
    for (int j = 0; j < 3; j++) {
      a[j] = pool->at[p->edge[first].from][j] - o[j];
      b[j] = pool->at[p->edge[i].from][j] - o[j];
      c[j] = pool->at[p->edge[i].to][j] - o[j];
    }
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum;
}

// Edges in both directions under one key, lesser corner first.
typedef struct edge_key {
  uint64_t key;
  uint32_t edge;
} edge_key;

static int by_key(const void *a, const void *b) {
  const edge_key *x = a, *y = b;
  return x->key != y->key ? (x->key > y->key) - (x->key < y->key) : (x->edge > y->edge) - (x->edge < y->edge);
}

static edge_key *sorted_edges(const piece *p) {
  edge_key *key = solid_allocate(p->edges, sizeof key[0]);
  for (size_t i = 0; i < p->edges; i++) {
    const uint64_t a = p->edge[i].from, b = p->edge[i].to;
    key[i].key = a < b ? a << 32 | b : b << 32 | a;
    key[i].edge = (uint32_t)i;
  }
  qsort(key, p->edges, sizeof key[0], by_key);
  return key;
}

// The greatest height of a face's corners beyond a plane.
static long double reach(const piece *p, const piece_pool *pool, const size_t *begin, uint32_t face,
                         const solid_plane *plane) {
  long double most = -INFINITY;
  for (size_t i = begin[face]; i < begin[face + 1]; i++) {
    most = fmaxl(most, piece_height(plane, pool->at[p->edge[i].from]));
  }
  return most;
}

// How deep the notch between two faces is, the lesser of how far each reaches beyond the other; 0: they bend outwards.
static long double depth_of(const piece *p, const piece_pool *pool, const size_t *begin, const piece_edge *e,
                            const piece_edge *back) {
  const solid_plane *a = &p->face[e->face], *b = &p->face[back->face];
  long double turn = 0;  // (a x b) . edge
  for (int j = 0; j < 3; j++) {
    const int k = (j + 1) % 3, l = (j + 2) % 3;
    const long double across =
        (long double)a->n[k] * (long double)b->n[l] - (long double)a->n[l] * (long double)b->n[k];
    turn += across * (pool->at[e->to][j] - pool->at[e->from][j]);
  }
  return turn < 0 ? fminl(reach(p, pool, begin, back->face, a), reach(p, pool, begin, e->face, b)) : 0;
}

piece_notch *piece_notches(const piece *p, const piece_pool *pool, long double slack, size_t *count) {
  edge_key *key = sorted_edges(p);
  size_t *begin = solid_allocate(p->faces + 1, sizeof begin[0]), room = 0;
  piece_notch *out = NULL;
  *count = 0;
  for (size_t i = 0; i < p->edges; i++) {
    begin[p->edge[i].face + 1] = i + 1;
  }
  for (size_t f = 0; f < p->faces; f++) {
    begin[f + 1] = begin[f + 1] > begin[f] ? begin[f + 1] : begin[f];
  }
  for (size_t i = 0; i < p->edges; i++) {
    // Two faces meet at most edges; where more do, all pairs that have the edge in opposite directions are looked at.
    for (size_t j = i + 1; j < p->edges && key[j].key == key[i].key; j++) {
      const piece_edge *e = &p->edge[key[i].edge], *back = &p->edge[key[j].edge];
      if (e->from == back->from) {
        continue;
      }
      const long double depth = depth_of(p, pool, begin, e, back);
      if (depth > slack) {
        if (*count == room) {
          out = solid_grow(out, &room, sizeof out[0]);
        }
        const piece_notch notch = {e->from, e->to, {p->face[e->face], p->face[back->face]}, depth};
        out[(*count)++] = notch;
      }
    }
  }
  free(begin);
  free(key);
  return out;
}

// Where a cut meets the edges: corners of the pool for each edge of the piece.
typedef struct cut {
  const piece *p;
  piece_pool *pool;
  solid_plane plane;
  const long double *height;  // of the pool's corners
  const uint32_t *crossing;   // a corner for each edge that both sides have; UINT32_MAX: none
  long double slack;
} cut;

// A corner on the cut, and how many edges of the face end there less those that begin.
typedef struct crossing {
  long double key;
  uint32_t corner;
  int count;
} crossing;

static int by_corner(const void *a, const void *b) {
  const crossing *x = a, *y = b;
  return (x->corner > y->corner) - (x->corner < y->corner);
}

static int along_line(const void *a, const void *b) {
  const crossing *x = a, *y = b;
  return x->key != y->key ? (x->key > y->key) - (x->key < y->key) : by_corner(a, b);
}

static void add_edge(piece *p, size_t *room, uint32_t from, uint32_t to, size_t face) {
  if (p->edges == *room) {
    p->edge = solid_grow(p->edge, room, sizeof p->edge[0]);
  }
  const piece_edge edge = {from, to, (uint32_t)face};
  p->edge[p->edges++] = edge;
}

// The direction of the line in which a face meets the cut.
static void line_direction(const solid_plane *a, const solid_plane *b, long double out[3]) {
  for (int i = 0; i < 3; i++) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    out[i] = (long double)a->n[j] * (long double)b->n[k] - (long double)a->n[k] * (long double)b->n[j];
  }
}

// Closes a face along the cut: sorted, the running count says how often an edge goes from a corner to the next one.
static void close_face(const cut *c, crossing *found, size_t count, size_t face, piece *kept, size_t *room, piece *cap,
                       size_t *cap_room) {
  long double way[3];
  size_t n = 0;
  qsort(found, count, sizeof found[0], by_corner);
  for (size_t i = 0; i < count; i++) {
    if (n > 0 && found[n - 1].corner == found[i].corner) {
      found[n - 1].count += found[i].count;
    } else {
      found[n++] = found[i];
    }
  }
  line_direction(&kept->face[face], &c->plane, way);
  for (size_t i = 0; i < n; i++) {
    const long double *x = c->pool->at[found[i].corner];
    found[i].key = way[0] * x[0] + way[1] * x[1] + way[2] * x[2];
  }
  qsort(found, n, sizeof found[0], along_line);
  int running = 0;
  for (size_t i = 0; i + 1 < n; i++) {
    running += found[i].count;
    for (int j = 0; j < (running < 0 ? -running : running); j++) {
      const uint32_t a = found[running > 0 ? i : i + 1].corner, b = found[running > 0 ? i + 1 : i].corner;
      add_edge(kept, room, a, b, face);
      add_edge(cap, cap_room, b, a, 0);
    }
  }
}

// What of the piece is on one side, sign = 1: beyond the plane.
static void keep_side(const cut *c, int sign, piece_list *out) {
  const piece *p = c->p;
  piece kept = {NULL, solid_allocate(p->faces + 1, sizeof kept.face[0]), 0, 0}, cap = {NULL, NULL, 0, 0};
  size_t room = 0, cap_room = 0, found_room = 0, found = 0;
  crossing *at = NULL;
  for (size_t i = 0; i < p->edges;) {
    const uint32_t face = p->edge[i].face;
    const size_t edges = kept.edges;
    found = 0;
    kept.face[kept.faces] = p->face[face];
    for (; i < p->edges && p->edge[i].face == face; i++) {
      const uint32_t a = p->edge[i].from, b = p->edge[i].to;
      const bool has_a = (long double)sign * c->height[a] > c->slack,
                 has_b = (long double)sign * c->height[b] > c->slack;
      if (has_a && has_b) {
        add_edge(&kept, &room, a, b, kept.faces);
      } else if (has_a || has_b) {
        const uint32_t missing = has_a ? b : a;
        const uint32_t corner = fabsl(c->height[missing]) <= c->slack ? missing : c->crossing[i];
        const crossing one = {0, corner, has_a ? 1 : -1};
        add_edge(&kept, &room, has_a ? a : corner, has_a ? corner : b, kept.faces);
        if (found == found_room) {
          at = solid_grow(at, &found_room, sizeof at[0]);
        }
        at[found++] = one;
      }
    }
    if (found > 0) {
      close_face(c, at, found, kept.faces, &kept, &room, &cap, &cap_room);
    }
    kept.faces += kept.edges > edges ? 1 : 0;
  }
  if (cap.edges > 0) {
    for (int j = 0; j < 3; j++) {
      kept.face[kept.faces].n[j] = -sign * c->plane.n[j];
    }
    kept.face[kept.faces].d = -sign * c->plane.d;
    for (size_t i = 0; i < cap.edges; i++) {
      add_edge(&kept, &room, cap.edge[i].from, cap.edge[i].to, kept.faces);
    }
    kept.faces++;
  }
  if (kept.edges > 0) {
    piece_part(&kept, c->pool, out);
  }
  free(at);
  free(cap.edge);
  piece_free(&kept);
}

void piece_cut(const piece *p, const solid_plane *plane, long double slack, piece_pool *pool, piece_list *out) {
  const size_t known = pool->count;
  long double *height = solid_allocate(known, sizeof height[0]);
  for (size_t i = 0; i < p->edges; i++) {
    height[p->edge[i].from] = piece_height(plane, pool->at[p->edge[i].from]);
  }
  edge_key *key = sorted_edges(p);
  uint32_t *crossing_of = solid_allocate(p->edges, sizeof crossing_of[0]);
  uint32_t last = UINT32_MAX;
  for (size_t i = 0; i < p->edges; i++) {
    const uint32_t a = (uint32_t)(key[i].key >> 32), b = (uint32_t)key[i].key;
    if (i == 0 || key[i].key != key[i - 1].key) {
      last = UINT32_MAX;
      if ((height[a] > slack && height[b] < -slack) || (height[a] < -slack && height[b] > slack)) {
        const long double t = height[a] / (height[a] - height[b]);
        long double x[3];
        for (int j = 0; j < 3; j++) {
          x[j] = pool->at[a][j] + t * (pool->at[b][j] - pool->at[a][j]);
          x[j] = fabsl(x[j] - rintl(x[j])) < 0x1p-16L ? rintl(x[j]) : x[j];
        }
        last = pool_add(pool, x);
      }
    }
    crossing_of[key[i].edge] = last;
  }
  free(key);
  const cut c = {p, pool, *plane, height, crossing_of, slack};
  keep_side(&c, 1, out);
  keep_side(&c, -1, out);
  free(crossing_of);
  free(height);
}
