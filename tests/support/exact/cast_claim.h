// Judges what gjk_cast says of polytopes, by the oracle of casts, which reads no certificate, or by
// its certificate alone.
#ifndef EXACT_CAST_CLAIM_H
#define EXACT_CAST_CLAIM_H

#include "cast.h"
#include "gjk/cast.h"

// Two colliders at the start and their ways, without radius and margin, and what is true of them.
typedef struct exact_cast {
  const gjk_collider *a, *b;
  exact_point way_a, way_b, way;  // way: of B against A
  exact_difference difference;
  exact_cast_truth truth;
} exact_cast;

// Does the contract let gjk_cast answer? Both centres stay within int32, and the way of B against A is shorter than
// 2^32 LSB along each axis. Sets the ways of out, if so.
bool exact_cast_is_in_range(const gjk_collider *a, const gjk_collider *b, const gjk_cast_path *path, exact_cast *out);

// Finds the truth. out is zeroed before the first use; may be set again; free it with exact_cast_free.
// False: a shape has no vertices to read or too many, a radius or a margin, or the way is out of range.
bool exact_cast_set(const gjk_collider *a, const gjk_collider *b, const gjk_cast_path *path, exact_cast *out);
void exact_cast_free(exact_cast *cast);

// Is it the answer to gjk_cast after GJK_OK? Checked: hit, inside, fraction, normal, points, places of rest. A check
// that refuses writes its reason to why, n bytes.
bool exact_check_cast(const exact_cast *cast, const gjk_cast_result *result, char *why, size_t n);

// Do hit or miss and the fraction follow from the certificate? For polytopes of any number of vertices, without radius
// and margin, and a way in range; a ray has the certificate of its point's cast.
bool exact_check_cast_certificate(const gjk_collider *a, const gjk_collider *b, const gjk_cast_path *path,
                                  const gjk_cast_result *result, char *why, size_t n);

#endif
