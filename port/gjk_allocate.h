// Allocation for what a user builds above the core: vertices of baked hulls, scenes. The core never allocates.
#ifndef GJK_ALLOCATE_H
#define GJK_ALLOCATE_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

// bytes of memory, aligned for any of the library's types, contents undefined. NULL when there is not that much left,
// and for 0 bytes.
void *gjk_port_allocate(size_t bytes);

// Gives back memory of gjk_port_allocate, once; NULL is ignored. A port may reuse it late: see its own file.
void gjk_port_release(void *memory);

#ifdef __cplusplus
}
#endif

#endif
