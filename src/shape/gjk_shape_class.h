// What a kind of shape provides: one constant table per kind, which the initialisers of gjk/shape.h name.
#ifndef GJK_SRC_SHAPE_CLASS_H
#define GJK_SRC_SHAPE_CLASS_H

#include "../arith/gjk_vector.h"
#include "gjk/collider.h"

// The extent of a shape's core, shape frame.
typedef struct gjk_extent {
  gjk_vec3 centre;   // of the core's bounding box
  uint64_t squared;  // the square of the core's largest distance from centre; gjk_collider_init bounds it
} gjk_extent;

// What frame and buffer of a collider hold, for code that looks at faces and edges, not only at support points.
typedef enum gjk_kind {
  GJK_KIND_SMOOTH,    // rotation rows; no faces or edges
  GJK_KIND_AXES,      // half axes: a vertex is the centre with each half axis added or subtracted
  GJK_KIND_VERTICES,  // a list of vertices
  GJK_KIND_CYLINDER,  // rotation rows
  GJK_KIND_CONE       // rotation rows
} gjk_kind;

struct gjk_iteration;

// For points and segments: src/gjk/gjk_close.c. A build that knows no others asks for it by its name.
bool gjk_close_segments(struct gjk_iteration *it);
#if GJK_SHAPES <= GJK_SHAPES_ROUND
#define GJK_CLOSE_SEGMENTS NULL
#else
#define GJK_CLOSE_SEGMENTS gjk_close_segments
#endif

struct gjk_shape_class {
  // Checks the shape's own fields and measures its core. gjk_collider_init checks the convex radius.
  gjk_status (*measure)(const gjk_shape *shape, gjk_extent *out);

  // Fills frame and buffer of a collider for the rotation with these rows, Q2.30. Pre: initialised; fraction is set.
  void (*pose)(gjk_collider *collider, const gjk_vec3 rows[3]);

  // The vertex that is farthest along d. Among equally far ones the choice depends on shape, pose and d alone.
  // Pre: d != 0, |d| <= 2^31.
  void (*support)(const gjk_collider *collider, const gjk_vec3 *d, gjk_support *out);

  // Moves *at, the support along d, to a vertex that is farthest along *direction, which d approximates. Returns whether *at has
  // moved, and in direction->ties what is as far. NULL for curved shapes, which have no vertices to choose from.
  // For GJK_KIND_VERTICES *at may be any vertex; with GJK_CONDITIONAL_MOVES also for GJK_KIND_AXES.
  bool (*refine)(const gjk_collider *collider, const gjk_vec3 *d, gjk_direction *direction, gjk_support *at);

  // The offset of the vertex with a number; false where there is none. NULL for curved shapes.
  bool (*vertex)(const gjk_collider *collider, uint16_t number, gjk_vec3 *offset);

  // Does an iteration that moves from one vertex of the pair's frame to another along d gain too little to go on for?
  // late: the search is long. NULL for polytopes: their searches end, since they run out of vertices.
  // Pre: see gjk_iteration.h.
  bool (*stalls)(const gjk_vec3 *d, const gjk_vec3 *from, const gjk_vec3 *to, int shift, bool late);

  // Sets the feature of two shapes that have the same function here, and the direction from it: the one that a search
  // would find. Counts as one iteration. False: a search is needed, and the simplex is empty. NULL for most kinds.
  bool (*close)(struct gjk_iteration *it);

  // For bodies of many parts, which only a scene takes: src/scene/gjk_scene_concave.h. NULL for all other shapes.
  const struct gjk_scene_concave *concave;

  bool buffered;  // a collider may have a buffer for posed vertices
  uint8_t count;  // half axes or vertices; where buffered is set the shape's own count is taken
  uint8_t kind;   // a gjk_kind
};

// Is the shape a cylinder, cone, ellipsoid or custom shape, which have no vertices?
static inline bool gjk_is_curved(const gjk_shape *shape) {
  return GJK_SHAPES >= GJK_SHAPES_ALL && shape->type->stalls != NULL;
}

// May a collider have a buffer for posed vertices?
static inline bool gjk_is_buffered(const gjk_shape_class *type) {
  return GJK_SHAPES >= GJK_SHAPES_POLYTOPES && type->buffered;
}

// Does a build for GJK_SHAPES know shapes of this kind?
static inline bool gjk_is_known(const gjk_shape_class *type) {
  const unsigned end = GJK_SHAPES == GJK_SHAPES_BOXES ? 4 : GJK_SHAPES == GJK_SHAPES_ROUND ? 2 : 1;  // of half axes
  return GJK_SHAPES >= GJK_SHAPES_ALL ||
         (GJK_SHAPES == GJK_SHAPES_POLYTOPES ? type->stalls == NULL : type->kind == GJK_KIND_AXES && type->count < end);
}

// Is the shape a point, segment or box, and not one of a query's own?
static inline bool gjk_has_half_axes(const gjk_shape *shape) {
  return GJK_SHAPES <= GJK_SHAPES_BOXES || shape->type->kind == GJK_KIND_AXES;
}

// The state of a collider. Other values are those of memory that was never initialised.
#define GJK_STATE_INITIALISED UINT16_C(0x676A)
#define GJK_STATE_POSED UINT16_C(0x676B)

// The arguments that all queries have: GJK_ERROR_NULL, GJK_ERROR_UNINITIALISED or GJK_OK.
static inline gjk_status gjk_check_pair(const gjk_collider *a, const gjk_collider *b, const void *out) {
  if (a == NULL || b == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  return a->state == GJK_STATE_POSED && b->state == GJK_STATE_POSED ? GJK_OK : GJK_ERROR_UNINITIALISED;
}

#endif
