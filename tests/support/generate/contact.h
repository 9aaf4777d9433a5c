// Families whose shapes share planes, lines, points and lattices.
#ifndef GENERATE_CONTACT_H
#define GENERATE_CONTACT_H

#include "case/case.h"
#include "random.h"

// Equal rotated boxes side by side: faces, edges or vertices in contact to the bit, or an LSB or two off it.
void generate_stacked(random_state *random, case_pair *pair);

// The same as hulls.
void generate_stacked_hulls(random_state *random, case_pair *pair);

// Two hulls that share one to four vertices of a plane between them.
void generate_shared_feature(random_state *random, case_pair *pair);

// Points of a small lattice, scaled: planes, lines and points coincide, and vertices repeat.
void generate_lattice(random_state *random, case_pair *pair);

// Points of one plane, or of one line, of any tilt; the other shape in the same plane, or an LSB above it.
void generate_flat(random_state *random, case_pair *pair);

// Cores exactly, or the square root of one square more or less than, the radii apart.
void generate_level_radius(random_state *random, case_pair *pair);

// See generate.h: both signs of the smallest determinant, and 0.
void generate_smallest_face_vertex(random_state *random, case_pair *pair);
void generate_smallest_face_face(random_state *random, case_pair *pair);
void generate_smallest_edge_edge(random_state *random, case_pair *pair);

// The same at the sum of the roundings, or at the border between two reported distances.
void generate_smallest_rounded(random_state *random, case_pair *pair);

#endif
