// The search for the facet of A - B nearest to the origin, for pairs of any kind.
#ifndef GJK_SRC_EXPAND_H
#define GJK_SRC_EXPAND_H

#include "facet.h"
#include "gjk/penetration.h"

typedef enum gjk_expansion {
  GJK_EXPANSION_FACET,    // found; exact, or for curved shapes nearly
  GJK_EXPANSION_TOUCHES,  // the origin lies on a plane across it->direction that nothing lies beyond; the simplex is the
                          // feature that holds the origin
  GJK_EXPANSION_FULL      // too few cells; facet bounds the depth from above, *lower from below
} gjk_expansion;

// Pre: the origin lies in the simplex. facet: not found yet. rounds: counts support scans.
gjk_expansion gjk_expand(gjk_iteration *it, const gjk_workspace *workspace, gjk_facet *facet, gjk_q16 *lower,
                         uint16_t *rounds);

#endif
