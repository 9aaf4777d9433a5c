// What fuzz targets of public functions share: shapes, rotations and statuses, as hostile as bytes can make them.
#ifndef FUZZ_HOSTILE_H
#define FUZZ_HOSTILE_H

#include <string.h>

#include "bytes.h"

// What outputs hold before a call.
#define HOSTILE_POISON 0xA5

#define HOSTILE_VERTICES 8
#define HOSTILE_CORNERS 16
#define HOSTILE_FACES 4

// A shape, and all that it points to.
typedef struct hostile_shape {
  gjk_shape shape;
  gjk_vec3 vertices[HOSTILE_VERTICES];
  uint16_t corner[HOSTILE_CORNERS], end[HOSTILE_FACES];
  gjk_hull_faces faces;
} hostile_shape;

// Leaves out one argument in 32.
static inline bool hostile_leaves_out(fuzz_bytes *bytes) {
  return fuzz_u8(bytes) < 8 && bytes->at < bytes->end;
}

// Ends the program unless the status is one that exists, and nothing was written but where the status says that fields
// are valid.
void hostile_check(gjk_status status, const void *output, size_t size);

// Calls with &result; the status and what was written must go together.
#define ASK(result, call)                              \
  do {                                                 \
    memset(&(result), HOSTILE_POISON, sizeof(result)); \
    hostile_check((call), &(result), sizeof(result));  \
  } while (false)

// The pointer; NULL for one argument in 32 of the target's `bytes`.
#define MAYBE(pointer) (hostile_leaves_out(&bytes) ? NULL : (pointer))

// Mostly a rotation.
gjk_quat hostile_quat(fuzz_bytes *bytes);

// A vector, smaller by so many bits.
gjk_vec3 hostile_vec3(fuzz_bytes *bytes, unsigned shift);

// A shape of any kind with any fields. Its faces have corners that it has and some that it has not, and ends anywhere
// among them.
void hostile_make_shape(fuzz_bytes *bytes, hostile_shape *out);

#endif
