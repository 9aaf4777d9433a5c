// Making and checking the table of a hull.
//
// A vertex b stays out of a cell where another vertex a is farther by more than the slack along every direction of the
// cell. Both sides of
//   (a - b) . d > GJK_TABLE_SLACK (major component of d)
// are linear in d, so the cell's four corners settle it. What is kept are the vertices that none keeps out:
//   1. Find the vertex that is farthest along the middle of the cell. It keeps most others out.
//   2. Go through the vertices in order. One that is kept out, by the vertex of step 1 or one kept so far, is left.
//   3. Otherwise it takes the places of those that it keeps out, and comes last.
// The vertices that step 3 removes are not missed: what keeps one of these out keeps out all that it kept out.
#include "gjk/table.h"

#include "gjk_hull_table.h"

// A cell, as gjk_hull_table.h has it: directions (2^level, u, v) to (2^level, u + 1, v + 1) about the major axis.
typedef struct table_cell {
  unsigned major;       // 0 to 2
  int32_t sign[3];      // of x, y, z: -1 or 1
  int32_t scale, u, v;  // 2^level, u, v
} table_cell;

static table_cell cell_of(unsigned number, unsigned level) {
  const unsigned side = number >> 2 * level;
  table_cell cell = {side >> 3, {0, 0, 0}, INT32_C(1) << level, 0, 0};
  for (unsigned i = 0; i < 3; i++) {
    cell.sign[i] = (side >> i & 1u) != 0 ? -1 : 1;
  }
  for (unsigned i = 0; i < level; i++) {
    const unsigned quarter = number >> 2 * (level - 1 - i) & 3u;
    cell.u = 2 * cell.u + (int32_t)(quarter >> 1);
    cell.v = 2 * cell.v + (int32_t)(quarter & 1u);
  }
  return cell;
}

// Products of a vertex with the directions of a cell: of its first corner; what u + 1 and what v + 1 add.
typedef struct corner_products {
  int64_t first, u, v;
} corner_products;

static corner_products products_of(const table_cell *cell, const gjk_vec3 *vertex) {
  const int32_t along[3] = {vertex->x, vertex->y, vertex->z};
  const unsigned i = cell->major, j = gjk_next(i), k = gjk_next(j);
  // |component| <= 2^31, so that each is negated as int64_t; scale <= 2^4, u and v below:  |first| < 2^37
  corner_products products = {0, (int64_t)along[j] * cell->sign[j], (int64_t)along[k] * cell->sign[k]};
  products.first = (int64_t)along[i] * cell->sign[i] * cell->scale + products.u * cell->u + products.v * cell->v;
  //@ assert products.first >= -(INT64_C(1) << 37) && products.first <= INT64_C(1) << 37;
  return products;
}

// Is a farther than b by more than the slack along all directions of the cell?
static bool keeps_out(const table_cell *cell, const corner_products *a, const corner_products *b) {
  const int64_t first = a->first - b->first, u = a->u - b->u, v = a->v - b->v;
  return first + (u < 0 ? u : 0) + (v < 0 ? v : 0) > (int64_t)GJK_TABLE_SLACK * cell->scale;
}

// Step 1
static corner_products farthest_of(const table_cell *cell, const gjk_vec3 *vertices, uint16_t count) {
  corner_products best = products_of(cell, &vertices[0]);
  for (uint32_t i = 1; i < count; i++) {
    const corner_products products = products_of(cell, &vertices[i]);
    if (2 * (products.first - best.first) + (products.u - best.u) + (products.v - best.v) > 0) {
      best = products;
    }
  }
  return best;
}

// Is the vertex with these products kept out by one of count kept ones?
static bool is_kept_out(const table_cell *cell, const gjk_vec3 *vertices, const uint16_t *kept, uint32_t count,
                        const corner_products *products) {
  for (uint32_t i = 0; i < count; i++) {
    const corner_products other = products_of(cell, &vertices[kept[i]]);
    if (keeps_out(cell, &other, products)) {
      return true;
    }
  }
  return false;
}

// Step 3: drops those of count kept vertices that one with these products keeps out. Returns how many are left.
static uint32_t drop_kept_out(const table_cell *cell, const gjk_vec3 *vertices, uint16_t *kept, uint32_t count,
                              const corner_products *products) {
  uint32_t left = 0;
  for (uint32_t i = 0; i < count; i++) {
    const corner_products other = products_of(cell, &vertices[kept[i]]);
    if (!keeps_out(cell, products, &other)) {
      kept[left++] = kept[i];
    }
  }
  return left;
}

