// Compounds: several convex shapes at poses as one body (gjk/parts.h), which may be concave.
//
//     static const gjk_compound_part parts[] = {{&seat, GJK_POSE_IDENTITY}, {&back, {{0, 0, GJK_Q16(0.5)}, {...}}}};
//     static gjk_compound_node nodes[GJK_COMPOUND_NODES(2)];
//     gjk_compound chair;
//     gjk_compound_build(parts, 2, nodes, GJK_COMPOUND_NODES(2), &chair);
//     gjk_parts body = GJK_PARTS_OF_COMPOUND(&chair);
//     gjk_parts_distance(&body, &ball, &part, &result);
#ifndef GJK_COMPOUND_H
#define GJK_COMPOUND_H

#include "gjk/parts.h"

#ifdef __cplusplus
extern "C" {
#endif

// The functions behind compounds.
extern const gjk_parts_class gjk_parts_class_compound;

// The most parts of one compound.
#define GJK_COMPOUND_PARTS_MAX 32767

// Up to this many parts the boxes form a plain list; with more they are the leaves of a tree.
#define GJK_COMPOUND_LIST_MAX 8

// The number of nodes for this many parts.
#define GJK_COMPOUND_NODES(parts) ((parts) <= GJK_COMPOUND_LIST_MAX ? (parts) : 2 * (parts)-1)

// One part: a shape and its pose. Both are the caller's constants.
typedef struct gjk_compound_part {
  const gjk_shape *shape;  // of any kind
  gjk_pose pose;           // in the frame of the compound
} gjk_compound_part;

// A box of the tree, in the frame of the compound. The order of the nodes is that of a walk, which needs no stack. If
// the box is met, the walk goes on to the next node, otherwise to skip.
typedef struct gjk_compound_node {
  gjk_aabb box;   // box of the part, or of all parts below
  uint16_t skip;  // the node after all those below this one
  uint16_t part;  // number of the part; UINT16_MAX: not a leaf
} gjk_compound_node;

// A compound. Its contents are the library's; gjk_compound_build fills it. It may be copied.
typedef struct gjk_compound {
  const gjk_compound_part *parts;  // count parts
  const gjk_compound_node *nodes;  // node_count nodes
  uint32_t reach;  // bound of the distance of any point of a part, or of a part's position, from the compound's origin
  uint16_t count, node_count;  // numbers of parts and of nodes
} gjk_compound;

// A body of this compound at the identity pose.
#define GJK_PARTS_OF_COMPOUND(compound) \
  { &gjk_parts_class_compound, 1 ? (compound) : (const gjk_compound *)0, GJK_POSE_IDENTITY }

// Checks the parts, and builds the boxes of a compound.
//
// parts     count parts, the caller's; must stay as they are while the compound is used.
// nodes     room for capacity nodes, at least GJK_COMPOUND_NODES(count); the caller's. Nodes hold no pointers, and the
//           same parts give the same nodes on every machine.
// out       written when the result is GJK_OK; nodes may be written in any case.
// Rounding  A part's pose is gjk_pose_compose of the body's pose and its own, so it is rounded once. Its position is
//           within 1 LSB up to 8192 units from the body's position, and within 4 LSB beyond. Its rotation is within
//           0.501 LSB of Q2.30. The shape is then posed like any other.
// Statuses  NULL; EMPTY; SIZE: more than GJK_COMPOUND_PARTS_MAX parts; CAPACITY; ROTATION of a part's pose. RANGE: a
//           part leaves int32 in the frame of the compound. Also those of gjk_collider_init for a part's shape.
// Cost      of the order of count times the square of log count.
gjk_status gjk_compound_build(const gjk_compound_part *parts, uint16_t count, gjk_compound_node *nodes,
                              uint32_t capacity, gjk_compound *out);

#ifdef __cplusplus
}
#endif

#endif
