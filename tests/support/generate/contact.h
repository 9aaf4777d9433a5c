// Makes pairs whose shapes share planes, lines, points or lattices.
#ifndef GENERATE_CONTACT_H
#define GENERATE_CONTACT_H

#include "case/case.h"
#include "random.h"

// Equal rotated boxes side by side: faces, edges or vertices in contact to the bit, or an LSB or two off it.
void generate_stacked(random_state *random, case_pair *pair);

// generate_stacked, with the boxes made hulls of 8 vertices.
void generate_stacked_hulls(random_state *random, case_pair *pair);

// Two hulls that share one to four vertices of a plane between them.
void generate_shared_feature(random_state *random, case_pair *pair);

// Hulls of points of one small lattice, scaled, so that planes, lines and points coincide and vertices repeat.
void generate_lattice(random_state *random, case_pair *pair);

// Shapes whose points lie in one plane or line, of any tilt; the other shape lies in the same plane, or an LSB above
// it.
void generate_flat(random_state *random, case_pair *pair);

// A prism, often flat, a little tilted, with its like or another polytope at its centre. Rounded to LSB its sides are level
// only to 1 LSB: supports along a normal and along the rounded normal differ.
void generate_tilted(random_state *random, case_pair *pair);

// The cores are as far apart as the sum of the convex radii, exactly, or one coordinate is an LSB off that.
void generate_level_radius(random_state *random, case_pair *pair);

// generate_smallest (generate.h) at level 0: the determinant that decides has the least size, either sign, or is 0.
void generate_smallest_face_vertex(random_state *random, case_pair *pair);
void generate_smallest_face_face(random_state *random, case_pair *pair);
void generate_smallest_edge_edge(random_state *random, case_pair *pair);

// The same at the sum of the convex radii, or at the border between two reported distances.
void generate_smallest_rounded(random_state *random, case_pair *pair);

#endif
