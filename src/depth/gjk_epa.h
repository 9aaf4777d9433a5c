// EPA, the expanding polytope algorithm: finds the facet of A - B nearest to the origin, for shapes of any kind.
#ifndef GJK_SRC_EPA_H
#define GJK_SRC_EPA_H

#include "gjk/penetration.h"
#include "gjk_facet.h"

typedef enum gjk_epa_outcome {
  GJK_EPA_FACET,    // found: exact, or of a curved pair within its errors
  GJK_EPA_TOUCHES,  // nothing of A - B lies beyond the origin along it->direction; the simplex, a vertex or an edge,
                    // holds the origin
  GJK_EPA_FULL      // too few cells, or a curved pair's limit: facet bounds the depth from above, *lower from below
} gjk_epa_outcome;

// Pre: the origin lies in the simplex; no facet is found yet. *iterations grows by the support scans.
gjk_epa_outcome gjk_epa(gjk_iteration *it, const gjk_workspace *workspace, gjk_facet *facet, gjk_q16 *lower,
                        uint16_t *iterations);

#endif
