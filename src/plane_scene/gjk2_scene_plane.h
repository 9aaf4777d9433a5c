// A scene's records in the plane, and what the code of scenes takes from the plane: vectors, boxes, rotations,
// colliders. src/scene/gjk_scene_space.h has the same of space.
//
// The records are packed: an index takes 24 bits, and what fits beside it shares its word. So a body with one part takes
// 160 bytes, and a pair 32 with its place in the queue.
#ifndef GJK2_SRC_SCENE_PLANE_H
#define GJK2_SRC_SCENE_PLANE_H

#include "../arith/gjk_ceilings.h"
#include "../ground/gjk2_ground_box.h"
#include "../plane/gjk2_class.h"
#include "../plane/gjk2_measure.h"
#include "../plane/gjk2_rotation.h"
#include "../scene/gjk_scene_common.h"
#include "gjk2/cache.h"
#include "gjk2/distance.h"
#include "gjk2/ground.h"
#include "gjk2/impact.h"
#include "gjk2/intersect.h"
#include "gjk2/pose.h"
#include "gjk2/scene.h"
#include "gjk2_scene_ground.h"

// The first word of a block: "gjs2" in a little-endian one.
#define GJK2_SCENE_MAGIC UINT32_C(0x32736A67)

// The version of the block's format.
#define GJK2_SCENE_VERSION GJK2_SCENE_BLOCK_VERSION

// The ceiling on casts of the build, as a block says it.
#define GJK2_SCENE_CASTS (GJK2_ADVANCE_ROUNDS_MAX + UINT32_C(0))

// How many contacts a report has at most.
#define GJK2_SCENE_CONTACTS GJK2_CONTACTS_MAX

// Do parts of some shapes lack what posing sets? In the plane they do: gjk2_scene_is_to_pose.
#define GJK2_SCENE_POSES_AGAIN 1

// The gap at which parts that turn count as touching.
#define GJK2_SCENE_TOLERANCE GJK2_IMPACT_TOLERANCE_MIN

// How many coordinates a vector has.
#define GJK2_SCENE_AXES 2

// An index that names no record. Parts, links of pairs and slots are below 2^23.
#define GJK2_SCENE_NONE UINT32_C(0xFFFFFF)

// An index as its field holds it.
#define GJK2_SCENE_INDEX(x) ((x)&GJK2_SCENE_NONE)

// A height of a node as its field holds it.
#define GJK2_SCENE_HEIGHT(x) ((x)&UINT32_C(0xFF))

// gjk2_scene_part.state: the collider's vertices are ordered.
#define GJK2_SCENE_ORDERED 16u

typedef struct gjk2_scene_body {
  uint32_t generation;  // odd: in use
  gjk2_vec position;
  gjk2_rotation rotation;
  uint32_t category, mask, user;
  gjk_q16 margin;
  uint32_t first : 24;       // part, or none
  uint32_t kind_detail : 8;  // kind | detail << 4
  uint32_t next_moved : 24;  // slot, or none
  uint32_t flags : 8;
} gjk2_scene_body;

// frame  of a shape made of half axes: these, from the centre. Otherwise the rotation, Q2.30, and the centre of the
//        shape's box in the shape's frame. A triangle has no rotation here, and is posed whenever it is needed.
typedef struct gjk2_scene_part {
  uint32_t next;         // part of the body, or none
  uint32_t body;         // slot
  uint32_t parent : 24;  // inner node, or none
  uint32_t state : 8;
  uint32_t pairs : 24;     // first link, see gjk2_scene_next, or none
  int32_t fraction_x : 8;  // of the centre
  uint32_t own_pose : 24;  // index, or none: the part is at the body's pose
  int32_t fraction_y : 8;
  uint32_t motion;  // bounds how far any of its points has moved since the last update, LSB
  gjk2_vec centre, frame[2];
  gjk_q16 core_radius;
  gjk2_aabb exact;     // of the part
  gjk2_aabb enlarged;  // in the tree: holds exact, grown by the body's margin
  uint16_t shape, number;
} gjk2_scene_part;

typedef struct gjk2_scene_node {
  uint32_t child[2];
  uint32_t parent : 24;  // inner node, or none
  uint32_t height : 8;   // over the leaves, whose height is 0; 0: the record is free
  gjk2_aabb box;
} gjk2_scene_node;

