// Tables that spare large hulls the look at every vertex: how to make one, and how to prove one.
//
// A table divides the directions into GJK_TABLE_CELLS(level) cells, and lists for each the vertices that may be farthest
// along one of its directions. A query looks at those of one cell alone, 5 to 12 of any number. The answers are the
// same bits as without a table. It is a constant, made beforehand, fit for flash:
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

// Makes the table of a hull from its vertices, in any order, with repeated, inner and collinear ones.
//
// level     0 to GJK_TABLE_LEVEL_MAX. Good choices: 0 up to 48 vertices, 1 up to 256, 2 up to 1,024, 3 beyond.
// vertex    room for capacity numbers; end[GJK_TABLE_CELLS(level) - 1] of them are the table's.
// end       room for GJK_TABLE_CELLS(level) numbers.
// Hulls of a few LSB, and cells that face a polygon of many corners, are listed whole.
// Statuses  NULL, EMPTY, RANGE (level), CAPACITY: vertex was too small, and what vertex and end hold is no table.
// Cost      each cell takes a pass over the vertices, and for each vertex a look at those listed so far. Of use on a
//           host; on a microcontroller once.
gjk_status gjk_hull_table_make(const gjk_vec3 *vertices, uint16_t count, uint8_t level, uint16_t *vertex,
                               uint16_t capacity, uint16_t *end);

// Proves that queries find with the table what they find without it. For every vertex that a cell does not list, it
// lists one that is farther along all of the cell's directions.
//
// Statuses  OK: proven. NULL, RANGE: as gjk_collider_init has it. UNPROVEN: a vertex may be missing. A table made by
//           gjk_hull_table_make of the same vertices is always proven.
// Cost      as gjk_hull_table_make.
gjk_status gjk_hull_table_check(const gjk_vec3 *vertices, uint16_t count, const gjk_hull_table *table);

#ifdef __cplusplus
}
#endif

#endif
