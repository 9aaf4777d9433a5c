// What scenes of space (gjk/scene.h) and of the plane (gjk2/scene.h) have in common: ids, kinds, details, events,
// statistics and hits.
#ifndef GJK_BODY_H
#define GJK_BODY_H

#include "gjk/format.h"

#ifdef __cplusplus
extern "C" {
#endif

// Ceilings on capacities.
#define GJK_SCENE_BODIES_MAX UINT32_C(1048576)
#define GJK_SCENE_PAIRS_MAX UINT32_C(4194304)
#define GJK_SCENE_PAIR_WORDS_MAX 32

// Names a body. A zeroed id names none. The id of a removed body never names another one: its generation differs, and a
// slot taken 2^31 times is not taken again.
typedef struct gjk_body_id {
  uint32_t slot;        // the body's place in the scene, below config.bodies
  uint32_t generation;  // counts how often the slot was taken and freed; odd while a body is in it
} gjk_body_id;

// How a body moves.
typedef enum gjk_body_kind {
  GJK_BODY_STATIC = 0,  // scenery: never tested against other statics
  GJK_BODY_KINEMATIC,   // moved by its own plan
  GJK_BODY_DYNAMIC      // may fall asleep
} gjk_body_kind;

// What a scene finds out about a pair. DEPTH and CONTACTS need the details of a scene's bindings.
//
// SENSOR  for a body only. Its pairs have detail TOUCH, whatever the other body or the configuration asks for. They
//         begin and end, but are never reported as persisting. Fast bodies pass through a sensor. Casts and slides meet
//         it unless their filter leaves it out.
typedef enum gjk_detail {
  GJK_DETAIL_TOUCH = 0,  // near or not
  GJK_DETAIL_DISTANCE,   // and the distance
  GJK_DETAIL_DEPTH,      // and the depth
  GJK_DETAIL_CONTACTS,   // and the manifold
  GJK_DETAIL_SENSOR      // for a body only, see above
} gjk_detail;

// Should this pair be tested? Called at most once per test, possibly from several threads. The predicate may depend on
// its arguments, and on what does not change during an update. An update calls it only for pairs whose nearness a
// motion may have changed. If the predicate changes for another reason, call gjk_scene_refilter, in the plane
// gjk2_scene_refilter.
typedef bool gjk_scene_predicate(void *user, gjk_body_id a, uint32_t user_a, gjk_body_id b, uint32_t user_b);

// What happened to a pair.
typedef enum gjk_event {
  GJK_EVENT_BEGIN = 1,  // near at this update, not at the last one
  GJK_EVENT_PERSIST,    // near at both; reported only with config.persist
  GJK_EVENT_END,        // near at the last update, but not at this one; or a body was removed, and its id is stale
  GJK_EVENT_IMPACT      // a is a fast body; b is what a touched first on its way since the last update
} gjk_event;

// Whether a scene remembers where a body was at the last update, see gjk_scene_set_motion.
typedef enum gjk_body_motion {
  GJK_MOTION_NOT_KEPT = 0,  // to fast bodies it stands where it is now
  GJK_MOTION_KEPT,          // fast bodies meet it on its way
  GJK_MOTION_FAST           // it is swept along its way, and what it touches first is reported
} gjk_body_motion;

// Progress of an update, which is done when pairs_left and reports_left are 0.
typedef struct gjk_progress {
  uint32_t reports;       // reports that this call wrote
  uint32_t pairs_left;    // pairs that are not yet tested, plus bodies with kept motion that are not yet swept
  uint32_t reports_left;  // reports that are not yet written
} gjk_progress;

// What the last update that tested all its pairs did. Each pair is counted once: in resting, or in one of filtered to
// cold. These numbers describe work, not answers. They depend on skips, caches, and on how bodies moved.
typedef struct gjk_scene_stats {
  uint32_t bodies, parts;  // currently in the scene
  uint32_t pairs;          // tested or resting
  uint32_t refused;        // boxes that began to meet but make no pair: both static, or filtered by category and mask
  uint32_t resting;        // neither body moved (asleep, static or still), so the last answer stands
  uint32_t filtered;       // refused by the predicate, or by a changed category or mask
  uint32_t motion;         // the motion since the last test is too small to change its answer
  uint32_t boxes;          // exact boxes are apart. Without curved shapes also: bounding spheres are apart, or spheres
                           // inside both parts are near
  uint32_t direction;      // the last separating direction still separates: one support scan
  uint32_t warm, cold;     // queries that started from the cache, and without it
  uint32_t begun, persisting, ended;  // events of the update that tested all pairs
  uint32_t unsettled;                 // queries that reached a ceiling, see gjk_scene_update and gjk2_scene_update
  uint32_t updates;                   // completed so far, modulo 2^32
  uint32_t measured;                  // distances and depths found, because details ask for them
  uint32_t manifolds;                 // found for reports
} gjk_scene_stats;

// A part that a query found.
typedef struct gjk_scene_hit {
  gjk_body_id body;   // the body that has it
  uint16_t part;      // the part's number in its body
  uint32_t fraction;  // where on the way it meets the part or its box, in 2^-30, rounded down; 0 if there is no way
  uint32_t user;      // the body's user word
} gjk_scene_hit;

// Does a query look at this part? May be called several times for a part, possibly from several threads.
typedef bool gjk_scene_accept(void *user, gjk_body_id body, uint32_t user_of_body, uint16_t part);

// Which parts a query of shapes looks at. A NULL filter: all.
typedef struct gjk_scene_filter {
  uint32_t category, mask;  // as a body's: each category must share a bit with the other's mask; both 0: no part passes
  gjk_body_id ignore;       // a body to leave out, for example the one that asks; zeroed: none
  gjk_scene_accept *accept;  // NULL: every part that the fields above let through
  void *user;                // accept's first argument
} gjk_scene_filter;

// What a line or point of gjk/draw.h and gjk2/draw.h belongs to, for its colour.
typedef enum gjk_draw_role {
  GJK_DRAW_STATIC = 0,  // outlines of bodies of a scene, by kind; a sensor and a sleeping body have their own
  GJK_DRAW_MOVING,      // kinematic and dynamic bodies
  GJK_DRAW_ASLEEP,      // dynamic bodies that sleep
  GJK_DRAW_SENSOR,      // sensors of any kind
  GJK_DRAW_BOX,         // edges of an axis-aligned box
  GJK_DRAW_PAIR,        // from centre to centre of two parts that are near
  GJK_DRAW_CONTACT,     // a contact point on each shape, and the line between both
  GJK_DRAW_NORMAL,      // from a contact point along the normal
  GJK_DRAW_WAY          // the way of a ray or cast, and the outlines at its ends
} gjk_draw_role;

// What gjk_draw_scene and gjk2_draw_scene draw. Their sum draws all.
#define GJK_DRAW_SHAPES 1u
#define GJK_DRAW_BOXES 2u
#define GJK_DRAW_PAIRS 4u

// The number of directions in which outlines of curved and rounded shapes are sampled.
#define GJK_DRAW_DIRECTIONS 24

// Limits of one gjk_slide: the most planes that it slides along, the least gap that it keeps, and the most casts.
#define GJK_SLIDE_PLANES 4
#define GJK_SLIDE_SKIN_MIN ((gjk_q16)16)
#define GJK_SLIDE_CASTS 50

#ifdef __cplusplus
}
#endif

#endif