typedef struct gjk2_scene_own_pose {
  uint32_t next;   // the part that has it
  gjk2_pose pose;  // in the body's frame
} gjk2_scene_own_pose;

// Where a body whose motion is kept was, and what it meets on its way.
typedef struct gjk2_scene_kept {
  uint32_t slot;
  gjk2_pose last;     // at the last update, or where the body was put since then
  uint32_t other;     // part that it meets first, or none
  uint32_t fraction;  // where; before it is swept: bounds the ways of all others, LSB
  uint16_t number;    // of its own part
  uint16_t state;
} gjk2_scene_kept;

// Two parts whose enlarged boxes meet, or that were near at the last update; or a pair that is gone.
//
// gap   linked: the distance of a near pair, or minus its depth, if its detail asks for that. Otherwise by how much the
//       pair is proven farther apart than its margins, or nearer, if it is near; 0: nothing is proven.
//       gone: the generation of side 0.
// low, high  six indices, see gjk2_scene_index. Linked: the two parts, their next and their previous links, as
//       gjk_scene_linked_pair has them. Gone: the two slots; the numbers of the two parts; the next pair that is gone.
// hint  linked: what the next query starts from. Where state counts no cached vertices: the direction as in gjk2_cache.
//       Otherwise the vertices of A and of B, a byte each. Gone: the generation of side 1.
typedef struct gjk2_scene_pair {
  int32_t gap;
  uint16_t low[6];
  uint8_t high[6];
  uint8_t state;
  uint8_t outcome;  // while it is queued a gjk_scene_outcome, in a queue of reports a gjk_event
  uint16_t hint[2];
} gjk2_scene_pair;

// Every build must lay the records out alike: a block may come from another one.
typedef char gjk2_scene_sizes_are_fixed[sizeof(gjk2_scene_body) == 44 && sizeof(gjk2_scene_part) == 88 &&
                                                sizeof(gjk2_scene_node) == 28 && sizeof(gjk2_scene_own_pose) == 20 &&
                                                sizeof(gjk2_scene_pair) == 28 && sizeof(gjk2_scene_config) == 28 &&
                                                sizeof(gjk2_scene_kept) == 32
                                            ? 1
                                            : -1];

// Bytes of a header.
#define GJK2_SCENE_HEADER_BYTES 292

struct gjk2_scene_view;

// What the class of ground brings along, so that only programs that mention it link it: the queries of a pair, one of which
// is ground. Two grounds are never near, and meet nowhere.
//
// a, b    the parts; NULL: a collider that is no part. on_a, on_b: their posed colliders.
struct gjk2_ground_queries {
  // Makes a collider of the box, not yet posed. Statuses as gjk2_collider_init.
  gjk_status (*bind)(const gjk2_shape *shape, gjk2_collider *out);

  gjk_status (*within)(const struct gjk2_scene_view *v, const gjk2_scene_part *a, const gjk2_scene_part *b,
                       const gjk2_collider *on_a, const gjk2_collider *on_b, gjk_q16 distance, gjk2_decision *out);

  // depth: an overlap has minus its depth.
  gjk_status (*distance)(const struct gjk2_scene_view *v, const gjk2_scene_part *a, const gjk2_scene_part *b,
                         const gjk2_collider *on_a, const gjk2_collider *on_b, bool depth, gjk2_distance_result *out);

  // Of the deepest contact.
  gjk_status (*manifold)(const struct gjk2_scene_view *v, const gjk2_scene_part *a, const gjk2_scene_part *b,
                         const gjk2_collider *on_a, const gjk2_collider *on_b, gjk_q16 margin, unsigned most,
                         gjk2_manifold *out);

  // A is ground that stands.
  gjk_status (*cast)(const struct gjk2_scene_view *v, const gjk2_scene_part *a, const gjk2_collider *on_a,
                     const gjk2_collider *b, const gjk2_cast_path *path, gjk2_cast_result *out);
  gjk_status (*ray)(const struct gjk2_scene_view *v, const gjk2_scene_part *a, const gjk2_collider *on_a,
                    const gjk2_vec *from, const gjk2_vec *to, gjk2_cast_result *out);

