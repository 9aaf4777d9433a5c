// Names of statuses.
#include "gjk/status.h"

const char *gjk_status_name(gjk_status status) {
  switch (status) {
    case GJK_OK: return "GJK_OK";
    case GJK_ERROR_NULL: return "GJK_ERROR_NULL";
    case GJK_ERROR_SIZE: return "GJK_ERROR_SIZE";
    case GJK_ERROR_NEGATIVE: return "GJK_ERROR_NEGATIVE";
    case GJK_ERROR_EMPTY: return "GJK_ERROR_EMPTY";
    case GJK_ERROR_CAPACITY: return "GJK_ERROR_CAPACITY";
    case GJK_ERROR_OVERLAP: return "GJK_ERROR_OVERLAP";
    case GJK_ERROR_ROTATION: return "GJK_ERROR_ROTATION";
    case GJK_ERROR_RANGE: return "GJK_ERROR_RANGE";
    case GJK_ERROR_UNINITIALISED: return "GJK_ERROR_UNINITIALISED";
    case GJK_ERROR_ITERATION_LIMIT: return "GJK_ERROR_ITERATION_LIMIT";
    case GJK_ERROR_UNPROVEN: return "GJK_ERROR_UNPROVEN";
    case GJK_ERROR_UNSUPPORTED: return "GJK_ERROR_UNSUPPORTED";
    case GJK_ERROR_BODY_ID: return "GJK_ERROR_BODY_ID";
    case GJK_ERROR_BUSY: return "GJK_ERROR_BUSY";
    case GJK_ERROR_CORRUPT: return "GJK_ERROR_CORRUPT";
  }
  return "GJK_ERROR_UNKNOWN";
}
