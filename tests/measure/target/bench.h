// Families of random pairs for which instructions per query are counted. They are the same pairs on every core.
#ifndef BENCH_H
#define BENCH_H

#include "gjk/gjk.h"

#define BENCH_VERTICES 64

// BENCH_CONTACTS: contact points at most BENCH_MARGIN apart, at most BENCH_CONTACTS_KEPT of them. BENCH_IMPACT: when
// shapes touch that move by bench_motion.
typedef enum bench_query { BENCH_DISTANCE, BENCH_INTERSECT, BENCH_DEPTH, BENCH_CONTACTS, BENCH_IMPACT } bench_query;

#define BENCH_MARGIN GJK_Q16(0.02)
#define BENCH_CONTACTS_KEPT 4

typedef enum bench_gap {
  BENCH_APART,  // 0.1 to 2 units
  BENCH_CLOSE,  // above 0, to 0.1 units; bounding spheres overlap
  BENCH_OVERLAPPING,
  BENCH_PRESSED,   // face to face, spun and tilted by up to a degree, up to 0.05 units deep
  BENCH_HOVERING,  // the same, apart by no more than the margin
  BENCH_MOVING     // apart as BENCH_APART; B moves to within a unit of A, both turn by half a turn, and they meet
} bench_gap;

typedef struct bench_family {
  const char *name;
  bench_query query;
  uint16_t vertices;  // of each hull; 0: boxes. Face to face, 8: frusta of pyramids, with faces
  bench_gap gap;
} bench_family;

extern const bench_family bench_families[];
extern const unsigned bench_family_count;

// How many pairs of a family are counted. Bounding spheres settle most intersections of shapes apart in 150
// instructions, and a few pairs take 20 times as many: a mean so skewed needs a large sample.
static inline unsigned bench_pair_count(const bench_family *family) {
  return family->query == BENCH_INTERSECT && family->gap == BENCH_APART ? 1000 : 50;
}

// bench_start: starts a family. bench_next: poses the next pair and sets its answer; false: the certificate of its
// depth does not hold.
void bench_start(void);
bool bench_next(const bench_family *family);

// The answer of a solver. distance: of overlapping shapes minus the depth; of contacts the least; of a decision it is
// not set.
typedef struct bench_answer {
  bool intersecting;
  gjk_q16 distance;
  unsigned iterations;  // or how many contacts
} bench_answer;

// The workspace of every depth query; and how many of its cells the present pair needs, 0 for other queries.
extern const gjk_workspace bench_workspace;
uint32_t bench_cells_needed(const bench_family *family);

extern const gjk_collider *const bench_pair[2];
extern gjk_motion bench_motion[2];
extern bench_answer bench_expected;  // intersecting and distance

// A solver answers the queries up to `last` about the present pair. run is what is measured.
typedef struct bench_solver {
  const char *name;
  bench_query last;
  void (*pose)(const gjk_collider *a, const gjk_collider *b);
  void (*run)(bench_query query, bench_answer *out);
} bench_solver;

extern const bench_solver bench_gjk, bench_float, bench_double;

#endif
