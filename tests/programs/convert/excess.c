// Bounds on how far a part reaches beyond a solid: branch and bound over convex cells.
#include "excess.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

// A cell is not cut beside a triangle where less than this would be cut off, LSB.
#define BESIDE_LEAST 0.125L

typedef long double point[3];

// A face of a cell: n . x <= d, n of length 1.
typedef struct cell_face {
  point n;
  long double d;
  point *corner;
  unsigned corners;
} cell_face;

typedef struct cell {
  cell_face *face;
  unsigned faces;
  long double bound;
} cell;

typedef struct cell_heap {
  cell *item;
  size_t count, room;
} cell_heap;

static void cell_free(cell *c) {
  for (unsigned f = 0; f < c->faces; f++) {
    free(c->face[f].corner);
  }
  free(c->face);
}

static void push(cell_heap *heap, cell c) {
  if (heap->count == heap->room) {
    heap->item = solid_grow(heap->item, &heap->room, sizeof heap->item[0]);
  }
  size_t i = heap->count++;
  for (; i > 0 && heap->item[(i - 1) / 2].bound < c.bound; i = (i - 1) / 2) {
    heap->item[i] = heap->item[(i - 1) / 2];
  }
  heap->item[i] = c;
}

static cell pop(cell_heap *heap) {
  const cell top = heap->item[0], last = heap->item[--heap->count];
  size_t i = 0;
  for (size_t child = 1; child < heap->count; child = 2 * i + 1) {
    child += child + 1 < heap->count && heap->item[child + 1].bound > heap->item[child].bound ? 1 : 0;
    if (heap->item[child].bound <= last.bound) {
      break;
    }
    heap->item[i] = heap->item[child];
    i = child;
  }
  heap->item[i] = last;
  return top;
}

