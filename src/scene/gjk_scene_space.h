// A scene's records in space, and what the code of scenes takes from space: vectors, boxes, rotations, colliders.
//
// Scenes of the plane have the same source files. src/plane_scene has their records and functions of these names;
// src/README.md tells how.
#ifndef GJK_SRC_SCENE_SPACE_H
#define GJK_SRC_SCENE_SPACE_H

#include "../arith/gjk_ceilings.h"
#include "../arith/gjk_rotation.h"
#include "../arith/gjk_vector.h"
#include "../shape/gjk_shape_class.h"
#include "gjk/cache.h"
#include "gjk/distance.h"
#include "gjk/intersect.h"
#include "gjk/pose.h"
#include "gjk/scene.h"
#include "gjk_scene_common.h"
#include "gjk_scene_concave.h"

// The first word of a block: "gjks" in a little-endian one.
#define GJK_SCENE_MAGIC UINT32_C(0x736B6A67)

// The version of the block's format.
#define GJK_SCENE_VERSION GJK_SCENE_BLOCK_VERSION

// The ceilings on casts of the build, as a block says them.
#define GJK_SCENE_CASTS (GJK_CAST_ITERATIONS_MAX * UINT32_C(65536) + GJK_ADVANCE_ROUNDS_MAX)

// How many contacts a report has at most.
#define GJK_SCENE_CONTACTS 4

// Do parts of some shapes lack what posing sets? Not in space.
#define GJK_SCENE_POSES_AGAIN 0

// The gap at which parts that turn count as touching.
#define GJK_SCENE_TOLERANCE GJK_IMPACT_TOLERANCE_MIN

// How many coordinates a vector has.
#define GJK_SCENE_AXES 3

// An index that names no record.
#define GJK_SCENE_NONE UINT32_MAX

// An index as its field holds it.
#define GJK_SCENE_INDEX(x) (x)

// A height of a node as its field holds it.
#define GJK_SCENE_HEIGHT(x) (x)

typedef struct gjk_scene_body {
  uint32_t generation;  // odd: in use
  gjk_vec3 position;
  gjk_quat rotation;
  uint32_t category, mask, user;
  gjk_q16 margin;
  uint32_t first;       // part, or none
  uint32_t next_moved;  // slot, or none
  uint16_t parts;       // how many
  uint8_t kind_detail;  // kind | detail << 4
  uint8_t flags;
} gjk_scene_body;

typedef struct gjk_scene_part {
  uint32_t next;      // part of the body, or none
  uint32_t body;      // slot
  uint32_t parent;    // inner node, or none
  uint32_t pairs;     // first link, see gjk_scene_linked_pair, or none
  uint32_t own_pose;  // index, or none: the part is at the body's pose
  uint32_t motion;    // bounds how far any of its points has moved since the last update, LSB
  gjk_vec3 centre, local_centre, frame[3];
  gjk_q16 core_radius;
  gjk_aabb exact;     // of the part
  gjk_aabb enlarged;  // in the tree: holds exact, grown by the body's margin
  uint16_t shape, number;
  uint8_t state;
  int8_t fraction[3];  // of the centre
} gjk_scene_part;

typedef struct gjk_scene_node {
  uint32_t child[2];
  uint32_t parent;  // inner node, or none
  uint32_t height;  // over the leaves, whose height is 0; 0: the record is free
  gjk_aabb box;
} gjk_scene_node;

typedef struct gjk_scene_own_pose {
  uint32_t next;  // the part that has it
  gjk_pose pose;  // in the body's frame
} gjk_scene_own_pose;

// Where a body whose motion is kept was, and what it meets on its way.
typedef struct gjk_scene_kept {
  uint32_t slot;
  gjk_pose last;      // at the last update, or where the body was put since then
  uint32_t other;     // part that it meets first, or none
  uint32_t fraction;  // where; before it is swept: bounds the ways of all others, LSB
  uint16_t number;    // of its own part
  uint16_t state;
} gjk_scene_kept;

// A pair that is in the lists of its two parts. A link names a place in such a list: the pair's index times two, plus
// the side of the part whose list it is.
typedef struct gjk_scene_linked_pair {
  uint32_t part[2];               // part[0] is of the body with the lower slot
  uint32_t next[2], previous[2];  // links, or none
} gjk_scene_linked_pair;

