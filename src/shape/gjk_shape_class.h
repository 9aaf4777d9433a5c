// What a kind of shape provides. One constant table per kind, named by the initialisers of gjk/shape.h.
#ifndef GJK_SRC_SHAPE_CLASS_H
#define GJK_SRC_SHAPE_CLASS_H

#include "../arith/gjk_vector.h"
#include "gjk/collider.h"

// The core of a shape in its own frame, without rounding.
typedef struct gjk_extent {
  gjk_vec3 centre;   // of the bounding box
  uint64_t squared;  // of the largest distance from it, at most GJK_RADIUS_MAX^2
} gjk_extent;

// What a collider of the class holds, for those that look at more than its supports.
typedef enum gjk_kind {
  GJK_KIND_SMOOTH,    // nothing to look at
  GJK_KIND_AXES,      // half axes: its vertices are the centre with each of them added or subtracted
  GJK_KIND_VERTICES,  // a list of vertices
  GJK_KIND_CYLINDER,  // rotation rows
  GJK_KIND_CONE       // rotation rows
} gjk_kind;

struct gjk_shape_class {
  // Checks the shape's own fields and measures it; round is checked by the caller.
  gjk_status (*measure)(const gjk_shape *shape, gjk_extent *out);

  // Fills frame and buffer of an initialised collider, its fraction set, for a rotation given by its rows, Q2.30.
  void (*pose)(gjk_collider *collider, const gjk_vec3 rows[3]);

  // The farthest vertex along d; among equals the one that the kind prefers, always the same.
  // Pre: d != 0, |d| <= 2^31.
  void (*support)(const gjk_collider *collider, const gjk_vec3 *d, gjk_support *out);

  // Moves *at, the support along d, to a vertex that is farthest along the exact direction, of which d is the rounded
  // one. Returns whether it moved. NULL: curved, there are no vertices to choose from.
  bool (*refine)(const gjk_collider *collider, const gjk_vec3 *d, const gjk_direction *direction, gjk_support *at);

  // The offset of a vertex by its number; false: there is none. NULL: curved.
  bool (*vertex)(const gjk_collider *collider, uint16_t number, gjk_vec3 *offset);

  // Does a step of the search along d, from one vertex of the pair's frame to another, gain too little to go on for? late: the
  // search is long. For kinds without vertices alone, NULL for the others, which run out of vertices. Pre: see gjk/iteration.h.
  bool (*stalls)(const gjk_vec3 *d, const gjk_vec3 *from, const gjk_vec3 *to, int shift, bool late);

  bool buffered;  // takes a buffer for the vertices of the shape
  uint8_t count;  // half axes or vertices; 0 with buffered: the shape's own count
  uint8_t kind;   // a gjk_kind
};

// Has the shape no vertices: a cylinder, cone, ellipsoid or a user's own?
static inline bool gjk_is_curved(const gjk_shape *shape) {
  return shape->type->stalls != NULL;
}

#define GJK_STATE_INITIALISED UINT16_C(0x676A)
#define GJK_STATE_POSED UINT16_C(0x676B)

// NULL, UNINITIALISED or OK.
static inline gjk_status gjk_check_pair(const gjk_collider *a, const gjk_collider *b, const void *out) {
  if (a == NULL || b == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  return a->state == GJK_STATE_POSED && b->state == GJK_STATE_POSED ? GJK_OK : GJK_ERROR_UNINITIALISED;
}

#endif
