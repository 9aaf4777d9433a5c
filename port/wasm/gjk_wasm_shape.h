// What the files of this port share: shapes in memory of their own, and the report.
#ifndef GJK_WASM_SHAPE_H
#define GJK_WASM_SHAPE_H

#include "gjk_wasm.h"

// A collider with all that it points to, in one block.
typedef struct gjk_wasm_shape {
  gjk_collider collider;  // first: its address is that of the block
  gjk_shape shape;
  gjk_hull_faces faces;
  uint32_t users;       // the caller, until it releases the shape, and each scene
  gjk_vec3 vertices[];  // the shape's, then room for posed ones, then corners and ends of faces
} gjk_wasm_shape;

// Enough for polytopes of 1000 vertices together, and for curved shapes.
extern const gjk_workspace gjk_wasm_workspace;

void gjk_wasm_begin(void);
void gjk_wasm_put(int32_t value);
void gjk_wasm_put_vector(int32_t x, int32_t y, int32_t z);

// Count, normal and features, then points, distance and id of each contact.
void gjk_wasm_put_manifold(const gjk_manifold *m);

// The report begins with a status. NULL.
void *gjk_wasm_fails(gjk_status status);

// Binds the collider of a block to its shape at the origin. NULL: the block is released.
gjk_collider *gjk_wasm_finish(gjk_wasm_shape *made);

#endif
