// The contacts of a body with a chain: those of each segment whose box meets the body's, by margin.
#include "gjk2_chain.h"
#include "gjk2_line.h"

// The segment with a length that comes before segment i, or after it. False: there is none.
static bool find_neighbour(const gjk2_chain *chain, uint32_t i, bool following, gjk2_vec *segment) {
  const uint32_t segments = chain->count - UINT32_C(1);
  for (uint32_t k = 1; k < segments; k++) {  // once round
    if (!chain->closed && (following ? i + 1 >= segments : i == 0)) {
      return false;
    }
    i = following ? (i + 1 < segments ? i + 1 : 0) : (i > 0 ? i : segments) - 1;
    *segment = gjk2_sub(chain->vertices[i + 1], chain->vertices[i]);
    if ((segment->x | segment->y) != 0) {
      return true;
    }
  }
  return false;
}

static void line_of_chain(const gjk2_chain *chain, uint16_t number, gjk2_line *out) {
  out->number = number;
  out->p = gjk2_chain_vertex(chain, number);
  out->q = gjk2_chain_vertex(chain, number + UINT32_C(1));
  out->open_before = !find_neighbour(chain, number, false, &out->before);
  out->open_after = !find_neighbour(chain, number, true, &out->after);
}

gjk_status gjk2_chain_contacts(const gjk2_chain *chain, const gjk2_collider *body, const gjk2_chain_range *range,
                               gjk_q16 margin, gjk2_chain_contact *out, uint16_t capacity, uint16_t *count) {
  gjk_status status = out == NULL || count == NULL ? GJK_ERROR_NULL : gjk2_chain_check(chain, body, range);
  if (status != GJK_OK || margin < 0 || margin > GJK2_RADIUS_MAX) {
    return status != GJK_OK ? status : margin < 0 ? GJK_ERROR_NEGATIVE : GJK_ERROR_RANGE;
  }
  gjk2_line_list found = {out, capacity, 0, false};
  gjk2_line_query query;
  gjk2_chain_walk walk;
  gjk2_aabb box;
  (void)gjk2_collider_aabb(body, &box);
  gjk2_line_query_set(&query, body, &box, margin);
  query.take = gjk2_line_list_take;
  query.user = &found;
  gjk2_chain_start(&walk, chain, &box, range, margin);
  uint16_t number;
  while (status == GJK_OK && gjk2_chain_next(&walk, &number)) {
    gjk2_line line;
    line_of_chain(chain, number, &line);
    status = gjk2_line_contacts(&query, &line);
  }
  if (status == GJK_OK) {
    *count = found.count;
    status = found.overflows ? GJK_ERROR_CAPACITY : GJK_OK;
  }
  return status;
}
