// What a scene's block holds: a header, then arrays of records, which name each other by index.
//
// Fields have a fixed width and natural alignment, so every compiler lays the records out alike, without holes. Free
// records of a pool form a list: the first word of each is the index of the next one. Free bodies are found by the bits
// of their slots instead.
#ifndef GJK_SRC_SCENE_BLOCK_H
#define GJK_SRC_SCENE_BLOCK_H

#include "../arith/gjk_wide.h"
#include "gjk/cache.h"
#include "gjk/scene.h"

#define GJK_SCENE_NONE UINT32_MAX

// A node of the tree is one number: a part's index with this bit set, or an inner node's index.
#define GJK_SCENE_LEAF UINT32_C(0x80000000)

// Room for a walk over the tree, which puts off one sibling per level. Heights of siblings differ by at most 1, so 2^20
// leaves are at most 1.45 * 20 = 29 deep.
#define GJK_SCENE_DEPTH 32

// The motion of a part that nothing bounds: it is new, has another shape, jumped, or its pairs are to be filtered
// again.
#define GJK_SCENE_UNBOUNDED UINT32_MAX

// gjk_scene_body.flags
#define GJK_SCENE_ASLEEP 1u
#define GJK_SCENE_MOVED 2u  // in the list of bodies that changed since the last update, header.moved

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

// gjk_scene_part.state
#define GJK_SCENE_LIVE 1u
#define GJK_SCENE_PAIRS_STALE 2u  // pairs may be missing whose enlarged boxes meet, or be there whose boxes do not
#define GJK_SCENE_MARK 4u         // has a pair with the part whose pairs are being made

// The body turned since the part was posed: centre, fraction and frame are of an earlier rotation. exact holds the part,
// but need not be its least box. Parts with pairs are posed again when an update begins.
#define GJK_SCENE_UNPOSED 8u

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

// gjk_scene_pair.state; the upper three bits count the cached vertices.
#define GJK_SCENE_PAIR_LIVE 1u
#define GJK_SCENE_PAIR_NEAR 2u      // near at the last update
#define GJK_SCENE_PAIR_QUEUED 4u    // to be tested in the update under way
#define GJK_SCENE_PAIR_NEAR_NOW 8u  // the test found it near
#define GJK_SCENE_PAIR_GONE 16u     // one of its bodies was removed; its end is still to be reported
#define GJK_SCENE_PAIR_CACHED 5u    // shift

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

// What settled a pair. FILTERED to COLD are in the order of their counters in gjk_scene_stats.
typedef enum gjk_scene_outcome {
  GJK_SCENE_PENDING = 0,
  GJK_SCENE_FILTERED,
  GJK_SCENE_MOTION,
  GJK_SCENE_BOXES,
  GJK_SCENE_DIRECTION,
  GJK_SCENE_WARM,
  GJK_SCENE_COLD,
  GJK_SCENE_OUTCOMES,
  GJK_SCENE_UNSETTLED = 16  // flag
} gjk_scene_outcome;

// Records of one size. A pool hands out the record that was given back last, or else the next one that was never used.
typedef struct gjk_scene_pool {
  uint32_t at;  // bytes from the start of the block
  uint32_t capacity;
  uint32_t fresh;  // records from here on were never used
  uint32_t free;   // first free record below fresh, or none
  uint32_t count;  // records in use
} gjk_scene_pool;

typedef enum gjk_scene_phase {
  GJK_SCENE_IDLE = 0,
  GJK_SCENE_TESTING,   // the queue holds the pairs to be tested; those before next_test are done
  GJK_SCENE_REPORTING  // the queue holds the pairs to be reported, in order; those from next_report on are left
} gjk_scene_phase;

struct gjk_scene_details {
  gjk_status (*signed_distance)(const gjk_collider *a, const gjk_collider *b, gjk_cache *cache,
                                const gjk_workspace *workspace, gjk_distance_result *out);
  gjk_status (*manifold)(const gjk_scene *scene, const gjk_report *report, unsigned most,
                         gjk_manifold *out);  // or NULL
};

typedef struct gjk_scene_header {
  uint32_t magic, version, order, bytes;
  uint32_t sealed, checksum[2];
  uint32_t iterations;  // GJK_ITERATIONS_MAX of the build
  gjk_scene_config config;
  gjk_scene_pool bodies, parts, nodes, own_poses, pairs;
  uint32_t queue_at;                // of the array of pair indices, bytes from the start of the block
  uint32_t slots_at;                // of the array with a bit per slot, set when the slot is free
  uint32_t lowest;                  // word of those bits: the words before it have no bit set
  uint32_t root;                    // node of the tree, or none
  uint32_t moved;                   // slot of the first body in the list of those that changed, or none
  uint32_t gone;                    // first pair in the list of those that are gone, or none
  uint32_t phase;                   // a gjk_scene_phase
  uint32_t queued;                  // length of the queue
  uint32_t next_test, next_report;  // places in the queue
  uint32_t updates;                 // completed, modulo 2^32
  uint32_t most_detail;             // the largest detail that the configuration or any body so far has asked for
  uint32_t refused;                 // counter of the update under way
  gjk_scene_stats stats;            // of the last update whose tests are done; what is counted elsewhere is not in it
} gjk_scene_header;

