// The statuses that calls return.
#ifndef GJK_STATUS_H
#define GJK_STATUS_H

#ifdef __cplusplus
extern "C" {
#endif

// GJK_OK is 0, every error is negative. Two errors come with results. Each query's comment says which fields are valid
// then; the others are as they were.
//
// ITERATION_LIMIT  gjk_distance, gjk_distance_until: bounds, points and a normal, as far as proven.
//                  gjk_signed_distance: bounds. gjk_intersect, gjk_within, gjk_within_until: iterations; the answer is
//                  open. gjk_penetration, gjk_contacts: nothing. gjk_cast: how far the way is free.
// CAPACITY         of a workspace, from gjk_penetration, gjk_signed_distance and gjk_contacts: an answer that is safe
//                  to move by, but not the least.
//
// Every other error leaves all outputs as they were, unless the call's comment says that it writes some.
typedef enum gjk_status {
  GJK_OK = 0,                       // the answer is there
  GJK_ERROR_NULL = -1,              // a required pointer is NULL
  GJK_ERROR_SIZE = -2,              // a shape whose radius exceeds GJK_RADIUS_MAX
  GJK_ERROR_NEGATIVE = -3,          // a negative radius, half extent or distance
  GJK_ERROR_EMPTY = -4,             // a hull without vertices
  GJK_ERROR_CAPACITY = -5,          // a buffer or workspace too small
  GJK_ERROR_OVERLAP = -6,           // a buffer that overlaps what it is made from
  GJK_ERROR_ROTATION = -7,          // a rotation or direction that is not a unit within the tolerance, or has length 0
  GJK_ERROR_RANGE = -8,             // a value outside its stated range, or a centre outside int32
  GJK_ERROR_UNINITIALISED = -9,     // a collider that was never initialised, or never posed
  GJK_ERROR_ITERATION_LIMIT = -10,  // GJK_ITERATIONS_MAX iterations did not settle it; only curved shapes cause it
  GJK_ERROR_UNPROVEN = -11,         // a certificate that does not hold
  GJK_ERROR_UNSUPPORTED = -12,      // no exact check exists, a scene does not do it, or the build left it out
  GJK_ERROR_BODY_ID = -13,          // a body id that is stale or was never given, or a slot that is taken
  GJK_ERROR_BUSY = -14,             // a scene in the middle of an update
  GJK_ERROR_CORRUPT = -15           // a block that is not a scene, or has changed since it was sealed
} gjk_status;

// The enumerator's name, for example "GJK_ERROR_NULL"; "GJK_ERROR_UNKNOWN" for any other value.
const char *gjk_status_name(gjk_status status);

#ifdef __cplusplus
}
#endif

#endif
