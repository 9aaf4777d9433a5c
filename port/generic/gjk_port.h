// Port for any C99 compiler: asserts compiled out, primitives in portable C, allocation from a fixed arena.
#ifndef GJK_GENERIC_PORT_H
#define GJK_GENERIC_PORT_H

#define GJK_ASSERT(condition) ((void)0)

// Bytes of the arena in gjk_arena.c.
#ifndef GJK_ARENA_BYTES
#define GJK_ARENA_BYTES 4096
#endif
#if GJK_ARENA_BYTES < 64 || GJK_ARENA_BYTES % 16 != 0
#error "GJK_ARENA_BYTES must be a multiple of 16 from 64 on: define it for the whole build, say -DGJK_ARENA_BYTES=8192"
#endif

#endif
