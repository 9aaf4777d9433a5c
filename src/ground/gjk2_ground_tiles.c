// Grids of tiles as ground: their merged outline, found near a box.
//
// Each tile is a convex polygon with its corners on quarters of its sides. Its sides are cut by what the tile across covers;
// what is left of them, and its surface, are the outline. Where two solids share a side nothing is left.
//
//   1. Go through the tiles that the box meets, and the sides of each.
//   2. Find the run that a side is in: sides in line, one after the other, up to the next cut at a multiple of
//      GJK2_TILE_RUN tiles. Take it at the first of its sides that the walk meets.
//   3. Find the neighbours of the run among the sides of the tiles around its ends.
//
// Lengths are in quarters of a tile until the end: at most 4 2^16.
#include "gjk2_ground_box.h"
#include "gjk2_ground_walk.h"

#define SIDES 4
#define SURFACE 2
#define QUARTERS 4

// A side of the outline, counterclockwise about its tile.
typedef struct tile_side {
  int32_t column, row;
  unsigned side;
  gjk2_vec from, to;  // not the same
} tile_side;

static const gjk2_tiles *tiles_of(const gjk2_ground_walk *walk) {
  return (const gjk2_tiles *)walk->ground->data;
}

// The form of a tile that has sides; NULL: it is empty.
static const gjk2_tile *form_of(const gjk2_tiles *t, int32_t column, int32_t row) {
  if (column < 0 || row < 0 || column >= t->columns || row >= t->rows) {
    return NULL;
  }
  const uint8_t number = t->cells[(uint32_t)row * t->columns + (uint32_t)column];
  if (number >= t->form_count) {
    return NULL;
  }
  const gjk2_tile *form = &t->forms[number];
  return form->one_way || (form->left | form->right) != 0 ? form : NULL;
}

static int32_t quarters_of(uint8_t height) {
  return height < QUARTERS ? height : QUARTERS;
}

// Does a tile fill its square? Most do, or are empty, so they are told first.
static bool is_full(const gjk2_tile *form) {
  return form->left >= QUARTERS && form->right >= QUARTERS && !form->one_way;
}

// The ends of a side, tile frame, before the tile is turned_corner.
static void unturned_side(const gjk2_tile *form, unsigned side, gjk2_vec *from, gjk2_vec *to) {
  const int32_t left = quarters_of(form->left), right = quarters_of(form->right);
  from->x = side == 1 || side == SURFACE ? QUARTERS : 0;
  to->x = side == 0 || side == 1 ? QUARTERS : 0;
  from->y = side == 3 ? left : side == SURFACE ? right : 0;
  to->y = side == 1 ? right : side == SURFACE ? left : 0;
}

static gjk2_vec turned_corner(gjk2_vec v, unsigned turns) {
  for (unsigned i = 0; i < (turns & 3u); i++) {
    const gjk2_vec next = {QUARTERS - v.y, v.x};
    gjk2_copy(&v, &next);
  }
  return v;
}

// What a tile covers of a side of its square, by quarters from the side's lower end: from *low to *high, none if they are
// the same. It begins or ends at an end of the side. square: 0 below, 1 right, 2 above, 3 left.
static void covered_by(const gjk2_tile *form, unsigned square, int32_t *low, int32_t *high) {
  const unsigned side = (square - form->turns) & 3u;
  gjk2_vec from, to;
  *low = *high = 0;
  if (is_full(form)) {
    *high = QUARTERS;
    return;
  }
  if (form->one_way || (side == SURFACE && (form->left < QUARTERS || form->right < QUARTERS))) {
    return;
  }
  unturned_side(form, side, &from, &to);
  from = turned_corner(from, form->turns);
  to = turned_corner(to, form->turns);
  const int32_t a = square % 2 == 0 ? from.x : from.y, b = square % 2 == 0 ? to.x : to.y;
  *low = a < b ? a : b;
  *high = a < b ? b : a;
}

// The side of the square that a side of a tile lies on; false: it lies within.
static bool square_of(const gjk2_tile *form, unsigned side, unsigned *square) {
  unsigned on = side;
  if (side == SURFACE) {
    if (form->left == 0 && form->right == 0) {
      on = 0;
    } else if (form->left < QUARTERS || form->right < QUARTERS) {
      return false;
    }
  }
  *square = (on + form->turns) & 3u;
  return true;
}

