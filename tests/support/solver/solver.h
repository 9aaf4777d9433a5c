// A small solver for rigid bodies that uses the library's contacts as a user's would. It computes in integers alone, so
// every machine computes the same bits. Tests and the demo let piles come to rest under it.
//
// Each tick: 1. Ask all pairs whose boxes meet for contacts.
//            2. Start each contact from the impulses that the contact of the same id had a tick before.
//            3. Sequential impulses push the bodies apart, and hold them by friction.
//            4. Move the bodies by their velocities.
//
// After   Erin Catto, Iterative Dynamics with Temporal Coherence, 2005.
#ifndef SOLVER_H
#define SOLVER_H

#include "gjk/gjk.h"

#ifndef SOLVER_BODIES_MAX
#define SOLVER_BODIES_MAX 64
#define SOLVER_PAIRS_MAX 512
#endif
#define SOLVER_POINTS_MAX 4
#define SOLVER_MANIFOLDS_MAX 8

// How far apart contact points may be, Q16.16.
#define SOLVER_MARGIN 1311

// Ticks a second.
#define SOLVER_RATE 60

// A number in 2^-24. Lengths are in units, times in seconds; a cubic unit has mass 1.
typedef int64_t solver_fix;
#define SOLVER_ONE ((solver_fix)1 << 24)

typedef struct solver_vec {
  solver_fix x, y, z;
} solver_vec;

typedef struct solver_body {
  gjk_collider collider;
  gjk_pose pose;
  gjk_aabb box;  // enlarged by the margin of contacts
  solver_vec position, velocity, spin;
  solver_fix inverse_mass;         // 0: it does not move
  solver_vec inverse_inertia;      // about its own axes
  solver_vec inverse_in_world[3];  // the same about the axes of the world in this tick, rows
} solver_body;

// What an impulse along an axis does. Each unit of it changes the spin of A by turn_a and of B by turn_b.
typedef struct solver_axis {
  solver_vec axis, moment_a, moment_b, turn_a, turn_b;
  solver_fix mass;  // effective
  solver_fix impulse;
} solver_axis;

typedef struct solver_point {
  uint16_t id;
  solver_axis along[3];  // the normal, two tangents
  solver_fix bias;       // the speed along the normal that the impulses aim at
} solver_point;

typedef struct solver_pair {
  uint16_t a, b, feature_a, feature_b;
  unsigned count;
  solver_point point[SOLVER_POINTS_MAX];
} solver_pair;

typedef struct solver_world {
  solver_body body[SOLVER_BODIES_MAX];
  unsigned bodies;
  solver_pair pair[2][SOLVER_PAIRS_MAX];  // of this tick, [now], and of the last, sorted by their bodies
  unsigned pairs[2], now;
  unsigned iterations;  // how often a tick goes over all impulses
  unsigned damping;     // bodies lose 1/2^damping of their spin each tick; 0: nothing
  // Where the manifolds of two bodies come from, for example a scene: as many as there are. NULL: gjk_contacts.
  unsigned (*manifolds)(void *user, unsigned a, unsigned b, gjk_manifold *out, unsigned capacity);
  void *user;
  unsigned long points;  // contact points of all ticks so far
  unsigned long fresh;   // those whose id was new though their pair had contacts a tick before
} solver_world;

// Starts an empty world without damping. iterations: how often a tick goes over all impulses.
void solver_init(solver_world *w, unsigned iterations);

// Adds a body and returns its number. shape: a sphere, capsule, box, cylinder or hull, which must outlive the world;
// half: the half extents of its box, for mass and inertia. fixed: it never moves.
unsigned solver_add(solver_world *w, const gjk_shape *shape, gjk_vec3 half, const gjk_pose *pose, bool fixed);

// Goes on by one tick of 1 / SOLVER_RATE s.
void solver_step(solver_world *w);

// The largest component of the velocity or spin of any body.
solver_fix solver_speed(const solver_world *w);

// A hash of the poses, velocities and spins of all bodies.
uint32_t solver_hash(const solver_world *w);

#endif