static long double dot(const point a, const point b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static bool normal_of(const solid_plane *plane, point n, long double *d) {
  long double length = 0;
  for (int j = 0; j < 3; j++) {
    n[j] = (long double)plane->n[j];
    length += n[j] * n[j];
  }
  length = sqrtl(length);
  for (int j = 0; j < 3 && length > 0; j++) {
    n[j] /= length;
  }
  *d = length > 0 ? (long double)plane->d / length : 0;
  return length > 0;
}

static cell cell_of(const part *p) {
  cell c = {solid_allocate(p->faces, sizeof c.face[0]), p->faces, INFINITY};
  for (unsigned f = 0, begin = 0; f < p->faces; begin = p->end[f++]) {
    cell_face *face = &c.face[f];
    normal_of(&p->plane[f], face->n, &face->d);
    face->corners = p->end[f] - begin;
    face->corner = solid_allocate(face->corners, sizeof face->corner[0]);
    for (unsigned i = 0; i < face->corners; i++) {
      for (int j = 0; j < 3; j++) {
        face->corner[i][j] = p->point[p->corner[begin + i]][j];
      }
    }
  }
  return c;
}

// What of a polygon is where n . x <= d. One corner more at most, but for rounding; never more than room.
static unsigned clip(const point *in, unsigned corners, const point n, long double d, point *out, unsigned room) {
  unsigned count = 0;
  long double hb = corners > 0 ? dot(n, in[0]) - d : 0;
  for (unsigned i = 0; i < corners; i++) {
    const long double *a = in[i], *b = in[i + 1 == corners ? 0 : i + 1];
    const long double ha = hb;
    hb = dot(n, b) - d;
    if (ha <= 0 && count < room) {
      memcpy(out[count++], a, sizeof out[0]);
    }
    if (((ha < 0 && hb > 0) || (ha > 0 && hb < 0)) && count < room) {
      for (int j = 0; j < 3; j++) {
        out[count][j] = a[j] + ha / (ha - hb) * (b[j] - a[j]);
      }
      count++;
    }
  }
  return count;
}

typedef struct turned {
  long double angle;
  point at;
} turned;

static int by_angle(const void *a, const void *b) {
  const turned *x = a, *y = b;
  return (x->angle > y->angle) - (x->angle < y->angle);
}

// Closes a cell by a face through points in a plane.
static void close_cell(cell *c, const point n, long double d, const point *at, unsigned count) {
  point middle = {0, 0, 0}, u, v;
  const int axis =
      fabsl(n[0]) < fabsl(n[1]) ? (fabsl(n[0]) < fabsl(n[2]) ? 0 : 2) : (fabsl(n[1]) < fabsl(n[2]) ? 1 : 2);
  const int j = (axis + 1) % 3, k = (axis + 2) % 3;
  u[axis] = 0;  // n x axis, and n x that
  u[j] = n[k];
  u[k] = -n[j];
  for (int i = 0; i < 3; i++) {
    v[i] = n[(i + 1) % 3] * u[(i + 2) % 3] - n[(i + 2) % 3] * u[(i + 1) % 3];
  }
  turned *sorted = solid_allocate(count, sizeof sorted[0]);
  for (unsigned i = 0; i < count; i++) {
    for (int m = 0; m < 3; m++) {
      middle[m] += at[i][m] / count;
    }
  }
  for (unsigned i = 0; i < count; i++) {
    memcpy(sorted[i].at, at[i], sizeof sorted[i].at);
    const point from = {at[i][0] - middle[0], at[i][1] - middle[1], at[i][2] - middle[2]};
    sorted[i].angle = atan2l(dot(from, v), dot(from, u));
  }
  qsort(sorted, count, sizeof sorted[0], by_angle);
  cell_face *face = &c->face[c->faces++];
  memcpy(face->n, n, sizeof face->n);
  face->d = d;
  face->corner = solid_allocate(count, sizeof face->corner[0]);
  face->corners = count;
  for (unsigned i = 0; i < count; i++) {
    memcpy(face->corner[i], sorted[i].at, sizeof face->corner[0]);
  }
  free(sorted);
}

// The part of a cell where n . x <= d.
static cell cell_clip(const cell *c, const point n, long double d) {
  cell out = {solid_allocate((size_t)c->faces + 1, sizeof out.face[0]), 0, c->bound};
  size_t all = 0;
  unsigned on = 0;
  for (unsigned f = 0; f < c->faces; f++) {
    all += (size_t)c->face[f].corners + 2;
  }
  point *cap = solid_allocate(all, sizeof cap[0]);
  for (unsigned f = 0; f < c->faces; f++) {
    const cell_face *face = &c->face[f];
    cell_face *kept = &out.face[out.faces];
    kept->corner = solid_allocate((size_t)face->corners + 2, sizeof kept->corner[0]);
    kept->corners = clip((const point *)face->corner, face->corners, n, d, kept->corner, face->corners + 2);
    memcpy(kept->n, face->n, sizeof kept->n);
    kept->d = face->d;
    for (unsigned i = 0; i < kept->corners; i++) {
      if (dot(n, kept->corner[i]) - d > -0x1p-24L) {
        memcpy(cap[on++], kept->corner[i], sizeof cap[0]);
      }
    }
    if (kept->corners >= 3) {
      out.faces++;
    } else {
      free(kept->corner);
    }
  }
  if (on >= 3) {
    close_cell(&out, n, d, (const point *)cap, on);
  }
  free(cap);
  return out;
}

// What is looked for among the triangles in a cell's box.
typedef struct look {
  const nearest_tree *tree;
  const cell *c;
  point middle;
  size_t best;
  long double least;  // of its plane's distance from the middle
  long double graze;
  point *room[2];
} look;

static bool look_at(void *user, size_t t) {
  look *l = user;
  const solid *s = l->tree->s;
  point n;
  long double d;
  unsigned corners = 3;
  int from = 0;
  if (!normal_of(&s->plane[t], n, &d) || fabsl(dot(n, l->middle) - d) >= l->least) {
    return true;
  }
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      l->room[0][i][j] = s->point[s->triangle[t][i]][j];
    }
  }
  for (unsigned f = 0; f < l->c->faces && corners > 0; f++) {
    const long double *across = l->c->face[f].n, at = l->c->face[f].d - l->graze;
    unsigned beyond = 0;
    for (unsigned i = 0; i < corners; i++) {
      beyond += dot(across, l->room[from][i]) > at;
    }
    if (beyond == corners) {
      corners = 0;
    } else if (beyond > 0) {
      corners = clip((const point *)l->room[from], corners, across, at, l->room[1 - from], l->c->faces + 4);
      from = 1 - from;
    }
  }
  if (corners > 0) {
    l->best = t;
    l->least = fabsl(dot(n, l->middle) - d);
  }
  return true;
}

