// The class of height fields: near cells found by arithmetic.
//
// Cells are walked along a Z-order curve. A node of level l holds the 4^l cells of a square block that begin at a number
// that 4^l divides. Its box needs no memory. The node that follows it, and all below it, begins at the next number, at the
// highest level that begins there. So the walk is a number.
#include "gjk/height_field.h"

#include "gjk_triangle.h"

// 4^15 cells.
#define LEVEL_MAX 15u
#define CELLS_END (UINT32_C(1) << 2 * LEVEL_MAX)

static const gjk_height_field *field_of(const void *data) {
  return (const gjk_height_field *)data;
}

static bool is_step(gjk_q16 step, uint16_t samples) {
  return step > 0 && step <= GJK_RADIUS_MAX && samples >= 2 && samples <= GJK_HEIGHT_FIELD_SIDE_MAX &&
         (int64_t)step * (samples - 1) <= INT32_C(1) << 30;
}

static bool is_as_stated(const gjk_height_field *f) {
  return f->heights != NULL && is_step(f->step_x, f->columns) && is_step(f->step_y, f->rows) && f->step_z > 0 &&
         f->step_z <= GJK_HEIGHT_FIELD_STEP_MAX;
}

static uint32_t count_of_field(const void *data) {
  const gjk_height_field *f = field_of(data);
  return is_as_stated(f) ? 2 * (uint32_t)(f->columns - 1) * (uint32_t)(f->rows - 1) : 0;
}

// The farthest corners: heights without holes are above -2^15.
static uint32_t reach_of_field(const void *data) {
  const gjk_height_field *f = field_of(data);
  const gjk_vec3 lower = {0, 0, -INT32_C(32767) * f->step_z};
  const gjk_vec3 upper = {f->step_x * (f->columns - 1), f->step_y * (f->rows - 1), INT32_C(32767) * f->step_z};
  return gjk_triangle_reach(&lower, &upper);
}

// A sample's place; false: a hole. Pre: there is one.
static bool sample_of(const gjk_height_field *f, uint32_t i, uint32_t j, gjk_vec3 *out) {
  const int16_t height = f->heights[j * f->columns + i];
  out->x = (int32_t)i * f->step_x;
  out->y = (int32_t)j * f->step_y;
  out->z = height * f->step_z;
  return height != GJK_HEIGHT_HOLE;
}

// The row of a cell. Out of line, so that no compiler makes one call for quotient and remainder of it.
GJK_OUT_OF_LINE static uint32_t row_of_cell(const gjk_height_field *f, uint32_t cell) {
  return cell / (f->columns - UINT32_C(1));
}

// The corners of a triangle of a cell; false: there is a hole.
static bool corners_in_cell(const gjk_height_field *f, uint32_t i, uint32_t j, unsigned second, gjk_vec3 corner[3]) {
  return sample_of(f, i, j, &corner[0]) && sample_of(f, i + 1, second != 0 ? j + 1 : j, &corner[1]) &&
         sample_of(f, second != 0 ? i : i + 1, j + 1, &corner[2]);
}

static bool corners_in_field(const gjk_height_field *f, uint32_t number, gjk_vec3 corner[3]) {
  const uint32_t cell = number / 2, cells = f->columns - UINT32_C(1), row = row_of_cell(f, cell);
  return corners_in_cell(f, cell - row * cells, row, number % 2, corner);
}

// Every second bit of a number.
static uint32_t even_bits(uint32_t x) {
  x &= UINT32_C(0x55555555);
  x = (x | x >> 1) & UINT32_C(0x33333333);
  x = (x | x >> 2) & UINT32_C(0x0F0F0F0F);
  x = (x | x >> 4) & UINT32_C(0x00FF00FF);
  return (x | x >> 8) & UINT32_C(0x0000FFFF);
}

