// The true answer to a pair.
#ifndef BENCH_TRUTH_H
#define BENCH_TRUTH_H

#include "method.h"

// Distances: the library's own answer, proven in exact integers, and the real distance of the feature that the proof
// names. False, with the reason, when it cannot be proven.
bool bench_find_distance(bench_pair *pair, char *why, size_t n);

// How a depth is known to be the least: by exact integers, see tests/support/exact/depth.h, or because the cores are apart, so
// that the library's certificate proves it; or as that of a facet that the certificate names, while the reference, in
// double, knows of none that is lower by more than the rounding to an LSB.
typedef enum bench_depth_proof { BENCH_DEPTH_EXACT, BENCH_DEPTH_CERTIFIED, BENCH_DEPTH_UNPROVEN } bench_depth_proof;

// Of a pair that intersects: the real depth. thorough: by exact integers for shapes of up to some 40 vertices, which
// takes a tenth of a second, not only where it takes no time.
bench_depth_proof bench_find_depth(bench_pair *pair, bool thorough, char *why, size_t n);

#endif
