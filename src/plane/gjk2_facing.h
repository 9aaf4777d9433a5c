// The contacts of two shapes along a given normal.
#ifndef GJK2_SRC_FACING_H
#define GJK2_SRC_FACING_H

#include "gjk2/contacts.h"

// Steps 2 and 3 of gjk2_contacts.c. Returns whether an edge of A faces one of B. *id: that of the nearest points.
// guess_a, guess_b: the numbers of vertices near the corners that meet the normal; negative: they are looked for.
// Pre: out->normal is set; out->count is 0.
bool gjk2_facing_contacts(const gjk2_collider *a, const gjk2_collider *b, gjk_q16 margin, int32_t guess_a,
                          int32_t guess_b, gjk2_manifold *out, uint16_t *id);

// Step 4. Is every contact farther than the nearest points? Then they are admitted, in place of the farther of two.
bool gjk2_facing_lacks(const gjk2_manifold *m, gjk_q16 distance);
void gjk2_facing_admit(gjk2_manifold *m, gjk_q16 distance, const gjk2_vec *point_a, const gjk2_vec *point_b,
                       uint16_t id);

// Step 5
void gjk2_facing_limit(gjk2_manifold *m, unsigned most);

#endif
