// What is measured: methods that answer a question about a pair.
//
// A method prepares what its users would keep between queries, untimed, and then answers again and again.
#ifndef BENCH_METHOD_H
#define BENCH_METHOD_H

#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

#define BENCH_LSB_PER_UNIT 65536.0

typedef enum bench_query { BENCH_DISTANCE, BENCH_INTERSECT, BENCH_QUERIES } bench_query;

// A posed polytope: its vertices are centre + vertices, in units, the axes the world's. Exactly the library's integers.
typedef struct bench_solid {
  double centre[3];
  double (*vertices)[3];
  size_t count;
} bench_solid;

struct case_pair;
struct case_collider;

// A pair with its true answer.
typedef struct bench_pair {
  struct case_pair *shapes;
  struct case_collider *a, *b;  // of shapes, posed
  bench_solid solid[2];
  bool intersecting;
  double distance;  // LSB, 0 when intersecting
  int placed;       // what gap the pair was made for, LSB; BENCH_NOT_PLACED
} bench_pair;

#define BENCH_NOT_PLACED (-1000000)

typedef enum bench_decision { BENCH_APART, BENCH_TOGETHER, BENCH_UNDECIDED } bench_decision;

// distance, lower, upper: LSB. A method that proves no bounds leaves bounded false.
typedef struct bench_answer {
  bench_decision decision;
  bool bounded;
  double distance, lower, upper;
  unsigned rounds;  // 0: the method does not tell
} bench_answer;

typedef struct bench_method {
  const char *name;
  const char *series;   // methods of one series differ in a setting and are drawn as one line
  int setting;          // the method's place in its series
  bool distance_only;   // answers no yes-or-no question
  bool intersect_only;  // answers nothing else
  void *(*prepare)(const struct bench_method *method, const bench_pair *pair);
  void (*run)(const struct bench_method *method, void *prepared, bench_query query, bench_answer *out);
  void (*release)(void *prepared);
} bench_method;

// A null-terminated list of methods. Those of other libraries are linked where their package is installed.
typedef const bench_method *const bench_method_list[];

extern bench_method_list bench_gjk_methods, bench_reference_methods;
extern bench_method_list bench_ccd_methods, bench_bullet_methods, bench_fcl_methods;

// All methods that are linked; the library's own, cold, is the first.
#define BENCH_METHODS_MAX 64
size_t bench_methods(const bench_method *out[BENCH_METHODS_MAX]);

static inline bool bench_answers(const bench_method *method, bench_query query) {
  return query == BENCH_DISTANCE ? !method->intersect_only : !method->distance_only;
}

#ifdef __cplusplus
}
#endif

#endif
