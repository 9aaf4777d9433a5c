// Pairs of the plane whose queries' instructions are counted.
#ifndef PLANE_BENCH_H
#define PLANE_BENCH_H

#include "gjk2/gjk2.h"
#include "random.h"

typedef enum plane_query {
  PLANE_INTERSECT,
  PLANE_DISTANCE,
  PLANE_DEPTH,
  PLANE_CONTACTS,
  PLANE_CHAIN,
  PLANE_CAST,    // B moves past A's centre, aside by up to 0.5 unit
  PLANE_RAY,     // the same way from B's centre
  PLANE_IMPACT,  // the same way, both turning by up to half a turn
  PLANE_STRAIGHT_IMPACT
} plane_query;

// From PLANE_SEGMENT on: how a body lies to a chain. SEGMENT: it covers no joint; LEVEL, RIDGE, DITCH: it lies over a
// joint of two segments in line, convex, concave; ABOVE: its box meets no segment.
typedef enum plane_gap {
  PLANE_APART,
  PLANE_CLOSE,
  PLANE_OVERLAPPING,
  PLANE_PRESSED,
  PLANE_HOVERING,
  PLANE_SEGMENT,
  PLANE_LEVEL,
  PLANE_RIDGE,
  PLANE_DITCH,
  PLANE_ABOVE
} plane_gap;

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

// For families of chains: makes the next chain and puts the body on it; asks for their contacts, and returns how many
// manifolds there are.
void plane_bench_ground(random_state *random, plane_gap gap, gjk2_collider *body, const gjk2_rotation *turn);
uint32_t plane_bench_chain(const gjk2_collider *body);

#endif
