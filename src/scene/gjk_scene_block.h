// What a scene's block holds: a header, then arrays of records, which name each other by index.
//
// Fields have a fixed width and natural alignment, so every compiler lays the records out alike, without holes. Free
// records of a pool form a list: the first word of each is the index of the next one. Free bodies are found by the bits
// of their slots instead.
#ifndef GJK_SRC_SCENE_BLOCK_H
#define GJK_SRC_SCENE_BLOCK_H

#include "gjk_scene_common.h"

// A file of the plane includes the plane's own definitions first.
#ifndef GJK_SCENE_OF_PLANE
#include "gjk_scene_space.h"
#endif

// Counters of gjk_scene_stats: those that are counted nowhere else, in the same order.
typedef struct gjk_scene_counters {
  uint32_t pairs, refused, resting;
  uint32_t filtered, motion, boxes, direction, warm, cold;  // in the order of gjk_scene_outcome
  uint32_t begun, persisting, ended, unsettled;
  uint32_t measured, manifolds;
} gjk_scene_counters;

typedef struct gjk_scene_header {
  uint32_t magic, version, order, bytes;
  uint32_t sealed, checksum[2];
  uint32_t iterations;  // GJK_ITERATIONS_MAX of the build
  uint32_t casts;       // GJK_SCENE_CASTS of the build
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
  uint32_t next_test, next_report;  // places in the queue. With kept motions, next_test goes on to count
                                    // them; next_report does when the queue is empty
  uint32_t updates;                 // completed, modulo 2^32
  uint32_t most_detail;             // the largest detail that the configuration or any body so far has asked for
  uint32_t refused;                 // counter of the update under way
  uint32_t kept_at;                 // of the array of kept motions
  uint32_t kept;                    // how many there are
  uint32_t words_at;                // of the array of the caller's words, config.pair_words for each pair
  uint32_t caches_at;               // of the array of caches, one for each pair where config.detail is CONTACTS
  gjk_scene_counters stats;         // of the last update whose tests are done
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
  gjk_scene_kept *kept;  // in the order of slots
  uint32_t *words;
  gjk_cache *caches;  // of contacts; NULL: they start cold
} gjk_scene_view;

// The code of fast bodies, which bindings.motion binds.
//
// update  steps 4 to 9 of an update, in the place of gjk_scene_update.c, where motions are kept.
struct gjk_scene_motions {
  void (*prepare)(gjk_scene_view *v);  // an update begins: readies all records
  void (*update)(gjk_scene_view *v, uint32_t tests, gjk_report *reports, uint32_t capacity, gjk_progress *progress);
  void (*restart)(gjk_scene_view *v, uint32_t slot);  // a body's way starts at the pose that it has now
  void (*forget)(gjk_scene_view *v, uint32_t slot);   // a body goes
};

// Finds the arrays of a scene. NULL, CORRUPT or OK.
gjk_status gjk_scene_view_of(const gjk_scene *scene, gjk_scene_view *out);

// As gjk_scene_view_of, for a call that changes bodies: breaks the seal. BUSY during an update.
gjk_status gjk_scene_edit(gjk_scene *scene, gjk_scene_view *out);

// Checks a header and the layout that it states, sealed or not. CORRUPT or CAPACITY.
gjk_status gjk_scene_check_header(const void *block, size_t bytes);

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

// The caller's words of a pair; NULL: there are none.
static inline uint32_t *gjk_scene_words_of(const gjk_scene_view *v, uint32_t pair) {
  const uint32_t count = v->header->config.pair_words;
  return count == 0 ? NULL : &v->words[pair * count];  // < 2^27
}

// Does the code that details bind lack what a gjk_detail asks for? A SENSOR asks for nothing.
static inline bool gjk_scene_lacks(const gjk_scene_details *details, uint32_t detail) {
  return (detail == GJK_DETAIL_DEPTH && details == NULL) ||
         (detail == GJK_DETAIL_CONTACTS && (details == NULL || details->manifold == NULL));
}

// Is the body a sensor?
static inline bool gjk_scene_is_sensor(const gjk_scene_body *body) {
  return body->kind_detail >> 4 == GJK_DETAIL_SENSOR;
}

// Where a body is.
static inline void gjk_scene_pose_of(const gjk_scene_body *body, gjk_pose *out) {
  out->position = body->position;
  out->rotation = body->rotation;
}

#endif