  // Where two parts first touch on their ways, at whose start they have these poses; hit, inside and fraction are set.
  // ahead: as of gjk2_ground_cast_ahead.
  gjk_status (*way)(const gjk2_collider c[2], const gjk2_pose pose[2], const gjk2_cast_path *path, bool ahead,
                    gjk2_cast_result *out);

  // gjk2_scene_ground_impact.
  gjk_status (*impact)(const gjk2_collider c[2], const gjk2_motion motion[2], gjk_q16 margin, const gjk2_motion *ahead,
                       gjk2_impact_query *query, gjk2_impact_result *out);
};

struct gjk2_scene_details {
  gjk_status (*signed_distance)(const gjk2_collider *a, const gjk2_collider *b, gjk2_cache *cache,
                                gjk2_distance_result *out);

  // The manifold of two parts, of a body with a lower slot first. cache: as of gjk2_contacts. Statuses as of
  // gjk2_scene_manifold; or NULL
  gjk_status (*manifold)(const struct gjk2_scene_view *v, const gjk2_scene_part *a, const gjk2_scene_part *b,
                         unsigned most, gjk2_cache *cache, gjk2_manifold *out);
};

// Binds to a handle; NULL: nothing.
static inline void gjk2_scene_set_bindings(gjk2_scene *scene, const gjk2_scene_bindings *bindings) {
  scene->bindings.predicate = bindings != NULL ? bindings->predicate : NULL;
  scene->bindings.user = bindings != NULL ? bindings->user : NULL;
  scene->bindings.details = bindings != NULL ? bindings->details : NULL;
  scene->bindings.manifolds = bindings != NULL ? bindings->manifolds : NULL;
  scene->bindings.motion = bindings != NULL ? bindings->motion : NULL;
  scene->bindings.keeps_manifolds = bindings != NULL && bindings->keeps_manifolds;
}

// One of the six indices of a pair.
static inline uint32_t gjk2_scene_index(const gjk2_scene_pair *pair, unsigned place) {
  return (uint32_t)pair->high[place] << 16 | pair->low[place];
}

static inline void gjk2_scene_set_index(gjk2_scene_pair *pair, unsigned place, uint32_t index) {
  pair->low[place] = (uint16_t)(index & 0xFFFFu);
  pair->high[place] = (uint8_t)(index >> 16 & 0xFFu);
}

// The ends and links of a pair, by side.
static inline uint32_t gjk2_scene_end(const gjk2_scene_pair *pair, unsigned side) {
  return gjk2_scene_index(pair, side);
}

static inline uint32_t gjk2_scene_next(const gjk2_scene_pair *pair, unsigned side) {
  return gjk2_scene_index(pair, 2 + side);
}

static inline uint32_t gjk2_scene_previous(const gjk2_scene_pair *pair, unsigned side) {
  return gjk2_scene_index(pair, 4 + side);
}

static inline void gjk2_scene_set_end(gjk2_scene_pair *pair, unsigned side, uint32_t part) {
  gjk2_scene_set_index(pair, side, part);
}

static inline void gjk2_scene_set_next(gjk2_scene_pair *pair, unsigned side, uint32_t link) {
  gjk2_scene_set_index(pair, 2 + side, link);
}

static inline void gjk2_scene_set_previous(gjk2_scene_pair *pair, unsigned side, uint32_t link) {
  gjk2_scene_set_index(pair, 4 + side, link);
}

// Forgets what the last query of a pair left for the next one. Its state has no cached vertices.
static inline void gjk2_scene_clear_hint(gjk2_scene_pair *pair) {
  pair->hint[0] = 0;
  pair->hint[1] = 0;
}

// The next one in the list of pairs that are gone, and what the report of a pair that is gone says of a side.
static inline uint32_t gjk2_scene_gone_next(const gjk2_scene_pair *pair) {
  return gjk2_scene_index(pair, 4);
}

static inline gjk_scene_side gjk2_scene_gone_side(const gjk2_scene_pair *pair, unsigned side) {
  gjk_scene_side result;
  result.slot = gjk2_scene_index(pair, side);
  result.generation = side == 0 ? (uint32_t)pair->gap : (uint32_t)pair->hint[1] << 16 | pair->hint[0];
  result.part = pair->low[2 + side];
  return result;
}

