// What a scene's block holds, and how its parts are found.
//
// Records have fields of fixed width, naturally aligned, so that every compiler lays them out alike, without holes. The
// first field of a record that is free is the index of the next free one.
#ifndef GJK_SRC_SCENE_BLOCK_H
#define GJK_SRC_SCENE_BLOCK_H

#include "../arith/gjk_wide.h"
#include "gjk/cache.h"
#include "gjk/scene.h"

#define GJK_SCENE_NONE UINT32_MAX

// A node of the tree by its number: a part's, marked, or an inner node's.
#define GJK_SCENE_LEAF UINT32_C(0x80000000)

// The tree is balanced: heights of siblings differ by at most 1, so 2^20 leaves are at most 1.45 * 20 = 29 deep. A walk
// that puts off one sibling per level needs no more room than this.
#define GJK_SCENE_DEPTH 32

// Motion that nothing bounds: a new shape, or a jump.
#define GJK_SCENE_UNBOUNDED UINT32_MAX

// gjk_scene_body.flags
#define GJK_SCENE_ASLEEP 1u
#define GJK_SCENE_MOVED 2u  // in the list of bodies that changed since the last update

typedef struct gjk_scene_body {
  uint32_t generation;  // odd: in use
  gjk_vec3 position;
  gjk_quat rotation;
  uint32_t category, mask, user;
  gjk_q16 margin;
  uint32_t first;  // part
  uint32_t next_moved;
  uint16_t parts;
  uint8_t kind_detail;  // kind, and detail << 4
  uint8_t flags;
} gjk_scene_body;

// gjk_scene_part.state
#define GJK_SCENE_LIVE 1u
#define GJK_SCENE_PAIRS_STALE 2u  // its pairs may not be those whose enlarged boxes meet
#define GJK_SCENE_MARK 4u         // already a partner of the part at hand

typedef struct gjk_scene_part {
  uint32_t next;    // of the body
  uint32_t body;    // slot
  uint32_t parent;  // inner node
  uint32_t pairs;   // first link, see gjk_scene_pair
  uint32_t placed;  // pose in the body, or none: the body's own
  uint32_t motion;  // bounds how far any of its points has moved since the last update, LSB
  gjk_vec3 centre, local_centre, frame[3];
  gjk_q16 core_radius;
  gjk_aabb exact, enlarged;
  uint16_t shape, number;
  uint8_t state;
  int8_t fraction[3];  // of the centre
} gjk_scene_part;

typedef struct gjk_scene_node {
  uint32_t child[2];
  uint32_t parent;
  uint32_t height;  // a leaf's is 0
  gjk_aabb box;
} gjk_scene_node;

typedef struct gjk_scene_placed {
  uint32_t next;
  gjk_pose pose;
} gjk_scene_placed;

// gjk_scene_pair.state; the upper three bits count the cached vertices.
#define GJK_SCENE_PAIR_LIVE 1u
#define GJK_SCENE_PAIR_NEAR 2u      // at the last update
#define GJK_SCENE_PAIR_QUEUED 4u    // to be tested in this one
#define GJK_SCENE_PAIR_NEAR_NOW 8u  // so it was found
#define GJK_SCENE_PAIR_GONE 16u     // a body was removed: the end is still to be reported
#define GJK_SCENE_PAIR_CACHED 5u    // shift

// Two parts whose enlarged boxes meet, or that were near at the last update; part[0] is of the body with the lower slot.
// A pair is in a list of each part's; a link is the pair's index times two, plus the side.
// Of a pair that is gone, part holds the slots, next the generations, and direction[0..1] the part numbers.
typedef struct gjk_scene_pair {
  uint32_t part[2];
  uint32_t next[2], previous[2];
  int32_t gap;  // by how much more than the margins they are proven apart, or nearer, or 0; but the distance of a
                // near pair whose detail asks for it
  int16_t direction[3];  // as in gjk_cache
  uint8_t a[4], b[4];
  uint8_t state;
  uint8_t outcome;  // a gjk_scene_outcome
} gjk_scene_pair;

// From FILTERED to COLD in the order of gjk_scene_stats.
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