// Cuts what lies between low and high off a range along an axis. Both begin or end at an end of the square's side.
static void cut_range(int32_t *from, int32_t *to, int32_t low, int32_t high) {
  int32_t *least = *from < *to ? from : to, *most = *from < *to ? to : from;
  if (low == high) {
    return;
  }
  if (low == 0) {
    *least = *least > high ? *least : high;
    *most = *most > high ? *most : high;
  } else {
    *most = *most < low ? *most : low;
    *least = *least < low ? *least : low;
  }
}

// The side of a full tile on one side of its square.
static void full_side(unsigned square, gjk2_vec *from, gjk2_vec *to) {
  const int32_t right = square == 0 || square == 1 ? QUARTERS : 0, above = square == 1 || square == 2 ? QUARTERS : 0;
  from->x = above;
  from->y = QUARTERS - right;
  to->x = right;
  to->y = above;
}

// What is left of a side that lies on one side of the tile's square, next to the tile across.
static void cut_side(const gjk2_tile *other, unsigned square, gjk2_vec *from, gjk2_vec *to) {
  int32_t low, high;
  covered_by(other, (square + 2) & 3u, &low, &high);
  if (square % 2 == 0) {
    cut_range(&from->x, &to->x, low, high);
  } else {
    cut_range(&from->y, &to->y, low, high);
  }
}

// A side of a tile, if any of it is outline.
static bool find_tile_side(const gjk2_tiles *t, const gjk2_tile *form, int32_t column, int32_t row, unsigned side,
                           tile_side *out) {
  static const int8_t across_x[SIDES] = {0, 1, 0, -1}, across_y[SIDES] = {-1, 0, 1, 0};
  unsigned square = 0;
  if (form->one_way && side != SURFACE) {
    return false;
  }
  const bool full = is_full(form), bounds = square_of(form, side, &square);
  const gjk2_tile *other = bounds ? form_of(t, column + across_x[square], row + across_y[square]) : NULL;
  if (full && other != NULL && is_full(other)) {
    return false;
  }
  if (full) {
    full_side(square, &out->from, &out->to);
  } else {
    unturned_side(form, side, &out->from, &out->to);
    out->from = turned_corner(out->from, form->turns);
    out->to = turned_corner(out->to, form->turns);
  }
  if (other != NULL) {
    cut_side(other, square, &out->from, &out->to);
  }
  if (gjk2_equal(out->from, out->to)) {
    return false;
  }
  const gjk2_vec corner = {column * QUARTERS, row * QUARTERS};
  out->from = gjk2_add(out->from, corner);
  out->to = gjk2_add(out->to, corner);
  out->column = column;
  out->row = row;
  out->side = side;
  return true;
}

// By parts, see gjk2_copy.
static void copy_side(tile_side *to, const tile_side *from) {
  to->column = from->column;
  to->row = from->row;
  to->side = from->side;
  gjk2_copy(&to->from, &from->from);
  gjk2_copy(&to->to, &from->to);
}

static gjk2_vec way_of_side(const tile_side *s) {
  return gjk2_sub(s->to, s->from);
}

static bool are_in_line(const tile_side *s, const tile_side *next) {
  const gjk2_vec a = way_of_side(s), b = way_of_side(next);
  return gjk2_cross(a, b) == 0 && gjk2_dot(a, b) > 0;
}

// How far the outline turns right from one side to the next, as a rank: right, straight on, left, back.
static int rank_of(gjk2_vec from, gjk2_vec to) {
  const int64_t turn = gjk2_cross(from, to);
  return turn < 0 ? 0 : turn > 0 ? 2 : gjk2_dot(from, to) > 0 ? 1 : 3;
}

// Is a candidate the better neighbour? Straight on is best; then what turns right the most.
static bool is_better_side(const tile_side *s, const tile_side *candidate, const tile_side *best, bool following) {
  const gjk2_vec way = way_of_side(s), c = way_of_side(candidate), b = way_of_side(best);
  const int rank = following ? rank_of(way, c) : rank_of(c, way),
            rank_best = following ? rank_of(way, b) : rank_of(b, way);
  if (rank != rank_best) {
    return rank == 1 || (rank_best != 1 && rank < rank_best);
  }
  const int64_t turn = gjk2_cross(b, c);
  return following ? turn < 0 : turn > 0;
}