// Makes a linked pair gone.
static inline void gjk2_scene_set_gone(gjk2_scene_pair *pair, const gjk_scene_side side[2], uint32_t next) {
  for (unsigned i = 0; i < 2; i++) {
    gjk2_scene_set_index(pair, i, side[i].slot);
    gjk2_scene_set_index(pair, 2 + i, side[i].part);
  }
  gjk2_scene_set_index(pair, 4, next);
  pair->gap = gjk_int32(side[0].generation);
  pair->hint[0] = (uint16_t)(side[1].generation & 0xFFFFu);
  pair->hint[1] = (uint16_t)(side[1].generation >> 16);
}

// How many parts a body has.
static inline uint32_t gjk2_scene_part_count(const gjk2_scene_body *body, const gjk2_scene_part *parts) {
  uint32_t count = 0;
  for (uint32_t i = body->first; i != GJK2_SCENE_NONE; i = parts[i].next) {
    count++;
  }
  return count;
}

static inline void gjk2_scene_set_part_count(gjk2_scene_body *body, uint16_t count) {
  (void)body;
  (void)count;
}

// Depths of the plane need no workspace.
static inline uint32_t gjk2_scene_cells(const gjk2_scene_config *config) {
  (void)config;
  return 0;
}

static inline bool gjk2_scene_has_workspace(const gjk2_scene *scene) {
  (void)scene;
  return true;
}

// The distance, or minus the depth, by bindings.details.
static inline gjk_status gjk2_scene_signed_distance(const gjk2_scene *scene, const gjk2_collider *a,
                                                    const gjk2_collider *b, gjk2_cache *cache,
                                                    gjk2_distance_result *out) {
  return scene->bindings.details->signed_distance(a, b, cache, out);
}

// The rotation of a motion is along the shortest arc.
#define gjk2_scene_no_spin(motion) ((motion)->spin = 0)

// Makes the normal of a manifold 0.
static inline void gjk2_scene_no_normal(gjk2_manifold *manifold) {
  manifold->normal.x = manifold->normal.y = 0;
}

// The cost of a box in the tree, an eighth of the sum of its sides:  < 2^30
static inline uint32_t gjk2_scene_cost(const gjk2_aabb *box) {
  return gjk_scene_side_cost(box->lower.x, box->upper.x) + gjk_scene_side_cost(box->lower.y, box->upper.y);
}

// Is lower > upper along an axis?
static inline bool gjk2_aabb_is_empty(const gjk2_aabb *box) {
  return box->lower.x > box->upper.x || box->lower.y > box->upper.y;
}

static inline bool gjk2_aabb_meet(const gjk2_aabb *a, const gjk2_aabb *b) {
  return a->lower.x <= b->upper.x && b->lower.x <= a->upper.x && a->lower.y <= b->upper.y && b->lower.y <= a->upper.y;
}

// Is a inside b?
static inline bool gjk2_aabb_inside(const gjk2_aabb *a, const gjk2_aabb *b) {
  return a->lower.x >= b->lower.x && a->upper.x <= b->upper.x && a->lower.y >= b->lower.y && a->upper.y <= b->upper.y;
}

// The largest gap of two boxes along an axis, 0 when they meet: a lower bound of their distance.
static inline uint32_t gjk2_aabb_gap(const gjk2_aabb *a, const gjk2_aabb *b) {
  const uint32_t x = gjk_larger_gap(0, a->lower.x, a->upper.x, b->lower.x, b->upper.x);
  return gjk_larger_gap(x, a->lower.y, a->upper.y, b->lower.y, b->upper.y);
}

static inline bool gjk2_scene_same_vec(const gjk2_vec *a, const gjk2_vec *b) {
  return a->x == b->x && a->y == b->y;
}

static inline bool gjk2_scene_same_rotation(const gjk2_rotation *a, const gjk2_rotation *b) {
  return a->c == b->c && a->s == b->s;
}

// Is it a unit within the tolerance of the public calls?
static inline bool gjk2_scene_is_rotation(const gjk2_rotation *r) {
  int64_t deviation;
  return gjk2_rotation_deviation(r, &deviation);
}

