// Queries with flat arguments, for hosts that see memory as numbers.
//
// Lengths are Q16.16, unit vectors and quaternions Q2.30. A query returns a gjk_status. After GJK_OK its answer stands in
// the report, an array of int32; after another status the report is as it was. Not reentrant.
#ifndef GJK_WASM_H
#define GJK_WASM_H

#include "gjk/cast.h"
#include "gjk/gjk.h"

// The longest: a scene's report, and of its contacts count, normal and features, then points, distance and id of each.
#define GJK_WASM_REPORT (12 + 6 + 8 * GJK_CONTACTS_MAX)

const int32_t *gjk_wasm_report(void);

// A shape at the origin. NULL: the report begins with the gjk_status.
//
// kind      0 point, 1 segment, 2 box, 3 triangle, 4 hull, 5 cylinder, 6 cone, 7 ellipsoid.
// x, y, z   gjk_shape.size: half extents or radii; of a segment z is half its length, of a cylinder or cone x is the radius.
// vertices  of a triangle or hull, x, y, z of each; copied. Else NULL, and count 0.
gjk_collider *gjk_wasm_collider(int kind, int32_t x, int32_t y, int32_t z, int32_t convex_radius,
                                const int32_t *vertices, unsigned count);

// The convex hull of points, with its faces, as a shape with this convex radius. count: at most 65535.
gjk_collider *gjk_wasm_hull_build(const int32_t *points, unsigned count, int32_t convex_radius);

// Reports where a hull's vertices stand and how many there are; then of its faces the count, 0: it has none, where the
// numbers of their corners stand, and where their ends.
void gjk_wasm_polyhedron(const gjk_collider *collider);

// Releases a shape. Scenes that have it keep its memory until they are released.
void gjk_wasm_release(gjk_collider *collider);

// As gjk_collider_pose: position, then the quaternion.
int gjk_wasm_pose(gjk_collider *collider, int32_t x, int32_t y, int32_t z, int32_t i, int32_t j, int32_t k, int32_t w);

// Reports yes, iterations.
int gjk_wasm_intersect(const gjk_collider *a, const gjk_collider *b);

// Reports intersecting, distance, point_a, point_b, normal, iterations, and whether gjk_check_distance proves it.
int gjk_wasm_distance(const gjk_collider *a, const gjk_collider *b);

// Reports intersecting, depth, point_a, point_b, normal, iterations, and whether gjk_check_penetration proves it.
int gjk_wasm_penetration(const gjk_collider *a, const gjk_collider *b);

// Reports count, normal, feature_a, feature_b, and of each contact point_a, point_b, distance, id.
int gjk_wasm_contacts(const gjk_collider *a, const gjk_collider *b, int32_t margin);

// B's position moves to x, y, z. Reports hit, fraction, point_a, point_b, normal, rest_b, iterations.
int gjk_wasm_cast(const gjk_collider *a, const gjk_collider *b, int32_t x, int32_t y, int32_t z, int32_t margin);

// Scenes, with depths, contacts and fast bodies.
typedef struct gjk_wasm_scene gjk_wasm_scene;

// config: the fields of gjk_scene_config in their order, but for pair_words, which is 0. Of workspace_cells no more count than
// there are. NULL: the report begins with the gjk_status.
gjk_wasm_scene *gjk_wasm_scene_make(gjk_collider *const *shapes, unsigned count, const int32_t *config);
void gjk_wasm_scene_release(gjk_wasm_scene *scene);

// slot: negative for the lowest free one. setup: the pose, then kind, detail, category, mask, user and margin. parts: of
// each its shape, whether it has a pose of its own, and that. Reports the slot and the generation.
int gjk_wasm_scene_add(gjk_wasm_scene *scene, int slot, const int32_t *setup, const int32_t *parts, unsigned count);

// As gjk_scene_move, or as gjk_scene_teleport.
int gjk_wasm_scene_move(gjk_wasm_scene *scene, uint32_t slot, uint32_t generation, const int32_t *pose, bool teleport);

// What else happens to a body. first, second: the arguments of the call of that name.
enum gjk_wasm_change {
  GJK_WASM_REMOVE,
  GJK_WASM_SLEEP,
  GJK_WASM_WAKE,
  GJK_WASM_SET_MOTION,
  GJK_WASM_SET_SHAPE,
  GJK_WASM_SET_FILTER,
  GJK_WASM_SET_USER
};
int gjk_wasm_scene_change(gjk_wasm_scene *scene, int change, uint32_t slot, uint32_t generation, uint32_t first,
                          uint32_t second);

// Reports the fields of gjk_body_state in their order.
int gjk_wasm_scene_get(const gjk_wasm_scene *scene, uint32_t slot, uint32_t generation);

// An update, one report at a time. Reports whether more may follow, so call it again; whether there is a report; then its
// bodies, parts, event, detail, distance, fraction, and contacts as gjk_wasm_contacts.
int gjk_wasm_scene_update(gjk_wasm_scene *scene);

// from, to: three numbers each. filter: category, mask, and a body to ignore. Reports found, the body, part and fraction, and
// of the cast point_a and normal.
int gjk_wasm_scene_cast_ray(const gjk_wasm_scene *scene, const int32_t *from, const int32_t *to, const int32_t *filter);

// Reports the fields of gjk_scene_stats; the low and the high word of the hash.
int gjk_wasm_scene_stats(const gjk_wasm_scene *scene);
int gjk_wasm_scene_hash(const gjk_wasm_scene *scene);

// Seals a scene. Reports where its block stands, and its bytes: a copy of them is a save.
int gjk_wasm_scene_save(gjk_wasm_scene *scene);

// Opens a copy of such a block, of gjk_port_allocate, in the place of the scene's, and takes it after GJK_OK alone.
int gjk_wasm_scene_load(gjk_wasm_scene *scene, void *block, uint32_t bytes);

#endif