// The one side of a full tile, cut or not, that begins at a corner of its square, or ends there. SIDES: the place, in the
// tile's frame, is no corner.
static unsigned side_at_corner(const gjk2_tile *form, gjk2_vec place, bool begins) {
  if (place.x % QUARTERS != 0 || place.y % QUARTERS != 0) {
    return SIDES;
  }
  const unsigned square = place.y == 0 ? (place.x == 0 ? 0 : 1) : (place.x == 0 ? 3 : 2);  // that begins there
  return (square + (begins ? 0 : 3) - form->turns) & 3u;
}

// The best neighbour of a side among those of one tile that meet it at a place.
static void try_tile(const gjk2_tiles *t, const tile_side *s, bool following, int32_t column, int32_t row, bool *found,
                     tile_side *out) {
  const gjk2_tile *form = form_of(t, column, row);
  const gjk2_vec at = following ? s->to : s->from, place = {at.x - column * QUARTERS, at.y - row * QUARTERS};
  const unsigned only = form != NULL && is_full(form) ? side_at_corner(form, place, following) : SIDES;
  for (unsigned side = 0; form != NULL && side < SIDES; side++) {
    tile_side candidate;
    if (only < SIDES && side != only) {
      continue;
    }
    if (find_tile_side(t, form, column, row, side, &candidate) &&
        gjk2_equal(following ? candidate.from : candidate.to, at) &&
        (!*found || is_better_side(s, &candidate, out, following))) {
      copy_side(out, &candidate);
      *found = true;
    }
  }
}

// The tiles that hold a coordinate, or one next to it: low to high. step: on which side of it; 0: on both.
static void tiles_at(int32_t at, int32_t step, int32_t *low, int32_t *high) {
  const int32_t tile = at / QUARTERS;  // not negative
  const bool between = at % QUARTERS == 0;
  *low = between && step <= 0 ? tile - 1 : tile;
  *high = between && step < 0 ? tile - 1 : tile;
}

// Step 3: the side that follows at the end of another, or precedes it at its beginning. ahead: among the tiles straight on
// alone; otherwise among all there.
static bool find_neighbour_side(const gjk2_tiles *t, const tile_side *s, bool following, bool ahead, tile_side *out) {
  const gjk2_vec at = following ? s->to : s->from, way = way_of_side(s);
  const int32_t step = !ahead ? 0 : following ? 1 : -1;
  gjk2_vec low, high;
  bool found = false;
  tiles_at(at.x, way.x > 0 ? step : way.x < 0 ? -step : 0, &low.x, &high.x);
  tiles_at(at.y, way.y > 0 ? step : way.y < 0 ? -step : 0, &low.y, &high.y);
  for (int32_t y = low.y; y <= high.y; y++) {
    for (int32_t x = low.x; x <= high.x; x++) {
      try_tile(t, s, following, x, y, &found, out);
    }
  }
  return found;
}

// Does a run end at this place, whatever follows?
static bool is_run_cut(gjk2_vec at, gjk2_vec way) {
  const int32_t along = way.x != 0 ? at.x : at.y;
  return along % (QUARTERS * GJK2_TILE_RUN) == 0;
}

// The side in line that follows, or precedes, in the same run. The same side of the tile one step on is tried first.
static bool find_in_run(const gjk2_tiles *t, const tile_side *s, bool following, tile_side *out) {
  const gjk2_vec way = way_of_side(s), at = following ? s->to : s->from;
  const int32_t step = following ? 1 : -1;
  if (is_run_cut(at, way)) {
    return false;
  }
  const int32_t column = s->column + (way.x > 0 ? step : way.x < 0 ? -step : 0);
  const int32_t row = s->row + (way.y > 0 ? step : way.y < 0 ? -step : 0);
  const gjk2_tile *form = form_of(t, column, row);
  if (form != NULL && find_tile_side(t, form, column, row, s->side, out) &&
      gjk2_equal(following ? out->from : out->to, at) && are_in_line(s, out)) {
    return true;
  }
  return find_neighbour_side(t, s, following, true, out) && are_in_line(s, out);
}

static bool is_in_cells(const gjk2_ground_cells *c, const tile_side *s) {
  return s->column >= c->first_column && s->column <= c->last_column && s->row >= c->first_row && s->row <= c->last_row;
}

// A run has at most so many sides: each is at least a quarter of a tile long, along x or along y.
#define RUN_SIDES (QUARTERS * GJK2_TILE_RUN)