// Are all coordinates below 2^bits in size? Pre: bits < 31.
static inline bool gjk2_scene_is_below(const gjk2_vec *v, unsigned bits) {
  const uint32_t half = UINT32_C(1) << bits;
  return (((uint32_t)v->x + half) | ((uint32_t)v->y + half)) >> (bits + 1) == 0;
}

static inline bool gjk2_scene_is_zero(const gjk2_vec *v) {
  return (v->x | v->y) == 0;
}

static inline void gjk2_scene_set_zero(gjk2_vec *v) {
  v->x = v->y = 0;
}

static inline gjk2_vec gjk2_scene_equal_vec(int32_t x) {
  const gjk2_vec v = {x, x};
  return v;
}

// to - from, modulo 2^32.
static inline void gjk2_scene_way(const gjk2_vec *from, const gjk2_vec *to, gjk2_vec *way) {
  way->x = gjk_int32((uint32_t)to->x - (uint32_t)from->x);
  way->y = gjk_int32((uint32_t)to->y - (uint32_t)from->y);
}

// v + step, which fits.
static inline void gjk2_scene_shift(gjk2_vec *v, const gjk2_vec *step) {
  v->x = gjk_scene_plus(v->x, step->x);
  v->y = gjk_scene_plus(v->y, step->y);
}

// Grows a box by margin all round, and by steps times way on the sides it points to.
static inline void gjk2_scene_grow(gjk2_aabb *box, int32_t margin, const gjk2_vec *way, int32_t steps) {
  gjk_scene_grow_side(&box->lower.x, &box->upper.x, margin, steps * way->x);
  gjk_scene_grow_side(&box->lower.y, &box->upper.y, margin, steps * way->y);
}

// The point at a length from another one along a unit vector, to the nearest LSB, saturated:  |length| * 2^30 <= 2^61
static inline gjk2_vec gjk2_scene_ahead(const gjk2_vec *from, const gjk2_unit *n, gjk_q16 length) {
  const int64_t half = INT64_C(1) << 29;
  const gjk2_vec at = {gjk_saturate(from->x + gjk_sar64(gjk_mul32(n->x, length) + half, 30)),
                       gjk_saturate(from->y + gjk_sar64(gjk_mul32(n->y, length) + half, 30))};
  return at;
}

// One word after another into a hash.
static inline uint64_t gjk2_scene_mix_vec(uint64_t hash, const gjk2_vec *v) {
  return gjk_hash_step(gjk_hash_step(hash, (uint32_t)v->x), (uint32_t)v->y);
}

static inline uint64_t gjk2_scene_mix_rotation(uint64_t hash, const gjk2_rotation *r) {
  return gjk_hash_step(gjk_hash_step(hash, (uint32_t)r->c), (uint32_t)r->s);
}

// An upper bound of the distance from a to b. UNBOUNDED when they are 2^30 or more apart along an axis.
static inline uint32_t gjk2_scene_distance_bound(const gjk2_vec *a, const gjk2_vec *b) {
  const uint32_t x = gjk_scene_difference(a->x, b->x), y = gjk_scene_difference(a->y, b->y);
  if ((x | y) >> 30 != 0) {
    return GJK_SCENE_UNBOUNDED;
  }
  return (x | y) == 0 ? 0 : gjk_scene_length_bound(x + y, gjk_scene_larger(x, y));
}

// How far the rotation from a to b moves points, Q30: at most by this times their distance from the origin.
// Pre: both are units within the tolerance of gjk2/pose.h.
//
// Units that are d apart move a point by d times its distance. With lengths other than 1, |a - b|^2 is at least |a| |b|
// times the square of that d. Lengths within 2^-17 of 1 change d by less than 2^-16 of itself, which d + d / 2^15 + 1
// covers.
static inline uint32_t gjk2_scene_rotation_bound(const gjk2_rotation *a, const gjk2_rotation *b) {
  // |a - b| <= 2^31 (1 + 2^-17), x + y < 2^31.6, the bound at most 9/8 of |a - b|:  < 2^31.2
  const uint32_t x = gjk_scene_difference(a->c, b->c), y = gjk_scene_difference(a->s, b->s);
  if ((x | y) == 0) {
    return 0;
  }
  const uint32_t distance = gjk_scene_length_bound(x + y, gjk_scene_larger(x, y));
  return distance + (distance >> 15) + 1;
}