// What is known of a cell.
typedef struct view {
  point middle, low, high;
  long double radius, inner;  // about the middle: all corners within; all faces beyond
} view;

static view view_of(const cell *c) {
  view v = {{0, 0, 0}, {INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}, 0, INFINITY};
  unsigned count = 0;
  for (unsigned f = 0; f < c->faces; f++) {
    for (unsigned i = 0; i < c->face[f].corners; i++, count++) {
      for (int j = 0; j < 3; j++) {
        const long double x = c->face[f].corner[i][j];
        v.middle[j] += x;
        v.low[j] = fminl(v.low[j], x);
        v.high[j] = fmaxl(v.high[j], x);
      }
    }
  }
  for (int j = 0; j < 3; j++) {
    v.middle[j] /= count;
  }
  for (unsigned f = 0; f < c->faces; f++) {
    v.inner = fminl(v.inner, c->face[f].d - dot(c->face[f].n, v.middle));
    for (unsigned i = 0; i < c->face[f].corners; i++) {
      const long double *x = c->face[f].corner[i];
      const point from = {x[0] - v.middle[0], x[1] - v.middle[1], x[2] - v.middle[2]};
      v.radius = fmaxl(v.radius, sqrtl(dot(from, from)));
    }
  }
  return v;
}

static long double farthest(const solid *s, const cell *c, size_t t) {
  long double most = 0;
  for (unsigned f = 0; f < c->faces; f++) {
    for (unsigned i = 0; i < c->face[f].corners; i++) {
      most = fmaxl(most, nearest_triangle(s, t, c->face[f].corner[i]));
    }
  }
  return most;
}

// The plane through an edge of a triangle, across it, which the cell's corners are farthest beyond. False: none that cuts the cell.
static bool beside(const solid *s, const cell *c, size_t t, point n, long double *d) {
  point up;
  long double most = 0;
  if (!normal_of(&s->plane[t], up, d)) {
    return false;
  }
  for (int e = 0; e < 3; e++) {
    const int32_t *a = s->point[s->triangle[t][e]], *b = s->point[s->triangle[t][(e + 1) % 3]];
    const point along = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, at = {a[0], a[1], a[2]};
    const long double length = sqrtl(dot(along, along));
    point out;
    long double beyond = 0, behind = 0;
    for (int j = 0; j < 3; j++) {
      out[j] = (along[(j + 1) % 3] * up[(j + 2) % 3] - along[(j + 2) % 3] * up[(j + 1) % 3]) / length;
    }
    for (unsigned f = 0; f < c->faces; f++) {
      for (unsigned i = 0; i < c->face[f].corners; i++) {
        const long double h = dot(out, c->face[f].corner[i]) - dot(out, at);
        beyond = fmaxl(beyond, h);
        behind = fmaxl(behind, -h);
      }
    }
    if (beyond > most && behind > BESIDE_LEAST && beyond > BESIDE_LEAST) {
      most = beyond;
      memcpy(n, out, sizeof out);
      *d = dot(out, at);
    }
  }
  return most > 0;
}