// Have two tiles the same sides? NULL is an empty one.
static bool are_alike(const gjk2_tile *form, const gjk2_tile *other) {
  return form == other ||
         (form != NULL && other != NULL && is_full(form) && is_full(other) && ((form->turns ^ other->turns) & 3u) == 0);
}

// Takes a side along its run as long as it covers whole tiles that are alike, and next to alike ones: find_in_run would find the
// same, one step on.
static void pass_alike(const gjk2_tiles *t, tile_side *s, bool following) {
  const gjk2_tile *form = form_of(t, s->column, s->row), *other = NULL;
  const gjk2_vec way = way_of_side(s);
  const int32_t step = following ? 1 : -1, x = way.x / QUARTERS * step, y = way.y / QUARTERS * step;
  unsigned square = 0;
  if (x == 0 ? way.x != 0 || y == 0 : way.y != 0) {
    return;  // part of a tile, or a slope
  }
  const bool bounds = square_of(form, s->side, &square);
  const int32_t across = square == 1 ? 1 : square == 3 ? -1 : 0, above = square == 2 ? 1 : square == 0 ? -1 : 0;
  if (bounds) {
    other = form_of(t, s->column + across, s->row + above);
  }
  // At most GJK2_TILE_RUN steps: each whole tile ends at one of their multiples, or before.
  while (!is_run_cut(following ? s->to : s->from, way) && are_alike(form_of(t, s->column + x, s->row + y), form) &&
         (!bounds || are_alike(form_of(t, s->column + x + across, s->row + y + above), other))) {
    const gjk2_vec tile = {x * QUARTERS, y * QUARTERS};
    s->column += x;
    s->row += y;
    s->from = gjk2_add(s->from, tile);
    s->to = gjk2_add(s->to, tile);
  }
}

// Takes a side to the end of its run, or to its beginning.
static void end_of_run(const gjk2_tiles *t, tile_side *s, bool following) {
  tile_side next;
  for (unsigned i = 0; i < RUN_SIDES; i++) {
    pass_alike(t, s, following);
    if (!find_in_run(t, s, following, &next)) {
      return;
    }
    copy_side(s, &next);
  }
}

// Step 2: the run of a side, from its first to its last. False: the walk has met it before.
static bool find_run(const gjk2_ground_walk *walk, const tile_side *s, tile_side *first, tile_side *last) {
  const gjk2_tiles *t = tiles_of(walk);
  if (find_in_run(t, s, false, first)) {
    if (is_in_cells(&walk->cells, first)) {
      return false;
    }
    end_of_run(t, first, false);
  } else {
    copy_side(first, s);
  }
  copy_side(last, s);
  end_of_run(t, last, true);
  return true;
}

static gjk2_vec corner_of(const gjk2_tiles *t, gjk2_vec v) {
  const int32_t quarter = t->size / QUARTERS;
  const gjk2_vec at = {v.x * quarter, v.y * quarter};
  return at;
}

// Is a side along an axis beside the box? Then so is its run, whose ends have the same coordinate across.
static bool is_beside_box(const gjk2_ground_cells *c, const tile_side *s) {
  const gjk2_vec at = s->from, low = c->low, high = c->high;
  return (at.y == s->to.y && (at.y < low.y || at.y > high.y)) || (at.x == s->to.x && (at.x < low.x || at.x > high.x));
}

static void neighbours_of_tiles(const gjk2_ground_walk *walk, gjk2_ground_edge *edge) {
  const gjk2_tiles *t = tiles_of(walk);
  tile_side run, neighbour;
  run.from = walk->cells.from;
  run.to = walk->cells.to;
  edge->open_before = !find_neighbour_side(t, &run, false, false, &neighbour);
  if (!edge->open_before) {
    edge->vertex[0] = corner_of(t, neighbour.from);
  }
  edge->open_after = !find_neighbour_side(t, &run, true, false, &neighbour);
  if (!edge->open_after) {
    edge->vertex[3] = corner_of(t, neighbour.to);
  }
}

// The quarters of a tile that a range of an axis holds, and the rows or columns that it meets; a tile's sides are its, too.
static void range_of(int32_t low, int32_t high, gjk_q16 size, int32_t count, int32_t *first, int32_t *last,
                     int32_t *least, int32_t *most) {
  // Unsigned, which has less to do where no instruction divides.
  const uint32_t quarter = (uint32_t)size / QUARTERS;
  const uint32_t below = low <= 0 ? 0 : (uint32_t)(low - 1) / quarter, up_to = high < 0 ? 0 : (uint32_t)high / quarter;
  *least = low <= 0 ? 0 : (int32_t)below + 1;
  *most = high < 0 ? -1 : (int32_t)up_to;
  *first = (int32_t)(below / QUARTERS);
  *last = high < 0 ? -1 : (int32_t)(up_to / QUARTERS);
  *last = *last < count - 1 ? *last : count - 1;
}

