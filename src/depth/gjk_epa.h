// The search for the facet of A - B nearest to the origin, for pairs of any kind.
#ifndef GJK_SRC_EPA_H
#define GJK_SRC_EPA_H

#include "gjk/penetration.h"
#include "gjk_facet.h"

typedef enum gjk_epa_outcome {
  GJK_EPA_FACET,    // found; exact, or for curved shapes nearly
  GJK_EPA_TOUCHES,  // the origin lies on a plane across it->direction that nothing lies beyond; the simplex is the
                    // feature that holds the origin
  GJK_EPA_FULL      // too few cells; facet bounds the depth from above, *lower from below
} gjk_epa_outcome;

// Pre: the origin lies in the simplex. facet: not found yet. iterations: counts support scans.
gjk_epa_outcome gjk_epa(gjk_iteration *it, const gjk_workspace *workspace, gjk_facet *facet, gjk_q16 *lower,
                        uint16_t *iterations);

#endif
