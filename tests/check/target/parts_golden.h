// Three numbers over every bit that fixed sets of queries answer about bodies of many parts, meshes and height fields: the
// same on every target.
#ifndef PARTS_GOLDEN_H
#define PARTS_GOLDEN_H

#include <stdint.h>

#include "gjk/version.h"

// Bodies in the full set, and in the start of it that small emulated cores have time for; many: a larger set, for hosts.
#define PARTS_GOLDEN_BODIES 600
#define PARTS_GOLDEN_FEW_BODIES 20
#define PARTS_GOLDEN_MANY_BODIES 3000

// A changed bit is a changed contract: raise GJK_BITS_VERSION with these, and say why in the commit. The host's golden
// program prints the lines to put here.
#if GJK_BITS_VERSION != 6
#error "the golden hashes are those of GJK_BITS_VERSION 6: replace them"
#endif
#define PARTS_GOLDEN_HASH UINT64_C(0xb4956bb2be60918c)
#define PARTS_GOLDEN_MANY_HASH UINT64_C(0x73d3aba612671fa6)
#define PARTS_GOLDEN_FEW_HASH UINT64_C(0xdc9a2d3b3275697e)
#define PARTS_CONTACTS_GOLDEN_HASH UINT64_C(0x2e91854d10ae0a64)
#define PARTS_CONTACTS_GOLDEN_MANY_HASH UINT64_C(0x138ab69fe975d0e5)
#define PARTS_CONTACTS_GOLDEN_FEW_HASH UINT64_C(0xda538e221bf9921b)
#define PARTS_MOTION_GOLDEN_HASH UINT64_C(0xd20e99a673259d65)
#define PARTS_MOTION_GOLDEN_MANY_HASH UINT64_C(0xb67d02f4ac41db67)
#define PARTS_MOTION_GOLDEN_FEW_HASH UINT64_C(0x9ec51f1c0f52d67f)

// The hash over the first bodies of the set: of decisions, distances and depths, of contacts, of casts and times of impact.
// Not reentrant: the bodies are static, to spare small stacks.
uint64_t parts_golden_hash(uint32_t bodies);
uint64_t parts_contacts_golden_hash(uint32_t bodies);
uint64_t parts_motion_golden_hash(uint32_t bodies);

#endif
