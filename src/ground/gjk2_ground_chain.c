// Chains as ground, and their index.
//
// A box of level k of the index holds 4^(k + 1) segments. The walk goes through the segments in order; where a run of them
// begins whose box is not near, it skips the run. So it needs no stack, and looks at few boxes beside those of near segments.
#include "../arith/gjk_memory.h"
#include "gjk2_ground_box.h"
#include "gjk2_ground_walk.h"

static const gjk2_polyline *chain_of(const gjk2_ground_walk *walk) {
  return (const gjk2_polyline *)walk->ground->data;
}

static uint32_t quarter(uint32_t n) {
  return (n + 3) / 4;
}

// Where each level begins; returns the number of boxes. segments >= 1
static uint32_t levels_of(uint32_t segments, uint16_t level[GJK2_INDEX_LEVELS]) {
  uint32_t boxes = 0, n = segments;
  for (unsigned k = 0; k < GJK2_INDEX_LEVELS; k++) {
    n = quarter(n);
    level[k] = (uint16_t)boxes;
    boxes += n;  // 16384 + 4096 + ... < 21853
  }
  return boxes;
}

static void begin_chain(gjk2_ground_walk *walk) {
  const gjk2_polyline *chain = chain_of(walk);
  walk->at = 0;
  walk->end = chain->vertices != NULL && chain->count > 0 ? chain->count - UINT32_C(1) : 0;
  if (walk->end > 0) {
    walk->closed = gjk2_equal(chain->vertices[0], chain->vertices[walk->end]);
    (void)levels_of(walk->end, walk->level);
  }
}

// Is a range from low to high, in LSB from the index's corner, beyond that of a box, in its units?
static bool is_range_beside(int32_t low, int32_t high, int32_t corner, unsigned shift, uint16_t lower, uint16_t upper) {
  // low and high are below 2^30.5 in size, the corner at most 2^28. 16 bits and a shift of at most 14 stay below 2^30.
  return high - corner < (int32_t)((uint32_t)lower << shift) || low - corner > (int32_t)((uint32_t)upper << shift);
}

static bool is_box_beside(const gjk2_ground_walk *walk, const gjk2_index *index, const gjk2_index_box *box) {
  const gjk2_vec low = walk->near.lower, high = walk->near.upper;
  return is_range_beside(low.x, high.x, index->corner.x, index->shift, box->lower_x, box->upper_x) ||
         is_range_beside(low.y, high.y, index->corner.y, index->shift, box->lower_y, box->upper_y);
}

// Skips the longest run that begins here and is not near. False: there is none.
static bool skip_run(gjk2_ground_walk *walk, const gjk2_index *index) {
  int k = 0;
  while (k + 1 < GJK2_INDEX_LEVELS && (walk->at & ((UINT32_C(1) << 2 * (k + 2)) - 1)) == 0) {
    k++;
  }
  for (; k >= 0; k--) {
    const uint32_t run = walk->at >> 2 * (k + 1);
    if (is_box_beside(walk, index, &index->boxes[walk->level[k] + run])) {
      walk->at = (run + 1) << 2 * (k + 1);
      return true;
    }
  }
  return false;
}

// The vertex before segment i, or after it, that is not its own. False: there is none.
static bool find_vertex(const gjk2_ground_walk *walk, uint32_t i, bool following, gjk2_vec *out) {
  const gjk2_vec *v = chain_of(walk)->vertices, *own = &v[following ? i + 1 : i];
  for (uint32_t k = 1; k < walk->end; k++) {  // once round
    if (!walk->closed && (following ? i + 1 >= walk->end : i == 0)) {
      return false;
    }
    i = following ? (i + 1 < walk->end ? i + 1 : 0) : (i > 0 ? i : walk->end) - 1;
    gjk2_copy(out, &v[following ? i + 1 : i]);
    if (!gjk2_equal(*out, *own)) {
      return true;
    }
  }
  return false;
}

// An index that was made for another chain is not used. What its boxes hold, gjk2_ground_of_chain checks.
static bool is_of_chain(const gjk2_index *index, uint32_t segments) {
  uint16_t level[GJK2_INDEX_LEVELS];
  return index->boxes != NULL && index->segments == segments && index->count == levels_of(segments, level) &&
         index->shift <= 14 && gjk2_ground_fits(index->corner);
}

static bool next_of_chain(gjk2_ground_walk *walk, gjk2_ground_edge *out) {
  const gjk2_polyline *chain = chain_of(walk);
  const gjk2_index *index = chain->index;
  const bool indexed = walk->end > 0 && index != NULL && is_of_chain(index, walk->end);
  while (walk->at < walk->end) {
    if (indexed && walk->at % 4 == 0 && skip_run(walk, index)) {
      continue;
    }
    const uint32_t i = walk->at++;
    const gjk2_vec p = chain->vertices[i], q = chain->vertices[i + 1];
    if (gjk2_ground_meets(&walk->near, p, q) && !gjk2_equal(p, q)) {
      out->number = i;
      gjk2_copy(&out->vertex[1], &p);
      gjk2_copy(&out->vertex[2], &q);
      return true;
    }
  }
  return false;
}

static void neighbours_of_chain(const gjk2_ground_walk *walk, gjk2_ground_edge *edge) {
  edge->open_before = !find_vertex(walk, edge->number, false, &edge->vertex[0]);
  edge->open_after = !find_vertex(walk, edge->number, true, &edge->vertex[3]);
}

const gjk2_ground_class gjk2_ground_chain = {
    .begin = begin_chain, .next = next_of_chain, .neighbours = neighbours_of_chain};

static void extend(gjk2_aabb *box, gjk2_vec v) {
  const gjk2_aabb at = {v, v};
  *box = gjk2_aabb_hull(box, &at);
}