// Ones in both halves of a number on the curve, as far as numbers up to count reach.
static uint32_t ones_over(uint32_t count) {
  return (UINT32_C(1) << 2 * (32u - gjk_clz32(count))) - 1;  // 0 < count < 2^15
}

// Which bits of a cell's number on the curve are complemented, so that a way leads from lower to higher numbers.
static uint32_t mirror_of(const gjk_height_field *f, const gjk_region *region) {
  const uint32_t x = region->moves && region->way[0] < 0 ? ones_over(f->columns - UINT32_C(1)) : 0;
  const uint32_t y = region->moves && region->way[1] < 0 ? ones_over(f->rows - UINT32_C(1)) : 0;
  return (x & UINT32_C(0x55555555)) | (y & UINT32_C(0xAAAAAAAA));
}

// May a block of cells meet the region? Blocks reach from the lowest height to the highest.
static bool block_meets(const gjk_height_field *f, const gjk_region *region, uint32_t cell, unsigned level) {
  const uint32_t i = even_bits(cell), j = even_bits(cell >> 1), side = UINT32_C(1) << level;
  const uint32_t columns = f->columns - UINT32_C(1), rows = f->rows - UINT32_C(1);
  if (i >= columns || j >= rows) {
    return false;
  }
  const uint32_t last_i = columns - i < side ? columns : i + side, last_j = rows - j < side ? rows : j + side;
  const gjk_aabb box = {{(int32_t)i * f->step_x, (int32_t)j * f->step_y, -INT32_C(32767) * f->step_z},
                        {(int32_t)last_i * f->step_x, (int32_t)last_j * f->step_y, INT32_C(32767) * f->step_z}};
  return gjk_region_meets(region, &box);
}

// Finds the next cell whose block meets the region; false: there is none.
static bool next_cell(const gjk_height_field *f, const gjk_region *region, gjk_parts_walk *walk) {
  const uint32_t mirror = mirror_of(f, region);
  uint32_t cell = walk->node;
  unsigned level = 0;
  bool found = false;
  while (cell < CELLS_END && !found) {  // ends: cell rises
    while (level < LEVEL_MAX && (cell >> 2 * level & 3u) == 0) {
      level++;
    }
    while (!found && block_meets(f, region, (cell ^ mirror) >> 2 * level << 2 * level, level)) {
      found = level == 0;
      level -= found ? 0u : 1u;
    }
    cell += UINT32_C(1) << 2 * level;
  }
  walk->node = cell;
  return found;
}

// walk->item: the next triangle of the cell before walk->node, 1 or 2; 0: there is none.
static bool next_in_field(const void *data, const gjk_region *region, gjk_parts_walk *walk, uint32_t *number) {
  const gjk_height_field *f = field_of(data);
  for (;;) {  // ends: each cell once
    if (walk->item == 0) {
      if (!next_cell(f, region, walk)) {
        return false;
      }
      walk->item = 1;
    }
    const unsigned second = walk->item == 2 ? 1 : 0;
    const uint32_t cell = (walk->node - 1) ^ mirror_of(f, region), i = even_bits(cell), j = even_bits(cell >> 1);
    gjk_vec3 corner[3];
    walk->item = second != 0 ? 0 : 2;
    if (corners_in_cell(f, i, j, second, corner) && gjk_triangle_meets(region, corner)) {
      *number = 2 * (j * (f->columns - UINT32_C(1)) + i) + second;
      return true;
    }
  }
}

// The cell below the region's middle, from 0 to cells - 1.
static uint32_t cell_below(int32_t lower, int32_t upper, int32_t step, uint32_t cells) {
  const int32_t middle = (int32_t)gjk_sar64((int64_t)lower + upper, 1);
  const uint32_t cell = middle < 0 ? 0 : (uint32_t)middle / (uint32_t)step;
  return cell < cells ? cell : cells - 1;
}

