// A small solver for rigid bodies of the plane, on gjk2_contacts and gjk2_chain_contacts, in integers alone.
//
// Each tick: 1. Ask all pairs whose boxes meet, and all bodies against all chains, for contacts.
//            2. Start each contact from the impulses that the contact of the same name had a tick before.
//            3. Sequential impulses push the bodies apart, and hold them by friction.
//            4. Move the bodies by their velocities.
//
// Lengths are Q16.16 units, velocities units a second, impulses a mass times a velocity. A square unit has mass 1.
//
// After   Erin Catto, Iterative Dynamics with Temporal Coherence, 2005.
#ifndef FLAT_SOLVER_H
#define FLAT_SOLVER_H

#include "gjk2/gjk2.h"

#ifndef FLAT_BODIES
#define FLAT_BODIES 32
#define FLAT_POINTS 192
#endif
#define FLAT_CHAINS 6
#define FLAT_VERTICES 8

// Ticks a second.
#define FLAT_RATE 60

typedef struct flat_body {
  gjk2_shape shape;
  gjk2_collider collider;
  gjk2_vec buffer[FLAT_VERTICES];
  gjk2_aabb box;
  gjk2_pose pose;
  gjk_angle angle;
  gjk2_vec velocity;
  int32_t spin;                           // radians a second
  int32_t inverse_mass, inverse_inertia;  // Q16.16; both 0: it does not move
  int32_t friction, bounce;               // Q16.16
  bool grounded;                          // something holds it from below, since the last tick
} flat_body;

typedef struct flat_chain {
  gjk2_chain chain;
  gjk_q16 deepest;  // contacts deeper than this are left out, so that a body may jump onto a thin platform from below
} flat_chain;

typedef struct flat_point {
  uint16_t a, b, segment, id;  // a: a body, or FLAT_BODIES and a chain
  gjk2_unit normal;
  gjk2_vec arm_a, arm_b;  // from the bodies' origins
  int32_t mass, mass_across;
  int32_t target;  // the speed along the normal that the impulses aim at
  int32_t impulse, impulse_across;
} flat_point;

typedef struct flat_world {
  flat_body body[FLAT_BODIES];
  flat_chain chain[FLAT_CHAINS];
  unsigned bodies, chains;
  flat_point point[2][FLAT_POINTS];  // of this tick, [now], and of the last
  unsigned points[2], now;
  uint32_t met, met_ground;  // contact points of pairs and of chains, of all ticks so far
} flat_world;

// Adds a body; inertia: of mass 1, Q16.16; 0: it does not turn. Returns its number.
unsigned flat_add(flat_world *w, const gjk2_shape *shape, gjk2_vec at, gjk_angle angle, int32_t mass, int32_t inertia);

void flat_add_chain(flat_world *w, const gjk2_vec *vertices, uint16_t count, gjk2_vec at, gjk_q16 deepest);

// Goes on by one tick.
void flat_step(flat_world *w);

#endif
