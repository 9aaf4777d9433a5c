// What a call reports about itself, apart from its answer.
#ifndef GJK_STATUS_H
#define GJK_STATUS_H

#ifdef __cplusplus
extern "C" {
#endif

// GJK_OK is 0, every error is negative. An error leaves all outputs as they were. Two of them come with results, of which
// each query's comment says what is valid: ITERATION_LIMIT, with the bounds proven so far, and CAPACITY of a workspace,
// with an answer that is safe but not the least.
typedef enum gjk_status {
  GJK_OK = 0,
  GJK_ERROR_NULL = -1,              // a required pointer is null
  GJK_ERROR_SIZE = -2,              // a shape beyond GJK_RADIUS_MAX
  GJK_ERROR_NEGATIVE = -3,          // a negative radius, half extent or distance
  GJK_ERROR_EMPTY = -4,             // a hull without vertices
  GJK_ERROR_CAPACITY = -5,          // a buffer or workspace too small
  GJK_ERROR_OVERLAP = -6,           // a buffer that overlaps what it is made from
  GJK_ERROR_ROTATION = -7,          // a quaternion or axis that is not a unit within the tolerance
  GJK_ERROR_RANGE = -8,             // a value outside its stated range, or a centre outside int32
  GJK_ERROR_UNINITIALISED = -9,     // a collider that was never initialised, or never posed
  GJK_ERROR_ITERATION_LIMIT = -10,  // GJK_ITERATIONS_MAX iterations did not settle it; of curved or user's shapes alone
  GJK_ERROR_UNPROVEN = -11,         // a certificate that does not hold
  GJK_ERROR_UNSUPPORTED = -12,      // a certificate of a curved or user's shape, which has no vertices
  GJK_ERROR_BODY_ID = -13,          // a scene's handle that is stale or was never given, or a slot that is taken
  GJK_ERROR_BUSY = -14,             // a scene in the middle of an update
  GJK_ERROR_CORRUPT = -15           // a block that is no scene, or not as it was when it was sealed
} gjk_status;

// The enumerator's name, for example "GJK_ERROR_NULL"; "GJK_ERROR_UNKNOWN" for any other value.
const char *gjk_status_name(gjk_status status);

#ifdef __cplusplus
}
#endif

#endif
