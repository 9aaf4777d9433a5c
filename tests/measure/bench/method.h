// A method answers queries about pairs: the library, the reference, or another library. The benchmark measures methods.
//
// prepare makes what a user of the method would keep between queries; it is not timed. run answers, again and again.
#ifndef BENCH_METHOD_H
#define BENCH_METHOD_H

#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

#define BENCH_LSB_PER_UNIT 65536.0

// BENCH_CONTACTS: contact points at most BENCH_MARGIN apart, at most BENCH_CONTACTS_KEPT of them.
typedef enum bench_query { BENCH_DISTANCE, BENCH_INTERSECT, BENCH_DEPTH, BENCH_CONTACTS, BENCH_QUERIES } bench_query;

#define BENCH_ASK(query) (1u << (query))
#define BENCH_MARGIN 655  // LSB
#define BENCH_CONTACTS_KEPT 4

// A posed polytope: all points within convex_radius of the hull of centre + vertices[i]. Lengths in units, axes of the
// world. All numbers are exactly the library's integers.
typedef struct bench_solid {
  double centre[3];
  double (*vertices)[3];
  size_t count;
  double convex_radius;
  double half_axes[3][3];  // of a box
} bench_solid;

struct case_pair;
struct case_collider;

// A pair with its true answer.
typedef struct bench_pair {
  struct case_pair *shapes;
  struct case_collider *a, *b;  // of shapes, posed
  bench_solid solid[2];
  bool intersecting;
  double distance;  // LSB; when intersecting 0, or minus the depth where the family asks for it
  int placed;       // the gap that the pair was made for, LSB, or BENCH_NOT_PLACED
} bench_pair;

#define BENCH_NOT_PLACED (-1000000)

typedef enum bench_decision { BENCH_APART, BENCH_TOGETHER, BENCH_UNDECIDED } bench_decision;

// distance, lower, upper  LSB; of overlapping shapes minus the depth; of contacts that of the deepest one
// bounded                 the method has proven lower and upper
typedef struct bench_answer {
  bench_decision decision;  // BENCH_UNDECIDED of a depth or contacts: there is no answer
  bool bounded;
  double distance, lower, upper;
  unsigned iterations;  // 0: unknown
  unsigned contacts;
} bench_answer;

typedef struct bench_method {
  const char *name;
  const char *series;  // methods of one series differ in a setting and are drawn as one line
  int setting;         // the method's place in its series
  unsigned answers;    // BENCH_ASK of each query that it answers, combined by |
  bool boxes_only;     // it answers only about boxes
  void *(*prepare)(const struct bench_method *method, const bench_pair *pair);
  void (*run)(const struct bench_method *method, void *prepared, bench_query query, bench_answer *out);
  void (*release)(void *prepared);
} bench_method;

// Lists of methods, each ended by NULL. Those of other libraries are linked if their package is installed.
typedef const bench_method *const bench_method_list[];

extern bench_method_list bench_gjk_methods, bench_reference_methods;
extern bench_method_list bench_ccd_methods, bench_bullet_methods, bench_fcl_methods;

// All methods that are linked; the library's own, cold, is the first.
#define BENCH_METHODS_MAX 64
size_t bench_methods(const bench_method *out[BENCH_METHODS_MAX]);

#ifdef __cplusplus
}
#endif

#endif
