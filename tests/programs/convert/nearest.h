// Distances from a solid's surface, in long double.
#ifndef NEAREST_H
#define NEAREST_H

#include "solid.h"

// A tree of boxes over the triangles.
typedef struct nearest_node {
  int32_t low[3], high[3];
  uint32_t begin, end;  // triangles, by nearest_tree.order
  uint32_t left;        // the first child, the other one follows; 0: a leaf
} nearest_node;

typedef struct nearest_tree {
  const solid *s;
  nearest_node *node;
  uint32_t *order;
  size_t nodes;
} nearest_tree;

void nearest_build(nearest_tree *tree, const solid *s);
void nearest_free(nearest_tree *tree);

// The distance from a point to a triangle.
long double nearest_triangle(const solid *s, size_t triangle, const long double x[3]);

// The distance from a point to the surface, and a triangle that has it.
long double nearest_find(const nearest_tree *tree, const long double x[3], size_t *triangle);

// Calls each(user, triangle) for all triangles whose boxes meet a box, until it says false.
void nearest_in_box(const nearest_tree *tree, const long double low[3], const long double high[3],
                    bool (*each)(void *user, size_t triangle), void *user);

// Is a point in the solid? It is rounded to 2^-24; points on the surface may be either.
bool nearest_is_inside(const nearest_tree *tree, const long double x[3]);

#endif
