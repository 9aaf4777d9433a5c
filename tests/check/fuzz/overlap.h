// Checks depths and contacts of a pair, for the fuzzer of pairs.
#ifndef FUZZ_OVERLAP_H
#define FUZZ_OVERLAP_H

#include "bytes.h"

// Checks the answers to gjk_penetration, gjk_signed_distance and gjk_contacts: certificates by the exact oracle, by
// brute force where the vertices are few, and all that follows from the contracts. gap: gjk_distance's answer; bytes:
// give a cache, workspace and margin. Returns NULL, or what does not hold, with the reason in why.
const char *fuzz_check_overlap(const gjk_collider *a, const gjk_collider *b, const gjk_distance_result *gap,
                               fuzz_bytes *bytes, char *why, size_t n);

#endif
