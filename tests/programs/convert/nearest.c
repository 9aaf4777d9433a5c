// A tree of boxes over triangles, and distances.
#include "nearest.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LEAF = 4, DEPTH = 64 };

static void box_of(const solid *s, const uint32_t *order, nearest_node *node) {
  for (int j = 0; j < 3; j++) {
    node->low[j] = INT32_MAX;
    node->high[j] = INT32_MIN;
  }
  for (uint32_t i = node->begin; i < node->end; i++) {
    for (int c = 0; c < 3; c++) {
      const int32_t *x = s->point[s->triangle[order[i]][c]];
      for (int j = 0; j < 3; j++) {
        node->low[j] = x[j] < node->low[j] ? x[j] : node->low[j];
        node->high[j] = x[j] > node->high[j] ? x[j] : node->high[j];
      }
    }
  }
}

typedef struct keyed {
  int64_t key;
  uint32_t triangle;
} keyed;

static int by_key(const void *a, const void *b) {
  const keyed *x = a, *y = b;
  return x->key != y->key ? (x->key > y->key) - (x->key < y->key)
                          : (x->triangle > y->triangle) - (x->triangle < y->triangle);
}

// Sorts a node's triangles along its longest side.
static void sort_node(const solid *s, uint32_t *order, const nearest_node *node, keyed *room) {
  int axis = 0;
  for (int j = 1; j < 3; j++) {
    axis = node->high[j] - node->low[j] > node->high[axis] - node->low[axis] ? j : axis;
  }
  const uint32_t count = node->end - node->begin;
  for (uint32_t i = 0; i < count; i++) {
    const uint32_t t = order[node->begin + i];
    room[i].key = (int64_t)s->point[s->triangle[t][0]][axis] + s->point[s->triangle[t][1]][axis] +
                  s->point[s->triangle[t][2]][axis];
    room[i].triangle = t;
  }
  qsort(room, count, sizeof room[0], by_key);
  for (uint32_t i = 0; i < count; i++) {
    order[node->begin + i] = room[i].triangle;
  }
}

void nearest_build(nearest_tree *tree, const solid *s) {
  keyed *room = solid_allocate(s->triangles, sizeof room[0]);
  tree->s = s;
  tree->order = solid_allocate(s->triangles, sizeof tree->order[0]);
  tree->node = solid_allocate(2 * s->triangles + 1, sizeof tree->node[0]);
  tree->nodes = 1;
  for (size_t t = 0; t < s->triangles; t++) {
    tree->order[t] = (uint32_t)t;
  }
  tree->node[0].begin = 0;
  tree->node[0].end = (uint32_t)s->triangles;
  for (size_t n = 0; n < tree->nodes; n++) {  // children come after their parents, so this meets all
    nearest_node *node = &tree->node[n];
    box_of(s, tree->order, node);
    if (node->end - node->begin > LEAF) {
      sort_node(s, tree->order, node, room);
      nearest_node *child = &tree->node[tree->nodes];
      node->left = (uint32_t)tree->nodes;
      tree->nodes += 2;
      child[0].begin = node->begin;
      child[0].end = child[1].begin = node->begin + (node->end - node->begin) / 2;
      child[1].end = node->end;
    }
  }
  free(room);
}

void nearest_free(nearest_tree *tree) {
  free(tree->node);
  free(tree->order);
  memset(tree, 0, sizeof *tree);
}

