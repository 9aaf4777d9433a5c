// What the library's search did on one pair: each iteration, and why it stopped.
//
// The search is the library's own. It is run one iteration at a time, as gjk_distance_until runs it, and looked at in
// between. So a trace has the bits and the number of iterations of the query. One exception: in the plane a query that
// may run to its end walks along the border of A - B where it can, which gjk2_distance_until does not.
#ifndef QUERY_TRACE_H
#define QUERY_TRACE_H

#include <stdio.h>

#include "case/answer.h"
#include "case/case2.h"

enum { TRACE_ITERATIONS_MAX = 256 };

// A point, or a vector, in LSB; in the plane z is 0.
typedef struct trace_point {
  int64_t x[3];
} trace_point;

// The vertex of A - B that an iteration found. Vertices are named by the iteration that found them first: w1, w2, ...
typedef struct trace_vertex {
  unsigned name;                // 0: no iteration found it, the search made it of vertices of A and B seen before
  unsigned number_a, number_b;  // of the vertices of A and B, from 0; of curved shapes 0
  trace_point a, b;             // the support points, world frame
  trace_point w;                // a - b
} trace_vertex;

// The vertices that span a feature of A - B.
typedef struct trace_simplex {
  unsigned count;
  trace_vertex vertex[4];
} trace_simplex;

typedef struct trace_iteration {
  trace_point direction;  // of the support scan, in the library's frame of the pair
  bool rounded;           // the direction is the exact one, rounded
  bool recalled;          // before the scan the search made the simplex the nearest of all vertices of A and B seen
  trace_vertex found;
  trace_simplex before, after;
} trace_iteration;

// Why the search stopped.
typedef enum trace_reason {
  TRACE_NEAREST,
  TRACE_ENCLOSING,
  TRACE_SEPARATED,
  TRACE_NEAR,
  TRACE_LIMIT,
  TRACE_SPHERES,  // bounding spheres
  TRACE_CIRCLES   // or in the plane circles
} trace_reason;

typedef struct trace {
  unsigned dimensions;  // 2 or 3
  trace_reason reason;
  int64_t radius;  // what the cores are compared with: the convex radii and the distance asked about, LSB
  bool curved;     // vertices have no numbers
  unsigned walk;   // iterations of the query where it walks; 0: it runs the search that is traced
  bool enclosing;  // the origin lies in the last simplex
  unsigned count;
  trace_iteration iteration[TRACE_ITERATIONS_MAX];
} trace;

// Begins a trace without iterations.
void trace_start(trace *t, unsigned dimensions, int64_t radius);

// Why it stopped, in a sentence.
const char *trace_reason_text(const trace *t);

// Completes a vertex whose numbers and support points are set: sets w, and the name of the iteration that found it.
void trace_complete_vertex(const trace *t, trace_vertex *vertex);

// Writes a list of names, 'w1,w2', or '-' where there is none.
void trace_simplex_text(const trace_simplex *simplex, char *text, size_t size);

// Runs the search of the question. Pre: a and b were built, and posed.
void trace_space(const case_question *question, const gjk_collider *a, const gjk_collider *b, trace *out);

// The same in the plane.
void trace_plane(const case_question *question, const gjk2_collider *a, const gjk2_collider *b, trace *out);

// Prints a line for each iteration, and one for the reason.
void trace_print(FILE *file, const trace *t);

#endif
