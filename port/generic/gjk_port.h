// Port for any C99 compiler: asserts compiled out, portable primitives.
#ifndef GJK_GENERIC_PORT_H
#define GJK_GENERIC_PORT_H

// Bytes of the arena behind gjk_port_allocate, a multiple of 8.
#ifndef GJK_ARENA_BYTES
#define GJK_ARENA_BYTES 4096
#endif
#if GJK_ARENA_BYTES <= 0 || GJK_ARENA_BYTES % 8 != 0
#error "GJK_ARENA_BYTES must be a positive multiple of 8: define it for the whole build, for example -DGJK_ARENA_BYTES=8192"
#endif

#define GJK_ASSERT(condition) ((void)0)

#endif
