// Chains: checking and placing them, their segments as colliders, and the queries that ask each segment.
#include "gjk2_chain.h"

#include "../arith/gjk_memory.h"
#include "gjk2/intersect.h"
#include "gjk2_line.h"

// The state of a chain. Other values are those of memory that was never initialised.
#define CHAIN_STATE UINT16_C(0x3269)

GJK_ONE_COPY static bool fits_placed(int32_t low, int32_t high, int32_t by) {
  return (int64_t)low + by >= INT32_MIN && (int64_t)high + by <= INT32_MAX;
}

static bool is_placeable(gjk2_vec lower, gjk2_vec upper, const gjk2_vec *position) {
  return fits_placed(lower.x, upper.x, position->x) && fits_placed(lower.y, upper.y, position->y);
}

// Is the distance of two coordinates within GJK2_RADIUS_MAX?
GJK_ONE_COPY static bool is_short(int32_t a, int32_t b) {
  const int64_t length = (int64_t)a - b;
  return length <= GJK2_RADIUS_MAX && length >= -GJK2_RADIUS_MAX;
}

gjk_status gjk2_chain_init(gjk2_chain *chain, const gjk2_vec *vertices, uint16_t count, const gjk2_vec *position) {
  if (chain == NULL || vertices == NULL || position == NULL) {
    return GJK_ERROR_NULL;
  }
  if (count == 0) {
    return GJK_ERROR_EMPTY;
  }
  gjk2_vec low = vertices[0], high = vertices[0];
  for (uint32_t i = 1; i < count; i++) {
    const gjk2_vec v = vertices[i];
    if (!is_short(v.x, vertices[i - 1].x) || !is_short(v.y, vertices[i - 1].y)) {
      return GJK_ERROR_SIZE;
    }
    low.x = v.x < low.x ? v.x : low.x;
    low.y = v.y < low.y ? v.y : low.y;
    high.x = v.x > high.x ? v.x : high.x;
    high.y = v.y > high.y ? v.y : high.y;
  }
  if (gjk2_equal(low, high)) {
    return GJK_ERROR_EMPTY;
  }
  if (!is_placeable(low, high, position)) {
    return GJK_ERROR_RANGE;
  }
  chain->vertices = vertices;
  gjk2_copy(&chain->position, position);
  gjk2_copy(&chain->lower, &low);
  gjk2_copy(&chain->upper, &high);
  chain->count = count;
  chain->closed = gjk2_equal(vertices[0], vertices[count - 1]);
  chain->state = CHAIN_STATE;
  return GJK_OK;
}

gjk_status gjk2_chain_move(gjk2_chain *chain, const gjk2_vec *position) {
  if (chain == NULL || position == NULL) {
    return GJK_ERROR_NULL;
  }
  if (chain->state != CHAIN_STATE) {
    return GJK_ERROR_UNINITIALISED;
  }
  if (!is_placeable(chain->lower, chain->upper, position)) {
    return GJK_ERROR_RANGE;
  }
  gjk2_copy(&chain->position, position);
  return GJK_OK;
}

gjk_status gjk2_chain_check(const gjk2_chain *chain, const gjk2_collider *body, const gjk2_chain_range *range) {
  if (chain == NULL || body == NULL) {
    return GJK_ERROR_NULL;
  }
  if (chain->state != CHAIN_STATE || body->state != GJK2_STATE_POSED) {
    return GJK_ERROR_UNINITIALISED;
  }
  return range != NULL && (uint32_t)range->first + range->count >= chain->count ? GJK_ERROR_RANGE : GJK_OK;
}

// Limits one axis of the walk's box. Returns whether it meets that of the chain, from low to high. Then saturation
// changes no comparison with a vertex.
static bool limit_axis(int64_t from, int64_t to, int32_t low, int32_t high, int32_t *out_from, int32_t *out_to) {
  *out_from = gjk_saturate(from);
  *out_to = gjk_saturate(to);
  return from <= high && to >= low;
}

void gjk2_chain_start(gjk2_chain_walk *walk, const gjk2_chain *chain, const gjk2_aabb *box,
                      const gjk2_chain_range *range, gjk_q16 margin) {
  const gjk2_vec *at = &chain->position;
  const bool meets_x = limit_axis((int64_t)box->lower.x - margin - at->x, (int64_t)box->upper.x + margin - at->x,
                                  chain->lower.x, chain->upper.x, &walk->lower.x, &walk->upper.x);
  const bool meets_y = limit_axis((int64_t)box->lower.y - margin - at->y, (int64_t)box->upper.y + margin - at->y,
                                  chain->lower.y, chain->upper.y, &walk->lower.y, &walk->upper.y);
  walk->chain = chain;
  walk->next = range != NULL ? range->first : 0;
  walk->end = range != NULL ? walk->next + range->count : chain->count - UINT32_C(1);
  if (!meets_x || !meets_y) {
    walk->end = walk->next;
  }
}