static bool is_grid(const gjk2_tiles *t) {
  // No vertex is beyond 2^28 then, so quarters of a tile times its size fit.
  return t->cells != NULL && t->size >= QUARTERS && t->size % QUARTERS == 0 && t->size <= GJK2_TILE_SIZE_MAX &&
         gjk_mul32(t->columns, t->size) <= GJK2_GROUND_REACH && gjk_mul32(t->rows, t->size) <= GJK2_GROUND_REACH &&
         (t->forms != NULL || t->form_count == 0) && gjk_umul32(t->columns, t->rows) <= UINT32_C(1) << 28;
}

static void begin_tiles(gjk2_ground_walk *walk) {
  const gjk2_tiles *t = tiles_of(walk);
  gjk2_ground_cells *c = &walk->cells;
  c->first_row = 0;
  c->last_row = -1;
  c->first_column = 0;
  c->last_column = -1;
  if (is_grid(t)) {
    range_of(walk->near.lower.x, walk->near.upper.x, t->size, t->columns, &c->first_column, &c->last_column, &c->low.x,
             &c->high.x);
    range_of(walk->near.lower.y, walk->near.upper.y, t->size, t->rows, &c->first_row, &c->last_row, &c->low.y,
             &c->high.y);
  }
  c->column = c->first_column;
  c->row = c->first_column <= c->last_column ? c->first_row : c->last_row + 1;
  c->side = 0;
}

// Step 1. Takes the walk from a side to the next one, of a tile that has a form.
static void step_on(gjk2_ground_cells *c, bool leave_tile) {
  c->side = leave_tile ? SIDES : c->side + 1;
  if (c->side < SIDES) {
    return;
  }
  c->side = 0;
  c->column++;
  if (c->column > c->last_column) {
    c->column = c->first_column;
    c->row++;
  }
}

static bool next_of_tiles(gjk2_ground_walk *walk, gjk2_ground_edge *out) {
  const gjk2_tiles *t = tiles_of(walk);
  gjk2_ground_cells *c = &walk->cells;
  while (c->row <= c->last_row) {
    tile_side side, first, last;
    const int32_t column = c->column, row = c->row;
    const unsigned number = c->side;
    const gjk2_tile *form = form_of(t, column, row);
    step_on(c, form == NULL);
    if (form != NULL && find_tile_side(t, form, column, row, number, &side) && !is_beside_box(c, &side) &&
        find_run(walk, &side, &first, &last)) {
      out->vertex[1] = corner_of(t, first.from);
      out->vertex[2] = corner_of(t, last.to);
      if (gjk2_ground_meets(&walk->near, out->vertex[1], out->vertex[2])) {
        out->number = ((uint32_t)first.row * t->columns + (uint32_t)first.column) * SIDES + first.side;
        c->from = first.from;
        c->to = last.to;
        return true;
      }
    }
  }
  return false;
}

const gjk2_ground_class gjk2_ground_tiles = {
    .begin = begin_tiles, .next = next_of_tiles, .neighbours = neighbours_of_tiles};

gjk_status gjk2_ground_of_tiles(const gjk2_tiles *data, gjk2_ground *out, gjk2_shape *shape) {
  gjk2_aabb box;
  if (data == NULL || data->cells == NULL || data->forms == NULL || out == NULL || shape == NULL) {
    return GJK_ERROR_NULL;
  }
  if (data->columns == 0 || data->rows == 0 || data->form_count == 0) {
    return GJK_ERROR_EMPTY;
  }
  if (data->size < 1) {
    return GJK_ERROR_NEGATIVE;
  }
  if (!is_grid(data)) {
    return GJK_ERROR_SIZE;
  }
  box.lower.x = 0;
  box.lower.y = 0;
  box.upper.x = data->columns * data->size;  // at most 2^28, as is_grid has it
  box.upper.y = data->rows * data->size;
  return gjk2_ground_set(&gjk2_ground_tiles, data, &box, out, shape);
}
