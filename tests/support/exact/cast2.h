// The exact oracle of casts in the plane, in the half spaces of cast.h with z = 0, and judge of what gjk2_cast says.
#ifndef EXACT_CAST2_H
#define EXACT_CAST2_H

#include "cast.h"
#include "claim2.h"
#include "gjk2/cast.h"

// Two colliders at the start and their ways, without radius and margin, and what is true of them.
typedef struct exact2_cast {
  const gjk2_collider *a, *b;
  exact2_posed at_a, at_b;        // owned
  exact_point way_a, way_b, way;  // z = 0; way: of B against A
  exact_difference difference;    // dimension 3 stands for an area
  exact_cast_truth truth;
} exact2_cast;

// As exact_cast_is_in_range and exact_cast_set of cast_claim.h.
bool exact2_cast_is_in_range(const gjk2_collider *a, const gjk2_collider *b, const gjk2_cast_path *path,
                             exact2_cast *out);
bool exact2_cast_set(const gjk2_collider *a, const gjk2_collider *b, const gjk2_cast_path *path, exact2_cast *out);

// Is it the answer to gjk2_cast after GJK_OK? Checked: hit, inside, fraction, normal, points, places of rest.
bool exact2_check_cast(const exact2_cast *cast, const gjk2_cast_result *result, char *why, size_t n);

#endif
