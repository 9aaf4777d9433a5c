// Queries with flat arguments, for hosts that see memory as numbers.
//
// Lengths are Q16.16, unit vectors and quaternions Q2.30. A query returns a gjk_status. After GJK_OK its answer stands in
// the report, an array of int32; after another status the report is as it was. Not reentrant.
#ifndef GJK_WASM_H
#define GJK_WASM_H

#include "gjk/cast.h"
#include "gjk/gjk.h"

// Of contacts: count and normal, then points, distance and id of each.
#define GJK_WASM_REPORT (4 + 8 * GJK_CONTACTS_MAX)

const int32_t *gjk_wasm_report(void);

// A shape at the origin. Release it with gjk_port_release. NULL: the report begins with the gjk_status.
//
// kind      0 point, 1 segment, 2 box, 3 triangle, 4 hull, 5 cylinder, 6 cone, 7 ellipsoid.
// x, y, z   gjk_shape.size: half extents or radii; of a segment z is half its length, of a cylinder or cone x is the radius.
// vertices  of a triangle or hull, x, y, z of each; copied. Else NULL, and count 0.
gjk_collider *gjk_wasm_collider(int kind, int32_t x, int32_t y, int32_t z, int32_t convex_radius,
                                const int32_t *vertices, unsigned count);

// As gjk_collider_pose: position, then the quaternion.
int gjk_wasm_pose(gjk_collider *collider, int32_t x, int32_t y, int32_t z, int32_t i, int32_t j, int32_t k, int32_t w);

// Reports yes, iterations.
int gjk_wasm_intersect(const gjk_collider *a, const gjk_collider *b);

// Reports intersecting, distance, point_a, point_b, normal, iterations, and whether gjk_check_distance proves it.
int gjk_wasm_distance(const gjk_collider *a, const gjk_collider *b);

// Reports intersecting, depth, point_a, point_b, normal, iterations, and whether gjk_check_penetration proves it.
int gjk_wasm_penetration(const gjk_collider *a, const gjk_collider *b);

// Reports count, normal, and of each contact point_a, point_b, distance, id.
int gjk_wasm_contacts(const gjk_collider *a, const gjk_collider *b, int32_t margin);

// B's position moves to x, y, z. Reports hit, fraction, point_a, point_b, normal, rest_b, iterations.
int gjk_wasm_cast(const gjk_collider *a, const gjk_collider *b, int32_t x, int32_t y, int32_t z, int32_t margin);

#endif