// A pair that is gone is in the list header.gone alone. It holds what its report says, because its parts may be free.
typedef struct gjk_scene_gone_pair {
  uint32_t slot[2], generation[2];  // of the bodies
  uint32_t next;                    // pair, or none
} gjk_scene_gone_pair;

// Two parts whose enlarged boxes meet, or that were near at the last update.
//
// gap  the distance of a near pair, or minus its depth, if its detail asks for that. Otherwise by how much the pair is
//      proven farther apart than its margins, or nearer, if it is near; 0: nothing is proven.
typedef struct gjk_scene_pair {
  union {
    gjk_scene_linked_pair linked;  // state without GJK_SCENE_PAIR_GONE
    gjk_scene_gone_pair gone;      // state with it
  } ends;
  int32_t gap;
  union {
    int16_t direction[3];   // linked: as in gjk_cache
    uint16_t gone_part[2];  // gone: numbers of the parts
  } hint;
  uint8_t a[4], b[4];  // cached vertices
  uint8_t state;
  uint8_t outcome;  // while it is queued a gjk_scene_outcome, in a queue of reports a gjk_event
} gjk_scene_pair;

struct gjk_scene_view;

struct gjk_scene_details {
  gjk_status (*signed_distance)(const gjk_collider *a, const gjk_collider *b, gjk_cache *cache,
                                const gjk_workspace *workspace, gjk_distance_result *out);

  // The manifold of two parts, of a body with a lower slot first. cache: as of gjk_contacts. Statuses as of
  // gjk_scene_manifold; or NULL
  gjk_status (*manifold)(const struct gjk_scene_view *v, const gjk_scene_part *a, const gjk_scene_part *b,
                         unsigned most, gjk_cache *cache, gjk_manifold *out);
};

static inline bool gjk_aabb_meet(const gjk_aabb *a, const gjk_aabb *b) {
  return a->lower.x <= b->upper.x && b->lower.x <= a->upper.x && a->lower.y <= b->upper.y && b->lower.y <= a->upper.y &&
         a->lower.z <= b->upper.z && b->lower.z <= a->upper.z;
}

// Is a inside b?
static inline bool gjk_aabb_inside(const gjk_aabb *a, const gjk_aabb *b) {
  return a->lower.x >= b->lower.x && a->upper.x <= b->upper.x && a->lower.y >= b->lower.y && a->upper.y <= b->upper.y &&
         a->lower.z >= b->lower.z && a->upper.z <= b->upper.z;
}

// Every build must lay the records out alike: a block may come from another one. The configuration and the header are
// checked where they are known.
typedef char sizes_are_fixed[sizeof(gjk_scene_body) == 60 && sizeof(gjk_scene_part) == 144 &&
                                     sizeof(gjk_scene_node) == 40 && sizeof(gjk_scene_own_pose) == 32 &&
                                     sizeof(gjk_scene_pair) == 44 && sizeof(gjk_scene_config) == 32 &&
                                     sizeof(gjk_scene_kept) == 44
                                 ? 1
                                 : -1];

// Bytes of a header.
#define GJK_SCENE_HEADER_BYTES 296

// Binds to a handle; NULL: nothing.
static inline void gjk_scene_set_bindings(gjk_scene *scene, const gjk_scene_bindings *bindings) {
  scene->bindings.predicate = bindings != NULL ? bindings->predicate : NULL;
  scene->bindings.user = bindings != NULL ? bindings->user : NULL;
  scene->bindings.details = bindings != NULL ? bindings->details : NULL;
  scene->bindings.workspace = bindings != NULL ? bindings->workspace : NULL;
  scene->bindings.manifolds = bindings != NULL ? bindings->manifolds : NULL;
  scene->bindings.motion = bindings != NULL ? bindings->motion : NULL;
  scene->bindings.keeps_manifolds = bindings != NULL && bindings->keeps_manifolds;
}

// The ends and links of a pair, by side.
static inline uint32_t gjk_scene_end(const gjk_scene_pair *pair, unsigned side) {
  return pair->ends.linked.part[side];
}

static inline uint32_t gjk_scene_next(const gjk_scene_pair *pair, unsigned side) {
  return pair->ends.linked.next[side];
}

static inline uint32_t gjk_scene_previous(const gjk_scene_pair *pair, unsigned side) {
  return pair->ends.linked.previous[side];
}

static inline void gjk_scene_set_end(gjk_scene_pair *pair, unsigned side, uint32_t part) {
  pair->ends.linked.part[side] = part;
}