// A scene with the addresses of its arrays.
typedef struct gjk_scene_view {
  const gjk_scene *scene;
  gjk_scene_header *header;
  gjk_scene_body *bodies;
  gjk_scene_part *parts;
  gjk_scene_node *nodes;
  gjk_scene_own_pose *own_poses;
  gjk_scene_pair *pairs;
  uint32_t *queue, *slots;
} gjk_scene_view;

// Finds the arrays of a scene. NULL, CORRUPT or OK.
gjk_status gjk_scene_view_of(const gjk_scene *scene, gjk_scene_view *out);

// As gjk_scene_view_of, for a call that changes bodies: breaks the seal. BUSY during an update.
gjk_status gjk_scene_edit(gjk_scene *scene, gjk_scene_view *out);

// Checks a header and the layout that it states, sealed or not. CORRUPT or CAPACITY.
gjk_status gjk_scene_check_header(const void *block, size_t bytes);

// Writes the part of the bound workspace that the configuration lets depths use. False: it has fewer cells.
bool gjk_scene_workspace(const gjk_scene *scene, gjk_workspace *out);

// Takes a record of size bytes from a pool. Pre: one is left.
uint32_t gjk_scene_pool_take(gjk_scene_view *v, gjk_scene_pool *pool, uint32_t size);

// Gives a record back to its pool.
void gjk_scene_pool_give(gjk_scene_view *v, gjk_scene_pool *pool, uint32_t size, uint32_t index);

// Finds the body that an id names. BODY_ID: there is none.
gjk_status gjk_scene_body_of(const gjk_scene_view *v, gjk_body_id id, gjk_scene_body **out);

static inline gjk_body_id gjk_scene_id_of(const gjk_scene_view *v, uint32_t slot) {
  const gjk_body_id id = {slot, v->bodies[slot].generation};
  return id;
}

static inline bool gjk_aabb_meet(const gjk_aabb *a, const gjk_aabb *b) {
  return a->lower.x <= b->upper.x && b->lower.x <= a->upper.x && a->lower.y <= b->upper.y && b->lower.y <= a->upper.y &&
         a->lower.z <= b->upper.z && b->lower.z <= a->upper.z;
}

// Is a inside b?
static inline bool gjk_aabb_inside(const gjk_aabb *a, const gjk_aabb *b) {
  return a->lower.x >= b->lower.x && a->upper.x <= b->upper.x && a->lower.y >= b->lower.y && a->upper.y <= b->upper.y &&
         a->lower.z >= b->lower.z && a->upper.z <= b->upper.z;
}

// The larger of gap and the gap of two intervals, which is 0 when they meet; below 2^32.
static inline uint32_t gjk_larger_gap(uint32_t gap, gjk_q16 lower_a, gjk_q16 upper_a, gjk_q16 lower_b,
                                      gjk_q16 upper_b) {
  const uint32_t apart = lower_a > upper_b   ? (uint32_t)lower_a - (uint32_t)upper_b
                         : lower_b > upper_a ? (uint32_t)lower_b - (uint32_t)upper_a
                                             : 0;
  return apart > gap ? apart : gap;
}

// The largest gap of two boxes along an axis, 0 when they meet: a lower bound of their distance.
static inline uint32_t gjk_aabb_gap(const gjk_aabb *a, const gjk_aabb *b) {
  const uint32_t x = gjk_larger_gap(0, a->lower.x, a->upper.x, b->lower.x, b->upper.x);
  const uint32_t y = gjk_larger_gap(x, a->lower.y, a->upper.y, b->lower.y, b->upper.y);
  return gjk_larger_gap(y, a->lower.z, a->upper.z, b->lower.z, b->upper.z);
}

// |a - b|, below 2^32.
static inline uint32_t gjk_scene_difference(int32_t a, int32_t b) {
  return a > b ? (uint32_t)a - (uint32_t)b : (uint32_t)b - (uint32_t)a;
}

static inline bool gjk_scene_same_vec3(const gjk_vec3 *a, const gjk_vec3 *b) {
  return a->x == b->x && a->y == b->y && a->z == b->z;
}

static inline bool gjk_scene_same_rotation(const gjk_quat *a, const gjk_quat *b) {
  return a->x == b->x && a->y == b->y && a->z == b->z && a->w == b->w;
}

#endif
