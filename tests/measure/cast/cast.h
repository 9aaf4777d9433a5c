// Casts whose true answer is known, and the methods that answer them: this library, the reference, other libraries.
#ifndef CAST_MEASURE_H
#define CAST_MEASURE_H

#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

#define CAST_LSB_PER_UNIT 65536.0

// All points within radius of the hull of centre + vertices[i]. Lengths in units; A's centre is the origin.
typedef struct cast_solid {
  double centre[3];
  double (*vertices)[3];
  size_t count;
  double radius;
} cast_solid;

struct case_pair;
struct case_collider;

// B moves by way against A, which stands. The shapes are apart at the start.
typedef struct cast_case {
  cast_solid solid[2];
  double way[3];
  struct case_pair *pair;  // the same in LSB, with its ways
  struct case_collider *a, *b;
  bool hit;
  double fraction;  // of the way at which they touch
  double rate;      // by how much the gap shrinks there over the whole way, LSB
} cast_case;

// prepare makes what a user of the method would keep; it is not timed. run: does B hit A, and at which fraction?
typedef struct cast_method {
  const char *name;
  void *(*prepare)(const cast_case *c);
  bool (*run)(void *prepared, double *fraction);
  void (*release)(void *prepared);
} cast_method;

// Lists of methods, each ended by NULL. Those of other libraries are linked if their package is installed.
typedef const cast_method *const cast_method_list[];

extern cast_method_list cast_own_methods, cast_bullet_methods, cast_fcl_methods;

typedef struct cast_family {
  const char *name;
  const char *made[5];  // generate_cast_families that it is made of; none: balls against a box
  double half, way;     // of those: the box's half extent and how long ways are, units
} cast_family;

extern const cast_family cast_families[];
extern const size_t cast_family_count;

// Makes count casts of a family. cast_release: frees them.
cast_case *cast_make(const cast_family *family, size_t count);
void cast_release(cast_case *cases, size_t count);

#ifdef __cplusplus
}
#endif

#endif
