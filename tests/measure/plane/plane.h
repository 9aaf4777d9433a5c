// Methods that answer queries about pairs in the plane: this library, the reference in double, and other libraries.
//
// prepare makes what a user would keep between queries; it is not measured. run answers, again and again.
#ifndef PLANE_METHOD_H
#define PLANE_METHOD_H

#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

#define PLANE_LSB_PER_UNIT 65536.0

// PLANE_CONTACTS counts the points of a manifold; PLANE_CHAIN those of B with the chain of A's corners.
typedef enum plane_query { PLANE_INTERSECT, PLANE_DISTANCE, PLANE_DEPTH, PLANE_CONTACTS, PLANE_CHAIN } plane_query;

// A posed polygon: its corners counterclockwise about a centre, in units, axes of the world. The numbers are exactly the
// library's integers; A's centre is 0. Not made of families that only this library answers.
typedef struct plane_solid {
  double centre[2];
  double (*corner)[2];
  size_t count;
} plane_solid;

struct case2_collider;

typedef struct plane_pair {
  struct case2_collider *collider[2];  // posed
  plane_solid solid[2];
  bool intersecting;  // proven
} plane_pair;

// Answers about a prepared pair: 1 if the shapes touch and 0 if not, in units the distance or the depth, or how many
// contacts there are.
typedef double plane_run(void *prepared);

// choose  how the method answers the query, or NULL if it does not
typedef struct plane_method {
  const char *name;
  plane_run *(*choose)(plane_query query);
  void *(*prepare)(const plane_pair *pair);
  void (*release)(void *prepared);
} plane_method;

// Lists of methods, each ended by NULL. Those of other libraries are linked if their package is installed.
typedef const plane_method *const plane_method_list[];

extern plane_method_list plane_own_methods, plane_box2d_methods, plane_chipmunk_methods;

#ifdef __cplusplus
}
#endif

#endif
