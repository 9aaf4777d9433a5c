// Tables for large hulls, with which a support scan looks at only a few vertices: how to make and prove them.
//
// A table divides the directions into GJK_TABLE_CELLS(level) cells. For each cell it lists the vertices that may be
// farthest along one of its directions. A query scans one cell's list: 5 to 12 vertices, however many the hull has. The
// answers are the same bits as without a table. A table is a constant, made beforehand, fit for flash:
//
//     static uint16_t vertex[2000], end[GJK_TABLE_CELLS(1)];
//     gjk_hull_table_make(points, 256, 1, vertex, 2000, end);
//     const gjk_hull_table table = {vertex, end, 1};
//     const gjk_shape rock = GJK_HULL_WITH_TABLE(points, 256, &table);
#ifndef GJK_TABLE_H
#define GJK_TABLE_H

#include "gjk/shape.h"
#include "gjk/status.h"

#ifdef __cplusplus
extern "C" {
#endif

// Makes the table of a hull from its vertices. They need no order, and may repeat, lie inside or be collinear.
//
// level     0 to GJK_TABLE_LEVEL_MAX. Good choices: 0 up to 48 vertices, 1 up to 256, 2 up to 1,024, 3 beyond.
// vertex    room for capacity numbers. The table has end[GJK_TABLE_CELLS(level) - 1] of them. With the levels above, 12
//           numbers a cell are mostly enough: 12 * GJK_TABLE_CELLS(level).
// end       room for GJK_TABLE_CELLS(level) numbers.
// Whole     For hulls of a few LSB, and polygons of many corners across a cell's directions, it lists all vertices.
// Statuses  NULL, EMPTY, RANGE (level), CAPACITY: vertex is too small, and vertex and end hold no valid table.
// Cost      each cell takes a pass over the vertices, and compares each with those listed so far. Meant for a host, or
//           for one call on a microcontroller.
gjk_status gjk_hull_table_make(const gjk_vec3 *vertices, uint16_t count, uint8_t level, uint16_t *vertex,
                               uint16_t capacity, uint16_t *end);

// Proves that queries find the same vertices with the table as without it. For every vertex that a cell leaves out, the
// cell lists one that is farther along all of its directions.
//
// Statuses  OK: proven. NULL, RANGE: as in gjk_collider_init. UNPROVEN: a vertex may be missing. A table made by
//           gjk_hull_table_make from the same vertices is always proven.
// Cost      as gjk_hull_table_make.
gjk_status gjk_hull_table_check(const gjk_vec3 *vertices, uint16_t count, const gjk_hull_table *table);

#ifdef __cplusplus
}
#endif

#endif