// Is the shape a polytope? Ground has no vertices, whatever kinds of shapes the build knows.
static inline bool gjk2_scene_has_vertices(const gjk2_shape *shape) {
  return shape->type->vertex != NULL;
}

// Is the shape made of half axes: a point, segment or box? Polygons have a buffer, triangles three vertices.
static inline bool gjk2_scene_has_axes(const gjk2_shape *shape) {
  return gjk2_scene_has_vertices(shape) && !shape->type->buffered && shape->type->count != 3;
}

// Is the core a point?
static inline bool gjk2_scene_is_point(const gjk2_shape *shape) {
  return shape->type->count == 1;
}

// The centre of the shape's box, in the shape's frame.
static inline const gjk2_vec *gjk2_scene_local_centre(const gjk2_scene_part *part, const gjk2_shape *shape) {
  static const gjk2_vec origin = {0, 0};
  return gjk2_scene_has_axes(shape) ? &origin : &part->frame[1];
}

// Is what gjk2_scene_load writes of a shape to be posed again? A triangle's vertices are not stored.
static inline bool gjk2_scene_is_to_pose(const gjk2_shape *shape) {
  return !shape->type->buffered && shape->type->count == 3;
}

// Writes a part as a posed collider with lazy polygons.
static inline void gjk2_scene_load(const gjk2_scene_part *part, const gjk2_shape *shape, gjk2_collider *out) {
  const bool axes = gjk2_scene_has_axes(shape);
  out->shape = shape;
  out->buffer = NULL;
  out->position = part->centre;
  out->centre = part->centre;
  out->local_centre = *gjk2_scene_local_centre(part, shape);
  out->frame[0] = part->frame[0];
  gjk2_scene_set_zero(&out->frame[2]);
  out->frame[1] = axes ? part->frame[1] : out->frame[2];
  out->core_radius = part->core_radius;
  out->radius = part->core_radius + shape->convex_radius;
  out->state = GJK2_STATE_POSED;
  out->count = shape->type->buffered ? shape->count : shape->type->count;
  out->fraction[0] = (int8_t)part->fraction_x;
  out->fraction[1] = (int8_t)part->fraction_y;
  out->ordered = (part->state & GJK2_SCENE_ORDERED) != 0;
}

// Stores what posing sets.
static inline void gjk2_scene_store(const gjk2_collider *c, gjk2_scene_part *part) {
  part->centre = c->centre;
  part->fraction_x = c->fraction[0];
  part->fraction_y = c->fraction[1];
  part->state = (uint8_t)((part->state & ~GJK2_SCENE_ORDERED) | (c->ordered ? GJK2_SCENE_ORDERED : 0u));
  if (gjk2_scene_has_axes(c->shape)) {
    part->frame[0] = c->frame[0];
    part->frame[1] = c->frame[1];
  } else if (gjk2_scene_is_to_pose(c->shape)) {
    gjk2_scene_set_zero(&part->frame[0]);
  } else {
    part->frame[0] = c->frame[0];
  }
}

// Stores what follows from the shape alone.
static inline void gjk2_scene_store_shape(const gjk2_collider *c, gjk2_scene_part *part) {
  part->frame[1] = c->local_centre;
  part->core_radius = c->core_radius;
}

// Does a part hold what gjk2_scene_store_shape stored?
static inline bool gjk2_scene_holds_shape(const gjk2_scene_part *p, const gjk2_collider *c) {
  return gjk2_scene_same_vec(gjk2_scene_local_centre(p, c->shape), &c->local_centre) &&
         p->core_radius == c->core_radius;
}

// Does a part hold what gjk2_scene_store stored?
static inline bool gjk2_scene_holds(const gjk2_scene_part *p, const gjk2_collider *c) {
  static const gjk2_vec origin = {0, 0};
  const gjk2_vec *frame = gjk2_scene_is_to_pose(c->shape) ? &origin : &c->frame[0];
  return gjk2_scene_same_vec(&p->centre, &c->centre) && gjk2_scene_same_vec(&p->frame[0], frame) &&
         (!gjk2_scene_has_axes(c->shape) || gjk2_scene_same_vec(&p->frame[1], &c->frame[1])) &&
         p->fraction_x == c->fraction[0] && p->fraction_y == c->fraction[1] &&
         ((p->state & GJK2_SCENE_ORDERED) != 0) == c->ordered;
}

