// Pairs of the plane whose queries' instructions are counted.
#ifndef PLANE_BENCH_H
#define PLANE_BENCH_H

#include "gjk2/gjk2.h"

typedef enum plane_query { PLANE_INTERSECT, PLANE_DISTANCE, PLANE_DEPTH, PLANE_CONTACTS } plane_query;

typedef enum plane_gap { PLANE_APART, PLANE_CLOSE, PLANE_OVERLAPPING, PLANE_PRESSED, PLANE_HOVERING } plane_gap;

typedef struct plane_family {
  const char *name;
  plane_query query;
  plane_gap gap;
  uint16_t vertices;  // of the polygons; 0: boxes
  gjk_q16 radius;     // of the rounding
} plane_family;

extern const plane_family plane_families[];
extern const unsigned plane_family_count;

#define PLANE_PAIRS 1000

// Begins the random pairs anew.
void plane_bench_start(void);

// Makes the next pair of a family.
void plane_bench_next(const plane_family *family);

// Asks. Returns iterations, or contacts.
uint32_t plane_bench_run(const plane_family *family);

#endif