// Checks all but the index. Sets the box of all vertices.
static gjk_status check_chain(const gjk2_polyline *chain, gjk2_aabb *box) {
  if (chain == NULL || chain->vertices == NULL) {
    return GJK_ERROR_NULL;
  }
  if (chain->count == 0) {
    return GJK_ERROR_EMPTY;
  }
  for (uint32_t i = 0; i < chain->count; i++) {
    const gjk2_vec v = chain->vertices[i];
    if (!gjk2_ground_fits(v) || (i > 0 && !gjk2_ground_fits_segment(chain->vertices[i - 1], v))) {
      return GJK_ERROR_SIZE;
    }
    if (i == 0) {
      gjk2_copy(&box->lower, &v);
      gjk2_copy(&box->upper, &v);
    }
    extend(box, v);
  }
  return gjk2_equal(box->lower, box->upper) ? GJK_ERROR_EMPTY : GJK_OK;
}

static uint16_t lower_unit(int32_t x, int32_t corner, unsigned shift) {
  return (uint16_t)((uint32_t)(x - corner) >> shift);
}

static uint16_t upper_unit(int32_t x, int32_t corner, unsigned shift) {
  return (uint16_t)(((uint32_t)(x - corner) + (UINT32_C(1) << shift) - 1) >> shift);
}

// The box of a run of segments, in units of the index.
static void box_of_run(const gjk2_polyline *chain, const gjk2_index *index, uint32_t first, uint32_t count,
                       gjk2_index_box *out) {
  const uint32_t segments = chain->count - UINT32_C(1);
  gjk2_aabb box;
  gjk2_copy(&box.lower, &chain->vertices[first]);
  gjk2_copy(&box.upper, &chain->vertices[first]);
  for (uint32_t i = first; i < segments && i < first + count; i++) {
    extend(&box, chain->vertices[i + 1]);
  }
  out->lower_x = lower_unit(box.lower.x, index->corner.x, index->shift);
  out->lower_y = lower_unit(box.lower.y, index->corner.y, index->shift);
  out->upper_x = upper_unit(box.upper.x, index->corner.x, index->shift);
  out->upper_y = upper_unit(box.upper.y, index->corner.y, index->shift);
}

// The corner and shift of an index, so that all units fit 16 bits: 65535 units hold the longer side.
static void set_units(const gjk2_aabb *box, gjk2_index *index) {
  const uint32_t x = (uint32_t)(box->upper.x - box->lower.x), y = (uint32_t)(box->upper.y - box->lower.y);
  const uint32_t longer = x > y ? x : y;  // <= 2^29
  gjk2_copy(&index->corner, &box->lower);
  index->shift = 0;
  while (longer >> index->shift >= UINT16_MAX) {  // at most 14 times
    index->shift++;
  }
}

gjk_status gjk2_index_build(const gjk2_polyline *chain, gjk2_index_box *boxes, uint16_t capacity, gjk2_index *out) {
  gjk2_aabb box;
  uint16_t level[GJK2_INDEX_LEVELS];
  gjk_status status = boxes == NULL || out == NULL ? GJK_ERROR_NULL : check_chain(chain, &box);
  if (status != GJK_OK) {
    return status;
  }
  const uint32_t segments = chain->count - UINT32_C(1), count = levels_of(segments, level);
  if (capacity < count) {
    return GJK_ERROR_CAPACITY;
  }
  gjk2_index index;
  index.boxes = boxes;
  index.count = (uint16_t)count;
  index.segments = (uint16_t)segments;
  set_units(&box, &index);
  for (unsigned k = 0; k < GJK2_INDEX_LEVELS; k++) {
    const uint32_t run = UINT32_C(4) << 2 * k;
    uint16_t i = level[k];
    for (uint32_t first = 0; first < segments; first += run) {
      box_of_run(chain, &index, first, run, &boxes[i++]);
    }
  }
  gjk_copy(out, &index, sizeof *out);
  return GJK_OK;
}

// Does an index hold each segment? A box may be larger than its run needs.
static gjk_status check_index(const gjk2_polyline *chain, const gjk2_index *index, const gjk2_aabb *box) {
  const uint32_t segments = chain->count - UINT32_C(1);
  if (!is_of_chain(index, segments) || !gjk2_equal(index->corner, box->lower)) {
    return GJK_ERROR_CORRUPT;
  }
  uint16_t level[GJK2_INDEX_LEVELS];
  (void)levels_of(segments, level);
  for (unsigned k = 0; k < GJK2_INDEX_LEVELS; k++) {
    const uint32_t run = UINT32_C(4) << 2 * k;
    uint16_t i = level[k];
    for (uint32_t first = 0; first < segments; first += run) {
      const gjk2_index_box *b = &index->boxes[i++];
      gjk2_index_box needed;
      box_of_run(chain, index, first, run, &needed);
      if (b->lower_x > needed.lower_x || b->lower_y > needed.lower_y || b->upper_x < needed.upper_x ||
          b->upper_y < needed.upper_y) {
        return GJK_ERROR_CORRUPT;
      }
    }
  }
  return GJK_OK;
}

gjk_status gjk2_ground_of_chain(const gjk2_polyline *data, gjk2_ground *out, gjk2_shape *shape) {
  gjk2_aabb box;
  gjk_status status = out == NULL || shape == NULL ? GJK_ERROR_NULL : check_chain(data, &box);
  if (status == GJK_OK && data->index != NULL) {
    status = check_index(data, data->index, &box);
  }
  return status == GJK_OK ? gjk2_ground_set(&gjk2_ground_chain, data, &box, out, shape) : status;
}
