// A small solver for rigid bodies that stand on contacts of the library: what a user's would do, in integers alone, so that
// every machine computes the same bits.
//
// Each tick the pairs whose boxes meet are asked for contacts; each contact starts from the impulses that the contact of the
// same id had a tick before; sequential impulses push the bodies apart and hold them by friction.
// After   Erin Catto, Iterative Dynamics with Temporal Coherence, 2005.
#ifndef SOLVER_H
#define SOLVER_H

#include "gjk/gjk.h"

#define SOLVER_BODIES_MAX 64
#define SOLVER_PAIRS_MAX 512
#define SOLVER_POINTS_MAX 4

// Ticks a second.
#define SOLVER_RATE 60

// 2^-24; lengths in units, times in seconds, the mass of a cubic unit is 1.
typedef int64_t solver_fix;
#define SOLVER_ONE ((solver_fix)1 << 24)

typedef struct solver_vec {
  solver_fix x, y, z;
} solver_vec;

typedef struct solver_body {
  gjk_collider collider;
  gjk_pose pose;
  gjk_aabb box;  // its margin included
  solver_vec position, velocity, spin;
  solver_fix inverse_mass;         // 0: it stays where it is
  solver_vec inverse_inertia;      // about its own axes
  solver_vec inverse_in_world[3];  // rows, this tick
} solver_body;

// What an impulse along an axis does: it turns A by turn_a and B by turn_b for each unit.
typedef struct solver_axis {
  solver_vec axis, moment_a, moment_b, turn_a, turn_b;
  solver_fix mass;  // effective
  solver_fix impulse;
} solver_axis;

typedef struct solver_point {
  uint16_t id;
  solver_axis along[3];  // the normal, two tangents
  solver_fix bias;       // the speed that the normal is to have
} solver_point;

typedef struct solver_pair {
  uint16_t a, b, feature_a, feature_b;
  unsigned count;
  solver_point point[SOLVER_POINTS_MAX];
} solver_pair;

typedef struct solver_world {
  solver_body body[SOLVER_BODIES_MAX];
  unsigned bodies;
  solver_pair pair[2][SOLVER_PAIRS_MAX];  // of this tick and the last, in the order of their bodies
  unsigned pairs[2], now;
  unsigned iterations;   // of impulses a tick
  unsigned damping;      // bodies lose 1/2^damping of their spin each tick; 0: nothing
  unsigned long points;  // of all ticks so far
  unsigned long fresh;   // those of them that had no impulse to start from though their pair had some
} solver_world;

// Empty, with so many iterations of impulses a tick and no damping.
void solver_init(solver_world *w, unsigned iterations);

// Adds a body of a sphere, capsule, box, cylinder or hull within a box of half extents; mass 0: it does not move. Returns its
// number. The shape must outlive the world.
unsigned solver_add(solver_world *w, const gjk_shape *shape, gjk_vec3 half, const gjk_pose *pose, bool fixed);

void solver_step(solver_world *w);

// The largest speed of any body, of turning, too.
solver_fix solver_speed(const solver_world *w);

// Of all that bodies are and do.
uint32_t solver_hash(const solver_world *w);

#endif
