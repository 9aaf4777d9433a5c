// What a kind of body of many parts provides: one constant table per kind, which its initialiser names.
//
// A class knows its parts in the body's own frame, by their numbers, and walks through those whose boxes a region meets. The
// queries know no more about it. So a walk may stop, and its region may shrink, at any time.
#ifndef GJK_SRC_PARTS_CLASS_H
#define GJK_SRC_PARTS_CLASS_H

#include "../shape/gjk_shape_class.h"
#include "gjk/parts.h"
#include "gjk_region.h"

// Where a walk is; zeroed: at its start. Only the class knows what the numbers mean.
typedef struct gjk_parts_walk {
  uint32_t node, item;
} gjk_parts_walk;

// A body as it stands in a query: its rotation as a matrix.
typedef struct gjk_parts_frame {
  const gjk_parts *parts;
  gjk_vec3 rows[3];
  bool is_level;  // the rotation is the identity
} gjk_parts_frame;

// A part in its body's frame, for motions: a shape, and where its pose is; own NULL: at the body's.
typedef struct gjk_parts_local {
  const gjk_shape *shape;
  const gjk_pose *own;
} gjk_parts_local;

// A flag beside the edges of a triangle: there are contacts on both sides.
#define GJK_TRIANGLE_TWO_SIDED 64u

struct gjk_parts_class {
  // How many parts there are. 0: none.
  uint32_t (*count)(const void *data);

  // Bounds the distance of parts' points, and of the positions of their poses, from the body's origin, at any rotation,
  // rounding included. Body positions nearer than that to an end of int32 are refused, so place cannot leave it.
  uint32_t (*reach)(const void *data);

  // A part that is likely to be near the region. Any part is right; a good guess saves work. GJK_PARTS_NONE, for
  // impacts only: none.
  uint32_t (*guess)(const void *data, const gjk_region *region);

  // The next part whose box the region meets, each once, in an order that is fixed by data. False: there is none left.
  // Whether a part is met depends on its own box and the region alone, since the box of a group holds those of its
  // parts.
  bool (*next)(const void *data, const gjk_region *region, gjk_parts_walk *walk, uint32_t *number);

  // Makes the posed collider of a part. room: for the shape, where the class makes one. Pre: there is a part of this number,
  // and the body is in range. Statuses as gjk_collider_init and gjk_collider_pose; RANGE: data has no such part after all.
  gjk_status (*place)(const gjk_parts_frame *frame, uint32_t number, gjk_parts_room *room, gjk_collider *out);

  // The shape of a part and its pose in the body's frame. RANGE: data has no such part after all.
  gjk_status (*local)(const void *data, uint32_t number, gjk_parts_room *room, gjk_parts_local *out);

  // Drops or turns contacts of a part with B that the whole body does not have, such as those of an inner edge of a mesh:
  // changes *m. False: none is left. NULL: all are right.
  bool (*settle)(const gjk_parts_frame *frame, uint32_t number, const gjk_collider *b, gjk_manifold *m);

  // The contacts of a part with B that the whole body has, in place of gjk_contacts: gjk_surface_meet. NULL: gjk_contacts.
  gjk_status (*meet)(const gjk_parts_frame *frame, uint32_t number, const gjk_collider *b, gjk_q16 margin,
                     unsigned most, gjk_cache *cache, const gjk_workspace *workspace, gjk_manifold *out);

  // What is known of a triangle's edges and sides: src/mesh/gjk_triangle.h. For surfaces of triangles; NULL for others.
  unsigned (*edges)(const void *data, uint32_t number);
};

// With the body at this position, do all parts stay in int32 at any rotation?
bool gjk_parts_has_room(const gjk_parts *parts, const gjk_vec3 *position);

// The start of every query: checks A, and sets its frame.
// Statuses: NULL, EMPTY, ROTATION, RANGE.
gjk_status gjk_parts_frame_set(gjk_parts_frame *frame, const gjk_parts *a);

// The same, checks B too, and starts the region with B's box, grown by 0. Statuses: UNINITIALISED too.
gjk_status gjk_parts_open(gjk_parts_frame *frame, gjk_region *region, const gjk_parts *a, const gjk_collider *b);

// The next part of the walk, as the class has it.
static inline bool gjk_parts_next(const gjk_parts_frame *frame, const gjk_region *region, gjk_parts_walk *walk,
                                  uint32_t *number) {
  return frame->parts->type->next(frame->parts->data, region, walk, number);
}

static inline gjk_status gjk_parts_place_in(const gjk_parts_frame *frame, uint32_t number, gjk_parts_room *room,
                                            gjk_collider *out) {
  return frame->parts->type->place(frame, number, room, out);
}

static inline void gjk_parts_walk_start(gjk_parts_walk *walk) {
  walk->node = 0;
  walk->item = 0;
}

#endif
