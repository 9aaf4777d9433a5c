// The steps of gjk_contacts, for callers that choose the normal.
#ifndef GJK_SRC_MANIFOLD_H
#define GJK_SRC_MANIFOLD_H

#include "../contact/gjk_clip.h"
#include "gjk/contacts.h"

// Steps 2 and 3 of gjk_contacts.c, along out->normal: the candidates, at most margin apart. Also sets out's features.
void gjk_manifold_find(const gjk_collider *a, const gjk_collider *b, gjk_q16 margin, gjk_candidates *candidates,
                       gjk_manifold *out);

// Steps 4 and 5: sets out's contacts. Uses distance and points of nearest; NULL: step 4 is left out.
void gjk_manifold_keep(gjk_candidates *candidates, const gjk_distance_result *nearest, unsigned most,
                       gjk_manifold *out);

#endif