static inline void gjk_scene_set_next(gjk_scene_pair *pair, unsigned side, uint32_t link) {
  pair->ends.linked.next[side] = link;
}

static inline void gjk_scene_set_previous(gjk_scene_pair *pair, unsigned side, uint32_t link) {
  pair->ends.linked.previous[side] = link;
}

// Forgets what the last query of a pair left for the next one. Its state has no cached vertices.
static inline void gjk_scene_clear_hint(gjk_scene_pair *pair) {
  pair->hint.direction[0] = 0;
  pair->hint.direction[1] = 0;
  pair->hint.direction[2] = 0;
}

// The next one in the list of pairs that are gone, and what the report of a pair that is gone says of a side.
static inline uint32_t gjk_scene_gone_next(const gjk_scene_pair *pair) {
  return pair->ends.gone.next;
}

static inline gjk_scene_side gjk_scene_gone_side(const gjk_scene_pair *pair, unsigned side) {
  const gjk_scene_side result = {pair->ends.gone.slot[side], pair->ends.gone.generation[side],
                                 pair->hint.gone_part[side]};
  return result;
}

// Makes a linked pair gone.
static inline void gjk_scene_set_gone(gjk_scene_pair *pair, const gjk_scene_side side[2], uint32_t next) {
  for (int i = 0; i < 2; i++) {
    pair->hint.gone_part[i] = side[i].part;
    pair->ends.gone.slot[i] = side[i].slot;
    pair->ends.gone.generation[i] = side[i].generation;
  }
  pair->ends.gone.next = next;
}

// How many parts a body has.
static inline uint32_t gjk_scene_part_count(const gjk_scene_body *body, const gjk_scene_part *parts) {
  (void)parts;
  return body->parts;
}

static inline void gjk_scene_set_part_count(gjk_scene_body *body, uint16_t count) {
  body->parts = count;
}

// How many cells of the workspace depths may use: part of what decides answers.
static inline uint32_t gjk_scene_cells(const gjk_scene_config *config) {
  return config->workspace_cells;
}

// The least box that holds both.
static inline gjk_aabb gjk_aabb_hull(const gjk_aabb *a, const gjk_aabb *b) {
  gjk_aabb box = *a;
  box.lower.x = b->lower.x < box.lower.x ? b->lower.x : box.lower.x;
  box.lower.y = b->lower.y < box.lower.y ? b->lower.y : box.lower.y;
  box.lower.z = b->lower.z < box.lower.z ? b->lower.z : box.lower.z;
  box.upper.x = b->upper.x > box.upper.x ? b->upper.x : box.upper.x;
  box.upper.y = b->upper.y > box.upper.y ? b->upper.y : box.upper.y;
  box.upper.z = b->upper.z > box.upper.z ? b->upper.z : box.upper.z;
  return box;
}

// The cost of a box in the tree, an eighth of the sum of its sides:  < 3 2^29
static inline uint32_t gjk_scene_cost(const gjk_aabb *box) {
  return gjk_scene_side_cost(box->lower.x, box->upper.x) + gjk_scene_side_cost(box->lower.y, box->upper.y) +
         gjk_scene_side_cost(box->lower.z, box->upper.z);
}

// Is lower > upper along an axis?
static inline bool gjk_aabb_is_empty(const gjk_aabb *box) {
  return box->lower.x > box->upper.x || box->lower.y > box->upper.y || box->lower.z > box->upper.z;
}

// The largest gap of two boxes along an axis, 0 when they meet: a lower bound of their distance.
static inline uint32_t gjk_aabb_gap(const gjk_aabb *a, const gjk_aabb *b) {
  const uint32_t x = gjk_larger_gap(0, a->lower.x, a->upper.x, b->lower.x, b->upper.x);
  const uint32_t y = gjk_larger_gap(x, a->lower.y, a->upper.y, b->lower.y, b->upper.y);
  return gjk_larger_gap(y, a->lower.z, a->upper.z, b->lower.z, b->upper.z);
}

static inline bool gjk_scene_same_vec3(const gjk_vec3 *a, const gjk_vec3 *b) {
  return a->x == b->x && a->y == b->y && a->z == b->z;
}

static inline bool gjk_scene_same_rotation(const gjk_quat *a, const gjk_quat *b) {
  return a->x == b->x && a->y == b->y && a->z == b->z && a->w == b->w;
}