// Bounds a cell. Returns false where nothing of it is outside. across: by which triangle it is best cut; SIZE_MAX: none.
static bool bound_cell(const nearest_tree *tree, cell *c, const view *v, long double graze, long double *at_least,
                       size_t *across, size_t *nearest) {
  size_t near = 0;
  const long double distance = nearest_find(tree, v->middle, &near);
  *nearest = near;
  const bool inside = nearest_is_inside(tree, v->middle);
  *across = SIZE_MAX;
  if (inside && distance >= v->radius) {
    return false;
  }
  if (!inside && distance > *at_least) {
    *at_least = distance;
  }
  long double bound = fminl(c->bound, inside ? v->radius - distance : v->radius + distance);
  if (bound > *at_least) {
    bound = fminl(bound, farthest(tree->s, c, near));
  }
  look l = {tree, c, {v->middle[0], v->middle[1], v->middle[2]}, SIZE_MAX, INFINITY, graze, {NULL, NULL}};
  l.room[0] = solid_allocate((size_t)c->faces + 4, sizeof(point));
  l.room[1] = solid_allocate((size_t)c->faces + 4, sizeof(point));
  nearest_in_box(tree, v->low, v->high, look_at, &l);
  free(l.room[0]);
  free(l.room[1]);
  *across = l.best;
  if (l.best == SIZE_MAX && inside) {  // nothing crosses the cell without its rim: all is in, but for the rim
    bound = v->inner > 2 * graze ? fminl(bound, v->radius * graze / v->inner) : bound;
  }
  c->bound = bound;
  return true;
}

// The greatest distance of a part's corners, its edges' middles and its facets' means from the solid, or one above the limit.
static long double found_outside(const nearest_tree *tree, const part *p, long double limit) {
  long double most = 0;
  for (unsigned f = 0, begin = 0; f < p->faces && most <= limit; begin = p->end[f++]) {
    const unsigned corners = p->end[f] - begin;
    point mean = {0, 0, 0};
    for (unsigned i = 0; i <= 2 * corners && most <= limit; i++) {
      const int32_t *a = p->point[p->corner[begin + i % corners]], *b = p->point[p->corner[begin + (i + 1) % corners]];
      point x;
      for (int j = 0; j < 3; j++) {
        x[j] = i < corners ? a[j] : i < 2 * corners ? (a[j] + (long double)b[j]) / 2 : mean[j];
        mean[j] += i < corners ? (long double)a[j] / corners : 0;
      }
      size_t near;
      if (!nearest_is_inside(tree, x)) {
        most = fmaxl(most, nearest_find(tree, x, &near));
      }
    }
  }
  return most;
}

excess_bounds excess_of(const nearest_tree *tree, const part *p, long double tolerance, long double limit,
                        unsigned cells) {
  excess_bounds out = {0, 0};
  const long double graze = fmaxl(0x1p-10L, tolerance / 64);
  cell_heap heap = {NULL, 0, 0};
  out.at_least = found_outside(tree, p, limit);
  push(&heap, cell_of(p));
  long double slack = fmaxl(tolerance, out.at_least / 64);
  for (unsigned done = 0; heap.count > 0 && done < cells; done++) {
    slack = fmaxl(tolerance, out.at_least / 64);
    if (heap.item[0].bound <= out.at_least + slack || out.at_least > limit ||
        (isfinite(limit) && heap.item[0].bound <= limit)) {
      break;
    }
    cell top = pop(&heap);
    const view v = view_of(&top);
    size_t across, near;
    if (top.faces < 4 || !bound_cell(tree, &top, &v, graze, &out.at_least, &across, &near)) {
      cell_free(&top);
      continue;
    }
    if (top.bound <= out.at_least + slack) {
      push(&heap, top);
      continue;
    }
    point n = {0, 0, 0};
    long double d = 0;
    if (across != SIZE_MAX) {
      normal_of(&tree->s->plane[across], n, &d);
    } else if (!beside(tree->s, &top, near, n, &d)) {
      int axis = 0;
      for (int j = 1; j < 3; j++) {
        axis = v.high[j] - v.low[j] > v.high[axis] - v.low[axis] ? j : axis;
      }
      n[axis] = 1;
      d = v.middle[axis];
    }
    const point back = {-n[0], -n[1], -n[2]};
    cell half[2] = {cell_clip(&top, n, d), cell_clip(&top, back, -d)};
    for (int i = 0; i < 2; i++) {
      if (half[i].faces >= 4) {
        push(&heap, half[i]);
      } else {
        cell_free(&half[i]);
      }
    }
    cell_free(&top);
  }
  out.at_most = fmaxl(out.at_least, heap.count > 0 ? heap.item[0].bound : 0) + graze;
  for (size_t i = 0; i < heap.count; i++) {
    cell_free(&heap.item[i]);
  }
  free(heap.item);
  return out;
}
