// Versions: what a program may rely on from one release to the next.
#ifndef GJK_VERSION_H
#define GJK_VERSION_H

// The API, by semantic versioning (semver.org): a program that compiles and runs with MAJOR.MINOR.PATCH does so with
// every later release of the same MAJOR. While MAJOR is 0, this holds only within the same MINOR.
#define GJK_VERSION_MAJOR 0
#define GJK_VERSION_MINOR 1
#define GJK_VERSION_PATCH 0

// The bits: builds with the same GJK_BITS_VERSION and GJK_ITERATIONS_MAX answer the same calls with the same integers,
// whatever the compiler, target and port. Only iterations and certificates may differ, since they describe the search.
// A release that changes one bit of one answer raises the number. Lockstep peers and replays compare it.
// tests/check/target/golden.h holds hashes of answers for it.
//
// Scene blocks have a version of their own, GJK_SCENE_BLOCK_VERSION of gjk/scene.h.
#define GJK_BITS_VERSION 6

#endif
