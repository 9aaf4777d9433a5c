// The contacts of two shapes along a given normal.
#ifndef GJK2_SRC_FACING_H
#define GJK2_SRC_FACING_H

#include "gjk2/contacts.h"

// Steps 2 to 5 of gjk2_contacts.c. Returns whether an edge of A faces one of B.
// nearest: the points of the normal, which step 4 may admit; NULL: none. named: its certificate, whose vertices are near
// the corners that meet the normal; NULL: they are looked for. Pre: out->normal is set; out->count is 0.
bool gjk2_facing_contacts(const gjk2_collider *a, const gjk2_collider *b, gjk_q16 margin, unsigned most,
                          const gjk2_distance_result *nearest, const gjk2_certificate *named, gjk2_manifold *out);

#endif
