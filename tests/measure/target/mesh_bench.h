// What contacts with a mesh of 10,000 triangles and with a height field cost, distances and rays.
#ifndef MESH_BENCH_H
#define MESH_BENCH_H

#include "gjk/height_field.h"
#include "gjk/mesh.h"
#include "gjk/surface.h"

#define MESH_BENCH_SIDE 71  // cells along x and y: 10,082 triangles
#define MESH_BENCH_BODIES 64

// Makes the ground: gentle hills, cells of one unit. False: it could not be built.
bool mesh_bench_make(void);

// Which body: a box or a ball, about size_q16 in half extent; rests on the ground at place i.
typedef enum mesh_bench_kind { MESH_BENCH_BOX, MESH_BENCH_FLUSH, MESH_BENCH_BALL, MESH_BENCH_KINDS } mesh_bench_kind;

void mesh_bench_place(mesh_bench_kind kind, unsigned i, gjk_collider *body);

// The manifolds of the body with the mesh, or with the height field.
unsigned mesh_bench_contacts(const gjk_collider *body, bool field);

// The distance from it.
gjk_q16 mesh_bench_distance(const gjk_collider *body, bool field);

// A ray from the body's place up to 16 units along the ground, which falls by 4. Does it hit?
bool mesh_bench_ray(const gjk_collider *body, bool field);

#endif