// Is it a unit within the tolerance of the public calls?
static inline bool gjk_scene_is_rotation(const gjk_quat *q) {
  int64_t deviation;
  return gjk_quat_deviation(q, &deviation);
}

// Are all coordinates below 2^bits in size? Pre: bits < 31.
static inline bool gjk_scene_is_below(const gjk_vec3 *v, unsigned bits) {
  const uint32_t half = UINT32_C(1) << bits;
  return (((uint32_t)v->x + half) | ((uint32_t)v->y + half) | ((uint32_t)v->z + half)) >> (bits + 1) == 0;
}

// to - from, modulo 2^32.
static inline void gjk_scene_way(const gjk_vec3 *from, const gjk_vec3 *to, gjk_vec3 *way) {
  way->x = gjk_int32((uint32_t)to->x - (uint32_t)from->x);
  way->y = gjk_int32((uint32_t)to->y - (uint32_t)from->y);
  way->z = gjk_int32((uint32_t)to->z - (uint32_t)from->z);
}

static inline void gjk_scene_set_zero(gjk_vec3 *v) {
  v->x = v->y = v->z = 0;
}

// The point at a length from another one along a unit vector, to the nearest LSB, saturated:  |length| * 2^30 <= 2^61
static inline gjk_vec3 gjk_scene_ahead(const gjk_vec3 *from, const gjk_unit3 *n, gjk_q16 length) {
  const int64_t half = INT64_C(1) << 29;
  const gjk_vec3 at = {gjk_saturate(from->x + gjk_sar64(gjk_mul32(n->x, length) + half, 30)),
                       gjk_saturate(from->y + gjk_sar64(gjk_mul32(n->y, length) + half, 30)),
                       gjk_saturate(from->z + gjk_sar64(gjk_mul32(n->z, length) + half, 30))};
  return at;
}

// One word after another into a hash.
static inline uint64_t gjk_scene_mix_vec3(uint64_t hash, const gjk_vec3 *v) {
  return gjk_hash_step(gjk_hash_step(gjk_hash_step(hash, (uint32_t)v->x), (uint32_t)v->y), (uint32_t)v->z);
}

static inline uint64_t gjk_scene_mix_rotation(uint64_t hash, const gjk_quat *q) {
  hash = gjk_hash_step(gjk_hash_step(hash, (uint32_t)q->x), (uint32_t)q->y);
  return gjk_hash_step(gjk_hash_step(hash, (uint32_t)q->z), (uint32_t)q->w);
}

// How far the rotation from a to b moves points, Q30: at most by this times their distance from the axis.
// Pre: both are unit quaternions within the tolerance of gjk/pose.h.
//
// If unit quaternions are d apart, the rotation between them moves a point by at most 2 d times its distance from the
// axis: with t = angle / 4, d = 2 sin t, and the point moves by 2 sin 2t = 4 sin t cos t. q and -q are the same
// rotation, so the nearer one counts. Quaternions of lengths within 2^-17 of 1 change d by less than 2^-16 of itself,
// which d + d / 2^15 + 1 covers.
static inline uint32_t gjk_scene_rotation_bound(const gjk_quat *a, const gjk_quat *b) {
  //@ assert a->x >= -0x40002000L && a->y >= -0x40002000L && a->z >= -0x40002000L && a->w >= -0x40002000L;
  //@ assert a->x <= 0x40002000L && a->y <= 0x40002000L && a->z <= 0x40002000L && a->w <= 0x40002000L;
  //@ assert b->x >= -0x40002000L && b->y >= -0x40002000L && b->z >= -0x40002000L && b->w >= -0x40002000L;
  //@ assert b->x <= 0x40002000L && b->y <= 0x40002000L && b->z <= 0x40002000L && b->w <= 0x40002000L;
  const int64_t dot = gjk_mac32(gjk_mac32(gjk_mac32(gjk_mul32(a->x, b->x), a->y, b->y), a->z, b->z), a->w, b->w);
  const int32_t sign = dot < 0 ? -1 : 1;
  // |a - b| <= sqrt(2) 2^30 (1 + 2^-17):  sum < 2^31.6
  const uint32_t x = gjk_scene_difference(a->x, sign * b->x), y = gjk_scene_difference(a->y, sign * b->y);
  const uint32_t z = gjk_scene_difference(a->z, sign * b->z), w = gjk_scene_difference(a->w, sign * b->w);
  const uint32_t sum = x + y + z + w;
  if (sum == 0) {
    return 0;
  }
  const uint32_t distance = gjk_scene_length_bound(
      sum, gjk_scene_larger(gjk_scene_larger(x, y), gjk_scene_larger(z, w)));  // distance < 2^31.2
  return distance < UINT32_C(1) << 30 ? 2 * (distance + (distance >> 15) + 1) : UINT32_MAX;
}

