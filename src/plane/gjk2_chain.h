// What the queries on chains share: the segments of a range that come near a body, as colliders.
#ifndef GJK2_SRC_CHAIN_H
#define GJK2_SRC_CHAIN_H

#include "gjk2/chain.h"
#include "gjk2_class.h"

// A walk over the segments of a range.
typedef struct gjk2_chain_walk {
  const gjk2_chain *chain;
  gjk2_vec lower, upper;  // segments whose box does not meet this one are left out; chain frame
  uint32_t next, end;
} gjk2_chain_walk;

// GJK_ERROR_NULL of the chain or the body, UNINITIALISED, RANGE of the range, or GJK_OK.
gjk_status gjk2_chain_check(const gjk2_chain *chain, const gjk2_collider *body, const gjk2_chain_range *range);

// Starts a walk over the segments whose box is at most margin from the body's along both axes. Pre: checked.
void gjk2_chain_start(gjk2_chain_walk *walk, const gjk2_chain *chain, const gjk2_aabb *box,
                      const gjk2_chain_range *range, gjk_q16 margin);

// The next segment with a length. False: there is none.
bool gjk2_chain_next(gjk2_chain_walk *walk, uint16_t *segment);

// A vertex in the world. Pre: the chain is initialised, so it fits.
static inline gjk2_vec gjk2_chain_vertex(const gjk2_chain *chain, uint32_t i) {
  return gjk2_add(chain->vertices[i], chain->position);
}

#endif
