// Functions for what the other headers give by macros, for languages that call the library without a C compiler.
//
// C and C++ programs need none of this. A function here links what its macro names, and nothing else.
#ifndef GJK_BIND_H
#define GJK_BIND_H

#include "gjk/compound.h"
#include "gjk/height_field.h"
#include "gjk/mesh.h"
#include "gjk/scene.h"
#include "gjk/shape.h"
#include "gjk/status.h"

#ifdef __cplusplus
extern "C" {
#endif

// Shapes. Each function makes what the macro of its name makes: gjk_shape_box that of GJK_ROUNDED_BOX.
//
// radius    the convex radius, Q16.16, at least 0. A box with 0 is GJK_BOX, a point with a radius is GJK_SPHERE, a
//           segment with one is GJK_CAPSULE.
// out       written when the result is GJK_OK. What a shape points to stays the caller's, and must outlive it.
// Statuses  those of gjk_collider_init for the shape: NULL, NEGATIVE, SIZE, EMPTY, RANGE.
// Cost      that of gjk_collider_init.
gjk_status gjk_shape_point(gjk_q16 radius, gjk_shape *out);
gjk_status gjk_shape_segment(gjk_q16 half, gjk_q16 radius, gjk_shape *out);
gjk_status gjk_shape_triangle(const gjk_vec3 *vertices3, gjk_q16 radius, gjk_shape *out);
gjk_status gjk_shape_box(gjk_q16 half_x, gjk_q16 half_y, gjk_q16 half_z, gjk_q16 radius, gjk_shape *out);
gjk_status gjk_shape_cylinder(gjk_q16 base_radius, gjk_q16 half, gjk_q16 radius, gjk_shape *out);
gjk_status gjk_shape_cone(gjk_q16 base_radius, gjk_q16 half, gjk_q16 radius, gjk_shape *out);
gjk_status gjk_shape_ellipsoid(gjk_q16 radius_x, gjk_q16 radius_y, gjk_q16 radius_z, gjk_q16 radius, gjk_shape *out);
gjk_status gjk_shape_custom(gjk_support_function *support, const void *user, gjk_q16 bound, gjk_q16 radius,
                            gjk_shape *out);

// faces may be NULL.
gjk_status gjk_shape_hull(const gjk_vec3 *vertices, uint16_t count, const gjk_hull_faces *faces, gjk_q16 radius,
                          gjk_shape *out);
gjk_status gjk_shape_hull_with_table(const gjk_vec3 *vertices, uint16_t count, const gjk_hull_faces *faces,
                                     const gjk_hull_table *table, gjk_q16 radius, gjk_shape *out);

// Bodies of many parts at the identity pose, as GJK_PARTS_OF_COMPOUND and its like make them. Statuses: NULL.
gjk_status gjk_parts_of_compound(const gjk_compound *compound, gjk_parts *out);
gjk_status gjk_parts_of_mesh(const gjk_mesh *mesh, gjk_parts *out);
gjk_status gjk_parts_of_height_field(const gjk_height_field *field, gjk_parts *out);

// Bindings for contacts, depths and motions: the tables that C programs name by address. All other fields are zeroed.
// Statuses: NULL.
gjk_status gjk_scene_bind_all(gjk_scene_bindings *out);

// The room that a result needs. GJK_COMPOUND_NODES, GJK_MESH_NODES and GJK_TABLE_CELLS are counts, GJK_HULL_WORKSPACE
// and GJK_HULL_SIMPLIFY_WORKSPACE are bytes. For a workspace see gjk_workspace_bytes of gjk/penetration.h. 0: the
// argument is out of range. Parts and triangles are at least 1, levels at most GJK_TABLE_LEVEL_MAX, points at most
// GJK_HULL_POINTS_MAX.
uint32_t gjk_compound_nodes(uint32_t parts);
uint32_t gjk_mesh_nodes(uint32_t triangles);
uint32_t gjk_table_cells(uint8_t level);
uint32_t gjk_hull_workspace(uint32_t points);
uint32_t gjk_hull_simplify_workspace(uint32_t points);

// The bytes of a public structure of this build, also of the plane: gjk_size_of("gjk_collider"). So other languages can
// reserve structures that they do not look into, and check those that they do. No structure needs an alignment above 8
// bytes. Any other name, and NULL, give 0.
size_t gjk_size_of(const char *structure);

// The value of a public constant or enumerator, also of the plane: gjk_constant("GJK_Q30_ONE", &one).
//
// out       written when the result is GJK_OK.
// Statuses  NULL; RANGE: there is none of this name.
gjk_status gjk_constant(const char *name, int64_t *out);

#ifdef __cplusplus
}
#endif

#endif
