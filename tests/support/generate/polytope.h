// Makes random polytopes, sizes and rotations.
#ifndef GENERATE_POLYTOPE_H
#define GENERATE_POLYTOPE_H

#include "case/case.h"
#include "random.h"

#define GENERATE_REACH_MAX (4000 * 65536)

// A number u, 0 <= u < 1.
double generate_unit(random_state *random);

// A size from 3 LSB to 4,000 units; every order of magnitude is equally likely.
gjk_q16 generate_reach(random_state *random);

// A bound of the radius of a polytope that is made for reach: the larger of reach and 2,000 units.
gjk_q16 generate_bound(gjk_q16 reach);

// A vector of about the length, in a random direction.
gjk_vec3 generate_vector(random_state *random, double length);

// Any rotation; one in eight is the identity or a quarter turn, one in eight almost one.
gjk_quat generate_rotation(random_state *random);

// Point, segment, triangle, box or hull.
case_kind generate_kind(random_state *random);

// Makes a shape of about that reach, with convex radius 0, at the identity pose. A hull has 4 to 256 points: on a
// sphere, in a box, in clusters, or on a coarse lattice, where many lie in one plane and some coincide.
void generate_polytope(random_state *random, case_kind kind, gjk_q16 reach, case_shape *out);

// generate_polytope, but one extent is 1 LSB and another below 1/10,000 of the reach.
void generate_sliver(random_state *random, case_kind kind, gjk_q16 reach, case_shape *out);

#endif