// A triangle of the cell below the region; where that is a hole, the next one there is.
static uint32_t guess_in_field(const void *data, const gjk_region *region) {
  const gjk_height_field *f = field_of(data);
  const gjk_aabb *box = &region->box;
  const uint32_t columns = f->columns - UINT32_C(1), rows = f->rows - UINT32_C(1), count = count_of_field(data);
  const uint32_t i = cell_below(box->lower.x, box->upper.x, f->step_x, columns);
  const uint32_t j = cell_below(box->lower.y, box->upper.y, f->step_y, rows);
  const uint32_t first = 2 * (j * columns + i);
  for (uint32_t k = 0; k < count; k++) {
    const uint32_t number = first < count - k ? first + k : first - (count - k);
    gjk_vec3 corner[3];
    if (corners_in_field(f, number, corner)) {
      return number;
    }
  }
  return first;  // a field of holes: no query finds a part, and place says so
}

static gjk_status place_in_field(const gjk_parts_frame *frame, uint32_t number, gjk_parts_room *room,
                                 gjk_collider *out) {
  gjk_vec3 corner[3];
  return corners_in_field(field_of(frame->parts->data), number, corner) ? gjk_triangle_place(frame, corner, room, out)
                                                                        : GJK_ERROR_RANGE;
}

static gjk_status local_in_field(const void *data, uint32_t number, gjk_parts_room *room, gjk_parts_local *out) {
  gjk_vec3 corner[3];
  if (!corners_in_field(field_of(data), number, corner)) {
    return GJK_ERROR_RANGE;
  }
  gjk_triangle_local(corner, room, out);
  return GJK_OK;
}

static unsigned edges_in_field(const void *data, uint32_t number) {
  // The third corner of the triangle across an edge, from the sample where the cell begins: of the first triangle of a cell
  // that across its edge 0, 1, 2, then of the second.
  static const int8_t far_corner[6][2] = {{0, -1}, {2, 1}, {0, 1}, {1, 0}, {1, 2}, {-1, 0}};
  const gjk_height_field *f = field_of(data);
  const uint32_t cells = f->columns - UINT32_C(1), row = row_of_cell(f, number / 2), first = number / 2 - row * cells;
  gjk_vec3 corner[3], far;
  unsigned edges = 0;
  if (!corners_in_field(f, number, corner)) {
    return 0;  // not reached: a precondition
  }
  for (unsigned k = 0; k < 3; k++) {
    const int8_t *to = far_corner[number % 2 * 3 + k];
    const int32_t i = (int32_t)first + to[0], j = (int32_t)row + to[1];
    const bool there = i >= 0 && j >= 0 && i < (int32_t)f->columns && j < (int32_t)f->rows &&
                       sample_of(f, (uint32_t)i, (uint32_t)j, &far);
    const gjk_mesh_edge edge =
        there ? gjk_triangle_edge_of(&corner[k], &corner[gjk_next(k)], &corner[gjk_next(gjk_next(k))], &far)
              : GJK_MESH_OPEN;
    edges |= (unsigned)edge << 2 * k;
  }
  return edges;
}

gjk_status gjk_height_field_check(const gjk_height_field *field) {
  if (field == NULL || field->heights == NULL) {
    return GJK_ERROR_NULL;
  }
  if (!is_as_stated(field)) {
    return GJK_ERROR_RANGE;
  }
  const uint32_t count = count_of_field(field);
  for (uint32_t number = 0; number < count; number++) {
    gjk_vec3 corner[3];
    if (corners_in_field(field, number, corner)) {
      return GJK_OK;
    }
  }
  return GJK_ERROR_EMPTY;
}

const gjk_parts_class gjk_parts_class_height_field = {
    .count = count_of_field,
    .reach = reach_of_field,
    .guess = guess_in_field,
    .next = next_in_field,
    .place = place_in_field,
    .local = local_in_field,
    .settle = gjk_surface_settle,
    .meet = gjk_surface_meet,
    .edges = edges_in_field,
};