bool gjk2_chain_next(gjk2_chain_walk *walk, uint16_t *segment) {
  const gjk2_vec low = walk->lower, high = walk->upper;
  while (walk->next < walk->end) {
    const gjk2_vec *p = &walk->chain->vertices[walk->next++], *q = p + 1;
    // Both ends beyond one side of the box.
    if ((p->x > high.x && q->x > high.x) || (p->x < low.x && q->x < low.x) || (p->y > high.y && q->y > high.y) ||
        (p->y < low.y && q->y < low.y) || gjk2_equal(*p, *q)) {
      continue;
    }
    *segment = (uint16_t)(walk->next - 1);
    return true;
  }
  return false;
}

static void collider_of(const gjk2_chain *chain, uint16_t segment, gjk2_collider *out) {
  gjk2_line_collider(gjk2_chain_vertex(chain, segment), gjk2_chain_vertex(chain, segment + UINT32_C(1)), out);
}

gjk_status gjk2_chain_intersect(const gjk2_chain *chain, const gjk2_collider *body, const gjk2_chain_range *range,
                                bool *yes, uint16_t *segment) {
  gjk_status status = yes == NULL || segment == NULL ? GJK_ERROR_NULL : gjk2_chain_check(chain, body, range);
  if (status != GJK_OK) {
    return status;
  }
  gjk2_chain_walk walk;
  gjk2_decision decision;
  uint16_t i = 0;
  gjk2_aabb box;
  decision.yes = false;
  (void)gjk2_collider_aabb(body, &box);
  gjk2_chain_start(&walk, chain, &box, range, 0);
  while (!decision.yes && gjk2_chain_next(&walk, &i)) {
    gjk2_collider line;
    collider_of(chain, i, &line);
    status = gjk2_intersect(&line, body, NULL, &decision);
    if (status != GJK_OK) {
      return status;
    }
  }
  *yes = decision.yes;
  if (decision.yes) {
    *segment = i;
  }
  return GJK_OK;
}

// How far the range from p to q is from the one from low to high; at most 0 where they meet.
GJK_ONE_COPY static int64_t axis_gap(int64_t p, int64_t q, int64_t low, int64_t high) {
  const int64_t below = low - (p > q ? p : q), above = (p < q ? p : q) - high;
  return below > above ? below : above;
}

gjk_status gjk2_chain_distance(const gjk2_chain *chain, const gjk2_collider *body, const gjk2_chain_range *range,
                               gjk2_distance_result *out, uint16_t *segment) {
  gjk_status status = out == NULL || segment == NULL ? GJK_ERROR_NULL : gjk2_chain_check(chain, body, range);
  if (status != GJK_OK) {
    return status;
  }
  const uint32_t first = range != NULL ? range->first : 0;
  const uint32_t end = range != NULL ? first + range->count : chain->count - UINT32_C(1);
  gjk2_aabb box;
  gjk2_distance_result best, found;
  bool any = false;
  uint16_t nearest = 0;
  (void)gjk2_collider_aabb(body, &box);
  for (uint32_t i = first; i < end && !(any && best.intersecting); i++) {
    const gjk2_vec p = gjk2_chain_vertex(chain, i), q = gjk2_chain_vertex(chain, i + 1);
    const int64_t x = axis_gap(p.x, q.x, box.lower.x, box.upper.x), y = axis_gap(p.y, q.y, box.lower.y, box.upper.y);
    if (gjk2_equal(p, q) || (any && (x > best.distance || y > best.distance))) {
      continue;
    }
    gjk2_collider line;
    gjk2_line_collider(p, q, &line);
    status = gjk2_distance(&line, body, NULL, &found);
    if (status != GJK_OK) {
      return status;
    }
    if (!any || found.distance < best.distance || found.intersecting) {
      gjk_copy(&best, &found, sizeof best);
      nearest = (uint16_t)i;
    }
    any = true;
  }
  if (!any) {
    return GJK_ERROR_EMPTY;
  }
  gjk_copy(out, &best, sizeof best);
  *segment = nearest;
  return GJK_OK;
}