// Steps 1 to 3: writes the vertices of a cell. False: more than capacity would have to be kept.
static bool fill_cell(const table_cell *cell, const gjk_vec3 *vertices, uint16_t count, uint16_t *kept,
                      uint32_t capacity, uint32_t *kept_count) {
  const corner_products farthest = farthest_of(cell, vertices, count);
  *kept_count = 0;
  for (uint32_t i = 0; i < count; i++) {
    const corner_products products = products_of(cell, &vertices[i]);
    if (keeps_out(cell, &farthest, &products) || is_kept_out(cell, vertices, kept, *kept_count, &products)) {
      continue;
    }
    *kept_count = drop_kept_out(cell, vertices, kept, *kept_count, &products);
    if (*kept_count == capacity) {
      return false;
    }
    kept[(*kept_count)++] = (uint16_t)i;
  }
  return true;
}

gjk_status gjk_hull_table_make(const gjk_vec3 *vertices, uint16_t count, uint8_t level, uint16_t *vertex,
                               uint16_t capacity, uint16_t *end) {
  if (vertices == NULL || vertex == NULL || end == NULL) {
    return GJK_ERROR_NULL;
  }
  if (count == 0) {
    return GJK_ERROR_EMPTY;
  }
  if (level > GJK_TABLE_LEVEL_MAX) {
    return GJK_ERROR_RANGE;
  }
  uint32_t used = 0;
  for (unsigned i = 0; i < (unsigned)GJK_TABLE_CELLS(level); i++) {
    const table_cell cell = cell_of(i, level);
    uint32_t kept;
    if (!fill_cell(&cell, vertices, count, &vertex[used], capacity - used, &kept)) {
      return GJK_ERROR_CAPACITY;
    }
    used += kept;
    end[i] = (uint16_t)used;
  }
  return GJK_OK;
}

gjk_status gjk_table_measure(const gjk_hull_table *table, uint16_t count) {
  uint16_t first = 0;
  if (table == NULL || table->vertex == NULL || table->end == NULL) {
    return GJK_ERROR_NULL;
  }
  if (table->level > GJK_TABLE_LEVEL_MAX) {
    return GJK_ERROR_RANGE;
  }
  for (unsigned i = 0; i < (unsigned)GJK_TABLE_CELLS(table->level); i++) {
    const uint16_t end = table->end[i];
    uint32_t least = 0;  // the vertex that may come next
    if (end <= first) {
      return GJK_ERROR_RANGE;
    }
    for (; first < end; first++) {
      if (table->vertex[first] < least || table->vertex[first] >= count) {
        return GJK_ERROR_RANGE;
      }
      least = table->vertex[first] + UINT32_C(1);
    }
  }
  return GJK_OK;
}

// Do the listed vertices of a cell keep all others out?
static bool is_complete(const table_cell *cell, const gjk_vec3 *vertices, uint16_t count, const uint16_t *listed,
                        uint32_t listed_count) {
  uint32_t next = 0;
  for (uint32_t i = 0; i < count; i++) {
    if (next < listed_count && listed[next] == i) {
      next++;
    } else {
      const corner_products products = products_of(cell, &vertices[i]);
      if (!is_kept_out(cell, vertices, listed, listed_count, &products)) {
        return false;
      }
    }
  }
  return true;
}

gjk_status gjk_hull_table_check(const gjk_vec3 *vertices, uint16_t count, const gjk_hull_table *table) {
  if (vertices == NULL) {
    return GJK_ERROR_NULL;
  }
  const gjk_status status = gjk_table_measure(table, count);
  if (status != GJK_OK) {
    return status;
  }
  uint16_t first = 0;
  for (unsigned i = 0; i < (unsigned)GJK_TABLE_CELLS(table->level); i++) {
    const table_cell cell = cell_of(i, table->level);
    const uint16_t end = table->end[i];
    if (!is_complete(&cell, vertices, count, &table->vertex[first], (uint32_t)(end - first))) {
      return GJK_ERROR_UNPROVEN;
    }
    first = end;
  }
  return GJK_OK;
}