// Does a part that is to be posed hold what posing leaves as it is? Other vertices than those of half axes and triangles
// are ordered or not at every pose.
static inline bool gjk2_scene_holds_unposed(const gjk2_scene_part *p, const gjk2_collider *c) {
  return gjk2_scene_has_axes(c->shape) || gjk2_scene_is_to_pose(c->shape) ||
         ((p->state & GJK2_SCENE_ORDERED) != 0) == c->ordered;
}

// The direction of a cache.
static inline gjk2_vec gjk2_scene_direction(const int16_t direction[2]) {
  const gjk2_vec d = {direction[0], direction[1]};
  return d;
}

static inline bool gjk2_scene_is_zero_direction(const int16_t direction[2]) {
  return (direction[0] | direction[1]) == 0;
}

// Writes what a pair keeps of its last query.
static inline void gjk2_scene_load_cache(const gjk2_scene_pair *pair, gjk2_cache *cache) {
  const unsigned count = pair->state >> GJK_SCENE_PAIR_CACHED;
  cache->count = (uint16_t)count;
  for (unsigned i = 0; i < 2; i++) {
    cache->direction[i] = (int16_t)(count == 0 ? (int32_t)((pair->hint[i] ^ 0x8000u) & 0xFFFFu) - 0x8000 : 0);
    cache->a[i] = pair->hint[0] >> 8 * i & 0xFFu;
    cache->b[i] = pair->hint[1] >> 8 * i & 0xFFu;
  }
}

// The direction that a pair keeps of its last query; 0: none. room is where it may be written.
static inline const int16_t *gjk2_scene_hint(const gjk2_scene_pair *pair, int16_t room[2]) {
  gjk2_cache cache;
  gjk2_scene_load_cache(pair, &cache);
  room[0] = cache.direction[0];
  room[1] = cache.direction[1];
  return room;
}

// Can all vertices of a cache be kept? Their numbers have to fit a byte.
static inline bool gjk2_scene_fits_bytes(const gjk2_cache *cache) {
  bool fits = cache->count <= 2;
  for (unsigned i = 0; i < cache->count && i < 2; i++) {
    fits = fits && cache->a[i] < 256 && cache->b[i] < 256;
  }
  return fits;
}

// Keeps what a query left for the next one: the direction that separates a pair, the vertices of a near one.
static inline void gjk2_scene_store_cache(const gjk2_cache *cache, bool near, gjk2_scene_pair *pair) {
  const unsigned count = near && gjk2_scene_fits_bytes(cache) ? cache->count : 0;
  if (count > 0) {
    pair->hint[0] = (uint16_t)(cache->a[0] | (count > 1 ? (uint32_t)cache->a[1] << 8 : 0u));
    pair->hint[1] = (uint16_t)(cache->b[0] | (count > 1 ? (uint32_t)cache->b[1] << 8 : 0u));
  } else {
    pair->hint[0] = (uint16_t)((uint32_t)(int32_t)cache->direction[0] & 0xFFFFu);
    pair->hint[1] = (uint16_t)((uint32_t)(int32_t)cache->direction[1] & 0xFFFFu);
  }
  const unsigned flags = pair->state & ((1u << GJK_SCENE_PAIR_CACHED) - 1);
  pair->state = (uint8_t)(flags | count << GJK_SCENE_PAIR_CACHED);
}

// Ground is all that is concave. Its code is in the class.
static inline bool gjk2_scene_is_concave(const gjk2_shape *shape) {
  return shape->type->ground != NULL;
}

// Binds a collider to a shape of a part. Statuses as gjk2_collider_init.
static inline gjk_status gjk2_scene_bind(gjk2_collider *c, const gjk2_shape *shape) {
  return shape != NULL && shape->type != NULL && gjk2_scene_is_concave(shape) ? shape->type->ground->bind(shape, c)
                                                                              : gjk2_collider_init(c, shape, NULL, 0);
}

// Does a part stay in int32 at any rotation? Of a convex one its collider tells.
static inline bool gjk2_scene_has_room(const gjk2_shape *shape, const gjk2_vec *position) {
  return !gjk2_scene_is_concave(shape) || gjk2_ground_has_room(position);
}

#endif