// An upper bound of the distance from a to b. UNBOUNDED when they are 2^30 or more apart along an axis.
static inline uint32_t gjk_scene_distance_bound(const gjk_vec3 *a, const gjk_vec3 *b) {
  const uint32_t x = gjk_scene_difference(a->x, b->x), y = gjk_scene_difference(a->y, b->y);
  const uint32_t z = gjk_scene_difference(a->z, b->z);
  if ((x | y | z) >> 30 != 0) {
    return GJK_SCENE_UNBOUNDED;
  }
  return (x | y | z) == 0 ? 0 : gjk_scene_length_bound(x + y + z, gjk_scene_larger(x, gjk_scene_larger(y, z)));
}

// v + step, which fits.
static inline void gjk_scene_shift(gjk_vec3 *v, const gjk_vec3 *step) {
  v->x = gjk_scene_plus(v->x, step->x);
  v->y = gjk_scene_plus(v->y, step->y);
  v->z = gjk_scene_plus(v->z, step->z);
}

static inline gjk_vec3 gjk_scene_equal_vec3(int32_t x) {
  const gjk_vec3 v = {x, x, x};
  return v;
}

// Grows a box by margin all round, and by steps times way on the sides it points to.
static inline void gjk_scene_grow(gjk_aabb *box, int32_t margin, const gjk_vec3 *way, int32_t steps) {
  gjk_scene_grow_side(&box->lower.x, &box->upper.x, margin, steps * way->x);
  gjk_scene_grow_side(&box->lower.y, &box->upper.y, margin, steps * way->y);
  gjk_scene_grow_side(&box->lower.z, &box->upper.z, margin, steps * way->z);
}

// The centre of the shape's box, in the shape's frame.
static inline const gjk_vec3 *gjk_scene_local_centre(const gjk_scene_part *part, const gjk_shape *shape) {
  (void)shape;
  return &part->local_centre;
}

// Is the shape a polytope, or made of several?
static inline bool gjk_scene_has_vertices(const gjk_shape *shape) {
  return !gjk_is_curved(shape);
}

// Is the core a point?
static inline bool gjk_scene_is_point(const gjk_shape *shape) {
  return gjk_has_half_axes(shape) && shape->type->count == 0;
}

// Writes a part as a posed collider with lazy hulls.
static inline void gjk_scene_load(const gjk_scene_part *part, const gjk_shape *shape, gjk_collider *out) {
  out->shape = shape;
  out->buffer = NULL;
  out->position = part->centre;
  out->centre = part->centre;
  out->local_centre = part->local_centre;
  out->frame[0] = part->frame[0];
  out->frame[1] = part->frame[1];
  out->frame[2] = part->frame[2];
  out->core_radius = part->core_radius;
  out->radius = part->core_radius + shape->convex_radius;
  for (int i = 0; i < 3; i++) {
    out->fraction[i] = part->fraction[i];
  }
  out->state = GJK_STATE_POSED;
  out->count = shape->type->buffered ? shape->count : shape->type->count;
  out->bits = (uint8_t)(32 - gjk_clz32((uint32_t)part->core_radius));
}

// Stores what posing sets.
static inline void gjk_scene_store(const gjk_collider *c, gjk_scene_part *part) {
  part->centre = c->centre;
  part->frame[0] = c->frame[0];
  part->frame[1] = c->frame[1];
  part->frame[2] = c->frame[2];
  for (int i = 0; i < 3; i++) {
    part->fraction[i] = c->fraction[i];
  }
}

// Stores what follows from the shape alone.
static inline void gjk_scene_store_shape(const gjk_collider *c, gjk_scene_part *part) {
  part->local_centre = c->local_centre;
  part->core_radius = c->core_radius;
}

// Does a part hold what gjk_scene_store_shape stored?
static inline bool gjk_scene_holds_shape(const gjk_scene_part *p, const gjk_collider *c) {
  return gjk_scene_same_vec3(&p->local_centre, &c->local_centre) && p->core_radius == c->core_radius;
}

