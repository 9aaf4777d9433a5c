// What a kind of shape of the plane provides: one constant table per kind, which the initialisers of gjk2/shape.h name.
#ifndef GJK2_SRC_CLASS_H
#define GJK2_SRC_CLASS_H

#include "gjk2/collider.h"
#include "gjk2_vector.h"

// The extent of a shape's core, shape frame.
typedef struct gjk2_extent {
  gjk2_vec centre;   // of the core's bounding box
  uint64_t squared;  // the square of the core's largest distance from centre; gjk2_collider_init bounds it
  bool ordered;      // see gjk2_collider
} gjk2_extent;

// A vertex of a shape, or the way to one.
typedef struct gjk2_support {
  gjk2_vec offset;  // from the collider's centre, Q16.16; at most core_radius long. Of a way: from another vertex
  uint16_t vertex;  // the vertex's number; 0 for curved shapes
} gjk2_support;

static inline void gjk2_copy_support(gjk2_support *to, const gjk2_support *from) {
  gjk2_copy(&to->offset, &from->offset);
  to->vertex = from->vertex;
}

// Goes the way to another vertex.
static inline void gjk2_follow(gjk2_support *at, const gjk2_support *way) {
  at->offset = gjk2_add(at->offset, way->offset);
  at->vertex = way->vertex;
}

struct gjk2_ground_queries;
struct gjk2_search;
struct gjk2_edge;
struct gjk2_distance_result;

// Measures a pair of points, segments and boxes without a search: see gjk2_close.h. Only builds for speed with 64-bit
// registers have it.
bool gjk2_touch_axes(const gjk2_collider *a, const gjk2_collider *b, unsigned parts, struct gjk2_distance_result *out);
#if GJK_64_BIT && !GJK_SMALL
#define GJK2_TOUCH_AXES gjk2_touch_axes
#else
#define GJK2_TOUCH_AXES NULL
#endif

struct gjk2_shape_class {
  // Checks the shape's own fields and measures its core. gjk2_collider_init checks the convex radius.
  gjk_status (*measure)(const gjk2_shape *shape, gjk2_extent *out);

  // Fills frame and buffer of a collider for a rotation, and ordered where it depends on the pose.
  // Pre: initialised; fraction is set.
  void (*pose)(gjk2_collider *collider, const gjk2_vec *rotation);

  // The vertex that is farthest along d. Among equally far ones the choice depends on shape, pose and d alone.
  // Pre: d != 0, |d| <= 3 2^29.
  void (*support)(const gjk2_collider *collider, const gjk2_vec *d, gjk2_support *out);

  // The offset of the vertex with a number; false where there is none. NULL for curved shapes.
  bool (*vertex)(const gjk2_collider *collider, uint16_t number, gjk2_vec *offset);

  // The way from a vertex to the one that follows counterclockwise, or precedes it, and that one's number, where the
  // collider's vertices are ordered. NULL for curved shapes.
  void (*adjacent)(const gjk2_collider *collider, const gjk2_support *from, bool following, gjk2_support *way);

  // gjk2_curved_depth of gjk2_curved_depth.h for curved shapes, so that programs without any do not link it; else NULL.
  bool (*depth)(struct gjk2_search *s, struct gjk2_edge *edge, int64_t *lower, uint16_t *iterations);

  // GJK2_TOUCH_AXES for points and segments, so that programs without any do not link it; else NULL. If it is set,
  // adjacent of a point or segment leads from one end to the other.
  bool (*touch)(const gjk2_collider *a, const gjk2_collider *b, unsigned parts, struct gjk2_distance_result *out);

  // The queries of ground, which no other query takes; NULL for all other shapes.
  const struct gjk2_ground_queries *ground;

  bool buffered;  // a collider may have a buffer for posed vertices
  uint8_t count;  // vertices; where buffered is set the shape's own count is taken
};

// Is the shape an ellipse or a custom shape, which have no vertices?
static inline bool gjk2_is_curved(const gjk2_shape *shape) {
  return GJK_SHAPES >= GJK_SHAPES_ALL && shape->type->vertex == NULL;
}

// May a collider have a buffer for posed vertices?
static inline bool gjk2_is_buffered(const gjk2_shape_class *type) {
  return GJK_SHAPES >= GJK_SHAPES_POLYTOPES && type->buffered;
}

// Does a build for GJK_SHAPES know shapes of this kind?
static inline bool gjk2_is_known(const gjk2_shape_class *type) {
  const unsigned most = GJK_SHAPES == GJK_SHAPES_POINTS ? 1 : GJK_SHAPES == GJK_SHAPES_ROUND ? 2 : 4;
  return GJK_SHAPES >= GJK_SHAPES_ALL ||
         (type->vertex != NULL &&
          (GJK_SHAPES == GJK_SHAPES_POLYTOPES || (!type->buffered && type->count != 3 && type->count <= most)));
}

// The state of a collider. Other values are those of memory that was never initialised.
#define GJK2_STATE_INITIALISED UINT16_C(0x3267)
#define GJK2_STATE_POSED UINT16_C(0x3268)

// The arguments that all queries have: GJK_ERROR_NULL, GJK_ERROR_UNINITIALISED or GJK_OK.
static inline gjk_status gjk2_check_pair(const gjk2_collider *a, const gjk2_collider *b, const void *out) {
  if (a == NULL || b == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  if (GJK_SHAPES <= GJK_SHAPES_POINTS && (a->count > 1 || b->count > 1)) {
    return GJK_ERROR_UNSUPPORTED;  // a segment of ground
  }
  return a->state == GJK2_STATE_POSED && b->state == GJK2_STATE_POSED ? GJK_OK : GJK_ERROR_UNINITIALISED;
}

#endif
