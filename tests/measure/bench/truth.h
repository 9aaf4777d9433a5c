// The true answer to a pair.
#ifndef BENCH_TRUTH_H
#define BENCH_TRUTH_H

#include "method.h"

// Sets the true distance: the library's own answer, proven in exact integers, and the real distance of the feature that
// the proof names. False, with the reason, if it cannot be proven.
bool bench_find_distance(bench_pair *pair, char *why, size_t n);

// How a depth is known to be the least.
// BENCH_DEPTH_EXACT: by exact integers (tests/support/exact/depth.h), or because the cores are apart, so that the
// certificate proves it.
// BENCH_DEPTH_CERTIFIED: it is that of the facet that the certificate names, and the reference in double knows of none
// that is lower by more than an LSB of rounding.
typedef enum bench_depth_proof { BENCH_DEPTH_EXACT, BENCH_DEPTH_CERTIFIED, BENCH_DEPTH_UNPROVEN } bench_depth_proof;

// Sets the real depth of a pair that intersects. thorough: by exact integers for shapes of up to some 40 vertices,
// which takes a tenth of a second; else only where that takes no time.
bench_depth_proof bench_find_depth(bench_pair *pair, bool thorough, char *why, size_t n);

#endif
