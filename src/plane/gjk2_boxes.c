// The nearest edge of A - B of two boxes, by their four half axes; on processors whose registers hold 64 bits.
//
//   1. Across each half axis v lie two edges of A - B: their height above the origin, times |v|, is the sum R of the half axes
//      across v, and the centre's offset along that normal more or less. The lower one counts.
//   2. A height below 0 proves that the boxes are apart.
//   3. Half axes that are parallel make one edge of both: heights and half axes add up.
//   4. Keep the lowest, by the leading bits of height^2 / |v|^2. Equal ones, or nearly so, are left to the walk over all
//      edges (gjk2_edges.h).
//   |v| < 2^28, |delta| <= 2^30:  products below 2^58 in size, R below 2^59, of two half axes below 2^60
#include "gjk2_boxes.h"

#if GJK_64_BIT && !GJK_SMALL

// One of the half axes: A's, then B's; or two that are parallel. Turned so that its edge is the lower one.
typedef struct box_axis {
  int64_t x, y;
  int64_t height;  // the edge's, times |v|
  bool of[4];      // which half axes it is made of
} box_axis;

static inline int64_t cross64(int64_t px, int64_t py, int64_t qx, int64_t qy) {
  return px * qy - py * qx;
}

static inline int64_t size64(int64_t x) {
  return x < 0 ? -x : x;
}

// A number that grows with height^2 / |v|^2: exponent, then 31 bits of the fraction, off by less than 8.
static int64_t height_key(const box_axis *axis) {
  if (axis->height == 0) {
    return 0;
  }
  const uint64_t h = (uint64_t)axis->height, s = (uint64_t)(axis->x * axis->x + axis->y * axis->y);
  const unsigned hz = gjk_clz64(h), sz = gjk_clz64(s);
  const uint64_t top = gjk_upper32(h, hz), bottom = gjk_upper32(s, sz);
  const uint64_t quotient = top * top / bottom;  // from 2^30 to 2^33
  const unsigned qz = gjk_clz64(quotient);
  const int64_t exponent = 256 + (int64_t)sz - 2 * (int64_t)hz - (int64_t)qz;  // above 0
  return exponent * (INT64_C(1) << 31) + (int64_t)(gjk_upper32(quotient, qz) & INT32_MAX);
}

#define KEY_SLACK 16

// The ends of the edge: every other half axis leads as far as it can across v; v's own from one end to the other.
static void set_ends(const gjk2_search *s, const box_axis *v, gjk2_edge *edge) {
  const gjk2_vec *half[4] = {&s->a->frame[0], &s->a->frame[1], &s->b->frame[0], &s->b->frame[1]};
  int64_t at[2][2] = {{0, 0}, {0, 0}}, way[2][2] = {{0, 0}, {0, 0}};  // of A, of -B
  unsigned number[2] = {0, 0}, other[2] = {0, 0};
  for (unsigned i = 0; i < 4; i++) {
    const unsigned shape = i >> 1, bit = 1u << (i & 1u);
    const int64_t x = half[i]->x, y = half[i]->y;
    // How far it leads outwards, across v; its own: how far against v.
    const bool own = v->of[i];
    const bool plus = own ? x * v->x + y * v->y < 0 : cross64(x, y, v->x, v->y) > 0;
    at[shape][0] += plus ? x : -x;
    at[shape][1] += plus ? y : -y;
    // A vertex of -B is that of B with the other signs.
    number[shape] |= plus == (shape == 0) ? bit : 0;
    other[shape] |= (plus != own) == (shape == 0) ? bit : 0;
    way[shape][0] += !own ? 0 : plus ? -2 * x : 2 * x;
    way[shape][1] += !own ? 0 : plus ? -2 * y : 2 * y;
  }
  gjk2_vertex *p = &edge->p, *q = &edge->q;
  p->a.offset.x = (int32_t)at[0][0];
  p->a.offset.y = (int32_t)at[0][1];
  p->b.offset.x = (int32_t)-at[1][0];
  p->b.offset.y = (int32_t)-at[1][1];
  p->a.vertex = (uint16_t)number[0];
  p->b.vertex = (uint16_t)number[1];
  p->w.x = s->delta.x + (int32_t)(at[0][0] + at[1][0]);
  p->w.y = s->delta.y + (int32_t)(at[0][1] + at[1][1]);
  q->a.offset.x = (int32_t)(at[0][0] + way[0][0]);
  q->a.offset.y = (int32_t)(at[0][1] + way[0][1]);
  q->b.offset.x = (int32_t) - (at[1][0] + way[1][0]);
  q->b.offset.y = (int32_t) - (at[1][1] + way[1][1]);
  q->a.vertex = (uint16_t)other[0];
  q->b.vertex = (uint16_t)other[1];
  q->w.x = p->w.x + (int32_t)(way[0][0] + way[1][0]);
  q->w.y = p->w.y + (int32_t)(way[0][1] + way[1][1]);
}

