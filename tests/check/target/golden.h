// One hash over every bit of the answers to a fixed set of queries. It is the same on every target.
#ifndef GOLDEN_H
#define GOLDEN_H

#include <stdint.h>

// Pairs in the full set, and in its first part, which small emulated cores have time for.
#define GOLDEN_PAIRS 3000
#define GOLDEN_FEW_PAIRS 150

// A changed bit is a changed contract: a commit that changes these says why.
#define GOLDEN_HASH UINT64_C(0x048919c62155e23e)
#define GOLDEN_FEW_HASH UINT64_C(0xfb69ea89e4a25dba)

// The hash over the first pairs of the set. Not reentrant: the colliders are static, as small stacks have no room for
// them.
uint64_t golden_hash(uint32_t pairs);

#endif