// A pool hands out what was given back last, and else the next that was never used.
typedef struct gjk_scene_pool {
  uint32_t at;  // bytes from the start of the block
  uint32_t capacity;
  uint32_t fresh;  // from here on never used
  uint32_t free;   // first
  uint32_t count;  // in use
} gjk_scene_pool;

typedef enum gjk_scene_phase {
  GJK_SCENE_IDLE = 0,
  GJK_SCENE_TESTING,   // queue[0 .. queued) are being tested, those below next_test are done
  GJK_SCENE_REPORTING  // queue[next_report .. queued) are still to be reported
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
  gjk_scene_pool bodies, parts, nodes, placed, pairs;
  uint32_t queue_at, slots_at;  // pair indices; a bit per slot, set when free
  uint32_t lowest;              // word of the bits; those below have none set
  uint32_t root;                // of the tree
  uint32_t moved;               // first body
  uint32_t gone;                // pairs of that state
  uint32_t phase, queued, next_test, next_report;
  uint32_t updates;       // completed
  uint32_t most_detail;   // that configuration or a body, maybe one that is gone, has asked for
  uint32_t refused;       // counted for the update under way
  gjk_scene_stats stats;  // of the last update whose tests are done, as far as not counted elsewhere
} gjk_scene_header;

// A scene with its sections found.
typedef struct gjk_scene_view {
  const gjk_scene *scene;
  gjk_scene_header *header;
  gjk_scene_body *bodies;
  gjk_scene_part *parts;
  gjk_scene_node *nodes;
  gjk_scene_placed *placed;
  gjk_scene_pair *pairs;
  uint32_t *queue, *slots;
} gjk_scene_view;

// NULL, CORRUPT or OK.
gjk_status gjk_scene_view_of(const gjk_scene *scene, gjk_scene_view *out);

// The same for a call that changes bodies: BUSY, too; the seal is broken.
gjk_status gjk_scene_edit(gjk_scene *scene, gjk_scene_view *out);

// Checks a header and the layout it states; sealed or not. CORRUPT or CAPACITY.
gjk_status gjk_scene_check_header(const void *block, size_t bytes);

// The part of the handle's workspace that the configuration lets depths use. False: the handle lacks it.
bool gjk_scene_workspace(const gjk_scene *scene, gjk_workspace *out);

// Takes a record of size bytes from a pool. Pre: one is left.
uint32_t gjk_scene_take(gjk_scene_view *v, gjk_scene_pool *pool, uint32_t size);
void gjk_scene_give(gjk_scene_view *v, gjk_scene_pool *pool, uint32_t size, uint32_t index);

// The body of a handle, or HANDLE.
gjk_status gjk_scene_body_of(const gjk_scene_view *v, gjk_body_id handle, gjk_scene_body **out);

static inline gjk_body_id gjk_scene_id_of(const gjk_scene_view *v, uint32_t slot) {
  const gjk_body_id handle = {slot, v->bodies[slot].generation};
  return handle;
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

// The larger of gap and that of two intervals; below 2^32.
static inline uint32_t gjk_larger_gap(uint32_t gap, gjk_q16 lower_a, gjk_q16 upper_a, gjk_q16 lower_b,
                                      gjk_q16 upper_b) {
  const uint32_t apart = lower_a > upper_b   ? (uint32_t)lower_a - (uint32_t)upper_b
                         : lower_b > upper_a ? (uint32_t)lower_b - (uint32_t)upper_a
                                             : 0;
  return apart > gap ? apart : gap;
}

// The largest gap of two boxes along an axis, 0 when they meet: a lower bound of the distance.
static inline uint32_t gjk_aabb_gap(const gjk_aabb *a, const gjk_aabb *b) {
  const uint32_t x = gjk_larger_gap(0, a->lower.x, a->upper.x, b->lower.x, b->upper.x);
  const uint32_t y = gjk_larger_gap(x, a->lower.y, a->upper.y, b->lower.y, b->upper.y);
  return gjk_larger_gap(y, a->lower.z, a->upper.z, b->lower.z, b->upper.z);
}

static inline bool gjk_scene_same_vec3(const gjk_vec3 *a, const gjk_vec3 *b) {
  return a->x == b->x && a->y == b->y && a->z == b->z;
}

#endif