// Step 3: the half axes i of A and j of B, which are parallel.
static void join(box_axis axis[4], unsigned i, unsigned j) {
  axis[i].x += axis[j].x;
  axis[i].y += axis[j].y;
  axis[i].height += axis[j].height;
  axis[i].of[j] = true;
  axis[j].height = -1;  // it is no edge of its own
}

// Are both shapes boxes with area?
static inline bool are_boxes(const gjk2_collider *a, const gjk2_collider *b) {
  return a->count == 4 && b->count == 4 && a->ordered && b->ordered && !a->shape->type->buffered &&
         !b->shape->type->buffered;
}

gjk2_lie gjk2_boxes_edge(gjk2_search *s, gjk2_edge *edge) {
  if (!are_boxes(s->a, s->b)) {
    return GJK2_LIE_OPEN;
  }
  const gjk2_vec *a = s->a->frame, *b = s->b->frame;
  box_axis axis[4] = {{a[0].x, a[0].y, 0, {true, false, false, false}},
                      {a[1].x, a[1].y, 0, {false, true, false, false}},
                      {b[0].x, b[0].y, 0, {false, false, true, false}},
                      {b[1].x, b[1].y, 0, {false, false, false, true}}};
  const int64_t of_a = cross64(axis[0].x, axis[0].y, axis[1].x, axis[1].y);
  const int64_t of_b = cross64(axis[2].x, axis[2].y, axis[3].x, axis[3].y);
  int64_t turn[2][2];
  for (unsigned i = 0; i < 2; i++) {
    for (unsigned j = 0; j < 2; j++) {
      turn[i][j] = size64(cross64(axis[i].x, axis[i].y, axis[2 + j].x, axis[2 + j].y));
    }
  }
  const int64_t across[4] = {of_a + turn[0][0] + turn[0][1], of_a + turn[1][0] + turn[1][1],
                             of_b + turn[0][0] + turn[1][0], of_b + turn[0][1] + turn[1][1]};
  for (unsigned i = 0; i < 4; i++) {  // Step 1
    const int64_t offset = cross64(s->delta.x, s->delta.y, axis[i].x, axis[i].y);
    if (offset == 0) {  // both edges are as low
      return GJK2_LIE_OPEN;
    }
    if (offset > 0) {
      axis[i].x = -axis[i].x;
      axis[i].y = -axis[i].y;
    }
    axis[i].height = across[i] - size64(offset);
    if (axis[i].height < 0) {  // Step 2
      s->d.x = (int32_t)(2 * axis[i].y);
      s->d.y = (int32_t)(-2 * axis[i].x);
      s->along = 2 * axis[i].height;
      return GJK2_LIE_APART;
    }
  }
  for (unsigned i = 0; i < 2; i++) {
    for (unsigned j = 0; j < 2; j++) {
      if (turn[i][j] == 0) {
        join(axis, i, 2 + j);
      }
    }
  }
  const box_axis *lowest = &axis[0];
  int64_t least = height_key(lowest), second = INT64_MAX;
  for (unsigned i = 1; i < 4; i++) {  // Step 4
    if (axis[i].height < 0) {
      continue;
    }
    const int64_t key = height_key(&axis[i]);
    if (key < least) {
      second = least;
      least = key;
      lowest = &axis[i];
    } else if (key < second) {
      second = key;
    }
  }
  if (second - least < KEY_SLACK) {
    return GJK2_LIE_OPEN;
  }
  set_ends(s, lowest, edge);
  edge->height = 2 * lowest->height;
  gjk2_length_set(&edge->length, gjk2_sub(edge->q.w, edge->p.w));
  return GJK2_LIE_OVERLAP;
}

#else

gjk2_lie gjk2_boxes_edge(gjk2_search *s, gjk2_edge *edge) {
  (void)s, (void)edge;
  return GJK2_LIE_OPEN;
}

#endif