static long double dot(const long double a[3], const long double b[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Squared distance from x, counted from a, to the segment from 0 to u.
static long double to_segment(const long double x[3], const long double u[3]) {
  const long double length = dot(u, u), t = length > 0 ? fminl(1, fmaxl(0, dot(x, u) / length)) : 0;
  long double sum = 0;
  for (int j = 0; j < 3; j++) {
    sum += (x[j] - t * u[j]) * (x[j] - t * u[j]);
  }
  return sum;
}

long double nearest_triangle(const solid *s, size_t triangle, const long double x[3]) {
  const int32_t *a = s->point[s->triangle[triangle][0]], *b = s->point[s->triangle[triangle][1]],
                *c = s->point[s->triangle[triangle][2]];
  long double u[3], v[3], w[3], p[3], q[3];
  for (int j = 0; j < 3; j++) {
    u[j] = b[j] - a[j];
    v[j] = c[j] - a[j];
    w[j] = c[j] - b[j];
    p[j] = x[j] - a[j];
    q[j] = x[j] - b[j];
  }
  const long double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), pu = dot(p, u), pv = dot(p, v);
  const long double area = uu * vv - uv * uv, i = vv * pu - uv * pv, j = uu * pv - uv * pu;
  long double least = fminl(to_segment(p, u), fminl(to_segment(p, v), to_segment(q, w)));
  if (area > 0 && i > 0 && j > 0 && i + j < area) {  // the point that i, j name is in the triangle, so never too near
    long double sum = 0;
    for (int n = 0; n < 3; n++) {
      const long double d = p[n] - i / area * u[n] - j / area * v[n];
      sum += d * d;
    }
    least = fminl(least, sum);
  }
  return sqrtl(least);
}

static long double to_box(const nearest_node *node, const long double x[3]) {
  long double sum = 0;
  for (int j = 0; j < 3; j++) {
    const long double d = fmaxl(0, fmaxl(node->low[j] - x[j], x[j] - node->high[j]));
    sum += d * d;
  }
  return sqrtl(sum);
}

long double nearest_find(const nearest_tree *tree, const long double x[3], size_t *triangle) {
  uint32_t stack[DEPTH];
  int depth = 0;
  long double least = INFINITY;
  stack[depth++] = 0;
  while (depth > 0) {
    const nearest_node *node = &tree->node[stack[--depth]];
    if (to_box(node, x) >= least) {
      continue;
    }
    if (node->left != 0) {
      const nearest_node *child = &tree->node[node->left];
      const bool swap = to_box(&child[0], x) < to_box(&child[1], x);  // the nearer one is taken first
      stack[depth++] = node->left + (swap ? 1 : 0);
      stack[depth++] = node->left + (swap ? 0 : 1);
      continue;
    }
    for (uint32_t i = node->begin; i < node->end; i++) {
      const long double d = nearest_triangle(tree->s, tree->order[i], x);
      if (d < least) {
        least = d;
        *triangle = tree->order[i];
      }
    }
  }
  return least;
}

void nearest_in_box(const nearest_tree *tree, const long double low[3], const long double high[3],
                    bool (*each)(void *user, size_t triangle), void *user) {
  uint32_t stack[DEPTH];
  int depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const nearest_node *node = &tree->node[stack[--depth]];
    if (node->low[0] > high[0] || node->low[1] > high[1] || node->low[2] > high[2] || node->high[0] < low[0] ||
        node->high[1] < low[1] || node->high[2] < low[2]) {
      continue;
    }
    if (node->left != 0) {
      stack[depth++] = node->left;
      stack[depth++] = node->left + 1;
      continue;
    }
    for (uint32_t i = node->begin; i < node->end; i++) {
      if (!each(user, tree->order[i])) {
        return;
      }
    }
  }
}

// A count of crossings, and whether the ray begins on the surface.
typedef struct crossings {
  const solid *s;
  solid_ray ray;
  long winding;
  bool on;
} crossings;

static bool cross(void *user, size_t triangle) {
  crossings *c = user;
  c->on = !solid_cross(c->s, triangle, &c->ray, &c->winding);
  return !c->on;
}

bool nearest_is_inside(const nearest_tree *tree, const long double x[3]) {
  crossings c = {tree->s, {{0, 0, 0}, NULL, 24, 0, 1}, 0, false};
  long double low[3], high[3];
  for (int j = 0; j < 3; j++) {
    c.ray.x[j] = (solid_wide)rintl(ldexpl(x[j], 24));
    low[j] = x[j] - 0x1p-20L;  // the place is moved by 2^-25 at most
    high[j] = j == 0 ? INFINITY : x[j] + 0x1p-20L;
  }
  nearest_in_box(tree, low, high, cross, &c);
  return c.on || c.winding != 0;
}