// Does a part hold what gjk_scene_store stored?
static inline bool gjk_scene_holds(const gjk_scene_part *p, const gjk_collider *c) {
  return gjk_scene_same_vec3(&p->centre, &c->centre) && gjk_scene_same_vec3(&p->frame[0], &c->frame[0]) &&
         gjk_scene_same_vec3(&p->frame[1], &c->frame[1]) && gjk_scene_same_vec3(&p->frame[2], &c->frame[2]) &&
         p->fraction[0] == c->fraction[0] && p->fraction[1] == c->fraction[1] && p->fraction[2] == c->fraction[2];
}

// Does a part that is to be posed hold what posing leaves as it is: 0?
static inline bool gjk_scene_holds_unposed(const gjk_scene_part *p, const gjk_collider *c) {
  static const gjk_vec3 origin = {0, 0, 0};
  const gjk_shape_class *type = c->shape->type;
  for (unsigned i = type->count; i < 3 && gjk_has_half_axes(c->shape); i++) {
    if (!gjk_scene_same_vec3(&p->frame[i], &origin)) {
      return false;
    }
  }
  return true;
}

static inline bool gjk_scene_is_zero(const gjk_vec3 *v) {
  return (v->x | v->y | v->z) == 0;
}

// The direction of a cache.
static inline gjk_vec3 gjk_scene_direction(const int16_t direction[3]) {
  const gjk_vec3 d = {direction[0], direction[1], direction[2]};
  return d;
}

static inline bool gjk_scene_is_zero_direction(const int16_t direction[3]) {
  return (direction[0] | direction[1] | direction[2]) == 0;
}

// The direction that a pair keeps of its last query; 0: none. room is where it may be written, as in the plane.
// NOLINTNEXTLINE(readability-non-const-parameter)
static inline const int16_t *gjk_scene_hint(const gjk_scene_pair *pair, int16_t room[3]) {
  (void)room;
  return pair->hint.direction;
}

// Is the shape a body of many parts? Then its code is in the class.
static inline bool gjk_scene_is_concave(const gjk_shape *shape) {
  return shape->type->concave != NULL;
}

// Binds a collider to a shape of a part. Statuses as gjk_collider_init.
static inline gjk_status gjk_scene_bind(gjk_collider *c, const gjk_shape *shape) {
  return shape != NULL && shape->type != NULL && gjk_scene_is_concave(shape) ? shape->type->concave->bind(shape, c)
                                                                             : gjk_collider_init(c, shape, NULL, 0);
}

static inline bool gjk_scene_is_amid(gjk_q16 x) {
  return x <= INT32_MAX - GJK_CONCAVE_REACH && x >= -(INT32_MAX - GJK_CONCAVE_REACH);
}

// Does a part stay in int32 at any rotation? Of a convex one its collider tells.
static inline bool gjk_scene_has_room(const gjk_shape *shape, const gjk_vec3 *position) {
  return !gjk_scene_is_concave(shape) ||
         (gjk_scene_is_amid(position->x) && gjk_scene_is_amid(position->y) && gjk_scene_is_amid(position->z));
}

// The rotation of a motion is along the shortest arc.
#define gjk_scene_no_spin(motion) gjk_scene_set_zero(&(motion)->spin)

// Makes the normal of a manifold 0.
static inline void gjk_scene_no_normal(gjk_manifold *manifold) {
  manifold->normal.x = manifold->normal.y = manifold->normal.z = 0;
}

// Writes the part of the bound workspace that the configuration lets depths use. False: it has fewer cells.
bool gjk_scene_workspace(const gjk_scene *scene, gjk_workspace *out);

// Is there what depths need besides bindings.details?
static inline bool gjk_scene_has_workspace(const gjk_scene *scene) {
  gjk_workspace workspace;
  return gjk_scene_workspace(scene, &workspace);
}

// The distance, or minus the depth, by bindings.details.
static inline gjk_status gjk_scene_signed_distance(const gjk_scene *scene, const gjk_collider *a, const gjk_collider *b,
                                                   gjk_cache *cache, gjk_distance_result *out) {
  gjk_workspace workspace;
  gjk_scene_workspace(scene, &workspace);
  return scene->bindings.details->signed_distance(a, b, cache, &workspace, out);
}

#endif
