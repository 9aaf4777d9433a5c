// Height fields: ground from a grid of heights, 2 bytes a sample.
#ifndef GJK_HEIGHT_FIELD_H
#define GJK_HEIGHT_FIELD_H

#include "gjk/parts.h"

#ifdef __cplusplus
extern "C" {
#endif

// The functions behind height fields.
extern const gjk_parts_class gjk_parts_class_height_field;

// The most columns, and the most rows.
#define GJK_HEIGHT_FIELD_SIDE_MAX 32768

// The largest step of a height. With it, heights are at most GJK_RADIUS_MAX apart.
#define GJK_HEIGHT_FIELD_STEP_MAX ((gjk_q16)4095)

// The height of a hole. Triangles with such a sample are missing.
#define GJK_HEIGHT_HOLE INT16_MIN

// A height field in its own frame. The initialiser below fills it; gjk_height_field_check checks it.
//
// Sample (i, j) is heights[j columns + i] and lies at (i step_x, j step_y, height step_z). Four samples make a cell.
// Its triangles are (i, j), (i + 1, j), (i + 1, j + 1) and (i, j), (i + 1, j + 1), (i, j + 1). Their fronts face +z,
// and contacts are only in front. Their numbers are k and k + 1, with k = 2 (j (columns - 1) + i).
typedef struct gjk_height_field {
  const int16_t *heights;  // the caller's, columns times rows
  uint16_t columns, rows;  // 2 to GJK_HEIGHT_FIELD_SIDE_MAX
  gjk_q16 step_x, step_y;  // Q16.16, above 0, at most GJK_RADIUS_MAX; the field is at most 16384 units long and wide
  gjk_q16 step_z;          // Q16.16, 1 to GJK_HEIGHT_FIELD_STEP_MAX
} gjk_height_field;

// A height field with these fields.
#define GJK_HEIGHT_FIELD(heights_pointer, columns, rows, step_x, step_y, step_z) \
  { (heights_pointer), (columns), (rows), GJK_INTEGER(step_x), GJK_INTEGER(step_y), GJK_INTEGER(step_z) }

// A body of this height field at the identity pose, for the queries of gjk/parts.h.
//
// gjk_parts_count includes triangles at holes; gjk_parts_place refuses them with RANGE. A field that
// gjk_height_field_check refuses counts as a body without parts (EMPTY).
// Cost  nearby cells are found by arithmetic. A query visits about 4 log2(columns) blocks of cells, and the cells whose
//       extent along x and y meets its region.
#define GJK_PARTS_OF_HEIGHT_FIELD(field) \
  { &gjk_parts_class_height_field, 1 ? (field) : (const gjk_height_field *)0, GJK_POSE_IDENTITY }

// Checks a height field. Statuses: NULL; RANGE: not as stated above; EMPTY: every triangle has a hole. Cost: one pass.
gjk_status gjk_height_field_check(const gjk_height_field *field);

#ifdef __cplusplus
}
#endif

#endif
