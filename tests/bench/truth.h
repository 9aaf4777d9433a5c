// The true answer to a pair.
#ifndef BENCH_TRUTH_H
#define BENCH_TRUTH_H

#include "method.h"

// Distances: the library's own answer, proven in exact integers, and the real distance of the feature that the proof names.
// False, with the reason, when it cannot be proven.
bool bench_find_distance(bench_pair *pair, char *why, size_t n);

// How a depth is known to be the least: by brute force over all directions; or as that of a facet, which the library's
// certificate names, while the reference, in double, knows of none that is lower.
typedef enum bench_depth_proof { BENCH_DEPTH_BRUTE, BENCH_DEPTH_CERTIFIED, BENCH_DEPTH_UNPROVEN } bench_depth_proof;

// Of a pair that intersects: the real depth of the facet. thorough: by brute force up to shapes of some 40 vertices,
// which takes a tenth of a second, not only where it takes no time.
bench_depth_proof bench_find_depth(bench_pair *pair, bool thorough, char *why, size_t n);

#endif
