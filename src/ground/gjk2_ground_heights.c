// Height profiles as ground.
#include "gjk2_ground_box.h"
#include "gjk2_ground_walk.h"

static const gjk2_heights *heights_of(const gjk2_ground_walk *walk) {
  return (const gjk2_heights *)walk->ground->data;
}

// Vertex i. False: there is none, or it is out of reach.
static bool vertex_of_column(const gjk2_heights *h, uint32_t i, gjk2_vec *out) {
  if (i >= h->count || h->heights[i] == GJK2_HOLE || h->shift > 13) {
    return false;
  }
  const int64_t x = gjk_mul32((int32_t)i, h->width);  // i < 2^16
  if (x > GJK2_GROUND_REACH || x < 0) {
    return false;
  }
  out->x = (int32_t)x;
  out->y = h->heights[i] * (INT32_C(1) << h->shift);  // at most 2^15 2^13
  return true;
}

// The column that a coordinate is in.
static uint32_t column_of(const gjk2_heights *h, int32_t x) {
  return x <= 0 ? 0 : (uint32_t)x / (uint32_t)h->width;
}

static void begin_heights(gjk2_ground_walk *walk) {
  const gjk2_heights *h = heights_of(walk);
  walk->at = walk->end = 0;
  if (h->count < 2 || h->width < 1 || h->heights == NULL || walk->near.upper.x < 0) {
    return;
  }
  const uint32_t first = column_of(h, walk->near.lower.x), last = column_of(h, walk->near.upper.x) + 1;
  // At a column's edge the box meets the segment before it, too.
  walk->at = first > 0 ? first - 1 : 0;
  walk->end = last < h->count - UINT32_C(1) ? last : h->count - UINT32_C(1);
}

static bool next_of_heights(gjk2_ground_walk *walk, gjk2_ground_edge *out) {
  const gjk2_heights *h = heights_of(walk);
  while (walk->at < walk->end) {
    const uint32_t i = walk->at++;
    gjk2_vec *p = &out->vertex[1], *q = &out->vertex[2];
    if (vertex_of_column(h, i + 1, p) && vertex_of_column(h, i, q) && gjk2_ground_meets(&walk->near, *p, *q)) {
      out->number = i;
      return true;
    }
  }
  return false;
}

static void neighbours_of_heights(const gjk2_ground_walk *walk, gjk2_ground_edge *edge) {
  const gjk2_heights *h = heights_of(walk);
  const uint32_t i = edge->number;
  edge->open_before = !vertex_of_column(h, i + 2, &edge->vertex[0]);
  edge->open_after = i == 0 || !vertex_of_column(h, i - 1, &edge->vertex[3]);
}

const gjk2_ground_class gjk2_ground_heights = {
    .begin = begin_heights, .next = next_of_heights, .neighbours = neighbours_of_heights};

gjk_status gjk2_ground_of_heights(const gjk2_heights *data, gjk2_ground *out, gjk2_shape *shape) {
  gjk2_aabb box;
  bool any = false;
  if (data == NULL || data->heights == NULL || out == NULL || shape == NULL) {
    return GJK_ERROR_NULL;
  }
  if (data->width < 1) {
    return GJK_ERROR_NEGATIVE;
  }
  if (data->shift > 13) {
    return GJK_ERROR_SIZE;
  }
  for (uint32_t i = 0; i < data->count; i++) {
    gjk2_vec v, next;
    if (data->heights[i] == GJK2_HOLE) {
      continue;
    }
    if (!vertex_of_column(data, i, &v) || !gjk2_ground_fits(v)) {
      return GJK_ERROR_SIZE;
    }
    if (vertex_of_column(data, i + 1, &next)) {
      gjk2_aabb at;
      if (!gjk2_ground_fits(next) || !gjk2_ground_fits_segment(v, next)) {
        return GJK_ERROR_SIZE;
      }
      at.lower.x = v.x;
      at.upper.x = next.x;
      at.lower.y = v.y < next.y ? v.y : next.y;
      at.upper.y = v.y < next.y ? next.y : v.y;
      box = any ? gjk2_aabb_hull(&box, &at) : at;
      any = true;
    }
  }
  return any ? gjk2_ground_set(&gjk2_ground_heights, data, &box, out, shape) : GJK_ERROR_EMPTY;
}
