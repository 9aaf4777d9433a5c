// Number formats, vectors and limits.
#ifndef GJK_FORMAT_H
#define GJK_FORMAT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "gjk/version.h"

// Length or coordinate in Q16.16: 1 LSB is 2^-16 unit.
typedef int32_t gjk_q16;

// Component of a unit vector, rotation or quaternion in Q2.30: 1 LSB is 2^-30.
typedef int32_t gjk_q30;

// Angle in radians, Q16.16: 1 LSB is 2^-16 radian, whatever the unit of length.
typedef int32_t gjk_angle;

// Position, offset or half extents, Q16.16.
typedef struct gjk_vec3 {
  gjk_q16 x, y, z;  // coordinates
} gjk_vec3;

// Unit vector, Q2.30.
typedef struct gjk_unit3 {
  gjk_q30 x, y, z;  // components, from -GJK_Q30_ONE to GJK_Q30_ONE
} gjk_unit3;

// Rotation as a unit quaternion x i + y j + z k + w, Q2.30; the identity is {0, 0, 0, GJK_Q30_ONE}.
typedef struct gjk_quat {
  gjk_q30 x, y, z, w;  // axis times the sine of half the angle, and its cosine
} gjk_quat;

// The pose of a shape, which is first rotated about its own origin and then moved by position.
typedef struct gjk_pose {
  gjk_vec3 position;  // of the origin of its frame
  gjk_quat rotation;  // a unit, see gjk/pose.h
} gjk_pose;

// 1 in Q16.16 and in Q2.30.
#define GJK_Q16_ONE ((gjk_q16)65536)
#define GJK_Q30_ONE ((gjk_q30)1073741824)

// A literal in units, rounded to the nearest LSB. The compiler folds it, so the program holds an integer. A value
// beyond int32 does not compile in C++11, nor in C where a constant is needed. In a function, C compilers warn of a
// division by 0.
#define GJK_Q16(units) GJK_FIXED((units)*65536.0)
#define GJK_Q30(value) GJK_FIXED((value)*1073741824.0)
#define GJK_ANGLE(radians) GJK_FIXED((radians)*65536.0)

// Helpers of the literals above: x as an integer, and x moved by half an LSB away from 0.
#define GJK_FIXED(x) \
  ((int32_t)GJK_TO_NEAREST(x) / GJK_TRUE(GJK_TO_NEAREST(x) >= -2147483648.5 && GJK_TO_NEAREST(x) < 2147483648.0))
#define GJK_TO_NEAREST(x) ((x) + ((x) < 0 ? -0.5 : 0.5))

// 1; does not compile if the condition is false.
#if defined(__cplusplus) && __cplusplus >= 201103L
#define GJK_TRUE(condition) ((int32_t)sizeof(char[(condition) ? 1 : -1]))
#else
#define GJK_TRUE(condition) ((condition) ? 1 : 0)
#endif

// x; does not compile unless x is an integer.
#define GJK_INTEGER(x) ((x) | 0)

// The pose at the origin, not rotated.
#define GJK_POSE_IDENTITY  \
  {                        \
    {0, 0, 0}, {           \
      0, 0, 0, GJK_Q30_ONE \
    }                      \
  }

// The largest radius of a shape about the centre of its core's bounding box, convex radius included: 4095 units.
#define GJK_RADIUS_MAX ((gjk_q16)(4095 * (int32_t)65536))

// The most vertices of one hull.
#define GJK_HULL_VERTICES_MAX 65535

// The most corners of one face of a hull.
#define GJK_FACE_CORNERS_MAX 12

// The highest level of a hull's table (gjk/table.h), and the number of cells of directions in a table of a level.
#define GJK_TABLE_LEVEL_MAX 4
#define GJK_TABLE_CELLS(level) (24 << 2 * (level))

// The most iterations of gjk_intersect, gjk_within, gjk_distance and their _until forms on polytopes of n and m
// vertices, with or without a convex radius. It is 15 + n + m, where n and m count as at most 64. src/gjk/gjk_search.h
// has the proof. A box has 8 vertices, a triangle 3, a segment or capsule 2, a point or sphere 1.
#define GJK_ITERATIONS_OF(n, m) (15 + ((n) < 64 ? (n) : 64) + ((m) < 64 ? (m) : 64))

// The ceiling on the iterations of a query with a cylinder, cone, ellipsoid or custom shape, for which no bound is
// proven. A query that reaches it returns GJK_ERROR_ITERATION_LIMIT. The query's comment says what it reports then.
#ifndef GJK_ITERATIONS_MAX
#define GJK_ITERATIONS_MAX 128
#endif
#if GJK_ITERATIONS_MAX < 1 || GJK_ITERATIONS_MAX > 250
#error "GJK_ITERATIONS_MAX must be from 1 to 250: define it for the whole build, or leave it at its default"
#endif

#endif
